// SPDX-License-Identifier: MIT
// Initialisation of OpenGL in a new context, and error reports.
#include "gl/state.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "error.hpp"
#include "gl/host_state.hpp"

namespace nicol::gl {
namespace {

constexpr std::size_t kKeptMessages = 8;

GLADapiproc look_up(void* platform, const char* name) {
    return static_cast<Platform*>(platform)->function(name);
}

void GLAD_API_PTR collect(GLenum, GLenum, GLuint, GLenum, GLsizei length, const GLchar* text,
                          const void* user) {
    auto& messages = static_cast<Context::State*>(const_cast<void*>(user))->messages;
    if (messages.size() >= kKeptMessages) messages.erase(messages.begin());
    messages.push_back(length >= 0 ? std::string(text, static_cast<std::size_t>(length)) : std::string(text));
}

}  // namespace

std::string error_name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        case GL_STACK_OVERFLOW:
            return "GL_STACK_OVERFLOW";
        case GL_STACK_UNDERFLOW:
            return "GL_STACK_UNDERFLOW";
        case GL_CONTEXT_LOST:
            return "GL_CONTEXT_LOST";
        default:
            return "OpenGL error " + std::to_string(error);
    }
}

namespace {

bool is_software(const std::string& renderer) {
    const auto names = {"llvmpipe", "softpipe", "swrast", "SWR", "Software", "software"};
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

std::string hexadecimal(std::span<const GLubyte> bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const GLubyte byte : bytes) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

}  // namespace

void Context::State::open(std::unique_ptr<Platform> made, Backend backend, const std::string& device) {
    platform = std::move(made);
    load(backend, device);

    gl.Enable(GL_DEBUG_OUTPUT);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // messages arrive on this thread, inside their call
    for (const GLenum quiet : {GLenum{GL_DEBUG_SEVERITY_LOW}, GLenum{GL_DEBUG_SEVERITY_NOTIFICATION}})
        gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, quiet, 0, nullptr, GL_FALSE);
    gl.DebugMessageCallback(collect, this);

    gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);  // row 0 of every image is its top
    gl.Disable(GL_DITHER);
    check("opening the context");
}

void Context::State::open_in_host(HostAccess access) {
    auto made = std::make_unique<HostPlatform>(std::move(access));
    host = std::make_unique<Host>(made->access());
    if (made->access().is_current && !made->access().is_current())
        throw Error(ErrorCode::not_current, "the host's OpenGL context is not current on the calling thread");
    platform = std::move(made);
    load(Backend::host, "the host's context");
    compatibility = (integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    // The limits are those of HostState, which saves only this many bindings.
    limits.texture_units = std::min(limits.texture_units, HostState::kTextureUnits);
    limits.storage_bindings = std::min(limits.storage_bindings, HostState::kStorageBindings);
    limits.colour_attachments = std::min(limits.colour_attachments, HostState::kDrawBuffers);
    clip_distances = integer(GL_MAX_CLIP_DISTANCES);
    validates = host->access().validates;
    gl.CreateQueries(GL_ANY_SAMPLES_PASSED, 1, &condition);
    host->mark(*this);
}

void Context::State::load(Backend backend, const std::string& device) {
    const int version = gladLoadGLContextUserPtr(&gl, look_up, platform.get());
    if (version == 0)
        throw Error(ErrorCode::no_backend,
                    "no OpenGL context is current, or the OpenGL functions cannot be loaded");
    const auto text = [this](GLenum name) {
        const GLubyte* value = gl.GetString(name);
        return value != nullptr ? std::string(reinterpret_cast<const char*>(value)) : std::string();
    };
    info = {.backend = backend,
            .device = device,
            .vendor = text(GL_VENDOR),
            .renderer = text(GL_RENDERER),
            .version = text(GL_VERSION)};
    if (gl.EXT_memory_object != 0) {
        std::array<GLubyte, GL_UUID_SIZE_EXT> uuid{};
        gl.GetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, uuid.data());
        info.device_uuid = hexadecimal(uuid);
        gl.GetUnsignedBytevEXT(GL_DRIVER_UUID_EXT, uuid.data());
        info.driver_uuid = hexadecimal(uuid);
    }
    info.software = is_software(info.renderer);
    if (version < GLAD_MAKE_VERSION(4, 5))
        throw Error(ErrorCode::no_backend, "OpenGL 4.5 is needed, " + info.renderer + " has " + info.version);
    read_limits();
    gl.CreateVertexArrays(1, &empty_vertex_array);
}

void Context::State::close() noexcept {
    if (empty_vertex_array != 0) gl.DeleteVertexArrays(1, &empty_vertex_array);
    if (condition != 0) gl.DeleteQueries(1, &condition);
    if (!host && gl.DebugMessageCallback != nullptr) gl.DebugMessageCallback(nullptr, nullptr);
    platform.reset();
}

void Context::State::check_command(std::string_view what) {
    unchecked = true;
    if (validates) check(what);
}

