// SPDX-License-Identifier: MIT
// Tests of textures in Mitsuba's XML: reading, resulting materials, refusals.
#include <tuple>

#include "image/color.hpp"
#include "import/described_material.hpp"
#include "import/load_scene.hpp"
#include "import/png_file.hpp"
#include "import/scene_file.hpp"
#include "material/conductor.hpp"
#include "material/spatial_variation.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using TextureKind = TextureSpecification::Kind;

MaterialDescription material(const std::string& bsdf) {
    return read_shape(bsdf).materials.at(0);
}

TextureSpecificationPtr reflectance(const MaterialDescription& material) {
    return as<DiffuseModel>(material).reflectance.texture;
}

std::string bsdf(const std::string& type, const std::string& inside) {
    return "<bsdf type='" + type + "'>\n" + inside + "</bsdf>";
}

std::string texture(const std::string& name, const std::string& type, const std::string& inside) {
    return "<texture name='" + name + "' type='" + type + "'>" + inside + "</texture>";
}

std::string bitmap(const std::string& name, const std::string& inside = "") {
    return texture(name, "bitmap", "<string name='filename' value='a.png'/>" + inside);
}

std::string checkerboard(const std::string& name) {
    return texture(name, "checkerboard",
                   "<float name='color0' value='0.75'/><float name='color1' value='0.25'/>");
}

const std::string raw = "<boolean name='raw' value='true'/>";

/// A folder with a.png of two pixels, (255, 0, 0) and (51, 51, 51), and a triangle with texture coordinates
/// and colours.
class Folder : public TemporaryFolder {
public:
    Folder() {
        write("a.png", png_bytes(2, 1, 3, {255, 0, 0, 51, 51, 51}));
        write("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
              "property float z\nproperty float s\nproperty float t\nproperty uchar red\n"
              "property uchar green\nproperty uchar blue\nelement face 1\n"
              "property list uchar int vertex_indices\nproperty float r\nproperty float g\n"
              "property float b\nend_header\n"
              "0 0 0 0 0 255 0 0\n1 0 0 1 0 0 255 0\n0 1 0 0 1 0 0 255\n3 0 1 2 1 0.5 0\n");
    }

    /// Loads the triangle with this material.
    LoadedScene load(const std::string& inside, const LoadLimits& limits = {}) const {
        return load_scene(write("a.xml", ::scene(a_sensor + an_emitter +
                                                 "<shape type='ply'><string name='filename' value='a.ply'/>" +
                                                 inside + "</shape>")),
                          {}, limits);
    }
    MaterialPtr load_material(const std::string& inside) const {
        return load(inside).scene.instances().at(0).material;
    }
};

/// Returns m00 at a surface point: the sum over the material's layers.
double reflected(const Material& material, const TexturePoint& point, int channel,
                 const glm::dvec3& towards_light, const glm::dvec3& towards_viewer) {
    const auto m00 = [&](const Material& of) {
        return evaluate(of, of.channels() == 1 ? 0 : channel, towards_light, towards_viewer)(0, 0);
    };
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return m00(material);
    std::vector<glm::vec3> weights(variation->layers.size());
    variation->weights(point, weights);
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        sum += static_cast<double>(weights[i][channel]) * m00(*variation->layers[i].material);
    return sum;
}

const glm::dvec3 a_light = glm::normalize(glm::dvec3(0.3, 0.1, 1));
const glm::dvec3 a_viewer = glm::normalize(glm::dvec3(-0.2, -0.1, 1));

void check_same(const Material& a, const TexturePoint& point, const Material& b) {
    for (int c = 0; c < 3; ++c)
        CHECK(reflected(a, point, c, a_light, a_viewer) ==
              doctest::Approx(evaluate(b, b.channels() == 1 ? 0 : c, a_light, a_viewer)(0, 0)).epsilon(1e-5));
}

void refused(const std::string& inside, ErrorCode code, const std::vector<std::string>& parts) {
    CAPTURE(inside);
    const SceneFile file(::scene(shape_with(inside)));
    check_refused(file, code, file.scene().string() + ":", parts);
}

}  // namespace

