// SPDX-License-Identifier: MIT
// Save, reset and restore of a host's state. Each restoring command is kept before its state changes.
#include "gl/host_state.hpp"

#include <algorithm>
#include <array>

#include "gl/host_program.hpp"

namespace nicol::gl {
namespace {

// State of compatibility contexts. The core-profile loader does not define these names.
constexpr GLenum kAlphaTest = 0x0BC0, kPolygonStipple = 0x0B42, kClampFragmentColor = 0x891B,
                 kFixedOnly = 0x891D;
using PixelTransfer = void(GLAD_API_PTR*)(GLenum, GLfloat);

/// Capabilities that are off while the library draws. Dithering is on in a fresh context, but contexts of our
/// own switch it off too. Each draw sets the depth test and culling.
// Mesa offsets filled polygons, too, if it offsets lines or points.
constexpr std::array kCapabilitiesOff{GL_STENCIL_TEST,
                                      GL_COLOR_LOGIC_OP,
                                      GL_DITHER,
                                      GL_POLYGON_OFFSET_FILL,
                                      GL_POLYGON_OFFSET_LINE,
                                      GL_POLYGON_OFFSET_POINT,
                                      GL_POLYGON_SMOOTH,
                                      GL_SAMPLE_ALPHA_TO_COVERAGE,
                                      GL_SAMPLE_ALPHA_TO_ONE,
                                      GL_SAMPLE_COVERAGE,
                                      GL_SAMPLE_MASK,
                                      GL_SAMPLE_SHADING,
                                      GL_PRIMITIVE_RESTART,
                                      GL_PRIMITIVE_RESTART_FIXED_INDEX,
                                      GL_RASTERIZER_DISCARD,
                                      GL_DEPTH_CLAMP,
                                      GL_FRAMEBUFFER_SRGB};

struct Setting {
    GLenum name;
    GLfloat fresh;
};

/// GL_MAP_COLOR, then scale and bias of red, green, blue and alpha.
constexpr std::array kPixelTransfers{Setting{0x0D10, 0}, Setting{0x0D14, 1}, Setting{0x0D15, 0},
                                     Setting{0x0D18, 1}, Setting{0x0D19, 0}, Setting{0x0D1A, 1},
                                     Setting{0x0D1B, 0}, Setting{0x0D1C, 1}, Setting{0x0D1D, 0}};

/// Returns whether a blend function takes a second source.
bool takes_second_source(GLenum function) {
    constexpr std::array second{GL_SRC1_COLOR, GL_ONE_MINUS_SRC1_COLOR, GL_SRC1_ALPHA,
                                GL_ONE_MINUS_SRC1_ALPHA};
    return std::ranges::find(second, static_cast<int>(function)) != second.end();
}

}  // namespace

HostState::HostState(const Context::State& state, bool restores)
    : state_(state), gl_(state.gl), restoring_(restores) {}

HostState::~HostState() {
    unbind_storages();
    for (; !restores_.empty(); restores_.pop_back()) restores_.back()();
}

template <class Set>
void HostState::set(GLenum name, GLint fresh, Set set) {
    if (restoring_) {
        const GLint found = state_.integer(name);
        if (found == fresh) return;
        restore([set, found] { set(found); });
    }
    set(fresh);
}

void HostState::disable(GLenum capability) {
    if (restoring_) {
        if (gl_.IsEnabled(capability) == GL_FALSE) return;
        restore([this, capability] { gl_.Enable(capability); });
    }
    gl_.Disable(capability);
}

void HostState::prepare_drawing() {
    if (!first(Kind::drawing)) return;
    for (const auto capability : kCapabilitiesOff) disable(static_cast<GLenum>(capability));
    for (GLint i = 0; i < state_.clip_distances; ++i) disable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    if (restoring_) save_what_draws_set();
    set_rasterisation();
    set_viewport();
    if (!restoring_) {
        gl_.Disable(GL_BLEND);
        return gl_.BlendFunc(GL_ONE, GL_ZERO);
    }
    for (GLuint i = 0; i < kDrawBuffers; ++i) set_draw_buffer(i);
    for (GLuint i = 0; i < kBlendedBuffers; ++i) set_blending(i);
}

void HostState::save_what_draws_set() {
    for (const GLenum capability : {GLenum{GL_DEPTH_TEST}, GLenum{GL_CULL_FACE}}) {
        const auto command = gl_.IsEnabled(capability) == GL_TRUE ? gl_.Enable : gl_.Disable;
        restore([command, capability] { command(capability); });
    }
    GLboolean depth_mask = GL_TRUE;
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask);
    restore([this, depth_mask, function = name(GL_DEPTH_FUNC), culled = name(GL_CULL_FACE_MODE)] {
        gl_.DepthMask(depth_mask);
        gl_.DepthFunc(function);
        gl_.CullFace(culled);
    });
    restore([this, array = name(GL_VERTEX_ARRAY_BINDING), target = name(GL_DRAW_FRAMEBUFFER_BINDING)] {
        gl_.BindVertexArray(array);
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    });
}

