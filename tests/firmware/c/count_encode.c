/* Prints how many instructions a color takes: to sRGB bytes with powf, with a table, and to RGB565 with
   powf. The colors are those of ../src/bin/encode.rs. With MEASURED, calls only one of the three: compared
   with `nothing`, the program grows by the flash that the function takes. */
#include "board.h"
#include "encode.h"

static volatile uint32_t result;
static volatile float color[3];

static inline void srgb8(void (*encode)(const float *, uint8_t *)) {
    float given[3] = {color[0], color[1], color[2]};
    uint8_t bytes[3];
    encode(given, bytes);
    result = bytes[0] + bytes[1] + bytes[2];
}

static inline void powf8(void) { srgb8(srgb8_by_powf); }
static inline void table8(void) { srgb8(srgb8_by_table); }
static inline void powf565(void) {
    float given[3] = {color[0], color[1], color[2]};
    result = rgb565_by_powf(given);
}

static inline uint32_t of(void (*work)(void)) {
    static const float channels[8] = {0, 1e-3f, 0.01f, 0.04f, 0.1f, 0.3f, 0.7f, 1};
    uint32_t empty = ticks(nothing), per_thousand = ticks(thousand) - empty, sum = 0;
    for (int i = 0; i < 8; i++) {
        color[0] = channels[i], color[1] = 0.5f * channels[i], color[2] = 1 - channels[i];
        sum += ticks(work) - empty;
    }
    return (uint32_t)((uint64_t)sum * 1000 / per_thousand / 8);
}

int main(void) {
#ifdef MEASURED
    MEASURED();
#else
    start_counting();
    print(of(powf8), ' ');
    print(of(table8), ' ');
    print(of(powf565), '\n');
    done();
#endif
    return 0;
}