TEST_CASE("a bitmap has Mitsuba's defaults and parameters") {
    const TextureSpecificationPtr image = reflectance(material(bsdf("diffuse", bitmap("reflectance"))));
    REQUIRE(image);
    const TextureSpecification& plain = *image;
    CHECK(plain.kind == TextureKind::image);
    CHECK(plain.filename.filename() == "a.png");
    CHECK_FALSE(plain.raw);
    // The default is bilinear interpolation with mipmaps.
    CHECK(plain.sampling == TextureSampling{.filter = TextureSampling::Filter::mipmap});
    const TextureSpecification given = *reflectance(material(bsdf(
        "diffuse",
        bitmap("reflectance", raw + "<string name='filter_type' value='nearest'/><string name='wrap_mode' "
                                    "value='clamp'/><string name='format' value='fp16'/><transform "
                                    "name='to_uv'><scale x='2' y='3'/><translate x='0.5' y='0.25'/>"
                                    "</transform>"))));
    CHECK(given.raw);
    CHECK(given.sampling.filter == TextureSampling::Filter::nearest);
    CHECK(given.sampling.wrap == TextureSampling::Wrap::clamp);
    CHECK(given.sampling.to_uv * glm::dvec3(1, 1, 1) == glm::dvec3(2.5, 3.25, 1));
    CHECK(reflectance(
              material(bsdf("diffuse", bitmap("reflectance", "<string name='wrap_mode' value='mirror'/>"))))
              ->sampling.wrap == TextureSampling::Wrap::mirror);
}

TEST_CASE("checkerboards, constants and colours of meshes") {
    const TextureSpecification board = *reflectance(
        material(bsdf("diffuse", texture("reflectance", "checkerboard",
                                         "<rgb name='color1' value='1, 0.5, 0'/><transform name='to_uv'>"
                                         "<scale x='8' y='4'/></transform>"))));
    CHECK(board.kind == TextureKind::checkerboard);
    CHECK(board.color0 == ColorDescription(0.4));
    CHECK(board.color1 == ColorDescription(glm::dvec3(1, 0.5, 0)));
    CHECK(board.sampling.to_uv[1][1] == 4);
    for (const std::string value :
         {"<vector name='value' x='0.5' y='0.25' z='1'/>", "<vector name='value' value='0.5, 0.25, 1'/>",
          "<rgb name='value' value='0.5, 0.25, 1'/>"}) {
        const TextureSpecification constant =
            *reflectance(material(bsdf("diffuse", texture("reflectance", "rawconstant", value))));
        CHECK(constant.kind == TextureKind::constant);
        CHECK(constant.color0 == ColorDescription(glm::dvec3(0.5, 0.25, 1)));
    }
    for (const auto& [name, of, attribute_name] : {std::tuple("vertex_color", ColorsOf::vertices, "color"),
                                                   {"face_color", ColorsOf::faces, "color"},
                                                   {"face_some_weight", ColorsOf::faces, "some_weight"}}) {
        const std::string attribute = "<string name='name' value='" + std::string(name) + "'/>";
        const TextureSpecification colors =
            *reflectance(material(bsdf("diffuse", texture("reflectance", "mesh_attribute", attribute))));
        CHECK(colors.kind == TextureKind::constant);
        CHECK(colors.color0 == ColorDescription(1.0));
        CHECK(colors.times_colors_of == of);
        CHECK(colors.attribute == attribute_name);
    }
}

