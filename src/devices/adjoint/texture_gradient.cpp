// SPDX-License-Identifier: MIT
#include "devices/adjoint/texture_gradient.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "shading/channel_spans.hpp"
#include "shading/shade_gradient.hpp"
#include "surfaces/local_lights.hpp"

namespace nicol {
namespace {

constexpr std::size_t kBlocks = PixelBatch::kMost / kLanes;

// Returns weights that leave one of the layers alone: [block][layer].
void only(std::size_t layer, std::size_t layers, std::size_t blocks, std::vector<LayerWeights>& out) {
    LayerWeights whole{.value = {}, .points = 0xFFFF, .equal = true};
    for (Lanes& of_color : whole.value) of_color.value.fill(1);
    out.assign(blocks * layers, LayerWeights{.value = {}, .points = 0, .equal = true});
    for (std::size_t block = 0; block < blocks; ++block) out[block * layers + layer] = whole;
}

bool has_factor(const MaterialLayer& layer, std::size_t texture) {
    return std::ranges::any_of(layer.factors,
                               [&](const LayerFactor& factor) { return factor.texture == texture; });
}

}  // namespace

// Work space for a batch of points.
struct TextureGradient::Work {
    std::vector<glm::vec3> positions, normals;
    std::vector<LayerWeights> weights;
    std::vector<glm::vec4> stokes;
    VertexLight light;
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
    rotation_.into_world(any, unoccluded_, 0);
    unoccluded_.to_rows(0);
    if (shadows == nullptr) return;
    const std::span normals(input_.geometry.normals);
    light_.resize(input_.layout, channels, normals.size());
    run.workers.for_blocks(
        light_.blocks(), "relight", run.progress, [&](std::size_t first, std::size_t last) {
            light.run(normals, first, last, light_);
            shadows->run(light_, first, last);
            for (std::size_t block = first; block < last; ++block) {
                const std::size_t v = block * kLanes;
                rotation_.into_world(normals.subspan(v, std::min(kLanes, normals.size() - v)), light_, block);
                light_.to_rows(block);
            }
        });
}

void TextureGradient::add(PixelBatch& batch, std::span<const std::span<glm::vec4>> stokes,
                          const Reflected& reflected) {
    thread_local Work work;
    const std::size_t range = batch.points().front().range;
    const std::span layers(input_.geometry.ranges[range].material->variation()->layers);
    const std::size_t blocks = batch.surfaces().size();
    work.positions.clear();
    work.normals.clear();
    for (const LaneSurface& surface : batch.surfaces()) {
        work.positions.insert(work.positions.end(), surface.positions.begin(), surface.positions.end());
        work.normals.insert(work.normals.end(), surface.normals.begin(), surface.normals.end());
    }
    for (std::size_t block = 0; block < blocks; ++block) work.by_value[block] = {};
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        if (!has_factor(layers[layer], *of_ranges_[range])) continue;
        work.by_weight.assign(stokes.size() * batch.points().size(), 0);
        if (reflected.distant) add_distant(batch, layer, stokes, work);
        if (reflected.local && input_.local_lights != nullptr) add_local(batch, layer, stokes, work);
        add_values(batch, layer, work);
    }
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t count = std::min(kLanes, batch.points().size() - block * kLanes);
        texels_.add(batch.texture_points()[block], (1U << count) - 1, work.by_value[block]);
    }
}

void TextureGradient::add_distant(const PixelBatch& batch, std::size_t layer,
                                  std::span<const std::span<glm::vec4>> stokes, Work& work) const {
    const std::span points = batch.points();
    const std::size_t blocks = batch.surfaces().size(), numbers = input_.layout.size();
    const std::span normals = std::span(work.normals).first(points.size());
    const std::array<const ResponseTable*, 1> response{responses_[points.front().range][layer]};
    only(0, 1, blocks, work.weights);
    work.light.resize(input_.layout, static_cast<int>(stokes.size()), PixelBatch::kMost);
    shade_gradient(input_.layout, response, work.weights, batch.views(),
                   std::span(work.positions).first(points.size()), normals, stokes, work.light);
    const bool shadowed = points.front().occluded != 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t begin = block * kLanes, count = std::min(kLanes, points.size() - begin);
        rotation_.into_world(normals.subspan(begin, count), work.light, block);
        work.light.to_rows(block);
        for (std::size_t i = 0; i < count; ++i) {
            const float* const row = work.light.row(begin + i);
            const glm::uvec3& corners = input_.geometry.triangles[points[begin + i].triangle];
            for (std::size_t c = 0; c < stokes.size(); ++c) {
                const std::size_t own = input_.light.channels() == 1 ? 0 : c;
                double sum = 0;
                for (std::size_t j = 0; j < numbers; ++j) {
                    const std::size_t at = own * numbers + j;
                    float light = 0;
                    if (shadowed)
                        for (glm::length_t k = 0; k < 3; ++k)
                            light += batch.surfaces()[block].weights[static_cast<std::size_t>(k)][i] *
                                     light_.row(corners[k])[at];
                    else
                        light = unoccluded_.row(0)[at];
                    sum += double{row[c * numbers + j]} * double{light};
                }
                work.by_weight[c * points.size() + begin + i] += double{input_.light_factors.of[c]} * sum;
            }
        }
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
