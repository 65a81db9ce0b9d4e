// SPDX-License-Identifier: MIT
// Tests of light given by coefficients, and of its files.
#include "files/npz.hpp"
#include "harmonics/evaluate.hpp"
#include "light/images.hpp"
#include "light/psh_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("look-up, projection and image are of one field") {
    const PshVector field = random_field(5, 2);
    const auto light = psh_environment(field);
    CHECK(light->channels() == 2);
    CHECK(light->polarized());
    CHECK(light->circular());
    for (const int order : {0, 3, 5, 8}) {
        const PshVector f = light->project(order);
        REQUIRE(f.order() == order);
        for (int c = 0; c < 2; ++c)
            for (int l = 0; l <= order; ++l)
                for (int m = -l; m <= l; ++m)
                    for (int p = 0; p < 4; ++p) CHECK(f.at(c, l, m, p) == (l > 5 ? 0 : field.at(c, l, m, p)));
    }
    const EquirectImage image = light->image();
    for (const auto& [x, y] : {std::pair(0, 100), {511, 3}, {200, 255}, {77, 128}, {300, 1}}) {
        const double u = (x + 0.5) / image.width;
        const double v = y / (image.height - 1.0);
        const glm::dvec3 w = glm::normalize(towards(u, v));
        for (int c = 0; c < 2; ++c) {
            const Stokes field_value = evaluate(field, c, -w);
            CHECK(glm::distance(light->radiance(c, w), field_value) < 1e-12);
            const Stokes expected =
                rotated(field_value, angle_between(theta_phi_frame(-w), pixel_frame(u, v)));
            CHECK(glm::distance(image.stokes(c, y, x), expected) < 1e-5);
        }
    }
    // The image is projected back by an independent code path.
    const PshVector back = image_environment(image)->project(5);
    for (std::size_t i = 0; i < back.data().size(); ++i)
        CHECK(std::abs(back.data()[i] - field.data()[i]) < 2e-3);
}

TEST_CASE("the table of coefficients is the light to 0.8 % of what varies in it, at the poles too") {
    for (const int order : {2, 31, 100}) {
        CAPTURE(order);
        const PshVector field = random_field(order, 2, 3);
        const auto light = psh_environment(field, {500, 600});
        const std::unique_ptr<const Environment> table = light->tabulated();
        REQUIRE(table);
        CHECK(table->wavelengths() == light->wavelengths());
        CHECK(table->polarized());
        CHECK(table->circular());
        CHECK_FALSE(table->tabulated());
        std::vector<glm::dvec3> anywhere = random_directions(400), poles;
        for (const glm::dvec3& d : random_directions(200, 2))
            poles.push_back(glm::normalize(glm::dvec3(0.01 * d.x, d.y, 0.01 * d.z)));
        poles.insert(poles.end(), {{0, 1, 0}, {0, -1, 0}});
        for (const std::vector<glm::dvec3>& directions : {anywhere, poles}) {
            Stokes error(0), size(0);
            for (const glm::dvec3& w : directions) {
                Stokes exact = light->radiance(1, w);
                const Stokes difference = table->radiance(1, w) - exact;
                exact[0] -= field.at(1, 0, 0, 0) / std::sqrt(4 * pi);
                error += difference * difference;
                size += exact * exact;
            }
            for (int p = 0; p < 4; ++p) CHECK(std::sqrt(error[p] / size[p]) < 0.008);
        }
    }
}

TEST_CASE("light that is quick to look up has no table") {
    CHECK_FALSE(image_environment(random_image(8, 5, 1, 1))->tabulated());
    CHECK_FALSE(constant_environment({1})->tabulated());
    CHECK_FALSE(rayleigh_sky({})->tabulated());
}

TEST_CASE("light of coefficients reports its polarization and wavelengths") {
    PshVector field(2, 1);
    field.at(0, 0, 0, 0) = 1;
    CHECK_FALSE(psh_environment(field)->polarized());
    field.at(0, 1, 0, 3) = 0.1;
    CHECK(psh_environment(field)->circular());
    CHECK(psh_environment(field)->polarized());
    field.at(0, 1, 0, 3) = 0;
    field.at(0, 2, 0, 2) = 0.1;
    CHECK_FALSE(psh_environment(field)->circular());
    CHECK(psh_environment(field)->polarized());
    CHECK(psh_environment(field)->wavelengths().empty());
    CHECK(psh_environment(field, {550})->wavelengths() == std::vector<double>{550});
    CHECK(psh_environment(field, {550})->image().wavelengths == std::vector<double>{550});
}

TEST_CASE("coefficients that are no light are refused") {
    const auto bad = ErrorCode::invalid_argument;
    check_error(bad, CALL(psh_environment(PshVector())), "channel");
    PshVector field = random_field(3, 2);
    check_error(bad, CALL(psh_environment(field, {500})), "wavelengths");
    check_error(bad, CALL(psh_environment(field, {500, -1})), "wavelengths");
    field.at(1, 1, -1, 2) = 0.1;
    check_error(bad, CALL(psh_environment(field)), "channel 1", "coefficient 1", "below l = 2");
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        field.at(1, 1, -1, 2) = 0;
        field.at(0, 2, -2, 1) = value;
        check_error(bad, CALL(psh_environment(field)), "channel 0", "coefficient 4", "finite");
    }
}

