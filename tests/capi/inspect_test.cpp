// SPDX-License-Identifier: MIT
// Files of light: from one format to another, and what they hold.
#include "inspect.hpp"

#include <cstdlib>

#include "nicol/stokes_image.hpp"
#include "psh_checks.hpp"
#include "psh_sky.hpp"

using namespace capi_test;

namespace {

nicol_light_report report_of(const std::string& path, const nicol_file_options* options = nullptr) {
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    OK(nicol_file_describe_light(path.c_str(), options, &report, nullptr, 0));
    return report;
}

// The sky of psh_sky.hpp as a picture file.
void write_sky(const std::string& path, std::uint32_t width, std::uint32_t height) {
    const std::vector<float> pixels = sky_picture(width, height, 1);
    nicol::StokesImage picture(static_cast<int>(width), static_cast<int>(height), 1);
    std::copy(pixels.begin(), pixels.end(), picture.data.begin());
    nicol::write_exr(path, picture);
}

std::string test_data(const char* name) {
    const char* folder = std::getenv("NICOL_TEST_DATA");
    const std::string path = std::string(folder != nullptr ? folder : "") + "/" + name;
    return folder != nullptr && std::filesystem::exists(path) ? path : "";
}

}  // namespace

TEST_CASE("inspect: written coefficients are read as they were") {
    const Folder folder;
    std::mt19937 random(3);
    for (const std::uint32_t order : {0U, 1U, 7U}) {
        const Doubles field = random_fields(random, order, 2);
        write_light(folder.file("f.npz"), order, field);
        CHECK(difference(coefficients_of(folder.file("f.npz"), order, 2), field) == 0);
    }
    const std::string path = folder.file("no.npz");
    const Doubles f(vector_size(3));
    FAILS(nicol_psh_write_file(nullptr, 3, 1, f.data(), f.size()), NICOL_ERROR_INVALID_ARGUMENT, "path");
    FAILS(nicol_psh_write_file("", 3, 1, f.data(), f.size()), NICOL_ERROR_INVALID_ARGUMENT, "path");
    for (const std::uint64_t vectors : {std::uint64_t{0}, std::uint64_t{17}, huge})
        FAILS(nicol_psh_write_file(path.c_str(), 3, vectors, f.data(), f.size()),
              NICOL_ERROR_INVALID_ARGUMENT, "vectors");
    check_order(NICOL_PSH_MAX_ORDER, "order", [&](std::uint32_t order) {
        return nicol_psh_write_file(path.c_str(), order, 1, f.data(), f.size());
    });
    check_input(f.size(), "coefficients", [&](const double* values, std::uint64_t count) {
        return nicol_psh_write_file(path.c_str(), 3, 1, values, count);
    });
    FAILS(nicol_psh_write_file(folder.file("none/f.npz").c_str(), 3, 1, f.data(), f.size()),
          NICOL_ERROR_WRITE_FAILED, "none/f.npz");
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}

