// SPDX-License-Identifier: MIT
#include "inspect_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "harmonics/rotation.hpp"
#include "inspect_image.hpp"
#include "light/cube_cross.hpp"
#include "light/cube_names.hpp"
#include "light/equirect.hpp"
#include "light/light_report.hpp"
#include "light/psh_file.hpp"
#include "shading/physical_range.hpp"

namespace nicol::capi {
namespace {

using std::filesystem::path;

constexpr int default_order = 32;

std::shared_ptr<const ImageLight> scaled(EquirectImage image, double scale) {
    for (float& value : image.data) {
        value = static_cast<float>(scale * static_cast<double>(value));
        if (!std::isfinite(value)) refuse("options->scale makes the light exceed the range of 32-bit floats");
    }
    return std::make_shared<const ImageLight>(std::move(image));
}

// The s0-weighted mean direction that light comes from.
glm::dvec3 mean_direction(const EquirectImage& image, int channel) {
    glm::dvec3 sum(0);
    double total = 0;
    for (int y = 0; y < image.height; ++y) {
        const double v = y / (image.height - 1.0);
        const double area = std::sin(std::numbers::pi * v);
        for (int x = 0; x < image.width; ++x) {
            const double weight = area * std::max(0.0, image.stokes(channel, y, x)[0]);
            sum += weight * equirect_direction((x + 0.5) / image.width, v);
            total += weight;
        }
    }
    return total > 0 ? sum / total : sum;
}

}  // namespace

int LightSource::order(const FileOptions& options) const {
    if (options.order) return *options.order;
    return image ? default_order : coefficients.order();
}

PshVector LightSource::project(const FileOptions& options) const {
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

EquirectImage LightSource::draw(const FileOptions& options, int least_width) const {
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

LightSource light_source(const Environment& light, const FileOptions& options) {
    if (!options.wavelengths.empty()) refuse("wavelengths can be chosen from spectral files only");
    LightSource out;
    EquirectImage image = light.image();
    out.width = image.width;
    out.image = scaled(std::move(image), options.scale);
    return out;
}

LightSource read_light(const path& file, nicol_file_kind kind, const FileOptions& options) {
    if (!options.wavelengths.empty() && kind != NICOL_FILE_LIGHT_IMAGE)
        refuse(file.string() + ": wavelengths can be chosen from spectral files only");
    LightSource out;
    if (kind == NICOL_FILE_LIGHT_PSH) {
        if (options.band_limited) refuse(file.string() + ": NICOL_FILE_BAND_LIMITED is for images to read");
        out.coefficients = read_psh_vector(file);
        for (double& value : out.coefficients.data()) value *= options.scale;
        return out;
    }
    EquirectImage image;
    if (kind == NICOL_FILE_LIGHT_CROSS)
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

void write_light(const LightSource& light, const FileOptions& options, const path& file) {
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

void report_light(const LightSource& light, const FileOptions& options, nicol_light_report& report,
                  std::span<double> energy) {
    FileOptions as_it_is = options;
    if (light.image) as_it_is.order.reset();
    const ImageLight seen(light.draw(as_it_is));
    const LightReport found = describe(seen, 0);
    report.channels = static_cast<std::uint32_t>(seen.channels());
    report.order = static_cast<std::uint32_t>(light.order(options));
    report.width = static_cast<std::uint32_t>(found.width);
    report.height = static_cast<std::uint32_t>(found.height);
    report.polarized = found.polarized ? 1 : 0;
    report.circular = found.circular ? 1 : 0;
    std::ranges::copy(found.wavelengths, report.wavelengths);
    const EquirectImage image = seen.image();
    for (int c = 0; c < seen.channels(); ++c) {
        const LightChannelReport& channel = found.channels[static_cast<std::size_t>(c)];
        report.mean[c] = channel.mean;
        report.smallest[c] = channel.smallest;
        report.largest[c] = channel.largest;
        report.mean_dolp[c] = channel.mean_dolp;
        report.largest_dolp[c] = channel.largest_dolp;
        report.largest_circular[c] = channel.circular;
        report.unphysical[c] = channel.unphysical;
        report.largest_excess[c] = channel.largest_excess;
        const glm::dvec3 direction = mean_direction(image, c);
        for (int i = 0; i < 3; ++i) report.direction[3 * c + i] = direction[i];
    }
    if (energy.empty()) return;
    const PshVector field = light.project(options);
    std::size_t at = 0;
    for (int c = 0; c < field.channels(); ++c)
        for (int l = 0; l <= field.order(); ++l)
            for (int p = 0; p < 4; ++p, ++at) {
                energy[at] = 0;
                for (int m = -l; m <= l; ++m) energy[at] += std::pow(field.at(c, l, m, p), 2);
            }
}

}  // namespace nicol::capi
