// SPDX-License-Identifier: MIT
#include "transfer/shadow_product.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "nicol/error.hpp"
#include "nicol/psh.hpp"
#include "transfer/lane_transpose.hpp"
#include "transfer/lane_vector.hpp"
#include "transfer/mirror_basis.hpp"
#include "transfer/shadow_grid.hpp"
#include "transfer/shadow_matrices.hpp"

namespace nicol {
namespace {

struct alignas(32) FixedLanes {
    std::array<std::int16_t, kLanes> value;
};

using Numbers = std::variant<std::vector<FixedLanes>, std::vector<Lanes>>;

FixedLanes fixed(const Lanes& in) {
    FixedLanes out{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        out.value[i] =
            static_cast<std::int16_t>(std::lround(std::clamp(in[i] * kFixedOne, -32767.0F, 32767.0F)));
    }
    return out;
}

[[noreturn]] void refuse(const std::string& message) {
    throw Error(ErrorCode::invalid_argument, message);
}

// Up to this sum of orders matrices serve. Beyond they are the faster still, 1.4 times at 8 + 8, but take 28
// times the memory there.
constexpr int most_for_matrix = 12;

ShadowProduct::Form choose(ShadowProduct::Form form, HorizonExtension extension, int visibility_order) {
    if (form == ShadowProduct::Form::best) {
        return extension == HorizonExtension::mirrored && visibility_order <= most_for_matrix
                   ? ShadowProduct::Form::matrix
                   : ShadowProduct::Form::grid;
    }
    if (form == ShadowProduct::Form::matrix && extension == HorizonExtension::dark) {
        throw Error(ErrorCode::unsupported,
                    "shadow matrices are made of mirrored visibility alone; dark visibility needs the grid");
    }
    return form;
}

}  // namespace

struct ShadowProduct::Blocks {
    Blocks(const LightLayout& layout_in, const LightLayout& layout_out, Form form_)
        : in(layout_in),
          out(layout_out),
          form(form_),
          product(form == Form::matrix ? Product(std::in_place_type<ShadowMatrices>, layout_in.order(), in,
                                                 layout_out.order(), out)
                                       : Product(std::in_place_type<ShadowGrid>, layout_in.order(), in,
                                                 layout_out.order(), out)) {}

    using Product = std::variant<ShadowMatrices, ShadowGrid>;

    MirrorBasis in;
    MirrorBasis out;
    Form form;
    Product product;
    bool dark = false;
    std::vector<std::uint32_t> vertices;
    std::size_t stride = 0;  // lanes of one block
    Numbers numbers;
    std::vector<std::size_t> position;  // of each packed number of `in` in a packed light of `out`

    void make(std::size_t block, const Visibility& visibility, const VisibilityHarmonics& harmonics,
              std::span<const glm::vec3> normals);
    template <class Number>
    void multiply(const Number* from, std::span<const Lanes* const> lights, std::span<Lanes* const> products,
                  std::size_t product_size) const;
};

// The last block repeats its last vertex.
void ShadowProduct::Blocks::make(std::size_t block, const Visibility& visibility,
                                 const VisibilityHarmonics& harmonics, std::span<const glm::vec3> normals) {
    const std::size_t count = psh_count(harmonics.order());
    std::vector<float> one(count);
    std::vector<Lanes> coefficients(count);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t vertex = vertices[std::min(block * kLanes + i, vertices.size() - 1)];
        harmonics.project(visibility, vertex, normals[vertex], one);
        for (std::size_t k = 0; k < count; ++k) coefficients[k][i] = one[k];
    }
    std::vector<Lanes> made(stride);
    if (const auto* matrices = std::get_if<ShadowMatrices>(&product)) {
        matrices->make(coefficients.data(), made.data());
    } else {
        std::get<ShadowGrid>(product).sample(coefficients.data(), made.data(),
                                             dark ? made.data() + stride / 2 : nullptr);
    }
    if (auto* fixed_numbers = std::get_if<std::vector<FixedLanes>>(&numbers)) {
        std::ranges::transform(made, fixed_numbers->begin() + static_cast<std::ptrdiff_t>(block * stride),
                               fixed);
    } else {
        std::ranges::copy(made, std::get<std::vector<Lanes>>(numbers).begin() +
                                    static_cast<std::ptrdiff_t>(block * stride));
    }
}

