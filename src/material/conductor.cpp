// SPDX-License-Identifier: MIT
#include "material/conductor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "material/frames.hpp"
#include "material/key.hpp"
#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "material/shared_terms.hpp"
#include "material/textured.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

template <class Number>
[[gnu::always_inline]] inline void reflect_metal(const Facets<float>& facets,
                                                 const std::vector<std::complex<double>>& eta,
                                                 const LaneVectors& towards_light,
                                                 const LaneVectors& towards_viewer, std::size_t columns,
                                                 LaneMueller* out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Vector3<Number> viewer;
        load_part(towards_light, first, light);
        load_part(towards_viewer, first, viewer);
        const FacetReflection<Number> facet = facet_reflection(facets, light, viewer);
        for (std::size_t t = 0; t < eta.size(); ++t) {
            const RelativeIndex<float> index(eta[t]);
            store_reflection(facet, reflection_block(facet.cosine, index), columns, first, out[t]);
        }
    }
}

template <class Number>
[[gnu::always_inline]] inline void reflect_coated(const Facets<float>& facets, const FilmTable& film,
                                                  const LaneVectors& towards_light,
                                                  const LaneVectors& towards_viewer, std::size_t columns,
                                                  LaneMueller* out) {
    std::array<FacetReflection<Number>, kLanes / kPart<Number>> parts;
    Lanes cosines;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Vector3<Number> viewer;
        load_part(towards_light, first, light);
        load_part(towards_viewer, first, viewer);
        FacetReflection<Number>& facet = parts[first / kPart<Number>];
        facet = facet_reflection(facets, light, viewer);
        store_part(facet.cosine, first, cosines);
    }
    for (int c = 0; c < film.channels(); ++c) {
        ReflectionBlock<Lanes> blocks;
        film.reflection_lanes(c, cosines, blocks);
        for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
            ReflectionBlock<Number> block;
            load_part(blocks.a, first, block.a);
            load_part(blocks.b, first, block.b);
            load_part(blocks.c, first, block.c);
            load_part(blocks.d, first, block.d);
            store_reflection(parts[first / kPart<Number>], block, columns, first, out[c]);
        }
    }
}

// Rough conductor with one term per index, or per channel of its film, and with a single term if only the
// reflectance has colour.
class RoughConductor final : public Material, public SharedTerms {
public:
    explicit RoughConductor(RoughConductorParameters parameters)
        : p_(std::move(parameters)), smooth_(take_smooth(p_.alpha.value, p_.distribution)) {
        if (p_.eta.empty())
            throw Error(ErrorCode::invalid_argument, "eta has no value; give one, or one a channel");
        for (const std::complex<double> eta : p_.eta) {
            check_range(eta.real(), 0, 100, "eta");
            check_range(-eta.imag(), 0, 100, "k");
            if (std::abs(eta) < kSmallestIndex)
                throw Error(ErrorCode::invalid_argument,
                            "eta and k are both 0 or close to it; eta^2 + k^2 of a metal is 1e-6 or more");
        }
        check_reflectance(p_.specular_reflectance.values, "specular_reflectance");
        alpha_ = {p_.alpha.value, p_.alpha_v.value != 0 ? p_.alpha_v.value : p_.alpha.value};
        check_range(alpha_.x, 0.001, 1, "alpha");
        check_range(alpha_.y, 0.001, 1, "alpha_v");
        check_channels(p_.eta.size(), "eta", p_.specular_reflectance.values.size(), "specular_reflectance");
        if (p_.film)
            check_channels(static_cast<std::size_t>(p_.film->channels()), "the film",
                           p_.specular_reflectance.values.size(), "specular_reflectance");
        if (!p_.film &&
            std::all_of(p_.eta.begin(), p_.eta.end(), [this](auto eta) { return eta == p_.eta.front(); }) &&
            p_.specular_reflectance.values.size() > 1)
            p_.eta.resize(1);
        if (alpha_.x != alpha_.y) {
            RoughConductorParameters mean = p_;
            mean.alpha = std::sqrt(alpha_.x * alpha_.y);
            mean.alpha_v = 0;
            isotropic_ = std::make_unique<const RoughConductor>(std::move(mean));
        }
    }

