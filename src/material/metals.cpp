// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "error.hpp"
#include "material/conductor.hpp"
#include "material/metal_constants.hpp"
#include "material/spectrum_weights.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;

std::span<const MetalSample> named(std::string_view metal) {
    const std::span<const NamedMetal> metals = named_metals();
    const auto found = std::ranges::find(metals, metal, &NamedMetal::name);
    if (found == metals.end())
        throw Error(ErrorCode::invalid_argument, "metal is \"" + std::string(metal.substr(0, 100)) +
                                                     "\"; it must be one of " + metal_names());
    return found->samples;
}

// Returns the samples with a step to 0 at both ends, narrower than any sampling resolves.
std::vector<MetalSample> ending_in_zeros(std::span<const MetalSample> samples) {
    constexpr double step = 1e-6;
    std::vector<MetalSample> out{{samples.front().wavelength - step, 0, 0}};
    out.insert(out.end(), samples.begin(), samples.end());
    out.push_back({samples.back().wavelength + step, 0, 0});
    return out;
}

std::vector<double> wavelengths_of(std::span<const MetalSample> samples) {
    std::vector<double> out;
    for (const MetalSample& sample : samples) out.push_back(sample.wavelength);
    return out;
}

// Returns the index n - ik in each channel.
std::vector<Complex> weighted(std::span<const MetalSample> samples, const ChannelWeights& weights) {
    std::vector<Complex> out;
    for (const std::vector<double>& channel : weights) {
        double n = 0, k = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            n += channel[i] * samples[i].n;
            k += channel[i] * samples[i].k;
        }
        // Metals have neither an index of 0 nor the negative values of colours outside the gamut.
        constexpr double least = 0.001;
        out.emplace_back(std::max(n, least), -std::max(k, 0.0));
    }
    return out;
}

}  // namespace

std::vector<Complex> metal_index(std::string_view metal) {
    const std::vector<MetalSample> samples = ending_in_zeros(named(metal));
    return weighted(samples, rgb_emission_weights(wavelengths_of(samples)));
}

std::vector<Complex> metal_index(std::string_view metal, const std::vector<double>& wavelengths) {
    const std::span<const MetalSample> samples = named(metal);
    for (const double wavelength : wavelengths)
        if (!(wavelength >= 380 && wavelength <= 800))
            throw Error(ErrorCode::invalid_argument,
                        "a wavelength is " + std::to_string(wavelength) + " nm; it must lie in 380 to 800");
    return weighted(samples, linear_weights(wavelengths_of(samples), wavelengths));
}

}  // namespace nicol
