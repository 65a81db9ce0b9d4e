/* SPDX-License-Identifier: MIT
 * Nicol: reports of files of light and materials, and conversion between the formats. */
#ifndef NICOL_FILES_H
#define NICOL_FILES_H

#include "nicol.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- inspect and convert */

/* Kind of a file of light or of a material. Functions of files need no context and may run at the same time
 * on any threads. An output appears under its name only when complete. Axes stay as they are: coefficients
 * are taken in the world's axes, whatever the world of their makers was. */
typedef uint32_t nicol_file_kind;
/* .exr: an equirectangular image in nicol_image's layout and frames, with the channels R G B or Y, S0 .. S3
 * by colour, or the channels of spectral Stokes images. */
#define NICOL_FILE_LIGHT_IMAGE 1u
/* NAME_s0.exr .. NAME_s3.exr, given as one of the four, or as NAME if no file has that name: a cube map as a
 * cross of 4 x 3 faces, with the rows Up / Left Front Right Back / Down at +z / -x +y +x -y / -z. Frames:
 * z = propagation, y = the part of the face's image up that is perpendicular to z, x = image right. */
#define NICOL_FILE_LIGHT_CROSS 2u
/* .npz, SHVec: member coeff [channel][l*l + l + m][4], as all coefficients of nicol_psh.h. */
#define NICOL_FILE_LIGHT_PSH 3u
/* .npz, SHMat ISOBI2: member coeff [channel][index][p out][p in], an isotropic pBRDF times the incident
 * cosine, both sides over propagation directions, the normal along z. */
#define NICOL_FILE_MATERIAL_PSH 4u
/* .pbsdf, as Mitsuba 3's measured_polarized: half vector and difference angles, s-frames. Files of this kind
 * can be read but not written. */
#define NICOL_FILE_MATERIAL_MEASURED 5u
/* .response, a table of Nicol's cache: light that leaves at each zenith angle up to 90 degrees, over
 * coefficients of the light. Tables are written into a cache folder: an output that is a folder or ends in
 * '/'. */
#define NICOL_FILE_MATERIAL_TABLE 6u

/* Flag for images whose pixels are samples of light without orders above `order`, instead of the bilinear
 * function between pixels. With the flag, an image that was written from coefficients gives the same
 * coefficients. The image needs 2 order + 1 columns and rows. */
#define NICOL_FILE_BAND_LIMITED 1u
/* Flag to make images physically realizable (Eq. 70): s0 below 0 becomes black, and polarization beyond s0 is
 * cut to s0. Truncated light needs the flag so that other programs accept it as a light. */
#define NICOL_FILE_PHYSICAL 2u

#define NICOL_FILE_ORDER_AUTOMATIC 0xffffffffu

typedef struct nicol_file_options {
    uint32_t struct_size;
    /* Highest order of coefficients and tables, also of an image if the order is given: at most 4096 for
     * light and 64 for materials (NICOL_PSH_MAX_ORDER, NICOL_PSH_MAX_MATRIX_ORDER). Default
     * NICOL_FILE_ORDER_AUTOMATIC: the file's own order if there is one, else 32 for light and 16 for
     * materials. */
    uint32_t order;
    /* Size of an image to write, pixels, both or none; height at least 2. 0, the default: automatic. An image
     * then keeps its size, and a cross of edge e gets 8 e columns (4 e above 256). Coefficients get 512 x
     * 257, doubled until there are 4 (order + 1) columns, at most 4096 x 2049, and lose the orders that fewer
     * than 2 order + 1 columns or rows cannot hold. */
    uint32_t width, height;
    uint32_t edge;  /* edge of a cross's face to write, pixels, 2 to 4096; 0, the default: automatic, 256 */
    uint32_t flags; /* sum of NICOL_FILE_BAND_LIMITED and NICOL_FILE_PHYSICAL, default 0 */
    double scale;   /* factor on radiance or reflectance, 0 to 1e12, default 1 */
    /* Rotation of light, row-major, default the identity: exact for coefficients, by bilinear interpolation
     * for images. Materials need the identity. */
    double rotation[9];
    /* Wavelengths of the channels of spectral files, nm: the nearest channel of an image, or linear between
     * the wavelengths of a material. count 0, the default: every wavelength of an image; red, green and blue
     * of a measured material. */
    nicol_spectrum wavelengths;
    uint32_t reserved; /* 0 */
} nicol_file_options;
/* clang-format off */
#define NICOL_FILE_OPTIONS_INIT                                                             \
    { sizeof(nicol_file_options), NICOL_FILE_ORDER_AUTOMATIC, 0, 0, 0, 0, 1,                \
      {1, 0, 0, 0, 1, 0, 0, 0, 1}, NICOL_SPECTRUM_INIT, 0 }
