// SPDX-License-Identifier: MIT
#include "transfer/visibility_product.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "error.hpp"
#include "harmonics/mirror_basis.hpp"
#include "harmonics/psh.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"
#include "visibility/shadow_matrices.hpp"

namespace nicol {
namespace {

// Two numbers of sixteen vertices.
struct alignas(64) FixedPair {
    std::array<std::int16_t, 2 * kLanes> value;
};

// No shadow falls on sixteen vertices.
constexpr std::uint32_t open = ~std::uint32_t{0};

using Numbers = std::variant<std::vector<FixedPair>, std::vector<Lanes>>;

constexpr float kLargestFixed = 32767.0F / kFixedOne;

std::int16_t fixed(float number) {
    // Where floats are whole numbers, which is faster than a function of the library.
    constexpr float whole = 12582912.0F;
    const float scaled = std::clamp(number * kFixedOne, -32767.0F, 32767.0F);
    return static_cast<std::int16_t>((scaled + whole) - whole);
}

// Matrices are two to four times as fast as the grid, but memory for them grows with the fourth power of the
// order: four times the grid's at order 6, eleven times at 12.
constexpr int most_for_matrix = 9;

VisibilityProduct::Form choose(VisibilityProduct::Form form, HorizonExtension extension, int order) {
    if (form == VisibilityProduct::Form::best) {
        return extension == HorizonExtension::mirrored && order <= most_for_matrix
                   ? VisibilityProduct::Form::matrix
                   : VisibilityProduct::Form::grid;
    }
    if (form == VisibilityProduct::Form::matrix && extension == HorizonExtension::dark) {
        throw Error(ErrorCode::unsupported,
                    "shadow matrices are made of mirrored visibility alone; dark visibility needs the grid");
    }
    return form;
}

}  // namespace

struct VisibilityProduct::Blocks {
    Blocks(const LightLayout& layout, Form form_, ShadowStorage storage_)
        : order(layout.order()),
          basis(layout),
          form(form_),
          storage(storage_),
          product(
              form == Form::matrix
                  ? Product(std::in_place_type<ShadowMatrices>, basis, 2 * layout.order())
                  : Product(std::in_place_type<ShadowGrid>, layout.order(), basis, layout.order(), basis)) {}

    using Product = std::variant<ShadowMatrices, ShadowGrid>;

    int order;
    MirrorBasis basis;
    Form form;
    ShadowStorage storage;
    Product product;
    bool dark = false;
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> shadow_of;  // for each sixteen vertices, their block of numbers or `open`
    std::size_t stride = 0;                // numbers of one block and lane, even
    float unit = 1;                        // that numbers are stored in
    Numbers numbers;

