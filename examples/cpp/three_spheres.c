/* Positions at given distances from three centres, and what a call says that is wrong. C99. */
#include <eliminant.h>

#include <stdio.h>
#include <string.h>

int main(void) {
    const double centres[3][3] = {{0.0, 0.0, 1.0}, {4.0, 0.0, 0.0}, {0.0, 3.0, 0.0}};
    const double distances[3] = {2.0, 3.0, 3.5};
    double solutions[ELIMINANT_TRILATERATION_MAX_SOLUTIONS][ELIMINANT_TRILATERATION_UNKNOWNS];
    size_t count = 0, k, i;
    int32_t code = eliminant_trilateration_solve(
        &centres[0][0], ELIMINANT_TRILATERATION_CENTRES_LENGTH, distances,
        ELIMINANT_TRILATERATION_DISTANCES_LENGTH, &solutions[0][0], ELIMINANT_TRILATERATION_MAX_SOLUTIONS, &count);
    if (code != ELIMINANT_OK || strcmp(eliminant_version(), ELIMINANT_VERSION) != 0) {
        fprintf(stderr, "error: %s\n", eliminant_error_text(code));
        return 1;
    }
    for (k = 0; k < count; ++k) {
        double bound = 1.0;
        code = eliminant_trilateration_error_bound(
            &centres[0][0], ELIMINANT_TRILATERATION_CENTRES_LENGTH, distances,
            ELIMINANT_TRILATERATION_DISTANCES_LENGTH, solutions[k], ELIMINANT_TRILATERATION_UNKNOWNS, &bound);
        printf("%.6f %.6f %.6f, known to %.1e\n", solutions[k][0], solutions[k][1], solutions[k][2], bound);
        if (code != ELIMINANT_OK || !(bound < 1e-12)) {
            fprintf(stderr, "error: solution %u is not known well: %s\n", (unsigned)k, eliminant_error_text(code));
            return 1;
        }
        for (i = 0; i < 3; ++i) {
            const double dx = solutions[k][0] - centres[i][0], dy = solutions[k][1] - centres[i][1],
                         dz = solutions[k][2] - centres[i][2];
            const double error = dx * dx + dy * dy + dz * dz - distances[i] * distances[i];
            if (error > 1e-12 || error < -1e-12) {
                fprintf(stderr, "error: distance %u is off\n", (unsigned)i);
                return 1;
            }
        }
    }
    code = eliminant_trilateration_solve(NULL, ELIMINANT_TRILATERATION_CENTRES_LENGTH, distances,
                                         ELIMINANT_TRILATERATION_DISTANCES_LENGTH, &solutions[0][0],
                                         ELIMINANT_TRILATERATION_MAX_SOLUTIONS, &count);
    printf("without centres: code %d, %s\n", (int)code, eliminant_error_text(code));
    return code == ELIMINANT_NULL_POINTER && count == 0 ? 0 : 1;
}
