// SPDX-License-Identifier: MIT
// Materials as a scene file describes them, before the channels of its light are known.
#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <utility>

#include "material/material.hpp"

namespace nicol {

struct MaterialMaker;

/// A reflectance model with its parameters, or a material made of others.
class MaterialModel {
public:
    virtual ~MaterialModel() = default;

    /// Throws what reading the model's files and the functions of src/material throw, and Error(unsupported)
    /// for colours that the scene's channels cannot have.
    [[nodiscard]] virtual MaterialPtr make(const MaterialMaker& maker) const = 0;

    /// Whether the model reflects nothing whatever the channels are.
    [[nodiscard]] virtual bool black() const { return false; }
};

struct MaterialDescription {
    template <std::derived_from<MaterialModel> Model>
    MaterialDescription(Model of) : model(std::make_shared<const Model>(std::move(of))) {}

    std::string id;                              ///< id of the outermost bsdf; empty when the file gives none
    bool twosided = false;                       ///< the back reflects as the front does
    std::shared_ptr<const MaterialModel> model;  ///< not null
};

}  // namespace nicol
