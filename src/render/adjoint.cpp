// SPDX-License-Identifier: MIT
// Renderer::adjoint(): gradients by what a picture is linear in.
#include <algorithm>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "devices/adjoint/adjoint_executor.hpp"
#include "draw/sample_pattern.hpp"
#include "material/reflectance.hpp"
#include "material/spatial_variation.hpp"
#include "render/check_options.hpp"
#include "render/renderer.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse_unsupported(const std::string& message) {
    throw Error(ErrorCode::unsupported, "the adjoint " + message);
}

// Throws Error(unsupported) for options whose picture is not linear in its light, or not the same each time.
void check_linear(const RenderOptions& options) {
    if (options.method != Method::factored) refuse_unsupported("needs the method factored");
    if (options.executor == Executor::compute) refuse_unsupported("runs on threads; set executor to cpu");
    if (options.physical)
        refuse_unsupported("needs a picture that is linear in its light; set physical to 0");
    if (options.choose_orders)
        refuse_unsupported("needs orders that do not depend on the light; set order_low and order_high");
    if (options.high_orders != HighOrders::none && options.order_high != options.order_low)
        refuse_unsupported("has no orders above order_low; set order_high to order_low");
    if (options.shade_at == ShadeAt::vertices)
        refuse_unsupported("needs light that is shaded at pixels; set shade_at to pixels");
    if (drawn_one_by_one(options.pixel_samples, options.filter))
        refuse_unsupported("needs 1, 4 or 8 pixel_samples and the box filter");
    if (options.bake_budget_ms > 0 || options.time_budget_ms > 0)
        refuse_unsupported("needs the final picture; set bake_budget_ms and time_budget_ms to 0");
}

[[noreturn]] void refuse_texture(const std::string& message) {
    refuse_unsupported("by texels " + message);
}

bool in_product(const Texture& texture, const TexturePtr& wanted) {
    const TextureDescription of = texture.describe();
    return of.kind == TextureDescription::Kind::product &&
           std::ranges::any_of(of.factors, [&](const TexturePtr& factor) {
               return factor == wanted || in_product(*factor, wanted);
           });
}

// Throws if what the scene's materials reflect is not a differentiable function of the texture.
void check_texture(const Scene& scene, const TexturePtr& wanted) {
    const TextureDescription::Kind kind = wanted->describe().kind;
    if (kind == TextureDescription::Kind::constant)
        refuse_texture(
            "needs texels that differ: materials take a texture of equal texels as a number; change one of "
            "them a little");
    if (kind != TextureDescription::Kind::image) refuse_texture("needs the texture of an image");
    const auto emitted = [&](const TexturePtr& texture) {
        return texture != nullptr && (texture == wanted || in_product(*texture, wanted));
    };
    if (std::ranges::any_of(scene.lights(), emitted, &LocalLight::texture))
        refuse_texture("has no texture that a local light projects; give the light a copy");
    bool used = false;
    for (const Instance& instance : scene.instances()) {
        if (instance.emission != nullptr && emitted(instance.emission->texture))
            refuse_texture("has no texture that surfaces emit; give the emission a copy");
        const SpatialVariation* const variation = instance.material->variation();
        if (variation == nullptr) continue;
        if (variation->opacity == wanted || variation->normal.texture == wanted ||
            variation->rotation.directions == wanted)
            refuse_texture("has no texture of an opacity, of normals or of directions; copy it for those");
        for (const MaterialLayer& layer : variation->layers)
            for (const LayerFactor& factor : layer.factors) {
                const TexturePtr& texture = variation->textures[factor.texture];
                if (in_product(*texture, wanted))
                    refuse_texture("has no texture that another one multiplies; multiply their images");
                if (texture != wanted) continue;
                if (factor.kind == LayerFactor::Kind::hat)
                    refuse_texture(
                        "has no texture of a roughness or another number between which materials "
                        "are interpolated; copy it for the colours");
                used = true;
            }
    }
    if (!used) refuse("gradients by a texture are wanted that no instance's material reflects by");
}

