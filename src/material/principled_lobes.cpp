// SPDX-License-Identifier: MIT
#include "material/principled_lobes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "material/key.hpp"
#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "material/shared_terms.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

/// Constants of a PrincipledShape and constants derived from them. Real: float or double.
template <class Real>
struct PrincipledConstants {
    explicit PrincipledConstants(const PrincipledShape& k)
        : roughness(static_cast<Real>(k.roughness)),
          index(k.eta),
          refracts_away(!(k.eta > 1)),
          inverse_square(static_cast<Real>(1 / (k.eta * k.eta))),
          facets{Distribution::ggx, static_cast<Real>(k.alpha().x), static_cast<Real>(k.alpha().y)},
          normal_reflectance(static_cast<Real>(k.normal_reflectance())),
          coat_alpha2(static_cast<Real>(k.coat_alpha() * k.coat_alpha())),
          coat_scale((coat_alpha2 - 1) / (4 * std::numbers::pi_v<Real> * std::log(coat_alpha2))) {}

    Real roughness;
    RelativeIndex<Real> index;
    bool refracts_away;   ///< eta is at most 1, so light refracts away from the normal
    Real inverse_square;  ///< 1 / eta^2
    Facets<Real> facets;
    Real normal_reflectance;
    Real coat_alpha2;
    Real coat_scale;
};

/// Groups of lobes that are computed.
struct WantedLobes {
    bool base;        ///< diffuse and subsurface
    bool facets;      ///< metal, edge, tinted
    bool dielectric;  ///< dielectric, of the same facets
    bool coat;        ///< clearcoat
};

/// Value of each lobe, by index(). Lobes that are not wanted are 0, except sheen.
template <class Number>
struct PrincipledValues {
    Number of[kPrincipledLobes];
};

template <class Number>
[[gnu::always_inline]] inline void to_fifth_power(Number& x) {
    const Number square = x * x;
    x *= square * square;
}

/// Computes Schlick's weight (1 - c)^5 of a direction, c the cosine of its angle to the normal.
template <class Number>
[[gnu::always_inline]] inline void schlick(const Vector3<Number>& direction, Number& weight) {
    const Number cosine = direction.z > 0.0F ? direction.z : Number{};
    weight = (direction.x * direction.x + direction.y * direction.y) / (1.0F + cosine);
    to_fifth_power(weight);
}

/// Returns the lobes, which are 0 if a direction lies below the horizon. Differences from 1 are computed
/// without cancellation.
template <class Number>
[[gnu::always_inline]] inline PrincipledValues<Number> principled_values(
    const PrincipledConstants<ScalarOf<Number>>& k, const WantedLobes& wanted, const Vector3<Number>& light,
    const Vector3<Number>& viewer) {
    constexpr ScalarOf<Number> inverse_pi = 1 / std::numbers::pi_v<ScalarOf<Number>>;
    // One condition, because GCC 12 does not vectorise two combined ones.
    const Number lower = light.z < viewer.z ? light.z : viewer.z;
    const auto above = lower > 0.0F;
    const Vector3<Number> half{light.x + viewer.x, light.y + viewer.y, light.z + viewer.z};
    const Vector3<Number> difference{light.x - viewer.x, light.y - viewer.y, light.z - viewer.z};
    Number length2;
    dot(half, half, length2);
    constexpr ScalarOf<Number> least = threshold<Number>(1e-18F, 1e-280);
    length2 = length2 > least ? length2 : Number{} + least;
    Number cosine = 0.25F * length2;
    square_root(cosine);
    cosine = cosine < 1.0F ? cosine : Number{} + 1.0F;
    Number sine2;
    dot(difference, difference, sine2);
    sine2 *= 0.25F;

    PrincipledValues<Number> out{};
    if (wanted.base) {
        Number in;
        Number from;
        schlick(light, in);
        schlick(viewer, from);
        const Number grazing = 2.0F * k.roughness * cosine * cosine;
        out.of[index(PrincipledLobe::diffuse)] =
            inverse_pi * ((1.0F - 0.5F * in) * (1.0F - 0.5F * from) +
                          grazing * (in + from + in * from * (grazing - 1.0F)));
        const Number inside = (1.0F + (0.5F * grazing - 1.0F) * in) * (1.0F + (0.5F * grazing - 1.0F) * from);
        out.of[index(PrincipledLobe::subsurface)] =
            1.25F * inverse_pi * (inside * (1.0F / (above ? half.z : Number{} + 1.0F) - 0.5F) + 0.5F);
    }
    Number w = sine2 / (1.0F + cosine);
    to_fifth_power(w);
    out.of[index(PrincipledLobe::sheen)] = w;

    if (k.refracts_away) {
        Number refracted2 = sine2 * k.inverse_square;
        refracted2 = refracted2 < 1.0F ? refracted2 : Number{} + 1.0F;
        Number refracted = 1.0F - refracted2;
        square_root(refracted);
        w = refracted2 / (1.0F + refracted);
        to_fifth_power(w);
    }
    Number from_light;
    Number to_viewer;
    if (wanted.facets || wanted.dielectric) {
        visibility_over_cosine(k.facets, light, from_light);
        visibility_over_cosine(k.facets, viewer, to_viewer);
        Number scale;
        density(k.facets, half, length2, scale);
        scale *= 0.25F * from_light * to_viewer;
        out.of[index(PrincipledLobe::metal)] = (1.0F - w) * scale;
        out.of[index(PrincipledLobe::edge)] = w * scale;
        out.of[index(PrincipledLobe::tinted)] = k.normal_reflectance * (1.0F - w) * scale;
        if (wanted.dielectric)
            out.of[index(PrincipledLobe::dielectric)] = dielectric_reflection(cosine, k.index).a * scale;
    }
    if (wanted.coat) {
        constexpr ScalarOf<Number> reflectance = constant<Number>(kCoatReflectance);
        constexpr Facets<ScalarOf<Number>> hidden{Distribution::ggx, constant<Number>(kCoatShadowing)};
        visibility_over_cosine(hidden, light, from_light);
        visibility_over_cosine(hidden, viewer, to_viewer);
        const Number rho2 = half.x * half.x + half.y * half.y;
        const Number coat = k.coat_scale * length2 / (rho2 + k.coat_alpha2 * half.z * half.z);
        out.of[index(PrincipledLobe::clearcoat)] =
            (reflectance + (1.0F - reflectance) * w) * coat * from_light * light.z * to_viewer * viewer.z;
    }
    for (Number& value : out.of) value = above ? value : Number{};
    return out;
}

