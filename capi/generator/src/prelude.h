/*
 * @name@.h: solvers of polynomial problems, as C functions.
 *
 * Written by eliminant-capi-generator @version@. Do not edit.
 *
 * Data are numbers in the order of the problem file, arrays row by row, each list with its length,
 * which must be the one that is documented (`.._LENGTH`). Solutions are rows of numbers. All memory
 * is the caller's, and the functions keep none of it. They may be called from several threads.
 *
 * `.._solve` writes at most `capacity` rows, and their number to `count`. Room for MAX_SOLUTIONS
 * rows always suffices. If there are more solutions than room, the code is @NAME@_SHORT_BUFFER,
 * and `count` their number. No solution is no error: `count` is then 0.
 *
 * `.._solve_with` is `.._solve` with a bound on second attempts. They are made at twice the
 * precision where solutions are missing, and take some twenty times as long. `second_attempts` is
 * @NAME@_ALWAYS, as in `.._solve`, @NAME@_NEVER, or the most operations that a second attempt may
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
#ifndef @NAME@_H
#define @NAME@_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* All went well. */
#define @NAME@_OK 0
/* A pointer is null, and numbers had to be read or written there. */
#define @NAME@_NULL_POINTER 1
/* A pointer is not a multiple of the alignment of what it points to. */
#define @NAME@_MISALIGNED_POINTER 2
/* A list of data has another length than is documented. */
#define @NAME@_WRONG_LENGTH 3
/* There are more solutions than there is room for. */
#define @NAME@_SHORT_BUFFER 4
/* The data hold an infinite value or a NaN. */
#define @NAME@_NON_FINITE_INPUT 5
/* Degenerate data: the elimination lost rank. */
#define @NAME@_DEGENERATE 6
/* Degenerate data: a matrix from which data are derived has lost rank. */
#define @NAME@_LOST_RANK 7
/* A number computed from the data is not finite. */
#define @NAME@_OVERFLOW 8
/* The problem needs larger arrays than are set aside. */
#define @NAME@_TOO_LARGE 9
/* The eigenvalue iteration reached its limit. */
#define @NAME@_NO_CONVERGENCE 10
/* The solver panicked, which is an error of the library. */
#define @NAME@_PANIC 11
/* An error that this version does not know. */
#define @NAME@_OTHER 12

/* Second attempts wherever solutions are missing, and paths from data nearby. */
#define @NAME@_ALWAYS UINT64_MAX
/* No second attempts. */
#define @NAME@_NEVER 0

/* The version that wrote this header. */
#define @NAME@_VERSION "@version@"

/* A sentence in English for a code, for any other number, too. It lives as long as the library. */
const char *@name@_error_text(int32_t code);

/* The version of the library, as @NAME@_VERSION is that of the header. */
const char *@name@_version(void);

@problems@
#ifdef __cplusplus
}
#endif

#endif
