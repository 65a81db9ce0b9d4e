// SPDX-License-Identifier: MIT
#include "specular/mixture_rows.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <vector>

using nicol::kLanes;
using nicol::Lanes;
using nicol::LayerWeights;
using nicol::MixtureRow;
using nicol::MixtureRows;

namespace {

struct Case {
    std::size_t channels;
    bool equal;   // whether weights are equal for every channel
    bool shared;  // whether rows are equal for every channel
    std::size_t first, count;
};

constexpr std::size_t kSize = 40;  // numbers per row
constexpr std::size_t kEntries = 5;

// One layer whose table has kEntries entries of `channels` rows.
struct Layer {
    std::size_t channels, size;
    std::vector<float> table;
    LayerWeights weights;
    std::array<std::size_t, kLanes> entries;

    Layer(std::size_t channels_, std::size_t size_, bool equal, std::mt19937& random)
        : channels(channels_), size(size_), weights{}, entries{} {
        std::uniform_real_distribution<float> number(-1, 1);
        table.resize(kEntries * channels * kSize);
        for (float& x : table) x = number(random);
        weights.equal = equal;
        for (std::size_t i = 0; i < kLanes; ++i) {
            entries[i] = random() % (kEntries - 1);
            if (random() % 3 == 0) continue;
            weights.points |= std::uint32_t{1} << i;
            for (Lanes& value : weights.value) value[i] = number(random);
        }
    }
    [[nodiscard]] MixtureRow row() const {
        MixtureRow out{.rows = {},
                       .step = channels * kSize,
                       .channel_step = channels == 1 ? 0 : kSize,
                       .size = size,
                       .weights = &weights};
        for (std::size_t i = 0; i < kLanes; ++i) out.rows[i] = &table[entries[i] * channels * kSize];
        return out;
    }
    [[nodiscard]] double value(std::size_t i, std::size_t channel, std::size_t j, double fraction) const {
        if (j >= size) return 0;
        const float* const at = &table[(entries[i] * channels + (channels == 1 ? 0 : channel)) * kSize + j];
        const auto low = static_cast<double>(at[0]);
        const auto high = static_cast<double>(at[channels * kSize]);
        return static_cast<double>(weights.of(channel)[i]) * (low + fraction * (high - low));
    }
};

}  // namespace

TEST_CASE("Sums of layers' rows are those of their definition") {
    std::mt19937 random(7);
    for (const Case& of :
         {Case{3, true, true, 0, 40}, Case{3, false, true, 0, 40}, Case{3, false, true, 0, 33},
          Case{3, true, false, 0, 40}, Case{3, false, true, 20, 20}, Case{1, true, true, 0, 16},
          Case{2, false, true, 0, 40}, Case{5, false, true, 0, 40}, Case{3, false, true, 0, 4},
          Case{3, true, false, 3, 7}}) {
        CAPTURE(of.channels);
        CAPTURE(of.equal);
        CAPTURE(of.shared);
        CAPTURE(of.count);
        // Some layers have shorter rows. The first two layers have equal values in all channels.
        std::vector<Layer> layers;
        layers.reserve(4);
        for (const std::size_t size : {kSize, std::size_t{20}, kSize, std::size_t{40}}) {
            const bool as_first = layers.size() < 2;
            layers.emplace_back(as_first || of.shared ? 1 : of.channels, size, as_first || of.equal, random);
        }
        // Numbers beyond a layer's size are 0 in tables.
        for (Layer& layer : layers)
            for (std::size_t k = 0; k < layer.table.size(); ++k)
                if (k % kSize >= layer.size) layer.table[k] = 0;
        Lanes fraction;
        for (float& x : fraction.value) x = std::uniform_real_distribution<float>(0, 1)(random);
        MixtureRows rows;
        rows.begin(kSize, of.channels);
        CHECK(rows.empty());
        for (const Layer& layer : layers) rows.add(layer.row());
        CHECK(!rows.empty());
        CHECK(rows.alike() == (of.equal && of.shared));
        rows.sum(fraction, of.first, of.count);
        for (std::size_t c = 0; c < of.channels; ++c) {
            for (std::size_t j = of.first; j < of.first + of.count; ++j) {
                for (std::size_t i = 0; i < kLanes; ++i) {
                    double expected = 0;
                    for (const Layer& layer : layers)
                        expected += layer.value(i, c, j, static_cast<double>(fraction[i]));
                    REQUIRE(static_cast<double>(rows.of(c)[j][i]) == doctest::Approx(expected).epsilon(1e-5));
                }
            }
        }
    }
}
