// SPDX-License-Identifier: MIT
// Tests of material files: conversion between formats, and reports.
#include "inspect.hpp"
#include "material/material.hpp"
#include "material/material_projection.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/response_cache.hpp"

using namespace capi_test;
using nicol::IsotropicMatrix;

namespace {

nicol_material_report report_of(const std::string& path, const nicol_file_options* options = nullptr) {
    nicol_material_report report = NICOL_MATERIAL_REPORT_INIT;
    OK(nicol_file_describe_material(path.c_str(), options, &report, nullptr, 0));
    return report;
}

void write_matrix(const std::string& path, const nicol::Material& material, int order) {
    std::vector<IsotropicMatrix> matrices;
    for (int c = 0; c < material.channels(); ++c)
        matrices.push_back(nicol::project_material(material, c, order));
    nicol::write_psh_matrix(path, matrices);
}

double distance(const std::string& a, const std::string& b, int order) {
    const std::vector<IsotropicMatrix> x = nicol::read_psh_matrix(a), y = nicol::read_psh_matrix(b);
    REQUIRE(x.size() == y.size());
    double sum = 0, all = 0;
    for (std::size_t c = 0; c < x.size(); ++c) {
        REQUIRE((x[c].order_in() == order && y[c].order_in() == order));
        const nicol::CoefficientMatrix p = x[c].dense(), q = y[c].dense();
        for (std::size_t i = 0; i < p.data().size(); ++i) {
            sum += std::pow(p.data()[i] - q.data()[i], 2);
            all += std::pow(q.data()[i], 2);
        }
    }
    return std::sqrt(sum / all);
}

}  // namespace

TEST_CASE("inspect: SHMat is described, stays as it is, is cut and scaled") {
    const TemporaryFolder folder;
    const std::string file = folder.file("m.npz");
    write_matrix(file, *nicol::pplastic({.diffuse_reflectance = {0.25, 0.5, 1}, .alpha = 0.4}), 8);
    Doubles energy(3 * 9);
    nicol_material_report r = NICOL_MATERIAL_REPORT_INIT;
    OK(nicol_file_describe_material(file.c_str(), nullptr, &r, energy.data(), energy.size()));
    CHECK(r.kind == NICOL_FILE_MATERIAL_PSH);
    CHECK((r.channels == 3 && r.order == 8 && r.file_order == 8 && r.stokes_columns == 4));
    for (std::size_t c = 0; c < 3; ++c) {
        // Squared norms by Stokes component and by order have equal sums, because they describe one matrix.
        double norms = 0, energies = 0;
        for (std::size_t i = 0; i < 9; ++i)
            norms += std::pow(r.norms[9 * c + i], 2), energies += energy[9 * c + i];
        CHECK(norms == doctest::Approx(energies));
        CHECK(r.asymmetry[c] < 1e-12);
        if (c > 0) CHECK(r.albedo[c] > r.albedo[c - 1]);
        CHECK(r.largest_albedo[c] >= r.albedo[c]);
    }
    convert(file, folder.file("same.npz"));
    CHECK(distance(folder.file("same.npz"), file, 8) < 1e-15);
    convert(file, folder.file("cut.npz"), of_order(2));
    convert(folder.file("same.npz"), folder.file("cut2.npz"), of_order(2));
    CHECK(distance(folder.file("cut.npz"), folder.file("cut2.npz"), 2) < 1e-15);
    CHECK(report_of(folder.file("cut.npz")).file_order == 2);
    nicol_file_options options = of_order(4);
    options.scale = 0.5;
    const nicol_material_report half = report_of(file, &options);
    CHECK((half.order == 4 && half.file_order == 8));
    CHECK(half.albedo[2] == doctest::Approx(0.5 * r.albedo[2]).epsilon(1e-2));
    options = NICOL_FILE_OPTIONS_INIT;
    options.scale = 2;
    convert(file, folder.file("twice.npz"), options);
    CHECK(report_of(folder.file("twice.npz")).norms[4] == doctest::Approx(2 * r.norms[4]));
}