TEST_CASE("a texture may be given for these parameters, itself or by reference") {
    const std::string gold = "<string name='filename' value='a.npz'/>";
    const auto read_reference = [&](const std::string& type, const std::string& name,
                                    const std::string& others) {
        return read("<texture type='bitmap' id='t'><string name='filename' value='b.png'/></texture>" +
                    shape_with(bsdf(type, others + "<ref id='t' name='" + name + "'/>")))
            .materials.at(0);
    };
    struct Case {
        std::string type, name, others;
        std::function<TextureSpecificationPtr(const MaterialDescription&)> texture;
    };
    using M = MaterialDescription;
    using P = PplasticParameters;
    using C = RoughConductorParameters;
    const auto plastic_color = [](ColorParameter P::*parameter) {
        return [=](const M& m) { return color(as<PplasticModel>(m), parameter).texture; };
    };
    const auto metal_color = [](const M& m) {
        return color(as<MetalModel>(m), &C::specular_reflectance).texture;
    };
    const auto scale = [](const M& m) { return dynamic_cast<const TabulatedModel&>(*m.model).scale.texture; };
    const auto varied = [](const M& m) { return dynamic_cast<const VariedModel&>(*m.model).texture; };
    for (const Case& c : {
             Case{"diffuse", "reflectance", "", [](const M& m) { return reflectance(m); }},
             Case{"pplastic", "diffuse_reflectance", "", plastic_color(&P::diffuse_reflectance)},
             Case{"pplastic", "specular_reflectance", "", plastic_color(&P::specular_reflectance)},
             Case{"pplastic", "alpha", "",
                  [](const M& m) { return number(as<PplasticModel>(m), &P::alpha).texture; }},
             Case{"conductor", "specular_reflectance", "", metal_color},
             Case{"roughconductor", "specular_reflectance", "", metal_color},
             Case{"roughconductor", "alpha", "",
                  [](const M& m) { return number(as<MetalModel>(m), &C::alpha).texture; }},
             Case{"psh", "scale", gold, scale},
             Case{"measured_polarized", "scale", gold, scale},
             Case{"mask", "opacity", "<bsdf type='diffuse'/>", varied},
             Case{"blendbsdf", "weight", "<bsdf type='diffuse'/><bsdf type='conductor'/>", varied},
             Case{"normalmap", "n", "<bsdf type='diffuse'/>", varied},
             Case{"bumpmap", "", "<bsdf type='diffuse'/>", varied},
         }) {
        CAPTURE(c.type + " " + c.name);
        const TextureSpecificationPtr inside = c.texture(material(bsdf(c.type, c.others + bitmap(c.name))));
        REQUIRE(inside);
        CHECK(inside->filename.filename() == "a.png");
        const TextureSpecificationPtr referred = c.texture(read_reference(c.type, c.name, c.others));
        REQUIRE(referred);
        CHECK(referred->filename.filename() == "b.png");
    }
    const M both = material(bsdf("roughconductor", bitmap("alpha_u") + bitmap("alpha_v")));
    CHECK(number(as<MetalModel>(both), &C::alpha).texture->filename.filename() == "a.png");
}

TEST_CASE("bsdfs that are made of others") {
    const MaterialDescription d = material(
        bsdf("twosided", bsdf("normalmap", texture("n", "rawconstant", "<vector name='value' x='1'/>") +
                                               bsdf("pplastic", ""))));
    CHECK(d.twosided);
    const auto mapped = as<NormalMapModel>(d);
    CHECK_FALSE(mapped.options.mirrored_y);
    CHECK(is<PplasticModel>(mapped.base));
    CHECK_FALSE(mapped.base.twosided);
    const auto bump = as<BumpMapModel>(
        material(bsdf("bumpmap", "<float name='scale' value='0.5'/>" + bitmap("") + bsdf("diffuse", ""))));
    CHECK(bump.scale == 0.5);
    const auto mask = as<MaskModel>(material(
        bsdf("mask", "<float name='opacity' value='0.75'/>" + bsdf("twosided", bsdf("diffuse", "")))));
    CHECK(mask.texture->color0 == ColorDescription(0.75));
    CHECK(mask.base.twosided);
    CHECK(as<MaskModel>(material(bsdf("mask", bsdf("diffuse", "")))).texture->color0 ==
          ColorDescription(0.5));
    const auto blend = as<BlendModel>(material(bsdf(
        "blendbsdf", "<float name='weight' value='0.25'/>" + bsdf("diffuse", "") + bsdf("conductor", ""))));
    CHECK(blend.texture->color0 == ColorDescription(0.25));
    CHECK(is<DiffuseModel>(blend.base));
    CHECK(as<MetalModel>(blend.other).parameters.alpha.value == 0);
}

