// SPDX-License-Identifier: MIT
// Files of materials: from one format to another, and what they hold.
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "inspect.hpp"
#include "material/material.hpp"
#include "material/material_projection.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/response_cache.hpp"
#include "psh_checks.hpp"

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

// Any isotropic operator: one of random coefficients, averaged over turns about the normal.
IsotropicMatrix random_matrix(int order) {
    std::mt19937 random(8);
    nicol::CoefficientMatrix dense(order, order);
    for (std::size_t row = 0; row < dense.rows(); ++row)
        for (std::size_t column = 0; column < dense.columns(); ++column) {
            const bool none = (row / 4 < 4 && (row % 4 == 1 || row % 4 == 2)) ||
                              (column / 4 < 4 && (column % 4 == 1 || column % 4 == 2));
            dense(row, column) = none ? 0 : random_number(random);
        }
    return nicol::isotropic_part(dense);
}

// Sign of a position under the mirror image in the plane y = 0: azimuths and s2, s3 turn round.
double mirror_sign(int m, std::size_t p) {
    if (p == 1 || p == 2) return p == 1 ? 1 : -1;
    return (m >= 0 ? 1.0 : -1.0) * (p == 0 ? 1 : -1);
}

std::string only_table(const std::string& folder) {
    std::string found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        CHECK(found.empty());
        found = entry.path().string();
    }
    return found;
}

}  // namespace

TEST_CASE("inspect: an even surface, in closed form") {
    const TemporaryFolder folder;
    write_matrix(folder.file("d.npz"), *nicol::diffuse({0.25, 0.5, 1}), 16);
    const nicol_material_report r = report_of(folder.file("d.npz"));
    CHECK(r.kind == NICOL_FILE_MATERIAL_PSH);
    CHECK((r.channels == 3 && r.order == 16 && r.file_order == 16 && r.stokes_columns == 4));
    for (std::size_t c = 0; c < 3; ++c) {
        const double reflectance = c == 0 ? 0.25 : c == 1 ? 0.5 : 1;
        CHECK(r.albedo[c] == doctest::Approx(reflectance).epsilon(1e-3));
        CHECK(r.largest_albedo[c] == doctest::Approx(reflectance).epsilon(0.03));
        CHECK(r.asymmetry[c] < 1e-12);
        // cos / pi over both hemispheres: the root of (1 / pi^2) (2 pi / 3) (2 pi).
        CHECK(r.norms[9 * c] == doctest::Approx(reflectance * 2 / std::sqrt(3)).epsilon(0.02));
        for (std::size_t i = 1; i < 9; ++i) CHECK(r.norms[9 * c + i] < 1e-9);
    }
    nicol_file_options options = of_order(4);
    options.scale = 0.5;
    const nicol_material_report half = report_of(folder.file("d.npz"), &options);
    CHECK((half.order == 4 && half.file_order == 16));
    CHECK(half.albedo[2] == doctest::Approx(0.5).epsilon(1e-2));
}

TEST_CASE("inspect: norms and asymmetry are those of the dense matrix") {
    const TemporaryFolder folder;
    constexpr int order = 5;
    const IsotropicMatrix matrix = random_matrix(order);
    nicol::write_psh_matrix(folder.file("m.npz"), std::vector{matrix});
    Doubles energy(order + 1);
    nicol_material_report r = NICOL_MATERIAL_REPORT_INIT;
    OK(nicol_file_describe_material(folder.file("m.npz").c_str(), nullptr, &r, energy.data(), energy.size()));

    Doubles norms(9), wanted_energy(order + 1);
    double wrong = 0, all = 0;
    const nicol::CoefficientMatrix dense = matrix.dense();
    const auto group = [](std::size_t p) { return p == 0 ? 0U : p == 3 ? 2U : 1U; };
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            for (int k = 0; k <= order; ++k)
                for (int n = -k; n <= k; ++n)
                    for (std::size_t p = 0; p < 4; ++p)
                        for (std::size_t q = 0; q < 4; ++q) {
                            const double square = std::pow(
                                dense(4 * nicol::psh_index(l, m) + p, 4 * nicol::psh_index(k, n) + q), 2);
                            norms[3 * group(p) + group(q)] += square;
                            wanted_energy[static_cast<std::size_t>(std::max(l, k))] += square;
                            all += square;
                            if (mirror_sign(m, p) != mirror_sign(n, q)) wrong += square;
                        }
    for (std::size_t i = 0; i < 9; ++i)
        CHECK(r.norms[i] == doctest::Approx(std::sqrt(norms[i])).epsilon(1e-9));
    for (std::size_t l = 0; l <= order; ++l)
        CHECK(energy[l] == doctest::Approx(wanted_energy[l]).epsilon(1e-9));
    CHECK(r.asymmetry[0] == doctest::Approx(std::sqrt(wrong / all)).epsilon(1e-9));
    CHECK(r.asymmetry[0] > 0.3);
}

