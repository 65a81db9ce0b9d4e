// SPDX-License-Identifier: MIT
// Files of light from one format to another.
#include <cstdlib>

#include "inspect.hpp"
#include "psh_checks.hpp"

using namespace capi_test;

namespace {

std::string test_data(const char* name) {
    const char* folder = std::getenv("NICOL_TEST_DATA");
    const std::string path = std::string(folder != nullptr ? folder : "") + "/" + name;
    return folder != nullptr && std::filesystem::exists(path) ? path : "";
}

}  // namespace

TEST_CASE("inspect: written coefficients are read as they were") {
    const TemporaryFolder folder;
    std::mt19937 random(3);
    for (const std::uint32_t order : {0U, 1U, 7U}) {
        const Doubles field = random_fields(random, order, 2);
        write_light(folder.file("f.npz"), order, field);
        CHECK(difference(coefficients_of(folder.file("f.npz"), order, 2), field) == 0);
    }
    const std::string path = folder.file("no.npz");
    const Doubles f(vector_size(3));
    FAILS(nicol_psh_write_file("", 3, 1, f.data(), f.size()), NICOL_ERROR_INVALID_ARGUMENT, "path");
    for (const std::uint64_t vectors : {std::uint64_t{0}, std::uint64_t{17}, huge})
        FAILS(nicol_psh_write_file(path.c_str(), 3, vectors, f.data(), f.size()),
              NICOL_ERROR_INVALID_ARGUMENT, "vectors");
    FAILS(nicol_psh_write_file(folder.file("none/f.npz").c_str(), 3, 1, f.data(), f.size()),
          NICOL_ERROR_WRITE_FAILED, "none/f.npz");
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}

TEST_CASE("inspect: light without high orders survives images in both directions") {
    const TemporaryFolder folder;
    std::mt19937 random(4);
    for (const std::uint32_t order : {2U, 9U, 40U}) {
        CAPTURE(order);
        const Doubles field = random_light(random, order, 3);
        const double scale = largest_of(field);
        write_light(folder.file("a.npz"), order, field);
        convert(folder.file("a.npz"), folder.file("a.exr"), NICOL_FILE_OPTIONS_INIT);
        const nicol_file_options exact = of_order(static_cast<std::int32_t>(order), NICOL_FILE_BAND_LIMITED);
        convert(folder.file("a.exr"), folder.file("b.npz"), exact);
        CHECK(difference(coefficients_of(folder.file("b.npz"), order, 3), field) < 1e-6 * scale);
        // And images through coefficients.
        convert(folder.file("b.npz"), folder.file("b.exr"), NICOL_FILE_OPTIONS_INIT);
        const nicol::StokesImage a = nicol::read_exr(folder.file("a.exr"));
        const nicol::StokesImage b = nicol::read_exr(folder.file("b.exr"));
        REQUIRE(a.data.size() == b.data.size());
        double largest = 0;
        double apart = 0;
        for (std::size_t i = 0; i < a.data.size(); ++i) {
            largest = std::max(largest, static_cast<double>(std::abs(a.data[i])));
            apart = std::max(apart, static_cast<double>(std::abs(a.data[i] - b.data[i])));
        }
        CHECK(apart < 2e-6 * largest);
    }
    SUBCASE("as the bilinear function it is smoothed a little") {
        const Doubles field = random_light(random, 9, 1);
        write_light(folder.file("a.npz"), 9, field);
        convert(folder.file("a.npz"), folder.file("a.exr"), NICOL_FILE_OPTIONS_INIT);
        convert(folder.file("a.exr"), folder.file("b.npz"), of_order(9));
        const double apart = difference(coefficients_of(folder.file("b.npz"), 9, 1), field);
        CHECK(apart > 1e-5);
        CHECK(apart < 1e-3 * largest_of(field));
    }
}

TEST_CASE("inspect: an image of coefficients shows the field where nicol_image says it is") {
    const TemporaryFolder folder;
    write_sky(folder.file("sky.exr"), 128, 65);
    convert(folder.file("sky.exr"), folder.file("sky.npz"), of_order(2, NICOL_FILE_BAND_LIMITED));
    CHECK(difference_from_sky(2, coefficients_of(folder.file("sky.npz"), 2, 1).data()) < 1e-6);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.width = 30;
    options.height = 17;
    convert(folder.file("sky.npz"), folder.file("small.exr"), options);
    const nicol::StokesImage image = nicol::read_exr(folder.file("small.exr"));
    REQUIRE(image.width == 30);
    REQUIRE(image.height == 17);
    const std::vector<float> wanted = sky_image(30, 17, 1);
    for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(std::abs(image.data[i] - wanted[i]) < 1e-6F);
}