    [[nodiscard]] int channels() const noexcept override {
        return std::max(terms(), static_cast<int>(p_.specular_reflectance.values.size()));
    }
    [[nodiscard]] int terms() const noexcept override {
        return p_.film ? p_.film->channels() : static_cast<int>(p_.eta.size());
    }
    [[nodiscard]] double weight(int term, int channel) const override {
        return terms() == 1 || term == channel ? of_channel(p_.specular_reflectance.values, channel) : 0;
    }
    [[nodiscard]] double lobe_width(int) const noexcept override { return std::min(alpha_.x, alpha_.y); }
    [[nodiscard]] glm::dvec2 lobe_widths(int) const noexcept override { return alpha_; }
    [[nodiscard]] Distribution distribution(int) const noexcept override { return p_.distribution; }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] bool smooth(int) const noexcept override { return smooth_; }
    [[nodiscard]] std::string content_key() const override {
        return with_terms(Key("roughconductor").add("specular_reflectance", p_.specular_reflectance.values));
    }
    [[nodiscard]] std::string own_terms_key() const override { return with_terms(Key("roughconductor")); }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        return reflect(facet(towards_light, towards_viewer), term);
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) {
            std::fill(out.begin(), out.end(), Mueller{});
            return;
        }
        const FacetReflection<double> shared = facet(towards_light, towards_viewer);
        for (int t = 0; t < terms(); ++t) out[static_cast<std::size_t>(t)] = reflect(shared, t);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t columns, std::span<LaneMueller> out) const override {
        const Facets<float> facets{p_.distribution, static_cast<float>(alpha_.x),
                                   static_cast<float>(alpha_.y)};
        if (p_.film)
            dispatch<reflect_coated<FourLanes>, reflect_coated<EightLanes>, reflect_coated<AllLanes>>(
                facets, *p_.film, towards_light, towards_viewer, columns, out.data());
        else
            dispatch<reflect_metal<FourLanes>, reflect_metal<EightLanes>, reflect_metal<AllLanes>>(
                facets, p_.eta, towards_light, towards_viewer, columns, out.data());
    }

private:
    [[nodiscard]] std::string with_terms(Key key) const {
        if (p_.film) key.add("film", std::string_view(p_.film->key()));
        return key.add("eta", p_.eta)
            .add("alpha", isotropic_ ? std::vector{alpha_.x, alpha_.y} : std::vector{alpha_.x})
            .add("distribution", p_.distribution == Distribution::ggx)
            .text();
    }
    // Returns the part of the reflection that all indices share.
    [[nodiscard]] FacetReflection<double> facet(const glm::dvec3& light, const glm::dvec3& viewer) const {
        return facet_reflection({p_.distribution, alpha_.x, alpha_.y}, components(light), components(viewer));
    }
    [[nodiscard]] Mueller reflect(const FacetReflection<double>& facet, int term) const {
        const ReflectionBlock<double> block =
            p_.film ? p_.film->reflection(term, facet.cosine)
                    : reflection_block(facet.cosine,
                                       RelativeIndex<double>(p_.eta[static_cast<std::size_t>(term)]));
        return in_rotated_frames(facet.scale, block, facet.rotations);
    }

    RoughConductorParameters p_;                       // values only, no textures
    glm::dvec2 alpha_;                                 // roughness along x and along y
    std::unique_ptr<const RoughConductor> isotropic_;  // null: this material is isotropic
    bool smooth_;
};

}  // namespace

MaterialPtr rough_conductor(const RoughConductorParameters& parameters) {
    RoughConductorParameters facets = parameters;
    facets.specular_reflectance = factor(parameters.specular_reflectance);
    const auto make_facets = [&facets](double u, double v) -> MaterialPtr {
        facets.alpha = u;
        facets.alpha_v = v;
        return std::make_shared<RoughConductor>(facets);
    };
    return times(at_roughness(make_facets, parameters.alpha, parameters.alpha_v),
                 parameters.specular_reflectance);
}

MaterialPtr conductor(std::vector<std::complex<double>> eta, const ColorParameter& specular_reflectance) {
    return rough_conductor({.eta = std::move(eta), .specular_reflectance = specular_reflectance, .alpha = 0});
}

}  // namespace nicol
