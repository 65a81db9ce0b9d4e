// SPDX-License-Identifier: MIT
// Scenes of files, as plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/file_record.hpp"
#include "files/load_budget.hpp"
#include "geometry/mesh.hpp"
#include "geometry/sdf_grid.hpp"
#include "image/reconstruction_filter.hpp"
#include "import/color_description.hpp"
#include "import/material_description.hpp"
#include "import/scene_animation.hpp"
#include "import/texture_specification.hpp"
#include "light/local_light.hpp"
#include "polarization/element.hpp"
#include "scene/path_depth.hpp"

namespace nicol {

/// A camera and the size of its image. Camera space: +z forward, +x image LEFT, +y image up.
struct SensorDescription {
    enum class Kind { perspective, orthographic };
    enum class FovAxis { x, y, diagonal, smaller, larger };
    Kind kind = Kind::perspective;
    double fov = 0.0;  ///< perspective: degrees along fov_axis, in (0, 180)
    FovAxis fov_axis = FovAxis::x;
    /// Camera to world, affine. Orthographic: the image spans [-1, 1] of camera x, and of y by the aspect.
    glm::dmat4 to_world{1.0};
    double near_clip = 1e-2;
    double far_clip = 1e4;
    int width = 768;  ///< width of the film
    int height = 576;
    struct Crop {
        glm::ivec2 offset{0};  ///< pixels right and down
        glm::ivec2 size{0};
    };
    std::optional<Crop> crop;  ///< none: all of it
    /// Offset of the film's middle from the view direction, right and down, in its widths and heights.
    glm::dvec2 principal_point_offset{0.0};
    bool luminance = false;          ///< the film has one channel, the luminance
    std::uint32_t sample_count = 0;  ///< samples of a pixel that the sampler asks for; 0: there is no sampler
    ReconstructionFilter filter;     ///< filter of the film
};

/// Returns the horizontal field of view of an image, in degrees. fov: degrees along `axis`; aspect: width
/// over height.
[[nodiscard]] double horizontal_fov(double fov, SensorDescription::FovAxis axis, double aspect);
/// Returns the horizontal field of view of a perspective sensor, in degrees.
[[nodiscard]] double horizontal_fov(const SensorDescription& sensor);

/// Emission of a surface, see Emission.
struct EmissionDescription {
    TexturedColor radiance{1.0};
    double scale = 1.0;  ///< times radiance
    bool two_sided = false;
    PolarizationState state;
};

struct ShapeDescription {
    enum class Kind {
        file,
        sphere,
        rectangle,
        cube,
        disk,
        cylinder,
        linear_curve,
        bspline_curve,
        sdf_grid,
        mesh
    };
    Kind kind = Kind::file;
    std::string id;  ///< own id of an instance; empty when the file gives none
    std::filesystem::path
        filename;  ///< file: of any format that load_mesh() reads; others: see load_curves(), load_sdf_grid()
    std::size_t index = 0;   ///< file: of its meshes, where the format holds several
    glm::dvec3 center{0.0};  ///< sphere
    double radius = 1.0;     ///< sphere, cylinder
    int segments = 0;        ///< sphere: see make_sphere(); 0: by its size in the picture
    SdfNormals sdf_normals = SdfNormals::smooth;  ///< SDF grid
    glm::dvec3 p0{0.0};                           ///< cylinder: the ends of its axis
    glm::dvec3 p1{0.0, 0.0, 1.0};
    std::shared_ptr<const Mesh> mesh;  ///< mesh: itself, the scene file holds it; validated
    bool flip_normals = false;
    bool face_normals = false;     ///< file: hard edges everywhere
    bool flip_tex_coords = false;  ///< file: v becomes 1 - v
    /// Textures in the place of attributes, by the whole name such as "vertex_weight".
    std::map<std::string, TextureSpecificationPtr> attributes;
    glm::dmat4 to_world{1.0};                     ///< affine and invertible
    bool present = true;                          ///< false: an animation leaves nothing of it to draw
    std::size_t material = 0;                     ///< index into SceneDescription::materials
    std::optional<EmissionDescription> emission;  ///< none: it emits no light
};

/// Light from all around.
struct EnvironmentDescription {
    enum class Kind { envmap, psh, constant, sky };
    Kind kind = Kind::constant;
    std::filesystem::path filename;  ///< envmap: EXR; psh: a PSH vector (.npz)
    double scale = 1.0;              ///< envmap, psh
    ColorDescription radiance{1.0};  ///< constant, sky
    glm::dvec3 sun_direction{0.0};   ///< sky: unit, towards the sun, in the emitter's frame (y up)
    double dop_max = 0.8;            ///< sky: degree of polarization at 90 degrees from the sun, in [0, 1]
    double turbidity = 0.0;          ///< sky: 0, light scattered once; or 1.7 to 10, very clear to hazy
    ColorDescription ground_albedo{0.2};  ///< sky with turbidity: 0 to 1
    bool sun = false;                     ///< sky: whether the sun's own disc lights the scene as well
    glm::dmat4 to_world{1.0};             ///< affine and invertible; only its rotation matters
};

/// A light without a surface, see LocalLight.
struct LightDescription {
    std::string id;         ///< empty when the file gives none
    LocalLight parameters;  ///< all but the parameters below. to_world: affine and invertible; only its
                            ///< rotation and shift matter
    ColorDescription value{1.0};
    double scale = 1.0;  ///< times value
    double fov = 45.0;   ///< projector: degrees along fov_axis, in (0, 180)
    SensorDescription::FovAxis fov_axis = SensorDescription::FovAxis::x;
    TextureSpecificationPtr texture;  ///< spot, projector, whose rectangle has its shape; null: none
};

/// A polarization element.
struct ElementDescription : PolarizationElement {
    std::string where;  ///< file and line
    /// Factors on the angle and on the retardance, see ElementTextures. Null: 1.
    TextureSpecificationPtr angle_texture = nullptr, retardance_texture = nullptr;

