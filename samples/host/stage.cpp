// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

constexpr const char* kTriangleVertex = R"(#version 450 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec4 colour;
uniform float angle;
out vec4 tint;
void main() {
    tint = colour;
    vec2 rotated = mat2(cos(angle), sin(angle), -sin(angle), cos(angle)) * place;
    gl_Position = vec4(rotated * vec2(0.5625, 1.0) * 0.8 - vec2(0.45, 0.0), 0.0, 1.0);
})";
constexpr const char* kTriangleFragment = R"(#version 450 core
in vec4 tint;
out vec4 pixel;
void main() { pixel = tint; })";

constexpr const char* kQuadVertex = R"(#version 450 core
layout(location = 0) in vec2 corner;  // in pixels from the quad's middle
uniform float angle;
out vec2 uv;
void main() {
    uv = corner / 256.0 + 0.5;
    float depth = 1.0 + 0.002 * corner.x * sin(angle);
    vec2 middle = vec2(480.0, 180.0) / vec2(320.0, 180.0) - 1.0;
    gl_Position = vec4(corner.x * cos(angle) / 320.0 + middle.x * depth, corner.y / 180.0 + middle.y * depth, 0.0, depth);
})";
constexpr const char* kQuadFragment = R"(#version 450 core
in vec2 uv;
layout(binding = 3) uniform sampler2D image;
out vec4 pixel;
void main() { pixel = texture(image, uv); })";

constexpr float kTriangleCorners[] = {
    -0.9F, -0.8F, 1, 0, 0, 1,    0.9F, -0.8F, 0, 1, 0, 1,    0,     0.9F, 0, 0, 1, 1,
    -0.5F, -0.9F, 1, 1, 0, 0.5F, 0.7F, -0.2F, 0, 1, 1, 0.5F, -0.2F, 0.8F, 1, 0, 1, 0.5F,
    -0.7F, 0.5F,  1, 1, 1, 0.3F, 0.2F, -0.7F, 1, 1, 1, 0.3F, 0.8F,  0.6F, 1, 1, 1, 0.3F};
constexpr float kQuadCorners[] = {-128, -128, 128, -128, -128, 128, 128, 128};

GLuint vertices(const Gl& gl, const float* data, std::size_t bytes) {
    GLuint array = 0, buffer = 0;
    gl.GenVertexArrays(1, &array);
    gl.BindVertexArray(array);
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return array;
}

void attribute(const Gl& gl, GLuint location, GLint components, GLsizei floats, std::uintptr_t first) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, floats * GLsizei{sizeof(float)},
                           reinterpret_cast<const void*>(first * sizeof(float)));
}

float radians(double degrees) {
    return static_cast<float>(degrees * std::numbers::pi / 180);
}

}  // namespace

Stage::Stage(const Gl& gl)
    : gl_(gl),
      triangles_(gl.program(kTriangleVertex, kTriangleFragment)),
      quad_(gl.program(kQuadVertex, kQuadFragment)) {
    triangle_vertices_ = vertices(gl, kTriangleCorners, sizeof kTriangleCorners);
    attribute(gl, 0, 2, 6, 0);
    attribute(gl, 1, 4, 6, 2);
    quad_vertices_ = vertices(gl, kQuadCorners, sizeof kQuadCorners);
    attribute(gl, 0, 2, 2, 0);

    gl.GenTextures(1, &image_);
    gl.ActiveTexture(GL_TEXTURE3);
    gl.BindTexture(GL_TEXTURE_2D, image_);
    gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, kQuadSize, kQuadSize);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.Viewport(0, 0, kWidth, kHeight);
    gl.ClearColor(0.1F, 0.2F, 0.3F, 1);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_BLEND);
}

void Stage::draw_triangles(double angle) const {
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.Scissor(20, 20, 300, kHeight - 40);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.UseProgram(triangles_);
    gl_.Uniform1f(gl_.GetUniformLocation(triangles_, "angle"), radians(angle));
    gl_.BindVertexArray(triangle_vertices_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 9);
}

void Stage::draw_quad(double angle) const {
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.UseProgram(quad_);
    gl_.Uniform1f(gl_.GetUniformLocation(quad_, "angle"), radians(angle));
    gl_.BindVertexArray(quad_vertices_);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl_.Enable(GL_SCISSOR_TEST);
}
