// A brass ball under one lamp, with Blinn's highlight, 240 x 240 pixels, in fixed point.
#include <shading_fixed.h>

enum { SIDE = 240, RADIUS = SIDE / 2 };

// A lamp at (2, 3, 4), where the ball has the radius 1; its light times 1/(0.5 + 0.03 q²), q the distance.
static const shading_fixed_light lamp = SHADING_FIXED_LAMP(2.0, 3.0, 4.0, 1.0, 0.9, 0.8, 0.5, 0.0, 0.03);

static const shading_fixed_material brass = {
    SHADING_FIXED_VEC3(0.3, 0.3, 0.3),    // k_a
    SHADING_FIXED_VEC3(0.78, 0.57, 0.11), // k_d
    SHADING_FIXED_VEC3(0.99, 0.94, 0.81), // k_s
    28,                                   // the shininess m
};

// The color of the pixel that is so many pixels to the right of the center and above it.
static uint16_t ball(int16_t right, int16_t up) {
    const shading_fixed_vec3 eye = SHADING_FIXED_VEC3(0, 0, 1), ambient = SHADING_FIXED_VEC3(0.1, 0.1, 0.1);
    if ((int32_t)right * right + (int32_t)up * up >= (int32_t)RADIUS * RADIUS) {
        return 0;
    }
    // Pixels over the radius, with 16 bits after the point.
    shading_fixed x = ((int32_t)right * 69905) >> 7, y = ((int32_t)up * 69905) >> 7;
    shading_fixed rest = shading_fixed_sub(SHADING_FIXED_ONE, shading_fixed_mul(x, x));
    shading_fixed z = shading_fixed_sqrt(shading_fixed_sub(rest, shading_fixed_mul(y, y)));
    shading_fixed_vec3 p = shading_fixed_vector(x, y, z);
    shading_fixed_vec3 n = shading_fixed_unit(p); // the center is at 0

    shading_fixed_sum sum = SHADING_FIXED_DARK;
    shading_fixed_add_blinn_phong(&sum, n, eye, brass.m, &lamp, p); // once for each lamp
    return shading_fixed_to_rgb565(shading_fixed_total(&sum, &brass, ambient));
}