TEST_CASE("textures and bsdfs that are refused") {
    const ErrorCode invalid = ErrorCode::invalid_file, unsupported = ErrorCode::unsupported;
    const auto diffuse_of = [](const std::string& type, const std::string& inside) {
        return bsdf("diffuse", texture("reflectance", type, inside));
    };
    const std::string plain = bsdf("diffuse", "");
    struct Case {
        std::string bsdf;
        ErrorCode code;
        std::vector<std::string> parts;
    };
    for (const Case& c : {
             Case{diffuse_of("bitmap", ""), invalid, {":5: texture \"bitmap\"", "\"filename\" is missing"}},
             Case{diffuse_of("volume", ""),
                  unsupported,
                  {"texture \"volume\"", "bitmap, checkerboard, mesh_attribute, rawconstant"}},
             Case{diffuse_of("checkerboard", "<float name='colour0' value='1'/>"),
                  invalid,
                  {"\"colour0\" is unknown", "color0, color1, to_uv"}},
             Case{diffuse_of("checkerboard", bitmap("color0")), unsupported, {"\"color0\" is a texture"}},
             Case{diffuse_of("bitmap",
                             "<string name='filename' value='a'/><string name='wrap_mode' "
                             "value='border'/>"),
                  invalid,
                  {"\"wrap_mode\"", "repeat, mirror, clamp"}},
             Case{diffuse_of("bitmap",
                             "<string name='filename' value='a'/><string name='filter_type' "
                             "value='cubic'/>"),
                  invalid,
                  {"\"filter_type\"", "bilinear, nearest"}},
             Case{diffuse_of("mesh_attribute", "<string name='name' value='temperature'/>"),
                  invalid,
                  {"\"name\" is \"temperature\"", "expected vertex_ or face_"}},
             Case{diffuse_of("mesh_attribute", ""), invalid, {"\"name\" is \"\"", "as vertex_color"}},
             Case{texture("face_a", "mesh_attribute", "<string name='name' value='face_a'/>"),
                  unsupported,
                  {"\"face_a\" is a mesh_attribute"}},
             Case{diffuse_of("rawconstant", ""), invalid, {"\"value\" is missing"}},
             Case{bsdf("diffuse", bitmap("reflektance")),
                  invalid,
                  {"texture \"reflektance\" is unknown", "accepted parameters: reflectance"}},
             Case{bsdf("diffuse", bitmap("reflectance") + "<rgb name='reflectance' value='1'/>"),
                  invalid,
                  {"\"reflectance\" is given twice"}},
             Case{bsdf("diffuse", "<rgb name='reflectance' value='1'/>" + bitmap("reflectance")),
                  invalid,
                  {"\"reflectance\" is given twice"}},
             Case{bsdf("conductor", bitmap("eta")), unsupported, {"\"eta\" is a texture", "one value"}},
             Case{bsdf("roughconductor", bitmap("k")), unsupported, {"\"k\" is a texture"}},
             Case{bsdf("pplastic", bitmap("int_ior")), unsupported, {"\"int_ior\" is a texture"}},
             Case{bsdf("roughplastic", bitmap("alpha_u") + checkerboard("alpha_v")),
                  unsupported,
                  {":5: ", "\"alpha_v\" differs"}},
             Case{bsdf("roughplastic", "<float name='alpha_u' value='0.1'/>" + checkerboard("alpha_v")),
                  unsupported,
                  {"\"alpha_v\" differs"}},
             Case{bsdf("roughconductor", bitmap("alpha_u")), invalid, {"\"alpha_u\" is given alone"}},
             Case{bsdf("normalmap", plain), invalid, {"has 0 textures inside; expected one"}},
             Case{bsdf("bumpmap", bitmap("a") + bitmap("b") + plain), invalid, {"has 2 textures inside"}},
             Case{bsdf("normalmap", bitmap("a")), invalid, {"has 0 bsdfs inside; expected 1"}},
             Case{bsdf("blendbsdf", bitmap("weight") + plain), invalid, {"has 1 bsdfs inside; expected 2"}},
             Case{bsdf("blendbsdf", plain + plain), invalid, {"\"weight\" is missing"}},
             Case{bsdf("mask", "<float name='opacity' value='2'/>" + plain), invalid, {"from 0 to 1"}},
             Case{bsdf("mask", "<float name='alpha' value='1'/>" + plain), invalid, {"accepted: opacity"}},
             Case{"<bsdf type='mask' id='m'><ref id='m'/></bsdf>", invalid, {"more than 64", "itself"}},
             Case{bitmap("t"), invalid, {"shape \"sphere\": texture \"t\" is unknown"}},
         })
        refused(c.bsdf, c.code, c.parts);
    // A few elements stand for many.
    std::string doubled = "<bsdf type='diffuse' id='b0'/>";
    for (int i = 0; i < 20; ++i) {
        const std::string before = "<ref id='b" + std::to_string(i) + "'/>";
        doubled += "<bsdf type='blendbsdf' id='b" + std::to_string(i + 1) +
                   "'><float name='weight' value='0.5'/>" + before + before + "</bsdf>";
    }
    const SceneFile file(::scene(a_sensor + a_shape + doubled));
    check_refused(file, invalid, file.scene().string(), {"more than 64"});
    const SceneFile missing(::scene("<texture id='t' type='bitmap'/>" + a_sensor + a_shape));
    check_refused(missing, invalid, missing.scene().string() + ":2: ", {"\"filename\" is missing"});
}

