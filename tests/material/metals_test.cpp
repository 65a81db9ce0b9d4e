// SPDX-License-Identifier: MIT
// Tests of named metals: their constants, and their values in red, green and blue.
#include "material/conductor.hpp"
#include "material/metal_constants.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

using Complex = std::complex<double>;

double reflectance(Complex eta) {
    return std::norm((eta - 1.0) / (eta + 1.0));
}

}  // namespace

TEST_CASE("named metals have the constants of the handbooks") {
    struct Case {
        const char* metal;
        double nm, n, k;
    };
    for (const auto& [metal, nm, n, k] : {Case{"Ag", 563.6, 0.12, 3.45},
                                          {"silver", 413.3, 0.173, 2.11},
                                          {"Au", 563.6, 0.306, 2.88},
                                          {"gold", 700, 0.1605, 3.964},
                                          {"Cu", 563.6, 0.8255, 2.599},
                                          {"copper", 700, 0.2148, 4.158},
                                          {"Al", 619.9, 1.304, 7.479},
                                          {"aluminium", 400, 0.490, 4.86},
                                          {"aluminum", 500, 0.769, 6.08},
                                          {"W", 619.9, 3.6, 2.89},
                                          {"Cr", 505, 2.665, 4.453},
                                          {"Ni_palik", 619.9, 1.93, 3.65},
                                          {"TiN_palik", 619.9, 1.32, 2.69},
                                          {"a-C", 619.9, 2.43, 0.75},
                                          {"d-C", 589, 2.417, 0},
                                          {"MgO", 589, 1.737, 0},
                                          {"Hg", 619.9, 1.91, 5.15}}) {
        CAPTURES(metal, nm);
        const Complex eta = metal_index(metal, {nm}).front();
        CHECK(eta.real() == Approx(n).epsilon(0.01));
        CHECK(-eta.imag() == Approx(k).epsilon(0.01));
    }
    // Outside the measured range the nearest value applies.
    CHECK(metal_index("AlSb", {600, 800})[0] == metal_index("AlSb", {600, 800})[1]);
    CHECK(metal_index("Au", {380, 500, 800}).size() == 3);
    for (const double nm : {379.0, 801.0, std::nan("")}) CHECK_THROWS_AS(metal_index("Au", {nm}), Error);
}

TEST_CASE("red, green and blue of named metals are those of Mitsuba's modes without spectra") {
    // The values were printed by Mitsuba 3.9.1, scalar_rgb, in the order eta, k.
    struct Case {
        const char* metal;
        std::array<double, 3> eta, k;
    };
    for (const auto& [metal, eta, k] :
         {Case{"Au", {0.14304, 0.37531, 1.44205}, {3.983, 2.38556, 1.60336}},
          {"Ag", {0.15528, 0.11673, 0.13839}, {4.82835, 3.12222, 2.1469}},
          {"Cu", {0.20101, 0.92375, 1.10222}, {3.91326, 2.45305, 2.14209}},
          {"Cu_palik", {0.21323, 0.91972, 1.10241}, {3.92187, 2.45733, 2.13658}},
          {"Al", {1.6575, 0.8804, 0.52124}, {9.22381, 6.2695, 4.837}},
          {"W", {4.37082, 3.30025, 2.99841}, {3.50064, 2.60487, 2.27323}},
          {"Cr", {4.36967, 2.91651, 1.6549}, {5.20655, 4.23131, 3.7547}},
          {"TiN_palik", {1.64845, 1.15052, 1.37982}, {3.36833, 1.9435, 1.10207}},
          {"a-C", {2.94405, 2.22714, 1.96816}, {0.88746, 0.7993, 0.81529}},
          {"AlSb", {0, 4.13937, 4.66925}, {0, 0.09401, 1.30057}},
          {"Hg", {2.39894, 1.44003, 0.90957}, {6.32759, 4.37192, 3.42176}}}) {
        const std::vector<Complex> index = metal_index(metal);
        REQUIRE(index.size() == 3);
        for (std::size_t c = 0; c < 3; ++c) {
            CAPTURES(metal, c);
            CHECK(std::abs(index[c].real() - eta[c]) <= 0.01 * eta[c] + 0.002);
            CHECK(std::abs(-index[c].imag() - k[c]) <= 0.01 * k[c] + 0.002);
        }
    }
}

TEST_CASE("every named metal has a table that a material can be made of") {
    CHECK(named_metals().size() == 70);
    for (const NamedMetal& metal : named_metals()) {
        CAPTURE(std::string(metal.name));
        REQUIRE(metal.samples.size() >= 2);
        CHECK(metal.samples.front().wavelength <= 380);
        for (std::size_t i = 1; i < metal.samples.size(); ++i)
            CHECK(metal.samples[i].wavelength > metal.samples[i - 1].wavelength);
        CHECK(metal_names().find(metal.name) != std::string::npos);
        CHECK(rough_conductor({.eta = metal_index(metal.name)})->channels() == 3);
        for (const Complex eta : metal_index(metal.name, {380, 450, 550, 650, 800})) {
            CHECK(reflectance(eta) <= 1);
            CHECK(eta.imag() <= 0);
        }
    }
    const std::string message = error_of(CALL(metal_index("Unobtainium")));
    CHECK(message.find("\"Unobtainium\"") != std::string::npos);
    CHECK(message.find("Ag, Al, AlAs") != std::string::npos);
}

TEST_CASE("gold is yellow, copper is red, silver and aluminium are grey") {
    const auto gold = metal_index("gold");
    CHECK(reflectance(gold[0]) > 0.93);
    CHECK(reflectance(gold[1]) == Approx(0.8).epsilon(0.05));
    CHECK(reflectance(gold[2]) < 0.4);
    const auto copper = metal_index("Cu");
    CHECK(reflectance(copper[0]) > 0.85);
    CHECK(reflectance(copper[2]) < 0.6);
    for (const char* name : {"Ag", "Al"})
        for (const Complex eta : metal_index(name)) CHECK(reflectance(eta) > 0.88);
}
