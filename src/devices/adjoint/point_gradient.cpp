// SPDX-License-Identifier: MIT
#include "devices/adjoint/point_gradient.hpp"

#include <algorithm>
#include <array>

#include "devices/adjoint/whole_layers.hpp"
#include "devices/pixel_lights.hpp"
#include "draw/visibility_buffer.hpp"
#include "shading/channel_spans.hpp"
#include "shading/shade_gradient.hpp"

namespace nicol {

GradientSums& GradientSums::operator+=(const GradientSums& other) {
    for (std::size_t i = 0; i < distant.size(); ++i) distant[i] += other.distant[i];
    for (std::size_t i = 0; i < lights.size(); ++i) lights[i] += other.lights[i];
    return *this;
}

void add_lanes(const VertexLight& light, std::size_t block, std::size_t first, std::size_t count,
               std::span<double> sums) {
    std::size_t j = 0;
    for (int c = 0; c < light.channels(); ++c)
        for (const Lanes& number : light.block(block, c)) {
            float sum = 0;
            for (std::size_t i = first; i < first + count; ++i) sum += number[i];
            sums[j++] += double{sum};
        }
}

// Work space for the points of a batch.
struct PointGradient::Work {
    PixelBatch batch;
    std::vector<float> coverage;
    std::vector<glm::vec4> gradients, reflected;
    std::vector<std::span<glm::vec4>> gradient;  // [channel][point]
    std::vector<glm::vec3> positions, normals;
    VertexLight light;
    PixelPoints points;
};

PointGradient::PointGradient(const PixelInput& input, const StokesImage& picture,
                             std::span<const std::vector<const ResponseTable*>> responses,
                             std::span<const LocalLighting> lights, VertexGradient& vertices,
                             TextureGradient* texture)
    : input_(input),
      picture_(picture),
      responses_(responses),
      lights_(lights),
      vertices_(vertices),
      texture_(texture),
      rotation_(input.layout) {}

void PointGradient::add(std::size_t first, std::size_t last, GradientSums& sums) const {
    thread_local Work work;
    work.coverage.resize(last - first);
    work.points.list(input_, first, last, work.coverage);
    const auto add = [&](std::span<const PixelPoint> rest, const auto& each) {
        for (; !rest.empty(); rest = rest.subspan(work.batch.points().size())) {
            work.batch.take(input_, rest);
            take_gradient(work);
            each();
        }
    };
    add(work.points.whole, [&] {
        add_distant(work, sums);
        if (work.batch.reflects_lights()) add_lights(work, sums);
        add_texture(
            work,
            {.positions = work.positions, .normals = work.normals, .local = work.batch.reflects_lights()});
    });
    add(work.points.parts, [&] {
        add_lights(work, sums);
        add_texture(work, {.positions = {}, .normals = {}, .local = true});
    });
}

void PointGradient::add_texture(Work& work, const TextureGradient::Reflected& reflected) const {
    if (texture_ != nullptr && texture_->varies(work.batch.points().front().range))
        texture_->add(work.batch, work.gradient, reflected);
}

void PointGradient::take_gradient(Work& work) const {
    const std::span points = work.batch.in_pixels();
    const std::size_t pixels =
        static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height);
    work.gradient = channel_spans(work.gradients, static_cast<std::size_t>(picture_.channels), points.size());
    for (std::size_t c = 0; c < work.gradient.size(); ++c)
        for (std::size_t i = 0; i < points.size(); ++i) {
            const float* const pixel = picture_.data.data() + 4 * (c * pixels + points[i].pixel);
            glm::vec4 stokes(0);
            for (std::size_t p = 0; p < input_.most_components; ++p)
                stokes[static_cast<glm::length_t>(p)] = points[i].weight * pixel[p];
            work.gradient[c][i] = stokes;
        }
}

void PointGradient::add_distant(Work& work, GradientSums& sums) const {
    const std::span points = work.batch.points();
    const std::span surfaces = work.batch.surfaces();
    work.positions.clear();
    work.normals.clear();
    for (const LaneSurface& surface : surfaces) {
        work.positions.insert(work.positions.end(), surface.positions.begin(), surface.positions.end());
        work.normals.insert(work.normals.end(), surface.normals.begin(), surface.normals.end());
    }
    const std::span positions = std::span(work.positions).first(points.size());
    const std::span normals = std::span(work.normals).first(points.size());
    const std::vector<const ResponseTable*>& layers = responses_[points.front().range];
    const std::span<const LayerWeights> weights =
        work.batch.weights().empty() ? std::span<const LayerWeights>(kWholeLayers).first(surfaces.size())
                                     : work.batch.weights();
    work.light.resize(input_.layout, picture_.channels, PixelBatch::kMost);
    shade_gradient(input_.layout, layers, weights, work.batch.views(), positions, normals, work.gradient,
                   work.light);
    const std::size_t size = vertices_.row_size();
    const std::span sum = std::span(sums.distant).subspan(points.front().range * size, size);
    for (std::size_t block = 0; block < surfaces.size(); ++block) {
        const std::size_t begin = block * kLanes, count = std::min(kLanes, points.size() - begin);
        rotation_.into_world(normals.subspan(begin, count), work.light, block);
        if (points.front().occluded == 0) {
            add_lanes(work.light, block, 0, count, sum);
            continue;
        }
        work.light.to_rows(block);
        const std::array<Lanes, 3>& at = surfaces[block].weights;
        for (std::size_t i = 0; i < count; ++i)
            vertices_.add(input_.geometry.triangles[points[begin + i].triangle],
                          {at[0][i], at[1][i], at[2][i]}, work.light.row(begin + i));
    }
}

void PointGradient::add_lights(Work& work, GradientSums& sums) const {
    const std::size_t channels = work.gradient.size(), points = work.batch.points().size();
    const std::size_t first = work.batch.points().front().range * lights_.size();
    for (std::size_t k = 0; k < lights_.size(); ++k) {
        work.reflected.clear();
        const std::vector<std::span<glm::vec4>> reflected =
            channel_spans(work.reflected, 4 * channels, points);
        PixelLights(lights_[k], input_).add(work.batch, reflected);
        double* const sum = sums.lights.data() + (first + k) * reflected.size();
        for (std::size_t j = 0; j < reflected.size(); ++j) {
            const std::span gradient = work.gradient[j % channels];
            for (std::size_t i = 0; i < points; ++i) sum[j] += double{glm::dot(gradient[i], reflected[j][i])};
        }
    }
}

}  // namespace nicol
