// SPDX-License-Identifier: MIT
// Save, reset and restore of a host's state.
#include "gl/host_state.hpp"

#include <algorithm>

namespace nicol::gl {
namespace {

// State of compatibility contexts. The core-profile loader does not define these names.
constexpr GLenum kAlphaTest = 0x0BC0, kPolygonStipple = 0x0B42, kClampFragmentColor = 0x891B,
                 kFixedOnly = 0x891D;
using PixelTransfer = void(GLAD_API_PTR*)(GLenum, GLfloat);

/// Capabilities that are off in a fresh context. Dithering is on there, but contexts of our own switch it off
/// too.
constexpr std::array kCapabilitiesOff{
    GL_STENCIL_TEST,        GL_COLOR_LOGIC_OP,    GL_DITHER,
    GL_POLYGON_OFFSET_FILL, GL_POLYGON_SMOOTH,    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE,   GL_SAMPLE_MASK,
    GL_SAMPLE_SHADING,      GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX,
    GL_RASTERIZER_DISCARD,  GL_DEPTH_CLAMP,       GL_FRAMEBUFFER_SRGB,
    GL_DEPTH_TEST,          GL_CULL_FACE};

std::vector<GLenum> capabilities(const Context::State& state) {
    std::vector<GLenum> all(kCapabilitiesOff.begin(), kCapabilitiesOff.end());
    if (state.compatibility) all.insert(all.end(), {kAlphaTest, kPolygonStipple});
    for (GLint i = 0; i < state.integer(GL_MAX_CLIP_DISTANCES); ++i)
        all.push_back(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    return all;
}

struct Setting {
    GLenum name;
    GLint fresh;
};

constexpr std::array kPixelStores{
    Setting{GL_UNPACK_SWAP_BYTES, 0},  Setting{GL_UNPACK_LSB_FIRST, 0},    Setting{GL_UNPACK_ROW_LENGTH, 0},
    Setting{GL_UNPACK_SKIP_ROWS, 0},   Setting{GL_UNPACK_SKIP_PIXELS, 0},  Setting{GL_UNPACK_ALIGNMENT, 4},
    Setting{GL_UNPACK_SKIP_IMAGES, 0}, Setting{GL_UNPACK_IMAGE_HEIGHT, 0}, Setting{GL_PACK_SWAP_BYTES, 0},
    Setting{GL_PACK_LSB_FIRST, 0},     Setting{GL_PACK_ROW_LENGTH, 0},     Setting{GL_PACK_SKIP_ROWS, 0},
    Setting{GL_PACK_SKIP_PIXELS, 0},   Setting{GL_PACK_ALIGNMENT, 4},      Setting{GL_PACK_SKIP_IMAGES, 0},
    Setting{GL_PACK_IMAGE_HEIGHT, 0}};

/// GL_MAP_COLOR, then scale and bias of red, green, blue and alpha.
constexpr std::array kPixelTransfers{Setting{0x0D10, 0}, Setting{0x0D14, 1}, Setting{0x0D15, 0},
                                     Setting{0x0D18, 1}, Setting{0x0D19, 0}, Setting{0x0D1A, 1},
                                     Setting{0x0D1B, 0}, Setting{0x0D1C, 1}, Setting{0x0D1D, 0}};

template <class Item, class Read>
void fill(std::vector<Item>& items, GLint count, Read read) {
    items.resize(static_cast<std::size_t>(count));
    for (GLint i = 0; i < count; ++i) read(static_cast<GLuint>(i), items[static_cast<std::size_t>(i)]);
}

template <class Item, class Write>
void each(const std::vector<Item>& items, Write write) {
    for (std::size_t i = 0; i < items.size(); ++i) write(static_cast<GLuint>(i), items[i]);
}

PixelTransfer pixel_transfer(const Context::State& state) {
    return reinterpret_cast<PixelTransfer>(state.platform->function("glPixelTransferf"));
}

}  // namespace

HostState::HostState(const Context::State& state)
    : state_(state), gl_(state.gl), capability_names_(capabilities(state)), program_(state) {
    save();
    save_units();
    set();
}

void HostState::save() {
    for (const GLenum capability : capability_names_) capabilities_.push_back(gl_.IsEnabled(capability));
    fill(viewports_, state_.integer(GL_MAX_VIEWPORTS), [this](GLuint i, Viewport& viewport) {
        gl_.GetFloati_v(GL_VIEWPORT, i, viewport.rectangle.data());
        gl_.GetDoublei_v(GL_DEPTH_RANGE, i, viewport.depth_range.data());
        viewport.scissor = gl_.IsEnabledi(GL_SCISSOR_TEST, i);
    });
    fill(draw_buffers_, state_.integer(GL_MAX_DRAW_BUFFERS), [this](GLuint i, DrawBuffer& buffer) {
        gl_.GetBooleani_v(GL_COLOR_WRITEMASK, i, buffer.mask.data());
        buffer.blend = gl_.IsEnabledi(GL_BLEND, i);
        const auto value = [&](GLenum what) {
            GLint number = 0;
            gl_.GetIntegeri_v(what, i, &number);
            return static_cast<GLenum>(number);
        };
        buffer.functions = {value(GL_BLEND_SRC_RGB), value(GL_BLEND_DST_RGB), value(GL_BLEND_SRC_ALPHA),
                            value(GL_BLEND_DST_ALPHA)};
        buffer.colour_equation = value(GL_BLEND_EQUATION_RGB);
        buffer.alpha_equation = value(GL_BLEND_EQUATION_ALPHA);
    });
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    depth_function_ = state_.integer(GL_DEPTH_FUNC);
    culled_ = state_.integer(GL_CULL_FACE_MODE);
    front_ = state_.integer(GL_FRONT_FACE);
    provoking_ = state_.integer(GL_PROVOKING_VERTEX);
    clip_origin_ = state_.integer(GL_CLIP_ORIGIN);
    clip_depth_ = state_.integer(GL_CLIP_DEPTH_MODE);
    gl_.GetIntegerv(GL_POLYGON_MODE, polygon_mode_.data());
    for (const Setting& store : kPixelStores) pixel_stores_.push_back(state_.integer(store.name));
    if (state_.compatibility) {
        clamp_fragments_ = state_.integer(kClampFragmentColor);
        fill(pixel_transfers_, kPixelTransfers.size(),
             [this](GLuint i, GLfloat& value) { gl_.GetFloatv(kPixelTransfers[i].name, &value); });
    }
    vertex_array_ = name(GL_VERTEX_ARRAY_BINDING);
    framebuffer_ = name(GL_DRAW_FRAMEBUFFER_BINDING);
    pack_ = name(GL_PIXEL_PACK_BUFFER_BINDING);
    unpack_ = name(GL_PIXEL_UNPACK_BUFFER_BINDING);
}

void HostState::save_units() {
    storage_buffer_ = name(GL_SHADER_STORAGE_BUFFER_BINDING);
    fill(storage_, state_.limits.storage_bindings, [this](GLuint i, StorageBinding& binding) {
        gl_.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &binding.name);
        gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &binding.start);
        gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &binding.size);
    });
    const auto image = [this](GLenum what) {
        GLint value = 0;
        gl_.GetIntegeri_v(what, 0, &value);
        return value;
    };
    image_ = {image(GL_IMAGE_BINDING_NAME),  image(GL_IMAGE_BINDING_LEVEL),  image(GL_IMAGE_BINDING_LAYERED),
              image(GL_IMAGE_BINDING_LAYER), image(GL_IMAGE_BINDING_ACCESS), image(GL_IMAGE_BINDING_FORMAT)};
    active_texture_ = state_.integer(GL_ACTIVE_TEXTURE);
    fill(texture_units_, state_.limits.texture_units, [this](GLuint i, TextureUnit& unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + i);
        unit = {state_.integer(GL_TEXTURE_BINDING_2D), state_.integer(GL_SAMPLER_BINDING)};
    });
    gl_.ActiveTexture(static_cast<GLenum>(active_texture_));
}

