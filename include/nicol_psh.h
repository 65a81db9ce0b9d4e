/* SPDX-License-Identifier: MIT
 * Nicol: polarized spherical harmonics as plain numbers. */
#ifndef NICOL_PSH_H
#define NICOL_PSH_H

#include "nicol.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- mathematics */

/* clang-format off */
/* Polarized spherical harmonics (PSH) as plain numbers, in double precision. No context is needed. Equation numbers
 * are those of the paper "Spin-Weighted Spherical Harmonics for Polarized Light Transport" (SIGGRAPH 2024) and its
 * supplement.
 *
 *   Fields        Fields are functions of the PROPAGATION direction of the light: light from straight above is at
 *                 theta = pi. Components are measured in the theta-phi frame of the direction (Eq. 79): x = growing
 *                 theta, y = growing phi, z = the direction; on the z axis phi is 0. Angles here are radians.
 *   Coefficients  Coefficients are [vector][l*l + l + m][p], orders l = 0..order, degrees m = -l..l, components
 *                 p = 0..3: 4 (order+1)^2 doubles per vector. p = 0 and 3 are over real harmonics. p = 1, 2 are the real
 *                 and imaginary part of the complex spin-2 coefficient (Eqs. 30 to 34) and do not exist below l = 2:
 *                 outputs have 0 there, and inputs must have 0 or are not read. A colour channel is a vector; a batch of
 *                 vectors shares all set-up.
 *   Matrices      Matrices of operators are [4 * (l*l + l + m) + p of the output][4 * (l*l + l + m) + p of the input],
 *                 row-major, real (Eq. 40). Mueller matrices are 16 doubles, row-major; rotations 9 doubles, row-major.
 *   Lengths       A length follows every pointer, in doubles; any other length than the documented one is refused. A
 *                 length of 0 (no vectors, no directions) does nothing, and its pointer may be NULL. Inputs must be
 *                 finite. Outputs must not overlap inputs unless a comment allows it; then both must be the same memory.
 *   Threads       All functions may run at the same time on any threads. A nicol_psh_transform does one call after
 *                 another.
 */
/* clang-format on */
#define NICOL_PSH_MAX_ORDER 4096
/* Highest order of dense matrices; the scalar factor of a shadow matrix has up to twice this order. */
#define NICOL_PSH_MAX_MATRIX_ORDER 64

/* Projects an image to coefficients, one vector per channel, in the world's axes. The image is the bilinear
 * function between its pixels and, as an environment, must be physically realizable: polarization up to s0.
 * Returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2. */
NICOL_API nicol_result nicol_psh_project_image(const nicol_image* image, uint32_t order, double* coefficients,
                                               uint64_t count);
/* Projects an environment to coefficients, one vector per channel, in the world's axes. Returns
 * NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2. */
NICOL_API nicol_result nicol_psh_project_environment(nicol_environment environment, uint32_t order,
                                                     double* coefficients, uint64_t count);
/* Projects a file that nicol_environment_load can read to coefficients, one vector per channel, in the
 * world's axes. channels may be NULL; coefficients NULL with count 0 gets only the number of channels.
 * Otherwise returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2. */
NICOL_API nicol_result nicol_psh_project_file(const char* path, uint32_t order, uint32_t* channels,
                                              double* coefficients, uint64_t count);

typedef uint32_t nicol_psh_grid;
#define NICOL_PSH_GRID_FEJER 0u           /* theta = (j + 1/2) pi / rows: pixel centres */
#define NICOL_PSH_GRID_CLENSHAW_CURTIS 1u /* theta = j pi / (rows - 1): both poles are rows */
#define NICOL_PSH_GRID_GAUSS_LEGENDRE 2u  /* cos theta at the roots of the Legendre polynomial */

