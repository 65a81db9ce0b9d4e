// SPDX-License-Identifier: MIT
#include "asset_bytes.hpp"

#include <span>
#include <unordered_set>

#include "material/spatial_variation.hpp"

namespace nicol::capi {
namespace {

/// Calls add(texture) for each texture of a material, null ones included.
template <class Add>
void visit_textures(const SpatialVariation& variation, const Add& add) {
    for (const TexturePtr& texture : variation.textures) add(texture.get());
    add(variation.normal.texture.get());
    add(variation.rotation.directions.get());
    add(variation.opacity.get());
}

}  // namespace

std::uint64_t bytes_of(const Mesh& mesh) {
    const auto size = [](const auto&... arrays) {
        return (std::uint64_t{0} + ... + std::span(arrays).size_bytes());
    };
    return size(mesh.positions, mesh.normals, mesh.triangles, mesh.colors, mesh.face_colors, mesh.texcoords,
                mesh.texcoord_triangles, mesh.tangents);
}

std::uint64_t bytes_of(const Texture& texture) {
    std::uint64_t bytes = 0;
    for (const TextureImage& level : texture.describe().levels) bytes += level.values.size() * sizeof(float);
    return bytes;
}

std::uint64_t bytes_of(const Environment& environment) {
    const EquirectView pixels = environment.pixels();
    if (pixels.values == nullptr) return 0;
    return static_cast<std::uint64_t>(pixels.width) * static_cast<std::uint64_t>(pixels.height) *
           static_cast<std::uint64_t>(pixels.channels) * static_cast<std::uint64_t>(pixels.components) *
           sizeof(float);
}

std::uint64_t bytes_of(const Material& material) {
    return material.bytes();
}

std::uint64_t bytes_of(const Scene& scene) {
    std::unordered_set<const void*> counted;
    std::uint64_t bytes = 0;
    const auto add = [&](const auto* asset) {
        if (asset != nullptr && counted.insert(asset).second) bytes += bytes_of(*asset);
    };
    for (const Instance& instance : scene.instances()) {
        add(instance.mesh.get());
        add(instance.material.get());
        if (const SpatialVariation* const variation = instance.material->variation(); variation != nullptr)
            visit_textures(*variation, add);
    }
    add(scene.environment().get());
    return bytes;
}

}  // namespace nicol::capi
