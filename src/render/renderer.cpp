// SPDX-License-Identifier: MIT
#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "draw/sample_pattern.hpp"
#include "image/observer.hpp"
#include "progress.hpp"
#include "reference/render_reference.hpp"
#include "render/check_options.hpp"
#include "render/filtered_image.hpp"
#include "render/wanted_executor.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

// Returns the options that the method uses, and defaults of the others, whose change makes no other image.
RenderOptions used(const RenderOptions& options) {
    RenderOptions out = options;
    out.progress = nullptr;
    if (options.method == Method::reference) {
        out = {};
        out.method = options.method;
        out.shadows = options.shadows;
        out.aovs = options.aovs;
        out.filter = options.filter;
        out.samples = options.samples;
        out.max_depth = options.max_depth;
        out.seed = options.seed;
    } else {
        out.samples = RenderOptions{}.samples;
        // Compared apart, because not all pictures take samples.
        out.seed = 0;
        out.light_samples = RenderOptions{}.light_samples;
    }
    return out;
}

// Part of the square of a sample over which textures are averaged. The mean over the samples averages them a
// second time, which blurs; nearly nothing is left between the squares by the samples' places. Measured.
constexpr double kTextureShare = 0.5;

// Returns whether threads shade the samples of pixels and nothing else. A time budget may take other samples.
// Cameras of one sample a pixel are moved within it from image to image, and need all that each may show.
bool shades_samples(const RenderOptions& options) {
    return options.shade_at != ShadeAt::vertices && options.pixel_samples > 1 && options.time_budget_ms == 0;
}

// Returns whether the framebuffer receives the luminance of the scene.
bool is_grey_of(const Scene& scene, const Framebuffer& target) {
    return target.channels() == 1 && scene.channels() == 3;
}

std::uint64_t texture_bytes(const gl::Context& context) {
    const gl::MemoryUse memory = context.memory();
    return memory.of(gl::MemoryKind::texture) + memory.of(gl::MemoryKind::render_target);
}

std::int64_t pixels(const View& view) {
    return std::int64_t{view.target->width()} * view.target->height();
}

}  // namespace

Renderer::Renderer(std::shared_ptr<gl::Context> context, WorkerOptions workers)
    : context_(context),
      worker_options_(std::move(workers)),
      workers_(worker_options_),
      buffers_(context),
      alpha_masks_(context_),
      hits_(context),
      drawn_hits_(context, buffers_, alpha_masks_),
      traced_hits_(workers_, pipeline_.drawn_rays()),
      painter_(context),
      elements_(std::move(context)) {}

RenderExecutor& Renderer::executor_for(const Scene& scene, const RenderOptions& options) {
    const Device& device = device_for(wanted_executor(scene, options), *context_);
    if (executor_ == nullptr || device_ != &device) {
        executor_.reset();  // frees the data of the former executor as well
        executor_ = device.make(context_, buffers_);
        device_ = &device;
    }
    return *executor_;
}

Statistics Renderer::render(const Scene& scene, const Camera& camera, const RenderOptions& options,
                            Framebuffer& target) {
    const View view{.camera = camera, .target = &target};
    return render(scene, {&view, 1}, options).front();
}

std::vector<Statistics> Renderer::render(const Scene& scene, std::span<const View> views,
                                         const RenderOptions& options) {
    CommonBake common;
    for (const View& view : views) {
        const Framebuffer& target = *view.target;
        if (target.context() != context_) refuse("the framebuffer is of another context than the scene");
        if (target.channels() != scene.channels() && !is_grey_of(scene, target)) {
            refuse("the framebuffer has " + std::to_string(target.channels()) +
                   " colour channels and the scene " + std::to_string(scene.channels()) +
                   "; give it those of nicol_scene_get_channels(), or one for the luminance of three");
        }
        check(options, scene, target.width(), target.height());
        common.views.push_back(project(view.camera, target.width(), target.height()));
    }
    const Framebuffer& largest = *std::ranges::max_element(views, {}, pixels)->target;
    memory_limit_.check(scene, options, largest.width(), largest.height());
    std::vector<Statistics> statistics;
    for (const View& view : views) {
        const bool grey = is_grey_of(scene, *view.target) && options.method != Method::reference;
        statistics.push_back(grey ? render_grey(scene, view.camera, options, *view.target, common)
                                  : render_into(scene, view.camera, options, *view.target, common));
    }
    if (options.method != Method::reference) memory_limit_.keep(statistics.back());
    memory_limit_.settle();
    return statistics;
}

