/* Prints how many instructions a point light costs with an integer and with a real shininess: the same
   8 calls as ../src/bin/count.rs, with the same scene and the same counter. */
#include "board.h"
#include "kernel.h"

#define LAMPS 4
#define POINTS 8

#define LAMP(x, y, z) {{x, y, z}, {1.0f, 0.75f, 0.5f}, 1.0f, 0.125f, 0.0625f}

static const point_light lamps[LAMPS] = {
    LAMP(3, 1, 4), LAMP(-2, 2, 5), LAMP(1, -3, 4), LAMP(-1, -1, 6)};

static const vec3 cap[POINTS] = {
    {0, 0, 1},         {0.28f, 0, 0.96f},          {-0.28f, 0, 0.96f},         {0, 0.28f, 0.96f},
    {0, -0.28f, 0.96f}, {0.168f, 0.224f, 0.96f}, {-0.224f, 0.168f, 0.96f}, {0.224f, -0.168f, 0.96f}};

static const material brass = {
    {0.33f, 0.22f, 0.03f}, {0.78f, 0.57f, 0.11f}, {0.99f, 0.94f, 0.81f}, 32};

static volatile vec3 result;
static vec3 n;

static void whole(void) {
    vec3 v = {0, 0, 1}, ambient = {0.125f, 0.125f, 0.1875f};
    vec3 shaded = blinn_phong_whole(n, v, n, &brass, ambient, lamps, LAMPS);
    result.x = shaded.x, result.y = shaded.y, result.z = shaded.z;
}

static void real(void) {
    vec3 v = {0, 0, 1}, ambient = {0.125f, 0.125f, 0.1875f};
    vec3 shaded = blinn_phong_real(n, v, n, &brass, ambient, lamps, LAMPS);
    result.x = shaded.x, result.y = shaded.y, result.z = shaded.z;
}

static uint32_t point_light_of(void (*work)(void)) {
    uint32_t empty = ticks(nothing), per_thousand = ticks(thousand) - empty, sum = 0;
    for (int i = 0; i < POINTS; i++) {
        n = cap[i];
        sum += ticks(work) - empty;
    }
    return (uint32_t)((uint64_t)sum * 1000 / per_thousand / (LAMPS * POINTS));
}

int main(void) {
    start_counting();
    print(point_light_of(whole), ' ');
    print(point_light_of(real), '\n');
    done();
    return 0;
}