TEST_CASE("inspect: an image of unpolarized coefficients has no polarized channels") {
    const TemporaryFolder folder;
    std::mt19937 random(9);
    Doubles field = random_light(random, 6, 1);
    for (std::size_t i = 0; i < field.size(); ++i)
        if (i % 4 != 0) field[i] = 0;
    write_light(folder.file("f.npz"), 6, field);
    convert(folder.file("f.npz"), folder.file("f.exr"), NICOL_FILE_OPTIONS_INIT);
    CHECK(light_report_of(folder.file("f.npz")).polarized == 0);
    CHECK(file_bytes(folder.file("f.exr")).find("S1.Y") == std::string::npos);
}

TEST_CASE("inspect: an image gets another size") {
    const TemporaryFolder folder;
    write_sky(folder.file("sky.exr"), 256, 129);
    for (const auto& [width, height] : {std::pair(64U, 33U), std::pair(100U, 200U), std::pair(512U, 257U)}) {
        CAPTURE(width);
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        options.width = width;
        options.height = height;
        convert(folder.file("sky.exr"), folder.file("out.exr"), options);
        const nicol::StokesImage image = nicol::read_exr(folder.file("out.exr"));
        const std::vector<float> wanted = sky_image(width, height, 1);
        REQUIRE(image.data.size() == wanted.size());
        // At the poles the frames of a row turn with the columns: means over large pixels lose there.
        for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(std::abs(image.data[i] - wanted[i]) < 6e-3F);
    }
}

TEST_CASE("inspect: light is rotated and scaled") {
    const TemporaryFolder folder;
    std::mt19937 random(5);
    const Rotation turn = random_rotation(random);
    const Doubles field = random_light(random, 5, 2);
    Doubles wanted = field;
    OK(nicol_psh_rotate(5, 2, field.data(), field.size(), turn.data(), wanted.data(), wanted.size()));
    for (double& v : wanted) v *= 2.5;
    const double scale = largest_of(wanted);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    set_rotation(options, turn);
    options.scale = 2.5;
    write_light(folder.file("f.npz"), 5, field);

    convert(folder.file("f.npz"), folder.file("rotated.npz"), options);
    CHECK(difference(coefficients_of(folder.file("rotated.npz"), 5, 2), wanted) < 1e-12 * scale);

    convert(folder.file("f.npz"), folder.file("rotated.exr"), options);
    convert(folder.file("rotated.exr"), folder.file("back.npz"), of_order(5, NICOL_FILE_BAND_LIMITED));
    CHECK(difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) < 1e-6 * scale);

    convert(folder.file("f.npz"), folder.file("f.exr"), NICOL_FILE_OPTIONS_INIT);
    convert(folder.file("f.exr"), folder.file("rotated.exr"), options);  // by look-ups in the image
    convert(folder.file("rotated.exr"), folder.file("back.npz"), of_order(5, NICOL_FILE_BAND_LIMITED));
    CHECK(difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) < 5e-4 * scale);

    options.order = 5;
    options.flags = NICOL_FILE_BAND_LIMITED;
    convert(folder.file("f.exr"), folder.file("back.npz"), options);
    CHECK(difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) < 1e-6 * scale);
}

TEST_CASE("inspect: cube maps hold the same light") {
    const TemporaryFolder folder;
    std::mt19937 random(6);
    const Doubles field = random_light(random, 4, 3);
    write_light(folder.file("f.npz"), 4, field);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.edge = 96;
    convert(folder.file("f.npz"), folder.file("cube_s2.exr"), options);
    CHECK(folder.names() ==
          std::set<std::string>{"f.npz", "cube_s0.exr", "cube_s1.exr", "cube_s2.exr", "cube_s3.exr"});
    for (const char* name : {"cube_s1.exr", "cube"}) {
        nicol_file_kind kind = 0;
        OK(nicol_file_identify(folder.file(name).c_str(), &kind));
        CHECK(kind == NICOL_FILE_LIGHT_CROSS);
        convert(folder.file(name), folder.file("back.npz"), of_order(4));
        CHECK(difference(coefficients_of(folder.file("back.npz"), 4, 3), field) < 1e-3 * largest_of(field));
    }
}

