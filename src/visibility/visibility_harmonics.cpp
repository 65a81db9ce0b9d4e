// SPDX-License-Identifier: MIT
#include "visibility/visibility_harmonics.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "error.hpp"
#include "geometry/unit.hpp"
#include "harmonics/psh.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_parts.hpp"
#include "simd/lane_vector.hpp"
#include "simd/work_space.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

// Coefficients in the world's axes are sums over directions, and a direction's harmonics are the same numbers
// for all vertices: a row. Rows hold coefficients over complex harmonics as LaneRotation takes them, m >= 0
// at position l (l + 1) / 2 + m: first all real parts, then all imaginary parts. Sums of four directions'
// rows are looked up by their four bits (the method of four Russians). LaneRotation then turns the sums into
// the vertex's frame.
constexpr std::size_t kTogether = 4;  // directions whose sums are looked up together
constexpr std::size_t kSums = std::size_t{1} << kTogether;
constexpr std::size_t kParts = kLanes / kTogether;
// Numbers that are summed in registers at once. Rows are filled up to a multiple of this.
constexpr std::size_t kStep = kLanes;

static_assert(RayBundle::kRays == kLanes);

std::size_t positions(int order) {
    return static_cast<std::size_t>(order + 1) * static_cast<std::size_t>(order + 2) / 2;
}

std::size_t position(int l, int m) {
    return static_cast<std::size_t>(l * (l + 1) / 2 + m);
}

// Returns factors of harmonics Y_lm = (x + i y)^m q_lm(z) with q_lm = a z q_{l-1,m} - b q_{l-2,m}: a and b at
// 2 position(l, m), and q_mm for l = m.
std::vector<float> recurrence_factors(int order) {
    std::vector<float> out(2 * positions(order), 0.0F);
    double sectoral = 1 / std::sqrt(4 * std::numbers::pi);
    for (int m = 0; m <= order; ++m) {
        if (m > 0) sectoral *= -std::sqrt((2.0 * m + 1) / (2.0 * m));
        out[2 * position(m, m)] = static_cast<float>(sectoral);
        const auto r = [m](int l) {
            const double square = static_cast<double>(l) * l;
            return l <= m ? 0.0 : std::sqrt((square - m * m) / (4 * square - 1));
        };
        for (int l = m + 1; l <= order; ++l) {
            out[2 * position(l, m)] = static_cast<float>(1 / r(l));
            out[2 * position(l, m) + 1] = static_cast<float>(r(l - 1) / r(l));
        }
    }
    return out;
}

// Computes weight conj(Y_lm) of sixteen propagation directions: real parts at position(l, m), imaginary parts
// at positions(order) + position(l, m).
[[gnu::always_inline]] inline void evaluate_bundle(const RayBundle& bundle, const Lanes& weight,
                                                   const float* recurrence, int order, Lanes* out) {
    LaneVector x, y, z, c, s{};
    load(bundle.x.data(), x);
    load(bundle.y.data(), y);
    load(bundle.z.data(), z);
    load(&weight, c);
    Lanes* const imaginary = out + (order + 1) * (order + 2) / 2;
    for (int m = 0; m <= order; ++m) {
        LaneVector before{};
        LaneVector q = LaneVector{} + recurrence[2 * (m * (m + 1) / 2 + m)];
        for (int l = m; l <= order; ++l) {
            const int at = l * (l + 1) / 2 + m;
            store(out + at, q * c);
            store(imaginary + at, -q * s);
            if (l == order) break;
            const float* const next = recurrence + 2 * ((l + 1) * (l + 2) / 2 + m);
            const LaneVector up = -next[0] * z * q - next[1] * before;
            before = q;
            q = up;
        }
        const LaneVector turned = s * y - c * x;
        s = -(s * x + c * y);
        c = turned;
    }
}

// Sums of a bundle's rows: [part][bits of its directions][row], and of all its rows.
struct BundleSums {
    float* parts;
    float* all;
};

template <class Number>
[[gnu::always_inline]] inline void load_some(const float* from, Number& to) {
    __builtin_memcpy(&to, from, sizeof to);
}
template <class Number>
[[gnu::always_inline]] inline void store_some(const Number& number, float* to) {
    __builtin_memcpy(to, &number, sizeof number);
}

