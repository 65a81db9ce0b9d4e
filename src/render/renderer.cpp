// SPDX-License-Identifier: MIT
#include "render/renderer.hpp"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "arguments.hpp"
#include "error.hpp"
#include "image/observer.hpp"
#include "render/reference_method.hpp"

namespace nicol {
namespace {

void check(const RenderOptions& options) {
    if (options.method == Method::reference) return;  // which checks its own
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
    if (!(options.dering >= 0 && std::isfinite(options.dering))) {
        refuse("dering is " + std::to_string(options.dering) + "; it must be finite and not negative");
    }
    if (!(options.tolerance >= 0 && std::isfinite(options.tolerance))) {
        refuse("tolerance is " + std::to_string(options.tolerance) + "; it must be finite and not negative");
    }
    if (options.components != 1 && options.components != 3 && options.components != 4) {
        refuse("components is " + std::to_string(options.components) + "; it must be 1, 3 or 4");
    }
    if ((options.disabled_optimisations & ~std::uint32_t{skip_all}) != 0) {
        refuse("disabled_optimisations is " + std::to_string(options.disabled_optimisations) +
               "; it must be a sum of skips");
    }
    if (options.tolerance > 0 &&
        (options.method != Method::factored || options.high_orders == HighOrders::convolution)) {
        refuse(
            "a tolerance is for the factored method with high orders split or left out: the error of others "
            "is not predicted");
    }
}

// All but the callback.
auto values(const RenderOptions& o) {
    return std::tie(o.method, o.executor, o.shadows, o.bake_directions, o.order_low, o.order_high,
                    o.high_orders, o.high_orders_at, o.high_order_shadows, o.tolerance, o.dering, o.physical,
                    o.components, o.planes, o.samples, o.seed, o.disabled_optimisations);
}

}  // namespace

Renderer::Renderer(std::shared_ptr<gl::Context> context, int threads)
    : context_(context),
      threads_(threads),
      transfer_(threads),
      buffers_(context),
      textures_(context),
      painter_(std::move(context)) {}

ComputeExecutor* Renderer::device_for(Executor executor) {
    if (executor == Executor::cpu) return nullptr;
    const std::string obstacle = ComputeExecutor::obstacle(*context_);
    if (executor == Executor::automatic && (context_->info().software || !obstacle.empty())) return nullptr;
    if (!obstacle.empty()) {
        throw Error(ErrorCode::unsupported, "the executor cannot be compute shaders: " + obstacle);
    }
    if (!device_) device_.emplace(context_, buffers_, textures_);
    return &*device_;
}

bool Renderer::holds(const Framebuffer& target, const Scene& scene, const Camera& camera,
                     const RenderOptions& options) const {
    return made_ && made_->content == target.content() && made_->geometry == scene.geometry_revision() &&
           made_->materials == scene.material_revision() && made_->light == scene.light_revision() &&
           made_->camera == camera && values(made_->options) == values(options);
}

void Renderer::render(const Scene& scene, const Camera& camera, const RenderOptions& options,
                      Framebuffer& target) {
    if (target.context() != context_) refuse("the framebuffer is of another context than the scene");
    const bool grey = target.channels() == 1 && scene.channels() == 3;
    if (target.channels() != scene.channels() && !grey) {
        refuse("the framebuffer has " + std::to_string(target.channels()) +
               " colour channels and the scene " + std::to_string(scene.channels()) +
               "; they must agree, or be 1 and 3 for the luminance");
    }
    check(options);
    memory_limit_.check(scene, options);
    if (!grey) return render_channels(scene, camera, options, target);

    // Lights and materials of three channels multiply before the luminance is taken, so the image is drawn in
    // three channels first.
    if (!colours_ || colours_->width() != target.width() || colours_->height() != target.height()) {
        colours_.reset();
        colours_ = std::make_unique<Framebuffer>(context_, target.width(), target.height(), 3);
    }
    render_channels(scene, camera, options, *colours_);
    const StokesImage& image = colours_->image();
    const Aovs& surfaces = colours_->surfaces();
    const Stopwatch watch;
    const Statistics statistics = colours_->statistics();
    target.show(luminance(image), statistics, surfaces);
    target.statistics().observe_ms = 0;
    target.statistics().draw_ms += statistics.observe_ms + watch.milliseconds();
}

void Renderer::render_channels(const Scene& scene, const Camera& camera, const RenderOptions& options,
                               Framebuffer& target) {
    if ((options.disabled_optimisations & skip_unchanged) == 0 && holds(target, scene, camera, options)) {
        Statistics& kept = target.statistics();
        for (double* ms : {&kept.project_ms, &kept.bake_ms, &kept.bake_trace_ms, &kept.relight_ms,
                           &kept.shade_ms, &kept.draw_ms, &kept.observe_ms, &kept.trace_ms}) {
            *ms = 0;
        }
        for (std::uint64_t* made : {&kept.bake_rays, &kept.lights_projected, &kept.materials_projected,
                                    &kept.vertices_traced, &kept.matrices_baked, &kept.vertices_relit,
                                    &kept.vertices_shaded, &kept.camera_rays, &kept.shadow_rays}) {
            *made = 0;
        }
        return;
    }
    if (options.method == Method::reference) {
        render_by_reference(scene, camera, options, threads_, target);
    } else {
        draw(scene, camera, options, target);
    }
    made_ = {.content = target.content(),
             .geometry = scene.geometry_revision(),
             .materials = scene.material_revision(),
             .light = scene.light_revision(),
             .camera = camera,
             .options = options};
    made_->options.progress = nullptr;
}

void Renderer::draw(const Scene& scene, const Camera& camera, const RenderOptions& options,
                    Framebuffer& target) {
    const Projection projection = project(camera, target.width(), target.height());
    Progress progress(options.progress);
    Statistics statistics;
    ComputeExecutor* const device = device_for(options.executor);
    if (device == nullptr) device_.reset();  // and with it all that only compute shaders work on
    RenderOptions chosen = options;
    if (chosen.high_orders_at == HighOrdersAt::automatic) {
        // Look-ups are dear where the processor rasterises.
        chosen.high_orders_at = context_->info().software ? HighOrdersAt::vertices : HighOrdersAt::pixels;
    }
    transfer_.update(scene, projection, chosen, device, progress, statistics);
    progress.report("draw", 0);

    const Stopwatch watch;
    context_->run([&] {
        const SceneGeometry& surfaces = transfer_.surfaces();
        buffers_.update(surfaces.geometry(), surfaces.revision(), target.channels());
        if (device == nullptr) buffers_.upload(transfer_.stokes());
        const HighOrderTransfer* const high_orders = transfer_.pixel_high_orders();
        if (high_orders != nullptr) {
            textures_.update(*high_orders, target.channels());
            if (device == nullptr) buffers_.upload(high_orders->fractions());
        }
        painter_.draw(scene, surfaces, buffers_,
                      {.textures = high_orders != nullptr ? &textures_ : nullptr,
                       .shadowed = high_orders != nullptr && !high_orders->visibility().empty(),
                       .physical = options.physical},
                      {.components = options.components, .planes = options.planes}, projection, target);
    });
    statistics.draw_ms = watch.milliseconds();

    const gl::MemoryUse memory = context_->memory();
    statistics.buffer_bytes = memory.of(gl::MemoryKind::vertex) + memory.of(gl::MemoryKind::index) +
                              memory.of(gl::MemoryKind::storage);
    statistics.texture_bytes = memory.of(gl::MemoryKind::texture) + memory.of(gl::MemoryKind::render_target);
    target.rendered(statistics);
}

}  // namespace nicol
