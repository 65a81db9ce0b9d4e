// SPDX-License-Identifier: MIT
// Tests of gradients by texels: look-ups of an image are linear in its values.
#include "texture/texel_gradient.hpp"

#include "test.hpp"

using namespace nicol;
using Filter = TextureSampling::Filter;
using Wrap = TextureSampling::Wrap;

namespace {

struct Size {
    int width, height;
};

TextureImage random_image(const Size& size, int channels, std::mt19937& generator) {
    TextureImage image{.width = size.width, .height = size.height, .channels = channels, .values = {}};
    std::uniform_real_distribution<float> value(-1, 1);
    image.values.resize(static_cast<std::size_t>(size.width * size.height * channels));
    for (float& number : image.values) number = value(generator);
    return image;
}

/// Returns points in and around the unit square, with footprints from none to many texels, some stretched.
TexturePoints random_points(std::mt19937& generator) {
    std::uniform_real_distribution<float> place(-0.7F, 1.6F), step(-0.3F, 0.3F);
    TexturePoints points{};
    for (std::size_t i = 0; i < kLanes; ++i)
        for (std::size_t k = 0; k < 2; ++k) {
            const float footprint = std::ldexp(1.0F, -static_cast<int>(i % 8));
            points.uv[k][i] = place(generator);
            points.du[k][i] = i == 0 ? 0.0F : footprint * step(generator);
            points.dv[k][i] = i == 0 ? 0.0F : 0.3F * footprint * step(generator);
        }
    return points;
}

}  // namespace

TEST_CASE("the gradient by texels is the transpose of look-ups") {
    std::mt19937 generator(3);
    constexpr std::uint32_t chosen = 0xBFFB;
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::mipmap})
        for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
            for (const int channels : {1, 3, 4})
                for (const Size size : {Size{8, 8}, Size{13, 7}, Size{1, 5}, Size{6, 1}}) {
                    CAPTURE(filter);
                    CAPTURE(wrap);
                    CAPTURE(channels);
                    CAPTURE(size.width);
                    const TextureImage image = random_image(size, channels, generator);
                    const TextureSampling sampling{
                        .filter = filter,
                        .wrap = wrap,
                        .to_uv = glm::dmat3(1.1, 0.2, 0, -0.1, 0.9, 0, 0.1, 0.2, 1)};
                    const TexturePtr texture = image_texture(image, sampling);
                    TexelGradient gradient(*texture);
                    double values = 0;
                    for (int repetition = 0; repetition < 4; ++repetition) {
                        const TexturePoints points = random_points(generator);
                        std::array<Lanes, 4> of_values{}, found;
                        texture->at_lanes(points, found);
                        for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
                            for (std::size_t i = 0; i < kLanes; ++i) {
                                of_values[c][i] = std::uniform_real_distribution<float>(-1, 1)(generator);
                                if ((chosen >> i & 1U) != 0)
                                    values += double{of_values[c][i]} * double{found[c][i]};
                            }
                        gradient.add(points, chosen, of_values);
                    }
                    const std::vector<double> texels = gradient.take();
                    REQUIRE(texels.size() == image.values.size());
                    double sum = 0;
                    for (std::size_t i = 0; i < texels.size(); ++i)
                        sum += texels[i] * double{image.values[i]};
                    CHECK(sum == doctest::Approx(values).epsilon(1e-5).scale(1));
                }
}