TEST_CASE("inspect: tables of the cache are materials again") {
    const TemporaryFolder folder;
    const auto plastic = nicol::pplastic({.diffuse_reflectance = {0.2, 0.4, 0.6}, .alpha = 0.4});
    constexpr int order = 5;
    write_matrix(folder.file("p.npz"), *plastic, order);
    const auto table_of = [&](const char* name, const nicol::LightLayout& layout) {
        static_cast<void>(nicol::load_or_build(*plastic, layout, 3, folder.file(name)));
        return std::filesystem::directory_iterator(folder.file(name))->path().string();
    };
    const std::string table = table_of("cache", nicol::LightLayout(order, nicol::LightKind::full));
    nicol_file_kind kind = 0;
    OK(nicol_file_identify(table.c_str(), &kind));
    CHECK(kind == NICOL_FILE_MATERIAL_TABLE);
    convert(table, folder.file("back.npz"));
    CHECK(distance(folder.file("back.npz"), folder.file("p.npz"), order) < 1e-4);
    const nicol_material_report r = report_of(table);
    CHECK((r.file_order == 5 && r.stokes_columns == 4 && r.channels == 3));
    CHECK(r.asymmetry[0] < 1e-12);

    // Writes tables from files into a cache folder for the renderer.
    for (const auto& [cache, wanted] : {std::pair("new/", 1), std::pair("cache", 2)}) {
        convert(folder.file("p.npz"), folder.file(cache), of_order(4));
        int tables = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder.file(cache)))
            tables += entry.path().extension() == ".response" ? 1 : 0;
        CHECK(tables == wanted);
    }
    folder.write("plain", "x");
    FAILS(nicol_file_convert(folder.file("p.npz").c_str(), nullptr, folder.file("plain/").c_str()),
          NICOL_ERROR_WRITE_FAILED, "plain");

    // A table for fewer Stokes components can be described but not used as a material.
    const std::string less = table_of("less", nicol::LightLayout(3, nicol::LightKind::unpolarized));
    const nicol_material_report s = report_of(less);
    CHECK((s.stokes_columns == 1 && s.file_order == 3));
    CHECK((s.norms[0] > 0.1 && s.norms[3] > 0.01 && s.norms[1] == 0 && s.norms[4] == 0));
    FAILS(nicol_file_convert(less.c_str(), nullptr, folder.file("no.npz").c_str()), NICOL_ERROR_UNSUPPORTED,
          "Stokes");
    const std::string whole = file_bytes(table);
    folder.write("bad.response", whole.substr(0, whole.size() / 2));
    nicol_material_report out = NICOL_MATERIAL_REPORT_INIT;
    FAILS(nicol_file_describe_material(folder.file("bad.response").c_str(), nullptr, &out, nullptr, 0),
          NICOL_ERROR_INVALID_FILE, "bad.response");
    CHECK(out.channels == 0);
}

