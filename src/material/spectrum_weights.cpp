// SPDX-License-Identifier: MIT
#include "material/spectrum_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "error.hpp"
#include "image/color.hpp"

namespace nicol {
namespace {

// CIE 1931 colour matching functions of the 2 degree observer and the relative power of illuminant D65, from
// 380 nm in steps of 10 nm (CIE 15).
struct Tristimulus {
    double x, y, z, d65;
};
constexpr std::array<Tristimulus, 41> kObserver{{
    {.001368, .000039, .006450, 49.9755},  {.004243, .000120, .020050, 54.6482},
    {.014310, .000396, .067850, 82.7549},  {.043510, .001210, .207400, 91.4860},
    {.134380, .004000, .645600, 93.4318},  {.283900, .011600, 1.385600, 86.6823},
    {.348280, .023000, 1.747060, 104.865}, {.336200, .038000, 1.772110, 117.008},
    {.290800, .060000, 1.669200, 117.812}, {.195360, .090980, 1.287640, 114.861},
    {.095640, .139020, .812950, 115.923},  {.032010, .208020, .465180, 108.811},
    {.004900, .323000, .272000, 109.354},  {.009300, .503000, .158200, 107.802},
    {.063270, .710000, .078250, 104.790},  {.165500, .862000, .042160, 107.689},
    {.290400, .954000, .020300, 104.405},  {.433450, .994950, .008750, 104.046},
    {.594500, .995000, .003900, 100.000},  {.762100, .952000, .002100, 96.3342},
    {.916300, .870000, .001650, 95.7880},  {1.026300, .757000, .001100, 88.6856},
    {1.062200, .631000, .000800, 90.0062}, {1.002600, .503000, .000340, 89.5991},
    {.854450, .381000, .000190, 87.6987},  {.642400, .265000, .000050, 83.2886},
    {.447900, .175000, .000020, 83.6992},  {.283500, .107000, 0, 80.0268},
    {.164900, .061000, 0, 80.2146},        {.087400, .032000, 0, 82.2778},
    {.046770, .017000, 0, 78.2842},        {.022700, .008210, 0, 69.7213},
    {.011359, .004102, 0, 71.6091},        {.005790, .002091, 0, 74.3490},
    {.002899, .001047, 0, 61.6040},        {.001440, .000520, 0, 69.8856},
    {.000690, .000249, 0, 75.0870},        {.000332, .000120, 0, 63.5927},
    {.000166, .000060, 0, 46.4182},        {.000083, .000030, 0, 66.8054},
    {.000042, .000015, 0, 63.3828},
}};

void require_increasing(std::span<const double> wavelengths) {
    bool good = !wavelengths.empty() && std::isfinite(wavelengths.front());
    for (std::size_t i = 1; i < wavelengths.size(); ++i) good = good && wavelengths[i] > wavelengths[i - 1];
    if (!good || !std::isfinite(wavelengths.back()))
        throw Error(ErrorCode::invalid_argument,
                    "wavelengths must be at least one number of nm, each above the one before");
}

// Adds `amount` of a value at a wavelength to the weights of its neighbours.
void spread(std::span<const double> wavelengths, double wavelength, double amount,
            std::vector<double>& weights) {
    const auto upper = static_cast<std::size_t>(
        std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength) - wavelengths.begin());
    if (upper == 0 || upper == wavelengths.size()) {
        weights[upper == 0 ? 0 : upper - 1] += amount;
        return;
    }
    const double x = (wavelength - wavelengths[upper - 1]) / (wavelengths[upper] - wavelengths[upper - 1]);
    weights[upper - 1] += (1 - x) * amount;
    weights[upper] += x * amount;
}

// Returns the observer at a whole nanometre.
Tristimulus observer_at(int nm) {
    const auto i = static_cast<std::size_t>(nm - 380) / 10;
    const double x = (nm - 380) % 10 / 10.0;
    const Tristimulus& a = kObserver[i];
    const Tristimulus& b = kObserver[i + 1];
    return {std::lerp(a.x, b.x, x), std::lerp(a.y, b.y, x), std::lerp(a.z, b.z, x),
            std::lerp(a.d65, b.d65, x)};
}

double response(std::size_t channel, const Tristimulus& t) {
    return linear_rgb(t.x, t.y, t.z)[channel];
}

}  // namespace

ChannelWeights rgb_weights(std::span<const double> wavelengths) {
    require_increasing(wavelengths);
    ChannelWeights out(3, std::vector<double>(wavelengths.size()));
    for (std::size_t c = 0; c < 3; ++c) {
        double total = 0;
        for (int nm = 380; nm < 780; ++nm) {
            const Tristimulus t = observer_at(nm);
            const double amount = response(c, t) * t.d65;
            spread(wavelengths, nm, amount, out[c]);
            total += amount;
        }
        for (double& weight : out[c]) weight /= total;
    }
    return out;
}

ChannelWeights rgb_emission_weights(std::span<const double> wavelengths) {
    require_increasing(wavelengths);
    ChannelWeights out(3, std::vector<double>(wavelengths.size()));
    double luminance = 0;
    for (int nm = 380; nm < 780; ++nm) {
        const Tristimulus t = observer_at(nm);
        luminance += t.y;
        for (std::size_t c = 0; c < 3; ++c) spread(wavelengths, nm, response(c, t), out[c]);
    }
    for (auto& channel : out)
        for (double& weight : channel) weight /= luminance;
    return out;
}

ChannelWeights linear_weights(std::span<const double> wavelengths, std::span<const double> requested) {
    require_increasing(wavelengths);
    ChannelWeights out(requested.size(), std::vector<double>(wavelengths.size()));
    for (std::size_t c = 0; c < requested.size(); ++c) spread(wavelengths, requested[c], 1, out[c]);
    return out;
}

ChannelWeights nearest_weights(std::span<const double> wavelengths, std::span<const double> requested) {
    require_increasing(wavelengths);
    ChannelWeights out(requested.size(), std::vector<double>(wavelengths.size()));
    for (std::size_t c = 0; c < requested.size(); ++c) {
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < wavelengths.size(); ++k)
            if (std::abs(wavelengths[k] - requested[c]) < std::abs(wavelengths[nearest] - requested[c]))
                nearest = k;
        out[c][nearest] = 1;
    }
    return out;
}

}  // namespace nicol
