// SPDX-License-Identifier: MIT
#include "material/principled.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string_view>
#include <utility>

#include "material/dielectric.hpp"
#include "material/mixture.hpp"
#include "material/principled_lobes.hpp"
#include "material/reflectance.hpp"
#include "material/textured.hpp"

namespace nicol {
namespace {

using P = PrincipledParameters;
using Kind = PrincipledLobe;

struct Number {
    std::string_view name;
    NumberParameter P::*parameter;
};
constexpr Number kRoughness{"roughness", &P::roughness};
constexpr Number kAnisotropic{"anisotropic", &P::anisotropic};
constexpr Number kMetallic{"metallic", &P::metallic};
constexpr Number kSpecTrans{"spec_trans", &P::spec_trans};
constexpr Number kSpecTint{"spec_tint", &P::spec_tint};
constexpr Number kSheen{"sheen", &P::sheen};
constexpr Number kSheenTint{"sheen_tint", &P::sheen_tint};
constexpr Number kFlatness{"flatness", &P::flatness};
constexpr Number kClearcoat{"clearcoat", &P::clearcoat};
constexpr Number kClearcoatGloss{"clearcoat_gloss", &P::clearcoat_gloss};

/// Number on which lobes do not depend linearly.
struct ShapeNumber {
    Number number;
    double PrincipledShape::*value;
    Kind first, last;  ///< range of the lobes that depend on the number
    /// Arguments of with_number(). Those of roughness match with_roughness() for alpha = roughness^2.
    double least, ratio;
};
constexpr ShapeNumber kShapeNumbers[] = {
    {kRoughness, &PrincipledShape::roughness, Kind::diffuse, Kind::dielectric, 0.1, 1.1},
    {kAnisotropic, &PrincipledShape::anisotropic, Kind::metal, Kind::dielectric, 0.01, 1.2},
    {kClearcoatGloss, &PrincipledShape::clearcoat_gloss, Kind::clearcoat, Kind::clearcoat, 0.01, 1.2}};

/// Number, or 1 - number if `rest` is true.
struct Factor {
    Number number;
    bool rest = false;
};
constexpr Factor rest_of(const Number& number) {
    return {number, true};
}

enum class Color { white, base, tint };

/// Lobe times a colour and factors.
struct Product {
    Kind lobe;
    Color color;
    std::vector<Factor> factors;
};

/// Returns the products whose sum is the model.
const std::vector<Product>& products() {
    static const std::vector<Product> all = {
        {Kind::diffuse, Color::base, {rest_of(kMetallic), rest_of(kSpecTrans), rest_of(kFlatness)}},
        {Kind::subsurface, Color::base, {rest_of(kMetallic), rest_of(kSpecTrans), {kFlatness}}},
        {Kind::sheen, Color::white, {{kSheen}, rest_of(kMetallic), rest_of(kSheenTint)}},
        {Kind::sheen, Color::tint, {{kSheen}, rest_of(kMetallic), {kSheenTint}}},
        {Kind::metal, Color::base, {{kMetallic}}},
        {Kind::edge, Color::white, {{kMetallic}}},
        {Kind::tinted, Color::tint, {rest_of(kMetallic), {kSpecTint}}},
        {Kind::edge, Color::white, {rest_of(kMetallic), {kSpecTint}}},
        {Kind::dielectric, Color::white, {rest_of(kMetallic), rest_of(kSpecTint)}},
        {Kind::clearcoat, Color::white, {{kClearcoat}}}};
    return all;
}

double luminance(const std::vector<double>& color) {
    if (color.size() == 3) return 0.212671 * color[0] + 0.715160 * color[1] + 0.072169 * color[2];
    double sum = 0;
    for (const double value : color) sum += value;
    return sum / static_cast<double>(color.size());
}

/// Lobes that vary by the same textures: one layer, or the layers that with_number() makes of it.
struct Part {
    struct Scale {
        LayerFactor::Kind kind;
        TexturePtr texture;
        bool operator==(const Scale&) const = default;
    };
    std::vector<Scale> scales;
    std::vector<const ShapeNumber*> shape;  ///< numbers that textures give
    PrincipledMix mix;
};

class Composer {
public:
    explicit Composer(P parameters) : p_(std::move(parameters)) {
        // A constant texture becomes a number.
        for (const Number& n : {kRoughness, kAnisotropic, kMetallic, kSpecTrans, kSpecTint, kSheen,
                                kSheenTint, kFlatness, kClearcoat, kClearcoatGloss}) {
            NumberParameter& number = p_.*n.parameter;
            if (number.texture && number.texture->constant())
                number = std::clamp(static_cast<double>(number.texture->mean().x), 0.0, 1.0);
            if (!number.texture) check_range(number.value, 0, 1, n.name);
        }
        const TexturePtr color = p_.base_color.texture;
        if (color && color->constant()) {
            const glm::vec4 mean = color->mean();
            p_.base_color = {mean.x, mean.y, mean.z};
            if (color->channels() == 1) p_.base_color.values.resize(1);
        } else {
            check_reflectance(p_.base_color.values, "base_color");
        }
        check_range(p_.eta, 1e-3, 1e3, "eta");
        shape_ = {.roughness = p_.roughness.value,
                  .anisotropic = p_.anisotropic.value,
                  .eta = p_.eta,
                  .clearcoat_gloss = p_.clearcoat_gloss.value};
    }

