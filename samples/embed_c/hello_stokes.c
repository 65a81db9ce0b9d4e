/* SPDX-License-Identifier: MIT
 * A plastic sphere under a polarized sky, through the C ABI: renders it and prints the Stokes vector of one
 * pixel. */
#include <nicol.h>
#include <stdio.h>
#include <stdlib.h>

#define SIZE 256
#define CHECK(call)                                      \
    do {                                                 \
        if ((call) != NICOL_OK) {                        \
            fprintf(stderr, "%s\n", nicol_last_error()); \
            return 2;                                    \
        }                                                \
    } while (0)

int main(void) {
    static float stokes[SIZE * SIZE * 4];
    static const double origin[3] = {0.0, 1.0, 4.0}, target[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0};
    const float* pixel = stokes + 4 * (SIZE / 2 * SIZE + SIZE * 5 / 16); /* left of the sphere's middle */
    nicol_context context = NULL;
    nicol_environment environment = NULL;
    nicol_material material = NULL;
    nicol_mesh mesh = NULL;
    nicol_scene scene = NULL;
    nicol_framebuffer framebuffer = NULL;
    nicol_sky sky = NICOL_SKY_INIT;
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    nicol_instance instance = NICOL_INSTANCE_INIT;
    nicol_camera camera = NICOL_CAMERA_INIT;

    CHECK(nicol_context_create(NULL, &context));

    sky.sun_direction[0] = 1.0f;
    sky.sun_direction[1] = 0.5f;
    CHECK(nicol_environment_create_sky(context, &sky, &environment));

    plastic.alpha = 0.3f;
    CHECK(nicol_material_create_pplastic(context, &plastic, &material));
    CHECK(nicol_mesh_create_sphere(context, &mesh));
    instance.mesh = mesh;
    instance.material = material;

    CHECK(nicol_scene_create(context, &scene));
    CHECK(nicol_scene_add_instance(scene, &instance, NULL));
    CHECK(nicol_scene_set_environment(scene, environment, NULL, 1.0));

    CHECK(nicol_camera_look_at(&camera, origin, target, up));
    CHECK(nicol_framebuffer_create(context, SIZE, SIZE, 3, &framebuffer));
    CHECK(nicol_render(scene, &camera, NULL, framebuffer));
    CHECK(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, 0, stokes, 0, sizeof stokes));
    printf("red channel: s0 %.6f, s1 %.6f, s2 %.6f, s3 %.6f\n", pixel[0], pixel[1], pixel[2], pixel[3]);

    nicol_framebuffer_release(framebuffer);
    nicol_scene_release(scene);
    nicol_mesh_release(mesh);
    nicol_material_release(material);
    nicol_environment_release(environment);
    nicol_context_release(context);
    return EXIT_SUCCESS;
}