TEST_CASE("inspect: light without high orders survives pictures in both directions") {
    const Folder folder;
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
        // And pictures through coefficients.
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

TEST_CASE("inspect: a picture of coefficients shows the field where nicol_image says it is") {
    const Folder folder;
    write_sky(folder.file("sky.exr"), 128, 65);
    convert(folder.file("sky.exr"), folder.file("sky.npz"), of_order(2, NICOL_FILE_BAND_LIMITED));
    CHECK(difference_from_sky(2, coefficients_of(folder.file("sky.npz"), 2, 1).data()) < 1e-6);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.width = 30;
    options.height = 17;
    convert(folder.file("sky.npz"), folder.file("small.exr"), options);
    const nicol::StokesImage picture = nicol::read_exr(folder.file("small.exr"));
    REQUIRE(picture.width == 30);
    REQUIRE(picture.height == 17);
    const std::vector<float> wanted = sky_picture(30, 17, 1);
    for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(std::abs(picture.data[i] - wanted[i]) < 1e-6F);
}

TEST_CASE("inspect: a picture of unpolarized coefficients has no polarized channels") {
    const Folder folder;
    std::mt19937 random(9);
    Doubles field = random_light(random, 6, 1);
    for (std::size_t i = 0; i < field.size(); ++i)
        if (i % 4 != 0) field[i] = 0;
    write_light(folder.file("f.npz"), 6, field);
    convert(folder.file("f.npz"), folder.file("f.exr"), NICOL_FILE_OPTIONS_INIT);
    CHECK(report_of(folder.file("f.npz")).polarized == 0);
    CHECK(bytes_of(folder.file("f.exr")).find("S1.Y") == std::string::npos);
}

TEST_CASE("inspect: a picture gets another size") {
    const Folder folder;
    write_sky(folder.file("sky.exr"), 256, 129);
    for (const auto& [width, height] : {std::pair(64U, 33U), std::pair(100U, 200U), std::pair(512U, 257U)}) {
        CAPTURE(width);
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        options.width = width;
        options.height = height;
        convert(folder.file("sky.exr"), folder.file("out.exr"), options);
        const nicol::StokesImage picture = nicol::read_exr(folder.file("out.exr"));
        const std::vector<float> wanted = sky_picture(width, height, 1);
        REQUIRE(picture.data.size() == wanted.size());
        // At the poles the frames of a row turn with the columns: means over large pixels lose there.
        for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(std::abs(picture.data[i] - wanted[i]) < 6e-3F);
    }
}

TEST_CASE("inspect: light is turned and scaled") {
    const Folder folder;
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

    convert(folder.file("f.npz"), folder.file("turned.npz"), options);
    CHECK(difference(coefficients_of(folder.file("turned.npz"), 5, 2), wanted) < 1e-12 * scale);

    convert(folder.file("f.npz"), folder.file("turned.exr"), options);
    convert(folder.file("turned.exr"), folder.file("back.npz"), of_order(5, NICOL_FILE_BAND_LIMITED));
    CHECK(difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) < 1e-6 * scale);

    convert(folder.file("f.npz"), folder.file("f.exr"), NICOL_FILE_OPTIONS_INIT);
    convert(folder.file("f.exr"), folder.file("turned.exr"), options);  // by look-ups in the picture
    convert(folder.file("turned.exr"), folder.file("back.npz"), of_order(5, NICOL_FILE_BAND_LIMITED));
    CHECK(difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) < 5e-4 * scale);

    options.order = 5;
    options.flags = NICOL_FILE_BAND_LIMITED;
    convert(folder.file("f.exr"), folder.file("back.npz"), options);
    CHECK(difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) < 1e-6 * scale);
}

TEST_CASE("inspect: cube maps hold the same light") {
    const Folder folder;
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
    const Folder folder;
    const Doubles wanted = coefficients_of(vector, 4, 3);
    CHECK(std::abs(wanted[position(2, 0, 1)] - 0.18872) < 1e-5);
    convert(cube, folder.file("direct.npz"), of_order(4));
    convert(cube, folder.file("sponza.exr"), NICOL_FILE_OPTIONS_INIT);
    convert(folder.file("sponza.exr"), folder.file("picture.npz"), of_order(4));
    for (const char* name : {"direct.npz", "picture.npz"})
        CHECK(difference(coefficients_of(folder.file(name), 4, 3), wanted) < 5e-3);
}

TEST_CASE("inspect: a given order cuts coefficients and smooths pictures") {
    const Folder folder;
    std::mt19937 random(7);
    const Doubles field = random_light(random, 6, 1);
    write_light(folder.file("f.npz"), 6, field);
    convert(folder.file("f.npz"), folder.file("cut.npz"), of_order(3));
    Doubles wanted(field.begin(), field.begin() + static_cast<std::ptrdiff_t>(vector_size(3)));
    CHECK(difference(coefficients_of(folder.file("cut.npz"), 3, 1), wanted) == 0);
    CHECK(report_of(folder.file("cut.npz")).order == 3);
    const nicol_file_options zero = of_order(-1);
    convert(folder.file("f.npz"), folder.file("cut.npz"), zero);
    CHECK(report_of(folder.file("cut.npz")).order == 0);

    convert(folder.file("f.npz"), folder.file("f.exr"), NICOL_FILE_OPTIONS_INIT);
    convert(folder.file("f.exr"), folder.file("smooth.exr"), of_order(3, NICOL_FILE_BAND_LIMITED));
    wanted.resize(vector_size(6));
    convert(folder.file("smooth.exr"), folder.file("back.npz"), of_order(6, NICOL_FILE_BAND_LIMITED));
    CHECK(difference(coefficients_of(folder.file("back.npz"), 6, 1), wanted) < 1e-6 * largest_of(wanted));
}