// Computes the sums of sixteen directions' rows of `size` numbers.
template <class Number>
[[gnu::always_inline]] inline void sum_rows(const float* rows, std::size_t size, const BundleSums& out) {
    for (std::size_t k = 0; k < size; k += kPart<Number>) {
        Number total{};
        for (std::size_t p = 0; p < kParts; ++p) {
            const float* const of_part = rows + kTogether * p * size + k;
            Number sums[kSums];
            sums[0] = Number{};
            for (std::size_t d = 0; d < kTogether; ++d) {
                Number row;
                load_some(of_part + d * size, row);
                for (std::size_t bits = 0; bits < std::size_t{1} << d; ++bits)
                    sums[(std::size_t{1} << d) + bits] = sums[bits] + row;
            }
            for (std::size_t bits = 1; bits < kSums; ++bits)
                store_some(sums[bits], out.parts + (kSums * p + bits) * size + k);
            total += sums[kSums - 1];
        }
        store_some(total, out.all + k);
    }
}

// Bits of sixteen directions, one for each vertex of a batch.
using BundleBits = std::array<std::uint16_t, VisibilityHarmonics::kBatch>;
using Factors = std::array<float, VisibilityHarmonics::kBatch>;

// Sums that a bundle adds to one vertex, and their factors.
struct Terms {
    std::size_t count = 0;
    std::array<const float*, 2 * kParts> rows;
    std::array<float, 2 * kParts> factors;

    void append(const float* row, float factor) {
        rows[count] = row;
        factors[count++] = factor;
    }
    void append(const BundleSums& bundle, std::size_t size, unsigned bits, float factor) {
        if (bits == 0xFFFF) return append(bundle.all, factor);
        for (std::size_t p = 0; p < kParts; ++p) {
            const unsigned part = bits >> (kTogether * p) & (kSums - 1);
            if (part != 0) append(bundle.parts + (kSums * p + part) * size, factor);
        }
    }
    // Appends both kinds of directions. If they are all of the bundle's, the kind in fewer parts is what
    // differs from the sum of all.
    void append(const BundleSums& bundle, std::size_t size, unsigned visible, float of_visible,
                unsigned hidden, float of_hidden) {
        if ((visible | hidden) != 0xFFFF) {
            append(bundle, size, visible, of_visible);
            append(bundle, size, hidden, of_hidden);
        } else if (parts_of(visible) < parts_of(hidden)) {
            append(bundle.all, of_hidden);
            append(bundle, size, visible, of_visible - of_hidden);
        } else {
            append(bundle.all, of_visible);
            append(bundle, size, hidden, of_hidden - of_visible);
        }
    }

private:
    [[nodiscard]] static int parts_of(unsigned bits) {
        int parts = 0;
        for (std::size_t p = 0; p < kParts; ++p) parts += (bits >> (kTogether * p) & (kSums - 1)) != 0;
        return parts;
    }
};

// Adds the terms of each vertex to its sums, [vertex][size].
template <class Number>
[[gnu::always_inline]] inline void add_terms(std::span<const Terms> of_vertices, std::size_t size,
                                             float* sums) {
    constexpr std::size_t count = kStep / kPart<Number>;
    for (const Terms& terms : of_vertices) {
        for (std::size_t k = 0; k < size && terms.count > 0; k += kStep) {
            Number sum[count];
            for (std::size_t i = 0; i < count; ++i) load_some(sums + k + i * kPart<Number>, sum[i]);
            for (std::size_t t = 0; t < terms.count; ++t) {
                for (std::size_t i = 0; i < count; ++i) {
                    Number row;
                    load_some(terms.rows[t] + k + i * kPart<Number>, row);
                    sum[i] += terms.factors[t] * row;
                }
            }
            for (std::size_t i = 0; i < count; ++i) store_some(sum[i], sums + k + i * kPart<Number>);
        }
        sums += size;
    }
}

// Directions of one vertex in each bundle, as bits, and sums of the weights of the directions above the
// horizon (all), and of the visible directions among them (part).
struct VertexBits {
    std::uint16_t* visible;  // step from bundle to bundle: kBatch
    std::uint16_t* hidden;
    float all;
    float part;
};

