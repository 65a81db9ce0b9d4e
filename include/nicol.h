/* SPDX-License-Identifier: MIT
 * Nicol: polarized light in real time, offscreen. Contexts, scenes, rendering, and reading of images;
 * nicol_psh.h has the mathematics, nicol_files.h conversion and reports of files, nicol.hpp C++ classes over
 * all of them. */

/* clang-format off */
/* Conventions, everywhere:
 *   Objects    are opaque, counted handles. Creation gives one reference; _retain adds one, _release drops one;
 *              releasing NULL does nothing. Objects keep what they need alive: any release order is legal.
 *   Results    Every function that can fail returns a nicol_result and, on failure, leaves its outputs untouched.
 *              nicol_last_error() then has the message, per thread.
 *   Structs    begin with struct_size = sizeof(the struct). NICOL_<TYPE>_INIT makes one with the defaults that the
 *              comments name; every number means itself, and 0 stands for "automatic" or "none" only where a comment
 *              says so. Fields that a caller built with an older header does not have get their defaults.
 *   Threads    Any function may be called from any thread (but see "inside a host's OpenGL"). Calls on objects of one
 *              context lock it; calls on different contexts run in parallel. Callbacks run on the calling thread unless
 *              stated otherwise.
 *   Numbers    Calls and the callbacks that they make run in the default floating-point environment: rounding to
 *              nearest, no traps, subnormal numbers kept. The caller's environment is as before when a call returns.
 *   Strings    are UTF-8 and copied. Strings returned are owned by the library; each says for how long.
 *   Matrices   are row-major: a point's image is M * (x, y, z, 1)^T. The default is the identity.
 *   World      right-handed, y up, units are the scene's own. Angles of the interface are degrees.
 *   Light      is radiance, linear, per colour channel. A Stokes vector (s0, s1, s2, s3) is defined for a receiver that
 *              faces the source: s1 > 0 along the frame's x, s2 > 0 at +45 degrees from x to y, s3 > 0 right circular.
 *              In an image x points to the image's right and y up, as Mitsuba 3's stokes integrator.
 */
/* clang-format on */
#ifndef NICOL_H
#define NICOL_H

#include <stdint.h>

#if defined(_WIN32) && defined(NICOL_BUILDING)
#define NICOL_API __declspec(dllexport)
#elif defined(_WIN32)
#define NICOL_API __declspec(dllimport)
#elif defined(NICOL_BUILDING)
#define NICOL_API __attribute__((visibility("default")))
#else
#define NICOL_API extern
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- version and build */

#define NICOL_VERSION_MAJOR 0
#define NICOL_VERSION_MINOR 1
#define NICOL_VERSION_PATCH 0
#define NICOL_VERSION (NICOL_VERSION_MAJOR * 10000 + NICOL_VERSION_MINOR * 100 + NICOL_VERSION_PATCH)

/* Of the library that runs: major * 10000 + minor * 100 + patch. */
NICOL_API uint32_t nicol_version(void);
/* "0.1.0"; lives as long as the library. */
NICOL_API const char* nicol_version_string(void);
/* Properties of this build as "key=value" (source, compiler, backends, methods, max_order, ...), index 0, 1,
 * ...; NULL past the last one. Lives as long as the library. */
NICOL_API const char* nicol_build_info(uint32_t index);

/* ---------------------------------------------------------------- results */

/* Functions that return a nicol_result never let an exception out, and may be called on any thread. In a
 * child made by fork() after the first of these calls they all fail with NICOL_ERROR_UNSUPPORTED; a child
 * made before it, and every process that was started anew, may use the library. Any child may end by exit().
 */
typedef int32_t nicol_result;
#define NICOL_OK 0
#define NICOL_ERROR_INVALID_ARGUMENT 1 /* a value, size or pointer outside its documented range */
#define NICOL_ERROR_INVALID_HANDLE 2   /* NULL, released, of another kind or of another context */
#define NICOL_ERROR_OUT_OF_MEMORY 3
#define NICOL_ERROR_FILE_NOT_FOUND 4 /* cannot be opened for reading */
#define NICOL_ERROR_INVALID_FILE 5   /* truncated, malformed, or values out of range */
#define NICOL_ERROR_WRITE_FAILED 6   /* an output could not be written; nothing half-written remains */
#define NICOL_ERROR_UNSUPPORTED 7    /* well-formed, but beyond this build, or a library is absent */
#define NICOL_ERROR_NO_BACKEND 8     /* no OpenGL context could be made; the message lists every attempt */
#define NICOL_ERROR_CANCELLED 9      /* a progress callback returned 0 */
#define NICOL_ERROR_OPENGL 10        /* the driver failed after the context was made */
#define NICOL_ERROR_INTERNAL 11      /* a defect in Nicol */
#define NICOL_ERROR_NOT_CURRENT 12   /* the host's OpenGL context is not current on the calling thread */
#define NICOL_ERROR_TIMEOUT 13       /* the timeout expired */
#define NICOL_ERROR_BUSY 14          /* NICOL_MAX_JOBS jobs wait already */

/* The message of the last failed call on this thread: one line that names the file, line, field or argument
 * and what is expected. Never NULL; "" before the first failure. Valid until this thread's next failed call.
 */
NICOL_API const char* nicol_last_error(void);
/* "out of memory" and the like for a code; lives as long as the library. */
NICOL_API const char* nicol_result_name(nicol_result result);

#define NICOL_LOG_INFO 0    /* what a new context opened */
#define NICOL_LOG_NOTICE 1  /* a request without effect, or a cache that was rebuilt */
#define NICOL_LOG_WARNING 2 /* a fallback, such as the CPU after a device failed */
/* message is one line that lives as long as the call; code is NICOL_OK, or the error that a call would have
 * returned for what was worked round. It must not call Nicol with objects of the context. */
typedef void (*nicol_log_callback)(void* user, uint32_t severity, nicol_result code, const char* message);

/* Called about ten times a second on the thread that called; fraction runs from 0 to 1. Return 1 to continue,
 * 0 to cancel: the call then returns NICOL_ERROR_CANCELLED. It must not call Nicol with objects of the same
 * context. */
typedef int32_t (*nicol_progress_callback)(void* user, const char* verb, double fraction);

/* ---------------------------------------------------------------- objects */

typedef struct nicol_context_impl* nicol_context;         /* an OpenGL context on a thread of its own */
typedef struct nicol_environment_impl* nicol_environment; /* light from infinitely far; immutable */
typedef struct nicol_texture_impl* nicol_texture;         /* values that vary over a surface; immutable */
typedef struct nicol_material_impl* nicol_material;       /* a polarimetric BRDF; immutable */
typedef struct nicol_mesh_impl* nicol_mesh;               /* triangles; immutable */
typedef struct nicol_scene_impl* nicol_scene;             /* what is rendered, and by which light */
typedef struct nicol_framebuffer_impl* nicol_framebuffer; /* the Stokes image of the last render into it */

#define NICOL_MAX_CHANNELS 16
#define NICOL_MAX_ORDER 32
#define NICOL_ORDER_AUTOMATIC 0xffffffffu /* orders are chosen, see nicol_render_options */
#define NICOL_MAX_SIZE 16384

/* One value a colour channel. count 0: not given, the default of where it is used; 1: the same in every
 * channel; else the scene's channel count. */
typedef struct nicol_spectrum {
    uint32_t count;
    float values[NICOL_MAX_CHANNELS];
} nicol_spectrum;
/* clang-format off */
#define NICOL_SPECTRUM_INIT { 0, {0} }
#define NICOL_IDENTITY_4X4 { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }
/* clang-format on */

#define NICOL_NO_LIMIT 0xffffffffffffffffu

/* ---------------------------------------------------------------- context */

typedef uint32_t nicol_backend;
/* The environment variable NICOL_BACKEND (egl, osmesa), else the first that works: EGL hardware, EGL
 * software, OSMesa. */
#define NICOL_BACKEND_AUTOMATIC 0
#define NICOL_BACKEND_EGL 1
#define NICOL_BACKEND_OSMESA 2
#define NICOL_BACKEND_HOST 3 /* a context of nicol_context_create_host */

/* The number of devices for nicol_context_options.device: those that EGL lists, in its order, which is
 * neither CUDA's nor the kernel's. 0 if there is no EGL. The list may change when devices or drivers are
 * added or removed. */
NICOL_API nicol_result nicol_device_count(uint32_t* count);

typedef struct nicol_device_info {
    uint32_t struct_size;
    uint32_t software;  /* 1 where OpenGL would run on the CPU */
    const char* name;   /* the driver's, or another that identifies it; valid as long as the library, like all
                           strings here */
    const char* vendor; /* "" if EGL does not report it */
    const char* file;   /* device file, such as /dev/dri/renderD128; "" if none */
} nicol_device_info;
#define NICOL_DEVICE_INFO_INIT \
    { sizeof(nicol_device_info), 0, 0, 0, 0 }

/* device from 1 to nicol_device_count's. No context is made, so that making one may still fail. */
NICOL_API nicol_result nicol_device_get_info(uint32_t device, nicol_device_info* info);

typedef struct nicol_context_options {
    uint32_t struct_size;
    nicol_backend backend;  /* an explicit choice never falls back to another */
    uint32_t device;        /* 0: automatic; n: that of nicol_device_get_info, EGL's n - 1; at most 1024 */
    uint32_t threads;       /* 0: automatic, one per core, which is also the maximum; at most 1024 */
    nicol_log_callback log; /* NULL: silent. May be called on any thread. */
    void* log_user;
    /* The folder in which material tables and baked visibility are kept between runs; created if missing.
     * Processes may share it, and it may be emptied at any time. Beyond the bytes of the environment variable
     * NICOL_CACHE_LIMIT (default 4 GiB; 0: no limit) what was used longest ago is removed. NULL or "": that
     * of the environment variable NICOL_CACHE, or if it is not set or empty, no cache. A folder that cannot
     * be used is a notice to the log, not an error. */
    const char* cache_folder;
    /* Limit of the bytes that each scene keeps at run time, on the device too: the statistics'
     * visibility_bytes and transfer_bytes, the OpenGL buffers of its vertices without compute shaders'
     * work space, and what AOVs, several samples and shading at pixels take beside the framebuffer; by the
     * reference method, its triangles. An upper bound is computed before a render bakes or
     * allocates; if it exceeds the limit, the render fails with NICOL_ERROR_OUT_OF_MEMORY, and the message
     * has both numbers. Where orders are automatic, the bound is for 4 and 9. Default NICOL_NO_LIMIT
     */
    uint64_t memory_limit;
    /* Limits of each call that loads from files, 1 or more, or NICOL_NO_LIMIT; beyond them it fails with
     * NICOL_ERROR_UNSUPPORTED, and the message names the option. */
    /* Bytes of all files together and of what is decoded from them, which is counted before it is decoded:
     * images, 4 for each value; textures 16 more for each pixel; environments 16 for each pixel and channel;
     * inflated meshes and arrays; tables of materials. Default 8 GiB. */
    uint64_t load_bytes_limit;
    uint64_t vertex_limit;   /* of a mesh, or of all instances of a scene together; default 2^26 */
    uint64_t triangle_limit; /* likewise; default 2^27 */
    /* Seconds of each call, checked all the time while files are read and what they hold is prepared; only
     * the decoding of one PNG or JPEG and the parsing of one glTF file's JSON are not interrupted. Above 0,
     * default 600. */
    double load_seconds_limit;
    /* Called about ten times a second while a call loads, on its thread, with the verb "load" and the
     * fraction 0; the call ends with NICOL_ERROR_CANCELLED where it returns 0. Threads that load at the same
     * time call it at the same time. NULL: none. */
    nicol_progress_callback load_progress;
    void* load_progress_user;
} nicol_context_options;
/* clang-format off */
#define NICOL_CONTEXT_OPTIONS_INIT \
    { sizeof(nicol_context_options), 0, 0, 0, 0, 0, 0, NICOL_NO_LIMIT, 0x200000000u, 1 << 26, 1 << 27, 600, 0, 0 }