TEST_CASE("coefficient files come back bit for bit") {
    const TemporaryFolder folder;
    const PshVector field = random_field(7, 3);
    write_psh_vector(folder / "a.npz", field);
    const PshVector back = read_psh_vector(folder / "a.npz");
    CHECK(back.order() == 7);
    CHECK(back.channels() == 3);
    CHECK(std::ranges::equal(back.data(), field.data()));
    const auto light = load_environment(folder / "a.npz", 2);
    CHECK(light->project(7).at(2, 5, -3, 1) == 2 * field.at(2, 5, -3, 1));
    check_error(ErrorCode::invalid_argument, CALL(write_psh_vector(folder / "b.npz", PshVector(0, 17))),
                "17");
    check_error(ErrorCode::invalid_argument, CALL(load_environment(folder / "a.npz", std::nan(""))), "scale");
    const std::vector<double> wavelengths = {500};
    check_error(ErrorCode::invalid_argument, CALL(load_environment(folder / "a.npz", 1, wavelengths)),
                "spectral");
}

TEST_CASE("coefficient files without a channel axis or without polarization") {
    const TemporaryFolder folder;
    const std::vector<double> scalar = {5, 1, 2, 3};
    write_npz(folder / "a.npz",
              std::vector<NpzMember>{
                  {"cod_type", "SCALAR"}, {"sh_type", "REAL"}, {"coeff", NpyArray{{4}, scalar}}});
    PshVector field = read_psh_vector(folder / "a.npz");
    CHECK(field.order() == 1);
    CHECK(field.at(0, 1, 1, 0) == 3);
    CHECK_FALSE(load_environment(folder / "a.npz")->polarized());
    write_npz(folder / "a.npz",
              std::vector<NpzMember>{
                  {"cod_type", "POLAR4"}, {"sh_type", "REAL"}, {"coeff", NpyArray{{1, 4}, {5, 0, 0, 2}}}});
    field = read_psh_vector(folder / "a.npz");
    CHECK(field.order() == 0);
    CHECK(field.at(0, 0, 0, 3) == 2);
}

TEST_CASE("coefficient files of another kind are refused") {
    const TemporaryFolder folder;
    const auto bad = ErrorCode::invalid_file;
    const auto refuse = [&](ErrorCode code, const std::string& codomain, const std::string& basis,
                            NpyArray array, const std::string& part) {
        write_npz(
            folder / "a.npz",
            std::vector<NpzMember>{{"cod_type", codomain}, {"sh_type", basis}, {"coeff", std::move(array)}});
        check_error(code, CALL(load_environment(folder / "a.npz")), "a.npz", part);
    };
    const auto zeros = [](std::vector<std::size_t> shape) {
        std::size_t count = 1;
        for (const std::size_t n : shape) count *= n;
        return NpyArray{std::move(shape), std::vector<double>(count)};
    };
    refuse(ErrorCode::unsupported, "POLAR2", "REAL", zeros({1, 4, 4}), "POLAR2");
    refuse(ErrorCode::unsupported, "POLAR4", "COMP", zeros({1, 4, 4}), "COMP");
    refuse(bad, "POLAR4", "REAL", zeros({1, 5, 4}), "(order + 1)^2");
    refuse(bad, "POLAR4", "REAL", zeros({1, 0, 4}), "(order + 1)^2");
    refuse(bad, "POLAR4", "REAL", zeros({0, 4, 4}), "0 channels");
    refuse(bad, "POLAR4", "REAL", zeros({17, 4, 4}), "17 channels");
    refuse(bad, "POLAR4", "REAL", zeros({1, 4, 3}), "[1, 4, 3]");
    refuse(bad, "POLAR4", "REAL", zeros({4}), "[4]");
    refuse(bad, "POLAR4", "REAL", zeros({1, 1, 4, 4}), "shape");
    refuse(bad, "SCALAR", "REAL", zeros({1, 4, 4}), "shape");
    NpyArray array = zeros({1, 9, 4});
    array.values[17] = std::nan("");
    refuse(bad, "POLAR4", "REAL", array, "value 17");
    array.values[17] = 0;
    array.values[13] = 1;
    refuse(bad, "POLAR4", "REAL", array, "below l = 2");
    write_npz(folder / "a.npz", std::vector<NpzMember>{{"cod_type", "POLAR4"}, {"sh_type", "REAL"}});
    check_error(bad, CALL(load_environment(folder / "a.npz")), "no member coeff.npy");
    write_bytes(folder / "a.npz", "no archive");
    check_error(bad, CALL(load_environment(folder / "a.npz")), "a.npz");
    check_error(ErrorCode::file_not_found, CALL(load_environment(folder / "none.npz")), "none.npz");
}

TEST_CASE("the authors' light has the published coefficients") {
    const auto file = test_data("polarsh/SHVec_sponza_1024_L100.npz");
    if (file.empty()) return;
    const PshVector f = read_psh_vector(file);
    CHECK(f.order() == 99);
    CHECK(f.channels() == 3);
    CHECK(f.at(0, 0, 0, 0) == doctest::Approx(1.390095).epsilon(1e-6));
    CHECK(f.at(0, 1, 0, 0) == doctest::Approx(-1.340224).epsilon(1e-6));
    CHECK(f.at(0, 2, -2, 0) == doctest::Approx(2e-5).epsilon(0.1));
    CHECK(f.at(0, 2, -2, 1) == doctest::Approx(-0.008983).epsilon(1e-4));
    CHECK(f.at(0, 2, 0, 0) == doctest::Approx(1.473826).epsilon(1e-6));
    CHECK(f.at(0, 2, 0, 1) == doctest::Approx(0.18872).epsilon(1e-5));
}