TEST_CASE("attributes of any name are factors, of the mesh or as textures of the shape") {
    const TemporaryFolder folder;
    folder.write("a.png", png_bytes(2, 1, 3, {255, 0, 0, 51, 51, 51}));
    folder.write("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nproperty float s\nproperty float t\nproperty float rough_0\n"
                 "property float tint_0\nproperty float tint_1\nproperty float tint_2\nelement face 1\n"
                 "property list uchar int vertex_indices\nproperty float weight_0\nend_header\n"
                 "0 0 0 0 0 0.2 1 0 0\n1 0 0 1 0 0.4 0 1 0\n0 1 0 0 1 0.8 0 0 1\n3 0 1 2 0.7\n");
    const auto load = [&](const std::string& inside) {
        const std::string shape =
            "<shape type='ply'><string name='filename' value='a.ply'/>" + inside + "</shape>";
        return load_scene(folder.write("a.xml", ::scene(a_sensor + an_emitter + shape)), {}, LoadLimits{});
    };
    const auto attribute = [](const std::string& parameter, const std::string& name,
                              const std::string& scale = "1") {
        return texture(
            parameter, "mesh_attribute",
            "<string name='name' value='" + name + "'/><float name='scale' value='" + scale + "'/>");
    };
    struct Case {
        std::string inside;
        glm::vec3 at_first;  ///< at the first vertex, where u = v = 0.25
    };
    for (const Case& c :
         {Case{bsdf("diffuse", attribute("reflectance", "vertex_rough")), glm::vec3(0.2F)},
          Case{bsdf("diffuse", attribute("reflectance", "vertex_tint", "0.5")), {0.5F, 0, 0}},
          Case{bsdf("diffuse", attribute("reflectance", "face_weight")), glm::vec3(0.7F)},
          // A texture of the shape, which the mesh need not have.
          Case{bsdf("diffuse", attribute("reflectance", "face_other", "0.5")) +
                   texture("face_other", "bitmap", "<string name='filename' value='a.png'/>"),
               {0.5F, 0, 0}},
          Case{bsdf("diffuse", attribute("reflectance", "vertex_tint")) + checkerboard("vertex_tint"),
               glm::vec3(0.75F)}}) {
        CAPTURE(c.inside);
        const LoadedScene loaded = load(c.inside);
        const Instance& instance = loaded.scene.instances().at(0);
        const Mesh& mesh = *instance.mesh;
        TexturePoint point{.uv = {0.25F, 0.25F}};
        if (!mesh.colors.empty()) point.color = mesh.colors[0];
        if (!mesh.face_colors.empty()) point.color = mesh.face_colors[0];
        check_same(*instance.material, point, *diffuse({c.at_first.x, c.at_first.y, c.at_first.z}));
    }
    // A number: the roughness is interpolated between materials.
    const LoadedScene rough = load(bsdf("roughconductor", attribute("alpha", "vertex_rough")));
    const Instance& instance = rough.scene.instances().at(0);
    CHECK(instance.mesh->colors[1] == glm::vec3(0.4F));
    const double expected = evaluate(*rough_conductor({.alpha = 0.4}), 0, a_light, a_viewer)(0, 0);
    CHECK(reflected(*instance.material, {.color = glm::vec3(0.4F)}, 0, a_light, a_viewer) ==
          doctest::Approx(expected).epsilon(0.02));
    for (const auto& [inside, code, part] :
         {std::tuple(bsdf("diffuse", attribute("reflectance", "vertex_rest")), ErrorCode::invalid_argument,
                     "no attribute vertex_rest"),
          {bsdf("roughconductor", attribute("alpha", "vertex_tint")), ErrorCode::invalid_argument,
           "vertex_tint has three numbers"},
          {bsdf("roughconductor",
                attribute("alpha", "vertex_rough") + attribute("specular_reflectance", "vertex_tint")),
           ErrorCode::unsupported, "the attributes rough and tint"}}) {
        const std::string& content = inside;  // lambdas of Clang 14 capture no structured bindings
        CAPTURE(content);
        CHECK(error_of([&] { static_cast<void>(load(content)); }, code).find(part) != std::string::npos);
    }
}

