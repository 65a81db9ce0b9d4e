// SPDX-License-Identifier: MIT
#include "host/gl_state.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace host_test {
namespace {

struct Named {
    const char* name;
    GLenum value;
    int count = 1;
};
#define NAMED(name) \
    { #name, name, 1 }
#define NAMED_N(name, count) \
    { #name, name, count }

constexpr Named capabilities[] = {NAMED(GL_DEPTH_TEST),
                                  NAMED(GL_STENCIL_TEST),
                                  NAMED(GL_CULL_FACE),
                                  NAMED(GL_DITHER),
                                  NAMED(GL_COLOR_LOGIC_OP),
                                  NAMED(GL_POLYGON_OFFSET_FILL),
                                  NAMED(GL_POLYGON_OFFSET_LINE),
                                  NAMED(GL_POLYGON_OFFSET_POINT),
                                  NAMED(GL_POLYGON_SMOOTH),
                                  NAMED(GL_LINE_SMOOTH),
                                  NAMED(GL_MULTISAMPLE),
                                  NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                  NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                                  NAMED(GL_SAMPLE_COVERAGE),
                                  NAMED(GL_SAMPLE_MASK),
                                  NAMED(GL_SAMPLE_SHADING),
                                  NAMED(GL_PRIMITIVE_RESTART),
                                  NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                                  NAMED(GL_RASTERIZER_DISCARD),
                                  NAMED(GL_DEPTH_CLAMP),
                                  NAMED(GL_FRAMEBUFFER_SRGB),
                                  NAMED(GL_PROGRAM_POINT_SIZE),
                                  NAMED(GL_DEBUG_OUTPUT),
                                  NAMED(GL_DEBUG_OUTPUT_SYNCHRONOUS),
                                  NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS),
                                  NAMED(GL_CLIP_DISTANCE0),
                                  NAMED(GL_CLIP_DISTANCE1),
                                  NAMED(GL_CLIP_DISTANCE5),
                                  NAMED(GL_CLIP_DISTANCE7)};

constexpr Named values[] = {NAMED(GL_DEPTH_WRITEMASK),
                            NAMED(GL_DEPTH_FUNC),
                            NAMED(GL_DEPTH_CLEAR_VALUE),
                            NAMED_N(GL_COLOR_CLEAR_VALUE, 4),
                            NAMED(GL_STENCIL_CLEAR_VALUE),
                            NAMED(GL_STENCIL_WRITEMASK),
                            NAMED(GL_STENCIL_BACK_WRITEMASK),
                            NAMED(GL_STENCIL_FUNC),
                            NAMED(GL_STENCIL_REF),
                            NAMED(GL_STENCIL_VALUE_MASK),
                            NAMED(GL_STENCIL_FAIL),
                            NAMED(GL_STENCIL_PASS_DEPTH_FAIL),
                            NAMED(GL_STENCIL_PASS_DEPTH_PASS),
                            NAMED(GL_CULL_FACE_MODE),
                            NAMED(GL_FRONT_FACE),
                            NAMED_N(GL_POLYGON_MODE, 2),
                            NAMED(GL_POLYGON_OFFSET_FACTOR),
                            NAMED(GL_POLYGON_OFFSET_UNITS),
                            NAMED(GL_PROVOKING_VERTEX),
                            NAMED(GL_CLIP_ORIGIN),
                            NAMED(GL_CLIP_DEPTH_MODE),
                            NAMED(GL_LOGIC_OP_MODE),
                            NAMED_N(GL_BLEND_COLOR, 4),
                            NAMED(GL_LINE_WIDTH),
                            NAMED(GL_POINT_SIZE),
                            NAMED(GL_SAMPLE_COVERAGE_VALUE),
                            NAMED(GL_MIN_SAMPLE_SHADING_VALUE),
                            NAMED(GL_PRIMITIVE_RESTART_INDEX),
                            NAMED(GL_PATCH_VERTICES),
                            NAMED(GL_CURRENT_PROGRAM),
                            NAMED(GL_PROGRAM_PIPELINE_BINDING),
                            NAMED(GL_VERTEX_ARRAY_BINDING),
                            NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
                            NAMED(GL_READ_FRAMEBUFFER_BINDING),
                            NAMED(GL_RENDERBUFFER_BINDING),
                            NAMED(GL_ARRAY_BUFFER_BINDING),
                            NAMED(GL_COPY_READ_BUFFER_BINDING),
                            NAMED(GL_COPY_WRITE_BUFFER_BINDING),
                            NAMED(GL_DRAW_INDIRECT_BUFFER_BINDING),
                            NAMED(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
                            NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
                            NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
                            NAMED(GL_QUERY_BUFFER_BINDING),
                            NAMED(GL_UNIFORM_BUFFER_BINDING),
                            NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
                            NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING),
                            NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
                            NAMED(GL_TRANSFORM_FEEDBACK_BINDING),
                            NAMED(GL_TEXTURE_BUFFER_BINDING),
                            NAMED(GL_ACTIVE_TEXTURE),
                            NAMED(GL_READ_BUFFER),
                            NAMED(GL_CLAMP_READ_COLOR),
                            NAMED(GL_FRAGMENT_SHADER_DERIVATIVE_HINT),
                            NAMED(GL_PACK_SWAP_BYTES),
                            NAMED(GL_PACK_LSB_FIRST),
                            NAMED(GL_PACK_ROW_LENGTH),
                            NAMED(GL_PACK_IMAGE_HEIGHT),
                            NAMED(GL_PACK_SKIP_ROWS),
                            NAMED(GL_PACK_SKIP_PIXELS),
                            NAMED(GL_PACK_SKIP_IMAGES),
                            NAMED(GL_PACK_ALIGNMENT),
                            NAMED(GL_UNPACK_SWAP_BYTES),
                            NAMED(GL_UNPACK_LSB_FIRST),
                            NAMED(GL_UNPACK_ROW_LENGTH),
                            NAMED(GL_UNPACK_IMAGE_HEIGHT),
                            NAMED(GL_UNPACK_SKIP_ROWS),
                            NAMED(GL_UNPACK_SKIP_PIXELS),
                            NAMED(GL_UNPACK_SKIP_IMAGES),
                            NAMED(GL_UNPACK_ALIGNMENT),
                            NAMED(GL_DEBUG_GROUP_STACK_DEPTH)};

// Of compatibility contexts; their names are not in the core loader.
constexpr Named old_capabilities[] = {{"GL_ALPHA_TEST", 0x0BC0},
                                      {"GL_POLYGON_STIPPLE", 0x0B42},
                                      {"GL_LIGHTING", 0x0B50},
                                      {"GL_FOG", 0x0B60},
                                      {"GL_TEXTURE_2D", GL_TEXTURE_2D}};
constexpr Named old_values[] = {{"GL_ALPHA_TEST_FUNC", 0x0BC1},
                                {"GL_ALPHA_TEST_REF", 0x0BC2},
                                {"GL_CLAMP_FRAGMENT_COLOR", 0x891B},
                                {"GL_CLAMP_VERTEX_COLOR", 0x891A},
                                {"GL_MATRIX_MODE", 0x0BA0},
                                {"GL_CURRENT_COLOR", 0x0B00, 4},
                                {"GL_MODELVIEW_MATRIX", 0x0BA6, 16},
                                {"GL_PROJECTION_MATRIX", 0x0BA7, 16},
                                {"GL_MAP_COLOR", 0x0D10},
                                {"GL_RED_SCALE", 0x0D14},
                                {"GL_RED_BIAS", 0x0D15},
                                {"GL_GREEN_SCALE", 0x0D18},
                                {"GL_GREEN_BIAS", 0x0D19},
                                {"GL_BLUE_SCALE", 0x0D1A},
                                {"GL_BLUE_BIAS", 0x0D1B},
                                {"GL_ALPHA_SCALE", 0x0D1C},
                                {"GL_ALPHA_BIAS", 0x0D1D}};

constexpr Named unit_bindings[] = {NAMED(GL_TEXTURE_BINDING_1D),
                                   NAMED(GL_TEXTURE_BINDING_2D),
                                   NAMED(GL_TEXTURE_BINDING_3D),
                                   NAMED(GL_TEXTURE_BINDING_1D_ARRAY),
                                   NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
                                   NAMED(GL_TEXTURE_BINDING_RECTANGLE),
                                   NAMED(GL_TEXTURE_BINDING_BUFFER),
                                   NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
                                   NAMED(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY),
                                   NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
                                   NAMED(GL_SAMPLER_BINDING)};

// Of each draw buffer, viewport, image unit or binding point.
constexpr Named of_draw_buffers[] = {NAMED_N(GL_COLOR_WRITEMASK, 4), NAMED(GL_BLEND_SRC_RGB),
                                     NAMED(GL_BLEND_DST_RGB),        NAMED(GL_BLEND_SRC_ALPHA),
                                     NAMED(GL_BLEND_DST_ALPHA),      NAMED(GL_BLEND_EQUATION_RGB),
                                     NAMED(GL_BLEND_EQUATION_ALPHA)};
constexpr Named of_viewports[] = {NAMED_N(GL_VIEWPORT, 4), NAMED_N(GL_DEPTH_RANGE, 2),
                                  NAMED_N(GL_SCISSOR_BOX, 4)};
constexpr Named of_image_units[] = {NAMED(GL_IMAGE_BINDING_NAME),    NAMED(GL_IMAGE_BINDING_LEVEL),
                                    NAMED(GL_IMAGE_BINDING_LAYERED), NAMED(GL_IMAGE_BINDING_LAYER),
                                    NAMED(GL_IMAGE_BINDING_ACCESS),  NAMED(GL_IMAGE_BINDING_FORMAT)};
constexpr Named of_buffer_bindings[] = {
    NAMED(GL_SHADER_STORAGE_BUFFER_BINDING), NAMED(GL_SHADER_STORAGE_BUFFER_START),
    NAMED(GL_SHADER_STORAGE_BUFFER_SIZE),    NAMED(GL_UNIFORM_BUFFER_BINDING),
    NAMED(GL_UNIFORM_BUFFER_START),          NAMED(GL_UNIFORM_BUFFER_SIZE)};

GLint integer(const GladGLContext& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

class Reader {
public:
    explicit Reader(const GladGLContext& gl) : gl_(gl) {}
    GlState state;

    void capability(const Named& named) { state[named.name] = {double(gl_.IsEnabled(named.value))}; }
    void value(const Named& named, const std::string& prefix = "") {
        std::array<GLdouble, 16> numbers{};
        gl_.GetDoublev(named.value, numbers.data());
        state[prefix + named.name].assign(numbers.begin(), numbers.begin() + named.count);
    }
    template <std::size_t N>
    void indexed(const Named (&all)[N], GLint count) {
        for (GLint i = 0; i < count; ++i)
            for (const Named& named : all) {
                std::array<GLdouble, 16> numbers{};
                gl_.GetDoublei_v(named.value, static_cast<GLuint>(i), numbers.data());
                state[std::string(named.name) + " " + std::to_string(i)].assign(
                    numbers.begin(), numbers.begin() + named.count);
            }
    }
    void enabled(const Named& named, GLint count) {
        for (GLint i = 0; i < count; ++i)
            state[std::string(named.name) + " " + std::to_string(i)] = {
                double(gl_.IsEnabledi(named.value, static_cast<GLuint>(i)))};
    }

private:
    const GladGLContext& gl_;
};

}  // namespace

GlState gl_state(const GladGLContext& gl) {
    Reader reader(gl);
    for (const Named& named : capabilities) reader.capability(named);
    for (const Named& named : values) reader.value(named);
    if ((integer(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0) {
        for (const Named& named : old_capabilities) reader.capability(named);
        for (const Named& named : old_values) reader.value(named);
    }
    reader.indexed(of_draw_buffers, integer(gl, GL_MAX_DRAW_BUFFERS));
    reader.enabled(NAMED(GL_BLEND), integer(gl, GL_MAX_DRAW_BUFFERS));
    reader.indexed(of_viewports, integer(gl, GL_MAX_VIEWPORTS));
    reader.enabled(NAMED(GL_SCISSOR_TEST), integer(gl, GL_MAX_VIEWPORTS));
    reader.indexed(of_image_units, integer(gl, GL_MAX_IMAGE_UNITS));
    reader.indexed(of_buffer_bindings, std::min(integer(gl, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS),
                                                integer(gl, GL_MAX_UNIFORM_BUFFER_BINDINGS)));
    const GLint active = integer(gl, GL_ACTIVE_TEXTURE);
    for (GLint unit = 0; unit < integer(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const Named& named : unit_bindings) reader.value(named, "unit " + std::to_string(unit) + " ");
    }
    gl.ActiveTexture(static_cast<GLenum>(active));
    void* callback = nullptr;
    gl.GetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &callback);
    reader.state["GL_DEBUG_CALLBACK_FUNCTION"] = {double(reinterpret_cast<std::uintptr_t>(callback))};
    reader.state["error"] = {double(gl.GetError())};
    return reader.state;
}

std::string difference(const GlState& before, const GlState& after) {
    std::ostringstream text;
    for (const auto& [name, was] : before) {
        const auto found = after.find(name);
        if (found != after.end() && found->second == was) continue;
        text << name << ": was";
        for (const double value : was) text << ' ' << value;
        text << ", is";
        if (found == after.end())
            text << " gone";
        else
            for (const double value : found->second) text << ' ' << value;
        text << '\n';
    }
    if (after.size() != before.size()) text << after.size() << " values, not " << before.size() << '\n';
    return text.str();
}

GlState gl_names(const GladGLContext& gl) {
    GlState names;
    for (GLuint id = 1; id < 400; ++id) {
        const auto add = [&](const char* kind, GLboolean exists) {
            if (exists == GL_TRUE) names[kind].push_back(id);
        };
        add("buffer", gl.IsBuffer(id));
        add("framebuffer", gl.IsFramebuffer(id));
        add("program or shader", static_cast<GLboolean>(gl.IsProgram(id) | gl.IsShader(id)));
        add("renderbuffer", gl.IsRenderbuffer(id));
        add("sampler", gl.IsSampler(id));
        add("texture", gl.IsTexture(id));
        add("vertex array", gl.IsVertexArray(id));
    }
    return names;
}

}  // namespace host_test
