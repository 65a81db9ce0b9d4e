// SPDX-License-Identifier: MIT
#include "devices/gl/device_dense.hpp"

#include <algorithm>

#include "gl/draw.hpp"
#include "gl/storage.hpp"

namespace nicol {

void DeviceDense::relight(const DenseMethod& method, const TransferInput& input, Progress& progress,
                          VertexBuffers& buffers) {
    copying_.run(method.runs().version(), input.light.channels(),
                 [&] { copy(method, input.light.channels()); });
    if (!program_) program_ = gl::Program::compute(context_, "dense.comp");
    for (Piece& piece : pieces_) {
        progress.report("relight", static_cast<double>(piece.light.first()) /
                                       static_cast<double>(input.geometry.positions.size()));
        multiply(input, piece);
        if (!input.at_pixels) continue;
        if (!rotation_) rotation_.emplace(context_);
        rotation_->set_layout(piece.material->outgoing());
        rotation_->into_world(*buffers.normals(input.geometry), piece.light);
    }
}

void DeviceDense::copy(const DenseMethod& method, int light_channels) {
    pieces_.clear();
    tables_.clear();
    for (const DenseMethod::Run& run : *method.runs()) {
        const DenseTransfer& transfer = run.matrices;
        const LightLayout& outgoing = transfer.material().outgoing();
        const auto table = tables_.try_emplace(run.response, context_, outgoing, *run.response).first;
        const std::size_t coefficients = outgoing.size();
        const gl::Limits& limits = context_->limits();
        const std::size_t step = std::max<std::size_t>(
            1, std::min({DeviceLight::most_vertices(
                             *context_, std::max(coefficients, DeviceRotation::work_space(outgoing))),
                         limits.storage_bytes / (transfer.vertex_stride() * sizeof(float)),
                         limits.groups[0] * gl::kGroupOfVertices / transfer.row_stride()}));
        for (std::size_t first = 0; first < transfer.vertices(); first += step) {
            const std::size_t last = std::min(first + step, transfer.vertices());
            pieces_.push_back(
                {.material = &transfer.material(),
                 .table = &table->second,
                 .rows = static_cast<int>(transfer.row_stride()),
                 .matrices = gl::Buffer(context_, gl::BufferUse::storage,
                                        std::as_bytes(transfer.between(first, last))),
                 .light = DeviceLight(context_, run.first + first, last - first, coefficients,
                                      std::max(light_channels, transfer.material().channels()))});
        }
    }
}

void DeviceDense::multiply(const TransferInput& input, Piece& piece) {
    const std::vector<std::size_t>& columns = piece.material->columns();
    const int channels = piece.material->channels();
    program_->set("count", static_cast<int>(piece.light.count()));
    program_->set("stride", static_cast<int>(piece.light.stride()));
    program_->set("rows", piece.rows);
    program_->set("used_rows", static_cast<int>(piece.light.coefficients()));
    program_->set("columns", static_cast<int>(columns.size()));
    program_->set("channels", channels);
    program_->set("one_matrix", channels == 1 ? 1 : 0);
    std::vector<std::vector<float>> numbers(static_cast<std::size_t>(input.light.channels()));
    for (int c = 0; c < input.light.channels(); ++c) {
        const std::span<const double> from = input.light.channel(c);
        for (const std::size_t column : columns)
            numbers[static_cast<std::size_t>(c)].push_back(static_cast<float>(from[column]));
    }
    const gl::ChannelStorage world(context_, numbers);
    piece.matrices.bind_storage(0);
    program_->set("world_step", static_cast<int>(world.step()));
    program_->set("light_step", static_cast<int>(piece.light.channel_step()));
    gl::for_independent_channels(
        *context_, piece.light.channels(), std::max(piece.light.channel_bytes(), world.bytes()),
        [&](gl::ChannelGroup some) {
            program_->set("first_channel", some.first);
            world.bind(1, some);
            piece.light.bind(2, some);
            gl::dispatch(*program_,
                         gl::groups_for(piece.light.count() * static_cast<std::size_t>(piece.rows)), 1,
                         static_cast<unsigned>(some.count));
        });
}

void DeviceDense::shade(DeviceShade& shade, const DevicePoints& vertices) {
    const gl::IndependentDispatches of_pieces(*context_);
    for (const Piece& piece : pieces_)
        shade.run(*piece.table, piece.light, piece.light.first(), piece.light.last(), vertices);
}

std::size_t DeviceDense::prepare_pixels(const DenseMethod& /*method*/, const PixelInput& input) {
    const LightLayout largest(input.layout.order(), LightKind::full);
    return DeviceLight::most_vertices(*context_,
                                      std::max(largest.size(), DeviceRotation::work_space(largest)));
}

const DeviceDense::Piece& DeviceDense::first_piece(const PixelRun& run) const {
    return *std::ranges::find(pieces_, run.surface.first,
                              [](const Piece& piece) { return piece.light.first(); });
}

void DeviceDense::light_pixels(const PixelInput& /*input*/, const PixelStretch& stretch,
                               DevicePixels& pixels) {
    const VertexRange& surface = stretch.runs.front().surface;
    const Piece& first = first_piece(stretch.runs.front());
    DeviceLight& light =
        pixels.light(stretch.first(), stretch.last(), first.light.coefficients(), first.light.channels());
    for (const Piece& piece : pieces_) {
        const std::size_t begin = piece.light.first();
        if (begin >= surface.first && begin < surface.last)
            pixels.interpolate(piece.light, begin > surface.first, stretch.first(), light);
    }
    rotation_->set_layout(first.material->outgoing());
    rotation_->into_frames(*pixels.points().normals, stretch.first(), light);
}

void DeviceDense::shade_pixels(const MaterialPtr& /*material*/, const PixelRun& run,
                               const DevicePixels& pixels, DeviceShade& shade, const DevicePoints& points) {
    shade.run(*first_piece(run).table, pixels.light(), run.first, run.last, points);
}

}  // namespace nicol