TEST_CASE("inspect: what a light holds, in closed form") {
    const Folder folder;
    SUBCASE("the same from everywhere") {
        Doubles field(2 * vector_size(3));
        field[0] = std::sqrt(4 * pi);
        field[vector_size(3)] = 3 * std::sqrt(4 * pi);
        write_light(folder.file("f.npz"), 3, field);
        Doubles energy(2 * 4 * 4, -1);
        nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
        OK(nicol_file_describe_light(folder.file("f.npz").c_str(), nullptr, &r, energy.data(),
                                     energy.size()));
        CHECK(r.kind == NICOL_FILE_LIGHT_PSH);
        CHECK(r.channels == 2);
        CHECK(r.order == 3);
        CHECK((r.width == 512 && r.height == 257));
        CHECK((r.polarized == 0 && r.circular == 0));
        for (std::size_t c = 0; c < 2; ++c) {
            const double radiance = c == 0 ? 1 : 3;
            for (const double value : {r.mean[c], r.smallest[c], r.largest[c]})
                CHECK(value == doctest::Approx(radiance).epsilon(1e-6));
            CHECK(std::abs(r.direction[3 * c]) + std::abs(r.direction[3 * c + 1]) +
                      std::abs(r.direction[3 * c + 2]) <
                  1e-5);
            CHECK((r.unphysical[c] == 0 && r.largest_excess[c] == 0 && r.mean_dolp[c] == 0));
            for (std::size_t i = 0; i < 16; ++i)
                CHECK(energy[16 * c + i] ==
                      doctest::Approx(i == 0 ? 4 * pi * radiance * radiance : 0).epsilon(1e-12));
        }
    }
    SUBCASE("more from one side") {
        // 1 + d: the mean of d (1 + d) over the sphere is 1/3. Light from d propagates along -d.
        for (int m = -1; m <= 1; ++m) {
            Doubles field(vector_size(1));
            field[0] = std::sqrt(4 * pi);
            field[position(1, m, 0)] = std::sqrt(4 * pi / 3);
            const std::size_t axis = m == -1 ? 1 : m == 0 ? 2 : 0;
            Vec3 along{};
            along[axis] = -1;
            const double sign = value(1, field.data(), along)[0] > 1 ? 1 : -1;
            write_light(folder.file("f.npz"), 1, field);
            const nicol_light_report r = report_of(folder.file("f.npz"));
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(r.direction[i] == doctest::Approx(i == axis ? sign / 3 : 0).epsilon(1e-3));
        }
    }
    SUBCASE("a clear sky") {
        write_sky(folder.file("sky.exr"), 256, 129);
        const nicol_light_report r = report_of(folder.file("sky.exr"));
        CHECK(r.kind == NICOL_FILE_LIGHT_PICTURE);
        CHECK((r.width == 256 && r.height == 129 && r.channels == 1 && r.order == 32));
        CHECK((r.polarized == 1 && r.circular == 0));
        CHECK(r.largest_dolp[0] == doctest::Approx(dop_max).epsilon(1e-3));
        // The means of 3/4 (1 + c^2) and of 3/4 dop_max (1 - c^2) are 1 and dop_max / 2.
        CHECK(r.mean[0] == doctest::Approx(1).epsilon(1e-3));
        CHECK(r.mean_dolp[0] == doctest::Approx(dop_max / 2).epsilon(1e-3));
        CHECK((r.smallest[0] >= 0.75F && r.largest[0] <= 1.5F));
        CHECK(r.unphysical[0] == 0);
    }
    SUBCASE("circular light") {
        Doubles field(vector_size(0));
        field[0] = 4;
        field[3] = -1;
        write_light(folder.file("f.npz"), 0, field);
        const nicol_light_report r = report_of(folder.file("f.npz"));
        CHECK((r.polarized == 1 && r.circular == 1));
        CHECK(r.largest_dolp[0] == 0);
        CHECK(r.largest_circular[0] == doctest::Approx(0.25));
    }
}

