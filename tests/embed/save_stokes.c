/* SPDX-License-Identifier: MIT
 * Writes the Stokes vectors that the example `save_stokes` of each language must write too.
 * usage: embed_save_stokes SCENE.xml OUT.npy [name=value...] */
#include <nicol.h>
#include <stdio.h>
#include <stdlib.h>

static void check(nicol_result result) {
    if (result == NICOL_OK) return;
    fprintf(stderr, "%s\n", nicol_last_error());
    exit(2);
}

static void write_npy(const char* path, const float* stokes, uint32_t width, uint32_t height) {
    char head[128];
    const int length =
        snprintf(head, sizeof head, "{'descr': '<f4', 'fortran_order': False, 'shape': (%u, %u, 4), }",
                 (unsigned)height, (unsigned)width);
    FILE* file = fopen(path, "wb");
    if (!file || length < 0 || length >= 117) exit(3);
    fprintf(file, "\x93NUMPY%c%c%c%c%-117s\n", 1, 0, 118, 0, head);
    if (fwrite(stokes, 16, (size_t)width * height, file) != (size_t)width * height) exit(3);
    if (fclose(file) != 0) exit(3);
}

int main(int argc, char** argv) {
    uint32_t width, height, channels;
    nicol_context context;
    nicol_scene scene;
    nicol_framebuffer framebuffer;
    nicol_camera camera = NICOL_CAMERA_INIT;
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    uint64_t size;
    float* stokes;
    if (argc < 3) return 1;
    options.order_low = 4;
    check(nicol_context_create(NULL, &context));
    check(nicol_scene_load(context, argv[1], (const char* const*)argv + 3, (uint32_t)argc - 3, &scene));
    check(nicol_scene_get_camera(scene, &camera));
    check(nicol_scene_get_film_size(scene, &width, &height));
    check(nicol_scene_get_channels(scene, &channels));
    check(nicol_framebuffer_create(context, width, height, channels, &framebuffer));
    check(nicol_render(scene, &camera, &options, framebuffer));
    size = (uint64_t)width * height * 16;
    stokes = malloc((size_t)size);
    if (!stokes) return 3;
    check(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, channels > 1, stokes, 0, size));
    write_npy(argv[2], stokes, width, height);
    free(stokes);
    nicol_framebuffer_release(framebuffer);
    nicol_scene_release(scene);
    nicol_context_release(context);
    return 0;
}
