// SPDX-License-Identifier: MIT
// Tests of Stokes images through OpenEXR files.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>

#include <set>

#include "image/file_size_limit.hpp"
#include "image/stokes_image.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

StokesImage numbered(int width, int height, int channels) {
    StokesImage image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<float>(i % 977) * 0.37f - 50.0f;
    return image;
}

std::set<std::string> channel_names(const std::filesystem::path& path) {
    std::set<std::string> names;
    const Imf::InputFile file(path.c_str());
    const Imf::ChannelList& list = file.header().channels();
    for (auto i = list.begin(); i != list.end(); ++i) names.insert(i.name());
    return names;
}

/// Writes the channels with the values 0.25, 1.25, 2.25 ... by pixel. The data window starts at `origin`.
void write_channels(const std::filesystem::path& path, const std::vector<std::string>& names,
                    Imf::PixelType type, Imf::Compression compression, bool tiled, Imath::V2i origin) {
    const int width = 21;
    const int height = 19;
    const Imath::Box2i window(origin, origin + Imath::V2i(width - 1, height - 1));
    Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), window);
    header.compression() = compression;
    std::vector<float> values(static_cast<std::size_t>(width * height));
    std::vector<unsigned> integers(values.size());
    std::vector<Imath::half> halves(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(i) + 0.25f;
        integers[i] = static_cast<unsigned>(i);
        halves[i] = values[i];
    }
    Imf::FrameBuffer buffer;
    for (const std::string& name : names) {
        header.channels().insert(name, Imf::Channel(type));
        void* base = values.data();
        if (type == Imf::UINT) base = integers.data();
        if (type == Imf::HALF) base = halves.data();
        const std::size_t size = type == Imf::HALF ? 2 : 4;
        buffer.insert(name, Imf::Slice::Make(type, base, window, size, size * width));
    }
    if (tiled) {
        header.setTileDescription(Imf::TileDescription(8, 8));
        Imf::TiledOutputFile file(path.c_str(), header, 0);
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(path.c_str(), header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    }
}

}  // namespace

TEST_CASE("what is written comes back bit for bit, under Mitsuba's channel names") {
    const TemporaryFolder folder;
    for (const int channels : {1, 3}) {
        const StokesImage image = numbered(37, 23, channels);
        write_exr(folder / "a.exr", image, {.comment = "a note"});
        const StokesImage back = read_exr(folder / "a.exr");
        CHECK(back.width == 37);
        CHECK(back.height == 23);
        CHECK(back.channels == channels);
        CHECK(back.data == image.data);
        const std::set<std::string> rgb = {"R",    "G",    "B",    "S0.R", "S0.G", "S0.B", "S1.R", "S1.G",
                                           "S1.B", "S2.R", "S2.G", "S2.B", "S3.R", "S3.G", "S3.B"};
        const std::set<std::string> grey = {"Y", "S0.Y", "S1.Y", "S2.Y", "S3.Y"};
        CHECK(channel_names(folder / "a.exr") == (channels == 3 ? rgb : grey));
        const Imf::InputFile file((folder / "a.exr").c_str());
        CHECK(file.header().channels().findChannel(channels == 3 ? "S2.G" : "S2.Y")->type == Imf::FLOAT);
        const auto text = [&](const char* name) {
            return file.header().typedAttribute<Imf::StringAttribute>(name).value();
        };
        CHECK(text("stokesFrame").find("x image right, y image up") != std::string::npos);
        CHECK(text("comments") == "a note");
        CHECK(text("software").find("Nicol") == 0);
    }
    CHECK(folder.names().size() == 1);
}

TEST_CASE("R G B hold s0, so that any viewer shows the image, and only the asked components are beside it") {
    const TemporaryFolder folder;
    const StokesImage image = numbered(4, 3, 3);
    for (const std::uint32_t components : {0b0000U, 0b0110U}) {
        write_exr(folder / "a.exr", image, {.components = components});
        std::set<std::string> names = {"R", "G", "B"};
        if (components != 0)
            names.merge(std::set<std::string>{"S1.R", "S1.G", "S1.B", "S2.R", "S2.G", "S2.B"});
        CHECK(channel_names(folder / "a.exr") == names);
        const StokesImage back = read_exr(folder / "a.exr");
        for (std::size_t i = 0; i < image.data.size(); ++i)
            CHECK(back.data[i] == (i % 4 == 0 || (components >> i % 4 & 1) != 0 ? image.data[i] : 0));
    }
}

