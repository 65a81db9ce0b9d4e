// SPDX-License-Identifier: MIT
// The paper's scene: a Buddha of measured gold on a plane, lit by the polarized sponza.
#pragma once

#include <string>

#include "common/handles.hpp"
#include "options.hpp"

/// Throws Failure where a file of the data is absent from the folder.
void require_data(const std::filesystem::path& folder);

/// The two views of figure 22.
enum class View { front, side };

/// What a render takes over from the library's defaults, and what not.
struct Recipe {
    nicol_method method = NICOL_METHOD_FACTORED;
    std::uint32_t order_low = 4;
    std::uint32_t order_high = 9;
    bool shadows = true;
    nicol_high_orders high_orders = NICOL_HIGH_ORDERS_SPLIT;
    bool physical = false;
    std::uint32_t samples = 256;
    std::uint64_t seed = 0;
};

class Stage {
public:
    /// Throws std::runtime_error for what the library refuses.
    explicit Stage(const Options& options);

    /// Of the same objects, materials and light; keeps its own work between renders.
    [[nodiscard]] Scene make_scene() const;
    /// For the reference method, which looks light up often: lit by an image of the light, which is written
    /// to this file and moved into the physically realizable range.
    [[nodiscard]] Scene make_reference_scene(const std::string& image) const;
    /// Black objects before white light.
    [[nodiscard]] Scene make_mask_scene() const;
    [[nodiscard]] Framebuffer make_framebuffer() const;
    /// The light of a scene of make_scene(), rotated about the vertical.
    void rotate_light(nicol_scene scene, double degrees) const;
    void render(nicol_scene scene, View view, const Recipe& recipe, nicol_framebuffer target) const;
    /// From somewhat beside `view`: for frames in which the camera moves.
    void render(nicol_scene scene, View view, double degrees_beside, const Recipe& recipe,
                nicol_framebuffer target) const;

    /// Stokes components that the light has: 3, or 4 with s3.
    [[nodiscard]] unsigned components() const noexcept { return components_; }
    /// OpenGL's renderer and the number of threads.
    [[nodiscard]] std::string machine() const;

private:
    [[nodiscard]] Scene assemble(nicol_material buddha, nicol_material plane, nicol_environment light) const;

    std::filesystem::path data_;
    std::uint32_t size_;
    std::uint32_t bake_directions_;
    Context context_;
    Environment light_;
    Material gold_, plastic_;
    Mesh buddha_, plane_;
    unsigned components_ = 3;
};
