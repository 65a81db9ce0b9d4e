// SPDX-License-Identifier: MIT
#include "render/memory_estimate.hpp"

#include <algorithm>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "draw/aov_layout.hpp"
#include "draw/element_painter.hpp"
#include "draw/framebuffer.hpp"
#include "draw/pixel_image.hpp"
#include "draw/sample_pattern.hpp"
#include "draw/visibility_buffer.hpp"
#include "error.hpp"
#include "harmonics/psh.hpp"
#include "material/spatial_variation.hpp"
#include "methods/bounce_columns.hpp"
#include "methods/bounces.hpp"
#include "methods/lobe_photons.hpp"
#include "render/light_projection.hpp"
#include "render/light_split.hpp"
#include "render/wanted_executor.hpp"
#include "surfaces/focusing_surfaces.hpp"
#include "surfaces/photon_paths.hpp"
#include "texture/texel_gradient.hpp"
#include "transfer/vertex_light.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {
namespace {

struct Size {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t corner = 0;  // bytes per corner that textures need
};

// Returns a scene's size, including both sides of two-sided surfaces.
Size size_of(const Scene& scene) {
    Size size;
    for (const Instance& instance : scene.instances()) {
        const std::uint64_t sides = instance.material->twosided() ? 2 : 1;
        size.vertices += sides * instance.mesh->positions.size();
        size.triangles += sides * instance.mesh->triangles.size();
    }
    if (scene.varies()) size.corner = sizeof(glm::vec2) + sizeof(glm::vec3);
    return size;
}

bool bounces(const RenderOptions& options) {
    return options.method == Method::factored && options.max_depth > kDirectLightDepth && options.shadows;
}

LightKind kind_of(const Scene& scene, const RenderOptions& options) {
    if ((options.disabled_optimisations & skip_light_components) != 0) return LightKind::full;
    const LightKind kind = light_kind(scene.distant_light().get());
    return bounces(options) && options.components > 1 ? std::max(kind, LightKind::linear) : kind;
}

// Returns the components of the distant light; none: there is no distant light.
std::optional<LightKind> distant_kind(const Scene& scene) {
    std::optional<LightKind> out;
    if (scene.distant_light() != nullptr) out = light_kind(scene.distant_light().get());
    return out;
}

// Returns the order of vertices, to which bounces may raise that of the options. An order out of range is
// refused by the render.
int order_of(const Scene& scene, const RenderOptions& options) {
    int order = options.order_low;
    if (bounces(options))
        order = order_with_bounces(order, scene.distant_light() != nullptr, options.choose_orders);
    return std::clamp(order, 0, kMaxRenderOrder);
}

// Vertices per block. Vertices are stored in blocks, so the memory of all is a multiple of a block's.
constexpr std::uint64_t kBlock = 16;

std::uint64_t blocks(std::uint64_t vertices) {
    return (vertices + kBlock - 1) / kBlock;
}

std::uint64_t shadows_of_block(const LightLayout& layout) {
    const DirectionSet directions(DirectionSet::kFewest);
    const Visibility nothing(directions.size(), kBlock);
    const std::vector<glm::vec3> normals(kBlock, glm::vec3(0, 0, 1));
    return VisibilityProduct(nothing, directions, normals, layout).bytes();
}

// Returns the bytes of the matrices, from the light's numbers to those of four reflected components, and of
// the reflected light.
std::uint64_t dense(const Scene& scene, const LightLayout& layout) {
    constexpr std::uint64_t vector = 8;
    const LightLayout outgoing(layout.order(), LightKind::full);
    const std::uint64_t numbers = outgoing.size();
    const std::uint64_t rows = (numbers + vector - 1) / vector * vector;
    const std::uint64_t columns = layout.size();
    const auto channels = static_cast<std::uint64_t>(scene.channels());
    std::uint64_t bytes = 0;
    for (const Instance& instance : scene.instances()) {
        const auto matrices = static_cast<std::uint64_t>(instance.material->channels());
        const std::uint64_t vertices =
            instance.mesh->positions.size() * (instance.material->twosided() ? 2 : 1);
        bytes += vertices * (rows * (matrices * columns + channels) * sizeof(float) + 1);
    }
    return bytes;
}

// Returns the bytes of light that smooth surfaces focus.
std::uint64_t focused(const Scene& scene, const RenderOptions& options) {
    // Compute shaders follow no rays.
    if (!bounces(options) || wanted_executor(scene, options) == Executor::compute) return 0;
    std::size_t surfaces = 0;
    for (const Instance& instance : scene.instances())
        if (focuses_light(*instance.material)) surfaces += instance.material->twosided() ? 2 : 1;
    if (surfaces == 0) return 0;
    const auto emitting = static_cast<std::size_t>(std::ranges::count_if(
        scene.instances(), [](const Instance& instance) { return instance.emission != nullptr; }));
    const auto channels = static_cast<std::size_t>(scene.channels());
    std::uint64_t bytes = 0;
    const auto add = [&](std::size_t sources) {
        if (sources > 0) bytes += most_focused_bytes(surfaces, sources, channels);
    };
    add(scene.lights().size() + emitting);
    if (scene.distant_light() != nullptr) add(static_cast<std::size_t>(most_extracted(options)));
    return bytes;
}

// Returns the bytes of photons that narrow lobes send.
std::uint64_t photons(const Scene& scene, const RenderOptions& options) {
    const bool lit =
        scene.has_local_lights() || (scene.distant_light() != nullptr && most_extracted(options) > 0);
    if (!lit || !bounces(options)) return 0;
    const bool sends = std::ranges::any_of(scene.instances(), [](const Instance& instance) {
        return any_term(*instance.material, sends_photons);
    });
    return sends ? most_photon_bytes(static_cast<std::size_t>(scene.channels())) : 0;
}

// Returns the bytes of all paths of light from lamps on.
std::uint64_t paths(const Scene& scene, const RenderOptions& options) {
    return focused(scene, options) + photons(scene, options);
}

// Returns the location of hits. Threads shade local lights, which may include the environment's extracted
// lights; the device draws elements.
VisibilityBuffer::Kept hits_of(const Scene& scene, const RenderOptions& options) {
    if (options.executor != Executor::compute)
        return scene.elements().empty() ? VisibilityBuffer::Kept::on_host : VisibilityBuffer::Kept::on_both;
    const bool extracted_lights = scene.distant_light() != nullptr && options.split_lights != 0;
    return extracted_lights || scene.has_local_lights() ? VisibilityBuffer::Kept::on_both
                                                        : VisibilityBuffer::Kept::on_device;
}

MemoryEstimate reference_memory(const Scene& scene) {
    // Embree's own measure in its robust mode, for corners and boxes together.
    constexpr std::uint64_t hierarchy_of_triangle = 200;
    MemoryEstimate estimate;
    for (const Instance& instance : scene.instances()) {
        estimate.transfer += instance.mesh->positions.size() * 2 * sizeof(glm::vec3) +
                             instance.mesh->triangles.size() * (sizeof(glm::uvec3) + hierarchy_of_triangle);
    }
    return estimate;
}

}  // namespace

