// SPDX-License-Identifier: MIT
// Tests of cube maps: geometry and frames by definition, a field of known coefficients, and the authors'
// light.
#include "light/cube_cross.hpp"

#include "harmonics/evaluate.hpp"
#include "light/images.hpp"
#include "light/psh_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Returns the cube map with the field's value at every pixel.
CubeCross cross_of(const PshVector& field, int edge) {
    CubeCross cross(4 * edge, 3 * edge, field.channels());
    for (int y = 0; y < 3 * edge; ++y) {
        for (int x = 0; x < 4 * edge; ++x) {
            if (y / edge != 1 && x / edge != 1) continue;
            const Frame frame = cube_point(edge, x + 0.5, y + 0.5).frame;
            for (int c = 0; c < field.channels(); ++c) {
                const Stokes s =
                    rotated(evaluate(field, c, frame[2]), angle_between(theta_phi_frame(frame[2]), frame));
                for (int p = 0; p < 4; ++p)
                    cross.at(c, y, x)[static_cast<std::size_t>(p)] = static_cast<float>(s[p]);
            }
        }
    }
    return cross;
}

/// Relative errors of s0 (without the mean) and of s1 + i s2 up to an order.
struct Errors {
    double s0, spin;
};
Errors errors(const PshVector& a, const PshVector& truth, int order) {
    double difference[4] = {};
    double size[4] = {};
    for (int c = 0; c < truth.channels(); ++c)
        for (int l = 1; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                for (int p = 0; p < 4; ++p) {
                    difference[p] += std::pow(a.at(c, l, m, p) - truth.at(c, l, m, p), 2);
                    size[p] += std::pow(truth.at(c, l, m, p), 2);
                }
    return {std::sqrt(difference[0] / size[0]),
            std::sqrt((difference[1] + difference[2]) / (size[1] + size[2]))};
}

}  // namespace

TEST_CASE("pixels lie in the directions of the layout, in right-handed frames of their propagation") {
    // The rows give the centre of every face and the directions to its right and up.
    const struct {
        double x, y;
        glm::dvec3 forward, right, up;
    } faces[] = {{1.5, 0.5, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}}, {1.5, 2.5, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}},
                 {0.5, 1.5, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1.5, 1.5, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                 {2.5, 1.5, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {3.5, 1.5, {0, -1, 0}, {-1, 0, 0}, {0, 0, 1}}};
    constexpr int edge = 10;
    for (const auto& face : faces) {
        const CubePoint middle = cube_point(edge, face.x * edge, face.y * edge);
        CHECK(glm::distance(middle.towards_light, face.forward) < 1e-15);
        CHECK(glm::distance(middle.frame[0], face.right) < 1e-15);
        CHECK(glm::distance(middle.frame[1], face.up) < 1e-15);
        const CubePoint corner = cube_point(edge, (face.x + 0.49) * edge, (face.y - 0.49) * edge);
        const glm::dvec3 expected = glm::normalize(face.forward + 0.98 * (face.right + face.up));
        CHECK(glm::distance(corner.towards_light, expected) < 1e-14);
        CHECK(glm::distance(corner.frame[2], -expected) < 1e-14);
        CHECK(glm::distance(glm::cross(corner.frame[0], corner.frame[1]), corner.frame[2]) < 1e-14);
        CHECK(std::abs(glm::dot(corner.frame[0], face.up)) < 1e-14);
        CHECK(glm::dot(corner.frame[0], face.right) > 0.5);
    }
    // Neighbours in the image across Front's four edges are neighbours on the sphere.
    for (const auto& [a, b] : {std::pair(glm::dvec2(1.4, 1.0001), glm::dvec2(1.4, 0.9999)),
                               {{1.4, 1.9999}, {1.4, 2.0001}},
                               {{1.0001, 1.3}, {0.9999, 1.3}},
                               {{1.9999, 1.3}, {2.0001, 1.3}}})
        CHECK(glm::distance(cube_point(edge, edge * a.x, edge * a.y).towards_light,
                            cube_point(edge, edge * b.x, edge * b.y).towards_light) < 1e-3);
    for (const glm::dvec2& p : {glm::dvec2(5, 5), {25, 5}, {35, 25}, {40, 15}, {15, -0.1}, {15, 30}})
        check_error(ErrorCode::invalid_argument, CALL(cube_point(edge, p.x, p.y)), "no face");
    check_error(ErrorCode::invalid_argument, CALL(cube_point(0, 0, 0)), "edge");
}

TEST_CASE("a field of known coefficients comes back from its cube, the better the finer") {
    const PshVector field = random_field(4, 2);
    double before = 1;
    for (const int edge : {16, 32, 64}) {
        const PshVector back = image_environment(equirect_from_cross(cross_of(field, edge)))->project(4);
        const auto [s0, spin] = errors(back, field, 4);
        CHECK(back.at(1, 0, 0, 0) == doctest::Approx(5).epsilon(1e-4));
        CHECK(s0 < 4.5 / (edge * edge));
        CHECK(spin < 4.5 / (edge * edge));
        CHECK(spin < 0.3 * before);
        before = spin;
    }
}