void HostState::set_rasterisation() {
    set(GL_FRONT_FACE, GL_CCW, [this](GLint face) { gl_.FrontFace(static_cast<GLenum>(face)); });
    set(GL_PROVOKING_VERTEX, GL_LAST_VERTEX_CONVENTION,
        [this](GLint vertex) { gl_.ProvokingVertex(static_cast<GLenum>(vertex)); });
    if (restoring_) {
        restore([this, origin = name(GL_CLIP_ORIGIN), depth = name(GL_CLIP_DEPTH_MODE)] {
            gl_.ClipControl(origin, depth);
        });
        std::array<GLint, 2> mode{};
        gl_.GetIntegerv(GL_POLYGON_MODE, mode.data());
        restore([this, mode] {
            if (!state_.compatibility)
                return gl_.PolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(mode[0]));
            gl_.PolygonMode(GL_FRONT, static_cast<GLenum>(mode[0]));
            gl_.PolygonMode(GL_BACK, static_cast<GLenum>(mode[1]));
        });
    }
    gl_.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    if (!state_.compatibility) return;
    disable(kAlphaTest);
    disable(kPolygonStipple);
    set(kClampFragmentColor, kFixedOnly,
        [this](GLint clamp) { gl_.ClampColor(kClampFragmentColor, static_cast<GLenum>(clamp)); });
}

void HostState::set_viewport() {
    if (restoring_) {
        std::array<GLfloat, 4> rectangle{};
        std::array<GLdouble, 2> range{};
        gl_.GetFloati_v(GL_VIEWPORT, 0, rectangle.data());
        gl_.GetDoublei_v(GL_DEPTH_RANGE, 0, range.data());
        restore([this, rectangle, range] {
            gl_.ViewportIndexedfv(0, rectangle.data());
            gl_.DepthRangeIndexed(0, range[0], range[1]);
        });
        if (gl_.IsEnabledi(GL_SCISSOR_TEST, 0) == GL_TRUE)
            restore([this] { gl_.Enablei(GL_SCISSOR_TEST, 0); });
    }
    gl_.DepthRangeIndexed(0, 0, 1);
    gl_.Disablei(GL_SCISSOR_TEST, 0);
}

void HostState::set_draw_buffer(GLuint index) {
    std::array<GLboolean, 4> mask{};
    gl_.GetBooleani_v(GL_COLOR_WRITEMASK, index, mask.data());
    restore([this, index, mask] { gl_.ColorMaski(index, mask[0], mask[1], mask[2], mask[3]); });
}

void HostState::set_blending(GLuint index) {
    // Mesa refuses draws for an advanced blend equation if any buffer is blended, also one not drawn to.
    if (gl_.IsEnabledi(GL_BLEND, index) == GL_TRUE) {
        restore([this, index] { gl_.Enablei(GL_BLEND, index); });
        gl_.Disablei(GL_BLEND, index);
    }
    std::array<GLenum, 4> functions{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                    GL_BLEND_DST_ALPHA};
    for (GLenum& function : functions) {
        GLint value = 0;
        gl_.GetIntegeri_v(function, index, &value);
        function = static_cast<GLenum>(value);
    }
    // Blending of two sources allows fewer draw buffers, even if blending is off; NVIDIA's driver refuses
    // draws for the functions of buffers that are not drawn to.
    if (std::ranges::none_of(functions, takes_second_source)) return;
    restore([this, index, functions] {
        gl_.BlendFuncSeparatei(index, functions[0], functions[1], functions[2], functions[3]);
    });
    gl_.BlendFunci(index, GL_ONE, GL_ZERO);
}

void HostState::prepare_program(bool compute) {
    if (first(Kind::program) && restoring_) restore([program = HostProgram(state_)] { program.put_back(); });
    // Mesa would keep the graphics program that replaces a compute program alive after its deletion.
    if (computed_ && !compute) gl_.UseProgram(0);
    computed_ = compute;
}

