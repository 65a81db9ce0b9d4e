// SPDX-License-Identifier: MIT
// Tests of spectral Stokes images, and of images with any number of channels.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include "image/stokes_image.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr auto bad = ErrorCode::invalid_file;

/// Writes a 2 x 1 image in which channel number i of the list has the value i + 1.
void write_named(const std::filesystem::path& path, const std::vector<std::string>& names,
                 const std::string& handedness = "", int sampling = 1) {
    Imf::Header header(2, 1);
    if (!handedness.empty()) header.insert("polarisationHandedness", Imf::StringAttribute(handedness));
    std::vector<float> values(2 * names.size());
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < names.size(); ++i) {
        values[2 * i] = values[2 * i + 1] = static_cast<float>(i + 1);
        header.channels().insert(names[i], Imf::Channel(Imf::FLOAT, sampling, 1));
        buffer.insert(names[i],
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&values[2 * i]), 4, 8, sampling, 1));
    }
    Imf::OutputFile file(path.c_str(), header, 0);
    file.setFrameBuffer(buffer);
    file.writePixels(1);
}

}  // namespace

TEST_CASE("spectral images come back, in the names of Fichet et al.") {
    const TemporaryFolder folder;
    StokesImage image(5, 4, 16);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i) * 0.5f;
    for (int c = 0; c < 16; ++c) image.wavelengths.push_back(400 + 20.5 * c);
    write_exr(folder / "a.exr", image);
    const StokesImage back = read_exr(folder / "a.exr");
    CHECK(back.wavelengths == image.wavelengths);
    CHECK(back.data == image.data);
    const Imf::InputFile file((folder / "a.exr").c_str());
    for (const char* name : {"S0.400,000000nm", "S1.420,500000nm", "S3.707,500000nm"})
        CHECK(file.header().channels().findChannel(name) != nullptr);
    CHECK(file.header().channels().findChannel("R") == nullptr);
    const auto text = [&](const char* name) {
        return file.header().typedAttribute<Imf::StringAttribute>(name).value();
    };
    CHECK(text("spectralLayoutVersion") == "1.0");
    CHECK(text("polarisationHandedness") == "right");
    CHECK(text("emissiveUnits") == "W.m^-2.sr^-1");

    // The nearest wavelengths are read, in the requested order.
    const std::vector<double> wanted = {705, 400, 430};
    const StokesImage chosen = read_exr(folder / "a.exr", wanted);
    CHECK(chosen.wavelengths == std::vector<double>{707.5, 400, 420.5});
    CHECK(chosen.at(0, 1, 2)[3] == image.at(15, 1, 2)[3]);
    CHECK(chosen.at(2, 3, 4)[1] == image.at(1, 3, 4)[1]);
    for (const double nm : {399.0, 708.0, std::nan("")}) {
        const std::vector<double> outside = {nm};
        check_error(ErrorCode::invalid_argument, CALL(read_exr(folder / "a.exr", outside)), "a.exr", "707.5");
    }
}

TEST_CASE("any number of channels without wavelengths comes back") {
    const TemporaryFolder folder;
    for (const int channels : {2, 5, 16}) {
        StokesImage image(3, 2, channels);
        for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i);
        write_exr(folder / "a.exr", image);
        const StokesImage back = read_exr(folder / "a.exr");
        CHECK(back.channels == channels);
        CHECK(back.data == image.data);
        CHECK(back.wavelengths.empty());
    }
}

TEST_CASE("wavelengths are read in any order, exponent and unit, and preview channels ignored") {
    const TemporaryFolder folder;
    const std::string file = folder / "a.exr";
    write_named(file, {"S0.7E-7m", "R", "G", "B", "S0.0,55um", "S0.500THz", "S0.4,5e2nm"});
    const StokesImage image = read_exr(file);
    REQUIRE(image.channels == 4);
    const std::vector<double> expected = {450, 550, 599.584916, 700};
    const std::vector<float> values = {7, 5, 6, 1};
    for (std::size_t c = 0; c < 4; ++c) {
        CHECK(image.wavelengths[c] == doctest::Approx(expected[c]).epsilon(1e-12));
        CHECK(image.at(static_cast<int>(c), 0, 1)[0] == values[c]);
        CHECK(image.at(static_cast<int>(c), 0, 1)[1] == 0);
    }
}

TEST_CASE("a left-handed file has the other sign of s3") {
    const TemporaryFolder folder;
    const std::string file = folder / "a.exr";
    const std::vector<std::string> names = {"S0.500nm", "S1.500nm", "S2.500nm", "S3.500nm"};
    for (const std::string handedness : {"", "right", "left"}) {
        write_named(file, names, handedness);
        CHECK(read_exr(file).stokes(0, 0, 1) == Stokes(1, 2, 3, handedness == "left" ? -4 : 4));
    }
    write_named(file, names, "both");
    check_error(bad, CALL(read_exr(file)), "polarisationHandedness", "both");
}

TEST_CASE("spectral files that lack or repeat something are refused") {
    const TemporaryFolder folder;
    const std::string file = folder / "a.exr";
    const auto refuse = [&](const std::vector<std::string>& names, ErrorCode code, const std::string& part) {
        write_named(file, names);
        check_error(code, CALL(read_exr(file)), "a.exr", part);
    };
    refuse({"S0.500nm", "S1.500nm"}, bad, "no channel S2.500nm");
    refuse({"S0.500nm", "S0.600nm", "S1.500nm", "S2.500nm"}, bad, "no channel S1.600nm");
    refuse({"S1.500nm", "S2.500nm"}, bad, "no channel S0.500nm");
    refuse({"S0.500nm", "S0.500,0nm"}, bad, "same wavelength");
    refuse({"T.500nm", "T.600nm"}, ErrorCode::unsupported, "reflectances");
    // These names contain no wavelength.
    for (const char* name :
         {"S0.-5nm", "S0.0nm", "S0.nm", "S0.5xm", "S0.5", "S0.1e999nm", "S4.500nm", "S0.5,5,5nm"})
        refuse({name}, bad, "has neither");
    std::vector<std::string> many;
    for (int i = 0; i < 31; ++i) many.push_back("S0." + std::to_string(400 + 10 * i) + "nm");
    refuse(many, ErrorCode::unsupported, "31 wavelengths");
    const std::vector<double> three = {450, 550, 650};
    CHECK(read_exr(file, three).at(2, 0, 0)[0] == 26);
    many.clear();
    for (int i = 0; i < 17; ++i) many.push_back("S0." + std::to_string(i));
    refuse(many, ErrorCode::unsupported, "17 channels");
    for (const char* name : {"S0.500nm", "Y"}) {
        write_named(file, {name}, "", 2);
        check_error(ErrorCode::unsupported, CALL(read_exr(file)), std::string("channel ") + name,
                    "subsampled");
    }
    write_named(file, {"R", "G", "B"});
    check_error(ErrorCode::invalid_argument, CALL(read_exr(file, three)), "no wavelengths");
}

TEST_CASE("wavelengths of an image that make no sense are refused") {
    const TemporaryFolder folder;
    StokesImage image(2, 2, 3);
    for (const std::vector<double>& wrong : {std::vector<double>{500},
                                             {500, 600, -1},
                                             {500, 600, std::numeric_limits<double>::infinity()},
                                             {500, 500, 600},
                                             {600, 500, 700}}) {
        image.wavelengths = wrong;
        check_error(ErrorCode::invalid_argument, CALL(write_exr(folder / "a.exr", image)), "wavelength");
    }
    CHECK(folder.names().size() == 0);
}
