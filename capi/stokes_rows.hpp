// SPDX-License-Identifier: MIT
// Stokes images in the caller's memory.
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <string>

#include "assets.hpp"
#include "image/stokes_image.hpp"
#include "rows.hpp"

namespace nicol::capi {

/// Stokes vectors in the caller's memory.
class StokesRows {
public:
    StokesRows(const nicol_stokes_image* given, const char* name)
        : image_(read_struct(given, nicol_stokes_image NICOL_STOKES_IMAGE_INIT, name)) {
        require_size(name, image_.width, image_.height);
        require_channels(image_.channels, std::string(name) + "->channels");
        rows_.emplace(image_.pixels, image_.row_stride, image_.byte_size, sizeof(float),
                      std::size_t{4} * image_.width * image_.channels, static_cast<int>(image_.height));
    }

    [[nodiscard]] StokesImage read() const {
        StokesImage out = blank();
        copy(out, [](float* ours, float* theirs) { std::memcpy(ours, theirs, 4 * sizeof(float)); });
        return out;
    }
    /// Throws Error(invalid_argument) if the image has another size.
    void write(StokesImage& from) const {
        const StokesImage wanted = blank();
        if (wanted.width != from.width || wanted.height != from.height || wanted.channels != from.channels)
            refuse("to has " + std::to_string(wanted.width) + " x " + std::to_string(wanted.height) +
                   " pixels with " + std::to_string(wanted.channels) + " channels; the result has " +
                   std::to_string(from.width) + " x " + std::to_string(from.height) + " with " +
                   std::to_string(from.channels));
        copy(from, [](float* ours, float* theirs) { std::memcpy(theirs, ours, 4 * sizeof(float)); });
    }

private:
    [[nodiscard]] StokesImage blank() const {
        return {static_cast<int>(image_.width), static_cast<int>(image_.height),
                static_cast<int>(image_.channels)};
    }
    template <class Copy>
    void copy(StokesImage& ours, const Copy& one) const {
        for (int y = 0; y < ours.height; ++y) {
            auto* theirs = reinterpret_cast<float*>(rows_->row(y));
            for (int x = 0; x < ours.width; ++x)
                for (int c = 0; c < ours.channels; ++c, theirs += 4) one(ours.at(c, y, x).data(), theirs);
        }
    }

    nicol_stokes_image image_;
    std::optional<Rows> rows_;
};

}  // namespace nicol::capi