Statistics Renderer::render_grey(const Scene& scene, const Camera& camera, const RenderOptions& options,
                                 Framebuffer& target, CommonBake& common) {
    // Lights and materials of three channels multiply before the luminance is taken, so the image is drawn in
    // three channels first.
    if (!colours_ || colours_->width() != target.width() || colours_->height() != target.height()) {
        colours_.reset();
        colours_ = std::make_unique<Framebuffer>(context_, target.width(), target.height(), 3);
    }
    render_into(scene, camera, options, *colours_, common);
    const Stopwatch watch;
    StokesImage grey_image = luminance(colours_->image());
    const Aovs& aovs = colours_->aovs();
    const Statistics statistics = colours_->statistics();
    const std::lock_guard lock(target.mutex());
    target.show(std::move(grey_image), statistics, aovs);
    target.statistics().observe_ms = 0;
    target.statistics().draw_ms += watch.milliseconds();
    return target.statistics();
}

Statistics Renderer::render_into(const Scene& scene, const Camera& camera, const RenderOptions& options,
                                 Framebuffer& target, CommonBake& common) {
    const auto content = [&target] {
        const std::lock_guard lock(target.mutex());
        return target.content();
    };
    const bool realtime = options.method != Method::reference;
    const std::pair sampling{options.seed, options.light_samples};
    if ((options.disabled_optimisations & skip_unchanged) != 0 || content_ != content() ||
        (realtime && (pipeline_.pending() > 0 || (pipeline_.sampled() && sampling != sampling_)))) {
        rendering_.reset();
    }
    RenderWork baking;
    const bool rendered = rendering_.run(
        scene.geometry_version(), scene.material_version(), scene.light_version(), scene.emission_version(),
        scene.local_light_version(), scene.element_version(), camera, used(options), [&] {
            const Projection projection = project(camera, target.width(), target.height());
            if (!realtime) return trace(scene, projection, options, target);
            sampling_ = sampling;
            workers_.run([&] {
                baking = bake(scene, options, common);
                draw_within_budget(scene, projection, options, target);
            });
        });
    const std::lock_guard lock(target.mutex());
    if (!rendered) target.statistics().nothing_ran();
    target.statistics() += baking;
    return target.statistics();
}

RenderWork Renderer::bake(const Scene& scene, const RenderOptions& options, CommonBake& common) {
    Statistics statistics;
    if (std::exchange(common.done, true)) return statistics;
    Progress progress(options.progress);
    RenderOptions within_limit = options;
    within_limit.max_vertices = memory_limit_.max_vertices(options);
    RenderRun run{.workers = workers_, .progress = progress, .statistics = statistics};
    std::vector<glm::dvec2> samples;
    if (shades_samples(options) && executor_for(scene, options).reads_hits_on_host())
        samples = sample_places(options.pixel_samples, options.filter);
    pipeline_.bake(scene, common.views, samples, within_limit, run);
    memory_limit_.refined(pipeline_.surfaces().geometry().positions.size());
    return statistics;
}

void Renderer::draw_within_budget(const Scene& scene, const Projection& projection,
                                  const RenderOptions& options, Framebuffer& target) {
    const bool can_shade_vertices = !scene.varies() && !scene.transmits();
    const RenderOptions afforded = budget_.afford(options, can_shade_vertices);
    const int given_up = budget_.steps();
    const Stopwatch watch;
    if (drawn_one_by_one(afforded.pixel_samples, afforded.filter)) {
        draw_one_by_one(scene, projection, afforded, target);
    } else {
        draw(scene, projection, afforded, target);
    }
    const double whole = watch.milliseconds();
    const std::lock_guard lock(target.mutex());
    Statistics& statistics = target.statistics();
    statistics.given_up = given_up;
    statistics.pixel_samples = afforded.pixel_samples;
    statistics.light_samples = afforded.light_samples;
    statistics.bsdf_samples = afforded.bsdf_samples;
    statistics.order_tolerance = afforded.choose_orders ? afforded.tolerance * afforded.order_slack : 0;
    const double focus = statistics.focus_ms;
    budget_.spend({.whole = whole - statistics.project_ms - statistics.bake_ms - focus,
                   .relight = statistics.relight_ms,
                   .shade = statistics.shade_ms - focus,
                   .lights = statistics.light_ms - focus,
                   .at_pixels = pipeline_.shaded_pixels()});
}

