// SPDX-License-Identifier: MIT
#include "host/unusual_state.hpp"

namespace host_test {
namespace {

using Gl = GladGLContext;

void add_capabilities(UnusualStates& states, std::initializer_list<Constant> capabilities, bool initial) {
    for (const auto& [name, value] : capabilities)
        states.push_back({name, [value = value, initial](const Gl& gl, bool unusual) {
                              enable(gl, value, unusual != initial);
                          }});
}

UnusualStates capabilities() {
    UnusualStates states;
    add_capabilities(states,
                     {GL_CONSTANT(GL_DEPTH_TEST),
                      GL_CONSTANT(GL_STENCIL_TEST),
                      GL_CONSTANT(GL_CULL_FACE),
                      GL_CONSTANT(GL_BLEND),
                      GL_CONSTANT(GL_COLOR_LOGIC_OP),
                      GL_CONSTANT(GL_POLYGON_OFFSET_FILL),
                      GL_CONSTANT(GL_POLYGON_OFFSET_LINE),
                      GL_CONSTANT(GL_POLYGON_OFFSET_POINT),
                      GL_CONSTANT(GL_POLYGON_SMOOTH),
                      GL_CONSTANT(GL_LINE_SMOOTH),
                      GL_CONSTANT(GL_SAMPLE_ALPHA_TO_COVERAGE),
                      GL_CONSTANT(GL_SAMPLE_ALPHA_TO_ONE),
                      GL_CONSTANT(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                      GL_CONSTANT(GL_RASTERIZER_DISCARD),
                      GL_CONSTANT(GL_DEPTH_CLAMP),
                      GL_CONSTANT(GL_FRAMEBUFFER_SRGB),
                      GL_CONSTANT(GL_PROGRAM_POINT_SIZE),
                      GL_CONSTANT(GL_TEXTURE_CUBE_MAP_SEAMLESS),
                      GL_CONSTANT(GL_DEBUG_OUTPUT),
                      GL_CONSTANT(GL_DEBUG_OUTPUT_SYNCHRONOUS),
                      GL_CONSTANT(GL_CLIP_DISTANCE0),
                      GL_CONSTANT(GL_CLIP_DISTANCE1),
                      GL_CONSTANT(GL_CLIP_DISTANCE2),
                      GL_CONSTANT(GL_CLIP_DISTANCE3),
                      GL_CONSTANT(GL_CLIP_DISTANCE4),
                      GL_CONSTANT(GL_CLIP_DISTANCE5),
                      GL_CONSTANT(GL_CLIP_DISTANCE6),
                      GL_CONSTANT(GL_CLIP_DISTANCE7)},
                     false);
    add_capabilities(states, {GL_CONSTANT(GL_DITHER), GL_CONSTANT(GL_MULTISAMPLE)}, true);
    return states;
}

/// Returns settings of the tests and the blending of fragments and samples.
UnusualStates fragment_states() {
    UnusualStates states{
        {"depth function", [](const Gl& gl, bool on) { gl.DepthFunc(on ? GL_NEVER : GL_LESS); }},
        {"depth mask", [](const Gl& gl, bool on) { gl.DepthMask(on ? GL_FALSE : GL_TRUE); }},
        {"clear depth", [](const Gl& gl, bool on) { gl.ClearDepth(on ? 0 : 1); }},
        {"clear colour", [](const Gl& gl, bool on) { gl.ClearColor(on ? 0.5F : 0, 0, 0, 0); }},
        {"clear stencil", [](const Gl& gl, bool on) { gl.ClearStencil(on ? 3 : 0); }},
        {"stencil",
         [](const Gl& gl, bool on) {
             enable(gl, GL_STENCIL_TEST, on);
             gl.StencilFunc(on ? GL_NEVER : GL_ALWAYS, on ? 1 : 0, on ? 3 : 255);
             gl.StencilFuncSeparate(GL_BACK, on ? GL_NEVER : GL_ALWAYS, on ? 2 : 0, on ? 5 : 255);
             gl.StencilOp(on ? GL_INVERT : GL_KEEP, on ? GL_ZERO : GL_KEEP, on ? GL_INCR : GL_KEEP);
             gl.StencilMask(on ? 6 : 255);
         }},
        {"logical operation",
         [](const Gl& gl, bool on) {
             enable(gl, GL_COLOR_LOGIC_OP, on);
             gl.LogicOp(on ? GL_INVERT : GL_COPY);
         }},
        {"blend colour", [](const Gl& gl, bool on) { gl.BlendColor(on ? 0.25F : 0, 0, 0, 0); }},
        {"sample coverage",
         [](const Gl& gl, bool on) {
             enable(gl, GL_SAMPLE_COVERAGE, on);
             gl.SampleCoverage(on ? 0 : 1, on ? GL_TRUE : GL_FALSE);
         }},
        {"sample mask",
         [](const Gl& gl, bool on) {
             enable(gl, GL_SAMPLE_MASK, on);
             gl.SampleMaski(0, on ? 0 : ~0U);
         }},
        {"sample shading",
         [](const Gl& gl, bool on) {
             enable(gl, GL_SAMPLE_SHADING, on);
             gl.MinSampleShading(on ? 1 : 0);
         }},
        {"blending",
         [](const Gl& gl, bool on) {
             enable(gl, GL_BLEND, on);
             gl.BlendFunc(on ? GL_ZERO : GL_ONE, on ? GL_ONE : GL_ZERO);
         }},
        {"blend equations apart", [](const Gl& gl, bool on) {
             gl.BlendEquationSeparate(on ? GL_MAX : GL_FUNC_ADD, on ? GL_MIN : GL_FUNC_ADD);
         }}};
    for (const GLenum factor :
         {GL_SRC1_COLOR, GL_ONE_MINUS_SRC1_COLOR, GL_SRC1_ALPHA, GL_ONE_MINUS_SRC1_ALPHA}) {
        states.push_back({"second source " + std::to_string(factor),
                          [factor](const Gl& gl, bool on) { gl.BlendFunc(GL_ONE, on ? factor : GL_ZERO); }});
        states.push_back(
            {"second source of alpha " + std::to_string(factor), [factor](const Gl& gl, bool on) {
                 gl.BlendFuncSeparate(GL_ONE, GL_ZERO, on ? factor : GL_ONE, GL_ZERO);
             }});
    }
    constexpr GLenum multiply = 0x9294;       // GL_MULTIPLY_KHR of an extension
    for (const bool first : {false, true}) {  // without the first draw buffer
        states.push_back({"advanced blending, " + std::to_string(first), [first](const Gl& gl, bool on) {
                              gl.BlendEquation(on ? multiply : GL_FUNC_ADD);
                              static_cast<void>(gl.GetError());
                              enable(gl, GL_BLEND, on);
                              if (!first) gl.Disablei(GL_BLEND, 0);
                          }});
    }
    for (GLuint i = 0; i < 8; ++i) {
        const std::string buffer = " of draw buffer " + std::to_string(i);
        states.push_back({"mask" + buffer, [i](const Gl& gl, bool on) {
                              const GLboolean other = on ? GL_FALSE : GL_TRUE;
                              gl.ColorMaski(i, other, GL_TRUE, other, GL_TRUE);
                          }});
        states.push_back({"blending" + buffer, [i](const Gl& gl, bool on) {
                              (on ? gl.Enablei : gl.Disablei)(GL_BLEND, i);
                              gl.BlendFunci(i, on ? GL_ZERO : GL_ONE, on ? GL_SRC1_COLOR : GL_ZERO);
                              gl.BlendEquationi(i, on ? GL_FUNC_SUBTRACT : GL_FUNC_ADD);
                          }});
    }
    return states;
}

/// Returns settings of vertex and primitive processing.
UnusualStates primitive_states() {
    UnusualStates states{
        {"culled face",
         [](const Gl& gl, bool on) {
             enable(gl, GL_CULL_FACE, on);
             gl.CullFace(on ? GL_FRONT_AND_BACK : GL_BACK);
         }},
        {"front face", [](const Gl& gl, bool on) { gl.FrontFace(on ? GL_CW : GL_CCW); }},
        {"polygon mode",
         [](const Gl& gl, bool on) { gl.PolygonMode(GL_FRONT_AND_BACK, on ? GL_POINT : GL_FILL); }},
        {"provoking vertex",
         [](const Gl& gl, bool on) {
             gl.ProvokingVertex(on ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
         }},
        {"clip control",
         [](const Gl& gl, bool on) {
             gl.ClipControl(on ? GL_UPPER_LEFT : GL_LOWER_LEFT, on ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
         }},
        {"primitive restart",
         [](const Gl& gl, bool on) {
             enable(gl, GL_PRIMITIVE_RESTART, on);
             gl.PrimitiveRestartIndex(on ? 2 : 0);
         }},
        {"line width", [](const Gl& gl, bool on) { gl.LineWidth(on ? 3 : 1); }},
        {"point size", [](const Gl& gl, bool on) { gl.PointSize(on ? 5 : 1); }},
        {"point parameters",
         [](const Gl& gl, bool on) {
             gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, on ? 4 : 1);
             gl.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, on ? GL_LOWER_LEFT : GL_UPPER_LEFT);
         }},
        {"patches",
         [](const Gl& gl, bool on) {
             const float levels[] = {on ? 7.0F : 1, 1, 1, 1};
             gl.PatchParameteri(GL_PATCH_VERTICES, on ? 5 : 3);
             gl.PatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels);
             gl.PatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels);
         }},
        {"current attributes",
         [](const Gl& gl, bool on) {
             for (GLuint i = 1; i < 16; ++i) gl.VertexAttrib4f(i, on ? 9 : 0, 0, 0, on ? 7 : 1);
         }},
        {"hints",
         [](const Gl& gl, bool on) {
             for (const GLenum hint : {GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_LINE_SMOOTH_HINT,
                                       GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT})
                 gl.Hint(hint, on ? GL_FASTEST : GL_DONT_CARE);
         }},
        {"read colour clamped",
         [](const Gl& gl, bool on) { gl.ClampColor(GL_CLAMP_READ_COLOR, on ? GL_TRUE : GL_FIXED_ONLY); }}};
    for (const GLenum kind : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT}) {
        states.push_back({"polygon offset " + std::to_string(kind), [kind](const Gl& gl, bool on) {
                              enable(gl, kind, on);
                              gl.PolygonOffset(on ? 1e6F : 0, on ? 1e6F : 0);
                          }});
    }
    for (GLuint i = 0; i < 16; i += 5) {
        const std::string viewport = " of viewport " + std::to_string(i);
        states.push_back({"rectangle" + viewport, [i](const Gl& gl, bool on) {
                              gl.ViewportIndexedf(i, on ? 2.5F : 0, 0, on ? 3 : 0, on ? 5 : 0);
                          }});
        states.push_back({"depth range" + viewport, [i](const Gl& gl, bool on) {
                              gl.DepthRangeIndexed(i, on ? 0.75 : 0, on ? 0.25 : 1);
                          }});
        states.push_back({"scissor" + viewport, [i](const Gl& gl, bool on) {
                              (on ? gl.Enablei : gl.Disablei)(GL_SCISSOR_TEST, i);
                              gl.ScissorIndexed(i, on ? 3 : 0, 0, on ? 2 : 0, on ? 2 : 0);
                          }});
    }
    return states;
}

