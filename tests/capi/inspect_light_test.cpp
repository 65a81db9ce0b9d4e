// SPDX-License-Identifier: MIT
// Tests of light files: conversion between formats, reports and errors.
#include "harmonics/rotation.hpp"
#include "inspect.hpp"
#include "inspect/light_file.hpp"

using namespace capi_test;
using nicol::PshVector;

namespace {

/// Returns random, physically realizable light: s0 stays well above the polarized part.
PshVector random_light(int order, int channels) {
    PshVector field = random_fields(static_cast<std::uint32_t>(order), channels);
    for (int c = 0; c < channels; ++c) field.at(c, 0, 0, 0) = 5 * (order + 1);
    return field;
}

nicol_file_options of_size(std::uint32_t width, std::uint32_t height) {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.width = width;
    options.height = height;
    return options;
}

nicol::EnvironmentPtr sky() {
    return nicol::rayleigh_sky({.sun_direction = {-0.5, -0.7, 0.2}, .radiance = {1}});
}

}  // namespace

TEST_CASE("inspect: written coefficients are read as they were") {
    const TemporaryFolder folder;
    const PshVector field = random_fields(7, 2);
    write_light(folder.file("f.npz"), field);
    CHECK(largest_difference(coefficients_of(folder.file("f.npz"), 7, 2), field) == 0);
    const Doubles f(vector_size(3));
    const auto write = [&](const char* name, std::uint64_t vectors) {
        return nicol_psh_write_file(*name == '\0' ? "" : folder.file(name).c_str(), 3, vectors, f.data(),
                                    f.size());
    };
    check_refused({{"path", [&] { return write("", 1); }},
                   {"vectors", [&] { return write("no.npz", 0); }},
                   {"vectors", [&] { return write("no.npz", 17); }},
                   {"vectors", [&] { return write("no.npz", UINT64_MAX); }},
                   {"none/f.npz", [&] { return write("none/f.npz", 1); }, NICOL_ERROR_WRITE_FAILED}});
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}

TEST_CASE("inspect: light without high orders survives images in both directions") {
    const TemporaryFolder folder;
    for (const int order : {2, 9, 40}) {
        CAPTURE(order);
        const PshVector field = random_light(order, 3);
        const auto apart = [&](const char* file) {
            return largest_difference(coefficients_of(folder.file(file), order, 3), field);
        };
        write_light(folder.file("a.npz"), field);
        convert(folder.file("a.npz"), folder.file("a.exr"));
        convert(folder.file("a.exr"), folder.file("b.npz"), of_order(order, NICOL_FILE_BAND_LIMITED));
        CHECK(apart("b.npz") < 1e-6 * largest(field));
        // Images convert to images through coefficients.
        convert(folder.file("b.npz"), folder.file("b.exr"));
        const std::vector<float> a = nicol::read_exr(folder.file("a.exr")).data;
        CHECK(largest_difference(a, nicol::read_exr(folder.file("b.exr")).data) < 2e-6 * largest(a));
        if (order != 9) continue;
        // Interpreting the image as a bilinear function smooths it a little.
        convert(folder.file("a.exr"), folder.file("c.npz"), of_order(9));
        CHECK(apart("c.npz") > 1e-5);
        CHECK(apart("c.npz") < 1e-3 * largest(field));
    }
}

