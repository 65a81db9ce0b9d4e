// SPDX-License-Identifier: MIT
// Tests of textures that are linear functions of others.
#include "texture/affine_texture.hpp"

#include "test.hpp"

using namespace nicol;

TEST_CASE("a number is linear in the first channel, clamped to 0..1, between texels and between levels") {
    const auto check_linear = [](const TexturePtr& texture, const TexturePtr& numbers) {
        CHECK(numbers->channels() == 1);
        for (int i = 0; i < 40; ++i) {
            const float t = 0.137F * static_cast<float>(i);
            const TexturePoint point{.uv = {t, 0.61F * t}, .du = {0.02F * t, 0}, .dv = {0, 0.05F * t}};
            CHECK(numbers->at(point).x == doctest::Approx(0.25F * texture->at(point).x + 0.5F).epsilon(1e-5));
        }
    };
    for (const int channels : {1, 3, 4})
        for (const auto filter : {TextureSampling::Filter::nearest, TextureSampling::Filter::bilinear,
                                  TextureSampling::Filter::mipmap}) {
            CAPTURE(channels);
            TextureImage image{.width = 5, .height = 3, .channels = channels, .values = {}};
            for (int i = 0; i < 15 * channels; ++i)
                image.values.push_back(0.5F + 0.5F * std::sin(1.7F * static_cast<float>(i)));
            const TexturePtr texture =
                image_texture(std::move(image), {.filter = filter,
                                                 .wrap = TextureSampling::Wrap::mirror,
                                                 .to_uv = {2, 0, 0, 0, 3, 0, 0.1, 0, 1}});
            check_linear(texture, affine_texture(texture, 0.25F, 0.5F));
        }
    const TexturePtr board = checkerboard_texture({0.2F, 1, 1}, {0.9F, 0, 0}, 3);
    check_linear(board, affine_texture(board, 0.25F, 0.5F));
    const TexturePtr even = constant_texture({0.3F, 1, 1, 1}, 3);
    check_linear(even, affine_texture(even, 0.25F, 0.5F));
    TextureImage beyond{.width = 2, .height = 1, .channels = 1, .values = {-3, 4}};
    CHECK(affine_texture(image_texture(std::move(beyond)), 0.25F, 0.5F)->range() == glm::vec2(0.5F, 0.75F));
}

TEST_CASE("numbers that no texture has are refused") {
    check_error(ErrorCode::unsupported, CALL(affine_texture(mesh_color_texture(ColorsOf::faces), 1, 0)),
                "a mesh's colours");
    check_error(ErrorCode::invalid_argument, CALL(affine_texture(nullptr, 1, 0)), "is null");
}
