// SPDX-License-Identifier: MIT
#include "gl_state.hpp"

#include <array>

namespace {

struct Query {
    const char* name;
    GLenum value;
    std::size_t count = 1;
};
#define QUERY(name, ...) \
    { #name, name __VA_OPT__(, ) __VA_ARGS__ }

constexpr Query kCapabilities[] = {QUERY(GL_BLEND),
                                   QUERY(GL_CULL_FACE),
                                   QUERY(GL_DEPTH_TEST),
                                   QUERY(GL_STENCIL_TEST),
                                   QUERY(GL_SCISSOR_TEST),
                                   QUERY(GL_DITHER),
                                   QUERY(GL_COLOR_LOGIC_OP),
                                   QUERY(GL_POLYGON_OFFSET_FILL),
                                   QUERY(GL_MULTISAMPLE),
                                   QUERY(GL_FRAMEBUFFER_SRGB),
                                   QUERY(GL_RASTERIZER_DISCARD),
                                   QUERY(GL_PRIMITIVE_RESTART),
                                   QUERY(GL_DEPTH_CLAMP),
                                   QUERY(GL_SAMPLE_MASK),
                                   QUERY(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                   QUERY(GL_DEBUG_OUTPUT)};
constexpr Query kValues[] = {QUERY(GL_CURRENT_PROGRAM),
                             QUERY(GL_VERTEX_ARRAY_BINDING),
                             QUERY(GL_ARRAY_BUFFER_BINDING),
                             QUERY(GL_DRAW_FRAMEBUFFER_BINDING),
                             QUERY(GL_READ_FRAMEBUFFER_BINDING),
                             QUERY(GL_RENDERBUFFER_BINDING),
                             QUERY(GL_PIXEL_PACK_BUFFER_BINDING),
                             QUERY(GL_PIXEL_UNPACK_BUFFER_BINDING),
                             QUERY(GL_SHADER_STORAGE_BUFFER_BINDING),
                             QUERY(GL_UNIFORM_BUFFER_BINDING),
                             QUERY(GL_ACTIVE_TEXTURE),
                             QUERY(GL_CULL_FACE_MODE),
                             QUERY(GL_FRONT_FACE),
                             QUERY(GL_POLYGON_MODE),
                             QUERY(GL_PROVOKING_VERTEX),
                             QUERY(GL_CLIP_ORIGIN),
                             QUERY(GL_CLIP_DEPTH_MODE),
                             QUERY(GL_DEPTH_FUNC),
                             QUERY(GL_DEPTH_WRITEMASK),
                             QUERY(GL_DEPTH_CLEAR_VALUE),
                             QUERY(GL_COLOR_CLEAR_VALUE, 4),
                             QUERY(GL_BLEND_COLOR, 4),
                             QUERY(GL_SCISSOR_BOX, 4),
                             QUERY(GL_VIEWPORT, 4),
                             QUERY(GL_DEPTH_RANGE, 2),
                             QUERY(GL_COLOR_WRITEMASK, 4),
                             QUERY(GL_BLEND_SRC_RGB),
                             QUERY(GL_BLEND_DST_RGB),
                             QUERY(GL_PACK_ALIGNMENT),
                             QUERY(GL_PACK_ROW_LENGTH),
                             QUERY(GL_UNPACK_ALIGNMENT),
                             QUERY(GL_UNPACK_ROW_LENGTH)};
constexpr Query kOfUnits[] = {QUERY(GL_TEXTURE_BINDING_2D), QUERY(GL_TEXTURE_BINDING_CUBE_MAP),
                              QUERY(GL_SAMPLER_BINDING)};
constexpr Query kOfBindings[] = {QUERY(GL_SHADER_STORAGE_BUFFER_BINDING),
                                 QUERY(GL_SHADER_STORAGE_BUFFER_SIZE), QUERY(GL_IMAGE_BINDING_NAME)};

}  // namespace

GlState gl_state(const Gl& gl) {
    GlState state;
    std::array<GLdouble, 4> numbers{};
    const auto keep = [&](const std::string& name, const Query& query) {
        state[name].assign(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(query.count));
    };
    for (const Query& query : kCapabilities)
        state[query.name] = {static_cast<double>(gl.IsEnabled(query.value))};
    for (const Query& query : kValues) {
        gl.GetDoublev(query.value, numbers.data());
        keep(query.name, query);
    }
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLenum unit = 0; unit < 32; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        for (const Query& query : kOfUnits) {
            gl.GetDoublev(query.value, numbers.data());
            keep("unit " + std::to_string(unit) + " " + query.name, query);
        }
    }
    gl.ActiveTexture(static_cast<GLenum>(active));
    for (GLuint index = 0; index < 8; ++index) {
        for (const Query& query : kOfBindings) {
            gl.GetDoublei_v(query.value, index, numbers.data());
            keep(std::string(query.name) + " " + std::to_string(index), query);
        }
        state["GL_BLEND " + std::to_string(index)] = {static_cast<double>(gl.IsEnabledi(GL_BLEND, index))};
    }
    state["glGetError"] = {static_cast<double>(gl.GetError())};
    return state;
}

std::string difference(const GlState& before, const GlState& after) {
    std::string text;
    for (const auto& [name, was] : before) {
        const std::vector<double>& is = after.at(name);
        for (std::size_t i = 0; i < was.size(); ++i) {
            if (was[i] == is[i]) continue;
            text += (text.empty() ? "" : "; ") + name + " was " + std::to_string(was[i]) + ", is " +
                    std::to_string(is[i]);
        }
    }
    return text;
}
