// SPDX-License-Identifier: MIT
// glTF files with a texture, for tests.
#pragma once

#include "import/gltf_file.hpp"
#include "import/png_file.hpp"

/// Returns one pixel (51, 102, 204) with coverage 128.
inline std::string an_image() {
    return png_bytes(1, 1, 4, {51, 102, 204, 128});
}

inline const std::vector<glm::vec2> some_texcoords = {{0, 0}, {1, 0}, {0, 1}};
inline const std::vector<glm::vec2> other_texcoords = {{0.25, 0.5}, {0.5, 0.5}, {0.25, 1}};

/// A triangle with two sets of texture coordinates, and with colours if `attributes` names accessor 3.
class TexturedFile : public TemporaryFolder {
public:
    explicit TexturedFile(const std::string& material, const std::string& more = "",
                          const std::string& attributes = "\"TEXCOORD_0\":1,\"TEXCOORD_1\":2") {
        GltfBuffer buffer = triangle_buffer();
        buffer.accessor("VEC2", gltf_float, 3, GltfBuffer::of(buffer.view(some_texcoords)));
        buffer.accessor("VEC2", gltf_float, 3, GltfBuffer::of(buffer.view(other_texcoords)));
        buffer.vectors({{1, 0.5, 0.25}, {1, 1, 1}, {0, 0, 0}});
        const std::string image = an_image();
        image_view_ = buffer.view(std::vector<char>(image.begin(), image.end()));
        write("a.bin", buffer.bytes);
        write("part/a b.png", image);
        write("a.gltf",
              buffer.json("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0" +
                          (attributes.empty() ? "" : "," + attributes) +
                          "},\"material\":0}]}],\"nodes\":[{\"mesh\":0}],\"materials\":[{" + material +
                          "}]," + (more.empty() ? one_texture("{\"uri\":\"part/a%20b.png\"}") : more)));
    }
    static std::string one_texture(const std::string& image, const std::string& sampler = "{}") {
        return "\"textures\":[{\"source\":0,\"sampler\":0}],\"images\":[" + image + "],\"samplers\":[" +
               sampler + "]";
    }

    [[nodiscard]] nicol::SceneDescription read() const { return nicol::read_gltf_scene(*this / "a.gltf"); }
    [[nodiscard]] nicol::MaterialDescription material() const { return read().materials.at(0); }
    [[nodiscard]] nicol::LoadedScene load(const nicol::LoadLimits& limits = {}) const {
        return nicol::load_scene(*this / "a.gltf", {}, limits);
    }
    [[nodiscard]] int image_view() const { return image_view_; }

private:
    int image_view_ = 0;
};