    void find_vertices(const Visibility& visibility);
    void allocate();
    void take_over(const Numbers& before, std::size_t from, std::size_t to);
    [[nodiscard]] std::vector<Lanes> numbers_of(std::size_t block, const Visibility& visibility,
                                                const VisibilityHarmonics& harmonics,
                                                std::span<const glm::vec3> normals,
                                                VisibilityBlocks* keep) const;
    void make(std::size_t block, const Visibility& visibility, const VisibilityHarmonics& harmonics,
              std::span<const glm::vec3> normals, VisibilityBlocks* keep = nullptr);
    void find_unit(const Visibility& visibility, const VisibilityHarmonics& harmonics,
                   std::span<const glm::vec3> normals);
    template <class Number>
    void multiply(const Number* from, std::span<const Lanes* const> lights,
                  std::span<Lanes* const> products) const;
};

void VisibilityProduct::Blocks::find_vertices(const Visibility& visibility) {
    vertices.clear();
    shadow_of.clear();
    std::uint32_t count = 0;
    for (std::size_t begin = 0; begin < visibility.vertices(); begin += kLanes) {
        const std::size_t end = std::min(begin + kLanes, visibility.vertices());
        // Half of a dark surrounding is dark even where all above the horizon is seen.
        bool shadowed = dark;
        for (std::size_t v = begin; v < end; ++v) shadowed = shadowed || !visibility.unoccluded(v);
        shadow_of.push_back(shadowed ? count++ : open);
        for (std::size_t v = begin; shadowed && v < end; ++v) {
            vertices.push_back(static_cast<std::uint32_t>(v));
        }
    }
}

void VisibilityProduct::Blocks::allocate() {
    const std::size_t count = (vertices.size() + kLanes - 1) / kLanes;
    if (storage == ShadowStorage::fixed16) {
        numbers = std::vector<FixedPair>(count * stride / 2);
    } else {
        numbers = std::vector<Lanes>(count * stride);
    }
}

void VisibilityProduct::Blocks::take_over(const Numbers& before, std::size_t from, std::size_t to) {
    const auto copy = [&]<class Element>(const std::vector<Element>& old, std::size_t size) {
        std::copy_n(old.begin() + static_cast<std::ptrdiff_t>(from * size), size,
                    std::get<std::vector<Element>>(numbers).begin() + static_cast<std::ptrdiff_t>(to * size));
    };
    if (const auto* pairs = std::get_if<std::vector<FixedPair>>(&before)) {
        copy(*pairs, stride / 2);
    } else {
        copy(std::get<std::vector<Lanes>>(before), stride);
    }
}

std::vector<Lanes> VisibilityProduct::Blocks::numbers_of(std::size_t block, const Visibility& visibility,
                                                         const VisibilityHarmonics& harmonics,
                                                         std::span<const glm::vec3> normals,
                                                         VisibilityBlocks* keep) const {
    const std::size_t first = vertices[block * kLanes];
    std::vector<Lanes> coefficients(psh_count(harmonics.order()));
    project_block(harmonics, visibility, normals, first, std::min(kLanes, vertices.size() - block * kLanes),
                  coefficients.data());
    if (keep != nullptr) keep->set(first / kLanes, coefficients.data());
    std::vector<Lanes> made(stride);
    if (const auto* matrices = std::get_if<ShadowMatrices>(&product)) {
        matrices->make(coefficients.data(), made.data());
    } else {
        std::get<ShadowGrid>(product).sample(coefficients.data(), made.data(),
                                             dark ? made.data() + stride / 2 : nullptr);
    }
    return made;
}

// Sums of fewer directions than the numbers that they shall fix are not bound to what visibility can be.
void VisibilityProduct::Blocks::find_unit(const Visibility& visibility, const VisibilityHarmonics& harmonics,
                                          std::span<const glm::vec3> normals) {
    const float largest = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, (vertices.size() + kLanes - 1) / kLanes), 0.0F,
        [&](const auto& range, float most) {
            for (std::size_t block = range.begin(); block < range.end(); ++block) {
                for (const Lanes& lanes : numbers_of(block, visibility, harmonics, normals, nullptr)) {
                    for (std::size_t i = 0; i < kLanes; ++i) most = std::max(most, std::abs(lanes[i]));
                }
            }
            return most;
        },
        [](float a, float b) { return std::max(a, b); });
    while (unit * kLargestFixed < largest) unit *= 2;
}

void VisibilityProduct::Blocks::make(std::size_t block, const Visibility& visibility,
                                     const VisibilityHarmonics& harmonics, std::span<const glm::vec3> normals,
                                     VisibilityBlocks* keep) {
    const std::vector<Lanes> made = numbers_of(block, visibility, harmonics, normals, keep);
    if (auto* lanes = std::get_if<std::vector<Lanes>>(&numbers)) {
        std::ranges::copy(made, lanes->begin() + static_cast<std::ptrdiff_t>(block * stride));
        return;
    }
    // The matrix has either number of a pair in each lane, the grid one after the other.
    const bool beside = form == Form::matrix;
    FixedPair* pair = std::get<std::vector<FixedPair>>(numbers).data() + block * stride / 2;
    for (std::size_t k = 0; k < stride; k += 2, ++pair) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            pair->value[beside ? 2 * i : i] = fixed(made[k][i] / unit);
            pair->value[beside ? 2 * i + 1 : kLanes + i] = fixed(made[k + 1][i] / unit);
        }
    }
}

