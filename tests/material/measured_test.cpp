// SPDX-License-Identifier: MIT
#include "material/measured.hpp"

#include "brute_force.hpp"
#include "directions.hpp"
#include "material/conductor.hpp"
#include "material/response_table.hpp"
#include "material/spectrum_weights.hpp"
#include "pbsdf_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;
using test::even_angles;

namespace {

// Rotates M from the theta-phi frames of evaluate() to s-frames, by the general functions.
Mueller in_s_frames(const Mueller& m, const glm::dvec3& light, const glm::dvec3& viewer) {
    const glm::dvec3 s = glm::cross(light, viewer);
    if (glm::length(s) < 1e-9) return in_rotated_frames(m, pi / 2, pi / 2);
    const double in = angle_between(theta_phi_frame(-light), frame_with_x(-light, s));
    const double out = angle_between(theta_phi_frame(viewer), frame_with_x(viewer, s));
    return in_rotated_frames(m, in, out);
}

test::SFrameMueller of(const MaterialPtr& material) {
    return [material](std::size_t wavelength, const glm::dvec3& light, const glm::dvec3& viewer) {
        const int channel = material->channels() == 1 ? 0 : static_cast<int>(wavelength);
        return in_s_frames(evaluate(*material, channel, light, viewer), light, viewer);
    };
}

test::PbsdfFile small_file() {
    return test::make_pbsdf(even_angles(5, -pi, pi), even_angles(3, 0, 1.5), even_angles(4, 0, 1.5),
                            {500, 600}, of(diffuse({0.5})));
}

std::string message(const std::filesystem::path& path, const std::string& bytes, ErrorCode code) {
    write_bytes(path, bytes);
    const std::string text = error_of(CALL(load_measured(path)), code);
    CHECK(text.find(path.filename().string()) != std::string::npos);
    return text;
}

}  // namespace

TEST_CASE("a plastic written to a file and read back has the same Mueller matrices") {
    const TemporaryFolder folder;
    const MaterialPtr original = pplastic({.alpha = 0.4});
    const MaterialPtr metal = rough_conductor({.eta = {metal_index("Cu")[0]}, .alpha = 0.4});
    for (const MaterialPtr& material : {original, metal}) {
        const auto path = folder / "material.pbsdf";
        write_bytes(path, test::make_pbsdf(even_angles(49, -pi, pi), even_angles(61, 0, pi / 2),
                                           even_angles(61, 0, pi / 2), {550}, of(material))
                              .bytes());
        const MaterialPtr read = load_measured(path);
        REQUIRE(read->channels() == 1);
        std::mt19937 random(1);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 light = random_direction_within(random, 1.1);
            const glm::dvec3 viewer = random_direction_within(random, 1.1);
            const Mueller expected = evaluate(*material, 0, light, viewer);
            const Mueller found = evaluate(*read, 0, light, viewer);
            // The bound is the bilinear interpolation error over 1.5 and 7.5 degrees.
            CHECK(largest_difference(found, expected) < 0.03 * expected(0, 0) + 3e-4);
        }
        for (const glm::dvec3& d : {direction(0, 0), direction(0.7, 2)}) {
            // Directions of light and viewer coincide.
            const Mueller expected = evaluate(*material, 0, d, d);
            const Mueller found = evaluate(*read, 0, d, d);
            for (std::size_t e = 0; e < 16; ++e)
                CHECK(found(e / 4, e % 4) == Approx(expected(e / 4, e % 4)).epsilon(0.01));
        }
        CHECK(read->lobe_width(0) > 0.3);
        if (material == metal) CHECK(read->lobe_width(0) < 0.6);
        CHECK(evaluate(*read, 0, direction(2, 0), direction(1, 0))(0, 0) == 0);

        // Tables of both materials agree within the file's resolution.
        const LightLayout layout(4, LightKind::full);
        const ResponseTable a(*material, layout, 1);
        const ResponseTable b(*load_measured(path, {.symmetrize = true}), layout, 1);
        const std::size_t compared = 400 * 4 * a.row_size();
        CHECK(largest_difference(a.data().first(compared), b.data().first(compared)) <
              5e-3 * largest(a.data().first(compared)));
    }
}

