// SPDX-License-Identifier: MIT
#include "transfer/visibility_product.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "error.hpp"
#include "harmonics/psh.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"
#include "visibility/narrow_opening.hpp"

namespace nicol {
namespace {

constexpr std::uint32_t kUnoccluded = ~std::uint32_t{0};
constexpr float kLargestFixed = 32767.0F / kFixedOne;

std::int16_t to_fixed(float number) {
    // Added to a float of this size, a number is rounded to an integer, faster than by std::lround.
    constexpr float whole = 12582912.0F;
    const float scaled = std::clamp(number * kFixedOne, -32767.0F, 32767.0F);
    return static_cast<std::int16_t>((scaled + whole) - whole);
}

void check_sizes(const Visibility& visibility, const DirectionSet& directions,
                 std::span<const glm::vec3> normals) {
    if (normals.size() != visibility.vertices() || directions.size() != visibility.directions()) {
        throw Error(ErrorCode::invalid_argument,
                    "visibility of " + std::to_string(visibility.vertices()) + " vertices and " +
                        std::to_string(visibility.directions()) + " directions does not go with " +
                        std::to_string(normals.size()) + " normals and " + std::to_string(directions.size()) +
                        " directions");
    }
}

void check_keep(const VisibilityBlocks* keep, const Visibility& visibility, int order) {
    if (keep != nullptr && (keep->order() != order || keep->vertices() != visibility.vertices())) {
        throw Error(
            ErrorCode::invalid_argument,
            "the coefficients to keep must be of the same vertices and of order " + std::to_string(order));
    }
}

bool all_ones(std::span<const std::uint8_t> flags) {
    return std::ranges::all_of(flags, [](std::uint8_t flag) { return flag != 0; });
}

}  // namespace

VisibilityProduct::VisibilityProduct(const Visibility& visibility, const DirectionSet& directions,
                                     std::span<const glm::vec3> normals, const LightLayout& layout,
                                     const KeptCoefficients& keep)
    : layout_(layout) {
    check_sizes(visibility, directions, normals);
    check_keep(keep.blocks, visibility, 2 * layout.order());
    const VisibilityHarmonics harmonics(directions, 2 * layout_.order());
    if (layout.order() <= kHighestMatrixOrder) {
        size_ = matrices_.emplace(layout).size();
    } else {
        size_ = grid_.emplace(layout).samples();
    }
    find_vertices(visibility);
    numbers_.resize(blocks() * size_ / 2);
    if (psh_count(harmonics.order()) > directions.size()) {
        find_unit({visibility, directions, harmonics, normals, {}});
    }
    compute(all_blocks(), {visibility, directions, harmonics, normals, keep},
            [&](std::size_t block, std::span<const Lanes> numbers) { store_block(block, numbers); });
}

VisibilityProduct::VisibilityProduct(VisibilityProduct&& before, std::span<const std::uint32_t> former,
                                     const Visibility& visibility, const DirectionSet& directions,
                                     std::span<const glm::vec3> normals, const KeptCoefficients& keep)
    : VisibilityProduct(std::move(before)) {
    check_sizes(visibility, directions, normals);
    check_keep(keep.blocks, visibility, 2 * layout_.order());
    if (former.size() != visibility.vertices()) {
        throw Error(ErrorCode::invalid_argument, "`former` must have one number for each vertex");
    }
    const std::vector<std::uint32_t> blocks_before = std::move(block_of_);
    const std::size_t vertices_before = vertices_.size();
    find_vertices(visibility);
    bool moved = block_of_ != blocks_before || vertices_.size() != vertices_before;
    for (std::size_t v = 0; v < former.size() && !moved; ++v)
        moved = former[v] != v && former[v] != kNoVertex;
    std::vector<NumberPair> numbers_before;
    if (moved) {
        numbers_before = std::move(numbers_);
        numbers_ = std::vector<NumberPair>(blocks() * size_ / 2);
    }
    // Places of the numbers of sixteen vertices; none if one of them is not known.
    const auto places_of = [&](std::size_t sixteen) -> std::optional<std::array<std::uint32_t, kLanes>> {
        std::array<std::uint32_t, kLanes> places{};
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t v = std::min(sixteen * kLanes + i, former.size() - 1);
            const std::size_t block = former[v] / kLanes;
            if (former[v] == kNoVertex || block >= blocks_before.size()) return std::nullopt;
            if (blocks_before[block] == kUnoccluded) return std::nullopt;
            places[i] = static_cast<std::uint32_t>(blocks_before[block] * kLanes + former[v] % kLanes);
        }
        return places;
    };
    std::vector<std::uint8_t> known(block_of_.size(), 1);
    tbb::parallel_for(std::size_t{0}, block_of_.size(), [&](std::size_t sixteen) {
        if (block_of_[sixteen] == kUnoccluded) return;
        const auto places = places_of(sixteen);
        known[sixteen] = places ? 1 : 0;
        if (places && moved) take_over(block_of_[sixteen], numbers_before, *places);
    });
    std::vector<std::uint32_t> changed;
    for (std::size_t sixteen = 0; sixteen < block_of_.size(); ++sixteen) {
        if (known[sixteen] == 0) changed.push_back(block_of_[sixteen]);
    }
    if (changed.empty()) return;
    const VisibilityHarmonics harmonics(directions, 2 * layout_.order());
    compute(changed, {visibility, directions, harmonics, normals, keep},
            [&](std::size_t block, std::span<const Lanes> numbers) { store_block(block, numbers); });
}

