// SPDX-License-Identifier: MIT
#include "draw/visibility_buffer.hpp"

namespace nicol {

void VisibilityBuffer::resize(int width, int height, std::span<const glm::dvec2> offsets, Kept kept) {
    width_ = width;
    height_ = height;
    offsets_ = offsets;
    kept_ = kept;
    const std::size_t targets = kept == Kept::on_host ? 0 : offsets.size();
    sizing_.run(width, height, targets, [&] {
        if (targets == 0 && targets_.empty()) return;  // no wait for the thread of OpenGL
        context_->run([&] {
            targets_.clear();
            for (std::size_t i = 0; i < targets; ++i)
                targets_.emplace_back(context_,
                                      gl::RenderTargetDescription{
                                          .width = width, .height = height, .format = gl::Format::r32ui});
        });
    });
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::size_t s = 0; s < kMostPixelSamples; ++s) {
        if (s >= offsets.size() || kept == Kept::on_device)
            texels_[s] = {};
        else
            texels_[s].resize(pixels);
    }
}

void VisibilityBuffer::clear() {
    targets_.clear();
    sizing_.reset();
    texels_ = {};
}

std::uint64_t VisibilityBuffer::bytes() const {
    std::uint64_t bytes = 0;
    for (const std::vector<std::uint32_t>& texels : texels_) bytes += texels.size() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace nicol