/* clang-format on */

typedef struct nicol_context_info {
    uint32_t struct_size;
    nicol_backend backend;
    uint32_t software;    /* 1 where OpenGL itself runs on the CPU */
    uint32_t threads;     /* used for the mathematics */
    const char* renderer; /* OpenGL's names; they live as long as the context */
    const char* vendor;
    const char* version;
    uint32_t max_framebuffer_size; /* the longest side: NICOL_MAX_SIZE, or less where the driver has less */
    uint32_t reserved;             /* 0 */
    /* The limits that hold, as in the options. */
    uint64_t memory_limit;
    uint64_t load_bytes_limit;
    uint64_t vertex_limit;
    uint64_t triangle_limit;
    double load_seconds_limit;
} nicol_context_info;
#define NICOL_CONTEXT_INFO_INIT \
    { sizeof(nicol_context_info), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }

/* options may be NULL: all defaults. NICOL_ERROR_NO_BACKEND if no such OpenGL context can be made. */
NICOL_API nicol_result nicol_context_create(const nicol_context_options* options, nicol_context* context);
NICOL_API nicol_result nicol_context_retain(nicol_context context);
NICOL_API nicol_result nicol_context_release(nicol_context context);
/* What was opened, and the limits that hold in it. */
NICOL_API nicol_result nicol_context_get_info(nicol_context context, nicol_context_info* info);

/* ---------------------------------------------------------------- environment */

/* An equirectangular image over the directions light comes FROM, in Mitsuba 3's layout: column u = atan2(x,
 * -z) / 2 pi (pixel-centred), row v = acos(y) / pi (row 0 is the pole itself, the last row the other pole).
 */
typedef struct nicol_image {
    uint32_t struct_size;
    uint32_t width, height; /* 1 to NICOL_MAX_SIZE, height at least 2 */
    uint32_t channels;      /* colour channels, 1 to NICOL_MAX_CHANNELS */
    uint32_t components; /* 1: s0 alone; 4: s0..s3 in the frame z = propagation, x = horizontal, along growing
                            u as seen from the scene's centre, y = z cross x */
    /* [row][column][channel][component]; finite, s0 >= 0, sqrt(s1^2 + s2^2 + s3^2) up to s0 (Eq. 70) */
    const float* pixels;
    uint64_t row_stride; /* bytes from row to row; 0: tightly packed */
    uint64_t byte_size;  /* of all that pixels points to; checked */
    /* NULL, or called once the library no longer reads pixels, on failure too. */
    void (*release)(void* user);
    void* release_user;
} nicol_image;
#define NICOL_IMAGE_INIT \
    { sizeof(nicol_image), 0, 0, 0, 0, 0, 0, 0, 0, 0 }

/* A clear sky; the sun's own disc is not part of it. At the angle g from the sun its degree of polarization
 * is dop_max sin^2 g / (1 + cos^2 g), the E-vector along sun x view, without s3.
 *
 * With turbidity 0 light is scattered once: radiance * 3/4 (1 + cos^2 g) over the whole sphere, below the
 * horizon too.
 *
 * With a turbidity of 1.7 (very clear) to 10 (hazy) brightness and, in three channels, colour follow Perez's
 * formula, mean luminance over the upper half 1, times radiance. Below the horizon is an unpolarized, uniform
 * ground that reflects ground_albedo of each channel's irradiance. The sun must not be below the horizon. */
typedef struct nicol_sky {
    uint32_t struct_size;
    float dop_max;           /* 0 to 1, default 0.8; 0: an unpolarized sky */
    float sun_direction[3];  /* towards the sun, of any length but 0; default straight up, (0, 1, 0) */
    nicol_spectrum radiance; /* default 1 in three channels; finite, not negative */
    float turbidity;         /* 1.7 to 10, or, which is the default, 0: light is scattered once */
    float ground_albedo;     /* 0 to 1, default 0.2; without effect where turbidity is 0 */
} nicol_sky;
/* clang-format off */
#define NICOL_SKY_INIT \
    { sizeof(nicol_sky), 0.8f, {0, 1, 0}, NICOL_SPECTRUM_INIT, 0, 0.2f }
/* clang-format on */

typedef struct nicol_environment_load_options {
    uint32_t struct_size;
    uint32_t reserved;          /* 0 */
    double scale;               /* multiplies the radiance, default 1; finite and not negative */
    nicol_spectrum wavelengths; /* for spectral OpenEXR files: the channels nearest to these, nm, in this
                                   order; within the file's range. count 0: all channels of the file */
} nicol_environment_load_options;
#define NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT \
    { sizeof(nicol_environment_load_options), 0, 1, NICOL_SPECTRUM_INIT }

/* clang-format off */
/* By the path:
 *   NAME.exr      OpenEXR, equirectangular as nicol_image: R, G, B or Y are unpolarized light; S0.<colour> to
 *                 S3.<colour> are polarized, in nicol_image's frames; spectral files (S0.550,000000nm and so on)
 *                 have a channel a wavelength.
 *   NAME_s0.exr   to NAME_s3.exr, any of them, or NAME alone: a cube map as a cross of 4 x 3 faces, a file for
 *                 each Stokes component, as the Python package polarsh has them.
 *   NAME.hdr      Radiance HDR; or NAME.png, .jpg, .bmp, .tga, whose colours are decoded from sRGB to 0 to 1: unpolarized
 *                 light, equirectangular.
 *   NAME.npz      PSH coefficients as polarsh writes them (SHVec).
 * options may be NULL: all defaults. */
/* clang-format on */
NICOL_API nicol_result nicol_environment_load(nicol_context context, const char* path,
                                              const nicol_environment_load_options* options,
                                              nicol_environment* environment);
/* From memory. */
NICOL_API nicol_result nicol_environment_create_image(nicol_context context, const nicol_image* image,
                                                      nicol_environment* environment);
/* Unpolarized and the same from all directions; radiance NULL or not given: 1 in one channel; finite, not
 * negative. */
NICOL_API nicol_result nicol_environment_create_constant(nicol_context context,
                                                         const nicol_spectrum* radiance,
                                                         nicol_environment* environment);
/* A clear sky, without its sun. */
NICOL_API nicol_result nicol_environment_create_sky(nicol_context context, const nicol_sky* sky,
                                                    nicol_environment* environment);
/* Light given by PSH coefficients over PROPAGATION directions in the world's axes, [channel][l*l + l + m][4]
 * as nicol_psh.h says; order up to NICOL_PSH_MAX_ORDER (4096), channels 1 to NICOL_MAX_CHANNELS, count =
 * channels * 4 (order+1)^2. p = 1, 2 below l = 2 must be 0. The light is band-limited: it may ring, with s0
 * below 0 and more polarization than light. */
NICOL_API nicol_result nicol_environment_create_psh(nicol_context context, uint32_t order, uint32_t channels,
                                                    const double* coefficients, uint64_t count,
                                                    nicol_environment* environment);

typedef struct nicol_environment_info {
    uint32_t struct_size;
    uint32_t channels;
    uint32_t polarized;                     /* 1 where some s1, s2 or s3 is not 0 */
    uint32_t circular;                      /* 1 where some s3 is not 0 */
    uint32_t wavelength_count;              /* of spectral light: channels; else 0 */
    uint32_t reserved;                      /* 0 */
    double wavelengths[NICOL_MAX_CHANNELS]; /* nm */
} nicol_environment_info;
/* clang-format off */
#define NICOL_ENVIRONMENT_INFO_INIT \
    { sizeof(nicol_environment_info), 0, 0, 0, 0, 0, {0} }
/* clang-format on */

/* Properties of the light. */
NICOL_API nicol_result nicol_environment_get_info(nicol_environment environment,
                                                  nicol_environment_info* info);
NICOL_API nicol_result nicol_environment_retain(nicol_environment environment);
NICOL_API nicol_result nicol_environment_release(nicol_environment environment);

/* ---------------------------------------------------------------- texture */

/* Values over a surface, by the texture coordinates u and v or the colours of its mesh. v points down: the
 * first row of an image begins at v = 0. An image covers u and v from 0 to 1, the centre of a texel is at (i
 * + 0.5) / width. Values are linear, of one channel, of red, green and blue, or of these and coverage. */

typedef uint32_t nicol_texture_filter;
#define NICOL_TEXTURE_FILTER_NEAREST 0
#define NICOL_TEXTURE_FILTER_BILINEAR 1
#define NICOL_TEXTURE_FILTER_MIPMAP \
    2 /* as bilinear, of ever smaller images where a pixel covers many texels, sharp also at a slant */

typedef uint32_t nicol_texture_wrap; /* beyond 0 to 1 */
#define NICOL_TEXTURE_WRAP_REPEAT 0
#define NICOL_TEXTURE_WRAP_MIRROR 1
#define NICOL_TEXTURE_WRAP_CLAMP 2

typedef uint32_t nicol_texel;
#define NICOL_TEXEL_UINT8 0  /* uint8_t, n / 255 */
#define NICOL_TEXEL_UINT16 1 /* uint16_t, n / 65535 */
#define NICOL_TEXEL_FLOAT32 2

typedef struct nicol_texture_image {
    uint32_t struct_size;
    nicol_texel type;
    uint32_t width, height; /* 1 to 32768 each, and at most 3 * 2^26 pixels */
    uint32_t channels;      /* 1, 3 (red, green, blue) or 4 (and coverage) */
    uint32_t reserved;      /* 0 */
    const void* pixels;     /* [row][column][channel], first row at the top; finite */
    uint64_t row_stride;    /* bytes from row to row; 0: tightly packed */
    uint64_t byte_size;     /* of all that pixels points to; checked */
} nicol_texture_image;
#define NICOL_TEXTURE_IMAGE_INIT \
    { sizeof(nicol_texture_image), 0, 0, 0, 0, 0, 0, 0, 0 }

