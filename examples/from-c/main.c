#include <math.h>
#include <stdio.h>

#include "shading.h"

/* A lamp above a horizontal surface, seen from above: N = L = V = H, q = 2.
   Red: 0.1 + (0.5 + 0.25)/(1 + 4/4) = 0.475. Green: 0.1 + half of that light = 0.2875. Blue: 0.1. */
int main(void) {
    const float p[3] = {0, 0, 0}, up[3] = {0, 0, 3};
    const float k_a[3] = {0.1f, 0.1f, 0.1f}, k_d[3] = {0.5f, 0.5f, 0.5f}, k_s[3] = {0.25f, 0.25f, 0.25f};
    const struct shading_lamp lamp = {{0, 0, 2}, {1.0f, 0.5f, 0.0f}, {1.0f, 0.0f, 0.25f}};
    const float expected[3] = {0.475f, 0.2875f, 0.1f};
    float light[3];
    shading_blinn_phong(p, up, up, k_a, k_d, k_s, 32, &lamp, 1, light);
    printf("%g %g %g\n", light[0], light[1], light[2]);
    for (int i = 0; i < 3; i++)
        if (fabsf(light[i] - expected[i]) > 1e-6f) return 1;
    return 0;
}