TEST_CASE("inspect: an image of any size shows the same field") {
    const TemporaryFolder folder;
    const PshVector field = sky()->project(2);
    write_light(folder.file("sky.npz"), field);
    convert(folder.file("sky.npz"), folder.file("large.exr"), of_size(256, 129));
    for (const auto& [width, height] : {std::pair(30, 17), {64, 33}, {100, 200}, {512, 257}}) {
        CAPTURES(width, height);
        const nicol_file_options options =
            of_size(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
        convert(folder.file("sky.npz"), folder.file("a.exr"), options);
        const nicol::StokesImage image = nicol::read_exr(folder.file("a.exr"));
        CHECK((image.width == width && image.height == height));
        convert(folder.file("a.exr"), folder.file("a.npz"), of_order(2, NICOL_FILE_BAND_LIMITED));
        CHECK(largest_difference(coefficients_of(folder.file("a.npz"), 2, 1), field) < 1e-6);
        if (width == 30) continue;
        // Near the poles the frames of a row rotate with the columns, so means over large pixels lose
        // accuracy.
        convert(folder.file("large.exr"), folder.file("b.exr"), options);
        CHECK(largest_difference(nicol::read_exr(folder.file("b.exr")).data, image.data) < 6e-3);
    }
}

TEST_CASE("inspect: light is rotated and scaled") {
    const TemporaryFolder folder;
    const PshVector field = random_light(5, 2);
    PshVector wanted = nicol::rotated(field, some_rotation());
    for (double& v : wanted.data()) v *= 2.5;
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    std::ranges::copy(rows_of(some_rotation()), options.rotation);
    options.scale = 2.5;
    const nicol_file_options plain = of_order(5, NICOL_FILE_BAND_LIMITED);
    nicol_file_options exact = options;
    exact.order = 5;
    exact.flags = NICOL_FILE_BAND_LIMITED;
    write_light(folder.file("f.npz"), field);
    convert(folder.file("f.npz"), folder.file("f.exr"));
    // Each case converts into a first output and back to coefficients. The tolerance is relative to the
    // largest one.
    const struct {
        const char *in, *out;
        nicol_file_options first, back;
        double tolerance;
    } cases[] = {{"f.npz", "a.npz", options, of_order(5), 1e-12},
                 {"f.npz", "a.exr", options, plain, 1e-6},
                 {"f.exr", "a.exr", options, plain, 5e-4},  // looked up in the image
                 {"f.exr", "f.exr", NICOL_FILE_OPTIONS_INIT, exact, 1e-6}};
    for (const auto& [in, out, first, back, tolerance] : cases) {
        CAPTURES(in, out);
        convert(folder.file(in), folder.file(out), first);
        convert(folder.file(out), folder.file("back.npz"), back);
        CHECK(largest_difference(coefficients_of(folder.file("back.npz"), 5, 2), wanted) <
              tolerance * largest(wanted));
    }
}

TEST_CASE("inspect: a given order cuts coefficients and smooths images") {
    const TemporaryFolder folder;
    const PshVector field = random_light(6, 1), cut = nicol::with_order(field, 3);
    write_light(folder.file("f.npz"), field);
    convert(folder.file("f.npz"), folder.file("cut.npz"), of_order(3));
    CHECK(largest_difference(coefficients_of(folder.file("cut.npz"), 3, 1), cut) == 0);
    CHECK(light_report_of(folder.file("cut.npz")).order == 3);
    convert(folder.file("f.npz"), folder.file("cut.npz"), of_order(0));
    CHECK(light_report_of(folder.file("cut.npz")).order == 0);

    convert(folder.file("f.npz"), folder.file("f.exr"));
    convert(folder.file("f.exr"), folder.file("smooth.exr"), of_order(3, NICOL_FILE_BAND_LIMITED));
    convert(folder.file("smooth.exr"), folder.file("back.npz"), of_order(6, NICOL_FILE_BAND_LIMITED));
    CHECK(largest_difference(coefficients_of(folder.file("back.npz"), 6, 1), nicol::with_order(cut, 6)) <
          1e-6 * largest(cut));
}

TEST_CASE("inspect: wavelengths of spectral images") {
    const TemporaryFolder folder;
    nicol::StokesImage image(8, 4, 4);
    image.wavelengths = {450, 500, 550, 600};
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = static_cast<float>(1 + i / 128);
    nicol::write_exr(folder.file("s.exr"), image);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.wavelengths = spectrum({598, 460});
    const nicol_light_report r = light_report_of(folder.file("s.exr"), &options);
    CHECK(r.channels == 2);
    CHECK((r.wavelengths[0] == 600 && r.wavelengths[1] == 450));
    CHECK((r.mean[0] == doctest::Approx(4) && r.mean[1] == doctest::Approx(1)));
    convert(folder.file("s.exr"), folder.file("copy.exr"));
    CHECK(light_report_of(folder.file("copy.exr")).wavelengths[2] == 550);
    nicol::write_exr(folder.file("plain.exr"), nicol::StokesImage(8, 4, 3));
    for (const char* name : {"plain.exr", "none_s0.exr"})
        REFUSES(nicol_file_convert(folder.file(name).c_str(), &options, folder.file("o.npz").c_str()), "");
}

TEST_CASE("inspect: a report of light is the library's, with room for every energy") {
    const TemporaryFolder folder;
    const std::string path = folder.file("f.npz");
    PshVector field = random_light(3, 2);
    field.at(1, 0, 0, 0) = 1;  // beyond the physically realizable range
    write_light(path, field);
    const nicol::LightReport wanted =
        describe(nicol::read_light_file(path, nicol::FileKind::light_psh, {}), {}, true);
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    Doubles energy(2 * 4 * 4 + 1, -7.5);
    OK(nicol_file_describe_light(path.c_str(), nullptr, &r, energy.data(), energy.size()));
    CHECK((r.kind == NICOL_FILE_LIGHT_PSH && r.channels == 2 && r.order == 3));
    CHECK((r.width == 512 && r.height == 257 && r.polarized == 1 && r.circular == 1));
    for (std::size_t c = 0; c < 2; ++c) {
        const nicol::LightChannelReport& channel = wanted.channels[c];
        CHECK((r.mean[c] == channel.mean && r.smallest[c] == channel.smallest));
        CHECK((r.largest[c] == channel.largest && r.mean_dolp[c] == channel.mean_dolp));
        CHECK((r.largest_dolp[c] == channel.largest_dolp && r.largest_circular[c] == channel.circular));
        CHECK((r.unphysical[c] == channel.unphysical && r.largest_excess[c] == channel.largest_excess));
        CHECK(std::equal(r.direction + 3 * c, r.direction + 3 * c + 3, &channel.direction.x));
        for (std::size_t i = 0; i < 16; ++i)
            CHECK(energy[16 * c + i] == channel.energy[i / 4][static_cast<int>(i % 4)]);
    }
    CHECK((r.unphysical[0] == 0 && r.unphysical[1] > 0));
    CHECK(energy[32] == -7.5);
    REFUSES(nicol_file_describe_light(path.c_str(), nullptr, &r, nullptr, 36), "energy");
    Untouched few(31);
    REFUSES(nicol_file_describe_light(path.c_str(), nullptr, &r, few.data(), few.size()), "32");
    nicol_material_report m = NICOL_MATERIAL_REPORT_INIT;
    REFUSES(nicol_file_describe_material(path.c_str(), nullptr, &m, nullptr, 0), "light");
}

TEST_CASE("inspect: the mean direction of light is where it comes from") {
    const TemporaryFolder folder;
    for (const glm::dvec3& from : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, -1}}) {
        // The field is 1 + d, and the mean of d (1 + d) over the sphere is 1/3. Light from d propagates along
        // -d.
        PshVector field(1, 1);
        field.at(0, 0, 0, 0) = std::sqrt(4 * pi);
        const double scale = -std::sqrt(4 * pi / 3);
        field.at(0, 1, -1, 0) = -scale * from.y;
        field.at(0, 1, 0, 0) = scale * from.z;
        field.at(0, 1, 1, 0) = -scale * from.x;
        write_light(folder.file("f.npz"), field);
        const nicol_light_report r = light_report_of(folder.file("f.npz"));
        for (int i = 0; i < 3; ++i) CHECK(r.direction[i] == doctest::Approx(from[i] / 3).epsilon(1e-3));
    }
}

