#include "encode.h"

#include <math.h>

static inline float clamped(float x) { return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f; }

static inline float encoded(float x) {
    x = clamped(x);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1.0f / 2.4f) - 0.055f;
}

void srgb8_by_powf(const float color[3], uint8_t bytes[3]) {
    for (int i = 0; i < 3; i++) bytes[i] = (uint8_t)(encoded(color[i]) * 255.0f + 0.5f);
}

uint16_t rgb565_by_powf(const float color[3]) {
    unsigned r = (unsigned)(encoded(color[0]) * 31.0f + 0.5f);
    unsigned g = (unsigned)(encoded(color[1]) * 63.0f + 0.5f);
    unsigned b = (unsigned)(encoded(color[2]) * 31.0f + 0.5f);
    return (uint16_t)(r << 11 | g << 5 | b);
}

/* One byte per step of 1/4095: near black a step is 0.8 of a level. */
static const uint8_t table[4096] = {
#include "table.h"
};

void srgb8_by_table(const float color[3], uint8_t bytes[3]) {
    for (int i = 0; i < 3; i++) bytes[i] = table[(unsigned)(clamped(color[i]) * 4095.0f + 0.5f)];
}
