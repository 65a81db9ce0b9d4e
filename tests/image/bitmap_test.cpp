// SPDX-License-Identifier: MIT
// Tests of bitmaps of every kind, built byte by byte.
#include "image/bitmap.hpp"

#include <zlib.h>

#include "image/observer.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using Bytes = std::string;

Bytes big(std::uint32_t value) {
    Bytes out;
    for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(value >> shift);
    return out;
}
Bytes little(std::uint32_t value, int count) {
    Bytes out;
    for (int i = 0; i < count; ++i) out += static_cast<char>(value >> (8 * i));
    return out;
}

// Returns a PNG. Each row in `rows` starts with its filter byte.
Bytes png(std::uint32_t width, std::uint32_t height, char bits, char kind, const Bytes& rows,
          const Bytes& palette = "") {
    const auto chunk = [](const Bytes& name, const Bytes& content) {
        const Bytes checked = name + content;
        return big(static_cast<std::uint32_t>(content.size())) + checked +
               big(static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                                                    static_cast<uInt>(checked.size()))));
    };
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    Bytes packed(size, '\0');
    REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                     reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size())) == Z_OK);
    packed.resize(size);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", big(width) + big(height) + Bytes{bits, kind, 0, 0, 0}) +
           (palette.empty() ? "" : chunk("PLTE", palette)) + chunk("IDAT", packed) + chunk("IEND", "");
}

// 2 x 1 pixels, red and dark green, stored bottom-up as B G R in BMP and TGA.
const Bytes bmp = "BM" + little(14 + 40 + 8, 4) + little(0, 4) + little(54, 4) + little(40, 4) +
                  little(2, 4) + little(1, 4) + little(1, 2) + little(24, 2) + Bytes(24, '\0') +
                  Bytes("\0\0\xff\0\x33\0\0\0", 8);
const Bytes tga = Bytes("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x18\0", 18) + Bytes("\0\0\xff\0\x33\0", 6);
// A run-length encoded TGA: two pixels in one run.
const Bytes tga_runs = Bytes("\0\0\x0a\0\0\0\0\0\0\0\0\0\2\0\1\0\x18\0", 18) + Bytes("\x81\0\0\xff", 4);
const Bytes hdr =
    Bytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") + Bytes("\x80\x40\0\x85\x80\x80\x80\x80", 8);
// 8 x 8 pixels of (200, 100, 50), written by libjpeg.
const std::array<unsigned char, 285> jpeg{
    0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46, 0x49, 0x46, 0x00, 0x01, 0x01, 0x00, 0x00, 0x01, 0x00,
    0x01, 0x00, 0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x02, 0x01, 0x01, 0x01, 0x01, 0x01, 0x02, 0x01, 0x01,
    0x01, 0x02, 0x02, 0x02, 0x02, 0x02, 0x04, 0x03, 0x02, 0x02, 0x02, 0x02, 0x05, 0x04, 0x04, 0x03, 0x04,
    0x06, 0x05, 0x06, 0x06, 0x06, 0x05, 0x06, 0x06, 0x06, 0x07, 0x09, 0x08, 0x06, 0x07, 0x09, 0x07, 0x06,
    0x06, 0x08, 0x0b, 0x08, 0x09, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x06, 0x08, 0x0b, 0x0c, 0x0b, 0x0a, 0x0c,
    0x09, 0x0a, 0x0a, 0x0a, 0xff, 0xdb, 0x00, 0x43, 0x01, 0x02, 0x02, 0x02, 0x02, 0x02, 0x02, 0x05, 0x03,
    0x03, 0x05, 0x0a, 0x07, 0x06, 0x07, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a,
    0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a,
    0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0x0a,
    0x0a, 0x0a, 0x0a, 0x0a, 0x0a, 0xff, 0xc0, 0x00, 0x11, 0x08, 0x00, 0x08, 0x00, 0x08, 0x03, 0x01, 0x11,
    0x00, 0x02, 0x11, 0x01, 0x03, 0x11, 0x01, 0xff, 0xc4, 0x00, 0x14, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x05, 0xff, 0xc4, 0x00, 0x14, 0x10,
    0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0xff, 0xc4, 0x00, 0x14, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x08, 0xff, 0xc4, 0x00, 0x14, 0x11, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0xda, 0x00, 0x0c, 0x03, 0x01, 0x00,
    0x02, 0x11, 0x03, 0x11, 0x00, 0x3f, 0x00, 0x3c, 0x57, 0x36, 0x1f, 0xff, 0xd9};

}  // namespace

