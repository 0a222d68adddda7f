/*
 * eliminant.h: solvers of polynomial problems, as C functions.
 *
 * Written by eliminant-capi-generator 0.1.0. Do not edit.
 *
 * Data are numbers in the order of the problem file, arrays row by row, each list with its length,
 * which must be the one that is documented (`.._LENGTH`). Solutions are rows of numbers. All memory
 * is the caller's, and the functions keep none of it. They may be called from several threads.
 *
 * `.._solve` writes at most `capacity` rows, and their number to `count`. Room for MAX_SOLUTIONS
 * rows always suffices. If there are more solutions than room, the code is ELIMINANT_SHORT_BUFFER,
 * and `count` their number. No solution is no error: `count` is then 0.
 *
 * `.._solve_with` is `.._solve` with a bound on second attempts. They are made at twice the
 * precision where solutions are missing, and take some twenty times as long. `second_attempts` is
 * ELIMINANT_ALWAYS, as in `.._solve`, ELIMINANT_NEVER, or the most operations that a second attempt may
 * have; `.._second_attempt_operations` returns how many it has. Where none is made, solutions that
 * only it would find are missing, and an elimination that fails is an error.
 *
 * `.._relative_residual` and `.._error_bound` measure a solution, a row of unknowns, and write a
 * number. The first is the largest |f| / (sum of the moduli of the terms of f) of all equations
 * f = 0. The second bounds the error of a solution, relative to its largest unknown; it is infinite
 * if no solution is known to be near.
 *
 * `.._solve_batch` solves many instances. Each list of data holds those of all instances, one after
 * another, and numbers are lists, too. `solutions` has room for MAX_SOLUTIONS rows for each
 * instance, and is as long as `solutions_length` says or longer; rows without a solution are NaN.
 * `counts` and `codes` have room for a number for each instance. What the function returns says
 * whether the buffers fit; if they do not, nothing is written.
 *
 * `.._for_NAME` returns results that the problem states, such as poses, in place of unknowns.
 *
 * `.._mean_NAME` computes data that are means over measurements: each list holds those of all
 * measurements, one after another. Without any the mean is NaN.
 *
 * Buffers for results may overlap neither each other nor data.
 */
#ifndef ELIMINANT_H
#define ELIMINANT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* All went well. */
#define ELIMINANT_OK 0
/* A pointer is null, and numbers had to be read or written there. */
#define ELIMINANT_NULL_POINTER 1
/* A pointer is not a multiple of the alignment of what it points to. */
#define ELIMINANT_MISALIGNED_POINTER 2
/* A list of data has another length than is documented. */
#define ELIMINANT_WRONG_LENGTH 3
/* There are more solutions than there is room for. */
#define ELIMINANT_SHORT_BUFFER 4
/* The data hold an infinite value or a NaN. */
#define ELIMINANT_NON_FINITE_INPUT 5
/* Degenerate data: the elimination lost rank. */
#define ELIMINANT_DEGENERATE 6
/* Degenerate data: a matrix from which data are derived has lost rank. */
#define ELIMINANT_LOST_RANK 7
/* A number computed from the data is not finite. */
#define ELIMINANT_OVERFLOW 8
/* The problem needs larger arrays than are set aside. */
#define ELIMINANT_TOO_LARGE 9
/* The eigenvalue iteration reached its limit. */
#define ELIMINANT_NO_CONVERGENCE 10
/* The solver panicked, which is an error of the library. */
#define ELIMINANT_PANIC 11
/* An error that this version does not know. */
#define ELIMINANT_OTHER 12

/* Second attempts wherever solutions are missing, and paths from data nearby. */
#define ELIMINANT_ALWAYS UINT64_MAX
/* No second attempts. */
#define ELIMINANT_NEVER 0

/* The version that wrote this header. */
#define ELIMINANT_VERSION "0.1.0"

/* A sentence in English for a code, for any other number, too. It lives as long as the library. */
const char *eliminant_error_text(int32_t code);

/* The version of the library, as ELIMINANT_VERSION is that of the header. */
const char *eliminant_version(void);

/*
 * calibration_6_receivers_4_senders
 *
 * Positions of six receivers and four senders from all ranges between them: 38 solutions, of which
 * those that can be placed in space are returned.
 *
 * Kuang, Burgess, Torstensson, Åström, "A complete characterization and solution to the microphone
 * position self-calibration problem", ICASSP 2013. Published as `toa_46`.
 *
 * `ranges[i][j]` is the distance between receiver i and sender j. Relative to one of the senders,
 * which is called the first, let G be the Gram matrix of the other three and K its inverse, [k11 v
 * w; v k22 x; w x y]. A receiver with the squares r of its range to the first sender and s of
 * those to the others satisfies 4 r = c K c + 2 c g + a with c_j = r - s_j, g = K n, a = n K n and
 * n = diag(G). Six receivers give k11, k22, g and a as combinations of v, w, x, y and 1. How well
 * depends on which sender is the first and which the last: the best of 12 choices is taken. With C
 * = adj(K) and z = det(K), n is diag(C) / z. M = [K g; g a] is K times [1 n] from both sides: its
 * adjugate is z times the square of (n, -1).
 *
 * Positions are known up to a motion and a mirror: the first of the senders is returned as the
 * origin, another one on the x axis, and the third in the plane of x and y.
 *
 * Data: ranges[6][4].
 * A row of 5 numbers, the unknowns: v, w, x, y, z.
 * A row of 30 numbers, the result positions: senders[4][3], receivers[6][3].
 */
