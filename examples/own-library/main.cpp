// The two solvers of this library. Where did the sound come from, that three microphones heard?
// Which bar guides a body through five poses?
#include "own.hpp"

#include <cmath>
#include <complex>
#include <cstdio>

// Whether a bar is found from a joint of the frame to a joint of the body that it guides.
static bool finds_the_bar() {
    using Complex = std::complex<double>;
    const Complex on_body(1.0, 0.5), on_frame(-0.5, -1.0), bar = on_body - on_frame;
    double turns[4][2], shifts[4][2];
    for (int k = 0; k < 4; ++k) {
        const Complex turn = std::polar(1.0, 0.3 * (k + 1));
        const Complex shift = on_frame + bar * std::polar(1.0, 0.5 * k * k - 0.4) - turn * on_body;
        turns[k][0] = turn.real(), turns[k][1] = turn.imag();
        shifts[k][0] = shift.real(), shifts[k][1] = shift.imag();
    }
    double error = INFINITY;
    // Five poses in general: one attempt suffices.
    for (const auto &found : own::linkage_5_poses::solve_with(own::SecondAttempts::never(), turns, shifts)) {
        std::printf("a bar from %.6f %.6f, known to %.1e\n", found.on_frame[0], found.on_frame[1],
                    own::linkage_5_poses::error_bound(turns, shifts, found));
        error = std::fmin(error, std::abs(Complex(found.on_frame[0], found.on_frame[1]) - on_frame));
    }
    return error < 1e-9;
}

int main() {
    if (!finds_the_bar()) {
        std::fprintf(stderr, "error: the bar is none of these\n");
        return 1;
    }
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