TEST_CASE("a textured parameter makes the material that its value there would make") {
    const Folder folder;
    // Centres of the image's pixels, and of two checkerboard fields.
    const TexturePoint red{.uv = {0.25, 0.5}}, grey{.uv = {0.75, 0.5}};
    const TexturePoint first{.uv = {0.25, 0.25}}, second{.uv = {0.75, 0.25}};
    const double dark = srgb_to_linear(0.2F);
    const std::string rough = "<float name='alpha' value='0.3'/>";
    struct Case {
        std::string bsdf;
        TexturePoint point;
        MaterialPtr expected;
    };
    const auto plastic = [](const std::vector<double>& base, const std::vector<double>& boundary,
                            double alpha) {
        return pplastic({.diffuse_reflectance = base, .specular_reflectance = boundary, .alpha = alpha});
    };
    const std::string colors = bitmap("diffuse_reflectance");
    for (const Case& c : {
             Case{bsdf("diffuse", bitmap("reflectance")), red, diffuse({1, 0, 0})},
             Case{bsdf("diffuse", bitmap("reflectance")), grey, diffuse({dark, dark, dark})},
             Case{bsdf("diffuse", bitmap("reflectance", raw)), grey, diffuse({0.2, 0.2, 0.2})},
             Case{bsdf("pplastic", rough + colors), red, plastic({1, 0, 0}, {1}, 0.3)},
             Case{bsdf("pplastic", rough + bitmap("specular_reflectance")), red,
                  plastic({0.5}, {1, 0, 0}, 0.3)},
             Case{bsdf("pplastic", checkerboard("alpha")), first, plastic({0.5}, {1}, 0.25)},
             Case{bsdf("pplastic", checkerboard("alpha")), second, plastic({0.5}, {1}, 0.75)},
             // The roughness is the luminance of red.
             Case{bsdf("roughconductor", bitmap("alpha")), red, rough_conductor({.alpha = 0.2126})},
             Case{bsdf("roughconductor", checkerboard("alpha_u") + checkerboard("alpha_v")), second,
                  rough_conductor({.alpha = 0.75})},
             Case{bsdf("roughconductor", rough + bitmap("specular_reflectance")), grey,
                  rough_conductor({.specular_reflectance = {dark}, .alpha = 0.3})},
             Case{bsdf("conductor", bitmap("specular_reflectance")), red,
                  conductor({{0.0, -1.0}}, {1, 0, 0})},
             Case{bsdf("blendbsdf", checkerboard("weight") + bsdf("diffuse", bitmap("reflectance")) +
                                        bsdf("diffuse", "<rgb name='reflectance' value='0'/>")),
                  first, diffuse({0.75, 0, 0})},
             Case{bsdf("diffuse", texture("reflectance", "mesh_attribute",
                                          "<string name='name' value='vertex_color'/><float name='scale' "
                                          "value='0.5'/>")),
                  TexturePoint{.color = {1, 0.5, 0.25}}, diffuse({0.5, 0.25, 0.125})},
             Case{bsdf("diffuse",
                       texture("reflectance", "mesh_attribute", "<string name='name' value='face_color'/>")),
                  TexturePoint{.color = {1, 0.5, 0.25}}, diffuse({1, 0.5, 0.25})},
             Case{bsdf("twosided", bsdf("pplastic", rough + colors)), red,
                  twosided(plastic({1, 0, 0}, {1}, 0.3))},
         }) {
        CAPTURE(c.bsdf);
        check_same(*folder.load_material(c.bsdf), c.point, *c.expected);
    }
}

