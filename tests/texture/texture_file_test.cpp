// SPDX-License-Identifier: MIT
// Tests of texture images from files.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include "image/observer.hpp"
#include "import/png_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"
#include "texture/image_pixels.hpp"
#include "texture/texture.hpp"

using namespace nicol;

namespace {

/// Writes a file of floats, interleaved in the order of their names.
void write_channels(const std::filesystem::path& path, int width, int height,
                    const std::vector<std::string>& names, const std::vector<float>& values,
                    int sampling = 1) {
    Imf::Header header(width, height);
    Imf::FrameBuffer buffer;
    const std::size_t step = names.size() * sizeof(float);
    for (std::size_t c = 0; c < names.size(); ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT, sampling, sampling));
        buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values.data() + c, header.dataWindow(), step,
                                                 step * static_cast<std::size_t>(width), sampling, sampling));
    }
    Imf::OutputFile file(path.c_str(), header, 0);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
}

/// Decodes sRGB by IEC 61966-2-1.
double linear_from_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST_CASE("a texture is the display window of its file, 0 where that has no data") {
    const TemporaryFolder folder;
    Imf::Header header(Imath::Box2i({0, 0}, {3, 1}), Imath::Box2i({-1, 1}, {1, 2}));
    const std::vector<float> values{1, 2, 3, 4, 5, 6};
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
    {
        Imf::OutputFile file((folder / "a.exr").c_str(), header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(2);
    }
    const TextureImage image = load_texture_image(folder / "a.exr", true);
    CHECK(image.width == 4);
    CHECK(image.height == 2);
    CHECK(image.values == std::vector<float>{0, 0, 0, 0, 2, 3, 0, 0});
}

TEST_CASE("PNG and EXR of the same values are the same texture") {
    const TemporaryFolder folder;
    Observation png{.width = 16, .height = 16, .rgb = {}};
    std::vector<float> numbers, linear;
    for (int i = 0; i < 16 * 16 * 3; ++i) {
        png.rgb.push_back(static_cast<std::uint8_t>(i * 7));
        const double encoded = (i * 7 % 256) / 255.0;
        numbers.push_back(static_cast<float>(encoded));
        linear.push_back(static_cast<float>(linear_from_srgb(encoded)));
    }
    write_png(folder / "a.png", png_of(png));
    for (const bool raw : {true, false}) {
        CAPTURE(raw);
        write_channels(folder / "a.exr", 16, 16, {"R", "G", "B"}, raw ? numbers : linear);
        const TextureImage from_png = load_texture_image(folder / "a.png", raw);
        const TextureImage from_exr = load_texture_image(folder / "a.exr", raw);
        for (const TextureImage* image : {&from_png, &from_exr}) {
            CHECK(image->width == 16);
            CHECK(image->height == 16);
            CHECK(image->channels == 3);
        }
        CHECK(largest_difference(from_png.values, from_exr.values) < 2e-7);
        CHECK(from_exr.values == (raw ? numbers : linear));
    }
}

TEST_CASE("pixels that are decoded where they are used are those of the texture") {
    const TemporaryFolder folder;
    std::vector<std::uint8_t> codes;
    for (int i = 0; i < 16 * 16; ++i)
        for (const int step : {7, 11, 13, 17}) codes.push_back(static_cast<std::uint8_t>(i * step));
    for (const int channels : {1, 2, 3, 4}) {
        const std::vector<std::uint8_t> some(codes.begin(), codes.begin() + 256 * channels);
        folder.write("a.png", png_bytes(16, 16, channels, some));
        write_channels(folder / "a.exr", 1, 1, {"A", "B", "G", "R"}, {0.5F, 3, 2, 1});
        for (const char* name : {"a.png", "a.exr"})
            for (const bool raw : {true, false}) {
                CAPTURES(channels, name, raw);
                const TextureImage image = load_texture_image(folder / name, raw);
                const ImagePixels pixels = load_image_pixels(folder / name, raw);
                REQUIRE(pixels.count() * static_cast<std::size_t>(pixels.channels()) == image.values.size());
                CHECK(pixels.width() == image.width);
                CHECK(pixels.channels() == image.channels);
                for (std::size_t i = 0; i < pixels.count(); ++i) {
                    const float* const of = &image.values[i * static_cast<std::size_t>(image.channels)];
                    const glm::vec4 expected =
                        image.channels == 1 ? glm::vec4(of[0], of[0], of[0], 1)
                                            : glm::vec4(of[0], of[1], of[2], image.channels == 4 ? of[3] : 1);
                    CHECK(pixels.at(i) == expected);
                    if (pixels.count() == 1) continue;  // the EXR file
                    const auto* const of_file = &some[i * static_cast<std::size_t>(channels)];
                    const double number = of_file[0] / 255.0;
                    CHECK(pixels.at(i).x ==
                          doctest::Approx(raw ? number : linear_from_srgb(number)).epsilon(1e-6));
                    const double coverage = channels % 2 == 0 ? of_file[channels - 1] / 255.0 : 1;
                    CHECK(pixels.at(i).w == static_cast<float>(coverage));
                }
            }
    }
}

TEST_CASE("channels of EXR files are those of the texture, others are ignored") {
    const TemporaryFolder folder;
    const struct {
        std::vector<std::string> names;
        std::vector<float> pixel;
        int channels;
        std::vector<float> expected;
    } rows[] = {{{"Y"}, {5}, 1, {5}},
                {{"R", "G", "B"}, {1, 2, -3}, 3, {1, 2, -3}},
                {{"R", "G", "B", "A"}, {1, 2, 3, 0.5F}, 4, {1, 2, 3, 0.5F}},
                {{"Y", "A"}, {5, 0.5F}, 4, {5, 5, 5, 0.5F}},
                {{"Z", "B", "S1.R", "G", "R"}, {9, 3, 9, 2, 1}, 3, {1, 2, 3}}};
    for (const auto& row : rows) {
        CAPTURE(row.names.size());
        write_channels(folder / "A.EXR", 1, 1, row.names, row.pixel);
        const TextureImage image = load_texture_image(folder / "A.EXR", false);
        CHECK(image.channels == row.channels);
        CHECK(image.values == row.expected);
    }
}

TEST_CASE("colours are decoded from sRGB, coverage is not") {
    for (const int channels : {1, 3, 4}) {
        TextureImage image{.width = 1024, .height = 1, .channels = channels};
        std::mt19937 random(3);
        for (int i = 0; i < 1024 * channels; ++i) {
            const auto bits = static_cast<float>(random() % 65536);
            const float codes[] = {bits / 65535, std::floor(bits / 256) / 255, bits / 65432.1F};
            image.values.push_back(codes[i % 3]);
        }
        const std::vector<float> encoded = image.values;
        decode_srgb(image);
        double error = 0;
        for (std::size_t i = 0; i < encoded.size(); ++i) {
            const auto value = static_cast<double>(encoded[i]);
            const double expected = channels == 4 && i % 4 == 3 ? value : linear_from_srgb(value);
            error = std::max(error, std::abs(static_cast<double>(image.values[i]) - expected));
        }
        CHECK(error < 3e-7);
    }
}

TEST_CASE("grey with coverage has four channels") {
    const TemporaryFolder folder;
    // A 16-bit TGA of grey and alpha, 2 x 1 pixels, from the top.
    const std::string head("\0\0\3\0\0\0\0\0\0\0\0\0\2\0\1\0\x10\x28", 18);
    const auto file = folder.write("a.tga", head + std::string("\x33\x66\xff\0", 4));
    const TextureImage raw = load_texture_image(file, true);
    CHECK(raw.channels == 4);
    CHECK(raw.values == std::vector<float>{0.2F, 0.2F, 0.2F, 0.4F, 1, 1, 1, 0});
    const TextureImage decoded = load_texture_image(file, false);
    CHECK(decoded.values[0] == doctest::Approx(linear_from_srgb(0.2)));
    CHECK(decoded.values[3] == 0.4F);
}

TEST_CASE("files that are no textures are refused by name") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& name, ErrorCode code, const std::string& part) {
        check_error(code, CALL(load_texture_image(folder / name, false)), name, part);
    };
    refused("none.exr", ErrorCode::file_not_found, "cannot be opened");
    refused("none.png", ErrorCode::file_not_found, "");
    folder.write("empty.exr", "");
    refused("empty.exr", ErrorCode::invalid_file, "is empty");
    folder.write("text.exr", "not an image at all");
    refused("text.exr", ErrorCode::invalid_file, "");
    folder.write("text.gif", "GIF89a");
    refused("text.gif", ErrorCode::unsupported, "expected PNG");
    write_channels(folder / "z.exr", 1, 1, {"Z"}, {1});
    refused("z.exr", ErrorCode::invalid_file, "has neither R G B nor Y");
    write_channels(folder / "rg.exr", 1, 1, {"R", "G"}, {1, 1});
    refused("rg.exr", ErrorCode::invalid_file, "has neither R G B nor Y");
    write_channels(folder / "chroma.exr", 2, 2, {"Y", "RY"}, std::vector<float>(8, 1));
    refused("chroma.exr", ErrorCode::unsupported, "luminance and chroma");
    write_channels(folder / "nan.exr", 2, 1, {"Y"}, {1, std::nanf("")});
    refused("nan.exr", ErrorCode::invalid_file, "channel Y, pixel (1, 0) is not a number");
    write_channels(folder / "sub.exr", 2, 2, {"Y"}, {1, 1, 1, 1}, 2);
    refused("sub.exr", ErrorCode::unsupported, "subsampled");
}
