// SPDX-License-Identifier: MIT
#include "draw/element_painter.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "draw/texture_table.hpp"
#include "error.hpp"
#include "gl/context.hpp"
#include "gl/draw.hpp"
#include "gl/storage.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

// Element in the layout of glsl/elements.frag.
struct DeviceElement {
    glm::vec4 x, y, z;
    glm::vec4 axis;
    float retardance;
    float transmittance;
    float round;
    float angle;
    ElementWords textures;
    std::uint32_t unused[2];
};
static_assert(sizeof(DeviceElement) == 96);
// Word of a number without a texture.
constexpr std::uint32_t kNoTexture = 0xFFFFFFFF;
static_assert(static_cast<int>(PolarizationElement::Kind::polarizer) == 0 &&
              static_cast<int>(PolarizationElement::Kind::retarder) == 1 &&
              static_cast<int>(PolarizationElement::Kind::right_circular) == 2);

DeviceElement on_device(const PlacedElement& placed, const glm::dvec3& eye, const ElementWords& textures) {
    const glm::dmat3 rows = glm::transpose(placed.to_local());
    const glm::dvec3 from = placed.to_local() * (eye - placed.center());
    const PolarizationElement& element = placed.element();
    return {.x = glm::vec4(rows[0], from.x),
            .y = glm::vec4(rows[1], from.y),
            .z = glm::vec4(rows[2], from.z),
            .axis = glm::vec4(textures.angle == kNoTexture ? placed.axis() : placed.axis(0),
                              static_cast<float>(element.kind)),
            .retardance = static_cast<float>(element.retardance),
            .transmittance = static_cast<float>(element.transmittance),
            .round = element.outline == PolarizationElement::Outline::disk ? 1.0F : 0.0F,
            .angle = static_cast<float>(element.angle),
            .textures = textures,
            .unused = {}};
}

// Adds the textures of an element to a table. Returns their words.
ElementWords words_of(const ElementTextures& of, TextureTable& table) {
    const auto word = [&](const TexturePtr& texture) {
        if (texture == nullptr) return kNoTexture;
        return static_cast<std::uint32_t>(TextureTable::kWords) * table.number_of(texture);
    };
    const std::uint32_t angle = word(of.angle);
    return {.angle = angle, .retardance = word(of.retardance)};
}

void check_storage(const gl::Context& context, const WorldGeometry& geometry) {
    const std::size_t most = context.limits().storage_bytes / sizeof(glm::vec3);
    if (std::max(geometry.triangles.size(), geometry.positions.size()) <= most) return;
    throw Error(ErrorCode::unsupported,
                context.info().renderer + " shows polarization elements before at most " +
                    std::to_string(most) + " triangles and vertices, and the scene has " +
                    std::to_string(geometry.triangles.size()) + " and " +
                    std::to_string(geometry.positions.size()) + "; use the reference method");
}

}  // namespace

std::uint64_t ElementPainter::bytes(const Scene& scene) {
    TextureTable textures;
    for (const SceneElement& element : scene.elements()) words_of(element.textures, textures);
    return sizeof(DeviceElement) * scene.elements().size() + sizeof(float) * textures.texels();
}

void ElementPainter::prepare(const Scene& scene, const RefinedSurfaces& surfaces,
                             const Projection& projection, int samples, const Framebuffer& target) {
    check_storage(*context_, surfaces.geometry());
    projection_ = in_axes(projection, surfaces.to_world());
    const glm::dmat4 from_world = inverse_motion(surfaces.to_world());
    std::vector<ElementTextures> of_elements;
    of_elements.reserve(scene.elements().size());
    for (const SceneElement& element : scene.elements()) of_elements.push_back(element.textures);
    textures_stage_.run(of_elements, [&] { prepare_textures(of_elements); });
    std::vector<DeviceElement> elements;
    elements.reserve(words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i)
        elements.push_back(
            on_device(PlacedElement(scene.elements()[i], from_world), projection_.view.eye, words_[i]));
    elements_.reset();
    elements_.emplace(gl::storage(context_, elements));
    for (int first = 0; first < target.channels(); first += Framebuffer::kGroup)
        static_cast<void>(program(std::min(Framebuffer::kGroup, target.channels() - first), samples));
}

void ElementPainter::prepare_textures(const std::vector<ElementTextures>& of_elements) {
    texture_table_.reset();
    texels_.reset();
    words_.clear();
    TextureTable textures;
    words_.reserve(of_elements.size());
    for (const ElementTextures& of : of_elements) words_.push_back(words_of(of, textures));
    if (textures.count() == 0) return;
    const std::size_t most = context_->limits().storage_bytes / sizeof(float);
    if (textures.texels() > most)
        throw Error(ErrorCode::unsupported,
                    context_->info().renderer + " reaches " + std::to_string(most) +
                        " numbers of the textures of polarization elements, which have " +
                        std::to_string(textures.texels()) + "; use smaller images, or the reference method");
    std::vector<std::uint32_t> table;
    std::vector<float> texels;
    textures.write(0, table, texels);
    if (texels.empty()) texels.push_back(0);
    texture_table_.emplace(gl::storage(context_, table));
    texels_.emplace(gl::storage(context_, texels));
}

gl::Program& ElementPainter::program(int channels, int samples) {
    const std::tuple key(channels, samples, texture_table_.has_value());
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<gl::Define> defines{{.name = "CHANNELS", .value = std::to_string(channels)},
                                        {.name = "SAMPLES", .value = std::to_string(samples)}};
        if (texture_table_) defines.push_back({.name = "TEXTURED"});
        found =
            programs_
                .emplace(key, gl::Program::graphics(context_, "fullscreen.vert", "elements.frag", defines))
                .first;
    }
    return found->second;
}

void ElementPainter::draw(const VertexBuffers& buffers, const VisibilityBuffer& hits, int components,
                          Framebuffer& target) {
    const glm::dvec2 size(target.width(), target.height());
    const std::span offsets = hits.offsets();
    elements_->bind_storage(0);
    if (texture_table_) {
        texture_table_->bind_storage(3);
        texels_->bind_storage(4);
    }
    if (!buffers.empty()) {
        buffers.indices()->buffer().bind_storage(1);
        buffers.positions()->bind_storage(2);
    }
    for (std::size_t s = 0; s < offsets.size(); ++s)
        hits.texture(s).bind(static_cast<unsigned>(Framebuffer::kGroup + s));
    for (gl::RenderTarget& image : target.groups()) {
        gl::Program& elements = program(image.colours(), static_cast<int>(offsets.size()));
        set_view_uniforms(elements, projection_.view);
        elements.set("half_size", glm::vec2(projection_.half_width, projection_.half_height));
        elements.set("shift", glm::vec2(projection_.shift));
        elements.set("pixel_size", glm::vec2(1.0 / size));
        elements.set("near", static_cast<float>(projection_.near_clip));
        elements.set("far", static_cast<float>(projection_.far_clip));
        elements.set("components", components);
        for (std::size_t s = 0; s < offsets.size(); ++s)
            elements.set("offsets[" + std::to_string(s) + "]", glm::vec2(offsets[s]));
        for (int c = 0; c < image.colours(); ++c) image.colour(c).bind(static_cast<unsigned>(c));
        gl::texture_barrier(*context_);
        gl::draw_fullscreen(image, elements);
    }
}

}  // namespace nicol
