// SPDX-License-Identifier: MIT
#include "material/coated_plastic.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "material/conductor.hpp"
#include "material/key.hpp"
#include "material/reflectance.hpp"
#include "material/textured.hpp"

namespace nicol {
namespace {

// Diffuse base below a smooth interface with a film: transmission, depolarizing scattering inside, and
// transmission out, as Pplastic's base. One term per channel of the film.
class CoatedBase final : public Material {
public:
    CoatedBase(std::vector<double> reflectance, FilmTablePtr film)
        : reflectance_(std::move(reflectance)), film_(std::move(film)) {
        check_reflectance(reflectance_, "diffuse_reflectance");
        check_channels(reflectance_.size(), "diffuse_reflectance", static_cast<std::size_t>(terms()),
                       "the film");
    }

    [[nodiscard]] int channels() const noexcept override {
        return std::max(terms(), static_cast<int>(reflectance_.size()));
    }
    [[nodiscard]] int terms() const noexcept override { return film_->channels(); }
    [[nodiscard]] double weight(int term, int channel) const override {
        return terms() == 1 || term == channel ? of_channel(reflectance_, channel) : 0;
    }
    [[nodiscard]] double lobe_width(int) const noexcept override { return 1; }
    [[nodiscard]] std::string content_key() const override {
        return Key("base below a film")
            .add("film", std::string_view(film_->key()))
            .add("diffuse_reflectance", reflectance_)
            .text();
    }
    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        const SpShares in = film_->split(term, std::min(1.0, towards_light.z), false).transmission;
        const SpShares out = film_->split(term, std::min(1.0, towards_viewer.z), false).transmission;
        // The s-axis of the macro surface is phi-hat. The rotation by 90 degrees negates s1.
        const double in_mean = (in.s + in.p) / 2, in_difference = (in.p - in.s) / 2;
        const double out_mean = (out.s + out.p) / 2 / std::numbers::pi;
        const double out_difference = (out.p - out.s) / 2 / std::numbers::pi;
        return Mueller({out_mean * in_mean, out_mean * in_difference, 0, 0, out_difference * in_mean,
                        out_difference * in_difference});
    }

private:
    std::vector<double> reflectance_;
    FilmTablePtr film_;
};

}  // namespace

MaterialPtr coated_pplastic(const PplasticParameters& parameters, const FilmParameters& film) {
    if (!film.present()) return pplastic(parameters);
    check_range(parameters.int_ior, 1e-3, 1e3, "int_ior");
    check_range(parameters.ext_ior, 1e-3, 1e3, "ext_ior");
    const double eta = parameters.int_ior / parameters.ext_ior;
    check_range(eta, 0.01, 100, "int_ior / ext_ior of a surface with a film");
    const FilmTablePtr table = film_table(film, parameters.ext_ior, {parameters.int_ior});
    const MaterialPtr base =
        std::make_shared<CoatedBase>(factor(parameters.diffuse_reflectance).values, table);
    return sum(times(base, parameters.diffuse_reflectance),
               rough_conductor({.eta = {eta},
                                .specular_reflectance = parameters.specular_reflectance,
                                .alpha = parameters.alpha,
                                .alpha_v = parameters.alpha_v,
                                .distribution = parameters.distribution,
                                .film = table}));
}

}  // namespace nicol
