/* SPDX-License-Identifier: MIT
 * Program of a user who has only the header: three instances, two lights swapped, frames with the light
 * rotating, planes read, errors provoked. Fails where a frame is wrong, an error is not what the header says,
 * memory grows, or something of the process is not as it was. usage: stranger FRAMES CONTEXTS */
#include <fenv.h>
#include <locale.h>
#include <malloc.h>
#include <math.h>
#include <nicol.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SIZE 64
#define PIXELS (SIZE * SIZE)
#define PARTS 8 /* of the frames */

static void check(nicol_result result, int line) {
    if (result == NICOL_OK) return;
    fprintf(stderr, "stranger.c, line %d: %s: %s\n", line, nicol_result_name(result), nicol_last_error());
    exit(2);
}
#define CHECK(call) check((call), __LINE__)

static void require(int holds, int line, const char* what) {
    if (holds) return;
    fprintf(stderr, "stranger.c, line %d: %s\n", line, what);
    exit(3);
}
#define REQUIRE(what) require((what), __LINE__, #what)

/* The call is refused in this way, with a message that says something about `word`. */
static void refused(nicol_result result, nicol_result expected, const char* word, int line) {
    if (result == expected && strstr(nicol_last_error(), word)) return;
    fprintf(stderr, "stranger.c, line %d: %s, not %s; \"%s\" does not name \"%s\"\n", line,
            nicol_result_name(result), nicol_result_name(expected), nicol_last_error(), word);
    exit(4);
}
#define REFUSED(call, expected, word) refused((call), (expected), (word), __LINE__)

typedef struct stage {
    nicol_context context;
    nicol_environment sky, even;
    nicol_scene scene;
    nicol_framebuffer framebuffer;
    nicol_camera camera;
    uint32_t ids[3];
} stage;

static void place(double matrix[16], double x, double y, double z, double scale) {
    memset(matrix, 0, 16 * sizeof matrix[0]);
    matrix[0] = matrix[5] = matrix[10] = scale;
    matrix[3] = x, matrix[7] = y, matrix[11] = z;
    matrix[15] = 1.0;
}

static void add(stage* s, nicol_mesh mesh, nicol_material material, double x, double scale, uint32_t* id) {
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = mesh;
    instance.material = material;
    place(instance.to_world, x, 0.0, 0.0, scale);
    CHECK(nicol_scene_add_instance(s->scene, &instance, id));
}

/* Drops everything but what the scene keeps, before the first render. */
static void build(stage* s) {
    static const double origin[3] = {0.0, 2.0, 6.0}, target[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0};
    nicol_camera unset = NICOL_CAMERA_INIT;
    nicol_sky sky = NICOL_SKY_INIT;
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    nicol_conductor gold = NICOL_CONDUCTOR_INIT;
    nicol_material materials[3];
    nicol_mesh ball, box;
    int i;

    CHECK(nicol_context_create(NULL, &s->context));
    sky.sun_direction[0] = 1.0f, sky.sun_direction[1] = 1.0f;
    CHECK(nicol_environment_create_sky(s->context, &sky, &s->sky));
    CHECK(nicol_environment_create_constant(s->context, NULL, &s->even));
    plastic.alpha = 0.3f;
    gold.metal = "Au", gold.alpha = 0.3f;
    CHECK(nicol_material_create_pplastic(s->context, &plastic, &materials[0]));
    CHECK(nicol_material_create_diffuse(s->context, NULL, &materials[1]));
    CHECK(nicol_material_create_conductor(s->context, &gold, &materials[2]));
    CHECK(nicol_mesh_create_sphere(s->context, &ball));
    CHECK(nicol_mesh_create_cube(s->context, &box));
    CHECK(nicol_scene_create(s->context, &s->scene));
    add(s, ball, materials[0], -2.0, 0.9, &s->ids[0]);
    add(s, box, materials[1], 0.0, 0.7, &s->ids[1]);
    add(s, ball, materials[2], 2.0, 0.9, &s->ids[2]);
    CHECK(nicol_framebuffer_create(s->context, SIZE, SIZE, 3, &s->framebuffer));
    s->camera = unset;
    CHECK(nicol_camera_look_at(&s->camera, origin, target, up));

    CHECK(nicol_mesh_release(ball));
    CHECK(nicol_mesh_release(box));
    for (i = 0; i < 3; ++i) CHECK(nicol_material_release(materials[i]));
}

static void take_down(stage* s) { /* the parent first: the others keep it */
    CHECK(nicol_context_release(s->context));
    CHECK(nicol_environment_release(s->sky));
    CHECK(nicol_environment_release(s->even));
    CHECK(nicol_scene_release(s->scene));
    CHECK(nicol_framebuffer_release(s->framebuffer));
}

static void rotate(double matrix[16], double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    place(matrix, 0.0, 0.0, 0.0, 1.0);
    matrix[0] = matrix[10] = cos(angle);
    matrix[2] = sin(angle), matrix[8] = -sin(angle);
}