TEST_CASE("the frame is continuous across the edges of faces") {
    // Without rotation, components of two faces would differ by the angle between their frames.
    const PshVector field = random_field(3, 1, 5);
    const EquirectImage image = equirect_from_cross(cross_of(field, 32));
    const auto light = image_environment(image);
    for (const glm::dvec3& w : random_directions(500)) {
        const Stokes expected = evaluate(field, 0, -w);
        const Stokes s = light->radiance(0, w);
        for (int p = 0; p < 4; ++p) CHECK(std::abs(s[p] - expected[p]) < 2e-3);
    }
}

TEST_CASE("the light is bilinear across the edges of faces too") {
    constexpr int edge = 16;
    CubeCross cross(4 * edge, 3 * edge, 1);
    for (int y = edge; y < 2 * edge; ++y)
        for (int x = 2 * edge; x < 3 * edge; ++x) cross.at(0, y, x)[0] = 1;
    const EquirectImage image = equirect_from_cross(cross);
    const int middle = image.height / 2;
    int between = 0;
    for (int x = 1; x < image.width; ++x) {
        const float value = image.at(0, middle, x)[0];
        CHECK(std::abs(value - image.at(0, middle, x - 1)[0]) < 0.9f);
        if (value > 0.05f && value < 0.95f) ++between;
    }
    CHECK(between >= 2);
}

TEST_CASE("files: written, and read by the name of any of them") {
    const TemporaryFolder folder;
    const PshVector field = random_field(3, 3);
    write_cube_cross(folder / "sky.v2", *psh_environment(field), 12);
    CHECK(folder.names().size() == 4);
    const CubeCross expected = cross_of(field, 12);
    for (const char* name : {"sky.v2", "sky.v2_s0.exr", "sky.v2_s2.exr", "sky.v2_s3.exr"}) {
        const CubeCross cross = read_cube_cross(folder / name);
        CHECK(largest_difference(cross, expected) < 1e-6);
        const auto light = load_environment(folder / name, 2);
        CHECK(light->circular());
        CHECK(light->channels() == 3);
        CHECK(light->project(0).at(2, 0, 0, 0) == doctest::Approx(12).epsilon(1e-3));
    }
    check_error(ErrorCode::invalid_argument, CALL(write_cube_cross(folder / "a", *psh_environment(field), 1)),
                "edge");
}

TEST_CASE("sets of files that do not fit together are refused by name") {
    const TemporaryFolder folder;
    const auto bad = ErrorCode::invalid_file;
    const auto write = [&](int component, int width, int height, int channels, float value = 0) {
        StokesImage image(width, height, channels);
        for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = value;
        write_exr(folder / ("a_s" + std::to_string(component) + ".exr"), image, {.components = 0});
    };
    const auto refuse = [&](ErrorCode code, const std::string& file, const std::string& part) {
        check_error(code, CALL(load_environment(folder / "a_s1.exr")), file, part);
    };
    refuse(ErrorCode::file_not_found, "a_s0.exr", "missing");
    for (const int p : {0, 1, 3}) write(p, 16, 12, 3, p == 0 ? 1.0f : 0.0f);
    refuse(ErrorCode::file_not_found, "a_s2.exr", "missing");
    write(2, 16, 12, 1);
    refuse(bad, "a_s2.exr", "1 channels");
    write(2, 32, 24, 3);
    refuse(bad, "a_s2.exr", "32 x 24");
    write(2, 16, 12, 3);
    CHECK_FALSE(load_environment(folder / "a_s1.exr")->polarized());
    write(2, 16, 12, 3, 1.1f);
    refuse(bad, "a_s1.exr", "more than fully");
    write(2, 16, 12, 3, std::nanf(""));
    refuse(bad, "a_s2.exr", "not a number");
    write(2, 16, 12, 3);
    for (const auto& [width, height] : {std::pair(16, 8), {12, 12}, {15, 12}, {12, 16}, {4, 3}}) {
        write(0, width, height, 3, 1);
        refuse(bad, "a_s0.exr", "4 edge x 3 edge");
    }
    StokesImage whole(16, 12, 3);
    for (std::size_t i = 0; i < whole.data.size(); ++i) whole.data[i] = i % 4 == 0 ? 1.0f : 0.1f;
    write_exr(folder / "a_s0.exr", whole);
    refuse(bad, "a_s0.exr", "of its own");
    const std::vector<double> wavelengths = {500};
    check_error(ErrorCode::invalid_argument, CALL(load_environment(folder / "a_s0.exr", 1, wavelengths)),
                "spectral");
    // A similar name does not make the image a part of a cube map.
    write_exr(folder / "s0.exr", StokesImage(4, 3, 1));
    CHECK(load_environment(folder / "s0.exr")->channels() == 1);
}

TEST_CASE("the authors' cube map is the light of the authors' coefficients") {
    const auto file = test_data("polarsh/sponza_64_s3.exr");
    if (file.empty()) return;
    const PshVector truth = read_psh_vector(file.parent_path() / "SHVec_sponza_1024_L100.npz");
    const auto [s0, spin] =
        errors(image_environment(equirect_from_cross(read_cube_cross(file)))->project(9), truth, 9);
    CHECK(s0 < 0.003);
    CHECK(spin < 0.003);
}
