// SPDX-License-Identifier: MIT
#include "devices/adjoint/adjoint_executor.hpp"

#include <tbb/combinable.h>

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <string>

#include "devices/adjoint/point_gradient.hpp"
#include "devices/adjoint/vertex_gradient.hpp"
#include "draw/visibility_buffer.hpp"
#include "error.hpp"
#include "harmonics/layout_gradient.hpp"
#include "harmonics/rotation.hpp"
#include "methods/factored_method.hpp"
#include "simd/lane_transpose.hpp"
#include "surfaces/local_lights.hpp"
#include "surfaces/plain_materials.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse_adjoint(const std::string& what) {
    throw Error(ErrorCode::unsupported, "the adjoint " + what);
}

[[noreturn]] void refuse_vertices() {
    refuse_adjoint("needs light that is shaded at pixels; set shade_at to pixels");
}

// Throws Error(unsupported) if a part of the picture's light is not the light of vertices and of local
// lights.
void check_transposed(const PixelInput& input) {
    if (input.high_orders != nullptr)
        refuse_adjoint("has no orders above order_low; set order_high to order_low");
    if (input.smooth != nullptr)
        refuse_adjoint("follows no rays from mirrors, smooth glass or narrow metal; make them rougher");
    if (input.local_lights == nullptr) return;
    const LocalLighting& lighting = input.local_lights->lighting();
    if (lighting.any_extracted())
        refuse_adjoint("has no lights that are extracted from the environment; set split_lights to 0");
    if (lighting.sampled() != SampledTerms::none)
        refuse_adjoint("has no lobes that sample the environment; set bsdf_samples to 0");
}

// Sums of gradients of one thread or of all.
using Sums = tbb::combinable<GradientSums>;

// Adds the transpose of relight: rotates the rows' gradients into the vertices' frames, multiplies them by
// the visibility, and rotates them back.
void transpose_relight(const FactoredMethod& method, const PixelInput& input, const VertexGradient& rows,
                       int channels, Sums& sums, RenderRun& run) {
    const WorldGeometry& geometry = input.geometry;
    const std::size_t vertices = geometry.normals.size(), size = rows.row_size();
    const FrameRotation rotation(input.layout);
    const VisibilityProduct& shadows = **method.shadows();
    const std::vector<float> zeros(size);
    run.workers.for_blocks(
        (vertices + kLanes - 1) / kLanes, "relight", run.progress, [&](std::size_t begin, std::size_t end) {
            thread_local VertexLight light;
            light.resize(input.layout, channels, kLanes);
            std::vector<double>& sum = sums.local().distant;
            for (std::size_t block = begin; block < end; ++block) {
                const std::size_t first = block * kLanes, count = std::min(kLanes, vertices - first);
                std::array<const float*, kLanes> of_lanes;
                of_lanes.fill(zeros.data());
                for (std::size_t i = 0; i < count; ++i) of_lanes[i] = rows.row(first + i);
                to_lanes(of_lanes, size, light.block(0, 0).data());
                const std::span normals = std::span(geometry.normals).subspan(first, count);
                rotation.into_frames(normals, light, 0);
                shadows.run(light, block, block + 1, block);
                rotation.into_world(normals, light, 0);
                for (std::size_t v = first; v < first + count;) {
                    const std::size_t range = range_of(geometry, v);
                    const std::size_t last = std::min(geometry.ranges[range].last, first + count);
                    add_lanes(light, 0, v - first, last - v, std::span(sum).subspan(range * size, size));
                    v = last;
                }
            }
        });
}

double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

std::uint64_t AdjointExecutor::relight(const FactoredMethod& /*method*/, const TransferInput& /*input*/,
                                       std::span<const std::uint8_t> /*current*/, RenderRun& /*run*/) {
    return 0;  // the gradient does not depend on the light
}

std::uint64_t AdjointExecutor::relight(const DenseMethod& /*method*/, const TransferInput& /*input*/,
                                       std::span<const std::uint8_t> /*current*/, RenderRun& /*run*/) {
    refuse_adjoint("has no dense method; set method to factored");
}

void AdjointExecutor::shade(const FactoredMethod& /*method*/, const ShadeInput& /*input*/,
                            RenderRun& /*run*/) {
    refuse_vertices();
}

