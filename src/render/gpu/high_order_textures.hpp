// SPDX-License-Identifier: MIT
// Filtered light and the materials' factors as textures.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "render/high_orders.hpp"

namespace nicol {

/// What glsl/high_order.glsl looks up. All members inside run() of the context.
class HighOrderTextures {
public:
    using Textures = std::vector<gl::Texture2D>;  ///< by group of Framebuffer::kGroup channels

    struct Part {
        Textures factors;
        const Textures* central;
        const Textures* outer;
        const Textures* base;
        float spread;
        bool has_base;
    };

    explicit HighOrderTextures(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies an image's channels of the maps and factors, as far as changes make it necessary.
    void update(const HighOrderTransfer& transfer, int channels);

    /// Of a material that the last update() saw.
    [[nodiscard]] const Part& part(const MaterialPtr& material) const { return parts_.at(material); }
    /// Whether programs need HIGH_ORDER_POLARIZED.
    [[nodiscard]] bool polarized() const noexcept { return polarized_; }

    /// Binds a part to texture units 0 to 3 of a program, with its uniforms but to_light.
    static void bind(gl::Program& program, const Part& part, std::size_t group);

private:
    void copy(const HighOrderTransfer& transfer, int channels);
    const Textures* textures(const LobeMap* map, int channels);

    std::shared_ptr<gl::Context> context_;
    std::map<const LobeMap*, Textures> maps_;
    std::map<MaterialPtr, Part> parts_;
    Stage<Version, int> copying_;  // parts, channels
    bool polarized_ = false;
};

}  // namespace nicol