TEST_CASE("any pixel type, compression, tiling and data window is read; the image is the display window") {
    const TemporaryFolder folder;
    const std::vector<std::string> names = {"A", "B", "G", "R", "Z"};
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression) {
        for_all({false, true}, {Imf::HALF, Imf::FLOAT, Imf::UINT}, [&](bool tiled, Imf::PixelType type) {
            CAPTURES(compression, tiled, type);
            write_channels(folder / "a.exr", names, type, static_cast<Imf::Compression>(compression), tiled,
                           {-3, 40});
            const StokesImage image = read_exr(folder / "a.exr");
            REQUIRE(image.width == 100);
            REQUIRE(image.height == 100);
            REQUIRE(image.channels == 3);
            const float fraction = type == Imf::UINT ? 0.0f : 0.25f;
            // Lossy compressions preserve neighbouring values to about a percent.
            CHECK(image.at(2, 40, 0)[0] == doctest::Approx(3 + fraction).epsilon(0.5));
            CHECK(image.at(1, 58, 17)[0] == doctest::Approx(18 * 21 + 20 + fraction).epsilon(0.02));
            // Pixels outside the data window are zero.
            const std::pair<int, int> beside[] = {{39, 5}, {59, 5}, {50, 18}, {99, 99}};
            for (const auto& [y, x] : beside) CHECK(image.at(0, y, x)[0] == 0);
        });
    }
    // The data window and the display window are disjoint.
    write_channels(folder / "far.exr", names, Imf::HALF, Imf::ZIP_COMPRESSION, false, {500, -300});
    CHECK(std::ranges::all_of(read_exr(folder / "far.exr").data, [](float value) { return value == 0; }));
    write_channels(folder / "y.exr", {"Y"}, Imf::HALF, Imf::ZIP_COMPRESSION, false, {0, 0});
    CHECK(read_exr(folder / "y.exr").channels == 1);
    CHECK(read_exr(folder / "y.exr").at(0, 0, 5)[0] == 5.25f);
}

TEST_CASE("of several parts the first is read") {
    const TemporaryFolder folder;
    std::vector<Imf::Header> headers;
    for (const char* name : {"first", "second"}) {
        const int right = name[0] == 'f' ? 2 : 6;
        headers.emplace_back(Imath::Box2i({0, 0}, {9, 9}), Imath::Box2i({0, 0}, {right, 1}));
        headers.back().channels().insert("Y", Imf::Channel(Imf::FLOAT));
        headers.back().setName(name);
        headers.back().setType(Imf::SCANLINEIMAGE);
    }
    std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
    {
        Imf::MultiPartOutputFile file((folder / "a.exr").c_str(), headers.data(), 2, false, 0);
        for (int i = 0; i < 2; ++i) {
            Imf::FrameBuffer buffer;
            const std::size_t row =
                4 * static_cast<std::size_t>(headers[static_cast<std::size_t>(i)].dataWindow().max.x + 1);
            buffer.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, row));
            Imf::OutputPart part(file, i);
            part.setFrameBuffer(buffer);
            part.writePixels(2);
        }
    }
    const StokesImage image = read_exr(folder / "a.exr");
    CHECK(image.width == 10);
    CHECK(image.at(0, 1, 0)[0] == 4);
}