/* clang-format on */
NICOL_API nicol_result nicol_file_options_init(nicol_file_options* descriptor, uint32_t struct_size);

/* Report of a light, by channel. Means and fractions are taken over the sphere, weighted by solid angle, for
 * the image that would be written. */
typedef struct nicol_light_report {
    uint32_t struct_size;
    nicol_file_kind kind;
    uint32_t channels;
    uint32_t order;                         /* highest order of the energies */
    uint32_t width;                         /* width of the image, pixels */
    uint32_t height;                        /* height of the image, pixels */
    uint32_t polarized;                     /* 1 if some s1, s2 or s3 is not 0, else 0 */
    uint32_t circular;                      /* 1 if some s3 is not 0, else 0 */
    double wavelengths[NICOL_MAX_CHANNELS]; /* wavelengths, nm; 0: the channels are colours */
    double mean[NICOL_MAX_CHANNELS];        /* mean s0 */
    double smallest[NICOL_MAX_CHANNELS];    /* smallest s0 */
    double largest[NICOL_MAX_CHANNELS];     /* largest s0 */
    /* Mean of the directions that light comes from, weighted by s0 > 0: of length 0 (evenly) to 1 (from one
     * point). */
    double direction[3 * NICOL_MAX_CHANNELS];
    double mean_dolp[NICOL_MAX_CHANNELS];        /* mean degree of linear polarization, weighted by s0 */
    double largest_dolp[NICOL_MAX_CHANNELS];     /* largest degree of linear polarization where s0 > 0 */
    double largest_circular[NICOL_MAX_CHANNELS]; /* largest |s3| / s0 where s0 > 0 */
    /* Fraction of the sphere that violates Eq. 70 by more than 1e-5 s0. */
    double unphysical[NICOL_MAX_CHANNELS];
    /* Largest sqrt(s1^2 + s2^2 + s3^2) - s0 where Eq. 70 is violated, over the mean s0. */
    double largest_excess[NICOL_MAX_CHANNELS];
} nicol_light_report;
#define NICOL_LIGHT_REPORT_INIT                                                                         \
    {                                                                                                   \
        sizeof(nicol_light_report), 0, 0, 0, 0, 0, 0, 0, {0}, {0}, {0}, {0}, {0}, {0}, {0}, {0}, {0}, { \
            0                                                                                           \
        }                                                                                               \
    }
NICOL_API nicol_result nicol_light_report_init(nicol_light_report* descriptor, uint32_t struct_size);

/* Report of a material, by channel, as far as coefficients up to `order` describe the material. */
typedef struct nicol_material_report {
    uint32_t struct_size;
    nicol_file_kind kind;
    uint32_t channels;
    uint32_t order;      /* highest order of the values below */
    uint32_t file_order; /* order of the file's own coefficients or table; 0 if measured */
    /* Number of Stokes components of the light that the material is defined for: 4; for a table also 1
     * (unpolarized light) or 3 (linearly polarized light). */
    uint32_t stokes_columns;
    uint32_t measured_wavelengths;          /* number of wavelengths of a measured material, else 0 */
    uint32_t reserved;                      /* 0 */
    double measured_range[2];               /* first and last measured wavelength, nm */
    double wavelengths[NICOL_MAX_CHANNELS]; /* wavelengths, nm; 0: the channels are colours */
    double albedo[NICOL_MAX_CHANNELS];      /* reflected fraction of unpolarized light that arrives evenly */
    /* Largest reflected fraction of light from one direction, for directions up to 75 degrees from the normal
     * and the worst polarization. Above 1 energy appears: the material is not passive. */
    double largest_albedo[NICOL_MAX_CHANNELS];
    /* Frobenius norms of the parts of the matrix between the groups s0, (s1, s2), s3:
     * [channel][out][in]. */
    double norms[9 * NICOL_MAX_CHANNELS];
    /* Norm of the part that breaks mirror symmetry, over the norm of all: mostly errors of a measurement. The
     * option symmetrize removes the part when the material is loaded. */
    double asymmetry[NICOL_MAX_CHANNELS];
    /* Fraction of all pairs of directions, by projected solid angle, for which some fully polarized light
     * leaves with sqrt(s1^2 + s2^2 + s3^2) above s0 by more than 0.001 of the mean M00. */
    double unphysical[NICOL_MAX_CHANNELS];
    /* Mean over all pairs of directions of the largest sqrt(s1^2 + s2^2 + s3^2) - s0 above 0, over the mean
     * M00. */
    double excess[NICOL_MAX_CHANNELS];
} nicol_material_report;
#define NICOL_MATERIAL_REPORT_INIT                                                               \
    {                                                                                            \
        sizeof(nicol_material_report), 0, 0, 0, 0, 0, 0, 0, {0}, {0}, {0}, {0}, {0}, {0}, {0}, { \
            0                                                                                    \
        }                                                                                        \
    }
