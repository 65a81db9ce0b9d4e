// SPDX-License-Identifier: MIT
// Values of an extension in a glTF file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "import/gltf_document.hpp"
#include "import/gltf_textures.hpp"

namespace nicol::scene {

/// One extension of one element. The functions throw Error(invalid_file), which names the element and the
/// value, for values of another type.
class GltfExtension {
public:
    /// The document and `extensions`, those of the element `where`, must outlive this.
    GltfExtension(const GltfDocument& document, const tinygltf::ExtensionMap& extensions, const char* name,
                  std::string where);

    /// Returns whether the element has the extension.
    [[nodiscard]] bool present() const { return value_ != nullptr; }
    /// Returns a finite number, or `otherwise` if the extension does not give it.
    [[nodiscard]] double number(const char* name, double otherwise) const;
    /// Returns number(), which must lie in least to most.
    [[nodiscard]] double number(const char* name, double otherwise, double least, double most) const;
    /// Returns an array of `count` finite numbers; empty if the extension does not give it.
    [[nodiscard]] std::vector<double> numbers(const char* name, std::size_t count) const;
    /// Returns the use of a texture, with the index -1 if the extension does not give it.
    [[nodiscard]] GltfTextureUse texture(const char* name) const;

private:
    [[nodiscard]] const tinygltf::Value* find(const char* name) const;

    const GltfDocument& document_;
    std::string where_;
    const tinygltf::Value* value_ = nullptr;  ///< null: the element lacks the extension
};

}  // namespace nicol::scene