TEST_CASE("inspect: scale and rotation change a report as they would an output") {
    const Folder folder;
    write_sky(folder.file("sky.exr"), 128, 65);
    nicol_file_options options = of_order(4);
    options.scale = 2;
    set_rotation(options, {1, 0, 0, 0, 0, 1, 0, -1, 0});
    convert(folder.file("sky.exr"), folder.file("out.npz"), options);
    Doubles wanted(20), energy(20);
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    OK(nicol_file_describe_light(folder.file("out.npz").c_str(), nullptr, &r, wanted.data(), 20));
    OK(nicol_file_describe_light(folder.file("sky.exr").c_str(), &options, &r, energy.data(), 20));
    CHECK(difference(energy, wanted) < 1e-9);
    CHECK(r.mean[0] == doctest::Approx(2).epsilon(2e-3));
}

TEST_CASE("inspect: truncated light is told, and made physical") {
    const Folder folder;
    nicol::StokesImage lamp(64, 33, 1);
    for (int x = 0; x < 64; ++x) {
        const auto s = lamp.at(0, 8, x);
        s[0] = 5;
        s[1] = -4;
    }
    nicol::write_exr(folder.file("lamp.exr"), lamp);
    CHECK(report_of(folder.file("lamp.exr")).unphysical[0] == 0);
    convert(folder.file("lamp.exr"), folder.file("lamp.npz"), of_order(6));
    const nicol_light_report r = report_of(folder.file("lamp.npz"));
    CHECK(r.unphysical[0] > 0.1);
    CHECK(r.largest_excess[0] > 0.05);
    CHECK(r.smallest[0] < 0);

    convert(folder.file("lamp.npz"), folder.file("ringing.exr"), NICOL_FILE_OPTIONS_INIT);
    Doubles f(vector_size(6));
    FAILS(nicol_psh_project_file(folder.file("ringing.exr").c_str(), 6, nullptr, f.data(), f.size()),
          NICOL_ERROR_INVALID_FILE, "ringing.exr");
    CHECK(report_of(folder.file("ringing.exr")).unphysical[0] == doctest::Approx(r.unphysical[0]));

    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.flags = NICOL_FILE_PHYSICAL;
    for (const char* name : {"good.exr", "good_s0.exr"}) {
        convert(folder.file("lamp.npz"), folder.file(name), options);
        const nicol_light_report good = report_of(folder.file(name));
        CHECK(good.unphysical[0] == 0);
        CHECK(good.smallest[0] >= 0);
        OK(nicol_psh_project_file(folder.file(name).c_str(), 6, nullptr, f.data(), f.size()));
    }
}

TEST_CASE("inspect: wavelengths of spectral pictures") {
    const Folder folder;
    nicol::StokesImage picture(8, 4, 4);
    picture.wavelengths = {450, 500, 550, 600};
    for (int c = 0; c < 4; ++c)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 8; ++x) picture.at(c, y, x)[0] = static_cast<float>(c + 1);
    nicol::write_exr(folder.file("s.exr"), picture);
    nicol_light_report r = report_of(folder.file("s.exr"));
    CHECK(r.channels == 4);
    CHECK(r.wavelengths[3] == 600);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.wavelengths = spectrum({598, 460});
    r = report_of(folder.file("s.exr"), &options);
    CHECK(r.channels == 2);
    CHECK((r.wavelengths[0] == 600 && r.wavelengths[1] == 450));
    CHECK((r.mean[0] == doctest::Approx(4) && r.mean[1] == doctest::Approx(1)));
    convert(folder.file("s.exr"), folder.file("copy.exr"), NICOL_FILE_OPTIONS_INIT);
    CHECK(report_of(folder.file("copy.exr")).wavelengths[2] == 550);
    write_sky(folder.file("sky.exr"), 16, 9);
    for (const char* name : {"sky.exr", "none_s0.exr"}) {
        const nicol_result result =
            nicol_file_convert(folder.file(name).c_str(), &options, folder.file("o.npz").c_str());
        CHECK(result == NICOL_ERROR_INVALID_ARGUMENT);
    }
}

