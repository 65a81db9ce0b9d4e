// SPDX-License-Identifier: MIT
// Environments, materials and meshes.
#include <cstddef>

#include "handles.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

// Makes an immutable asset on the caller's thread; nothing of the context is touched, so no turn is taken.
template <class Impl, class Make>
nicol_result create(nicol_context context, Impl** out, const char* name, Make&& make) {
    return guarded([&] {
        require(out, name);
        const SessionPtr session = resolve(context).session;
        *out = make_handle<Impl>(session, make());
    });
}

// Calls an image's release callback when the library is done reading, on failure too: even a description that
// is refused has one, if its struct_size reaches that far.
class Releaser {
public:
    explicit Releaser(const nicol_image* image) {
        constexpr std::size_t end = offsetof(nicol_image, release_user) + sizeof image->release_user;
        if (image == nullptr || image->struct_size < end || image->struct_size > max_struct_size) return;
        release_ = image->release;
        user_ = image->release_user;
    }
    ~Releaser() {
        if (release_ != nullptr) release_(user_);
    }
    Releaser(const Releaser&) = delete;
    Releaser& operator=(const Releaser&) = delete;

private:
    void (*release_)(void* user) = nullptr;
    void* user_ = nullptr;
};

EnvironmentPtr environment_from(const nicol_image& image) {
    require(image.pixels, "image->pixels");
    if (image.width < 1 || image.width > NICOL_MAX_SIZE || image.height < 2 ||
        image.height > NICOL_MAX_SIZE) {
        refuse("image is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
               " pixels; width must lie in 1 to " + std::to_string(NICOL_MAX_SIZE) + ", height in 2 to " +
               std::to_string(NICOL_MAX_SIZE));
    }
    if (image.channels < 1 || image.channels > NICOL_MAX_CHANNELS) {
        refuse("image->channels is " + std::to_string(image.channels) + "; it must lie in 1 to " +
               std::to_string(NICOL_MAX_CHANNELS));
    }
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
        refuse("image->byte_size is " + std::to_string(image.byte_size) + "; the picture takes " +
               std::to_string(needed) + " bytes");
    }
    EquirectImage copy(static_cast<int>(image.width), static_cast<int>(image.height),
                       static_cast<int>(image.channels));
    for (std::uint32_t y = 0; y < image.height; ++y) {
        const float* from = image.pixels + y * (stride / sizeof(float));
        for (std::uint32_t x = 0; x < image.width; ++x) {
            for (std::uint32_t c = 0; c < image.channels; ++c, from += image.components) {
                const auto to = copy.at(static_cast<int>(c), static_cast<int>(y), static_cast<int>(x));
                std::copy_n(from, image.components, to.begin());
            }
        }
    }
    return image_environment(std::move(copy));
}

double or_default(float value, double fallback) {
    return value == 0 ? fallback : static_cast<double>(value);
}

}  // namespace

EnvironmentPtr nicol::capi::read_image(const nicol_image* image) {
    const Releaser releaser(image);
    return environment_from(read_struct(image, "image"));
}

nicol_result nicol_environment_load(nicol_context context, const char* path, nicol_environment* environment) {
    return create(context, environment, "environment", [&] {
        require(path, "path");
        return load_environment(path);
    });
}

nicol_result nicol_environment_create_image(nicol_context context, const nicol_image* image,
                                            nicol_environment* environment) {
    return guarded([&] {
        const Releaser releaser(image);
        const nicol_image description = read_struct(image, "image");
        require(environment, "environment");
        const SessionPtr session = resolve(context).session;
        *environment = make_handle<nicol_environment_impl>(session, environment_from(description));
    });
}

nicol_result nicol_environment_create_constant(nicol_context context, const nicol_spectrum* radiance,
                                               nicol_environment* environment) {
    return create(context, environment, "environment", [&] {
        require(radiance, "radiance");
        return constant_environment(spectrum(*radiance, 1, 1, "radiance"));
    });
}

nicol_result nicol_environment_create_sky(nicol_context context, const nicol_sky* sky,
                                          nicol_environment* environment) {
    return create(context, environment, "environment", [&] {
        const nicol_sky given = read_struct(sky, "sky");
        RayleighSky description;
        const glm::dvec3 sun(given.sun_direction[0], given.sun_direction[1], given.sun_direction[2]);
        if (sun != glm::dvec3(0)) description.sun_direction = sun;
        description.dop_max = given.dop_max < 0 ? 0 : or_default(given.dop_max, 0.8);
        description.radiance = spectrum(given.radiance, 1, 3, "sky->radiance");
        return rayleigh_sky(description);
    });
}

