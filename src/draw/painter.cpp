// SPDX-License-Identifier: MIT
#include "draw/painter.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <utility>

#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

int group_size(int channels, std::size_t group) {
    return std::min(Framebuffer::kGroup, channels - static_cast<int>(group) * Framebuffer::kGroup);
}

gl::TextureDescription equirect(const EquirectImage& image) {
    return {.width = image.width,
            .height = image.height,
            .filter = gl::Filter::linear,
            .wrap_x = gl::Wrap::repeat,
            .wrap_y = gl::Wrap::clamp};
}

// Clears the depth alone if a background of all components covers all pixels without surfaces, else
// everything.
void clear(gl::RenderTarget& image, bool background, int components) {
    if (background && components == 4) {
        image.clear_depth();
    } else {
        image.clear();
    }
}

// Returns whether the painter draws the background, which an executor may have added to its pixels.
bool draws_background(const Scene& scene, const RenderExecutor* pixels) {
    return scene.background() != nullptr && !(pixels != nullptr && pixels->adds_background());
}

}  // namespace

Painter::Painter(std::shared_ptr<gl::Context> context)
    : context_(std::move(context)), pixels_(context_), aovs_(context_) {}

void Painter::prepare(const Subject& subject, const Wanted& wanted, const Framebuffer& target) {
    const Scene& scene = subject.scene;
    const int channels = target.channels();
    const auto count = static_cast<std::size_t>((channels + Framebuffer::kGroup - 1) / Framebuffer::kGroup);
    if (groups_.size() != count) uploading_.reset();
    groups_.resize(count);
    if (draws_background(scene, subject.pixels))
        uploading_.run(scene.background(), channels,
                       [&] { upload_environment(*scene.background(), channels); });
    const bool vertices = subject.pixels == nullptr;
    context_->run([&] {
        binding_.run(subject.buffers.version(), channels, [&] { bind_vertices(subject.buffers, channels); });
        prepare_sample(vertices && wanted.samples.size() > 1, target);
    });
    for (std::size_t g = 0; g < count; ++g) compile(subject, wanted, g, group_size(channels, g));
}

void Painter::compile(const Subject& subject, const Wanted& wanted, std::size_t group, int channels) {
    const Scene& scene = subject.scene;
    const bool background = draws_background(scene, subject.pixels);
    if (subject.pixels != nullptr) {
        if (background) static_cast<void>(background_program(scene, true, channels));
        return;
    }
    if (sample_) static_cast<void>(program("fullscreen.vert", "mean.frag", channels, {}));
    const bool polarized = background && scene.background()->polarized();
    if (!compiled_.emplace(channels, wanted.components, background, polarized).second) return;
    // Software drivers compile most of a program when it first draws into such an image.
    std::optional<gl::RenderTarget> pixel;
    context_->run([&] {
        pixel.emplace(context_, gl::RenderTargetDescription{.width = 1, .height = 1, .colours = channels});
    });
    draw_vertices(subject, wanted.components, subject.projection, group, channels, 1, *pixel);
}

void Painter::draw(const Subject& subject, const Wanted& wanted, Framebuffer& target) {
    context_->run([&] {
        aovs_.prepare(subject.surfaces.geometry(), subject.buffers, subject.alpha_masks, wanted.aovs,
                      wanted.samples, target);
        if (subject.pixels != nullptr && !subject.in_memory) {
            pixels_.begin(target);
            subject.pixels->store(pixels_);
        } else {
            pixels_.clear();
        }
    });
    if (!subject.in_memory) draw_image(subject, wanted, target);
    context_->run([&] {
        aovs_.draw(subject.alpha_masks, subject.projection, subject.surfaces.to_world(), target);
        gl::finish(*context_);
    });
}

void Painter::draw_image(const Subject& subject, const Wanted& wanted, Framebuffer& target) {
    const bool behind = draws_background(subject.scene, subject.pixels);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const int channels = group_size(target.channels(), g);
        gl::RenderTarget& image = target.groups_to_replace()[g];
        if (subject.pixels == nullptr) {
            draw_samples(subject, wanted, g, channels, image);
        } else if (behind) {
            draw_background(subject.scene, wanted.components, subject.projection, true, g, channels, image);
        }
    }
}

