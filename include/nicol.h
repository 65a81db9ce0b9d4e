/* SPDX-License-Identifier: MIT
 * Nicol: polarized light in real time, offscreen. Contexts, scenes, rendering, and reading of images.
 * nicol_psh.h has the mathematics, nicol_files.h the conversion and reports of files, and nicol.hpp the C++
 * classes for all three headers. */

/* clang-format off */
/* Conventions of all functions:
 *   Objects    Objects are opaque, counted handles. Creation gives one reference, _retain adds one, and _release drops
 *              one. Releasing NULL does nothing. An object keeps alive what it needs: any release order is legal.
 *   Results    Every function that can fail returns a nicol_result and leaves its outputs untouched on failure.
 *              nicol_last_error() then returns the message, per thread. Every function may return
 *              NICOL_ERROR_INVALID_ARGUMENT, _INVALID_HANDLE, _OUT_OF_MEMORY and _INTERNAL. A function that reads files
 *              may also return _FILE_NOT_FOUND, _INVALID_FILE, _UNSUPPORTED and _CANCELLED, a function that writes files
 *              _WRITE_FAILED, and a function that uses OpenGL _OPENGL. Comments name all other codes.
 *   Structs    A struct begins with struct_size = sizeof(the struct). NICOL_<TYPE>_INIT makes a struct with the defaults
 *              that the comments name. nicol_<type>_init(&x, sizeof x) sets the same defaults at run time, for languages
 *              that do not see macros: all bytes of x, and struct_size to its second argument. Every number means itself;
 *              0 stands for "automatic" or "none" only where a comment says so. Fields that a caller built with an older
 *              header does not have get their defaults. A function that fills a struct sets struct_size to the number of
 *              bytes that it filled: all of them, unless the caller was built with a newer header than the library.
 *   Threads    Any function may be called from any thread, except as "inside a host's OpenGL" says. Calls run in parallel,
 *              except that renders of one scene run one after another, as do calls that use one framebuffer, and commands
 *              of OpenGL in one context. Callbacks run on the calling thread unless stated otherwise.
 *   Numbers    Calls and their callbacks run in the default floating-point environment: rounding to nearest, no traps,
 *              subnormal numbers kept. Each call restores the caller's environment before it returns.
 *   Strings    Strings in arguments are UTF-8 and copied. Returned strings belong to the library; each comment says how
 *              long they live.
 *   Matrices   Matrices are row-major: the image of a point is M * (x, y, z, 1)^T. The default is the identity.
 *   World      The world is right-handed, with y up and the scene's own units. Angles are degrees unless a comment says
 *              radians.
 *   Light      Light is linear radiance per colour channel. A Stokes vector (s0, s1, s2, s3) is defined for a receiver
 *              that faces the source: s1 > 0 along the frame's x, s2 > 0 at +45 degrees from x to y, s3 > 0 right
 *              circular. In an image x points to the image's right and y up, as in Mitsuba 3's stokes integrator.
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

/* Marks what the next minor version lacks (capi/reference/stability.md). Compilers print the text, which
 * names the successor. */
#ifndef NICOL_DEPRECATED
#if defined(__GNUC__)
#define NICOL_DEPRECATED(text) __attribute__((deprecated(text)))
#elif defined(_MSC_VER)
#define NICOL_DEPRECATED(text) __declspec(deprecated(text))
#else
#define NICOL_DEPRECATED(text)
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- version and build */

#define NICOL_VERSION_MAJOR 0
#define NICOL_VERSION_MINOR 1
#define NICOL_VERSION_PATCH 0
#define NICOL_VERSION (NICOL_VERSION_MAJOR * 10000 + NICOL_VERSION_MINOR * 100 + NICOL_VERSION_PATCH)

/* Returns the version of the running library: major * 10000 + minor * 100 + patch. */
NICOL_API uint32_t nicol_version(void);
/* Returns the version of the running library as text, such as "0.1.0". The string lives as long as the
 * library. */
NICOL_API const char* nicol_version_string(void);
/* Returns a property of this build as "key=value" (source, compiler, backends, methods, max_order, ...).
 * index counts from 0; an index past the last property gives NULL. "files" lists the kinds of files that the
 * build reads: exr, bitmaps, mesh_files and scene_files may be left out; calls for the others fail with
 * NICOL_ERROR_UNSUPPORTED. The string lives as long as the library. */
NICOL_API const char* nicol_build_info(uint32_t index);

/* ---------------------------------------------------------------- results */

/* Result code of a function. Functions that return a nicol_result never let an exception out and may be
 * called on any thread. In a child that fork() made after the first of these calls, all of them fail with
 * NICOL_ERROR_UNSUPPORTED. A child made before the first call, and every newly started process, may use the
 * library. Any child may end by exit(). */
typedef int32_t nicol_result;
#define NICOL_OK 0
#define NICOL_ERROR_INVALID_ARGUMENT 1 /* value, size or pointer outside its documented range */
#define NICOL_ERROR_INVALID_HANDLE 2   /* handle that is NULL, released, or of another kind or context */
#define NICOL_ERROR_OUT_OF_MEMORY 3
#define NICOL_ERROR_FILE_NOT_FOUND 4 /* file that cannot be opened for reading */
#define NICOL_ERROR_INVALID_FILE 5   /* file that is truncated, malformed, or has values out of range */
#define NICOL_ERROR_WRITE_FAILED 6   /* output that could not be written; no part of the output remains */
#define NICOL_ERROR_UNSUPPORTED 7    /* well-formed input that is beyond this build, or a missing library */
#define NICOL_ERROR_NO_BACKEND 8     /* no OpenGL context could be created; the message lists every attempt */
#define NICOL_ERROR_CANCELLED 9      /* a callback returned 0, or the job was cancelled */
#define NICOL_ERROR_OPENGL 10        /* failure of the driver after the context was created */
#define NICOL_ERROR_INTERNAL 11      /* defect in Nicol */
#define NICOL_ERROR_NOT_CURRENT 12   /* the host's OpenGL context is not current on the calling thread */
#define NICOL_ERROR_TIMEOUT 13       /* the timeout expired */
#define NICOL_ERROR_BUSY 14          /* NICOL_MAX_JOBS jobs are queued, or the scene is being rendered */

/* Returns the message of the last failed call on this thread: one line that names the file, line, field or
 * argument and what is expected. The message is never NULL, and "" before the first failure. The string is
 * valid until this thread's next failed call. Tasks that move between threads, as in Go and in asynchronous
 * runtimes, may see another task's message: they keep their thread for both calls, or use the error callback
 * of nicol_context_options. */
NICOL_API const char* nicol_last_error(void);
/* Returns a name such as "out of memory" for a result code. The string lives as long as the library. */
NICOL_API const char* nicol_result_name(nicol_result result);

#define NICOL_LOG_INFO 0u    /* device that a new context opened */
#define NICOL_LOG_NOTICE 1u  /* request without effect, or cache that was rebuilt */
#define NICOL_LOG_WARNING 2u /* fallback, such as the CPU after a device failed */
/* Receives a message of the log. message is one line that lives as long as the call. code is NICOL_OK, or the
 * result that a call would have returned for the problem that Nicol worked around. The callback must not call
 * Nicol with objects of the context. */
typedef void (*nicol_log_callback)(void* user, uint32_t severity, nicol_result code, const char* message);

/* Receives a failure: the result code, the message of nicol_last_error(), and the function's name, such as
 * "nicol_render"; the strings live as long as the call. The callback runs on the thread of the failed call,
 * before the call returns. A job that fails reports from its own thread, as "nicol_render_async". The
 * callback must not call Nicol. */
typedef void (*nicol_error_callback)(void* user, nicol_result code, const char* message,
                                     const char* function);

/* Receives the progress of a call about ten times a second, on the calling thread; fraction runs from 0 to 1.
 * Returns 1 to continue, or 0 to cancel: the call then returns NICOL_ERROR_CANCELLED. The callback must not
 * call Nicol with objects of the same context. */
typedef int32_t (*nicol_progress_callback)(void* user, const char* verb, double fraction);

/* ---------------------------------------------------------------- objects */

typedef struct nicol_context_impl* nicol_context;         /* OpenGL context on its own thread, or a host's */
typedef struct nicol_environment_impl* nicol_environment; /* light from infinitely far; immutable */
typedef struct nicol_texture_impl* nicol_texture;         /* values that vary over a surface; immutable */
typedef struct nicol_material_impl* nicol_material;       /* polarimetric BRDF (pBRDF); immutable */
typedef struct nicol_mesh_impl* nicol_mesh;               /* triangles; immutable */
typedef struct nicol_scene_impl* nicol_scene;             /* instances, light and polarization elements */
typedef struct nicol_framebuffer_impl* nicol_framebuffer; /* Stokes image of the last render into it */

#define NICOL_MAX_CHANNELS 16
#define NICOL_MAX_ORDER 32
#define NICOL_ORDER_AUTOMATIC 0xffffffffu /* automatic choice of an order, see nicol_render_options */
#define NICOL_MAX_SIZE 16384

/* Values per colour channel. count 0: not given, so that the default of the field or argument applies; 1: one
 * value for every channel; else the scene's number of channels. */
typedef struct nicol_spectrum {
    uint32_t count;
    float values[NICOL_MAX_CHANNELS];
} nicol_spectrum;
/* clang-format off */
#define NICOL_SPECTRUM_INIT { 0, {0} }
#define NICOL_IDENTITY_4X4 { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }
/* clang-format on */
NICOL_API nicol_result nicol_spectrum_init(nicol_spectrum* descriptor, uint32_t struct_size);

#define NICOL_NO_LIMIT 0xffffffffffffffffULL

/* ---------------------------------------------------------------- context */

typedef uint32_t nicol_backend;
/* Backend that the environment variable NICOL_BACKEND names (egl, osmesa). If the variable is not set: the
 * first of EGL on hardware, EGL on software and OSMesa that works. */
#define NICOL_BACKEND_AUTOMATIC 0u
#define NICOL_BACKEND_EGL 1u
#define NICOL_BACKEND_OSMESA 2u
#define NICOL_BACKEND_HOST 3u /* backend of a context of nicol_context_create_host */

/* Gets the number of devices for nicol_context_options.device. The devices are those that EGL lists, in EGL's
 * order, which is neither CUDA's nor the kernel's. Without EGL the number is 0. The list may change when
 * devices or drivers are added or removed. */
NICOL_API nicol_result nicol_device_count(uint32_t* count);

