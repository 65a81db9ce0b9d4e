/* SPDX-License-Identifier: MIT
 * Ends while jobs run, with nothing released: the process must come to its end. */
#include <nicol.h>
#include <stdio.h>

int main(void) {
    nicol_context context = NULL;
    nicol_spectrum grey = NICOL_SPECTRUM_INIT;
    nicol_environment light = NULL;
    nicol_mesh mesh = NULL;
    nicol_material material = NULL;
    nicol_scene scene = NULL;
    nicol_instance instance = NICOL_INSTANCE_INIT;
    nicol_framebuffer framebuffer = NULL;
    nicol_camera camera = NICOL_CAMERA_INIT;
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    nicol_job_status status = NICOL_JOB_STATUS_INIT;
    nicol_job job = NULL, next = NULL;
    const double origin[3] = {0, 0, 4}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0};

    if (nicol_context_create(NULL, &context) || nicol_environment_create_constant(context, &grey, &light) ||
        nicol_mesh_create_sphere(context, &mesh) || nicol_material_create_diffuse(context, NULL, &material) ||
        nicol_scene_create(context, &scene) || nicol_scene_set_environment(scene, light, NULL, 1) ||
        nicol_framebuffer_create(context, 512, 512, 1, &framebuffer) ||
        nicol_camera_look_at(&camera, origin, target, up)) {
        printf("%s\n", nicol_last_error());
        return 1;
    }
    instance.mesh = mesh;
    instance.material = material;
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = 65536; /* hours */
    if (nicol_scene_add_instance(scene, &instance, NULL) ||
        nicol_render_async(scene, &camera, &options, framebuffer, &job) ||
        nicol_render_async(scene, &camera, &options, framebuffer, &next)) {
        printf("%s\n", nicol_last_error());
        return 1;
    }
    while (status.state != NICOL_JOB_RUNNING || status.fraction == 0) {
        if (nicol_job_poll(job, &status)) return 1;
        if (status.state == NICOL_JOB_DONE) return 1;
    }
    return 0;
}
