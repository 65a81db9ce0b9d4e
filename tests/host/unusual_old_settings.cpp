// SPDX-License-Identifier: MIT
#include "host/egl_host.hpp"
#include "host/unusual_state.hpp"

namespace host_test {
namespace {

using Gl = GladGLContext;

/// Calls a function of compatibility contexts, which the core-profile loader does not define.
template <class... Parameters>
void old(const char* name, Parameters... arguments) {
    reinterpret_cast<void (*)(Parameters...)>(egl().proc_address(name))(arguments...);
}

constexpr GLenum alpha_test = 0x0BC0, polygon_stipple = 0x0B42, modelview = 0x1700, projection = 0x1701,
                 flat = 0x1D00, smooth = 0x1D01, filter_control = 0x8500, lod_bias = 0x8501,
                 all_attributes = 0xFFFFF, vertex_array = 0x8074, map_r_to_r = 0x0C76, map_color = 0x0D10,
                 index_shift = 0x0D12, index_offset = 0x0D13, clamp_vertex_color = 0x891A,
                 clamp_fragment_color = 0x891B;

UnusualStates pixel_transfers() {
    UnusualStates states;
    for (const auto& [name, value] : {Constant{"GL_RED_SCALE", 0x0D14}, Constant{"GL_GREEN_SCALE", 0x0D18},
                                      Constant{"GL_BLUE_SCALE", 0x0D1A}, Constant{"GL_ALPHA_SCALE", 0x0D1C},
                                      Constant{"GL_DEPTH_SCALE", 0x0D1E}}) {
        const std::string text = name;
        states.push_back({text, [scale = value](const Gl&, bool on) {
                              old<GLenum, GLfloat>("glPixelTransferf", scale, on ? 0.25F : 1);
                          }});
        states.push_back({"bias after " + text, [bias = value + 1](const Gl&, bool on) {
                              old<GLenum, GLfloat>("glPixelTransferf", bias, on ? 0.5F : 0);
                          }});
    }
    states.push_back({"mapped colours", [](const Gl&, bool on) {
                          const GLfloat zeros[] = {0, 0};
                          old<GLenum, GLint>("glPixelTransferi", map_color, on ? 1 : 0);
                          old<GLenum, GLsizei, const GLfloat*>("glPixelMapfv", map_r_to_r, on ? 2 : 1, zeros);
                      }});
    states.push_back({"integers shifted", [](const Gl&, bool on) {
                          old<GLenum, GLint>("glPixelTransferi", index_shift, on ? 3 : 0);
                          old<GLenum, GLint>("glPixelTransferi", index_offset, on ? 5 : 0);
                      }});
    return states;
}

}  // namespace

UnusualStates unusual_old_settings() {
    UnusualStates states{
        {"alpha test",
         [](const Gl& gl, bool on) {
             enable(gl, alpha_test, on);
             old<GLenum, GLfloat>("glAlphaFunc", on ? GL_NEVER : GL_ALWAYS, 0);
         }},
        {"polygon stipple",
         [](const Gl& gl, bool on) {
             enable(gl, polygon_stipple, on);
             std::array<GLubyte, 128> pattern{};
             if (!on) pattern.fill(255);
             old<const GLubyte*>("glPolygonStipple", pattern.data());
         }},
        {"polygon modes apart",
         [](const Gl& gl, bool on) {
             gl.PolygonMode(GL_FRONT, on ? GL_LINE : GL_FILL);
             gl.PolygonMode(GL_BACK, on ? GL_POINT : GL_FILL);
         }},
        {"fragment colours clamped",
         [](const Gl& gl, bool on) { gl.ClampColor(clamp_fragment_color, on ? GL_TRUE : GL_FIXED_ONLY); }},
        {"vertex colours not clamped",
         [](const Gl& gl, bool on) { gl.ClampColor(clamp_vertex_color, on ? GL_FALSE : GL_TRUE); }},
        {"flat shading", [](const Gl&, bool on) { old<GLenum>("glShadeModel", on ? flat : smooth); }},
        {"matrices",
         [](const Gl&, bool on) {
             for (const GLenum mode : {projection, modelview}) {
                 old<GLenum>("glMatrixMode", mode);
                 if (on)
                     old<GLfloat, GLfloat, GLfloat>("glScalef", 0, 2, 3);
                 else
                     old("glLoadIdentity");
             }
         }},
        {"matrix mode", [](const Gl&, bool on) { old<GLenum>("glMatrixMode", on ? projection : modelview); }},
        {"current colour",
         [](const Gl&, bool on) {
             old<GLfloat, GLfloat, GLfloat, GLfloat>("glColor4f", on ? 0.25F : 1, 1, 1, on ? 0 : 1);
         }},
        {"attribute stack",
         [](const Gl&, bool on) {
             if (on)
                 old<GLbitfield>("glPushAttrib", all_attributes);
             else
                 old("glPopAttrib");
         }},
        {"level of detail",
         [](const Gl& gl, bool on) {
             for (GLuint unit = 0; unit < 8; ++unit) {
                 gl.ActiveTexture(GL_TEXTURE0 + unit);
                 old<GLenum, GLenum, GLfloat>("glTexEnvf", filter_control, lod_bias, on ? 4 : 0);
             }
             gl.ActiveTexture(GL_TEXTURE0);
         }},
        {"client arrays",
         [](const Gl&, bool on) {
             old<GLenum>(on ? "glEnableClientState" : "glDisableClientState", vertex_array);
         }},
        {"lists' base", [](const Gl&, bool on) { old<GLuint>("glListBase", on ? 17 : 0); }}};
    for (const auto& [name, value] :
         {Constant{"GL_LIGHTING", 0x0B50}, Constant{"GL_FOG", 0x0B60}, Constant{"GL_LINE_STIPPLE", 0x0B24},
          Constant{"GL_POINT_SMOOTH", 0x0B10}, Constant{"GL_POINT_SPRITE", 0x8861},
          Constant{"GL_INDEX_LOGIC_OP", 0x0BF1}, Constant{"GL_COLOR_MATERIAL", 0x0B57},
          Constant{"GL_NORMALIZE", 0x0BA1}, Constant{"GL_RESCALE_NORMAL", 0x803A},
          Constant{"GL_AUTO_NORMAL", 0x0D80}, Constant{"GL_COLOR_SUM", 0x8458},
          Constant{"GL_VERTEX_PROGRAM_TWO_SIDE", 0x8643}, Constant{"GL_TEXTURE_1D", GL_TEXTURE_1D},
          Constant{"GL_TEXTURE_2D", GL_TEXTURE_2D}, Constant{"GL_TEXTURE_CUBE_MAP", GL_TEXTURE_CUBE_MAP},
          Constant{"GL_TEXTURE_GEN_S", 0x0C60}, Constant{"GL_VERTEX_PROGRAM_ARB", 0x8620},
          Constant{"GL_FRAGMENT_PROGRAM_ARB", 0x8804}})
        states.push_back({name, [value = value](const Gl& gl, bool on) { enable(gl, value, on); }});
    for (const UnusualState& state : pixel_transfers()) states.push_back(state);
    return states;
}

}  // namespace host_test
