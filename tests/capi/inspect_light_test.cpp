// SPDX-License-Identifier: MIT
// Files of light: from one format to another, what they hold, and what is wrong.
#include "inspect.hpp"
#include "psh_checks.hpp"

using namespace capi_test;

TEST_CASE("inspect: written coefficients are read as they were") {
    const TemporaryFolder folder;
    std::mt19937 random(3);
    const Doubles field = random_fields(random, 7, 2), f(vector_size(3));
    write_light(folder.file("f.npz"), 7, field);
    CHECK(difference(coefficients_of(folder.file("f.npz"), 7, 2), field) == 0);
    const auto write = [&](const std::string& path, std::uint64_t vectors) {
        return nicol_psh_write_file(path.c_str(), 3, vectors, f.data(), f.size());
    };
    REFUSES(write("", 1), "path");
    for (const std::uint64_t vectors : {std::uint64_t{0}, std::uint64_t{17}, huge})
        REFUSES(write(folder.file("no.npz"), vectors), "vectors");
    FAILS(write(folder.file("none/f.npz"), 1), NICOL_ERROR_WRITE_FAILED, "none/f.npz");
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}

TEST_CASE("inspect: light without high orders survives images in both directions") {
    const TemporaryFolder folder;
    std::mt19937 random(4);
    for (const std::uint32_t order : {2U, 9U, 40U}) {
        CAPTURE(order);
        const Doubles field = random_light(random, order, 3);
        write_light(folder.file("a.npz"), order, field);
        convert(folder.file("a.npz"), folder.file("a.exr"), NICOL_FILE_OPTIONS_INIT);
        const nicol_file_options exact = of_order(static_cast<std::int32_t>(order), NICOL_FILE_BAND_LIMITED);
        convert(folder.file("a.exr"), folder.file("b.npz"), exact);
        CHECK(difference(coefficients_of(folder.file("b.npz"), order, 3), field) < 1e-6 * largest_of(field));
        // And images through coefficients.
        convert(folder.file("b.npz"), folder.file("b.exr"), NICOL_FILE_OPTIONS_INIT);
        const std::vector<float> a = nicol::read_exr(folder.file("a.exr")).data;
        CHECK(largest_difference(a, nicol::read_exr(folder.file("b.exr")).data) < 2e-6F * largest_of(a));
        if (order != 9) continue;
        // As the bilinear function it is smoothed a little.
        convert(folder.file("a.exr"), folder.file("c.npz"), of_order(9));
        const double apart = difference(coefficients_of(folder.file("c.npz"), 9, 3), field);
        CHECK(apart > 1e-5);
        CHECK(apart < 1e-3 * largest_of(field));
    }
}

TEST_CASE("inspect: an image shows the field where nicol_image says it is, in any size") {
    const TemporaryFolder folder;
    write_sky(folder.file("large.exr"), 256, 129);
    write_sky(folder.file("sky.exr"), 128, 65);
    convert(folder.file("sky.exr"), folder.file("sky.npz"), of_order(2, NICOL_FILE_BAND_LIMITED));
    CHECK(difference_from_sky(2, coefficients_of(folder.file("sky.npz"), 2, 1).data()) < 1e-6);
    const struct {
        const char* file;
        std::uint32_t width, height;
        float tolerance;
    } cases[] = {
        {"sky.npz", 30, 17, 1e-6F},
        // At the poles the frames of a row rotate with the columns: means over large pixels lose there.
        {"large.exr", 64, 33, 6e-3F},
        {"large.exr", 100, 200, 6e-3F},
        {"large.exr", 512, 257, 6e-3F}};
    for (const auto& [file, width, height, tolerance] : cases) {
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        options.width = width;
        options.height = height;
        CAPTURE(options.width);
        convert(folder.file(file), folder.file("out.exr"), options);
        const nicol::StokesImage image = nicol::read_exr(folder.file("out.exr"));
        CHECK((image.width == static_cast<int>(width) && image.height == static_cast<int>(height)));
        CHECK(largest_difference(image.data, sky_image(width, height, 1)) < tolerance);
    }
}

TEST_CASE("inspect: light is rotated and scaled") {
    const TemporaryFolder folder;
    std::mt19937 random(5);
    const Rotation rotation = random_rotation(random);
    const Doubles field = random_light(random, 5, 2);
    Doubles wanted = field;
    OK(nicol_psh_rotate(5, 2, field.data(), field.size(), rotation.data(), wanted.data(), wanted.size()));
    for (double& v : wanted) v *= 2.5;
    const double scale = largest_of(wanted);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    set_rotation(options, rotation);
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
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = static_cast<float>(1 + i / 128);
    nicol::write_exr(folder.file("s.exr"), image);
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.wavelengths = spectrum({598, 460});
    const nicol_light_report r = light_report_of(folder.file("s.exr"), &options);
    CHECK(r.channels == 2);
    CHECK((r.wavelengths[0] == 600 && r.wavelengths[1] == 450));
    CHECK((r.mean[0] == doctest::Approx(4) && r.mean[1] == doctest::Approx(1)));
    convert(folder.file("s.exr"), folder.file("copy.exr"), NICOL_FILE_OPTIONS_INIT);
    CHECK(light_report_of(folder.file("copy.exr")).wavelengths[2] == 550);
    write_sky(folder.file("sky.exr"), 16, 9);
    for (const char* name : {"sky.exr", "none_s0.exr"})
        REFUSES(nicol_file_convert(folder.file(name).c_str(), &options, folder.file("o.npz").c_str()), "");
}

