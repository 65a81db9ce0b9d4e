// SPDX-License-Identifier: MIT
// Tests of scene textures under light whose channels are not red, green and blue.
#include "import/scene_textures.hpp"

#include "import/png_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("colours of textures under light of other channels are refused, grey ones are not") {
    const TemporaryFolder folder;
    folder.write("a.png", png_bytes(2, 1, 3, {255, 0, 0, 51, 51, 51}));
    folder.write("grey.png", png_bytes(2, 1, 3, {255, 255, 255, 51, 51, 51}));
    const SceneChannels five{.count = 5, .wavelengths = {}};
    scene::SceneFiles files({}, {});
    scene::SceneTextures textures(five, files);
    TextureSpecification image;
    image.kind = TextureSpecification::Kind::image;
    image.filename = folder / "grey.png";
    CHECK(textures.color(image)->channels() == 1);
    // Vectors have three numbers, also those of a grey image.
    CHECK(textures.vector(image)->channels() == 3);
    image.filename = folder / "a.png";
    CHECK(textures.number(image)->channels() == 1);
    CHECK(textures.vector(image)->channels() == 3);
    CHECK(error_of(CALL(textures.color(image)), ErrorCode::unsupported).find("of 5 other channels") !=
          std::string::npos);
    TextureSpecification constant;
    constant.color0 = glm::dvec3(1, 0, 0);
    static_cast<void>(error_of(CALL(textures.color(constant)), ErrorCode::unsupported));
    constant.color0 = 0.5;
    CHECK(textures.color(constant)->channels() == 1);
    constant.times_colors_of = ColorsOf::vertices;
    static_cast<void>(error_of(CALL(textures.color(constant)), ErrorCode::unsupported));
    static_cast<void>(error_of(CALL(textures.number(constant)), ErrorCode::unsupported));
}

// Mitsuba 3.9 draws checkerboards in this way: eval() and eval_1() differ.
TEST_CASE("a checkerboard of colours begins with color0, one of numbers with color1") {
    const SceneChannels channels;
    scene::SceneFiles files({}, {});
    scene::SceneTextures textures(channels, files);
    TextureSpecification board;
    board.kind = TextureSpecification::Kind::checkerboard;
    board.color0 = 0.75;
    board.color1 = 0.25;
    const TexturePoint first{.uv = {0.1F, 0.2F}}, second{.uv = {0.6F, 0.2F}};
    CHECK(textures.color(board)->at(first).x == 0.75F);
    CHECK(textures.color(board)->at(second).x == 0.25F);
    CHECK(textures.number(board)->at(first).x == 0.25F);
    CHECK(textures.number(board)->at(second).x == 0.75F);
}