TEST_CASE("inspect: options that are wrong, or of no use") {
    const Folder folder;
    write_sky(folder.file("sky.exr"), 16, 9);
    write_light(folder.file("f.npz"), 1, Doubles(vector_size(1)));
    const std::string npz = folder.file("o.npz"), exr = folder.file("o.exr"), cube = folder.file("o_s0.exr");
    const auto refuse = [&](const char* in, const std::string& out, const char* word, auto set) {
        CAPTURE(word);
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        set(options);
        FAILS(nicol_file_convert(folder.file(in).c_str(), &options, out.c_str()),
              NICOL_ERROR_INVALID_ARGUMENT, word);
    };
    using O = nicol_file_options;
    for (const std::int32_t order : {-2, NICOL_PSH_MAX_ORDER + 1, INT32_MIN, INT32_MAX})
        refuse("sky.exr", npz, "order", [=](O& o) { o.order = order; });
    refuse("sky.exr", exr, "height", [](O& o) { o.width = 16; });
    refuse("sky.exr", exr, "width", [](O& o) { o.height = 16; });
    refuse("sky.exr", exr, "height", [](O& o) { o.width = 16, o.height = 1; });
    refuse("sky.exr", exr, "width", [](O& o) { o.width = NICOL_MAX_SIZE + 1, o.height = 9; });
    refuse("sky.exr", cube, "edge", [](O& o) { o.edge = 1; });
    refuse("sky.exr", cube, "edge", [](O& o) { o.edge = 4097; });
    refuse("sky.exr", npz, "flags", [](O& o) { o.flags = 4; });
    for (const double scale : {-1.0, not_a_number, infinity, 1e13})
        refuse("sky.exr", npz, "scale", [=](O& o) { o.scale = scale; });
    refuse("sky.exr", npz, "rotation", [](O& o) { o.rotation[0] = not_a_number; });
    refuse("sky.exr", npz, "rotation", [](O& o) { o.rotation[0] = o.rotation[4] = 1, o.rotation[8] = -1; });
    refuse("sky.exr", npz, "wavelengths", [](O& o) { o.wavelengths.count = 17; });
    for (const float nm : {0.0F, 99.0F, 5001.0F, std::nanf("")})
        refuse("sky.exr", npz, "wavelength",
               [=](O& o) { o.wavelengths.count = 1, o.wavelengths.values[0] = nm; });
    refuse("sky.exr", npz, "reserved", [](O& o) { o.reserved = 1; });
    refuse("sky.exr", npz, "struct_size", [](O& o) { o.struct_size = 0; });
    // Of no use:
    refuse("sky.exr", npz, "width", [](O& o) { o.width = 16, o.height = 9; });
    refuse("sky.exr", npz, "edge", [](O& o) { o.edge = 16; });
    refuse("sky.exr", exr, "edge", [](O& o) { o.edge = 16; });
    refuse("sky.exr", cube, "width", [](O& o) { o.width = 16, o.height = 9; });
    refuse("sky.exr", npz, "PHYSICAL", [](O& o) { o.flags = NICOL_FILE_PHYSICAL; });
    refuse("f.npz", exr, "BAND_LIMITED", [](O& o) { o.flags = NICOL_FILE_BAND_LIMITED; });
    refuse("sky.exr", npz, "order 5",
           [](O& o) { o.order = 5, o.flags = NICOL_FILE_BAND_LIMITED; });  // 9 rows hold order 4
    refuse("f.npz", folder.file("o.png"), "o.png", [](O&) {});
    refuse("f.npz", "", "out", [](O&) {});
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.width = options.height = 20;
    FAILS(nicol_file_describe_light(folder.file("sky.exr").c_str(), &options, &report, nullptr, 0),
          NICOL_ERROR_INVALID_ARGUMENT, "width");
    CHECK(folder.names() == std::set<std::string>{"sky.exr", "f.npz"});
}