template <class Number>
[[gnu::always_inline]] inline void find_bits(std::span<const RayBundle> bundles, const Lanes* weights,
                                             const glm::vec3& normal, const std::uint64_t* seen,
                                             VertexBits& out) {
    constexpr std::size_t width = kPart<Number>;
    using Ints = decltype(Number{} > Number{});  // integers as wide
    Ints bit;
    for (std::size_t i = 0; i < width; ++i) bit[i] = 1 << i;
    Number all{}, part{};
    for (std::size_t b = 0; b < bundles.size(); ++b) {
        const std::uint16_t bits = bundle_bits(seen, b);
        unsigned above = 0;
        for (std::size_t first = 0; first < kLanes; first += width) {
            Number x, y, z, weight;
            load_some(bundles[b].x.data() + first, x);
            load_some(bundles[b].y.data() + first, y);
            load_some(bundles[b].z.data() + first, z);
            const Ints up = x * normal.x + y * normal.y + z * normal.z > 0.0F;
            // The bits of this part's lanes, whose sum has each once.
            const Ints found = up & bit;
            int sum = 0;
            for (std::size_t i = 0; i < width; ++i) sum += found[i];
            above |= static_cast<unsigned>(sum) << first;
            load_some(weights[b].value.data() + first, weight);
            const Number of_all = up ? weight : Number{};
            const Ints visible = ((Ints{} + (bits >> first)) & bit) != 0;
            all += of_all;
            part += visible ? of_all : Number{};
        }
        out.visible[b * VisibilityHarmonics::kBatch] = static_cast<std::uint16_t>(above & bits);
        out.hidden[b * VisibilityHarmonics::kBatch] = static_cast<std::uint16_t>(above & ~unsigned{bits});
    }
    out.all = out.part = 0;
    for (std::size_t i = 0; i < width; ++i) {
        out.all += all[i];
        out.part += part[i];
    }
}

// Computes coefficients over real harmonics, of even l + m, from v_lm of LaneRotation.
void to_real_harmonics(int order, const Lanes* real, const Lanes* imaginary, std::span<Lanes> out) {
    std::ranges::fill(out, Lanes{});
    // The factor 2 accounts for the mirror image below the horizon.
    constexpr float zonal = 2;
    constexpr float pair = 2 * std::numbers::sqrt2_v<float>;
    for (int l = 0; l <= order; ++l)
        for (int m = l % 2; m <= l; m += 2) {
            const Lanes& re = real[position(l, m)];
            const Lanes& im = imaginary[position(l, m)];
            // (-i)^m, whose imaginary part or real part is 0.
            const float sign = m % 4 < 2 ? 1.0F : -1.0F;
            const Lanes& cosine = m % 2 == 0 ? re : im;
            const Lanes& sine = m % 2 == 0 ? im : re;
            const float of_sine = m % 2 == 0 ? -sign : sign;
            for (std::size_t i = 0; i < kLanes; ++i) {
                out[psh_index(l, m)][i] = (m == 0 ? zonal : pair * sign) * cosine[i];
                if (m > 0) out[psh_index(l, -m)][i] = pair * of_sine * sine[i];
            }
        }
}

}  // namespace

VisibilityHarmonics::VisibilityHarmonics(const DirectionSet& directions, int order)
    : directions_(directions), order_(order), rotation_(std::clamp(order, 0, kHighestOrder)) {
    if (order < 0 || order > kHighestOrder) {
        throw Error(ErrorCode::invalid_argument, "visibility of order " + std::to_string(order) +
                                                     "; it must lie in 0 to " +
                                                     std::to_string(kHighestOrder));
    }
    // The last bundle repeats its last direction; the repetitions get the weight 0.
    weights_.resize(directions.bundles().size(), Lanes{});
    for (std::size_t i = 0; i < directions.size(); ++i) {
        weights_[i / kLanes][i % kLanes] = directions.weights()[i];
    }
    const std::vector<float> recurrence = recurrence_factors(order);
    const std::size_t numbers = 2 * positions(order);
    row_ = (numbers + kStep - 1) / kStep * kStep;
    rows_.resize(directions.bundles().size() * row_);
    tbb::parallel_for(std::size_t{0}, directions.bundles().size(), [&](std::size_t b) {
        std::vector<Lanes> values(numbers);
        dispatch<evaluate_bundle>(directions.bundles()[b], weights_[b], recurrence.data(), order,
                                  values.data());
        for (std::size_t i = 0; i < kLanes; ++i)
            for (std::size_t k = 0; k < numbers; ++k) {
                const std::size_t at = (b * kLanes + i) * row_ + k;
                rows_[at / kLanes][at % kLanes] = values[k][i];
            }
    });
}

