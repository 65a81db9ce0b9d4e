// SPDX-License-Identifier: MIT
#include "render/compute/device_high_orders.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "gl/draw.hpp"
#include "render/compute/device_shade.hpp"
#include "render/framebuffer.hpp"

namespace nicol {
namespace {

constexpr int kGroup = Framebuffer::kGroup;

int group_count(int channels) {
    return (channels + kGroup - 1) / kGroup;
}

int group_size(int channels, int group) {
    return std::min(kGroup, channels - group * kGroup);
}

// The layers that glsl/high_order.glsl wants of a group; a map of one channel serves all.
gl::Texture2D texture_of(const std::shared_ptr<gl::Context>& context, const LobeMap& map, int group,
                         int channels) {
    const bool single = map.channels() == 1;
    const int layers = map.polarized() ? 2 * channels : 1;
    const gl::TextureDescription size{.width = map.columns(), .height = layers * map.rows()};
    const int first = group * (map.polarized() ? 2 * kGroup : 1);
    if (!single) return {context, size, map.texels(first, layers)};
    std::vector<float> texels;
    for (int c = 0; c < (map.polarized() ? channels : 1); ++c) {
        const std::span<const float> from = map.texels(0, map.polarized() ? 2 : 1);
        texels.insert(texels.end(), from.begin(), from.end());
    }
    if (!map.polarized()) {
        for (std::size_t i = 0; i < texels.size(); i += 4) {
            texels[i + 1] = texels[i + 2] = texels[i + 3] = texels[i];
        }
    }
    return {context, size, texels};
}

}  // namespace

void DeviceHighOrders::shade(const HighOrderTransfer& transfer, const TransferInput& input,
                             const DistantLight& light, const Viewpoint& view, VertexBuffers& buffers) {
    mirror_visibility(transfer);
    mirror(transfer, input);
    for (const VertexRange& range : input.geometry.ranges) {
        const Part& part = parts_.at(range.material);
        if (visibility_.empty()) {
            run(part, range.first, range.last, nullptr, input, buffers, light, view);
            continue;
        }
        for (const DeviceLight& seen : visibility_) {
            const std::size_t first = std::max(range.first, seen.first());
            const std::size_t last = std::min(range.last, seen.last());
            if (first < last) run(part, first, last, &seen, input, buffers, light, view);
        }
    }
}

void DeviceHighOrders::mirror(const HighOrderTransfer& transfer, const TransferInput& input) {
    if (parts_revision_ == transfer.parts_revision()) return;
    parts_revision_ = 0;
    parts_.clear();
    maps_.clear();
    for (const auto& [material, from] : transfer.parts()) {
        const bool polarized = from.maps.centre->polarized();
        Part part{.factors = {},
                  .centre = textures(from.maps.centre, input.channels),
                  .around = textures(from.maps.around, input.channels),
                  .base = textures(from.maps.normal, input.channels),
                  .spread = static_cast<float>(from.factors.spread()),
                  .has_base = from.maps.normal != nullptr,
                  .polarized = polarized,
                  .lobe = {}};
        // A sampler wants a texture, used or not.
        if (part.around == nullptr) part.around = part.centre;
        if (part.base == nullptr) part.base = part.centre;
        for (int g = 0; g < group_count(input.channels); ++g) {
            part.factors.emplace_back(
                context_,
                gl::TextureDescription{
                    .width = HighOrderFactors::kAngles,
                    .height = polarized ? HighOrderFactors::kElements : HighOrderFactors::kUnpolarized},
                from.factors.texels(g * kGroup, group_size(input.channels, g), polarized));
        }
        if (!visibility_.empty()) {
            const std::vector<float> constants =
                HighOrderVisibility(visibility_order_,
                                    kLobeWidths[static_cast<std::size_t>(from.factors.centre())],
                                    input.horizon)
                    .constants();
            part.lobe.emplace_back(context_, gl::BufferUse::storage, std::as_bytes(std::span(constants)));
        }
        parts_.emplace(material, std::move(part));
    }
    parts_revision_ = transfer.parts_revision();
}

const DeviceHighOrders::Textures* DeviceHighOrders::textures(const LobeMap* map, int channels) {
    if (map == nullptr) return nullptr;
    const auto [found, made] = maps_.try_emplace(map);
    for (int g = 0; made && g < group_count(channels); ++g) {
        found->second.push_back(texture_of(context_, *map, g, group_size(channels, g)));
    }
    return &found->second;
}

void DeviceHighOrders::mirror_visibility(const HighOrderTransfer& transfer) {
    if (visibility_count_ == transfer.visibility_count()) return;
    parts_revision_ = 0;  // their lobes depend on it
    visibility_count_ = 0;
    visibility_.clear();
    const std::span<const float> all = transfer.visibility();
    const std::size_t numbers = psh_count(transfer.visibility_order());
    const std::size_t vertices = all.size() / numbers;
    const std::size_t step = DeviceLight::most_vertices(*context_, numbers);
    for (std::size_t first = 0; first < vertices; first += step) {
        visibility_.emplace_back(context_, first, std::min(step, vertices - first), numbers, 1);
        visibility_.back().upload(
            [&](std::size_t v, int /*channel*/) { return all.subspan(v * numbers, numbers); });
    }
    visibility_order_ = transfer.visibility_order();
    visibility_count_ = transfer.visibility_count();
}

gl::Program& DeviceHighOrders::program(int channels, bool polarized, bool shadowed) {
    const std::tuple key(channels, polarized, shadowed);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<gl::Define> defines{{.name = "CHANNELS", .value = std::to_string(channels)}};
        if (polarized) defines.push_back({.name = "HIGH_ORDER_POLARIZED"});
        if (shadowed) defines.push_back({.name = "SHADOWED"});
        found = programs_.emplace(key, gl::Program::compute(context_, "high_order.comp", defines)).first;
    }
    return found->second;
}

void DeviceHighOrders::run(const Part& part, std::size_t first, std::size_t last,
                           const DeviceLight* visibility, const TransferInput& input, VertexBuffers& buffers,
                           const DistantLight& light, const Viewpoint& view) {
    for (int g = 0; g < group_count(input.channels); ++g) {
        const int channels = group_size(input.channels, g);
        const auto group = static_cast<std::size_t>(g);
        gl::Program& program = this->program(channels, part.polarized, visibility != nullptr);
        set_view_uniforms(program, view);
        const std::size_t begin = bind_vertices(*buffers.positions(), 0, 3, first, last);
        std::ignore = bind_vertices(buffers.normals(input.geometry), 1, 3, first, last);
        program.set("first", static_cast<int>(first - begin));
        program.set("count", static_cast<int>(last - first));
        program.set("to_light", glm::mat3(glm::transpose(light.to_world)));
        program.set("spread", part.spread);
        program.set("has_base", part.has_base ? 1 : 0);
        if (visibility != nullptr) {
            visibility->bind(2, 0);
            part.lobe.front().bind_storage(3);
            program.set("visibility_first", static_cast<int>(first - visibility->first()));
            program.set("stride", static_cast<int>(visibility->stride()));
            program.set("visibility_order", visibility_order_);
        }
        for (int c = 0; c < channels; ++c) {
            std::ignore =
                bind_vertices(*buffers.stokes(g * kGroup + c), static_cast<unsigned>(4 + c), 4, first, last);
        }
        part.factors[group].bind(0);
        (*part.centre)[group].bind(1);
        (*part.around)[group].bind(2);
        (*part.base)[group].bind(3);
        gl::dispatch(program, groups_for(last - first));
    }
}

}  // namespace nicol