void check_scene(const Scene& scene, const RenderOptions& options, const WantedGradients& wanted) {
    if (!scene.elements().empty())
        refuse_unsupported(
            "has no polarization elements; remove them, or multiply the picture's gradient by "
            "the transposed Mueller matrix of one that covers the picture");
    if (wanted.environment && scene.distant_light() == nullptr)
        refuse(
            "the gradient by the environment is wanted, but the scene has no environment that gives light");
    if (wanted.environment && scene.background() != nullptr)
        refuse_unsupported("has no background; hide the emitters (nicol_scene_hide_emitters)");
    if (wanted.texture != nullptr) check_texture(scene, wanted.texture);
    if (!wanted.lights && !wanted.instances && wanted.texture == nullptr) return;
    if (options.max_depth > kDirectLightDepth)
        refuse_unsupported(
            "by lights, by instances and by texels has no light that bounces; set max_depth to 2");
    for (std::size_t k = 0; k < scene.lights().size(); ++k)
        if (std::ranges::all_of(scene.lights()[k].value, [](double value) { return value == 0; }))
            refuse("light " + std::to_string(scene.light_ids()[k]) +
                   " has the value 0, so that nothing samples it; give it a value above 0");
    const bool emits = std::ranges::any_of(
        scene.instances(), [](const Instance& instance) { return instance.emission != nullptr; });
    if (wanted.instances && emits)
        refuse_unsupported("by instances has no emissive surfaces; replace them by local lights");
}

// Returns the local lights of a scene. from_world: to the axes of the surfaces.
std::vector<AdjointLight> adjoint_lights(const Scene& scene, const glm::dmat4& from_world) {
    std::vector<AdjointLight> out;
    out.reserve(scene.lights().size());
    for (const LocalLight& light : scene.lights()) {
        std::vector<Stokes> stokes;
        stokes.reserve(static_cast<std::size_t>(scene.channels()));
        for (int c = 0; c < scene.channels(); ++c)
            stokes.push_back(of_channel(light.value, c) * light.state.stokes());
        out.push_back(
            {.source = unit_sources(light, scene.channels(), from_world), .stokes = std::move(stokes)});
    }
    return out;
}

// Returns the gradient by the environment from that by the light of the scale 1 and without a window.
PshVector by_environment(PshVector gradient, double scale, double dering) {
    for (double& number : gradient.data()) number *= scale;
    suppress_ringing(gradient, dering);
    return gradient;
}

// Adds the gradients of the ranges of each instance, which has two if it is two-sided.
std::vector<double> of_instances(const Scene& scene, const std::vector<VertexRange>& ranges,
                                 std::span<const double> of_ranges, int channels) {
    const auto planes = static_cast<std::size_t>(channels);
    std::vector<double> out(scene.ids().size() * planes);
    for (std::size_t r = 0; r < ranges.size(); ++r) {
        const auto instance = static_cast<std::size_t>(
            std::ranges::lower_bound(scene.ids(), ranges[r].instance) - scene.ids().begin());
        for (std::size_t c = 0; c < planes; ++c) out[instance * planes + c] += of_ranges[r * planes + c];
    }
    return out;
}

}  // namespace

Gradients Renderer::adjoint(const Scene& scene, const Camera& camera, const RenderOptions& given,
                            const StokesImage& picture, const WantedGradients& wanted) {
    if (picture.channels != scene.channels())
        refuse("the gradient of the picture has " + std::to_string(picture.channels) +
               " colour channels; the scene has " + std::to_string(scene.channels()));
    check(given, scene, picture.width, picture.height);
    check_linear(given);
    check_scene(scene, given, wanted);
    RenderOptions options = given;
    // Gradients are wanted by components that the light lacks, too.
    options.disabled_optimisations |= skip_light_components;
    memory_limit_.check(scene, options, picture.width, picture.height,
                        gradient_memory(scene, options, wanted.texture.get()));
    const Projection projection = project(camera, picture.width, picture.height);
    CommonBake common{.views = {projection}};
    Statistics statistics;
    Progress progress(options.progress);
    RenderRun run{.workers = workers_, .progress = progress, .statistics = statistics};
    const auto hits = [&](bool /*on_host*/) -> const VisibilityBuffer& {
        find_hits(projection, options, VisibilityBuffer::Kept::on_host,
                  {picture.width, picture.height, picture.channels}, statistics);
        return hits_;
    };
    Gradients out;
    workers_.run([&] {
        bake(scene, options, common);
        std::vector<AdjointLight> lights;
        if (wanted.lights || wanted.instances)
            lights = adjoint_lights(scene, inverse_motion(pipeline_.surfaces().to_world()));
        AdjointExecutor executor(picture, std::move(lights), wanted.texture);
        pipeline_.run(scene, projection, options, executor, run, hits, false);
        LightGradients gradients = executor.take_gradients();
        if (wanted.environment)
            out.environment = by_environment(gradients.distant, scene.light_scale(), options.dering);
        if (wanted.lights) out.lights = std::move(gradients.lights);
        if (wanted.texture != nullptr) out.texels = std::move(gradients.texels);
        if (wanted.instances)
            out.instances = of_instances(scene, pipeline_.surfaces().geometry().ranges, gradients.reflection,
                                         picture.channels);
    });
    return out;
}

}  // namespace nicol