/// First and last lobe of each term; the lobes of a term have one width.
constexpr std::array<std::pair<PrincipledLobe, PrincipledLobe>, 3> kTermLobes = {
    {{PrincipledLobe::sheen, PrincipledLobe::subsurface},
     {PrincipledLobe::metal, PrincipledLobe::dielectric},
     {PrincipledLobe::clearcoat, PrincipledLobe::clearcoat}}};

struct Term {
    std::array<double, kPrincipledLobes> amounts{};
    bool colored;
    glm::dvec2 widths;
};

WantedLobes wanted_of(const std::vector<Term>& terms) {
    const auto any = [&](PrincipledLobe first, PrincipledLobe last) {
        return std::ranges::any_of(terms, [=](const Term& term) {
            return std::any_of(&term.amounts[index(first)], &term.amounts[index(last)] + 1,
                               [](double amount) { return amount != 0; });
        });
    };
    using enum PrincipledLobe;
    return {.base = any(diffuse, subsurface),
            .facets = any(metal, tinted),
            .dielectric = any(dielectric, dielectric),
            .coat = any(clearcoat, clearcoat)};
}

template <class Number>
[[gnu::always_inline]] inline void reflect_principled(const PrincipledConstants<float>& constants,
                                                      const WantedLobes& wanted,
                                                      const std::vector<Term>& terms,
                                                      const LaneVectors& towards_light,
                                                      const LaneVectors& towards_viewer, LaneMueller* out) {
    for (std::size_t t = 0; t < terms.size(); ++t) out[t] = {};
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Vector3<Number> viewer;
        load_part(towards_light, first, light);
        load_part(towards_viewer, first, viewer);
        const PrincipledValues<Number> values = principled_values(constants, wanted, light, viewer);
        for (std::size_t t = 0; t < terms.size(); ++t) {
            Number sum{};
            for (std::size_t i = 0; i < kPrincipledLobes; ++i)
                if (terms[t].amounts[i] != 0) sum += static_cast<float>(terms[t].amounts[i]) * values.of[i];
            store_part<Number>(sum, first, out[t].m[0]);
        }
    }
}

class PrincipledLobes final : public Material, public SharedTerms {
public:
    PrincipledLobes(const PrincipledShape& shape, std::vector<double> color, const PrincipledMix& mix)
        : shape_(shape), doubles_(shape), lanes_(shape), color_(std::move(color)) {
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
        wanted_ = wanted_of(terms_);
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
        return with_terms(Key("principled").add("color", color_));
    }
    [[nodiscard]] std::string own_terms_key() const override { return with_terms(Key("principled")); }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        return sum(at(term), values(towards_light, towards_viewer));
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) {
            std::fill(out.begin(), out.end(), Mueller{});
            return;
        }
        const PrincipledValues<double> all = values(towards_light, towards_viewer);
        for (std::size_t t = 0; t < terms_.size(); ++t) out[t] = sum(terms_[t], all);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer, std::size_t,
                        std::span<LaneMueller> out) const override {
        dispatch<reflect_principled<FourLanes>, reflect_principled<EightLanes>, reflect_principled<AllLanes>>(
            lanes_, wanted_, terms_, towards_light, towards_viewer, out.data());
    }

private:
    [[nodiscard]] std::string with_terms(Key key) const {
        key.add("roughness", shape_.roughness)
            .add("anisotropic", isotropic_ ? shape_.anisotropic : 0)
            .add("eta", shape_.eta)
            .add("clearcoat_gloss", shape_.clearcoat_gloss);
        for (const Term& term : terms_)
            key.add(term.colored ? "colored" : "white",
                    std::vector<double>(term.amounts.begin(), term.amounts.end()));
        return key.text();
    }
    [[nodiscard]] const Term& at(int term) const { return terms_[static_cast<std::size_t>(term)]; }
    [[nodiscard]] PrincipledValues<double> values(const glm::dvec3& light, const glm::dvec3& viewer) const {
        return principled_values(doubles_, wanted_, components(light), components(viewer));
    }
    static Mueller sum(const Term& term, const PrincipledValues<double>& values) {
        Mueller m;
        for (std::size_t i = 0; i < kPrincipledLobes; ++i) m(0, 0) += term.amounts[i] * values.of[i];
        return m;
    }

    PrincipledShape shape_;
    PrincipledConstants<double> doubles_;
    PrincipledConstants<float> lanes_;
    std::vector<double> color_;
    std::vector<Term> terms_;
    WantedLobes wanted_{};
    std::unique_ptr<const PrincipledLobes> isotropic_;  // null: this material is isotropic
};

}  // namespace

MaterialPtr principled_lobes(const PrincipledShape& shape, std::vector<double> color,
                             const PrincipledMix& mix) {
    return std::make_shared<PrincipledLobes>(shape, std::move(color), mix);
}

}  // namespace nicol
