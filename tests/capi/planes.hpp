// SPDX-License-Identifier: MIT
// Helpers for reading planes of surfaces.
#pragma once

#include "capi.hpp"

namespace capi_test {

/// Reads a plane of surfaces. `Number` is float, or std::uint32_t for instance ids.
template <class Number>
std::vector<Number> read_surface(nicol_framebuffer framebuffer, nicol_plane plane, std::size_t components) {
    std::uint32_t width = 0, height = 0, channels = 0;
    OK(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    std::vector<Number> pixels(std::size_t{width} * height * components);
    nicol_plane_buffer to = NICOL_PLANE_BUFFER_INIT;
    to.plane = plane;
    to.pixels = pixels.data();
    to.byte_size = pixels.size() * sizeof(Number);
    OK(nicol_framebuffer_read_plane(framebuffer, &to));
    return pixels;
}

struct Surfaces {
    std::vector<float> depth, normal, position, alpha;
    std::vector<std::uint32_t> instance;

    explicit Surfaces(nicol_framebuffer framebuffer)
        : depth(read_surface<float>(framebuffer, NICOL_PLANE_DEPTH, 1)),
          normal(read_surface<float>(framebuffer, NICOL_PLANE_NORMAL, 3)),
          position(read_surface<float>(framebuffer, NICOL_PLANE_POSITION, 3)),
          alpha(read_surface<float>(framebuffer, NICOL_PLANE_ALPHA, 1)),
          instance(read_surface<std::uint32_t>(framebuffer, NICOL_PLANE_INSTANCE, 1)) {}
};

/// Returns options of the reference method with few samples and its variance.
inline nicol_render_options with_variance() {
    nicol_render_options options = plain_options();
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = 2;
    options.aovs = NICOL_AOV_VARIANCE;
    return options;
}

/// Returns options of every method that makes planes, with little other work.
inline std::vector<nicol_render_options> every_method() {
    std::vector<nicol_render_options> all;
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE, NICOL_METHOD_REFERENCE}) {
        nicol_render_options options = plain_options();
        options.method = method;
        options.order_low = 1;
        options.order_high = 1;
        options.shadows = 0;
        options.samples = 1;
        options.aovs = NICOL_AOV_ALL;
        all.push_back(options);
    }
    return all;
}

}  // namespace capi_test
