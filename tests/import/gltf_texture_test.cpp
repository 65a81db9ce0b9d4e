// SPDX-License-Identifier: MIT
// Tests of textures in glTF files.
#include "image/color.hpp"
#include "import/described_material.hpp"
#include "import/textured_gltf_file.hpp"
#include "material/matrix_at.hpp"
#include "material/spatial_variation.hpp"

using namespace nicol;

namespace {

using Part = TextureSpecification::Part;
using Filter = TextureSampling::Filter;
using Wrap = TextureSampling::Wrap;

std::string pbr(const std::string& members, const std::string& more = "") {
    return "\"pbrMetallicRoughness\":{" + members + "}" + more;
}
std::string base(const std::string& more = "", const std::string& members = ",\"metallicFactor\":0") {
    return pbr("\"baseColorTexture\":{\"index\":0" + more + "}" + members);
}
std::string transform(const std::string& members) {
    return ",\"extensions\":{\"KHR_texture_transform\":{" + members + "}}";
}

TextureSpecificationPtr base_texture(const MaterialDescription& material) {
    return color(as<PplasticModel>(material), &PplasticParameters::diffuse_reflectance).texture;
}

std::string refusal(const std::string& material, const std::string& more, ErrorCode code) {
    const TexturedFile file(material, more);
    const std::string message = error_of(CALL(file.load()), code);
    CHECK(message.find((file / "a.gltf").string()) != std::string::npos);
    return message;
}

}  // namespace

TEST_CASE("the base colour of glTF is its factor times its texture, sRGB, times colours of vertices") {
    const TextureSpecificationPtr image = base_texture(
        TexturedFile(base("", ",\"metallicFactor\":0,\"baseColorFactor\":[0.5,1,0.25,1]")).material());
    REQUIRE(image);
    const TextureSpecification& t = *image;
    CHECK(t.kind == TextureSpecification::Kind::image);
    CHECK(t.filename.filename() == "a b.png");
    CHECK_FALSE(t.raw);
    CHECK(t.part == Part::color);
    CHECK(t.factor == glm::dvec3(0.5, 1, 0.25));
    CHECK_FALSE(t.times_colors_of);

    const std::string colored = "\"TEXCOORD_0\":1,\"COLOR_0\":3";
    CHECK(base_texture(TexturedFile(base(), "", colored).material())->times_colors_of == ColorsOf::vertices);
    const TextureSpecificationPtr bare = base_texture(
        TexturedFile(pbr("\"metallicFactor\":0,\"baseColorFactor\":[0.5,1,0.25,1]"), "", colored).material());
    REQUIRE(bare);
    CHECK(bare->kind == TextureSpecification::Kind::constant);
    CHECK(bare->color0.rgb == glm::dvec3(0.5, 1, 0.25));
    CHECK(bare->times_colors_of == ColorsOf::vertices);

    // A metal with a textured colour is a mirror times that colour.
    const auto metal = as<MetalModel>(TexturedFile(base("", "")).material());
    CHECK(metal.eta.rgb == glm::dvec3(0));
    CHECK(color(metal, &RoughConductorParameters::specular_reflectance).texture);
}

TEST_CASE("metal and roughness of glTF are channels of one texture") {
    const std::string rough = "\"metallicRoughnessTexture\":{\"index\":0},\"roughnessFactor\":0.5";
    const auto blend = as<BlendModel>(TexturedFile(pbr(rough + ",\"metallicFactor\":0.25")).material());
    CHECK(blend.texture->part == Part::blue);
    CHECK(blend.texture->raw);
    CHECK(blend.texture->factor == glm::dvec3(0.25));
    for (const TextureSpecificationPtr& alpha :
         {number(as<PplasticModel>(blend.base), &PplasticParameters::alpha).texture,
          number(as<MetalModel>(blend.other), &RoughConductorParameters::alpha).texture}) {
        REQUIRE(alpha);
        CHECK(alpha->part == Part::green);
        CHECK(alpha->raw);
        CHECK(alpha->factor == glm::dvec3(0.5));
        CHECK(alpha->squared);
    }
    CHECK(is<PplasticModel>(TexturedFile(pbr(rough + ",\"metallicFactor\":0")).material()));
    const auto half = as<BlendModel>(TexturedFile(pbr("\"metallicFactor\":0.5")).material());
    CHECK(half.texture->color0 == ColorDescription(0.5));
}