template <class Number>
void VisibilityProduct::Blocks::multiply(const Number* from, std::span<const Lanes* const> lights,
                                         std::span<Lanes* const> products) const {
    if (const auto* matrices = std::get_if<ShadowMatrices>(&product)) {
        matrices->multiply(from, lights, products);
        return;
    }
    const Number* odd = dark ? from + stride / 2 * kLanes : nullptr;
    for (std::size_t c = 0; c < lights.size(); ++c) {
        std::fill_n(products[c], basis.size(), Lanes{});
        std::get<ShadowGrid>(product).multiply(from, odd, lights[c], products[c]);
    }
}

namespace {

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

}  // namespace

VisibilityProduct::VisibilityProduct(const Visibility& visibility, const DirectionSet& directions,
                                     std::span<const glm::vec3> normals, const LightLayout& layout,
                                     HorizonExtension extension, Form form, ShadowStorage storage,
                                     VisibilityBlocks* keep) {
    check_sizes(visibility, directions, normals);
    if (keep != nullptr &&
        (keep->order() != 2 * layout.order() || keep->vertices() != visibility.vertices())) {
        throw Error(ErrorCode::invalid_argument,
                    "what is to be kept of visibility must be of its vertices and of order " +
                        std::to_string(2 * layout.order()));
    }
    const VisibilityHarmonics harmonics(directions, 2 * layout.order(), extension);
    blocks_ = std::make_unique<Blocks>(layout, choose(form, extension, layout.order()), storage);
    Blocks& b = *blocks_;
    b.dark = extension == HorizonExtension::dark;
    b.find_vertices(visibility);
    if (const auto* matrices = std::get_if<ShadowMatrices>(&b.product)) {
        b.stride = matrices->size();
    } else {
        b.stride = std::get<ShadowGrid>(b.product).samples() * (b.dark ? 2 : 1);
    }
    b.allocate();
    const bool unresolved = psh_count(harmonics.order()) > directions.size();
    if (unresolved && storage == ShadowStorage::fixed16) b.find_unit(visibility, harmonics, normals);
    tbb::parallel_for(std::size_t{0}, blocks(),
                      [&](std::size_t block) { b.make(block, visibility, harmonics, normals, keep); });
}

VisibilityProduct::VisibilityProduct(VisibilityProduct&& before, std::span<const std::uint8_t> unchanged,
                                     const Visibility& visibility, const DirectionSet& directions,
                                     std::span<const glm::vec3> normals) {
    check_sizes(visibility, directions, normals);
    if (unchanged.size() != visibility.vertices()) {
        throw Error(ErrorCode::invalid_argument,
                    "there must be a number of what is unchanged for each vertex");
    }
    blocks_ = std::move(before.blocks_);
    Blocks& b = *blocks_;
    const VisibilityHarmonics harmonics(directions, 2 * b.order,
                                        b.dark ? HorizonExtension::dark : HorizonExtension::mirrored);
    const std::vector<std::uint32_t> places = std::move(b.shadow_of);
    const std::size_t vertices = b.vertices.size();
    b.find_vertices(visibility);
    const bool moved = places != b.shadow_of || vertices != b.vertices.size();
    const Numbers numbers = moved ? std::move(b.numbers) : Numbers();
    if (moved) b.allocate();
    tbb::parallel_for(std::size_t{0}, b.shadow_of.size(), [&](std::size_t block) {
        const std::size_t shadow = b.shadow_of[block];
        if (shadow == open) return;
        const std::size_t first = block * kLanes;
        const std::span same = unchanged.subspan(first, std::min(kLanes, unchanged.size() - first));
        const bool known = block < places.size() && places[block] != open &&
                           std::ranges::all_of(same, [](std::uint8_t one) { return one != 0; });
        if (!known) {
            b.make(shadow, visibility, harmonics, normals);
        } else if (moved) {
            b.take_over(numbers, places[block], shadow);
        }
    });
}

VisibilityProduct::~VisibilityProduct() = default;
VisibilityProduct::VisibilityProduct(VisibilityProduct&&) noexcept = default;
VisibilityProduct& VisibilityProduct::operator=(VisibilityProduct&&) noexcept = default;

std::size_t VisibilityProduct::blocks() const noexcept {
    return (blocks_->vertices.size() + kLanes - 1) / kLanes;
}

