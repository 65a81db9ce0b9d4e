// SPDX-License-Identifier: MIT
#include "rings.hpp"

#include <numbers>

#include "stage.hpp"

namespace {

// The camera is that of Polarized: at (0, 0.5, 3.5), towards the origin, 45 degrees wide.
constexpr const char* kVertex = R"(#version 450 core
const int SECTORS = 32;
uniform float ring;   // 0 or 1
uniform float angle;
uniform float near;
out vec3 normal;
void main() {
    // One strip of triangles winds around the tube.
    int step = gl_VertexID / 2, side = gl_VertexID % 2;
    float u = 6.2831853 * (float(step) / float(SECTORS) + float(side)) / 96.0, v = 6.2831853 * float(step % SECTORS) / float(SECTORS);
    vec3 outward = vec3(cos(u), sin(u), 0.0);
    normal = cos(v) * outward + vec3(0.0, 0.0, sin(v));
    vec3 place = 1.15 * outward + 0.07 * normal;
    float tilt = 1.2 - 2.4 * ring;
    mat3 turn = mat3(cos(angle), 0.0, -sin(angle), 0.0, 1.0, 0.0, sin(angle), 0.0, cos(angle)) *
                mat3(1.0, 0.0, 0.0, 0.0, cos(tilt), sin(tilt), 0.0, -sin(tilt), cos(tilt));
    normal = turn * normal;
    vec3 eye = vec3(0.0, 0.5, 3.5), forward = normalize(-eye);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0))), up = cross(right, forward);
    vec3 seen = turn * place - eye;
    float distance = dot(seen, forward), wide = 2.4142136;
    gl_Position = vec4(wide * dot(seen, right), wide * dot(seen, up), distance - 2.0 * near, distance);
})";
constexpr const char* kFragment = R"(#version 450 core
in vec3 normal;
uniform float ring;
out vec4 pixel;
void main() {
    float light = 0.35 + 0.65 * max(dot(normalize(normal), normalize(vec3(0.4, 0.8, 0.5))), 0.0);
    pixel = vec4(light * (ring < 0.5 ? vec3(1.0, 0.75, 0.2) : vec3(0.3, 0.8, 1.0)), 1.0);
})";
constexpr int kVertices = 2 * (32 * 96 + 1);

}  // namespace

Rings::Rings(const Gl& gl, GLuint image, int size)
    : gl_(gl), size_(size), program_(gl.program(kVertex, kFragment)) {
    gl.GenVertexArrays(1, &vertices_);
    gl.GenTextures(1, &depth_);
    gl.BindTexture(GL_TEXTURE_2D, depth_);
    gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, size, size);
    gl.BindTexture(GL_TEXTURE_2D, image);
    gl.GenFramebuffers(1, &framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Rings::enter() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, size_, size_);
    gl_.Disable(GL_SCISSOR_TEST);
}

void Rings::leave() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Viewport(0, 0, Stage::kWidth, Stage::kHeight);
    gl_.Enable(GL_SCISSOR_TEST);
}

void Rings::clear() const {
    enter();
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    leave();
}

void Rings::draw(int ring, double angle) const {
    enter();
    gl_.Enable(GL_DEPTH_TEST);
    gl_.UseProgram(program_);
    gl_.Uniform1f(gl_.GetUniformLocation(program_, "ring"), static_cast<float>(ring));
    gl_.Uniform1f(gl_.GetUniformLocation(program_, "angle"),
                  static_cast<float>(angle * std::numbers::pi / 180));
    gl_.Uniform1f(gl_.GetUniformLocation(program_, "near"), kNear);
    gl_.BindVertexArray(vertices_);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, kVertices);
    gl_.Disable(GL_DEPTH_TEST);
    leave();
}
