// SPDX-License-Identifier: MIT
// Parts of small test scenes: a mesh that bakes quickly, light of all orders, cameras, and their images.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "harmonics/light_coefficients.hpp"
#include "material/conductor.hpp"
#include "render/renderer.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/surface_state.hpp"

namespace nicol::test {

/// Returns a sphere of few vertices: those of a cube, projected to unit length. `cells` is their number along
/// a cube edge.
inline std::shared_ptr<const Mesh> coarse_sphere(int cells) {
    Mesh mesh = make_cube(cells);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.normals[i] = mesh.positions[i] = glm::normalize(mesh.positions[i]);
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

/// Returns a sphere of 3,612 vertices.
inline std::shared_ptr<const Mesh> fine_sphere() {
    static const auto mesh = std::make_shared<const Mesh>(make_sphere({}, 1, 0.5));
    return mesh;
}

inline std::shared_ptr<const Mesh> rectangle(int cells) {
    return std::make_shared<const Mesh>(make_rectangle(cells));
}

inline glm::dmat4 at(double x, double y, double z, double size = 1) {
    return glm::scale(glm::translate(glm::dmat4(1), {x, y, z}), glm::dvec3(size));
}

/// Returns surfaces that cast no shadows, which refer to `surfaces`.
inline SurfaceState without_shadows(const SceneGeometry& surfaces) {
    return {.geometry = surfaces.geometry(),
            .visibility = nullptr,
            .directions = nullptr,
            .versions = {.geometry = surfaces.version()},
            .materials = surfaces.material_version(),
            .change = {}};
}

/// Returns the matrix of a horizontal rectangle.
inline glm::dmat4 plate_at(double y, double half) {
    return at(0, y, 0, half) * glm::rotate(glm::dmat4(1), glm::radians(-90.0), glm::dvec3(1, 0, 0));
}

/// Returns an absorbing metal with one index for all channels.
inline MaterialPtr some_metal(double alpha) {
    return rough_conductor({.eta = {{0.2, -3.0}}, .alpha = alpha});
}

/// Returns light of all orders up to `order`, whose power falls as that of images.
inline EnvironmentPtr falling_light(int order, LightKind kind, int channels = 3) {
    PshVector light(order, channels);
    for (int c = 0; c < channels; ++c) {
        light.at(c, 0, 0, 0) = 6 + c;
        for (int l = 0; l <= order; ++l) {
            for (int m = -l; m <= l; ++m) {
                for (int p = l == 0 ? 3 : 0; p < static_cast<int>(kind); ++p) {
                    if (l < 2 && (p == 1 || p == 2)) continue;
                    light.at(c, l, m, p) = std::sin(7.1 * l + 3.3 * m + 5 * p + 0.2 * c) / (l + 1);
                }
            }
        }
    }
    return psh_environment(light);
}
inline EnvironmentPtr falling_light(int order, bool polarized, int channels = 3) {
    return falling_light(order, polarized ? LightKind::full : LightKind::unpolarized, channels);
}

/// Returns a lamp in darkness, whose low orders ring.
inline EnvironmentPtr lamp() {
    EquirectImage image(64, 33, 3);
    for (int c = 0; c < 3; ++c) image.at(c, 8, 20)[0] = 500;
    return image_environment(image);
}

inline Camera camera_at(const glm::dvec3& eye, const glm::dvec3& target = glm::dvec3(0)) {
    Camera camera;
    camera.to_world = look_at(eye, target, {0, 1, 0});
    return camera;
}

inline Camera some_camera() {
    Camera camera = camera_at({2, 3, 4});
    camera.fov = 40;
    return camera;
}

/// A renderer of test images.
struct Studio {
    explicit Studio(std::shared_ptr<gl::Context> with, int across = 64, int down = 48)
        : context(std::move(with)), renderer(context), width(across), height(down) {}

    StokesImage operator()(const Scene& scene, const RenderOptions& options,
                           const Camera& camera = some_camera()) {
        Framebuffer target(context, width, height, scene.channels());
        renderer.render(scene, camera, options, target);
        statistics = target.statistics();
        return target.image();
    }

    std::shared_ptr<gl::Context> context;
    Renderer renderer;
    int width, height;
    Statistics statistics;  ///< statistics of the last image
};

}  // namespace nicol::test
