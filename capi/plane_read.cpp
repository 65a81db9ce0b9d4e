// SPDX-License-Identifier: MIT
// Reading of framebuffer planes into the caller's memory.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "assets.hpp"
#include "image/observer.hpp"
#include "initialiser.hpp"
#include "planes.hpp"
#include "progress.hpp"
#include "rows.hpp"
#include "simd/half_floats.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

// A checked request with resolved defaults.
struct Request {
    nicol_plane plane;
    nicol_format format;  // never automatic
    int first_channel;
    int channels;
    double polarizer_angle;  // radians
};

std::size_t bytes_of_number(nicol_format format) {
    return format == NICOL_FORMAT_FLOAT16 ? 2 : 4;
}

Request understand(const nicol_plane_buffer& given, int channels) {
    const PlaneKind& kind = plane_kind(given.plane);
    require_constant(given.format, NICOL_FORMAT_UINT32, "format", "NICOL_FORMAT_...");
    const bool ids = given.plane == NICOL_PLANE_INSTANCE;
    const nicol_format own = ids ? NICOL_FORMAT_UINT32 : NICOL_FORMAT_FLOAT32;
    const nicol_format format = given.format == NICOL_FORMAT_AUTOMATIC ? own : given.format;
    if (ids != (format == NICOL_FORMAT_UINT32)) {
        refuse(std::string("the format of ") + kind.name + " must be " +
               (ids ? "NICOL_FORMAT_UINT32" : "NICOL_FORMAT_FLOAT32 or NICOL_FORMAT_FLOAT16"));
    }
    if (!std::isfinite(given.polarizer_angle)) refuse("polarizer_angle must be finite");
    const double angle = given.polarizer_angle * std::numbers::pi / 180;
    if (kind.coloured && given.channel == NICOL_ALL_CHANNELS)
        return {given.plane, format, 0, channels, angle};
    require_channel(kind, given.channel, channels);
    return {given.plane, format, static_cast<int>(given.channel), 1, angle};
}

// Copies groups of numbers from places that are `step` apart to places that are `spread` apart. A count that
// is known at compile time needs no call for each pixel.
template <std::size_t count>
void spread_groups(const float* in, std::size_t step, float* out, std::size_t spread, std::size_t groups) {
    for (std::size_t i = 0; i < groups; ++i, in += step, out += spread)
        for (std::size_t k = 0; k < count; ++k) out[k] = in[k];
}

// Numbers of a plane, by rows.
class Source {
public:
    Source(Framebuffer& from, const Request& request)
        : components_(plane_kind(request.plane).components), width_(static_cast<std::size_t>(from.width())) {
        if (plane_kind(request.plane).aov != 0) aovs_ = &from.aovs();
        for (int c = 0; c < request.channels; ++c)
            parts_.push_back(part(from, request, request.first_channel + c));
    }

    // Reads a row: [column][channel][component].
    void read(int y, std::span<float> row) const {
        if (is_dense()) {
            std::copy_n(dense_row(y), row.size(), row.data());
        } else {
            gather(y, 0, row);
        }
    }

    // Reads a row as read() does, in half precision.
    void read(int y, std::span<std::uint16_t> row) const {
        if (is_dense()) return to_half({dense_row(y), row.size()}, row);
        // Parts of a row stay in the processor's fastest cache until they are converted.
        std::array<float, 512> room;
        const std::size_t of_pixel = parts_.size() * components_;
        const std::size_t most = room.size() / of_pixel;
        for (std::size_t x = 0; x < width_; x += most) {
            const std::span part(room.data(), std::min(most, width_ - x) * of_pixel);
            gather(y, x, part);
            to_half(part, row.subspan(x * of_pixel, part.size()));
        }
    }

    [[nodiscard]] const std::uint32_t* instances(int y) const {
        return aovs_->instances.data() + static_cast<std::size_t>(y) * width_;
    }

private:
    // Numbers of one channel: the first one, and the step from pixel to pixel.
    struct Part {
        const float* first;
        std::size_t step;
    };

    // Copies the pixels of a row from column x on: [column][channel][component].
    void gather(int y, std::size_t x, std::span<float> pixels) const {
        const std::size_t of_pixel = parts_.size() * components_;
        const auto copy = components_ == 1   ? spread_groups<1>
                          : components_ == 3 ? spread_groups<3>
                                             : spread_groups<4>;
        for (std::size_t c = 0; c < parts_.size(); ++c) {
            const Part& part = parts_[c];
            const float* const first = part.first + (static_cast<std::size_t>(y) * width_ + x) * part.step;
            copy(first, part.step, pixels.data() + c * components_, of_pixel, pixels.size() / of_pixel);
        }
    }