void Context::State::check(std::string_view what) {
    unchecked = false;
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) {
        messages.clear();
        return;
    }
    bool memory = error == GL_OUT_OF_MEMORY;
    std::string text = std::string(what) + ": " + error_name(error);
    // OpenGL keeps one flag per kind of error; the loop is bounded because a lost context reports errors
    // without end.
    for (int i = 0; i < 8; ++i) {
        const GLenum next = gl.GetError();
        if (next == GL_NO_ERROR) break;
        memory = memory || next == GL_OUT_OF_MEMORY;
        text += ", " + error_name(next);
    }
    for (const std::string& message : messages) text += "; " + message;
    messages.clear();
    throw Error(memory ? ErrorCode::out_of_memory : ErrorCode::opengl, text);
}

namespace {

// Forgets resources for which gone(resource).
template <class Resource, class Gone>
void forget(std::vector<Context::State::Binding<Resource>>& bindings, const Gone& gone) {
    for (auto& [wanted, bound] : bindings)
        for (Resource* const resource : {&wanted, &bound})
            if (gone(*resource)) *resource = {};
}

// Calls bind(first, resources) for what shall be bound and is not, neighbours together. A call that throws
// for lack of memory has bound nothing, so what is bound is noted after it.
template <class Resource, class Bind>
void bind_wanted(std::vector<Context::State::Binding<Resource>>& bindings, const Bind& bind) {
    std::vector<Resource> run;
    for (std::size_t first = 0; first < bindings.size(); ++first) {
        if (bindings[first].wanted == bindings[first].bound) continue;
        run.clear();
        for (std::size_t i = first; i < bindings.size() && bindings[i].wanted != Resource(); ++i)
            run.push_back(bindings[i].wanted);
        if (run.empty()) {  // the resource is gone, and what is bound there is not read
            bindings[first].bound = {};
            continue;
        }
        bind(static_cast<GLuint>(first), std::span<const Resource>(run));
        for (std::size_t i = 0; i < run.size(); ++i) bindings[first + i].bound = run[i];
    }
}

}  // namespace

void Context::State::remove(ObjectKind kind, GLuint id) noexcept {
    delete_object(gl, kind, id);
    if (kind == ObjectKind::program && used_program == id) used_program = 0;
    if (kind == ObjectKind::buffer)
        forget(storages, [id](const StorageRange& range) { return range.buffer == id; });
    if (kind == ObjectKind::texture) forget(textures, [id](GLuint texture) { return texture == id; });
}

void Context::State::bind_resources() {
    bind_wanted(storages, [this](GLuint first, std::span<const StorageRange> ranges) {
        std::vector<GLuint> buffers;
        std::vector<GLintptr> offsets;
        std::vector<GLsizeiptr> sizes;
        buffers.reserve(ranges.size());
        offsets.reserve(ranges.size());
        sizes.reserve(ranges.size());
        for (const StorageRange& range : ranges) {
            buffers.push_back(range.buffer);
            offsets.push_back(static_cast<GLintptr>(range.offset));
            sizes.push_back(static_cast<GLsizeiptr>(range.bytes));
        }
        gl.BindBuffersRange(GL_SHADER_STORAGE_BUFFER, first, static_cast<GLsizei>(ranges.size()),
                            buffers.data(), offsets.data(), sizes.data());
    });
    bind_wanted(textures, [this](GLuint first, std::span<const GLuint> names) {
        gl.BindTextures(first, static_cast<GLsizei>(names.size()), names.data());
    });
}

void Context::State::forget_bindings() {
    storages.clear();
    textures.clear();
    used_program = 0;
}

GLint Context::State::integer(GLenum name) const {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

void Context::State::read_limits() {
    std::array<GLint, 2> viewport{};
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    limits.texture_size = integer(GL_MAX_TEXTURE_SIZE);
    limits.target_size =
        std::min({limits.texture_size, integer(GL_MAX_RENDERBUFFER_SIZE), viewport[0], viewport[1]});
    limits.colour_attachments = std::min(integer(GL_MAX_COLOR_ATTACHMENTS), integer(GL_MAX_DRAW_BUFFERS));
    limits.texture_units = integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    limits.storage_bindings = std::min(integer(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS),
                                       integer(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS));
    limits.vertex_attributes =
        std::min(integer(GL_MAX_VERTEX_ATTRIBS), integer(GL_MAX_VERTEX_ATTRIB_BINDINGS));
    limits.vertex_stride = static_cast<std::size_t>(integer(GL_MAX_VERTEX_ATTRIB_STRIDE));
    GLint64 bytes = 0;
    gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    // A few drivers answer with -1 for no limit.
    limits.storage_bytes = bytes > 0 ? static_cast<std::size_t>(bytes) : PTRDIFF_MAX;
    limits.storage_alignment =
        static_cast<std::size_t>(std::max(1, integer(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT)));
    for (GLuint axis = 0; axis < 3; ++axis) {
        GLint groups = 0;
        gl.GetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &groups);
        limits.groups[axis] = static_cast<unsigned>(std::max(0, groups));
    }
}

const GladGLContext& functions(Context& context, std::string_view what) {
    if (!context.on_thread())
        throw Error(ErrorCode::internal, std::string(what) + " was called outside Context::run");
    return context.state().gl;
}

}  // namespace nicol::gl