template <class Number>
void ShadowProduct::Blocks::multiply(const Number* from, std::span<const Lanes* const> lights,
                                     std::span<Lanes* const> products, std::size_t product_size) const {
    if (const auto* matrices = std::get_if<ShadowMatrices>(&product)) {
        matrices->multiply(from, lights, products);
        return;
    }
    const Number* odd = dark ? from + stride / 2 * kLanes : nullptr;
    for (std::size_t c = 0; c < lights.size(); ++c) {
        std::fill_n(products[c], product_size, Lanes{});
        std::get<ShadowGrid>(product).multiply(from, odd, lights[c], products[c]);
    }
}

ShadowProduct::ShadowProduct(const Visibility& visibility, const DirectionSet& directions,
                             std::span<const glm::vec3> normals, const LightLayout& in,
                             const LightLayout& out, HorizonExtension extension, Form form,
                             ShadowStorage storage) {
    if (in.kind() != out.kind() || in.order() > out.order()) {
        refuse("the product must have the kind of the light and at least its order");
    }
    if (normals.size() != visibility.vertices() || directions.size() != visibility.directions()) {
        refuse("visibility of " + std::to_string(visibility.vertices()) + " vertices and " +
               std::to_string(visibility.directions()) + " directions does not go with " +
               std::to_string(normals.size()) + " normals and " + std::to_string(directions.size()) +
               " directions");
    }
    const int visibility_order = in.order() + out.order();
    const VisibilityHarmonics harmonics(directions, visibility_order, extension);
    blocks_ = std::make_unique<Blocks>(in, out, choose(form, extension, visibility_order));
    Blocks& b = *blocks_;
    b.dark = extension == HorizonExtension::dark;
    for (std::size_t v = 0; v < visibility.vertices(); ++v) {
        // Half of a dark surrounding is dark even where all above the horizon is seen.
        if (b.dark || !visibility.unoccluded(v)) b.vertices.push_back(static_cast<std::uint32_t>(v));
    }
    if (const auto* matrices = std::get_if<ShadowMatrices>(&b.product)) {
        b.stride = matrices->size();
    } else {
        b.stride = std::get<ShadowGrid>(b.product).samples() * (b.dark ? 2 : 1);
    }
    if (storage == ShadowStorage::fixed16) {
        b.numbers = std::vector<FixedLanes>(blocks() * b.stride);
    } else {
        b.numbers = std::vector<Lanes>(blocks() * b.stride);
    }
    for (const LightLayout::Entry& e : in.entries()) {
        const auto same = [&](const LightLayout::Entry& x) {
            return x.part == e.part && x.l == e.l && x.m == e.m;
        };
        b.position.push_back(
            static_cast<std::size_t>(std::ranges::find_if(out.entries(), same) - out.entries().begin()));
    }
    tbb::parallel_for(std::size_t{0}, blocks(),
                      [&](std::size_t block) { b.make(block, visibility, harmonics, normals); });
}

ShadowProduct::~ShadowProduct() = default;
ShadowProduct::ShadowProduct(ShadowProduct&&) noexcept = default;
ShadowProduct& ShadowProduct::operator=(ShadowProduct&&) noexcept = default;

std::size_t ShadowProduct::blocks() const noexcept {
    return (blocks_->vertices.size() + kLanes - 1) / kLanes;
}

std::span<const std::uint32_t> ShadowProduct::vertices(std::size_t block) const {
    const std::span<const std::uint32_t> all(blocks_->vertices);
    return all.subspan(block * kLanes, std::min(kLanes, all.size() - block * kLanes));
}