TEST_CASE("normals, heights and opacities reach the material") {
    const Folder folder;
    const TexturePoint red{.uv = {0.25, 0.5}};
    const std::string plain = bsdf("diffuse", "");
    const MaterialPtr mapped = folder.load_material(bsdf("normalmap", bitmap("", raw) + plain));
    REQUIRE(mapped->variation());
    const NormalVariation& normal = mapped->variation()->normal;
    CHECK(normal.kind == NormalVariation::Kind::map);
    CHECK_FALSE(normal.mirrored_y);
    CHECK(glm::vec3(normal.texture->at(red)) == glm::vec3(1, 0, 0));
    const MaterialPtr bumped =
        folder.load_material(bsdf("bumpmap", "<float name='scale' value='3'/>" + bitmap("", raw) + plain));
    REQUIRE(bumped->variation());
    CHECK(bumped->variation()->normal.kind == NormalVariation::Kind::bump);
    CHECK(bumped->variation()->normal.scale == 3);
    CHECK(bumped->variation()->normal.texture->at(red).x == doctest::Approx(0.2126));
    const MaterialPtr cut = folder.load_material(bsdf("mask", bitmap("opacity", raw) + plain));
    REQUIRE(cut->variation());
    CHECK(cut->variation()->opacity->at(red).x == doctest::Approx(0.2126));
    // A normal map shared by both parts applies to the whole blend.
    const std::string part = bsdf("normalmap", bitmap("", raw) + plain);
    const MaterialPtr both = folder.load_material(bsdf("blendbsdf", checkerboard("weight") + part + part));
    REQUIRE(both->variation());
    CHECK(both->variation()->normal.kind == NormalVariation::Kind::map);
    CHECK(both->variation()->layers.size() == 2);
}

TEST_CASE("a mask covers a fraction, and a bump map without interpolation is flat, with a notice") {
    const Folder folder;
    const std::string plain = bsdf("diffuse", "");
    const LoadedScene half = folder.load(bsdf("mask", "<float name='opacity' value='0.25'/>" + plain));
    CHECK(half.notices.empty());
    const SpatialVariation* const variation = half.scene.instances().front().material->variation();
    REQUIRE(variation);
    CHECK(variation->translucent);
    CHECK(variation->opacity->mean().x == 0.25F);
    const MaterialPtr whole = folder.load_material(bsdf("mask", "<float name='opacity' value='1'/>" + plain));
    CHECK(!whole->variation());

    const std::string nearest = "<string name='filter_type' value='nearest'/>";
    const LoadedScene flat = folder.load(bsdf("bumpmap", bitmap("", nearest) + plain));
    CHECK(!flat.scene.instances().front().material->variation());
    REQUIRE(flat.notices.size() == 1);
    CHECK(flat.notices.front().find("flat") != std::string::npos);
}

TEST_CASE("maps are dimmed at a slant unless told otherwise, and reversed around a two-sided bsdf") {
    const Folder folder;
    const std::string plain = bsdf("diffuse", "");
    const std::string off = "<boolean name='use_shadowing_function' value='false'/>";
    for (const char* const map : {"normalmap", "bumpmap"}) {
        CAPTURE(map);
        const auto normal_of = [&](const std::string& inside) {
            const MaterialPtr material = folder.load_material(bsdf(map, bitmap("", raw) + inside));
            REQUIRE(material->variation());
            return material->variation()->normal;
        };
        CHECK(normal_of(plain).shadowed);
        CHECK(!normal_of(off + plain).shadowed);
        CHECK(!normal_of(plain).reversed_back);
        CHECK(normal_of(bsdf("twosided", plain)).reversed_back);
    }
}

