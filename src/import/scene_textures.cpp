// SPDX-License-Identifier: MIT
#include "import/scene_textures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <utility>

#include "error.hpp"
#include "geometry/mesh.hpp"

namespace nicol::scene {
namespace {

using Part = TextureSpecification::Part;

float luminance(const glm::vec3& rgb) {
    return glm::dot(rgb, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

/// The pixels of an image that a texture is made of, with what it does to them.
class Pixels {
public:
    Pixels(const ImagePixels& image, const TextureSpecification& description)
        : image_(image), description_(description) {}

    [[nodiscard]] TextureImage colors() const {
        if (image_.channels() != 1 || !is_grey(description_)) return vectors();
        return made<1>([](const glm::vec3& value, float* out) { *out = value.x; });
    }

    /// Returns three channels, also of a grey image.
    [[nodiscard]] TextureImage vectors() const {
        return made<3>([](const glm::vec3& value, float* out) {
            out[0] = value.x;
            out[1] = value.y;
            out[2] = value.z;
        });
    }

    [[nodiscard]] TextureImage numbers() const {
        const bool one = image_.channels() == 1 || description_.part != Part::color;
        return made<1>(
            [one](const glm::vec3& value, float* out) { *out = one ? value.x : luminance(value); });
    }

private:
    static bool is_grey(const TextureSpecification& d) {
        return d.factor == glm::dvec3(d.factor.x) && d.offset == glm::dvec3(d.offset.x);
    }

    [[nodiscard]] glm::vec3 part(std::size_t pixel) const {
        const glm::vec4 all = image_.at(pixel);
        switch (description_.part) {
            case Part::color:
                break;
            case Part::red:
                return glm::vec3(all.x);
            case Part::green:
                return glm::vec3(all.y);
            case Part::blue:
                return glm::vec3(all.z);
            case Part::coverage:
                return glm::vec3(all.w);
        }
        return all;
    }

    /// Returns the image of what put(value, values) makes of each pixel's value.
    template <int channels, class Put>
    [[nodiscard]] TextureImage made(const Put& put) const {
        constexpr std::size_t grain = 1U << 14U;
        TextureImage out{
            .width = image_.width(), .height = image_.height(), .channels = channels, .values = {}};
        out.values.reserve(image_.count() * channels + 1);  // image_texture() appends one
        out.values.resize(image_.count() * channels);
        const glm::vec3 factor(description_.factor), offset(description_.offset);
        using Range = tbb::blocked_range<std::size_t>;
        tbb::parallel_for(Range(0, image_.count(), grain), [&](const Range& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                glm::vec3 value = factor * part(i) + offset;
                if (description_.clamped) value = glm::clamp(value, 0.0F, 1.0F);
                if (description_.squared) value *= value;
                put(value, &out.values[i * channels]);
            }
        });
        return out;
    }

    const ImagePixels& image_;
    const TextureSpecification& description_;
};

/// With one channel where the three are equal in all pixels.
TextureImage without_repetition(TextureImage image) {
    if (image.channels != 3) return image;
    const std::size_t size = image.values.size();
    for (std::size_t i = 0; i < size; i += 3)
        if (image.values[i] != image.values[i + 1] || image.values[i] != image.values[i + 2]) return image;
    for (std::size_t i = 0; i < size; i += 3) image.values[i / 3] = image.values[i];
    image.values.resize(size / 3);
    image.channels = 1;
    return image;
}

}  // namespace

TexturePtr SceneTextures::color(const TextureSpecification& description) {
    return of(description, Use::color);
}

TexturePtr SceneTextures::number(const TextureSpecification& description) {
    return of(description, Use::number);
}

TexturePtr SceneTextures::number_of_color(const TextureSpecification& description) {
    if (description.kind != TextureSpecification::Kind::checkerboard) return number(description);
    TextureSpecification swapped = description;
    std::swap(swapped.color0, swapped.color1);
    return number(swapped);
}

bool SceneTextures::colored(const TextureSpecification& d) {
    const auto of_value = [](const ColorDescription& color) {
        return color.spectrum.empty() && color.rgb != glm::dvec3(color.rgb.x);
    };
    if (d.kind == TextureSpecification::Kind::constant) return of_value(d.color0);
    if (d.kind == TextureSpecification::Kind::checkerboard) return of_value(d.color0) || of_value(d.color1);
    return d.part == Part::color &&
           without_repetition(Pixels(images_.at({d.filename, d.raw}), d).colors()).channels == 3;
}

TexturePtr SceneTextures::vector(const TextureSpecification& description) {
    return of(description, Use::vector);
}

double SceneTextures::aspect(const TextureSpecification& d) const {
    if (d.kind != TextureSpecification::Kind::image) return 1;
    const ImagePixels& image = images_.at({d.filename, d.raw});
    return static_cast<double>(image.width()) / image.height();
}

TexturePtr SceneTextures::of(const TextureSpecification& description, Use use) {
    const bool of_shape = in_place_of_attribute(description) != nullptr;
    if (description.times_colors_of && !of_shape) need_attribute(description, use);
    if (of_shape || description.kind != TextureSpecification::Kind::image) return made(description, use);
    std::vector<Made>& made_of_file = made_[description.filename];
    for (const Made& known : made_of_file)
        if (known.use == use && known.description == description) return known.texture;
    TexturePtr texture = made(description, use);
    made_of_file.push_back({description, use, texture});
    return texture;
}

glm::vec4 SceneTextures::value(const ColorDescription& color, Use use) const {
    if (use == Use::vector && color.spectrum.empty()) return {color.rgb, 1};
    const std::vector<double> values = reflectance(color, use == Use::color ? channels_ : SceneChannels());
    if (values.size() > 3)
        throw Error(ErrorCode::unsupported,
                    "a <spectrum> table in a texture under light of wavelengths; give one grey value");
    const glm::vec3 rgb(values[0], values[values.size() == 3 ? 1 : 0], values[values.size() == 3 ? 2 : 0]);
    return {use == Use::number ? glm::vec3(luminance(rgb)) : rgb, 1};
}

TexturePtr SceneTextures::made(const TextureSpecification& d, Use use) {
    const auto channels_of = [](const glm::vec4& a) { return a.x == a.y && a.y == a.z ? 1 : 3; };
    TexturePtr texture;
    switch (d.kind) {
        case TextureSpecification::Kind::constant: {
            const glm::vec4 all = value(d.color0, use);
            texture = constant_texture(all, channels_of(all));
            break;
        }
        case TextureSpecification::Kind::checkerboard: {
            glm::vec4 a = value(d.color0, use), b = value(d.color1, use);
            if (use == Use::number) std::swap(a, b);  // as Mitsuba, which evaluates both apart
            texture = checkerboard_texture(a, b, std::max(channels_of(a), channels_of(b)), d.sampling.to_uv);
            break;
        }
        case TextureSpecification::Kind::image: {
            const Pixels pixels(image(d), d);
            TextureImage image = use == Use::number   ? pixels.numbers()
                                 : use == Use::vector ? pixels.vectors()
                                                      : without_repetition(pixels.colors());
            if (image.channels == 3 && use == Use::color) require_rgb("an image of red, green and blue");
            texture = image_texture(std::move(image), d.sampling);
            break;
        }
    }
    if (!d.times_colors_of) return texture;
    const TextureSpecification* const of_shape = in_place_of_attribute(d);
    TexturePtr factor = of_shape != nullptr ? of(*of_shape, use) : mesh_color_texture(*d.times_colors_of);
    return texture->constant() && texture->mean() == glm::vec4(1)
               ? factor
               : product_texture(std::move(texture), std::move(factor));
}

const TextureSpecification* SceneTextures::in_place_of_attribute(const TextureSpecification& d) const {
    if (attributes_ == nullptr || !d.times_colors_of) return nullptr;
    const std::string_view prefix = *d.times_colors_of == ColorsOf::faces ? kFacePrefix : kVertexPrefix;
    const auto own = attributes_->find(std::string(prefix) + d.attribute);
    return own == attributes_->end() ? nullptr : own->second.get();
}

void SceneTextures::need_attribute(const TextureSpecification& d, Use use) {
    const bool number = use == Use::number;
    if (use == Use::color) require_rgb("a mesh's colours");
    if (number && d.attribute == MeshColorNames().vertices)
        throw Error(ErrorCode::unsupported, "a mesh's colours where one number is expected; give an image");
    needed_.insert({.of = *d.times_colors_of, .name = d.attribute, .number = number});
}

void SceneTextures::require_rgb(const char* what) const {
    if (!channels_.rgb())
        throw Error(ErrorCode::unsupported, std::string(what) + " under light of " +
                                                std::to_string(channels_.count) +
                                                " other channels; give grey ones");
}

const ImagePixels& SceneTextures::image(const TextureSpecification& d) {
    const auto [entry, is_new] = images_.try_emplace({d.filename, d.raw});
    ImagePixels& image = entry->second;
    if (is_new)
        image = d.bytes ? load_image_pixels(d.filename, *d.bytes, d.raw, files_.budget())
                        : files_.read(d.filename,
                                      [&] { return load_image_pixels(d.filename, d.raw, files_.budget()); });
    files_.budget().take_pixels(d.filename, image.count());
    return image;
}

}  // namespace nicol::scene