TEST_CASE("inspect: scale and rotation change a report as they would an output") {
    const TemporaryFolder folder;
    write_light(folder.file("sky.npz"), sky()->project(2));
    convert(folder.file("sky.npz"), folder.file("sky.exr"), of_size(128, 65));
    nicol_file_options options = of_order(4);
    options.scale = 2;
    std::ranges::copy(Rotation{1, 0, 0, 0, 0, 1, 0, -1, 0}, options.rotation);
    convert(folder.file("sky.exr"), folder.file("out.npz"), options);
    Doubles wanted(20), energy(20);
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    OK(nicol_file_describe_light(folder.file("out.npz").c_str(), nullptr, &r, wanted.data(), 20));
    OK(nicol_file_describe_light(folder.file("sky.exr").c_str(), &options, &r, energy.data(), 20));
    CHECK(largest_difference(energy, wanted) < 1e-9);
    CHECK(r.mean[0] == doctest::Approx(2).epsilon(2e-3));
}

TEST_CASE("inspect: truncated light is told, and made physical") {
    const TemporaryFolder folder;
    nicol::StokesImage lamp(64, 33, 1);
    for (int x = 0; x < 64; ++x) {
        lamp.at(0, 8, x)[0] = 5;
        lamp.at(0, 8, x)[1] = -4;
    }
    nicol::write_exr(folder.file("lamp.exr"), lamp);
    CHECK(light_report_of(folder.file("lamp.exr")).unphysical[0] == 0);
    convert(folder.file("lamp.exr"), folder.file("lamp.npz"), of_order(6));
    const nicol_light_report r = light_report_of(folder.file("lamp.npz"));
    CHECK((r.unphysical[0] > 0.1 && r.largest_excess[0] > 0.05 && r.smallest[0] < 0));

    convert(folder.file("lamp.npz"), folder.file("ringing.exr"));
    Doubles f(vector_size(6));
    const auto project = [&](const char* name) {
        return nicol_psh_project_file(folder.file(name).c_str(), 6, nullptr, f.data(), f.size());
    };
    FAILS(project("ringing.exr"), NICOL_ERROR_INVALID_FILE, "ringing.exr");
    CHECK(light_report_of(folder.file("ringing.exr")).unphysical[0] == doctest::Approx(r.unphysical[0]));
    for (const char* name : {"good.exr", "good_s0.exr"}) {
        convert(folder.file("lamp.npz"), folder.file(name),
                of_order(NICOL_FILE_ORDER_AUTOMATIC, NICOL_FILE_PHYSICAL));
        const nicol_light_report good = light_report_of(folder.file(name));
        CHECK((good.unphysical[0] == 0 && good.smallest[0] >= 0));
        OK(project(name));
    }
}

