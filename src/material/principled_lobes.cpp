// SPDX-License-Identifier: MIT
#include "material/principled_lobes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "material/frames.hpp"
#include "material/key.hpp"
#include "material/lane_principled.hpp"
#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

/// Lobes of one width make one term.
constexpr std::array<std::pair<PrincipledLobe, PrincipledLobe>, 3> kTermLobes = {
    {{PrincipledLobe::sheen, PrincipledLobe::subsurface},
     {PrincipledLobe::metal, PrincipledLobe::dielectric},
     {PrincipledLobe::clearcoat, PrincipledLobe::clearcoat}}};

struct Term {
    std::array<double, kPrincipledLobes> amounts{};
    bool colored;
    glm::dvec2 widths;
};

/// Schlick's weight, (1 - cosine)^5, by the square of the sine: 1 - cosine without cancellation.
double schlick(double sine2, double cosine) {
    const double rest = sine2 / (1 + cosine);
    return rest * rest * rest * rest * rest;
}
double schlick(const glm::dvec3& direction) {
    return schlick(direction.x * direction.x + direction.y * direction.y, direction.z);
}

using Values = std::array<double, kPrincipledLobes>;

Values lobes(const PrincipledShape& k, const glm::dvec3& light, const glm::dvec3& viewer) {
    const double length = glm::length(light + viewer);
    const glm::dvec3 half = (light + viewer) / length;
    const double cosine = std::min(1.0, length / 2);
    const double sine2 = glm::dot(light - viewer, light - viewer) / 4;
    Values out{};
    const auto at = [&](PrincipledLobe lobe) -> double& { return out[index(lobe)]; };

    at(PrincipledLobe::sheen) = schlick(sine2, cosine);
    const double in = schlick(light);
    const double from = schlick(viewer);
    const double grazing = 2 * k.roughness * cosine * cosine;
    at(PrincipledLobe::diffuse) =
        ((1 - in / 2) * (1 - from / 2) + grazing * (in + from + in * from * (grazing - 1))) / pi;
    const double inside = (1 + (grazing / 2 - 1) * in) * (1 + (grazing / 2 - 1) * from);
    at(PrincipledLobe::subsurface) = 1.25 / pi * (inside * (1 / (light.z + viewer.z) - 0.5) + 0.5);

    double w = at(PrincipledLobe::sheen);
    if (!(k.eta > 1)) {
        const double refracted2 = std::min(1.0, sine2 / (k.eta * k.eta));
        w = schlick(refracted2, std::sqrt(1 - refracted2));
    }
    const Facets<double> facet_shape{Distribution::ggx, k.alpha().x, k.alpha().y};
    const double facets = facet_reflection(facet_shape, components(light), components(viewer)).scale;
    at(PrincipledLobe::metal) = (1 - w) * facets;
    at(PrincipledLobe::edge) = w * facets;
    at(PrincipledLobe::tinted) = k.normal_reflectance() * (1 - w) * facets;
    at(PrincipledLobe::dielectric) = dielectric_reflection(cosine, RelativeIndex<double>(k.eta)).a * facets;

    const auto visible = [](const glm::dvec3& direction) {
        return facet_visibility(Distribution::ggx, kCoatShadowing, direction.z);
    };
    const double coat_alpha2 = k.coat_alpha() * k.coat_alpha();
    const double coat =
        (coat_alpha2 - 1) / std::log(coat_alpha2) / (4 * pi) / (1 + (coat_alpha2 - 1) * half.z * half.z);
    at(PrincipledLobe::clearcoat) =
        (kCoatReflectance + (1 - kCoatReflectance) * w) * coat * visible(light) * visible(viewer);
    return out;
}

template <class Number>
[[gnu::always_inline]] inline void reflect_principled(const LanePrincipled& constants,
                                                      const std::vector<Term>& terms,
                                                      const LaneVectors& towards_light,
                                                      const LaneVectors& towards_viewer, LaneMueller* out) {
    for (std::size_t t = 0; t < terms.size(); ++t) out[t] = {};
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Vector3<Number> viewer;
        load_part(towards_light, first, light);
        load_part(towards_viewer, first, viewer);
        const LaneLobes<Number> values = lane_lobes(constants, light, viewer);
        for (std::size_t t = 0; t < terms.size(); ++t) {
            Number sum{};
            for (std::size_t i = 0; i < kPrincipledLobes; ++i)
                if (terms[t].amounts[i] != 0) sum += static_cast<float>(terms[t].amounts[i]) * values.of[i];
            store_part<Number>(sum, first, out[t].m[0]);
        }
    }
}

