// SPDX-License-Identifier: MIT
#include "import/gltf_accessor.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace nicol::scene {
namespace {

template <class Number>
double number_at(const unsigned char* bytes) {
    Number value{};
    std::memcpy(&value, bytes, sizeof(Number));
    return static_cast<double>(value);
}

double number_of(const unsigned char* bytes, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return number_at<std::int8_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return number_at<std::uint8_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return number_at<std::int16_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return number_at<std::uint16_t>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return number_at<std::uint32_t>(bytes);
        default:
            return number_at<float>(bytes);
    }
}

/// 0 for types that glTF does not have.
std::size_t size_of(int type) {
    if (type == TINYGLTF_COMPONENT_TYPE_INT || type == TINYGLTF_COMPONENT_TYPE_DOUBLE) return 0;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
    return size < 0 ? 0 : static_cast<std::size_t>(size);
}

/// Returns the integer of a type that stands for 1 if integers stand for real numbers.
double one_of(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return 127;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 255;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return 32767;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 65535;
        default:
            return 1;
    }
}

}  // namespace

GltfAccessor::GltfAccessor(const GltfDocument& document, int index, const std::string& where)
    : document_(&document),
      where_(where + ": accessors[" + std::to_string(index) + "]"),
      accessor_(&document.at(document.model().accessors, "accessors", index, where)),
      components_(static_cast<std::size_t>(
          tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor_->type)))) {
    if (accessor_->count == 0) document_->fail(where_, "count is 0; expected at least 1");
    dense_.type = accessor_->componentType;
    if (size_of(dense_.type) == 0)
        document_->fail(where_, "componentType is " + std::to_string(dense_.type) +
                                    "; expected 5120 to 5123, 5125 or 5126");
    if (accessor_->bufferView >= 0)
        dense_ = elements(accessor_->bufferView, accessor_->byteOffset, accessor_->count, dense_.type,
                          components_);
    else if (accessor_->count > document_->buffer_bytes())
        document_->fail(where_, "has no bufferView and " + std::to_string(accessor_->count) +
                                    " elements, more than the buffers have bytes");
    if (accessor_->sparse.isSparse) read_sparse();
}

GltfAccessor::Elements GltfAccessor::elements(int view, std::size_t offset, std::size_t count, int type,
                                              std::size_t components) const {
    const tinygltf::Model& model = document_->model();
    const tinygltf::BufferView& bytes = document_->at(model.bufferViews, "bufferViews", view, where_);
    const std::string name = where_ + ": bufferViews[" + std::to_string(view) + "]";
    const tinygltf::Buffer& buffer = document_->at(model.buffers, "buffers", bytes.buffer, name);
    if (bytes.byteOffset > buffer.data.size() || bytes.byteLength > buffer.data.size() - bytes.byteOffset)
        document_->fail(name, "byteOffset " + std::to_string(bytes.byteOffset) + " and byteLength " +
                                  std::to_string(bytes.byteLength) + " lead beyond the buffer's " +
                                  std::to_string(buffer.data.size()) + " bytes");
    const std::size_t size = size_of(type) * components;
    const std::size_t stride = bytes.byteStride == 0 ? size : bytes.byteStride;
    if (stride < size)
        document_->fail(name, "byteStride " + std::to_string(stride) + " is less than the " +
                                  std::to_string(size) + " bytes of an element");
    const bool fits = offset <= bytes.byteLength && size <= bytes.byteLength - offset &&
                      count - 1 <= (bytes.byteLength - offset - size) / stride;
    if (!fits)
        document_->fail(where_, std::to_string(count) + " elements of " + std::to_string(size) +
                                    " bytes from byteOffset " + std::to_string(offset) + " lead beyond the " +
                                    std::to_string(bytes.byteLength) + " bytes of bufferViews[" +
                                    std::to_string(view) + "]");
    return {buffer.data.data() + bytes.byteOffset + offset, stride, type};
}

void GltfAccessor::read_sparse() {
    const auto& sparse = accessor_->sparse;
    if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > accessor_->count)
        document_->fail(where_, "sparse.count is " + std::to_string(sparse.count) + "; expected 1 to " +
                                    std::to_string(accessor_->count));
    const int type = sparse.indices.componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
        document_->fail(where_, "sparse.indices.componentType is " + std::to_string(type) +
                                    "; expected 5121, 5123 or 5125");
    sparse_count_ = static_cast<std::size_t>(sparse.count);
    sparse_indices_ = elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                               sparse_count_, type, 1);
    sparse_values_ = elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                              sparse_count_, dense_.type, components_);
    double last = -1;
    for (std::size_t i = 0; i < sparse_count_; ++i) {
        const double index = number_of(sparse_indices_.first + i * sparse_indices_.stride, type);
        if (index <= last || index >= static_cast<double>(accessor_->count))
            document_->fail(where_, "sparse.indices must ascend and lie below " +
                                        std::to_string(accessor_->count) + "; number " + std::to_string(i) +
                                        " does not");
        last = index;
    }
}

bool GltfAccessor::is_real() const {
    return dense_.type == TINYGLTF_COMPONENT_TYPE_FLOAT || accessor_->normalized;
}

bool GltfAccessor::is_unsigned() const {
    return dense_.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           dense_.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           dense_.type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

double GltfAccessor::number(std::size_t i, std::size_t c) const {
    const Elements* source = &dense_;
    std::size_t element = i;
    // Sparse indices are sorted.
    std::size_t low = 0, high = sparse_count_;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        const double index =
            number_of(sparse_indices_.first + middle * sparse_indices_.stride, sparse_indices_.type);
        if (index == static_cast<double>(i)) {
            source = &sparse_values_;
            element = middle;
            break;
        }
        if (index < static_cast<double>(i))
            low = middle + 1;
        else
            high = middle;
    }
    if (source->first == nullptr) return 0;
    const unsigned char* bytes = source->first + element * source->stride + c * size_of(source->type);
    const double value = number_of(bytes, source->type);
    return accessor_->normalized ? std::max(value / one_of(source->type), -1.0) : value;
}

}  // namespace nicol::scene