typedef struct nicol_psh_sampling {
    uint32_t struct_size;
    nicol_psh_grid grid;
    uint32_t order; /* highest order, 0 to NICOL_PSH_MAX_ORDER; the default 0 is order 0 */
    /* Number of rows, at most 32768 (Gauss-Legendre: 16384). 0, the default: the fewest rows that are exact
     * for fields of this order: 2 order + 1, or order + 1 with Gauss-Legendre, and at least 2 with
     * Clenshaw-Curtis. */
    uint32_t rows;
    /* Number of columns, 2 order + 1 to 131072, at the azimuths phi0 + 2 pi c / columns. 0, the default: 2
     * order + 1. */
    uint32_t columns;
    uint32_t reserved; /* 0 */
    double phi0;       /* azimuth of column 0, radians, finite, default 0 */
} nicol_psh_sampling;
#define NICOL_PSH_SAMPLING_INIT \
    { sizeof(nicol_psh_sampling), 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_psh_sampling_init(nicol_psh_sampling* descriptor, uint32_t struct_size);

/* Transform between samples [vector][row][column][4], north to south, and coefficients, in O(order^3). The
 * transform needs no context and holds its work space: no call allocates after creation. Calls on one
 * transform are serialised. */
typedef struct nicol_psh_transform_impl* nicol_psh_transform;

/* Creates a transform. Returns NICOL_ERROR_INVALID_ARGUMENT if the sampling is too coarse for the
 * order. */
NICOL_API nicol_result nicol_psh_transform_create(const nicol_psh_sampling* sampling,
                                                  nicol_psh_transform* transform);
NICOL_API nicol_result nicol_psh_transform_retain(nicol_psh_transform transform);
NICOL_API nicol_result nicol_psh_transform_release(nicol_psh_transform transform);
/* Gets the numbers of rows and columns of the transform's grid. */
NICOL_API nicol_result nicol_psh_transform_get_size(nicol_psh_transform transform, uint32_t* rows,
                                                    uint32_t* columns);
/* Gets theta of each row, and the rows' weights for the integral over cos theta, which sum to 2;
 * count = rows. */
NICOL_API nicol_result nicol_psh_transform_get_rows(nicol_psh_transform transform, double* theta,
                                                    double* weight, uint64_t count);
/* Computes coefficients from samples: inner products with the basis (Eq. 32) by the rows' weights. */
NICOL_API nicol_result nicol_psh_analyze(nicol_psh_transform transform, uint64_t vectors,
                                         const double* samples, uint64_t sample_count, double* coefficients,
                                         uint64_t coefficient_count);
/* Computes samples from coefficients: the field of the coefficients (Eq. 30) at the grid. */
NICOL_API nicol_result nicol_psh_synthesize(nicol_psh_transform transform, uint64_t vectors,
                                            const double* coefficients, uint64_t coefficient_count,
                                            double* samples, uint64_t sample_count);

/* Computes Stokes vectors [vector][direction][4] at directions [direction][3] of any length but 0. */
NICOL_API nicol_result nicol_psh_evaluate(uint32_t order, uint64_t vectors, const double* coefficients,
                                          uint64_t coefficient_count, const double* directions,
                                          uint64_t direction_count, double* stokes, uint64_t stokes_count);

/* Rotates fields: (R f)(w) = R f(R^-1 w) (Eqs. 25, 36). The rotation must be orthonormal to 1e-5 and
 * right-handed. out may be in. */
NICOL_API nicol_result nicol_psh_rotate(uint32_t order, uint64_t vectors, const double* in, uint64_t in_count,
                                        const double rotation[9], double* out, uint64_t out_count);

/* Mirrors fields in the plane z = 0 (Eq. 214, with its conjugation). out may be in. */
NICOL_API nicol_result nicol_psh_reflect(uint32_t order, uint64_t vectors, const double* in,
                                         uint64_t in_count, double* out, uint64_t out_count);

/* Multiplies each field by a scalar field, (scalar_order+1)^2 coefficients over real harmonics, such as
 * visibility, and cuts the product above order_out. The product is exact, through a grid, in O(order^3). out
 * may be in if the orders agree. */
NICOL_API nicol_result nicol_psh_multiply(uint32_t scalar_order, const double* scalar, uint64_t scalar_count,
                                          uint32_t order, uint64_t vectors, const double* in,
                                          uint64_t in_count, uint32_t order_out, double* out,
                                          uint64_t out_count);

/* Computes the matrix of nicol_psh_multiply for a scalar field (Eq. 54, by the triple products of Eqs. 215
 * and 216). */
NICOL_API nicol_result nicol_psh_shadow_matrix(uint32_t scalar_order, const double* scalar,
                                               uint64_t scalar_count, uint32_t order_out, uint32_t order_in,
                                               double* matrix, uint64_t matrix_count);

/* Writes the Mueller matrix from the theta-phi frame of the propagation direction `in` to that of `out`,
 * cosine factors included (Eq. 38). Returns 1 to continue, or 0 to stop with NICOL_ERROR_CANCELLED. The
 * function is called on the calling thread, and may call Nicol. */
typedef int32_t (*nicol_psh_mueller_callback)(void* user, const double in[3], const double out[3],
                                              double mueller[16]);

typedef struct nicol_psh_mueller_field {
    uint32_t struct_size;
    /* 1: the field depends on the azimuths only by their difference, as an isotropic pBRDF in its surface's
     * frame does; `out` is then sampled at azimuth 0 only. 0, the default: any field. */
    uint32_t isotropic;
    uint32_t order_out, order_in;
    /* Numbers of Gauss-Legendre rows and even columns at which the field is sampled, for each of the two
     * directions, at most 4096. 0, the default: 2 order + 2 rows and 4 order + 4 columns, exact for fields up
     * to three times the order. */
    uint32_t rows_out, columns_out;
    uint32_t rows_in, columns_in;
    nicol_psh_mueller_callback callback;
    void* user;
} nicol_psh_mueller_field;
#define NICOL_PSH_MUELLER_FIELD_INIT \
    { sizeof(nicol_psh_mueller_field), 0, 0, 0, 0, 0, 0, 0, 0, 0 }
NICOL_API nicol_result nicol_psh_mueller_field_init(nicol_psh_mueller_field* descriptor,
                                                    uint32_t struct_size);

/* Computes the matrix of the operator "integrate the field times the light over the incoming directions"
 * (Eqs. 39, 40), by quadrature. */
NICOL_API nicol_result nicol_psh_project_matrix(const nicol_psh_mueller_field* field, double* matrix,
                                                uint64_t matrix_count);
/* Computes out = matrix * in, vector by vector (Eq. 41). */
NICOL_API nicol_result nicol_psh_apply_matrix(uint32_t order_out, uint32_t order_in, const double* matrix,
                                              uint64_t matrix_count, uint64_t vectors, const double* in,
                                              uint64_t in_count, double* out, uint64_t out_count);
/* Computes the matrix of `second` after `first`. */
NICOL_API nicol_result nicol_psh_compose_matrix(uint32_t order_out, uint32_t order_between, uint32_t order_in,
                                                const double* second, uint64_t second_count,
                                                const double* first, uint64_t first_count, double* matrix,
                                                uint64_t matrix_count);

/* Size of a band of a convolution kernel. Kernels are [band l = 0..order][16], 16 (order+1) doubles. A band
 * is k00, k03, k30, k33, then the real and imaginary parts of k10 + i k20, k13 + i k23, k01 - i k02,
 * k31 - i k32, and of the isomorphic and the conjugation part of the 2-to-2 block (Eqs. 44, 68). All but the
 * first four are 0 below l = 2. */
#define NICOL_PSH_BAND_SIZE 16

/* Writes the Mueller matrix at the angle theta between input and output direction. Both frames have x along
 * the great circle, from input to output (Eq. 62). Returns 1 to continue, or 0 to stop with
 * NICOL_ERROR_CANCELLED. The function is called on the calling thread, and may call Nicol. */
typedef int32_t (*nicol_psh_kernel_callback)(void* user, double theta, double mueller[16]);

/* Computes the bands of a kernel by quadrature (Eq. 68). rows is the number of Gauss-Legendre rows, at most
 * 16384; 0: 2 order + 2. */
NICOL_API nicol_result nicol_psh_project_kernel(nicol_psh_kernel_callback callback, void* user,
                                                uint32_t order, uint32_t rows, double* bands,
                                                uint64_t band_count);
/* Computes Mueller matrices [angle][16] of a kernel at angles in 0 to pi, the inverse of
 * nicol_psh_project_kernel. */
NICOL_API nicol_result nicol_psh_kernel_at(uint32_t order, const double* bands, uint64_t band_count,
                                           const double* theta, uint64_t theta_count, double* mueller,
                                           uint64_t mueller_count);
/* Convolves each field with a kernel (Eq. 69). out may be in. */
NICOL_API nicol_result nicol_psh_convolve(uint32_t order, const double* bands, uint64_t band_count,
                                          uint64_t vectors, const double* in, uint64_t in_count, double* out,
                                          uint64_t out_count);
/* Computes the matrix of a convolution (supplement E.9); both sides of the matrix have this order. */
NICOL_API nicol_result nicol_psh_kernel_matrix(uint32_t order, const double* bands, uint64_t band_count,
                                               double* matrix, uint64_t matrix_count);
/* Computes the kernel nearest to a matrix in the Frobenius norm (supplement E.9); both sides of the matrix
 * have this order. */
NICOL_API nicol_result nicol_psh_nearest_kernel(uint32_t order, const double* matrix, uint64_t matrix_count,
                                                double* bands, uint64_t band_count);

#ifdef __cplusplus
}
#endif

#endif
