// SPDX-License-Identifier: MIT
// Bounced light as a linear map of the distant light, and that of local lights.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "methods/bounce_series.hpp"
#include "methods/transfer_input.hpp"
#include "stage/workers.hpp"

namespace nicol {

/// Highest order of bounced light at vertices under distant light, whose map has this order.
inline constexpr int kBounceOrder = 3;
/// Highest order of bounced light at vertices under local lights alone. There is no map, so rough metal can
/// be shown what it reflects more sharply.
inline constexpr int kLocalBounceOrder = 5;
/// Returns the highest order of bounced light at vertices. distant: whether there is distant light.
[[nodiscard]] constexpr int highest_bounce_order(bool distant) {
    return distant ? kBounceOrder : kLocalBounceOrder;
}
/// Returns the order of vertices where light bounces, which bounces may raise. order: of the options; chosen:
/// whether it may be chosen, as it always may under local lights alone, of which vertices keep nothing else.
[[nodiscard]] constexpr int order_with_bounces(int order, bool distant, bool chosen) {
    return distant && !chosen ? order : std::max(order, highest_bounce_order(distant));
}
/// Highest order of the distant light that bounces. What surfaces reflect to each other is so smooth that
/// higher orders hardly matter. The 16 columns of unpolarized light fill Lanes.
inline constexpr int kBouncingOrder = 3;

/// Channels with equal reflectance everywhere, which share a map.
using ChannelGroups = std::vector<std::vector<std::size_t>>;

/// Input of the bounced light's series.
struct BounceInput {
    const TransferInput& scene;
    const LinkedSurfaces& surfaces;
    const BounceTables& tables;
    const LightLayout& layout;  ///< layout of the bounced light and the tables
};

/// Bounced light of local lights, by channel group, in the columns of the group's channels.
using LitSeries = std::vector<BounceSeries>;

/// Returns the coverage of directions by surfaces at receivers, [receiver][number]: the light that would
/// arrive if each surface emitted 1.
[[nodiscard]] std::vector<float> coverage_at_receivers(const BounceInput& input, RenderRun& run);

/// Linear map from the distant light to the bounced light at receivers, and its parts that local lights use.
class BounceColumns {
public:
    BounceColumns() = default;
    /// light: components of the distant light; none: it is dark.
    BounceColumns(const BounceInput& input, std::optional<LightKind> light, RenderRun& run);

    [[nodiscard]] const ChannelGroups& groups() const noexcept { return groups_; }
    /// Returns the numbers of the distant light that the map takes, [channel][number].
    [[nodiscard]] std::vector<float> numbers_of(const PshVector& light, int channels) const;
    /// Adds the bounced light of a receiver to out, [channel][number]. light: see numbers_of().
    void add(std::size_t receiver, std::span<const float> light, std::span<float> out) const;
    /// Adds the transpose of add(): from the gradient of a receiver's bounced light, [channel][number], to
    /// that of the distant light, [channel][number].
    void add_gradient(std::size_t receiver, std::span<const float> bounced, std::span<double> light) const;
    /// Returns the layout of the numbers of the distant light; none: it is dark.
    [[nodiscard]] const std::optional<LightLayout>& light() const noexcept { return light_; }
    /// Returns the mean over directions of the direct light at a receiver. light: numbers of one channel.
    [[nodiscard]] double direct(std::size_t receiver, const float* light) const;
    /// Returns the sum over receivers and channels of the estimated squared error, see BounceSeries::left.
    [[nodiscard]] double left(std::span<const float> light) const;
    /// Computes the bounced light of local lights.
    [[nodiscard]] LitSeries sum(const BounceInput& input, const ArrivingLamps& lit, RenderRun& run) const;

    [[nodiscard]] int rounds() const noexcept { return rounds_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    /// Returns how many numbers the map takes.
    [[nodiscard]] std::size_t lights() const { return light_ ? light_->size() : 0; }

    std::optional<LightLayout> light_;  // none: the distant light is dark
    std::size_t numbers_ = 0;           // of the bounced light
    ChannelGroups groups_;
    std::vector<std::vector<float>> maps_;   // [group], [receiver][number of the light][number]
    std::vector<std::vector<double>> left_;  // [group][number of the light]
    std::vector<float> direct_;              // [receiver][number of the light]: mean over directions
    int rounds_ = 0;
};

}  // namespace nicol
