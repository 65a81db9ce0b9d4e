// SPDX-License-Identifier: MIT
#include "devices/adjoint/texture_gradient.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "devices/adjoint/whole_layers.hpp"
#include "devices/light_for_pixels.hpp"
#include "shading/channel_spans.hpp"
#include "shading/shade_gradient.hpp"
#include "surfaces/local_lights.hpp"

namespace nicol {
namespace {

constexpr std::size_t kBlocks = PixelBatch::kMost / kLanes;

// Returns weights that leave one of the layers alone: [block][layer].
void only(std::size_t layer, std::size_t layers, std::size_t blocks, std::vector<LayerWeights>& out) {
    out.assign(blocks * layers, LayerWeights{.value = {}, .points = 0, .equal = true});
    for (std::size_t block = 0; block < blocks; ++block) out[block * layers + layer] = kWholeLayer;
}

bool has_factor(const MaterialLayer& layer, std::size_t texture) {
    return std::ranges::any_of(layer.factors,
                               [&](const LayerFactor& factor) { return factor.texture == texture; });
}

}  // namespace

// Work space for a batch of points.
struct TextureGradient::Work {
    std::vector<LayerWeights> weights;
    std::vector<glm::vec4> stokes;
    VertexLight light;
    std::vector<float> own;
    std::vector<double> by_weight;                       // of one layer, [channel][point]
    std::array<std::array<Lanes, 4>, kBlocks> by_value;  // [block][channel of the texture]
};

TextureGradient::TextureGradient(const PixelInput& input,
                                 std::span<const std::vector<const ResponseTable*>> responses,
                                 const VisibilityProduct* shadows, TexturePtr texture, RenderRun& run)
    : input_(input),
      responses_(responses),
      texture_(std::move(texture)),
      rotation_(input.layout),
      texels_(*texture_) {
    of_ranges_.reserve(input.geometry.ranges.size());
    for (const VertexRange& range : input.geometry.ranges) {
        std::optional<std::size_t>& index = of_ranges_.emplace_back();
        const SpatialVariation* const variation = range.material->variation();
        if (variation == nullptr) continue;
        const auto found = std::ranges::find(variation->textures, texture_);
        if (found == variation->textures.end()) continue;
        const auto at = static_cast<std::size_t>(found - variation->textures.begin());
        if (std::ranges::any_of(variation->layers, [&](const auto& layer) { return has_factor(layer, at); }))
            index = at;
    }
    relight(shadows, run);
}

void TextureGradient::relight(const VisibilityProduct* shadows, RenderRun& run) {
    const Relight light(input_.layout, input_.light);
    const int channels = input_.light.channels();
    // Light without shadows is the same everywhere in the geometry's axes.
    constexpr std::array<glm::vec3, 1> any{glm::vec3(0, 0, 1)};
    unoccluded_.resize(input_.layout, channels, kLanes);
    light.run(any, 0, 1, unoccluded_);
    leave_for_pixels(rotation_, nullptr, any, 0, 1, unoccluded_);
    if (shadows == nullptr) return;
    const std::span normals(input_.geometry.normals);
    light_.resize(input_.layout, channels, normals.size());
    run.workers.for_blocks(light_.blocks(), "relight", run.progress,
                           [&](std::size_t first, std::size_t last) {
                               light.run(normals, first, last, light_);
                               shadows->run(light_, first, last);
                               leave_for_pixels(rotation_, nullptr, normals, first, last, light_);
                           });
}

void TextureGradient::add(PixelBatch& batch, std::span<const std::span<glm::vec4>> stokes,
                          const Reflected& reflected) {
    thread_local Work work;
    const std::size_t range = batch.points().front().range;
    const std::span layers(input_.geometry.ranges[range].material->variation()->layers);
    const std::size_t blocks = batch.surfaces().size();
    for (std::size_t block = 0; block < blocks; ++block) work.by_value[block] = {};
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        if (!has_factor(layers[layer], *of_ranges_[range])) continue;
        work.by_weight.assign(stokes.size() * batch.points().size(), 0);
        if (!reflected.normals.empty()) add_distant(batch, reflected, layer, stokes, work);
        if (reflected.local && input_.local_lights != nullptr) add_local(batch, layer, stokes, work);
        add_values(batch, layer, work);
    }
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t count = std::min(kLanes, batch.points().size() - block * kLanes);
        texels_.add(batch.texture_points()[block], (1U << count) - 1, work.by_value[block]);
    }
}

