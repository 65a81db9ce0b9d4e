// SPDX-License-Identifier: MIT
#include "draw/plate_painter.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "error.hpp"
#include "gl/context.hpp"
#include "gl/draw.hpp"
#include "gl/storage.hpp"
#include "reference/camera_rays.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

// As glsl/plates.frag has it.
struct DevicePlate {
    glm::vec4 x, y, z;
    glm::vec4 axis;
    float retardance;
    float transmittance;
    float round;
    float unused;
};
static_assert(sizeof(DevicePlate) == PlatePainter::kBytesPerPlate);
static_assert(static_cast<int>(PolarizingPlate::Kind::polarizer) == 0 &&
              static_cast<int>(PolarizingPlate::Kind::retarder) == 1 &&
              static_cast<int>(PolarizingPlate::Kind::right_circular) == 2);

DevicePlate on_device(const PlacedPlate& placed, const glm::dvec3& eye) {
    const glm::dmat3 rows = glm::transpose(placed.to_local());
    const glm::dvec3 from = placed.to_local() * (eye - placed.center());
    const PolarizingPlate& plate = placed.plate();
    return {.x = glm::vec4(rows[0], from.x),
            .y = glm::vec4(rows[1], from.y),
            .z = glm::vec4(rows[2], from.z),
            .axis = glm::vec4(placed.axis(), static_cast<float>(plate.kind)),
            .retardance = static_cast<float>(plate.retardance),
            .transmittance = static_cast<float>(plate.transmittance),
            .round = plate.outline == PolarizingPlate::Outline::disk ? 1.0F : 0.0F,
            .unused = 0};
}

void check_storage(const gl::Context& context, const WorldGeometry& geometry) {
    const std::size_t most = context.limits().storage_bytes / sizeof(glm::vec3);
    if (std::max(geometry.triangles.size(), geometry.positions.size()) <= most) return;
    throw Error(ErrorCode::unsupported,
                context.info().renderer + " shows polarizing plates before at most " + std::to_string(most) +
                    " triangles and vertices, and the scene has " +
                    std::to_string(geometry.triangles.size()) + " and " +
                    std::to_string(geometry.positions.size()) + "; use the reference method");
}

}  // namespace

void PlatePainter::prepare(const Scene& scene, const RefinedSurfaces& surfaces, const Projection& projection,
                           int samples, const Framebuffer& target) {
    check_storage(*context_, surfaces.geometry());
    projection_ = in_axes(projection, surfaces.to_world());
    const glm::dmat4 from_world = inverse_motion(surfaces.to_world());
    std::vector<DevicePlate> plates;
    for (const PolarizingPlate& plate : scene.plates())
        plates.push_back(on_device(PlacedPlate(plate, from_world), projection_.view.eye));
    plates_.reset();
    plates_.emplace(gl::storage(context_, plates));
    for (int first = 0; first < target.channels(); first += Framebuffer::kGroup)
        static_cast<void>(program(std::min(Framebuffer::kGroup, target.channels() - first), samples));
}

gl::Program& PlatePainter::program(int channels, int samples) {
    const std::pair key(channels, samples);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        const gl::Define defines[] = {{.name = "CHANNELS", .value = std::to_string(channels)},
                                      {.name = "SAMPLES", .value = std::to_string(samples)}};
        found =
            programs_.emplace(key, gl::Program::graphics(context_, "fullscreen.vert", "plates.frag", defines))
                .first;
    }
    return found->second;
}

void PlatePainter::draw(const VertexBuffers& buffers, const HitImage& hits, int components,
                        Framebuffer& target) {
    const glm::dvec2 size(target.width(), target.height());
    // Of one ray, whose distances become depths.
    const Ray ray = CameraRays(projection_, target.width(), target.height()).through(size.x / 2, size.y / 2);
    const double depth = glm::dot(ray.direction, projection_.view.forward);
    const std::span offsets = hits.offsets();
    plates_->bind_storage(0);
    if (!buffers.empty()) {
        buffers.indices()->buffer().bind_storage(1);
        buffers.positions()->bind_storage(2);
    }
    for (std::size_t s = 0; s < offsets.size(); ++s)
        hits.texture(s).bind(static_cast<unsigned>(Framebuffer::kGroup + s));
    for (gl::RenderTarget& image : target.groups()) {
        gl::Program& plates = program(image.colours(), static_cast<int>(offsets.size()));
        set_view_uniforms(plates, projection_.view);
        plates.set("half_size", glm::vec2(projection_.half_width, projection_.half_height));
        plates.set("shift", glm::vec2(projection_.shift));
        plates.set("pixel_size", glm::vec2(1.0 / size));
        plates.set("near", static_cast<float>(ray.nearest * depth));
        plates.set("far", static_cast<float>(ray.farthest * depth));
        plates.set("components", components);
        for (std::size_t s = 0; s < offsets.size(); ++s)
            plates.set("offsets[" + std::to_string(s) + "]", glm::vec2(offsets[s]));
        for (int c = 0; c < image.colours(); ++c) image.colour(c).bind(static_cast<unsigned>(c));
        gl::texture_barrier(*context_);
        gl::draw_fullscreen(image, plates);
    }
}

}  // namespace nicol
