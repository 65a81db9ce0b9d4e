// SPDX-License-Identifier: MIT
// Tests of the numbers between which a textured material is interpolated.
#include "material/texture_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

constexpr double kRatio = 1.2;

// Texture of 256 x 256 pixels whose values are value(i / count), i the number of the pixel.
template <class Value>
TexturePtr texture_of(const Value& value) {
    TextureImage image{.width = 256, .height = 256, .channels = 1, .values = {}};
    for (int i = 0; i < image.width * image.height; ++i)
        image.values.push_back(static_cast<float>(value(i / 65536.0)));
    return image_texture(std::move(image), {.filter = TextureSampling::Filter::nearest});
}

}  // namespace

TEST_CASE("numbers of a texture lie where its values are, and their error is that of even ones") {
    struct Case {
        const char* name;
        double (*value)(double part);
        std::size_t fewest, most;
    };
    const std::initializer_list<Case> cases = {
        {"evenly spread", [](double part) { return 0.02 * std::pow(50, part); }, 20, 24},
        {"two groups far apart",
         [](double part) { return part < 0.5 ? 0.02 + 0.002 * part : 0.8 + 0.1 * part; }, 8, 14},
        {"one group and a few outliers",
         [](double part) { return part < 1e-3 ? 0.02 + 200 * part : 0.3 + 0.02 * part; }, 10, 16},
        {"all but one value",  // more than 16 values
         [](double part) { return part > 0.99 ? 0.3 + 0.5 * part : 0.3; }, 2, 6},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const TexturePtr texture = texture_of(c.value);
        const std::vector<double> numbers = texture_numbers(*texture, 0.01, kRatio);
        CHECK(numbers.size() >= c.fewest);
        CHECK(numbers.size() <= c.most);
        CHECK(std::ranges::is_sorted(numbers));
        CHECK(numbers.front() == Approx(static_cast<double>(texture->range().x)));
        CHECK(numbers.back() == Approx(static_cast<double>(texture->range().y)));
        // Errors relative to that half-way between two even numbers.
        double sum = 0, largest = 0;
        for (int i = 0; i < 65536; ++i) {
            const double value = c.value(i / 65536.0);
            const auto after =
                std::clamp(std::ranges::upper_bound(numbers, value), numbers.begin() + 1, numbers.end() - 1);
            const double error = 4 * std::log(value / after[-1]) * std::log(*after / value) /
                                 (std::log(kRatio) * std::log(kRatio));
            sum += error * error;
            largest = std::max(largest, error);
        }
        CHECK(sum / 65536 < 1.05 * 8 / 15);
        CHECK(largest < 4.01);
    }
}

TEST_CASE("few values are returned as they are, and no more numbers than asked for") {
    const TexturePtr few = texture_of([](double part) { return part < 0.3 ? 0.05 : part < 0.5 ? 0.2 : 2.0; });
    CHECK(texture_numbers(*few, 0.1, kRatio) == std::vector<double>{0.1, static_cast<double>(0.2F), 1});
    CHECK(texture_numbers(*constant_texture(glm::vec4(0.25F), 1), 0.01, kRatio) == std::vector<double>{0.25});
    const TexturePtr ramp = texture_of([](double part) { return 0.05 + 0.95 * part; });
    CHECK(texture_numbers(*ramp, 0.01, kRatio, 8).size() == 8);
}