TEST_CASE("inspect: what a light holds, in closed form") {
    const TemporaryFolder folder;
    {
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
    {
        // More from one side: 1 + d: the mean of d (1 + d) over the sphere is 1/3. Light from d propagates
        // along -d.
        for (int m = -1; m <= 1; ++m) {
            Doubles field(vector_size(1));
            field[0] = std::sqrt(4 * pi);
            field[position(1, m, 0)] = std::sqrt(4 * pi / 3);
            const std::size_t axis = m == -1 ? 1 : m == 0 ? 2 : 0;
            Vec3 along{};
            along[axis] = -1;
            const double sign = value(1, field.data(), along)[0] > 1 ? 1 : -1;
            write_light(folder.file("f.npz"), 1, field);
            const nicol_light_report r = light_report_of(folder.file("f.npz"));
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(r.direction[i] == doctest::Approx(i == axis ? sign / 3 : 0).epsilon(1e-3));
        }
    }
}

TEST_CASE("inspect: scale and rotation change a report as they would an output") {
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
    nicol::StokesImage lamp(64, 33, 1);
    for (int x = 0; x < 64; ++x) {
        const auto s = lamp.at(0, 8, x);
        s[0] = 5;
        s[1] = -4;
    }
    nicol::write_exr(folder.file("lamp.exr"), lamp);
    CHECK(light_report_of(folder.file("lamp.exr")).unphysical[0] == 0);
    convert(folder.file("lamp.exr"), folder.file("lamp.npz"), of_order(6));
    const nicol_light_report r = light_report_of(folder.file("lamp.npz"));
    CHECK(r.unphysical[0] > 0.1);
    CHECK(r.largest_excess[0] > 0.05);
    CHECK(r.smallest[0] < 0);

    convert(folder.file("lamp.npz"), folder.file("ringing.exr"), NICOL_FILE_OPTIONS_INIT);
    Doubles f(vector_size(6));
    FAILS(nicol_psh_project_file(folder.file("ringing.exr").c_str(), 6, nullptr, f.data(), f.size()),
          NICOL_ERROR_INVALID_FILE, "ringing.exr");
    CHECK(light_report_of(folder.file("ringing.exr")).unphysical[0] == doctest::Approx(r.unphysical[0]));

    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.flags = NICOL_FILE_PHYSICAL;
    for (const char* name : {"good.exr", "good_s0.exr"}) {
        convert(folder.file("lamp.npz"), folder.file(name), options);
        const nicol_light_report good = light_report_of(folder.file(name));
        CHECK(good.unphysical[0] == 0);
        CHECK(good.smallest[0] >= 0);
        OK(nicol_psh_project_file(folder.file(name).c_str(), 6, nullptr, f.data(), f.size()));
    }
}

TEST_CASE("inspect: arguments and outputs of a report") {
    const TemporaryFolder folder;
    write_light(folder.file("f.npz"), 2, Doubles(3 * vector_size(2)));
    const std::string file = folder.file("f.npz");
    const char* path = file.c_str();
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    REFUSES(nicol_file_describe_light(path, nullptr, &r, nullptr, 36), "energy");
    Untouched few(35);
    REFUSES(nicol_file_describe_light(path, nullptr, &r, few.data(), few.size()), "36");
    Doubles many(40, -7.5);
    OK(nicol_file_describe_light(path, nullptr, &r, many.data(), many.size()));
    CHECK(many[35] == 0);
    CHECK(many[36] == -7.5);
    nicol_material_report m = NICOL_MATERIAL_REPORT_INIT;
    REFUSES(nicol_file_describe_material(path, nullptr, &m, nullptr, 0), "light");
}

TEST_CASE("inspect: an environment is written in every format") {
    const TemporaryFolder folder;
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    nicol_sky sky = NICOL_SKY_INIT;
    sky.sun_direction[0] = 0.5F;
    sky.sun_direction[1] = 0.7F;
    Owned<nicol_environment> environment;
    OK(nicol_environment_create_sky(context, &sky, &environment));
    Doubles wanted(3 * vector_size(2));
    OK(nicol_psh_project_environment(environment, 2, wanted.data(), wanted.size()));
    const nicol_file_options options = of_order(2, NICOL_FILE_BAND_LIMITED);
    OK(nicol_environment_write(environment, &options, folder.file("a.npz").c_str()));
    OK(nicol_environment_write(environment, nullptr, folder.file("a.exr").c_str()));
    OK(nicol_environment_write(environment, nullptr, folder.file("a_s0.exr").c_str()));
    CHECK(difference(coefficients_of(folder.file("a.npz"), 2, 3), wanted) < 1e-6);
    CHECK(difference(coefficients_of(folder.file("a.exr"), 2, 3), wanted) < 5e-4);
    CHECK(difference(coefficients_of(folder.file("a_s0.exr"), 2, 3), wanted) < 5e-4);

    nicol_file_options wavelengths = NICOL_FILE_OPTIONS_INIT;
    wavelengths.wavelengths = spectrum({550});
    REFUSES(nicol_environment_write(environment, &wavelengths, folder.file("b.npz").c_str()), "wavelengths");
    REFUSES(nicol_environment_write(environment, nullptr, folder.file("b.png").c_str()), "b.png");
}

TEST_CASE("inspect: options that are wrong, or of no use") {
    const TemporaryFolder folder;
    write_sky(folder.file("sky.exr"), 16, 9);
    write_light(folder.file("f.npz"), 1, Doubles(vector_size(1)));
    using O = nicol_file_options;
    const O good = NICOL_FILE_OPTIONS_INIT;
    const auto to = [&](const char* in, const std::string& out) {
        return [&, in, out](const O& options) {
            return nicol_file_convert(folder.file(in).c_str(), &options, out.c_str());
        };
    };
    const auto npz = to("sky.exr", folder.file("o.npz")), exr = to("sky.exr", folder.file("o.exr")),
               cube = to("sky.exr", folder.file("o_s0.exr")), back = to("f.npz", folder.file("o.exr"));
    check_wrong(
        good, npz,
        {{"order", [](O& o) { o.order = -2; }},
         {"order", [](O& o) { o.order = NICOL_PSH_MAX_ORDER + 1; }},
         {"order", [](O& o) { o.order = INT32_MIN; }},
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
         // Of no use:
         {"width", [](O& o) { o.width = 16, o.height = 9; }},
         {"edge", [](O& o) { o.edge = 16; }},
         {"PHYSICAL", [](O& o) { o.flags = NICOL_FILE_PHYSICAL; }},
         {"order 5", [](O& o) { o.order = 5, o.flags = NICOL_FILE_BAND_LIMITED; }}});  // 9 rows hold order 4
    check_wrong(good, exr,
                {{"height", [](O& o) { o.width = 16; }},
                 {"width", [](O& o) { o.height = 16; }},
                 {"height", [](O& o) { o.width = 16, o.height = 1; }},
                 {"width", [](O& o) { o.width = NICOL_MAX_SIZE + 1, o.height = 9; }},
                 {"edge", [](O& o) { o.edge = 16; }}});
    check_wrong(good, cube,
                {{"edge", [](O& o) { o.edge = 1; }},
                 {"edge", [](O& o) { o.edge = 4097; }},
                 {"width", [](O& o) { o.width = 16, o.height = 9; }}});
    check_wrong(good, back, {{"BAND_LIMITED", [](O& o) { o.flags = NICOL_FILE_BAND_LIMITED; }}});
    REFUSES(to("f.npz", folder.file("o.png"))(good), "o.png");
    REFUSES(to("f.npz", "")(good), "out");
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    nicol_file_options sized = good;
    sized.width = sized.height = 20;
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

    write_light(folder.file("f.npz"), 3, Doubles(vector_size(3), 0.25));
    nicol_light_report r = NICOL_LIGHT_REPORT_INIT;
    std::uint32_t channels = 7;
    const std::string whole = file_bytes(folder.file("f.npz"));
    for (const char* name : {"bad.exr", "bad_s0.exr", "bad.npz"})
        for (const std::string& content : {std::string(), std::string(4096, '\0'), whole.substr(0, 200)}) {
            const std::string path = folder.write(name, content);
            CHECK(nicol_file_describe_light(path.c_str(), nullptr, &r, nullptr, 0) != NICOL_OK);
            CHECK(std::string(nicol_last_error()).find("bad") != std::string::npos);
            CHECK(nicol_file_convert(path.c_str(), nullptr, folder.file("o.exr").c_str()) != NICOL_OK);
            CHECK(nicol_psh_project_file(path.c_str(), 5, &channels, nullptr, 0) != NICOL_OK);
        }
    CHECK(channels == 7);
    CHECK(r.channels == 0);
    // One pixel is an image, but no light.
    nicol::write_exr(folder.file("one.exr"), nicol::StokesImage(1, 1, 1));
    FAILS(nicol_file_describe_light(folder.file("one.exr").c_str(), nullptr, &r, nullptr, 0),
          NICOL_ERROR_INVALID_FILE, "2 x 2");
    CHECK(folder.names().count("o.exr") == 0);
}

TEST_CASE("inspect: a failed output leaves what was there") {
    const TemporaryFolder folder;
    Doubles field(vector_size(1));
    field[0] = 1;
    write_light(folder.file("f.npz"), 1, field);
    const std::string file = folder.file("f.npz");
    for (const char* out : {"none/o.exr", "none/o.npz", "none/o_s0.exr"})
        FAILS(nicol_file_convert(file.c_str(), nullptr, folder.file(out).c_str()), NICOL_ERROR_WRITE_FAILED,
              "none/o");
    // The input may be the output.
    convert(file, file, of_order(3));
    CHECK(light_report_of(file).order == 3);
    CHECK(folder.names() == std::set<std::string>{"f.npz"});
}
