// SPDX-License-Identifier: MIT
// The dense method on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "devices/gl/device_pixels.hpp"
#include "devices/gl/device_rotation.hpp"
#include "devices/gl/device_shade.hpp"
#include "methods/dense_method.hpp"

namespace nicol {

/// Copies of a DenseMethod's matrices, and the outgoing light of its vertices. All members must be called
/// inside run() of the context.
class DeviceDense {
public:
    explicit DeviceDense(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Relights all vertices.
    void relight(const DenseMethod& method, const TransferInput& input, Progress& progress,
                 VertexBuffers& buffers);
    void shade(DeviceShade& shade, const DevicePoints& vertices);

    /// Returns the largest number of points that shading at pixels takes at once.
    [[nodiscard]] std::size_t prepare_pixels(const DenseMethod& method, const PixelInput& input);
    /// Pieces have lights of several sizes.
    static constexpr DevicePixels::Joins kJoins = DevicePixels::Joins::none;
    /// Computes the light that leaves the points of a stretch, which has one run.
    void light_pixels(const PixelInput& input, const PixelStretch& stretch, DevicePixels& pixels);
    void shade_pixels(const MaterialPtr& material, const PixelRun& run, const DevicePixels& pixels,
                      DeviceShade& shade, const DevicePoints& points);

private:
    // Vertices of one instance whose matrices fit into one binding.
    struct Piece {
        const DenseMaterial* material;
        const DeviceTable* table;
        int rows;  // rows of a matrix, including padding
        gl::Buffer matrices;
        DeviceLight light;
    };

    [[nodiscard]] const Piece& first_piece(const PixelRun& run) const;
    void copy(const DenseMethod& method, int light_channels);
    void multiply(const TransferInput& input, Piece& piece);

    std::shared_ptr<gl::Context> context_;
    std::optional<gl::Program> program_;
    std::map<std::shared_ptr<const ResponseTable>, DeviceTable> tables_;
    std::vector<Piece> pieces_;
    std::optional<DeviceRotation> rotation_;  // for shading at pixels
    Stage<Version, int> copying_;             // runs, channels of the light
};

}  // namespace nicol
