// SPDX-License-Identifier: MIT
// Small scenes for tests, and their images.
#pragma once

#include <glm/geometric.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "harmonics/evaluate.hpp"
#include "harmonics/psh.hpp"
#include "reference/render_reference.hpp"

namespace nicol::test {

inline StokesImage render(const Scene& scene, const Camera& camera, int width, int height,
                          const ReferenceOptions& options, Strategy strategy = Strategy::both) {
    ReferenceStatistics statistics;
    return render_reference(scene, project(camera, width, height), width, height, options, statistics,
                            strategy);
}

/// Returns an orthographic camera so narrow that its image is the single point `target`, seen from
/// `towards_viewer`.
inline Camera camera_on(const glm::dvec3& target, const glm::dvec3& towards_viewer,
                        const glm::dvec3& up = {0.1, 1, 0.2}) {
    Camera camera;
    camera.orthographic = true;
    camera.to_world = look_at(target + 2.0 * glm::normalize(towards_viewer), target, up);
    for (int axis = 0; axis < 2; ++axis) camera.to_world[axis] *= 1e-5;
    return camera;
}

/// Returns the single pixel of such a camera, all channels.
inline std::vector<Stokes> point(const Scene& scene, const Camera& camera, int samples,
                                 Strategy strategy = Strategy::both, std::uint64_t seed = 0) {
    const StokesImage image = render(scene, camera, 1, 1, {.samples = samples, .seed = seed}, strategy);
    std::vector<Stokes> out;
    for (int c = 0; c < image.channels; ++c) out.push_back(image.stokes(c, 0, 0));
    return out;
}

/// Returns make_rectangle(1) with axes x and y and the normal z of `frame`, of half side `half` about
/// `center`.
inline Instance square(const MaterialPtr& material, const Frame& frame = Frame(1.0),
                       const glm::dvec3& center = glm::dvec3(0.0), double half = 1) {
    glm::dmat4 to_world(frame);
    to_world[0] *= half;
    to_world[1] *= half;
    to_world[3] = glm::dvec4(center, 1);
    return {
        .mesh = std::make_shared<const Mesh>(make_rectangle(1)), .material = material, .to_world = to_world};
}

/// Light given by coefficients over propagation directions. The light is smooth and uses every Stokes
/// component, but may not be physically realizable.
class PshLight final : public Environment {
public:
    explicit PshLight(PshVector coefficients) : coefficients_(std::move(coefficients)) {}

    int channels() const noexcept override { return coefficients_.channels(); }
    bool polarized() const noexcept override { return true; }
    bool circular() const noexcept override { return true; }
    Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
        const glm::dvec3 propagation[] = {-towards_light};
        Stokes out[1];
        evaluate(coefficients_, channel, propagation, out);
        return out[0];
    }
    PshVector project(int) const override { return coefficients_; }
    /// Returns a uniform image, so that directions towards the light are sampled uniformly whatever its sign.
    EquirectImage image() const override {
        EquirectImage image(4, 3, channels());
        for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1;
        return image;
    }

private:
    PshVector coefficients_;
};

}  // namespace nicol::test