TEST_CASE("inspect: an environment is written in every format") {
    const TemporaryFolder folder;
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const Owned sky(clear_sky(context, {0.5F, 0.7F, 0}));
    PshVector wanted(2, 3);
    OK(nicol_psh_project_environment(sky, 2, wanted.data().data(), wanted.data().size()));
    const nicol_file_options exact = of_order(2, NICOL_FILE_BAND_LIMITED);
    for (const auto& [name, options, tolerance] :
         {std::tuple("a.npz", &exact, 1e-6), {"a.exr", nullptr, 5e-4}, {"a_s0.exr", nullptr, 5e-4}}) {
        OK(nicol_environment_write(sky, options, folder.file(name).c_str()));
        CHECK(largest_difference(coefficients_of(folder.file(name), 2, 3), wanted) < tolerance);
    }
    nicol_file_options wavelengths = NICOL_FILE_OPTIONS_INIT;
    wavelengths.wavelengths = spectrum({550});
    REFUSES(nicol_environment_write(sky, &wavelengths, folder.file("b.npz").c_str()), "wavelengths");
    REFUSES(nicol_environment_write(sky, nullptr, folder.file("b.png").c_str()), "b.png");
}

TEST_CASE("inspect: options that are wrong, or of no use") {
    const TemporaryFolder folder;
    write_light(folder.file("f.npz"), PshVector(1, 1));
    convert(folder.file("f.npz"), folder.file("sky.exr"), of_size(16, 9));
    using O = nicol_file_options;
    const O good = NICOL_FILE_OPTIONS_INIT;
    const auto to = [&](const char* in, const std::string& out) {
        return [&, in, out](const O& options) {
            return nicol_file_convert(folder.file(in).c_str(), &options, out.c_str());
        };
    };
    const auto npz = to("sky.exr", folder.file("o.npz")), exr = to("sky.exr", folder.file("o.exr")),
               cube = to("sky.exr", folder.file("o_s0.exr"));
    check_wrong(
        good, npz,
        {{"order", [](O& o) { o.order = NICOL_PSH_MAX_ORDER + 1; }},
         {"order", [](O& o) { o.order = UINT32_MAX - 1; }},
         {"flags", [](O& o) { o.flags = 4; }},
         {"scale", [](O& o) { o.scale = -1; }},
         {"scale", [](O& o) { o.scale = not_a_number; }},
         {"scale", [](O& o) { o.scale = 1e13; }},
         {"rotation", [](O& o) { o.rotation[0] = not_a_number; }},
         {"rotation", [](O& o) { o.rotation[0] = o.rotation[4] = 1, o.rotation[8] = -1; }},
         {"wavelengths", [](O& o) { o.wavelengths.count = 17; }},
         {"wavelength", [](O& o) { o.wavelengths = spectrum({99}); }},
         {"wavelength", [](O& o) { o.wavelengths = spectrum({5001}); }},
         {"wavelength", [](O& o) { o.wavelengths = spectrum({NAN}); }},
         {"reserved", [](O& o) { o.reserved = 1; }},
         // The order below exceeds the order that the rows of the file can hold.
         {"order 5", [](O& o) { o.order = 5, o.flags = NICOL_FILE_BAND_LIMITED; }}});  // 9 rows hold order 4
    check_wrong(good, exr,
                {{"height", [](O& o) { o.width = 16; }},
                 {"width", [](O& o) { o.height = 16; }},
                 {"height", [](O& o) { o.width = 16, o.height = 1; }},
                 {"width", [](O& o) { o.width = NICOL_MAX_SIZE + 1, o.height = 9; }}});
    check_wrong(good, cube, {{"edge", [](O& o) { o.edge = 1; }}, {"edge", [](O& o) { o.edge = 4097; }}});
    REFUSES(to("f.npz", folder.file("o.png"))(good), "o.png");
    REFUSES(to("f.npz", "")(good), "out");
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    const O sized = of_size(20, 20);
    REFUSES(nicol_file_describe_light(folder.file("sky.exr").c_str(), &sized, &report, nullptr, 0), "width");
    CHECK(folder.names() == std::set<std::string>{"sky.exr", "f.npz"});
}