    // Returns whether the numbers lie as they are read.
    [[nodiscard]] bool is_dense() const { return parts_.size() == 1 && parts_.front().step == components_; }
    [[nodiscard]] const float* dense_row(int y) const {
        return parts_.front().first + static_cast<std::size_t>(y) * width_ * components_;
    }

    Part part(Framebuffer& from, const Request& request, int channel) {
        switch (request.plane) {
            case NICOL_PLANE_DOLP:
                return {made_.emplace_back(dolp(from.image(), channel)).values.data(), 1};
            case NICOL_PLANE_AOLP:
                return {made_.emplace_back(aolp(from.image(), channel)).values.data(), 1};
            case NICOL_PLANE_POLARIZER:
                return {made_.emplace_back(behind_polarizer(from.image(), request.polarizer_angle, channel))
                            .values.data(),
                        1};
            case NICOL_PLANE_DEPTH:
                return {aovs_->depth.data(), 1};
            case NICOL_PLANE_NORMAL:
                return {aovs_->normals.data(), 3};
            case NICOL_PLANE_POSITION:
                return {aovs_->positions.data(), 3};
            case NICOL_PLANE_ALPHA:
                return {aovs_->alpha.data(), 1};
            case NICOL_PLANE_INSTANCE:
                return {nullptr, 1};  // has no floats
            case NICOL_PLANE_VARIANCE: {
                const std::size_t floats = 4 * width_ * static_cast<std::size_t>(from.height());
                return {aovs_->variance.data() + static_cast<std::size_t>(channel) * floats, 4};
            }
            default: {
                const float* const stokes = from.image().at(channel, 0, 0).data();
                return {request.plane == NICOL_PLANE_STOKES ? stokes : stokes + request.plane, 4};
            }
        }
    }

    std::size_t components_;
    std::size_t width_;
    const Aovs* aovs_ = nullptr;
    std::vector<Plane> made_;  // owners of numbers that parts_ may point to
    std::vector<Part> parts_;  // by channel
};

void read(Framebuffer& from, const nicol_plane_buffer& to) {
    const Request request = understand(to, from.channels());
    const PlaneKind& kind = plane_kind(request.plane);
    require_made(kind, from);
    const std::size_t elements =
        static_cast<std::size_t>(from.width()) * static_cast<std::size_t>(request.channels) * kind.components;
    const Rows rows(to.pixels, to.row_stride, to.byte_size, bytes_of_number(request.format), elements,
                    from.height());
    const Source source(from, request);
    const Stopwatch watch;
    for (int y = 0; y < from.height(); ++y) {
        std::byte* const row = rows.row(y);
        switch (request.format) {
            case NICOL_FORMAT_UINT32:
                std::copy_n(source.instances(y), elements, reinterpret_cast<std::uint32_t*>(row));
                break;
            case NICOL_FORMAT_FLOAT16:
                source.read(y, std::span(reinterpret_cast<std::uint16_t*>(row), elements));
                break;
            default:
                source.read(y, std::span(reinterpret_cast<float*>(row), elements));
        }
    }
    from.statistics().observe_ms += watch.milliseconds();
}

}  // namespace

nicol_result nicol_framebuffer_read_plane(nicol_framebuffer framebuffer, const nicol_plane_buffer* to) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const nicol_plane_buffer buffer = read_struct(to, nicol_plane_buffer NICOL_PLANE_BUFFER_INIT, "to");
        const Access access(self);
        self.session->gl->visit([&] { read(*self.content, buffer); });
    });
}

nicol_result nicol_framebuffer_read(nicol_framebuffer framebuffer, nicol_plane plane, uint32_t channel,
                                    float* pixels, uint64_t row_stride, uint64_t byte_size) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        nicol_plane_buffer buffer = NICOL_PLANE_BUFFER_INIT;
        buffer.plane = plane;
        buffer.format = NICOL_FORMAT_FLOAT32;
        buffer.channel = channel;
        buffer.pixels = pixels;
        buffer.row_stride = row_stride;
        buffer.byte_size = byte_size;
        const Access access(self);
        if (channel == NICOL_ALL_CHANNELS) refuse("channel must be one of the framebuffer's");
        self.session->gl->visit([&] { read(*self.content, buffer); });
    });
}

NICOL_INITIALISER(nicol_plane_buffer, NICOL_PLANE_BUFFER_INIT)
