// SPDX-License-Identifier: MIT
// Framebuffers, and files of their content.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "files/memory_output.hpp"
#include "files/suffix.hpp"
#include "image/observer.hpp"
#include "initialiser.hpp"
#include "planes.hpp"
#include "progress.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

Observation observe(const StokesImage& image, const nicol_observation& given) {
    switch (given.kind) {
        case NICOL_OBSERVATION_S0:
            return tone_mapped(image, static_cast<double>(given.exposure));
        case NICOL_OBSERVATION_S1:
        case NICOL_OBSERVATION_S2:
        case NICOL_OBSERVATION_S3:
            return signed_component(image, static_cast<int>(given.kind), static_cast<double>(given.scale));
        case NICOL_OBSERVATION_DOLP:
            return dolp_image(image);
        case NICOL_OBSERVATION_AOLP:
            return aolp_image(image, AolpStyle::dark);
        case NICOL_OBSERVATION_POLARIZER: {
            const double angle = static_cast<double>(given.polarizer_angle) * std::numbers::pi / 180;
            return tone_mapped(through_polarizer(image, angle), static_cast<double>(given.exposure));
        }
        default:
            refuse("observation->kind is " + std::to_string(given.kind) +
                   "; it must be one of NICOL_OBSERVATION_...");
    }
}

std::shared_ptr<Framebuffer> make_framebuffer(const Session& session, std::uint32_t width,
                                              std::uint32_t height, std::uint32_t channels) {
    require_size("a framebuffer", width, height);
    require_channels(channels);
    refuse_in_callback(session);
    return std::make_shared<Framebuffer>(session.gl, static_cast<int>(width), static_cast<int>(height),
                                         static_cast<int>(channels));
}

constexpr const char* kSinkName = "the image in memory";

/// Calls write(image, options) with the image of a framebuffer, locked, as nicol_framebuffer_write_exr has
/// it.
template <class Write>
void write_exr_by(const nicol_framebuffer_impl& self, const Write& write) {
    const Access access(self);
    const StokesImage* image = nullptr;
    const Aovs* aovs = nullptr;
    self.session->gl->visit([&] {
        image = &self.content->image();
        if (self.content->aov_mask() != 0) aovs = &self.content->aovs();
    });
    const Stopwatch watch;
    write(*image, ExrOptions{.aovs = aovs});
    self.content->statistics().observe_ms += watch.milliseconds();
}

/// Calls write(png) with the observation of a framebuffer, locked.
template <class Write>
void write_png_by(const nicol_framebuffer_impl& self, const nicol_observation& given, const Write& write) {
    const Access access(self);
    const StokesImage& image = self.content->image();
    const Stopwatch watch;
    const Observation observation = observe(image, given);
    write(png_of(observation));
    self.content->statistics().observe_ms += watch.milliseconds();
}

/// Gives bytes to a sink, in parts that a caller can handle one after another.
void give(std::string_view bytes, nicol_sink_callback sink, void* user) {
    constexpr std::size_t most = std::size_t{1} << 20;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size()))) {
        const std::string_view part = bytes.substr(0, most);
        if (sink(user, part.data(), part.size()) == 0)
            throw Error(ErrorCode::write_failed, "the sink returned 0");
    }
}

}  // namespace

namespace nicol::capi {

void require_suffix(const char* path, std::string_view own) {
    constexpr std::array others{".exr",  ".png",  ".jpg", ".jpeg", ".hdr", ".bmp", ".tga", ".tif",
                                ".tiff", ".webp", ".gif", ".pfm",  ".ppm", ".npy", ".npz"};
    const std::string suffix = suffix_of(path);
    if (suffix != own && std::ranges::find(others, suffix) != others.end())
        refuse(std::string(path) + " ends in " + suffix + "; what is written is " + std::string(own));
}

}  // namespace nicol::capi

nicol_result nicol_framebuffer_create(nicol_context context, uint32_t width, uint32_t height,
                                      uint32_t channels, nicol_framebuffer* framebuffer) {
    return guarded([&] {
        require(framebuffer, "framebuffer");
        const SessionPtr session = resolve(context).session;
        *framebuffer =
            make_handle<nicol_framebuffer_impl>(session, make_framebuffer(*session, width, height, channels));
    });
}