TEST_CASE("azimuths from 0 to 2 pi, half of them, and rows of one dimension say the same") {
    const TemporaryFolder folder;
    const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.2}}, .alpha = 0.5});
    const auto load = [&](const std::vector<float>& phi) {
        test::PbsdfFile file =
            test::make_pbsdf(phi, even_angles(16, 0, pi / 2), even_angles(16, 0, pi / 2), {550}, of(metal));
        file.field("phi_d").shape = {phi.size()};
        write_bytes(folder / "m.pbsdf", file.bytes());
        return load_measured(folder / "m.pbsdf");
    };
    const MaterialPtr full = load(even_angles(25, -pi, pi));
    const MaterialPtr positive = load(even_angles(25, 0, 2 * pi));
    const MaterialPtr half = load(even_angles(13, 0, pi));
    for (const double azimuth : {0.3, 1.4, 3.5, 5.0}) {
        const Mueller expected = full->evaluate(0, direction(0.5, azimuth), direction(0.8, 0));
        for (const MaterialPtr& other : {positive, half}) {
            const Mueller found = other->evaluate(0, direction(0.5, azimuth), direction(0.8, 0));
            CHECK(largest_difference(found, expected) < 2e-4 * expected(0, 0));
        }
    }
}

TEST_CASE("what breaks mirror symmetry is kept, or dropped and nothing else") {
    const TemporaryFolder folder;
    const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.2}}, .alpha = 0.5});
    const auto path = folder / "m.pbsdf";
    const auto angles = even_angles(12, 0, pi / 2);
    for (const auto& [from, to] : {std::pair{-pi, pi}, std::pair{0.0, 2 * pi}}) {
        write_bytes(path, test::make_pbsdf(even_angles(25, from, to), angles, angles, {550},
                                           [&](std::size_t w, const glm::dvec3& i, const glm::dvec3& o) {
                                               Mueller m = of(metal)(w, i, o);
                                               // Biases of an analyser, one constant over the azimuth and one
                                               // varying.
                                               m(2, 0) += 0.3 * m(0, 0);
                                               m(1, 0) += (0.1 + 0.2 * glm::cross(i, o).z) * m(0, 0);
                                               return m;
                                           })
                              .bytes());
        const MaterialPtr whole = load_measured(path);
        const MaterialPtr half = load_measured(path, {.symmetrize = true});
        CHECK_FALSE(whole->mirror_symmetric());
        CHECK(half->mirror_symmetric());
        CHECK(whole->content_key() != half->content_key());
        for (const double azimuth : {0.0, 2.0, 3.0, 4.0}) {
            const glm::dvec3 light = direction(0.5, azimuth);
            const glm::dvec3 viewer = direction(0.6, 0);
            const double side = glm::cross(light, viewer).z;
            const auto in_s = [&](const MaterialPtr& material) {
                return in_s_frames(evaluate(*material, 0, light, viewer), light, viewer);
            };
            const Mueller all = in_s(whole);
            CHECK(all(2, 0) == Approx(0.3 * all(0, 0)).epsilon(0.01));
            CHECK(std::abs(all(1, 0) - all(0, 1) - (0.1 + 0.2 * side) * all(0, 0)) < 5e-3 * all(0, 0));
            const Mueller m = in_s(half);
            CHECK(std::abs(m(2, 0)) < 1e-3 * m(0, 0));
            CHECK(m(1, 0) - m(0, 1) == Approx(0.1 * m(0, 0)).epsilon(0.01));
        }
    }
}

TEST_CASE("missing values: the nearest wavelength, the mirrored direction, or nothing") {
    const TemporaryFolder folder;
    const auto path = folder / "m.pbsdf";
    const auto angles = even_angles(3, 0, 1.5);
    const auto load = [&](auto&& value) {
        write_bytes(path, test::make_pbsdf(even_angles(5, -pi, pi), angles, angles, {450, 550, 650},
                                           [&](std::size_t w, const glm::dvec3&, const glm::dvec3& o) {
                                               Mueller m;
                                               m(0, 0) = value(w, o);
                                               m(1, 1) = std::nan("");
                                               return m;
                                           })
                              .bytes());
        return load_measured(path, {.wavelengths = {450, 550, 650}});
    };
    const glm::dvec3 light = direction(0.2, 0);
    const glm::dvec3 viewer = direction(0.3, 2);
    const double nan = std::nan("");
    const MaterialPtr spectrum =
        load([&](std::size_t w, const glm::dvec3&) { return w == 1 ? nan : static_cast<double>(w) + 1; });
    CHECK(evaluate(*spectrum, 1, light, viewer)(0, 0) == Approx(1));
    CHECK(evaluate(*spectrum, 2, light, viewer)(0, 0) == Approx(3));
    CHECK(evaluate(*spectrum, 0, light, viewer)(1, 1) == 0);
    const MaterialPtr side = load([&](std::size_t, const glm::dvec3& o) { return o.y < -1e-6 ? nan : 2.0; });
    CHECK(evaluate(*side, 0, light, viewer)(0, 0) == Approx(2));
    CHECK(evaluate(*side, 0, light, direction(0.3, -2))(0, 0) == Approx(2));
    const MaterialPtr none = load([&](std::size_t, const glm::dvec3&) { return nan; });
    CHECK(evaluate(*none, 0, light, viewer)(0, 0) == 0);
    const MaterialPtr negative = load([&](std::size_t, const glm::dvec3&) { return -1.0; });
    CHECK(evaluate(*negative, 0, light, viewer)(0, 0) == 0);
}

