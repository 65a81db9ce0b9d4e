// SPDX-License-Identifier: MIT
#include "material/principled_lobes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "material/key.hpp"
#include "material/principled_values.hpp"
#include "material/reflectance.hpp"
#include "material/shared_terms.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

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
