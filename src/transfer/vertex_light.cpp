// SPDX-License-Identifier: MIT
#include "transfer/vertex_light.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Returns the coefficients of a real field over complex harmonics, m >= 0, from its coefficients over real
// ones.
std::vector<std::complex<float>> complex_half(std::span<const double> channel, int order, std::size_t p) {
    std::vector<std::complex<float>> half;
    for (int l = 0; l <= order; ++l) {
        half.emplace_back(static_cast<float>(channel[4 * psh_index(l, 0) + p]));
        for (int m = 1; m <= l; ++m) {
            half.emplace_back(static_cast<float>(channel[4 * psh_index(l, m) + p] / std::numbers::sqrt2),
                              static_cast<float>(-channel[4 * psh_index(l, -m) + p] / std::numbers::sqrt2));
        }
    }
    return half;
}

}  // namespace

void VertexLight::resize(const LightLayout& layout, int channels, std::size_t vertices) {
    const std::size_t former = row_size();
    size_ = layout.size();
    channels_ = channels;
    if (row_size() != former) data_.resize(0);
    data_.resize((vertices + kLanes - 1) / kLanes);
    allocate();
}

void VertexLight::allocate() {
    for (std::size_t block = 0; block < blocks(); ++block) {
        if (data_.at(block) == nullptr) data_.allocate(block, row_size());
    }
}

void VertexLight::renumber(std::span<const std::uint32_t> former, bool rows) {
    const std::size_t size = row_size();
    const auto copy = [size, rows](Lanes* to, std::size_t lane, const Lanes* from, std::size_t lane_before) {
        if (rows) {
            std::copy_n(from->value.data() + lane_before * size, size, to->value.data() + lane * size);
            return;
        }
        for (std::size_t k = 0; k < size; ++k) to[k][lane] = from[k][lane_before];
    };
    data_.renumber(
        former, size, [](std::size_t /*block*/) { return true; }, copy);
}

void VertexLight::to_rows(std::size_t block) {
    const std::span<Lanes> lanes(data_.at(block), row_size());
    const std::span<Lanes> copy = work_space<VertexLight, Lanes>(lanes.size());
    std::ranges::copy(lanes, copy.begin());
    float* to = lanes.front().value.data();
    for (std::size_t i = 0; i < kLanes; ++i)
        for (const Lanes& number : copy) *to++ = number[i];
}

Relight::Relight(const LightLayout& layout, const PshVector& light)
    : order_(layout.order()), rotation_(layout.order()), fields_(layout, LightFields::Form::rotated) {
    for (const LightFields::Part& part : fields_.parts()) {
        std::vector<Field>& channels = channels_.emplace_back();
        for (int c = 0; c < light.channels(); ++c) {
            const std::span<const double> from = light.channel(c);
            Field& field = channels.emplace_back();
            if (part.kind == LaneRotation::Field::real) {
                field = complex_half(from, order_, part.component == LightKind::full ? 3 : 0);
                continue;
            }
            for (std::size_t index = 0; index < psh_count(order_); ++index) {
                field.emplace_back(static_cast<float>(from[4 * index + 1]),
                                   static_cast<float>(from[4 * index + 2]));
            }
        }
    }
}

void Relight::run_part(std::size_t p, LaneRotation::Work& work, std::size_t block, VertexLight& out) const {
    const LightFields::Part& part = fields_.parts()[p];
    const auto channels = static_cast<std::size_t>(out.channels());
    for (std::size_t first = 0; first < channels; first += LaneRotation::kMostFields) {
        std::array<const std::complex<float>*, LaneRotation::kMostFields> in{};
        const std::size_t count = std::min(in.size(), channels - first);
        bool zero = true;
        for (std::size_t f = 0; f < count; ++f) {
            const Field& field = channels_[p][first + f];
            in[f] = field.data();
            zero = zero && std::ranges::all_of(field, [](const auto& number) { return number == 0.0F; });
        }
        if (zero) {
            for (std::size_t f = 0; f < count; ++f)
                std::ranges::fill(
                    out.block(block, static_cast<int>(first + f)).subspan(part.begin, part.to_light.size()),
                    Lanes{});
            continue;
        }
        rotation_.rotate(part.kind, std::span(in).first(count), work);
        for (std::size_t f = 0; f < count; ++f)
            LightFields::to_light(part, work.fields(), count, f,
                                  out.block(block, static_cast<int>(first + f)).data());
    }
}

void Relight::run(std::span<const glm::vec3> normals, std::size_t first, std::size_t last,
                  VertexLight& out) const {
    LaneRotation::Work& work = rotation_.work_of_thread();
    for (std::size_t block = first; block < last; ++block) {
        const std::size_t begin = block * kLanes;
        rotation_.set_normals(normals.subspan(begin, std::min(kLanes, normals.size() - begin)), work);
        for (std::size_t p = 0; p < channels_.size(); ++p) run_part(p, work, block, out);
    }
}

}  // namespace nicol
