/* Prints how many instructions a point light costs with an integer and with a real shininess, and with an
   integer one in fixed point: the same 8 calls as ../src/bin/count.rs and ../src/bin/count_fixed.rs, with
   the same scene and the same counter. */
#include "board.h"
#include "kernel.h"
#include "kernel_fixed.h"

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

static fixed_point_light fixed_lamps[LAMPS];
static fixed_material fixed_brass;
static volatile fixed_vec3 fixed_result;
static fixed_vec3 fixed_n;

static fixed_vec3 to_fixed(vec3 a) { return (fixed_vec3){FIXED(a.x), FIXED(a.y), FIXED(a.z)}; }

static void prepare_fixed(void) {
    for (int i = 0; i < LAMPS; i++) {
        point_light lamp = lamps[i];
        fixed_lamps[i] = (fixed_point_light){to_fixed(lamp.position), to_fixed(lamp.intensity),
                                             FIXED(lamp.a), FIXED(lamp.b), FIXED(lamp.c)};
    }
    fixed_brass = (fixed_material){to_fixed(brass.k_a), to_fixed(brass.k_d), to_fixed(brass.k_s), 32};
}

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

static void in_fixed(void) {
    fixed_vec3 v = {0, 0, FIXED(1)}, ambient = {FIXED(0.125), FIXED(0.125), FIXED(0.1875)};
    fixed_vec3 shaded =
        blinn_phong_fixed(fixed_n, v, fixed_n, &fixed_brass, ambient, fixed_lamps, LAMPS);
    fixed_result.x = shaded.x, fixed_result.y = shaded.y, fixed_result.z = shaded.z;
}

static uint32_t point_light_of(void (*work)(void)) {
    uint32_t empty = ticks(nothing), per_thousand = ticks(thousand) - empty, sum = 0;
    for (int i = 0; i < POINTS; i++) {
        n = cap[i], fixed_n = to_fixed(n);
        sum += ticks(work) - empty;
    }
    return (uint32_t)((uint64_t)sum * 1000 / per_thousand / (LAMPS * POINTS));
}

int main(void) {
    prepare_fixed();
    start_counting();
    print(point_light_of(whole), ' ');
    print(point_light_of(real), ' ');
    print(point_light_of(in_fixed), '\n');
    done();
    return 0;
}