NICOL_API nicol_result nicol_material_report_init(nicol_material_report* descriptor, uint32_t struct_size);

/* Gets the kind of a file from its suffix and headers alone; the file may yet prove damaged. Returns
 * NICOL_ERROR_UNSUPPORTED for another suffix or an archive of another kind. */
NICOL_API nicol_result nicol_file_identify(const char* path, nicol_file_kind* kind);
/* Gets the report of a light, and its energies [channel][l][p], 4 (order + 1) per channel: squares of the
 * coefficients, summed over m. energy has room for count doubles, and may be NULL with count 0. options may
 * be NULL. Scale and rotation change the report as they would change an output. Options of images to write
 * must be 0. The order limits the energies of an image, and everything for coefficients. An image that
 * violates Eq. 70 is described, although it is refused as a light. */
NICOL_API nicol_result nicol_file_describe_light(const char* path, const nicol_file_options* options,
                                                 nicol_light_report* report, double* energy, uint64_t count);
/* Gets the report of a material, and its energies [channel][l], order + 1 per channel: squares of the matrix'
 * entries between two orders, the larger of which is l. options are those of nicol_file_describe_light. */
NICOL_API nicol_result nicol_file_describe_material(const char* path, const nicol_file_options* options,
                                                    nicol_material_report* report, double* energy,
                                                    uint64_t count);
/* Reads the file `in` and writes `out` in the kind that the name of `out` says: .exr, _s0.exr (all four
 * files), .npz or a cache folder. Light becomes light, and a material becomes a material. options may be
 * NULL. */
NICOL_API nicol_result nicol_file_convert(const char* in, const nicol_file_options* options, const char* out);
/* Writes an environment to a file in the kind that the path says, as nicol_file_convert does. options may be
 * NULL, and must have no wavelengths. */
NICOL_API nicol_result nicol_environment_write(nicol_environment environment,
                                               const nicol_file_options* options, const char* path);
/* Writes a material to a file in the kind that the path says, as nicol_file_convert does. options may be
 * NULL, and must have no wavelengths. */
NICOL_API nicol_result nicol_material_write(nicol_material material, const nicol_file_options* options,
                                            const char* path);
/* Reads a mosaic from a grey image of 8 or 16 bits, as of a polarization camera or nicol_sensor_write_png,
 * and writes the Stokes image of nicol_sensor_demosaic to an OpenEXR file. */
NICOL_API nicol_result nicol_file_demosaic(const char* in, const nicol_sensor* sensor, nicol_demosaic method,
                                           const char* out);
/* Reads pictures of one view behind a polarizer at 0, 45, 90 and 135 degrees counter-clockwise from image
 * right, and writes the Stokes image in front of it to an OpenEXR file, with s3 = 0. EXR files give s0. Other
 * images give their numbers as linear light in 0 to 1, without a curve. */
NICOL_API nicol_result nicol_file_combine_angles(const char* at_0, const char* at_45, const char* at_90,
                                                 const char* at_135, const char* out);
/* Writes coefficients of 1 to NICOL_MAX_CHANNELS vectors to a file of the kind NICOL_FILE_LIGHT_PSH. */
NICOL_API nicol_result nicol_psh_write_file(const char* path, uint32_t order, uint64_t vectors,
                                            const double* coefficients, uint64_t count);

#ifdef __cplusplus
}
#endif

#endif
