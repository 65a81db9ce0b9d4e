// SPDX-License-Identifier: MIT
// Reading and writing of light files.
#include <algorithm>
#include <cstdio>
#include <string>

#include "error.hpp"
#include "image/bitmap.hpp"
#include "light/cube_cross.hpp"
#include "light/environment_checks.hpp"
#include "light/psh_file.hpp"

namespace nicol {

using std::filesystem::path;

const std::vector<double>& Environment::wavelengths() const noexcept {
    static const std::vector<double> none;
    return none;
}

namespace {

bool is_cube(const path& file, const FileSource& files) {
    return cube_cross_stem(file) ||
           (!file.empty() && !files.find(file) && files.find(cube_cross_file(file, 0)));
}

/// Returns the light of a bitmap's colours. Takes the memory of the image from `budget`.
StokesImage light_of(const Bitmap& bitmap, const LoadBudget& budget) {
    budget.take_memory(4 * sizeof(float) * static_cast<std::uint64_t>(bitmap.width) *
                       static_cast<std::uint64_t>(bitmap.height) * (bitmap.channels < 3 ? 1 : 3));
    budget.check();
    return unpolarized_image(bitmap);
}

}  // namespace

std::vector<path> environment_files(const path& file, const FileSource& files) {
    if (!is_cube(file, files)) return {file};
    const path stem = cube_cross_stem(file).value_or(file);
    constexpr int components = 4;
    std::vector<path> all;
    all.reserve(components);
    for (int component = 0; component < components; ++component)
        all.push_back(cube_cross_file(stem, component));
    return all;
}

EnvironmentPtr load_environment(const path& file, double scale, std::span<const double> wavelengths,
                                const LoadBudget& budget) {
    const std::string name = file.string();
    check_scale(name, scale);
    const bool coefficients = file.extension() == ".npz";
    const bool cube = is_cube(file, budget.files());
    const bool bitmap = is_bitmap(file);
    if (!wavelengths.empty() && (coefficients || cube || bitmap))
        throw Error(ErrorCode::invalid_argument,
                    name + ": wavelengths can be chosen from spectral EXR files only");
    if (coefficients) {
        PshVector field = read_psh_vector(file, budget);
        for (double& value : field.data()) value *= scale;
        return psh_environment(std::move(field));
    }
    if (cube) {
        CubeCross cross = read_cube_cross(file, budget);
        const std::vector<double> weights(static_cast<std::size_t>(cross.height), 1.0);
        const double negative =
            examine_image(view_of(cross), 1, weights, name, ErrorCode::invalid_file).negative;
        if (negative > 0)
            for (std::size_t i = 0; i < cross.data.size(); i += 4)
                cross.data[i] = std::max(cross.data[i], 0.0F);
        const EquirectImage image = equirect_from_cross(cross, budget);
        return checked_environment(view_of(image), image.wavelengths, scale, name, ErrorCode::invalid_file,
                                   negative);
    }
    const StokesImage image =
        bitmap ? light_of(read_bitmap(file, budget), budget) : read_exr(file, wavelengths, budget);
    budget.check();
    return checked_environment(view_of(image), image.wavelengths, scale, name, ErrorCode::invalid_file);
}

std::string notice_of_negative(const Environment& environment, const std::string& name) {
    if (environment.negative_share() == 0) return "";
    char share[32];
    (void)std::snprintf(share, sizeof share, "%.2g", 100 * environment.negative_share());
    return name + ": has negative radiance, up to " + share +
           " % of the positive in a channel, which was set to 0";
}

void write_environment(const path& file, const Environment& environment) {
    write_exr(
        file, environment.image(),
        {.components = environment.polarized() ? kStokesAll : 0u,
         .frame = "equirectangular, y up, over the directions the light comes from; z propagation, x image "
                  "right (increasing u), y image up; s3 > 0 right circular"});
}

}  // namespace nicol