void ShadowProduct::run(const VertexLight& in, VertexLight& out, std::size_t first, std::size_t last) const {
    const Blocks& b = *blocks_;
    const auto channels = static_cast<std::size_t>(in.channels());
    std::vector<Lanes> packed(std::max(b.in.packed_size(), b.out.packed_size()));
    std::vector<Lanes> light(b.in.size() * ShadowMatrices::kMostChannels);
    std::vector<Lanes> product(b.out.size() * ShadowMatrices::kMostChannels);
    std::array<const Lanes*, ShadowMatrices::kMostChannels> lights{};
    std::array<Lanes*, ShadowMatrices::kMostChannels> products{};
    for (std::size_t c = 0; c < lights.size(); ++c) {
        lights[c] = light.data() + c * b.in.size();
        products[c] = product.data() + c * b.out.size();
    }
    for (std::size_t block = first; block < last; ++block) {
        const std::span<const std::uint32_t> here = vertices(block);
        for (std::size_t begin = 0; begin < channels; begin += lights.size()) {
            const std::size_t count = std::min(lights.size(), channels - begin);
            for (std::size_t c = 0; c < count; ++c) {
                std::array<const float*, kLanes> from{};
                for (std::size_t i = 0; i < kLanes; ++i) {
                    from[i] = in.at(here[std::min(i, here.size() - 1)], static_cast<int>(begin + c)).data();
                }
                to_lanes(from, b.in.packed_size(), packed.data());
                b.in.split(packed.data(), light.data() + c * b.in.size());
            }
            const auto some_lights = std::span(lights).first(count);
            const auto some_products = std::span(products).first(count);
            if (const auto* numbers = std::get_if<std::vector<FixedLanes>>(&b.numbers)) {
                b.multiply(reinterpret_cast<const std::int16_t*>(numbers->data() + block * b.stride),
                           some_lights, some_products, b.out.size());
            } else {
                b.multiply(reinterpret_cast<const float*>(std::get<std::vector<Lanes>>(b.numbers).data() +
                                                          block * b.stride),
                           some_lights, some_products, b.out.size());
            }
            for (std::size_t c = 0; c < count; ++c) {
                b.out.join(product.data() + c * b.out.size(), packed.data());
                std::array<float*, kLanes> to{};
                for (std::size_t i = 0; i < here.size(); ++i) {
                    to[i] = out.at(here[i], static_cast<int>(begin + c)).data();
                }
                from_lanes(packed.data(), b.out.packed_size(), here.size(), to);
            }
        }
    }
}

void ShadowProduct::copy(const VertexLight& in, VertexLight& out, std::size_t first, std::size_t last) const {
    const std::vector<std::size_t>& position = blocks_->position;
    for (std::size_t v = first; v < last; ++v) {
        for (int c = 0; c < in.channels(); ++c) {
            const std::span<const float> from = in.at(v, c);
            const std::span<float> to = out.at(v, c);
            std::ranges::fill(to, 0.0F);
            for (std::size_t j = 0; j < position.size(); ++j) {
                to[position[j]] = from[j];
                to[out.row_size() + position[j]] = from[in.row_size() + j];
            }
        }
    }
}

ShadowProduct::Form ShadowProduct::form() const noexcept {
    return blocks_->form;
}

std::optional<ShadowProduct::Matrices> ShadowProduct::matrices() const {
    const auto* numbers = std::get_if<std::vector<FixedLanes>>(&blocks_->numbers);
    if (form() != Form::matrix || numbers == nullptr || blocks_->in.size() != blocks_->out.size()) {
        return std::nullopt;
    }
    static_assert(sizeof(FixedLanes) == kLanes * sizeof(std::int16_t));
    return Matrices{
        .basis = blocks_->in,
        .vertices = blocks_->vertices,
        .numbers = {reinterpret_cast<const std::int16_t*>(numbers->data()), numbers->size() * kLanes},
        .numbers_of_vertex = blocks_->stride};
}

std::size_t ShadowProduct::bytes() const noexcept {
    const std::size_t numbers = std::visit(
        [](const auto& vector) { return vector.size() * sizeof(vector.front()); }, blocks_->numbers);
    return numbers + blocks_->vertices.size() * sizeof(std::uint32_t);
}

}  // namespace nicol
