// SPDX-License-Identifier: MIT
// Numbers in the buffers of a glTF file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "import/gltf_document.hpp"

namespace nicol::scene {

/// Elements of one accessor, dense or sparse. All data of the accessor lies within the buffers, and an
/// accessor without data has no more elements than the buffers have bytes. Refers to the document.
class GltfAccessor {
public:
    /// Throws Error(invalid_file) that begins with the file and `where`, the name of the user of the
    /// accessor.
    GltfAccessor(const GltfDocument& document, int index, const std::string& where);

    [[nodiscard]] std::size_t count() const { return accessor_->count; }
    /// Returns the number of components of an element: 1 to 4, or those of a matrix.
    [[nodiscard]] std::size_t components() const { return components_; }
    /// Returns whether components are floats, or integers that stand for 0 to 1 or -1 to 1.
    [[nodiscard]] bool is_real() const;
    [[nodiscard]] bool is_unsigned() const;
    /// Returns component `c` of element `i`, both in range.
    [[nodiscard]] double number(std::size_t i, std::size_t c) const;

private:
    struct Elements {
        const unsigned char* first = nullptr;  ///< null: all zero
        std::size_t stride = 0;
        int type = 0;  ///< type of a component
    };
    [[nodiscard]] Elements elements(int view, std::size_t offset, std::size_t count, int type,
                                    std::size_t components) const;
    void read_sparse();

    const GltfDocument* document_;
    std::string where_;
    const tinygltf::Accessor* accessor_;
    std::size_t components_;
    Elements dense_;
    Elements sparse_indices_;  ///< ascending
    Elements sparse_values_;
    std::size_t sparse_count_ = 0;
};

}  // namespace nicol::scene
