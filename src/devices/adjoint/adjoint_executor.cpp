// SPDX-License-Identifier: MIT
#include "devices/adjoint/adjoint_executor.hpp"

#include <tbb/combinable.h>

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <optional>
#include <string>

#include "devices/adjoint/point_gradient.hpp"
#include "devices/adjoint/texture_gradient.hpp"
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
    if (lighting.sampled().kind != SampledTerms::none)
        refuse_adjoint("has no lobes that sample the environment; set bsdf_samples to 0");
}

// Sums of gradients of one thread or of all.
using Sums = tbb::combinable<GradientSums>;

// Adds the transpose of relight to the sums: rotates the gradients of a block of vertices into the vertices'
// frames, multiplies them by the visibility, and rotates them back. light: room for a block.
void transpose_relight(const WorldGeometry& geometry, const VisibilityProduct& shadows,
                       const FrameRotation& rotation, std::size_t block, VertexLight& light,
                       std::span<double> sums) {
    const std::size_t first = block * kLanes, size = light.row_size();
    const std::size_t end = std::min(first + kLanes, geometry.normals.size());
    const std::span normals = std::span(geometry.normals).subspan(first, end - first);
    rotation.into_frames(normals, light, 0);
    shadows.run(light, block, block + 1, block);
    rotation.into_world(normals, light, 0);
    for (std::size_t v = first; v < end;) {
        const std::size_t range = range_of(geometry, v);
        const std::size_t last = std::min(geometry.ranges[range].last, end);
        add_lanes(light, 0, v - first, last - v, sums.subspan(range * size, size));
        v = last;
    }
}

// Adds the transpose of relight of all vertices that points have added to.
void transpose_relight(const FactoredMethod& method, const PixelInput& input, const VertexGradient& rows,
                       int channels, Sums& sums, RenderRun& run) {
    const FrameRotation rotation(input.layout);
    run.workers.for_blocks((input.geometry.normals.size() + kLanes - 1) / kLanes, "relight", run.progress,
                           [&](std::size_t begin, std::size_t end) {
                               thread_local VertexLight light;
                               light.resize(input.layout, channels, kLanes);
                               for (std::size_t block = begin; block < end; ++block) {
                                   if (rows.row(block * kLanes) == nullptr) continue;
                                   std::array<const float*, kLanes> of_lanes;
                                   for (std::size_t i = 0; i < kLanes; ++i)
                                       of_lanes[i] = rows.row(block * kLanes + i);
                                   to_lanes(of_lanes, rows.row_size(), light.block(0, 0).data());
                                   transpose_relight(input.geometry, **method.shadows(), rotation, block,
                                                     light, sums.local().distant);
                               }
                           });
}

// Returns the response tables of the ranges' materials, [range][layer].
std::vector<std::vector<const ResponseTable*>> responses_of(const WorldGeometry& geometry,
                                                            const FactoredMethod::Tables& tables) {
    std::vector<std::vector<const ResponseTable*>> out;
    out.reserve(geometry.ranges.size());
    for (const VertexRange& range : geometry.ranges) {
        const std::vector<MaterialPtr> layers = plain_materials(range.material);
        std::vector<const ResponseTable*>& of_layers = out.emplace_back(layers.size());
        std::ranges::transform(layers, of_layers.begin(),
                               [&](const MaterialPtr& layer) { return &tables.at(layer); });
    }
    return out;
}

void add(const PshVector& from, PshVector& to) {
    for (std::size_t i = 0; i < from.data().size(); ++i) to.data()[i] += from.data()[i];
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

void AdjointExecutor::make_physical(const ShadeInput& /*input*/) {
    refuse_vertices();
}

void AdjointExecutor::illuminate(const LocalLights& /*lights*/, const ShadeInput& /*input*/,
                                 RenderRun& /*run*/) {
    refuse_vertices();
}

void AdjointExecutor::shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) {
    check_transposed(input);
    const WorldGeometry& geometry = input.geometry;
    const auto channels = static_cast<std::size_t>(picture_.channels);
    const std::size_t size = channels * input.layout.size();
    const auto responses = responses_of(geometry, *method.tables());
    std::vector<LocalLighting> lights;
    lights.reserve(lights_.size());
    for (AdjointLight& light : lights_)
        lights.push_back(input.local_lights->lighting().with_light(std::move(light.source), lights.size()));
    GradientSums all{.distant = std::vector<double>(geometry.ranges.size() * size),
                     .lights = std::vector<double>(geometry.ranges.size() * lights.size() * 4 * channels)};
    Sums sums([none = all] { return none; });

    const bool shadows = method.shadows()->has_value();
    VertexGradient rows(shadows ? geometry.positions.size() : 0, size);
    std::optional<TextureGradient> texture;
    if (texture_ != nullptr)
        texture.emplace(input, responses, shadows ? &**method.shadows() : nullptr, texture_, run);
    const PointGradient points(input, picture_, responses, lights, rows, texture ? &*texture : nullptr);
    const std::size_t pixels =
        static_cast<std::size_t>(input.hits.width()) * static_cast<std::size_t>(input.hits.height());
    run.workers.for_vertices(
        0, pixels, pixels, "shade", run.progress,
        [&](std::size_t begin, std::size_t end) { points.add(begin, end, sums.local()); });
    if (shadows) transpose_relight(method, input, rows, picture_.channels, sums, run);
    sums.combine_each([&](const GradientSums& one) { all += one; });
    collect(all, input);
    if (texture) gradients_.texels = texture->take_texels();
    if (input.bounces > 0)
        add(method.bounces().gradient([&](std::size_t v) { return rows.row(v); }, input.layout,
                                      picture_.channels),
            gradients_.distant);
    gradients_.distant = rotated(gradients_.distant, glm::transpose(input.light_to_geometry));
}

void AdjointExecutor::collect(const GradientSums& sums, const PixelInput& input) {
    const auto channels = static_cast<std::size_t>(picture_.channels);
    const std::size_t ranges = input.geometry.ranges.size(), size = channels * input.layout.size();
    const std::size_t lights = lights_.size();
    gradients_ = {.distant = PshVector(input.layout.order(), picture_.channels),
                  .lights = std::vector<double>(lights * channels * 4),
                  .reflection = std::vector<double>(ranges * channels),
                  .texels = {}};
    for (std::size_t r = 0; r < ranges; ++r) {
        const std::span reflection = std::span(gradients_.reflection).subspan(r * channels, channels);
        const PshVector distant = gradient_by_coefficients(std::span(sums.distant).subspan(r * size, size),
                                                           input.layout, picture_.channels);
        add(distant, gradients_.distant);
        for (int c = 0; c < picture_.channels; ++c)
            reflection[static_cast<std::size_t>(c)] +=
                double{input.light_factors.of[static_cast<std::size_t>(c)]} *
                dot(distant.channel(c), input.light.channel(input.light.channels() == 1 ? 0 : c));
        for (std::size_t k = 0; k < lights; ++k)
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t c = 0; c < channels; ++c) {
                    const double sum = sums.lights[((r * lights + k) * 4 + p) * channels + c];
                    gradients_.lights[(k * channels + c) * 4 + p] += sum;
                    reflection[c] += sum * lights_[k].stokes[c][static_cast<glm::length_t>(p)];
                }
    }
}

}  // namespace nicol