TEST_CASE("images are read once, recorded, and count as bytes of the load") {
    const Folder folder;
    const std::string two =
        bsdf("pplastic", bitmap("diffuse_reflectance") +
                             bitmap("specular_reflectance", "<string name='wrap_mode' value='clamp'/>"));
    const LoadedScene loaded = folder.load(two);
    REQUIRE(loaded.files.size() == 3);
    CHECK(std::ranges::count(loaded.files, folder / "a.png", &FileRecord::path) == 1);
    const std::uint64_t files = file_size(folder / "a.png") + file_size(folder / "a.ply");
    // The image has six values of 4 bytes and is decoded once. A texture takes 16 bytes per pixel.
    static_cast<void>(folder.load(two, {.bytes = files + 24 + 64}));
    static_cast<void>(error_of(CALL(folder.load(two, {.bytes = files + 24 + 63})), ErrorCode::unsupported));
    // Equal textures are stored once.
    const std::string same = bsdf("pplastic", bitmap("diffuse_reflectance") + bitmap("specular_reflectance"));
    static_cast<void>(folder.load(same, {.bytes = files + 24 + 32}));
    const std::string missing = "<string name='filename' value='none.png'/>";
    const std::string message =
        error_of(CALL(folder.load(bsdf("diffuse", texture("reflectance", "bitmap", missing)))),
                 ErrorCode::file_not_found);
    CHECK(message.find("a.xml: bsdf: ") != std::string::npos);
    CHECK(message.find("none.png") != std::string::npos);
    folder.write("none.png", "no image");
    static_cast<void>(error_of(CALL(folder.load(bsdf("diffuse", texture("reflectance", "bitmap", missing)))),
                               ErrorCode::unsupported));
}

TEST_CASE("v is turned where a file counts it upwards, unless the scene says otherwise") {
    const TemporaryFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.125 0.25\nf 1/1 2/1 3/1\n");
    folder.write("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nproperty float u\nproperty float v\nelement face 1\n"
                 "property list uchar int vertex_indices\nend_header\n"
                 "0 0 0 0.125 0.25\n1 0 0 0.125 0.25\n0 1 0 0.125 0.25\n3 0 1 2\n");
    const auto v_of = [&](const std::string& type, const std::string& inside) {
        const auto file = folder.write(
            "a.xml", ::scene(a_sensor + an_emitter + "<shape type='" + type +
                             "'><string name='filename' value='a." + type + "'/>" + inside + "</shape>"));
        const Mesh mesh = *load_scene(file, {}).scene.instances().at(0).mesh;
        CHECK(mesh.texcoords.at(0).x == 0.125F);
        return mesh.texcoords.at(0).y;
    };
    const std::string yes = "<boolean name='flip_tex_coords' value='true'/>";
    const std::string no = "<boolean name='flip_tex_coords' value='false'/>";
    CHECK(v_of("obj", "") == 0.75F);
    CHECK(v_of("obj", yes) == 0.75F);
    CHECK(v_of("obj", no) == 0.25F);
    CHECK(v_of("ply", "") == 0.25F);
    CHECK(v_of("ply", yes) == 0.75F);
}

TEST_CASE("Mitsuba's scenes with textures are read") {
    const std::filesystem::path folder = test_data("mitsuba_scenes/tests/scenes/bsdf_spheres");
    if (folder.empty()) return;
    for (const char* name : {"bumpmap", "normalmap", "textured_diffuse", "textured_roughconductor",
                             "normalmap_roughconductor", "normalmap_identity_roughconductor"}) {
        CAPTURE(name);
        const LoadedScene loaded = load_scene(folder / ("test_" + std::string(name) + "_path.xml"), {});
        CHECK(loaded.notices.size() == 1);
        CHECK(loaded.scene.instances().size() == 2);
        CHECK(loaded.scene.lights().size() == 1);
    }
}