nicol_result nicol_environment_retain(nicol_environment environment) {
    return retain(environment);
}
nicol_result nicol_environment_release(nicol_environment environment) {
    return release(environment);
}

nicol_result nicol_material_create_pplastic(nicol_context context, const nicol_pplastic* parameters,
                                            nicol_material* material) {
    return create(context, material, "material", [&] {
        const nicol_pplastic given = read_struct(parameters, "parameters");
        if (given.distribution > NICOL_DISTRIBUTION_GGX) {
            refuse("distribution is " + std::to_string(given.distribution) +
                   "; it must be NICOL_DISTRIBUTION_BECKMANN or NICOL_DISTRIBUTION_GGX");
        }
        PplasticParameters p;
        p.diffuse_reflectance = spectrum(given.diffuse_reflectance, 0.5, 1, "diffuse_reflectance");
        p.specular_reflectance = spectrum(given.specular_reflectance, 1, 1, "specular_reflectance");
        p.int_ior = or_default(given.int_ior, p.int_ior);
        p.ext_ior = or_default(given.ext_ior, p.ext_ior);
        p.alpha = or_default(given.alpha, p.alpha);
        p.distribution =
            given.distribution == NICOL_DISTRIBUTION_GGX ? Distribution::ggx : Distribution::beckmann;
        return pplastic(p);
    });
}

nicol_result nicol_material_create_diffuse(nicol_context context, const nicol_spectrum* reflectance,
                                           nicol_material* material) {
    return create(context, material, "material", [&] {
        const nicol_spectrum given =
            reflectance != nullptr ? *reflectance : nicol_spectrum NICOL_SPECTRUM_INIT;
        return diffuse(spectrum(given, 0.5, 1, "reflectance"));
    });
}

nicol_result nicol_material_retain(nicol_material material) {
    return retain(material);
}
nicol_result nicol_material_release(nicol_material material) {
    return release(material);
}

nicol_result nicol_mesh_load(nicol_context context, const char* path, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        require(path, "path");
        return std::make_shared<const Mesh>(load_mesh(path));
    });
}

nicol_result nicol_mesh_create(nicol_context context, const nicol_mesh_data* data, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        const nicol_mesh_data given = read_struct(data, "data");
        require(given.positions, "data->positions");
        require(given.indices, "data->indices");
        if (given.reserved != 0) refuse("data->reserved must be 0");
        Mesh out;
        for (std::uint32_t v = 0; v < given.vertex_count; ++v) {
            const float* p = given.positions + 3 * std::size_t{v};
            out.positions.emplace_back(p[0], p[1], p[2]);
            if (given.normals == nullptr) continue;
            const float* n = given.normals + 3 * std::size_t{v};
            out.normals.emplace_back(n[0], n[1], n[2]);
        }
        for (std::uint32_t t = 0; t < given.triangle_count; ++t) {
            const std::uint32_t* i = given.indices + 3 * std::size_t{t};
            out.triangles.emplace_back(i[0], i[1], i[2]);
        }
        try {
            validate(out, "data");
        } catch (const Error& error) {  // of a file it would be the file's fault
            throw Error(ErrorCode::invalid_argument, error.what());
        }
        return std::make_shared<const Mesh>(std::move(out));
    });
}

nicol_result nicol_mesh_create_sphere(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_sphere()); });
}

nicol_result nicol_mesh_create_rectangle(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_rectangle()); });
}

nicol_result nicol_mesh_create_cube(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_cube()); });
}

nicol_result nicol_mesh_get_size(nicol_mesh mesh, uint32_t* vertices, uint32_t* triangles) {
    return guarded([&] {
        const nicol_mesh_impl& self = resolve(mesh);
        require(vertices, "vertices");
        require(triangles, "triangles");
        *vertices = static_cast<uint32_t>(self.content->positions.size());
        *triangles = static_cast<uint32_t>(self.content->triangles.size());
    });
}

nicol_result nicol_mesh_retain(nicol_mesh mesh) {
    return retain(mesh);
}
nicol_result nicol_mesh_release(nicol_mesh mesh) {
    return release(mesh);
}