#define ELIMINANT_CALIBRATION_6_RECEIVERS_4_SENDERS_RANGES_LENGTH 24
#define ELIMINANT_CALIBRATION_6_RECEIVERS_4_SENDERS_UNKNOWNS 5
#define ELIMINANT_CALIBRATION_6_RECEIVERS_4_SENDERS_LENGTH_OF_POSITIONS 30
#define ELIMINANT_CALIBRATION_6_RECEIVERS_4_SENDERS_MAX_SOLUTIONS 38
int32_t eliminant_calibration_6_receivers_4_senders_solve(
    const double *ranges, size_t ranges_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_calibration_6_receivers_4_senders_solve_with(
    uint64_t second_attempts, const double *ranges, size_t ranges_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_calibration_6_receivers_4_senders_solve_batch(
    size_t instances, const double *ranges, size_t ranges_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_calibration_6_receivers_4_senders_solve_for_positions(
    const double *ranges, size_t ranges_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_calibration_6_receivers_4_senders_solve_with_for_positions(
    uint64_t second_attempts, const double *ranges, size_t ranges_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_calibration_6_receivers_4_senders_solve_batch_for_positions(
    size_t instances, const double *ranges, size_t ranges_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_calibration_6_receivers_4_senders_relative_residual(
    const double *ranges, size_t ranges_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_calibration_6_receivers_4_senders_error_bound(
    const double *ranges, size_t ranges_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_calibration_6_receivers_4_senders_second_attempt_operations(void);

/*
 * circle_least_squares
 *
 * Circle tangent to n lines in the least-squares sense: the stationary points of the constrained
 * dual conic, 9 solutions.
 *
 * Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", eq. (23)-(26): the
 * Lagrangian as printed.
 *
 * `gram` is the mean over all lines l = (a, b, c) of r r^T with r = (a^2, ab, ac, b^2, bc, c^2).
 * The dual conic is [d1 d2 d3; d2 d4 d5; d3 d5 -1]: a circle with centre (-d3, -d5) and squared
 * radius d1 + d3^2 = d4 + d5^2, which is negative at some stationary points. The cost is the mean
 * of (l^T D l)^2.
 *
 * Data: gram[6][6] (symmetric: the result of `mean_of_line`).
 * A row of 7 numbers, the unknowns: d1, d2, d3, d4, d5, lambda1, lambda2.
 * A row of 4 numbers, the result circle: centre[2], squared_radius, cost.
 */
#define ELIMINANT_CIRCLE_LEAST_SQUARES_GRAM_LENGTH 36
#define ELIMINANT_CIRCLE_LEAST_SQUARES_UNKNOWNS 7
#define ELIMINANT_CIRCLE_LEAST_SQUARES_LENGTH_OF_CIRCLE 4
#define ELIMINANT_CIRCLE_LEAST_SQUARES_MAX_SOLUTIONS 9
int32_t eliminant_circle_least_squares_solve(
    const double *gram, size_t gram_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_solve_with(
    uint64_t second_attempts, const double *gram, size_t gram_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_solve_batch(
    size_t instances, const double *gram, size_t gram_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_circle_least_squares_solve_for_circle(
    const double *gram, size_t gram_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_solve_with_for_circle(
    uint64_t second_attempts, const double *gram, size_t gram_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_solve_batch_for_circle(
    size_t instances, const double *gram, size_t gram_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_circle_least_squares_relative_residual(
    const double *gram, size_t gram_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_circle_least_squares_error_bound(
    const double *gram, size_t gram_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_circle_least_squares_second_attempt_operations(void);
/*
 * What a line a x + b y + c = 0 gives.
 * Mean mean[6][6] over measurements of: line[3].
 */
int32_t eliminant_circle_least_squares_mean_of_line(
    size_t measurements, const double *line, size_t line_length, double *mean, size_t mean_length);

/*
 * circle_least_squares_dual
 *
 * Circle tangent to n lines in the least-squares sense, in three unknowns of the dual conic, 9
 * solutions.
 *
 * Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation": the two constraints give d1
 * and d2, which leaves the cost as a polynomial in d3, d4, d5. Data and conic are those of
 * `circle_least_squares`.
 *
 * Data: gram[6][6] (symmetric: the result of `mean_of_line`).
 * A row of 3 numbers, the unknowns: d3, d4, d5.
 * A row of 4 numbers, the result circle: centre[2], squared_radius, cost.
 */
#define ELIMINANT_CIRCLE_LEAST_SQUARES_DUAL_GRAM_LENGTH 36
#define ELIMINANT_CIRCLE_LEAST_SQUARES_DUAL_UNKNOWNS 3
#define ELIMINANT_CIRCLE_LEAST_SQUARES_DUAL_LENGTH_OF_CIRCLE 4
#define ELIMINANT_CIRCLE_LEAST_SQUARES_DUAL_MAX_SOLUTIONS 9
int32_t eliminant_circle_least_squares_dual_solve(
    const double *gram, size_t gram_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_dual_solve_with(
    uint64_t second_attempts, const double *gram, size_t gram_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_dual_solve_batch(
    size_t instances, const double *gram, size_t gram_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_circle_least_squares_dual_solve_for_circle(
    const double *gram, size_t gram_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_dual_solve_with_for_circle(
    uint64_t second_attempts, const double *gram, size_t gram_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_circle_least_squares_dual_solve_batch_for_circle(
    size_t instances, const double *gram, size_t gram_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_circle_least_squares_dual_relative_residual(
    const double *gram, size_t gram_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_circle_least_squares_dual_error_bound(
    const double *gram, size_t gram_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_circle_least_squares_dual_second_attempt_operations(void);
/*
 * What a line a x + b y + c = 0 gives.
 * Mean mean[6][6] over measurements of: line[3].
 */
int32_t eliminant_circle_least_squares_dual_mean_of_line(
    size_t measurements, const double *line, size_t line_length, double *mean, size_t mean_length);

/*
 * circle_minimal
 *
 * The circles tangent to three lines: 4 solutions (the incircle and the three excircles of the
 * triangle).
 *
 * Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", the minimal three-line
 * solver.
 *
 * A line l = (a, b, c) is tangent to the circle with dual conic D = [d1 d2 d3; d2 d4 d5; d3 d5 d6]
 * if l^T D l = 0: one linear equation in d = (d1, .., d6), (a^2, 2ab, 2ac, b^2, 2bc, c^2) d = 0.
 * Three lines leave a null space of dimension three, d = a d_alpha + b d_beta + d_gamma, in which
 * the two constraints of a circle, d2 d6 = d3 d5 and (d1 - d4) d6 = d3^2 - d5^2, pick four points.
 *
 * Data: d_alpha[6], d_beta[6], d_gamma[6].
 * A row of 2 numbers, the unknowns: a, b.
 */
#define ELIMINANT_CIRCLE_MINIMAL_D_ALPHA_LENGTH 6
#define ELIMINANT_CIRCLE_MINIMAL_D_BETA_LENGTH 6
#define ELIMINANT_CIRCLE_MINIMAL_D_GAMMA_LENGTH 6
#define ELIMINANT_CIRCLE_MINIMAL_UNKNOWNS 2
#define ELIMINANT_CIRCLE_MINIMAL_MAX_SOLUTIONS 4
int32_t eliminant_circle_minimal_solve(
    const double *d_alpha, size_t d_alpha_length, const double *d_beta, size_t d_beta_length,
    const double *d_gamma, size_t d_gamma_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_circle_minimal_solve_with(
    uint64_t second_attempts, const double *d_alpha, size_t d_alpha_length, const double *d_beta,
    size_t d_beta_length, const double *d_gamma, size_t d_gamma_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_circle_minimal_solve_batch(
    size_t instances, const double *d_alpha, size_t d_alpha_length, const double *d_beta,
    size_t d_beta_length, const double *d_gamma, size_t d_gamma_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_circle_minimal_relative_residual(
    const double *d_alpha, size_t d_alpha_length, const double *d_beta, size_t d_beta_length,
    const double *d_gamma, size_t d_gamma_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_circle_minimal_error_bound(
    const double *d_alpha, size_t d_alpha_length, const double *d_beta, size_t d_beta_length,
    const double *d_gamma, size_t d_gamma_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_circle_minimal_second_attempt_operations(void);

/*
 * fundamental_7pt
 *
 * Fundamental matrix of two cameras from seven points: 3 solutions.
 *
 * Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.2.
 *
 * `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
 * `(second[k], 1) . F (first[k], 1) = 0`; it is the sum of the two matrices that span the null
 * space of these equations, each times its weight.
 *
 * Data: first[7][2], second[7][2].
 * A row of 2 numbers, the unknowns: weights[2] (given up to scale: of length 1).
 * A row of 9 numbers, the result epipolar: fundamental[3][3] (given up to scale).
 */
#define ELIMINANT_FUNDAMENTAL_7PT_FIRST_LENGTH 14
#define ELIMINANT_FUNDAMENTAL_7PT_SECOND_LENGTH 14
#define ELIMINANT_FUNDAMENTAL_7PT_UNKNOWNS 2
#define ELIMINANT_FUNDAMENTAL_7PT_LENGTH_OF_EPIPOLAR 9
#define ELIMINANT_FUNDAMENTAL_7PT_MAX_SOLUTIONS 3
int32_t eliminant_fundamental_7pt_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_7pt_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_7pt_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_7pt_solve_for_epipolar(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_7pt_solve_with_for_epipolar(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_7pt_solve_batch_for_epipolar(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_7pt_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_fundamental_7pt_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_fundamental_7pt_second_attempt_operations(void);

/*
 * fundamental_8pt
 *
 * Fundamental matrix of two cameras from eight points: 1 solution.
 *
 * Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.
 *
 * `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
 * `(second[k], 1) . F (first[k], 1) = 0`. It is the sum of the two matrices that span the null
 * space of the first seven of these equations, each times its weight, which the last one gives. Of
 * images with errors F has rank 3; that of seven points, `fundamental_7pt`, has rank 2.
 *
 * Data: first[8][2], second[8][2].
 * A row of 2 numbers, the unknowns: weights[2] (given up to scale: of length 1).
 * A row of 9 numbers, the result epipolar: fundamental[3][3] (given up to scale).
 */
#define ELIMINANT_FUNDAMENTAL_8PT_FIRST_LENGTH 16
#define ELIMINANT_FUNDAMENTAL_8PT_SECOND_LENGTH 16
#define ELIMINANT_FUNDAMENTAL_8PT_UNKNOWNS 2
#define ELIMINANT_FUNDAMENTAL_8PT_LENGTH_OF_EPIPOLAR 9
#define ELIMINANT_FUNDAMENTAL_8PT_MAX_SOLUTIONS 1
int32_t eliminant_fundamental_8pt_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_8pt_solve_for_epipolar(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_solve_with_for_epipolar(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_solve_batch_for_epipolar(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_8pt_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_fundamental_8pt_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_fundamental_8pt_second_attempt_operations(void);

/*
 * fundamental_8pt_radial
 *
 * Fundamental matrix and the radial distortion common to both cameras from eight points: 16
 * solutions.
 *
 * Kukelova, Pajdla, "A minimal solution to the autocalibration of radial distortion", CVPR 2007.
 * Published as `8ptF_radial`, with f33 = 1, which loses planar motions and those without a
 * rotation: f33 is 0.
 *
 * `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
 * distortion. An image x lies along (x, 1 + radial |x|^2), the division model. Then x2^T F x1 = 0
 * is linear in f11, f21, f31, f12, f22, f32, radial f31, radial f32 and the monomials radial f13,
 * radial f23, radial^2 f33, f13, f23, radial f33, f33: eight points give the former as
 * combinations of these. `third` is the third column of F, which is given up to scale. It vanishes
 * where the first camera moves along its optical axis; without a rotation such points tell nothing
 * of the distortion.
 *
 * Data: first[8][2], second[8][2].
 * A row of 4 numbers, the unknowns: radial, third[3] (given up to scale: of length 1).
 * A row of 10 numbers, the result radial_epipolar: fundamental[3][3] (given up to scale), radial.
 */
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_FIRST_LENGTH 16
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_SECOND_LENGTH 16
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_UNKNOWNS 4
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_LENGTH_OF_RADIAL_EPIPOLAR 10
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_MAX_SOLUTIONS 16
int32_t eliminant_fundamental_8pt_radial_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_8pt_radial_solve_for_radial_epipolar(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_solve_with_for_radial_epipolar(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_solve_batch_for_radial_epipolar(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_8pt_radial_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_fundamental_8pt_radial_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_fundamental_8pt_radial_second_attempt_operations(void);

/*
 * fundamental_8pt_radial_one_side
 *
 * Fundamental matrix and radial distortion of the second camera from eight points: 8 solutions.
 *
 * Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
 * distortion", CVPR 2014. Published as `8ptF_radial_1s`, with f33 = 1, which loses planar motions
 * and those without a rotation: f33 is 0.
 *
 * `first[k]` is the image of point k in a camera without distortion, `second[k]` the distorted one
 * in the other, relative to the centre of distortion. There an image x lies along (x, 1 + radial
 * |x|^2), the division model. Then x2^T F x1 = 0 is, with f32 = 1, linear in the first two rows of
 * F, radial f31, radial f32 and in radial f33, f31, 1, f33: eight points give the former as
 * combinations of these. The first image is turned, which turns (f31, f32): for usual motions one
 * of these is 0 if it is not. Both vanish where the second camera moves along its optical axis:
 * then the points tell nothing of the distortion.
 *
 * Data: first[8][2], second[8][2].
 * A row of 3 numbers, the unknowns: f_31, f_33, radial.
 * A row of 10 numbers, the result radial_epipolar: fundamental[3][3] (given up to scale), radial.
 */
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_ONE_SIDE_FIRST_LENGTH 16
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_ONE_SIDE_SECOND_LENGTH 16
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_ONE_SIDE_UNKNOWNS 3
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_ONE_SIDE_LENGTH_OF_RADIAL_EPIPOLAR 10
#define ELIMINANT_FUNDAMENTAL_8PT_RADIAL_ONE_SIDE_MAX_SOLUTIONS 8
int32_t eliminant_fundamental_8pt_radial_one_side_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_one_side_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_one_side_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_8pt_radial_one_side_solve_for_radial_epipolar(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_one_side_solve_with_for_radial_epipolar(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_8pt_radial_one_side_solve_batch_for_radial_epipolar(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_8pt_radial_one_side_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_fundamental_8pt_radial_one_side_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_fundamental_8pt_radial_one_side_second_attempt_operations(void);

/*
 * fundamental_9pt_two_radials
 *
 * Fundamental matrix and the two different radial distortions of two cameras from nine points: 24
 * solutions.
 *
 * Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
 * problems for cameras with radial distortion", CVIU 114, 2010. Published as `rdist9p`, with f33 =
 * 1, which loses planar motions and those without a rotation: f33 is 0.
 *
 * `first[k]` and `second[k]` are the distorted images of point k, relative to the centres of
 * distortion. An image x lies along (x, 1 + radial |x|^2), the division model: with s for `radial`
 * in the second image and t in the first. Then x2^T F x1 = 0 is, with f23 = 1, linear in f11, f12,
 * f21, f22, t f13, t, t f33, s t f33, f13 and in s f31, s f32, s f33, f31, f32, f33, 1: nine
 * points give the former as combinations of these. The second image is turned, which turns (f13,
 * f23): for usual motions one of these is 0 if it is not. Both vanish where the first camera moves
 * along its optical axis; without a rotation such points tell nothing of the distortions.
 *
 * Data: first[9][2], second[9][2].
 * A row of 4 numbers, the unknowns: s, f_31, f_32, f_33.
 * A row of 11 numbers, the result radial_epipolar: fundamental[3][3] (given up to scale),
 *   radials[2].
 */
#define ELIMINANT_FUNDAMENTAL_9PT_TWO_RADIALS_FIRST_LENGTH 18
#define ELIMINANT_FUNDAMENTAL_9PT_TWO_RADIALS_SECOND_LENGTH 18
#define ELIMINANT_FUNDAMENTAL_9PT_TWO_RADIALS_UNKNOWNS 4
#define ELIMINANT_FUNDAMENTAL_9PT_TWO_RADIALS_LENGTH_OF_RADIAL_EPIPOLAR 11
#define ELIMINANT_FUNDAMENTAL_9PT_TWO_RADIALS_MAX_SOLUTIONS 24
int32_t eliminant_fundamental_9pt_two_radials_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_9pt_two_radials_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_9pt_two_radials_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_9pt_two_radials_solve_for_radial_epipolar(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_9pt_two_radials_solve_with_for_radial_epipolar(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_fundamental_9pt_two_radials_solve_batch_for_radial_epipolar(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_fundamental_9pt_two_radials_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_fundamental_9pt_two_radials_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_fundamental_9pt_two_radials_second_attempt_operations(void);

/*
 * homography_4pt
 *
 * Homography of two images of a plane, or of two cameras with one centre, from four points: 1
 * solution.
 *
 * Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 4.1; here by the
 * projective bases of the four points, as Heckbert, "Fundamentals of texture mapping and image
 * warping", 1989.
 *
 * `first[k]` and `second[k]` are the images of point k, in pixels or any other unit; no three of
 * either may lie on a line. The homography H takes (`first[k]`, 1) to a multiple of (`second[k]`,
 * 1): that of point k < 3 is `multiples[k]`. The fourth point is the sum of these three with
 * weights, which are known in both images and proportional when multiplied.
 *
 * Data: first[4][2], second[4][2].
 * A row of 3 numbers, the unknowns: multiples[3] (given up to scale: of length 1).
 * A row of 9 numbers, the result homography: homography[3][3] (given up to scale).
 */
#define ELIMINANT_HOMOGRAPHY_4PT_FIRST_LENGTH 8
#define ELIMINANT_HOMOGRAPHY_4PT_SECOND_LENGTH 8
#define ELIMINANT_HOMOGRAPHY_4PT_UNKNOWNS 3
#define ELIMINANT_HOMOGRAPHY_4PT_LENGTH_OF_HOMOGRAPHY 9
#define ELIMINANT_HOMOGRAPHY_4PT_MAX_SOLUTIONS 1
int32_t eliminant_homography_4pt_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_homography_4pt_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_homography_4pt_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_homography_4pt_solve_for_homography(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_homography_4pt_solve_with_for_homography(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_homography_4pt_solve_batch_for_homography(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_homography_4pt_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_homography_4pt_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_homography_4pt_second_attempt_operations(void);

/*
 * katsura_5
 *
 * Katsura's equations for the magnetic field of a spin glass with six unknowns: 32 solutions.
 * There are no data.
 *
 * Katsura, "Spin glass problem by the method of integral equation of the effective field", in: New
 * Trends in Magnetism, 1990; as in the data base of PHCpack (Verschelde, ACM TOMS 795, 1999).
 * Published as `katsura5`.
 *
 * Data: none.
 * A row of 6 numbers, the unknowns: t, u, v, x, y, z.
 */
#define ELIMINANT_KATSURA_5_UNKNOWNS 6
#define ELIMINANT_KATSURA_5_MAX_SOLUTIONS 32
int32_t eliminant_katsura_5_solve(
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_katsura_5_solve_with(
    uint64_t second_attempts, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_katsura_5_solve_batch(
    size_t instances, double *solutions, size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_katsura_5_relative_residual(
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_katsura_5_error_bound(
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_katsura_5_second_attempt_operations(void);

/*
 * orbit_5_lines_of_sight
 *
 * Keplerian orbit from five lines of sight without times: 66 solutions.
 *
 * Mancini, Duff, Leykin, Christian, "Geometric solution to the angles-only initial orbit
 * determination problem", 2023; Huang, Leykin, Mancini, "Projective plane subdivision method for
 * initial orbit determination", arXiv 2509.14397, 2025. Published as `IOD`.
 *
 * `sights` holds for each line the position of the observer and the direction; the Sun is the
 * origin. The plane of the orbit has the normal n = (a, b, 1). It meets the line with direction d
 * and moment m in x = n x m / n.d. The orbit is |x| = h - e.x, where e points to the pericentre
 * and has the eccentricity as its length. With w = n x e / h = (-q, p, r), where (p, q, 0) is e /
 * h up to a multiple of n, this is (n.d + w.m)^2 = |n x m|^2 / h^2, and `square` is 1 / h^2. The
 * published unknowns are the entries of the orbit's dual quadric.
 *
 * Returned are the normal of the plane, of length 1, e and h, which is the semi-latus rectum.
 *
 * With directions and moments exchanged these are the cylinders that touch five lines: n is the
 * direction of the axis, w its moment, and `square` that of the radius.
 *
 * Data: sights[5][2][3].
 * A row of 6 numbers, the unknowns: a, b, p, q, r, square.
 * A row of 7 numbers, the result orbit: normal[3], eccentricity[3], semi_latus_rectum.
 */
#define ELIMINANT_ORBIT_5_LINES_OF_SIGHT_SIGHTS_LENGTH 30
#define ELIMINANT_ORBIT_5_LINES_OF_SIGHT_UNKNOWNS 6
#define ELIMINANT_ORBIT_5_LINES_OF_SIGHT_LENGTH_OF_ORBIT 7
#define ELIMINANT_ORBIT_5_LINES_OF_SIGHT_MAX_SOLUTIONS 66
int32_t eliminant_orbit_5_lines_of_sight_solve(
    const double *sights, size_t sights_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_orbit_5_lines_of_sight_solve_with(
    uint64_t second_attempts, const double *sights, size_t sights_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_orbit_5_lines_of_sight_solve_batch(
    size_t instances, const double *sights, size_t sights_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_orbit_5_lines_of_sight_solve_for_orbit(
    const double *sights, size_t sights_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_orbit_5_lines_of_sight_solve_with_for_orbit(
    uint64_t second_attempts, const double *sights, size_t sights_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_orbit_5_lines_of_sight_solve_batch_for_orbit(
    size_t instances, const double *sights, size_t sights_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_orbit_5_lines_of_sight_relative_residual(
    const double *sights, size_t sights_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_orbit_5_lines_of_sight_error_bound(
    const double *sights, size_t sights_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_orbit_5_lines_of_sight_second_attempt_operations(void);

/*
 * platform_forward_kinematics
 *
 * Forward kinematics of the general Stewart-Gough platform, all poses with given lengths of its
 * six legs: 40 solutions.
 *
 * Husty, "An algorithm for solving the direct kinematics of general Stewart-Gough-type platforms",
 * Mechanism and Machine Theory 31, 1996. Published as `parallel_robot_66`.
 *
 * Leg k joins `base[k]`, in the frame of the base, and `platform[k]`, in that of the platform, and
 * has the length `lengths[k]`. Base or platform may be flat, but not both. Returned is the pose
 * x -> rotation x + translation that takes the platform to the frame of the base.
 *
 * Joints are taken relative to those of the first leg. Let t be that leg in the base's
 * coordinates, s = R^T t in the platform's. The length of the leg from X to x, less that of the
 * first, gives x s - X t as a linear combination of the entries of R and 1: five equations for s
 * and t. The null vector of these has a part p of s and a part q of t, and the longer one is p,
 * else base and platform are exchanged. Both are turned so that p and q are along their third
 * axes. R is that of the quaternion 1 + a i + b j + c k, so n s and n t, with n = 1 + a a + b b +
 * c c, are quadratic polynomials: `sums` has the coefficients of n (s_i + t_i), `differences`
 * those of n (s_i - t_i), for i = 1, 2, and s_3 + t_3 = `ratio` (s_3 - t_3) + `shift`.
 *
 * That t q = q s gives n (s_3 - t_3) times 1, a, b and c as cubic polynomials, and that |s| = |t|
 * its square: with these |t|^2 = `square` and its product with n (s_3 - t_3) have degrees of four
 * and six.
 *
 * Data: base[6][3], platform[6][3], lengths[6].
 * A row of 3 numbers, the unknowns: a, b, c.
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_PLATFORM_FORWARD_KINEMATICS_BASE_LENGTH 18
#define ELIMINANT_PLATFORM_FORWARD_KINEMATICS_PLATFORM_LENGTH 18
#define ELIMINANT_PLATFORM_FORWARD_KINEMATICS_LENGTHS_LENGTH 6
#define ELIMINANT_PLATFORM_FORWARD_KINEMATICS_UNKNOWNS 3
#define ELIMINANT_PLATFORM_FORWARD_KINEMATICS_LENGTH_OF_POSE 12
#define ELIMINANT_PLATFORM_FORWARD_KINEMATICS_MAX_SOLUTIONS 40
int32_t eliminant_platform_forward_kinematics_solve(
    const double *base, size_t base_length, const double *platform, size_t platform_length,
    const double *lengths, size_t lengths_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_platform_forward_kinematics_solve_with(
    uint64_t second_attempts, const double *base, size_t base_length, const double *platform,
    size_t platform_length, const double *lengths, size_t lengths_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_platform_forward_kinematics_solve_batch(
    size_t instances, const double *base, size_t base_length, const double *platform,
    size_t platform_length, const double *lengths, size_t lengths_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_platform_forward_kinematics_solve_for_pose(
    const double *base, size_t base_length, const double *platform, size_t platform_length,
    const double *lengths, size_t lengths_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_platform_forward_kinematics_solve_with_for_pose(
    uint64_t second_attempts, const double *base, size_t base_length, const double *platform,
    size_t platform_length, const double *lengths, size_t lengths_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_platform_forward_kinematics_solve_batch_for_pose(
    size_t instances, const double *base, size_t base_length, const double *platform,
    size_t platform_length, const double *lengths, size_t lengths_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_platform_forward_kinematics_relative_residual(
    const double *base, size_t base_length, const double *platform, size_t platform_length,
    const double *lengths, size_t lengths_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_platform_forward_kinematics_error_bound(
    const double *base, size_t base_length, const double *platform, size_t platform_length,
    const double *lengths, size_t lengths_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_platform_forward_kinematics_second_attempt_operations(void);

/*
 * pose_1pt_2line
 *
 * Pose of a calibrated camera from a point and two lines: 8 solutions, of which those with the
 * point in front of the camera are returned.
 *
 * Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
 * ICRA 2011; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose estimation for minimal
 * configurations of 2D/3D point and line correspondences", ACCV 2018.
 *
 * `ray` is the ray of the point in the camera, of any length, and `point` its position.
 * `normals[k]` is the image of line k: the plane through it and the centre of the camera is
 * perpendicular to that vector, of any length. It is the cross product of the rays of two points
 * of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
 * if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
 * `quaternion` is that of the rotation. The depth of the point along its ray is eliminated.
 *
 * Data: ray[3], point[3], normals[2][3], lines[2][2][3].
 * A row of 4 numbers, the unknowns: quaternion[4] (given up to scale: of length 1).
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_1PT_2LINE_RAY_LENGTH 3
#define ELIMINANT_POSE_1PT_2LINE_POINT_LENGTH 3
#define ELIMINANT_POSE_1PT_2LINE_NORMALS_LENGTH 6
#define ELIMINANT_POSE_1PT_2LINE_LINES_LENGTH 12
#define ELIMINANT_POSE_1PT_2LINE_UNKNOWNS 4
#define ELIMINANT_POSE_1PT_2LINE_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_1PT_2LINE_MAX_SOLUTIONS 8
int32_t eliminant_pose_1pt_2line_solve(
    const double *ray, size_t ray_length, const double *point, size_t point_length,
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_1pt_2line_solve_with(
    uint64_t second_attempts, const double *ray, size_t ray_length, const double *point,
    size_t point_length, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_1pt_2line_solve_batch(
    size_t instances, const double *ray, size_t ray_length, const double *point,
    size_t point_length, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_1pt_2line_solve_for_pose(
    const double *ray, size_t ray_length, const double *point, size_t point_length,
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_1pt_2line_solve_with_for_pose(
    uint64_t second_attempts, const double *ray, size_t ray_length, const double *point,
    size_t point_length, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_1pt_2line_solve_batch_for_pose(
    size_t instances, const double *ray, size_t ray_length, const double *point,
    size_t point_length, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_1pt_2line_relative_residual(
    const double *ray, size_t ray_length, const double *point, size_t point_length,
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_1pt_2line_error_bound(
    const double *ray, size_t ray_length, const double *point, size_t point_length,
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_1pt_2line_second_attempt_operations(void);

/*
 * pose_2pt_1line
 *
 * Pose of a calibrated camera from two points and a line: at most 2 solutions, those with the
 * points in front of the camera.
 *
 * Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
 * ICRA 2011, who have 4 solutions, which are 2 with both signs of the depths.
 *
 * `rays[k]` is the ray of point k in the camera, of any length, and `points[k]` its position.
 * `normal` is the image of the line: the plane through it and the centre of the camera is
 * perpendicular to that vector, of any length. It is the cross product of the rays of two points
 * of the image. `line` are two points of the line in space, other ones than the rays are of, if
 * need be. A point X has the coordinates `rotation` X + `translation` in the camera. In the frame
 * of the points the normal is perpendicular to the line: it is the sum of two vectors that are,
 * each times its weight. The depths of the points along their rays are linear in it, since it is
 * perpendicular to the plane, and the distance of the points gives a quadratic equation. The
 * points must not lie on the line, nor their images on its image.
 *
 * Data: rays[2][3], points[2][3], normal[3], line[2][3].
 * A row of 2 numbers, the unknowns: weights[2] (given up to scale: of length 1).
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_2PT_1LINE_RAYS_LENGTH 6
#define ELIMINANT_POSE_2PT_1LINE_POINTS_LENGTH 6
#define ELIMINANT_POSE_2PT_1LINE_NORMAL_LENGTH 3
#define ELIMINANT_POSE_2PT_1LINE_LINE_LENGTH 6
#define ELIMINANT_POSE_2PT_1LINE_UNKNOWNS 2
#define ELIMINANT_POSE_2PT_1LINE_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_2PT_1LINE_MAX_SOLUTIONS 2
int32_t eliminant_pose_2pt_1line_solve(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *normal, size_t normal_length, const double *line, size_t line_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_1line_solve_with(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, const double *normal, size_t normal_length, const double *line,
    size_t line_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_1line_solve_batch(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, const double *normal, size_t normal_length, const double *line,
    size_t line_length, double *solutions, size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_2pt_1line_solve_for_pose(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *normal, size_t normal_length, const double *line, size_t line_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_1line_solve_with_for_pose(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, const double *normal, size_t normal_length, const double *line,
    size_t line_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_1line_solve_batch_for_pose(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, const double *normal, size_t normal_length, const double *line,
    size_t line_length, double *solutions, size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_2pt_1line_relative_residual(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *normal, size_t normal_length, const double *line, size_t line_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_2pt_1line_error_bound(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *normal, size_t normal_length, const double *line, size_t line_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_2pt_1line_second_attempt_operations(void);

/*
 * pose_2pt_upright
 *
 * Pose of a camera whose vertical is known, as by an inertial sensor, from two points: 2
 * solutions.
 *
 * Kukelova, Bujnak, Pajdla, "Closed-form solutions to minimal absolute pose problems with known
 * vertical direction", ACCV 2010; here by the depths, as Haralick, Lee, Ottenberg, Nölle, IJCV
 * 1994, state the pose from three points.
 *
 * `rays[k]` is the ray of point k in a frame of the camera whose y axis is vertical, of any
 * length, and `points[k]` its position in a world with the same vertical. The unknowns are the
 * depths along the rays. A pose X -> rotation X + translation takes the world to the camera; the
 * rotation is about the y axis, and both points are in front. The points must not be above each
 * other, nor both rays level.
 *
 * Data: rays[2][3], points[2][3].
 * A row of 2 numbers, the unknowns: a, b.
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_2PT_UPRIGHT_RAYS_LENGTH 6
#define ELIMINANT_POSE_2PT_UPRIGHT_POINTS_LENGTH 6
#define ELIMINANT_POSE_2PT_UPRIGHT_UNKNOWNS 2
#define ELIMINANT_POSE_2PT_UPRIGHT_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_2PT_UPRIGHT_MAX_SOLUTIONS 2
int32_t eliminant_pose_2pt_upright_solve(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_upright_solve_with(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_upright_solve_batch(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_2pt_upright_solve_for_pose(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_upright_solve_with_for_pose(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_2pt_upright_solve_batch_for_pose(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_2pt_upright_relative_residual(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_2pt_upright_error_bound(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_2pt_upright_second_attempt_operations(void);

/*
 * pose_35pt_focal
 *
 * Pose and focal length of a camera from three points and one image coordinate of a fourth: 10
 * solutions.
 *
 * Wu, "P3.5P: Pose estimation with unknown focal length", CVPR 2015. Published as `pose_35pt`.
 *
 * `points` holds the points, one a row; `horizontal` and `vertical` their image coordinates,
 * centred at the principal point. The rotation is, up to scale, that about the optical axis times
 * that of the quaternion (1, x, y, 0). Each row of the matrix eliminates the rotation about the
 * optical axis, and what is unknown of the focal length, from three points: it annihilates (cos,
 * sin, 1/f). Where the camera looks against the third axis x and y are infinite. Points are turned
 * before, so that this is no direction in which one would look. A point X has the coordinates
 * `rotation` X + `translation` in the camera.
 *
 * Data: points[4][3], horizontal[4], vertical[3].
 * A row of 2 numbers, the unknowns: x, y.
 * A row of 13 numbers, the result pose: rotation[3][3], translation[3], focal.
 */
#define ELIMINANT_POSE_35PT_FOCAL_POINTS_LENGTH 12
#define ELIMINANT_POSE_35PT_FOCAL_HORIZONTAL_LENGTH 4
#define ELIMINANT_POSE_35PT_FOCAL_VERTICAL_LENGTH 3
#define ELIMINANT_POSE_35PT_FOCAL_UNKNOWNS 2
#define ELIMINANT_POSE_35PT_FOCAL_LENGTH_OF_POSE 13
#define ELIMINANT_POSE_35PT_FOCAL_MAX_SOLUTIONS 10
int32_t eliminant_pose_35pt_focal_solve(
    const double *points, size_t points_length, const double *horizontal, size_t horizontal_length,
    const double *vertical, size_t vertical_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_pose_35pt_focal_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *horizontal,
    size_t horizontal_length, const double *vertical, size_t vertical_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_35pt_focal_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *horizontal,
    size_t horizontal_length, const double *vertical, size_t vertical_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_35pt_focal_solve_for_pose(
    const double *points, size_t points_length, const double *horizontal, size_t horizontal_length,
    const double *vertical, size_t vertical_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_pose_35pt_focal_solve_with_for_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *horizontal,
    size_t horizontal_length, const double *vertical, size_t vertical_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_35pt_focal_solve_batch_for_pose(
    size_t instances, const double *points, size_t points_length, const double *horizontal,
    size_t horizontal_length, const double *vertical, size_t vertical_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_35pt_focal_relative_residual(
    const double *points, size_t points_length, const double *horizontal, size_t horizontal_length,
    const double *vertical, size_t vertical_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_35pt_focal_error_bound(
    const double *points, size_t points_length, const double *horizontal, size_t horizontal_length,
    const double *vertical, size_t vertical_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_35pt_focal_second_attempt_operations(void);

/*
 * pose_3line
 *
 * Pose of a calibrated camera from three lines: 8 solutions.
 *
 * Dhome, Richetin, Lapresté, Rives, "Determination of the attitude of 3D objects from a single
 * perspective view", PAMI 1989; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose
 * estimation for minimal configurations of 2D/3D point and line correspondences", ACCV 2018.
 *
 * `normals[k]` is the image of line k: the plane through it and the centre of the camera is
 * perpendicular to that vector, of any length. It is the cross product of the rays of two points
 * of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
 * if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
 * `quaternion` is that of the rotation: `normals[k]` is perpendicular to the turned direction of
 * line k. Three planes give the translation. The lines must not be parallel, nor the planes meet
 * in a line.
 *
 * Data: normals[3][3], lines[3][2][3].
 * A row of 4 numbers, the unknowns: quaternion[4] (given up to scale: of length 1).
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_3LINE_NORMALS_LENGTH 9
#define ELIMINANT_POSE_3LINE_LINES_LENGTH 18
#define ELIMINANT_POSE_3LINE_UNKNOWNS 4
#define ELIMINANT_POSE_3LINE_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_3LINE_MAX_SOLUTIONS 8
int32_t eliminant_pose_3line_solve(
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3line_solve_with(
    uint64_t second_attempts, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3line_solve_batch(
    size_t instances, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_3line_solve_for_pose(
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3line_solve_with_for_pose(
    uint64_t second_attempts, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3line_solve_batch_for_pose(
    size_t instances, const double *normals, size_t normals_length, const double *lines,
    size_t lines_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_3line_relative_residual(
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_3line_error_bound(
    const double *normals, size_t normals_length, const double *lines, size_t lines_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_3line_second_attempt_operations(void);

/*
 * pose_3pt
 *
 * Pose of a calibrated camera from three points: at most 4 of 8 solutions, in front of the camera.
 *
 * The problem `pose_3pt_depths` from measurements. `rays[k]` is the ray of point k in the camera,
 * of any length, and `points[k]` its position. The unknowns are the distances of the points from
 * the centre of the camera. A point x has the coordinates `rotation` x + `translation` in the
 * camera: the rotation takes the differences of positions, and their cross product, to those in
 * the camera.
 *
 * Data: rays[3][3], points[3][3].
 * A row of 3 numbers, the unknowns: distances[3].
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_3PT_RAYS_LENGTH 9
#define ELIMINANT_POSE_3PT_POINTS_LENGTH 9
#define ELIMINANT_POSE_3PT_UNKNOWNS 3
#define ELIMINANT_POSE_3PT_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_3PT_MAX_SOLUTIONS 8
int32_t eliminant_pose_3pt_solve(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_solve_with(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_solve_batch(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_3pt_solve_for_pose(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_solve_with_for_pose(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_solve_batch_for_pose(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_3pt_relative_residual(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_3pt_error_bound(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_3pt_second_attempt_operations(void);

/*
 * pose_3pt_depths
 *
 * Pose of a calibrated camera from three points: their distances from the centre of the camera, 8
 * solutions, which are 4 with both signs.
 *
 * Grunert, "Das Pothenotische Problem in erweiterter Gestalt", 1841; in this form Haralick, Lee,
 * Ottenberg, Nölle, "Review and analysis of solutions of the three point perspective pose
 * estimation problem", IJCV 1994, equation (1).
 *
 * `cosines` are those of the angles between the viewing rays of the points b and c, a and c, a and
 * b; `squares` the squared distances of these points. Those of the solutions are poses in which
 * all depths are positive.
 *
 * Data: cosines[3], squares[3].
 * A row of 3 numbers, the unknowns: a, b, c.
 */
#define ELIMINANT_POSE_3PT_DEPTHS_COSINES_LENGTH 3
#define ELIMINANT_POSE_3PT_DEPTHS_SQUARES_LENGTH 3
#define ELIMINANT_POSE_3PT_DEPTHS_UNKNOWNS 3
#define ELIMINANT_POSE_3PT_DEPTHS_MAX_SOLUTIONS 8
int32_t eliminant_pose_3pt_depths_solve(
    const double *cosines, size_t cosines_length, const double *squares, size_t squares_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_depths_solve_with(
    uint64_t second_attempts, const double *cosines, size_t cosines_length, const double *squares,
    size_t squares_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_depths_solve_batch(
    size_t instances, const double *cosines, size_t cosines_length, const double *squares,
    size_t squares_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_3pt_depths_relative_residual(
    const double *cosines, size_t cosines_length, const double *squares, size_t squares_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_3pt_depths_error_bound(
    const double *cosines, size_t cosines_length, const double *squares, size_t squares_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_3pt_depths_second_attempt_operations(void);

/*
 * pose_3pt_upright_error_bound
 *
 * Poses of a camera with known vertical direction in which the errors of three points equal their
 * bounds and are stationary: 48 solutions.
 *
 * Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
 * direction", PAMI 2017. Published as `optpose3pt_v2`. A pose with the largest number of points
 * within the bound can be moved until four errors equal it, or three where it can be moved no
 * further.
 *
 * `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
 * `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
 * turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
 * in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
 * The derivatives of the three left sides by w, y and z are linearly dependent.
 *
 * Data: points[3][3], images[3][2], bound.
 * A row of 5 numbers, the unknowns: u, v, w, y, z.
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_3PT_UPRIGHT_ERROR_BOUND_POINTS_LENGTH 9
#define ELIMINANT_POSE_3PT_UPRIGHT_ERROR_BOUND_IMAGES_LENGTH 6
#define ELIMINANT_POSE_3PT_UPRIGHT_ERROR_BOUND_UNKNOWNS 5
#define ELIMINANT_POSE_3PT_UPRIGHT_ERROR_BOUND_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_3PT_UPRIGHT_ERROR_BOUND_MAX_SOLUTIONS 48
int32_t eliminant_pose_3pt_upright_error_bound_solve(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_upright_error_bound_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_upright_error_bound_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, const double *bound, size_t bound_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_3pt_upright_error_bound_solve_for_pose(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_upright_error_bound_solve_with_for_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_3pt_upright_error_bound_solve_batch_for_pose(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, const double *bound, size_t bound_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_3pt_upright_error_bound_relative_residual(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_3pt_upright_error_bound_error_bound(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_3pt_upright_error_bound_second_attempt_operations(void);

/*
 * pose_4pt_focal
 *
 * Pose and focal lengths of a camera from four points: 8 solutions, of which those with the points
 * in front of the camera are returned.
 *
 * Bujnak, Kukelova, Pajdla, "A general solution to the P4P problem for camera with unknown focal
 * length", CVPR 2008, by three quadrics as Kukelova, Heller, Fitzgibbon, "Efficient intersection
 * of three quadrics and applications in computer vision", CVPR 2016.
 *
 * `points[k]` is the position of point k, in a plane or not, and `images[k]` its image, relative
 * to the principal point. Eight equations leave a null space of dimension four of the camera
 * diag(f_x, f_y, 1) \[R t\], which is the sum of its vectors, each times its weight, up to scale.
 * Its first three columns have perpendicular rows. One focal length would be one equation too
 * many: it is left out, and of the results that one is wanted whose two `focal` lengths differ
 * least. A point X has the coordinates `rotation` X + `translation` in the camera.
 *
 * Data: points[4][3], images[4][2].
 * A row of 4 numbers, the unknowns: weights[4] (given up to scale: of length 1).
 * A row of 14 numbers, the result focal_pose: rotation[3][3], translation[3], focal[2].
 */
#define ELIMINANT_POSE_4PT_FOCAL_POINTS_LENGTH 12
#define ELIMINANT_POSE_4PT_FOCAL_IMAGES_LENGTH 8
#define ELIMINANT_POSE_4PT_FOCAL_UNKNOWNS 4
#define ELIMINANT_POSE_4PT_FOCAL_LENGTH_OF_FOCAL_POSE 14
#define ELIMINANT_POSE_4PT_FOCAL_MAX_SOLUTIONS 8
int32_t eliminant_pose_4pt_focal_solve(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_4pt_focal_solve_for_focal_pose(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_solve_with_for_focal_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_solve_batch_for_focal_pose(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_4pt_focal_relative_residual(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_4pt_focal_error_bound(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_4pt_focal_second_attempt_operations(void);

/*
 * pose_4pt_focal_radial
 *
 * Pose, focal length and radial distortion of a camera from four points: 16 solutions.
 *
 * Josephson, Byröd, "Pose estimation with radial distortion and unknown focal length", CVPR 2009,
 * in the form of Bujnak, Kukelova, Pajdla, "New efficient solution to the absolute pose problem
 * for camera with unknown focal length and radial distortion", ACCV 2010. Published as `p4p_fr`.
 *
 * `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
 * principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
 * v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
 * 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
 * null space of dimension four: these rows are the sum of its vectors, each times its weight. The
 * third row follows from the four points. `projection` is P up to scale.
 *
 * Data: points[4][3], images[4][2].
 * A row of 5 numbers, the unknowns: weights[4] (given up to scale: of length 1), radial.
 * A row of 14 numbers, the result radial_pose: projection[3][4], focal, radial.
 */
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_POINTS_LENGTH 12
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_IMAGES_LENGTH 8
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_UNKNOWNS 5
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_LENGTH_OF_RADIAL_POSE 14
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_MAX_SOLUTIONS 16
int32_t eliminant_pose_4pt_focal_radial_solve(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_4pt_focal_radial_solve_for_radial_pose(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_solve_with_for_radial_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_solve_batch_for_radial_pose(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_4pt_focal_radial_relative_residual(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_4pt_focal_radial_error_bound(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_4pt_focal_radial_second_attempt_operations(void);

/*
 * pose_4pt_focal_radial_cut
 *
 * Pose, focal length and radial distortion of a camera from four points, without the degenerate
 * solutions: 12 solutions.
 *
 * Larsson, Kukelova, Zheng, "Making minimal solvers for absolute pose estimation compact and
 * robust", ICCV 2017. Published as `p4p_fr_iccv17`; `pose_4pt_focal_radial` is the older
 * formulation of the same problem, with 16.
 *
 * `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
 * principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
 * v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
 * 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
 * null space of dimension four: these rows are the sum of its vectors, each times its weight. The
 * third row follows from the four points. `projection` is P up to scale.
 *
 * Data: points[4][3], images[4][2].
 * A row of 5 numbers, the unknowns: radial, weights[4] (given up to scale: of length 1).
 * A row of 14 numbers, the result radial_pose: projection[3][4], focal, radial.
 */
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_CUT_POINTS_LENGTH 12
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_CUT_IMAGES_LENGTH 8
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_CUT_UNKNOWNS 5
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_CUT_LENGTH_OF_RADIAL_POSE 14
#define ELIMINANT_POSE_4PT_FOCAL_RADIAL_CUT_MAX_SOLUTIONS 12
int32_t eliminant_pose_4pt_focal_radial_cut_solve(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_cut_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_cut_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_4pt_focal_radial_cut_solve_for_radial_pose(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_cut_solve_with_for_radial_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_focal_radial_cut_solve_batch_for_radial_pose(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_4pt_focal_radial_cut_relative_residual(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_4pt_focal_radial_cut_error_bound(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_4pt_focal_radial_cut_second_attempt_operations(void);

/*
 * pose_4pt_generalized_scale
 *
 * Pose and scale of a generalised camera from four points: 8 solutions, of which those with a
 * positive scale are returned.
 *
 * Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
 * problem", CVPR 2014. Published as `gp4p_scale`. As three quadrics: Kukelova, Heller, Fitzgibbon,
 * "Efficient intersection of three quadrics and applications in computer vision", CVPR 2016.
 *
 * `rays[k]` is the ray of point k, of any length, from `centres[k]`, and `points[k]` its position.
 * With R = `rotation`, that of the quaternion, t = `translation` and s = `scale`,
 * R `points[k]` + t - s `centres[k]` is along `rays[k]`: for each point two equations, linear in
 * R, t and s. Seven of the eight are combined so that t and s vanish. `residual` is what the
 * eighth, of the last point, leaves over: the solution that fits it best is wanted.
 *
 * Data: centres[4][3], rays[4][3], points[4][3].
 * A row of 4 numbers, the unknowns: quaternion[4] (given up to scale: of length 1).
 * A row of 14 numbers, the result scaled_pose: rotation[3][3], translation[3], scale, residual.
 */
#define ELIMINANT_POSE_4PT_GENERALIZED_SCALE_CENTRES_LENGTH 12
#define ELIMINANT_POSE_4PT_GENERALIZED_SCALE_RAYS_LENGTH 12
#define ELIMINANT_POSE_4PT_GENERALIZED_SCALE_POINTS_LENGTH 12
#define ELIMINANT_POSE_4PT_GENERALIZED_SCALE_UNKNOWNS 4
#define ELIMINANT_POSE_4PT_GENERALIZED_SCALE_LENGTH_OF_SCALED_POSE 14
#define ELIMINANT_POSE_4PT_GENERALIZED_SCALE_MAX_SOLUTIONS 8
int32_t eliminant_pose_4pt_generalized_scale_solve(
    const double *centres, size_t centres_length, const double *rays, size_t rays_length,
    const double *points, size_t points_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_generalized_scale_solve_with(
    uint64_t second_attempts, const double *centres, size_t centres_length, const double *rays,
    size_t rays_length, const double *points, size_t points_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_generalized_scale_solve_batch(
    size_t instances, const double *centres, size_t centres_length, const double *rays,
    size_t rays_length, const double *points, size_t points_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_4pt_generalized_scale_solve_for_scaled_pose(
    const double *centres, size_t centres_length, const double *rays, size_t rays_length,
    const double *points, size_t points_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_generalized_scale_solve_with_for_scaled_pose(
    uint64_t second_attempts, const double *centres, size_t centres_length, const double *rays,
    size_t rays_length, const double *points, size_t points_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_generalized_scale_solve_batch_for_scaled_pose(
    size_t instances, const double *centres, size_t centres_length, const double *rays,
    size_t rays_length, const double *points, size_t points_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_4pt_generalized_scale_relative_residual(
    const double *centres, size_t centres_length, const double *rays, size_t rays_length,
    const double *points, size_t points_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_4pt_generalized_scale_error_bound(
    const double *centres, size_t centres_length, const double *rays, size_t rays_length,
    const double *points, size_t points_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_4pt_generalized_scale_second_attempt_operations(void);

/*
 * pose_4pt_upright_error_bound
 *
 * Poses of a camera with known vertical direction in which the errors of four points equal their
 * bounds: 28 solutions.
 *
 * Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
 * direction", PAMI 2017. Published as `optpose4pt_v2`. A pose with the largest number of points
 * within the bound can be moved until four errors equal it.
 *
 * `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
 * `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
 * turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
 * in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
 *
 * Data: points[4][3], images[4][2], bound.
 * A row of 5 numbers, the unknowns: u, v, w, y, z.
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_4PT_UPRIGHT_ERROR_BOUND_POINTS_LENGTH 12
#define ELIMINANT_POSE_4PT_UPRIGHT_ERROR_BOUND_IMAGES_LENGTH 8
#define ELIMINANT_POSE_4PT_UPRIGHT_ERROR_BOUND_UNKNOWNS 5
#define ELIMINANT_POSE_4PT_UPRIGHT_ERROR_BOUND_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_4PT_UPRIGHT_ERROR_BOUND_MAX_SOLUTIONS 28
int32_t eliminant_pose_4pt_upright_error_bound_solve(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_upright_error_bound_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_upright_error_bound_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, const double *bound, size_t bound_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_4pt_upright_error_bound_solve_for_pose(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_upright_error_bound_solve_with_for_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double bound, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_4pt_upright_error_bound_solve_batch_for_pose(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, const double *bound, size_t bound_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_4pt_upright_error_bound_relative_residual(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_4pt_upright_error_bound_error_bound(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double bound, const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_4pt_upright_error_bound_second_attempt_operations(void);

/*
 * pose_5pt_refraction
 *
 * Pose of a calibrated camera that looks at five points through a plane at which light is
 * refracted: 8 solutions.
 *
 * Haner, Åström, "Absolute pose for cameras under flat refractive interfaces", CVPR 2015.
 * Published as `refract5p`.
 *
 * The plane is Z = 0, with the camera on one side of it and the points on the other. `rays[k]` is
 * the ray of point k in the camera, of any length, and `points[k]` its position; `index` is the
 * index of refraction on the side of the points, relative to that on the side of the camera.
 * Refraction keeps a ray in its plane with the normal, so that R ray and the point X minus the
 * centre (v, w, ..) of the camera are parallel in their first two coordinates:
 * (r1 ray) (X2 - w) - (r2 ray) (X1 - v) = 0 with the rows r1, r2, r3 of R. This is linear in r1,
 * r2 and u = v r2 - w r1, so these are a sum of four vectors, each times its weight. r1 and r2
 * have one length and are orthogonal, and u is in their plane: the determinant is 0. Four complex
 * solutions with r1 and r2 of length 0 satisfy that for any u. They are none of the other form, in
 * which u is the sum of its parts along r1 and r2. The two together are all cubic equations.
 *
 * The published system is stated in a quaternion and has 16 solutions: with (r1, r2, r3) also
 * (-r1, -r2, r3), the same turned by a half about the normal. Both have the same weights here, up
 * to sign. Of the two, `rotation` is the one with the points ahead of the camera. It takes rays to
 * the frame of the points, and `centre` is that of the camera. Its height follows from how much
 * the rays are bent, by least squares.
 *
 * Data: rays[5][3], points[5][3], index.
 * A row of 4 numbers, the unknowns: weights[4] (given up to scale: of length 1).
 * A row of 12 numbers, the result refracted_pose: rotation[3][3], centre[3].
 */
#define ELIMINANT_POSE_5PT_REFRACTION_RAYS_LENGTH 15
#define ELIMINANT_POSE_5PT_REFRACTION_POINTS_LENGTH 15
#define ELIMINANT_POSE_5PT_REFRACTION_UNKNOWNS 4
#define ELIMINANT_POSE_5PT_REFRACTION_LENGTH_OF_REFRACTED_POSE 12
#define ELIMINANT_POSE_5PT_REFRACTION_MAX_SOLUTIONS 8
int32_t eliminant_pose_5pt_refraction_solve(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double index, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_5pt_refraction_solve_with(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double index, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_5pt_refraction_solve_batch(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, const double *index, size_t index_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_5pt_refraction_solve_for_refracted_pose(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double index, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_5pt_refraction_solve_with_for_refracted_pose(
    uint64_t second_attempts, const double *rays, size_t rays_length, const double *points,
    size_t points_length, double index, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_5pt_refraction_solve_batch_for_refracted_pose(
    size_t instances, const double *rays, size_t rays_length, const double *points,
    size_t points_length, const double *index, size_t index_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_5pt_refraction_relative_residual(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double index, const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_5pt_refraction_error_bound(
    const double *rays, size_t rays_length, const double *points, size_t points_length,
    double index, const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_5pt_refraction_second_attempt_operations(void);

/*
 * pose_5tdoa_two_receivers
 *
 * Pose of two receivers close to each other from the time differences with which they hear five
 * senders: 24 solutions.
 *
 * Burgess, Kuang, Åström, "Pose estimation from minimal dual-receiver configurations", ICPR 2012.
 * Published as `tdoa_pose_5pt`.
 *
 * `senders` are positions, `differences` the differences of the ranges of each to the two
 * receivers, and `distance` is that of the receivers. They are at C, one from the other in the
 * direction n = (u, v, w). Divided by `distance`, the difference of the ranges of a sender U is
 * the cosine c of an angle: (n U - t)^2 = c^2 |n|^2 |U - C|^2 with t = n C. Five such equations
 * are linear in |n|^2 |C|^2 and |n|^2 C, and otherwise have the terms u u, u v, u w, v v, v w, w
 * w, t u, t v, t w and t t. They are solved for the former, and a fifth linear combination has
 * none of them. C follows from n and t, which are `plane`: n X = t passes through the receivers,
 * across their line. t is in units of the length of all positions.
 *
 * Data: senders[5][3], differences[5], distance.
 * A row of 4 numbers, the unknowns: plane[4] (given up to scale: of length 1).
 * A row of 6 numbers, the result receiver_pair: direction[3], centre[3].
 */
#define ELIMINANT_POSE_5TDOA_TWO_RECEIVERS_SENDERS_LENGTH 15
#define ELIMINANT_POSE_5TDOA_TWO_RECEIVERS_DIFFERENCES_LENGTH 5
#define ELIMINANT_POSE_5TDOA_TWO_RECEIVERS_UNKNOWNS 4
#define ELIMINANT_POSE_5TDOA_TWO_RECEIVERS_LENGTH_OF_RECEIVER_PAIR 6
#define ELIMINANT_POSE_5TDOA_TWO_RECEIVERS_MAX_SOLUTIONS 24
int32_t eliminant_pose_5tdoa_two_receivers_solve(
    const double *senders, size_t senders_length, const double *differences,
    size_t differences_length, double distance, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_5tdoa_two_receivers_solve_with(
    uint64_t second_attempts, const double *senders, size_t senders_length,
    const double *differences, size_t differences_length, double distance, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_5tdoa_two_receivers_solve_batch(
    size_t instances, const double *senders, size_t senders_length, const double *differences,
    size_t differences_length, const double *distance, size_t distance_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_5tdoa_two_receivers_solve_for_receiver_pair(
    const double *senders, size_t senders_length, const double *differences,
    size_t differences_length, double distance, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_5tdoa_two_receivers_solve_with_for_receiver_pair(
    uint64_t second_attempts, const double *senders, size_t senders_length,
    const double *differences, size_t differences_length, double distance, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_5tdoa_two_receivers_solve_batch_for_receiver_pair(
    size_t instances, const double *senders, size_t senders_length, const double *differences,
    size_t differences_length, const double *distance, size_t distance_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_5tdoa_two_receivers_relative_residual(
    const double *senders, size_t senders_length, const double *differences,
    size_t differences_length, double distance, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_5tdoa_two_receivers_error_bound(
    const double *senders, size_t senders_length, const double *differences,
    size_t differences_length, double distance, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_5tdoa_two_receivers_second_attempt_operations(void);

/*
 * pose_6pt_rolling_shutter
 *
 * Pose and motion of a camera with rolling shutter from six points: 20 solutions.
 *
 * Albl, Kukelova, Pajdla, "R6P - rolling shutter absolute camera pose", CVPR 2015. Published as
 * `r6p`.
 *
 * `points[k]` is the position of a point and `images[k]` its image, in units of the focal length.
 * A point X is seen at q, in the row q\[0\], where (q, 1) and (I + q\[0\] \[(x, y, z)\]x) (I +
 * \[(u, v, w)\]x) X + C + q\[0\] t are parallel: both rotations linearised, the first for an
 * angular velocity. Three of the points, linear in the position C and the velocity t, give them as
 * position m and velocity m, m being the products of x, y, z (slower) with u, v, w, and then u, v,
 * w, x, y, z, 1.
 *
 * Data: points[6][3], images[6][2].
 * A row of 6 numbers, the unknowns: u, v, w, x, y, z.
 * A row of 18 numbers, the result rolling_pose: rotation[3][3], position[3], angular_velocity[3],
 *   velocity[3].
 */
#define ELIMINANT_POSE_6PT_ROLLING_SHUTTER_POINTS_LENGTH 18
#define ELIMINANT_POSE_6PT_ROLLING_SHUTTER_IMAGES_LENGTH 12
#define ELIMINANT_POSE_6PT_ROLLING_SHUTTER_UNKNOWNS 6
#define ELIMINANT_POSE_6PT_ROLLING_SHUTTER_LENGTH_OF_ROLLING_POSE 18
#define ELIMINANT_POSE_6PT_ROLLING_SHUTTER_MAX_SOLUTIONS 20
int32_t eliminant_pose_6pt_rolling_shutter_solve(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_6pt_rolling_shutter_solve_with(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_6pt_rolling_shutter_solve_batch(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_6pt_rolling_shutter_solve_for_rolling_pose(
    const double *points, size_t points_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_6pt_rolling_shutter_solve_with_for_rolling_pose(
    uint64_t second_attempts, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_6pt_rolling_shutter_solve_batch_for_rolling_pose(
    size_t instances, const double *points, size_t points_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_pose_6pt_rolling_shutter_relative_residual(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_pose_6pt_rolling_shutter_error_bound(
    const double *points, size_t points_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_pose_6pt_rolling_shutter_second_attempt_operations(void);

/*
 * pose_npt_direct_least_squares
 *
 * Pose of a calibrated camera from n points, all stationary points of a least-squares cost in
 * Cayley parameters: 27 solutions.
 *
 * Hesch, Roumeliotis, "A direct least-squares (DLS) method for PnP", ICCV 2011. Published as
 * `opt_pnp_hesch`.
 *
 * The cost is the mean squared distance of the points from the rays along which the camera sees
 * them, with the best translation, which is linear in the rotation. Without the common denominator
 * 1 + x^2 + y^2 + z^2 of the rotation of the quaternion (1, x, y, z) it is a polynomial of degree
 * four. `means` are those of `of_point` over 3 points or more. Rounding errors are smallest if the
 * origin is amid the points. Half turns would be at infinity. Points are turned before, so that
 * none of the poses that are at infinity is one that scenes are made of.
 *
 * Data: means[6][10] (the result of `mean_of_point`).
 * A row of 3 numbers, the unknowns: x, y, z.
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_NPT_DIRECT_LEAST_SQUARES_MEANS_LENGTH 60
#define ELIMINANT_POSE_NPT_DIRECT_LEAST_SQUARES_UNKNOWNS 3
#define ELIMINANT_POSE_NPT_DIRECT_LEAST_SQUARES_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_NPT_DIRECT_LEAST_SQUARES_MAX_SOLUTIONS 27
int32_t eliminant_pose_npt_direct_least_squares_solve(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_direct_least_squares_solve_with(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_direct_least_squares_solve_batch(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_direct_least_squares_solve_for_pose(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_direct_least_squares_solve_with_for_pose(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_direct_least_squares_solve_batch_for_pose(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_direct_least_squares_relative_residual(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_npt_direct_least_squares_error_bound(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_npt_direct_least_squares_second_attempt_operations(void);
/*
 * What a point gives: the products of its coordinates and 1, times the entries of the projection
 * across its ray. `ray` is the ray of the point in the camera, of any length.
 * Mean mean[6][10] over measurements of: ray[3], point[3].
 */
int32_t eliminant_pose_npt_direct_least_squares_mean_of_point(
    size_t measurements, const double *ray, size_t ray_length, const double *point,
    size_t point_length, double *mean, size_t mean_length);

/*
 * pose_npt_least_squares_cayley
 *
 * Pose of a calibrated camera from n points, all stationary points of a least-squares cost over
 * the rotations, by Cayley parameters: 40 solutions.
 *
 * Nakano, "Globally optimal DLS method for PnP problem with Cayley parameterization", BMVC 2015.
 * Published as `opt_pnp_nakanoC`.
 *
 * The cost is the mean squared distance of the points from the rays along which the camera sees
 * them, with the best translation, which is linear in the rotation: r^T `cost` r, r being the
 * entries of the rotation of the quaternion q, row by row. With r times |q|^2 in its place the
 * cost grows with the fourth power of the length of q, so q is stationary up to its length where
 * the gradient d is parallel to it. `means` are those of `of_point` over 3 points or more.
 * Rounding errors are smallest if the origin is amid the points.
 *
 * Data: means[6][10] (the result of `mean_of_point`).
 * A row of 4 numbers, the unknowns: q[4] (given up to scale: of length 1).
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_CAYLEY_MEANS_LENGTH 60
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_CAYLEY_UNKNOWNS 4
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_CAYLEY_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_CAYLEY_MAX_SOLUTIONS 40
int32_t eliminant_pose_npt_least_squares_cayley_solve(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_cayley_solve_with(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_cayley_solve_batch(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_least_squares_cayley_solve_for_pose(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_cayley_solve_with_for_pose(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_cayley_solve_batch_for_pose(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_least_squares_cayley_relative_residual(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_npt_least_squares_cayley_error_bound(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_npt_least_squares_cayley_second_attempt_operations(void);
/*
 * What a point gives: the products of its coordinates and 1, times the entries of the projection
 * across its ray. `ray` is the ray of the point in the camera, of any length.
 * Mean mean[6][10] over measurements of: ray[3], point[3].
 */
int32_t eliminant_pose_npt_least_squares_cayley_mean_of_point(
    size_t measurements, const double *ray, size_t ray_length, const double *point,
    size_t point_length, double *mean, size_t mean_length);

/*
 * pose_npt_least_squares_quaternion
 *
 * Pose of a calibrated camera from n points, all stationary points of a least-squares cost in a
 * quaternion that is not normalised: 40 solutions.
 *
 * Zheng, Kuang, Sugimoto, Åström, Okutomi, "Revisiting the PnP problem: a fast, general and
 * optimal solution", ICCV 2013. Published as `opt_pnp_zheng`.
 *
 * With depths relative to their mean, and P the rotation over the mean depth, the image (u, v) of
 * a point satisfies (u, v) (1 + P3 X) = (P1 X, P2 X) + constants, X relative to the mean of the
 * points. With the best constants the mean square of the differences is a quadratic form in 1 and
 * the entries of P, which are the products of two entries of a quaternion. The square of its
 * length, the inverse of the mean depth, is free: it is an unknown scale s times the unknown
 * direction q below. The derivatives, divided by s, are linear in the square of s, with the
 * coefficients `cubic` and `linear`: it follows from any of them, and is eliminated here.
 *
 * `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
 * origin is amid the points.
 *
 * Data: means[39] (the result of `mean_of_point`).
 * A row of 4 numbers, the unknowns: q[4] (given up to scale: of length 1).
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_QUATERNION_MEANS_LENGTH 39
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_QUATERNION_UNKNOWNS 4
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_QUATERNION_LENGTH_OF_POSE 12
#define ELIMINANT_POSE_NPT_LEAST_SQUARES_QUATERNION_MAX_SOLUTIONS 40
int32_t eliminant_pose_npt_least_squares_quaternion_solve(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_quaternion_solve_with(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_quaternion_solve_batch(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_least_squares_quaternion_solve_for_pose(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_quaternion_solve_with_for_pose(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_least_squares_quaternion_solve_batch_for_pose(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_least_squares_quaternion_relative_residual(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_npt_least_squares_quaternion_error_bound(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_npt_least_squares_quaternion_second_attempt_operations(void);
/*
 * What a point and its image give: the products of two of the point's coordinates and 1, then
 * those with 1 times the coordinates of the image and times the square of its distance from the
 * principal point.
 * Mean mean[39] over measurements of: image[2], point[3].
 */
int32_t eliminant_pose_npt_least_squares_quaternion_mean_of_point(
    size_t measurements, const double *image, size_t image_length, const double *point,
    size_t point_length, double *mean, size_t mean_length);

/*
 * pose_npt_weak_perspective
 *
 * Pose of a weak-perspective camera from n points, all stationary points of the least-squares
 * cost: 16 solutions.
 *
 * Larsson, Åström, "Uncovering symmetries in polynomial systems", ECCV 2016. Published as `wpnp`.
 *
 * The image of a point X is P X + t, with P the first two rows of a rotation times a scale, that
 * is, of the rotation of a quaternion q that is not normalised. With the best t the mean square of
 * the differences is a quadratic form in P, whose matrix is the covariance of the points. Since q
 * and -q are the same rotation, the unknowns are the ratios in q = root (w, 1, y, z), and
 * `square`, that of the root. Points are turned before, so that the entry of 1 is not 0 for poses
 * that scenes are made of. Published templates take the principal axes of the points instead, in
 * which the covariance is diagonal.
 *
 * `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
 * origin is amid the points.
 *
 * Data: means[17] (the result of `mean_of_point`).
 * A row of 4 numbers, the unknowns: w, square, y, z.
 * A row of 12 numbers, the result weak_pose: rotation[3][3], scale, translation[2].
 */
#define ELIMINANT_POSE_NPT_WEAK_PERSPECTIVE_MEANS_LENGTH 17
#define ELIMINANT_POSE_NPT_WEAK_PERSPECTIVE_UNKNOWNS 4
#define ELIMINANT_POSE_NPT_WEAK_PERSPECTIVE_LENGTH_OF_WEAK_POSE 12
#define ELIMINANT_POSE_NPT_WEAK_PERSPECTIVE_MAX_SOLUTIONS 16
int32_t eliminant_pose_npt_weak_perspective_solve(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_weak_perspective_solve_with(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_weak_perspective_solve_batch(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_weak_perspective_solve_for_weak_pose(
    const double *means, size_t means_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_pose_npt_weak_perspective_solve_with_for_weak_pose(
    uint64_t second_attempts, const double *means, size_t means_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_pose_npt_weak_perspective_solve_batch_for_weak_pose(
    size_t instances, const double *means, size_t means_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_pose_npt_weak_perspective_relative_residual(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_pose_npt_weak_perspective_error_bound(
    const double *means, size_t means_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_pose_npt_weak_perspective_second_attempt_operations(void);
/*
 * What a point and its image give: the products of two of the point's coordinates and 1, then
 * those of the coordinates and 1 with those of the image.
 * Mean mean[17] over measurements of: image[2], point[3].
 */
int32_t eliminant_pose_npt_weak_perspective_mean_of_point(
    size_t measurements, const double *image, size_t image_length, const double *point,
    size_t point_length, double *mean, size_t mean_length);

/*
 * relpose_3pt_angle_zero_screw
 *
 * Relative pose of two calibrated cameras from three point correspondences where the motion turns
 * by a known angle about an axis without moving along it: 12 solutions.
 *
 * Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
 * of known relative rotation angle", JMIV 62, 2020. Published as `3pra_st0`.
 *
 * `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
 * the cosine and the sine of half the angle: the rotation from the first camera to the second is
 * that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
 * follows from any other point, and from the translation being orthogonal to (u, v, w). All
 * polynomials are written p + w q, with p and q in u and v only, and stated with their multiple by
 * w.
 *
 * A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
 * The length of the translation is open, and it is of length 1; where the motion is a rotation it
 * is not known. Its sign is the one for which the first point is in front of the first camera.
 *
 * Data: first[3][3], second[3][3], half_angle[2] (of length 1).
 * A row of 3 numbers, the unknowns: u, v, w.
 * A row of 12 numbers, the result relative_pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_3PT_ANGLE_ZERO_SCREW_FIRST_LENGTH 9
#define ELIMINANT_RELPOSE_3PT_ANGLE_ZERO_SCREW_SECOND_LENGTH 9
#define ELIMINANT_RELPOSE_3PT_ANGLE_ZERO_SCREW_HALF_ANGLE_LENGTH 2
#define ELIMINANT_RELPOSE_3PT_ANGLE_ZERO_SCREW_UNKNOWNS 3
#define ELIMINANT_RELPOSE_3PT_ANGLE_ZERO_SCREW_LENGTH_OF_RELATIVE_POSE 12
#define ELIMINANT_RELPOSE_3PT_ANGLE_ZERO_SCREW_MAX_SOLUTIONS 12
int32_t eliminant_relpose_3pt_angle_zero_screw_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_3pt_angle_zero_screw_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_3pt_angle_zero_screw_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_3pt_angle_zero_screw_solve_for_relative_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_3pt_angle_zero_screw_solve_with_for_relative_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_3pt_angle_zero_screw_solve_batch_for_relative_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_3pt_angle_zero_screw_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, const double *solution,
    size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_3pt_angle_zero_screw_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, const double *solution,
    size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_3pt_angle_zero_screw_second_attempt_operations(void);

/*
 * relpose_3pt_depths
 *
 * Relative pose of two calibrated cameras from three points with depths that are known up to scale
 * and shift, as a network estimates them from each image: at most 4 solutions.
 *
 * Ding, Kocur, Vávra, Berger Haladová, Yang, Sattler, Kukelova, "RePoseD: Efficient relative pose
 * estimation with known depth information", ICCV 2025; Yu, Liu, Pautrat, Pollefeys, Larsson,
 * "Relative pose estimation through affine corrections of monocular depth priors", CVPR 2025.
 *
 * `first[k]` and `second[k]` are the images of point k, (x, y) of the ray (x, y, 1), and
 * `first_depths[k]` and `second_depths[k]` its depths, the third coordinates, as estimated. The
 * point is at (`first_depths[k]` + u) (x, y, 1) in the first camera and at `scale`
 * (`second_depths[k]` + v) (x, y, 1) in the second; `shifts` are u and v. Squared distances of the
 * points are quadratic in the shifts, and those in the second camera are 1 / `scale`^2 of those in
 * the first. Three of them, solved for 1, u and u^2, give these times 1 / `scale`^2 as `powers`,
 * which are quadratic in v: the first times the third is the square of the second. A point X in
 * the first camera is at `rotation` X + `translation` in the second.
 *
 * Data: first[3][2], first_depths[3], second[3][2], second_depths[3].
 * A row of 1 numbers, the unknowns: v.
 * A row of 15 numbers, the result depth_pose: rotation[3][3], translation[3], scale, shifts[2].
 */
#define ELIMINANT_RELPOSE_3PT_DEPTHS_FIRST_LENGTH 6
#define ELIMINANT_RELPOSE_3PT_DEPTHS_FIRST_DEPTHS_LENGTH 3
#define ELIMINANT_RELPOSE_3PT_DEPTHS_SECOND_LENGTH 6
#define ELIMINANT_RELPOSE_3PT_DEPTHS_SECOND_DEPTHS_LENGTH 3
#define ELIMINANT_RELPOSE_3PT_DEPTHS_UNKNOWNS 1
#define ELIMINANT_RELPOSE_3PT_DEPTHS_LENGTH_OF_DEPTH_POSE 15
#define ELIMINANT_RELPOSE_3PT_DEPTHS_MAX_SOLUTIONS 4
int32_t eliminant_relpose_3pt_depths_solve(
    const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_3pt_depths_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_3pt_depths_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_3pt_depths_solve_for_depth_pose(
    const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_3pt_depths_solve_with_for_depth_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_3pt_depths_solve_batch_for_depth_pose(
    size_t instances, const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_3pt_depths_relative_residual(
    const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, const double *solution,
    size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_3pt_depths_error_bound(
    const double *first, size_t first_length, const double *first_depths,
    size_t first_depths_length, const double *second, size_t second_length,
    const double *second_depths, size_t second_depths_length, const double *solution,
    size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_3pt_depths_second_attempt_operations(void);

/*
 * relpose_3pt_upright
 *
 * Relative pose of two cameras whose vertical is known, as by an inertial sensor, from three
 * points: 4 solutions.
 *
 * Fraundorfer, Tanskanen, Pollefeys, "A minimal case solution to the calibrated relative pose
 * problem for the case of two known orientation angles", ECCV 2010.
 *
 * `first[k]` and `second[k]` are the rays of point k in frames of the cameras whose y axes are
 * vertical, of any length. The unknowns are cosine and sine of the turn about the vertical.
 *
 * A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
 * The length of the translation is open, and it is of length 1; where the motion is a rotation it
 * is not known. Its sign is the one for which the first point is in front of the first camera.
 *
 * Data: first[3][3], second[3][3].
 * A row of 2 numbers, the unknowns: c, s.
 * A row of 12 numbers, the result relative_pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_3PT_UPRIGHT_FIRST_LENGTH 9
#define ELIMINANT_RELPOSE_3PT_UPRIGHT_SECOND_LENGTH 9
#define ELIMINANT_RELPOSE_3PT_UPRIGHT_UNKNOWNS 2
#define ELIMINANT_RELPOSE_3PT_UPRIGHT_LENGTH_OF_RELATIVE_POSE 12
#define ELIMINANT_RELPOSE_3PT_UPRIGHT_MAX_SOLUTIONS 4
int32_t eliminant_relpose_3pt_upright_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_3pt_upright_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_3pt_upright_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_3pt_upright_solve_for_relative_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_3pt_upright_solve_with_for_relative_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_3pt_upright_solve_batch_for_relative_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_3pt_upright_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_3pt_upright_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_3pt_upright_second_attempt_operations(void);

/*
 * relpose_4pt_angle
 *
 * Relative pose of two calibrated cameras with a known angle of rotation from four point
 * correspondences: 20 solutions.
 *
 * Li, Heng, Lee, Pollefeys, "A 4-point algorithm for relative pose estimation of a calibrated
 * camera with a known relative rotation angle", IROS 2013. Published as `relpose_4pt`, with the
 * translation among the unknowns; it is eliminated here as in Martyushev, Li, "Efficient relative
 * pose estimation for cameras and generalized cameras in case of known relative rotation angle",
 * JMIV 62, 2020.
 *
 * `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
 * the cosine and the sine of half the angle: the rotation from the first camera to the second is
 * that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
 * follows from any other point. All polynomials are written p + w q, with p and q in u and v only,
 * and stated with their multiple by w.
 *
 * A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
 * The length of the translation is open, and it is of length 1; where the motion is a rotation it
 * is not known. Its sign is the one for which the first point is in front of the first camera.
 *
 * Data: first[4][3], second[4][3], half_angle[2] (of length 1).
 * A row of 3 numbers, the unknowns: u, v, w.
 * A row of 12 numbers, the result relative_pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_4PT_ANGLE_FIRST_LENGTH 12
#define ELIMINANT_RELPOSE_4PT_ANGLE_SECOND_LENGTH 12
#define ELIMINANT_RELPOSE_4PT_ANGLE_HALF_ANGLE_LENGTH 2
#define ELIMINANT_RELPOSE_4PT_ANGLE_UNKNOWNS 3
#define ELIMINANT_RELPOSE_4PT_ANGLE_LENGTH_OF_RELATIVE_POSE 12
#define ELIMINANT_RELPOSE_4PT_ANGLE_MAX_SOLUTIONS 20
int32_t eliminant_relpose_4pt_angle_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_4pt_angle_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_4pt_angle_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_4pt_angle_solve_for_relative_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_4pt_angle_solve_with_for_relative_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_4pt_angle_solve_batch_for_relative_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_4pt_angle_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, const double *solution,
    size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_4pt_angle_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, const double *solution,
    size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_4pt_angle_second_attempt_operations(void);

/*
 * relpose_5pt
 *
 * Relative pose of two calibrated cameras from five point correspondences: 10 essential matrices.
 *
 * Nistér, "An efficient solution to the five-point relative pose problem", PAMI 2004; in this form
 * Stewénius, Engels, Nistér, "Recent developments on direct relative orientation", ISPRS 2006.
 * Published as `5p`.
 *
 * `basis` spans the null space of the five epipolar equations; the essential matrix is the sum
 * of its matrices, each times its weight.
 *
 * Data: basis[4][3][3].
 * A row of 4 numbers, the unknowns: weights[4] (given up to scale: of length 1).
 */
#define ELIMINANT_RELPOSE_5PT_BASIS_LENGTH 36
#define ELIMINANT_RELPOSE_5PT_UNKNOWNS 4
#define ELIMINANT_RELPOSE_5PT_MAX_SOLUTIONS 10
int32_t eliminant_relpose_5pt_solve(
    const double *basis, size_t basis_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_solve_with(
    uint64_t second_attempts, const double *basis, size_t basis_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_solve_batch(
    size_t instances, const double *basis, size_t basis_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_5pt_relative_residual(
    const double *basis, size_t basis_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_relpose_5pt_error_bound(
    const double *basis, size_t basis_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_relpose_5pt_second_attempt_operations(void);

/*
 * relpose_5pt_generalized_angle
 *
 * Relative pose of two generalized cameras with a known angle of rotation from five point
 * correspondences: 44 solutions.
 *
 * Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
 * of known relative rotation angle", JMIV 62, 2020. Published as `gen5pra`.
 *
 * `first` and `second` hold the rays of the points in either system of cameras: a point of the
 * ray, and its direction. `half_angle` holds the cosine and the sine of half the angle: the
 * rotation from the first system to the second is that of the unit quaternion cosine + u i + v j +
 * w k. That the rays of one point meet gives the translation up to the depths of that point along
 * either ray; that the rays of any three others meet, too, are linear equations for these depths.
 * All polynomials are written p + w q, with p and q in u and v only, and stated with their
 * multiple by w.
 *
 * A pose X -> rotation X + translation takes the first system to the second, in the unit of the
 * points of the rays.
 *
 * Data: first[5][2][3], second[5][2][3], half_angle[2] (of length 1).
 * A row of 3 numbers, the unknowns: u, v, w.
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_5PT_GENERALIZED_ANGLE_FIRST_LENGTH 30
#define ELIMINANT_RELPOSE_5PT_GENERALIZED_ANGLE_SECOND_LENGTH 30
#define ELIMINANT_RELPOSE_5PT_GENERALIZED_ANGLE_HALF_ANGLE_LENGTH 2
#define ELIMINANT_RELPOSE_5PT_GENERALIZED_ANGLE_UNKNOWNS 3
#define ELIMINANT_RELPOSE_5PT_GENERALIZED_ANGLE_LENGTH_OF_POSE 12
#define ELIMINANT_RELPOSE_5PT_GENERALIZED_ANGLE_MAX_SOLUTIONS 44
int32_t eliminant_relpose_5pt_generalized_angle_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_5pt_generalized_angle_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_generalized_angle_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_5pt_generalized_angle_solve_for_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_5pt_generalized_angle_solve_with_for_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_generalized_angle_solve_batch_for_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *half_angle, size_t half_angle_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_5pt_generalized_angle_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, const double *solution,
    size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_5pt_generalized_angle_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *half_angle, size_t half_angle_length, const double *solution,
    size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_5pt_generalized_angle_second_attempt_operations(void);

/*
 * relpose_5pt_rays
 *
 * Relative pose of two calibrated cameras from five points: 10 essential matrices.
 *
 * The problem `relpose_5pt` from measurements. `first[k]` and `second[k]` are the rays of point k
 * in both cameras, of any length. An essential matrix E satisfies `second[k] . E first[k] = 0`; it
 * is the sum of the matrices that span the null space of these equations, each times its weight.
 *
 * A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
 * the translation has the length 1. Of the four poses of an essential matrix it is the one with
 * the first point in front of both cameras: Horn, "Recovering baseline and orientation from
 * essential matrix", 1990. For a solution that belongs to the scene all points are in front.
 *
 * Data: first[5][3], second[5][3].
 * A row of 4 numbers, the unknowns: weights[4] (given up to scale: of length 1).
 * A row of 21 numbers, the result relative_pose: essential[3][3] (given up to scale),
 *   rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_5PT_RAYS_FIRST_LENGTH 15
#define ELIMINANT_RELPOSE_5PT_RAYS_SECOND_LENGTH 15
#define ELIMINANT_RELPOSE_5PT_RAYS_UNKNOWNS 4
#define ELIMINANT_RELPOSE_5PT_RAYS_LENGTH_OF_RELATIVE_POSE 21
#define ELIMINANT_RELPOSE_5PT_RAYS_MAX_SOLUTIONS 10
int32_t eliminant_relpose_5pt_rays_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_rays_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_rays_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_5pt_rays_solve_for_relative_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_rays_solve_with_for_relative_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_rays_solve_batch_for_relative_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_5pt_rays_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_5pt_rays_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_5pt_rays_second_attempt_operations(void);

/*
 * relpose_5pt_semi_generalized_focal
 *
 * Pose and focal length of a camera from five points that calibrated cameras of known poses see,
 * too, and one point of known position: 56 solutions.
 *
 * Bhayani, Sattler, Larsson, Heikkilä, Kukelova, "Partially calibrated semi-generalized pose from
 * hybrid point correspondences", WACV 2023. Published as `hyb51f`.
 *
 * `image` is that of the known `point`, relative to the principal point, and must not be there.
 * `images[k]` is that of point k, which a calibrated camera sees along the ray from `centres[k]`
 * in the direction `directions[k]`. Positions are relative to `point`; images are turned and
 * scaled so that that of `point` is (1, 0), and its depth is the unknown `depth`. The rotation of
 * the camera, which is turned with the images, is that of the quaternion 1 + x i + y j, and a turn
 * about its axis after it, by the angle of which c and s are cosine and sine, times the focal
 * length. An image lies on that of the ray: det(M) M^-T, the cofactors of M, maps moments of rays
 * to lines of the image where M maps directions to points of it. The squared norm of the
 * quaternion, which divides all cofactors, is left out.
 *
 * A pose X -> rotation X + translation takes the world to the camera; `focal` is in the unit of
 * images. The known point is in front of the camera.
 *
 * Data: point[3], image[2], images[5][2], centres[5][3], directions[5][3].
 * A row of 5 numbers, the unknowns: x, y, c, s, depth.
 * A row of 13 numbers, the result focal_pose: rotation[3][3], translation[3], focal.
 */
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_POINT_LENGTH 3
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_IMAGE_LENGTH 2
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_IMAGES_LENGTH 10
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_CENTRES_LENGTH 15
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_DIRECTIONS_LENGTH 15
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_UNKNOWNS 5
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_LENGTH_OF_FOCAL_POSE 13
#define ELIMINANT_RELPOSE_5PT_SEMI_GENERALIZED_FOCAL_MAX_SOLUTIONS 56
int32_t eliminant_relpose_5pt_semi_generalized_focal_solve(
    const double *point, size_t point_length, const double *image, size_t image_length,
    const double *images, size_t images_length, const double *centres, size_t centres_length,
    const double *directions, size_t directions_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_5pt_semi_generalized_focal_solve_with(
    uint64_t second_attempts, const double *point, size_t point_length, const double *image,
    size_t image_length, const double *images, size_t images_length, const double *centres,
    size_t centres_length, const double *directions, size_t directions_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_semi_generalized_focal_solve_batch(
    size_t instances, const double *point, size_t point_length, const double *image,
    size_t image_length, const double *images, size_t images_length, const double *centres,
    size_t centres_length, const double *directions, size_t directions_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_5pt_semi_generalized_focal_solve_for_focal_pose(
    const double *point, size_t point_length, const double *image, size_t image_length,
    const double *images, size_t images_length, const double *centres, size_t centres_length,
    const double *directions, size_t directions_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_5pt_semi_generalized_focal_solve_with_for_focal_pose(
    uint64_t second_attempts, const double *point, size_t point_length, const double *image,
    size_t image_length, const double *images, size_t images_length, const double *centres,
    size_t centres_length, const double *directions, size_t directions_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_5pt_semi_generalized_focal_solve_batch_for_focal_pose(
    size_t instances, const double *point, size_t point_length, const double *image,
    size_t image_length, const double *images, size_t images_length, const double *centres,
    size_t centres_length, const double *directions, size_t directions_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_5pt_semi_generalized_focal_relative_residual(
    const double *point, size_t point_length, const double *image, size_t image_length,
    const double *images, size_t images_length, const double *centres, size_t centres_length,
    const double *directions, size_t directions_length, const double *solution,
    size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_5pt_semi_generalized_focal_error_bound(
    const double *point, size_t point_length, const double *image, size_t image_length,
    const double *images, size_t images_length, const double *centres, size_t centres_length,
    const double *directions, size_t directions_length, const double *solution,
    size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_5pt_semi_generalized_focal_second_attempt_operations(void);

/*
 * relpose_6pt_focal
 *
 * Relative pose of two cameras with one unknown shared focal length from six point
 * correspondences: 15 solutions.
 *
 * Stewénius, Nistér, Kahl, Schaffalitzky, "A minimal solution for relative pose with unknown focal
 * length", CVPR 2005; the form with w = 1/f^2 as in Kukelova, Bujnak, Pajdla, "Polynomial
 * eigenvalue solutions to the 5-pt and 6-pt relative pose problems", BMVC 2008. Published as
 * `focal6p`.
 *
 * `basis` spans the null space of the six epipolar equations; the fundamental matrix is the
 * sum of its matrices, each times its weight.
 *
 * Data: basis[3][3][3].
 * A row of 4 numbers, the unknowns: weights[3] (given up to scale: of length 1), w.
 */
#define ELIMINANT_RELPOSE_6PT_FOCAL_BASIS_LENGTH 27
#define ELIMINANT_RELPOSE_6PT_FOCAL_UNKNOWNS 4
#define ELIMINANT_RELPOSE_6PT_FOCAL_MAX_SOLUTIONS 15
int32_t eliminant_relpose_6pt_focal_solve(
    const double *basis, size_t basis_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_solve_with(
    uint64_t second_attempts, const double *basis, size_t basis_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_solve_batch(
    size_t instances, const double *basis, size_t basis_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_relpose_6pt_focal_relative_residual(
    const double *basis, size_t basis_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_relpose_6pt_focal_error_bound(
    const double *basis, size_t basis_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_relpose_6pt_focal_second_attempt_operations(void);

/*
 * relpose_6pt_focal_one_side
 *
 * Relative pose of a camera with unknown focal length and a calibrated one from six points: 9
 * solutions, of which those with a real focal length are returned.
 *
 * Bujnak, Kukelova, Pajdla, "3D reconstruction from image collections with a single known focal
 * length", ICCV 2009. Published as `focal6p_1s`.
 *
 * `first[k]` is the image of point k in the camera with unknown focal length, relative to the
 * principal point, `second[k]` its ray in the calibrated one, of any length. A fundamental matrix
 * F satisfies `second[k] . F (first[k], 1) = 0`; it is the sum of the matrices that span the null
 * space of these equations, each times its weight. w is 1 / focal^2 in units of the length of all
 * images.
 *
 * Data: first[6][2], second[6][3].
 * A row of 4 numbers, the unknowns: weights[3] (given up to scale: of length 1), w.
 * A row of 10 numbers, the result focal_pose: fundamental[3][3] (given up to scale), focal.
 */
#define ELIMINANT_RELPOSE_6PT_FOCAL_ONE_SIDE_FIRST_LENGTH 12
#define ELIMINANT_RELPOSE_6PT_FOCAL_ONE_SIDE_SECOND_LENGTH 18
#define ELIMINANT_RELPOSE_6PT_FOCAL_ONE_SIDE_UNKNOWNS 4
#define ELIMINANT_RELPOSE_6PT_FOCAL_ONE_SIDE_LENGTH_OF_FOCAL_POSE 10
#define ELIMINANT_RELPOSE_6PT_FOCAL_ONE_SIDE_MAX_SOLUTIONS 9
int32_t eliminant_relpose_6pt_focal_one_side_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_one_side_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_one_side_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_focal_one_side_solve_for_focal_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_one_side_solve_with_for_focal_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_one_side_solve_batch_for_focal_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_focal_one_side_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_6pt_focal_one_side_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_6pt_focal_one_side_second_attempt_operations(void);

/*
 * relpose_6pt_focal_points
 *
 * Relative pose of two cameras with one unknown shared focal length from six points: 15 solutions,
 * of which those with a real focal length are returned.
 *
 * The problem `relpose_6pt_focal` from measurements. `first[k]` and `second[k]` are the images of
 * point k, relative to the principal points. The fundamental matrix is the sum of the matrices
 * that span the null space of the epipolar equations, each times its weight. w is 1 / focal^2 in
 * units of the length of all images.
 *
 * A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
 * the translation has the length 1. Of the four poses of an essential matrix it is the one with
 * the first point in front of both cameras, as in `relpose_5pt_rays`. For a solution that belongs
 * to the scene all points are in front.
 *
 * Data: first[6][2], second[6][2].
 * A row of 4 numbers, the unknowns: weights[3] (given up to scale: of length 1), w.
 * A row of 22 numbers, the result focal_pose: fundamental[3][3] (given up to scale), focal,
 *   rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_6PT_FOCAL_POINTS_FIRST_LENGTH 12
#define ELIMINANT_RELPOSE_6PT_FOCAL_POINTS_SECOND_LENGTH 12
#define ELIMINANT_RELPOSE_6PT_FOCAL_POINTS_UNKNOWNS 4
#define ELIMINANT_RELPOSE_6PT_FOCAL_POINTS_LENGTH_OF_FOCAL_POSE 22
#define ELIMINANT_RELPOSE_6PT_FOCAL_POINTS_MAX_SOLUTIONS 15
int32_t eliminant_relpose_6pt_focal_points_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_points_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_points_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_focal_points_solve_for_focal_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_points_solve_with_for_focal_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_focal_points_solve_batch_for_focal_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_focal_points_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_6pt_focal_points_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_6pt_focal_points_second_attempt_operations(void);

/*
 * relpose_6pt_generalized
 *
 * Relative pose of two generalized cameras from six point correspondences: 64 solutions.
 *
 * Stewénius, Nistér, Oskarsson, Åström, "Solutions to minimal generalized relative pose problems",
 * OMNIVIS 2005. Published as `gen6p`.
 *
 * `first` and `second` hold the rays of the points in either system of cameras: a point of the
 * ray, and its direction. The rotation from the first system to the second is that of the
 * quaternion q. That the rays of one point meet gives the translation up to the
 * depths of that point along either ray; that the rays of any three others meet, too, are linear
 * equations for these depths.
 *
 * A pose X -> rotation X + translation takes the first system to the second, in the unit of the
 * points of the rays.
 *
 * Data: first[6][2][3], second[6][2][3].
 * A row of 4 numbers, the unknowns: q[4] (given up to scale: of length 1).
 * A row of 12 numbers, the result pose: rotation[3][3], translation[3].
 */
#define ELIMINANT_RELPOSE_6PT_GENERALIZED_FIRST_LENGTH 36
#define ELIMINANT_RELPOSE_6PT_GENERALIZED_SECOND_LENGTH 36
#define ELIMINANT_RELPOSE_6PT_GENERALIZED_UNKNOWNS 4
#define ELIMINANT_RELPOSE_6PT_GENERALIZED_LENGTH_OF_POSE 12
#define ELIMINANT_RELPOSE_6PT_GENERALIZED_MAX_SOLUTIONS 64
int32_t eliminant_relpose_6pt_generalized_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_generalized_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_generalized_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_generalized_solve_for_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_generalized_solve_with_for_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_generalized_solve_batch_for_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_generalized_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_6pt_generalized_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_6pt_generalized_second_attempt_operations(void);

/*
 * relpose_6pt_radial
 *
 * The essential matrix and the radial distortion common to two otherwise calibrated cameras from
 * six points: 52 solutions.
 *
 * Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
 * problems for cameras with radial distortion", CVIU 114, 2010. Published as `relpose_6p_rad`,
 * with e33 = 1, which loses planar motions and those without a rotation: e33 is 0.
 *
 * `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
 * distortion and in units of the focal length. An image x lies along (x, 1 + radial |x|^2), the
 * division model. Then x1^T E x2 = 0 is, with e23 = 1, linear in e11, e21, e12, e22, radial e31,
 * e31 and the monomials e32, radial e32, e13, radial e13, 1, radial, radial^2 e33, radial e33,
 * e33: six points give the former as combinations of these. How well depends on which image is the
 * first, and on how the second one is turned about its centre: the best of eight choices is taken.
 * The first image is turned, too, which turns (e13, e23): for usual motions one of these is 0 if
 * it is not.
 *
 * Data: first[6][2], second[6][2].
 * A row of 4 numbers, the unknowns: e_13, e_32, e_33, radial.
 * A row of 10 numbers, the result radial_pose: essential[3][3] (given up to scale), radial.
 */
#define ELIMINANT_RELPOSE_6PT_RADIAL_FIRST_LENGTH 12
#define ELIMINANT_RELPOSE_6PT_RADIAL_SECOND_LENGTH 12
#define ELIMINANT_RELPOSE_6PT_RADIAL_UNKNOWNS 4
#define ELIMINANT_RELPOSE_6PT_RADIAL_LENGTH_OF_RADIAL_POSE 10
#define ELIMINANT_RELPOSE_6PT_RADIAL_MAX_SOLUTIONS 52
int32_t eliminant_relpose_6pt_radial_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_radial_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_radial_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_radial_solve_for_radial_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_radial_solve_with_for_radial_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_6pt_radial_solve_batch_for_radial_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_6pt_radial_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_6pt_radial_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_6pt_radial_second_attempt_operations(void);

/*
 * relpose_7pt_angle_focal_centre
 *
 * Focal length and principal point common to two cameras from their fundamental matrix and the
 * angle of rotation between them: 6 solutions.
 *
 * Martyushev, "Self-calibration of cameras with Euclidean image plane in case of two views and
 * known relative rotation angle", ECCV 2018. Published as `relpose_7p_fuv_angle`.
 *
 * `fundamental` comes from seven points or more, in pixels or any other unit; `half_angle` holds
 * the cosine and the sine of half the angle. The principal point is (x, y), `z` the square of the
 * focal length. With the matrix K of these K^T F K is an essential matrix. F is a multiple of
 * `left`\[0\] `right`\[0\]^T + `left`\[1\] `right`\[1\]^T: with the products A of the left vectors
 * in the quadratic form K K^T, and B of the right ones, B A is a multiple of the identity. With
 * z = 0 all points of a conic are solutions; four combinations of the equations that are divisible
 * by z are stated divided.
 *
 * Data: fundamental[3][3] (of lower rank), half_angle[2] (of length 1).
 * A row of 3 numbers, the unknowns: x, y, z.
 * A row of 3 numbers, the result camera: focal, centre[2].
 */
#define ELIMINANT_RELPOSE_7PT_ANGLE_FOCAL_CENTRE_FUNDAMENTAL_LENGTH 9
#define ELIMINANT_RELPOSE_7PT_ANGLE_FOCAL_CENTRE_HALF_ANGLE_LENGTH 2
#define ELIMINANT_RELPOSE_7PT_ANGLE_FOCAL_CENTRE_UNKNOWNS 3
#define ELIMINANT_RELPOSE_7PT_ANGLE_FOCAL_CENTRE_LENGTH_OF_CAMERA 3
#define ELIMINANT_RELPOSE_7PT_ANGLE_FOCAL_CENTRE_MAX_SOLUTIONS 6
int32_t eliminant_relpose_7pt_angle_focal_centre_solve(
    const double *fundamental, size_t fundamental_length, const double *half_angle,
    size_t half_angle_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_angle_focal_centre_solve_with(
    uint64_t second_attempts, const double *fundamental, size_t fundamental_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_7pt_angle_focal_centre_solve_batch(
    size_t instances, const double *fundamental, size_t fundamental_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t solutions_length,
    size_t *counts, int32_t *codes);
int32_t eliminant_relpose_7pt_angle_focal_centre_solve_for_camera(
    const double *fundamental, size_t fundamental_length, const double *half_angle,
    size_t half_angle_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_angle_focal_centre_solve_with_for_camera(
    uint64_t second_attempts, const double *fundamental, size_t fundamental_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_relpose_7pt_angle_focal_centre_solve_batch_for_camera(
    size_t instances, const double *fundamental, size_t fundamental_length,
    const double *half_angle, size_t half_angle_length, double *solutions, size_t solutions_length,
    size_t *counts, int32_t *codes);
int32_t eliminant_relpose_7pt_angle_focal_centre_relative_residual(
    const double *fundamental, size_t fundamental_length, const double *half_angle,
    size_t half_angle_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_relpose_7pt_angle_focal_centre_error_bound(
    const double *fundamental, size_t fundamental_length, const double *half_angle,
    size_t half_angle_length, const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_7pt_angle_focal_centre_second_attempt_operations(void);

/*
 * relpose_7pt_focal_radial
 *
 * Relative pose, focal length and radial distortion common to two cameras from seven point
 * correspondences: 68 solutions, of which those with a real focal length are returned.
 *
 * Jiang, Kuang, Solem, Åström, "A minimal solution to relative pose with unknown focal length and
 * radial distortion", ACCV 2014. Published as `relpose_7p_fr`.
 *
 * `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
 * An image x lies along (x, 1 + radial |x|^2), the division model. Then x1^T F x2 = 0 is, with f33
 * = 1, linear in f11, f21, f12, f22, radial f31, radial^2, f31 and the monomials f32, radial f32,
 * f13, radial f13, f23, radial f23, radial, 1: seven points give the former as combinations of
 * these. How well depends on which image is the first, and on how the second one is turned about
 * its centre: the best of eight choices is taken. The first image may be turned, too, which turns
 * (f13, f23), and `radial` may have any unit: they are such that in f31 radial f23 has the
 * coefficient 0 and radial f13 the coefficient 1. With the focal length, diag(focal, focal, 1) F
 * diag(focal, focal, 1) is an essential matrix; `w` is 1 / focal^2.
 *
 * Everything is p + radial q, two polynomials without `radial`, modulo the equation that gives
 * radial^2, and most equations are stated times `radial`, too. There are points at infinity, near
 * which residuals are small; there the factors that are stated not to vanish are small beside
 * their terms.
 *
 * Data: first[7][2], second[7][2].
 * A row of 5 numbers, the unknowns: w, f_32, f_13, f_23, radial.
 * A row of 11 numbers, the result radial_focal_pose: fundamental[3][3] (given up to scale), focal,
 *   radial.
 */
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_FIRST_LENGTH 14
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_SECOND_LENGTH 14
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_UNKNOWNS 5
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_LENGTH_OF_RADIAL_FOCAL_POSE 11
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_MAX_SOLUTIONS 68
int32_t eliminant_relpose_7pt_focal_radial_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_focal_radial_solve_for_radial_focal_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_solve_with_for_radial_focal_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_solve_batch_for_radial_focal_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_focal_radial_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_7pt_focal_radial_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_7pt_focal_radial_second_attempt_operations(void);

/*
 * relpose_7pt_focal_radial_one_side
 *
 * Relative pose, focal length and radial distortion of the first camera, the second calibrated,
 * from seven points: 19 solutions, of which those with a real focal length are returned.
 *
 * Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
 * distortion", CVPR 2014. Published as `relpose_7p_fr_1s`;
 * `relpose_7pt_focal_radial_one_side_eliminated` is a formulation without the focal length.
 *
 * `first[k]` is the distorted image of point k in the first camera, relative to the principal
 * point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
 * first image lies along (x1, 1 + radial |x1|^2), the division model. Then x1^T F x2 = 0 is linear
 * in the first two rows of F, radial f33 and the monomials radial f31, radial f32, f31, f32, f33:
 * seven points give the former as combinations of these. `third` is the third row of F, which is
 * given up to scale. It vanishes where the first camera moves along its optical axis: then the
 * points tell nothing of the distortion. With f33 = 1, as published, planar motions and those
 * without a rotation are lost. With the focal length, diag(focal, focal, 1) F is an essential
 * matrix; `w` is 1 / focal^2.
 *
 * Data: first[7][2], second[7][2].
 * A row of 5 numbers, the unknowns: w, third[3] (given up to scale: of length 1), radial.
 * A row of 11 numbers, the result radial_focal_pose: fundamental[3][3] (given up to scale), focal,
 *   radial.
 */
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_FIRST_LENGTH 14
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_SECOND_LENGTH 14
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_UNKNOWNS 5
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_LENGTH_OF_RADIAL_FOCAL_POSE 11
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_MAX_SOLUTIONS 19
int32_t eliminant_relpose_7pt_focal_radial_one_side_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_focal_radial_one_side_solve_for_radial_focal_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_solve_with_for_radial_focal_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_solve_batch_for_radial_focal_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_focal_radial_one_side_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_7pt_focal_radial_one_side_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_7pt_focal_radial_one_side_second_attempt_operations(void);

/*
 * relpose_7pt_focal_radial_one_side_eliminated
 *
 * Relative pose and radial distortion of the first camera, whose focal length is unknown, too, and
 * eliminated, the second calibrated, from seven points: 19 solutions.
 *
 * Kukelova, Kileel, Sturmfels, Pajdla, "A clever elimination strategy for efficient minimal
 * solvers", CVPR 2017. Published as `relpose_7p_fr_1s_elr`.
 *
 * `first[k]` is the distorted image of point k in the first camera, relative to the principal
 * point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
 * first image lies along (x1, 1 + radial |x1|^2), the division model. Then x2^T F x1 = 0 is linear
 * in radial f33, the first two columns of F and the monomials radial f13, radial f23, f13, f23,
 * f33: seven points give the former as combinations of these. `third` is the third column of F,
 * which is given up to scale. It vanishes where the first camera moves along its optical axis:
 * then the points tell nothing of the distortion. With f33 = 1, as published, planar motions and
 * those without a rotation are lost. F diag(focal, focal, 1) is an essential matrix for some focal
 * length: with A the first two columns of F, the third is an eigenvector of A A^T, and where mu is
 * its eigenvalue, |third column|^2 / focal^2 = trace(A A^T) - 2 mu.
 *
 * Data: first[7][2], second[7][2].
 * A row of 4 numbers, the unknowns: third[3] (given up to scale: of length 1), radial.
 * A row of 10 numbers, the result radial_epipolar: fundamental[3][3] (given up to scale), radial.
 */
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_ELIMINATED_FIRST_LENGTH 14
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_ELIMINATED_SECOND_LENGTH 14
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_ELIMINATED_UNKNOWNS 4
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_ELIMINATED_LENGTH_OF_RADIAL_EPIPOLAR 10
#define ELIMINANT_RELPOSE_7PT_FOCAL_RADIAL_ONE_SIDE_ELIMINATED_MAX_SOLUTIONS 19
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_for_radial_epipolar(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_with_for_radial_epipolar(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_batch_for_radial_epipolar(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_7pt_focal_radial_one_side_eliminated_second_attempt_operations(void);

/*
 * relpose_7pt_generalized_scale
 *
 * Relative pose and relative scale of two generalized cameras from seven point correspondences:
 * 140 solutions.
 *
 * Kneip, Sweeney, Hartley, "The generalized relative pose and scale problem: View-graph fusion via
 * 2D-2D registration", WACV 2016. Published as `gen_relpose_scale`.
 *
 * `first` and `second` hold the rays of the points in either system of cameras: a point of the
 * ray, and its direction. The rotation from the first system to the second is that of the
 * quaternion q, and points of the second system are multiplied by its scale.
 * That the rays of one point meet gives the translation up to the depths of that point along
 * either ray and the scale; that the rays of any four others meet, too, are linear equations for
 * these three. What is stated depends on these five points, not on which is the first.
 *
 * For a point of the rays, rotation p1 + translation = scale p2, with p1 in the first system and
 * p2 in the second.
 *
 * Data: first[7][2][3], second[7][2][3].
 * A row of 4 numbers, the unknowns: q[4] (given up to scale: of length 1).
 * A row of 13 numbers, the result scaled_pose: rotation[3][3], translation[3], scale.
 */
#define ELIMINANT_RELPOSE_7PT_GENERALIZED_SCALE_FIRST_LENGTH 42
#define ELIMINANT_RELPOSE_7PT_GENERALIZED_SCALE_SECOND_LENGTH 42
#define ELIMINANT_RELPOSE_7PT_GENERALIZED_SCALE_UNKNOWNS 4
#define ELIMINANT_RELPOSE_7PT_GENERALIZED_SCALE_LENGTH_OF_SCALED_POSE 13
#define ELIMINANT_RELPOSE_7PT_GENERALIZED_SCALE_MAX_SOLUTIONS 140
int32_t eliminant_relpose_7pt_generalized_scale_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_generalized_scale_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_generalized_scale_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_generalized_scale_solve_for_scaled_pose(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_generalized_scale_solve_with_for_scaled_pose(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_relpose_7pt_generalized_scale_solve_batch_for_scaled_pose(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_relpose_7pt_generalized_scale_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_relpose_7pt_generalized_scale_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_relpose_7pt_generalized_scale_second_attempt_operations(void);

/*
 * stitching_3pt_radial_focal
 *
 * Rotation between two photographs with common unknown focal length and radial distortion, a
 * panorama, from three points: 18 solutions, of which those with a real focal length are returned.
 *
 * Naroditsky, Daniilidis, "Optimizing polynomial solvers for minimal geometry problems", ICCV
 * 2011, after Byröd, Brown, Åström, "Minimal solutions for panoramic stitching with radial
 * distortion", BMVC 2009. Published as `stitching`.
 *
 * `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
 * A point p lies along (p, focal (1 + radial |p|^2)), the division model. Two points with the
 * inner product xy of their rays, in the first image, and x'y' in the second, satisfy xy^2 x'x'
 * y'y' = x'y'^2 xx yy. With w = 1/focal^2 both sides divided by focal^8 are polynomials in w whose
 * difference has no term without w; it is divided by w.
 *
 * Data: first[3][2], second[3][2].
 * A row of 2 numbers, the unknowns: radial, w.
 * A row of 2 numbers, the result panorama: focal, radial.
 */
#define ELIMINANT_STITCHING_3PT_RADIAL_FOCAL_FIRST_LENGTH 6
#define ELIMINANT_STITCHING_3PT_RADIAL_FOCAL_SECOND_LENGTH 6
#define ELIMINANT_STITCHING_3PT_RADIAL_FOCAL_UNKNOWNS 2
#define ELIMINANT_STITCHING_3PT_RADIAL_FOCAL_LENGTH_OF_PANORAMA 2
#define ELIMINANT_STITCHING_3PT_RADIAL_FOCAL_MAX_SOLUTIONS 18
int32_t eliminant_stitching_3pt_radial_focal_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_stitching_3pt_radial_focal_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_stitching_3pt_radial_focal_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_stitching_3pt_radial_focal_solve_for_panorama(
    const double *first, size_t first_length, const double *second, size_t second_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_stitching_3pt_radial_focal_solve_with_for_panorama(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_stitching_3pt_radial_focal_solve_batch_for_panorama(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_stitching_3pt_radial_focal_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_stitching_3pt_radial_focal_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_stitching_3pt_radial_focal_second_attempt_operations(void);

/*
 * tensor_eigenvectors
 *
 * Eigenvectors of a 3 x 3 x 3 tensor, scaled to eigenvalue 1: x_i = sum over j and k of a_ijk x_j
 * x_k, 8 solutions with x = 0.
 *
 * Cartwright and Sturmfels, "The number of eigenvalues of a tensor", Linear Algebra and its
 * Applications 2013: 7 of them for general data. The method of moments reads the parts of a
 * mixture from them (Anandkumar, Ge, Hsu, Kakade, Telgarsky, "Tensor decompositions for learning
 * latent variable models", JMLR 2014, section 4).
 *
 * Data: a[3][3][3].
 * A row of 3 numbers, the unknowns: x, y, z.
 */
#define ELIMINANT_TENSOR_EIGENVECTORS_A_LENGTH 27
#define ELIMINANT_TENSOR_EIGENVECTORS_UNKNOWNS 3
#define ELIMINANT_TENSOR_EIGENVECTORS_MAX_SOLUTIONS 8
int32_t eliminant_tensor_eigenvectors_solve(
    const double *a, size_t a_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_tensor_eigenvectors_solve_with(
    uint64_t second_attempts, const double *a, size_t a_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_tensor_eigenvectors_solve_batch(
    size_t instances, const double *a, size_t a_length, double *solutions, size_t solutions_length,
    size_t *counts, int32_t *codes);
int32_t eliminant_tensor_eigenvectors_relative_residual(
    const double *a, size_t a_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_tensor_eigenvectors_error_bound(
    const double *a, size_t a_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_tensor_eigenvectors_second_attempt_operations(void);

/*
 * three_quadrics
 *
 * The intersection of three general quadrics: 8 solutions by Bézout's theorem.
 *
 * Kukelova, Heller, Fitzgibbon, "Efficient intersection of three quadrics and applications in
 * computer vision", CVPR 2016.
 *
 * `quadrics` holds the coefficients of x^2, x y, x z, y^2, y z, z^2, x, y, z, 1, a quadric in each
 * row.
 *
 * Data: quadrics[3][10].
 * A row of 3 numbers, the unknowns: x, y, z.
 */
#define ELIMINANT_THREE_QUADRICS_QUADRICS_LENGTH 30
#define ELIMINANT_THREE_QUADRICS_UNKNOWNS 3
#define ELIMINANT_THREE_QUADRICS_MAX_SOLUTIONS 8
int32_t eliminant_three_quadrics_solve(
    const double *quadrics, size_t quadrics_length, double *solutions, size_t capacity,
    size_t *count);
int32_t eliminant_three_quadrics_solve_with(
    uint64_t second_attempts, const double *quadrics, size_t quadrics_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_three_quadrics_solve_batch(
    size_t instances, const double *quadrics, size_t quadrics_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_three_quadrics_relative_residual(
    const double *quadrics, size_t quadrics_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_three_quadrics_error_bound(
    const double *quadrics, size_t quadrics_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_three_quadrics_second_attempt_operations(void);

/*
 * triangulation_3view
 *
 * Triangulation from three views, all stationary points of the sum of squared reprojection errors:
 * 47 solutions.
 *
 * Stewénius, Schaffalitzky, Nistér, "How hard is 3-view triangulation really?", ICCV 2005.
 * Published as `3v_triang_laurent`.
 *
 * `cameras` are the projection matrices of the views and `images` where they see the point. The
 * unknowns are projective coordinates (x, y, z, 1) of the point: x and y its depths in the first
 * and second view over that in the third, each times a constant, and z its first error in the
 * third view. Every image is turned so that its second error does not depend on z, and scales are
 * such that in the errors of the first two views over their depths, x and y, z has the
 * coefficient 1. The planes of depth zero must meet in one point: the three images must not all be
 * parallel, as rectified ones are.
 *
 * Stated are derivatives towards seven points. Where the depth of a view vanishes, so does a power
 * of it in the denominators; where the errors of a view vanish, too, at its centre, they do not
 * change at all.
 *
 * Data: cameras[3][3][4], images[3][2].
 * A row of 3 numbers, the unknowns: x, y, z.
 * A row of 3 numbers, the result point: position[3].
 */
#define ELIMINANT_TRIANGULATION_3VIEW_CAMERAS_LENGTH 36
#define ELIMINANT_TRIANGULATION_3VIEW_IMAGES_LENGTH 6
#define ELIMINANT_TRIANGULATION_3VIEW_UNKNOWNS 3
#define ELIMINANT_TRIANGULATION_3VIEW_LENGTH_OF_POINT 3
#define ELIMINANT_TRIANGULATION_3VIEW_MAX_SOLUTIONS 47
int32_t eliminant_triangulation_3view_solve(
    const double *cameras, size_t cameras_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_solve_with(
    uint64_t second_attempts, const double *cameras, size_t cameras_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_solve_batch(
    size_t instances, const double *cameras, size_t cameras_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_triangulation_3view_solve_for_point(
    const double *cameras, size_t cameras_length, const double *images, size_t images_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_solve_with_for_point(
    uint64_t second_attempts, const double *cameras, size_t cameras_length, const double *images,
    size_t images_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_solve_batch_for_point(
    size_t instances, const double *cameras, size_t cameras_length, const double *images,
    size_t images_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_triangulation_3view_relative_residual(
    const double *cameras, size_t cameras_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_triangulation_3view_error_bound(
    const double *cameras, size_t cameras_length, const double *images, size_t images_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_triangulation_3view_second_attempt_operations(void);

/*
 * triangulation_3view_relaxed
 *
 * Triangulation from three views with two of the three epipolar constraints, all stationary points
 * of the least-squares cost: 27 solutions.
 *
 * Kukelova, Pajdla, Bujnak, "Fast and stable algebraic solution to L2 three-view triangulation",
 * 3DV 2013. Published as `l2_3view_triang`, for matrices of full rank, which give 31 solutions.
 * Fundamental and essential matrices have rank 2, and with them four of the 31 are at infinity.
 *
 * `image` holds the measured image points, one a row. The corrected ones (x1, x2), (x3, x4) and
 * (x5, x6) are the closest to these that satisfy p1^T `first` p2 = 0 and p2^T `second` p3 = 0,
 * with the multipliers x7 and x8. The cost is the sum of the squared distances.
 *
 * Data: first[3][3] (of lower rank), second[3][3] (of lower rank), image[3][2].
 * A row of 8 numbers, the unknowns: x1, x2, x3, x4, x5, x6, x7, x8.
 * A row of 7 numbers, the result corrected: images[3][2], cost.
 */
#define ELIMINANT_TRIANGULATION_3VIEW_RELAXED_FIRST_LENGTH 9
#define ELIMINANT_TRIANGULATION_3VIEW_RELAXED_SECOND_LENGTH 9
#define ELIMINANT_TRIANGULATION_3VIEW_RELAXED_IMAGE_LENGTH 6
#define ELIMINANT_TRIANGULATION_3VIEW_RELAXED_UNKNOWNS 8
#define ELIMINANT_TRIANGULATION_3VIEW_RELAXED_LENGTH_OF_CORRECTED 7
#define ELIMINANT_TRIANGULATION_3VIEW_RELAXED_MAX_SOLUTIONS 27
int32_t eliminant_triangulation_3view_relaxed_solve(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *image, size_t image_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_relaxed_solve_with(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *image, size_t image_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_relaxed_solve_batch(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *image, size_t image_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_triangulation_3view_relaxed_solve_for_corrected(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *image, size_t image_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_relaxed_solve_with_for_corrected(
    uint64_t second_attempts, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *image, size_t image_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_triangulation_3view_relaxed_solve_batch_for_corrected(
    size_t instances, const double *first, size_t first_length, const double *second,
    size_t second_length, const double *image, size_t image_length, double *solutions,
    size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_triangulation_3view_relaxed_relative_residual(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *image, size_t image_length, const double *solution, size_t solution_length,
    double *relative_residual);
int32_t eliminant_triangulation_3view_relaxed_error_bound(
    const double *first, size_t first_length, const double *second, size_t second_length,
    const double *image, size_t image_length, const double *solution, size_t solution_length,
    double *error_bound);
uint64_t eliminant_triangulation_3view_relaxed_second_attempt_operations(void);

/*
 * trilateration
 *
 * A point at given distances from three known points: 2 solutions, mirror images in the plane of
 * the three.
 *
 * Thomas & Ros, "Revisiting trilateration for robot localization", IEEE Transactions on Robotics
 * 21(1), 2005.
 *
 * `centres` holds the known points, one a row; `distances` the distances from them, in the same
 * unit.
 *
 * Data: centres[3][3], distances[3].
 * A row of 3 numbers, the unknowns: x, y, z.
 */
#define ELIMINANT_TRILATERATION_CENTRES_LENGTH 9
#define ELIMINANT_TRILATERATION_DISTANCES_LENGTH 3
#define ELIMINANT_TRILATERATION_UNKNOWNS 3
#define ELIMINANT_TRILATERATION_MAX_SOLUTIONS 2
int32_t eliminant_trilateration_solve(
    const double *centres, size_t centres_length, const double *distances, size_t distances_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_trilateration_solve_with(
    uint64_t second_attempts, const double *centres, size_t centres_length, const double *distances,
    size_t distances_length, double *solutions, size_t capacity, size_t *count);
int32_t eliminant_trilateration_solve_batch(
    size_t instances, const double *centres, size_t centres_length, const double *distances,
    size_t distances_length, double *solutions, size_t solutions_length, size_t *counts,
    int32_t *codes);
int32_t eliminant_trilateration_relative_residual(
    const double *centres, size_t centres_length, const double *distances, size_t distances_length,
    const double *solution, size_t solution_length, double *relative_residual);
int32_t eliminant_trilateration_error_bound(
    const double *centres, size_t centres_length, const double *distances, size_t distances_length,
    const double *solution, size_t solution_length, double *error_bound);
uint64_t eliminant_trilateration_second_attempt_operations(void);

/*
 * two_conics
 *
 * The intersection of two general conics: 4 solutions by Bézout's theorem.
 *
 * Kukelova, Bujnak, Pajdla, "Automatic Generator of Minimal Problem Solvers", ECCV 2008, use two
 * such quadrics as their running example.
 *
 * `p` and `q` hold the coefficients of x^2, x y, y^2, x, y, 1.
 *
 * Data: p[6], q[6].
 * A row of 2 numbers, the unknowns: x, y.
 */
#define ELIMINANT_TWO_CONICS_P_LENGTH 6
#define ELIMINANT_TWO_CONICS_Q_LENGTH 6
#define ELIMINANT_TWO_CONICS_UNKNOWNS 2
#define ELIMINANT_TWO_CONICS_MAX_SOLUTIONS 4
int32_t eliminant_two_conics_solve(
    const double *p, size_t p_length, const double *q, size_t q_length, double *solutions,
    size_t capacity, size_t *count);
int32_t eliminant_two_conics_solve_with(
    uint64_t second_attempts, const double *p, size_t p_length, const double *q, size_t q_length,
    double *solutions, size_t capacity, size_t *count);
int32_t eliminant_two_conics_solve_batch(
    size_t instances, const double *p, size_t p_length, const double *q, size_t q_length,
    double *solutions, size_t solutions_length, size_t *counts, int32_t *codes);
int32_t eliminant_two_conics_relative_residual(
    const double *p, size_t p_length, const double *q, size_t q_length, const double *solution,
    size_t solution_length, double *relative_residual);
int32_t eliminant_two_conics_error_bound(
    const double *p, size_t p_length, const double *q, size_t q_length, const double *solution,
    size_t solution_length, double *error_bound);
uint64_t eliminant_two_conics_second_attempt_operations(void);

#ifdef __cplusplus
}
#endif

#endif