TEST_CASE("bitmaps of every kind are read to the last bit") {
    const float dark = 51.0F / 255;
    struct Row {
        std::string name;
        Bytes bytes;
        int channels;
        std::vector<float> values;
    };
    const std::vector<Row> rows{
        {"rgb.png", png(2, 1, 8, 2, Bytes("\0\xff\0\0\0\x33\0", 7)), 3, {1, 0, 0, 0, dark, 0}},
        {"rgba.png", png(1, 1, 8, 6, Bytes("\0\xff\0\x33\x33", 5)), 4, {1, 0, dark, dark}},
        {"grey.PNG", png(1, 2, 8, 0, Bytes("\0\xff\0\x33", 4)), 1, {1, dark}},
        {"grey_alpha.png", png(1, 1, 8, 4, Bytes("\0\xff\x33", 3)), 2, {1, dark}},
        {"bits.png", png(2, 1, 1, 0, Bytes("\0\x40", 2)), 1, {0, 1}},
        {"deep.png", png(1, 1, 16, 2, Bytes("\0\xff\xff\0\1\x33\x33", 7)), 3, {1, 1.0F / 65535, dark}},
        {"palette.png",
         png(2, 1, 8, 3, Bytes("\0\1\0", 3), Bytes("\0\x33\0\xff\0\0", 6)),
         3,
         {1, 0, 0, 0, dark, 0}},
        {"a.bmp", bmp, 3, {1, 0, 0, 0, dark, 0}},
        {"a.tga", tga, 3, {1, 0, 0, 0, dark, 0}},
        {"runs.tga", tga_runs, 3, {1, 0, 0, 1, 0, 0}},
        {"a.hdr", hdr, 3, {16, 8, 0, 0.5F, 0.5F, 0.5F}},
        // The content decides, whatever the suffix says.
        {"really_png.jpg", png(1, 1, 8, 0, Bytes("\0\x33", 2)), 1, {dark}}};
    const TemporaryFolder folder;
    for (const Row& row : rows) {
        CAPTURE(row.name);
        const auto file = folder.write(row.name, row.bytes);
        CHECK(is_bitmap(file));
        const Bitmap found = read_bitmap(file);
        CHECK(found.channels == row.channels);
        CHECK(static_cast<std::size_t>(found.width * found.height * found.channels) == row.values.size());
        CHECK(found.values == row.values);
        CHECK(found.linear == (row.name == "a.hdr"));
    }
    const Bitmap photo =
        read_bitmap(folder.write("a.jpg", Bytes(reinterpret_cast<const char*>(jpeg.data()), jpeg.size())));
    CHECK(photo.width == 8);
    for (std::size_t i = 0; i < photo.values.size(); ++i)
        CHECK(photo.values[i] == doctest::Approx(std::array{200, 100, 50}[i % 3] / 255.0).epsilon(0.02));
}

