// SPDX-License-Identifier: MIT
// Tests of reconstruction filters.
#include "image/reconstruction_filter.hpp"

#include <array>
#include <limits>

#include "error.hpp"
#include "test.hpp"

using namespace nicol;
using Kind = ReconstructionFilter::Kind;

namespace {

constexpr std::array kDistances{0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.5};

// Mitsuba approximates the Gaussian by a polynomial, which differs by up to 8e-4.
struct Peer {
    ReconstructionFilter filter;
    double radius;
    std::array<double, kDistances.size()> values;  // eval() of Mitsuba 3.9.1
};
const std::array kPeers{
    Peer{{.kind = Kind::box}, 0.5, {1, 1, 0, 0, 0, 0, 0, 0, 0}},
    Peer{{.kind = Kind::gaussian},
         2,
         {0.999247, 0.882167, 0.606423, 0.324243, 0.13496, 0.0436035, 0.0107582, 0.0018431, 0}},
    Peer{{.kind = Kind::gaussian, .size = 0.8},
         3.2,
         {0.999256, 0.9518, 0.822387, 0.644309, 0.457579, 0.294603, 0.172021, 0.091069, 0.0072369}},
    Peer{{.kind = Kind::tent}, 1, {1, 0.75, 0.5, 0.25, 0, 0, 0, 0, 0}},
    Peer{{.kind = Kind::tent, .size = 2}, 2, {1, 0.875, 0.75, 0.625, 0.5, 0.375, 0.25, 0.125, 0}},
    Peer{{.kind = Kind::mitchell},
         2,
         {0.888889, 0.782118, 0.534722, 0.256076, 0.0555556, -0.0234375, -0.0347221, -0.0147569, 0}},
    Peer{{.kind = Kind::mitchell, .b = 0.2, .c = 0.4},
         2,
         {0.933333, 0.816146, 0.545833, 0.244271, 0.0333333, -0.0421875, -0.0458336, -0.0182295, 0}},
    Peer{{.kind = Kind::catmullrom},
         2,
         {1, 0.867188, 0.5625, 0.226562, 0, -0.0703125, -0.0625, -0.0234375, 0}},
    Peer{{.kind = Kind::lanczos},
         3,
         {1, 0.890067, 0.607927, 0.27019, 0, -0.132871, -0.135095, -0.0677913, 0.0243171}},
    Peer{{.kind = Kind::lanczos, .size = 2},
         2,
         {1, 0.877354, 0.573159, 0.235347, 0, -0.0847248, -0.0636844, -0.0179052, 0}}};

}  // namespace

TEST_CASE("filters have the radius and the values of Mitsuba's") {
    for (const Peer& peer : kPeers) {
        CAPTURE(static_cast<int>(peer.filter.kind));
        CHECK(peer.filter.radius() == peer.radius);
        for (std::size_t i = 0; i < kDistances.size(); ++i) {
            CAPTURE(kDistances[i]);
            CHECK(std::abs(peer.filter(kDistances[i]) - peer.values[i]) < 8e-4);
            // The box holds its left end and not its right one, so that neighbours share no sample.
            if (peer.filter.kind != Kind::box || kDistances[i] != 0.5)
                CHECK(peer.filter(-kDistances[i]) == peer.filter(kDistances[i]));
        }
    }
    CHECK(ReconstructionFilter{}(-0.5) == 1);
}

TEST_CASE("filters out of range are refused by member") {
    const auto refused = [](const ReconstructionFilter& filter, const char* part) {
        try {
            check(filter, "filter.");
            FAIL(part);
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::invalid_argument);
            CHECK(std::string(error.what()).find(part) != std::string::npos);
        }
    };
    refused({.kind = Kind::gaussian, .size = 0.12}, "filter.size is 0.12");
    refused({.kind = Kind::gaussian, .size = 4.1}, "0.125000 to 4.000000, or be 0");
    refused({.kind = Kind::tent, .size = 0.4}, "0.500000 to 16.000000");
    refused({.kind = Kind::lanczos, .size = 0.9}, "1.000000 to 16.000000");
    refused({.kind = Kind::lanczos, .size = std::numeric_limits<double>::quiet_NaN()}, "filter.size");
    refused({.kind = Kind::mitchell, .b = -0.1}, "filter.b is -0.1");
    refused({.kind = Kind::mitchell, .c = 1.1}, "filter.c is 1.1");
    for (const Peer& peer : kPeers) check(peer.filter, "");
}
