// SPDX-License-Identifier: MIT
#include "render/order_selector.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "harmonics/energy.hpp"
#include "material/shared_terms.hpp"
#include "render/light_projection.hpp"
#include "render/vertex_weights.hpp"

namespace nicol {
namespace {

constexpr std::array<int, 4> kSplitOrders{9, 16, 32, 64};

// Lowest low order with high orders. Below it, visibility has too few orders to shadow high orders.
constexpr int kLowestSplit = 3;

// Usual stencils. A fit takes the best of them, or a better one.
constexpr std::array<SplitStencil, 3> kUsualStencils{{{0, 1, 0.05}, {1, 2, 0.1}, {2, 3, 0.2}}};

// Returns the relative time of a frame in which the light rotates: the cube of low + 1, plus the cost of
// looking up filtered light (nicol-bench frame) and of samples of local lights.
double cost(int low, bool split, bool local_lights) {
    // Samples of one light take a hundred times as long as an order of 9; much less would do here.
    constexpr double of_lights = 1000;
    return std::pow(low + 1.0, 3) + (split ? 60 : 0) + (local_lights ? of_lights : 0);
}

// Time of the rest of a frame by the same measure: of an image of 512 x 512 and 20,000 vertices.
constexpr double kRestOfFrame = 1000;

// Largest error of chosen orders out of a tolerance's reach, relative to the least one of all orders.
constexpr double kMostLoss = 1.5;

// Part of a frame's time that better orders may take beyond the cheapest orders.
constexpr double kNegligible = 0.06;
// Error, relative to the tolerance, below which no better orders are looked for.
constexpr double kSmallError = 0.1;

// Most memory of the integrals of materials' terms that are kept for new weights.
constexpr std::size_t kMostTermBytes = std::size_t{1} << 25;

// Energies by order of the parts of a light, s0, (s1, s2) and s3, for each channel. With s1 and s2 complex,
// half of their products with a response are real.
using Spectra = std::array<ResponsePower::Spectrum, ResponsePower::kParts>;
std::vector<Spectra> energies(const PshVector& light) {
    std::vector<Spectra> out;
    for (int c = 0; c < light.channels(); ++c) {
        Spectra& of = out.emplace_back();
        for (const Stokes& energy : energy_per_order(light, c)) {
            const double degrees = 2.0 * static_cast<double>(of[0].size()) + 1;
            of[0].push_back(energy[0] / degrees);
            of[1].push_back((energy[1] + energy[2]) / 2 / degrees);
            of[2].push_back(energy[3] / degrees);
        }
    }
    return out;
}

// Returns the energy of the reflection of light with the energies `light` by a response with the energies
// `power`. coupling: of VisibilityPower.
double reflected(const ResponsePower::Spectrum& light, const ResponsePower::Spectrum& power,
                 std::span<const double> coupling) {
    double sum = 0;
    for (std::size_t l = 0; l < light.size(); ++l)
        for (std::size_t from = 0; from < power.size(); ++from)
            sum += light[l] * coupling[l * power.size() + from] * power[from];
    return sum;
}

std::size_t parts_of(LightKind kind) {
    return kind == LightKind::unpolarized ? 1 : kind == LightKind::linear ? 2 : 3;
}

}  // namespace

OrderSelector::Orders OrderSelector::choose(const Scene& scene, const Projected& projected,
                                            const SurfaceState& surfaces, bool settled,
                                            const RenderOptions& options, std::uint64_t memory_limit,
                                            KeptProjection& projection) {
    const SurfaceVersions versions =
        settled || measured_ == SurfaceVersions{} ? surfaces.versions : measured_;
    measuring_.run(scene.distant_light(), projected, surfaces.materials, versions, [&] {
        measured_ = versions;
        choosing_.reset();
        shares_.clear();
        mean_square_ = values_ = 0;
        if (projected.light) measure(scene, projected, surfaces, projection);
    });
    limiting_.run(MemoryInputs(scene, options), memory_limit,
                  [&] { highest_low_ = highest_low(scene, options, memory_limit); });
    const bool split = options.high_orders == HighOrders::split;
    const double tolerance = options.tolerance * options.order_slack;
    const bool lights = scene.has_local_lights() || projected.light != scene.distant_light();
    choosing_.run(tolerance, split, lights, highest_low_,
                  [&] { chosen_ = cheapest(tolerance, split, lights); });
    chosen_.rms = values_ > 0 ? std::sqrt(mean_square_ / values_) : 0;
    return chosen_;
}

int OrderSelector::highest_low(const Scene& scene, RenderOptions options, std::uint64_t memory_limit) {
    const int least = options.order_low;
    for (int low = kHighestLow; low > least; --low) {
        options.order_low = low;
        options.order_high = kOrder;
        // Bounced light takes memory of its own, whatever the orders.
        RenderOptions direct = options;
        direct.max_depth = kDirectLightDepth;
        if (estimate_memory(scene, direct).transfer <= kMostBytes &&
            estimate_memory(scene, options).total() <= memory_limit)
            return low;
    }
    return least;
}

OrderSelector::Orders OrderSelector::cheapest(double tolerance, bool split, bool local_lights) {
    std::vector<Orders> candidates;
    for (int low = 0; low <= highest_low_; ++low) {
        candidates.push_back({.low = low, .high = low});
        for (const int high : kSplitOrders)
            if (split && low >= kLowestSplit && high > low) candidates.push_back({.low = low, .high = high});
    }
    const auto frame_time = [=](const Orders& orders) {
        return kRestOfFrame + cost(orders.low, orders.high > orders.low, local_lights);
    };
    std::ranges::stable_sort(candidates, {}, frame_time);
    // Fits take most of the time, so only candidates that could be within the tolerance are fitted.
    for (Orders& orders : candidates) {
        if (error(orders.low, orders.high, Fit::perfect) > tolerance) continue;
        orders.error = error(orders.low, orders.high, Fit::made);
        if (orders.error > tolerance) continue;
        if (orders.high > orders.low || orders.error <= kSmallError * tolerance) return orders;
        // Fits of high orders would take longer than they save.
        Orders best = orders;
        for (Orders better : candidates) {
            if (frame_time(better) > (1 + kNegligible) * frame_time(orders)) break;
            if (better.high > better.low) continue;
            better.error = error(better.low, better.high, Fit::made);
            if (better.error < best.error) best = better;
        }
        return best;
    }
    for (Orders& orders : candidates) orders.error = error(orders.low, orders.high, Fit::made);
    // The least error may take several times as long as one that is half as large again. Noise of samples
    // would fall so that its square times time stays the same, and here no more is paid for less error. The
    // rest of an image errs by about what the tolerance leaves to orders, so that much smaller errors gain
    // nothing.
    const double least = std::ranges::min_element(candidates, {}, &Orders::error)->error;
    std::erase_if(candidates, [=](const Orders& orders) { return orders.error > kMostLoss * least; });
    return *std::ranges::min_element(candidates, {}, [&](const Orders& orders) {
        return (tolerance * tolerance + orders.error * orders.error) * frame_time(orders);
    });
}

void OrderSelector::prepare(const Scene& scene, const Projected& projected, KeptProjection& projection) {
    project(scene, projected, projection);
    for (const Instance& instance : scene.instances())
        static_cast<void>(response_of(instance.material, projected, scene.channels()));
}

void OrderSelector::project(const Scene& scene, const Projected& projected, KeptProjection& projection) {
    projecting_.run(scene.distant_light(), projected.light, [&] {
        light_ = energies(projection.project(projected.light, kOrder));
        all_light_ = projected.light == scene.distant_light()
                         ? light_
                         : energies(scene.distant_light()->project(kOrder));
    });
    kind_ = light_kind(projected.light.get());
    responding_.run(kind_, projected.sampled, scene.channels(), [&] {
        responses_.clear();
        known_terms_.clear();
        fits_.clear();
    });
    if (couplings_.empty()) couplings_ = {OrderCoupling(kOrder, 0), OrderCoupling(kOrder, 2)};
}

OrderSelector::Response& OrderSelector::response_of(const MaterialPtr& material, const Projected& projected,
                                                    int channels) {
    const auto known = responses_.find(material);
    if (known != responses_.end()) return known->second;
    MaterialPtr in_orders = in_harmonics(material, projected.sampled);
    const ResponsePower whole(*material, kOrder, kind_, channels, known_terms_);
    const ResponsePower power =
        in_orders == material ? whole : ResponsePower(*in_orders, kOrder, kind_, channels, known_terms_);
    Response response{.whole = whole, .projected = std::move(in_orders), .power = power, .missed = {}};
    return responses_.emplace(material, std::move(response)).first->second;
}

void OrderSelector::measure(const Scene& scene, const Projected& projected, const SurfaceState& surfaces,
                            KeptProjection& projection) {
    project(scene, projected, projection);
    shadowing_.run(surfaces.materials, surfaces.versions, [&] { measure_shadows(surfaces); });
    constexpr std::size_t size = kOrder + 1;
    std::erase_if(responses_, [&](const auto& known) { return !shadowed_.contains(known.first); });
    for (const auto& [material, shadowed] : shadowed_) {
        const auto& [weight, fraction, couplings, sample] = shadowed;
        Response& response = response_of(material, projected, scene.channels());
        const auto& [whole, in_orders, power, missed] = response;
        Share& share = shares_.emplace_back(Share{.response = &response, .all = {}, .seen = {}, .left = {}});
        share.all.fill(Spectrum(size));
        share.seen.fill(Spectrum(size));
        for (int c = 0; c < scene.channels(); ++c) {
            const std::size_t channel = light_.size() == 1 ? 0 : static_cast<std::size_t>(c);
            auto of_light = light_[channel];
            for (std::size_t part = 0; part < parts_of(kind_); ++part) {
                for (double& energy : of_light[part]) energy *= weight;
                for (std::size_t output = 0; output < kOutputs; ++output)
                    add_part(of_light[part], power.of(c, output, part), couplings[part == 1 ? 1 : 0],
                             fraction, output, share);
                mean_square_ += weight * reflected(all_light_[channel][part], whole.of(c, 0, part),
                                                   couplings[part == 1 ? 1 : 0]);
            }
        }
        values_ += weight * scene.channels();
    }
    forget_terms();
}

void OrderSelector::measure_shadows(const SurfaceState& surfaces) {
    const WorldGeometry& geometry = surfaces.geometry;
    constexpr std::size_t size = kOrder + 1;
    std::optional<VisibilityHarmonics> harmonics;
    const VertexWeights vertices(geometry, surfaces.baked);
    std::map<std::vector<std::uint32_t>, Shadowed> former;
    if (shadowed_versions_ == surfaces.versions)
        for (auto& [material, shadowed] : shadowed_) {
            std::vector<std::uint32_t> sample = shadowed.sample;
            former.emplace(std::move(sample), std::move(shadowed));
        }
    shadowed_.clear();
    shadowed_versions_ = {};
    for (const auto& [material, group] : vertices.groups()) {
        Shadowed& shadowed = shadowed_[material];
        // Another material on the same vertices has the same shadows.
        const auto known = former.find(group.sample);
        if (known != former.end()) shadowed = known->second;
        shadowed.weight = group.weight;
        if (known != former.end()) continue;
        shadowed.sample = group.sample;
        if (surfaces.visibility != nullptr) {
            if (!harmonics) harmonics.emplace(*surfaces.directions, VisibilityPower::kOrder);
            const VisibilityPower visible(*harmonics, *surfaces.visibility, geometry.normals, group.sample);
            shadowed.fraction = visible.fraction();
            for (std::size_t k = 0; k < couplings_.size(); ++k)
                shadowed.couplings[k] = couplings_[k].of(visible);
        } else {
            for (std::vector<double>& coupling : shadowed.couplings) {
                coupling.assign(size * size, 0);
                for (std::size_t l = 0; l < size; ++l) coupling[l * size + l] = 1;
            }
        }
    }
    shadowed_versions_ = surfaces.versions;
}

void OrderSelector::forget_terms() {
    std::set<std::string> keys;
    for (const auto& [material, response] : responses_) {
        keys.insert(terms_key(*material));
        keys.insert(terms_key(*response.projected));
    }
    const auto is_other = [&](const auto& known) { return !keys.contains(known.first); };
    for (auto& [orders, fit] : fits_) std::erase_if(fit.known, is_other);
    std::erase_if(known_terms_, is_other);
    std::size_t bytes = 0;
    for (const auto& [key, angles] : known_terms_)
        for (const std::vector<double>& rows : angles) bytes += rows.size() * sizeof(double);
    if (bytes > kMostTermBytes) known_terms_.clear();
}

void OrderSelector::add_part(const Spectrum& light, const Spectrum& power, std::span<const double> coupling,
                             double fraction, std::size_t output, Share& share) {
    const std::size_t size = power.size();
    for (std::size_t l = 0; l < light.size(); ++l) {
        const std::span row = coupling.subspan(l * size, size);
        // Sum over the responses above each order, from the last order down.
        double above = 0;
        for (std::size_t from = size; from-- > 0;) {
            if (from >= l && from <= kHighestLow) share.left[output][from] += light[l] * above;
            above += row[from] * power[from];
        }
        share.all[output][l] += light[l] * above;
        share.seen[output][l] += light[l] * fraction * power[l];
    }
}

double OrderSelector::error(int low, int high, Fit fit) {
    if (!(mean_square_ > 0)) return 0;
    std::array<double, kOutputs> sum{};
    for (const Share& share : shares_) {
        for (std::size_t output = 0; output < kOutputs; ++output) {
            sum[output] += share.left[output][static_cast<std::size_t>(low)];
            for (int l = low + 1; l <= kOrder; ++l) {
                const auto k = static_cast<std::size_t>(l);
                const double all = share.all[output][k];
                const double seen = std::min(all, share.seen[output][k]);
                if (l > high)
                    sum[output] += all;
                else if (fit == Fit::perfect)
                    sum[output] += all - seen;
                else
                    sum[output] += all - seen + missed(share, low, high)[output] * seen;
            }
        }
    }
    // s1 and s2 each have half of their joint energy.
    return std::sqrt(std::max(sum[0], sum[1] / 2) / mean_square_);
}

// Returns the missed fractions for natural light, the light of SplitBasis::prior().
const std::array<double, OrderSelector::kOutputs>& OrderSelector::missed(const Share& share, int low,
                                                                         int high) {
    const auto [found, fresh] = share.response->missed.try_emplace({low, high});
    if (!fresh) return found->second;
    constexpr std::size_t angles = 4;
    const ResponsePower& power = share.response->power;
    const Material& material = *share.response->projected;
    SharedFit& shared = fits_.try_emplace({low, high}, low, high).first->second;
    const std::string key = terms_key(material);
    KnownMoments own;
    const std::size_t columns = kind_ == LightKind::unpolarized ? 1 : 4;
    const SplitFit fit(material, shared.basis, power.channels(), key.empty() ? own : shared.known[key],
                       columns);
    std::array<double, kOutputs> total{};
    for (int c = 0; c < power.channels(); ++c) {
        for (std::size_t output = 0; output < kOutputs; ++output)
            for (std::size_t part = 0; part < parts_of(kind_); ++part)
                for (int l = low + 1; l <= high; ++l)
                    total[output] +=
                        SplitBasis::prior(l) * power.of(c, output, part)[static_cast<std::size_t>(l)];
    }
    found->second.fill(1);
    std::array<std::array<double, kOutputs>, kUsualStencils.size()> all_caught{};
    std::array<std::vector<std::vector<SplitFactors>>, angles> at_angles;
    tbb::parallel_for(std::size_t{0}, angles, [&](std::size_t k) {
        const double cosine = std::sqrt((static_cast<double>(k) + 0.5) / angles);
        at_angles[k] = fit.at(std::acos(cosine), kUsualStencils);
    });
    for (const auto& stencils : at_angles) {
        for (std::size_t s = 0; s < stencils.size(); ++s) {
            for (const SplitFactors& factors : stencils[s]) {
                for (std::size_t part = 0; part < parts_of(kind_); ++part) {
                    all_caught[s][0] += factors.energy[0][part] / angles;
                    all_caught[s][1] += (factors.energy[1][part] + factors.energy[2][part]) / angles;
                }
            }
        }
    }
    for (const auto& caught : all_caught) {
        for (std::size_t output = 0; output < kOutputs; ++output) {
            const double rest = total[output] > 0 ? 1 - caught[output] / total[output] : 0;
            found->second[output] = std::clamp(rest, 0.0, found->second[output]);
        }
    }
    return found->second;
}

}  // namespace nicol
