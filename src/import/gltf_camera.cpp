// SPDX-License-Identifier: MIT
// Cameras. Those of glTF look along their -z with +x to the right, ours along +z with +x to the left.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "import/gltf_readers.hpp"
#include "scene/camera.hpp"

namespace nicol::scene {

void GltfBounds::add(const GltfBounds& box, const glm::dmat4& to_world) {
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner((i & 1) != 0 ? box.upper.x : box.lower.x,
                                (i & 2) != 0 ? box.upper.y : box.lower.y,
                                (i & 4) != 0 ? box.upper.z : box.lower.z);
        const glm::dvec3 p(to_world * glm::dvec4(corner, 1));
        lower = empty ? p : glm::min(lower, p);
        upper = empty ? p : glm::max(upper, p);
        empty = false;
    }
}

GltfBounds bounds_of(const Mesh& mesh) {
    glm::vec3 lower = mesh.positions.front(), upper = lower;
    for (const glm::vec3& p : mesh.positions) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    return {.lower = lower, .upper = upper, .empty = false};
}

bool is_gltf_placement(const glm::dmat4& m) {
    const glm::dmat3 linear(m);
    const double box = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return std::abs(glm::determinant(linear)) > 1e-12 * box;
}
namespace {

constexpr double kDefaultHeight = 45;  // degrees

/// The film is as wide as always, and as high as it takes.
void set_aspect(const GltfDocument& document, const std::string& where, const char* name, double aspect,
                SensorDescription& sensor) {
    constexpr double most = 20;
    if (!(aspect >= 1 / most && aspect <= most))
        document.fail(where, std::string(name) + " is " + std::to_string(aspect) + "; expected 0.05 to 20");
    sensor.height = static_cast<int>(std::lround(sensor.width / aspect));
}

void set_clip(const GltfDocument& document, const std::string& where, double near, double far,
              SensorDescription& sensor) {
    if (!(near > 0 && far > near && std::isfinite(far)))
        document.fail(where, "znear is " + std::to_string(near) + " and zfar " + std::to_string(far) +
                                 "; they must satisfy 0 < znear < zfar");
    sensor.near_clip = near;
    sensor.far_clip = far;
}

/// From a point to the farthest corner.
double reach(const GltfBounds& bounds, const glm::dvec3& from) {
    return glm::length(glm::max(glm::abs(bounds.lower - from), glm::abs(bounds.upper - from)));
}

void read_perspective(const GltfDocument& document, const std::string& where,
                      const tinygltf::PerspectiveCamera& camera, double reach, SensorDescription& sensor) {
    sensor.fov = camera.yfov * 180 / std::numbers::pi;
    sensor.fov_axis = SensorDescription::FovAxis::y;
    if (!(sensor.fov > 0 && sensor.fov < 180))
        document.fail(where,
                      "yfov is " + std::to_string(camera.yfov) + "; expected more than 0 and less than pi");
    if (camera.aspectRatio != 0) set_aspect(document, where, "aspectRatio", camera.aspectRatio, sensor);
    if (!(horizontal_fov(sensor) < 179.99))
        document.fail(where, "yfov and aspectRatio make the image 180 degrees wide; expected less");
    // A camera without zfar sees to infinity. It may be moved away from where it is.
    const double far = camera.zfar != 0 ? camera.zfar : std::max(1e6 * camera.znear, 10 * reach);
    set_clip(document, where, camera.znear, far, sensor);
}

void read_orthographic(const GltfDocument& document, const std::string& where,
                       const tinygltf::OrthographicCamera& camera, SensorDescription& sensor) {
    sensor.kind = SensorDescription::Kind::orthographic;
    const double x = std::abs(camera.xmag);
    const double y = std::abs(camera.ymag);
    if (!(x > 0 && y > 0)) document.fail(where, "xmag or ymag is 0; expected another value");
    set_aspect(document, where, "xmag / ymag", x / y, sensor);
    // The height follows from the aspect ratio of the film, which has whole pixels.
    sensor.to_world[0] *= x;
    sensor.to_world[1] *= y * sensor.width / sensor.height;
    set_clip(document, where, camera.znear == 0 ? 1e-6 * camera.zfar : camera.znear, camera.zfar, sensor);
}

}  // namespace

glm::dmat4 gltf_view(const GltfDocument& document, const std::string& where, const char* thing,
                     const glm::dmat4& to_world) {
    const glm::dvec3 backward(to_world[2]);
    const glm::dvec3 up(to_world[1]);
    if (!(glm::length(glm::cross(up, backward)) > 1e-9 * glm::length(up) * glm::length(backward)))
        document.fail(where,
                      std::string("its ") + thing + " has axes of no length, or two that are parallel");
    glm::dmat4 view = look_at(glm::dvec3(0), -glm::normalize(backward), glm::normalize(up));
    view[3] = to_world[3];
    return view;
}

SensorDescription read_gltf_camera(const GltfDocument& document, const tinygltf::Node& node,
                                   const std::string& where, const glm::dmat4& to_world,
                                   const GltfBounds& bounds) {
    const tinygltf::Camera& camera = document.at(document.model().cameras, "cameras", node.camera, where);
    const glm::dvec3 eye(to_world[3]);
    SensorDescription sensor;
    sensor.to_world = gltf_view(document, where, "camera", to_world);
    const std::string name = "cameras[" + std::to_string(node.camera) + "]";
    if (camera.type == "perspective")
        read_perspective(document, name, camera.perspective, reach(bounds, eye), sensor);
    else
        read_orthographic(document, name, camera.orthographic, sensor);
    return sensor;
}

SensorDescription gltf_camera_in_front(const GltfBounds& bounds) {
    SensorDescription sensor;
    sensor.fov = kDefaultHeight;
    sensor.fov_axis = SensorDescription::FovAxis::y;
    const glm::dvec3 center = 0.5 * (bounds.lower + bounds.upper);
    // Nothing may be there to draw at one time of an animation.
    const double radius = bounds.empty ? 1 : 0.5 * glm::distance(bounds.lower, bounds.upper);
    // The cone of the image's height touches the sphere around the scene; the image is wider than high.
    const double distance = radius / std::sin(kDefaultHeight * std::numbers::pi / 360);
    const glm::dvec3 eye = center + glm::dvec3(0, 0, distance);
    sensor.to_world = look_at(glm::dvec3(0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));
    sensor.to_world[3] = glm::dvec4(eye, 1);
    sensor.near_clip = 1e-3 * distance;
    sensor.far_clip = 1e3 * distance;
    return sensor;
}

}  // namespace nicol::scene