TEST_CASE("inspect: files that are no light") {
    const TemporaryFolder folder;
    nicol_file_kind kind = 77;
    const auto identify = [&](const std::string& name) {
        return nicol_file_identify(folder.file(name).c_str(), &kind);
    };
    FAILS(identify("none.exr"), NICOL_ERROR_FILE_NOT_FOUND, "none.exr");
    FAILS(identify("none"), NICOL_ERROR_FILE_NOT_FOUND, "none");
    REFUSES(nicol_file_identify("", &kind), "path");
    std::filesystem::create_directory(folder.file("folder.exr"));
    FAILS(identify("folder.exr"), NICOL_ERROR_UNSUPPORTED, "folder.exr");
    folder.write("text.xml", "<scene/>");
    FAILS(identify("text.xml"), NICOL_ERROR_UNSUPPORTED, ".exr");
    CHECK(kind == 77);

    write_light(folder.file("f.npz"), PshVector(3, 1));
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    std::uint32_t channels = 7;
    const std::string whole = file_bytes(folder.file("f.npz"));
    for (const char* name : {"bad.exr", "bad_s0.exr", "bad.npz"}) {
        const std::string path = folder.write(name, whole.substr(0, 200));
        CHECK(nicol_file_describe_light(path.c_str(), nullptr, &r, nullptr, 0) != NICOL_OK);
        CHECK(std::string(nicol_last_error()).find("bad") != std::string::npos);
        CHECK(nicol_psh_project_file(path.c_str(), 5, &channels, nullptr, 0) != NICOL_OK);
    }
    CHECK(channels == 7);
    CHECK(r.channels == 0);
    // A single pixel is a valid image but not a valid light.
    nicol::write_exr(folder.file("one.exr"), nicol::StokesImage(1, 1, 1));
    FAILS(nicol_file_describe_light(folder.file("one.exr").c_str(), nullptr, &r, nullptr, 0),
          NICOL_ERROR_INVALID_FILE, "2 x 2");
    CHECK(folder.names().count("o.exr") == 0);
}

TEST_CASE("inspect: a failed output leaves what was there") {
    const TemporaryFolder folder;
    write_light(folder.file("f.npz"), random_light(1, 1));
    const std::string file = folder.file("f.npz");
    for (const char* out : {"none/o.exr", "none/o.npz", "none/o_s0.exr"})
        FAILS(nicol_file_convert(file.c_str(), nullptr, folder.file(out).c_str()), NICOL_ERROR_WRITE_FAILED,
              "none/o");
    // The input file may also be the output file.
    convert(file, file, of_order(3));
    CHECK(light_report_of(file).order == 3);
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}
