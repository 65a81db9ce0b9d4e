// SPDX-License-Identifier: MIT
#include "inspect/light_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "arguments.hpp"
#include "harmonics/rotation.hpp"
#include "inspect/resample.hpp"
#include "light/cube_cross.hpp"
#include "light/equirect_projection.hpp"
#include "light/image_light.hpp"
#include "light/psh_file.hpp"
#include "shading/physical_range.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

constexpr int kLightOrder = 32;

std::shared_ptr<const ImageLight> scaled(EquirectImage image, double scale) {
    for (float& value : image.data) {
        value = static_cast<float>(scale * static_cast<double>(value));
        if (!std::isfinite(value)) refuse("options->scale makes the light exceed the range of 32-bit floats");
    }
    return std::make_shared<const ImageLight>(std::move(image));
}

}  // namespace

int LightFile::order(const FileOptions& options) const {
    if (options.order) return *options.order;
    return image ? kLightOrder : coefficients.order();
}

PshVector LightFile::project(const FileOptions& options) const {
    const int highest = order(options);
    PshVector out;
    if (!image)
        out = with_order(coefficients, highest);
    else if (options.band_limited)
        out = project_samples_of(image->image(), highest);
    else
        out = image->project(highest);
    return options.rotation ? rotated(out, *options.rotation) : out;
}

EquirectImage LightFile::draw(const FileOptions& options, int least_width) const {
    EquirectImage out;
    if (image && !options.order) {
        if (options.width != 0 || options.rotation) {
            const int w = options.width != 0 ? options.width : width;
            const int h = options.height != 0 ? options.height : image->image().height;
            out = resample_image(*image, options.rotation.value_or(glm::dmat3(1)), width, w, h);
        } else {
            out = image->image();
        }
    } else {
        const PshVector field = project(options);
        int w = options.width;
        if (w == 0)
            for (w = least_width; w < 4 * (field.order() + 1) && w < 4096;) w *= 2;
        out = synthesize_image(field, w, options.height != 0 ? options.height : w / 2 + 1);
        if (image) out.wavelengths = image->wavelengths();
    }
    if (options.physical) make_physical({reinterpret_cast<glm::vec4*>(out.data.data()), out.data.size() / 4});
    return out;
}

LightFile light_file(const Environment& light, const FileOptions& options) {
    if (!options.wavelengths.empty()) refuse("wavelengths can be chosen from spectral files only");
    LightFile out;
    EquirectImage image = light.image();
    out.width = image.width;
    out.image = scaled(std::move(image), options.scale);
    return out;
}

LightFile read_light_file(const path& file, FileKind kind, const FileOptions& options) {
    if (!options.wavelengths.empty() && kind != FileKind::light_image)
        refuse(file.string() + ": wavelengths can be chosen from spectral files only");
    LightFile out;
    if (kind == FileKind::light_psh) {
        if (options.band_limited) refuse(file.string() + ": NICOL_FILE_BAND_LIMITED is for images to read");
        out.coefficients = read_psh_vector(file);
        for (double& value : out.coefficients.data()) value *= options.scale;
        return out;
    }
    EquirectImage image;
    if (kind == FileKind::light_cross)
        image = equirect_from_cross(read_cube_cross(file));
    else
        static_cast<StokesImage&>(image) = read_exr(file, options.wavelengths);
    if (image.width < 2 || image.height < 2)
        throw Error(ErrorCode::invalid_file, file.string() + ": has " + std::to_string(image.width) + " x " +
                                                 std::to_string(image.height) +
                                                 " pixels; light needs at least 2 x 2");
    out.width = image.width;
    out.image = scaled(std::move(image), options.scale);
    return out;
}

void write_light_file(const LightFile& light, const FileOptions& options, const path& file) {
    if (const auto stem = cube_cross_stem(file)) {
        if (options.width != 0)
            refuse("width and height are those of an equirectangular image; a cube map has an edge");
        const int edge = options.edge != 0 ? options.edge : 256;
        // Its pixels are looked up bilinearly, in an image that is finer.
        write_cube_cross(*stem, ImageLight(light.draw(options, std::clamp(8 * edge, 512, 4096))), edge);
    } else if (file.extension() == ".exr") {
        if (options.edge != 0) refuse("edge is that of a cube map, whose name ends in _s0.exr");
        write_environment(file, ImageLight(light.draw(options)));
    } else if (file.extension() == ".npz") {
        require_no_image_options(options, "coefficients");
        write_psh_vector(file, light.project(options));
    } else {
        refuse(file.string() + ": light is written as .exr, _s0.exr or .npz");
    }
}

LightReport describe(const LightFile& light, const FileOptions& options, bool energies) {
    FileOptions drawing = options;
    if (light.image) drawing.order.reset();  // which limits the energies of an image alone
    return describe(ImageLight(light.draw(drawing)), energies ? light.project(options) : PshVector());
}

}  // namespace nicol
