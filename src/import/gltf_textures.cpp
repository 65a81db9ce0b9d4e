// SPDX-License-Identifier: MIT
#include "import/gltf_textures.hpp"

#include <charconv>
#include <cmath>
#include <glm/vec2.hpp>
#include <string_view>
#include <utility>

namespace nicol::scene {
namespace {

using Filter = TextureSampling::Filter;
using Wrap = TextureSampling::Wrap;

std::string element(const char* list, int index) {
    return list + ("[" + std::to_string(index) + "]");
}

/// With %20 and the like replaced.
std::string decoded(std::string_view uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char code = 0;
        const char* const digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
            out += static_cast<char>(code);
            i += 2;
        } else {
            out += uri[i];
        }
    }
    return out;
}

Wrap wrap_of(int mode) {
    switch (mode) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Wrap::clamp;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Wrap::mirror;
        default:
            return Wrap::repeat;
    }
}

/// Without a filter the choice is ours.
Filter filter_of(const tinygltf::Sampler& sampler) {
    if (sampler.minFilter == -1 || sampler.minFilter >= TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST)
        return Filter::mipmap;
    return sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::nearest : Filter::bilinear;
}

const tinygltf::Value* transform_of(const GltfTextureUse& use) {
    const auto found = use.extensions->find("KHR_texture_transform");
    return found == use.extensions->end() ? nullptr : &found->second;
}

/// The values of KHR_texture_transform.
class Transform {
public:
    Transform(const GltfDocument& document, const GltfTextureUse& use, const tinygltf::Value& value)
        : document_(document), where_(use.where + ".KHR_texture_transform"), value_(value) {}

    /// The file's rotation is counter-clockwise as an image is seen, whose v points down.
    [[nodiscard]] glm::dmat3 matrix() const {
        const glm::dvec2 offset = pair("offset", 0), scale = pair("scale", 1);
        const double angle = value_.Has("rotation") ? number(value_.Get("rotation"), "rotation") : 0;
        const double c = std::cos(angle), s = std::sin(angle);
        return {c * scale.x, -s * scale.x, 0, s * scale.y, c * scale.y, 0, offset.x, offset.y, 1};
    }

private:
    [[nodiscard]] glm::dvec2 pair(const char* name, double otherwise) const {
        if (!value_.Has(name)) return glm::dvec2(otherwise);
        const tinygltf::Value& both = value_.Get(name);
        if (!both.IsArray() || both.ArrayLen() != 2)
            document_.fail(where_, std::string(name) + " is not an array of two numbers");
        return {number(both.Get(0), name), number(both.Get(1), name)};
    }
    [[nodiscard]] double number(const tinygltf::Value& value, const char* name) const {
        constexpr double most = 1e6;
        const double number = value.IsNumber() ? value.GetNumberAsDouble() : 2 * most;
        if (!(std::abs(number) <= most))
            document_.fail(where_, std::string(name) + " is not made of numbers from -1e6 to 1e6");
        return number;
    }

    const GltfDocument& document_;
    std::string where_;
    const tinygltf::Value& value_;
};

}  // namespace

std::optional<TextureSpecification> GltfTextures::read(const GltfTextureUse& use) {
    if (use.index < 0) return std::nullopt;
    const tinygltf::Texture& texture =
        document_.at(document_.model().textures, "textures", use.index, use.where);
    if (texture.source < 0) {
        notices_.add("textures without a PNG or JPEG image are not followed");
        return std::nullopt;
    }
    TextureSpecification out;
    out.kind = TextureSpecification::Kind::image;
    const std::string where = element("textures", use.index);
    read_image(texture.source, where, out);
    out.sampling = sampling(texture.sampler, where);
    if (const tinygltf::Value* transform = transform_of(use))
        out.sampling.to_uv = Transform(document_, use, *transform).matrix();
    return out;
}

int GltfTextures::texcoord_set(const GltfTextureUse& use) const {
    const tinygltf::Value* const transform = transform_of(use);
    if (transform == nullptr || !transform->Has("texCoord")) return use.texcoord_set;
    const tinygltf::Value& value = transform->Get("texCoord");
    if (!value.IsInt()) document_.fail(use.where, "KHR_texture_transform: texCoord is not a whole number");
    return value.GetNumberAsInt();
}

TextureSampling GltfTextures::sampling(int sampler, const std::string& where) {
    TextureSampling out{.filter = Filter::mipmap};
    if (sampler < 0) return out;
    const tinygltf::Sampler& of = document_.at(document_.model().samplers, "samplers", sampler, where);
    out.filter = filter_of(of);
    out.wrap = wrap_of(of.wrapS);
    if (of.wrapT != of.wrapS)
        notices_.add("a sampler with wrapT other than its wrapS is not followed; wrapS counts for both");
    return out;
}

void GltfTextures::read_image(int index, const std::string& where, TextureSpecification& out) {
    const tinygltf::Image& image = document_.at(document_.model().images, "images", index, where);
    if (image.uri.empty()) {
        out.filename = document_.path().string() + ": " + element("images", index);
        out.bytes = embedded(index);
    } else {
        out.filename = gltf_file(document_.path(), decoded(image.uri), "an image");
    }
}

std::shared_ptr<const std::string> GltfTextures::embedded(int index) {
    std::shared_ptr<const std::string>& bytes = embedded_[index];
    if (bytes) return bytes;
    const tinygltf::Image& image = document_.model().images[static_cast<std::size_t>(index)];
    if (image.bufferView < 0) {
        bytes = std::make_shared<const std::string>(image.image.begin(), image.image.end());
        return bytes;
    }
    const std::string where = element("images", index);
    const tinygltf::BufferView& view =
        document_.at(document_.model().bufferViews, "bufferViews", image.bufferView, where);
    const std::vector<unsigned char>& data =
        document_.at(document_.model().buffers, "buffers", view.buffer, where).data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        document_.fail(where, "leads beyond the buffer's " + std::to_string(data.size()) + " bytes");
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
    bytes = std::make_shared<const std::string>(first, first + static_cast<std::ptrdiff_t>(view.byteLength));
    return bytes;
}

}  // namespace nicol::scene