TEST_CASE("textures of glTF become the material that their pixel stands for") {
    const TexturePoint point{.uv = {0.5, 0.5}, .color = {1, 0.5, 0.25}};
    const double red = srgb_to_linear(0.2F), green = srgb_to_linear(0.4F), blue = srgb_to_linear(0.8F);
    const auto weight_sum = [&](const Material& material, int channel) {
        std::vector<glm::vec3> weights(material.variation()->layers.size());
        material.variation()->weights(point, weights);
        glm::dvec3 sum(0);
        for (const glm::vec3& weight : weights) sum += glm::dvec3(weight);
        return sum[channel];
    };
    // A texture of one pixel is constant, while vertex colours vary.
    const LoadedScene plain = TexturedFile(base()).load();
    const MaterialPtr material = plain.scene.instances().at(0).material;
    CHECK(material->variation() == nullptr);
    const glm::dvec3 up(0, 0, 1);
    const MaterialPtr expected = pplastic({.diffuse_reflectance = {red, green, blue},
                                           .int_ior = 1.5,
                                           .ext_ior = 1,
                                           .alpha = 1,
                                           .distribution = Distribution::ggx});
    for (int c = 0; c < 3; ++c)
        CHECK(evaluate(*material, c, up, up)(0, 0) ==
              doctest::Approx(evaluate(*expected, c, up, up)(0, 0)).epsilon(1e-5));
    const LoadedScene colored = TexturedFile(base("", ""), "", "\"TEXCOORD_0\":1,\"COLOR_0\":3").load();
    const Material& metal = *colored.scene.instances().at(0).material;
    REQUIRE(metal.variation());
    CHECK(weight_sum(metal, 0) == doctest::Approx(red));
    CHECK(weight_sum(metal, 1) == doctest::Approx(0.5 * green));
    CHECK(weight_sum(metal, 2) == doctest::Approx(0.25 * blue));
}

TEST_CASE("textures of glTF's anisotropy") {
    const auto brushed = [](const std::string& members, const std::string& metal) {
        return TexturedFile("\"extensions\":{\"KHR_materials_anisotropy\":{\"anisotropyStrength\":0.5" +
                            members + "}}," + pbr(metal + ",\"roughnessFactor\":0.5"));
    };
    const std::string image = ",\"anisotropyTexture\":{\"index\":0,\"texCoord\":1}";
    const std::string rough = ",\"metallicRoughnessTexture\":{\"index\":0,\"texCoord\":1}";
    const SceneDescription scene =
        brushed(image + ",\"anisotropyRotation\":1", "\"metallicFactor\":1").read();
    CHECK(scene.shapes.at(0).mesh->texcoords == other_texcoords);
    const auto rotated = as<RotatedModel>(scene.materials.at(0));
    CHECK(rotated.angle == 1);
    REQUIRE(rotated.directions);
    CHECK(rotated.directions->raw);
    CHECK(rotated.directions->part == Part::color);
    const auto wide = as<BrushedModel>(rotated.base);
    CHECK(wide.alpha.value == 0.25);
    REQUIRE(wide.strength.texture);
    CHECK(wide.strength.texture->part == Part::blue);
    CHECK(wide.strength.texture->raw);
    CHECK(wide.strength.texture->factor == glm::dvec3(0.5));

    // The image has green 102 and blue 204 of 255.
    const double alpha = std::pow(0.5 * 102 / 255, 2), strength = 0.5 * 204 / 255;
    const struct {
        std::string members, metal;
        double across, along;
    } rows[] = {{"", "\"metallicFactor\":1" + rough, alpha, widened(alpha, 0.5)},
                {image, "\"metallicFactor\":1", 0.25, widened(0.25, strength)},
                {image, "\"metallicFactor\":1" + rough, alpha, widened(alpha, strength)},
                {image, "\"metallicFactor\":0" + rough, alpha, widened(alpha, strength)}};
    for (const auto& row : rows) {
        CAPTURES(row.members, row.metal);
        const LoadedScene loaded = brushed(row.members, row.metal).load();
        const Material& material = *loaded.scene.instances().at(0).material;
        CHECK(material.anisotropic());
        double nearest = 1;
        for (int t = 0; t < material.terms(); ++t)
            nearest =
                std::min(nearest, glm::distance(material.lobe(t).alpha, glm::dvec2(row.along, row.across)));
        CHECK(nearest < 1e-4);
        const SpatialVariation* const variation = material.variation();
        CHECK((variation != nullptr && variation->rotation.directions != nullptr) == !row.members.empty());
    }
}