TEST_CASE("inspect: measured materials become matrices") {
    const TemporaryFolder folder;
    const auto angles = nicol::test::even_angles(19, 0, pi / 2);
    const std::string file = folder.file("m.pbsdf");
    write_bytes(
        file, nicol::test::make_pbsdf(nicol::test::even_angles(13, -pi, pi), angles, angles, {450, 550, 650},
                                      [](std::size_t w, const glm::dvec3&, const glm::dvec3&) {
                                          nicol::Mueller m;
                                          m(0, 0) = 0.2 * static_cast<double>(w + 1) / pi;
                                          return m;
                                      })
                  .bytes());
    nicol_file_options options = of_order(6);
    options.wavelengths = spectrum({650, 500});
    const nicol_material_report r = report_of(file, &options);
    CHECK(r.kind == NICOL_FILE_MATERIAL_MEASURED);
    CHECK((r.channels == 2 && r.order == 6 && r.file_order == 0 && r.measured_wavelengths == 3));
    CHECK((r.measured_range[0] == 450 && r.measured_range[1] == 650));
    CHECK((r.wavelengths[0] == 650 && r.wavelengths[1] == 500));
    CHECK(r.albedo[0] == doctest::Approx(0.6).epsilon(0.02));
    CHECK(r.albedo[1] == doctest::Approx(0.3).epsilon(0.02));
    options.scale = 0.5;
    convert(file, folder.file("m.npz"), options);
    const nicol_material_report half = report_of(folder.file("m.npz"));
    CHECK((half.channels == 2 && half.file_order == 6));
    CHECK(half.albedo[0] == doctest::Approx(r.albedo[0] / 2).epsilon(1e-9));
    CHECK(report_of(file).channels == 3);
    REFUSES(nicol_file_convert(file.c_str(), &options, folder.file("c/").c_str()), "scale");
    folder.write("bad.pbsdf", file_bytes(file).substr(0, 60));
    FAILS(nicol_file_convert(folder.file("bad.pbsdf").c_str(), nullptr, folder.file("o.npz").c_str()),
          NICOL_ERROR_INVALID_FILE, "bad.pbsdf");
}

TEST_CASE("inspect: options that materials do not take") {
    const TemporaryFolder folder;
    const std::string file = folder.file("d.npz");
    write_matrix(file, *nicol::diffuse({0.5}), 2);
    const auto to = [&](const std::string& out) {
        return [&, out](const nicol_file_options& options) {
            return nicol_file_convert(file.c_str(), &options, folder.file(out).c_str());
        };
    };
    using O = nicol_file_options;
    const O good = NICOL_FILE_OPTIONS_INIT;
    check_wrong(good, to("o.npz"),
                {{"order", [](O& o) { o.order = NICOL_PSH_MAX_MATRIX_ORDER + 1; }},
                 {"width", [](O& o) { o.width = o.height = 8; }},
                 {"edge", [](O& o) { o.edge = 8; }},
                 {"PHYSICAL", [](O& o) { o.flags = NICOL_FILE_PHYSICAL; }},
                 {"BAND_LIMITED", [](O& o) { o.flags = NICOL_FILE_BAND_LIMITED; }},
                 {"rotation",
                  [](O& o) {
                      std::ranges::copy(std::array<double, 9>{0, 1, 0, 0, 0, 1, 1, 0, 0}, o.rotation);
                  }},
                 {"wavelengths", [](O& o) { o.wavelengths = spectrum({550}); }}});
    REFUSES(to("o.exr")(good), "o.exr");
    REFUSES(to("o.response")(good), "folder");
    nicol_light_report light = NICOL_LIGHT_REPORT_INIT;
    REFUSES(nicol_file_describe_light(file.c_str(), nullptr, &light, nullptr, 0), "material");
    nicol_material_report r = NICOL_MATERIAL_REPORT_INIT;
    Untouched few(2);
    REFUSES(nicol_file_describe_material(file.c_str(), nullptr, &r, few.data(), few.size()), "energy");
    CHECK(folder.names() == std::set<std::string>{"d.npz"});
}

TEST_CASE("inspect: a material of a context is written as SHMat and into a cache") {
    const TemporaryFolder folder;
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const Owned material(diffuse(context, {0.25F, 0.75F}));
    nicol_file_options options = of_order(6);
    OK(nicol_material_write(material, &options, folder.file("cache/").c_str()));
    CHECK(!std::filesystem::is_empty(folder.file("cache")));
    options.scale = 2;
    OK(nicol_material_write(material, &options, folder.file("m.npz").c_str()));
    const nicol_material_report r = report_of(folder.file("m.npz"));
    CHECK((r.channels == 2 && r.file_order == 6));
    CHECK(r.albedo[0] == doctest::Approx(0.5).epsilon(0.01));
    CHECK(r.albedo[1] == doctest::Approx(1.5).epsilon(0.01));
    REFUSES(nicol_material_write(material, nullptr, folder.file("m.exr").c_str()), "m.exr");
}
