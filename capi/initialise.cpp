// SPDX-License-Identifier: MIT
// Defaults at run time: nicol_<type>_init() of every struct.
#include "boundary.hpp"
#include "nicol_files.h"
#include "nicol_psh.h"

using namespace nicol::capi;

namespace {

template <class T>
nicol_result initialise(T* descriptor, const T& defaults, std::uint32_t struct_size) noexcept {
    return guarded([&] {
        require(descriptor, "descriptor");
        constexpr bool sized = requires {
            descriptor->struct_size;
        };
        if (sized ? !may_be_size<T>(struct_size) : struct_size != sizeof defaults) {
            nicol::refuse("struct_size is " + std::to_string(struct_size) +
                          "; it must be sizeof(the struct), " + std::to_string(sizeof defaults) +
                          " in this version");
        }
        // Fields that only a newer caller has are 0, as read_struct() demands.
        std::memset(descriptor, 0, struct_size);
        std::memcpy(descriptor, &defaults, std::min<std::size_t>(struct_size, sizeof defaults));
        if constexpr (sized) descriptor->struct_size = struct_size;
    });
}

}  // namespace

// Static defaults have zeros between fields too.
#define NICOL_INITIALISER(type, ...)                                   \
    nicol_result type##_init(type* descriptor, uint32_t struct_size) { \
        static constexpr type defaults = __VA_ARGS__;                  \
        return initialise(descriptor, defaults, struct_size);          \
    }

NICOL_INITIALISER(nicol_spectrum, NICOL_SPECTRUM_INIT)
NICOL_INITIALISER(nicol_device_info, NICOL_DEVICE_INFO_INIT)
NICOL_INITIALISER(nicol_context_options, NICOL_CONTEXT_OPTIONS_INIT)
NICOL_INITIALISER(nicol_context_info, NICOL_CONTEXT_INFO_INIT)
NICOL_INITIALISER(nicol_file_content, NICOL_FILE_CONTENT_INIT)
NICOL_INITIALISER(nicol_memory_file, NICOL_MEMORY_FILE_INIT)
NICOL_INITIALISER(nicol_image, NICOL_IMAGE_INIT)
NICOL_INITIALISER(nicol_sky, NICOL_SKY_INIT)
NICOL_INITIALISER(nicol_environment_load_options, NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT)
NICOL_INITIALISER(nicol_environment_info, NICOL_ENVIRONMENT_INFO_INIT)
NICOL_INITIALISER(nicol_texture_image, NICOL_TEXTURE_IMAGE_INIT)
NICOL_INITIALISER(nicol_texture_options, NICOL_TEXTURE_OPTIONS_INIT)
NICOL_INITIALISER(nicol_pplastic, NICOL_PPLASTIC_INIT)
NICOL_INITIALISER(nicol_plastic, NICOL_PLASTIC_INIT)
NICOL_INITIALISER(nicol_principled, NICOL_PRINCIPLED_INIT)
NICOL_INITIALISER(nicol_conductor, NICOL_CONDUCTOR_INIT)
NICOL_INITIALISER(nicol_film, NICOL_FILM_INIT)
NICOL_INITIALISER(nicol_dielectric, NICOL_DIELECTRIC_INIT)
NICOL_INITIALISER(nicol_measured, NICOL_MEASURED_INIT)
NICOL_INITIALISER(nicol_psh_matrix, NICOL_PSH_MATRIX_INIT)
NICOL_INITIALISER(nicol_callback_material, NICOL_CALLBACK_MATERIAL_INIT)
NICOL_INITIALISER(nicol_mesh_data, NICOL_MESH_DATA_INIT)
NICOL_INITIALISER(nicol_deformation, NICOL_DEFORMATION_INIT)
NICOL_INITIALISER(nicol_camera, NICOL_CAMERA_INIT)
NICOL_INITIALISER(nicol_polarization, NICOL_POLARIZATION_INIT)
NICOL_INITIALISER(nicol_filter, NICOL_FILTER_INIT)
NICOL_INITIALISER(nicol_light, NICOL_LIGHT_INIT)
NICOL_INITIALISER(nicol_emission, NICOL_EMISSION_INIT)
NICOL_INITIALISER(nicol_polarization_element, NICOL_POLARIZATION_ELEMENT_INIT)
NICOL_INITIALISER(nicol_instance, NICOL_INSTANCE_INIT)
NICOL_INITIALISER(nicol_scene_file, NICOL_SCENE_FILE_INIT)
NICOL_INITIALISER(nicol_render_options, NICOL_RENDER_OPTIONS_INIT)
NICOL_INITIALISER(nicol_job_status, NICOL_JOB_STATUS_INIT)
NICOL_INITIALISER(nicol_statistics, NICOL_STATISTICS_INIT)
NICOL_INITIALISER(nicol_plane_buffer, NICOL_PLANE_BUFFER_INIT)
NICOL_INITIALISER(nicol_observation, NICOL_OBSERVATION_INIT)
NICOL_INITIALISER(nicol_sensor, NICOL_SENSOR_INIT)
NICOL_INITIALISER(nicol_stokes_image, NICOL_STOKES_IMAGE_INIT)
NICOL_INITIALISER(nicol_gradient, NICOL_GRADIENT_INIT)
NICOL_INITIALISER(nicol_raw_image, NICOL_RAW_IMAGE_INIT)
NICOL_INITIALISER(nicol_host, NICOL_HOST_INIT)
NICOL_INITIALISER(nicol_gl_texture, NICOL_GL_TEXTURE_INIT)
NICOL_INITIALISER(nicol_texture_target, NICOL_TEXTURE_TARGET_INIT)
NICOL_INITIALISER(nicol_psh_sampling, NICOL_PSH_SAMPLING_INIT)
NICOL_INITIALISER(nicol_psh_mueller_field, NICOL_PSH_MUELLER_FIELD_INIT)
NICOL_INITIALISER(nicol_file_options, NICOL_FILE_OPTIONS_INIT)
NICOL_INITIALISER(nicol_light_report, NICOL_LIGHT_REPORT_INIT)
NICOL_INITIALISER(nicol_material_report, NICOL_MATERIAL_REPORT_INIT)