TEST_CASE("normal maps of glTF") {
    const MaterialDescription d =
        TexturedFile("\"doubleSided\":true,\"normalTexture\":{\"index\":0,\"scale\":0.5}").material();
    CHECK(d.twosided);
    const auto mapped = as<NormalMapModel>(d);
    CHECK(mapped.options.mirrored_y);
    CHECK(mapped.texture->raw);
    // The factor and offset halve 2 t - 1 in x and y.
    const glm::dvec3 t(0.75, 0.25, 1);
    CHECK(2.0 * (mapped.texture->factor * t + mapped.texture->offset) - 1.0 == glm::dvec3(0.25, -0.25, 1));
    CHECK(is<MetalModel>(mapped.base));
}

TEST_CASE("coverage of glTF cuts at its cutoff") {
    struct Case {
        std::string members;
        double factor;  ///< 0 without an alpha mask
    };
    const std::string mask = ",\"alphaMode\":\"MASK\"";
    for (const Case& c : {Case{base() + mask, 1}, Case{base() + mask + ",\"alphaCutoff\":0.25", 2},
                          Case{base() + mask + ",\"alphaCutoff\":0", 0},
                          Case{base("", ",\"metallicFactor\":0,\"baseColorFactor\":[1,1,1,0.5]") + mask, 0.5},
                          Case{base(), 0}, Case{base() + ",\"alphaMode\":\"BLEND\"", 1}}) {
        CAPTURE(c.members);
        const SceneDescription scene = TexturedFile(c.members).read();
        const MaterialDescription& d = scene.materials.at(0);
        CHECK(is<MaskModel>(d) == (c.factor != 0));
        if (c.factor == 0) continue;
        const auto masked = as<MaskModel>(d);
        CHECK(masked.texture->part == Part::coverage);
        CHECK(masked.texture->factor == glm::dvec3(c.factor));
        CHECK(masked.texture->filename == base_texture(masked.base)->filename);
        CHECK(masked.translucent == (c.members.find("BLEND") != std::string::npos));
    }
    const std::string faint = "\"alphaMode\":\"MASK\"," + pbr("\"baseColorFactor\":[1,1,1,0.25]");
    CHECK(is<MaskModel>(TexturedFile(faint).material()));
    CHECK(is<MetalModel>(TexturedFile("\"alphaMode\":\"MASK\"").material()));
}

TEST_CASE("samplers of glTF") {
    struct Case {
        std::string sampler;
        Filter filter;
        Wrap wrap;
    };
    for (const Case& c :
         {Case{"{}", Filter::mipmap, Wrap::repeat},
          Case{"{\"wrapS\":33071,\"wrapT\":33071,\"minFilter\":9729}", Filter::bilinear, Wrap::clamp},
          Case{"{\"wrapS\":33648,\"wrapT\":33648,\"minFilter\":9987}", Filter::mipmap, Wrap::mirror},
          Case{"{\"magFilter\":9728,\"minFilter\":9728}", Filter::nearest, Wrap::repeat},
          Case{"{\"magFilter\":9728,\"minFilter\":9984}", Filter::mipmap, Wrap::repeat}}) {
        CAPTURE(c.sampler);
        const TextureSampling sampling =
            base_texture(
                TexturedFile(base(), TexturedFile::one_texture("{\"uri\":\"a.png\"}", c.sampler)).material())
                ->sampling;
        CHECK(sampling.filter == c.filter);
        CHECK(sampling.wrap == c.wrap);
    }
    CHECK(has_notice(
        TexturedFile(base(), TexturedFile::one_texture("{\"uri\":\"a.png\"}", "{\"wrapS\":33071}")).read(),
        "wrapT"));
}

