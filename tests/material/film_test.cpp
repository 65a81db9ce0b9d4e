// SPDX-License-Identifier: MIT
#include "material/film.hpp"

#include "directions.hpp"
#include "material/coated_plastic.hpp"
#include "material/conductor.hpp"
#include "material/spectrum_weights.hpp"
#include "polarization/fresnel.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

using Complex = std::complex<double>;

double difference(const SpShares& a, const SpShares& b) {
    return std::max({std::abs(a.s - b.s), std::abs(a.p - b.p), std::abs(a.correlation - b.correlation)});
}

double difference(const FilmSplit& a, const FilmSplit& b) {
    return std::max({difference(a.front, b.front), difference(a.back, b.back),
                     difference(a.transmission, b.transmission)});
}

bool possible(const SpShares& shares) {
    return shares.s >= 0 && shares.p >= 0 && shares.s <= 1 && shares.p <= 1 &&
           std::norm(shares.correlation) <= shares.s * shares.p + 1e-12;
}

}  // namespace

TEST_CASE("channels of single wavelengths are the film at these wavelengths, from both sides") {
    const FilmParameters film{.thickness = 420, .eta = {1.33}, .wavelengths = {450, 630}};
    for (const double inside : {1.0, 1.5, 0.7}) {
        for (const double outside : {1.0, 1.33}) {
            const FilmTable table(film, outside, {inside});
            CHECK(table.channels() == 2);
            for (int c = 0; c < 2; ++c) {
                const double eta = inside / outside;
                const auto expected = [&](double tangential2) {
                    return film_split(tangential2, eta, {420, 1.33 / outside},
                                      film.wavelengths[static_cast<std::size_t>(c)] / outside);
                };
                for (double cosine = 0.001; cosine < 1; cosine += 0.0173) {
                    const double front2 = 1 - cosine * cosine;
                    const double behind2 = eta * eta * front2;
                    CHECK(difference(table.split(c, cosine, false).front, expected(front2).front) <= 2e-3);
                    CHECK(difference(table.split(c, cosine, true).back, expected(behind2).back) <= 2e-3);
                    if (behind2 < 1)
                        CHECK(difference(table.split(c, cosine, true), expected(behind2)) <= 2e-3);
                }
            }
        }
    }
}

TEST_CASE("red, green and blue are means over the spectrum, clipped to what is possible") {
    std::vector<double> wavelengths;
    for (double nm = 380; nm <= 780; nm += 1) wavelengths.push_back(nm);
    const ChannelWeights weights = rgb_weights(wavelengths);
    // The thin film has colours within the gamut.
    const FilmParameters film{.thickness = 200, .eta = {1.45}};
    const FilmTable table(film, 1, {Complex(2.9, -3.1)});
    for (const double cosine : {1.0, 0.8, 0.5, 0.1}) {
        for (int c = 0; c < 3; ++c) {
            FilmSplit mean;
            for (std::size_t k = 0; k < wavelengths.size(); ++k)
                mean.front += weights[static_cast<std::size_t>(c)][k] *
                              film_split(1 - cosine * cosine, {2.9, -3.1}, {200, 1.45}, wavelengths[k]).front;
            // Negative weights of wavelengths give a correlation that is a little too large.
            const double most = std::sqrt(mean.front.s * mean.front.p);
            const double length = std::abs(mean.front.correlation);
            CHECK(length < 1.1 * most);
            if (length > most) mean.front.correlation *= most / length;
            CHECK(difference(table.split(c, cosine, false).front, mean.front) <= 2e-3);
        }
    }
    for (const double thickness : {150.0, 400.0, 1000.0, 8000.0}) {
        for (const Complex eta : {Complex(1), Complex(1.5), Complex(0.2, -3.4)}) {
            const FilmTable any({.thickness = thickness, .eta = {2.4}}, 1, {eta});
            for (double cosine = 0; cosine <= 1; cosine += 1.0 / 64) {
                for (int c = 0; c < 3; ++c) {
                    const FilmSplit split = any.split(c, cosine, false);
                    CHECK(possible(split.front));
                    CHECK(possible(split.transmission));
                    if (eta.imag() == 0) CHECK(split.front.s + split.transmission.s == Approx(1));
                }
            }
        }
    }
}