UnusualStates pixel_states() {
    UnusualStates states;
    for (const auto& [name, value] :
         {GL_CONSTANT(GL_PACK_SWAP_BYTES), GL_CONSTANT(GL_PACK_LSB_FIRST), GL_CONSTANT(GL_PACK_ROW_LENGTH),
          GL_CONSTANT(GL_PACK_IMAGE_HEIGHT), GL_CONSTANT(GL_PACK_SKIP_ROWS), GL_CONSTANT(GL_PACK_SKIP_PIXELS),
          GL_CONSTANT(GL_PACK_SKIP_IMAGES), GL_CONSTANT(GL_UNPACK_SWAP_BYTES),
          GL_CONSTANT(GL_UNPACK_LSB_FIRST), GL_CONSTANT(GL_UNPACK_ROW_LENGTH),
          GL_CONSTANT(GL_UNPACK_IMAGE_HEIGHT), GL_CONSTANT(GL_UNPACK_SKIP_ROWS),
          GL_CONSTANT(GL_UNPACK_SKIP_PIXELS), GL_CONSTANT(GL_UNPACK_SKIP_IMAGES)})
        states.push_back(
            {name, [value = value](const Gl& gl, bool on) { gl.PixelStorei(value, on ? 1 : 0); }});
    for (const auto& [name, value] :
         {GL_CONSTANT(GL_PACK_COMPRESSED_BLOCK_WIDTH), GL_CONSTANT(GL_PACK_COMPRESSED_BLOCK_HEIGHT),
          GL_CONSTANT(GL_PACK_COMPRESSED_BLOCK_DEPTH), GL_CONSTANT(GL_PACK_COMPRESSED_BLOCK_SIZE),
          GL_CONSTANT(GL_UNPACK_COMPRESSED_BLOCK_WIDTH), GL_CONSTANT(GL_UNPACK_COMPRESSED_BLOCK_HEIGHT),
          GL_CONSTANT(GL_UNPACK_COMPRESSED_BLOCK_DEPTH), GL_CONSTANT(GL_UNPACK_COMPRESSED_BLOCK_SIZE)})
        states.push_back(
            {name, [value = value](const Gl& gl, bool on) { gl.PixelStorei(value, on ? 4 : 0); }});
    for (const auto& [name, value] : {GL_CONSTANT(GL_PACK_ALIGNMENT), GL_CONSTANT(GL_UNPACK_ALIGNMENT)})
        states.push_back(
            {name, [value = value](const Gl& gl, bool on) { gl.PixelStorei(value, on ? 8 : 4); }});
    return states;
}

}  // namespace

UnusualStates unusual_settings() {
    UnusualStates all;
    for (const UnusualStates& states :
         {capabilities(), fragment_states(), primitive_states(), pixel_states()})
        all.insert(all.end(), states.begin(), states.end());
    return all;
}

}  // namespace host_test