TEST_CASE("KHR_texture_transform scales, then rotates counter-clockwise with v down, then moves") {
    const auto to_uv = [](const std::string& members) {
        return base_texture(TexturedFile(base(transform(members))).material())->sampling.to_uv;
    };
    // The example of the extension: the lower left quarter of the image, rotated clockwise.
    const glm::dmat3 m = to_uv("\"offset\":[0,1],\"rotation\":1.57079632679,\"scale\":[0.5,0.5]");
    const auto near = [&](const glm::dvec2& uv, const glm::dvec2& expected) {
        return glm::distance(glm::dvec2(m * glm::dvec3(uv, 1)), expected) < 1e-9;
    };
    CHECK(near({0, 0}, {0, 1}));
    CHECK(near({1, 0}, {0, 0.5}));
    CHECK(near({0, 1}, {0.5, 1}));
    CHECK(to_uv("\"scale\":[2,3]") * glm::dvec3(1, 1, 1) == glm::dvec3(2, 3, 1));
    CHECK(to_uv("") == glm::dmat3(1));
}

TEST_CASE("textures of glTF take the texture coordinates that they name") {
    const auto texcoords = [](const SceneDescription& scene) { return scene.shapes.at(0).mesh->texcoords; };
    CHECK(texcoords(TexturedFile(base()).read()) == some_texcoords);
    CHECK(texcoords(TexturedFile(base(",\"texCoord\":1")).read()) == other_texcoords);
    CHECK(texcoords(TexturedFile(base(transform("\"texCoord\":1"))).read()) == other_texcoords);
    const SceneDescription both =
        TexturedFile(base(",\"texCoord\":1") + ",\"normalTexture\":{\"index\":0}").read();
    CHECK(texcoords(both) == other_texcoords);
    CHECK(has_notice(both, "several sets of texture coordinates"));
    const SceneDescription none = TexturedFile(base(",\"texCoord\":2")).read();
    CHECK(has_notice(none, "lack the texture coordinates"));
    CHECK_FALSE(base_texture(none.materials.at(0)));
    CHECK_FALSE(base_texture(TexturedFile(base(), "", "").material()));
}

