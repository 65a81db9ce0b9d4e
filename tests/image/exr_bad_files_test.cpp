// SPDX-License-Identifier: MIT
// Tests of OpenEXR files that are damaged or contradict themselves.
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfHeader.h>
#include <ImfPartType.h>
#include <sys/resource.h>

#include "image/stokes_image.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr auto bad = ErrorCode::invalid_file;

StokesImage some_image() {
    StokesImage image(40, 50, 3);
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (float& v : image.data) v = uniform(engine);
    return image;
}

/// Returns the peak memory of this process so far, in MiB.
long peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

/// Overwrites the value of a header attribute, found by its name and type.
void patch(std::string& bytes, const std::string& name, const std::string& type,
           const std::vector<std::int32_t>& value) {
    const std::string key = name + '\0' + type + '\0';
    const std::size_t at = bytes.find(key);
    REQUIRE(at != std::string::npos);
    std::memcpy(bytes.data() + at + key.size() + 4, value.data(), 4 * value.size());
}

/// Writes a small image that is zero except for one value.
void write_with(const std::filesystem::path& path, const std::string& channel, std::size_t pixel,
                float value) {
    StokesImage image(4, 3, 3);
    const std::size_t c = channel.back() == 'R' ? 0 : channel.back() == 'G' ? 1 : 2;
    const std::size_t p = channel.size() == 1 ? 0 : static_cast<std::size_t>(channel[1] - '0');
    image.data[(c * 12 + pixel) * 4 + p] = value;
    write_exr(path, image);
}

}  // namespace

TEST_CASE("missing, empty and foreign files") {
    const TemporaryFolder folder;
    check_error(ErrorCode::file_not_found, CALL(read_exr(folder / "none.exr")), "none.exr");
    check_error(ErrorCode::file_not_found, CALL(read_exr(folder.path())), folder.path().string());
    check_error(ErrorCode::file_not_found, CALL(read_exr("")), "cannot be opened");
    write_bytes(folder / "empty.exr", "");
    check_error(bad, CALL(read_exr(folder / "empty.exr")), "empty.exr", "is empty");
    write_bytes(folder / "text.exr", std::string(5000, 'x'));
    check_error(bad, CALL(read_exr(folder / "text.exr")), "text.exr", "OpenEXR");
}

TEST_CASE("a file cut anywhere is refused") {
    const TemporaryFolder folder;
    write_exr(folder / "whole.exr", some_image());
    const std::string bytes = file_bytes(folder / "whole.exr");
    std::vector<std::size_t> lengths;
    for (std::size_t n = 1; n < 1600; n += 7) lengths.push_back(n);
    for (std::size_t n = 1600; n < bytes.size(); n += bytes.size() / 60) lengths.push_back(n);
    lengths.push_back(bytes.size() - 1);
    for (const std::size_t n : lengths) {
        CAPTURE(n);
        write_bytes(folder / "cut.exr", bytes.substr(0, n));
        check_error(bad, CALL(read_exr(folder / "cut.exr")), "cut.exr");
    }
}

TEST_CASE("sizes beyond reason are refused before they are allocated") {
    const TemporaryFolder folder;
    write_exr(folder / "whole.exr", some_image());
    const std::string bytes = file_bytes(folder / "whole.exr");
    const long before = peak_megabytes();
    constexpr std::int32_t huge = std::numeric_limits<std::int32_t>::max();
    const std::vector<std::vector<std::int32_t>> windows = {
        {0, 0, huge, huge},       {0, 0, huge - 1, 49}, {0, 0, 39, huge - 1}, {-huge, -huge, huge, huge},
        {0, 0, 40000, 40000},     {0, 0, 32767, 32767}, {0, 0, -1, -1},       {5, 5, 3, 9},
        {0, 0, 39, 1'000'000},    {0, 0, 30000, 2000},  {0, 0, 39, 30000},    {huge - 5, 0, huge, 49},
        {-huge - 1, 0, -huge, 49}};
    for (const auto& window : windows) {
        CAPTURES(window[2], window[3]);
        std::string lie = bytes;
        patch(lie, "dataWindow", "box2i", window);
        write_bytes(folder / "lie.exr", lie);
        check_error(bad, CALL(read_exr(folder / "lie.exr")), "lie.exr");
    }
    // The header claims a text of 2 GB in a file of a few kilobytes.
    std::string lie = bytes;
    const std::string text = std::string("software") + '\0' + "string" + '\0';
    std::memcpy(lie.data() + lie.find(text) + text.size(), &huge, sizeof huge);
    write_bytes(folder / "lie.exr", lie);
    check_error(bad, CALL(read_exr(folder / "lie.exr")), "lie.exr", "attribute");
    CHECK(peak_megabytes() < before + 256);
}

