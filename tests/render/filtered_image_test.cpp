// SPDX-License-Identifier: MIT
// Tests of filtered images.
#include "render/filtered_image.hpp"

#include <array>
#include <random>

#include "test.hpp"

using namespace nicol;
using Kind = ReconstructionFilter::Kind;

namespace {

constexpr int kWidth = 9;
constexpr int kHeight = 7;
constexpr int kChannels = 2;
constexpr std::array<glm::dvec2, 3> kPlaces{{{-0.3, 0.45}, {0.1, -0.2}, {0.49, 0}}};
const std::array<ReconstructionFilter, 7> kFilters{{{.kind = Kind::box},
                                                    {.kind = Kind::gaussian},
                                                    {.kind = Kind::gaussian, .size = 2},
                                                    {.kind = Kind::tent, .size = 0.5},
                                                    {.kind = Kind::mitchell},
                                                    {.kind = Kind::catmullrom},
                                                    {.kind = Kind::lanczos}}};

StokesImage noise(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    StokesImage image(kWidth, kHeight, kChannels);
    for (float& value : image.data) value = normal(random);
    return image;
}

}  // namespace

TEST_CASE("a pixel is the weighted mean of all samples within the radius") {
    for (const ReconstructionFilter& filter : kFilters) {
        CAPTURE(static_cast<int>(filter.kind));
        FilteredImage filtered(filter, kWidth, kHeight, kChannels);
        std::array<StokesImage, kPlaces.size()> samples;
        for (std::size_t s = 0; s < samples.size(); ++s) {
            samples[s] = noise(static_cast<unsigned>(s));
            filtered.add(samples[s], kPlaces[s]);
        }
        const StokesImage mean = std::move(filtered).mean();
        for (int c = 0; c < kChannels; ++c)
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    Stokes sum(0);
                    double weights = 0;
                    for (std::size_t s = 0; s < samples.size(); ++s)
                        for (int v = 0; v < kHeight; ++v)
                            for (int u = 0; u < kWidth; ++u) {
                                const double weight =
                                    filter(u - x + kPlaces[s].x) * filter(v - y + kPlaces[s].y);
                                sum += weight * samples[s].stokes(c, v, u);
                                weights += weight;
                            }
                    for (glm::length_t p = 0; p < 4; ++p)
                        CHECK(std::abs(mean.stokes(c, y, x)[p] - sum[p] / weights) < 2e-6);
                }
    }
}
