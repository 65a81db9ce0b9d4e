// SPDX-License-Identifier: MIT
#include "render/check_options.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include "arguments.hpp"
#include "draw/sample_pattern.hpp"
#include "error.hpp"
#include "scene/path_depth.hpp"
#include "visibility/visibility_directions.hpp"

namespace nicol {
namespace {

std::string depth_text(int max_depth) {
    return max_depth == kUnlimitedDepth ? "unlimited" : std::to_string(max_depth);
}

void check_not_negative(const char* name, double value) {
    if (!(value >= 0 && std::isfinite(value)))
        refuse(name + (" is " + std::to_string(value)) + "; it must be finite and not negative");
}

void check_ranges(const RenderOptions& options) {
    check(options.filter, "filter.");
    if (options.method == Method::reference) return;  // the reference method checks its own options
    if (options.order_low < 0 || options.order_low > kMaxRenderOrder) {
        refuse("order_low is " + std::to_string(options.order_low) + "; it must lie in 0 to " +
               std::to_string(kMaxRenderOrder));
    }
    if (options.order_high < options.order_low || options.order_high > 64) {
        refuse("order_high is " + std::to_string(options.order_high) + "; it must lie in order_low (" +
               std::to_string(options.order_low) + ") to 64");
    }
    if (options.bake_directions < DirectionSet::kFewest || options.bake_directions > DirectionSet::kMost) {
        refuse("bake_directions is " + std::to_string(options.bake_directions) + "; it must lie in " +
               std::to_string(DirectionSet::kFewest) + " to " + std::to_string(DirectionSet::kMost));
    }
    if (!(options.refine_tolerance >= 0 && options.refine_tolerance <= 1)) {
        refuse("refine_tolerance is " + std::to_string(options.refine_tolerance) + "; it must lie in 0 to 1");
    }
    check_not_negative("bake_budget_ms", options.bake_budget_ms);
    check_not_negative("time_budget_ms", options.time_budget_ms);
    check_not_negative("dering", options.dering);
    check_not_negative("tolerance", options.tolerance);
    if (options.split_lights < kSplitAutomatic || options.split_lights > kMaxSplitLights) {
        refuse("split_lights is " + std::to_string(options.split_lights) + "; it must lie in 0 to " +
               std::to_string(kMaxSplitLights) + ", or be " + std::to_string(kSplitAutomatic) +
               ", automatic");
    }
    if (options.light_samples < 1 || options.light_samples > kMaxLightSamples) {
        refuse("light_samples is " + std::to_string(options.light_samples) + "; it must lie in 1 to " +
               std::to_string(kMaxLightSamples));
    }
    if (options.bsdf_samples < 0 || options.bsdf_samples > kMaxBsdfSamples) {
        refuse("bsdf_samples is " + std::to_string(options.bsdf_samples) + "; it must lie in 0 to " +
               std::to_string(kMaxBsdfSamples));
    }
    if (options.max_depth < kDirectLightDepth ||
        (options.max_depth > kDirectLightDepth && options.method == Method::dense)) {
        throw Error(ErrorCode::unsupported, "max_depth is " + depth_text(options.max_depth) +
                                                (options.method == Method::dense
                                                     ? ", but the dense method computes direct light alone"
                                                     : ", which only the reference method follows") +
                                                "; set method to reference, or max_depth to 2, direct light");
    }
    if (options.max_depth > kDirectLightDepth && !options.shadows) {
        refuse(
            "shadows is off, but max_depth is more than 2: surfaces that light passes do not reflect it to "
            "each other; turn shadows on or set max_depth to 2");
    }
    if ((options.aovs & aov_variance) != 0) {
        refuse("aovs asks for the variance, which the reference method alone makes: others have no noise");
    }
    if (options.components != 1 && options.components != 3 && options.components != 4) {
        refuse("components is " + std::to_string(options.components) + "; it must be 1, 3 or 4");
    }
    if (options.pixel_samples < 1 || options.pixel_samples > kMostDrawnSamples) {
        refuse("pixel_samples is " + std::to_string(options.pixel_samples) + "; it must lie in 1 to " +
               std::to_string(kMostDrawnSamples));
    }
    if ((options.disabled_optimisations & ~std::uint32_t{skip_all}) != 0) {
        refuse("disabled_optimisations is " + std::to_string(options.disabled_optimisations) +
               "; it must be a sum of skips");
    }
}

// Throws Error(unsupported) if the options do not allow a textured material.
void check_varying(const RenderOptions& options) {
    const auto refuse_unsupported = [](const std::string& message) {
        throw Error(ErrorCode::unsupported, "a material of the scene varies by a texture: " + message);
    };
    if (options.method == Method::reference) return;
    if (options.shade_at == ShadeAt::vertices)
        refuse_unsupported("textures are shaded at pixels; set shade_at to automatic or pixels");
    if (options.method == Method::dense)
        refuse_unsupported("the dense method has no textures; set method to factored or reference");
}

// Throws Error(unsupported) if the options do not allow a material that light passes.
void check_transmitting(const RenderOptions& options) {
    const auto refuse_unsupported = [](const std::string& message) {
        throw Error(
            ErrorCode::unsupported,
            "a material of the scene is glass that light passes (dielectric or thindielectric): " + message);
    };
    if (options.method == Method::dense)
        refuse_unsupported("the dense method follows no rays; set method to factored or reference");
    if (options.method == Method::factored && options.shade_at == ShadeAt::vertices)
        refuse_unsupported("rays begin at pixels; set shade_at to automatic or pixels");
}

// Throws if the image has too many samples for the visibility buffer, which shading at pixels and elements
// need.
void check_size(const Scene& scene, const RenderOptions& options, int width, int height) {
    constexpr std::uint64_t most = std::uint64_t{1} << 27;
    if (options.method == Method::reference) return;
    if (options.shade_at == ShadeAt::vertices && scene.elements().empty()) return;
    const std::uint64_t samples = std::uint64_t{samples_at_once(options.pixel_samples)} *
                                  static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (samples <= most) return;
    refuse("pixel_samples is " + std::to_string(options.pixel_samples) + ": " + std::to_string(samples) +
           " samples of " + std::to_string(width) + " x " + std::to_string(height) +
           " pixels are more than the " + std::to_string(most) +
           " that shading at pixels and polarization elements can keep");
}

}  // namespace

void check(const RenderOptions& options, const Scene& scene, int width, int height) {
    check_ranges(options);
    if (scene.varies()) check_varying(options);
    if (scene.transmits()) check_transmitting(options);
    check_size(scene, options, width, height);
}

}  // namespace nicol