TEST_CASE("wavelengths become channels") {
    const TemporaryFolder folder;
    const auto path = folder / "m.pbsdf";
    const auto angles = even_angles(2, 0, 1.5);
    std::vector<std::uint16_t> wavelengths;
    for (int nm = 400; nm <= 735; nm += 5) wavelengths.push_back(static_cast<std::uint16_t>(nm));
    REQUIRE(wavelengths.size() == 68);
    // The reflectance is nm / 1000.
    write_bytes(path, test::make_pbsdf(even_angles(3, -pi, pi), angles, angles, wavelengths,
                                       [&](std::size_t w, const glm::dvec3&, const glm::dvec3&) {
                                           Mueller m;
                                           m(0, 0) = wavelengths[w] / 1000.0;
                                           return m;
                                       })
                          .bytes());
    const glm::dvec3 up(0, 0, 1);
    const auto of_channel = [&](const MaterialPtr& m, int c) { return evaluate(*m, c, up, up)(0, 0); };
    const MaterialPtr linear = load_measured(path, {.wavelengths = {503, 650, 900}});
    REQUIRE(linear->channels() == 3);
    CHECK(of_channel(linear, 0) == Approx(0.503));
    CHECK(of_channel(linear, 2) == Approx(0.735));
    const MaterialPtr nearest =
        load_measured(path, {.wavelengths = {503}, .sampling = WavelengthSampling::nearest});
    CHECK(of_channel(nearest, 0) == Approx(0.505));
    const MaterialPtr rgb = load_measured(path);
    REQUIRE(rgb->channels() == 3);
    CHECK(of_channel(rgb, 0) > 0.59);
    CHECK(of_channel(rgb, 1) == Approx(0.54).epsilon(0.04));
    CHECK(of_channel(rgb, 2) < 0.48);
    CHECK(rgb->content_key() != linear->content_key());
    CHECK(rgb->content_key() == load_measured(path)->content_key());
    CHECK_THROWS_AS(load_measured(path, {.wavelengths = {1e9}}), Error);
    CHECK_THROWS_AS(load_measured(path, {.wavelengths = std::vector<double>(17, 500)}), Error);
}

TEST_CASE("colour weights: grey stays grey, single wavelengths have their colour") {
    const std::vector<double> wavelengths{450, 500, 550, 600, 650};
    const ChannelWeights rgb = rgb_weights(wavelengths);
    for (const auto& channel : rgb) {
        double sum = 0;
        for (const double w : channel) sum += w;
        CHECK(sum == Approx(1));
    }
    CHECK(rgb[0][3] > 0.5);    // 600 nm is red
    CHECK(rgb[2][0] > 0.8);    // 450 nm is blue
    CHECK(rgb[1][2] > 0.5);    // 550 nm is green
    CHECK(rgb[0][1] < -0.05);  // 500 nm lies outside the gamut
    CHECK_THROWS_AS(rgb_weights({}), Error);
    CHECK_THROWS_AS(rgb_weights(std::vector<double>{500, 500}), Error);
    CHECK_THROWS_AS(linear_weights(std::vector<double>{600, 500}, wavelengths), Error);
}