nicol_result nicol_framebuffer_resize(nicol_framebuffer framebuffer, uint32_t width, uint32_t height) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const Framebuffer& former = *self.content;
        if (former.borrows())
            throw Error(
                ErrorCode::unsupported,
                "the framebuffer's images are textures of the host; nicol_framebuffer_create_textures "
                "makes one of other textures");
        if (std::cmp_equal(width, former.width()) && std::cmp_equal(height, former.height())) return;
        // Calls in progress go on with the former object.
        replace_content(framebuffer, make_framebuffer(*self.session, width, height,
                                                      static_cast<std::uint32_t>(former.channels())));
    });
}

nicol_result nicol_framebuffer_get_size(nicol_framebuffer framebuffer, uint32_t* width, uint32_t* height,
                                        uint32_t* channels) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        require(width, "width");
        require(height, "height");
        require(channels, "channels");
        *width = static_cast<uint32_t>(self.content->width());
        *height = static_cast<uint32_t>(self.content->height());
        *channels = static_cast<uint32_t>(self.content->channels());
    });
}

nicol_result nicol_framebuffer_blend(nicol_framebuffer framebuffer, nicol_framebuffer other, double weight) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const nicol_framebuffer_impl& from = resolve(other);
        require_same_context(self, from);
        Framebuffer& target = *self.content;
        if (self.content == from.content) refuse("other is the framebuffer itself");
        if (target.width() != from.content->width() || target.height() != from.content->height() ||
            target.channels() != from.content->channels())
            refuse("other has another size or other channels; both framebuffers must have the same");
        if (!(weight >= 0 && weight <= 1))
            refuse("weight is " + std::to_string(weight) + "; it must lie in 0 to 1");
        const auto image_of = [](const nicol_framebuffer_impl& of) {
            const Access access(of);
            StokesImage image;
            of.session->gl->visit([&] { image = of.content->image(); });
            return image;
        };
        const StokesImage added = image_of(from);
        const Access access(self);
        self.session->gl->visit([&] {
            StokesImage mixed = target.image();
            for (std::size_t i = 0; i < mixed.data.size(); ++i)
                mixed.data[i] =
                    static_cast<float>(std::lerp(double{mixed.data[i]}, double{added.data[i]}, weight));
            const Statistics statistics = target.statistics();
            Aovs aovs = target.aovs();
            target.show(std::move(mixed), statistics, std::move(aovs));
        });
    });
}

nicol_result nicol_framebuffer_retain(nicol_framebuffer framebuffer) {
    return retain(framebuffer);
}
nicol_result nicol_framebuffer_release(nicol_framebuffer framebuffer) {
    return release(framebuffer);
}

nicol_result nicol_framebuffer_write_exr(nicol_framebuffer framebuffer, const char* path) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        require(path, "path");
        require_suffix(path, ".exr");
        write_exr_by(self, [&](const StokesImage& image, const ExrOptions& options) {
            write_exr(path, image, options);
        });
    });
}

nicol_result nicol_framebuffer_encode_exr(nicol_framebuffer framebuffer, nicol_sink_callback sink,
                                          void* user) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        require(sink, "sink");
        MemoryOutput file;
        write_exr_by(self, [&](const StokesImage& image, const ExrOptions& options) {
            encode_exr(file.handle(), kSinkName, image, options);
        });
        give(file.bytes(), sink, user);
    });
}

nicol_result nicol_framebuffer_write_png(nicol_framebuffer framebuffer, const nicol_observation* observation,
                                         const char* path) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const nicol_observation given =
            read_struct(observation, nicol_observation NICOL_OBSERVATION_INIT, "observation");
        require(path, "path");
        require_suffix(path, ".png");
        write_png_by(self, given, [&](const PngImage& image) { write_png(path, image); });
    });
}

nicol_result nicol_framebuffer_encode_png(nicol_framebuffer framebuffer, const nicol_observation* observation,
                                          nicol_sink_callback sink, void* user) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const nicol_observation given =
            read_struct(observation, nicol_observation NICOL_OBSERVATION_INIT, "observation");
        require(sink, "sink");
        MemoryOutput file;
        write_png_by(self, given,
                     [&](const PngImage& image) { encode_png(file.handle(), kSinkName, image); });
        give(file.bytes(), sink, user);
    });
}

NICOL_INITIALISER(nicol_observation, NICOL_OBSERVATION_INIT)