void AdjointExecutor::shade(const DenseMethod& /*method*/, const ShadeInput& /*input*/, RenderRun& /*run*/) {
    refuse_vertices();
}

void AdjointExecutor::specular(const HighOrderTransfer& /*high_orders*/, const ShadeInput& /*input*/,
                               RenderRun& /*run*/) {
    refuse_vertices();
}

void AdjointExecutor::scale(const ShadeInput& /*input*/) {
    refuse_vertices();
}

void AdjointExecutor::shade_pixels(const DenseMethod& /*method*/, const PixelInput& /*input*/,
                                   RenderRun& /*run*/) {
    refuse_adjoint("has no dense method; set method to factored");
}

std::uint64_t AdjointExecutor::make_physical(const ShadeInput& /*input*/) {
    refuse_vertices();
}

void AdjointExecutor::illuminate(const LocalLights& /*lights*/, const ShadeInput& /*input*/,
                                 RenderRun& /*run*/) {
    refuse_vertices();
}

void AdjointExecutor::shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) {
    check_transposed(input);
    const WorldGeometry& geometry = input.geometry;
    const int channels = picture_.channels;
    const auto planes = static_cast<std::size_t>(channels);
    const std::size_t size = planes * input.layout.size();
    std::vector<std::vector<const ResponseTable*>> responses;
    for (const VertexRange& range : geometry.ranges) {
        std::vector<const ResponseTable*>& layers = responses.emplace_back();
        for (const MaterialPtr& layer : plain_materials(range.material))
            layers.push_back(&method.tables()->at(layer));
    }
    std::vector<LocalLighting> lights;
    if (input.local_lights != nullptr)
        for (AdjointLight& light : lights_)
            lights.push_back(
                input.local_lights->lighting().with_light(std::move(light.source), lights.size()));
    const GradientSums none{
        .distant = std::vector<double>(geometry.ranges.size() * size),
        .lights = std::vector<double>(geometry.ranges.size() * lights.size() * 4 * planes)};
    Sums sums([&] { return none; });

    VertexGradient rows(method.shadows()->has_value() ? geometry.positions.size() : 0, size);
    const PointGradient points(input, picture_, responses, lights, rows);
    const std::size_t pixels =
        static_cast<std::size_t>(input.hits.width()) * static_cast<std::size_t>(input.hits.height());
    run.workers.for_vertices(
        0, pixels, pixels, "shade", run.progress,
        [&](std::size_t begin, std::size_t end) { points.add(begin, end, sums.local()); });
    if (method.shadows()->has_value()) transpose_relight(method, input, rows, channels, sums, run);
    GradientSums all = none;
    sums.combine_each([&](const GradientSums& one) { all += one; });

    const double factor = double{input.light_factor};
    gradients_.distant = PshVector(input.layout.order(), channels);
    gradients_.reflection.assign(geometry.ranges.size() * planes, 0);
    gradients_.lights.assign(lights.size() * planes * 4, 0);
    for (std::size_t r = 0; r < geometry.ranges.size(); ++r) {
        const PshVector own =
            gradient_by_coefficients(std::span(all.distant).subspan(r * size, size), input.layout, channels);
        for (std::size_t i = 0; i < own.data().size(); ++i) gradients_.distant.data()[i] += own.data()[i];
        for (int c = 0; c < channels; ++c)
            gradients_.reflection[r * planes + static_cast<std::size_t>(c)] +=
                factor * dot(own.channel(c), input.light.channel(input.light.channels() == 1 ? 0 : c));
        for (std::size_t k = 0; k < lights.size(); ++k)
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t c = 0; c < planes; ++c) {
                    const double sum = all.lights[((r * lights.size() + k) * 4 + p) * planes + c];
                    gradients_.lights[(k * planes + c) * 4 + p] += sum;
                    gradients_.reflection[r * planes + c] +=
                        sum * lights_[k].stokes[c][static_cast<glm::length_t>(p)];
                }
    }
    if (input.bounces > 0) {
        const PshVector bounced =
            method.bounces().gradient([&](std::size_t v) { return rows.row(v); }, input.layout, channels);
        for (std::size_t i = 0; i < bounced.data().size(); ++i)
            gradients_.distant.data()[i] += bounced.data()[i];
    }
    gradients_.distant = rotated(gradients_.distant, glm::transpose(input.light_to_geometry));
}

}  // namespace nicol