void TextureGradient::add_distant(const PixelBatch& batch, const Reflected& reflected, std::size_t layer,
                                  std::span<const std::span<glm::vec4>> stokes, Work& work) const {
    const std::span points = batch.points();
    const std::size_t blocks = batch.surfaces().size(), numbers = input_.layout.size();
    const std::span normals = reflected.normals.first(points.size());
    const std::array<const ResponseTable*, 1> response{responses_[points.front().range][layer]};
    work.light.resize(input_.layout, static_cast<int>(stokes.size()), PixelBatch::kMost);
    shade_gradient(input_.layout, response, std::span(kWholeLayers).first(blocks), batch.views(),
                   reflected.positions.first(points.size()), normals, stokes, work.light);
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t begin = block * kLanes;
        rotation_.into_world(normals.subspan(begin, std::min(kLanes, points.size() - begin)), work.light,
                             block);
        work.light.to_rows(block);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        find_own(batch, i, work);
        const float* gradient = work.light.row(i);
        for (std::size_t c = 0; c < stokes.size(); ++c, gradient += numbers) {
            const float* const own = work.own.data() + (input_.light.channels() == 1 ? 0 : c * numbers);
            work.by_weight[c * points.size() + i] +=
                double{input_.light_factors.of[c]} *
                std::inner_product(gradient, gradient + numbers, own, 0.0);
        }
    }
}

void TextureGradient::find_own(const PixelBatch& batch, std::size_t point, Work& work) const {
    const float* const unoccluded = unoccluded_.row(0);
    work.own.assign(unoccluded, unoccluded + unoccluded_.row_size());
    if (batch.points()[point].occluded == 0) return;
    const glm::uvec3& corners = input_.geometry.triangles[batch.points()[point].triangle];
    const std::array<Lanes, 3>& weights = batch.surfaces()[point / kLanes].weights;
    std::ranges::fill(work.own, 0.0F);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const float* const row = light_.row(corners[static_cast<glm::length_t>(k)]);
        for (std::size_t j = 0; j < work.own.size(); ++j) work.own[j] += weights[k][point % kLanes] * row[j];
    }
}

void TextureGradient::add_local(PixelBatch& batch, std::size_t layer,
                                std::span<const std::span<glm::vec4>> stokes, Work& work) const {
    const std::size_t points = batch.points().size();
    only(layer, responses_[batch.points().front().range].size(), batch.surfaces().size(), work.weights);
    batch.weigh(work.weights);
    work.stokes.clear();
    const std::vector<std::span<glm::vec4>> reflected = channel_spans(work.stokes, stokes.size(), points);
    PixelLights(input_.local_lights->lighting(), input_).add(batch, reflected);
    for (std::size_t c = 0; c < stokes.size(); ++c)
        for (std::size_t i = 0; i < points; ++i)
            work.by_weight[c * points + i] += double{glm::dot(stokes[c][i], reflected[c][i])};
}

void TextureGradient::add_values(const PixelBatch& batch, std::size_t layer, Work& work) const {
    const std::size_t points = batch.points().size(), range = batch.points().front().range;
    const SpatialVariation& variation = *input_.geometry.ranges[range].material->variation();
    const MaterialLayer& of = variation.layers[layer];
    const std::size_t channels = work.by_weight.size() / points;
    const bool grey = texture_->channels() == 1;
    for (std::size_t i = 0; i < points; ++i) {
        const TexturePoint at = batch.texture_points()[i / kLanes].at(i % kLanes);
        for (std::size_t f = 0; f < of.factors.size(); ++f) {
            if (of.factors[f].texture != *of_ranges_[range]) continue;
            glm::vec3 slope = of.scale * factor_slope(of.factors[f], texture_->at(at));
            for (std::size_t g = 0; g < of.factors.size(); ++g)
                if (g != f)
                    slope *= factor_value(of.factors[g], variation.textures[of.factors[g].texture]->at(at));
            for (std::size_t c = 0; c < channels; ++c) {
                const std::size_t color = channels == 1 ? 0 : c % 3;
                const std::size_t to = grey || !of.factors[f].colored() ? 0 : color;
                work.by_value[i / kLanes][to][i % kLanes] +=
                    static_cast<float>(work.by_weight[c * points + i]) *
                    slope[static_cast<glm::length_t>(color)];
            }
        }
    }
}

}  // namespace nicol