    MaterialPtr run() {
        for (const Product& product : products()) add(product);
        // A black material has no parts.
        if (parts_.empty()) return diffuse({0});
        MaterialPtr out;
        for (const Part& part : parts_) {
            const MaterialPtr material = of(part);
            out = out ? sum(out, material) : material;
        }
        return out;
    }

private:
    void add(const Product& product) {
        if (p_.eta == 1 && product.lobe >= Kind::metal && product.lobe <= Kind::dielectric) return;
        Part part;
        double amount = 1;
        for (const auto& [number, rest] : product.factors) {
            const auto& [value, texture] = p_.*number.parameter;
            if (texture)
                part.scales.push_back(
                    {rest ? LayerFactor::Kind::complement : LayerFactor::Kind::fraction, texture});
            else
                amount *= rest ? 1 - value : value;
        }
        if (amount == 0) return;
        const bool colored = multiply(product.color, part, amount);
        for (const ShapeNumber& n : kShapeNumbers)
            if ((p_.*n.number.parameter).texture && product.lobe >= n.first && product.lobe <= n.last)
                part.shape.push_back(&n);

        auto same = std::ranges::find_if(parts_, [&](const Part& other) {
            return other.scales == part.scales && other.shape == part.shape;
        });
        if (same == parts_.end()) same = parts_.insert(parts_.end(), std::move(part));
        (colored ? same->mix.colored : same->mix.white)[index(product.lobe)] += amount;
    }

    /// Multiplies a part or its amount by a colour. Returns whether base_color multiplies the amount.
    bool multiply(Color color, Part& part, double& amount) {
        if (color == Color::white) return false;
        if (const TexturePtr& base = p_.base_color.texture) {
            if (color == Color::tint && !tint_) tint_ = tint_texture(base);
            part.scales.push_back({LayerFactor::Kind::value, color == Color::base ? base : tint_});
            return false;
        }
        if (color == Color::base) return true;
        const double light = luminance(p_.base_color.values);
        if (light > 0) amount /= light;
        return light > 0;
    }

    [[nodiscard]] MaterialPtr of(const Part& part) const {
        MaterialPtr out = shaped(part.mix, shape_, part.shape);
        for (const auto& [kind, texture] : part.scales) out = scaled_by(kind, out, texture);
        return out;
    }

    [[nodiscard]] MaterialPtr shaped(const PrincipledMix& mix, const PrincipledShape& shape,
                                     std::span<const ShapeNumber* const> varying) const {
        if (varying.empty()) return principled_lobes(shape, factor(p_.base_color).values, mix);
        const ShapeNumber& n = *varying.front();
        return with_number(
            [&](double value) {
                PrincipledShape at = shape;
                at.*n.value = value;
                return shaped(mix, at, varying.subspan(1));
            },
            (p_.*n.number.parameter).texture, n.least, n.ratio);
    }

    P p_;
    TexturePtr tint_;
    PrincipledShape shape_;
    std::vector<Part> parts_;
};

// Least roughness of facets, and an index that stands for 1, as in Mitsuba.
constexpr double kLeastFacetAlpha = 0.001;
constexpr double kNearlyOne = 1.001;

/// Returns the diffuse base and the sheen of a sheet.
MaterialPtr principled_base(const PrincipledThinParameters& p) {
    MaterialPtr base = Composer({.base_color = p.base_color,
                                 .roughness = p.roughness,
                                 .spec_trans = mean_of(p.spec_trans, 0),
                                 .eta = 1,
                                 .sheen = p.sheen,
                                 .sheen_tint = p.sheen_tint,
                                 .flatness = p.flatness})
                           .run();
    if (p.diff_trans == 0) return base;
    return scaled(base, constant_texture(glm::vec4(static_cast<float>(1 - p.diff_trans / 2)), 1));
}

/// Returns the boundary that transmits a share of the light.
SmoothBoundary boundary_of(double eta, const NumberParameter& roughness, double share,
                           std::vector<double> color) {
    const double mean = mean_of(roughness, 0);
    for (double& value : color) value *= share;
    return {.eta = eta == 1 ? kNearlyOne : eta,
            .reflectance = {share},
            .transmittance = std::move(color),
            .alpha = std::max(mean * mean, kLeastFacetAlpha),
            .distribution = Distribution::ggx};
}

}  // namespace

MaterialPtr principled(const PrincipledParameters& parameters) {
    MaterialPtr reflection = Composer(parameters).run();
    const double share = (1 - mean_of(parameters.metallic, 0)) * mean_of(parameters.spec_trans, 0);
    if (share == 0 || !parameters.transmits) return reflection;
    std::vector<double> color = mean_of(parameters.base_color);
    for (double& value : color) value = std::sqrt(value);
    return transmitting(std::move(reflection),
                        boundary_of(parameters.eta, parameters.roughness, share, std::move(color)));
}

MaterialPtr principled_thin(const PrincipledThinParameters& p) {
    check_range(p.diff_trans, 0, 2, "diff_trans");
    MaterialPtr base = principled_base(p);
    const double share = mean_of(p.spec_trans, 0);
    if (share == 0) return base;
    SmoothBoundary sheet = boundary_of(p.eta, p.roughness, share, mean_of(p.base_color));
    sheet.behind = SmoothBoundary::Behind::slab;
    const MaterialPtr reflection = sum(base, rough_reflection(sheet, sheet.alpha));
    // Two refractions bend light less than a reflection does. Burley's roughness of what is transmitted.
    const double narrowing = std::clamp(0.65 * p.eta - 0.35, 0.0, 1.0);
    sheet.alpha = std::max(sheet.alpha * narrowing * narrowing, kLeastFacetAlpha);
    return transmitting(reflection, sheet);
}

double index_of_specular(double specular) {
    return 2 / (1 - std::sqrt(0.08 * specular)) - 1;
}

}  // namespace nicol
