// Shades a dome from C++, with vectors and an exception for each error, and writes the colors as floats: main FILE.
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "shading.h"

namespace {

std::vector<float> shade(const std::vector<float> &points, const std::vector<float> &normals,
                         const std::vector<shading_light> &lights) {
    const float eye[]{0, 0, 5}, ambient[]{0.5f, 0.5f, 0.5f};
    const shading_material material{{0.125f, 0.125f, 0.125f}, {0.5f, 0.375f, 0.25f}, {0.5f, 0.5f, 0.5f}, 32};
    std::vector<float> colors(points.size());
    const auto status = shading_shade(SHADING_BLINN_PHONG, points.size() / 3, points.data(), normals.data(), eye,
                                      &material, ambient, lights.data(), lights.size(), colors.data());
    if (status != SHADING_OK) throw std::invalid_argument("shading_shade: status " + std::to_string(status));
    return colors;
}

void run(const char *path) {
    // kind, position, direction, intensity, attenuation, range, inner and outer half-angle, gltf
    const std::vector<shading_light> lights{
        {SHADING_DIRECTIONAL, {0, 0, 0}, {-1, 2, 2}, {0.25f, 0.25f, 0.375f}, {0, 0, 0}, 0, 0, 0, 0},
        {SHADING_POINT, {2, 1, 2}, {0, 0, 0}, {1, 0.75f, 0.5f}, {1, 0, 0.25f}, INFINITY, 0, 0, 0},
        {SHADING_SPOT, {0, 3, 3}, {0, -1, -1}, {3, 1, 1}, {1, 0.5f, 0}, 8, 0.25f, 0.375f, 0},
    };
    std::vector<float> points, normals;
    for (int i = 0; i < 64 * 64; i++) {
        const float x = static_cast<float>(i % 64 - 32) / 32, y = static_cast<float>(32 - i / 64) / 32;
        points.insert(points.end(), {x, y, 1 - x * x - y * y});
        normals.insert(normals.end(), {2 * x, 2 * y, 1});
    }
    const auto colors = shade(points, normals, lights);
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
