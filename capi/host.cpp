// SPDX-License-Identifier: MIT
// Contexts that belong to the caller.
#include <span>

#include "handles.hpp"
#include "host_image.hpp"
#include "initialiser.hpp"
#include "planes.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

gl::HostAccess access_from(const nicol_host& host) {
    require(host.get_proc_address, "host->get_proc_address");
    gl::HostAccess access;
    access.function = [look_up = host.get_proc_address, user = host.user](const char* name) {
        return reinterpret_cast<void (*)()>(look_up(user, name));
    };
    access.sets_state = (host.flags & NICOL_HOST_SETS_STATE) != 0;
    access.validates = (host.flags & NICOL_HOST_VALIDATE) != 0;
    if (host.is_current != nullptr) {
        access.is_current = [is_current = host.is_current, user = host.user] {
            return is_current(user) != 0;
        };
    }
    return access;
}

Framebuffer& of_host(const nicol_framebuffer_impl& framebuffer) {
    if (!framebuffer.session->in_host()) {
        throw Error(ErrorCode::unsupported,
                    "the framebuffer's context is Nicol's own and shares no textures; it must come from "
                    "nicol_context_create_host");
    }
    return *framebuffer.content;
}

nicol_texture_target read_target(const nicol_texture_target* target) {
    return read_struct(target, nicol_texture_target NICOL_TEXTURE_TARGET_INIT, "target");
}

void draw_plane(nicol_framebuffer framebuffer, nicol_plane plane, std::uint32_t channel,
                const nicol_texture_target* target) {
    const nicol_framebuffer_impl& self = resolve(framebuffer);
    Framebuffer& content = of_host(self);
    const nicol_texture_target to = read_target(target);
    const Access access(self);
    draw(*self.session, content, plane_image(content, plane, channel), to);
}

}  // namespace

nicol_result nicol_context_create_host(const nicol_host* host, const nicol_context_options* options,
                                       nicol_context* context) {
    return guarded([&] {
        const nicol_host access = read_struct(host, nicol_host NICOL_HOST_INIT, "host");
        require(context, "context");
        if (access.flags > (NICOL_HOST_SETS_STATE | NICOL_HOST_VALIDATE)) {
            refuse("host->flags is " + std::to_string(access.flags) + "; it must be a sum of NICOL_HOST_...");
        }
        const nicol_context_options chosen = context_options(options);
        if (chosen.backend != NICOL_BACKEND_AUTOMATIC || chosen.device != 0) {
            refuse("backend and device must be 0: the context is the host's");
        }
        *context = make_context(gl::Context::create_in_host(access_from(access)), chosen);
    });
}

nicol_result nicol_framebuffer_create_textures(nicol_context context, const uint32_t* textures,
                                               uint32_t channels, nicol_framebuffer* framebuffer) {
    return guarded([&] {
        require(textures, "textures");
        require(framebuffer, "framebuffer");
        const SessionPtr session = resolve(context).session;
        if (!session->in_host()) {
            throw Error(ErrorCode::unsupported,
                        "the context is Nicol's own and shares no textures; it must come from "
                        "nicol_context_create_host");
        }
        require_channels(channels);
        refuse_in_callback(*session);
        std::shared_ptr<Framebuffer> made;
        session->gl->run([&] {
            made = std::make_shared<Framebuffer>(session->gl,
                                                 std::span<const unsigned>(textures, textures + channels));
        });
        *framebuffer = make_handle<nicol_framebuffer_impl>(session, std::move(made));
    });
}

nicol_result nicol_framebuffer_get_texture(nicol_framebuffer framebuffer, uint32_t channel,
                                           nicol_gl_texture* texture) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        Framebuffer& content = of_host(self);
        require_channel(channel, content.channels());
        const gl::Texture2D& from = channel_texture(content, static_cast<int>(channel));
        nicol_gl_texture out = NICOL_GL_TEXTURE_INIT;
        out.name = from.id();
        out.target = 0x0DE1;           // GL_TEXTURE_2D
        out.internal_format = 0x8814;  // GL_RGBA32F
        out.width = static_cast<uint32_t>(from.width());
        out.height = static_cast<uint32_t>(from.height());
        write_struct(texture, out, "texture");
    });
}

nicol_result nicol_framebuffer_draw_stokes(nicol_framebuffer framebuffer, uint32_t channel,
                                           const nicol_texture_target* target) {
    return guarded([&] { draw_plane(framebuffer, NICOL_PLANE_STOKES, channel, target); });
}

nicol_result nicol_framebuffer_draw_plane(nicol_framebuffer framebuffer, nicol_plane plane, uint32_t channel,
                                          const nicol_texture_target* target) {
    return guarded([&] { draw_plane(framebuffer, plane, channel, target); });
}

nicol_result nicol_framebuffer_draw_observation(nicol_framebuffer framebuffer,
                                                const nicol_observation* observation,
                                                const nicol_texture_target* target) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        Framebuffer& content = of_host(self);
        const nicol_observation shown =
            read_struct(observation, nicol_observation NICOL_OBSERVATION_INIT, "observation");
        const nicol_texture_target to = read_target(target);
        const Access access(self);
        draw(*self.session, content, observation_image(content, shown), to);
    });
}

NICOL_INITIALISER(nicol_host, NICOL_HOST_INIT)
NICOL_INITIALISER(nicol_gl_texture, NICOL_GL_TEXTURE_INIT)