void VisibilityHarmonics::project(const Visibility& visibility, std::span<const glm::vec3> normals,
                                  std::span<const std::uint32_t> vertices, std::span<Lanes> out) const {
    static_assert(kBatch % kLanes == 0);
    for (std::size_t first = 0; first < vertices.size(); first += kBatch) {
        const std::size_t count = std::min(kBatch, vertices.size() - first);
        project_batch(visibility, normals, vertices.subspan(first, count),
                      out.subspan(first / kLanes * psh_count(order_)));
    }
}

void VisibilityHarmonics::project_batch(const Visibility& visibility, std::span<const glm::vec3> normals,
                                        std::span<const std::uint32_t> vertices, std::span<Lanes> out) const {
    const std::span<const RayBundle> bundles = directions_.bundles();
    const std::span visible = work_space<struct VisibleBits, BundleBits>(bundles.size());
    const std::span hidden = work_space<struct HiddenBits, BundleBits>(bundles.size());
    // A visible direction counts 1 and a hidden one 0, less the mean over the directions above the horizon.
    // The mean is added exactly, so that the quadrature does not depend on the position of the horizon.
    Factors of_visible, of_hidden;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const glm::vec3 normal = unit(normals[vertices[v]]);
        VertexBits bits{.visible = &visible[0][v], .hidden = &hidden[0][v], .all = 0, .part = 0};
        dispatch<find_bits<FourLanes>, find_bits<EightLanes>, find_bits<AllLanes>>(
            bundles, static_cast<const Lanes*>(weights_.data()), normal, visibility.at(vertices[v]).data(),
            bits);
        const float fraction = bits.all > 0 ? bits.part / bits.all : 0.0F;
        of_visible[v] = 1 - fraction;
        of_hidden[v] = -fraction;
    }

    const std::span lanes =
        work_space<VisibilityHarmonics, Lanes>((kBatch + kSums * kParts + 1) * row_ / kLanes);
    float* const sums = lanes.front().value.data();
    float* const parts = sums + kBatch * row_;
    float* const all = parts + kSums * kParts * row_;
    std::fill_n(sums, vertices.size() * row_, 0.0F);
    std::array<Terms, kBatch> terms;
    for (std::size_t b = 0; b < bundles.size(); ++b) {
        const auto any = [&](const BundleBits& bits) {
            return std::any_of(bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(vertices.size()),
                               [](std::uint16_t one) { return one != 0; });
        };
        if (!any(visible[b]) && !any(hidden[b])) continue;
        const BundleSums bundle{parts, all};
        dispatch<sum_rows<FourLanes>, sum_rows<EightLanes>, sum_rows<AllLanes>>(
            static_cast<const float*>(rows_[b * row_].value.data()), row_, bundle);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            terms[v].count = 0;
            terms[v].append(bundle, row_, visible[b][v], of_visible[v], hidden[b][v], of_hidden[v]);
        }
        dispatch<add_terms<FourLanes>, add_terms<EightLanes>, add_terms<AllLanes>>(
            std::span<const Terms>(terms.data(), vertices.size()), row_, sums);
    }

    LaneRotation::Work& work = rotation_.work_of_thread();
    for (std::size_t first = 0; first < vertices.size(); first += kLanes) {
        const auto lane = [&](std::size_t i) { return std::min(first + i, vertices.size() - 1); };
        std::array<glm::vec3, kLanes> axes;
        for (std::size_t i = 0; i < kLanes; ++i) axes[i] = normals[vertices[lane(i)]];
        rotation_.set_normals(axes, work);
        Lanes* const real = work.fields();
        Lanes* const imaginary = real + work.imaginary();
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float* const sum = sums + lane(i) * row_;
            for (std::size_t p = 0; p < positions(order_); ++p) {
                real[p][i] = sum[p];
                imaginary[p][i] = sum[positions(order_) + p];
            }
        }
        rotation_.rotate(LaneRotation::Field::real, 1, work);
        const std::span block = out.subspan(first / kLanes * psh_count(order_), psh_count(order_));
        to_real_harmonics(order_, real, imaginary, block);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t v = lane(i);
            if (!visibility.unoccluded(vertices[v])) {
                block[0][i] += (1 - of_visible[v]) * kUnoccluded;
                continue;
            }
            for (Lanes& number : block) number[i] = 0;
            block[0][i] = kUnoccluded;
        }
    }
}

}  // namespace nicol