static void frame(stage* s, int number) {
    static float stokes[PIXELS * 4], dolp[PIXELS];
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    double to_world[16], light = 0.0, polarized = 0.0;
    int i;
    options.bake_directions = 256;
    options.order_low = 3;
    rotate(to_world, 3.6 * number);
    CHECK(nicol_scene_set_environment(s->scene, number / 50 % 2 == 0 ? s->sky : s->even, to_world, 1.0));
    CHECK(nicol_render(s->scene, &s->camera, &options, s->framebuffer));
    CHECK(nicol_framebuffer_read(s->framebuffer, NICOL_PLANE_STOKES, 1, stokes, 0, sizeof stokes));
    CHECK(nicol_framebuffer_read(s->framebuffer, NICOL_PLANE_DOLP, 1, dolp, 0, sizeof dolp));
    for (i = 0; i < PIXELS; ++i) {
        REQUIRE(isfinite(stokes[4 * i]));
        light += stokes[4 * i];
        polarized += dolp[i];
    }
    REQUIRE(light > 0.05 * PIXELS);
    REQUIRE(polarized > 0.0);
}

static void provoke(stage* s) {
    nicol_camera blind = s->camera;
    nicol_scene scene = NULL;
    blind.fov = 200.0;
    REFUSED(nicol_render(NULL, &s->camera, NULL, s->framebuffer), NICOL_ERROR_INVALID_HANDLE, "scene");
    REFUSED(nicol_render(s->scene, &blind, NULL, s->framebuffer), NICOL_ERROR_INVALID_ARGUMENT, "fov");
    REFUSED(nicol_scene_load(s->context, "no such file.xml", NULL, 0, &scene), NICOL_ERROR_FILE_NOT_FOUND,
            "no such file.xml");
    REFUSED(nicol_framebuffer_write_exr(s->framebuffer, "/no such folder/a.exr"), NICOL_ERROR_WRITE_FAILED,
            "/no such folder/a.exr");
    REQUIRE(!scene);
}

/* Bytes that the process has asked for and not given back. */
static size_t heap(void) {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

static size_t resident(void) {
    unsigned long total = 0, pages = 0;
    FILE* file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%lu %lu", &total, &pages) != 2) exit(5);
    fclose(file);
    return (size_t)pages * 4096;
}

/* At most this much since `before`, for what frames and contexts cannot account for one by one. */
static void grown(const char* what, size_t before, size_t after, double most) {
    const double bytes = (double)after - (double)before;
    printf("%s: %+.0f bytes\n", what, bytes);
    if (bytes <= most) return;
    fprintf(stderr, "%s grew by more than %.0f bytes\n", what, most);
    exit(6);
}

/* At most this much in the part that grew least: pools of threads fill at some time, but a leak is in every
 * part. */
static void grown_in_every_part(const char* what, size_t before, const size_t after[PARTS], double most) {
    size_t grown_before = 0, grown_after = 0;
    double least = INFINITY;
    int part;
    for (part = 0; part < PARTS; ++part) {
        const double bytes = (double)after[part] - (double)before;
        if (bytes < least) least = bytes, grown_before = before, grown_after = after[part];
        before = after[part];
    }
    grown(what, grown_before, grown_after, most);
}

/* State of the process and of the calling thread, which a library must not change. */
typedef struct surroundings {
    void (*handlers[32])(int);
    int rounding;
    char locale[256];
} surroundings;

static void look_around(surroundings* all) {
    int i;
    for (i = 1; i < 32; ++i) {
        struct sigaction action;
        REQUIRE(sigaction(i, NULL, &action) == 0);
        all->handlers[i] = action.sa_handler;
    }
    all->rounding = fegetround();
    snprintf(all->locale, sizeof all->locale, "%s", setlocale(LC_ALL, NULL));
}

int main(int argc, char** argv) {
    stage s;
    surroundings before, after;
    size_t heap_before, resident_before, heap_of_parts[PARTS];
    int frames, contexts, part, i;
    if (argc != 3) return 1;
    frames = atoi(argv[1]), contexts = atoi(argv[2]);
    mallopt(M_ARENA_MAX, 1); /* mallinfo2 counts one arena */

    memset(&before, 0, sizeof before), memset(&after, 0, sizeof after);
    look_around(&before);
    build(&s);
    for (i = 0; i < 60 && i < frames; ++i) frame(&s, i);
    provoke(&s);
    frame(&s, 0); /* the sky, which has more to keep than the even light */
    heap_before = heap(), resident_before = resident();
    for (part = 0; part < PARTS; ++part) {
        for (i = part; i < frames; i += PARTS) frame(&s, i);
        provoke(&s);
        frame(&s, 0);
        heap_of_parts[part] = heap();
    }
    grown_in_every_part("heap by frames", heap_before, heap_of_parts, 2.0 * 1024);
    grown("resident memory by frames", resident_before, resident(), 16.0 * 1024 * 1024);
    take_down(&s);
    look_around(&after);
    REQUIRE(memcmp(&before, &after, sizeof before) == 0);

    for (i = 0; i < contexts; ++i) {
        if (i == contexts / 5) heap_before = heap(), resident_before = resident();
        build(&s);
        frame(&s, i);
        take_down(&s);
    }
    if (contexts > 0) {
        grown("heap by contexts", heap_before, heap(), 4.0 * 1024 * contexts);
        grown("resident memory by contexts", resident_before, resident(), 32.0 * 1024 * 1024);
    }
    return EXIT_SUCCESS;
}