TEST_CASE("images of glTF in files, in buffers and in the text are the same") {
    const std::string png = an_image();
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string base64;
    for (std::size_t i = 0; i < png.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < png.size() ? static_cast<unsigned char>(png[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            base64 += i + k > png.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
    }
    const int view = TexturedFile(base()).image_view();
    const MaterialPtr in_file = TexturedFile(base()).load().scene.instances().at(0).material;
    for (const std::string& image :
         {std::string("{\"bufferView\":") + std::to_string(view) + ",\"mimeType\":\"image/png\"}",
          "{\"uri\":\"data:image/png;base64," + base64 + "\"}"}) {
        CAPTURE(image);
        const LoadedScene loaded = TexturedFile(base(), TexturedFile::one_texture(image)).load();
        CHECK(loaded.files.size() == 2);
        const Material& material = *loaded.scene.instances().at(0).material;
        CHECK(material.content_key() == in_file->content_key());
    }
    const LoadedScene loaded = TexturedFile(base()).load();
    CHECK(loaded.files.size() == 3);
    CHECK(std::ranges::count_if(loaded.files, [](const FileRecord& record) {
              return record.path.filename() == "a b.png";
          }) == 1);
}

TEST_CASE("textures of glTF that are refused, by element") {
    struct Case {
        std::string material, more, part;
        ErrorCode code = ErrorCode::invalid_file;
    };
    const auto image = [](const std::string& of) { return TexturedFile::one_texture(of); };
    for (const Case& c : {
             Case{base(), "\"images\":[]", "materials[0].baseColorTexture: refers to textures[0]"},
             Case{base(), "\"textures\":[{\"source\":3}],\"images\":[{\"uri\":\"a.png\"}]",
                  "textures[0]: refers to images[3]"},
             Case{base(), "\"textures\":[{\"source\":0,\"sampler\":2}],\"images\":[{\"uri\":\"a.png\"}]",
                  "textures[0]: refers to samplers[2]"},
             Case{base(), image("{\"uri\":\"none.png\"}"), "none.png", ErrorCode::file_not_found},
             Case{base(), image("{\"uri\":\"../a.png\"}"), "an image's uri", ErrorCode::unsupported},
             Case{base(), image("{\"uri\":\"%2e%2e/a.png\"}"), "an image's uri", ErrorCode::unsupported},
             Case{base(), image("{\"uri\":\"/etc/passwd\"}"), "an image's uri", ErrorCode::unsupported},
             Case{base(), image("{\"uri\":\"data:image/png;base64,AAAA\"}"), "images[0]",
                  ErrorCode::unsupported},
             Case{base(), image("{\"bufferView\":0,\"mimeType\":\"image/png\"}"), "images[0]",
                  ErrorCode::unsupported},
             Case{base(transform("\"offset\":[1]")), "", "offset is not an array of two numbers"},
             Case{base(transform("\"scale\":[1,\"a\"]")), "", "scale is not made of numbers"},
             Case{base(transform("\"rotation\":1e300")), "", "rotation is not made of numbers"},
             Case{base(transform("\"texCoord\":\"a\"")), "", "texCoord is not a whole number"},
             Case{"\"normalTexture\":{\"index\":0,\"scale\":1e9}", "", "normalTexture: scale"},
         }) {
        CAPTURE(c.material + c.more);
        const std::string message = refusal(c.material, c.more, c.code);
        CHECK_MESSAGE(message.find(c.part) != std::string::npos, message);
    }
    CHECK(has_notice(TexturedFile(base(), "\"textures\":[{}]").read(), "without a PNG or JPEG image"));
}

TEST_CASE("a texture of the thickness makes the film of each point") {
    const auto iridescent = [](double metallic, double least, double most, const std::string& more) {
        return pbr("\"roughnessFactor\":0.5,\"metallicFactor\":" + std::to_string(metallic),
                   ",\"extensions\":{\"KHR_materials_iridescence\":{\"iridescenceFactor\":1,"
                   "\"iridescenceThicknessMinimum\":" +
                       std::to_string(least) + ",\"iridescenceThicknessMaximum\":" + std::to_string(most) +
                       more + "}}");
    };
    const std::string varies = ",\"iridescenceThicknessTexture\":{\"index\":0}";
    // Columns of green from 0 to 255. Red and blue are none of the thickness.
    constexpr unsigned int columns = 256;
    std::vector<std::uint8_t> ramp;
    for (unsigned int x = 0; x < columns; ++x)
        for (const unsigned int value : {255 - x, x, 100U}) ramp.push_back(static_cast<std::uint8_t>(value));
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.5, 0.1, 0.8));
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(-0.6, 0.1, 0.7));
    for (const double metallic : {0.0, 1.0})
        // The film may be thinnest where the texture is brightest, or vanish.
        for (const auto& [least, most] : {std::pair(100.0, 400.0), {500.0, 0.0}}) {
            CAPTURES(metallic, least, most);
            const TexturedFile file(iridescent(metallic, least, most, varies));
            file.write("part/a b.png", png_bytes(columns, 1, 3, ramp));
            CHECK(file.read().notices.empty());
            const MaterialPtr material = file.load().scene.instances().at(0).material;
            REQUIRE(material->variation() != nullptr);
            double squared_error = 0, squared_contrast = 0;
            const MaterialPtr bare =
                TexturedFile(iridescent(metallic, 0, 0, "")).load().scene.instances().at(0).material;
            for (unsigned int x = 3; x < columns; x += 24) {
                const double thickness = least + (most - least) * x / 255;
                const MaterialPtr expected = TexturedFile(iridescent(metallic, 0, thickness, ""))
                                                 .load()
                                                 .scene.instances()
                                                 .at(0)
                                                 .material;
                const glm::vec2 uv((static_cast<float>(x) + 0.5F) / columns, 0.5F);
                for (int c = 0; c < 3; ++c) {
                    const Mueller varying = test::matrix_at(*material, c, uv, light, viewer);
                    const Mueller even = evaluate(*expected, c, light, viewer);
                    const Mueller without = evaluate(*bare, c, light, viewer);
                    for (std::size_t row = 0; row < 2; ++row) {
                        squared_error += std::pow(varying(row, 0) - even(row, 0), 2);
                        squared_contrast += std::pow(even(row, 0) - without(row, 0), 2);
                    }
                }
            }
            CHECK(std::sqrt(squared_error) < 0.06 * std::sqrt(squared_contrast));
        }
    // A body of glass has one film.
    const TexturedFile glass(
        pbr("\"metallicFactor\":0",
            ",\"extensions\":{\"KHR_materials_transmission\":{\"transmissionFactor\":1},"
            "\"KHR_materials_iridescence\":{\"iridescenceFactor\":1,\"iridescenceThicknessMaximum\":500" +
                varies + "}}"));
    CHECK(has_notice(glass.read(), "KHR_materials_iridescence with a texture of the thickness has the mean"));
    CHECK(as<GlassModel>(glass.material()).glass.film.thickness == 300);
}