void Painter::prepare_sample(bool several, const Framebuffer& target) {
    if (!several) {
        sample_.reset();
        return;
    }
    const int colours = std::min(Framebuffer::kGroup, target.channels());
    if (sample_ && sample_->width() == target.width() && sample_->height() == target.height() &&
        sample_->colours() == colours)
        return;
    sample_.reset();
    sample_.emplace(context_, gl::RenderTargetDescription{
                                  .width = target.width(), .height = target.height(), .colours = colours});
}

void Painter::draw_samples(const Subject& subject, const Wanted& wanted, std::size_t group, int channels,
                           gl::RenderTarget& image) {
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
    for (std::size_t s = 0; s < wanted.samples.size(); ++s) {
        draw_vertices(subject, wanted.components, jittered(subject.projection, wanted.samples[s]), group,
                      channels, all, sample_ ? *sample_ : image);
        if (sample_) add_sample(s, wanted, channels, image);
    }
}

void Painter::draw_vertices(const Subject& subject, int components, const Projection& projection,
                            std::size_t group, int channels, std::size_t most, gl::RenderTarget& image) {
    const Scene& scene = subject.scene;
    draw_surface(subject, components, in_axes(projection, subject.surfaces.to_world()), group, channels, most,
                 image);
    // The environment is as smooth as its image, so a pixel has the environment of its centre.
    if (scene.background())
        draw_background(scene, components, subject.projection, false, group, channels, image);
}

void Painter::add_sample(std::size_t sample, const Wanted& wanted, int channels, gl::RenderTarget& image) {
    gl::Program& mean = program("fullscreen.vert", "mean.frag", channels, {});
    context_->run([&] {
        mean.set("weight", 1.0F / static_cast<float>(wanted.samples.size()));
        mean.set("first", sample == 0 ? 1 : 0);
        for (int c = 0; c < channels; ++c) {
            sample_->colour(c).bind(static_cast<unsigned>(c));
            image.colour(c).bind(static_cast<unsigned>(Framebuffer::kGroup + c));
        }
        gl::texture_barrier(*context_);
        gl::draw_fullscreen(image, mean, {.depth_test = gl::DepthTest::off, .depth_write = false});
    });
}

void Painter::draw_surface(const Subject& subject, int components, const Projection& projection,
                           std::size_t group, int channels, std::size_t most, gl::RenderTarget& image) {
    gl::Program& surface = program("surface.vert", "surface.frag", channels, {});
    const WorldGeometry& geometry = subject.surfaces.geometry();
    // A software driver draws some thousand triangles a millisecond. In a host's OpenGL a step is the host's
    // own.
    constexpr std::size_t triangles_of_step = 8192;
    const gl::ContextInfo& info = context_->info();
    const bool in_steps = info.software && info.backend != gl::Backend::host;
    const std::size_t step = in_steps ? triangles_of_step : geometry.triangles.size();
    const auto draw_some = [&](std::size_t first, std::size_t last, gl::Cull cull) {
        last = first + std::min(most, last - first);
        for (; first < last; first += step) {
            context_->run([&] {
                gl::draw(image, surface, *groups_[group].vertices, 3 * first,
                         3 * std::min(step, last - first), {.cull = cull, .components = components});
                if (in_steps) gl::finish(*context_);
            });
        }
    };
    context_->run([&] {
        surface.set("world_to_clip", glm::mat4(projection.world_to_clip));
        clear(image, subject.scene.background() != nullptr, components);
    });
    // One-sided materials are drawn black from behind; two-sided materials have triangles for each side.
    draw_some(0, geometry.one_sided, gl::Cull::none);
    draw_some(geometry.one_sided, geometry.triangles.size(), gl::Cull::back);
}

gl::Program& Painter::background_program(const Scene& scene, bool shaded, int channels) {
    std::set<std::string> features;
    if (scene.background()->polarized()) features.insert("POLARIZED");
    if (shaded) features.insert("SHADED");
    return program("fullscreen.vert", "background.frag", channels, features);
}