TEST_CASE("malformed files are refused by file and field") {
    const TemporaryFolder folder;
    const auto path = folder / "bad.pbsdf";
    const auto with = [](auto&& change) {
        test::PbsdfFile file = small_file();
        change(file);
        return file.bytes();
    };
    const auto has = [&](const std::string& bytes, const char* what,
                         ErrorCode code = ErrorCode::invalid_file) {
        const std::string text = message(path, bytes, code);
        CAPTURE(text);
        CHECK(text.find(what) != std::string::npos);
    };
    using File = test::PbsdfFile;
    const std::string good = small_file().bytes();
    has("", "tensor_file");
    has("tensor_fils" + good.substr(11), "tensor_file");
    has(with([](File& f) { f.magic[12] = 2; }), "version", ErrorCode::unsupported);
    has(good.substr(0, good.size() - 1), "field M does not fit");
    for (std::size_t cut = 12; cut < 200; cut += 7)
        CHECK_FALSE(message(path, good.substr(0, cut), ErrorCode::invalid_file).empty());
    has(with([](File& f) { f.field("M").shape[0] = std::uint64_t{1} << 60; }), "field M does not fit");
    has(with([](File& f) { f.field("M").shape = {1ull << 60, 1ull << 60, 1ull << 60, 1, 4, 4}; }), "field M");
    has(with([](File& f) { f.field("M").shape[3] = 1; }), "field M must have the shape");
    has(with([](File& f) { f.field("M").shape.pop_back(); }), "dimensions");
    has(with([](File& f) { f.field("M").type = 99; }), "unknown type");
    has(with([](File& f) { f.field("M").type = 6; }), "type");
    has(with([](File& f) { f.field("M").name = "N"; }), "no field M");
    has(with([](File& f) { f.field("M").name = "wvls"; }), "twice");
    has(with([](File& f) { f.field("M").name = "M\n"; }), "ASCII");
    has(with([](File& f) { f.field("theta_h").shape = {1, 0}; }), "theta_h is empty");
    has(with([](File& f) { f.field("phi_d").shape = {0}; }), "phi_d is empty");
    has(with([](File& f) { f.field("wvls").shape = {1, 0}; }), "wvls is empty");
    has(with([](File& f) { f.field("theta_d").shape = {3, 1}; }), "theta_d");
    has(with([](File& f) { f.field("theta_h").type = 11; }), "theta_h");
    const auto patch = [](File& f, const char* name, std::size_t index, float value) {
        f.field(name).bytes.replace(4 * index, 4, reinterpret_cast<const char*>(&value), 4);
    };
    has(with([&](File& f) { patch(f, "theta_h", 2, 0.5F); }), "theta_h does not increase");
    has(with([&](File& f) { patch(f, "theta_d", 0, -1); }), "theta_d has the angle");
    has(with([&](File& f) { patch(f, "phi_d", 4, 7); }), "phi_d has the angle");
    has(with([&](File& f) { patch(f, "phi_d", 1, std::nanf("")); }), "phi_d has the angle");
    has(with([](File& f) {
            std::swap(f.field("wvls").bytes[0], f.field("wvls").bytes[2]);
            std::swap(f.field("wvls").bytes[1], f.field("wvls").bytes[3]);
        }),
        "wvls");
    // The offset field is the eight bytes after name, dimensions and type, and points beyond the file.
    const std::size_t at = good.find("phi_d") + 5 + 2 + 1;
    has(std::string(good).replace(at, 8, "\xff\xff\xff\xff\xff\xff\xff\x7f", 8), "beyond the end");
    has(std::string(good).replace(14, 4, "\xff\xff\xff\xff", 4), "fields");
    CHECK_THROWS_AS(load_measured(folder / "absent.pbsdf"), Error);
    CHECK_THROWS_AS(load_measured(folder.path()), Error);
    // Random byte changes must give an error or a material, and nothing else.
    std::mt19937 random(7);
    for (int i = 0; i < 300; ++i) {
        std::string bytes = good;
        bytes[random() % 220] = static_cast<char>(random());
        write_bytes(path, bytes);
        try {
            static_cast<void>(load_measured(path));
        } catch (const Error&) {
        }
    }
}