TEST_CASE("inspect: energy that appears and light that polarizes beyond itself are told") {
    const TemporaryFolder folder;
    // A diffuse surface that reflects twice what arrives, and one whose light leaves with s1 = 1.5 s0 unless
    // s3 took part.
    const auto surface = [](double reflectance, double polarization) {
        return nicol::callback_material({.reflect =
                                             [=](int, const glm::dvec3&, const glm::dvec3&) {
                                                 nicol::Mueller m;
                                                 m(0, 0) = reflectance / pi;
                                                 m(1, 0) = polarization * m(0, 0);
                                                 return m;
                                             },
                                         .channels = 1});
    };
    write_matrix(folder.file("bright.npz"), *surface(2, 0), 12);
    write_matrix(folder.file("plain.npz"), *surface(0.5, 0), 12);
    write_matrix(folder.file("polar.npz"), *surface(0.5, 1.5), 12);
    CHECK(report_of(folder.file("bright.npz")).largest_albedo[0] == doctest::Approx(2).epsilon(0.05));
    const nicol_material_report plain = report_of(folder.file("plain.npz"));
    const nicol_material_report polar = report_of(folder.file("polar.npz"));
    CHECK(plain.largest_albedo[0] == doctest::Approx(0.5).epsilon(0.05));
    CHECK(plain.excess[0] < 0.02);
    CHECK(polar.unphysical[0] > 0.9);
    CHECK(std::abs(polar.excess[0] - 0.5) < 0.1);
}

TEST_CASE("inspect: the worst polarization counts in the largest albedo") {
    const TemporaryFolder folder;
    // In the plane of light and viewer all of s1 = s0 is reflected, nothing of s1 = -s0: frames are s-frames.
    const auto polarizer = nicol::callback_material({.reflect =
                                                         [](int, const glm::dvec3&, const glm::dvec3&) {
                                                             nicol::Mueller m;
                                                             m(0, 0) = m(0, 3) = m(3, 0) = m(3, 3) = 0;
                                                             m(0, 0) = 0.4 / pi;
                                                             m(0, 1) = 0.4 / pi;
                                                             return m;
                                                         },
                                                     .channels = 1});
    write_matrix(folder.file("p.npz"), *polarizer, 16);
    const nicol_material_report r = report_of(folder.file("p.npz"));
    CHECK(r.albedo[0] == doctest::Approx(0.4).epsilon(1e-3));
    // Directions leave evenly by cosine; the part of s1 in s-frames that points one way adds to 0.4.
    CHECK(r.largest_albedo[0] > 0.45);
    CHECK(r.largest_albedo[0] < 0.81);
}

TEST_CASE("inspect: SHMat stays as it is, and is cut") {
    const TemporaryFolder folder;
    nicol::write_psh_matrix(folder.file("m.npz"), std::vector{random_matrix(4), random_matrix(4)});
    convert(folder.file("m.npz"), folder.file("same.npz"), NICOL_FILE_OPTIONS_INIT);
    CHECK(distance(folder.file("same.npz"), folder.file("m.npz"), 4) < 1e-15);
    convert(folder.file("m.npz"), folder.file("cut.npz"), of_order(2));
    convert(folder.file("same.npz"), folder.file("cut2.npz"), of_order(2));
    CHECK(distance(folder.file("cut.npz"), folder.file("cut2.npz"), 2) < 1e-15);
    CHECK(report_of(folder.file("cut.npz")).file_order == 2);
    nicol_file_options twice = NICOL_FILE_OPTIONS_INIT;
    twice.scale = 2;
    convert(folder.file("m.npz"), folder.file("twice.npz"), twice);
    CHECK(report_of(folder.file("twice.npz")).norms[4] ==
          doctest::Approx(2 * report_of(folder.file("m.npz")).norms[4]));
}

TEST_CASE("inspect: the authors' gold survives") {
    const char* data = std::getenv("NICOL_TEST_DATA");
    const std::string gold =
        std::string(data != nullptr ? data : "") + "/polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz";
    if (!std::filesystem::exists(gold)) {
        MESSAGE("skipped: no polarsh files in NICOL_TEST_DATA");
        return;
    }
    const TemporaryFolder folder;
    convert(gold, folder.file("gold.npz"), NICOL_FILE_OPTIONS_INIT);
    const nicol_material_report a = report_of(gold), b = report_of(folder.file("gold.npz"));
    CHECK((a.channels == 3 && a.file_order == 19));
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK(a.albedo[c] == doctest::Approx(b.albedo[c]).epsilon(1e-12));
        for (std::size_t i = 0; i < 9; ++i)
            CHECK(a.norms[9 * c + i] == doctest::Approx(b.norms[9 * c + i]).epsilon(1e-12));
        CHECK(a.largest_albedo[c] < 1);
    }
    CHECK((a.albedo[0] > a.albedo[1] && a.albedo[1] > a.albedo[2]));  // it is yellow
}