void HostState::set() {
    for (const GLenum capability : capability_names_) gl_.Disable(capability);
    gl_.Disable(GL_BLEND);  // for all draw buffers, as the calls below
    // Two-source blending allows fewer draw buffers, even if blending is off.
    gl_.BlendFunc(GL_ONE, GL_ZERO);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.DepthRange(0, 1);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.FrontFace(GL_CCW);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    set_pixels();
    gl_.ActiveTexture(GL_TEXTURE0);
    // A host's sampler would override the filters of our textures.
    for (GLuint i = 0; i < texture_units_.size(); ++i) gl_.BindSampler(i, 0);
}

void HostState::set_pixels() const {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const Setting& store : kPixelStores) gl_.PixelStorei(store.name, store.fresh);
    if (!state_.compatibility) return;
    gl_.ClampColor(kClampFragmentColor, kFixedOnly);
    const PixelTransfer transfer = pixel_transfer(state_);
    for (const Setting& setting : kPixelTransfers)
        transfer(setting.name, static_cast<GLfloat>(setting.fresh));
}

HostState::~HostState() {
    for (std::size_t i = 0; i < capabilities_.size(); ++i) enable(capability_names_[i], capabilities_[i]);
    each(viewports_, [this](GLuint i, const Viewport& viewport) {
        gl_.ViewportIndexedfv(i, viewport.rectangle.data());
        gl_.DepthRangeIndexed(i, viewport.depth_range[0], viewport.depth_range[1]);
        (viewport.scissor == GL_TRUE ? gl_.Enablei : gl_.Disablei)(GL_SCISSOR_TEST, i);
    });
    each(draw_buffers_, [this](GLuint i, const DrawBuffer& buffer) {
        gl_.ColorMaski(i, buffer.mask[0], buffer.mask[1], buffer.mask[2], buffer.mask[3]);
        (buffer.blend == GL_TRUE ? gl_.Enablei : gl_.Disablei)(GL_BLEND, i);
        const auto& [source, destination, source_alpha, destination_alpha] = buffer.functions;
        gl_.BlendFuncSeparatei(i, source, destination, source_alpha, destination_alpha);
        if (buffer.colour_equation == buffer.alpha_equation) {
            gl_.BlendEquationi(i, buffer.colour_equation);  // extensions' equations are only set together
        } else {
            gl_.BlendEquationSeparatei(i, buffer.colour_equation, buffer.alpha_equation);
        }
    });
    gl_.DepthMask(depth_mask_);
    gl_.DepthFunc(static_cast<GLenum>(depth_function_));
    gl_.CullFace(static_cast<GLenum>(culled_));
    gl_.FrontFace(static_cast<GLenum>(front_));
    gl_.ProvokingVertex(static_cast<GLenum>(provoking_));
    gl_.ClipControl(static_cast<GLenum>(clip_origin_), static_cast<GLenum>(clip_depth_));
    if (state_.compatibility) {
        gl_.PolygonMode(GL_FRONT, static_cast<GLenum>(polygon_mode_[0]));
        gl_.PolygonMode(GL_BACK, static_cast<GLenum>(polygon_mode_[1]));
    } else {
        gl_.PolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygon_mode_[0]));
    }
    put_back_pixels();
    put_back_units();
    program_.put_back();
    gl_.BindVertexArray(vertex_array_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
}

