/* SPDX-License-Identifier: MIT
 * Every NICOL_..._INIT macro and callback type, as any dialect of C and C++ must take them. */
#include "nicol.h"
#include "nicol_files.h"
#include "nicol_psh.h"

static void log_nothing(void* user, uint32_t severity, nicol_result code, const char* message) {
    (void)user;
    (void)severity;
    (void)code;
    (void)message;
}

static int32_t go_on(void* user, const char* verb, double fraction) {
    (void)user;
    (void)verb;
    return fraction <= 1.0;
}

static int32_t reflect(void* user, uint32_t channel, const double towards_light[3],
                       const double towards_viewer[3], double mueller[16]) {
    (void)user;
    (void)towards_light;
    (void)towards_viewer;
    mueller[0] = (double)channel;
    return 1;
}

static void* find(void* user, const char* name) {
    (void)name;
    return user;
}

static int32_t current(void* user) {
    return user != 0;
}

static void forget(void* user) {
    (void)user;
}

int use_header(void);

int use_header(void) {
    nicol_context context = 0;
    nicol_environment environment = 0;
    nicol_material material = 0;
    nicol_mesh mesh = 0;
    nicol_scene scene = 0;
    nicol_framebuffer framebuffer = 0;
    nicol_spectrum spectrum = NICOL_SPECTRUM_INIT;
    nicol_context_options context_options = NICOL_CONTEXT_OPTIONS_INIT;
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    nicol_image image = NICOL_IMAGE_INIT;
    nicol_sky sky = NICOL_SKY_INIT;
    nicol_environment_load_options load_options = NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT;
    nicol_environment_info environment_info = NICOL_ENVIRONMENT_INFO_INIT;
    nicol_pplastic pplastic = NICOL_PPLASTIC_INIT;
    nicol_conductor conductor = NICOL_CONDUCTOR_INIT;
    nicol_measured measured = NICOL_MEASURED_INIT;
    nicol_callback_material function = NICOL_CALLBACK_MATERIAL_INIT;
    nicol_mesh_data mesh_data = NICOL_MESH_DATA_INIT;
    nicol_camera camera = NICOL_CAMERA_INIT;
    nicol_instance instance = NICOL_INSTANCE_INIT;
    nicol_render_options render_options = NICOL_RENDER_OPTIONS_INIT;
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    nicol_observation observation = NICOL_OBSERVATION_INIT;
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    nicol_psh_mueller_field field = NICOL_PSH_MUELLER_FIELD_INIT;
    nicol_file_options file_options = NICOL_FILE_OPTIONS_INIT;
    nicol_light_report light_report = NICOL_LIGHT_REPORT_INIT;
    nicol_material_report material_report = NICOL_MATERIAL_REPORT_INIT;
    nicol_device_info device_info = NICOL_DEVICE_INFO_INIT;
    nicol_plane_buffer plane_buffer = NICOL_PLANE_BUFFER_INIT;
    nicol_job_status job_status = NICOL_JOB_STATUS_INIT;
    nicol_host host = NICOL_HOST_INIT;
    nicol_texture texture = NICOL_TEXTURE_INIT;
    nicol_texture_target texture_target = NICOL_TEXTURE_TARGET_INIT;

    context_options.log = log_nothing;
    render_options.progress = go_on;
    host.get_proc_address = find;
    host.is_current = current;
    image.release = forget;
    function.mueller = reflect;
    function.release = forget;
    load_options.wavelengths = spectrum;
    sky.radiance = spectrum;
    pplastic.diffuse_reflectance = spectrum;
    instance.mesh = mesh;
    instance.material = material;
    if (nicol_version() != (uint32_t)NICOL_VERSION) return 1;
    if (context_options.struct_size != sizeof context_options || image.struct_size != sizeof image) return 2;
    if (sky.struct_size != sizeof sky || pplastic.struct_size != sizeof pplastic) return 3;
    if (mesh_data.struct_size != sizeof mesh_data || instance.struct_size != sizeof instance) return 4;
    if (statistics.struct_size != sizeof statistics || observation.struct_size != sizeof observation) return 5;
    if (sampling.struct_size != sizeof sampling || field.struct_size != sizeof field) return 9;
    if (conductor.struct_size != sizeof conductor || measured.struct_size != sizeof measured) return 10;
    if (function.struct_size != sizeof function || load_options.struct_size != sizeof load_options) return 11;
    if (environment_info.struct_size != sizeof environment_info) return 12;
    if (file_options.struct_size != sizeof file_options) return 13;
    if (light_report.struct_size != sizeof light_report) return 14;
    if (material_report.struct_size != sizeof material_report) return 15;
    if (host.struct_size != sizeof host || texture.struct_size != sizeof texture) return 16;
    if (texture_target.struct_size != sizeof texture_target) return 17;
    if (device_info.struct_size != sizeof device_info || plane_buffer.struct_size != sizeof plane_buffer) {
        return 18;
    }
    if (job_status.struct_size != sizeof job_status) return 19;
    if (nicol_context_get_info(context, &info) != NICOL_ERROR_INVALID_HANDLE) return 6;
    if (nicol_render(scene, &camera, &render_options, framebuffer) != NICOL_ERROR_INVALID_HANDLE) return 7;
    return nicol_environment_release(environment) == NICOL_OK ? 0 : 8;
}
