// SPDX-License-Identifier: MIT
#include "inspect/light_file.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "harmonics/rotation.hpp"
#include "light/cube_cross.hpp"
#include "light/equirect.hpp"
#include "light/equirect_projection.hpp"
#include "light/image_light.hpp"
#include "light/psh_file.hpp"
#include "shading/realizable_range.hpp"

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

/// Returns a rotated light as an image. Each pixel is a bilinear look-up, or the mean of several look-ups if
/// the pixels are larger than those of an image of `source_width` columns.
EquirectImage resample_image(const Environment& light, const glm::dmat3& rotation, int source_width,
                             int width, int height) {
    EquirectImage image(width, height, light.channels());
    image.wavelengths = light.wavelengths();
    const int steps = std::clamp((source_width + width - 1) / width, 1, 64);
    std::vector<Stokes> sums(static_cast<std::size_t>(light.channels()));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::ranges::fill(sums, Stokes(0));
            double area = 0;
            for (int j = 0; j < steps; ++j) {
                const double v = (y + (j + 0.5) / steps - 0.5) / (height - 1);
                // Beyond a pole lies the opposite meridian, whose frame is continued across the pole.
                const double weight = steps == 1 ? 1 : std::abs(std::sin(std::numbers::pi * v));
                for (int i = 0; i < steps; ++i) {
                    const double u = (x + (i + 0.5) / steps) / width;
                    const glm::dvec3 from =
                        glm::normalize(glm::transpose(rotation) * equirect_direction(u, v));
                    const double angle =
                        angle_between(rotation * theta_phi_frame(-from), equirect_frame(u, v));
                    for (std::size_t c = 0; c < sums.size(); ++c)
                        sums[c] += weight * rotated(light.radiance(static_cast<int>(c), from), angle);
                    area += weight;
                }
            }
            for (std::size_t c = 0; c < sums.size(); ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    image.at(static_cast<int>(c), y, x)[p] =
                        static_cast<float>(sums[c][static_cast<glm::length_t>(p)] / area);
        }
    }
    return image;
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
        // The pixels of the cube map are bilinear look-ups in a finer equirectangular image.
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
    if (light.image) drawing.order.reset();  // `order` limits only the energies of an image
    return describe(ImageLight(light.draw(drawing)), energies ? light.project(options) : PshVector());
}

}  // namespace nicol
