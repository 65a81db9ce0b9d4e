// SPDX-License-Identifier: MIT
#include "light.hpp"

#include <cmath>

#include "common/light_image.hpp"

namespace {

const Vec3 sun = unit({0.3, 0.9, -0.2});

struct Lamp {
    Vec3 towards;
    Vec3 field;  ///< electric field before projection perpendicular to the light
    double sharpness, radiance, polarization;
};
const Lamp lamps[] = {
    {unit({0.1, 0.2, -1}), {1, 1, 0}, 8, 1.0, 0.7},
    {unit({-0.8, 0.3, 0.4}), {0, 1, 0.4}, 30, 2.0, 0.9},
    {unit({0.5, -0.3, 0.8}), {1, -0.3, 0}, 120, 4.0, 1.0},
};

/// Returns s0, s1, s2 from `towards`, in a frame with this x axis.
std::array<double, 3> radiance(const Vec3& towards, const Vec3& x) {
    const Vec3 y = cross({-towards[0], -towards[1], -towards[2]}, x);
    std::array<double, 3> s{};
    const auto add = [&](double intensity, double polarization, const Vec3& field) {
        const double along = dot(field, x), across = dot(field, y);
        const double length = along * along + across * across;
        s[0] += intensity;
        if (length == 0) return;
        s[1] += intensity * polarization * (along * along - across * across) / length;
        s[2] += intensity * polarization * 2 * along * across / length;
    };
    const double c = dot(towards, sun);
    add(0.75 * (1 + c * c), 0.8 * (1 - c * c) / (1 + c * c), cross(sun, towards));
    for (const Lamp& lamp : lamps) {
        add(lamp.radiance * std::exp(lamp.sharpness * (dot(towards, lamp.towards) - 1)), lamp.polarization,
            lamp.field);
    }
    return s;
}

}  // namespace

Doubles light(const Experiment& experiment, std::uint32_t order) {
    Doubles coefficients;
    if (!experiment.light.empty()) {
        std::uint32_t channels = 0;
        check(nicol_psh_project_file(experiment.light.c_str(), order, &channels, nullptr, 0));
        coefficients.resize(channels * vector_size(order));
        check(nicol_psh_project_file(experiment.light.c_str(), order, &channels, coefficients.data(),
                                     coefficients.size()));
        return cut(coefficients, order);
    }
    const std::uint32_t width = 512, height = 257;
    std::vector<float> pixels;
    for (std::uint32_t row = 0; row < height; ++row)
        for (std::uint32_t column = 0; column < width; ++column) {
            const double u = 2 * pi * (column + 0.5) / width;
            const double v = pi * row / (height - 1);
            const auto s = radiance({std::sin(u) * std::sin(v), std::cos(v), -std::cos(u) * std::sin(v)},
                                    {std::cos(u), 0, std::sin(u)});
            for (const double value : {s[0], s[1], s[2], 0.0}) pixels.push_back(static_cast<float>(value));
        }
    const nicol_image image = light_image(pixels, width, height, 1, 4);
    coefficients.resize(vector_size(order));
    check(nicol_psh_project_image(&image, order, coefficients.data(), coefficients.size()));
    return coefficients;
}