TEST_CASE("inspect: tables of the cache are materials again") {
    const TemporaryFolder folder;
    const auto plastic = nicol::pplastic({.diffuse_reflectance = {0.2, 0.4, 0.6}, .alpha = 0.4});
    constexpr int order = 5;
    write_matrix(folder.file("p.npz"), *plastic, order);
    (void)nicol::load_or_build(*plastic, nicol::LightLayout(order, nicol::LightKind::full), 3,
                               folder.file("cache"));
    const std::string table = only_table(folder.file("cache"));
    nicol_file_kind kind = 0;
    OK(nicol_file_identify(table.c_str(), &kind));
    CHECK(kind == NICOL_FILE_MATERIAL_TABLE);
    convert(table, folder.file("back.npz"), NICOL_FILE_OPTIONS_INIT);
    CHECK(distance(folder.file("back.npz"), folder.file("p.npz"), order) < 1e-4);
    const nicol_material_report r = report_of(table);
    CHECK((r.file_order == 5 && r.stokes_columns == 4 && r.channels == 3));
    CHECK(r.asymmetry[0] < 1e-12);

    SUBCASE("and are written from files, for the renderer to find") {
        for (const char* cache : {"new/", "cache"}) {
            convert(folder.file("p.npz"), folder.file(cache), of_order(4));
            std::size_t tables = 0;
            for (const auto& entry : std::filesystem::directory_iterator(folder.file(cache)))
                tables += entry.path().extension() == ".response" ? 1 : 0;
            CHECK(tables == (std::string(cache) == "cache" ? 2 : 1));
        }
        folder.write("plain", "x");
        FAILS(nicol_file_convert(folder.file("p.npz").c_str(), nullptr, folder.file("plain/").c_str()),
              NICOL_ERROR_WRITE_FAILED, "plain");
    }
    SUBCASE("a table for less light is described, but is no material") {
        (void)nicol::load_or_build(*plastic, nicol::LightLayout(3, nicol::LightKind::unpolarized), 3,
                                   folder.file("less"));
        const std::string less = only_table(folder.file("less"));
        const nicol_material_report s = report_of(less);
        CHECK((s.stokes_columns == 1 && s.file_order == 3));
        CHECK((s.norms[0] > 0.1 && s.norms[3] > 0.01 && s.norms[1] == 0 && s.norms[4] == 0));
        FAILS(nicol_file_convert(less.c_str(), nullptr, folder.file("no.npz").c_str()),
              NICOL_ERROR_UNSUPPORTED, "Stokes");
    }
    SUBCASE("damaged ones are refused") {
        const std::string whole = file_bytes(table);
        const auto refuse = [&](std::string content, nicol_result code) {
            folder.write("bad.response", content);
            nicol_material_report out = NICOL_MATERIAL_REPORT_INIT;
            FAILS(
                nicol_file_describe_material(folder.file("bad.response").c_str(), nullptr, &out, nullptr, 0),
                code, "bad.response");
            CHECK(out.channels == 0);
        };
        for (const std::size_t size : {std::size_t{0}, std::size_t{8}, std::size_t{16}, std::size_t{40},
                                       whole.size() / 2, whole.size() - 1})
            refuse(whole.substr(0, size), NICOL_ERROR_INVALID_FILE);
        refuse(whole + "x", NICOL_ERROR_INVALID_FILE);
        for (const std::size_t at : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
            std::string flipped = whole;
            flipped[at] = static_cast<char>(flipped[at] ^ 1);
            refuse(flipped, NICOL_ERROR_INVALID_FILE);
        }
        std::string version = whole;
        version[8] = 99;
        refuse(version, NICOL_ERROR_UNSUPPORTED);
        std::string key = whole;
        key.replace(12, 4, "\xff\xff\xff\x7f");
        refuse(key, NICOL_ERROR_INVALID_FILE);
        for (const char* text : {"order=5", "kind=4", "channels=3", "angles=1021"}) {
            const std::string name = std::string(text).substr(0, std::string(text).find('=') + 1);
            std::string changed = whole;
            changed[changed.rfind(text, 4096) + name.size()] = '9';
            refuse(changed, NICOL_ERROR_INVALID_FILE);
            changed[changed.rfind(name, 4096)] = '_';
            refuse(changed, NICOL_ERROR_INVALID_FILE);
        }
    }
}

