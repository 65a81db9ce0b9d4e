// SPDX-License-Identifier: MIT
#include "devices/gl/device_high_orders.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "draw/framebuffer.hpp"
#include "gl/draw.hpp"

namespace nicol {
namespace {

constexpr int kGroup = Framebuffer::kGroup;

int group_count(int channels) {
    return (channels + kGroup - 1) / kGroup;
}

int group_size(int channels, int group) {
    return std::min(kGroup, channels - group * kGroup);
}

// Returns the layers of a group of channels as glsl/high_order.glsl reads them. A map of one channel serves
// all channels.
gl::Texture2D texture_of(const std::shared_ptr<gl::Context>& context, const LobeMap& map, int group,
                         int channels) {
    const bool single = map.channels() == 1;
    const int layers = map.polarized() ? 2 * channels : 1;
    const gl::TextureDescription size{.width = map.columns(), .height = layers * map.rows()};
    const int first = group * (map.polarized() ? 2 * kGroup : 1);
    if (!single) return {context, size, map.layers_apart(first, layers)};
    std::vector<float> texels;
    for (int c = 0; c < (map.polarized() ? channels : 1); ++c) {
        const std::vector<float> from = map.layers_apart(0, map.polarized() ? 2 : 1);
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

void HighOrderTextures::update(const HighOrderTransfer& transfer, int channels) {
    copying_.run(transfer.parts().version(), channels, [&] { copy(transfer, channels); });
}

void HighOrderTextures::copy(const HighOrderTransfer& transfer, int channels) {
    parts_.clear();
    maps_.clear();
    for (const auto& [material, from] : *transfer.parts()) {
        polarized_ = from.maps.central->polarized();
        Part part{.factors = {},
                  .central = textures(from.maps.central, channels),
                  .outer = textures(from.maps.outer, channels),
                  .base = textures(from.maps.base, channels),
                  .spread = static_cast<float>(from.factors.spread()),
                  .has_base = from.maps.base != nullptr};
        // A sampler needs a texture even if it is not used.
        if (part.outer == nullptr) part.outer = part.central;
        if (part.base == nullptr) part.base = part.central;
        for (int g = 0; g < group_count(channels); ++g) {
            const std::vector<float> texels =
                from.factors.texels(g * kGroup, group_size(channels, g), polarized_);
            const gl::TextureDescription size{
                .width = HighOrderFactors::kAngles,
                .height = static_cast<int>(texels.size() / 4 / HighOrderFactors::kAngles)};
            part.factors.emplace_back(context_, size, texels);
        }
        parts_.emplace(material, std::move(part));
    }
}

const HighOrderTextures::Textures* HighOrderTextures::textures(const LobeMap* map, int channels) {
    if (map == nullptr) return nullptr;
    const auto [found, made] = maps_.try_emplace(map);
    for (int g = 0; made && g < group_count(channels); ++g) {
        found->second.push_back(texture_of(context_, *map, g, group_size(channels, g)));
    }
    return &found->second;
}

void HighOrderTextures::bind(gl::Program& program, const Part& part, std::size_t group) {
    program.set("spread", part.spread);
    program.set("has_base", part.has_base ? 1 : 0);
    part.factors[group].bind(0);
    (*part.central)[group].bind(1);
    (*part.outer)[group].bind(2);
    (*part.base)[group].bind(3);
}

void DeviceHighOrders::compute_fractions(const HighOrderTransfer& transfer, const ShadeInput& input,
                                         VertexBuffers& buffers) {
    copy_visibility(transfer);
    if (visibility_.empty()) return;
    if (!fraction_) fraction_ = gl::Program::compute(context_, "high_order_fraction.comp");
    set_view_uniforms(*fraction_, input.view);
    fraction_->set("visibility_order", transfer.visibility()->order());
    const gl::IndependentDispatches of_ranges(*context_);
    for (const VertexRange& range : input.geometry.ranges) {
        const double width = transfer.lobe_width(range.material);
        auto lobe = lobes_.find(width);
        if (lobe == lobes_.end()) {
            const std::vector<float> constants =
                HighOrderVisibility(transfer.visibility()->order(), width).constants();
            lobe =
                lobes_
                    .try_emplace(width, context_, gl::BufferUse::storage, std::as_bytes(std::span(constants)))
                    .first;
        }
        for (const DeviceLight& seen : visibility_) {
            const std::size_t first = std::max(range.first, seen.first());
            const std::size_t last = std::min(range.last, seen.last());
            if (first >= last) continue;
            const std::size_t begin = gl::bind_vertices(*buffers.positions(), 0, 3, first, last);
            std::ignore = gl::bind_vertices(*buffers.normals(input.geometry), 1, 3, first, last);
            seen.bind(2, {.first = 0, .count = 1});
            lobe->second.bind_storage(3);
            std::ignore = gl::bind_vertices(*buffers.fractions(), 4, 2, first, last);
            fraction_->set("vertices", glm::ivec3(first - begin, first - seen.first(), last - first));
            fraction_->set("stride", static_cast<int>(seen.stride()));
            gl::dispatch(*fraction_, gl::groups_for(last - first));
        }
    }
}

void DeviceHighOrders::add(const HighOrderTransfer& transfer, const MaterialPtr& material, std::size_t first,
                           std::size_t last, const ShadeInput& input, const DevicePoints& points) {
    constexpr std::size_t step = std::size_t{1} << 20;
    textures_.update(transfer, input.channels);
    const HighOrderTextures::Part& part = textures_.part(material);
    for (std::size_t begin = first; begin < last; begin += step)
        run(part, begin, std::min(begin + step, last), input, points);
}

void DeviceHighOrders::run(const HighOrderTextures::Part& part, std::size_t first, std::size_t last,
                           const ShadeInput& input, const DevicePoints& points) {
    constexpr int group_of = Framebuffer::kGroup;
    for (int from = 0; from < input.channels; from += group_of) {
        const int channels = std::min(group_of, input.channels - from);
        gl::Program& program = this->program(channels, textures_.polarized(), points.fractions != nullptr);
        set_view_uniforms(program, input.view);
        const std::size_t begin = gl::bind_vertices(*points.positions, 0, 3, first, last);
        std::ignore = gl::bind_vertices(*points.normals, 1, 3, first, last);
        if (points.fractions != nullptr)
            std::ignore = gl::bind_vertices(*points.fractions, 2, 2, first, last);
        for (int c = 0; c < channels; ++c) {
            std::ignore = points.stokes->bind(static_cast<unsigned>(4 + c), {.first = from + c, .count = 1},
                                              first, last);
        }
        HighOrderTextures::bind(program, part, static_cast<std::size_t>(from / group_of));
        program.set("first", static_cast<int>(first - begin));
        program.set("count", static_cast<int>(last - first));
        program.set("to_light", glm::mat3(glm::transpose(input.light_to_geometry)));
        gl::dispatch(program, gl::groups_for(last - first));
    }
}

void DeviceHighOrders::copy_visibility(const HighOrderTransfer& transfer) {
    copying_.run(transfer.visibility().version(), [&] {
        visibility_.clear();
        lobes_.clear();
        if (transfer.visibility()->empty()) return;
        const VisibilityBlocks& all = *transfer.visibility();
        const std::size_t coefficients = psh_count(all.order());
        const std::size_t vertices = all.vertices();
        std::vector<float> one(coefficients);
        const std::size_t step = DeviceLight::most_vertices(*context_, coefficients);
        for (std::size_t first = 0; first < vertices; first += step) {
            visibility_.emplace_back(context_, first, std::min(step, vertices - first), coefficients, 1);
            visibility_.back().upload([&](std::size_t v, int /*channel*/) {
                all.expand(v, one);
                return std::span<const float>(one);
            });
        }
    });
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

}  // namespace nicol