TEST_CASE("inspect: arguments and outputs of a report") {
    const Folder folder;
    write_light(folder.file("f.npz"), 2, Doubles(3 * vector_size(2)));
    const std::string file = folder.file("f.npz");
    const char* path = file.c_str();
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    FAILS(nicol_file_describe_light(nullptr, nullptr, &r, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT, "path");
    FAILS(nicol_file_describe_light(path, nullptr, nullptr, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT,
          "report");
    FAILS(nicol_file_identify(path, nullptr), NICOL_ERROR_INVALID_ARGUMENT, "kind");
    FAILS(nicol_file_describe_light(path, nullptr, &r, nullptr, 36), NICOL_ERROR_INVALID_ARGUMENT, "energy");
    Untouched few(35);
    FAILS(nicol_file_describe_light(path, nullptr, &r, few.data(), few.size()), NICOL_ERROR_INVALID_ARGUMENT,
          "36");
    Doubles many(40, -7.5);
    OK(nicol_file_describe_light(path, nullptr, &r, many.data(), many.size()));
    CHECK(many[35] == 0);
    CHECK(many[36] == -7.5);
    nicol_light_report older = NICOL_LIGHT_REPORT_INIT;
    older.struct_size = 12;
    older.order = 99;
    OK(nicol_file_describe_light(path, nullptr, &older, nullptr, 0));
    CHECK((older.channels == 3 && older.order == 99));
    older.struct_size = 0;
    FAILS(nicol_file_describe_light(path, nullptr, &older, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT,
          "struct_size");
    nicol_material_report m = NICOL_MATERIAL_REPORT_INIT;
    FAILS(nicol_file_describe_material(path, nullptr, &m, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT, "light");
}

TEST_CASE("inspect: files that are no light") {
    const Folder folder;
    nicol_file_kind kind = 77;
    const auto identify = [&](const std::string& name) {
        return nicol_file_identify(folder.file(name).c_str(), &kind);
    };
    FAILS(identify("none.exr"), NICOL_ERROR_FILE_NOT_FOUND, "none.exr");
    FAILS(identify("none"), NICOL_ERROR_FILE_NOT_FOUND, "none");
    FAILS(nicol_file_identify("", &kind), NICOL_ERROR_INVALID_ARGUMENT, "path");
    std::filesystem::create_directory(folder.file("folder.exr"));
    FAILS(identify("folder.exr"), NICOL_ERROR_UNSUPPORTED, "folder.exr");
    folder.write("text.xml", "<scene/>");
    FAILS(identify("text.xml"), NICOL_ERROR_UNSUPPORTED, ".exr");
    CHECK(kind == 77);

    write_light(folder.file("f.npz"), 3, Doubles(vector_size(3), 0.25));
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    for (const char* name : {"bad.exr", "bad_s0.exr", "bad.npz"}) {
        const std::string whole = bytes_of(folder.file("f.npz"));
        for (const std::string& content : {std::string(), std::string("v/1\x01"), std::string(4096, '\0'),
                                           whole.substr(0, 200), whole.substr(0, whole.size() - 30)}) {
            folder.write(name, content);
            const std::string path = folder.file(name);
            CHECK(nicol_file_describe_light(path.c_str(), nullptr, &r, nullptr, 0) != NICOL_OK);
            CHECK(std::string(nicol_last_error()).find("bad") != std::string::npos);
            CHECK(nicol_file_convert(path.c_str(), nullptr, folder.file("o.exr").c_str()) != NICOL_OK);
        }
    }
    CHECK(r.channels == 0);
    // One pixel is a picture, but no light.
    nicol::write_exr(folder.file("one.exr"), nicol::StokesImage(1, 1, 1));
    FAILS(nicol_file_describe_light(folder.file("one.exr").c_str(), nullptr, &r, nullptr, 0),
          NICOL_ERROR_INVALID_FILE, "2 x 2");
    CHECK(folder.names().count("o.exr") == 0);
}

TEST_CASE("inspect: a failed output leaves what was there") {
    const Folder folder;
    Doubles field(vector_size(1));
    field[0] = 1;
    write_light(folder.file("f.npz"), 1, field);
    const std::string file = folder.file("f.npz");
    for (const char* out : {"none/o.exr", "none/o.npz", "none/o_s0.exr"})
        FAILS(nicol_file_convert(file.c_str(), nullptr, folder.file(out).c_str()), NICOL_ERROR_WRITE_FAILED,
              "none/o");
    // The input may be the output.
    convert(file, file, of_order(3));
    CHECK(report_of(file).order == 3);
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}
