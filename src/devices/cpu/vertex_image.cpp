// SPDX-License-Identifier: MIT
#include "devices/cpu/vertex_image.hpp"

#include <algorithm>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "devices/cpu/pixel_shading.hpp"
#include "draw/visibility_buffer.hpp"
#include "light/equirect_texels.hpp"

namespace nicol {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Returns the weights of a triangle's corners at a place of the image, whose sum is 1. The weight of a corner
// is in proportion to the determinant of the place and the two other corners in homogeneous coordinates,
// which also holds for corners behind the camera. Double precision, because differences of small triangles
// at grazing angles lose most digits.
glm::vec3 weights_at(const glm::dvec2& place, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto from_place = [&place](const glm::dvec3& corner) {
        return glm::dvec2(corner) - corner.z * place;
    };
    const glm::dvec2 to_a = from_place(a), to_b = from_place(b), to_c = from_place(c);
    const glm::dvec3 parts(cross(to_b, to_c), cross(to_c, to_a), cross(to_a, to_b));
    const double sum = parts.x + parts.y + parts.z;
    return sum != 0 ? glm::vec3(parts / sum) : glm::vec3(1, 0, 0);
}

// Interpolation of Stokes vectors between the corners of triangles.
class Interpolation {
public:
    // components: number of Stokes components that are interpolated; the others become 0.
    Interpolation(const VertexStokes& stokes, std::size_t components) : stokes_(stokes) {
        for (std::size_t p = 0; p < components; ++p) wanted_[p] = 1;
    }

    // Adds a triangle's Stokes vectors at a point to out[c][pixel].
    void add(const glm::uvec3& corners, const glm::vec3& weights, std::size_t pixel,
             std::span<const std::span<glm::vec4>> out) const {
        const FourLanes a = weights.x * wanted_, b = weights.y * wanted_, c = weights.z * wanted_;
        for (std::size_t channel = 0; channel < out.size(); ++channel) {
            const std::vector<glm::vec4>& of = stokes_[channel];
            glm::vec4& to = out[channel][pixel];
            const FourLanes sum = in_register(to) + a * in_register(of[corners.x]) +
                                  b * in_register(of[corners.y]) + c * in_register(of[corners.z]);
            std::memcpy(&to, &sum, sizeof sum);
        }
    }

private:
    const VertexStokes& stokes_;
    FourLanes wanted_{};
};

}  // namespace

VertexImage::VertexImage(const PixelInput& input, const VertexStokes& stokes, RenderRun& run)
    : input_(input), stokes_(stokes), projected_(input.geometry.positions.size()) {
    const glm::dmat4& to_clip = input.projection.world_to_clip;
    run.workers.for_vertices(0, projected_.size(), projected_.size(), "draw", run.progress,
                             [&](std::size_t begin, std::size_t end) {
                                 for (std::size_t v = begin; v < end; ++v) {
                                     const glm::dvec4 place =
                                         to_clip * glm::dvec4(input_.geometry.positions[v], 1);
                                     projected_[v] = glm::dvec3(place.x, place.y, place.w);
                                 }
                             });
}

void VertexImage::run(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out) const {
    for (const std::span<glm::vec4> channel : out)
        std::ranges::fill(channel.subspan(first, last - first), glm::vec4(0));
    thread_local std::vector<float> coverage;
    coverage.assign(last - first, 0.0F);
    const VisibilityBuffer& hits = input_.hits;
    const auto width = static_cast<std::size_t>(hits.width());
    const float weight = 1.0F / static_cast<float>(hits.offsets().size());
    const Interpolation between(stokes_, input_.most_components);
    const glm::dvec2 step(2.0 / hits.width(), -2.0 / hits.height());
    for (std::size_t s = 0; s < hits.offsets().size(); ++s) {
        const glm::dvec2 in_pixel = 0.5 + hits.offsets()[s];
        for (std::size_t pixel = first; pixel < last; ++pixel) {
            const std::optional<Hit> hit = hits.at(s, pixel);
            if (!hit) continue;
            coverage[pixel - first] += weight;
            if (!hit->front) continue;  // backs of surfaces are black
            const glm::dvec2 column_and_row(pixel % width, pixel / width);
            const glm::dvec2 place = step * (column_and_row + in_pixel) + glm::dvec2(-1, 1);
            const glm::uvec3& triangle = input_.geometry.triangles[hit->triangle];
            between.add(triangle,
                        weight * weights_at(place, projected_[triangle.x], projected_[triangle.y],
                                            projected_[triangle.z]),
                        pixel, out);
        }
    }
    add_background(input_, first, last, coverage, out);
}

}  // namespace nicol
