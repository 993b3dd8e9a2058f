// The same from C++, with vectors and an exception for each error: main FOLDER.
#include "shading.h"
#include "shading.h" // twice, as two libraries would

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "by_hand.h"
#include "scene.h"

namespace {

std::vector<float> read(const std::string &path) {
    std::vector<float> floats(3 * POINTS);
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char *>(floats.data()), 4 * static_cast<std::streamsize>(floats.size())))
        throw std::runtime_error("cannot read " + path);
    return floats;
}

std::vector<float> shade(const std::vector<float> &points, const std::vector<float> &normals,
                         const std::vector<shading_light> &with) {
    std::vector<float> colors(points.size());
    const auto status = shading_shade(SHADING_BLINN_PHONG, points.size() / 3, points.data(), normals.data(), eye,
                                      &material, ambient, with.data(), with.size(), colors.data());
    if (status != SHADING_OK) throw std::invalid_argument("shading_shade: status " + std::to_string(status));
    return colors;
}

template <class Work> double milliseconds(Work work) {
    using clock = std::chrono::steady_clock;
    const auto start = clock::now();
    work();
    return std::chrono::duration<double, std::milli>(clock::now() - start).count();
}

void run(const std::string &folder) {
    const auto points = read(folder + "/points"), normals = read(folder + "/normals"), expected = read(folder + "/colors");
    const std::vector<shading_light> all(lights, lights + LIGHTS);
    const auto colors = shade(points, normals, all);
    if (std::memcmp(colors.data(), expected.data(), 4 * colors.size()) != 0)
        throw std::runtime_error("other bits than the crate's");
    try {
        shade(points, normals, {shading_light{}}); // a directional light without a direction
        throw std::runtime_error("a bad light was not refused");
    } catch (const std::invalid_argument &) {
    }
    std::vector<float> theirs(points.size());
    double ours = 1e9, by_hand = 1e9;
    for (int pass = 0; pass < 20; pass++) {
        ours = std::min(ours, milliseconds([&] { shade(points, normals, all); }));
        by_hand = std::min(by_hand, milliseconds([&] {
            shade_by_hand(POINTS, points.data(), normals.data(), eye, &material, ambient, lights, LIGHTS, theirs.data());
        }));
    }
    for (std::size_t i = 0; i < theirs.size(); i++)
        if (!(std::abs(theirs[i] - colors[i]) <= 1e-4f * (1 + colors[i])))
            throw std::runtime_error("the version by hand computes something else");
    std::cout.precision(2);
    std::cout << "C++: " << ours << " ms, " << ours / by_hand << " of the time by hand; all bits are the crate's\n";
}

} // namespace

int main(int count, char **arguments) {
    try {
        if (count != 2) throw std::runtime_error("usage: main FOLDER");
        run(arguments[1]);
        return 0;
    } catch (const std::exception &error) {
        std::cerr << "C++: " << error.what() << '\n';
        return 1;
    }
}
