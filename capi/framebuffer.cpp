// SPDX-License-Identifier: MIT
// Framebuffers, and what is read from them.
#include <numbers>

#include "handles.hpp"
#include "nicol/observer.hpp"
#include "render/stopwatch.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

Picture picture_of(const StokesImage& image, const nicol_picture& wanted) {
    switch (wanted.kind) {
        case NICOL_PICTURE_S0:
            return tone_mapped(image, static_cast<double>(wanted.exposure));
        case NICOL_PICTURE_S1:
        case NICOL_PICTURE_S2:
        case NICOL_PICTURE_S3:
            return signed_component(image, static_cast<int>(wanted.kind), static_cast<double>(wanted.scale));
        case NICOL_PICTURE_DOLP:
            return dolp_picture(image);
        case NICOL_PICTURE_AOLP:
            return aolp_picture(image, AolpStyle::dark);
        case NICOL_PICTURE_POLARIZER: {
            const double angle = static_cast<double>(wanted.polarizer_angle) * std::numbers::pi / 180;
            return tone_mapped(through_polarizer(image, angle), static_cast<double>(wanted.exposure));
        }
        default:
            refuse("picture->kind is " + std::to_string(wanted.kind) +
                   "; it must be one of NICOL_PICTURE_...");
    }
}

// The rows of one plane, as floats in the caller's memory.
class PlaneWriter {
public:
    PlaneWriter(const StokesImage& image, std::size_t floats_per_pixel, float* pixels, std::uint64_t stride,
                std::uint64_t byte_size)
        : row_(static_cast<std::size_t>(image.width) * floats_per_pixel), pixels_(pixels) {
        require(pixels, "pixels");
        const std::uint64_t row_bytes = row_ * sizeof(float);
        stride_ = stride == 0 ? row_bytes : stride;
        if (stride_ < row_bytes || stride_ % sizeof(float) != 0 || stride_ > (std::uint64_t{1} << 40)) {
            refuse("row_stride is " + std::to_string(stride_) + "; a row takes " + std::to_string(row_bytes) +
                   " bytes, and strides are multiples of 4");
        }
        const std::uint64_t needed = stride_ * static_cast<std::uint64_t>(image.height - 1) + row_bytes;
        if (byte_size < needed) {
            refuse("byte_size is " + std::to_string(byte_size) + "; the plane takes " +
                   std::to_string(needed) + " bytes");
        }
    }

    [[nodiscard]] float* row(int y) const {
        return pixels_ + static_cast<std::size_t>(y) * (stride_ / sizeof(float));
    }
    [[nodiscard]] std::size_t row_floats() const { return row_; }

private:
    std::size_t row_;
    float* pixels_;
    std::uint64_t stride_ = 0;
};

}  // namespace

nicol_result nicol_framebuffer_create(nicol_context context, uint32_t width, uint32_t height,
                                      uint32_t channels, nicol_framebuffer* framebuffer) {
    return guarded([&] {
        require(framebuffer, "framebuffer");
        const SessionPtr session = resolve(context).session;
        if (width < 1 || width > NICOL_MAX_SIZE || height < 1 || height > NICOL_MAX_SIZE) {
            refuse("a framebuffer of " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels; each side must lie in 1 to " + std::to_string(NICOL_MAX_SIZE));
        }
        if (channels < 1 || channels > NICOL_MAX_CHANNELS) {
            refuse("channels is " + std::to_string(channels) + "; it must lie in 1 to " +
                   std::to_string(NICOL_MAX_CHANNELS));
        }
        const Turn turn(session);
        *framebuffer = make_handle<nicol_framebuffer_impl>(
            session, std::make_shared<Framebuffer>(session->gl, static_cast<int>(width),
                                                   static_cast<int>(height), static_cast<int>(channels)));
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

nicol_result nicol_framebuffer_retain(nicol_framebuffer framebuffer) {
    return retain(framebuffer);
}
nicol_result nicol_framebuffer_release(nicol_framebuffer framebuffer) {
    return release(framebuffer);
}

nicol_result nicol_framebuffer_read(nicol_framebuffer framebuffer, nicol_plane plane, uint32_t channel,
                                    float* pixels, uint64_t row_stride, uint64_t byte_size) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        if (plane > NICOL_PLANE_AOLP) {
            refuse("plane is " + std::to_string(plane) + "; it must be one of NICOL_PLANE_...");
        }
        if (channel >= static_cast<uint32_t>(self.content->channels())) {
            refuse("channel is " + std::to_string(channel) + "; the framebuffer has " +
                   std::to_string(self.content->channels()) + ", counted from 0");
        }
        const Turn turn(self.session);
        const StokesImage& image = self.content->image();
        const Stopwatch watch;
        const PlaneWriter out(image, plane == NICOL_PLANE_STOKES ? 4 : 1, pixels, row_stride, byte_size);
        const auto c = static_cast<int>(channel);
        if (plane == NICOL_PLANE_DOLP || plane == NICOL_PLANE_AOLP) {
            const Plane values = plane == NICOL_PLANE_DOLP ? dolp(image, c) : aolp(image, c);
            for (int y = 0; y < image.height; ++y) {
                std::copy_n(values.values.data() + static_cast<std::size_t>(y) * out.row_floats(),
                            out.row_floats(), out.row(y));
            }
        } else {
            for (int y = 0; y < image.height; ++y) {
                const float* from = image.at(c, y, 0).data();
                float* to = out.row(y);
                if (plane == NICOL_PLANE_STOKES) {
                    std::copy_n(from, out.row_floats(), to);
                    continue;
                }
                for (std::size_t x = 0; x < out.row_floats(); ++x) to[x] = from[4 * x + plane];
            }
        }
        self.content->statistics().observe_ms += watch.milliseconds();
    });
}

nicol_result nicol_framebuffer_write_exr(nicol_framebuffer framebuffer, const char* path) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        require(path, "path");
        const Turn turn(self.session);
        const StokesImage& image = self.content->image();
        const Stopwatch watch;
        write_exr(path, image);
        self.content->statistics().observe_ms += watch.milliseconds();
    });
}

nicol_result nicol_framebuffer_write_png(nicol_framebuffer framebuffer, const nicol_picture* picture,
                                         const char* path) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const nicol_picture wanted = read_struct(picture, "picture");
        require(path, "path");
        const Turn turn(self.session);
        const StokesImage& image = self.content->image();
        const Stopwatch watch;
        write_png(path, picture_of(image, wanted));
        self.content->statistics().observe_ms += watch.milliseconds();
    });
}