Framebuffer& Renderer::spare_of(const Framebuffer& target) {
    if (!spare_ || spare_->width() != target.width() || spare_->height() != target.height() ||
        spare_->channels() != target.channels()) {
        spare_.reset();
        spare_ = std::make_unique<Framebuffer>(context_, target.width(), target.height(), target.channels());
    }
    return *spare_;
}

void Renderer::put(Framebuffer& target, const std::function<void()>& draw) {
    const std::lock_guard lock(target.mutex());
    draw();
    content_ = target.content();
}

void Renderer::put(Framebuffer& target, StokesImage image, const Statistics& statistics, Aovs aovs) {
    put(target, [&] {
        const Stopwatch watch;
        target.show(std::move(image), statistics, std::move(aovs));
        target.statistics().draw_ms += watch.milliseconds();
    });
}

void Renderer::trace(const Scene& scene, const Projection& projection, const RenderOptions& options,
                     Framebuffer& target) {
    ReferenceStatistics traced;
    Aovs aovs;
    StokesImage image = render_reference(scene, projection, target.width(), target.height(),
                                         {.samples = options.samples,
                                          .max_depth = options.max_depth,
                                          .shadows = options.shadows,
                                          .luminance = target.channels() < scene.channels(),
                                          .seed = options.seed,
                                          .filter = options.filter,
                                          .workers = worker_options_,
                                          .aovs = options.aovs,
                                          .progress = options.progress},
                                         traced, Strategy::both, &aovs);
    Statistics statistics;
    for (const Instance& instance : scene.instances()) statistics.vertices += instance.mesh->positions.size();
    statistics.triangles = traced.triangles;
    statistics.bake_ms = traced.build_ms;
    statistics.trace_ms = traced.trace_ms;
    statistics.camera_rays = traced.camera_rays;
    statistics.shadow_rays = traced.shadow_rays;
    statistics.texture_bytes = texture_bytes(*context_);
    put(target, std::move(image), statistics, std::move(aovs));
}

void Renderer::draw_one_by_one(const Scene& scene, const Projection& projection, const RenderOptions& options,
                               Framebuffer& target) {
    Framebuffer& sample = spare_of(target);
    FilteredImage filtered(options.filter, target.width(), target.height(), target.channels());
    Statistics statistics;
    std::uint64_t unphysical = 0;
    Aovs aovs;
    RenderOptions one = options;
    one.progress = nullptr;
    if (options.aovs != 0) {
        one.pixel_samples = static_cast<int>(samples_at_once(options.pixel_samples));
        draw(scene, projection, one, sample);
        aovs = sample.aovs();
        statistics = sample.statistics();
        one.aovs = 0;
    }
    one.pixel_samples = 1;
    Projection sharp = projection;
    sharp.sample_size = 1 / std::sqrt(options.pixel_samples);
    sharp.texture_size = kTextureShare * sharp.sample_size;
    Progress progress(options.progress);
    for (int s = 0; s < options.pixel_samples; ++s) {
        progress.report("draw", static_cast<double>(s) / options.pixel_samples);
        one.seed = options.seed + static_cast<std::uint64_t>(s);
        const glm::dvec2 place = sample_place(s, options.pixel_samples);
        draw(scene, jittered(sharp, place), one, sample);
        const StokesImage& image = sample.image();
        workers_.run([&] { filtered.add(image, place); });
        // Vertices may be shaded for the first sample alone.
        unphysical += sample.statistics().vertices_unphysical;
        statistics.add(sample.statistics());
    }
    statistics.vertices_unphysical = unphysical;
    put(target, std::move(filtered).mean(), statistics, std::move(aovs));
}