TEST_CASE("attributes whose values end elsewhere than their sizes say are refused") {
    // OpenEXR would continue to read at the value's own end, where the next size may claim 2 GB.
    const TemporaryFolder folder;
    write_exr(folder / "whole.exr", some_image());
    const std::string bytes = file_bytes(folder / "whole.exr");
    const auto end_of = [&](const std::string& name, const std::string& type) {
        const std::string text = name + '\0' + type + '\0';
        REQUIRE(bytes.find(text) != std::string::npos);
        return bytes.find(text) + text.size();
    };
    const auto longer = [](std::string file, std::size_t at) {
        std::uint32_t size = 0;
        std::memcpy(&size, file.data() + at, sizeof size);
        file.insert(at + sizeof size + size, 8, '\x7f');
        size += 8;
        std::memcpy(file.data() + at, &size, sizeof size);
        return file;
    };
    for (const auto& [name, type] :
         {std::pair{"channels", "chlist"}, {"dataWindow", "box2i"}, {"pixelAspectRatio", "float"}}) {
        write_bytes(folder / "lie.exr", longer(bytes, end_of(name, type)));
        check_error(bad, CALL(read_exr(folder / "lie.exr")), "lie.exr", "the attribute \"", "claims");
    }
    // Attributes of types that OpenEXR does not write are checked, too.
    const std::string huge = "\xff\xff\xff\x7f";
    for (const std::string& lie : {std::string("a\0stringvector\0\5\0\0\0", 19) + huge + "x",
                                   std::string("preview\0preview\0\10\0\0\0", 20) + huge + huge}) {
        std::string file = bytes;
        write_bytes(folder / "lie.exr", file.insert(8, lie));
        check_error(bad, CALL(read_exr(folder / "lie.exr")), "lie.exr", "the attribute \"", "claims");
    }
}

TEST_CASE("an attribute that comes twice is refused") {
    // OpenEXR's libraries would each use a different one of the two, and only one is checked.
    const TemporaryFolder folder;
    write_exr(folder / "whole.exr", some_image());
    std::string lie = file_bytes(folder / "whole.exr");
    const std::string window = std::string("dataWindow") + '\0' + "box2i" + '\0';
    const std::string twice = lie.substr(lie.find(window), window.size() + 4 + 16);
    write_bytes(folder / "lie.exr", lie.insert(8, twice));
    check_error(bad, CALL(read_exr(folder / "lie.exr")), "lie.exr", "\"dataWindow\" comes twice");
}

TEST_CASE("values that are not finite are named by channel and pixel") {
    const TemporaryFolder folder;
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    write_with(folder / "a.exr", "S1.G", 6, not_a_number);
    check_error(bad, CALL(read_exr(folder / "a.exr")), "a.exr", "channel S1.G", "pixel (2, 1)",
                "not a number");
    write_with(folder / "a.exr", "S3.B", 11, -infinity);
    check_error(bad, CALL(read_exr(folder / "a.exr")), "channel S3.B", "pixel (3, 2)", "infinite");
    write_with(folder / "a.exr", "S0.R", 0, infinity);
    check_error(bad, CALL(read_exr(folder / "a.exr")), "channel S0.R", "pixel (0, 0)");
}

TEST_CASE("deep data is refused") {
    const TemporaryFolder folder;
    Imf::Header header(2, 1);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::NO_COMPRESSION;
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    {
        unsigned counts[] = {1, 1};
        float values[] = {3, 4};
        float* samples[] = {&values[0], &values[1]};
        Imf::DeepFrameBuffer buffer;
        buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts), 4, 8));
        buffer.insert("Y", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples), sizeof(float*),
                                          2 * sizeof(float*), sizeof(float)));
        Imf::DeepScanLineOutputFile file((folder / "a.exr").c_str(), header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    check_error(ErrorCode::unsupported, CALL(read_exr(folder / "a.exr")), "a.exr", "deep");
}

TEST_CASE("random damage is an error or an image, never a crash") {
    const TemporaryFolder folder;
    write_exr(folder / "whole.exr", some_image());
    const std::string bytes = file_bytes(folder / "whole.exr");
    std::mt19937 engine(5);
    for (int i = 0; i < 300; ++i) {
        std::string damaged = bytes;
        const std::size_t reach = i % 2 == 0 ? 1400 : bytes.size();
        for (int k = 0; k < 3; ++k) damaged[engine() % reach] = static_cast<char>(engine() & 0xff);
        write_bytes(folder / "damaged.exr", damaged);
        try {
            read_exr(folder / "damaged.exr").check("damaged");
        } catch (const Error& e) {
            CHECK(std::string(e.what()).find("damaged.exr") != std::string::npos);
        }
    }
}
