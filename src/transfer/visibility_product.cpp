// SPDX-License-Identifier: MIT
#include "transfer/visibility_product.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "error.hpp"
#include "harmonics/psh.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"
#include "visibility/even_irradiance.hpp"

namespace nicol {
namespace {

constexpr int kMostFixed = 32767;
constexpr float kLargestFixed = kMostFixed / kFixedOne;

std::int16_t to_fixed(float number) {
    // Added to a float of this size, a number is rounded to an integer, faster than by std::lround.
    constexpr float whole = 12582912.0F;
    const float scaled = std::clamp(number * kFixedOne, -1.0F * kMostFixed, 1.0F * kMostFixed);
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

void check_needed(std::span<const std::uint8_t> needed, const Visibility& visibility) {
    if (!needed.empty() && needed.size() != visibility.vertices())
        throw Error(ErrorCode::invalid_argument, "`needed` must be empty or have one flag for each vertex");
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

// Returns whether a block of sixteen has a needed vertex; true if `needed` is empty.
bool is_needed(std::span<const std::uint8_t> needed, std::size_t block) {
    if (needed.empty()) return true;
    const std::span of_block = needed.subspan(block * kLanes);
    return std::ranges::any_of(of_block.first(std::min(kLanes, of_block.size())),
                               [](std::uint8_t flag) { return flag != 0; });
}

}  // namespace

VisibilityProduct::VisibilityProduct(const Visibility& visibility, const DirectionSet& directions,
                                     std::span<const glm::vec3> normals, const LightLayout& layout,
                                     const KeptCoefficients& keep, std::span<const std::uint8_t> needed)
    : layout_(layout) {
    check_sizes(visibility, directions, normals);
    check_needed(needed, visibility);
    check_keep(keep.blocks, visibility, 2 * layout.order());
    const VisibilityHarmonics harmonics(directions, 2 * layout_.order());
    if (layout.order() <= kHighestMatrixOrder) {
        size_ = matrices_.emplace(layout).size();
    } else {
        size_ = grid_.emplace(layout).samples();
    }
    find_occluded(visibility);
    numbers_.resize((visibility.vertices() + kLanes - 1) / kLanes);
    std::vector<std::uint32_t> vertices;
    for (std::size_t first = 0; first < vertices_.size(); first += kLanes) {
        const std::size_t block = vertices_[first] / kLanes;
        if (!is_needed(needed, block)) continue;
        numbers_.allocate(block, size_ / 2);
        const std::span all(vertices_);
        const auto of_block = all.subspan(first, std::min(kLanes, all.size() - first));
        vertices.insert(vertices.end(), of_block.begin(), of_block.end());
    }
    store(vertices, {visibility, harmonics, normals, keep});
}

VisibilityProduct::VisibilityProduct(VisibilityProduct&& before, std::span<const std::uint32_t> former,
                                     const Visibility& visibility, const DirectionSet& directions,
                                     std::span<const glm::vec3> normals, const KeptCoefficients& keep,
                                     std::span<const std::uint8_t> needed)
    : VisibilityProduct(std::move(before)) {
    check_sizes(visibility, directions, normals);
    check_needed(needed, visibility);
    check_keep(keep.blocks, visibility, 2 * layout_.order());
    if (former.size() != visibility.vertices()) {
        throw Error(ErrorCode::invalid_argument, "`former` must have one number for each vertex");
    }
    find_occluded(visibility);
    std::vector<std::uint8_t> wanted((former.size() + kLanes - 1) / kLanes, 0);
    for (const std::uint32_t block : occluded_) {
        const auto vertices =
            former.subspan(block * kLanes, std::min(kLanes, former.size() - block * kLanes));
        const bool known = std::ranges::find(vertices, kNoVertex) == vertices.end();
        wanted[block] = known || is_needed(needed, block) ? 1 : 0;
    }
    const auto copy = [this](NumberPair* to, std::size_t lane, const NumberPair* from,
                             std::size_t lane_before) {
        const std::size_t step = matrices_ ? 2 : 1;
        const std::size_t second = matrices_ ? 1 : kLanes;
        for (std::size_t k = 0; k < size_ / 2; ++k) {
            to[k].value[lane * step] = from[k].value[lane_before * step];
            to[k].value[lane * step + second] = from[k].value[lane_before * step + second];
        }
    };
    const std::vector<std::uint32_t> changed = numbers_.renumber(
        former, size_ / 2, [&](std::size_t block) { return wanted[block] != 0; }, copy);
    if (changed.empty()) return;
    const VisibilityHarmonics harmonics(directions, 2 * layout_.order());
    store(changed, {visibility, harmonics, normals, keep});
}

void VisibilityProduct::find_occluded(const Visibility& visibility) {
    occluded_.clear();
    vertices_.clear();
    for (std::size_t begin = 0; begin < visibility.vertices(); begin += kLanes) {
        const std::size_t end = std::min(begin + kLanes, visibility.vertices());
        if (all_ones(visibility.unoccluded().subspan(begin, end - begin))) continue;
        occluded_.push_back(static_cast<std::uint32_t>(begin / kLanes));
        for (std::size_t v = begin; v < end; ++v) vertices_.push_back(static_cast<std::uint32_t>(v));
    }
}

void VisibilityProduct::grow_unit(float largest) {
    int doublings = 0;
    for (; unit_ * kLargestFixed < largest; ++doublings) unit_ *= 2;
    const int half = 1 << (doublings - 1);
    tbb::parallel_for(std::size_t{0}, numbers_.blocks(), [&](std::size_t block) {
        if (numbers_.at(block) == nullptr) return;
        for (NumberPair& pair : std::span(numbers_.at(block), size_ / 2))
            for (std::int16_t& number : pair.value)
                number = static_cast<std::int16_t>((number + half) >> doublings);
    });
}

template <class Use>
void VisibilityProduct::compute(std::span<const std::uint32_t> all, const Input& input,
                                const Use& use) const {
    constexpr std::size_t most = VisibilityHarmonics::kBatch;
    const std::size_t size = psh_count(input.harmonics.order());
    const EvenIrradiance even(input.harmonics.directions(), layout_.order());
    tbb::parallel_for(std::size_t{0}, (all.size() + most - 1) / most, [&](std::size_t batch) {
        const std::span vertices = all.subspan(batch * most, std::min(most, all.size() - batch * most));
        std::vector<Lanes> projected((vertices.size() + kLanes - 1) / kLanes * size), numbers(size_);
        input.harmonics.project(input.visibility, input.normals, vertices, projected);
        for (std::size_t first = 0; first < vertices.size(); first += kLanes) {
            const std::span some = vertices.subspan(first, std::min(kLanes, vertices.size() - first));
            const std::span coefficients = std::span(projected).subspan(first / kLanes * size, size);
            if (input.keep.blocks != nullptr) {
                input.keep.blocks->set(some, coefficients.data());
                if (!input.keep.missing.empty())
                    for (const std::uint32_t v : some) input.keep.missing[v] = 0;
            }
            const std::span numbers_of_lanes(coefficients.front().value.data(), size * kLanes);
            for (std::size_t i = 0; i < some.size(); ++i)
                even.restore(input.visibility, some[i], input.normals[some[i]], numbers_of_lanes.subspan(i),
                             kLanes);
            if (matrices_) {
                matrices_->make(coefficients.data(), numbers.data());
            } else {
                grid_->sample(coefficients.data(), numbers.data());
            }
            use(some, numbers);
        }
    });
}

void VisibilityProduct::store(std::span<const std::uint32_t> vertices, const Input& input) {
    const float largest = store_in_unit(vertices, input);
    if (largest <= unit_ * kLargestFixed) return;
    // Few vertices have numbers that were clamped.
    std::vector<std::uint8_t> clamped(vertices.size(), 0);
    const std::size_t step = matrices_ ? 2 : 1, second = matrices_ ? 1 : kLanes;
    tbb::parallel_for(std::size_t{0}, vertices.size(), [&](std::size_t i) {
        const std::int16_t* const of =
            numbers_.at(vertices[i] / kLanes)->value.data() + vertices[i] % kLanes * step;
        for (std::size_t k = 0; k < size_ && clamped[i] == 0; k += 2)
            clamped[i] =
                std::max(std::abs(of[k * kLanes]), std::abs(of[k * kLanes + second])) == kMostFixed ? 1 : 0;
    });
    std::vector<std::uint32_t> again;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (clamped[i] != 0) again.push_back(vertices[i]);
    grow_unit(largest);
    store_in_unit(again, {input.visibility, input.harmonics, input.normals, {}});
}

float VisibilityProduct::store_in_unit(std::span<const std::uint32_t> vertices, const Input& input) {
    const std::size_t step = matrices_ ? 2 : 1;         // step from lane to lane
    const std::size_t second = matrices_ ? 1 : kLanes;  // step from the first number of a pair to the second
    // With fewer directions than coefficients, the numbers may leave the range of visibility.
    const bool may_be_large = psh_count(input.harmonics.order()) > input.harmonics.directions().size();
    std::atomic<float> largest = 0;
    compute(vertices, input, [&](std::span<const std::uint32_t> some, std::span<const Lanes> numbers) {
        std::array<std::int16_t*, kLanes> to{};
        for (std::size_t i = 0; i < some.size(); ++i)
            to[i] = numbers_.at(some[i] / kLanes)->value.data() + some[i] % kLanes * step;
        for (std::size_t k = 0; k < size_; k += 2) {
            for (std::size_t i = 0; i < some.size(); ++i) {
                std::int16_t* const pair = to[i] + k * kLanes;
                pair[0] = to_fixed(numbers[k][i] / unit_);
                pair[second] = to_fixed(numbers[k + 1][i] / unit_);
            }
        }
        if (!may_be_large) return;
        Lanes most{};
        for (const Lanes& lanes : numbers)
            for (std::size_t i = 0; i < kLanes; ++i) most[i] = std::max(most[i], std::abs(lanes[i]));
        const float here = *std::max_element(most.value.begin(), most.value.begin() + some.size());
        float known = largest;
        while (known < here && !largest.compare_exchange_weak(known, here)) {
        }
    });
    return largest;
}

void VisibilityProduct::find_computed(std::span<std::uint8_t> computed) const {
    std::ranges::fill(computed, std::uint8_t{1});
    for (const std::uint32_t block : occluded_) {
        if (numbers_.at(block) != nullptr) continue;
        const std::span of_block = computed.subspan(block * kLanes);
        std::ranges::fill(of_block.first(std::min(kLanes, of_block.size())), std::uint8_t{0});
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
        if (numbers_.at(sixteen) == nullptr) continue;
        const std::int16_t* numbers = numbers_.at(sixteen)->value.data();
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
    return numbers_.count() * size_ / 2 * sizeof(NumberPair) +
           (vertices_.size() + occluded_.size()) * sizeof(std::uint32_t);
}

}  // namespace nicol