void VisibilityProduct::take_over(std::size_t block, const std::vector<NumberPair>& before,
                                  const std::array<std::uint32_t, kLanes>& places) {
    const std::size_t step = matrices_ ? 2 : 1;
    const std::size_t second = matrices_ ? 1 : kLanes;
    NumberPair* const to = &numbers_[block * size_ / 2];
    bool aligned = places[0] % kLanes == 0;
    for (std::size_t i = 0; i < kLanes; ++i) aligned = aligned && places[i] == places[0] + i;
    if (aligned) {
        std::copy_n(&before[places[0] / kLanes * size_ / 2], size_ / 2, to);
        return;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        const NumberPair* const from = &before[places[i] / kLanes * size_ / 2];
        const std::size_t lane = places[i] % kLanes * step;
        for (std::size_t k = 0; k < size_ / 2; ++k) {
            to[k].value[i * step] = from[k].value[lane];
            to[k].value[i * step + second] = from[k].value[lane + second];
        }
    }
}

std::vector<std::uint32_t> VisibilityProduct::all_blocks() const {
    std::vector<std::uint32_t> out(blocks());
    std::iota(out.begin(), out.end(), 0U);
    return out;
}

void VisibilityProduct::find_vertices(const Visibility& visibility) {
    vertices_.clear();
    block_of_.clear();
    std::uint32_t count = 0;
    for (std::size_t begin = 0; begin < visibility.vertices(); begin += kLanes) {
        const std::size_t end = std::min(begin + kLanes, visibility.vertices());
        if (all_ones(visibility.unoccluded().subspan(begin, end - begin))) {
            block_of_.push_back(kUnoccluded);
            continue;
        }
        block_of_.push_back(count++);
        for (std::size_t v = begin; v < end; ++v) vertices_.push_back(static_cast<std::uint32_t>(v));
    }
}

// Finds the unit of the stored numbers. With fewer directions than coefficients, the numbers may leave the
// range of visibility.
void VisibilityProduct::find_unit(const Input& input) {
    std::vector<float> largest(blocks(), 0.0F);
    compute(all_blocks(), input, [&](std::size_t block, std::span<const Lanes> numbers) {
        for (const Lanes& lanes : numbers)
            for (const float number : lanes.value)
                largest[block] = std::max(largest[block], std::abs(number));
    });
    const float most = largest.empty() ? 0.0F : std::ranges::max(largest);
    while (unit_ * kLargestFixed < most) unit_ *= 2;
}