void Renderer::draw(const Scene& scene, const Projection& projection, const RenderOptions& options,
                    Framebuffer& target) {
    Progress progress(options.progress);
    Statistics statistics;
    RenderExecutor& executor = executor_for(scene, options);
    statistics.compute = device_->executor == Executor::compute;
    RenderOptions chosen = options;
    const bool elements = !scene.elements().empty();
    if (elements) chosen.components = 4;  // elements may turn any component into any other
    RenderRun run{.workers = workers_,
                  .progress = progress,
                  .statistics = statistics,
                  .memory_limit = memory_limit_.for_scene(),
                  .saves_memory = memory_limit_.saves()};
    const auto draw_hits = [&](VisibilityBuffer::Kept kept) {
        find_hits(projection, options, kept, {target.width(), target.height(), target.channels()},
                  statistics);
    };
    const auto hits_for_shading = [&](bool on_host) -> const VisibilityBuffer& {
        const bool host = on_host || executor.reads_hits_on_host();
        const bool device = elements || !executor.reads_hits_on_host();
        draw_hits(!device ? VisibilityBuffer::Kept::on_host
                  : host  ? VisibilityBuffer::Kept::on_both
                          : VisibilityBuffer::Kept::on_device);
        return hits_;
    };
    // A software driver takes longer to interpolate than threads, which need to know the triangles alone.
    const gl::ContextInfo& info = context_->info();
    pipeline_.run(scene, projection, chosen, executor, run, hits_for_shading, info.software);
    progress.report("draw", 0);

    // Steps of the context, so that other calls need not wait for all of them.
    const Stopwatch preparing;
    const RefinedSurfaces& surfaces = pipeline_.surfaces();
    const bool made = pipeline_.made_image();
    // A host reads its textures, and elements are drawn over the image.
    const bool in_host = info.backend == gl::Backend::host;
    StokesImage* const image_made = made && !elements && !in_host ? executor.image() : nullptr;
    update_buffers(surfaces, target.channels());
    if (!made) {
        if (elements)
            draw_hits(VisibilityBuffer::Kept::on_device);
        else
            clear_hits();
        context_->run([&] { executor.store(buffers_); });
    }
    const Painter::Subject subject{.scene = scene,
                                   .surfaces = surfaces,
                                   .buffers = buffers_,
                                   .alpha_masks = alpha_masks_,
                                   .pixels = made ? &executor : nullptr,
                                   .in_memory = image_made != nullptr,
                                   .projection = projection};
    const Painter::Wanted wanted{.components = chosen.components,
                                 .aovs = options.aovs,
                                 .samples = sample_pattern(options.pixel_samples)};
    painter_.prepare(subject, wanted, target);
    if (elements)
        context_->run([&] { elements_.prepare(scene, surfaces, projection, options.pixel_samples, target); });
    statistics.draw_ms += preparing.milliseconds();
    const auto draw_into = [&](Framebuffer& image) {
        const Stopwatch watch;
        painter_.draw(subject, wanted, image);
        if (elements) {
            context_->run([&] {
                elements_.draw(buffers_, hits_, options.components, image);
                gl::finish(*context_);
            });
        }
        statistics.draw_ms += watch.milliseconds();
        if (made) statistics.transfer_bytes += hits_.bytes();
        const gl::MemoryUse memory = context_->memory();
        statistics.buffer_bytes = memory.of(gl::MemoryKind::vertex) + memory.of(gl::MemoryKind::index) +
                                  memory.of(gl::MemoryKind::storage);
        statistics.texture_bytes = texture_bytes(*context_);
        if (image_made != nullptr)
            image.rendered(*image_made, statistics);
        else
            image.rendered(statistics);
    };
    // A host keeps the names of its framebuffers' textures, so its images are drawn where they are. Nobody
    // else reads a framebuffer of the renderer's own.
    if (in_host || &target == colours_.get() || &target == spare_.get()) {
        put(target, [&] { draw_into(target); });
    } else {
        Framebuffer& image = spare_of(target);
        draw_into(image);
        put(target, [&] { target.exchange(image); });
        // Frees AOVs that the picture before had and this one has not.
        if (options.aovs == 0 && image.aov_mask() != 0) {
            context_->run([&] { image.drew_aovs(0, 0, nullptr); });
            const std::lock_guard lock(target.mutex());
            target.statistics().texture_bytes = texture_bytes(*context_);
        }
    }
}

}  // namespace nicol
