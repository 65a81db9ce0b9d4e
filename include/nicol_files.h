/* SPDX-License-Identifier: MIT
 * Nicol: what files of light and materials hold, and conversion between them. */
#ifndef NICOL_FILES_H
#define NICOL_FILES_H

#include "nicol.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- inspect and convert */

/* Light and materials in files: what they hold, and from one format to another. Files need no context. These
 * functions may run at the same time on any threads. An output appears under its name only when complete.
 * Axes stay as they are: coefficients are taken in the world's axes, whatever the world of their makers was.
 */
typedef uint32_t nicol_file_kind;
/* .exr: an equirectangular image in nicol_image's layout and frames, with the channels R G B or Y, S0 .. S3
 * by colour, or those of spectral Stokes images. */
#define NICOL_FILE_LIGHT_IMAGE 1
/* NAME_s0.exr .. NAME_s3.exr, given as one of the four or as NAME where no file has that name: a cube map as
 * a cross of 4 x 3 faces, rows Up / Left Front Right Back / Down, which lie at +z / -x +y +x -y / -z. Frames:
 * z = propagation, y = the face's image up as far as it is perpendicular to z, x = image right. */
#define NICOL_FILE_LIGHT_CROSS 2
/* .npz, SHVec: member coeff [channel][l*l + l + m][4], as nicol_psh.h has them everywhere. */
#define NICOL_FILE_LIGHT_PSH 3
/* .npz, SHMat ISOBI2: member coeff [channel][index][p out][p in], an isotropic pBRDF times the incident
 * cosine, both sides over propagation directions, the normal along z. */
#define NICOL_FILE_MATERIAL_PSH 4
/* .pbsdf, as Mitsuba 3's measured_polarized: half vector and difference angles, s-frames. Read alone. */
#define NICOL_FILE_MATERIAL_MEASURED 5
/* .response, a table of Nicol's cache: what leaves at each zenith angle up to 90 degrees, over coefficients
 * of the light. Written into a cache folder: an output that is a folder or ends in '/'. */
#define NICOL_FILE_MATERIAL_TABLE 6

/* An image's pixels are taken as samples of light that has no orders above `order`, instead of the bilinear
 * function between them: what was written from coefficients comes back as it was. Needs 2 order + 1 columns
 * and rows. */
#define NICOL_FILE_BAND_LIMITED 1
/* Images are made physical (Eq. 70): s0 below 0 becomes black, polarization beyond s0 is cut to s0.
 * Truncated light needs it for other programs to accept it as a light. */
#define NICOL_FILE_PHYSICAL 2

#define NICOL_FILE_ORDER_AUTOMATIC 0xffffffffu

typedef struct nicol_file_options {
    uint32_t struct_size;
    uint32_t order; /* highest order of coefficients and tables, also of an image where it is given. Default
                       NICOL_FILE_ORDER_AUTOMATIC: the file's own where it has one, else 32 for light and 16
                       for materials. At most 4096 for light and 64 for materials (NICOL_PSH_MAX_ORDER,
                       NICOL_PSH_MAX_MATRIX_ORDER) */
    uint32_t width,
        height;     /* of an image to write, both or none; height at least 2. 0: automatic, an image keeps its
                       size, a cross of edge e gets 8 e columns (4 e above 256); coefficients 512 x
                       257, doubled until there are 4 (order + 1) columns, at most 4096 x 2049.
                       Coefficients lose the orders that fewer than 2 order + 1 columns or rows cannot hold */
    uint32_t edge;  /* of a face of a cross to write, 2 to 4096. 0: automatic, 256 */
    uint32_t flags; /* NICOL_FILE_BAND_LIMITED, NICOL_FILE_PHYSICAL */
    double scale;   /* multiplies radiance or reflectance; 0 to 1e12, default 1 */
    double rotation[9];         /* of light, row-major, default the identity. Coefficients
                                   exactly, images by bilinear interpolation. Of materials: must be the identity */
    nicol_spectrum wavelengths; /* nm, of spectral files: each channel is that of an image which is nearest,
                                   or linear between those of a material. count 0: every wavelength of a
                                   image; red, green and blue of a measured material */
    uint32_t reserved;          /* 0 */
} nicol_file_options;
/* clang-format off */
#define NICOL_FILE_OPTIONS_INIT                                                             \
    { sizeof(nicol_file_options), NICOL_FILE_ORDER_AUTOMATIC, 0, 0, 0, 0, 1,                \
      {1, 0, 0, 0, 1, 0, 0, 0, 1}, NICOL_SPECTRUM_INIT, 0 }
/* clang-format on */

/* What a light is, by channel; means and parts are over the sphere by solid angle, of the image that would
 * be written. */
