// SPDX-License-Identifier: MIT
// Files in the layout ISOBI2. Entries are sorted by max(l_in, l_out). The degrees m of a pair of orders run
// over -b..b, b = min(l_in, l_out), with (m, m) next to (m, -m).
#include "material/psh_matrix_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "error.hpp"
#include "files/npz.hpp"
#include "harmonics/isotropic_lanes.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;
using Block = IsotropicMatrix::Block;
constexpr std::size_t kMaxChannels = 16;

std::size_t entry_count(std::size_t levels) {
    return levels * (4 * levels * levels + 2 - 3 * levels) / 3;
}

std::size_t entry_index(int l_in, int l_out, int m_in, int m_out) {
    const auto a = static_cast<std::size_t>(std::max(l_in, l_out));
    const auto b = std::min(l_in, l_out);
    const int within = 2 * b * (2 * b - 1) + 2 * (b + m_in) +
                       (m_in > m_out   ? -1
                        : m_in < m_out ? 1
                                       : 0) +
                       (l_in > l_out ? 4 * b + 1 : 0);
    return entry_count(a) + static_cast<std::size_t>(within);
}

/// Positions of the 4 x 4 entries of one (m, l_out, l_in), for input and output degree +-m.
struct DegreePair {
    int m, l_out, l_in;

    [[nodiscard]] std::size_t entry(int sign_out, int sign_in) const {
        return 16 * entry_index(l_in, l_out, sign_in * m, sign_out * m);
    }
    // Returns the level of degrees -1, 0, 1 that stands for degrees -m and m, so that lanes can be used.
    [[nodiscard]] int level() const { return m > 0 ? 1 : 0; }
};

std::size_t coefficient(int level, int sign) {
    return 4 * psh_index(level, sign * level);
}

/// Applies the map T of real coefficients to lanes.
IsotropicLanes apply(std::span<const double> channel, const DegreePair& pair, const IsotropicLanes& lanes) {
    std::array<double, 16> in{};
    std::array<double, 16> out{};
    store_lanes(lanes, in, pair.level(), pair.level());
    for (const int sign_out : {-1, 1}) {
        for (const int sign_in : {-1, 1}) {
            const std::span<const double> e = channel.subspan(pair.entry(sign_out, sign_in), 16);
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t q = 0; q < 4; ++q)
                    out[coefficient(pair.level(), sign_out) + p] +=
                        e[4 * p + q] * in[coefficient(pair.level(), sign_in) + q];
        }
    }
    return load_lanes(out, pair.level(), pair.level());
}

Block read_block(std::span<const double> channel, const DegreePair& pair) {
    Block out{};
    if (pair.m == 0) {
        // Scalars are real and the fourth lane is the conjugate of the third.
        const std::span<const double> e = channel.subspan(pair.entry(1, 1), 16);
        constexpr std::array<std::size_t, 2> scalar{0, 3};
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) out[4 * a + b] = e[4 * scalar[a] + scalar[b]];
            out[4 * a + 2] = 0.5 * Complex(e[4 * scalar[a] + 1], -e[4 * scalar[a] + 2]);
            out[4 * a + 3] = std::conj(out[4 * a + 2]);
            out[8 + a] = Complex(e[4 + scalar[a]], e[8 + scalar[a]]);
            out[12 + a] = std::conj(out[8 + a]);
        }
        out[10] = 0.5 * Complex(e[5] + e[10], e[9] - e[6]);
        out[11] = 0.5 * Complex(e[5] - e[10], e[9] + e[6]);
        out[14] = std::conj(out[11]);
        out[15] = std::conj(out[10]);
        return out;
    }
    // A map of complex numbers z that commutes with rotations is A z; a part with conj z is not isotropic.
    for (std::size_t b = 0; b < 4; ++b) {
        IsotropicLanes unit{};
        unit[b] = 1;
        const IsotropicLanes real = apply(channel, pair, unit);
        unit[b] = {0, 1};
        const IsotropicLanes imaginary = apply(channel, pair, unit);
        for (std::size_t a = 0; a < 4; ++a) out[4 * a + b] = 0.5 * (real[a] - Complex(0, 1) * imaginary[a]);
    }
    return out;
}

void write_block(std::span<double> channel, const DegreePair& pair, const Block& block) {
    for (const int sign_in : {-1, 1}) {
        for (std::size_t q = 0; q < 4; ++q) {
            std::array<double, 16> in{};
            std::array<double, 16> out{};
            in[coefficient(pair.level(), sign_in) + q] = 1;
            const IsotropicLanes from = load_lanes(in, pair.level(), pair.level());
            IsotropicLanes to{};
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = 0; b < 4; ++b) multiply_add(to[a], block[4 * a + b], from[b]);
            store_lanes(to, out, pair.level(), pair.level());
            for (const int sign_out : {-1, 1})
                for (std::size_t p = 0; p < 4; ++p)
                    channel[pair.entry(sign_out, sign_in) + 4 * p + q] =
                        out[coefficient(pair.level(), sign_out) + p];
        }
    }
}