TEST_CASE("a thick film has no colour, and a thin one has") {
    const auto spread = [](double thickness) {
        const FilmTable table({.thickness = thickness, .eta = {1.33}}, 1, {1.0});
        double least = 1;
        double most = 0;
        for (int c = 0; c < 3; ++c) {
            least = std::min(least, table.reflection(c, 1).a);
            most = std::max(most, table.reflection(c, 1).a);
        }
        return most - least;
    };
    CHECK(spread(350) > 0.02);
    CHECK(spread(9000) < 0.002);
}

TEST_CASE("a metal with a film reflects by the film in frames of the facets, in lanes as well") {
    const FilmParameters film{.thickness = 300, .eta = {2.2}};
    const std::vector<Complex> eta = metal_index("Cr");
    const FilmTablePtr table = film_table(film, 1, eta);
    const MaterialPtr coated = rough_conductor({.eta = eta, .alpha = 0.3, .film = table});
    CHECK(coated->channels() == 3);
    CHECK(coated->terms() == 3);
    CHECK(film_table({}, 1, eta) == nullptr);
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 light = random_direction_within(random, 1.5);
        const glm::dvec3 viewer = random_direction_within(random, 1.5);
        const double cosine = glm::dot(glm::normalize(light + viewer), viewer);
        const MaterialPtr bare = rough_conductor({.eta = {Complex(0, -1)}, .alpha = 0.3});
        for (int c = 0; c < 3; ++c)
            CHECK(evaluate(*coated, c, light, viewer)(0, 0) ==
                  Approx(table->reflection(c, cosine).a * evaluate(*bare, 0, light, viewer)(0, 0)));
    }
    const auto key = [&](double thickness) {
        return rough_conductor({.eta = eta, .film = film_table({.thickness = thickness}, 1, eta)})
            ->content_key();
    };
    CHECK(key(300) != key(301));
    CHECK(key(0) == rough_conductor({.eta = eta})->content_key());
}

TEST_CASE("plastic with a film that is hardly there is plastic") {
    const PplasticParameters parameters{.diffuse_reflectance = {0.3, 0.5, 0.7}, .alpha = 0.2};
    const MaterialPtr bare = pplastic(parameters);
    const MaterialPtr coated = coated_pplastic(parameters, {.thickness = 0.01, .eta = {1.6}});
    CHECK(coated_pplastic(parameters, {})->content_key() == bare->content_key());
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 light = random_direction_within(random, 1.4);
        const glm::dvec3 viewer = random_direction_within(random, 1.4);
        for (int c = 0; c < 3; ++c) {
            const Mueller expected = evaluate(*bare, c, light, viewer);
            CHECK(largest_difference(evaluate(*coated, c, light, viewer), expected) <= 2e-3 * expected(0, 0));
        }
    }
}

TEST_CASE("films out of range are named") {
    const auto message = [](const FilmParameters& film, std::vector<Complex> inside = {Complex(1.5)}) {
        return error_of(CALL(FilmTable(film, 1, inside)));
    };
    CHECK(message({.thickness = -1}).find("film_thickness") == 0);
    CHECK(message({.thickness = 10001}).find("film_thickness") == 0);
    CHECK(message({.thickness = 100, .eta = {}}).find("film_eta") == 0);
    CHECK(message({.thickness = 100, .eta = {0.0}}).find("film_eta") == 0);
    CHECK(message({.thickness = 100, .eta = {{1.5, 1}}}).find("film_k") == 0);
    CHECK(message({.thickness = 100, .eta = {1.5, 1.6}}).find("film_eta") == 0);
    CHECK(message({.thickness = 100, .wavelengths = {50}}).find("wavelengths") == 0);
    CHECK(message({.thickness = 100}, {1.5, 1.6}).find("eta") == 0);
}