void HostState::prepare_reads() {
    if (!first(Kind::reads)) return;
    set_pixels(GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING,
               {GL_PACK_SWAP_BYTES, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_ROWS,
                GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES},
               GL_PACK_ALIGNMENT);
}

void HostState::prepare_uploads() {
    if (!first(Kind::uploads)) return;
    set_pixels(GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING,
               {GL_UNPACK_SWAP_BYTES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS},
               GL_UNPACK_ALIGNMENT);
}

void HostState::set_pixels(GLenum buffer, GLenum binding, std::initializer_list<GLenum> zeros,
                           GLenum alignment) {
    set(binding, 0, [this, buffer](GLint id) { gl_.BindBuffer(buffer, static_cast<GLuint>(id)); });
    const auto set_store = [this](GLenum store, GLint fresh) {
        set(store, fresh, [this, store](GLint value) { gl_.PixelStorei(store, value); });
    };
    for (const GLenum store : zeros) set_store(store, 0);
    set_store(alignment, 4);
    if (state_.compatibility && first(Kind::transfer)) set_transfer();
}

void HostState::set_transfer() {
    const auto transfer = reinterpret_cast<PixelTransfer>(state_.platform->function("glPixelTransferf"));
    for (const Setting& setting : kPixelTransfers) {
        if (restoring_) {
            GLfloat value = 0;
            gl_.GetFloatv(setting.name, &value);
            restore([transfer, name = setting.name, value] { transfer(name, value); });
        }
        transfer(setting.name, setting.fresh);
    }
}

void HostState::prepare_texture(GLuint unit) {
    // A host's sampler would override the filters of our textures.
    if (!restoring_) {
        if (first(Kind::units)) gl_.BindSamplers(0, kTextureUnits, nullptr);
        return;
    }
    if (!first(Kind::texture, unit)) return;
    if (first(Kind::units)) restore([this, active = name(GL_ACTIVE_TEXTURE)] { gl_.ActiveTexture(active); });
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    restore([this, unit, texture = name(GL_TEXTURE_BINDING_2D)] {
        // glBindTextureUnit with 0 would unbind a unit's other textures as well.
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.BindTexture(GL_TEXTURE_2D, texture);
    });
    const auto bind = [this, unit](GLint sampler) { gl_.BindSampler(unit, static_cast<GLuint>(sampler)); };
    set(GL_SAMPLER_BINDING, 0, bind);
}

void HostState::prepare_storage(GLuint binding) {
    if (!restoring_ || !first(Kind::storage, binding)) return;
    if (first(Kind::storages)) {
        restore([this, buffer = name(GL_SHADER_STORAGE_BUFFER_BINDING)] {
            gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
        });
    }
    GLint found = 0;
    GLint64 start = 0, size = 0;
    gl_.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, binding, &found);
    const auto buffer = static_cast<GLuint>(found);
    if (buffer == 0) {
        unbound_.insert(binding);
        return;
    }
    gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, binding, &start);
    gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, binding, &size);
    restore([this, binding, buffer, start, size] {
        if (size == 0) return gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
        gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer, static_cast<GLintptr>(start),
                            static_cast<GLsizeiptr>(size));
    });
}

void HostState::unbind_storages() {
    for (auto next = unbound_.begin(); next != unbound_.end();) {
        const GLuint first = *next;
        GLsizei count = 0;
        while (next != unbound_.end() && *next == first + static_cast<GLuint>(count)) {
            ++next;
            ++count;
        }
        gl_.BindBuffersBase(GL_SHADER_STORAGE_BUFFER, first, count, nullptr);
    }
}

void HostState::prepare_image() {
    if (!restoring_ || !first(Kind::image)) return;
    const auto value = [this](GLenum what) {
        GLint found = 0;
        gl_.GetIntegeri_v(what, 0, &found);
        return found;
    };
    restore([this, texture = value(GL_IMAGE_BINDING_NAME), level = value(GL_IMAGE_BINDING_LEVEL),
             layered = value(GL_IMAGE_BINDING_LAYERED), layer = value(GL_IMAGE_BINDING_LAYER),
             access = value(GL_IMAGE_BINDING_ACCESS), format = value(GL_IMAGE_BINDING_FORMAT)] {
        gl_.BindImageTexture(0, static_cast<GLuint>(texture), level, layered != 0 ? GL_TRUE : GL_FALSE, layer,
                             static_cast<GLenum>(access), static_cast<GLenum>(format));
    });
}

}  // namespace nicol::gl
