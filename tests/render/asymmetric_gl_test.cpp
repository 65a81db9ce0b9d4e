// SPDX-License-Identifier: MIT
// Tests of materials without mirror symmetry: every method keeps the asymmetry, compared with the matrix
// itself.
#include <map>

#include "gl/contexts.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/rotation.hpp"
#include "material/chiral_material.hpp"
#include "material/material_projection.hpp"
#include "material/psh_matrix_file.hpp"
#include "reference/render_reference.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr int kPixels = 12;  // width and height of the image

/// Returns the normal of the unit sphere at a pixel, seen from far up the z axis, or nothing beside the
/// sphere.
std::optional<glm::vec3> normal_at(int row, int column) {
    const double x = (2.0 * column + 1) / kPixels - 1;
    const double y = 1 - (2.0 * row + 1) / kPixels;
    const double z2 = 1 - x * x - y * y;
    if (z2 < 0.05) return std::nullopt;
    return glm::vec3(x, y, std::sqrt(z2));
}

/// Returns one square per pixel with the sphere's normal there, so that nothing is interpolated.
Mesh sphere_of_squares() {
    Mesh mesh;
    for (int row = 0; row < kPixels; ++row)
        for (int column = 0; column < kPixels; ++column) {
            const auto normal = normal_at(row, column);
            if (!normal) continue;
            const auto first = static_cast<unsigned>(mesh.positions.size());
            for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                mesh.positions.emplace_back(2.0 * (column + right) / kPixels - 1,
                                            1 - 2.0 * (row + 1 - up) / kPixels, 0);
                mesh.normals.push_back(*normal);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangles.emplace_back(first, first + 2, first + 3);
        }
    return mesh;
}

Camera camera_above() {
    Camera camera = test::camera_at({0, 0, 3});
    camera.orthographic = true;
    return camera;
}

Scene scene_of(const MaterialPtr& material, const EnvironmentPtr& light) {
    static const auto mesh = std::make_shared<const Mesh>(sphere_of_squares());
    Scene scene;
    scene.add({.mesh = mesh, .material = material, .to_world = glm::dmat4(1)});
    scene.set_environment(light, glm::dmat3(1), 1);
    return scene;
}

/// Returns the matrix applied to the light in the frame of each normal, evaluated towards the camera (Eq.
/// 40).
StokesImage truth(const IsotropicMatrix& matrix, const PshVector& light) {
    const Viewpoint view = project(camera_above(), kPixels, kPixels).view;
    const glm::dvec3 towards(0, 0, 1);
    StokesImage image(kPixels, kPixels, 1);
    for (int row = 0; row < kPixels; ++row)
        for (int column = 0; column < kPixels; ++column) {
            const auto normal = normal_at(row, column);
            if (!normal) continue;
            const Frame surface = theta_phi_frame(glm::dvec3(*normal));
            const PshVector local = rotated(light, glm::transpose(surface));
            PshVector out(matrix.order_out(), 1);
            matrix.apply(local.channel(0), out.channel(0));
            const glm::dvec3 viewer = glm::transpose(surface) * towards;
            const double angle = angle_between(surface * theta_phi_frame(viewer), view.frame(towards));
            const Stokes s = rotated(evaluate(out, 0, viewer), angle);
            for (std::size_t p = 0; p < 4; ++p)
                image.at(0, row, column)[p] = static_cast<float>(s[static_cast<int>(p)]);
        }
    return image;
}

/// Returns the error of each component over the sphere, relative to the root mean square of the truth's s0.
std::array<double, 4> errors(const StokesImage& image, const StokesImage& truth) {
    std::array<double, 4> out{};
    double square = 0;
    for (int row = 0; row < kPixels; ++row)
        for (int column = 0; column < kPixels; ++column) {
            if (!normal_at(row, column)) continue;
            const Stokes wanted = truth.stokes(0, row, column);
            const Stokes found = image.stokes(0, row, column);
            square += wanted[0] * wanted[0];
            for (int p = 0; p < 4; ++p)
                out[static_cast<std::size_t>(p)] += (found[p] - wanted[p]) * (found[p] - wanted[p]);
        }
    for (double& e : out) e = std::sqrt(e / square);
    return out;
}

void check_errors(const StokesImage& image, const StokesImage& expected, double most) {
    const auto e = errors(image, expected);
    MESSAGE("s0 ", 100 * e[0], " %, s1 ", 100 * e[1], " %, s2 ", 100 * e[2], " %, s3 ", 100 * e[3], " %");
    for (const double error : e) CHECK(error < most);
}

/// Returns materials of one channel whose matrices have this order: a synthetic one, and measured gold if its
/// file is present. Each order is projected once, because that takes seconds.
const std::vector<IsotropicMatrix>& matrices(int order) {
    static std::map<int, std::vector<IsotropicMatrix>> known;
    std::vector<IsotropicMatrix>& out = known[order];
    if (!out.empty()) return out;
    out.push_back(project_material(*test::chiral(test::some_metal(0.4)), 0, order));
    const auto gold = test_data("polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz");
    if (!gold.empty()) out.push_back(project_material(*psh_matrix_material(read_psh_matrix(gold)), 0, order));
    return out;
}

}  // namespace

IMAGE_TEST_CASE("a sphere of a material without mirror symmetry is what its matrix makes of the light") {
    struct Row {
        Method method;
        Executor executor;
        int low;
        int order;
        double most;
    };
    const std::vector<Row> rows{
        {Method::factored, Executor::cpu, 19, 19, 0.01}, {Method::factored, Executor::compute, 19, 19, 0.01},
        {Method::factored, Executor::cpu, 9, 19, 0.01},  {Method::factored, Executor::compute, 9, 19, 0.01},
        {Method::dense, Executor::cpu, 4, 4, 0.01},      {Method::dense, Executor::compute, 4, 4, 0.01}};
    test::Studio render(context, kPixels, kPixels);
    for (const Row& row : rows) {
        const EnvironmentPtr light = test::falling_light(row.order, true, 1);
        const RenderOptions options{.method = row.method,
                                    .executor = row.executor,
                                    .shadows = false,
                                    .order_low = row.low,
                                    .order_high = row.order};
        for (const IsotropicMatrix& matrix : matrices(row.order)) {
            const StokesImage expected = truth(matrix, light->project(row.order));
            CAPTURES(&row - rows.data(), row.low, row.order);
            const auto image = [&](bool symmetrize) {
                return render(scene_of(psh_matrix_material({matrix}, {1.0}, symmetrize), light), options,
                              camera_above());
            };
            check_errors(image(false), expected, row.most);
            // The symmetric half of the material misses a part.
            const auto half = errors(image(true), expected);
            CHECK(std::max(half[1], half[2]) > 0.05);
        }
    }
}

TEST_CASE("rays see all of a material without mirror symmetry") {
    // Light from below the horizon reaches no ray, although truncated matrices reflect a little of it.
    constexpr int order = 19;
    const EnvironmentPtr light = test::falling_light(4, true, 1);
    for (const IsotropicMatrix& matrix : matrices(order)) {
        // Measured gold is noisier: 1.9 % of s0 in four times as many samples, where the synthetic material
        // has 0.4 %.
        const bool synthetic = &matrix == &matrices(order).front();
        const double most = synthetic ? 0.0125 : 0.03;
        ReferenceStatistics statistics;
        const StokesImage image = render_reference(
            scene_of(psh_matrix_material({matrix}), light), project(camera_above(), kPixels, kPixels),
            kPixels, kPixels, {.samples = synthetic ? 512 : 2048, .shadows = false}, statistics);
        check_errors(image, truth(matrix, light->project(order)), most);
    }
}