class PrincipledLobes final : public Material {
public:
    PrincipledLobes(const PrincipledShape& shape, std::vector<double> color, const PrincipledMix& mix)
        : shape_(shape), lanes_(shape), color_(std::move(color)) {
        const glm::dvec2 widths[] = {glm::dvec2(1), shape.alpha(), glm::dvec2(shape.coat_alpha())};
        for (std::size_t i = 0; i < kTermLobes.size(); ++i) {
            for (const bool colored : {true, false}) {
                const auto& amounts = colored ? mix.colored : mix.white;
                Term term{.colored = colored, .widths = widths[i]};
                bool any = false;
                for (std::size_t l = index(kTermLobes[i].first); l <= index(kTermLobes[i].second); ++l) {
                    term.amounts[l] = amounts[l];
                    any = any || amounts[l] != 0;
                }
                if (any) terms_.push_back(term);
            }
        }
        if (std::ranges::none_of(terms_, &Term::colored)) color_ = {1};
        const auto anisotropic = [](const Term& term) { return term.widths.x != term.widths.y; };
        if (std::ranges::any_of(terms_, anisotropic)) {
            PrincipledShape mean = shape;
            mean.anisotropic = 0;
            isotropic_ = std::make_unique<const PrincipledLobes>(mean, color_, mix);
        }
    }

    [[nodiscard]] int channels() const noexcept override { return static_cast<int>(color_.size()); }
    [[nodiscard]] int terms() const noexcept override { return static_cast<int>(terms_.size()); }
    [[nodiscard]] double weight(int term, int channel) const override {
        return at(term).colored ? of_channel(color_, channel) : 1;
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override {
        return std::min(at(term).widths.x, at(term).widths.y);
    }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override { return at(term).widths; }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] std::string content_key() const override {
        Key key("principled");
        key.add("roughness", shape_.roughness)
            .add("anisotropic", isotropic_ ? shape_.anisotropic : 0)
            .add("eta", shape_.eta)
            .add("clearcoat_gloss", shape_.clearcoat_gloss)
            .add("color", color_);
        for (const Term& term : terms_)
            key.add(term.colored ? "colored" : "white",
                    std::vector<double>(term.amounts.begin(), term.amounts.end()));
        return key.text();
    }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        return sum(at(term), lobes(shape_, towards_light, towards_viewer));
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) {
            std::fill(out.begin(), out.end(), Mueller{});
            return;
        }
        const Values values = lobes(shape_, towards_light, towards_viewer);
        for (std::size_t t = 0; t < terms_.size(); ++t) out[t] = sum(terms_[t], values);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer, std::size_t,
                        std::span<LaneMueller> out) const override {
        dispatch<reflect_principled<FourLanes>, reflect_principled<EightLanes>, reflect_principled<AllLanes>>(
            lanes_, terms_, towards_light, towards_viewer, out.data());
    }

private:
    [[nodiscard]] const Term& at(int term) const { return terms_[static_cast<std::size_t>(term)]; }
    static Mueller sum(const Term& term, const Values& values) {
        Mueller m;
        for (std::size_t i = 0; i < kPrincipledLobes; ++i) m(0, 0) += term.amounts[i] * values[i];
        return m;
    }

    PrincipledShape shape_;
    LanePrincipled lanes_;
    std::vector<double> color_;
    std::vector<Term> terms_;
    std::unique_ptr<const PrincipledLobes> isotropic_;  // null: it is so itself
};

}  // namespace

MaterialPtr principled_lobes(const PrincipledShape& shape, std::vector<double> color,
                             const PrincipledMix& mix) {
    return std::make_shared<PrincipledLobes>(shape, std::move(color), mix);
}

}  // namespace nicol