MemoryInputs::MemoryInputs(const Scene& scene, const RenderOptions& options)
    : paths(nicol::paths(scene, options)),
      geometry(scene.geometry_version()),
      distant(distant_kind(scene)),
      kind(kind_of(scene, options)),
      high_orders(options.high_orders),
      method(options.method),
      channels(scene.channels()),
      order_low(order_of(scene, options)),
      order_high(options.order_high),
      bake_directions(options.bake_directions),
      disabled_optimisations(options.disabled_optimisations),
      bounces(nicol::bounces(options)),
      shadows(options.shadows),
      high_order_shadows(options.high_order_shadows) {}

MemoryEstimate estimate_memory(const Scene& scene, const RenderOptions& options) {
    if (options.method == Method::reference) return reference_memory(scene);
    const Size size = size_of(scene);
    const auto channels = static_cast<std::uint64_t>(scene.channels());
    const std::uint64_t in_world =
        size.vertices * 2 * sizeof(glm::vec3) + size.triangles * sizeof(glm::uvec3);
    const bool shadows = options.shadows && size.triangles > 0;
    MemoryEstimate estimate;
    if (shadows) {
        const auto directions = static_cast<std::uint64_t>(std::max(options.bake_directions, 0));
        estimate.visibility = size.vertices * ((directions + 63) / 64 * sizeof(std::uint64_t) + 1);
        // Shadows of unoccluded vertices need a second set of bits.
        if ((options.disabled_optimisations & skip_unoccluded) != 0) estimate.visibility *= 2;
    }
    estimate.transfer =
        in_world + size.triangles * 3 * size.corner + size.vertices * (1 + channels * sizeof(glm::vec4));
    estimate.buffers = in_world + size.vertices * channels * sizeof(glm::vec4);
    if (size.vertices == 0) return estimate;
    estimate.focused = paths(scene, options);

    const int order = order_of(scene, options);
    const LightLayout layout(order, kind_of(scene, options));
    if (options.method == Method::dense) {
        estimate.transfer += dense(scene, layout);
    } else {
        estimate.transfer +=
            blocks(size.vertices) * VertexLight(layout, static_cast<int>(channels), kBlock).bytes();
        if (shadows) estimate.transfer += blocks(size.vertices) * shadows_of_block(layout);
    }
    if (shadows && bounces(options)) {
        // In small scenes each vertex may be a receiver, in others one of four.
        const std::uint64_t counted =
            std::max(size.vertices, std::min<std::uint64_t>(4 * size.vertices, 8192));
        estimate.transfer +=
            counted * Bounces::bytes_of_vertex(distant_kind(scene), layout.kind(), scene.channels());
    }
    const bool high_orders = options.high_orders != HighOrders::none && options.order_high > order;
    if (high_orders && shadows && options.high_order_shadows) {
        // Visibility has twice the orders that materials resolve.
        estimate.transfer += size.vertices * (psh_count(2 * order) * sizeof(float) + sizeof(glm::vec2));
        estimate.buffers += size.vertices * sizeof(glm::vec2);
    }
    return estimate;
}