gl::Program& Painter::program(const char* vertex, const char* fragment, int channels,
                              const std::set<std::string>& features) {
    const auto key = std::make_tuple(std::string(fragment), channels, features);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<gl::Define> defines{{.name = "CHANNELS", .value = std::to_string(channels)}};
        for (const std::string& feature : features) defines.push_back({.name = feature});
        context_->run([&] {
            found = programs_.emplace(key, gl::Program::graphics(context_, vertex, fragment, defines)).first;
        });
    }
    return found->second;
}

void Painter::bind_vertices(VertexBuffers& buffers, int channels) {
    for (Group& group : groups_) group.vertices.reset();
    if (buffers.empty()) return;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        std::vector<gl::Attribute> attributes{
            {.location = 0, .components = 3, .buffer = buffers.positions()}};
        const StokesBuffer& stokes = buffers.stokes();
        for (int c = 0; c < group_size(channels, g); ++c) {
            attributes.push_back({.location = static_cast<unsigned>(1 + c),
                                  .components = 4,
                                  .buffer = stokes.buffer(),
                                  .offset = stokes.offset(static_cast<int>(g) * Framebuffer::kGroup + c)});
        }
        groups_[g].vertices.emplace(context_, attributes, buffers.indices());
    }
}

void Painter::upload_environment(const Environment& environment, int channels) {
    for (Group& group : groups_) group.environment.clear();
    // A megabyte of rows is a step of its own, so that other calls need not wait for all.
    constexpr std::size_t floats_of_step = std::size_t{1} << 18;
    const auto upload = [&](Group& group, std::span<const float> texels, const gl::TextureDescription& as) {
        context_->run([&] { group.environment.emplace_back(context_, as); });
        const std::size_t row = 4 * static_cast<std::size_t>(as.width);
        const int band = static_cast<int>(std::max<std::size_t>(1, floats_of_step / row));
        for (int y = 0; y < as.height; y += band) {
            const int rows = std::min(band, as.height - y);
            context_->run([&] {
                group.environment.back().update(
                    0, y, as.width, rows,
                    texels.subspan(static_cast<std::size_t>(y) * row, static_cast<std::size_t>(rows) * row));
            });
        }
    };
    const EquirectImage image = environment.image();
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto channel_data = [&](int c) {
        const auto from = static_cast<std::size_t>(image.channels == 1 ? 0 : c) * 4 * pixels;
        return std::span(image.data).subspan(from, 4 * pixels);
    };
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const int first = static_cast<int>(g) * Framebuffer::kGroup;
        if (environment.polarized()) {
            for (int c = 0; c < group_size(channels, g); ++c) {
                upload(groups_[g], channel_data(first + c), equirect(image));
            }
            continue;
        }
        std::vector<float> packed(4 * pixels);
        for (int c = 0; c < group_size(channels, g); ++c) {
            const std::span<const float> from = channel_data(first + c);
            for (std::size_t i = 0; i < pixels; ++i)
                packed[4 * i + static_cast<std::size_t>(c)] = from[4 * i];
        }
        upload(groups_[g], packed, equirect(image));
    }
}

void Painter::draw_background(const Scene& scene, int components, const Projection& projection, bool shaded,
                              std::size_t group, int channels, gl::RenderTarget& image) {
    const Viewpoint& view = projection.view;
    gl::Program& sky = background_program(scene, shaded, channels);
    context_->run([&] {
        unsigned unit = 0;
        if (shaded) {
            for (int c = 0; c < channels; ++c) image.colour(c).bind(unit++);
            pixels_.coverage().bind(unit++);
            gl::texture_barrier(*context_);
        }
        sky.set("camera", glm::mat3(view.right, view.up, view.forward));
        sky.set("half_size", glm::vec2(projection.half_width, projection.half_height));
        sky.set("shift", glm::vec2(projection.shift));
        sky.set("orthographic", view.orthographic ? 1 : 0);
        sky.set("to_light", glm::mat3(glm::transpose(scene.light_rotation())));
        sky.set("scale", static_cast<float>(scene.light_scale()));
        for (const gl::Texture2D& environment : groups_[group].environment) environment.bind(unit++);
        gl::draw_fullscreen(image, sky,
                            {.depth_test = shaded ? gl::DepthTest::off : gl::DepthTest::nearer_or_equal,
                             .depth_write = false,
                             .components = components});
    });
}

}  // namespace nicol
