// SPDX-License-Identifier: MIT
// What files of light hold.
#include "inspect.hpp"
#include "psh_checks.hpp"

using namespace capi_test;

TEST_CASE("inspect: what a light holds, in closed form") {
    const TemporaryFolder folder;
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
            const nicol_light_report r = light_report_of(folder.file("f.npz"));
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(r.direction[i] == doctest::Approx(i == axis ? sign / 3 : 0).epsilon(1e-3));
        }
    }
    SUBCASE("a clear sky") {
        write_sky(folder.file("sky.exr"), 256, 129);
        const nicol_light_report r = light_report_of(folder.file("sky.exr"));
        CHECK(r.kind == NICOL_FILE_LIGHT_IMAGE);
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
        const nicol_light_report r = light_report_of(folder.file("f.npz"));
        CHECK((r.polarized == 1 && r.circular == 1));
        CHECK(r.largest_dolp[0] == 0);
        CHECK(r.largest_circular[0] == doctest::Approx(0.25));
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
    nicol_material_report m = NICOL_MATERIAL_REPORT_INIT;
    FAILS(nicol_file_describe_material(path, nullptr, &m, nullptr, 0), NICOL_ERROR_INVALID_ARGUMENT, "light");
}
