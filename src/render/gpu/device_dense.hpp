// SPDX-License-Identifier: MIT
// The dense method on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "render/dense_method.hpp"
#include "render/gpu/device_shade.hpp"

namespace nicol {

/// Holds copies of the matrices of a DenseMethod and the outgoing light of its vertices. All members inside
/// run().
class DeviceDense {
public:
    explicit DeviceDense(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// relight of all vertices.
    void relight(const DenseMethod& method, const TransferInput& input, Progress& progress);
    void shade(const TransferInput& input, DeviceShade& shade, VertexBuffers& buffers);

private:
    // Vertices of one instance whose matrices one binding reaches.
    struct Piece {
        const DenseMaterial* material;
        const DeviceTable* table;
        int rows;  // of a matrix, with padding
        gl::Buffer matrices;
        DeviceLight light;
    };

    void copy(const DenseMethod& method, int light_channels);
    void multiply(const TransferInput& input, Piece& piece);

    std::shared_ptr<gl::Context> context_;
    std::optional<gl::Program> program_;
    std::map<std::shared_ptr<const ResponseTable>, DeviceTable> tables_;
    std::vector<Piece> pieces_;
    Stage<Version, int> copying_;  // runs, channels of the light
};

}  // namespace nicol
