/* SPDX-License-Identifier: MIT
 * A host whose floating-point environment is unusual from its first call on: it traps, rounds up and takes
 * subnormal numbers for zeros. Files are loaded and images rendered as elsewhere, and the environment is as
 * before after every call. usage: traps ASSETS */
#include <fenv.h>
#include <nicol.h>
#include <pmmintrin.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SIZE 24
#define PIXELS (SIZE * SIZE)

enum { traps = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW };
static const unsigned zeros = _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON;

static int unusual; /* whether the environment is */

static void require(int holds, int line, const char* what) {
    if (holds) return;
    fprintf(stderr, "traps.c, line %d: %s: %s\n", line, what, nicol_last_error());
    exit(3);
}
#define REQUIRE(what) require((what), __LINE__, #what)

static void make_unusual(void) {
    unusual = 1;
    feclearexcept(FE_ALL_EXCEPT); /* which libraries may have raised when they were loaded */
    fesetround(FE_UPWARD);
    _mm_setcsr(_mm_getcsr() | zeros);
    REQUIRE(feenableexcept(traps) != -1);
}

static void make_usual(void) {
    unusual = 0;
    fesetenv(FE_DFL_ENV);
}

static void check(nicol_result result, int line) {
    require(result == NICOL_OK, line, "a call failed");
    require(fegetexcept() == (unusual ? traps : 0), line, "traps are others than before");
    require(fegetround() == (unusual ? FE_UPWARD : FE_TONEAREST), line, "rounding is another than before");
    require((_mm_getcsr() & zeros) == (unusual ? zeros : 0), line, "flushing to zero is not as before");
    require(fetestexcept(FE_ALL_EXCEPT) == 0, line, "flags are raised");
}
#define CHECK(call) check((call), __LINE__)

/* The Stokes vectors of both methods. */
static void render(nicol_context context, const char* scene_file, const char* light_file, float* images) {
    static const nicol_method methods[] = {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE};
    nicol_scene scene = NULL;
    nicol_environment light = NULL;
    nicol_framebuffer framebuffer = NULL;
    nicol_camera camera = NICOL_CAMERA_INIT;
    int i;
    CHECK(nicol_scene_load(context, scene_file, NULL, 0, &scene));
    CHECK(nicol_environment_load(context, light_file, NULL, &light));
    CHECK(nicol_scene_set_environment(scene, light, NULL, 1.0));
    CHECK(nicol_scene_get_camera(scene, &camera));
    CHECK(nicol_framebuffer_create(context, SIZE, SIZE, 3, &framebuffer));
    for (i = 0; i < 2; ++i) {
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.method = methods[i];
        options.order_low = 3;
        options.order_high = 3;
        options.bake_directions = 256;
        options.samples = 4;
        CHECK(nicol_render(scene, &camera, &options, framebuffer));
        CHECK(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, 1, images, 0,
                                     4 * PIXELS * sizeof *images));
        images += 4 * PIXELS;
    }
    CHECK(nicol_scene_release(scene));
    CHECK(nicol_environment_release(light));
    CHECK(nicol_framebuffer_release(framebuffer));
}

static void render_everywhere(const char* scene_file, const char* light_file, float* images) {
    static const nicol_backend backends[] = {NICOL_BACKEND_EGL, NICOL_BACKEND_OSMESA};
    int i;
    for (i = 0; i < 2; ++i) {
        nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
        nicol_context context = NULL;
        options.backend = backends[i];
        CHECK(nicol_context_create(&options, &context));
        render(context, scene_file, light_file, images);
        CHECK(nicol_context_release(context));
        images += 2 * 4 * PIXELS;
    }
}

int main(int argc, char** argv) {
    static float trapping[4 * 4 * PIXELS], usual[4 * 4 * PIXELS];
    char scene_file[4096], light_file[4096];
    if (argc != 2) return 1;
    snprintf(scene_file, sizeof scene_file, "%s/textured.gltf", argv[1]);
    snprintf(light_file, sizeof light_file, "%s/forest.exr", argv[1]);

    make_unusual(); /* first: threads that live on inherit it */
    render_everywhere(scene_file, light_file, trapping);
    make_usual();
    render_everywhere(scene_file, light_file, usual);
    REQUIRE(memcmp(trapping, usual, sizeof usual) == 0);
    return EXIT_SUCCESS;
}
