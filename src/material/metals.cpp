// SPDX-License-Identifier: MIT
// Optical constants of the named metals.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "error.hpp"
#include "material/conductor.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;

constexpr double kPhotonEnergyNm = 1239.84198;  // h c / e in eV nm

/// An index n - ik at a photon energy in eV.
struct Sample {
    double energy, n, k;
};
// Johnson and Christy, table I.
constexpr std::array<Sample, 15> kGold{{{1.51, .16, 5.083},
                                        {1.64, .14, 4.542},
                                        {1.76, .13, 4.103},
                                        {1.88, .14, 3.697},
                                        {2.01, .21, 3.272},
                                        {2.13, .29, 2.863},
                                        {2.26, .43, 2.455},
                                        {2.38, .62, 2.081},
                                        {2.50, 1.04, 1.833},
                                        {2.63, 1.31, 1.849},
                                        {2.75, 1.38, 1.914},
                                        {2.88, 1.45, 1.948},
                                        {3.00, 1.46, 1.958},
                                        {3.12, 1.47, 1.952},
                                        {3.25, 1.46, 1.933}}};
constexpr std::array<Sample, 15> kSilver{{{1.51, .04, 5.727},
                                          {1.64, .03, 5.242},
                                          {1.76, .04, 4.838},
                                          {1.88, .05, 4.483},
                                          {2.01, .06, 4.152},
                                          {2.13, .05, 3.858},
                                          {2.26, .06, 3.586},
                                          {2.38, .05, 3.324},
                                          {2.50, .05, 3.093},
                                          {2.63, .05, 2.869},
                                          {2.75, .04, 2.657},
                                          {2.88, .04, 2.462},
                                          {3.00, .05, 2.275},
                                          {3.12, .05, 2.070},
                                          {3.25, .05, 1.864}}};
constexpr std::array<Sample, 15> kCopper{{{1.51, .26, 5.180},
                                          {1.64, .24, 4.665},
                                          {1.76, .21, 4.205},
                                          {1.88, .22, 3.747},
                                          {2.01, .30, 3.205},
                                          {2.13, .70, 2.704},
                                          {2.26, 1.02, 2.577},
                                          {2.38, 1.18, 2.608},
                                          {2.50, 1.22, 2.564},
                                          {2.63, 1.25, 2.483},
                                          {2.75, 1.24, 2.397},
                                          {2.88, 1.25, 2.305},
                                          {3.00, 1.28, 2.207},
                                          {3.12, 1.32, 2.116},
                                          {3.25, 1.33, 2.045}}};
// Amorphous carbon, Palik's handbook by way of luxpop.com.
constexpr std::array<Sample, 10> kCarbon{{{1.4, 2.24, 0.80},
                                          {1.6, 2.33, 0.71},
                                          {1.8, 2.43, 0.70},
                                          {2.0, 2.43, 0.75},
                                          {2.2, 2.38, 0.82},
                                          {2.4, 2.30, 0.87},
                                          {2.6, 2.24, 0.88},
                                          {2.8, 2.17, 0.89},
                                          {3.0, 2.11, 0.90},
                                          {3.2, 2.06, 0.91}}};

Complex interpolate(std::span<const Sample> table, double energy) {
    const auto upper = std::ranges::upper_bound(table.begin(), table.end() - 1, energy, {}, &Sample::energy);
    const Sample& b = *std::max(upper, table.begin() + 1);
    const Sample& a = *(&b - 1);
    const double x = (energy - a.energy) / (b.energy - a.energy);
    return {std::lerp(a.n, b.n, x), -std::lerp(a.k, b.k, x)};
}

// Rakic et al., tables 1 and 2, Lorentz-Drude: strength, damping and resonance in eV.
Complex aluminium(double energy) {
    constexpr double plasma = 14.98;
    struct Oscillator {
        double strength, damping, resonance;
    };
    constexpr std::array<Oscillator, 5> oscillators{{{0.523, 0.047, 0},
                                                     {0.227, 0.333, 0.162},
                                                     {0.050, 0.312, 1.544},
                                                     {0.166, 1.351, 1.808},
                                                     {0.030, 3.382, 3.473}}};
    Complex permittivity = 1;
    for (const Oscillator& o : oscillators)
        permittivity += o.strength * plasma * plasma /
                        Complex(o.resonance * o.resonance - energy * energy, energy * o.damping);
    // With this sign of the damping the root in the right half plane is n - ik.
    return std::sqrt(permittivity);
}

}  // namespace

std::vector<Complex> metal_index(std::string_view metal, const std::vector<double>& wavelengths) {
    const auto named = [metal](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), metal) != names.end();
    };
    std::span<const Sample> table;
    if (named({"Au", "gold"})) table = kGold;
    if (named({"Ag", "silver"})) table = kSilver;
    if (named({"Cu", "copper"})) table = kCopper;
    if (metal == "a-C") table = kCarbon;
    if (table.empty() && !named({"Al", "aluminium", "aluminum"}))
        throw Error(ErrorCode::invalid_argument, "metal is \"" + std::string(metal.substr(0, 100)) +
                                                     "\"; it must be Au, Ag, Cu, Al or a-C");
    std::vector<Complex> out;
    for (const double wavelength : wavelengths) {
        if (!(wavelength >= 400 && wavelength <= 800))
            throw Error(ErrorCode::invalid_argument,
                        "a wavelength is " + std::to_string(wavelength) + " nm; it must lie in 400 to 800");
        const double energy = kPhotonEnergyNm / wavelength;
        out.push_back(table.empty() ? aluminium(energy) : interpolate(table, energy));
    }
    return out;
}

}  // namespace nicol