void VisibilityProduct::run(VertexLight& light, std::size_t first, std::size_t last) const {
    const Blocks& b = *blocks_;
    const int channels = light.channels();
    const std::size_t size = b.basis.size();
    const std::span<Lanes> product =
        work_space<VisibilityProduct, Lanes>(size * ShadowMatrices::kMostChannels);
    std::array<const Lanes*, ShadowMatrices::kMostChannels> lights{};
    std::array<Lanes*, ShadowMatrices::kMostChannels> products{};
    for (std::size_t c = 0; c < lights.size(); ++c) products[c] = product.data() + c * size;
    for (std::size_t block = first; block < last; ++block) {
        const std::size_t shadow = b.shadow_of[block];
        if (shadow == open) continue;
        for (int begin = 0; begin < channels; begin += static_cast<int>(lights.size())) {
            const int end = std::min(begin + static_cast<int>(lights.size()), channels);
            const auto count = static_cast<std::size_t>(end - begin);
            for (int c = begin; c < end; ++c) {
                lights[static_cast<std::size_t>(c - begin)] = light.block(block, c).data();
            }
            const auto some_lights = std::span(lights).first(count);
            const auto some_products = std::span(products).first(count);
            if (const auto* numbers = std::get_if<std::vector<FixedPair>>(&b.numbers)) {
                b.multiply((*numbers)[shadow * b.stride / 2].value.data(), some_lights, some_products);
            } else {
                b.multiply(reinterpret_cast<const float*>(std::get<std::vector<Lanes>>(b.numbers).data() +
                                                          shadow * b.stride),
                           some_lights, some_products);
            }
            for (int c = begin; c < end; ++c) {
                const Lanes* from = products[static_cast<std::size_t>(c - begin)];
                const std::span<Lanes> to = light.block(block, c);
                for (std::size_t k = 0; k < size; ++k) {
                    for (std::size_t i = 0; i < kLanes; ++i) to[k][i] = b.unit * from[k][i];
                }
            }
        }
    }
}

VisibilityProduct::Form VisibilityProduct::form() const noexcept {
    return blocks_->form;
}

std::optional<VisibilityProduct::Matrices> VisibilityProduct::matrices() const {
    const auto* numbers = std::get_if<std::vector<FixedPair>>(&blocks_->numbers);
    const auto* matrices = std::get_if<ShadowMatrices>(&blocks_->product);
    if (matrices == nullptr || numbers == nullptr) return std::nullopt;
    const std::vector<std::size_t> whole = matrices->whole();
    Matrices out{.basis = blocks_->basis,
                 .vertices = blocks_->vertices,
                 .unit = blocks_->unit,
                 .numbers = std::vector<std::int16_t>(blocks() * whole.size() * kLanes),
                 .numbers_of_vertex = whole.size()};
    auto to = out.numbers.begin();
    for (std::size_t block = 0; block < blocks(); ++block) {
        for (const std::size_t number : whole) {
            const FixedPair& pair = (*numbers)[(block * blocks_->stride + number) / 2];
            for (std::size_t i = 0; i < kLanes; ++i) *to++ = pair.value[2 * i + number % 2];
        }
    }
    return out;
}

std::optional<VisibilityProduct::Grid> VisibilityProduct::grid() const {
    const auto* numbers = std::get_if<std::vector<FixedPair>>(&blocks_->numbers);
    const auto* grid = std::get_if<ShadowGrid>(&blocks_->product);
    if (grid == nullptr || numbers == nullptr) return std::nullopt;
    return Grid{.basis = blocks_->basis,
                .vertices = blocks_->vertices,
                .unit = blocks_->unit,
                .grid = *grid,
                .samples = {reinterpret_cast<const std::int16_t*>(numbers->data()),
                            blocks() * blocks_->stride * kLanes},
                .samples_of_vertex = blocks_->stride};
}

std::size_t VisibilityProduct::bytes() const noexcept {
    const auto bytes_of = []<class Element>(const std::vector<Element>* of) {
        return of == nullptr ? 0 : of->size() * sizeof(Element);
    };
    const std::size_t numbers = bytes_of(std::get_if<std::vector<FixedPair>>(&blocks_->numbers)) +
                                bytes_of(std::get_if<std::vector<Lanes>>(&blocks_->numbers));
    return numbers + (blocks_->vertices.size() + blocks_->shadow_of.size()) * sizeof(std::uint32_t);
}

}  // namespace nicol