TEST_CASE("a large JPEG of many scans is refused before it is decoded") {
    Bytes file(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
    const std::size_t frame = file.find("\xff\xc0");
    file.replace(frame + 5, 4, Bytes("\x20\0\x40\0", 4));  // 8192 x 16384
    for (int i = 0; i < 100; ++i) file += "\xff\xda" + Bytes(1000, '\x11');
    const TemporaryFolder folder;
    check_error(ErrorCode::unsupported, CALL(read_bitmap(folder.write("a.jpg", file))), "101 scans");
}

TEST_CASE("a Radiance file is divided by its exposures and colour corrections") {
    const auto file = [](const std::string& lines) {
        return "#?RADIANCE\n" + lines + "FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" +
               Bytes("\x80\x40\x20\x85", 4);
    };
    const TemporaryFolder folder;
    struct Row {
        std::string lines;
        std::vector<float> values;
    };
    const std::vector<Row> rows{{"", {16, 8, 4}},
                                {"EXPOSURE=2\n", {8, 4, 2}},
                                {"EXPOSURE= 2.0\r\nmade by hand\nEXPOSURE=4\n", {2, 1, 0.5F}},
                                {"COLORCORR= 1 2 4\nEXPOSURE=0.5\n", {32, 8, 2}},
                                {"# EXPOSURE=2\n", {16, 8, 4}}};
    for (const Row& row : rows) {
        CAPTURE(row.lines);
        CHECK(read_bitmap(folder.write("a.hdr", file(row.lines))).values == row.values);
    }
    for (const std::string lines :
         {"EXPOSURE=0\n", "EXPOSURE=-1\n", "EXPOSURE=nan\n", "EXPOSURE=1,5\n", "COLORCORR=1 2\n"}) {
        CAPTURE(lines);
        check_error(ErrorCode::invalid_file, CALL(read_bitmap(folder.write("a.hdr", file(lines)))),
                    "line 2: ");
    }
}

TEST_CASE("what is written as PNG is read again") {
    const TemporaryFolder folder;
    std::mt19937 random(4);
    Observation image{.width = 33, .height = 17, .rgb = {}};
    for (int i = 0; i < 33 * 17 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(random()));
    const auto file = folder.path() / "a.png";
    write_png(file, png_of(image));
    const Bitmap found = read_bitmap(file);
    REQUIRE(found.values.size() == image.rgb.size());
    for (std::size_t i = 0; i < found.values.size(); ++i)
        CHECK(found.values[i] == static_cast<float>(image.rgb[i]) / 255);
}

TEST_CASE("colours become light by the curve of sRGB, radiance as it is") {
    const Bitmap colours{.width = 2, .height = 1, .channels = 4, .values = {0.5F, 1, 0.02F, 9, 0, 0, 0, 9}};
    const StokesImage light = unpolarized_image(colours);
    CHECK(light.channels == 3);
    CHECK(light.at(0, 0, 0)[0] == doctest::Approx(0.214041));
    CHECK(light.at(1, 0, 0)[0] == doctest::Approx(1));
    CHECK(light.at(2, 0, 0)[0] == doctest::Approx(0.02 / 12.92));
    for (int p = 1; p < 4; ++p) CHECK(light.at(0, 0, 0)[static_cast<std::size_t>(p)] == 0);
    const Bitmap radiance{.width = 1, .height = 1, .channels = 1, .linear = true, .values = {7.5F}};
    CHECK(unpolarized_image(radiance).channels == 1);
    CHECK(unpolarized_image(radiance).at(0, 0, 0)[0] == 7.5F);
}

TEST_CASE("bad bitmaps are refused by name, cut short anywhere too") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& name, const Bytes& bytes, ErrorCode code,
                             const std::string& part) {
        CAPTURES(name, bytes.size());
        const auto file = folder.write(name, bytes);
        check_error(code, CALL(read_bitmap(file)), file.string(), part);
    };
    check_error(ErrorCode::file_not_found, CALL(read_bitmap(folder.path() / "none.png")), "none.png");
    refused("a.png", "", ErrorCode::invalid_file, "is empty");
    refused("a.png", "hello", ErrorCode::unsupported, "expected PNG, JPEG, BMP, TGA or Radiance HDR");
    refused("a.png", png(40000, 1, 8, 0, Bytes(40001, '\0')), ErrorCode::invalid_file,
            "of more than 32768 pixels a side");
    refused("a.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\0\x20\0\x20\x18\0\1\2\3", 21),
            ErrorCode::invalid_file, "21 bytes cannot hold 8192 x 8192 pixels");
    refused("a.png", png(32768, 32768, 8, 0, "\0"), ErrorCode::unsupported, "32768 x 32768 pixels; at most");
    const Bytes photo(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
    // PNG and JPEG files may lack the end mark, because all pixels are present.
    for (const auto& [name, bytes, end] : {std::tuple<std::string, Bytes, std::size_t>{
                                               "a.png", png(2, 1, 8, 2, Bytes("\0\xff\0\0\0\x33\0", 7)), 12},
                                           {"a.bmp", bmp, 2},
                                           {"a.tga", tga, 0},
                                           {"a.hdr", hdr, 0},
                                           {"a.jpg", photo, 2}}) {
        for (std::size_t size = 1; size + end < bytes.size(); ++size) {
            CAPTURES(name, size);
            const auto file = folder.write(name, bytes.substr(0, size));
            CHECK_THROWS_AS(static_cast<void>(read_bitmap(file)), Error);
        }
    }
}
