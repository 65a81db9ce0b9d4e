// SPDX-License-Identifier: MIT
// The paper's scene: a Buddha of measured gold on a plane, lit by the polarized sponza.
#pragma once

#include <string>

#include "common/handles.hpp"
#include "options.hpp"

/// Throws Failure if a file of the data is absent from the folder.
void require_data(const std::filesystem::path& folder);

/// Returns the path of the light's coefficients in a folder of the data.
[[nodiscard]] std::filesystem::path light_file(const std::filesystem::path& folder);

/// The two views of figure 22.
enum class View { front, side };

/// Options of a render that differ between steps.
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
    /// Loads the scene's parts. Throws std::runtime_error for anything that the library refuses.
    explicit Stage(const Options& options);

    /// Makes a scene of the common objects, materials and light; it keeps its work between renders.
    [[nodiscard]] Scene make_scene() const;
    /// Makes a scene for the reference method, which looks light up often: the light is an image, written to
    /// this file and moved into the physically realizable range.
    [[nodiscard]] Scene make_reference_scene(const std::string& image) const;
    /// Makes a scene of black objects before white light.
    [[nodiscard]] Scene make_mask_scene() const;
    [[nodiscard]] Framebuffer make_framebuffer() const;
    /// Rotates the light of a scene of make_scene() about the vertical.
    void rotate_light(nicol_scene scene, double degrees) const;
    void render(nicol_scene scene, View view, const Recipe& recipe, nicol_framebuffer target) const;
    /// Renders from beside `view`, for frames with a moved camera.
    void render(nicol_scene scene, View view, double degrees_beside, const Recipe& recipe,
                nicol_framebuffer target) const;

    /// Returns the Stokes components of the light: 3, or 4 with s3.
    [[nodiscard]] unsigned components() const noexcept { return components_; }
    /// Returns OpenGL's renderer and the number of threads.
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