TEST_CASE("inspect: the authors' cube map is the light of their coefficients") {
    const std::string cube = test_data("polarsh/sponza_64_s0.exr");
    const std::string vector = test_data("polarsh/SHVec_sponza_1024_L100.npz");
    if (cube.empty() || vector.empty()) {
        MESSAGE("skipped: no polarsh files in NICOL_TEST_DATA");
        return;
    }
    const TemporaryFolder folder;
    const Doubles wanted = coefficients_of(vector, 4, 3);
    CHECK(std::abs(wanted[position(2, 0, 1)] - 0.18872) < 1e-5);
    convert(cube, folder.file("direct.npz"), of_order(4));
    convert(cube, folder.file("sponza.exr"), NICOL_FILE_OPTIONS_INIT);
    convert(folder.file("sponza.exr"), folder.file("image.npz"), of_order(4));
    for (const char* name : {"direct.npz", "image.npz"})
        CHECK(difference(coefficients_of(folder.file(name), 4, 3), wanted) < 5e-3);
}

TEST_CASE("inspect: a given order cuts coefficients and smooths images") {
    const TemporaryFolder folder;
    std::mt19937 random(7);
    const Doubles field = random_light(random, 6, 1);
    write_light(folder.file("f.npz"), 6, field);
    convert(folder.file("f.npz"), folder.file("cut.npz"), of_order(3));
    Doubles wanted(field.begin(), field.begin() + static_cast<std::ptrdiff_t>(vector_size(3)));
    CHECK(difference(coefficients_of(folder.file("cut.npz"), 3, 1), wanted) == 0);
    CHECK(light_report_of(folder.file("cut.npz")).order == 3);
    const nicol_file_options zero = of_order(-1);
    convert(folder.file("f.npz"), folder.file("cut.npz"), zero);
    CHECK(light_report_of(folder.file("cut.npz")).order == 0);

    convert(folder.file("f.npz"), folder.file("f.exr"), NICOL_FILE_OPTIONS_INIT);
    convert(folder.file("f.exr"), folder.file("smooth.exr"), of_order(3, NICOL_FILE_BAND_LIMITED));
    wanted.resize(vector_size(6));
    convert(folder.file("smooth.exr"), folder.file("back.npz"), of_order(6, NICOL_FILE_BAND_LIMITED));
    CHECK(difference(coefficients_of(folder.file("back.npz"), 6, 1), wanted) < 1e-6 * largest_of(wanted));
}

TEST_CASE("inspect: wavelengths of spectral images") {
    const TemporaryFolder folder;
    nicol::StokesImage image(8, 4, 4);
    image.wavelengths = {450, 500, 550, 600};
    for (int c = 0; c < 4; ++c)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 8; ++x) image.at(c, y, x)[0] = static_cast<float>(c + 1);
    nicol::write_exr(folder.file("s.exr"), image);
    nicol_light_report r = light_report_of(folder.file("s.exr"));
    CHECK(r.channels == 4);
    CHECK(r.wavelengths[3] == 600);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.wavelengths = spectrum({598, 460});
    r = light_report_of(folder.file("s.exr"), &options);
    CHECK(r.channels == 2);
    CHECK((r.wavelengths[0] == 600 && r.wavelengths[1] == 450));
    CHECK((r.mean[0] == doctest::Approx(4) && r.mean[1] == doctest::Approx(1)));
    convert(folder.file("s.exr"), folder.file("copy.exr"), NICOL_FILE_OPTIONS_INIT);
    CHECK(light_report_of(folder.file("copy.exr")).wavelengths[2] == 550);
    write_sky(folder.file("sky.exr"), 16, 9);
    for (const char* name : {"sky.exr", "none_s0.exr"}) {
        const nicol_result result =
            nicol_file_convert(folder.file(name).c_str(), &options, folder.file("o.npz").c_str());
        CHECK(result == NICOL_ERROR_INVALID_ARGUMENT);
    }
}
