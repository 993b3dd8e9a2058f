/* The scene that `src/bin/scene.rs` writes, for C and C++: lights, material, eye. */
#ifndef SCENE_H
#define SCENE_H

#include <math.h>

#include "shading.h"

enum { POINTS = 256 * 256, LIGHTS = 4 };

static const float eye[3] = {0, 0, 5}, ambient[3] = {0.5f, 0.5f, 0.5f};
static const shading_material material = {
    {0.125f, 0.125f, 0.125f}, {0.5f, 0.375f, 0.25f}, {0.5f, 0.5f, 0.5f}, 32};
/* kind, position, direction, intensity, attenuation, range, inner and outer half-angle, unsquared */
static const shading_light lights[LIGHTS] = {
    {SHADING_DIRECTIONAL, {0, 0, 0}, {-1, 2, 2}, {0.25f, 0.25f, 0.375f}, {0, 0, 0}, 0, 0, 0, 0},
    {SHADING_POINT, {2, 1, 2}, {0, 0, 0}, {1, 0.75f, 0.5f}, {1, 0, 0.25f}, INFINITY, 0, 0, 0},
    {SHADING_POINT, {-4, -2, 4}, {0, 0, 0}, {2, 4, 8}, {0, 0, 1}, 8, 0, 0, 1},
    {SHADING_SPOT, {0, 3, 3}, {0, -1, -1}, {3, 1, 1}, {1, 0.5f, 0}, 8, 0.25f, 0.375f, 0},
};

#endif