TEST_CASE("inspect: measured materials become matrices") {
    const TemporaryFolder folder;
    const auto angles = nicol::test::even_angles(19, 0, pi / 2);
    write_bytes(
        folder.file("m.pbsdf"),
        nicol::test::make_pbsdf(nicol::test::even_angles(13, -pi, pi), angles, angles, {450, 550, 650},
                                [](std::size_t w, const glm::dvec3&, const glm::dvec3&) {
                                    nicol::Mueller m;
                                    m(0, 0) = 0.2 * static_cast<double>(w + 1) / pi;
                                    return m;
                                })
            .bytes());
    nicol_file_options options = of_order(6);
    options.wavelengths = spectrum({650, 500});
    const nicol_material_report r = report_of(folder.file("m.pbsdf"), &options);
    CHECK(r.kind == NICOL_FILE_MATERIAL_MEASURED);
    CHECK((r.channels == 2 && r.order == 6 && r.file_order == 0 && r.measured_wavelengths == 3));
    CHECK((r.measured_range[0] == 450 && r.measured_range[1] == 650));
    CHECK((r.wavelengths[0] == 650 && r.wavelengths[1] == 500));
    CHECK(r.albedo[0] == doctest::Approx(0.6).epsilon(0.02));
    CHECK(r.albedo[1] == doctest::Approx(0.3).epsilon(0.02));
    options.scale = 0.5;
    convert(folder.file("m.pbsdf"), folder.file("m.npz"), options);
    const nicol_material_report half = report_of(folder.file("m.npz"));
    CHECK((half.channels == 2 && half.file_order == 6));
    CHECK(half.albedo[0] == doctest::Approx(r.albedo[0] / 2).epsilon(1e-9));
    CHECK(report_of(folder.file("m.pbsdf")).channels == 3);
    FAILS(nicol_file_convert(folder.file("m.pbsdf").c_str(), &options, (folder.file("c") + "/").c_str()),
          NICOL_ERROR_INVALID_ARGUMENT, "scale");

    const std::string whole = file_bytes(folder.file("m.pbsdf"));
    for (const std::size_t size : {std::size_t{0}, std::size_t{13}, std::size_t{60}, whole.size() - 1}) {
        folder.write("bad.pbsdf", whole.substr(0, size));
        FAILS(nicol_file_convert(folder.file("bad.pbsdf").c_str(), nullptr, folder.file("o.npz").c_str()),
              NICOL_ERROR_INVALID_FILE, "bad.pbsdf");
    }
}

TEST_CASE("inspect: options that materials do not take") {
    const TemporaryFolder folder;
    write_matrix(folder.file("d.npz"), *nicol::diffuse({0.5}), 2);
    const auto refuse = [&](const std::string& out, const char* word, auto set) {
        CAPTURE(word);
        nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
        set(options);
        FAILS(nicol_file_convert(folder.file("d.npz").c_str(), &options, folder.file(out).c_str()),
              NICOL_ERROR_INVALID_ARGUMENT, word);
    };
    using O = nicol_file_options;
    refuse("o.npz", "order", [](O& o) { o.order = NICOL_PSH_MAX_MATRIX_ORDER + 1; });
    refuse("o.npz", "width", [](O& o) { o.width = o.height = 8; });
    refuse("o.npz", "edge", [](O& o) { o.edge = 8; });
    refuse("o.npz", "PHYSICAL", [](O& o) { o.flags = NICOL_FILE_PHYSICAL; });
    refuse("o.npz", "BAND_LIMITED", [](O& o) { o.flags = NICOL_FILE_BAND_LIMITED; });
    refuse("o.npz", "rotation", [](O& o) { o.rotation[0] = o.rotation[4] = o.rotation[8] = 1; });
    refuse("o.npz", "wavelengths", [](O& o) { o.wavelengths = spectrum({550}); });
    refuse("o.exr", "o.exr", [](O&) {});
    refuse("o.response", "folder", [](O&) {});
    nicol_light_report light = NICOL_LIGHT_REPORT_INIT;
    FAILS(nicol_file_describe_light(folder.file("d.npz").c_str(), nullptr, &light, nullptr, 0),
          NICOL_ERROR_INVALID_ARGUMENT, "material");
    nicol_material_report r = NICOL_MATERIAL_REPORT_INIT;
    Untouched few(2);
    FAILS(nicol_file_describe_material(folder.file("d.npz").c_str(), nullptr, &r, few.data(), few.size()),
          NICOL_ERROR_INVALID_ARGUMENT, "energy");
    CHECK(folder.names() == std::set<std::string>{"d.npz"});
}