void HostState::put_back_pixels() const {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, pack_);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, unpack_);
    for (std::size_t i = 0; i < kPixelStores.size(); ++i)
        gl_.PixelStorei(kPixelStores[i].name, pixel_stores_[i]);
    if (!state_.compatibility) return;
    gl_.ClampColor(kClampFragmentColor, static_cast<GLenum>(clamp_fragments_));
    const PixelTransfer transfer = pixel_transfer(state_);
    each(pixel_transfers_, [&](GLuint i, GLfloat value) { transfer(kPixelTransfers[i].name, value); });
}

void HostState::put_back_units() const {
    each(storage_, [this](GLuint i, const StorageBinding& binding) {
        const auto buffer = static_cast<GLuint>(binding.name);
        if (buffer == 0 || binding.size == 0) {
            gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffer);
        } else {
            gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffer, static_cast<GLintptr>(binding.start),
                                static_cast<GLsizeiptr>(binding.size));
        }
    });
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, storage_buffer_);
    gl_.BindImageTexture(0, static_cast<GLuint>(image_.texture), image_.level,
                         image_.layered != 0 ? GL_TRUE : GL_FALSE, image_.layer,
                         static_cast<GLenum>(image_.access), static_cast<GLenum>(image_.format));
    each(texture_units_, [this](GLuint i, const TextureUnit& unit) {
        // glBindTextureUnit with 0 would unbind a unit's other textures as well.
        gl_.ActiveTexture(GL_TEXTURE0 + i);
        gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(unit.texture));
        gl_.BindSampler(i, static_cast<GLuint>(unit.sampler));
    });
    gl_.ActiveTexture(static_cast<GLenum>(active_texture_));
}

void HostState::enable(GLenum capability, GLboolean on) const {
    (on == GL_TRUE ? gl_.Enable : gl_.Disable)(capability);
}

GLuint HostState::name(GLenum binding) const {
    return static_cast<GLuint>(state_.integer(binding));
}

}  // namespace nicol::gl