TEST_CASE("angle fields without values stand for evenly spaced angles, with one notice") {
    const TemporaryFolder folder;
    const auto path = folder / "m.pbsdf";
    test::PbsdfFile file = test::make_pbsdf(even_angles(9, 0, 2 * pi), even_angles(4, 0, pi / 2),
                                            even_angles(5, 0, pi / 2), {550}, of(pplastic({.alpha = 0.4})));
    std::vector<std::string> notices;
    const auto read = [&] {
        write_bytes(path, file.bytes());
        notices.clear();
        return load_measured(path, {}, [&](const std::string& text) { notices.push_back(text); });
    };
    const MaterialPtr expected = read();
    CHECK(notices.empty());
    const auto check_same = [&](const MaterialPtr& found) {
        std::mt19937 random(1);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 light = random_direction_within(random, 1.4);
            const glm::dvec3 viewer = random_direction_within(random, 1.4);
            const Mueller wanted = evaluate(*expected, 0, light, viewer);
            // The bound reflects that the file's angles are floats.
            CHECK(largest_difference(evaluate(*found, 0, light, viewer), wanted) <
                  1e-5 + 1e-4 * wanted(0, 0));
        }
    };
    const auto empty = [&](const std::string& name) {
        test::PbsdfFile::Field& field = file.field(name);
        field.shape[0] = 0;
        field.bytes.clear();
    };
    empty("phi_d");
    check_same(read());
    REQUIRE(notices.size() == 1);
    CHECK(notices[0].starts_with(path.string() + ": "));
    CHECK(notices[0].find("phi_d") != std::string::npos);
    CHECK(notices[0].find("theta") == std::string::npos);
    empty("theta_h");
    empty("theta_d");
    check_same(read());
    REQUIRE(notices.size() == 1);
    for (const char* name : {"phi_d", "theta_d", "theta_h"})
        CHECK_MESSAGE(notices[0].find(name) != std::string::npos, name);
    // The claimed number of angles has no limit if there are no values.
    for (const std::uint64_t count : {std::uint64_t{0}, std::uint64_t{6}, UINT64_MAX}) {
        file.field("theta_h").shape[1] = count;
        CHECK(error_of(CALL(read()), ErrorCode::invalid_file).find("field ") != std::string::npos);
    }
}

TEST_CASE("Mitsuba's own measured material is read") {
    const auto path = test_data("mitsuba_scenes/tests/pbsdf/spectralon_lowres.pbsdf");
    if (path.empty()) return;
    int notices = 0;
    const MaterialPtr white = load_measured(path, {}, [&](const std::string&) { ++notices; });
    CHECK(notices == 1);
    CHECK(white->channels() == 3);
    // Spectralon reflects nearly all light uniformly and hardly polarizes it.
    const Mueller m = evaluate(*white, 1, direction(0.3, 0), direction(0.4, 2));
    CHECK(m(0, 0) * pi == Approx(0.65).epsilon(0.2));
    CHECK(std::abs(m(1, 0)) < 0.1 * m(0, 0));
}

TEST_CASE("a file of the KAIST size is read in less than 300 MB of memory where it is symmetrized") {
#if defined(NICOL_SANITIZED)
    MESSAGE("skipped: the sanitizer's own memory hides ours");
#else
    const auto peak = [] {
        std::ifstream status("/proc/self/status");
        for (std::string line; std::getline(status, line);)
            if (line.starts_with("VmHWM:")) return std::stol(line.substr(6)) / 1024;
        return 0L;
    };
    // Writing 5 resets the peak. Without the permission the bound is harder to meet but still valid.
    std::ofstream("/proc/self/clear_refs") << "5";
    const TemporaryFolder folder;
    const auto path = folder / "sparse.pbsdf";
    test::PbsdfFile file;
    file.add("theta_h", {1, 91}, 10, even_angles(91, 0, pi / 2));
    file.add("theta_d", {1, 91}, 10, even_angles(91, 0, pi / 2));
    file.add("phi_d", {1, 361}, 10, even_angles(361, -pi, pi));
    file.add("wvls", {1, 5}, 3, std::vector<std::uint16_t>{450, 500, 550, 600, 650});
    file.add("M", {361, 91, 91, 5, 4, 4}, 10, std::vector<float>());
    const std::string head = file.bytes();
    write_bytes(path, head);
    std::filesystem::resize_file(path, head.size() + 361ull * 91 * 91 * 5 * 64);
    CHECK(std::filesystem::file_size(path) > 950'000'000);
    const MaterialPtr material = load_measured(path, {.symmetrize = true});
    CHECK(material->channels() == 3);
    const long used = peak();
    if (used == 0) {
        MESSAGE("skipped: no /proc/self/status");
        return;
    }
    MESSAGE("peak memory: ", used, " MiB");
    CHECK(used < 286);
#endif
}
