// SPDX-License-Identifier: MIT
// Tests of PNG files, read back with libpng.
#include <png.h>

#include <cstdio>
#include <map>

#include "image/file_size_limit.hpp"
#include "image/observer.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

struct Decoded {
    int width = 0;
    int height = 0;
    int depth = 0;
    int colour_type = 0;
    bool srgb = false;
    bool gamma = false;
    std::vector<std::uint8_t> rgb;
    std::map<std::string, std::string> text;
};

Decoded decode(const std::filesystem::path& path) {
    Decoded result;
    std::FILE* file = std::fopen(path.c_str(), "rb");
    REQUIRE(file != nullptr);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0) {
        FAIL("libpng cannot read ", path.string());
    }
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    result.width = static_cast<int>(png_get_image_width(png, info));
    result.height = static_cast<int>(png_get_image_height(png, info));
    result.depth = png_get_bit_depth(png, info);
    result.colour_type = png_get_color_type(png, info);
    result.srgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
    result.gamma = png_get_valid(png, info, PNG_INFO_gAMA) != 0;
    png_bytepp rows = png_get_rows(png, info);
    for (int y = 0; y < result.height; ++y)
        result.rgb.insert(result.rgb.end(), rows[y], rows[y] + 3 * result.width);
    png_textp text = nullptr;
    const int count = png_get_text(png, info, &text, nullptr);
    for (int i = 0; i < count; ++i) result.text[text[i].key] = text[i].text;
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return result;
}

}  // namespace

TEST_CASE("a PNG holds the pixels and the text of its observation") {
    const TemporaryFolder folder;
    const Observation observation{3,
                                  2,
                                  {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 250, 251, 252, 253, 254, 255},
                                  {{"Title", "A test"}, {"Nicol:Scale", "code 255 is 3"}},
                                  false};
    write_png(folder / "a.png", png_of(observation));
    const Decoded back = decode(folder / "a.png");
    CHECK(back.width == 3);
    CHECK(back.height == 2);
    CHECK(back.depth == 8);
    CHECK(back.colour_type == PNG_COLOR_TYPE_RGB);
    CHECK(back.rgb == observation.rgb);
    CHECK(back.text.at("Title") == "A test");
    CHECK(back.text.at("Nicol:Scale") == "code 255 is 3");
    CHECK(back.text.at("Software").find("Nicol") == 0);
    CHECK(folder.names().size() == 1);
}

TEST_CASE("images claim a transfer curve, but for signed components") {
    const TemporaryFolder folder;
    StokesImage image(4, 4, 1);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = 1.0F / static_cast<float>(1 + i % 4);
    write_png(folder / "a.png", png_of(tone_mapped(image)));
    CHECK(decode(folder / "a.png").srgb);
    for (const Observation& observation :
         {signed_component(image, 1), dolp_image(image), aolp_image(image)}) {
        write_png(folder / "a.png", png_of(observation));
        const Decoded back = decode(folder / "a.png");
        CHECK(back.srgb == observation.srgb);
        // The file has no gAMA. Some versions of libpng derive it from sRGB.
        CHECK((observation.srgb || !back.gamma));
        CHECK(back.text.count("Nicol:Observer") == 1);
        CHECK(back.text.count("Nicol:Scale") == 1);
        CHECK(back.text.at("Nicol:Frame").find("counter-clockwise") != std::string::npos);
    }
}

TEST_CASE("what cannot be written is an error and leaves nothing behind") {
    const TemporaryFolder folder;
    const Observation good{1, 1, {1, 2, 3}, {}, false};
    check_error(ErrorCode::write_failed, CALL(write_png(folder / "none" / "a.png", png_of(good))),
                "none/a.png");
    std::filesystem::create_directories(folder / "taken.png" / "inside");
    check_error(ErrorCode::write_failed, CALL(write_png(folder / "taken.png", png_of(good))), "taken.png");
    CHECK(folder.names().size() == 1);

    write_png(folder / "whole.png", png_of(good));
    const auto size = std::filesystem::file_size(folder / "whole.png");
    for (const auto limit : {std::uintmax_t{0}, size / 2, size - 1}) {
        const FileSizeLimit full(limit);
        check_error(ErrorCode::write_failed, CALL(write_png(folder / "a.png", png_of(good))), "a.png");
    }
    CHECK(folder.names().size() == 2);

    const auto refuse = [&](Observation observation, const char* what) {
        check_error(ErrorCode::invalid_argument, CALL(write_png(folder / "a.png", png_of(observation))),
                    what);
    };
    refuse({}, "0 x 0");
    refuse({2, 1, {1, 2, 3}, {}, false}, "3 bytes");
    refuse({-1, -1, {1, 2, 3}, {}, false}, "-1 x -1");
    refuse({1, 1, {1, 2, 3}, {{"", "text"}}, false}, "keyword");
    refuse({1, 1, {1, 2, 3}, {{std::string(80, 'k'), "text"}}, false}, "keyword");
    refuse({1, 1, {1, 2, 3}, {{"a\nb", "text"}}, false}, "keyword");
    refuse({1, 1, {1, 2, 3}, {{"a", std::string("x\0y", 3)}}, false}, "zero bytes");
    CHECK(folder.names().size() == 2);
}