template <class Visit>
void for_each_pair(int order, const Visit& visit) {
    for (int m = 0; m <= order; ++m)
        for (int l = m; l <= order; ++l)
            for (int k = m; k <= order; ++k) visit(DegreePair{m, l, k});
}

void require_text(const std::filesystem::path& path, const std::vector<std::string>& members,
                  const std::string& name, const std::string& wanted, const LoadBudget& budget) {
    if (std::ranges::find(members, name) == members.end()) return;
    const std::string text = read_npz_text(path, name, budget);
    if (text == wanted) return;
    throw Error(ErrorCode::invalid_file,
                path.string() + ": member " + name + ".npy says \"" + text + "\"; it must be " + wanted);
}

}  // namespace

std::vector<IsotropicMatrix> read_psh_matrix(const std::filesystem::path& path, const LoadBudget& budget) {
    const std::vector<std::string> members = npz_members(path, budget);
    require_text(path, members, "cod_type", "POLAR4", budget);
    require_text(path, members, "sh_type", "REAL", budget);
    const NpyArray coeff = read_npz_member(path, "coeff", kMaxNpyValues, budget);
    const std::string name = path.string() + ": member coeff.npy";
    if (coeff.shape.size() != 4 || coeff.shape[2] != 4 || coeff.shape[3] != 4)
        throw Error(ErrorCode::invalid_file, name + " must have the shape [channel][index][4][4]");
    if (coeff.shape[0] < 1 || coeff.shape[0] > kMaxChannels)
        throw Error(ErrorCode::invalid_file,
                    name + " has " + std::to_string(coeff.shape[0]) + " channels; it must have 1 to 16");
    std::size_t levels = 1;
    while (entry_count(levels) < coeff.shape[1]) ++levels;
    if (entry_count(levels) != coeff.shape[1])
        throw Error(ErrorCode::invalid_file, name + " has " + std::to_string(coeff.shape[1]) +
                                                 " entries a channel, which no ISOBI2 has (for L levels "
                                                 "L (4 L^2 - 3 L + 2) / 3)");
    if (!std::ranges::all_of(coeff.values, [](double value) { return std::isfinite(value); }))
        throw Error(ErrorCode::invalid_file, name + " has a value that is not finite");

    budget.take_memory(coeff.values.size() * sizeof(double));
    std::vector<IsotropicMatrix> out;
    const std::size_t channel_size = 16 * coeff.shape[1];
    for (std::size_t c = 0; c < coeff.shape[0]; ++c) {
        const auto channel = std::span(coeff.values).subspan(c * channel_size, channel_size);
        IsotropicMatrix& matrix =
            out.emplace_back(static_cast<int>(levels) - 1, static_cast<int>(levels) - 1);
        for_each_pair(matrix.order_in(), [&](const DegreePair& pair) {
            budget.step(1024);
            matrix.block(pair.m, pair.l_out, pair.l_in) = read_block(channel, pair);
        });
    }
    return out;
}

void write_psh_matrix(const std::filesystem::path& path, std::span<const IsotropicMatrix> channels) {
    const auto refuse = [](const std::string& what) {
        throw Error(ErrorCode::invalid_argument, "write_psh_matrix: " + what);
    };
    if (channels.empty() || channels.size() > kMaxChannels) refuse("there must be 1 to 16 channels");
    const int order = channels.front().order_in();
    for (const IsotropicMatrix& matrix : channels)
        if (matrix.order_in() != order || matrix.order_out() != order)
            refuse("all channels must have one order, the same on both sides");
    if (order < 0 || order > CoefficientMatrix::kMaxDenseOrder)
        refuse("the order is " + std::to_string(order) + "; it must lie in 0 to " +
               std::to_string(CoefficientMatrix::kMaxDenseOrder));
    const std::size_t entries = entry_count(static_cast<std::size_t>(order) + 1);
    NpyArray coeff{{channels.size(), entries, 4, 4}, std::vector<double>(channels.size() * entries * 16)};
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const auto channel = std::span(coeff.values).subspan(c * entries * 16, entries * 16);
        for_each_pair(order, [&](const DegreePair& pair) {
            write_block(channel, pair, channels[c].block(pair.m, pair.l_out, pair.l_in));
        });
    }
    const std::array<NpzMember, 4> members{{{"dom_type", std::string("ISOBI2")},
                                            {"cod_type", std::string("POLAR4")},
                                            {"sh_type", std::string("REAL")},
                                            {"coeff", std::move(coeff)}}};
    write_npz(path, members);
}

}  // namespace nicol