typedef struct nicol_texture_options {
    uint32_t struct_size;
    nicol_texture_filter filter; /* default bilinear */
    nicol_texture_wrap wrap;     /* default repeat */
    /* 0, the default: numbers of 8 and 16 bits are decoded from sRGB, coverage apart. 1: they are values as
     * they are, as for roughness, normals and heights. Floats always are. */
    uint32_t raw;
    double to_uv[9]; /* 3 x 3: (u, v, 1) of the surface to that of the texture, last row 0 0 1 */
} nicol_texture_options;
/* clang-format off */
#define NICOL_TEXTURE_OPTIONS_INIT \
    { sizeof(nicol_texture_options), NICOL_TEXTURE_FILTER_BILINEAR, 0, 0, { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }
/* clang-format on */

/* Copies the pixels. options may be NULL: all defaults. */
NICOL_API nicol_result nicol_texture_create_image(nicol_context context, const nicol_texture_image* image,
                                                  const nicol_texture_options* options,
                                                  nicol_texture* texture);
/* PNG, JPEG, BMP, TGA, Radiance HDR, or OpenEXR with R G B or Y; with A as coverage. options may be NULL: all
 * defaults. */
NICOL_API nicol_result nicol_texture_load(nicol_context context, const char* path,
                                          const nicol_texture_options* options, nicol_texture* texture);
/* Mitsuba 3's checkerboard of colours: four squares a unit of u and v, color0 at u = v = 0. Colours of 1 or 3
 * values; NULL or not given: 0.4 and 0.2. to_uv as of nicol_texture_options, NULL: identity. */
NICOL_API nicol_result nicol_texture_create_checkerboard(nicol_context context, const nicol_spectrum* color0,
                                                         const nicol_spectrum* color1, const double to_uv[9],
                                                         nicol_texture* texture);
/* The colours of the mesh's vertices, interpolated. */
NICOL_API nicol_result nicol_texture_create_vertex_colors(nicol_context context, nicol_texture* texture);
/* The colours of the mesh's triangles. A material takes these or those of vertices, not both. */
NICOL_API nicol_result nicol_texture_create_face_colors(nicol_context context, nicol_texture* texture);
NICOL_API nicol_result nicol_texture_retain(nicol_texture texture);
NICOL_API nicol_result nicol_texture_release(nicol_texture texture);

/* ---------------------------------------------------------------- material */

/* Where a material takes a texture, each point of a surface has its own value. Its instance then needs a mesh
 * with texture coordinates, or with colours. */

typedef uint32_t nicol_distribution;
#define NICOL_DISTRIBUTION_BECKMANN 0
#define NICOL_DISTRIBUTION_GGX 1

/* Mitsuba 3's pplastic: rough Fresnel reflection over a diffuse base, both polarizing. Front side only. */
typedef struct nicol_pplastic {
    uint32_t struct_size;
    nicol_distribution distribution;
    nicol_spectrum diffuse_reflectance;  /* default 0.5; 0 to 1 */
    nicol_spectrum specular_reflectance; /* default 1; 0 to 1 */
    float int_ior;                       /* default 1.49 */
    float ext_ior;                       /* default 1.000277 */
    float alpha;                         /* 0.001 to 1, default 0.1 */
    uint32_t reserved;                   /* 0 */
    /* Each stands for the number of its name; NULL: the number holds. */
    nicol_texture diffuse_reflectance_texture;
    nicol_texture specular_reflectance_texture;
    nicol_texture alpha_texture; /* of it the first channel, moved to 0.01 to 1 */
} nicol_pplastic;
/* clang-format off */
#define NICOL_PPLASTIC_INIT                                                                        \
    { sizeof(nicol_pplastic), 0, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, 1.49f, 1.000277f, 0.1f, \
      0, 0, 0, 0 }
/* clang-format on */

/* NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range. */
NICOL_API nicol_result nicol_material_create_pplastic(nicol_context context, const nicol_pplastic* parameters,
                                                      nicol_material* material);

/* Mitsuba 3's plastic and roughplastic: Fresnel reflection over a diffuse base, both depolarizing;
 * nicol_pplastic is the model that polarizes. Front side only. */
typedef struct nicol_plastic {
    uint32_t struct_size;
    nicol_distribution distribution;     /* of rough surfaces */
    nicol_spectrum diffuse_reflectance;  /* default 0.5; 0 to 1 */
    nicol_spectrum specular_reflectance; /* default 1; 0 to 1 */
    float int_ior;                       /* default 1.49 */
    float ext_ior;                       /* default 1.000277 */
    float alpha; /* roughness, 0.001 to 1; 0, the default: smooth, as of nicol_conductor */
    /* 1: light that the surface returns to the base takes the base's colour each time, which makes colours
     * deeper; 0, the default: it does not. */
    uint32_t nonlinear;
    /* As of nicol_pplastic; with a texture alpha has no effect. */
    nicol_texture diffuse_reflectance_texture;
    nicol_texture specular_reflectance_texture;
    nicol_texture alpha_texture;
} nicol_plastic;
/* clang-format off */
#define NICOL_PLASTIC_INIT                                                                     \
    { sizeof(nicol_plastic), 0, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, 1.49f, 1.000277f, 0, \
      0, 0, 0, 0 }
/* clang-format on */

/* Likewise. */
NICOL_API nicol_result nicol_material_create_plastic(nicol_context context, const nicol_plastic* parameters,
                                                     nicol_material* material);

/* Mitsuba 3's principled, Disney's material, without what it transmits. It depolarizes. Front side only.
 * Numbers are 0 to 1, by default 0. */
typedef struct nicol_principled {
    uint32_t struct_size;
    /* Relative index of the facets, 0.001 to 1000, default 1.5; 1: there are none, not even of a metal. For
     * Disney's `specular` it is 2 / (1 - sqrt(0.08 specular)) - 1. */
    float eta;
    nicol_spectrum base_color; /* default 0.5; 0 to 1 */
    float roughness;           /* default 0.5; GGX facets have alpha = roughness^2 */
    float anisotropic;         /* alpha where u grows is that across it over 1 - 0.9 anisotropic */
    float metallic;
    float spec_trans; /* the share of the diffuse base that lets light through in its place */
    float spec_tint; /* from white reflection to one in the tint of the base, its colour over its luminance */
    float sheen;
    float sheen_tint; /* likewise */
    float flatness;   /* from a diffuse base to one like subsurface scattering */
    float clearcoat;
    float clearcoat_gloss;
    uint32_t reserved; /* 0 */
    /* Each stands for the number of its name; NULL: the number holds. Of those but base_color the first
     * channel, moved to 0 to 1, of roughness to 0.1 to 1, of anisotropic and clearcoat_gloss to 0.01 to 1.
     * Beside a tint that of base_color must not have the colours of a mesh. */
    nicol_texture base_color_texture;
    nicol_texture roughness_texture;
    nicol_texture anisotropic_texture;
    nicol_texture metallic_texture;
    nicol_texture spec_trans_texture;
    nicol_texture spec_tint_texture;
    nicol_texture sheen_texture;
    nicol_texture sheen_tint_texture;
    nicol_texture flatness_texture;
    nicol_texture clearcoat_texture;
    nicol_texture clearcoat_gloss_texture;
} nicol_principled;
/* clang-format off */
#define NICOL_PRINCIPLED_INIT                                                                  \
    { sizeof(nicol_principled), 1.5f, NICOL_SPECTRUM_INIT, 0.5f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, \
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
/* clang-format on */

/* Likewise; NICOL_ERROR_UNSUPPORTED for a tint of a mesh's colours. */
NICOL_API nicol_result nicol_material_create_principled(nicol_context context,
                                                        const nicol_principled* parameters,
                                                        nicol_material* material);
/* Lambertian and depolarizing; reflectance NULL or not given: 0.5. Front side only. */
NICOL_API nicol_result nicol_material_create_diffuse(nicol_context context, const nicol_spectrum* reflectance,
                                                     nicol_material* material);

/* Mitsuba 3's conductor and roughconductor: single reflection off the facets of an opaque metal. The complex
 * index is eta - i k, relative to air. With k 0 and eta the index of a dielectric it is what the surface of
 * that reflects, as of glass whose inside is not seen. Front side only. */
typedef struct nicol_conductor {
    uint32_t struct_size;
    nicol_distribution distribution; /* of rough surfaces */
    /* Roughness, 0.001 to 1. 0: smooth, for which Beckmann's facets of 0.01 stand, a blur of one degree; in
     * real time lights with a size, also those split off the environment, are mirrored without it.
     * Smooth surfaces reflect nothing of lights without a size: points, spots, projectors and directional
     * lights whose angular_radius is 0, which would be seen in a mirror as points. */
    float alpha;
    uint32_t reserved; /* 0 */
    /* A name of Mitsuba's list as "Au", "Ag", "Cu", "Al", "W" or "TiN_palik", or "gold", "silver", "copper"
     * or "aluminium", with measured values; eta and k must be empty then. NULL or "": eta and k hold. */
    const char* metal;
    nicol_spectrum eta; /* default 0; 0 to 100 */
    nicol_spectrum k;   /* default 1, with eta 0 a perfect mirror; 0 to 100; eta^2 + k^2 is 1e-6 or more */
    /* Of a named metal, a channel each, nm, 380 to 800. count 0: red, green and blue as Mitsuba takes them,
     * the colours of light of the spectra of eta and of k; a constant one is white of equal energy. */
    nicol_spectrum wavelengths;
    nicol_spectrum specular_reflectance; /* default 1; 0 to 1 */
    /* As of nicol_pplastic; with a texture alpha has no effect. */
    nicol_texture specular_reflectance_texture;
    nicol_texture alpha_texture;
    /* Roughness along texture coordinates u and v, 0.001 to 1, as of brushed metal; 0: alpha. Where they
     * differ, local lights and NICOL_METHOD_REFERENCE follow the direction, any where a mesh has no texture
     * coordinates; other light is reflected as by sqrt(alpha_u alpha_v). A texture stands for the number of
     * its name; NULL with the number 0: alpha_texture. */
    float alpha_u;
    float alpha_v;
    nicol_texture alpha_u_texture;
    nicol_texture alpha_v_texture;
} nicol_conductor;
/* clang-format off */
#define NICOL_CONDUCTOR_INIT                                                                        \
    { sizeof(nicol_conductor), 0, 0, 0, 0, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT,                \
      NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, 0, 0, 0, 0, 0, 0 }
/* clang-format on */

/* Likewise; a metal that is not known is refused with the names of those that are. */
NICOL_API nicol_result nicol_material_create_conductor(nicol_context context,
                                                       const nicol_conductor* parameters,
                                                       nicol_material* material);

typedef uint32_t nicol_wavelength_sampling;
#define NICOL_WAVELENGTH_LINEAR 0  /* linear between the measured wavelengths, constant beyond them */
#define NICOL_WAVELENGTH_NEAREST 1 /* the nearest measured wavelength */

typedef struct nicol_measured {
    uint32_t struct_size;
    nicol_wavelength_sampling sampling; /* between measured wavelengths; of the chosen ones alone */
    /* A channel each, nm, 100 to 5000. count 0: red, green and blue by the CIE 1931 observer under D65, or
     * one channel where the file has one wavelength. */
    nicol_spectrum wavelengths;
    /* 1: without what breaks mirror symmetry, in which noise of the measurement is; 0, the default: all. */
    uint32_t symmetrize;
} nicol_measured;
#define NICOL_MEASURED_INIT \
    { sizeof(nicol_measured), 0, NICOL_SPECTRUM_INIT, 0 }

/* Mitsuba 3's measured_polarized: a .pbsdf file, as the KAIST data set has them. It is streamed: about 102 MB
 * stay in memory for each channel at the data set's resolution, half of that where symmetrized. options may
 * be NULL: all defaults. Front side only. */
NICOL_API nicol_result nicol_material_load_measured(nicol_context context, const char* path,
                                                    const nicol_measured* options, nicol_material* material);

typedef struct nicol_psh_matrix {
    uint32_t struct_size;
    uint32_t symmetrize;  /* as of nicol_measured */
    nicol_spectrum scale; /* multiplies; default 1; not negative */
} nicol_psh_matrix;
#define NICOL_PSH_MATRIX_INIT \
    { sizeof(nicol_psh_matrix), 0, NICOL_SPECTRUM_INIT }

/* A PSH coefficient matrix a channel, cosine included, of an isotropic material: the .npz files of the Python
 * package polarsh (SHMat in the layout ISOBI2). Light of orders above the matrix's is not reflected. options
 * may be NULL: all defaults. Front side only. */
NICOL_API nicol_result nicol_material_load_psh(nicol_context context, const char* path,
                                               const nicol_psh_matrix* options, nicol_material* material);
/* The back of a surface reflects as its front. `front` may be released afterwards. */
NICOL_API nicol_result nicol_material_create_twosided(nicol_context context, nicol_material front,
                                                      nicol_material* material);

/* A material times a texture: a diffuse one of reflectance 1 then has the texture's colours. The handles
 * given may be released afterwards, here and below. */
NICOL_API nicol_result nicol_material_create_scaled(nicol_context context, nicol_material base,
                                                    nicol_texture scale, nicol_material* material);
/* first (1 - t) + second t, t the weight's first channel, moved to 0 to 1: Mitsuba 3's blendbsdf. Both must
 * be two-sided, or neither. */
NICOL_API nicol_result nicol_material_create_blend(nicol_context context, nicol_material first,
                                                   nicol_material second, nicol_texture weight,
                                                   nicol_material* material);
/* Shading normals 2 t - 1 in the frame of the surface, x along growing u: Mitsuba 3's normalmap. The texture
 * is raw. y completes a right-handed frame; with mirrored_y 1 it points to where v falls, which differs where
 * texture coordinates are mirrored, as in glTF. */
NICOL_API nicol_result nicol_material_create_normal_map(nicol_context context, nicol_material base,
                                                        nicol_texture normals, uint32_t mirrored_y,
                                                        nicol_material* material);
/* Shading normals of a surface that is displaced along its normal by scale times the texture's first channel,
 * in the scene's units: Mitsuba 3's bumpmap. */
NICOL_API nicol_result nicol_material_create_bump_map(nicol_context context, nicol_material base,
                                                      nicol_texture heights, double scale,
                                                      nicol_material* material);
/* Cut out where the texture's coverage, or of fewer than four channels its first one, is below 0.5: Mitsuba
 * 3's mask of opacities 0 and 1. */
NICOL_API nicol_result nicol_material_create_mask(nicol_context context, nicol_material base,
                                                  nicol_texture opacity, nicol_material* material);

/* Writes the Mueller matrix of one colour channel, 16 row-major doubles, 1/sr and without the cosine, for
 * light from the direction `towards_light` into the direction `towards_viewer`: unit vectors in the surface's
 * frame, whose normal is z; both have z > 0. Both Stokes frames have x along the s-axis towards_light x
 * towards_viewer and z along the propagation, y = z cross x, as Fresnel's matrices do (where the directions
 * are equal, x is any perpendicular direction, the same for both). Return 1 to continue, 0 to end the call
 * that needs it with NICOL_ERROR_CANCELLED. It is called by nicol_material_create_callback and nicol_render,
 * on several threads at once, and must not call Nicol with objects of the material's context. */
typedef int32_t (*nicol_mueller_callback)(void* user, uint32_t channel, const double towards_light[3],
                                          const double towards_viewer[3], double mueller[16]);

typedef struct nicol_callback_material {
    uint32_t struct_size;
    uint32_t channels; /* 1, the default, to NICOL_MAX_CHANNELS */
    nicol_mueller_callback mueller;
    void* user;
    /* NULL, or called once, when `user` is no longer needed: on failure before the call returns, else when
     * the material and all its users are released, on the thread of the last release. */
    void (*release)(void* user);
    /* Angular radius in radians of the narrowest feature about the mirror direction, 0.001 to 1, the default.
     * A value that is too large loses highlights, one that is too small costs time. */
    float lobe_width;
    uint32_t reserved; /* 0 */
} nicol_callback_material;
#define NICOL_CALLBACK_MATERIAL_INIT \
    { sizeof(nicol_callback_material), 1, 0, 0, 0, 1, 0 }

/* The function must be isotropic, mirror symmetric about every plane through the normal, and finite. It is
 * tested at some directions and refused with NICOL_ERROR_INVALID_ARGUMENT otherwise. Front side only. */
NICOL_API nicol_result nicol_material_create_callback(nicol_context context,
                                                      const nicol_callback_material* parameters,
                                                      nicol_material* material);
NICOL_API nicol_result nicol_material_retain(nicol_material material);
NICOL_API nicol_result nicol_material_release(nicol_material material);

/* ---------------------------------------------------------------- mesh */

/* All numbers must be finite, indices valid. Triangles without area are left out, and logged once. */
typedef struct nicol_mesh_data {
    uint32_t struct_size;
    uint32_t vertex_count;   /* 1 or more */
    uint32_t triangle_count; /* 1 or more */
    uint32_t texcoord_count; /* of texcoords; 0: vertex_count, where there are texcoords */
    const float* positions;  /* 3 a vertex */
    const float* normals;    /* 3 a vertex, of any length; 0 means the smooth normal. NULL: made from the
                                triangles, smooth across edges whose faces share vertices */
    const uint32_t* indices; /* 3 a triangle, counter-clockwise from the front */
    const float* texcoords;  /* u, v, see nicol_texture_image; NULL: none */
    /* 3 a triangle, of texcoords, so that a seam of these splits no vertex. NULL: indices, with texcoords of
     * each vertex */
    const uint32_t* texcoord_indices;
    const float* colors;      /* 3 a vertex, linear, see nicol_texture_create_vertex_colors; NULL: none */
    const float* face_colors; /* 3 a triangle, linear, see nicol_texture_create_face_colors; NULL: none */
} nicol_mesh_data;
#define NICOL_MESH_DATA_INIT \
    { sizeof(nicol_mesh_data), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }

/* OBJ, PLY, OFF, STL or the first mesh of Mitsuba's .serialized, by the file's suffix. Polygons may be
 * concave. Triangles without area, vertices of no face and what is not followed (materials) are left out; one
 * line of the log counts them. Texture coordinates and colours of vertices and faces are kept; v of OBJ,
 * which points up there, becomes 1 - v. NICOL_ERROR_INVALID_FILE names the line, vertex or face. */
NICOL_API nicol_result nicol_mesh_load(nicol_context context, const char* path, nicol_mesh* mesh);
/* Copies the arrays. A render adds vertices where shadows need them, see refine_tolerance. */
NICOL_API nicol_result nicol_mesh_create(nicol_context context, const nicol_mesh_data* data,
                                         nicol_mesh* mesh);
/* The unit sphere, finely enough divided for per-vertex shading. Here and below texture coordinates are those
 * of Mitsuba 3's shapes. */
NICOL_API nicol_result nicol_mesh_create_sphere(nicol_context context, nicol_mesh* mesh);
/* [-1, 1]^2 in the plane z = 0, facing +z. */
NICOL_API nicol_result nicol_mesh_create_rectangle(nicol_context context, nicol_mesh* mesh);
/* [-1, 1]^3. */
NICOL_API nicol_result nicol_mesh_create_cube(nicol_context context, nicol_mesh* mesh);
/* Radius 1 in the plane z = 0, facing +z: 128 sectors of 16 rings. */
NICOL_API nicol_result nicol_mesh_create_disk(nicol_context context, nicol_mesh* mesh);
/* Of this radius around the line from p0 to p1, in the scene's units, without its ends: 180 sides. The front
 * is outside. radius is above 0, p0 and p1 must differ. */
NICOL_API nicol_result nicol_mesh_create_cylinder(nicol_context context, const double p0[3],
                                                  const double p1[3], double radius, nicol_mesh* mesh);
/* Of its vertices and triangles. */
NICOL_API nicol_result nicol_mesh_get_size(nicol_mesh mesh, uint32_t* vertices, uint32_t* triangles);
NICOL_API nicol_result nicol_mesh_retain(nicol_mesh mesh);
NICOL_API nicol_result nicol_mesh_release(nicol_mesh mesh);

/* ---------------------------------------------------------------- camera */

typedef uint32_t nicol_projection;
#define NICOL_PROJECTION_PERSPECTIVE 0
#define NICOL_PROJECTION_ORTHOGRAPHIC 1

typedef struct nicol_camera {
    uint32_t struct_size;
    nicol_projection projection;
    double to_world[16]; /* camera space, as Mitsuba's: +z forward, +y up, +x to the image's LEFT; axes at
                            right angles, right-handed. A scale in x, y is the half extent of an orthographic
                            image. */
    double fov; /* perspective: the horizontal field of view in degrees; above 0, default 45, below 180 */
    double near_clip; /* distance along +z, in the scene's units; above 0, default 0.01 */
    double far_clip;  /* above near_clip, default 10000 */
    double jitter[2]; /* pixels to the right and down, -0.5 to 0.5 each, default 0: what is that far from a
                         pixel's centre is at its centre. Images of different jitter, averaged, are
                         anti-aliased */
    double shift[2];  /* how far the middle of the image is from the view direction (its principal point),
                         right  and down, in widths and heights of the image; -1e5 to 1e5 each, default 0. A
                         crop of a  larger image is its own fov and shift */
} nicol_camera;
/* clang-format off */
#define NICOL_CAMERA_INIT \
    { sizeof(nicol_camera), 0, NICOL_IDENTITY_4X4, 45, 0.01, 10000, { 0, 0 }, { 0, 0 } }
/* clang-format on */

/* A camera at `origin` that looks at `target`; sets to_world alone. `up` must not lie along the view. */
NICOL_API nicol_result nicol_camera_look_at(nicol_camera* camera, const double origin[3],
                                            const double target[3], const double up[3]);

/* ---------------------------------------------------------------- light */

/* clang-format off */
/* How what a light emits is polarized, all of it the same. Its frame, seen by who looks into the light:
 *
 *  y|  / E-vector
 *   | /    z  comes towards the viewer, along the light
 *   |/     x  is the part of axis across z (of an axis along z, the direction of growing angle from the light's own +z)
 *   +---x  y  = z cross x; the AoLP counts from x to y, counter-clockwise
 *
 * A sheet polarizer before the light that absorbs along `axis` is dolp 1 and aolp pi / 2, seen from anywhere; a
 * quarter-wave plate behind it docp 1 or -1. */
/* clang-format on */
typedef struct nicol_polarization {
    double dolp;    /* degree of linear polarization, 0, the default, to 1 */
    double aolp;    /* angle of linear polarization, radians as NICOL_PLANE_AOLP; finite, default 0 */
    double docp;    /* s3 / s0: -1 (left circular) to 1 (right); default 0. dolp^2 + docp^2 may be 1 */
    double axis[3]; /* where AoLP is 0, in the light's own axes, of any length but 0; default (1, 0, 0) */
} nicol_polarization;
/* clang-format off */
#define NICOL_POLARIZATION_INIT { 0, 0, 0, { 1, 0, 0 } }
/* clang-format on */

typedef uint32_t nicol_light_kind;
#define NICOL_LIGHT_DIRECTIONAL 0 /* parallel light from infinitely far, or from a disc of the sky */
#define NICOL_LIGHT_POINT 1       /* in all directions */
#define NICOL_LIGHT_SPOT 2        /* within a cone */
#define NICOL_LIGHT_PROJECTOR 3   /* a texture, or one colour, onto a rectangle */

/* A light without a surface, beside the environment. In its own axes it emits light along +z, from the origin
 * where it has a place; +y is up and +x to the left of who looks along +z, as of cameras. Fields of other
 * kinds have no effect. */
typedef struct nicol_light {
    uint32_t struct_size;
    nicol_light_kind kind; /* default point */
    /* Default 1; finite, not negative. Directional: irradiance on a surface that faces the light. Point and
     * spot: radiant intensity, power per solid angle, of a spot on its axis. Projector: irradiance on the
     * plane at distance 1. A directional light of a size has this irradiance over all of its disc. */
    nicol_spectrum value;
    uint32_t reserved;     /* 0 */
    double to_world[16];   /* a rotation and a shift */
    double angular_radius; /* directional: of the disc, degrees, 0, the default, to 90. The sun's is 0.27 */
    double cutoff_angle;   /* spot: from the axis to where it ends, degrees, 0.01 to 90, default 20 */
    double beam_width; /* spot: degrees, 0 to cutoff_angle, default 15: from here the intensity falls to 0 at
                          cutoff_angle, linearly in the angle */
    double fov;        /* projector: of the rectangle's width, degrees, 0.01 to 179.98, default 45 */
    double aspect;     /* projector: the rectangle's width over its height; above 0, default 1 */
    /* Spot: times the intensity, over the square around the cone; projector: times value, over the rectangle.
     * 1 or 3 channels, not negative, no colours of a mesh; NULL, the default: 1. The image's top is up. */
    nicol_texture texture;
    nicol_polarization polarization;
} nicol_light;
/* clang-format off */
#define NICOL_LIGHT_INIT \
    { sizeof(nicol_light), NICOL_LIGHT_POINT, NICOL_SPECTRUM_INIT, 0, NICOL_IDENTITY_4X4, 0, 20, 15, 45, 1, 0, \
      NICOL_POLARIZATION_INIT }
/* clang-format on */

/* What an instance emits, beside what it reflects. */
typedef struct nicol_emission {
    uint32_t struct_size;
    uint32_t two_sided;      /* 1: from both sides; 0, the default: from the front */
    nicol_spectrum radiance; /* default 1; finite, not negative */
    uint32_t reserved;       /* 0 */
    /* Times radiance; 1 or 3 channels, not negative, no colours of a mesh; NULL, the default: 1. */
    nicol_texture texture;
    nicol_polarization polarization; /* its axis is in the mesh's axes */
} nicol_emission;
/* clang-format off */
#define NICOL_EMISSION_INIT \
    { sizeof(nicol_emission), 0, NICOL_SPECTRUM_INIT, 0, 0, NICOL_POLARIZATION_INIT }
/* clang-format on */

/* ---------------------------------------------------------------- polarization elements */

typedef uint32_t nicol_polarization_element_kind;
/* clang-format off */
#define NICOL_POLARIZATION_ELEMENT_POLARIZER 0      /* linear: lets through what is polarized along its axis */
#define NICOL_POLARIZATION_ELEMENT_RETARDER 1       /* a wave plate: delays what is polarized across its fast axis */
#define NICOL_POLARIZATION_ELEMENT_RIGHT_CIRCULAR 2 /* lets right circular light through; it has no axis */
#define NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR 3  /* lets left circular light through; it has no axis */
/* clang-format on */

typedef uint32_t nicol_polarization_element_outline;
#define NICOL_POLARIZATION_ELEMENT_RECTANGLE 0 /* |x| <= 1, |y| <= 1 */
#define NICOL_POLARIZATION_ELEMENT_DISK 1      /* of radius 1 */

/* clang-format off */
/* An ideal, infinitely thin sheet. The camera sees what is behind it through its Mueller matrix; several along a ray
 * act in their order. It casts no shadow, and light passes it unchanged on its way to surfaces.
 * In its own axes it lies in the plane z = 0 about the origin; light passes both ways alike.
 *
 *   y
 *   |  / axis   x  is where to_world takes the element's x, z its normal, and y = z cross x
 *   | /) angle
 *   +------x
 *
 * Light at an angle to the normal is treated as by Mitsuba 3: a polarizer absorbs along what is across the ray of the
 * direction that it absorbs, retardance is times the cosine of that angle. A fast axis is what is across the ray of it,
 * where Mitsuba 3.9 rotates it with the tilt. */
/* clang-format on */
typedef struct nicol_polarization_element {
    uint32_t struct_size;
    nicol_polarization_element_kind kind;       /* default polarizer */
    nicol_polarization_element_outline outline; /* default rectangle */
    uint32_t reserved;                          /* 0 */
    double to_world[16];                        /* any invertible affine transform; its last row is 0 0 0 1 */
    /* Of the axis that a polarizer lets through or of a retarder's fast axis, degrees from x to y; finite,
     * default 0. Without effect on circular ones, which have none. */
    double angle;
    double retardance; /* retarder: degrees, at normal incidence; finite, default 90, a quarter-wave plate */
    double transmittance; /* times what is ideal, 0 to 1, the default */
} nicol_polarization_element;
/* clang-format off */
#define NICOL_POLARIZATION_ELEMENT_INIT \
    { sizeof(nicol_polarization_element), NICOL_POLARIZATION_ELEMENT_POLARIZER, \
      NICOL_POLARIZATION_ELEMENT_RECTANGLE, 0, NICOL_IDENTITY_4X4, 0, 90, 1 }
/* clang-format on */

/* ---------------------------------------------------------------- scene */

typedef struct nicol_instance {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    nicol_mesh mesh;
    nicol_material material;
    double to_world[16]; /* any invertible affine transform; its last row is 0 0 0 1 */
} nicol_instance;
/* clang-format off */
#define NICOL_INSTANCE_INIT \
    { sizeof(nicol_instance), 0, 0, 0, NICOL_IDENTITY_4X4 }
/* clang-format on */

/* Empty and dark. */
NICOL_API nicol_result nicol_scene_create(nicol_context context, nicol_scene* scene);
/* A Mitsuba 3 XML file, or glTF 2.0 where the name ends in .gltf or .glb (the subsets that
 * samples/render/README.md lists); definitions are "name=value" strings that override <default>s of the XML.
 * glTF has no environment, and may have lights. Lights of a file that polarization elements of it cover have
 * the state and the brightness of their light behind these. */
NICOL_API nicol_result nicol_scene_load(nicol_context context, const char* path,
                                        const char* const* definitions, uint32_t definition_count,
                                        nicol_scene* scene);
/* id may be NULL; ids count up from 0, past those of removed instances too. A mesh must have the texture
 * coordinates and colours that its material needs, here and in nicol_scene_set_material. Materials and
 * environment must have one colour channel or the same number of them, here and in
 * nicol_scene_set_environment. */
NICOL_API nicol_result nicol_scene_add_instance(nicol_scene scene, const nicol_instance* instance,
                                                uint32_t* id);
/* id as nicol_scene_add_instance gave it; to_world as nicol_instance's. The next render bakes again the
 * vertices that the instance may shadow, before or now; a scene that rotates and moves as a whole is only
 * relit. */
NICOL_API nicol_result nicol_scene_set_transform(nicol_scene scene, uint32_t id, const double to_world[16]);
/* The next render projects the material, if it is new to the scene, and shades its instance. */
NICOL_API nicol_result nicol_scene_set_material(nicol_scene scene, uint32_t id, nicol_material material);
/* Its id is not used again; the others keep theirs. */
NICOL_API nicol_result nicol_scene_remove_instance(nicol_scene scene, uint32_t id);
/* The parts of an instance: mesh and material as handles to release. Each of the three may be NULL. */
NICOL_API nicol_result nicol_scene_get_instance(nicol_scene scene, uint32_t id, nicol_mesh* mesh,
                                                nicol_material* material, double to_world[16]);
NICOL_API nicol_result nicol_scene_get_instance_count(nicol_scene scene, uint32_t* instances);
/* The ids of all instances, ascending; count: of the instances. */
NICOL_API nicol_result nicol_scene_get_instance_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
/* environment NULL: darkness. to_world rotates it (NULL: identity; must be a proper rotation), scale
 * multiplies (1 leaves it; 0: darkness; finite, not negative). */
NICOL_API nicol_result nicol_scene_set_environment(nicol_scene scene, nicol_environment environment,
                                                   const double to_world[16], double scale);
/* The arguments of nicol_scene_set_environment: the environment, as a handle to release, its rotation and
 * scale. to_world and scale may be NULL. In darkness, also that of a file's scale of 0, *environment is NULL,
 * to_world the identity and scale 1. */
NICOL_API nicol_result nicol_scene_get_environment(nicol_scene scene, nicol_environment* environment,
                                                   double to_world[16], double* scale);
/* hide 1: no light goes straight to the camera from the environment, which leaves black (alpha 0), or from
 * instances that emit, which show what they reflect alone; both light the scene as before. 0: they are seen,
 * unless the scene's file has hide_emitters. */
NICOL_API nicol_result nicol_scene_hide_emitters(nicol_scene scene, uint32_t hide);
/* Adds a light, with an id of its own: lights are counted from 0, apart from instances. id may be NULL. A
 * light must have one colour channel or as many as the scene; so must what an instance emits. The handle of
 * the texture may be released afterwards. NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range,
 * here and below. */
NICOL_API nicol_result nicol_scene_add_light(nicol_scene scene, const nicol_light* light, uint32_t* id);
/* All of the light of this id. The next render bakes nothing. */
NICOL_API nicol_result nicol_scene_set_light(nicol_scene scene, uint32_t id, const nicol_light* light);
/* Its id is not used again; the others keep theirs. */
NICOL_API nicol_result nicol_scene_remove_light(nicol_scene scene, uint32_t id);
/* The light as it was given; its texture, as a handle to release, in *texture (NULL: it has none) and not in
 * light->texture. texture may be NULL. */
NICOL_API nicol_result nicol_scene_get_light(nicol_scene scene, uint32_t id, nicol_light* light,
                                             nicol_texture* texture);
NICOL_API nicol_result nicol_scene_get_light_count(nicol_scene scene, uint32_t* lights);
/* The ids of all lights, ascending; count: of the lights. */
NICOL_API nicol_result nicol_scene_get_light_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
/* Makes an instance emit light, emission NULL: stop it. id is the instance's. A texture needs texture
 * coordinates of the mesh. */
NICOL_API nicol_result nicol_scene_set_emission(nicol_scene scene, uint32_t id,
                                                const nicol_emission* emission);
/* What an instance emits, its texture as of nicol_scene_get_light. Of one that emits no light the radiance
 * is 0. */
NICOL_API nicol_result nicol_scene_get_emission(nicol_scene scene, uint32_t id, nicol_emission* emission,
                                                nicol_texture* texture);
/* Adds an element, with an id of its own: elements are counted from 0, apart from instances and lights. id
 * may be NULL. NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range. */
NICOL_API nicol_result nicol_scene_add_polarization_element(nicol_scene scene,
                                                            const nicol_polarization_element* element,
                                                            uint32_t* id);
/* All of the element of this id. */
NICOL_API nicol_result nicol_scene_set_polarization_element(nicol_scene scene, uint32_t id,
                                                            const nicol_polarization_element* element);
/* Its id is not used again; the others keep theirs. */
NICOL_API nicol_result nicol_scene_remove_polarization_element(nicol_scene scene, uint32_t id);
/* The element as it was given. */
NICOL_API nicol_result nicol_scene_get_polarization_element(nicol_scene scene, uint32_t id,
                                                            nicol_polarization_element* element);
NICOL_API nicol_result nicol_scene_get_polarization_element_count(nicol_scene scene, uint32_t* elements);
/* The ids of all elements, ascending; count: of the elements. */
NICOL_API nicol_result nicol_scene_get_polarization_element_ids(nicol_scene scene, uint32_t* ids,
                                                                uint64_t count);
/* The camera and film size of a loaded file, and the AOVs that its integrators ask for, a sum of
 * NICOL_AOV_... for nicol_render_options; NICOL_ERROR_UNSUPPORTED for a scene that was not loaded. */
NICOL_API nicol_result nicol_scene_get_camera(nicol_scene scene, nicol_camera* camera);
NICOL_API nicol_result nicol_scene_get_film_size(nicol_scene scene, uint32_t* width, uint32_t* height);
NICOL_API nicol_result nicol_scene_get_aovs(nicol_scene scene, uint32_t* aovs);

typedef struct nicol_scene_file {
    uint32_t struct_size;
    uint32_t reserved;
    const char* path;   /* as it was opened; the strings live as long as the scene */
    const char* digest; /* of the bytes that were read: 32 hexadecimal digits, not a cryptographic hash */
    uint64_t bytes;
} nicol_scene_file;
#define NICOL_SCENE_FILE_INIT \
    { sizeof(nicol_scene_file), 0, 0, 0, 0 }

/* The files that nicol_scene_load has read, each once: the scene file, those that it includes (of glTF, its
 * buffers), then light, materials and meshes. With equal digests the scene is the same. None for a scene that
 * was not loaded. */
NICOL_API nicol_result nicol_scene_get_file_count(nicol_scene scene, uint32_t* count);
/* index from 0; beyond the last, NICOL_ERROR_INVALID_ARGUMENT */
NICOL_API nicol_result nicol_scene_get_file(nicol_scene scene, uint32_t index, nicol_scene_file* file);
/* Colour channels of its images: those of everything in it, 1 (all grey) or more, and 1 if the film of a
 * loaded file is luminance. */
NICOL_API nicol_result nicol_scene_get_channels(nicol_scene scene, uint32_t* channels);
NICOL_API nicol_result nicol_scene_retain(nicol_scene scene);
NICOL_API nicol_result nicol_scene_release(nicol_scene scene);

/* ---------------------------------------------------------------- render */

typedef uint32_t nicol_method;
/* Real time. Light up to order_low is kept in each vertex's frame and multiplied by a table of the material's
 * response at each view angle. */
#define NICOL_METHOD_FACTORED 0
/* Real time: the paper's transfer matrix for each vertex, baked from shadow and material. Outgoing light is
 * truncated at order_low too. Slower and larger, for comparison. */
#define NICOL_METHOD_DENSE 1
/* Monte Carlo integration of the light at each pixel, with shadows, without harmonics. Slow, noisy and
 * unbiased: the reference for the other methods. */
#define NICOL_METHOD_REFERENCE 2

/* How the light's orders above order_low become reflected light: prefiltered by lobes and looked up at the
 * mirrored view direction, times the visible fraction of the lobe. */
typedef uint32_t nicol_high_orders;
#define NICOL_HIGH_ORDERS_SPLIT 0       /* lobes times Mueller matrices of the view angle */
#define NICOL_HIGH_ORDERS_CONVOLUTION 1 /* a kernel a material (Eq. 68): no polarization by reflection */
#define NICOL_HIGH_ORDERS_NONE 2        /* left out */

/* Where light becomes the Stokes vector of an image. */
typedef uint32_t nicol_shade_at;
/* Pixels, where Stokes vectors between vertices are predicted to err by more than the tolerance: where
 * normals or view directions change much across triangles, for the lobes of the materials; and for several
 * samples of a pixel by threads, which cost less there. Also where a material varies by a texture. */
#define NICOL_SHADE_AT_AUTOMATIC 0
/* Stokes vectors are interpolated across triangles: fast, and right where triangles cover few pixels. Not for
 * materials that vary by textures: NICOL_ERROR_UNSUPPORTED. */
#define NICOL_SHADE_AT_VERTICES 1
/* The light that arrives is interpolated, in the world's axes; normal, view angle, response and high orders
 * are those of the pixel. For coarse meshes. */
#define NICOL_SHADE_AT_PIXELS 2

/* What runs relight and shade. The images agree to 1e-5 of their largest value; shaded at pixels, to 1e-4
 * where a surface is seen edge-on. */
typedef uint32_t nicol_executor;
#define NICOL_EXECUTOR_AUTOMATIC 0 /* compute, unless OpenGL runs on the CPU or lacks features */
#define NICOL_EXECUTOR_CPU 1       /* threads */
#define NICOL_EXECUTOR_COMPUTE 2   /* compute shaders, also where OpenGL runs on the CPU and is slow at it */

/* Work that a render skips because the image is the same without it; all enabled by default. */
#define NICOL_OPTIMISATION_UNCHANGED 1u        /* everything, where nothing changed */
#define NICOL_OPTIMISATION_LIGHT_COMPONENTS 2u /* Stokes components that the light lacks */
#define NICOL_OPTIMISATION_CHANNELS 4u         /* colour channels of light that equal another */
#define NICOL_OPTIMISATION_ORDERS 8u           /* orders that the light lacks */
#define NICOL_OPTIMISATION_RESPONSE_ROWS 16u   /* Stokes components that a material never reflects */
#define NICOL_OPTIMISATION_HIDDEN 32u          /* vertices that face away or lie outside the view */
#define NICOL_OPTIMISATION_UNOCCLUDED 64u      /* shadows of vertices with nothing above their horizon */
#define NICOL_OPTIMISATION_ALL 127u

/* AOVs that a render makes beside the image, by any method; see NICOL_PLANE_DEPTH, _NORMAL, _POSITION,
 * _INSTANCE and _ALPHA. Those of surfaces are of the first on the ray through a pixel's centre; with
 * pixel_samples, of the nearest that the samples show, and the normal is the mean of theirs.
 * NICOL_AOV_ALL: these five. */
#define NICOL_AOV_DEPTH 1u
#define NICOL_AOV_NORMAL 2u
#define NICOL_AOV_POSITION 4u
#define NICOL_AOV_INSTANCE 8u
#define NICOL_AOV_ALPHA 32u
#define NICOL_AOV_ALL 47u
/* The noise of the image, by the reference method with 2 samples or more alone; others refuse it. See
 * NICOL_PLANE_VARIANCE. */
#define NICOL_AOV_VARIANCE 16u

/* Stokes components that an image has; the others are 0. */
typedef uint32_t nicol_components;
#define NICOL_COMPONENTS_ALL 0
#define NICOL_COMPONENTS_S0 1     /* s0 */
#define NICOL_COMPONENTS_LINEAR 3 /* s0, s1, s2 */

#define NICOL_DIRECTIONS_AUTOMATIC 0

#define NICOL_SPLIT_AUTOMATIC (-1)
#define NICOL_MAX_SPLIT_LIGHTS 64

typedef struct nicol_render_options {
    uint32_t struct_size;
    nicol_method method;
    /* Options of the factored and the dense method; the reference method uses samples, seed, `shadows` and
     * NICOL_OPTIMISATION_UNCHANGED only. */
    uint32_t order_low; /* light up to this order is shaded with the material's full response; at most
                           NICOL_MAX_ORDER. NICOL_ORDER_AUTOMATIC, the default: see tolerance */
    uint32_t
        order_high; /* light of the orders above order_low, up to this one, is rendered by high_orders; at
                       most 64. At order_low or below there are none. NICOL_ORDER_AUTOMATIC, the default */
    nicol_high_orders high_orders; /* default split */
    uint32_t shadows;         /* whether surfaces shadow each other and themselves: 1, the default, or 0 */
    uint32_t bake_directions; /* directions of rays at each vertex; 256 to 65536. More take more time and
                                 memory to bake and leave less noise in the shadows.
                                 NICOL_DIRECTIONS_AUTOMATIC, the default: 2048; where orders are chosen, 1024
                                 for a tolerance of 0.03 or more, which leaves noise of about a tenth of that,
                                 2048 down to 0.015, 4096 down to 0.0075, else 8192 */
    /* 1, the default: Stokes vectors are made physically realizable (Eq. 70), s0 >= 0 and no more polarized
     * than s0, which truncated light may violate: at vertices, or at pixels if these are shaded. Where orders
     * are chosen, light that is as weak as the predicted error becomes less polarized: no false DoLP in the
     * dark. 0: they are not. */
    uint32_t physical;
    double dering; /* against ringing: the light's order l is multiplied by 1 / (1 + dering (l (l +
                      1))^2). 0: not at all; 0.0001 to 0.01 are of use; finite, not negative */
    nicol_progress_callback progress; /* NULL: none. Of the verbs project, bake, relight, shade, draw; of the
                                         reference method trace */
    void* progress_user;
    uint32_t
        samples; /* reference: camera rays a pixel, 1 to 2^20, default 256. Powers of two are spread best */
    nicol_executor executor; /* default automatic */
    uint64_t seed; /* of the reference method and of samples of local lights: equal seeds give equal images,
                      whatever the threads */
    /* Where both orders are automatic: the largest predicted error of the orders left out, as RMSE of s0, s1
     * and s2 relative to the RMS of s0; the fastest orders that keep it are taken, order_low up to 16. Errors
     * are mostly a half to a third of the prediction, and that of the DoLP, as the mean over pixels, is no
     * larger than it. Where what vertices keep would exceed 1 GiB, or the context's memory_limit, orders
     * are as high as fits. The dense method and convolution have no prediction: automatic orders are 4 and 9
     * there, and where tolerance is 0, or one of the orders is given. Default 0.03; finite, not negative */
    double tolerance;
    nicol_components components; /* default all */
    uint32_t
        disabled_optimisations;  /* sum of NICOL_OPTIMISATION_... to disable, in order to measure what they
                                    save. Compute shaders shade all vertices and rows in any case. 0: none */
    uint32_t high_order_shadows; /* whether high orders are multiplied by the visible fraction of their lobe:
                                    1, the default, or 0: unshadowed highlights */
    uint32_t aovs;               /* sum of NICOL_AOV_... to make. 0: none */
    nicol_shade_at shade_at;     /* default automatic */
    uint32_t pixel_samples;      /* real-time methods: samples of a pixel, 1 to 1024; 0, the default, is 1. A
                                    pixel is the mean of surfaces and environment by the number of samples
                                    that show them. 4 and 8 are drawn together: shade_at pixels shades each
                                    surface once a pixel, at the mean of its samples. Other numbers are
                                    drawn and shaded one by one, each at the cost of an image, which also
                                    averages normal maps and soft shadows; AOVs are those of 8 */
    double refine_tolerance; /* the bake splits triangles where shadows change faster than the mesh is fine,
                                until what interpolation errs by in the hidden part of an even light is at
                                most this part of all of it; 0: none is split. 0 to 1, default 0.02 */
    uint64_t max_vertices;   /* that splitting may lead to; 0, the default: 65536, or four times as many as
                                there were where that is more. A memory_limit lowers it */
    /* factored: bright parts of the environment, such as a sun, that are taken out of it and rendered as
     * local lights, at most: 0 to NICOL_MAX_SPLIT_LIGHTS. NICOL_SPLIT_AUTOMATIC, the default: those that the
     * orders would miss. */
    int32_t split_lights;
    /* Real-time methods: samples of each light with a size that light a point or a pixel, 1 to 1024, default
     * 16. Fewer are faster, and leave steps in soft shadows. */
    uint32_t light_samples;
} nicol_render_options;
/* clang-format off */
#define NICOL_RENDER_OPTIONS_INIT \
    { sizeof(nicol_render_options), 0, NICOL_ORDER_AUTOMATIC, NICOL_ORDER_AUTOMATIC, 0, 1, NICOL_DIRECTIONS_AUTOMATIC, 1, 0, 0, 0, 256, 0, 0, \
      0.03, 0, 0, 1, 0, 0, 0, 0.02, 0, NICOL_SPLIT_AUTOMATIC, 16 }
/* clang-format on */

/* width, height: 1 to NICOL_MAX_SIZE (the driver may allow less), at most 2^26 pixels. channels: as the
 * scene's, or 1 for the luminance of a scene of three: 0.2126 R + 0.7152 G + 0.0722 B of each Stokes
 * component. */
NICOL_API nicol_result nicol_framebuffer_create(nicol_context context, uint32_t width, uint32_t height,
                                                uint32_t channels, nicol_framebuffer* framebuffer);
/* As it was created. */
NICOL_API nicol_result nicol_framebuffer_get_size(nicol_framebuffer framebuffer, uint32_t* width,
                                                  uint32_t* height, uint32_t* channels);
NICOL_API nicol_result nicol_framebuffer_retain(nicol_framebuffer framebuffer);
NICOL_API nicol_result nicol_framebuffer_release(nicol_framebuffer framebuffer);

/* options may be NULL: all defaults. Results that a change of the scene, the camera or the options does not
 * affect are kept from the scene's last render; if nothing changed, nothing runs. On failure or cancellation
 * the framebuffer keeps its content and statistics. NICOL_ERROR_INVALID_ARGUMENT for options and cameras out
 * of range and channels that do not fit, NICOL_ERROR_UNSUPPORTED for an unknown method, for compute shaders
 * if the driver lacks features, and, where a material varies by a texture, for the dense method and for
 * shading at vertices, NICOL_ERROR_CANCELLED, NICOL_ERROR_OUT_OF_MEMORY. */
NICOL_API nicol_result nicol_render(nicol_scene scene, const nicol_camera* camera,
                                    const nicol_render_options* options, nicol_framebuffer framebuffer);

/* An asynchronous render. Jobs of one context run one after another, in the order of submission, on a thread
 * of the context. A running job locks the context: calls that render, create, read and write its framebuffers
 * wait for it, but not for queued jobs. Calls that change or query scenes or make lights, materials and
 * meshes do not wait. May be used from any thread; nicol_job_poll and nicol_job_cancel from callbacks too.
 * What is different inside a host's OpenGL is told there. */
typedef struct nicol_job_impl* nicol_job;

#define NICOL_MAX_JOBS 256 /* queued in one context */

/* nicol_render as a job. Copies the scene's state: later changes affect later renders only. The framebuffer
 * keeps its content until the job has run. Scene, framebuffer and all they need are kept alive; the caller
 * may release them, and the job too, which runs all the same. The progress callback runs on the context's
 * thread, and progress_user must live until the job is done. Invalid arguments are refused at once where
 * possible; other errors are the job's result. NICOL_ERROR_BUSY if NICOL_MAX_JOBS are queued. A process that
 * exits cancels its jobs. */
NICOL_API nicol_result nicol_render_async(nicol_scene scene, const nicol_camera* camera,
                                          const nicol_render_options* options, nicol_framebuffer framebuffer,
                                          nicol_job* job);

typedef uint32_t nicol_job_state;
#define NICOL_JOB_WAITING 0
#define NICOL_JOB_RUNNING 1
#define NICOL_JOB_DONE 2

typedef struct nicol_job_status {
    uint32_t struct_size;
    nicol_job_state state;
    nicol_result result; /* of a job that is done: what nicol_render would have returned. Else NICOL_OK */
    uint32_t reserved;   /* 0 */
    double fraction;     /* of the current verb, 0 to 1; 1 after success */
    const char* verb; /* as a progress callback's; "" while it waits and once it is done. Lives as long as the
                         library */
} nicol_job_status;
#define NICOL_JOB_STATUS_INIT \
    { sizeof(nicol_job_status), 0, 0, 0, 0, 0 }

/* The job's progress; never waits for it. */
NICOL_API nicol_result nicol_job_poll(nicol_job job, nicol_job_status* status);

#define NICOL_WAIT_FOREVER 0xffffffffu
/* Waits until the job is done, at most this long (0: not at all), and returns its result; after a failure
 * nicol_last_error() has its message. NICOL_ERROR_TIMEOUT if it is not done by then, NICOL_ERROR_NOT_CURRENT
 * where the job needs a host's OpenGL context that is not current on the calling thread.
 * NICOL_ERROR_INVALID_ARGUMENT inside a callback of the context, which would be a deadlock. */
NICOL_API nicol_result nicol_job_wait(nicol_job job, uint32_t timeout_ms);
/* Cancels a queued job at once, and a running one where it would next call a progress callback; its result is
 * NICOL_ERROR_CANCELLED. No effect on a job that is done or almost done. Does not wait. */
NICOL_API nicol_result nicol_job_cancel(nicol_job job);
NICOL_API nicol_result nicol_job_retain(nicol_job job);
NICOL_API nicol_result nicol_job_release(nicol_job job);

/* clang-format off */
/* Statistics of the last render into a framebuffer. Milliseconds are 0 for verbs that did not run. */
typedef struct nicol_statistics {
    uint32_t struct_size;
    uint32_t order;                 /* highest order of the light that was rendered: order_high, or less where the light
                                       has no more, but at least order_low; 0 by the reference method */
    uint64_t vertices;              /* of all instances, vertices_added among them */
    uint64_t triangles;             /* likewise */
    double project_ms;              /* light and materials to coefficients, tables and lobes */
    double bake_ms;                 /* visibility at the vertices, and the dense method's matrices; of the
                                       reference method its hierarchy of triangles and table of light */
    double relight_ms;              /* light, times shadows, into the vertices' frames */
    double shade_ms;                /* light times response, at the view, high orders included */
    double draw_ms;                 /* rasterisation, or copying the image into the framebuffer */
    double observe_ms;              /* reading and writing images since that render */
    double bake_trace_ms;           /* of bake_ms, tracing rays; 0 where the bake came from the cache */
    uint64_t bake_rays;             /* traced by the bake; 0 likewise */
    uint64_t vertices_skipped;      /* not shaded: facing away or outside the view */
    uint64_t vertices_unoccluded;   /* nothing above their horizon: no shadow to compute */
    uint64_t vertices_unphysical;   /* that `physical` moved into the physically realizable range, times channels; pixels are not counted */
    uint64_t light_columns_skipped; /* Stokes components of the light that are zero everywhere, times channels */
    uint64_t response_rows_skipped; /* Stokes components that no material reflects, times channels */
    uint64_t channels_shared;       /* colour channels of light that equal another and are not computed again */
    uint64_t response_bytes;        /* material tables */
    uint64_t visibility_bytes;      /* visibility by direction at each vertex */
    uint64_t transfer_bytes;        /* per-vertex light, shadows, matrices and geometry kept for relight and shade, and of
                                       pixels that are shaded what they show and how */
    uint64_t buffer_bytes;          /* OpenGL buffers: vertices and triangles, and what compute shaders work on */
    uint64_t texture_bytes;         /* OpenGL textures, framebuffer included */
    uint64_t camera_rays;           /* reference: rays from the camera */
    uint64_t shadow_rays;           /* reference: rays towards the light */
    double trace_ms;                /* reference: tracing rays */
    uint32_t compute;               /* 1: compute shaders relight and shade, 0: threads do */
    uint32_t order_low;             /* of the light that was rendered, as the option says or as was chosen */
    double predicted_error;         /* where a tolerance was given: of the orders left out; may exceed it where no orders
                                       reach it. Interpolation between vertices is not in it */
    /* What this render recomputed; 0 if all was kept from the one before. */
    uint64_t lights_projected;      /* environments to coefficients */
    uint64_t materials_projected;   /* tables, matrices and sets of lobes of materials, from the cache folder too */
    uint64_t vertices_traced;       /* that the bake traced rays from */
    uint64_t matrices_baked;        /* dense: of vertices */
    uint64_t vertices_relit;        /* into whose frames light was brought */
    uint64_t vertices_shaded;       /* whose Stokes vectors were computed */
    uint64_t pixels_shaded;         /* likewise */
    uint64_t vertices_added;        /* where the bake split triangles; as they are, recomputed or not */
    uint64_t local_lights;          /* lights beside the environment: the scene's, each instance that emits light, and ... */
    uint64_t lights_split;          /* ... those that were taken out of the environment */
    uint64_t light_rays;            /* real-time methods: rays from vertices and pixels to these lights */
    double light_ms;                /* of shade_ms: these lights and their shadows */
} nicol_statistics;
/* clang-format on */
#define NICOL_STATISTICS_INIT                                                                                \
    {                                                                                                        \
        sizeof(nicol_statistics), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, \
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0                                                      \
    }

/* All zeros before the first render. */
NICOL_API nicol_result nicol_framebuffer_get_statistics(nicol_framebuffer framebuffer,
                                                        nicol_statistics* statistics);

/* ---------------------------------------------------------------- observe */

typedef uint32_t nicol_plane;
#define NICOL_PLANE_S0 0
#define NICOL_PLANE_S1 1
#define NICOL_PLANE_S2 2
#define NICOL_PLANE_S3 3
#define NICOL_PLANE_STOKES 4 /* four floats a pixel */
#define NICOL_PLANE_DOLP 5   /* degree of linear polarization; 0 where s0 <= 0 */
/* Angle of linear polarization, radians in (-pi/2, pi/2], counter-clockwise from image right. */
#define NICOL_PLANE_AOLP 6
/* The following exist only if the last render into the framebuffer made them (NICOL_AOV_...), and but for
 * NICOL_PLANE_VARIANCE have no colour channels. */
#define NICOL_PLANE_DEPTH 7 /* distance along the camera's +z; +infinity where there is no surface */
#define NICOL_PLANE_NORMAL                                                                              \
    8 /* three numbers a pixel: the unit shading normal in the world, of a surface with two             \
         sides on the one that is seen, of others on the front; 0 without a surface, and where those of \
         samples cancel */
#define NICOL_PLANE_POSITION 9  /* three numbers a pixel: the point in the world; 0 without a surface */
#define NICOL_PLANE_INSTANCE 10 /* a uint32_t a pixel: the instance's id, or NICOL_NO_INSTANCE */
#define NICOL_NO_INSTANCE 0xffffffffu
/* Four floats a pixel and colour channel: the variance of each Stokes component of the pixel over seeds,
 * whose square root is its standard error; in framebuffers of luminance that of the luminance. It is
 * estimated from the means of four groups of the pixel's samples (as many as there are samples below four),
 * so that it is itself noisy, as a chi-square of 3 degrees of freedom is. On average it is an upper bound,
 * since all samples of a pixel together are spread better than those of a group: 1 to 2 times the variance on
 * most surfaces and 3 times at outlines under smooth light, where measured. At most the largest float. */
#define NICOL_PLANE_VARIANCE 11
/* Coverage: the fraction of a pixel's samples (of the reference method: of its rays) that show a surface,
 * seen from the front or from behind; 1 or 0 with one sample. The Stokes image is not multiplied by it: it
 * has the environment behind the surfaces, weighted by 1 - alpha, and without an environment black. */
#define NICOL_PLANE_ALPHA 12

/* Copies one plane of one colour channel, first row at the top. row_stride in bytes, 0: tightly packed;
 * byte_size is what pixels has room for. NICOL_ERROR_INVALID_ARGUMENT for a plane that is not there and for
 * NICOL_PLANE_INSTANCE, which holds no floats. */
NICOL_API nicol_result nicol_framebuffer_read(nicol_framebuffer framebuffer, nicol_plane plane,
                                              uint32_t channel, float* pixels, uint64_t row_stride,
                                              uint64_t byte_size);

typedef uint32_t nicol_format;
#define NICOL_FORMAT_AUTOMATIC 0 /* float32, and uint32 of NICOL_PLANE_INSTANCE */
#define NICOL_FORMAT_FLOAT32 1
#define NICOL_FORMAT_FLOAT16                                                               \
    2 /* IEEE 754 half precision, rounded to the nearest, ties to even; beyond 65504 it is \
         infinite, below 2^-24 in steps of that: scale the light where that matters */
#define NICOL_FORMAT_UINT32 3 /* of NICOL_PLANE_INSTANCE alone */

#define NICOL_ALL_CHANNELS 0xffffffffu

typedef struct nicol_plane_buffer {
    uint32_t struct_size;
    nicol_plane plane;
    nicol_format format;
    uint32_t channel;    /* counted from 0; NICOL_ALL_CHANNELS: every one, interleaved. 0 of planes without
                            channels */
    void* pixels;        /* [row][column][channel][component], first row at the top; aligned to its numbers */
    uint64_t row_stride; /* bytes from row to row, a multiple of a number's; 0: tightly packed */
    uint64_t byte_size;  /* of what pixels has room for; checked */
} nicol_plane_buffer;
#define NICOL_PLANE_BUFFER_INIT \
    { sizeof(nicol_plane_buffer), 0, 0, 0, 0, 0, 0 }

/* Copies a plane in the format and with the channels of `to`; bytes between rows are not written. A call that
 * fails writes nothing. */
NICOL_API nicol_result nicol_framebuffer_read_plane(nicol_framebuffer framebuffer,
                                                    const nicol_plane_buffer* to);
/* clang-format off */
/* Channels of 32-bit floats, named by the number of colour channels:
 *   3             R G B (which are s0) and S0.R S0.G S0.B to S3.R S3.G S3.B, as Mitsuba 3's stokes integrator
 *   1             Y (which is s0) and S0.Y to S3.Y
 *   2, 4 to 16    S0.0 S0.1 ... to S3.0 S3.1 ...
 * and of the last render's AOVs Z (depth), N.X N.Y N.Z, P.X P.Y P.Z, id (32-bit unsigned), A (alpha; R G B still
 * have the environment) and, of each Stokes channel, variance.S0.R ... variance.S3.B. */
/* clang-format on */
NICOL_API nicol_result nicol_framebuffer_write_exr(nicol_framebuffer framebuffer, const char* path);

typedef uint32_t nicol_observation_kind;
#define NICOL_OBSERVATION_S0 0        /* tone-mapped with the sRGB curve */
#define NICOL_OBSERVATION_S1 1        /* red negative, green positive, linear */
#define NICOL_OBSERVATION_S2 2        /* likewise */
#define NICOL_OBSERVATION_S3 3        /* likewise */
#define NICOL_OBSERVATION_DOLP 4      /* black 0, white 1 */
#define NICOL_OBSERVATION_AOLP 5      /* hue = angle / 180 degrees, value = DoLP */
#define NICOL_OBSERVATION_POLARIZER 6 /* behind an ideal linear polarizer, tone-mapped like s0 */

typedef struct nicol_observation {
    uint32_t struct_size;
    nicol_observation_kind kind;
    float exposure; /* stops; s0 and polarizer */
    float scale;    /* s1..s3: the value shown at full colour; 0: automatic, the largest in the image. Written
                       into the file. */
    float polarizer_angle; /* degrees counter-clockwise from image right */
} nicol_observation;
#define NICOL_OBSERVATION_INIT \
    { sizeof(nicol_observation), 0, 0, 0, 0 }

/* 8-bit RGB. S0 and POLARIZER need a framebuffer of 1 or 3 channels; the others show the mean of the
 * channels. */
NICOL_API nicol_result nicol_framebuffer_write_png(nicol_framebuffer framebuffer,
                                                   const nicol_observation* observation, const char* path);

/* ---------------------------------------------------------------- inside a host's OpenGL */

/* clang-format off */
/* A context can be the caller's own, so that images stay on the device: no context is made current, no OpenGL thread
 * is started, and nicol_framebuffer_get_texture and nicol_framebuffer_draw_... give access to the images.
 *
 *   Current       That OpenGL context, and no other, must be current on the calling thread in nicol_context_create_host
 *                 and in every call that uses OpenGL: nicol_framebuffer_create, nicol_render, and what reads, writes
 *                 and draws images. Else they fail with NICOL_ERROR_NOT_CURRENT and touch nothing. It may move from
 *                 thread to thread.
 *   State         All of the host's OpenGL state is as before when a call returns: what Nicol changes it saves and
 *                 restores, and what it depends on (scissor, masks, pixel storage, ...) it sets and restores. Objects
 *                 are made with new names and others are left alone. Active queries of the host count what is drawn,
 *                 and its debug callback gets the driver's messages about Nicol's commands.
 *   Refused       with NICOL_ERROR_UNSUPPORTED are calls in states that cannot be restored, or in which nothing is
 *                 drawn: transform feedback that is not paused, conditional rendering, a current program that is
 *                 deleted or whose last link failed; in compatibility contexts also a display list that is compiled
 *                 and a render mode other than GL_RENDER.
 *   Errors        that the host left pending stay pending: glGetError returns after a call what it would have returned
 *                 before, and no error of Nicol's. For an error that cannot be made pending again, GL_STACK_OVERFLOW,
 *                 GL_STACK_UNDERFLOW or GL_CONTEXT_LOST, the call takes the error, fails with NICOL_ERROR_OPENGL and
 *                 names it. nicol_context_create_host leaves pending errors alone.
 *   Callbacks     that come while Nicol renders must not call OpenGL.
 *   Jobs          bake, project and shade on a thread of Nicol's, while the host goes on. The OpenGL commands that they
 *                 give wait until the host lends its context: a call of nicol_job_poll where it is current gives those
 *                 that are ready, and nicol_job_wait, or any call that waits for the job, gives them as they come.
 *                 Waiting where it is not current is NICOL_ERROR_NOT_CURRENT. A job that waits for the context after
 *                 the last handle of its objects was released is cancelled.
 *   Times         of verbs that work on the device are those of giving the commands, which the host's follow in order.
 *   Release       where the context is current deletes its OpenGL objects at once. Elsewhere they are deleted by the
 *                 next call while it is current, or with the host's context. Release everything before the OpenGL
 *                 library is unloaded.
 */
/* clang-format on */
/* The address of an OpenGL function by its name, as from SDL_GL_GetProcAddress, eglGetProcAddress and others.
 */
typedef void* (*nicol_get_proc_address_callback)(void* user, const char* name);
/* Returns 1 if the host's context is current on the calling thread, else 0. */
typedef int32_t (*nicol_is_current_callback)(void* user);

typedef struct nicol_host {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    nicol_get_proc_address_callback get_proc_address;
    /* NULL: OpenGL is queried, which needs OpenGL functions that may be called without a context, as with
     * libglvnd and Mesa. */
    nicol_is_current_callback is_current;
    void* user; /* of both; used until the last object of the context is released */
} nicol_host;
#define NICOL_HOST_INIT \
    { sizeof(nicol_host), 0, 0, 0, 0 }

/* A context inside the one that is current: OpenGL 4.5 or newer, of the core or the compatibility profile.
 * options as of nicol_context_create, backend and device 0. NICOL_ERROR_NOT_CURRENT if is_current returns 0,
 * NICOL_ERROR_NO_BACKEND where there is no such OpenGL. */
NICOL_API nicol_result nicol_context_create_host(const nicol_host* host, const nicol_context_options* options,
                                                 nicol_context* context);

typedef struct nicol_gl_texture {
    uint32_t struct_size;
    uint32_t name;            /* OpenGL's */
    uint32_t target;          /* GL_TEXTURE_2D */
    uint32_t internal_format; /* GL_RGBA32F */
    uint32_t width;
    uint32_t height;
} nicol_gl_texture;
#define NICOL_GL_TEXTURE_INIT \
    { sizeof(nicol_gl_texture), 0, 0, 0, 0, 0 }

/* The texture of a colour channel: a texel is the Stokes vector (s0, s1, s2, s3), row 0 is the image's TOP.
 * The name is valid, and stays the same, until the framebuffer is released; the content is that of the last
 * render. It may be sampled, and its filters and wrap modes changed, but not its swizzle; it must neither be
 * written nor deleted.
 * NICOL_ERROR_UNSUPPORTED for a framebuffer whose context is not a host's, as for the functions below. */
NICOL_API nicol_result nicol_framebuffer_get_texture(nicol_framebuffer framebuffer, uint32_t channel,
                                                     nicol_gl_texture* texture);

typedef uint32_t nicol_encoding;
#define NICOL_ENCODING_LINEAR 0 /* radiance; stored as far as the texture's format goes */
#define NICOL_ENCODING_SRGB 1   /* clipped to 0 to 1 and through the sRGB curve, as in PNG files */

/* A texture of the host's to draw into: level 0 of a GL_TEXTURE_2D of GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F
 * or GL_RGBA32F, as large as the framebuffer. */
typedef struct nicol_texture_target {
    uint32_t struct_size;
    uint32_t texture;
    uint32_t bottom_up;      /* 0: row 0 is the image's top; 1: its bottom, as OpenGL's own images have it */
    nicol_encoding encoding; /* of the images S0 and POLARIZER; SRGB8_ALPHA8 gets these numbers as they are */
} nicol_texture_target;
#define NICOL_TEXTURE_TARGET_INIT \
    { sizeof(nicol_texture_target), 0, 0, 0 }

/* Copies the Stokes vectors of a channel. Nothing is read back. */
NICOL_API nicol_result nicol_framebuffer_draw_stokes(nicol_framebuffer framebuffer, uint32_t channel,
                                                     const nicol_texture_target* target);
/* The image that nicol_framebuffer_write_png would write, as red, green, blue and alpha 1. s1 to s3 need a
 * scale above 0 here, since nothing is read back. */
NICOL_API nicol_result nicol_framebuffer_draw_observation(nicol_framebuffer framebuffer,
                                                          const nicol_observation* observation,
                                                          const nicol_texture_target* target);

#ifdef __cplusplus
}
#endif

#endif
