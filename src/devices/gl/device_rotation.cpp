// SPDX-License-Identifier: MIT
#include "devices/gl/device_rotation.hpp"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <numbers>
#include <utility>

#include "gl/draw.hpp"
#include "gl/storage.hpp"
#include "harmonics/wigner.hpp"

namespace nicol {
namespace {

std::size_t field_count(const LightLayout& layout) {
    return layout.kind() == LightKind::unpolarized ? 1 : 2;
}

// Returns the entries in the layout of rotation.glsl.
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

void DeviceRotation::set_layout(const LightLayout& layout) {
    if (!tables_.empty() && tables_.begin()->second.layout.order() != layout.order()) tables_.clear();
    auto found = tables_.find(layout.kind());
    if (found == tables_.end()) {
        const std::vector<double> d = wigner_d(layout.order(), -std::numbers::pi / 2);
        const std::vector<std::array<std::int32_t, 8>> entries = entries_of(layout);
        found = tables_
                    .emplace(layout.kind(), Tables{.layout = layout,
                                                   .quarter_rotation = gl::storage(
                                                       context_, std::vector<float>(d.begin(), d.end())),
                                                   .entries = gl::storage(context_, entries),
                                                   .entry_count = static_cast<unsigned>(entries.size())})
                    .first;
    }
    current_ = &found->second;
}

void DeviceRotation::set_light(const PshVector& light) {
    std::vector<std::vector<float>> numbers(static_cast<std::size_t>(light.channels()));
    for (int c = 0; c < light.channels(); ++c) {
        const std::span<const double> from = light.channel(c);
        for (const auto& [first, second] : current_->layout.terms()) {
            numbers[static_cast<std::size_t>(c)].push_back(static_cast<float>(
                first.factor * from[first.coefficient] + second.factor * from[second.coefficient]));
        }
    }
    if (distant_ && numbers == numbers_) return;
    distant_.reset();
    distant_.emplace(context_, numbers);
    numbers_ = std::move(numbers);
}

void DeviceRotation::run(const gl::Buffer& normals, DeviceLight& out) {
    rotate(normals, false, out.last(), out);
}

void DeviceRotation::into_frames(const gl::Buffer& normals, std::size_t own, DeviceLight& light) {
    rotate(normals, false, own, light);
}

void DeviceRotation::into_world(const gl::Buffer& normals, DeviceLight& light) {
    rotate(normals, true, light.first(), light);
}

void DeviceRotation::rotate(const gl::Buffer& normals, bool back, std::size_t own, DeviceLight& light) {
    const LightLayout& layout = current_->layout;
    const std::size_t fields = field_count(layout) * psh_count(layout.order());
    const std::size_t bytes = fields * light.stride() * sizeof(glm::vec2);
    const int most = gl::channels_at_once(*context_, light.channels(), std::max(bytes, light.channel_bytes()),
                                          DeviceLight::kWorkBytes);
    const std::size_t work = static_cast<std::size_t>(most) * bytes;
    if (!work_ || work_->size() != work) {
        work_.reset();
        work_.emplace(context_, gl::BufferUse::storage, work, gl::BufferUpdate::fixed);
    }
    const std::size_t begin = gl::bind_vertices(normals, 1, 3, light.first(), light.last());
    for (gl::Program* program : {&azimuth_, &zenith_}) {
        program->set("first", static_cast<int>(light.first() - begin));
        program->set("stride", static_cast<int>(light.stride()));
        program->set("fields_step", static_cast<int>(fields * light.stride()));
        program->set("order", layout.order());
        program->set("back", back ? 1 : 0);
    }
    zenith_.set("count", static_cast<int>(light.count()));
    zenith_.set("light_step", static_cast<int>(light.channel_step()));
    current_->quarter_rotation.bind_storage(0);
    current_->entries.bind_storage(2);
    const auto start = [&](bool distant, std::size_t first, std::size_t last, gl::ChannelGroup channels) {
        if (first == last) return;
        azimuth_.set("points", glm::ivec2(first, last));
        azimuth_.set("light_step", static_cast<int>(distant ? distant_->step() : light.channel_step()));
        azimuth_.set("number_step", distant ? 1 : static_cast<int>(light.stride()));
        azimuth_.set("point_step", distant ? 0 : 1);
        if (distant) {
            distant_->bind(3, channels);
        } else {
            light.bind(3, channels);
        }
        gl::dispatch(azimuth_, gl::groups_for(last - first), static_cast<unsigned>(fields),
                     static_cast<unsigned>(channels.count));
    };
    gl::for_channels(light.channels(), most, [&](gl::ChannelGroup channels) {
        const auto count = static_cast<unsigned>(channels.count);
        work_->bind_storage(4, 0, count * bytes);
        {
            const gl::IndependentDispatches of_points(*context_);
            start(true, 0, own - light.first(), channels);
            start(false, own - light.first(), light.count(), channels);
        }
        work_->bind_storage(3, 0, count * bytes);
        light.bind(4, channels);
        gl::dispatch(zenith_, gl::groups_for(light.count()), current_->entry_count, count);
    });
}

}  // namespace nicol