typedef struct nicol_light_report {
    uint32_t struct_size;
    nicol_file_kind kind;
    uint32_t channels;
    uint32_t order; /* up to which the energies go */
    uint32_t width; /* of the image */
    uint32_t height;
    uint32_t polarized;                       /* 1 where some s1, s2 or s3 is not zero */
    uint32_t circular;                        /* 1 where some s3 is not zero */
    double wavelengths[NICOL_MAX_CHANNELS];   /* nm; 0: the channels are colours */
    double mean[NICOL_MAX_CHANNELS];          /* of s0 */
    double smallest[NICOL_MAX_CHANNELS];      /* of s0 */
    double largest[NICOL_MAX_CHANNELS];       /* of s0 */
    double direction[3 * NICOL_MAX_CHANNELS]; /* mean of the directions light comes from, weighted by s0 > 0:
                                                 of length 0 (evenly) to 1 (from one point) */
    double mean_dolp[NICOL_MAX_CHANNELS];     /* degree of linear polarization, weighted by s0 */
    double largest_dolp[NICOL_MAX_CHANNELS];  /* where s0 > 0 */
    double largest_circular[NICOL_MAX_CHANNELS]; /* |s3| / s0 where s0 > 0 */
    double unphysical[NICOL_MAX_CHANNELS]; /* part of the sphere that violates Eq. 70 by more than 1e-5 s0 */
    double largest_excess[NICOL_MAX_CHANNELS]; /* of sqrt(s1^2 + s2^2 + s3^2) - s0 there, over the mean s0 */
} nicol_light_report;
#define NICOL_LIGHT_REPORT_INIT                                                                         \
    {                                                                                                   \
        sizeof(nicol_light_report), 0, 0, 0, 0, 0, 0, 0, {0}, {0}, {0}, {0}, {0}, {0}, {0}, {0}, {0}, { \
            0                                                                                           \
        }                                                                                               \
    }

/* What a material is, by channel, as far as coefficients up to `order` describe it. */
typedef struct nicol_material_report {
    uint32_t struct_size;
    nicol_file_kind kind;
    uint32_t channels;
    uint32_t order;                /* of the values below */
    uint32_t file_order;           /* of the file's own coefficients or table; 0 of measured ones */
    uint32_t stokes_columns;       /* 4; of a table for unpolarized light 1, for linearly polarized light 3 */
    uint32_t measured_wavelengths; /* of a measured material, else 0 */
    uint32_t reserved;
    double measured_range[2];                  /* nm: the first and the last of them */
    double wavelengths[NICOL_MAX_CHANNELS];    /* nm; 0: the channels are colours */
    double albedo[NICOL_MAX_CHANNELS];         /* reflected part of unpolarized light that falls in evenly */
    double largest_albedo[NICOL_MAX_CHANNELS]; /* of light from one direction, the worst up to 75 degrees from
                                                  the normal and the worst polarization; above 1 energy
                                                  appears, the material is not passive */
    double norms[9 * NICOL_MAX_CHANNELS];  /* [channel][out][in]: Frobenius norms of the parts of the matrix
                                              between the groups s0, (s1, s2), s3 */
    double asymmetry[NICOL_MAX_CHANNELS];  /* norm of what breaks mirror symmetry, over that of all: errors of
                                              a measurement, mostly. It can be left out when the material is
                                              loaded (symmetrize) */
    double unphysical[NICOL_MAX_CHANNELS]; /* part of all pairs of directions, by projected solid angle, where
                                              some fully polarized light leaves with sqrt(s1^2 + s2^2 + s3^2)
                                              above s0 by more than 0.001 of the mean M00 */
    double excess[NICOL_MAX_CHANNELS];     /* the mean of that over all pairs, over the mean M00 */
} nicol_material_report;
#define NICOL_MATERIAL_REPORT_INIT                                                               \
    {                                                                                            \
        sizeof(nicol_material_report), 0, 0, 0, 0, 0, 0, 0, {0}, {0}, {0}, {0}, {0}, {0}, {0}, { \
            0                                                                                    \
        }                                                                                        \
    }

/* By suffix and headers alone: NICOL_ERROR_UNSUPPORTED for a suffix or an archive of another kind, and
 * the file may yet prove damaged. */
NICOL_API nicol_result nicol_file_identify(const char* path, nicol_file_kind* kind);
/* options may be NULL. energy, which may be NULL with count 0, has room for count doubles and gets
 * [channel][l][p], 4 (order + 1) a channel: squares of the coefficients summed over m. Scale and rotation
 * change the report as they would an output; what concerns images to write must be 0; the order limits the
 * energies of an image, and all of coefficients. An image that violates Eq. 70 is described, though it is
 * refused as a light. */
NICOL_API nicol_result nicol_file_describe_light(const char* path, const nicol_file_options* options,
                                                 nicol_light_report* report, double* energy, uint64_t count);
/* energy: [channel][l], order + 1 a channel: squares of the matrix' entries between orders of which the
 * larger is l. */
NICOL_API nicol_result nicol_file_describe_material(const char* path, const nicol_file_options* options,
                                                    nicol_material_report* report, double* energy,
                                                    uint64_t count);
/* Reads `in` and writes `out` in the kind that its name says: .exr, _s0.exr (all four files), .npz or a cache
 * folder. Light becomes light and a material a material. options may be NULL. */
NICOL_API nicol_result nicol_file_convert(const char* in, const nicol_file_options* options, const char* out);
/* The same from objects; options without wavelengths. */
NICOL_API nicol_result nicol_environment_write(nicol_environment environment,
                                               const nicol_file_options* options, const char* path);
NICOL_API nicol_result nicol_material_write(nicol_material material, const nicol_file_options* options,
                                            const char* path);
/* Coefficients of 1 to NICOL_MAX_CHANNELS vectors as a LIGHT_PSH file. */
NICOL_API nicol_result nicol_psh_write_file(const char* path, uint32_t order, uint64_t vectors,
                                            const double* coefficients, uint64_t count);

#ifdef __cplusplus
}
#endif

#endif
