// SPDX-License-Identifier: MIT
#include "clouds.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "common/light_image.hpp"

Environment clouds(nicol_context context, int number) {
    constexpr std::uint32_t width = 512, height = 256;
    std::vector<float> pixels;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const double up = 1 - 2.0 * y / height, around = 6.2831853 * x / width;
            const double cloud = std::sin((3 + number) * around + 5 * up) * std::cos(9 * up - 2 * around);
            for (const double blue : {0.6, 0.8, 1.0})
                pixels.push_back(static_cast<float>(0.4 + 0.3 * blue * up + 0.25 * cloud));
        }
    }
    const nicol_image image = light_image(pixels, width, height, 3, 1);
    return create<Environment>(nicol_environment_create_image, context, &image);
}
