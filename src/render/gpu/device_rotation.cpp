// SPDX-License-Identifier: MIT
#include "render/gpu/device_rotation.hpp"

#include <array>
#include <complex>
#include <glm/vec2.hpp>
#include <numbers>

#include "gl/draw.hpp"
#include "harmonics/wigner.hpp"

namespace nicol {
namespace {

std::size_t field_count(const LightLayout& layout) {
    return layout.kind() == LightKind::unpolarized ? 1 : 2;
}

// Coefficients of s0 + i s3, then of s1 + i s2, over complex harmonics.
std::vector<glm::vec2> complex_fields(const LightLayout& layout, std::span<const double> channel) {
    const std::size_t size = psh_count(layout.order());
    std::vector<glm::vec2> fields(field_count(layout) * size);
    const auto real_field = [&](int l, int m, std::size_t p) -> std::complex<double> {
        const double plus = channel[4 * psh_index(l, std::abs(m)) + p];
        if (m == 0) return plus;
        const std::complex<double> value(plus, -channel[4 * psh_index(l, -std::abs(m)) + p]);
        return (m > 0 ? value : (m % 2 == 0 ? 1.0 : -1.0) * std::conj(value)) / std::numbers::sqrt2;
    };
    for (int l = 0; l <= layout.order(); ++l) {
        for (int m = -l; m <= l; ++m) {
            std::complex<double> scalar = real_field(l, m, 0);
            if (layout.kind() == LightKind::full) {
                scalar += std::complex<double>(0, 1) * real_field(l, m, 3);
            }
            const std::size_t index = psh_index(l, m);
            fields[index] = {scalar.real(), scalar.imag()};
            if (layout.kind() == LightKind::unpolarized || l < 2) continue;
            fields[size + index] = {channel[4 * index + 1], channel[4 * index + 2]};
        }
    }
    return fields;
}

// As in rotate_zenith.comp.
std::vector<std::array<std::int32_t, 8>> entries_of(const LightLayout& layout) {
    std::vector<std::array<std::int32_t, 8>> entries;
    std::vector<std::size_t> places(2 * psh_count(layout.order()));  // [field][psh_index] in entries
    for (std::int32_t field = 0; field < static_cast<std::int32_t>(field_count(layout)); ++field) {
        for (int l = 2 * field; l <= layout.order(); ++l) {
            for (int m = 0; m <= l; ++m) {
                places[static_cast<std::size_t>(field) * psh_count(layout.order()) + psh_index(l, m)] =
                    entries.size();
                entries.push_back({field, l, m, 0, -1, -1, -1, -1});
            }
        }
    }
    for (const LightLayout::Run& run : layout.runs()) {
        const bool spin = run.part == LightKind::linear;
        for (std::size_t i = 0; i < run.count; ++i) {
            const std::size_t index = psh_index(run.l + static_cast<int>(i) * run.step, run.m);
            std::array<std::int32_t, 8>& entry =
                entries[places[(spin ? psh_count(layout.order()) : 0) + index]];
            const auto even = static_cast<std::int32_t>(run.even + i);
            const auto odd = static_cast<std::int32_t>(run.odd + i);
            if (run.m == 0 && spin) {  // a cosine of one part and one of the other, or sines
                entry[run.sign > 0 ? 4 : 5] = run.sign > 0 ? even : odd;
                entry[run.sign > 0 ? 6 : 7] = run.sign > 0 ? odd : even;
            } else if (run.sign > 0) {
                entry[4] = even;
                if (run.m > 0) entry[5] = odd;
            } else {
                entry[6] = odd;
                if (run.m > 0) entry[7] = even;
            }
        }
    }
    return entries;
}

}  // namespace

std::size_t DeviceRotation::work_space(const LightLayout& layout) {
    return 2 * field_count(layout) * psh_count(layout.order());
}

DeviceRotation::DeviceRotation(const std::shared_ptr<gl::Context>& context)
    : context_(context),
      azimuth_(gl::Program::compute(context, "rotate_azimuth.comp")),
      zenith_(gl::Program::compute(context, "rotate_zenith.comp")) {}

void DeviceRotation::set_light(const LightLayout& layout, const PshVector& light) {
    if (!layout_ || layout_->order() != layout.order() || layout_->kind() != layout.kind()) {
        layout_.reset();
        const std::vector<double> d = wigner_d(layout.order(), -std::numbers::pi / 2);
        const std::vector<float> quarter(d.begin(), d.end());
        quarter_rotation_.emplace(context_, gl::BufferUse::storage, std::as_bytes(std::span(quarter)));
        const std::vector<std::array<std::int32_t, 8>> entries = entries_of(layout);
        entries_.emplace(storage(context_, entries));
        entry_count_ = static_cast<unsigned>(entries.size());
        layout_ = layout;
    }
    fields_.clear();
    for (int c = 0; c < light.channels(); ++c) {
        const std::vector<glm::vec2> fields = complex_fields(layout, light.channel(c));
        fields_.emplace_back(context_, gl::BufferUse::storage, std::as_bytes(std::span(fields)));
    }
}

void DeviceRotation::run(const WorldGeometry& geometry, VertexBuffers& buffers, DeviceLight& out) {
    const std::size_t fields = field_count(*layout_) * psh_count(layout_->order());
    const std::size_t bytes = fields * out.stride() * sizeof(glm::vec2);
    if (!work_ || work_->size() < bytes) {
        work_.reset();
        work_.emplace(context_, gl::BufferUse::storage, bytes, gl::BufferUpdate::fixed);
    }
    for (gl::Program* program : {&azimuth_, &zenith_}) {
        program->set("count", static_cast<int>(out.count()));
        program->set("stride", static_cast<int>(out.stride()));
        program->set("order", layout_->order());
    }
    for (int c = 0; c < out.channels(); ++c) {
        quarter_rotation_->bind_storage(0);
        std::ignore = bind_vertices(*buffers.normals(geometry), 1, 3, out.first(), out.last());
        fields_[static_cast<std::size_t>(c)].bind_storage(2);
        work_->bind_storage(3, 0, bytes);
        gl::dispatch(azimuth_, groups_for(out.count()), static_cast<unsigned>(fields));
        entries_->bind_storage(1);
        work_->bind_storage(2, 0, bytes);
        out.bind(3, c);
        gl::dispatch(zenith_, groups_for(out.count()), entry_count_);
    }
}

}  // namespace nicol