std::uint64_t image_memory(const Scene& scene, const RenderOptions& options, int width, int height) {
    if (options.method == Method::reference) return 0;
    constexpr std::uint64_t texel = sizeof(glm::vec4);
    constexpr std::uint64_t depth = sizeof(float);
    const bool several = options.pixel_samples > 1;
    const std::size_t samples = samples_at_once(options.pixel_samples);
    const auto planes = static_cast<std::uint64_t>(scene.channels());
    const std::uint64_t of_elements =
        scene.elements().empty()
            ? 0
            : VisibilityBuffer::bytes_per_pixel(samples, VisibilityBuffer::Kept::on_device);
    const std::uint64_t of_sample =
        several ? std::min<std::uint64_t>(Framebuffer::kGroup, planes) * texel + depth : 0;
    const std::uint64_t at_pixels = VisibilityBuffer::bytes_per_pixel(samples, hits_of(scene, options)) +
                                    PixelImage::kBytesPerPixel + planes * texel;
    // Threads interpolate between vertices where the device would take longer.
    const std::uint64_t at_vertices = options.executor == Executor::compute
                                          ? of_sample + of_elements
                                          : std::max(of_sample + of_elements, at_pixels);
    std::uint64_t bytes = 0;
    if (options.shade_at != ShadeAt::pixels) bytes = at_vertices;
    if (options.shade_at != ShadeAt::vertices) bytes = std::max(bytes, at_pixels);
    if (options.aovs != 0) {
        // Attachments of the framebuffer, of the spare and of one sample, with the depth that decides which
        // sample is nearest.
        const auto attachments =
            static_cast<std::uint64_t>(AovLayout(options.aovs | aov_depth).attachments());
        bytes += (several ? 3 : 2) * (attachments * texel + depth);
    }
    bytes += planes * texel + depth;  // spare, which the image is drawn into
    return bytes * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) +
           ElementPainter::bytes(scene);
}

GradientMemory gradient_memory(const Scene& scene, const RenderOptions& options, const Texture* texels) {
    GradientMemory memory;
    if (texels != nullptr) memory.texels = TexelGradient::bytes(*texels);
    const Size size = size_of(scene);
    if (!options.shadows || size.triangles == 0) return memory;
    // Vertices have sums of gradients, and for texels the light that they show.
    const LightLayout layout(order_of(scene, options), kind_of(scene, options));
    memory.of_vertices = (texels != nullptr ? 2 : 1) * blocks(size.vertices) *
                         VertexLight(layout, scene.channels(), kBlock).bytes();
    return memory;
}

void MemoryLimit::check(const Scene& scene, const RenderOptions& options, int width, int height,
                        const GradientMemory& gradients) {
    vertices_ = size_of(scene).vertices;
    if (!saves()) return;
    image_ = image_memory(scene, options, width, height) + gradients.texels;
    checking_.run(MemoryInputs(scene, options), image_, gradients.of_vertices, [&] {
        estimate_ = estimate_memory(scene, options);
        estimate_.transfer += gradients.of_vertices;
        const std::uint64_t needed = estimate_.total() + image_;
        if (needed <= bytes_) return;
        throw Error(ErrorCode::out_of_memory, "the scene and its image need up to " + std::to_string(needed) +
                                                  " bytes at run time; the context's memory_limit is " +
                                                  std::to_string(bytes_));
    });
    share_.reserve(estimate_.visibility + estimate_.transfer + estimate_.focused + image_);
}

void MemoryLimit::refined(std::uint64_t vertices) {
    if (!share_.monitored() || vertices <= vertices_ || vertices_ == 0) return;
    const double times = static_cast<double>(vertices) / static_cast<double>(vertices_);
    const auto scene = static_cast<double>(estimate_.visibility + estimate_.transfer);
    share_.reserve(image_ + estimate_.focused + static_cast<std::uint64_t>(times * scene));
}

std::uint64_t MemoryLimit::max_vertices(const RenderOptions& options) const {
    const std::uint64_t wanted =
        options.max_vertices != 0 ? options.max_vertices : std::max<std::uint64_t>(4 * vertices_, 65536);
    if (bytes_ == kNone || estimate_.of_vertices() == 0) return wanted;
    // All memory but that of focused light grows with the vertices. The bake of the vertices before
    // refinement stays for the next change.
    const double times = static_cast<double>(for_scene() - estimate_.visibility - estimate_.focused) /
                         static_cast<double>(estimate_.of_vertices());
    return std::min(wanted, static_cast<std::uint64_t>(times * static_cast<double>(vertices_)));
}

}  // namespace nicol
