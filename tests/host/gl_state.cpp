// SPDX-License-Identifier: MIT
#include "host/gl_state.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <sstream>

namespace host_test {
namespace {

struct Named {
    std::string name;
    GLenum value;
    int count = 1;  ///< number of values
};
using Names = std::vector<Named>;

Names named(int count, const std::string& names, std::initializer_list<GLenum> values) {
    Names all;
    std::istringstream words(names);
    for (const GLenum value : values) {
        std::string name;
        std::getline(words >> std::ws, name, ',');
        all.push_back({name, value, count});
    }
    return all;
}
/// Constants of OpenGL with their names, each of `count` values.
#define NAMED(count, ...) named(count, #__VA_ARGS__, {__VA_ARGS__})

const Names capabilities = NAMED(
    1, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_DITHER, GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT, GL_POLYGON_SMOOTH, GL_LINE_SMOOTH, GL_MULTISAMPLE,
    GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK,
    GL_SAMPLE_SHADING, GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_RASTERIZER_DISCARD,
    GL_DEPTH_CLAMP, GL_FRAMEBUFFER_SRGB, GL_PROGRAM_POINT_SIZE, GL_DEBUG_OUTPUT, GL_DEBUG_OUTPUT_SYNCHRONOUS,
    GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1, GL_CLIP_DISTANCE2, GL_CLIP_DISTANCE3,
    GL_CLIP_DISTANCE4, GL_CLIP_DISTANCE5, GL_CLIP_DISTANCE6, GL_CLIP_DISTANCE7);
const Names values[] = {
    NAMED(1, GL_DEPTH_WRITEMASK, GL_DEPTH_FUNC, GL_DEPTH_CLEAR_VALUE, GL_STENCIL_CLEAR_VALUE,
          GL_STENCIL_WRITEMASK, GL_STENCIL_BACK_WRITEMASK, GL_STENCIL_FUNC, GL_STENCIL_REF,
          GL_STENCIL_VALUE_MASK, GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS,
          GL_CULL_FACE_MODE, GL_FRONT_FACE, GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_OFFSET_UNITS,
          GL_PROVOKING_VERTEX, GL_CLIP_ORIGIN, GL_CLIP_DEPTH_MODE, GL_LOGIC_OP_MODE, GL_LINE_WIDTH,
          GL_POINT_SIZE, GL_SAMPLE_COVERAGE_VALUE, GL_MIN_SAMPLE_SHADING_VALUE, GL_PRIMITIVE_RESTART_INDEX,
          GL_PATCH_VERTICES, GL_CURRENT_PROGRAM, GL_PROGRAM_PIPELINE_BINDING, GL_VERTEX_ARRAY_BINDING,
          GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_RENDERBUFFER_BINDING,
          GL_ARRAY_BUFFER_BINDING, GL_COPY_READ_BUFFER_BINDING, GL_COPY_WRITE_BUFFER_BINDING,
          GL_DRAW_INDIRECT_BUFFER_BINDING, GL_DISPATCH_INDIRECT_BUFFER_BINDING, GL_PIXEL_PACK_BUFFER_BINDING,
          GL_PIXEL_UNPACK_BUFFER_BINDING, GL_QUERY_BUFFER_BINDING, GL_UNIFORM_BUFFER_BINDING,
          GL_SHADER_STORAGE_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_BINDING,
          GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BINDING, GL_TEXTURE_BUFFER_BINDING,
          GL_ACTIVE_TEXTURE, GL_READ_BUFFER, GL_CLAMP_READ_COLOR, GL_FRAGMENT_SHADER_DERIVATIVE_HINT,
          GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_ROWS,
          GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_PACK_ALIGNMENT, GL_UNPACK_SWAP_BYTES,
          GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS,
          GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_ALIGNMENT, GL_DEBUG_GROUP_STACK_DEPTH,
          GL_DEBUG_LOGGED_MESSAGES, GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK,
          GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS,
          GL_SAMPLE_COVERAGE_INVERT, GL_POINT_FADE_THRESHOLD_SIZE, GL_POINT_SPRITE_COORD_ORIGIN,
          GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT,
          GL_TRANSFORM_FEEDBACK_ACTIVE, GL_TRANSFORM_FEEDBACK_PAUSED, GL_ELEMENT_ARRAY_BUFFER_BINDING,
          GL_DRAW_BUFFER0, GL_DRAW_BUFFER1, GL_PACK_COMPRESSED_BLOCK_WIDTH, GL_PACK_COMPRESSED_BLOCK_HEIGHT,
          GL_PACK_COMPRESSED_BLOCK_DEPTH, GL_PACK_COMPRESSED_BLOCK_SIZE, GL_UNPACK_COMPRESSED_BLOCK_WIDTH,
          GL_UNPACK_COMPRESSED_BLOCK_HEIGHT, GL_UNPACK_COMPRESSED_BLOCK_DEPTH,
          GL_UNPACK_COMPRESSED_BLOCK_SIZE),
    NAMED(4, GL_COLOR_CLEAR_VALUE, GL_BLEND_COLOR, GL_PATCH_DEFAULT_OUTER_LEVEL),
    NAMED(2, GL_POLYGON_MODE, GL_PATCH_DEFAULT_INNER_LEVEL)};

// Capabilities of compatibility contexts. The core-profile loader does not define their names.
const Names old_capabilities = {{"GL_ALPHA_TEST", 0x0BC0},
                                {"GL_POLYGON_STIPPLE", 0x0B42},
                                {"GL_LIGHTING", 0x0B50},
                                {"GL_FOG", 0x0B60},
                                {"GL_LINE_STIPPLE", 0x0B24},
                                {"GL_POINT_SMOOTH", 0x0B10},
                                {"GL_INDEX_LOGIC_OP", 0x0BF1},
                                {"GL_COLOR_MATERIAL", 0x0B57},
                                {"GL_NORMALIZE", 0x0BA1},
                                {"GL_COLOR_SUM", 0x8458},
                                {"GL_VERTEX_PROGRAM_TWO_SIDE", 0x8643},
                                {"GL_VERTEX_PROGRAM_ARB", 0x8620},
                                {"GL_FRAGMENT_PROGRAM_ARB", 0x8804},
                                {"GL_TEXTURE_2D", GL_TEXTURE_2D}};
const Names old_values = {{"GL_ALPHA_TEST_FUNC", 0x0BC1},
                          {"GL_ALPHA_TEST_REF", 0x0BC2},
                          {"GL_CLAMP_FRAGMENT_COLOR", 0x891B},
                          {"GL_CLAMP_VERTEX_COLOR", 0x891A},
                          {"GL_MATRIX_MODE", 0x0BA0},
                          {"GL_CURRENT_COLOR", 0x0B00, 4},
                          {"GL_MODELVIEW_MATRIX", 0x0BA6, 16},
                          {"GL_PROJECTION_MATRIX", 0x0BA7, 16},
                          {"GL_SHADE_MODEL", 0x0B54},
                          {"GL_RENDER_MODE", 0x0C40},
                          {"GL_LIST_BASE", 0x0B32},
                          {"GL_LINE_STIPPLE_PATTERN", 0x0B25},
                          {"GL_ATTRIB_STACK_DEPTH", 0x0BB0},
                          {"GL_CLIENT_ACTIVE_TEXTURE", 0x84E1},
                          {"GL_CURRENT_NORMAL", 0x0B02, 3},
                          {"GL_MAP_STENCIL", 0x0D11},
                          {"GL_INDEX_SHIFT", 0x0D12},
                          {"GL_INDEX_OFFSET", 0x0D13},
                          {"GL_DEPTH_SCALE", 0x0D1E},
                          {"GL_DEPTH_BIAS", 0x0D1F},
                          {"GL_MAP_COLOR", 0x0D10},
                          {"GL_RED_SCALE", 0x0D14},
                          {"GL_RED_BIAS", 0x0D15},
                          {"GL_GREEN_SCALE", 0x0D18},
                          {"GL_GREEN_BIAS", 0x0D19},
                          {"GL_BLUE_SCALE", 0x0D1A},
                          {"GL_BLUE_BIAS", 0x0D1B},
                          {"GL_ALPHA_SCALE", 0x0D1C},
                          {"GL_ALPHA_BIAS", 0x0D1D}};

const Names unit_bindings =
    NAMED(1, GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_1D_ARRAY,
          GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_RECTANGLE, GL_TEXTURE_BINDING_BUFFER,
          GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE,
          GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY, GL_SAMPLER_BINDING);
// State of each draw buffer, viewport, image unit or binding point.
const Names of_draw_buffers[] = {NAMED(1, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                       GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA),
                                 NAMED(4, GL_COLOR_WRITEMASK)};
const Names of_viewports[] = {NAMED(4, GL_VIEWPORT, GL_SCISSOR_BOX), NAMED(2, GL_DEPTH_RANGE)};
const Names of_image_units = NAMED(1, GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED,
                                   GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT);
const Names of_buffer_bindings =
    NAMED(1, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE,
          GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE);
const Names of_counter_bindings =
    NAMED(1, GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE);
const Names of_feedback_bindings =
    NAMED(1, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_START,
          GL_TRANSFORM_FEEDBACK_BUFFER_SIZE);
const Names of_sample_masks = NAMED(1, GL_SAMPLE_MASK_VALUE);
const Names queries =
    NAMED(1, GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE,
          GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED);

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
    void indexed(const Names& all, GLint count) {
        for (GLint i = 0; i < count; ++i)
            for (const Named& named : all) {
                std::array<GLdouble, 16> numbers{};
                gl_.GetDoublei_v(named.value, static_cast<GLuint>(i), numbers.data());
                state[named.name + " " + std::to_string(i)].assign(numbers.begin(),
                                                                   numbers.begin() + named.count);
            }
    }
    void enabled(const Named& named, GLint count) {
        for (GLint i = 0; i < count; ++i)
            state[named.name + " " + std::to_string(i)] = {
                double(gl_.IsEnabledi(named.value, static_cast<GLuint>(i)))};
    }

