// SPDX-License-Identifier: MIT
// Environments.
#include "assets.hpp"
#include "initialiser.hpp"
#include "psh_arguments.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

std::shared_ptr<void> owned_pixels(const nicol_image* image) {
    return owned_user(image, &nicol_image::release, &nicol_image::release_user,
                      offsetof(nicol_image, release_user) + sizeof image->release_user);
}

EquirectView view_of(const nicol_image& image) {
    require(image.pixels, "image->pixels");
    if (image.width < 2 || image.width > NICOL_MAX_SIZE || image.height < 2 ||
        image.height > NICOL_MAX_SIZE) {
        refuse("image is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
               " pixels; width and height must lie in 2 to " + std::to_string(NICOL_MAX_SIZE));
    }
    require_channels(image.channels, "image->channels");
    if (image.components != 1 && image.components != 4) {
        refuse("image->components is " + std::to_string(image.components) +
               "; it must be 1 (s0) or 4 (s0..s3)");
    }
    const std::uint64_t row = std::uint64_t{image.width} * image.channels * image.components * sizeof(float);
    const std::uint64_t stride = image.row_stride == 0 ? row : image.row_stride;
    if (stride < row || stride % sizeof(float) != 0 || stride > (std::uint64_t{1} << 40)) {
        refuse("image->row_stride is " + std::to_string(stride) + "; a row takes " + std::to_string(row) +
               " bytes, and strides are multiples of 4");
    }
    const std::uint64_t needed = stride * (image.height - 1) + row;
    if (image.byte_size < needed) {
        refuse("image->byte_size is " + std::to_string(image.byte_size) + "; the image takes " +
               std::to_string(needed) + " bytes");
    }
    return {.width = static_cast<int>(image.width),
            .height = static_cast<int>(image.height),
            .channels = static_cast<int>(image.channels),
            .components = static_cast<int>(image.components),
            .values = image.pixels,
            .channel_stride = image.components,
            .row_stride = stride / sizeof(float),
            .pixel_stride = std::size_t{image.channels} * image.components};
}

void tell_negative(const Session& session, const Environment& light, const std::string& name) {
    const std::string negative = notice_of_negative(light, name);
    if (!negative.empty()) session.notice(negative);
}

EnvironmentPtr from_file(const std::filesystem::path& path, const nicol_environment_load_options* options,
                         const LoadBudget& budget) {
    const auto given =
        read_options(options, nicol_environment_load_options NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT);
    if (given.reserved != 0) refuse("options->reserved must be 0");
    return load_environment(path, given.scale, spectrum(given.wavelengths, 0, 0, "options->wavelengths"),
                            budget);
}

/// Loads an environment, for load().
struct EnvironmentLoader {
    const nicol_environment_load_options* options;

    EnvironmentPtr operator()(const std::filesystem::path& path, const LoadBudget& budget,
                              const SessionPtr& session) const {
        for (const std::filesystem::path& file : environment_files(path, budget.files()))
            budget.take_file(file);
        EnvironmentPtr light = session->on_workers([&] { return from_file(path, options, budget); });
        tell_negative(*session, *light, path.string());
        return light;
    }
};

EnvironmentPtr from_coefficients(std::uint32_t order, std::uint32_t channels, const double* coefficients,
                                 std::uint64_t count) {
    const int highest = read_order(order, "order");
    require_channels(channels);
    const auto from = read_array(coefficients, count, channels, vector_size(highest), "coefficients");
    PshVector light(highest, static_cast<int>(channels));
    std::ranges::copy(from, light.data().begin());
    return psh_environment(std::move(light));
}

}  // namespace

