// SPDX-License-Identifier: MIT
// Parameters of reflectance models whose colours and textures are made once the channels of the light are
// known.
#pragma once

#include <utility>
#include <vector>

#include "import/material_maker.hpp"

namespace nicol::scene {

/// The parameters of a model, P of src/material, as a scene file gives them.
template <class P>
struct LateParameters {
    P parameters;  ///< all but the colours and the textures below
    std::vector<std::pair<ColorParameter P::*, TexturedColor>> colors;
    std::vector<std::pair<NumberParameter P::*, TexturedNumber>> textured_numbers;

    void set(ColorParameter P::*parameter, const TexturedColor& color) {
        colors.emplace_back(parameter, color);
    }
    void set(NumberParameter P::*parameter, const TexturedNumber& number) {
        parameters.*parameter = number.value;
        if (number.texture) textured_numbers.emplace_back(parameter, number);
    }

    /// Throws as MaterialModel::make().
    [[nodiscard]] P with(const MaterialMaker& maker) const {
        P out = parameters;
        for (const auto& [parameter, color] : colors) out.*parameter = maker.color(color);
        for (const auto& [parameter, number] : textured_numbers) out.*parameter = maker.number(number);
        if constexpr (requires { out.film.wavelengths; }) out.film = film_in(out.film, maker.channels);
        return out;
    }
};

/// A model that a function of src/material makes from P alone.
template <class P>
class ModelOf final : public MaterialModel, public LateParameters<P> {
public:
    using Make = MaterialPtr (*)(const P&);
    explicit ModelOf(Make make) : make_(make) {}

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override {
        return make_(this->with(maker));
    }

private:
    Make make_;
};

/// Facets of a rough surface.
struct FacetDescription {
    Distribution distribution;
    TexturedNumber alpha;
    TexturedNumber alpha_v = 0.0;  ///< roughness along v, where alpha is along u; 0: as alpha
};

template <class P>
void set_facets(const FacetDescription& facets, LateParameters<P>& out) {
    out.parameters.distribution = facets.distribution;
    out.set(&P::alpha, facets.alpha);
    if constexpr (requires { &P::alpha_v; }) out.set(&P::alpha_v, facets.alpha_v);
}

}  // namespace nicol::scene