    void vertex_attributes() {
        // Attribute 0 has no current value in compatibility contexts.
        for (GLuint i = 1; i < static_cast<GLuint>(integer(gl_, GL_MAX_VERTEX_ATTRIBS)); ++i) {
            std::array<GLdouble, 4> current{};
            GLint enabled = 0, buffer = 0;
            gl_.GetVertexAttribdv(i, GL_CURRENT_VERTEX_ATTRIB, current.data());
            gl_.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
            gl_.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
            std::vector<double>& numbers = state["vertex attribute " + std::to_string(i)];
            numbers.assign(current.begin(), current.end());
            numbers.insert(numbers.end(), {double(enabled), double(buffer)});
        }
    }
    void active_queries() {
        for (const Named& named : queries) {
            GLint active = 0;
            gl_.GetQueryiv(named.value, GL_CURRENT_QUERY, &active);
            state["query " + named.name] = {double(active)};
        }
    }

private:
    const GladGLContext& gl_;
};

}  // namespace

GlState gl_state(const GladGLContext& gl) {
    Reader reader(gl);
    for (const Named& named : capabilities) reader.capability(named);
    for (const Names& names : values)
        for (const Named& named : names) reader.value(named);
    if ((integer(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0) {
        for (const Named& named : old_capabilities) reader.capability(named);
        for (const Named& named : old_values) reader.value(named);
    }
    for (const Names& names : of_draw_buffers) reader.indexed(names, integer(gl, GL_MAX_DRAW_BUFFERS));
    reader.enabled(NAMED(1, GL_BLEND).front(), integer(gl, GL_MAX_DRAW_BUFFERS));
    for (const Names& names : of_viewports) reader.indexed(names, integer(gl, GL_MAX_VIEWPORTS));
    reader.enabled(NAMED(1, GL_SCISSOR_TEST).front(), integer(gl, GL_MAX_VIEWPORTS));
    reader.indexed(of_image_units, integer(gl, GL_MAX_IMAGE_UNITS));
    reader.indexed(of_buffer_bindings, std::min(integer(gl, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS),
                                                integer(gl, GL_MAX_UNIFORM_BUFFER_BINDINGS)));
    reader.indexed(of_counter_bindings, integer(gl, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS));
    reader.indexed(of_feedback_bindings, integer(gl, GL_MAX_TRANSFORM_FEEDBACK_BUFFERS));
    reader.indexed(of_sample_masks, integer(gl, GL_MAX_SAMPLE_MASK_WORDS));
    reader.vertex_attributes();
    reader.active_queries();
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
        add("query", gl.IsQuery(id));
        add("program or shader", static_cast<GLboolean>(gl.IsProgram(id) | gl.IsShader(id)));
        add("renderbuffer", gl.IsRenderbuffer(id));
        add("sampler", gl.IsSampler(id));
        add("texture", gl.IsTexture(id));
        add("vertex array", gl.IsVertexArray(id));
    }
    return names;
}

}  // namespace host_test
