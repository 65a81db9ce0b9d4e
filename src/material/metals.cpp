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

// Johnson and Christy, table I, by photon energy in eV.
constexpr std::array<double, 15> kEnergies{1.51, 1.64, 1.76, 1.88, 2.01, 2.13, 2.26, 2.38,
                                           2.50, 2.63, 2.75, 2.88, 3.00, 3.12, 3.25};
struct Table {
    std::array<double, 15> n;
    std::array<double, 15> k;
};
constexpr Table kGold{{.16, .14, .13, .14, .21, .29, .43, .62, 1.04, 1.31, 1.38, 1.45, 1.46, 1.47, 1.46},
                      {5.083, 4.542, 4.103, 3.697, 3.272, 2.863, 2.455, 2.081, 1.833, 1.849, 1.914, 1.948,
                       1.958, 1.952, 1.933}};
constexpr Table kSilver{{.04, .03, .04, .05, .06, .05, .06, .05, .05, .05, .04, .04, .05, .05, .05},
                        {5.727, 5.242, 4.838, 4.483, 4.152, 3.858, 3.586, 3.324, 3.093, 2.869, 2.657, 2.462,
                         2.275, 2.070, 1.864}};
constexpr Table kCopper{{.26, .24, .21, .22, .30, .70, 1.02, 1.18, 1.22, 1.25, 1.24, 1.25, 1.28, 1.32, 1.33},
                        {5.180, 4.665, 4.205, 3.747, 3.205, 2.704, 2.577, 2.608, 2.564, 2.483, 2.397, 2.305,
                         2.207, 2.116, 2.045}};

Complex interpolate(const Table& table, double energy) {
    const auto upper = std::upper_bound(kEnergies.begin(), kEnergies.end() - 1, energy);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(upper - kEnergies.begin(), 1));
    const double x = (energy - kEnergies[i - 1]) / (kEnergies[i] - kEnergies[i - 1]);
    return {std::lerp(table.n[i - 1], table.n[i], x), -std::lerp(table.k[i - 1], table.k[i], x)};
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
    const Table* table = nullptr;
    if (named({"Au", "gold"})) table = &kGold;
    if (named({"Ag", "silver"})) table = &kSilver;
    if (named({"Cu", "copper"})) table = &kCopper;
    if (table == nullptr && !named({"Al", "aluminium", "aluminum"}))
        throw Error(ErrorCode::invalid_argument,
                    "metal is \"" + std::string(metal.substr(0, 100)) + "\"; it must be Au, Ag, Cu or Al");
    std::vector<Complex> out;
    for (const double wavelength : wavelengths) {
        if (!(wavelength >= 400 && wavelength <= 800))
            throw Error(ErrorCode::invalid_argument,
                        "a wavelength is " + std::to_string(wavelength) + " nm; it must lie in 400 to 800");
        const double energy = kPhotonEnergyNm / wavelength;
        out.push_back(table != nullptr ? interpolate(*table, energy) : aluminium(energy));
    }
    return out;
}

}  // namespace nicol