RayleighSky nicol::capi::sky_from(const nicol_sky* sky) {
    const nicol_sky given = read_struct(sky, nicol_sky NICOL_SKY_INIT, "sky");
    RayleighSky out;
    out.sun_direction = {given.sun_direction[0], given.sun_direction[1], given.sun_direction[2]};
    out.dop_max = static_cast<double>(given.dop_max);
    out.radiance = spectrum(given.radiance, 1, 3, "sky->radiance");
    out.turbidity = static_cast<double>(given.turbidity);
    out.ground_albedo = {static_cast<double>(given.ground_albedo)};
    return out;
}

ImagePixels nicol::capi::read_image(const nicol_image* image) {
    std::shared_ptr<void> user = owned_pixels(image);
    return {view_of(read_struct(image, nicol_image NICOL_IMAGE_INIT, "image")), std::move(user)};
}

nicol_result nicol_environment_load(nicol_context context, const char* path,
                                    const nicol_environment_load_options* options,
                                    nicol_environment* environment) {
    return load(context, path, environment, "environment", EnvironmentLoader{options});
}

nicol_result nicol_environment_load_memory(nicol_context context, const nicol_memory_file* file,
                                           const nicol_environment_load_options* options,
                                           nicol_environment* environment) {
    return load(context, file, environment, "environment", EnvironmentLoader{options});
}

nicol_result nicol_environment_create_image(nicol_context context, const nicol_image* image,
                                            nicol_environment* environment) {
    return guarded([&] {
        const std::shared_ptr<void> user = owned_pixels(image);
        const nicol_image description = read_struct(image, nicol_image NICOL_IMAGE_INIT, "image");
        require(environment, "environment");
        const SessionPtr session = resolve(context).session;
        const EnvironmentPtr light =
            session->on_workers([&] { return image_environment(view_of(description)); });
        tell_negative(*session, *light, "image");
        *environment = make_handle<nicol_environment_impl>(session, monitored(*session, light));
    });
}

nicol_result nicol_environment_create_constant(nicol_context context, const nicol_spectrum* radiance,
                                               nicol_environment* environment) {
    return create(context, environment, "environment", [&] {
        static constexpr nicol_spectrum unset = NICOL_SPECTRUM_INIT;
        return constant_environment(spectrum(radiance ? *radiance : unset, 1, 1, "radiance"));
    });
}

nicol_result nicol_environment_create_sky(nicol_context context, const nicol_sky* sky,
                                          nicol_environment* environment) {
    return create(context, environment, "environment", [&] { return rayleigh_sky(sky_from(sky)); });
}

nicol_result nicol_environment_create_psh(nicol_context context, uint32_t order, uint32_t channels,
                                          const double* coefficients, uint64_t count,
                                          nicol_environment* environment) {
    return create(context, environment, "environment",
                  [&] { return from_coefficients(order, channels, coefficients, count); });
}

nicol_result nicol_environment_get_info(nicol_environment environment, nicol_environment_info* info) {
    return guarded([&] {
        const auto self = resolve(environment);
        const Environment& light = *self.content;
        nicol_environment_info out = NICOL_ENVIRONMENT_INFO_INIT;
        out.channels = static_cast<uint32_t>(light.channels());
        out.polarized = light.polarized() ? 1 : 0;
        out.circular = light.circular() ? 1 : 0;
        const std::vector<double>& wavelengths = light.wavelengths();
        out.wavelength_count =
            static_cast<uint32_t>(std::min<std::size_t>(wavelengths.size(), NICOL_MAX_CHANNELS));
        std::copy_n(wavelengths.begin(), out.wavelength_count, out.wavelengths);
        write_struct(info, out, "info");
    });
}

nicol_result nicol_environment_retain(nicol_environment environment) {
    return retain(environment);
}
nicol_result nicol_environment_release(nicol_environment environment) {
    return release(environment);
}

NICOL_INITIALISER(nicol_image, NICOL_IMAGE_INIT)
NICOL_INITIALISER(nicol_sky, NICOL_SKY_INIT)
NICOL_INITIALISER(nicol_environment_load_options, NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT)
NICOL_INITIALISER(nicol_environment_info, NICOL_ENVIRONMENT_INFO_INIT)