    [[nodiscard]] bool textured() const noexcept {
        return angle_texture != nullptr || retardance_texture != nullptr;
    }
};

/// The parameters of an integrator that have an effect.
struct IntegratorDescription {
    /// Largest depth of paths of light (scene/path_depth.hpp), 1..kUnlimitedDepth; 0: the file has no
    /// integrator.
    int max_depth = 0;
    bool hide_emitters = false;  ///< see Scene::hide_emitters()
    std::uint32_t aovs = 0;      ///< bits of AovBit that the file asks for

    /// Returns whether light is asked for that surfaces reflect to each other, which Mitsuba computes where a
    /// file has no integrator.
    [[nodiscard]] bool reflects_often() const noexcept {
        return max_depth == 0 || max_depth > kDirectLightDepth;
    }
};

struct SceneDescription {
    IntegratorDescription integrator;
    SensorDescription sensor;
    std::vector<MaterialDescription> materials;
    std::vector<ShapeDescription> shapes;
    std::optional<EnvironmentDescription> environment;
    std::vector<LightDescription> lights;
    std::vector<ElementDescription> elements;  ///< those that do not stand directly before an area light
    std::shared_ptr<const SceneAnimation> animation;  ///< null: nothing moves
    std::vector<FileRecord> files;                    ///< the scene file and those that it includes
    std::vector<std::string> notices;                 ///< elements read and not followed; one sentence each
};

/// Largest number of shapes of one scene, including instances, whose memory the size of the files does not
/// bound.
inline constexpr std::size_t kMaxShapes = 100000;

/// Values for the file's $parameters, by name without the $; they win over <default>.
using SceneParameters = std::map<std::string, std::string>;

/// Reads a scene of Mitsuba 3's XML format. Plug-ins, parameters and defaults are Mitsuba's, apart from the
/// exceptions below. The table of a kind of object names its types: kMaterialTypes of material_readers.hpp
/// for bsdfs, mesh_format_names() and shape.cpp for shapes, local_light.cpp and environment.cpp for emitters.
/// - Shapes off and stl, the bsdf psh, and the emitters psh and sky do not exist in Mitsuba. Emitters other
///   than envmap and constant take the Stokes state of their light: dolp, aolp in degrees, docp,
///   polarization_axis. A light given by its position or direction has its polarization_axis in the world's
///   axes, a light with to_world in its own axes. directional takes angular_radius, and area takes two_sided.
/// - Rectangles and disks whose bsdf is polarizer, retarder or circular become the Stokes state of the area
///   lights directly behind them, see PolarizationElements, as at normal incidence. Other such shapes become
///   elements of the scene, and load_scene() puts them before the scene's lights.
/// - An emissive shape without a bsdf is black; any other shape without a bsdf is grey.
/// - An instance becomes one shape for each member of its group.
/// - An integrator's max_depth, AOVs and hide_emitters and a sampler's sample_count have an effect. One
/// notice
///   names the other parameters of integrators and samplers.
/// - A roughness that differs by direction becomes its geometric mean, with a notice, if the material is
///   isotropic.
/// - <rgb> takes one value, three values, or #rrggbb, which stands for linear values of n / 255. <spectrum>
///   also takes a file, which is read: lines with a wavelength in nm and a value; comments begin with #.
/// - Files are looked for in the folders of <path>, the newest first, then in the folder of the file that
///   names them, then in the folders of the files that include that file. If none has the file, the name is
///   relative to the folder of the file that names it. Files other than spectra and includes are not opened.
/// Throws Error with these codes. Messages name file:line, the plug-in, the parameter, what is accepted, and,
/// within an included file, the files that include it.
/// - file_not_found: the file, an <include> or a spectrum is missing;
/// - unsupported: a plug-in, element or value that Nicol lacks; more than 1000 files, or files of more than
///   16 MiB together;
/// - invalid_file: XML that is not well-formed, unknown or missing parameters, values out of range, undefined
///   $parameters (except those of samplers), missing or repeated ids, includes in a circle or more than 15
///   deep;
/// - invalid_argument: an entry of `parameters` that the files do not use.
[[nodiscard]] SceneDescription read_mitsuba_scene(const std::filesystem::path& file,
                                                  const SceneParameters& parameters = {},
                                                  const LoadBudget& budget = {});

/// Reads the default scene of a glTF 2.0 file, text or binary, with its buffers. Its axes are the world's.
/// - Shapes are the primitives of triangles, strips and fans of each node; nodes with the same mesh share
///   it. Without NORMAL they are flat. Colours and texture coordinates (v downwards) are the file's; those of
///   the set that the base colour takes, where there are several.
/// - A metallicFactor of 0 makes pplastic, 1 roughconductor, and any between both, blended; GGX with alpha =
///   roughness^2. Base colour, metal, roughness, normals and alphaMode MASK follow their textures.
/// - KHR_materials_pbrSpecularGlossiness makes pplastic and a mirror, mixed in each colour. It is followed
///   where the file requires it or gives no metallic-roughness.
/// - KHR_materials_unlit makes a black surface that emits the base colour.
/// - By KHR_materials_variants a primitive has its default material, else that of the first variant.
/// - The sensor is the first camera; without one it looks along -z, its image 45 degrees high, and the sphere
///   around the box of the scene fits in. The film is 768 pixels wide and as high as the camera's aspect
///   ratio says, else 576. There is no environment.
/// - Lights are those of KHR_lights_punctual, with the file's intensities. A spot falls off linearly in the
///   angle between its cones. A range has no effect.
/// - Nodes have the transforms and morph weights that an animation gives at the parameter `time`, in seconds;
///   without it their own. The parameter `animation` is the animation's name or index, the first by default.
/// - Vertices follow morph targets and skins. The transform of a node with a skin has no effect.
/// - Notices name what is not followed: occlusion, emission, alphaMode BLEND, ranges of lights, animations
///   without a time, points and lines, extensions without effect.
/// Throws Error: file_not_found (also of a buffer); unsupported (another version, an unknown required
/// extension, buffers and images outside the folder of the file, more than kMaxShapes,
/// what exceeds `budget`); invalid_file (malformed, references or data out of range, nodes in a circle,
/// nothing to draw), naming the element; invalid_argument (a parameter that is not used, or no number or
/// animation). Memory is proportional to the size of the files, times the number of primitives that share
/// data, up to the limits of `budget`.
[[nodiscard]] SceneDescription read_gltf_scene(const std::filesystem::path& file,
                                               const SceneParameters& parameters = {},
                                               const LoadBudget& budget = {});

}  // namespace nicol