template <class Use>
void VisibilityProduct::compute(std::span<const std::uint32_t> blocks, const Input& input,
                                const Use& use) const {
    constexpr std::size_t most = VisibilityHarmonics::kBatch / kLanes;
    const std::size_t size = psh_count(input.harmonics.order());
    tbb::parallel_for(std::size_t{0}, (blocks.size() + most - 1) / most, [&](std::size_t batch) {
        const std::span some = blocks.subspan(batch * most, std::min(most, blocks.size() - batch * most));
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t block : some) {
            const auto of_block = std::span(vertices_).subspan(block * kLanes);
            vertices.insert(
                vertices.end(), of_block.begin(),
                of_block.begin() + static_cast<std::ptrdiff_t>(std::min(kLanes, of_block.size())));
        }
        std::vector<Lanes> all(some.size() * size), numbers(size_);
        input.harmonics.project(input.visibility, input.normals, vertices, all);
        for (std::size_t k = 0; k < some.size(); ++k) {
            const std::span coefficients = std::span(all).subspan(k * size, size);
            if (input.keep.blocks != nullptr) {
                const std::size_t sixteen = vertices[k * kLanes] / kLanes;
                input.keep.blocks->set(sixteen, coefficients.data());
                if (!input.keep.missing.empty()) input.keep.missing[sixteen] = 0;
            }
            const std::span numbers_of_lanes(coefficients.front().value.data(), size * kLanes);
            for (std::size_t i = 0; i < kLanes && k * kLanes + i < vertices.size(); ++i) {
                const std::size_t vertex = vertices[k * kLanes + i];
                scale_narrow_opening(input.directions, input.visibility, vertex, input.normals[vertex],
                                     layout_.order(), numbers_of_lanes.subspan(i), kLanes);
            }
            if (matrices_) {
                matrices_->make(coefficients.data(), numbers.data());
            } else {
                grid_->sample(coefficients.data(), numbers.data());
            }
            use(some[k], numbers);
        }
    });
}

void VisibilityProduct::store_block(std::size_t block, std::span<const Lanes> numbers) {
    const std::size_t step = matrices_ ? 2 : 1;         // step from lane to lane
    const std::size_t second = matrices_ ? 1 : kLanes;  // step from the first number of a pair to the second
    NumberPair* pair = &numbers_[block * size_ / 2];
    for (std::size_t k = 0; k < size_; k += 2, ++pair) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            pair->value[i * step] = to_fixed(numbers[k][i] / unit_);
            pair->value[i * step + second] = to_fixed(numbers[k + 1][i] / unit_);
        }
    }
}

void VisibilityProduct::run(VertexLight& light, std::size_t first, std::size_t last,
                            std::size_t skipped) const {
    constexpr std::size_t most = ShadowMatrices::kMostChannels;
    const std::size_t size = layout_.size();
    const auto channels = static_cast<std::size_t>(light.channels());
    const std::span<Lanes> work = work_space<VisibilityProduct, Lanes>(size * most);
    std::array<const Lanes*, most> lights{};
    std::array<Lanes*, most> products{};
    for (std::size_t c = 0; c < most; ++c) products[c] = &work[c * size];
    for (std::size_t sixteen = first; sixteen < last; ++sixteen) {
        if (block_of_[sixteen] == kUnoccluded) continue;
        const std::int16_t* numbers = numbers_[block_of_[sixteen] * size_ / 2].value.data();
        for (std::size_t begin = 0; begin < channels; begin += most) {
            const std::size_t count = std::min(most, channels - begin);
            for (std::size_t c = 0; c < count; ++c) {
                lights[c] = light.block(sixteen - skipped, static_cast<int>(begin + c)).data();
            }
            if (matrices_) {
                matrices_->multiply(numbers, std::span(lights).first(count),
                                    std::span(products).first(count));
            } else {
                for (std::size_t c = 0; c < count; ++c) grid_->multiply(numbers, lights[c], products[c]);
            }
            for (std::size_t c = 0; c < count; ++c) {
                const std::span<Lanes> to = light.block(sixteen - skipped, static_cast<int>(begin + c));
                for (std::size_t k = 0; k < size; ++k) {
                    for (std::size_t i = 0; i < kLanes; ++i) to[k][i] = unit_ * products[c][k][i];
                }
            }
        }
    }
}

std::size_t VisibilityProduct::bytes() const noexcept {
    return numbers_.size() * sizeof(NumberPair) +
           (vertices_.size() + block_of_.size()) * sizeof(std::uint32_t);
}

}  // namespace nicol
