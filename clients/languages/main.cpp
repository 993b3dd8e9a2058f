// Shades a dome from C++, with vectors and an exception for each error, and writes the colors as floats: main FILE.
#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "shading.h"

namespace {

using Vector = std::array<float, 3>;

void set(float (&member)[3], const Vector &value) {
    std::copy(value.begin(), value.end(), member);
}

shading_light light(shading_kind kind, const Vector &intensity) {
    auto light = shading_default_light(kind);
    set(light.intensity, intensity);
    return light;
}

std::vector<float> shade(const std::vector<float> &points, const std::vector<float> &normals,
                         const std::vector<shading_light> &lights) {
    auto scene = shading_default_scene();
    scene.count = points.size() / 3;
    scene.points = points.data();
    scene.normals = normals.data();
    scene.lights = lights.data();
    scene.light_count = lights.size();
    scene.material.m = 32;
    set(scene.eye, {0, 0, 5});
    set(scene.ambient, {0.5f, 0.5f, 0.5f});
    set(scene.material.k_a, {0.125f, 0.125f, 0.125f});
    set(scene.material.k_d, {0.5f, 0.375f, 0.25f});
    set(scene.material.k_s, {0.5f, 0.5f, 0.5f});
    std::vector<float> colors(points.size());
    shading_error error;
    if (shading_shade(&scene, colors.data(), &error)) throw std::invalid_argument(error.text);
    return colors;
}

std::vector<shading_light> lights() {
    auto sun = light(SHADING_DIRECTIONAL, {0.25f, 0.25f, 0.375f});
    set(sun.toward, {-1, 2, 2});
    auto lamp = light(SHADING_POINT, {1, 0.75f, 0.5f});
    set(lamp.position, {2, 1, 2});
    set(lamp.attenuation, {1, 0, 0.25f});
    auto spot = light(SHADING_SPOT, {3, 1, 1});
    set(spot.position, {0, 3, 3});
    set(spot.axis, {0, -1, -1});
    set(spot.attenuation, {1, 0.5f, 0});
    spot.range = 8;
    spot.inner = 0.25f;
    spot.outer = 0.375f;
    return {sun, lamp, spot};
}

void run(const char *path) {
    std::vector<float> points, normals;
    for (int i = 0; i < 64 * 64; i++) {
        const float x = static_cast<float>(i % 64 - 32) / 32, y = static_cast<float>(32 - i / 64) / 32;
        points.insert(points.end(), {x, y, 1 - x * x - y * y});
        normals.insert(normals.end(), {2 * x, 2 * y, 1});
    }
    const auto colors = shade(points, normals, lights());
    std::ofstream file(path, std::ios::binary);
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.write(reinterpret_cast<const char *>(colors.data()), static_cast<std::streamsize>(4 * colors.size()));
}

}

int main(int count, char **arguments) try {
    if (count != 2) throw std::invalid_argument("usage: main FILE");
    run(arguments[1]);
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