TEST_CASE("files that call for channels they lack are refused by the name of the channel") {
    const TemporaryFolder folder;
    const auto refuse = [&](const std::vector<std::string>& names, ErrorCode code, const std::string& what) {
        write_channels(folder / "a.exr", names, Imf::FLOAT, Imf::NO_COMPRESSION, false, {0, 0});
        check_error(code, CALL(read_exr(folder / "a.exr")), "a.exr", what);
    };
    const auto bad = ErrorCode::invalid_file;
    refuse({"R", "B"}, bad, "no channel G");
    refuse({"A", "Z"}, bad, "neither R G B nor Y");
    refuse({"Y", "S2.Y"}, bad, "no channel S1.Y");
    refuse({"Y", "S1.Y"}, bad, "no channel S2.Y");
    refuse({"Y", "S3.Y"}, bad, "no channel S1.Y");
    refuse({"R", "G", "B", "S1.R", "S1.B", "S2.R", "S2.G", "S2.B"}, bad, "no channel S1.G");
    refuse({"R", "G", "B", "S0.R"}, bad, "no channel S0.G");
    refuse({"Y", "RY", "BY"}, ErrorCode::unsupported, "chroma");
    // S0 channels are enough without R G B.
    write_channels(folder / "b.exr", {"S0.R", "S0.G", "S0.B"}, Imf::FLOAT, Imf::NO_COMPRESSION, false,
                   {0, 0});
    CHECK(read_exr(folder / "b.exr").at(1, 0, 3)[0] == 3.25f);
}

TEST_CASE("a file that cannot be written is an error and leaves nothing behind") {
    const TemporaryFolder folder;
    const StokesImage image = numbered(4, 3, 3);
    const auto bad = ErrorCode::write_failed;
    check_error(bad, CALL(write_exr(folder / "none" / "a.exr", image)), "none/a.exr");
    std::filesystem::create_directories(folder / "taken.exr" / "inside");
    check_error(bad, CALL(write_exr(folder / "taken.exr", image)), "taken.exr");
    check_error(bad, CALL(write_exr(folder.path() / "", image)), "folder");
    check_error(bad, CALL(write_exr("", image)), "cannot be written");
    CHECK(folder.names().size() == 1);
    // The file name is too long for the system.
    check_error(bad, CALL(write_exr(folder / std::string(300, 'a'), image)), "aaaa");
    check_error(ErrorCode::invalid_argument, CALL(write_exr(folder / "a.exr", StokesImage())), "image");
    check_error(ErrorCode::invalid_argument, CALL(write_exr(folder / "a.exr", StokesImage(2, 2, 17))),
                "17 channels");
    check_error(ErrorCode::invalid_argument,
                CALL(write_exr(folder / "a.exr", image, {.components = 0b10000})), "components");
}

TEST_CASE("a full disk is an error, at whatever byte it is full") {
    const TemporaryFolder folder;
    const StokesImage image = numbered(60, 40, 3);
    write_exr(folder / "whole.exr", image);
    const auto size = std::filesystem::file_size(folder / "whole.exr");
    for (const auto limit : {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 1}) {
        const FileSizeLimit full(limit);
        check_error(ErrorCode::write_failed, CALL(write_exr(folder / "a.exr", image)), "a.exr");
    }
    CHECK(folder.names().size() == 1);
}

TEST_CASE("an existing file is replaced only by a complete one") {
    const TemporaryFolder folder;
    write_exr(folder / "a.exr", numbered(4, 3, 1));
    CHECK_THROWS((void)write_exr(folder / "a.exr", StokesImage(2, 2, 17)));
    CHECK(read_exr(folder / "a.exr").width == 4);
    write_exr(folder / "a.exr", numbered(9, 2, 1));
    CHECK(read_exr(folder / "a.exr").width == 9);
    CHECK(folder.names().size() == 1);
}

TEST_CASE("Mitsuba's own files are read") {
    const auto file = test_data("mitsuba/sphere_const_a03.exr");
    if (file.empty()) return;
    const StokesImage image = read_exr(file);
    CHECK(image.width == 128);
    CHECK(image.channels == 3);
    // A dielectric sphere under uniform light. At the right of its rim the plane of incidence is horizontal,
    // so the reflected light is polarized vertically, s1 < 0. Above the middle it is polarized horizontally,
    // s1 > 0.
    CHECK(image.at(1, 64, 64 + 45)[1] < -0.01f);
    CHECK(image.at(1, 64 - 45, 64)[1] > 0.01f);
    // Towards the upper right the field is perpendicular to that direction, at -45 degrees, so s2 < 0.
    CHECK(image.at(1, 64 - 32, 64 + 32)[2] < -0.01f);
}
