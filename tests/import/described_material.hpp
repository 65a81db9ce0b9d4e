// SPDX-License-Identifier: MIT
// Access to the materials that scene files describe, for tests.
#pragma once

#include "import/coated_model.hpp"
#include "import/conductor_material.hpp"
#include "import/diffuse_material.hpp"
#include "import/gltf_models.hpp"
#include "import/late_parameters.hpp"
#include "import/nested_material.hpp"
#include "import/tabulated_material.hpp"
#include "material/plastic.hpp"
#include "material/principled.hpp"
#include "test.hpp"

using namespace nicol::scene;

using PplasticModel = ModelOf<nicol::PplasticParameters>;
using PlasticModel = ModelOf<nicol::PlasticParameters>;
using PrincipledModel = ModelOf<nicol::PrincipledParameters>;

template <class Model>
bool is(const nicol::MaterialDescription& material) {
    return dynamic_cast<const Model*>(material.model.get()) != nullptr;
}

/// A copy of the model, which must be of this type.
template <class Model>
Model as(const nicol::MaterialDescription& material) {
    REQUIRE(is<Model>(material));
    return dynamic_cast<const Model&>(*material.model);
}

template <class P>
nicol::TexturedColor color(const LateParameters<P>& model, nicol::ColorParameter P::*parameter) {
    for (const auto& [of, color] : model.colors)
        if (of == parameter) return color;
    FAIL("no colour was read");
    return 0.0;
}

template <class P>
nicol::TexturedNumber number(const LateParameters<P>& model, nicol::NumberParameter P::*parameter) {
    for (const auto& [of, number] : model.textured_numbers)
        if (of == parameter) return number;
    return (model.parameters.*parameter).value;
}
