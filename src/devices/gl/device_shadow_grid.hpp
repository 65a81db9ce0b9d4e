// SPDX-License-Identifier: MIT
// Second half of relight on the device: light times the visibility of its vertices, on a grid.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "devices/gl/device_light.hpp"
#include "devices/gl/device_shadow_coefficients.hpp"
#include "gl/program.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

/// ShadowGrid on the device, in passes over all vertices of a chunk, each from one work space into the other:
///   light            [harmonic]
///   sums over l      [component][row][slot]
///   sums over m      [component][cosines of even, odd m, sines of even, odd m][row][column]
///     ... made samples, multiplied by visibility, and made sums again in place
///   sums over phi    [component][slot][row]
///   sums over rows   [harmonic]
/// A component is the even or odd part of a Stokes component; rows, columns and slots are ShadowGrid's.
class DeviceShadowGrid {
public:
    /// Copies the host's samples; `shadows` must have a grid.
    DeviceShadowGrid(const std::shared_ptr<gl::Context>& context, const VisibilityProduct& shadows);

    /// Multiplies light by its vertices' visibility: light = V light, except in unoccluded blocks.
    void run(DeviceLight& light);

private:
    // Numbers, each of which is a sum of products of consecutive other numbers with fixed factors.
    struct Sums {
        gl::Buffer rows;
        gl::Buffer factors;
        unsigned count;
    };

    [[nodiscard]] Sums over_orders(const ShadowGrid& grid) const;
    [[nodiscard]] Sums over_degrees(const ShadowGrid& grid) const;
    [[nodiscard]] Sums over_columns(const ShadowGrid& grid) const;
    [[nodiscard]] Sums over_rows(const ShadowGrid& grid, std::size_t size) const;

    // Multiplies some channels of a chunk's light.
    void multiply(DeviceLight& light, gl::ChannelGroup channels, unsigned groups, const gl::Buffer& samples);

    std::shared_ptr<gl::Context> context_;
    gl::Program gather_;
    gl::Program sums_;
    gl::Program multiply_;
    gl::Program store_;
    DeviceShadowCoefficients samples_;
    unsigned points_;    // rows times columns times Stokes components
    std::size_t chunk_;  // vertices of a chunk
    Sums orders_;
    Sums degrees_;
    Sums columns_;
    Sums rows_;
    // Both work spaces, [channel][number][shadowed vertex], and their numbers of a channel.
    std::size_t column_numbers_;
    std::size_t slot_numbers_;
    std::optional<gl::Buffer> on_columns_;
    std::optional<gl::Buffer> on_slots_;
};

}  // namespace nicol
