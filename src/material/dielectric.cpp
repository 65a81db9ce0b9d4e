// SPDX-License-Identifier: MIT
#include "material/dielectric.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "error.hpp"
#include "material/key.hpp"
#include "material/reflectance.hpp"
#include "material/textured.hpp"
#include "polarization/fresnel.hpp"

namespace nicol {
namespace {

// Least roughness that a texture gives.
constexpr double kLeastOfTexture = 0.01;

class SmoothDielectric final : public Material {
public:
    explicit SmoothDielectric(SmoothBoundary boundary) : boundary_(std::move(boundary)) {}

    [[nodiscard]] int channels() const noexcept override { return boundary_.channels(); }
    [[nodiscard]] int terms() const noexcept override { return 1; }
    [[nodiscard]] double weight(int, int) const override { return 0; }
    [[nodiscard]] double lobe_width(int) const noexcept override { return 1; }
    [[nodiscard]] const SmoothBoundary* smooth_boundary() const noexcept override { return &boundary_; }
    [[nodiscard]] std::string content_key() const override { return boundary_.content_key(); }
    [[nodiscard]] Mueller evaluate(int, const glm::dvec3&, const glm::dvec3&) const override { return {}; }

private:
    SmoothBoundary boundary_;
};

void check_factor(const ColorParameter& color, const std::string& name) {
    if (color.texture != nullptr)
        throw Error(ErrorCode::unsupported,
                    name + " of a material that light passes is a texture; give a constant colour");
    check_reflectance(color.values, name);
}

void check_film_channels(const DielectricParameters& p) {
    if (!p.film.present()) return;
    const auto channels = static_cast<std::size_t>(p.film.channels());
    check_channels(p.specular_reflectance.values.size(), "specular_reflectance", channels, "the film");
    check_channels(p.specular_transmittance.values.size(), "specular_transmittance", channels, "the film");
    check_channels(p.absorption.size(), "absorption", channels, "the film");
}

MaterialPtr boundary_material(SmoothBoundary::Behind behind, const DielectricParameters& p) {
    check_range(p.int_ior, 1e-3, 1e3, "int_ior");
    check_range(p.ext_ior, 1e-3, 1e3, "ext_ior");
    check_factor(p.specular_reflectance, "specular_reflectance");
    check_factor(p.specular_transmittance, "specular_transmittance");
    check_channels(p.specular_reflectance.values.size(), "specular_reflectance",
                   p.specular_transmittance.values.size(), "specular_transmittance");
    if (p.absorption.empty())
        throw Error(ErrorCode::invalid_argument, "absorption has no value; give one, or one per channel");
    for (const double value : p.absorption)
        check_range(value, 0, std::numeric_limits<double>::max(), "absorption");
    check_channels(p.specular_reflectance.values.size(), "specular_reflectance", p.absorption.size(),
                   "absorption");
    check_channels(p.specular_transmittance.values.size(), "specular_transmittance", p.absorption.size(),
                   "absorption");
    if (behind == SmoothBoundary::Behind::slab && !black(p.absorption))
        throw Error(ErrorCode::invalid_argument,
                    "absorption is not 0, but a thin pane has no thickness; set specular_transmittance");
    check_film_channels(p);
    const auto kind =
        behind == SmoothBoundary::Behind::slab ? FilmTable::Kind::slab : FilmTable::Kind::interface;
    const SmoothBoundary boundary{.behind = behind,
                                  .eta = p.int_ior / p.ext_ior,
                                  .reflectance = p.specular_reflectance.values,
                                  .transmittance = p.specular_transmittance.values,
                                  .absorption = p.absorption,
                                  .alpha = mean_of(p.alpha, kLeastOfTexture),
                                  .distribution = p.distribution,
                                  .film = film_table(p.film, p.ext_ior, {p.int_ior}, kind)};
    if (boundary.alpha != 0) check_range(boundary.alpha, 0.001, 1, "alpha");
    if (!boundary.rough()) return std::make_shared<SmoothDielectric>(boundary);
    return transmitting(rough_reflection(boundary, p.alpha), boundary);
}

}  // namespace

int SmoothBoundary::channels() const noexcept {
    const std::size_t of_film = film ? static_cast<std::size_t>(film->channels()) : 1;
    return static_cast<int>(std::max({reflectance.size(), transmittance.size(), absorption.size(), of_film}));
}

std::string SmoothBoundary::content_key() const {
    Key key("dielectric");
    if (film) key.add("film", std::string_view(film->key()));
    return key.add("eta", eta)
        .add("slab", behind == Behind::slab)
        .add("reflectance", reflectance)
        .add("transmittance", transmittance)
        .add("absorption", absorption)
        .add("alpha", alpha)
        .add("distribution", distribution == Distribution::ggx)
        .text();
}

SlabSplit split_of(const SmoothBoundary& boundary, double cosine, bool inside, int channel) {
    const bool slab = boundary.behind == SmoothBoundary::Behind::slab;
    if (boundary.film) {
        const FilmSplit split = boundary.film->split(channel, cosine, inside && !slab);
        return {.reflection = mueller_of(inside && !slab ? split.back : split.front),
                .transmission = mueller_of(split.transmission)};
    }
    if (slab) return slab_split(cosine, boundary.eta);
    const double eta = inside ? 1 / boundary.eta : boundary.eta;
    return {.reflection = fresnel_reflection(cosine, eta), .transmission = fresnel_transmission(cosine, eta)};
}

SlabSplit mean_split_of(const SmoothBoundary& boundary, double cosine, bool inside) {
    if (!boundary.film) return split_of(boundary, cosine, inside, 0);
    const int channels = boundary.film->channels();
    SlabSplit sum;
    for (int c = 0; c < channels; ++c) {
        const SlabSplit split = split_of(boundary, cosine, inside, c);
        sum.reflection = sum.reflection + 1.0 / channels * split.reflection;
        sum.transmission = sum.transmission + 1.0 / channels * split.transmission;
    }
    return sum;
}

std::string glass_key(const Material& material) {
    const SmoothBoundary* const boundary = material.smooth_boundary();
    return boundary != nullptr ? boundary->content_key() : std::string();
}

MaterialPtr dielectric(const DielectricParameters& parameters) {
    return boundary_material(SmoothBoundary::Behind::body, parameters);
}

MaterialPtr thin_dielectric(const DielectricParameters& parameters) {
    return boundary_material(SmoothBoundary::Behind::slab, parameters);
}

}  // namespace nicol