typedef struct nicol_device_info {
    uint32_t struct_size;
    uint32_t software; /* 1 if OpenGL would run on the CPU, else 0 */
    /* Name from the driver, or another name that identifies the device. The strings are valid as long as the
     * library. */
    const char* name;
    const char* vendor; /* vendor; "" if EGL does not report one */
    const char* file;   /* device file, such as /dev/dri/renderD128; "" if none */
    /* Address on the PCI bus (domain, bus, device, function), such as "0000:65:00.0", by which CUDA and
     * Vulkan (VK_EXT_pci_bus_info) list the same device; "" if the device has none. nicol_context_info has
     * UUIDs, which a driver tells only to a context; LUIDs exist on Windows alone. */
    const char* pci_address;
} nicol_device_info;
#define NICOL_DEVICE_INFO_INIT \
    { sizeof(nicol_device_info), 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_device_info_init(nicol_device_info* descriptor, uint32_t struct_size);

/* Gets the properties of a device; device is 1 to the number of nicol_device_count. Creating a context on the
 * device may still fail, because this function does not create one. */
NICOL_API nicol_result nicol_device_get_info(uint32_t device, nicol_device_info* info);

/* Part of the library's parallel loops, for a host's task system. */
typedef void (*nicol_task)(void* data);
/* Begins `count` calls of task(data) on any threads of the host, and returns at once with a value that
 * nicol_finish_tasks takes. Calls return when the loops that they help with have ended, and at once if they
 * come later. The function is called on the thread that renders or loads. */
typedef void* (*nicol_start_tasks)(void* user, uint32_t count, nicol_task task, void* data);
/* Returns when all calls of one nicol_start_tasks have returned. */
typedef void (*nicol_finish_tasks)(void* user, void* started);

/* Receives the bytes of large blocks of memory: a positive number before they are taken, a negative one after
 * they were given back. Returns 1, or 0 to refuse a positive number: the call then fails with
 * NICOL_ERROR_OUT_OF_MEMORY, or its job, and gives back what it took. Other objects stay as they were. The
 * callback is called on any thread, on several at once, and must not call Nicol. */
typedef int32_t (*nicol_memory_callback)(void* user, int64_t bytes);

typedef struct nicol_context_options {
    uint32_t struct_size;
    nicol_backend backend; /* backend, default automatic; an explicit choice never falls back to another */
    /* Device, at most 1024. 0, the default: automatic; n: the device n of nicol_device_get_info, EGL's n -
     * 1. */
    uint32_t device;
    /* Number of threads, at most 1024. 0, the default: one per core, which is also the largest number
     * used. */
    uint32_t threads;
    /* Log callback, on any thread, on several at once; NULL, the default: silent. nicol_context_set_log
     * replaces it. */
    nicol_log_callback log;
    void* log_user;
    /* Folder in which material tables and baked visibility are kept between runs; created if missing. NULL,
     * the default, or "": the folder of the environment variable NICOL_CACHE, or no cache if the variable is
     * not set or empty. Processes may share the folder, and the folder may be emptied at any time. The
     * environment variable NICOL_CACHE_LIMIT limits the folder's bytes (default 4 GiB; 0: no limit): beyond
     * the limit, the least recently used files are removed. A folder that cannot be used causes a notice to
     * the log, not an error. */
    const char* cache_folder;
    /* Limit of the bytes that each scene keeps at run time, including those on the device; default
     * NICOL_NO_LIMIT. The limit covers visibility_bytes and transfer_bytes of the statistics, the OpenGL
     * buffers of the scene's vertices (without the work space of compute shaders), the textures of
     * polarization elements, and the memory beside the framebuffer for AOVs, several samples and shading at
     * pixels; with the reference method, the scene's triangles. A render computes an upper bound before it
     * bakes or allocates. If the bound exceeds the limit, the render fails with NICOL_ERROR_OUT_OF_MEMORY,
     * and the message has both numbers. If orders are automatic, the bound is for the orders 4 and 9. */
    uint64_t memory_limit;
    /* Limit of the bytes of each call that loads from files: 1 or more, or NICOL_NO_LIMIT; default 8 GiB. The
     * limit covers all files together and the data decoded from the files, counted before they are decoded: 4
     * bytes per value of an image, 16 more per pixel of a texture, 16 per pixel and channel of an
     * environment, inflated meshes and arrays, and tables of materials. Beyond this limit or one of the next
     * three, the call fails with NICOL_ERROR_UNSUPPORTED, and the message names the option. */
    uint64_t load_bytes_limit;
    /* Limit of the vertices of each call that loads from files, for a mesh or for all instances of a scene
     * together: 1 or more, or NICOL_NO_LIMIT; default 2^26. */
    uint64_t vertex_limit;
    /* Limit of the triangles of each call that loads from files, for a mesh or for all instances of a scene
     * together: 1 or more, or NICOL_NO_LIMIT; default 2^27. */
    uint64_t triangle_limit;
    /* Limit of the seconds of each call that loads from files; above 0, default 600. The time is checked
     * continually while files are read and their content is prepared. Only the decoding of one PNG or JPEG
     * and the parsing of one glTF file's JSON are not interrupted. */
    double load_seconds_limit;
    /* Progress callback of calls that load; NULL, the default: none. The loading thread calls the function
     * about ten times a second with the verb "load" and the fraction 0. If the function returns 0, the load
     * ends with NICOL_ERROR_CANCELLED. Threads that load at the same time call the function at the same
     * time. */
    nicol_progress_callback load_progress;
    void* load_progress_user;
    /* Error callback of failed calls that were given an object of the context, on any thread; NULL, the
     * default: none. */
    nicol_error_callback error;
    void* error_user;
    /* Task system of a host, whose threads help in the parallel loops of renders and loads: `threads` - 1 of
     * them beside the thread that renders or loads. Both functions, or NULL for both, the default: the
     * library's own threads help. OpenGL has a thread of its own all the same, and software OpenGL has more.
     * Functions that take no object of a context use the library's threads. */
    nicol_start_tasks start_tasks;
    nicol_finish_tasks finish_tasks;
    void* tasks_user;
    /* Memory monitor; NULL, the default: none. The monitor is told of each OpenGL buffer, texture and
     * framebuffer; of meshes, textures, images of light and measured tables when they have been made or
     * loaded, before the call returns their object; and of what a scene keeps for its renders: tables, bakes
     * and light. A render asks for an upper bound of visibility_bytes and transfer_bytes before it computes
     * anything, once more when meshes were refined, and at its end replaces the bound by what it keeps, which
     * includes response_bytes. Bytes beyond the bound are told at the end; if the monitor refuses them, the
     * render does not fail and they stay uncounted. A render that failed keeps its bound until the scene's
     * next render. The sum of the numbers that were not refused is 0 when all objects of the context are
     * released. */
    nicol_memory_callback memory;
    void* memory_user;
} nicol_context_options;
/* clang-format off */
#define NICOL_CONTEXT_OPTIONS_INIT \
    { sizeof(nicol_context_options), 0, 0, 0, 0, 0, 0, NICOL_NO_LIMIT, 0x200000000ULL, 1 << 26, 1 << 27, 600, 0, 0, \
      0, 0, 0, 0, 0, 0, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_context_options_init(nicol_context_options* descriptor, uint32_t struct_size);

typedef struct nicol_context_info {
    uint32_t struct_size;
    nicol_backend backend;
    uint32_t software;    /* 1 if OpenGL itself runs on the CPU, else 0 */
    uint32_t threads;     /* number of threads for the mathematics */
    const char* renderer; /* GL_RENDERER; lives as long as the context */
    const char* vendor;   /* GL_VENDOR; lives as long as the context */
    const char* version;  /* GL_VERSION; lives as long as the context */
    /* Largest width and height of a framebuffer, pixels: NICOL_MAX_SIZE, or less if the driver allows
     * less. */
    uint32_t max_framebuffer_size;
    uint32_t reserved; /* 0 */
    /* Limits in effect: this field and the next four, see nicol_context_options. */
    uint64_t memory_limit;
    uint64_t load_bytes_limit;
    uint64_t vertex_limit;
    uint64_t triangle_limit;
    double load_seconds_limit;
    /* UUIDs of the device and of the driver, by which Vulkan, CUDA and others find the same device: 32
     * hexadecimal digits, or "" if OpenGL does not tell (GL_EXT_memory_object); live as long as the context.
     */
    const char* device_uuid;
    const char* driver_uuid;
    /* Bytes of the OpenGL objects that the context holds now: buffers, textures and framebuffers, as
     * requested. */
    uint64_t device_bytes;
} nicol_context_info;
#define NICOL_CONTEXT_INFO_INIT \
    { sizeof(nicol_context_info), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_context_info_init(nicol_context_info* descriptor, uint32_t struct_size);

/* Creates a context. options may be NULL: all defaults. Returns NICOL_ERROR_NO_BACKEND if no such OpenGL
 * context can be created. */
NICOL_API nicol_result nicol_context_create(const nicol_context_options* options, nicol_context* context);
NICOL_API nicol_result nicol_context_retain(nicol_context context);
NICOL_API nicol_result nicol_context_release(nicol_context context);
/* Replaces the log callback of nicol_context_options; NULL: silent from now on. When the function returns, no
 * thread is in the callback before, whose user data may then be released. */
NICOL_API nicol_result nicol_context_set_log(nicol_context context, nicol_log_callback log, void* log_user);
/* Gets the properties of the OpenGL context, and the limits in effect. */
NICOL_API nicol_result nicol_context_get_info(nicol_context context, nicol_context_info* info);

/* ---------------------------------------------------------------- files in memory */

/* Content of a file that a resolver returns. */
typedef struct nicol_file_content {
    uint32_t struct_size;
    uint32_t reserved;  /* 0 */
    const void* bytes;  /* content; stays valid and unchanged until the loading call returns; default NULL */
    uint64_t byte_size; /* size of the content, bytes, default 0 */
} nicol_file_content;
#define NICOL_FILE_CONTENT_INIT \
    { sizeof(nicol_file_content), 0, 0, 0 }
NICOL_API nicol_result nicol_file_content_init(nicol_file_content* descriptor, uint32_t struct_size);

/* Finds a file that a file in memory names. Sets bytes and byte_size of content, which has its defaults, and
 * returns 1; or returns 0 if there is no such file. The name is joined to the folder of the naming file,
 * without "." and "folder/..": "maps/wood.png" in "rooms/hall.xml" is "rooms/maps/wood.png". The name may
 * begin with "/" or "..". The callback is called once per name, on the calling thread, and must not call
 * Nicol with objects of the same context. */
typedef int32_t (*nicol_resolve_callback)(void* user, const char* name, nicol_file_content* content);

/* A file in memory. The ..._load_memory functions read it as the ..._load functions read a file, within the
 * same limits, and with the same result. They read nothing from the file system. If the resolver does not
 * have a file, they return NICOL_ERROR_FILE_NOT_FOUND, and the message has the file's name. */
typedef struct nicol_memory_file {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    /* Name for messages. Its suffix determines the format, as for files on disk. Without a suffix, or if the
     * name is NULL, the default, the content determines the format; only TGA images need a suffix. */
    const char* name;
    const void* bytes;  /* content, not used after the call; default NULL */
    uint64_t byte_size; /* size of the content, bytes, default 0 */
    /* Resolver of the files that this file names; NULL, the default: there are none. */
    nicol_resolve_callback resolve;
    void* resolve_user; /* first argument of resolve, default NULL */
} nicol_memory_file;
#define NICOL_MEMORY_FILE_INIT \
    { sizeof(nicol_memory_file), 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_memory_file_init(nicol_memory_file* descriptor, uint32_t struct_size);

/* Receives the next bytes of a file that is written to memory, on the calling thread. bytes are valid until
 * the callback returns. Returns 1 to continue, or 0 to end the writing call, which then returns
 * NICOL_ERROR_WRITE_FAILED. The callback must not call Nicol with objects of the same context. */
typedef int32_t (*nicol_sink_callback)(void* user, const void* bytes, uint64_t byte_size);

/* ---------------------------------------------------------------- environment */

/* Equirectangular image over the directions that light comes FROM, in Mitsuba 3's layout: column u = atan2(x,
 * -z) / 2 pi (pixel-centred), row v = acos(y) / pi (row 0 is the pole itself, the last row the other
 * pole). */
typedef struct nicol_image {
    uint32_t struct_size;
    uint32_t width, height; /* size, pixels, 2 to NICOL_MAX_SIZE */
    uint32_t channels;      /* number of colour channels, 1 to NICOL_MAX_CHANNELS */
    /* Number of Stokes components. 1: s0 alone; 4: s0..s3 in the frame z = propagation, x = horizontal, along
     * growing u as seen from the scene's centre, y = z cross x. */
    uint32_t components;
    /* Values [row][column][channel][component]: finite, s0 >= 0, sqrt(s1^2 + s2^2 + s3^2) up to s0
     * (Eq. 70). */
    const float* pixels;
    uint64_t row_stride; /* bytes from row to row; 0, the default: tightly packed */
    uint64_t byte_size;  /* size of the memory that pixels points to, bytes; checked */
    /* Release callback; NULL, the default: none. Called once the library no longer reads pixels, on failure
     * too. */
    void (*release)(void* user);
    void* release_user;
} nicol_image;
#define NICOL_IMAGE_INIT \
    { sizeof(nicol_image), 0, 0, 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_image_init(nicol_image* descriptor, uint32_t struct_size);

/* Clear sky without the sun's own disc. At the angle g from the sun, the degree of linear polarization is
 * dop_max sin^2 g / (1 + cos^2 g), the electric field is along sun x view, and s3 is 0.
 *
 * Turbidity 0: light is scattered once, with radiance * 3/4 (1 + cos^2 g) over the whole sphere, below the
 * horizon too.
 *
 * Turbidity 1.7 (very clear) to 10 (hazy): brightness and, in three channels, colour follow Perez's formula,
 * scaled so that the mean luminance over the upper half is 1, times radiance. Below the horizon is an
 * unpolarized, uniform ground that reflects ground_albedo of each channel's irradiance. The sun must not be
 * below the horizon. */
typedef struct nicol_sky {
    uint32_t struct_size;
    float dop_max;           /* largest degree of linear polarization, 0 (unpolarized) to 1, default 0.8 */
    float sun_direction[3];  /* direction to the sun, of any length but 0; default (0, 1, 0), straight up */
    nicol_spectrum radiance; /* factor on the radiance, finite, not negative; default 1 in three channels */
    float turbidity;         /* turbidity, 1.7 to 10, or 0, the default: light is scattered once */
    float ground_albedo;     /* albedo of the ground, 0 to 1, default 0.2; without effect if turbidity is 0 */
} nicol_sky;
/* clang-format off */
#define NICOL_SKY_INIT \
    { sizeof(nicol_sky), 0.8f, {0, 1, 0}, NICOL_SPECTRUM_INIT, 0, 0.2f }
/* clang-format on */
NICOL_API nicol_result nicol_sky_init(nicol_sky* descriptor, uint32_t struct_size);

typedef struct nicol_environment_load_options {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    double scale;      /* factor on the radiance, finite and not negative, default 1 */
    /* Wavelengths to read from a spectral OpenEXR file, nm, within the file's range: the nearest channels of
     * the file, in this order. count 0, the default: all channels of the file. */
    nicol_spectrum wavelengths;
} nicol_environment_load_options;
#define NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT \
    { sizeof(nicol_environment_load_options), 0, 1, NICOL_SPECTRUM_INIT }
NICOL_API nicol_result nicol_environment_load_options_init(nicol_environment_load_options* descriptor,
                                                           uint32_t struct_size);

/* clang-format off */
/* Loads an environment from files in the format that the path names:
 *   NAME.exr      OpenEXR, equirectangular as nicol_image: R, G, B or Y are unpolarized light; S0.<colour> to
 *                 S3.<colour> are polarized light, in nicol_image's frames. Spectral files (S0.550,000000nm and so on)
 *                 have one channel per wavelength.
 *   NAME_s0.exr   to NAME_s3.exr, any of the four, or NAME alone: a cube map as a cross of 4 x 3 faces, one file per
 *                 Stokes component, as the Python package polarsh writes them.
 *   NAME.hdr      Radiance HDR, equirectangular, unpolarized light.
 *   NAME.png      or NAME.jpg, .bmp, .tga: equirectangular, unpolarized light, decoded from sRGB to 0 to 1.
 *   NAME.npz      PSH coefficients as polarsh writes them (SHVec).
 * options may be NULL: all defaults. */
/* clang-format on */
NICOL_API nicol_result nicol_environment_load(nicol_context context, const char* path,
                                              const nicol_environment_load_options* options,
                                              nicol_environment* environment);
/* Loads an environment from memory. The resolver returns the other files of a cube map. */
NICOL_API nicol_result nicol_environment_load_memory(nicol_context context, const nicol_memory_file* file,
                                                     const nicol_environment_load_options* options,
                                                     nicol_environment* environment);
/* Creates an environment from an image in memory. */
NICOL_API nicol_result nicol_environment_create_image(nicol_context context, const nicol_image* image,
                                                      nicol_environment* environment);
/* Creates an environment of unpolarized light that is equal from all directions. radiance is finite and not
 * negative; NULL or not given: 1 in one channel. */
NICOL_API nicol_result nicol_environment_create_constant(nicol_context context,
                                                         const nicol_spectrum* radiance,
                                                         nicol_environment* environment);
/* Creates a clear sky without the sun's own disc. */
NICOL_API nicol_result nicol_environment_create_sky(nicol_context context, const nicol_sky* sky,
                                                    nicol_environment* environment);
/* Creates an environment from PSH coefficients over PROPAGATION directions in the world's axes,
 * [channel][l*l + l + m][4] as nicol_psh.h defines. order is up to NICOL_PSH_MAX_ORDER (4096), channels 1 to
 * NICOL_MAX_CHANNELS, and count = channels * 4 (order+1)^2. Coefficients p = 1, 2 below l = 2 must be 0. The
 * light is band-limited and may ring: s0 may be below 0, and the polarization above s0. */
NICOL_API nicol_result nicol_environment_create_psh(nicol_context context, uint32_t order, uint32_t channels,
                                                    const double* coefficients, uint64_t count,
                                                    nicol_environment* environment);

typedef struct nicol_environment_info {
    uint32_t struct_size;
    uint32_t channels;
    uint32_t polarized;                     /* 1 if some s1, s2 or s3 is not 0, else 0 */
    uint32_t circular;                      /* 1 if some s3 is not 0, else 0 */
    uint32_t wavelength_count;              /* number of wavelengths: channels for spectral light, else 0 */
    uint32_t reserved;                      /* 0 */
    double wavelengths[NICOL_MAX_CHANNELS]; /* wavelengths of spectral light, nm */
} nicol_environment_info;
/* clang-format off */
#define NICOL_ENVIRONMENT_INFO_INIT \
    { sizeof(nicol_environment_info), 0, 0, 0, 0, 0, {0} }
/* clang-format on */
NICOL_API nicol_result nicol_environment_info_init(nicol_environment_info* descriptor, uint32_t struct_size);

/* Gets the properties of the light. */
NICOL_API nicol_result nicol_environment_get_info(nicol_environment environment,
                                                  nicol_environment_info* info);
NICOL_API nicol_result nicol_environment_retain(nicol_environment environment);
NICOL_API nicol_result nicol_environment_release(nicol_environment environment);

/* ---------------------------------------------------------------- texture */

/* Textures are values over a surface, given by the texture coordinates u and v or by the colours of the mesh.
 * v points down: the first row of an image begins at v = 0. An image covers u and v from 0 to 1, and the
 * centre of texel i is at (i + 0.5) / width. Values are linear and have one channel, three (red, green and
 * blue), or four (and coverage). */

typedef uint32_t nicol_texture_filter;
#define NICOL_TEXTURE_FILTER_NEAREST 0u
#define NICOL_TEXTURE_FILTER_BILINEAR 1u
#define NICOL_TEXTURE_FILTER_MIPMAP \
    2u /* bilinear on smaller images where a pixel covers many texels, which is sharp also at a slant */

typedef uint32_t nicol_texture_wrap; /* continuation of an image beyond u and v of 0 to 1 */
#define NICOL_TEXTURE_WRAP_REPEAT 0u
#define NICOL_TEXTURE_WRAP_MIRROR 1u
#define NICOL_TEXTURE_WRAP_CLAMP 2u

typedef uint32_t nicol_texel;
#define NICOL_TEXEL_UINT8 0u  /* uint8_t, n / 255 */
#define NICOL_TEXEL_UINT16 1u /* uint16_t, n / 65535 */
#define NICOL_TEXEL_FLOAT32 2u

typedef struct nicol_texture_image {
    uint32_t struct_size;
    nicol_texel type;
    uint32_t width, height; /* size, pixels, 1 to 32768 each, and at most 3 * 2^26 pixels in all */
    uint32_t channels;      /* number of channels: 1, 3 (red, green, blue) or 4 (and coverage) */
    uint32_t reserved;      /* 0 */
    const void* pixels;     /* values [row][column][channel], first row at the top; finite */
    uint64_t row_stride;    /* bytes from row to row; 0, the default: tightly packed */
    uint64_t byte_size;     /* size of the memory that pixels points to, bytes; checked */
} nicol_texture_image;
#define NICOL_TEXTURE_IMAGE_INIT \
    { sizeof(nicol_texture_image), 0, 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_texture_image_init(nicol_texture_image* descriptor, uint32_t struct_size);

typedef struct nicol_texture_options {
    uint32_t struct_size;
    nicol_texture_filter filter; /* filter, default bilinear */
    nicol_texture_wrap wrap;     /* wrap mode, default repeat */
    /* Encoding of integers. 0, the default: integers of 8 and 16 bits are decoded from sRGB, except coverage.
     * 1: integers are linear values, as for roughness, normals and heights. Floats are always linear
     * values. */
    uint32_t raw;
    /* 3 x 3 transform from (u, v, 1) of the surface to that of the texture; last row 0 0 1; default the
     * identity. */
    double to_uv[9];
} nicol_texture_options;
/* clang-format off */
#define NICOL_TEXTURE_OPTIONS_INIT \
    { sizeof(nicol_texture_options), NICOL_TEXTURE_FILTER_BILINEAR, 0, 0, { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }
/* clang-format on */
NICOL_API nicol_result nicol_texture_options_init(nicol_texture_options* descriptor, uint32_t struct_size);

/* Creates a texture from an image in memory and copies the pixels. options may be NULL: all defaults. */
NICOL_API nicol_result nicol_texture_create_image(nicol_context context, const nicol_texture_image* image,
                                                  const nicol_texture_options* options,
                                                  nicol_texture* texture);
/* Loads a texture from a file of PNG, JPEG, BMP, TGA, Radiance HDR, or OpenEXR with R G B or Y; A is the
 * coverage. options may be NULL: all defaults. */
NICOL_API nicol_result nicol_texture_load(nicol_context context, const char* path,
                                          const nicol_texture_options* options, nicol_texture* texture);
/* Loads a texture from memory. */
NICOL_API nicol_result nicol_texture_load_memory(nicol_context context, const nicol_memory_file* file,
                                                 const nicol_texture_options* options,
                                                 nicol_texture* texture);
/* Creates Mitsuba 3's checkerboard of colours: four squares per unit square of u and v, color0 at u = v = 0.
 * Colours have 1 or 3 values; NULL or not given: 0.4 and 0.2. to_uv is that of nicol_texture_options; NULL:
 * identity. */
NICOL_API nicol_result nicol_texture_create_checkerboard(nicol_context context, const nicol_spectrum* color0,
                                                         const nicol_spectrum* color1, const double to_uv[9],
                                                         nicol_texture* texture);
/* Creates a texture of the colours of the mesh's vertices, interpolated. */
NICOL_API nicol_result nicol_texture_create_vertex_colors(nicol_context context, nicol_texture* texture);
/* Creates a texture of the colours of the mesh's triangles. A material may use colours of triangles or of
 * vertices, not both. */
NICOL_API nicol_result nicol_texture_create_face_colors(nicol_context context, nicol_texture* texture);
NICOL_API nicol_result nicol_texture_retain(nicol_texture texture);
NICOL_API nicol_result nicol_texture_release(nicol_texture texture);

/* ---------------------------------------------------------------- material */

/* Textures give each point of a surface its own value of a material's parameter. Instances of a material with
 * textures need a mesh with texture coordinates, or with colours. */

typedef uint32_t nicol_distribution;
#define NICOL_DISTRIBUTION_BECKMANN 0u
#define NICOL_DISTRIBUTION_GGX 1u

/* Thin film on a surface, such as an oxide, oil, soap or the coating of a lens. All reflections inside the
 * film interfere: their complex amplitudes are summed for s and p apart (Airy). A channel of red, green or
 * blue has the mean over its response to the spectrum, of the CIE 1931 observer under D65, clipped to what is
 * physically possible; a channel of one wavelength is exact. */
typedef struct nicol_film {
    float thickness;   /* thickness, nm, 0 to 10000; 0, the default: no film */
    float eta;         /* real part of the refractive index, 0.1 to 100, default 1.5 */
    float k;           /* extinction coefficient of the refractive index, 0 to 100, default 0 */
    uint32_t reserved; /* 0 */
    /* Wavelengths, one per channel of the material, nm, 100 to 5000. count 0, the default: red, green and
     * blue. */
    nicol_spectrum wavelengths;
} nicol_film;
/* clang-format off */
#define NICOL_FILM_INIT { 0, 1.5f, 0, 0, NICOL_SPECTRUM_INIT }
/* clang-format on */
NICOL_API nicol_result nicol_film_init(nicol_film* descriptor, uint32_t struct_size);

/* Plastic as Mitsuba 3's pplastic: rough Fresnel reflection over a diffuse base, both polarizing. Only the
 * front side reflects. */
typedef struct nicol_pplastic {
    uint32_t struct_size;
    nicol_distribution distribution;     /* distribution of the facets, default Beckmann */
    nicol_spectrum diffuse_reflectance;  /* reflectance of the base, 0 to 1, default 0.5 */
    nicol_spectrum specular_reflectance; /* factor on the Fresnel reflection, 0 to 1, default 1 */
    float int_ior;                       /* refractive index inside, above 0, default 1.49 */
    float ext_ior;                       /* refractive index outside, above 0, default 1.000277 */
    float alpha;                         /* roughness, 0.001 to 1, default 0.1 */
    uint32_t reserved;                   /* 0 */
    /* Texture that replaces diffuse_reflectance; NULL, the default: none. */
    nicol_texture diffuse_reflectance_texture;
    /* Texture that replaces specular_reflectance; NULL, the default: none. */
    nicol_texture specular_reflectance_texture;
    /* Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none. */
    nicol_texture alpha_texture;
    /* Roughness along texture coordinates u and v, 0.001 to 1; 0, the default: alpha. If the two differ, the
     * surface is anisotropic, see nicol_conductor. */
    float alpha_u;
    float alpha_v;
    /* Textures that replace alpha_u and alpha_v; NULL, the default: none, but alpha_texture if the number is
     * 0. */
    nicol_texture alpha_u_texture;
    nicol_texture alpha_v_texture;
    nicol_film film; /* film on the boundary, default none */
    /* Texture whose first channel, clamped to 0 to 1, varies the thickness of the film: film_thickness_least
     * at 0, film.thickness at 1, linear between; NULL, the default: none. A texture of more than 16 values is
     * interpolated between up to 25 thicknesses. */
    nicol_texture film_thickness_texture;
    double film_thickness_least; /* thickness of the film where its texture is 0, nm, 0 to 10000, default 0 */
} nicol_pplastic;
/* clang-format off */
#define NICOL_PPLASTIC_INIT                                                                        \
    { sizeof(nicol_pplastic), 0, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, 1.49f, 1.000277f, 0.1f, \
      0, 0, 0, 0, 0, 0, 0, 0, NICOL_FILM_INIT, 0, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_pplastic_init(nicol_pplastic* descriptor, uint32_t struct_size);

/* Creates a material from nicol_pplastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
 * out of range. */
NICOL_API nicol_result nicol_material_create_pplastic(nicol_context context, const nicol_pplastic* parameters,
                                                      nicol_material* material);

/* Plastic as Mitsuba 3's plastic and roughplastic: Fresnel reflection over a diffuse base, both depolarizing.
 * nicol_pplastic is the model that polarizes. Only the front side reflects. */
typedef struct nicol_plastic {
    uint32_t struct_size;
    nicol_distribution distribution;     /* distribution of the facets of a rough surface, default Beckmann */
    nicol_spectrum diffuse_reflectance;  /* reflectance of the base, 0 to 1, default 0.5 */
    nicol_spectrum specular_reflectance; /* factor on the Fresnel reflection, 0 to 1, default 1 */
    float int_ior;                       /* refractive index inside, above 0, default 1.49 */
    float ext_ior;                       /* refractive index outside, above 0, default 1.000277 */
    float alpha; /* roughness, 0.001 to 1; 0, the default: smooth, see alpha of nicol_conductor */
    /* Whether light that the surface returns to the base takes the base's colour each time, which makes
     * colours deeper: 0, the default, or 1. */
    uint32_t nonlinear;
    /* Texture that replaces diffuse_reflectance; NULL, the default: none. */
    nicol_texture diffuse_reflectance_texture;
    /* Texture that replaces specular_reflectance; NULL, the default: none. */
    nicol_texture specular_reflectance_texture;
    /* Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none. */
    nicol_texture alpha_texture;
} nicol_plastic;
/* clang-format off */
#define NICOL_PLASTIC_INIT                                                                     \
    { sizeof(nicol_plastic), 0, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, 1.49f, 1.000277f, 0, \
      0, 0, 0, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_plastic_init(nicol_plastic* descriptor, uint32_t struct_size);

/* Creates a material from nicol_plastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
 * out of range. */
NICOL_API nicol_result nicol_material_create_plastic(nicol_context context, const nicol_plastic* parameters,
                                                     nicol_material* material);

/* Disney's material as Mitsuba 3's principled. What it reflects is unpolarized. Light that passes the surface
 * (spec_trans above 0) is followed as that of a rough nicol_dielectric. Only the front side reflects. Numbers
 * are 0 to 1, default 0, unless stated otherwise. */
typedef struct nicol_principled {
    uint32_t struct_size;
    /* Relative refractive index of the facets, 0.001 to 1000, default 1.5. 1: no facets, not even of a metal.
     * Disney's `specular` corresponds to the index 2 / (1 - sqrt(0.08 specular)) - 1. */
    float eta;
    nicol_spectrum base_color; /* colour of the base, 0 to 1, default 0.5 */
    float roughness;           /* roughness, 0 to 1, default 0.5; GGX facets have alpha = roughness^2 */
    /* Anisotropy: the facets' alpha along growing u is 1 / (1 - 0.9 anisotropic) times the alpha across
     * u. */
    float anisotropic;
    float metallic;
    /* Fraction of the diffuse base that transmits light instead of reflecting it, times the square root of
     * base_color; the means of textures. */
    float spec_trans;
    /* Tint of the reflection, from white (0) to the tint of the base (1), which is its colour over its
     * luminance. */
    float spec_tint;
    float sheen;
    float sheen_tint; /* tint of the sheen, from white (0) to the tint of the base (1) */
    float flatness;   /* shape of the base, from diffuse (0) to one like subsurface scattering (1) */
    float clearcoat;
    float clearcoat_gloss;
    uint32_t reserved; /* 0 */
    /* Textures: each replaces the number of its name; NULL, the default: the number is used.
     * base_color_texture gives colours, and must not have the colours of a mesh beside spec_tint or
     * sheen_tint. The other textures give their first channel, clamped to 0 to 1; roughness is clamped to 0.1
     * to 1, anisotropic and clearcoat_gloss to 0.01 to 1. */
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
NICOL_API nicol_result nicol_principled_init(nicol_principled* descriptor, uint32_t struct_size);

/* Creates a material from nicol_principled. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
 * is out of range. Returns NICOL_ERROR_UNSUPPORTED for a tint of a mesh's colours. */
NICOL_API nicol_result nicol_material_create_principled(nicol_context context,
                                                        const nicol_principled* parameters,
                                                        nicol_material* material);
/* Creates a Lambertian, depolarizing material. reflectance is 0 to 1; NULL or not given: 0.5. Only the front
 * side reflects. */
NICOL_API nicol_result nicol_material_create_diffuse(nicol_context context, const nicol_spectrum* reflectance,
                                                     nicol_material* material);

/* Metal as Mitsuba 3's conductor and roughconductor: single reflection off the facets of an opaque metal. The
 * complex index is eta - i k, relative to air. With k = 0 and the index of a dielectric as eta, the material
 * reflects like the surface of the dielectric, such as glass whose inside is not seen. Only the front side
 * reflects. */
typedef struct nicol_conductor {
    uint32_t struct_size;
    nicol_distribution distribution; /* distribution of the facets of a rough surface, default Beckmann */
    /* Roughness, 0.001 to 1; 0, the default: smooth. Beckmann's facets of roughness 0.01 stand for a smooth
     * surface, which is a blur of one degree. The factored method mirrors local lights with a size, and the
     * image of an environment, without this blur; the reference method mirrors everything without it where
     * the material has no other terms, such as smooth metal. A smooth surface does not reflect lights without
     * a size (points, spots, projectors, and directional lights whose angular_radius is 0), because a mirror
     * would show them as points. */
    float alpha;
    uint32_t reserved; /* 0 */
    /* Name of a metal with measured values: a name of Mitsuba's list such as "Au", "Ag", "Cu", "Al", "W" or
     * "TiN_palik", or "gold", "silver", "copper" or "aluminium". eta and k must be empty beside a name. NULL,
     * the default, or "": eta and k are used. */
    const char* metal;
    nicol_spectrum eta; /* real part of the index, 0 to 100, default 0 */
    /* Extinction coefficient of the index, 0 to 100, default 1, which is a perfect mirror with eta = 0; eta^2
     * + k^2 must be 1e-6 or more. */
    nicol_spectrum k;
    /* Wavelengths of a named metal, one per channel, nm, 380 to 800. count 0, the default: red, green and
     * blue as in Mitsuba, the colours of light with the spectra of eta and of k. A constant spectrum is white
     * of equal energy. */
    nicol_spectrum wavelengths;
    nicol_spectrum specular_reflectance; /* factor on the reflection, 0 to 1, default 1 */
    /* Texture that replaces specular_reflectance; NULL, the default: none. */
    nicol_texture specular_reflectance_texture;
    /* Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none. */
    nicol_texture alpha_texture;
    /* Roughness along texture coordinate u, 0.001 to 1, as of brushed metal; 0, the default: alpha. If
     * alpha_u and alpha_v differ, the reflection follows the direction of u, which is arbitrary for a mesh
     * without texture coordinates. Only light in harmonics, of the dense method, of
     * NICOL_HIGH_ORDERS_CONVOLUTION and of bsdf_samples 0, is reflected with the roughness
     * sqrt(alpha_u alpha_v). */
    float alpha_u;
    /* Roughness along texture coordinate v, 0.001 to 1; 0, the default: alpha. */
    float alpha_v;
    /* Texture that replaces alpha_u; NULL, the default: none, but alpha_texture if alpha_u is 0. */
    nicol_texture alpha_u_texture;
    /* Texture that replaces alpha_v; NULL, the default: none, but alpha_texture if alpha_v is 0. */
    nicol_texture alpha_v_texture;
    nicol_film film; /* film on the facets, default none */
    /* Texture whose first channel, clamped to 0 to 1, varies the thickness of the film: film_thickness_least
     * at 0, film.thickness at 1, linear between; NULL, the default: none. A texture of more than 16 values is
     * interpolated between up to 25 thicknesses. */
    nicol_texture film_thickness_texture;
    double film_thickness_least; /* thickness of the film where its texture is 0, nm, 0 to 10000, default 0 */
} nicol_conductor;
/* clang-format off */
#define NICOL_CONDUCTOR_INIT                                                                        \
    { sizeof(nicol_conductor), 0, 0, 0, 0, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT,                \
      NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, 0, 0, 0, 0, 0, 0, NICOL_FILM_INIT, 0, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_conductor_init(nicol_conductor* descriptor, uint32_t struct_size);

/* Creates a material from nicol_conductor. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
 * is out of range or, for an unknown metal, the known metals. */
NICOL_API nicol_result nicol_material_create_conductor(nicol_context context,
                                                       const nicol_conductor* parameters,
                                                       nicol_material* material);

/* Glass as Mitsuba 3's dielectric, roughdielectric and thindielectric: a boundary that reflects and transmits
 * light, polarized as Fresnel's formulas say. The factored method follows light through it by rays at pixels,
 * the reference method by its paths; max_depth of nicol_render_options limits how often. By the factored
 * method with a max_depth above 2, smooth glass and smooth metal bend the light of local lights to other
 * surfaces, as unpolarized light: 131,072 paths, found anew when local lights, bright parts of the
 * environment or surfaces change or turn, make caustics. Otherwise, and through rough glass, the light of
 * local lights passes straight on, dimmed in each channel as unpolarized light is; the light of the
 * environment passes straight on and is dimmed equally in all channels, by their mean. Metal of a roughness
 * below 0.25 shows the environment as glass bends it. The dense method and shading at vertices return
 * NICOL_ERROR_UNSUPPORTED. The surface of a body must be closed, its normals pointing outwards, and bodies
 * must not overlap. */
typedef struct nicol_dielectric {
    uint32_t struct_size;
    /* 0, the default: the surface bounds a body, and refracts the light that it transmits. 1: the surface is
     * a thin pane, such as a window of one rectangle, which transmits light straight on; all reflections
     * inside the pane are summed, without interference. */
    uint32_t thin;
    float int_ior; /* refractive index inside, 0.001 to 1000, default 1.5046 (borosilicate glass) */
    float ext_ior; /* refractive index outside, 0.001 to 1000, default 1.000277 (air) */
    nicol_spectrum specular_reflectance;   /* factor on reflected light, 0 to 1, default 1 */
    nicol_spectrum specular_transmittance; /* factor on transmitted light, 0 to 1, default 1 */
    /* Absorption coefficient of the inside, per unit of length in the world, 0 or more, default 0: a path of
     * length d through the body transmits exp(-absorption d) (Beer's law). Only 0 for a thin pane. */
    nicol_spectrum absorption;
    /* Roughness of facets, 0.001 to 1; 0, the default: smooth. Light through a rough surface is sampled at
     * each pixel, so it is noisy; more pixel_samples reduce the noise. The factored method shows no lights
     * without a size (points, spots, projectors, and directional lights whose angular_radius is 0) through
     * glass. A smooth surface does not reflect them either. */
    float alpha;
    nicol_distribution distribution; /* distribution of the facets of a rough surface, default Beckmann */
    /* Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none. The texture
     * varies what a body reflects; facets that transmit light, and those of a thin pane, have its mean. */
    nicol_texture alpha_texture;
    /* Film on the boundary, or on both sides of a thin pane, default none. A soap film in air is a film on a
     * body whose int_ior equals ext_ior. */
    nicol_film film;
} nicol_dielectric;
/* clang-format off */
#define NICOL_DIELECTRIC_INIT                                                                     \
    { sizeof(nicol_dielectric), 0, 1.5046f, 1.000277f, NICOL_SPECTRUM_INIT, NICOL_SPECTRUM_INIT, \
      NICOL_SPECTRUM_INIT, 0, 0, 0, NICOL_FILM_INIT }
/* clang-format on */
NICOL_API nicol_result nicol_dielectric_init(nicol_dielectric* descriptor, uint32_t struct_size);

/* Creates a material from nicol_dielectric. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
 * is out of range. */
NICOL_API nicol_result nicol_material_create_dielectric(nicol_context context,
                                                        const nicol_dielectric* parameters,
                                                        nicol_material* material);

typedef uint32_t nicol_wavelength_sampling;
#define NICOL_WAVELENGTH_LINEAR 0u  /* linear between the measured wavelengths, constant beyond them */
#define NICOL_WAVELENGTH_NEAREST 1u /* nearest measured wavelength */

typedef struct nicol_measured {
    uint32_t struct_size;
    /* Interpolation between measured wavelengths, default linear; used only for the wavelengths of the next
     * field. */
    nicol_wavelength_sampling sampling;
    /* Wavelengths, one per channel, nm, 100 to 5000. count 0, the default: red, green and blue by the CIE
     * 1931 observer under D65, or one channel if the file has one wavelength. */
    nicol_spectrum wavelengths;
    /* Whether the part that breaks mirror symmetry, which contains noise of the measurement, is removed: 0,
     * the default, or 1. */
    uint32_t symmetrize;
} nicol_measured;
#define NICOL_MEASURED_INIT \
    { sizeof(nicol_measured), 0, NICOL_SPECTRUM_INIT, 0 }
NICOL_API nicol_result nicol_measured_init(nicol_measured* descriptor, uint32_t struct_size);

/* Loads a material as Mitsuba 3's measured_polarized from a .pbsdf file, such as the KAIST data set has. The
 * file is streamed: about 102 MB per channel stay in memory at the data set's resolution, or half as much if
 * symmetrized. options may be NULL: all defaults. Only the front side reflects. */
NICOL_API nicol_result nicol_material_load_measured(nicol_context context, const char* path,
                                                    const nicol_measured* options, nicol_material* material);
/* Loads a measured material from memory. */
NICOL_API nicol_result nicol_material_load_measured_memory(nicol_context context,
                                                           const nicol_memory_file* file,
                                                           const nicol_measured* options,
                                                           nicol_material* material);

typedef struct nicol_psh_matrix {
    uint32_t struct_size;
    uint32_t symmetrize;  /* whether the part that breaks mirror symmetry is removed: 0, the default, or 1 */
    nicol_spectrum scale; /* factor on the matrix, not negative, default 1 */
} nicol_psh_matrix;
#define NICOL_PSH_MATRIX_INIT \
    { sizeof(nicol_psh_matrix), 0, NICOL_SPECTRUM_INIT }
NICOL_API nicol_result nicol_psh_matrix_init(nicol_psh_matrix* descriptor, uint32_t struct_size);

/* Loads an isotropic material from one PSH coefficient matrix per channel, cosine included: the .npz files of
 * the Python package polarsh (SHMat in the layout ISOBI2). The material does not reflect light of orders
 * above the matrix's. options may be NULL: all defaults. Only the front side reflects. */
NICOL_API nicol_result nicol_material_load_psh(nicol_context context, const char* path,
                                               const nicol_psh_matrix* options, nicol_material* material);
/* Loads a material of PSH matrices from memory. */
NICOL_API nicol_result nicol_material_load_psh_memory(nicol_context context, const nicol_memory_file* file,
                                                      const nicol_psh_matrix* options,
                                                      nicol_material* material);
/* Creates a material whose back side reflects as its front side. `front` may be released afterwards. */
NICOL_API nicol_result nicol_material_create_twosided(nicol_context context, nicol_material front,
                                                      nicol_material* material);

/* Creates the product of a material and a texture: a diffuse material of reflectance 1 gets the texture's
 * colours. The given handles may be released afterwards. */
NICOL_API nicol_result nicol_material_create_scaled(nicol_context context, nicol_material base,
                                                    nicol_texture scale, nicol_material* material);
/* Creates the mixture first (1 - t) + second t, with t = the weight's first channel, clamped to 0 to 1
 * (Mitsuba 3's blendbsdf). If one material is two-sided, the mixture is too, and the other material is black
 * on the back. The given handles may be released afterwards. */
NICOL_API nicol_result nicol_material_create_blend(nicol_context context, nicol_material first,
                                                   nicol_material second, nicol_texture weight,
                                                   nicol_material* material);
/* Creates a material with perturbed normals from a raw texture with values t: shading normals 2 t - 1 in the
 * frame of the surface, with x along growing u (Mitsuba 3's normalmap). mirrored_y 0: y completes a
 * right-handed frame; 1: y points to where v falls, as in glTF. The two values differ where texture
 * coordinates are mirrored. The given handles may be released afterwards. */
NICOL_API nicol_result nicol_material_create_normal_map(nicol_context context, nicol_material base,
                                                        nicol_texture normals, uint32_t mirrored_y,
                                                        nicol_material* material);
/* Creates a material with perturbed normals from heights: shading normals of a surface that is displaced
 * along its normal by scale times the texture's first channel, in the scene's units (Mitsuba 3's bumpmap).
 * The given handles may be released afterwards. */
NICOL_API nicol_result nicol_material_create_bump_map(nicol_context context, nicol_material base,
                                                      nicol_texture heights, double scale,
                                                      nicol_material* material);
/* Creates a material whose anisotropic parts are rotated within the surface, as by glTF's
 * KHR_materials_anisotropy. directions is a raw texture with values t, or NULL: the first two of 2 t - 1 are
 * the direction in which u would grow, in the frame of x along growing u and y to where v falls. angle, in
 * radians from x towards y, is added. The given handles may be released afterwards. */
NICOL_API nicol_result nicol_material_create_rotated(nicol_context context, nicol_material base,
                                                     nicol_texture directions, double angle,
                                                     nicol_material* material);
/* Creates a material with an alpha mask: the surface is cut out where the opacity is below 0.5 (Mitsuba 3's
 * mask of opacities 0 and 1). The opacity is the texture's coverage or, with fewer than four channels, the
 * first channel. The given handles may be released afterwards. */
NICOL_API nicol_result nicol_material_create_mask(nicol_context context, nicol_material base,
                                                  nicol_texture opacity, nicol_material* material);

/* Writes the Mueller matrix of one colour channel: 16 row-major doubles, 1/sr, without the cosine. The light
 * comes from the direction `towards_light` and goes into the direction `towards_viewer`: unit vectors with
 * z > 0 in the surface's frame, whose normal is z. Both Stokes frames have x along the s-axis towards_light x
 * towards_viewer, z along the propagation and y = z cross x, as Fresnel's matrices do. If the directions are
 * equal, x is any perpendicular direction, the same for both frames. Returns 1 to continue, or 0 to end the
 * call that needs the matrix with NICOL_ERROR_CANCELLED. nicol_material_create_callback and nicol_render call
 * the function, on several threads at once. The function must not call Nicol with objects of the material's
 * context. */
typedef int32_t (*nicol_mueller_callback)(void* user, uint32_t channel, const double towards_light[3],
                                          const double towards_viewer[3], double mueller[16]);

typedef struct nicol_callback_material {
    uint32_t struct_size;
    uint32_t channels; /* number of colour channels, 1 to NICOL_MAX_CHANNELS, default 1 */
    nicol_mueller_callback mueller;
    void* user; /* first argument of mueller, and the argument of release */
    /* Release callback; NULL, the default: none. Called once, when `user` is no longer needed: on failure
     * before the call returns, else when the material and all its users are released, on the thread of the
     * last release. */
    void (*release)(void* user);
    /* Angular radius of the narrowest feature about the mirror direction, radians, 0.001 to 1, default 1. A
     * value that is too large loses highlights; a value that is too small costs time. */
    float lobe_width;
    uint32_t reserved; /* 0 */
} nicol_callback_material;
#define NICOL_CALLBACK_MATERIAL_INIT \
    { sizeof(nicol_callback_material), 1, 0, 0, 0, 1, 0 }
NICOL_API nicol_result nicol_callback_material_init(nicol_callback_material* descriptor,
                                                    uint32_t struct_size);

/* Creates a material from a function, which must be isotropic, mirror symmetric about every plane through the
 * normal, and finite. Returns NICOL_ERROR_INVALID_ARGUMENT if a test at some directions shows that the
 * function is not. Only the front side reflects. */
NICOL_API nicol_result nicol_material_create_callback(nicol_context context,
                                                      const nicol_callback_material* parameters,
                                                      nicol_material* material);
NICOL_API nicol_result nicol_material_retain(nicol_material material);
NICOL_API nicol_result nicol_material_release(nicol_material material);

/* ---------------------------------------------------------------- mesh */

/* Triangles in memory. All numbers must be finite and all indices valid. Triangles without area are left out,
 * and logged once. */
typedef struct nicol_mesh_data {
    uint32_t struct_size;
    uint32_t vertex_count;   /* number of vertices, 1 or more */
    uint32_t triangle_count; /* number of triangles, 1 or more */
    /* Number of pairs in texcoords; 0, the default: vertex_count if texcoords is not NULL. */
    uint32_t texcoord_count;
    const float* positions; /* positions, 3 numbers per vertex */
    /* Normals, 3 numbers per vertex, of any length; a normal of length 0 stands for the smooth normal. NULL,
     * the default: normals made from the triangles, smooth across edges whose faces share vertices. */
    const float* normals;
    const uint32_t* indices; /* vertex indices, 3 per triangle, counter-clockwise from the front */
    const float* texcoords;  /* texture coordinates u, v, see nicol_texture_image; NULL, the default: none */
    /* Indices into texcoords, 3 per triangle, so that a seam of texture coordinates splits no vertex. NULL,
     * the default: indices is used, with one pair of texture coordinates per vertex. */
    const uint32_t* texcoord_indices;
    /* Linear colours, 3 per vertex, see nicol_texture_create_vertex_colors; NULL, the default: none. */
    const float* colors;
    /* Linear colours, 3 per triangle, see nicol_texture_create_face_colors; NULL, the default: none. */
    const float* face_colors;
    /* Tangents, 4 numbers per pair in texcoords, as in glTF: x, y and z, of any length, are the x axis of
     * normal maps and of anisotropic materials, which otherwise is the direction of growing u; the y axis is
     * w cross(normal, x), w 1 or -1. NULL, the default, or of length 0: the directions of u and v. */
    const float* tangents;
} nicol_mesh_data;
#define NICOL_MESH_DATA_INIT \
    { sizeof(nicol_mesh_data), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_mesh_data_init(nicol_mesh_data* descriptor, uint32_t struct_size);

/* Loads a mesh from OBJ, PLY, OFF, STL or the first mesh of Mitsuba's .serialized, by the file's suffix.
 * Polygons may be concave. Triangles without area, vertices without a face, and elements that the reader
 * ignores (materials) are left out; one line of the log counts them. Texture coordinates and colours of
 * vertices and faces are kept. v of OBJ, which points up, becomes 1 - v. The message of
 * NICOL_ERROR_INVALID_FILE names the line, vertex or face. */
NICOL_API nicol_result nicol_mesh_load(nicol_context context, const char* path, nicol_mesh* mesh);
/* Loads a mesh from memory. */
NICOL_API nicol_result nicol_mesh_load_memory(nicol_context context, const nicol_memory_file* file,
                                              nicol_mesh* mesh);
/* Creates a mesh from arrays and copies the arrays. A render adds vertices where shadows need them, see
 * refine_tolerance of nicol_render_options. */
NICOL_API nicol_result nicol_mesh_create(nicol_context context, const nicol_mesh_data* data,
                                         nicol_mesh* mesh);
/* Creates the unit sphere, divided finely enough for per-vertex shading, with the texture coordinates of
 * Mitsuba 3's sphere. */
NICOL_API nicol_result nicol_mesh_create_sphere(nicol_context context, nicol_mesh* mesh);
/* Creates the unit sphere with a chosen number of vertices: 10 segments^2 + 2. The sphere is an icosahedron
 * whose edges are each cut into `segments` parts; segments is even, 2 to 512. nicol_mesh_create_sphere has 38
 * segments. */
NICOL_API nicol_result nicol_mesh_create_divided_sphere(nicol_context context, uint32_t segments,
                                                        nicol_mesh* mesh);
/* Creates the rectangle [-1, 1]^2 in the plane z = 0, facing +z, with the texture coordinates of Mitsuba 3's
 * rectangle. */
NICOL_API nicol_result nicol_mesh_create_rectangle(nicol_context context, nicol_mesh* mesh);
/* Creates the cube [-1, 1]^3, with the texture coordinates of Mitsuba 3's cube. */
NICOL_API nicol_result nicol_mesh_create_cube(nicol_context context, nicol_mesh* mesh);
/* Creates the disk of radius 1 in the plane z = 0, facing +z: 180 sectors of 16 rings, with the texture
 * coordinates of Mitsuba 3's disk. */
NICOL_API nicol_result nicol_mesh_create_disk(nicol_context context, nicol_mesh* mesh);
/* Creates the cylinder of this radius around the line from p0 to p1, in the scene's units, without its ends:
 * 180 sides, with the texture coordinates of Mitsuba 3's cylinder. The front is outside. radius must be above
 * 0, and p0 and p1 must differ. */
NICOL_API nicol_result nicol_mesh_create_cylinder(nicol_context context, const double p0[3],
                                                  const double p1[3], double radius, nicol_mesh* mesh);
/* Other places of a mesh's vertices, such as those of the next frame of an animated character. */
typedef struct nicol_deformation {
    uint32_t struct_size;
    uint32_t vertex_count;  /* number of vertices of the mesh, see nicol_mesh_get_size */
    const float* positions; /* positions, 3 finite numbers per vertex */
    /* Normals, 3 finite numbers per vertex, of any length; a normal of length 0 stands for the smooth normal.
     * NULL, the default: smooth normals. */
    const float* normals;
} nicol_deformation;
#define NICOL_DEFORMATION_INIT \
    { sizeof(nicol_deformation), 0, 0, 0 }
NICOL_API nicol_result nicol_deformation_init(nicol_deformation* descriptor, uint32_t struct_size);

/* Creates a mesh with the triangles, texture coordinates and colours of `base`, without its tangents, and
 * with other positions and normals, for nicol_scene_set_mesh. Triangles may lose their area, and stay. `base`
 * may be released afterwards. */
NICOL_API nicol_result nicol_mesh_create_deformed(nicol_context context, nicol_mesh base,
                                                  const nicol_deformation* deformation, nicol_mesh* mesh);
/* Gets the numbers of vertices and triangles of a mesh. */
NICOL_API nicol_result nicol_mesh_get_size(nicol_mesh mesh, uint32_t* vertices, uint32_t* triangles);
/* Gets the box of the mesh in its own axes: the least and the largest coordinates. */
NICOL_API nicol_result nicol_mesh_get_bounds(nicol_mesh mesh, double lower[3], double upper[3]);
NICOL_API nicol_result nicol_mesh_retain(nicol_mesh mesh);
NICOL_API nicol_result nicol_mesh_release(nicol_mesh mesh);

/* ---------------------------------------------------------------- camera */

typedef uint32_t nicol_projection;
#define NICOL_PROJECTION_PERSPECTIVE 0u
#define NICOL_PROJECTION_ORTHOGRAPHIC 1u

typedef struct nicol_camera {
    uint32_t struct_size;
    nicol_projection projection; /* projection, default perspective */
    /* Transform from camera space to the world, with axes at right angles and right-handed; default the
     * identity. Camera space is Mitsuba's: +z forward, +y up, +x to the image's LEFT. A scale in x and y is
     * the half extent of an orthographic image. */
    double to_world[16];
    double fov;       /* horizontal field of view if perspective, degrees, above 0, below 180, default 45 */
    double near_clip; /* near distance along +z, in the scene's units, above 0, default 0.01 */
    /* Far distance along +z, in the scene's units, above near_clip, default 10000. INFINITY: a perspective
     * camera has no far plane. */
    double far_clip;
    /* Sample point inside each pixel, relative to its centre, in pixels to the right and down, -0.5 to 0.5
     * each, default 0. The mean of images with different jitter is anti-aliased. */
    double jitter[2];
    /* Offset of the image's middle from the view direction (the principal point), right and down, in widths
     * and heights of the image, -1e5 to 1e5 each, default 0. A crop of a larger image has its own fov and
     * shift. */
    double shift[2];
    double pixel_aspect; /* width of a pixel over its height on the image plane, 0.01 to 100, default 1 */
} nicol_camera;
/* clang-format off */
#define NICOL_CAMERA_INIT \
    { sizeof(nicol_camera), 0, NICOL_IDENTITY_4X4, 45, 0.01, 10000, { 0, 0 }, { 0, 0 }, 1 }
/* clang-format on */
NICOL_API nicol_result nicol_camera_init(nicol_camera* descriptor, uint32_t struct_size);

/* Sets to_world, and no other field, to that of a camera at `origin` that looks at `target`. `up` must not
 * lie along the view. */
NICOL_API nicol_result nicol_camera_look_at(nicol_camera* camera, const double origin[3],
                                            const double target[3], const double up[3]);

/* Sets to_world, fov, shift, pixel_aspect and projection, and no other field, to those of a pinhole camera in
 * OpenCV's convention: a point X of the world is at x = R X + t, with x[0] to the right, x[1] down and x[2]
 * forward, and there at the pixel (fx x[0] / x[2] + cx, fy x[1] / x[2] + cy), where (0, 0) is the MIDDLE of
 * the first pixel and K = [fx 0 cx; 0 fy cy; 0 0 1]. Matrices are row-major. Undistort images first: there is
 * no lens distortion. (COLMAP has the same R and t, and 0.5 more in cx and cy.) */
NICOL_API nicol_result nicol_camera_set_opencv(nicol_camera* camera, const double K[9], const double R[9],
                                               const double t[3], uint32_t width, uint32_t height);
/* Gets the pinhole camera of a perspective camera, for an image of this size; jitter is left out. */
NICOL_API nicol_result nicol_camera_get_opencv(const nicol_camera* camera, uint32_t width, uint32_t height,
                                               double K[9], double R[9], double t[3]);

/* Moves the camera, without turning it, so that the box from `lower` to `upper` is in the image of this size
 * and as large as it can be. near_clip and far_clip enclose the box; an orthographic camera gets another half
 * extent. nicol_scene_get_bounds has the box of a scene. */
NICOL_API nicol_result nicol_camera_frame(nicol_camera* camera, const double lower[3], const double upper[3],
                                          uint32_t width, uint32_t height);

/* ---------------------------------------------------------------- light */

/* clang-format off */
/* Polarization of the emission of a light, equal in all directions. The frame, as seen by a viewer who looks into the
 * light:
 *
 *  y|  / E-vector
 *   | /    z  points towards the viewer, along the light
 *   |/     x  is the part of axis perpendicular to z (for an axis along z: growing angle from the light's own +z)
 *   +---x  y  = z cross x; the AoLP counts from x to y, counter-clockwise
 *
 * A sheet polarizer before the light that absorbs along `axis` is dolp 1 and aolp pi / 2, seen from anywhere. A
 * quarter-wave plate behind this polarizer gives docp 1 or -1. */
/* clang-format on */
typedef struct nicol_polarization {
    double dolp; /* degree of linear polarization, 0 to 1, default 0 */
    double aolp; /* angle of linear polarization, radians as NICOL_PLANE_AOLP, finite, default 0 */
    /* Ratio s3 / s0, -1 (left circular) to 1 (right), default 0; dolp^2 + docp^2 may be up to 1. */
    double docp;
    double axis[3]; /* direction of AoLP 0, in the light's own axes, of any length but 0; default (1, 0, 0) */
} nicol_polarization;
/* clang-format off */
#define NICOL_POLARIZATION_INIT { 0, 0, 0, { 1, 0, 0 } }
/* clang-format on */
NICOL_API nicol_result nicol_polarization_init(nicol_polarization* descriptor, uint32_t struct_size);

typedef uint32_t nicol_light_kind;
#define NICOL_LIGHT_DIRECTIONAL 0u /* parallel light from infinitely far, or from a disc of the sky */
#define NICOL_LIGHT_POINT 1u       /* light in all directions */
#define NICOL_LIGHT_SPOT 2u        /* light within a cone */
#define NICOL_LIGHT_PROJECTOR 3u   /* texture, or one colour, projected onto a rectangle */

/* Local light without a surface, beside the environment. In its own axes the light emits along +z, from the
 * origin unless it is directional. +y is up, and +x is to the left of a viewer who looks along +z, as for
 * cameras. Fields of other kinds have no effect. */
typedef struct nicol_light {
    uint32_t struct_size;
    nicol_light_kind kind; /* kind of light, default point */
    /* Brightness, finite and not negative, default 1. Directional: irradiance on a surface that faces the
     * light, which is the irradiance from the whole disc for a light with a size. Point and spot: radiant
     * intensity, power per solid angle; for a spot, the intensity on the axis. Projector: irradiance on the
     * plane at distance 1. */
    nicol_spectrum value;
    uint32_t reserved;     /* 0 */
    double to_world[16];   /* rotation and translation of the light, default the identity */
    double angular_radius; /* directional: disc's radius, degrees, 0 to 90, default 0; the sun's is 0.27 */
    double cutoff_angle;   /* spot: angle from the axis to the edge, degrees, 0.01 to 90, default 20 */
    /* Spot: angle from the axis at which the intensity begins to fall, degrees, 0 to cutoff_angle, default
     * 15. The intensity reaches 0 at cutoff_angle, linearly in the angle. */
    double beam_width;
    double fov;    /* projector: angle of the rectangle's width, degrees, 0.01 to 179.98, default 45 */
    double aspect; /* projector: width over height of the rectangle, above 0, default 1 */
    /* Spot: factor on the intensity, over the square around the cone. Projector: factor on value, over the
     * rectangle. The texture has 1 or 3 channels, is not negative, and has no colours of a mesh; the image's
     * top is up. NULL, the default: 1. */
    nicol_texture texture;
    nicol_polarization polarization; /* polarization of the emission, default unpolarized */
} nicol_light;
/* clang-format off */
#define NICOL_LIGHT_INIT \
    { sizeof(nicol_light), NICOL_LIGHT_POINT, NICOL_SPECTRUM_INIT, 0, NICOL_IDENTITY_4X4, 0, 20, 15, 45, 1, 0, \
      NICOL_POLARIZATION_INIT }
/* clang-format on */
NICOL_API nicol_result nicol_light_init(nicol_light* descriptor, uint32_t struct_size);

/* Fills a light with the sun of a sky: a directional light that comes from sun_direction, with an
 * angular_radius of 0.27 degrees. Its value is an irradiance in the units of the sky's radiance. The sun is a
 * black body of 5778 K and 128 klx above the atmosphere, attenuated by the air, haze and ozone of the sky's
 * turbidity (Preetham et al. 1999). A sky of turbidity 0 gets the sun of turbidity 1.7. A sun below the
 * horizon has a value of 0. */
NICOL_API nicol_result nicol_sky_get_sun(const nicol_sky* sky, nicol_light* light);

/* Emission of an instance, in addition to its reflection. */
typedef struct nicol_emission {
    uint32_t struct_size;
    uint32_t two_sided;      /* whether both sides emit: 1, or 0, the default: the front alone */
    nicol_spectrum radiance; /* radiance, finite and not negative, default 1 */
    uint32_t reserved;       /* 0 */
    /* Factor on radiance: 1 or 3 channels, not negative; NULL, the default: 1. If both the texture and the
     * material use colours of the mesh, both use those of its vertices, or both those of its triangles. */
    nicol_texture texture;
    nicol_polarization polarization; /* polarization of the emission, whose axis is in the mesh's axes */
} nicol_emission;
/* clang-format off */
#define NICOL_EMISSION_INIT \
    { sizeof(nicol_emission), 0, NICOL_SPECTRUM_INIT, 0, 0, NICOL_POLARIZATION_INIT }
/* clang-format on */
NICOL_API nicol_result nicol_emission_init(nicol_emission* descriptor, uint32_t struct_size);

/* ---------------------------------------------------------------- polarization elements */

typedef uint32_t nicol_polarization_element_kind;
/* clang-format off */
#define NICOL_POLARIZATION_ELEMENT_POLARIZER 0u      /* linear polarizer: transmits light that is polarized along its axis */
#define NICOL_POLARIZATION_ELEMENT_RETARDER 1u       /* wave plate: delays light that is polarized across its fast axis */
#define NICOL_POLARIZATION_ELEMENT_RIGHT_CIRCULAR 2u /* circular polarizer: transmits right circular light; has no axis */
#define NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR 3u  /* circular polarizer: transmits left circular light; has no axis */
/* clang-format on */

typedef uint32_t nicol_polarization_element_outline;
#define NICOL_POLARIZATION_ELEMENT_RECTANGLE 0u /* |x| <= 1, |y| <= 1 */
#define NICOL_POLARIZATION_ELEMENT_DISK 1u      /* radius 1 */

/* clang-format off */
/* Ideal, infinitely thin polarization element. The camera sees what is behind the element through its Mueller matrix.
 * Several elements along a ray act in their order. An element casts no shadow, and light passes it unchanged on its way
 * to surfaces. In its own axes an element lies in the plane z = 0 about the origin; light passes in both directions with
 * equal effect.
 *
 *   y
 *   |  / axis   x  is where to_world takes the element's x, z its normal, and y = z cross x
 *   | /) angle
 *   +------x
 *
 * Light at an angle to the normal is treated as in Mitsuba 3. A polarizer absorbs along the part of its absorbing axis
 * that is perpendicular to the ray. The retardance is multiplied by the cosine of the angle. The effective fast axis of
 * a retarder is the part of its fast axis that is perpendicular to the ray, whereas Mitsuba 3.9 rotates the fast axis
 * with the tilt. */
/* clang-format on */
typedef struct nicol_polarization_element {
    uint32_t struct_size;
    nicol_polarization_element_kind kind;       /* kind of element, default polarizer */
    nicol_polarization_element_outline outline; /* outline, default rectangle */
    uint32_t reserved;                          /* 0 */
    /* Transform from the element's axes to the world: affine, invertible, last row 0 0 0 1; default the
     * identity. */
    double to_world[16];
    /* Angle of a polarizer's transmission axis or of a retarder's fast axis, degrees from x to y, -1e6 to
     * 1e6, default 0. The angle has no effect on circular polarizers, which have no axis. */
    double angle;
    /* Retardance of a retarder at normal incidence, degrees, -1e6 to 1e6, default 90, a quarter-wave plate.
     */
    double retardance;
    double transmittance; /* factor on the transmittance of the ideal element, 0 to 1, default 1 */
    /* Textures over the square |x| <= 1, |y| <= 1 of the element's axes, with u along x and v
     * along y, as on nicol_mesh_create_rectangle. They are looked up at points, so fringes finer than a pixel
     * need pixel_samples, and have no colours of a mesh. Each value times the number lies in the number's
     * range. An element with textures acts on what the camera sees, not on lights of a file. */
    nicol_texture angle_texture; /* factor on angle, in the first channel; NULL, the default: 1 */
    /* Factor on the retardance of a retarder: one channel, or red, green and blue, as of a plate whose
     * retardance is a length; NULL, the default: 1. */
    nicol_texture retardance_texture;
} nicol_polarization_element;
/* clang-format off */
#define NICOL_POLARIZATION_ELEMENT_INIT \
    { sizeof(nicol_polarization_element), NICOL_POLARIZATION_ELEMENT_POLARIZER, \
      NICOL_POLARIZATION_ELEMENT_RECTANGLE, 0, NICOL_IDENTITY_4X4, 0, 90, 1, 0, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_polarization_element_init(nicol_polarization_element* descriptor,
                                                       uint32_t struct_size);

/* ---------------------------------------------------------------- scene */

/* Flags of an instance. */
#define NICOL_INSTANCE_CASTS_NO_SHADOWS 1u    /* other surfaces are lit as if it were absent */
#define NICOL_INSTANCE_RECEIVES_NO_SHADOWS 2u /* nothing blocks its light, not even itself */
#define NICOL_INSTANCE_INVISIBLE 4u /* images do not show it, neither in mirrors nor through glass */

typedef struct nicol_instance {
    uint32_t struct_size;
    /* Sum of NICOL_INSTANCE_...; 0, the default: the instance casts and receives shadows and is visible. Its
     * emission lights the scene with any flags. Invisible smooth glass dims no light. */
    uint32_t flags;
    nicol_mesh mesh;
    nicol_material material;
    /* Transform from the mesh's axes to the world: affine, invertible, last row 0 0 0 1; default the
     * identity. */
    double to_world[16];
} nicol_instance;
/* clang-format off */
#define NICOL_INSTANCE_INIT \
    { sizeof(nicol_instance), 0, 0, 0, NICOL_IDENTITY_4X4 }
/* clang-format on */
NICOL_API nicol_result nicol_instance_init(nicol_instance* descriptor, uint32_t struct_size);

/* Creates an empty, dark scene. */
NICOL_API nicol_result nicol_scene_create(nicol_context context, nicol_scene* scene);
/* Loads a scene from a Mitsuba 3 XML file, or from glTF 2.0 if the name ends in .gltf or .glb (the subsets
 * that samples/render/README.md lists). definitions are "name=value" strings that override <default>s of the
 * XML. Those of glTF are time=SECONDS, at which the file's animation is drawn, and animation=NAME, its name
 * or number, the first by default. A glTF file has no environment, and may have lights. Lights that
 * polarization elements of the file cover get the polarization state and the brightness that their light has
 * behind the elements. */
NICOL_API nicol_result nicol_scene_load(nicol_context context, const char* path,
                                        const char* const* definitions, uint32_t definition_count,
                                        nicol_scene* scene);
/* Moves a scene that was loaded from a glTF file with animations to a time, in seconds. Instances, deformed
 * meshes, lights and camera (nicol_scene_get_camera) become those that nicol_scene_load gives for the
 * definition time. The animation is that of the scene's definition animation, or the first one. Meshes,
 * transforms and places of lights that were set after loading are replaced; removed instances and lights stay
 * removed. An instance that the animation scales to 0 is removed, and returns under another id. The next
 * render bakes what has moved. Returns NICOL_ERROR_INVALID_ARGUMENT for a time that is not finite, and
 * NICOL_ERROR_UNSUPPORTED for a scene without animations. */
NICOL_API nicol_result nicol_scene_set_time(nicol_scene scene, double time);
/* Loads a scene from memory: XML, glTF as JSON, or GLB. The resolver returns the scene's other files. */
NICOL_API nicol_result nicol_scene_load_memory(nicol_context context, const nicol_memory_file* file,
                                               const char* const* definitions, uint32_t definition_count,
                                               nicol_scene* scene);
/* Adds an instance. id may be NULL; ids count up from 0, past those of removed instances too. The mesh must
 * have the texture coordinates and colours that the material needs. Materials and environment of a scene must
 * have one colour channel or the same number of channels. */
NICOL_API nicol_result nicol_scene_add_instance(nicol_scene scene, const nicol_instance* instance,
                                                uint32_t* id);
/* Sets the transform of an instance; to_world is that of nicol_instance. The next render bakes again the
 * vertices that the instance may shadow, before or now. A scene that rotates and moves as a whole is only
 * relit. */
NICOL_API nicol_result nicol_scene_set_transform(nicol_scene scene, uint32_t id, const double to_world[16]);
/* Sets the mesh of an instance, under the conditions of nicol_scene_add_instance. The next render bakes again
 * the instance and the vertices that it may shadow, before or now. An instance whose meshes have the same
 * triangles, such as those of nicol_mesh_create_deformed, keeps its former shadows until they are baked, see
 * bake_budget_ms of nicol_render_options. */
NICOL_API nicol_result nicol_scene_set_mesh(nicol_scene scene, uint32_t id, nicol_mesh mesh);
/* Sets the material of an instance, under the conditions of nicol_scene_add_instance. The next render
 * projects the material, if it is new to the scene, and shades the instance. */
NICOL_API nicol_result nicol_scene_set_material(nicol_scene scene, uint32_t id, nicol_material material);
/* Sets the flags of an instance, as in nicol_instance. The next render repeats the bake of the instance
 * and of the vertices that it may shadow. Returns NICOL_ERROR_INVALID_ARGUMENT for unknown flags. */
NICOL_API nicol_result nicol_scene_set_instance_flags(nicol_scene scene, uint32_t id, uint32_t flags);
/* Gets the flags of an instance. */
NICOL_API nicol_result nicol_scene_get_instance_flags(nicol_scene scene, uint32_t id, uint32_t* flags);
/* Removes an instance. The id is not used again; other instances keep their ids. */
NICOL_API nicol_result nicol_scene_remove_instance(nicol_scene scene, uint32_t id);
/* Gets the parts of an instance: mesh and material as handles to release, and the transform. Each of the
 * three may be NULL. */
NICOL_API nicol_result nicol_scene_get_instance(nicol_scene scene, uint32_t id, nicol_mesh* mesh,
                                                nicol_material* material, double to_world[16]);
/* Gets the box of all instances in the world, without local lights, which have no surface. Returns
 * NICOL_ERROR_INVALID_ARGUMENT for a scene without instances. */
NICOL_API nicol_result nicol_scene_get_bounds(nicol_scene scene, double lower[3], double upper[3]);

/* Gets the number of instances. */
NICOL_API nicol_result nicol_scene_get_instance_count(nicol_scene scene, uint32_t* instances);
/* Gets the ids of all instances, ascending. count must be the number of instances. */
NICOL_API nicol_result nicol_scene_get_instance_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
/* Sets the environment; NULL: darkness. to_world is a proper rotation of the environment; NULL: identity.
 * scale is a factor on the radiance, finite and not negative; 1: no change; 0: darkness. */
NICOL_API nicol_result nicol_scene_set_environment(nicol_scene scene, nicol_environment environment,
                                                   const double to_world[16], double scale);
/* Gets the arguments of nicol_scene_set_environment: the environment, as a handle to release, its rotation
 * and scale. to_world and scale may be NULL. In darkness, including a file's scale of 0, *environment is
 * NULL, to_world the identity and scale 1. */
NICOL_API nicol_result nicol_scene_get_environment(nicol_scene scene, nicol_environment* environment,
                                                   double to_world[16], double* scale);
/* Sets whether emitters are hidden from the camera. hide 1: no light goes straight to the camera from the
 * environment, which leaves black (alpha 0), or from instances that emit, which show only their reflection;
 * both light the scene as before. hide 0: the camera sees emitters, unless the scene's file has
 * hide_emitters. */
NICOL_API nicol_result nicol_scene_hide_emitters(nicol_scene scene, uint32_t hide);
/* Adds a light. id may be NULL; ids of lights count up from 0, independently of instances. Lights, and the
 * emission of instances, must have one colour channel or as many as the scene. The handle of the texture may
 * be released afterwards. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
 * range. */
NICOL_API nicol_result nicol_scene_add_light(nicol_scene scene, const nicol_light* light, uint32_t* id);
/* Replaces all fields of a light. The next render bakes nothing. The message of NICOL_ERROR_INVALID_ARGUMENT
 * names the field that is out of range. */
NICOL_API nicol_result nicol_scene_set_light(nicol_scene scene, uint32_t id, const nicol_light* light);
/* Removes a light. The id is not used again; other lights keep their ids. */
NICOL_API nicol_result nicol_scene_remove_light(nicol_scene scene, uint32_t id);
/* Gets a light as it was given. *texture, and not light->texture, is the light's texture as a handle to
 * release, or NULL if the light has none. texture may be NULL. */
NICOL_API nicol_result nicol_scene_get_light(nicol_scene scene, uint32_t id, nicol_light* light,
                                             nicol_texture* texture);
/* Gets the number of lights. */
NICOL_API nicol_result nicol_scene_get_light_count(nicol_scene scene, uint32_t* lights);
/* Gets the ids of all lights, ascending. count must be the number of lights. */
NICOL_API nicol_result nicol_scene_get_light_ids(nicol_scene scene, uint32_t* ids, uint64_t count);
/* Sets the emission of the instance `id`; NULL: the instance emits no light. A texture needs texture
 * coordinates of the mesh. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
 * range. */
NICOL_API nicol_result nicol_scene_set_emission(nicol_scene scene, uint32_t id,
                                                const nicol_emission* emission);
/* Gets the emission of an instance, with its texture as nicol_scene_get_light does. The radiance is 0 for an
 * instance that emits no light. */
NICOL_API nicol_result nicol_scene_get_emission(nicol_scene scene, uint32_t id, nicol_emission* emission,
                                                nicol_texture* texture);
/* Adds a polarization element. id may be NULL; ids of elements count up from 0, independently of instances
 * and lights. The handles of the textures may be released afterwards. The message of
 * NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range. */
NICOL_API nicol_result nicol_scene_add_polarization_element(nicol_scene scene,
                                                            const nicol_polarization_element* element,
                                                            uint32_t* id);
/* Replaces all fields of a polarization element. The message of NICOL_ERROR_INVALID_ARGUMENT names the field
 * that is out of range. */
NICOL_API nicol_result nicol_scene_set_polarization_element(nicol_scene scene, uint32_t id,
                                                            const nicol_polarization_element* element);
/* Removes a polarization element. The id is not used again; other elements keep their ids. */
NICOL_API nicol_result nicol_scene_remove_polarization_element(nicol_scene scene, uint32_t id);
/* Gets a polarization element as it was given, but for its textures, which are NULL. */
NICOL_API nicol_result nicol_scene_get_polarization_element(nicol_scene scene, uint32_t id,
                                                            nicol_polarization_element* element);
/* Gets the textures of a polarization element as handles to release; NULL for none. angle or retardance may
 * be NULL. */
NICOL_API nicol_result nicol_scene_get_polarization_element_textures(nicol_scene scene, uint32_t id,
                                                                     nicol_texture* angle,
                                                                     nicol_texture* retardance);
/* Gets the number of polarization elements. */
NICOL_API nicol_result nicol_scene_get_polarization_element_count(nicol_scene scene, uint32_t* elements);
/* Gets the ids of all polarization elements, ascending. count must be the number of elements. */
NICOL_API nicol_result nicol_scene_get_polarization_element_ids(nicol_scene scene, uint32_t* ids,
                                                                uint64_t count);
/* Gets the camera of a loaded file. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded. */
NICOL_API nicol_result nicol_scene_get_camera(nicol_scene scene, nicol_camera* camera);
/* Gets the film size of a loaded file, in pixels. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not
 * loaded. */
NICOL_API nicol_result nicol_scene_get_film_size(nicol_scene scene, uint32_t* width, uint32_t* height);
/* Gets the samples of a pixel that the sampler of a loaded file asks for, 0 if there is no sampler; for the
 * pixel_samples of nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded. */
NICOL_API nicol_result nicol_scene_get_sample_count(nicol_scene scene, uint32_t* samples);
/* Gets the largest max_depth that the integrators of a loaded file ask for, for nicol_render_options: 1 or
 * more, or NICOL_DEPTH_UNLIMITED, which is Mitsuba's default; 0 if there is no integrator. Returns
 * NICOL_ERROR_UNSUPPORTED for a scene that was not loaded. */
NICOL_API nicol_result nicol_scene_get_max_depth(nicol_scene scene, int32_t* max_depth);
/* Gets the AOVs that the integrators of a loaded file ask for, a sum of NICOL_AOV_... for
 * nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded. */
NICOL_API nicol_result nicol_scene_get_aovs(nicol_scene scene, uint32_t* aovs);

typedef struct nicol_scene_file {
    uint32_t struct_size;
    uint32_t reserved;
    const char* path; /* path with which the file was opened; lives as long as the scene */
    /* Digest of the bytes that were read: 32 hexadecimal digits, not a cryptographic hash; lives as long as
     * the scene. */
    const char* digest;
    uint64_t bytes;
} nicol_scene_file;
#define NICOL_SCENE_FILE_INIT \
    { sizeof(nicol_scene_file), 0, 0, 0, 0 }
NICOL_API nicol_result nicol_scene_file_init(nicol_scene_file* descriptor, uint32_t struct_size);

/* Gets the number of files that nicol_scene_load has read, or 0 for a scene that was not loaded. Each file
 * counts once: the scene file, the files that it includes (the buffers of glTF), then light, materials and
 * meshes. Scenes whose files have equal digests are equal. */
NICOL_API nicol_result nicol_scene_get_file_count(nicol_scene scene, uint32_t* count);
/* Gets a file that nicol_scene_load has read; index counts from 0. Returns NICOL_ERROR_INVALID_ARGUMENT for
 * an index beyond the last file. */
NICOL_API nicol_result nicol_scene_get_file(nicol_scene scene, uint32_t index, nicol_scene_file* file);
/* Gets the number of colour channels of the scene's images: the number of everything in the scene, 1 (all
 * grey) or more, and 1 if the film of a loaded file is luminance. */
NICOL_API nicol_result nicol_scene_get_channels(nicol_scene scene, uint32_t* channels);
NICOL_API nicol_result nicol_scene_retain(nicol_scene scene);
NICOL_API nicol_result nicol_scene_release(nicol_scene scene);

/* ---------------------------------------------------------------- render */

typedef uint32_t nicol_method;
/* Real-time method that stores light up to order_low in each vertex's frame and multiplies the light by a
 * table of the material's response at each view angle. Pixels that show smooth glass or a mirror are followed
 * by rays, through as many reflections and refractions as max_depth says, to other surfaces and the
 * environment. With a max_depth above 2, pixels that show metal of a roughness below 0.25 are followed by
 * rays to other surfaces as well, which facets chosen by chance reflect: one ray a sample, at least four a
 * pixel. */
#define NICOL_METHOD_FACTORED 0u
/* Real-time method of the paper, with a transfer matrix per vertex, baked from shadow and material. Outgoing
 * light is truncated at order_low too. The method is slower and larger, for comparison. */
#define NICOL_METHOD_DENSE 1u
/* Monte Carlo integration of the light at each pixel, with shadows, without harmonics. The method is slow,
 * noisy and unbiased: the reference for the other methods. With max_depth it follows light that surfaces
 * reflect to each other and, through smooth glass, transmit, with full Mueller matrices along each path. */
#define NICOL_METHOD_REFERENCE 2u

/* Reflection of the light's orders above order_low: the light is prefiltered by lobes, looked up at the
 * mirrored view direction, and multiplied by the visible fraction of the lobe. */
typedef uint32_t nicol_high_orders;
#define NICOL_HIGH_ORDERS_SPLIT 0u       /* lobes times Mueller matrices of the view angle */
#define NICOL_HIGH_ORDERS_CONVOLUTION 1u /* one kernel per material (Eq. 68), which does not polarize */
#define NICOL_HIGH_ORDERS_NONE 2u        /* no high orders */

/* Place where light becomes the Stokes vector of an image. */
typedef uint32_t nicol_shade_at;
/* Pixels if the interpolation of Stokes vectors between vertices is predicted to err by more than the
 * tolerance, because normals or view directions change much across triangles for the lobes of the materials.
 * Also pixels for local lights, for a material that varies by a texture, and by threads for several samples
 * per pixel, which cost less there, and where unpolarized light bounces. Otherwise vertices. */
#define NICOL_SHADE_AT_AUTOMATIC 0u
/* Vertices: Stokes vectors are interpolated across triangles, which is fast, and right where triangles cover
 * few pixels. Materials that vary by textures give NICOL_ERROR_UNSUPPORTED. */
#define NICOL_SHADE_AT_VERTICES 1u
/* Pixels, for coarse meshes: the light that arrives is interpolated, in the world's axes; normal, view angle,
 * response and high orders are those of the pixel. */
#define NICOL_SHADE_AT_PIXELS 2u

/* Device that runs relight and shade. The images of both devices agree to 1e-5 of their largest value; shaded
 * at pixels, to 1e-4 where a surface is seen edge-on. In a first image of several samples a pixel, single
 * pixels beside a shadow may differ by a few hundredths: threads refine shadows only where samples show them.
 * Threads alone follow rays: they shade scenes with glass whatever the option says, and only they show other
 * surfaces in mirrors and, with bounces, in narrow metal.
 */
typedef uint32_t nicol_executor;
/* Compute, unless OpenGL runs on the CPU or lacks features, or mirrors or narrow metal show other surfaces.
 */
#define NICOL_EXECUTOR_AUTOMATIC 0u
#define NICOL_EXECUTOR_CPU 1u     /* threads */
#define NICOL_EXECUTOR_COMPUTE 2u /* compute shaders, also if OpenGL runs on the CPU, where they are slow */

/* Work that a render skips because the image is the same without it. All optimisations are enabled by
 * default. */
#define NICOL_OPTIMISATION_UNCHANGED 1u        /* everything, if nothing changed */
#define NICOL_OPTIMISATION_LIGHT_COMPONENTS 2u /* Stokes components that the light lacks */
#define NICOL_OPTIMISATION_CHANNELS 4u         /* colour channels of light, if all are multiples of one */
#define NICOL_OPTIMISATION_ORDERS 8u           /* orders that the light lacks */
#define NICOL_OPTIMISATION_RESPONSE_ROWS 16u   /* Stokes components that a material never reflects */
#define NICOL_OPTIMISATION_HIDDEN 32u          /* vertices that face away or lie outside the view */
#define NICOL_OPTIMISATION_UNOCCLUDED 64u      /* shadows of vertices with nothing above their horizon */
/* Rays of the bake: those that nothing can block, because no surface lies in their direction; those that
 * large flat faces certainly block; those of fine meshes in directions in which the vertices around see the
 * same (images differ by about 0.0005); those of vertices that no image has shown, that are black or unlit;
 * and, after a move, light of vertices that see almost the same. A first image refines shadows on triangles
 * that face it alone, down to two of its pixels. Further views add what they show newly; after some of them,
 * and after a change of the scene, all is refined. Such images differ from a first image of theirs by about
 * 0.01 of the RMS of s0; without this they are equal. */
#define NICOL_OPTIMISATION_RAYS 128u
/* Shadow rays to local lights that are so dim that all of them together add less than a hundredth of the
 * tolerance to a point's light; such lights are added without shadows. Images differ by less than that. */
#define NICOL_OPTIMISATION_DIM_LIGHTS 256u
#define NICOL_OPTIMISATION_ALL 511u

/* AOVs that a render makes beside the image, with any method; see NICOL_PLANE_DEPTH, _NORMAL, _POSITION,
 * _INSTANCE and _ALPHA. AOVs of surfaces describe the first surface on the ray through a pixel's centre. With
 * pixel_samples, AOVs describe the nearest surface that the samples show, and the normal is the mean of the
 * samples' normals. NICOL_AOV_ALL is the sum of the five. */
#define NICOL_AOV_DEPTH 1u
#define NICOL_AOV_NORMAL 2u
#define NICOL_AOV_POSITION 4u
#define NICOL_AOV_INSTANCE 8u
#define NICOL_AOV_ALPHA 32u
#define NICOL_AOV_ALL 47u
/* Noise of the image, see NICOL_PLANE_VARIANCE. Only the reference method with 2 samples or more makes the
 * variance; other methods refuse it. */
#define NICOL_AOV_VARIANCE 16u

/* Stokes components of an image; the others are 0. */
typedef uint32_t nicol_components;
#define NICOL_COMPONENTS_ALL 0u
#define NICOL_COMPONENTS_S0 1u     /* s0 */
#define NICOL_COMPONENTS_LINEAR 3u /* s0, s1, s2 */

/* clang-format off */
/* Weight of a sample by its distance x along each axis from a pixel's centre, in pixels; the product of both axes' weights.
 * Shapes and defaults are those of Mitsuba 3. */
typedef uint32_t nicol_filter_kind;
#define NICOL_FILTER_BOX 0u        /* 1 within the pixel, 0 elsewhere */
#define NICOL_FILTER_GAUSSIAN 1u   /* Gaussian, 0 beyond four standard deviations */
#define NICOL_FILTER_TENT 2u       /* linear descent to 0 */
#define NICOL_FILTER_MITCHELL 3u   /* cubic of Mitchell and Netravali, radius 2, negative in places */
#define NICOL_FILTER_CATMULLROM 4u /* Mitchell with b = 0, c = 0.5 */
#define NICOL_FILTER_LANCZOS 5u    /* sinc times sinc, negative in places */
/* clang-format on */

/* Reconstruction filter of an image. A pixel is the weighted mean of the samples of all pixels within the
 * filter's radius; no samples lie beyond the border of the image. The filter applies to each Stokes component
 * and not to AOVs, except that the reference method's alpha and variance are those of the weighted samples.
 */
typedef struct nicol_filter {
    nicol_filter_kind kind; /* kind of filter, default box */
    uint32_t reserved;      /* 0 */
    /* Gaussian: standard deviation, 0.125 to 4 pixels. Tent: radius, 0.5 to 16 pixels. Lanczos: number of
     * lobes on each side, 1 to 16. 0, the default: 0.5, 1 and 3. No effect on other kinds. */
    double size;
    double b; /* Mitchell: blur, 0 to 1, default 1/3 */
    double c; /* Mitchell: ringing, 0 to 1, default 1/3 */
} nicol_filter;
/* clang-format off */
#define NICOL_FILTER_INIT { NICOL_FILTER_BOX, 0, 0, 0.3333333333333333, 0.3333333333333333 }
/* clang-format on */
NICOL_API nicol_result nicol_filter_init(nicol_filter* descriptor, uint32_t struct_size);
/* Gets the filter that the film of a loaded file asks for, for nicol_render_options: Gaussian, which is
 * Mitsuba's default, if a Mitsuba file names none; box for glTF. Returns NICOL_ERROR_UNSUPPORTED for a scene
 * that was not loaded. */
NICOL_API nicol_result nicol_scene_get_filter(nicol_scene scene, nicol_filter* filter);

#define NICOL_DIRECTIONS_AUTOMATIC 0u

/* No limit of the path's length; Russian roulette ends paths without a bias. */
#define NICOL_DEPTH_UNLIMITED (-1)

#define NICOL_SPLIT_AUTOMATIC (-1)
#define NICOL_MAX_SPLIT_LIGHTS 64

/* Options of a render. The reference method uses only samples, seed, max_depth, shadows, aovs, filter,
 * progress and NICOL_OPTIMISATION_UNCHANGED; the other options are those of the factored and the dense
 * method. */
typedef struct nicol_render_options {
    uint32_t struct_size;
    nicol_method method; /* method, default factored */
    /* Highest order of the light that is shaded with the material's full response, 0 to NICOL_MAX_ORDER;
     * default NICOL_ORDER_AUTOMATIC, see tolerance. */
    uint32_t order_low;
    /* Highest order of the light that is rendered, at most 64; default NICOL_ORDER_AUTOMATIC, see tolerance.
     * high_orders renders the orders above order_low; there are none if order_high is order_low or
     * below. */
    uint32_t order_high;
    nicol_high_orders high_orders; /* reflection of the orders above order_low, default split */
    /* Whether surfaces shadow each other and themselves: 1, the default, or 0. */
    uint32_t shadows;
    /* Number of directions of rays at each vertex, 256 to 65536. More directions take more time and memory to
     * bake and leave less noise in the shadows. NICOL_DIRECTIONS_AUTOMATIC, the default: 2048. If orders are
     * chosen, the automatic number is 1024 for a tolerance of 0.03 or more, which leaves noise of about a
     * tenth of 0.03, 2048 down to 0.015, 4096 down to 0.0075, else 8192. */
    uint32_t bake_directions;
    /* Whether Stokes vectors are made physically realizable (Eq. 70), 1, the default, or 0: s0 below 0
     * becomes 0, and polarization beyond s0 is shortened to s0, which stays. Truncated light may violate
     * both. The correction is made at vertices, or at pixels if pixels are shaded. If orders are chosen,
     * light that is as weak as the predicted error becomes less polarized, so that there is no false DoLP in
     * the dark. */
    uint32_t physical;
    /* Strength of the window against ringing, finite and not negative, default 0 (no window); 0.0001 to 0.01
     * are of use. The light's order l is multiplied by 1 / (1 + dering (l (l + 1))^2). */
    double dering;
    /* Progress callback; NULL, the default: none. The verbs are project, bake, relight, shade and draw; the
     * reference method has the verb trace. */
    nicol_progress_callback progress;
    void* progress_user;
    /* Number of camera rays per pixel of the reference method, 1 to 2^20, default 256. Powers of two are
     * spread best. */
    uint32_t samples;
    nicol_executor executor; /* device that runs relight and shade, default automatic */
    /* Seed of the reference method and of the samples of lights and lobes, default 0. Equal seeds give equal
     * images, whatever the number of threads. */
    uint64_t seed;
    /* Largest predicted error of the orders left out and of shadows between baked vertices if both orders are
     * automatic, finite and not negative, default 0.03: the RMSE of s0, s1 and s2 relative to the RMS of s0.
     * The fastest orders are chosen, order_low up to 16, that keep what shadows leave of the tolerance, or
     * half of it. If no orders do, the product of squared error and a frame's time decides among orders that
     * err at most 1.5 times as much as the best ones. The error of the DoLP, as the mean over pixels, is no
     * larger than the prediction. Orders are as high as fits if the data of vertices would exceed 1 GiB or
     * the context's memory_limit. Automatic orders are 4 and 9 without a prediction: for the dense method,
     * for convolution, for a tolerance of 0, and beside an order that is given. */
    double tolerance;
    nicol_components components; /* Stokes components of the image, default all */
    /* Sum of NICOL_OPTIMISATION_... to disable, in order to measure what the optimisations save; default 0:
     * none. Compute shaders shade all vertices and rows in any case. */
    uint32_t disabled_optimisations;
    /* Whether high orders are multiplied by the visible fraction of their lobe: 1, the default, or 0
     * (unshadowed highlights). */
    uint32_t high_order_shadows;
    uint32_t aovs;           /* sum of NICOL_AOV_... to make, default 0: none */
    nicol_shade_at shade_at; /* place of shading, default automatic */
    /* Number of samples per pixel of the real-time methods, 1 to 1024; 0, the default, is 1. A pixel is the
     * mean of surfaces and environment, weighted by the number of samples that show them. 4 and 8 samples are
     * drawn together: shading at pixels shades each surface once per pixel, at the mean of its samples, but
     * for narrow highlights of local lights on normal maps, which each sample has of its own. Other numbers
     * are drawn and shaded one by one, each sample at the cost of an image, which also averages normal maps
     * and soft shadows; AOVs are then those of 8 samples. */
    uint32_t pixel_samples;
    /* Largest interpolation error of shadows, as a fraction of the light, 0 to 1, default 0.02; 0: no
     * triangle is split. The bake splits triangles where shadows change faster than the mesh is fine, until
     * the error of uniform light is at most this fraction of what arrives, or of a quarter of it all. */
    double refine_tolerance;
    /* Largest number of vertices after splitting; 0, the default: 65536, or four times the original number if
     * that is more. A memory_limit lowers the number. */
    uint64_t max_vertices;
    /* Largest number of extracted lights of the factored method: bright parts of the environment, such as a
     * sun, that are taken out of the environment and rendered as local lights. 0 to NICOL_MAX_SPLIT_LIGHTS;
     * default NICOL_SPLIT_AUTOMATIC: the lights that the orders would miss. */
    int32_t split_lights;
    /* Number of light samples of the real-time methods, per local light with a size and per point or pixel, 1
     * to 1024, default 16; up to twice as many for very wide lights. Fewer are faster and noisier. */
    uint32_t light_samples;
    /* Largest number of samples of the environment, per lobe and per point or pixel, that the factored method
     * takes for lobes which harmonics cannot hold, 0 to 1024, default 32: anisotropic lobes, and lobes
     * narrower than 0.1 if the environment is an image or surfaces hide it from each other. If
     * pixel_samples is above 1 and both orders are automatic, the limit rises to at most 0.35 for lobes
     * that a tenth of the image shows at grazing angles. Longer lobes take more; those of GGX up to half
     * as many again. Samples are weighted by the pBRDF, see the environment averaged over the gaps between
     * them, and cast shadow rays. 0: none; all lobes are those of harmonics, and anisotropic ones round. */
    uint32_t bsdf_samples;
    /* Largest number of segments of a path from the camera to a light, counted as Mitsuba's max_depth: 1 is
     * light that the camera sees directly, 2 adds light that a surface reflects once (direct light), 3 adds
     * light that two surfaces reflect, and so on; NICOL_DEPTH_UNLIMITED: no limit. 0, the default: 2. The
     * factored method computes the light that surfaces reflect to each other at vertices, up to order 3 of
     * its incident field (5 without an environment), and stops at 0.002 of all light; rays from pixels find
     * what mirrors and narrow lobes of metal reflect. It refuses 1 and the dense method refuses everything
     * but 0 and 2, with NICOL_ERROR_UNSUPPORTED. More than 2 needs shadows. Smooth glass and mirrors count as
     * well: the rays of the factored method have max_depth - 1 reflections and refractions, at most 64, but
     * eight for 0 and 2, because direct light would not leave a body of glass. */
    int32_t max_depth;
    /* Behaviour of nicol_render and nicol_render_views while another render of the scene runs, such as a job.
     * 0, the default: they wait; 1: they return NICOL_ERROR_BUSY. No effect on nicol_render_async. */
    uint32_t fail_if_busy;
    uint32_t reserved; /* 0 */
    /* Time that a render of a real-time method spends on shadows, bake and relight of changed vertices, in
     * milliseconds: about that much, and at least one step. 0, the default: as long as the final picture
     * takes. Above 0, a render uses the shadows that are there, and the next renders, also of an unchanged
     * scene, go on: nearest to the change and visible first. vertices_pending of the statistics says how much
     * is left; at 0 the picture is that of a render without a budget. Until then it approximates: a vertex
     * keeps its former shadows, those of a moved or deformed object on itself move with it, a new object
     * casts and receives none, and orders stay as chosen before. The cache folder is not used for these
     * shadows. A scene that was rendered with a budget stays divided into steps; 0 then completes all of
     * them. */
    double bake_budget_ms;
    /* Reconstruction filter, default box: a pixel is the mean of its own samples. With any other filter, the
     * real-time methods draw and shade all numbers of pixel_samples one by one, and the reference method
     * places its samples by the filter. */
    nicol_filter filter;
    /* Time that a frame of a real-time method may take on this machine, in milliseconds, without project and
     * bake, which do not repeat; finite and not negative. 0, the default: as long as it takes, and the
     * picture does not depend on time. Above 0, the options are the best picture that is wanted, and the
     * scene's renders measure how much of it they can keep. They give up pixel_samples, light_samples and
     * bsdf_samples (down to a quarter) and, if automatic, shading at pixels and orders (down to those of
     * eight times the tolerance): what loses least and saves enough. Two frames in succession that exceed the
     * budget by a tenth lower the effort; eight in succession below 0.7 of it may raise it. The statistics
     * say what was given up (given_up). A scene that does not change keeps its picture. */
    double time_budget_ms;
} nicol_render_options;
/* clang-format off */
#define NICOL_RENDER_OPTIONS_INIT \
    { sizeof(nicol_render_options), 0, NICOL_ORDER_AUTOMATIC, NICOL_ORDER_AUTOMATIC, 0, 1, NICOL_DIRECTIONS_AUTOMATIC, 1, 0, 0, 0, 256, 0, 0, \
      0.03, 0, 0, 1, 0, 0, 0, 0.02, 0, NICOL_SPLIT_AUTOMATIC, 16, 32, 0, 0, 0, 0, NICOL_FILTER_INIT, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_render_options_init(nicol_render_options* descriptor, uint32_t struct_size);

/* Purpose of an image. */
typedef uint32_t nicol_quality;
/* Frames of a scene that moves: one sample per pixel, tolerance 0.03. These are the defaults. */
#define NICOL_QUALITY_REALTIME 0u
/* An image to look at while a scene is made: 8 samples per pixel, tolerance 0.03. */
#define NICOL_QUALITY_PREVIEW 1u
/* An image to keep or to measure in: 64 samples per pixel, tolerance 0.01, refine_tolerance 0.01. */
#define NICOL_QUALITY_FINAL 2u
/* Sets the options of the real-time methods that trade time for accuracy: tolerance, pixel_samples,
 * bake_directions, refine_tolerance, light_samples and bsdf_samples. All other options stay. Options that are
 * set afterwards win. Returns NICOL_ERROR_INVALID_ARGUMENT for another quality. */
NICOL_API nicol_result nicol_render_options_set_quality(nicol_render_options* options, nicol_quality quality);

/* Creates a framebuffer. width and height are 1 to NICOL_MAX_SIZE pixels (the driver may allow less), and at
 * most 2^26 pixels in all. channels is the scene's number, or 1 for the luminance of a scene of three
 * channels: 0.2126 R + 0.7152 G + 0.0722 B of each Stokes component. */
NICOL_API nicol_result nicol_framebuffer_create(nicol_context context, uint32_t width, uint32_t height,
                                                uint32_t channels, nicol_framebuffer* framebuffer);
/* Changes the size, within the limits of nicol_framebuffer_create, and keeps the handle and the channels. The
 * content is lost and undefined until the next render, and textures get other names; nothing happens if the
 * size is the same. A job or another render that was given the framebuffer before puts its image into the
 * former content, which is lost. */
NICOL_API nicol_result nicol_framebuffer_resize(nicol_framebuffer framebuffer, uint32_t width,
                                                uint32_t height);
/* Gets the width, height and channels of the framebuffer. */
NICOL_API nicol_result nicol_framebuffer_get_size(nicol_framebuffer framebuffer, uint32_t* width,
                                                  uint32_t* height, uint32_t* channels);
/* Replaces the image of a framebuffer by (1 - weight) times this image plus weight times the image of
 * `other`, in each Stokes component. weight is 0 to 1. AOVs and statistics do not change. For motion blur,
 * the mean of n pictures, blend picture k, counted from 1, with weight 1 / k. Returns
 * NICOL_ERROR_INVALID_ARGUMENT if the framebuffers are the same one, or differ in size or channels. */
NICOL_API nicol_result nicol_framebuffer_blend(nicol_framebuffer framebuffer, nicol_framebuffer other,
                                               double weight);
NICOL_API nicol_result nicol_framebuffer_retain(nicol_framebuffer framebuffer);
NICOL_API nicol_result nicol_framebuffer_release(nicol_framebuffer framebuffer);

/* Renders a scene into a framebuffer. options may be NULL: all defaults. Results that a change of the scene,
 * the camera or the options does not affect are kept from the scene's last render; if nothing changed,
 * nothing runs. On failure or cancellation the framebuffer keeps its content and statistics. Returns
 * NICOL_ERROR_INVALID_ARGUMENT for options and cameras out of range and for channels that do not fit. Returns
 * NICOL_ERROR_UNSUPPORTED for an unknown method, for compute shaders if the driver lacks features, and, if a
 * material varies by a texture, for the dense method and for shading at vertices. Returns
 * NICOL_ERROR_CANCELLED if a callback returned 0, NICOL_ERROR_BUSY as fail_if_busy says, and
 * NICOL_ERROR_OUT_OF_MEMORY also beyond the context's memory_limit. */
NICOL_API nicol_result nicol_render(nicol_scene scene, const nicol_camera* camera,
                                    const nicol_render_options* options, nicol_framebuffer framebuffer);

#define NICOL_MAX_VIEWS 1024 /* largest number of views of nicol_render_views */

/* Renders several views of a scene, such as the faces of a cube or the cameras of a rig: the view of
 * cameras[i] into framebuffers[i]. The images are those of nicol_render, called for one view after the other,
 * but the views share one bake of what all of them need, and the light of each vertex. count is the number of
 * views, 1 to NICOL_MAX_VIEWS. All cameras have the struct_size of cameras[0]. The framebuffers are different
 * ones and may differ in size. options apply to each view, NULL: all defaults; bake_budget_ms is the time for
 * all views together. The statistics of the first view that is drawn include the bake. Invalid arguments are
 * refused before anything is rendered. After another failure or cancellation, the views before it have their
 * images. Returns the results of nicol_render. */
NICOL_API nicol_result nicol_render_views(nicol_scene scene, const nicol_camera* cameras,
                                          const nicol_framebuffer* framebuffers, uint32_t count,
                                          const nicol_render_options* options);

/* Asynchronous render. Jobs of one context run one after another, in the order of submission, on a thread of
 * the context. Only nicol_render and nicol_render_views of the same scene wait for a running job, unless
 * fail_if_busy is set. Other functions return while it runs: those that use OpenGL wait at most for the step
 * that the job gives to OpenGL, and those that use its framebuffer for the step that puts the image there. A
 * job may be used from any thread; nicol_job_poll and nicol_job_cancel may also be called from callbacks.
 * "Inside a host's OpenGL" says how jobs differ there. */
typedef struct nicol_job_impl* nicol_job;

#define NICOL_MAX_JOBS 256 /* largest number of queued jobs of a context */

/* Submits nicol_render as a job. The job copies the scene's state: later changes affect later renders only.
 * The framebuffer keeps its content until the job puts its image there. Scene, framebuffer and all they need
 * are kept alive. The caller may release them, and the job too, which runs all the same. The progress
 * callback runs on the context's thread, and progress_user must live until the job is done. Invalid arguments
 * are refused at once if possible; other errors are the job's result. Returns NICOL_ERROR_BUSY if
 * NICOL_MAX_JOBS jobs are queued. A process that exits cancels its jobs. */
NICOL_API nicol_result nicol_render_async(nicol_scene scene, const nicol_camera* camera,
                                          const nicol_render_options* options, nicol_framebuffer framebuffer,
                                          nicol_job* job);

typedef uint32_t nicol_job_state;
#define NICOL_JOB_WAITING 0u
#define NICOL_JOB_RUNNING 1u
#define NICOL_JOB_DONE 2u

typedef struct nicol_job_status {
    uint32_t struct_size;
    nicol_job_state state;
    nicol_result result; /* result of a job that is done, as nicol_render would return it; else NICOL_OK */
    uint32_t reserved;   /* 0 */
    double fraction;     /* fraction of the current verb, 0 to 1; 1 after success */
    /* Verb of a progress callback, "" before the job runs and once it is done; lives as long as the
     * library. */
    const char* verb;
} nicol_job_status;
#define NICOL_JOB_STATUS_INIT \
    { sizeof(nicol_job_status), 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_job_status_init(nicol_job_status* descriptor, uint32_t struct_size);

/* Gets the job's progress, and never waits for the job. */
NICOL_API nicol_result nicol_job_poll(nicol_job job, nicol_job_status* status);

#define NICOL_WAIT_FOREVER 0xffffffffu
/* Waits until the job is done, at most timeout_ms milliseconds (0: not at all), and returns the job's result.
 * After a failure of the job, nicol_last_error() has its message. Returns NICOL_ERROR_TIMEOUT if the job is
 * not done in time, and NICOL_ERROR_NOT_CURRENT if the job needs a host's OpenGL context that is not current
 * on the calling thread. Returns NICOL_ERROR_INVALID_ARGUMENT inside a callback of the context, because
 * waiting there would be a deadlock. */
NICOL_API nicol_result nicol_job_wait(nicol_job job, uint32_t timeout_ms);
/* Cancels a queued job at once, or a running job when it would next call a progress callback. The job's
 * result is NICOL_ERROR_CANCELLED. A job that is done or almost done is not affected. The function does not
 * wait. */
NICOL_API nicol_result nicol_job_cancel(nicol_job job);
NICOL_API nicol_result nicol_job_retain(nicol_job job);
NICOL_API nicol_result nicol_job_release(nicol_job job);

/* clang-format off */
/* Statistics of the last render into a framebuffer. Milliseconds are 0 for verbs that did not run. */
typedef struct nicol_statistics {
    uint32_t struct_size;
    uint32_t order;                 /* highest order of the rendered light: order_high, or less if the light has no more,
                                       but at least order_low; 0 with the reference method */
    uint64_t vertices;              /* number of vertices of all instances, including vertices_added */
    uint64_t triangles;             /* number of triangles of all instances */
    double project_ms;              /* time of projecting light and materials to coefficients, tables and lobes */
    double bake_ms;                 /* time of baking visibility at the vertices, and the dense method's matrices; with the
                                       reference method, its hierarchy of triangles and table of light */
    double relight_ms;              /* time of bringing light, times shadows, into the vertices' frames */
    double shade_ms;                /* time of multiplying light by the response at the view, high orders included */
    double draw_ms;                 /* time of rasterisation, of interpolation between shaded vertices, or of copying the
                                       image into the framebuffer */
    double observe_ms;              /* time of reading and writing images since the last render */
    double bake_trace_ms;           /* part of bake_ms that traced rays; 0 if the bake came from the cache */
    uint64_t bake_rays;             /* rays that the bake traced; 0 if the bake came from the cache */
    uint64_t vertices_skipped;      /* vertices not shaded because they face away or lie outside the view */
    uint64_t vertices_unoccluded;   /* vertices with nothing above their horizon, and so no shadow to compute */
    uint64_t vertices_unphysical;   /* vertices, times channels, that `physical` moved into the physically realizable range;
                                       pixels are not counted */
    uint64_t light_columns_skipped; /* Stokes components of the light that are zero everywhere, times channels */
    uint64_t response_rows_skipped; /* Stokes components that no material reflects, times channels */
    uint64_t channels_shared;       /* colour channels of light that are multiples of one and are not computed again */
    uint64_t response_bytes;        /* bytes of material tables */
    uint64_t visibility_bytes;      /* bytes of visibility by direction at each vertex */
    uint64_t transfer_bytes;        /* bytes kept for relight and shade: light, shadows, matrices and geometry per vertex,
                                       focused light, the surfaces that pixels show, and the image, unless OpenGL draws
                                       it */
    uint64_t buffer_bytes;          /* bytes of OpenGL buffers: vertices, triangles, and work space of compute shaders */
    uint64_t texture_bytes;         /* bytes of OpenGL textures, framebuffer included */
    uint64_t camera_rays;           /* rays from the camera: of the reference method, or those that found the triangles
                                       at pixels where these are much finer than pixels; 0: triangles were drawn, or the
                                       triangles of the image before were kept */
    uint64_t shadow_rays;           /* reference: rays towards the light */
    double trace_ms;                /* reference: time of tracing rays */
    uint32_t compute;               /* 1 if compute shaders relit and shaded, 0 if threads did */
    uint32_t order_low;             /* order_low of the rendered light, as the option says or as it was chosen */
    double predicted_error;         /* predicted error of the orders left out, if a tolerance was given, of shadows
                                       between baked vertices, of interpolation between shaded vertices, of the samples
                                       of lights and lobes, and of bounced light: of surfaces, relative to the RMS of
                                       their s0, without edges of objects, shadows and textures, which are
                                       pixel_samples' */
    /* Counts of recomputed work, up to pixels_shaded; 0 if all was kept from the render before. */
    uint64_t lights_projected;      /* environments projected to coefficients */
    uint64_t materials_projected;   /* tables, matrices and sets of lobes of materials, also from the cache folder */
    uint64_t vertices_traced;       /* vertices whose shadows the bake found, by rays or because nothing can block them */
    uint64_t matrices_baked;        /* dense: matrices of vertices */
    uint64_t vertices_relit;        /* vertices into whose frames light was brought: of threads, those that the image shows */
    uint64_t vertices_shaded;       /* vertices whose Stokes vectors were computed */
    uint64_t pixels_shaded;         /* pixels whose Stokes vectors were computed */
    uint64_t vertices_added;        /* vertices that the bake added by splitting triangles, and their small reserve, recomputed or kept */
    uint64_t local_lights;          /* local lights: the scene's, each instance that emits light, and lights_split */
    uint64_t lights_split;          /* extracted lights that were taken out of the environment */
    uint64_t light_rays;            /* real-time methods: rays from vertices and pixels to local lights, and of the light
                                       that glass and mirrors focus or narrow lobes send on */
    double light_ms;                /* part of shade_ms for local lights, their shadows and the light that glass and mirrors
                                       focus, which is found anew when lights or surfaces change */
    uint64_t smooth_rays;           /* real-time methods: rays from pixels that show glass, mirrors or narrow lobes of
                                       metal, by threads; 0 if compute shaders shaded: smooth surfaces then mirror
                                       lights alone, no surfaces, and narrow lobes the light at vertices */
    uint64_t vertices_pending;      /* vertices whose shadows are not final (bake_budget_ms); 0: the picture is */
    double bounce_ms;               /* real-time methods: part of relight_ms for light that surfaces reflect to each other */
    uint64_t bounce_links;          /* pairs of a vertex and a point of a surface that it sees, along which light bounces */
    uint64_t bounce_rounds;         /* bounces that were computed; 0: direct light alone */
    double bounced_light;           /* RMS over vertices of bounced light, relative to that of all light */
    double bounced_left;            /* estimate of the bounces that were left out, in the same unit */
    uint64_t bake_rays_skipped;     /* rays above the horizon of baked points whose result was known without, beside bake_rays */
    uint64_t vertices_unbaked;      /* vertices that were not baked, or not since the scene changed, because no image has
                                       needed their shadows yet */
    uint32_t given_up;              /* number of better pictures that time_budget_ms does not allow; 0: nothing is given up */
    uint32_t pixel_samples;         /* real-time methods: samples per pixel of the image */
    uint32_t light_samples;         /* real-time methods: light_samples of the image */
    uint32_t bsdf_samples;          /* real-time methods: bsdf_samples of the image */
    double order_tolerance;         /* tolerance of orders and shadows for which orders were chosen: the option's, or more
                                       by time_budget_ms; 0 if they were not chosen */
    uint64_t light_rays_skipped;    /* rays to dim lights that were not traced (NICOL_OPTIMISATION_DIM_LIGHTS), beside light_rays */
} nicol_statistics;
/* clang-format on */
#define NICOL_STATISTICS_INIT                                                                                \
    {                                                                                                        \
        sizeof(nicol_statistics), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, \
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0         \
    }
NICOL_API nicol_result nicol_statistics_init(nicol_statistics* descriptor, uint32_t struct_size);

/* Gets the statistics of the last render into a framebuffer: all zeros before the first render. */
NICOL_API nicol_result nicol_framebuffer_get_statistics(nicol_framebuffer framebuffer,
                                                        nicol_statistics* statistics);

/* ---------------------------------------------------------------- observe */

typedef uint32_t nicol_plane;
#define NICOL_PLANE_S0 0u
#define NICOL_PLANE_S1 1u
#define NICOL_PLANE_S2 2u
#define NICOL_PLANE_S3 3u
#define NICOL_PLANE_STOKES 4u /* Stokes vector, four floats per pixel */
#define NICOL_PLANE_DOLP 5u   /* degree of linear polarization; 0 where s0 <= 0 */
/* Angle of linear polarization, radians in (-pi/2, pi/2], counter-clockwise from image right. */
#define NICOL_PLANE_AOLP 6u
/* Depth: distance along the camera's +z; +infinity without a surface. This plane and all planes below exist
 * only if the last render into the framebuffer made them (NICOL_AOV_...), and only NICOL_PLANE_VARIANCE has
 * colour channels. */
#define NICOL_PLANE_DEPTH 7u
/* Unit shading normal in the world: on the visible side of a two-sided surface, else on the front. */
#define NICOL_PLANE_NORMAL \
    8u /* three floats per pixel; 0 without a surface, and where the normals of a pixel's samples cancel */
#define NICOL_PLANE_POSITION 9u  /* point in the world, three floats per pixel; 0 without a surface */
#define NICOL_PLANE_INSTANCE 10u /* id of the instance, one uint32_t per pixel, or NICOL_NO_INSTANCE */
#define NICOL_NO_INSTANCE 0xffffffffu
/* Variance of each Stokes component of a pixel over seeds, whose square root is the standard error: four
 * floats per pixel and colour channel, at most the largest float. Framebuffers of luminance have the variance
 * of the luminance. The variance is estimated from the means of four groups of the pixel's samples (as many
 * groups as samples below four), so that the estimate itself is as noisy as a chi-square of 3 degrees of
 * freedom. On average the estimate is an upper bound, because all samples of a pixel together are spread
 * better than those of a group: in measurements, 1 to 2 times the variance on most surfaces, and 3 times at
 * outlines under smooth light. */
#define NICOL_PLANE_VARIANCE 11u
/* Coverage: the fraction of a pixel's samples (with the reference method, of its rays) that show a surface,
 * from the front or from behind; 1 or 0 with one sample. The Stokes image is not multiplied by the coverage,
 * and has the environment behind the surfaces, weighted by 1 - alpha, or black without an environment. */
#define NICOL_PLANE_ALPHA 12u
/* Light behind an ideal linear polarizer at the polarizer_angle of nicol_plane_buffer, or at 0 degrees with
 * nicol_framebuffer_read. The plane always exists and has the colour channels of the framebuffer. */
#define NICOL_PLANE_POLARIZER 13u

/* Copies one plane of one colour channel, first row at the top. row_stride is in bytes; 0: tightly packed.
 * byte_size is the room at pixels, in bytes. Returns NICOL_ERROR_INVALID_ARGUMENT for a plane that does not
 * exist, and for NICOL_PLANE_INSTANCE, which holds no floats. */
NICOL_API nicol_result nicol_framebuffer_read(nicol_framebuffer framebuffer, nicol_plane plane,
                                              uint32_t channel, float* pixels, uint64_t row_stride,
                                              uint64_t byte_size);

typedef uint32_t nicol_format;
#define NICOL_FORMAT_AUTOMATIC 0u /* float32; uint32 for NICOL_PLANE_INSTANCE */
#define NICOL_FORMAT_FLOAT32 1u
/* IEEE 754 half precision, rounded to the nearest, ties to even. */
#define NICOL_FORMAT_FLOAT16 \
    2u /* infinite beyond 65504 and in steps of 2^-24 for small values: scale the light if this matters */
#define NICOL_FORMAT_UINT32 3u /* for NICOL_PLANE_INSTANCE alone */

#define NICOL_ALL_CHANNELS 0xffffffffu

typedef struct nicol_plane_buffer {
    uint32_t struct_size;
    nicol_plane plane;
    nicol_format format;
    /* Colour channel, counted from 0, or NICOL_ALL_CHANNELS: every channel, interleaved; default 0. Planes
     * without channels need 0. */
    uint32_t channel;
    /* Room for [row][column][channel][component], first row at the top; aligned to its numbers. */
    void* pixels;
    /* Bytes from row to row, a multiple of a number's size; 0, the default: tightly packed. */
    uint64_t row_stride;
    uint64_t byte_size; /* room at pixels, bytes; checked */
    /* NICOL_PLANE_POLARIZER: angle of the polarizer's transmission axis, counter-clockwise from image right,
     * degrees, finite, default 0. */
    double polarizer_angle;
} nicol_plane_buffer;
#define NICOL_PLANE_BUFFER_INIT \
    { sizeof(nicol_plane_buffer), 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_plane_buffer_init(nicol_plane_buffer* descriptor, uint32_t struct_size);

/* Copies a plane in the format and with the channels of `to`. Bytes between rows are not written. A call that
 * fails writes nothing. */
NICOL_API nicol_result nicol_framebuffer_read_plane(nicol_framebuffer framebuffer,
                                                    const nicol_plane_buffer* to);
/* clang-format off */
/* Writes an OpenEXR file of 32-bit floats, whose channels are named by the number of colour channels:
 *   3             R G B (which are s0) and S0.R S0.G S0.B to S3.R S3.G S3.B, as Mitsuba 3's stokes integrator
 *   1             Y (which is s0) and S0.Y to S3.Y
 *   2, 4 to 16    S0.0 S0.1 ... to S3.0 S3.1 ...
 * A path that ends as the names of another kind of image do, such as .png, is refused.
 * AOVs of the last render are Z (depth), N.X N.Y N.Z, P.X P.Y P.Z, id (32-bit unsigned), A (alpha; R G B still have the
 * environment) and, for each Stokes channel, variance.S0.R ... variance.S3.B. */
/* clang-format on */
NICOL_API nicol_result nicol_framebuffer_write_exr(nicol_framebuffer framebuffer, const char* path);
/* Passes the bytes of the file that nicol_framebuffer_write_exr writes to a sink. The sink is called after
 * all bytes are made; user is its first argument. */
NICOL_API nicol_result nicol_framebuffer_encode_exr(nicol_framebuffer framebuffer, nicol_sink_callback sink,
                                                    void* user);

typedef uint32_t nicol_observation_kind;
#define NICOL_OBSERVATION_S0 0u        /* s0, tone-mapped with the sRGB curve */
#define NICOL_OBSERVATION_S1 1u        /* s1: red negative, green positive, linear */
#define NICOL_OBSERVATION_S2 2u        /* s2: red negative, green positive, linear */
#define NICOL_OBSERVATION_S3 3u        /* s3: red negative, green positive, linear */
#define NICOL_OBSERVATION_DOLP 4u      /* DoLP: black 0, white 1, with the sRGB curve */
#define NICOL_OBSERVATION_AOLP 5u      /* AoLP: hue = angle / 180 degrees, value = DoLP with the sRGB curve */
#define NICOL_OBSERVATION_POLARIZER 6u /* light behind an ideal linear polarizer, tone-mapped as s0 */

typedef struct nicol_observation {
    uint32_t struct_size;
    nicol_observation_kind kind;
    float exposure; /* exposure of s0 and polarizer, stops, default 0 */
    /* Value of s1..s3 that is shown at full colour; 0, the default: automatic, the largest value in the
     * image. The file states the scale. */
    float scale;
    float polarizer_angle; /* angle of the polarizer, degrees counter-clockwise from image right, default 0 */
} nicol_observation;
#define NICOL_OBSERVATION_INIT \
    { sizeof(nicol_observation), 0, 0, 0, 0 }
NICOL_API nicol_result nicol_observation_init(nicol_observation* descriptor, uint32_t struct_size);

/* Writes a PNG file of 8-bit RGB; a path that ends as the names of another kind of image do, such as .jpg, is
 * refused. S0 and POLARIZER need a framebuffer of 1 or 3 channels; the other kinds
 * show the mean of the channels. */
NICOL_API nicol_result nicol_framebuffer_write_png(nicol_framebuffer framebuffer,
                                                   const nicol_observation* observation, const char* path);
/* Passes the bytes of the file that nicol_framebuffer_write_png writes to a sink. The sink is called after
 * all bytes are made; user is its first argument. */
NICOL_API nicol_result nicol_framebuffer_encode_png(nicol_framebuffer framebuffer,
                                                    const nicol_observation* observation,
                                                    nicol_sink_callback sink, void* user);

/* ---------------------------------------------------------------- sensor */

/* Arrangement of polarizers and colour filters on the pixels of an image sensor, from the image's top left.
 */
typedef uint32_t nicol_mosaic;
#define NICOL_MOSAIC_PLAIN 0u /* neither: each pixel measures the mean of all channels */
/* Polarizers at 90 45 / 135 0 degrees counter-clockwise from image right, as on Sony's IMX250MZR. Each pixel
 * measures the mean of all channels. Both sides of images are multiples of 2. */
#define NICOL_MOSAIC_POLARIZED 1u
/* The same polarizers, each 2 x 2 under one of the colour filters R G / G B, as on Sony's IMX250MYR. Images
 * have 3 channels, and sides that are multiples of 4. */
#define NICOL_MOSAIC_POLARIZED_BAYER 2u

/* clang-format off */
/* Linear image sensor, by the figures of the standard EMVA 1288. A pixel collects
 *     n = Poisson(quantum_efficiency * exposure * I + dark_current * exposure_time)
 * electrons, at most full_well, where I is s0 behind the optics and the pixel's polarizer, and gives the number
 *     floor(gain * (n + read noise + offset) + black_level + 1/2), cut to 0 .. 2^bits - 1.
 * Noise belongs to the seed, the frame and the pixel. The polarizers' angles and transmittances, the offsets and the
 * sensitivities belong to the seed and the pixel, as does the crosstalk. All of them have the same bits on every machine and for any number
 * of threads, so that the same Stokes image gives the same bytes. */
/* clang-format on */
typedef struct nicol_sensor {
    uint32_t struct_size;
    nicol_mosaic mosaic; /* polarizers and colour filters, default NICOL_MOSAIC_POLARIZED */
    uint32_t bits;       /* bits of a number, 8, 10, 12 or 16, default 12 */
    uint32_t shot_noise; /* 1, the default: electrons are Poisson distributed; 0: their mean, not rounded */
    uint64_t seed;       /* seed of noise and of the pixels' errors, default 0 */
    /* Mueller matrix of the optics in front of the sensor, row-major, in the image's frame; default the
     * identity. nicol_sensor_add_element adds an element. */
    double optics[16];
    /* Photons that reach a pixel where s0 = 1, before its polarizer. 0, the default: as many as fill the well
     * where unpolarized light has s0 = 1. */
    double exposure;
    double exposure_time; /* time in which dark current flows, seconds, default 0.01 */
    double full_well;     /* largest number of electrons, 1 to 1e9, default 10000 */
    double gain; /* system gain K, numbers per electron; 0, the default: the full well gives 2^bits - 1 */
    double black_level;  /* number without electrons, default 0 */
    double read_noise;   /* temporal dark noise sigma_d, electrons, default 2.5 */
    double dark_current; /* dark current, electrons per second, default 0 */
    double dsnu; /* dark signal nonuniformity: standard deviation of the offsets, electrons, default 0 */
    double prnu; /* photo response nonuniformity: relative standard deviation, 0 to 1, default 0 */
    /* Transmittance of a pixel's polarizer along its axis (1) over that across it, at least 1. 0, the
     * default: an ideal polarizer. */
    double extinction_ratio;
    double extinction_spread; /* relative standard deviation of the transmittance across, 0 to 1, default 0 */
    double misalignment;      /* standard deviation of the polarizers' angles, degrees, 0 to 5, default 0 */
    double crosstalk; /* fraction of a pixel's electrons that its four neighbours get, 0 to 0.8, default 0 */
    double crosstalk_spread; /* relative standard deviation of that fraction over pixels, 0 to 1, default 0 */
    double blur; /* standard deviation of the lens's blur, which is normal, pixels, 0 to 16, default 0 */
    /* Part of the light that the lens loses in the image's corners, 0 to 0.99, default 0. The rest of the
     * image follows the fourth power of the cosine of the angle from the optical axis, the image's middle. */
    double vignetting;
    /* Quantum efficiency of the channels, above 0 and at most 1, for light along the polarizer's axis;
     * default 0.6. */
    nicol_spectrum quantum_efficiency;
    uint32_t reserved; /* 0 */
} nicol_sensor;
/* clang-format off */
#define NICOL_SENSOR_INIT                                                                                  \
    { sizeof(nicol_sensor), NICOL_MOSAIC_POLARIZED, 12, 1, 0, NICOL_IDENTITY_4X4, 0, 0.01, 10000, 0, 0, 2.5, \
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, NICOL_SPECTRUM_INIT, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_sensor_init(nicol_sensor* descriptor, uint32_t struct_size);

typedef uint32_t nicol_sensor_preset;
/* Sony IMX250MZR and IMX250MYR: mosaic, 12 bits, and the full well (10715 electrons) and read noise (2.95
 * electrons) that MATRIX VISION measured of the IMX250 by EMVA 1288. The preset leaves the other fields. */
#define NICOL_SENSOR_PRESET_IMX250MZR 0u
#define NICOL_SENSOR_PRESET_IMX250MYR 1u

/* Sets the fields of a preset. */
NICOL_API nicol_result nicol_sensor_set_preset(nicol_sensor* sensor, nicol_sensor_preset preset);
/* Sets the fields that a JSON file names, or those of a mosaic that nicol_sensor_write_png wrote. The file is
 * an object with the names of the fields, and "preset" ("imx250mzr", "imx250myr") and "elements", a list of
 * objects with "kind" ("polarizer", "retarder", "right_circular", "left_circular"), "angle", "retardance",
 * "transmittance" and "extinction_ratio", in the order of the light. */
NICOL_API nicol_result nicol_sensor_load(nicol_sensor* sensor, const char* path);
/* Sets the fields that a file in memory names, as nicol_sensor_load does. */
NICOL_API nicol_result nicol_sensor_load_memory(nicol_sensor* sensor, const nicol_memory_file* file);
/* Multiplies the sensor's optics by the matrix of an element that faces the camera, between the optics and
 * the sensor; angles are counter-clockwise from image right. The element's to_world must be the identity, and
 * its outline has no effect, and it must have no textures. extinction_ratio: transmittance along over across
 * a polarizer's axis, at least 1; 0: an ideal polarizer. */
NICOL_API nicol_result nicol_sensor_add_element(nicol_sensor* sensor,
                                                const nicol_polarization_element* element,
                                                double extinction_ratio);

/* Stokes image in the caller's memory, in the frame of rendered images: x right, y up. */
typedef struct nicol_stokes_image {
    uint32_t struct_size;
    uint32_t width, height; /* size, pixels, 1 to NICOL_MAX_SIZE */
    uint32_t channels;      /* number of colour channels, 1 to NICOL_MAX_CHANNELS */
    /* Floats [row][column][channel][component], first row at the top; finite. */
    void* pixels;
    uint64_t row_stride; /* bytes from row to row, a multiple of 4; 0, the default: tightly packed */
    uint64_t byte_size;  /* room at pixels, bytes; checked */
} nicol_stokes_image;
#define NICOL_STOKES_IMAGE_INIT \
    { sizeof(nicol_stokes_image), 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_stokes_image_init(nicol_stokes_image* descriptor, uint32_t struct_size);

/* Numbers of a sensor's pixels in the caller's memory. */
typedef struct nicol_raw_image {
    uint32_t struct_size;
    uint32_t width, height; /* size, pixels, 1 to NICOL_MAX_SIZE */
    uint32_t reserved;      /* 0 */
    void* pixels;           /* uint16_t [row][column], first row at the top */
    uint64_t row_stride;    /* bytes from row to row, a multiple of 2; 0, the default: tightly packed */
    uint64_t byte_size;     /* room at pixels, bytes; checked */
} nicol_raw_image;
#define NICOL_RAW_IMAGE_INIT \
    { sizeof(nicol_raw_image), 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_raw_image_init(nicol_raw_image* descriptor, uint32_t struct_size);

/* Exposes the sensor to light, and writes the numbers to `to`, which has the light's size. Frames with other
 * numbers have other noise. Light that is not finite is refused. */
NICOL_API nicol_result nicol_sensor_expose(const nicol_sensor* sensor, const nicol_stokes_image* light,
                                           uint64_t frame, const nicol_raw_image* to);
/* Exposes the sensor to the last image of a framebuffer. */
NICOL_API nicol_result nicol_framebuffer_expose(nicol_framebuffer framebuffer, const nicol_sensor* sensor,
                                                uint64_t frame, const nicol_raw_image* to);
/* Writes numbers as a grey PNG: 8 bits, or 16 bits if the sensor has more than 8. The file names the mosaic,
 * the bits and the sensor in the text chunks Nicol:Mosaic, Nicol:Bits and Nicol:Sensor. */
NICOL_API nicol_result nicol_sensor_write_png(const nicol_sensor* sensor, const nicol_raw_image* raw,
                                              const char* path);

typedef uint32_t nicol_demosaic;
#define NICOL_DEMOSAIC_BILINEAR \
    0u                           /* mosaic's size; angles and colours are interpolated between their pixels */
#define NICOL_DEMOSAIC_BLOCKS 1u /* one Stokes vector per cell of 2 x 2, or 4 x 4 with colour filters */
/* Like BILINEAR, but angles are interpolated along edges: of the two lines through a pixel, that along which
 * the mosaic varies less counts more (after Gao and Gruev 2013). */
#define NICOL_DEMOSAIC_GRADIENT 2u

/* Computes the light on the sensor, behind its optics, from numbers of its pixels, by the sensor's exposure,
 * quantum efficiency, gain, levels and extinction ratio. The pixels' own errors and crosstalk are not undone.
 * `to` has 3 channels with colour filters, else 1, and s3 = 0; NICOL_MOSAIC_PLAIN gives s0 alone. */
NICOL_API nicol_result nicol_sensor_demosaic(const nicol_sensor* sensor, const nicol_raw_image* raw,
                                             nicol_demosaic method, const nicol_stokes_image* to);

/* ---------------------------------------------------------------- gradients */

/* Room for gradients of a function f of a picture, which nicol_render_adjoint writes. NULL, the default: the
 * gradient is not wanted. */
typedef struct nicol_gradient {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    /* Derivatives of f by the coefficients of the environment up to order_low, in its own axes:
     * [channel][l*l + l + m][4] as nicol_environment_create_psh has them, in all channels of the scene. The
     * derivative by an environment of one channel is the sum over the channels. Components p = 1, 2 below l =
     * 2 are 0. All four components are computed, also those that the environment lacks. */
    double* environment;
    uint64_t environment_count; /* number of doubles at environment: channels * 4 (order_low + 1)^2 */
    /* Derivatives of f by the Stokes vectors of the local lights, [light][channel][4], lights in the order of
     * nicol_scene_get_light_ids. A light's Stokes vector in a channel is its value times (1, dolp cos 2 aolp,
     * dolp sin 2 aolp, docp). */
    double* lights;
    uint64_t lights_count; /* number of doubles at lights: lights * channels * 4 */
    /* Derivatives of f by a factor of all that an instance reflects, at the factor 1: [instance][channel],
     * instances in the order of nicol_scene_get_instance_ids. The derivative by the reflectance of a diffuse
     * material is the sum over its instances, divided by the reflectance. */
    double* instances;
    uint64_t instances_count; /* number of doubles at instances: instances * channels */
    /* Derivatives of f by the linear values of the texels of `texture`, [row][column][channel of the
     * texture], its look-ups and their means over pixels included. Materials reflect in proportion to the
     * texture, as by the colour of a diffuse material or by the weight of a blend. What they interpolate by
     * its values, such as a roughness, is refused; tints of principled materials and thicknesses of films
     * count as constant. */
    nicol_texture texture; /* image whose texels are not all equal; NULL: texels must be NULL, too */
    double* texels;
    uint64_t texels_count; /* number of doubles at texels: rows * columns * channels of the texture */
} nicol_gradient;
#define NICOL_GRADIENT_INIT \
    { sizeof(nicol_gradient), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_gradient_init(nicol_gradient* descriptor, uint32_t struct_size);

/* clang-format off */
/* Computes gradients of a function f of the image that nicol_render makes with this camera and these options. The image is
 * linear in its light: image = A light. The gradient by the light is the transpose of A times the gradient by the image. For
 * f = |image - measured|^2 / 2, `picture` is image - measured, and conjugate gradients recover the light.
 *   picture       Derivatives of f by the Stokes vectors of the pixels, in all channels of the scene. Its size is the image's.
 *   Cost          About that of an image whose light has changed, and by texels three to five times as much: with 512 x 512
 *                 pixels, an image took 86 ms, gradients by instances 151, by the environment 108 and by texels 245 ms.
 *                 Nothing is drawn into a framebuffer.
 *   Bake          Gradients need all Stokes components. Callers that alternate between images and gradients should disable
 *                 NICOL_OPTIMISATION_LIGHT_COMPONENTS for both, because the bake then serves both.
 *   Options       method factored; executor automatic or cpu; physical 0; order_low and order_high given and equal, or
 *                 high_orders none; shade_at pixels, or automatic if that shades pixels; pixel_samples 0, 1, 4 or 8; filter
 *                 box; max_depth 0 or 2, or more for the gradient by the environment alone; both time budgets 0; split_lights
 *                 0 and bsdf_samples 0 if the image would otherwise have extracted lights or samples of the environment.
 *   Scene         No mirrors, no smooth glass, and with a max_depth above 2 no narrow metal; no polarization elements. The
 *                 gradient by the environment needs hidden emitters, that by instances no emissive surfaces, and those by
 *                 lights, by instances and by texels no local light of the value 0.
 * Returns NICOL_ERROR_UNSUPPORTED for other options and scenes, with a message that says what to change.
 * Returns NICOL_ERROR_INVALID_ARGUMENT for sizes that do not fit, for numbers that are not finite, for a local light of the
 * value 0, and if the gradient by the environment is wanted without an environment, or by a texture that no instance's material
 * reflects by; else the results of nicol_render. A call that fails writes nothing. */
/* clang-format on */
NICOL_API nicol_result nicol_render_adjoint(nicol_scene scene, const nicol_camera* camera,
                                            const nicol_render_options* options,
                                            const nicol_stokes_image* picture,
                                            const nicol_gradient* gradient);

/* ---------------------------------------------------------------- inside a host's OpenGL */

/* clang-format off */
/* A context can be the caller's own, so that images stay on the device. No context is then made current, no OpenGL thread
 * is started, and nicol_framebuffer_get_texture and nicol_framebuffer_draw_... give access to the images.
 *
 *   Current       The host's OpenGL context, and no other, must be current on the calling thread in
 *                 nicol_context_create_host and in every call that uses OpenGL: nicol_framebuffer_create and
 *                 nicol_framebuffer_resize, nicol_render, and calls that read, write and draw images. If the context is not
 *                 current, such a call fails with NICOL_ERROR_NOT_CURRENT and touches nothing. The context may move from
 *                 thread to thread.
 *   State         All OpenGL state of the host is as before when a call returns. Nicol saves and restores the state that
 *                 it changes, and sets and restores the state on which it depends (scissor, masks, pixel storage, ...),
 *                 once a call. A host that sets its own state again after each call may say so, which saves the queries:
 *                 NICOL_HOST_SETS_STATE.
 *                 Nicol makes objects with new names and leaves other objects alone. Active queries of the host count
 *                 what Nicol draws, and the host's debug callback gets the driver's messages about Nicol's commands.
 *   Refused       Unless the host sets its state, calls fail with NICOL_ERROR_UNSUPPORTED in states that cannot be
 *                 restored, or in which nothing is drawn: transform feedback that is not paused, conditional rendering, a
 *                 current program that is deleted or whose last link failed; in compatibility contexts also a display
 *                 list that is being compiled and a render mode other than GL_RENDER.
 *   Errors        Errors that the host left pending stay pending: glGetError returns after a call the error that it would
 *                 have returned before, and no error of Nicol's. GL_STACK_OVERFLOW, GL_STACK_UNDERFLOW and
 *                 GL_CONTEXT_LOST cannot be made pending again: the call takes the error, fails with NICOL_ERROR_OPENGL
 *                 and names the error. nicol_context_create_host leaves pending errors alone.
 *   Callbacks     Callbacks during a render must not call OpenGL.
 *   Jobs          Jobs bake, project and shade on a thread of Nicol's, while the host goes on. The OpenGL commands of jobs
 *                 wait until the host lends its context. A call of nicol_job_poll where the context is current gives the
 *                 commands that are ready. nicol_job_wait, and any call that waits for the job, gives commands as they
 *                 come, and fails with NICOL_ERROR_NOT_CURRENT where the context is not current. A job that waits for
 *                 the context is cancelled when the last handle of the context's objects has been released.
 *   Times         The time of a verb that works on the device is the time of giving its commands; the host's commands
 *                 follow in order.
 *   Release       A release where the context is current deletes the object's OpenGL objects at once. Otherwise the next
 *                 call where the context is current deletes them, or the end of the host's context does. Release
 *                 everything before the OpenGL library is unloaded.
 */
/* clang-format on */
/* Returns the address of an OpenGL function by its name, as SDL_GL_GetProcAddress, eglGetProcAddress and
 * others do. */
typedef void* (*nicol_get_proc_address_callback)(void* user, const char* name);
/* Returns 1 if the host's context is current on the calling thread, else 0. */
typedef int32_t (*nicol_is_current_callback)(void* user);

/* Flag of a host that sets all OpenGL state that it uses again after each call of Nicol. Nicol then queries
 * no state and restores none: see "State" and "Refused" above. Objects and pending errors are left as they
 * were. is_current should be given, because OpenGL is queried without it. */
#define NICOL_HOST_SETS_STATE 1u
/* Flag for finding defects: the errors of OpenGL are asked after each command instead of once a call, so that
 * the message of NICOL_ERROR_OPENGL names the command. */
#define NICOL_HOST_VALIDATE 2u

typedef struct nicol_host {
    uint32_t struct_size;
    uint32_t flags; /* sum of NICOL_HOST_..., default 0: none */
    nicol_get_proc_address_callback get_proc_address;
    /* Callback that tells whether the context is current. NULL, the default: OpenGL is queried, which needs
     * OpenGL functions that may be called without a context, as with libglvnd and Mesa. */
    nicol_is_current_callback is_current;
    void* user; /* argument of both callbacks; used until the last object of the context is released */
} nicol_host;
#define NICOL_HOST_INIT \
    { sizeof(nicol_host), 0, 0, 0, 0 }
NICOL_API nicol_result nicol_host_init(nicol_host* descriptor, uint32_t struct_size);

/* Creates a context inside the OpenGL context that is current: OpenGL 4.5 or newer, of the core or the
 * compatibility profile. options are those of nicol_context_create, with backend and device 0. Returns
 * NICOL_ERROR_NOT_CURRENT if is_current returns 0, and NICOL_ERROR_NO_BACKEND if there is no such
 * OpenGL. */
NICOL_API nicol_result nicol_context_create_host(const nicol_host* host, const nicol_context_options* options,
                                                 nicol_context* context);

/* Creates a framebuffer whose images are textures of the host's, one for each channel: level 0 of a
 * GL_TEXTURE_2D of GL_RGBA32F, allocated by glTexStorage2D or glTextureStorage2D, all of one size. A texel is
 * the Stokes vector, and row 0 the image's TOP. The textures must live until the framebuffer is released;
 * Nicol never deletes them. The host may sample them between renders, and must not write them while the
 * framebuffer lives. nicol_framebuffer_resize fails with NICOL_ERROR_UNSUPPORTED. Returns
 * NICOL_ERROR_INVALID_ARGUMENT that names a texture which cannot be used, and NICOL_ERROR_UNSUPPORTED for a
 * context that is not a host's. */
NICOL_API nicol_result nicol_framebuffer_create_textures(nicol_context context, const uint32_t* textures,
                                                         uint32_t channels, nicol_framebuffer* framebuffer);

typedef struct nicol_gl_texture {
    uint32_t struct_size;
    uint32_t name;            /* OpenGL's name of the texture */
    uint32_t target;          /* GL_TEXTURE_2D */
    uint32_t internal_format; /* GL_RGBA32F */
    uint32_t width;
    uint32_t height;
} nicol_gl_texture;
#define NICOL_GL_TEXTURE_INIT \
    { sizeof(nicol_gl_texture), 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_gl_texture_init(nicol_gl_texture* descriptor, uint32_t struct_size);

/* Gets the texture of a colour channel: a texel is the Stokes vector (s0, s1, s2, s3), and row 0 is the
 * image's TOP. The name is valid, and stays the same, until the framebuffer is released or resized; the
 * content is that of the last render. The host may sample the texture and change its filters and wrap modes,
 * but not its swizzle, and must neither write nor delete the texture. Returns NICOL_ERROR_UNSUPPORTED for a
 * framebuffer whose context is not a host's. */
NICOL_API nicol_result nicol_framebuffer_get_texture(nicol_framebuffer framebuffer, uint32_t channel,
                                                     nicol_gl_texture* texture);

typedef uint32_t nicol_encoding;
#define NICOL_ENCODING_LINEAR 0u /* radiance, stored as far as the texture's format goes */
#define NICOL_ENCODING_SRGB 1u   /* radiance clipped to 0 to 1, through the sRGB curve, as in PNG files */

/* Mapping of the distance z along the camera's +z to the numbers of a host's depth buffer, with the host's
 * near plane n and far plane f. They do not depend on the range of z in clip space (glClipControl). */
typedef uint32_t nicol_depth_mapping;
#define NICOL_DEPTH_MAPPING_PERSPECTIVE 0u /* (1/n - 1/z) / (1/n - 1/f): 0 at n, 1 at f */
#define NICOL_DEPTH_MAPPING_PERSPECTIVE_REVERSED \
    1u /* 1 at n, 0 at f: the host's depth test is GL_GREATER or GL_GEQUAL */
#define NICOL_DEPTH_MAPPING_ORTHOGRAPHIC 2u /* (z - n) / (f - n) */
#define NICOL_DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED 3u

/* Texture of the host's to draw into: level 0 of a GL_TEXTURE_2D of GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F or
 * GL_RGBA32F, as large as the framebuffer. */
typedef struct nicol_texture_target {
    uint32_t struct_size;
    uint32_t texture; /* OpenGL's name of the texture */
    /* Meaning of row 0. 0, the default: the image's top; 1: the image's bottom, as in OpenGL's own
     * images. */
    uint32_t bottom_up;
    /* Encoding of the images S0, POLARIZER, DOLP and AOLP, default linear: the numbers whose sRGB encoding a
     * PNG file has. SRGB8_ALPHA8 gets the encoded numbers unchanged. */
    nicol_encoding encoding;
    /* Depth texture of the host's, of the same size and with the same row 0; default 0: none. The image is
     * then drawn only where its surfaces are nearer than the texture's depths, and its depths replace these:
     * what the host has drawn hides Nicol's surfaces, and these hide what the host draws next. Pixels without
     * a surface are infinitely far. The render needs NICOL_AOV_DEPTH and the host's own view. Formats:
     * GL_DEPTH_COMPONENT16, 24 or 32F, GL_DEPTH24_STENCIL8 or GL_DEPTH32F_STENCIL8. */
    uint32_t depth_texture;
    nicol_depth_mapping depth_mapping; /* numbers in depth_texture, default NICOL_DEPTH_MAPPING_PERSPECTIVE */
    float depth_near; /* the host's near plane, default 0: above 0 is needed in perspective */
    float depth_far;  /* the host's far plane; 0, the default: none, in perspective */
} nicol_texture_target;
#define NICOL_TEXTURE_TARGET_INIT \
    { sizeof(nicol_texture_target), 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_texture_target_init(nicol_texture_target* descriptor, uint32_t struct_size);

/* Copies a plane of one channel into a texture; nothing is read back. A texel gets the numbers that
 * nicol_framebuffer_read copies, in red, green, blue and alpha; components that the plane does not have are
 * 0, and alpha 1. The texture may also be of GL_R16F or GL_R32F for one component, and is of GL_R32UI for
 * NICOL_PLANE_INSTANCE. Returns NICOL_ERROR_INVALID_ARGUMENT for NICOL_PLANE_VARIANCE, which is not on the
 * device, and for NICOL_PLANE_POLARIZER, which nicol_framebuffer_draw_observation draws, and
 * NICOL_ERROR_UNSUPPORTED for a framebuffer whose context is not a host's. */
NICOL_API nicol_result nicol_framebuffer_draw_plane(nicol_framebuffer framebuffer, nicol_plane plane,
                                                    uint32_t channel, const nicol_texture_target* target);
/* Draws the plane NICOL_PLANE_STOKES. */
NICOL_API nicol_result nicol_framebuffer_draw_stokes(nicol_framebuffer framebuffer, uint32_t channel,
                                                     const nicol_texture_target* target);
/* Draws the image of nicol_framebuffer_write_png into a texture, as red, green, blue and alpha 1. s1 to s3
 * need a scale above 0, because nothing is read back. Returns NICOL_ERROR_UNSUPPORTED for a framebuffer whose
 * context is not a host's. */
NICOL_API nicol_result nicol_framebuffer_draw_observation(nicol_framebuffer framebuffer,
                                                          const nicol_observation* observation,
                                                          const nicol_texture_target* target);

#ifdef __cplusplus
}
#endif

#endif
