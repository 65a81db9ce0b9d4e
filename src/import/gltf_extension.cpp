// SPDX-License-Identifier: MIT
#include "import/gltf_extension.hpp"

#include <cmath>
#include <utility>

namespace nicol::scene {
namespace {

bool is_finite_number(const tinygltf::Value& value) {
    return value.IsNumber() && std::isfinite(value.GetNumberAsDouble());
}

}  // namespace

GltfExtension::GltfExtension(const GltfDocument& document, const tinygltf::ExtensionMap& extensions,
                             const char* name, std::string where)
    : document_(document), where_(std::move(where)) {
    const auto found = extensions.find(name);
    if (found != extensions.end()) value_ = &found->second;
}

double GltfExtension::number(const char* name, double otherwise) const {
    const tinygltf::Value* const value = find(name);
    if (value == nullptr) return otherwise;
    if (!is_finite_number(*value)) document_.fail(where_, std::string(name) + " is not a finite number");
    return value->GetNumberAsDouble();
}

double GltfExtension::number(const char* name, double otherwise, double least, double most) const {
    return document_.in_range(number(name, otherwise), least, most, where_, name);
}

std::vector<double> GltfExtension::numbers(const char* name, std::size_t count) const {
    const tinygltf::Value* const value = find(name);
    std::vector<double> out;
    if (value == nullptr) return out;
    for (std::size_t i = 0; i < value->ArrayLen(); ++i)
        if (const tinygltf::Value& element = value->Get(static_cast<int>(i)); is_finite_number(element))
            out.push_back(element.GetNumberAsDouble());
    if (out.size() != count || value->ArrayLen() != count)
        document_.fail(
            where_, std::string(name) + " is not an array of " + std::to_string(count) + " finite numbers");
    return out;
}

GltfTextureUse GltfExtension::texture(const char* name) const {
    static const tinygltf::ExtensionMap kNone;
    const tinygltf::Value* const info = find(name);
    const auto whole = [&](const char* member, int otherwise) {
        if (info == nullptr || !info->Has(member)) return otherwise;
        const tinygltf::Value& value = info->Get(member);
        if (!value.IsInt())
            document_.fail(where_, std::string(name) + ": " + member + " is not a whole number");
        return value.GetNumberAsInt();
    };
    GltfTextureUse out{.index = whole("index", -1),
                       .texcoord_set = whole("texCoord", 0),
                       .extensions = &kNone,
                       .where = where_ + "." + name};
    if (info != nullptr && info->Has("extensions") && info->Get("extensions").IsObject())
        out.extensions = &info->Get("extensions").Get<tinygltf::Value::Object>();
    return out;
}

const tinygltf::Value* GltfExtension::find(const char* name) const {
    return value_ != nullptr && value_->Has(name) ? &value_->Get(name) : nullptr;
}

}  // namespace nicol::scene
