// Where did the sound come from? Three microphones, and the solver of this library.
#include "own.hpp"

#include <cmath>
#include <cstdio>

int main() {
    const double microphones[3][2] = {{0.0, 0.0}, {4.0, 0.0}, {0.0, 3.0}};
    const double source[2] = {2.5, 1.5}, time = 10.0;
    double arrivals[3];
    for (int k = 0; k < 3; ++k)
        arrivals[k] = time + std::hypot(source[0] - microphones[k][0], source[1] - microphones[k][1]);

    double error = INFINITY;
    for (const auto &found : own::sound_source::solve_for_source(microphones, arrivals)) {
        std::printf("position %.6f %.6f, first heard after %.6f\n", found.position[0], found.position[1],
                    found.distances[0]);
        error = std::fmin(error, std::hypot(found.position[0] - source[0], found.position[1] - source[1]));
    }
    // Rounding errors of the arrivals, some 1e-15, grow by geometry.
    if (!(error < 1e-9)) {
        std::fprintf(stderr, "error: the source is none of these\n");
        return 1;
    }
    const auto refused = own::sound_source::try_solve(microphones, own::Span<const double>(arrivals, 2));
    std::printf("two arrivals: %s\n", refused.text());
    return refused ? 1 : 0;
}
