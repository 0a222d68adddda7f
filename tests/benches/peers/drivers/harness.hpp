// The side of a peer: reads instances from a file, solves chunks of them on request, and answers
// with the time that they took. The bench `peers` compiles it and talks to it by lines:
//
//   time FIRST COUNT  ->  NANOSECONDS SOLUTIONS          instances FIRST .. FIRST + COUNT
//   solutions INDEX   ->  N VALUE VALUE ..               all solutions of one instance
//
// The file holds 64-bit floating-point numbers of this machine: how many instances there are, how
// many numbers each has, then the instances.
#pragma once

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

// One solver: keeps the instances in the types that its callers hold.
struct Solver {
    virtual ~Solver() = default;
    virtual void load(const double *data) = 0;
    // Solves one instance into buffers that are kept; how many solutions there are.
    virtual size_t solve(size_t index) = 0;
    // The solutions of the last call, one after the other, as the bench compares them.
    virtual std::vector<double> solutions() const = 0;
};

inline int serve(Solver &solver, const char *path) {
    std::FILE *file = std::fopen(path, "rb");
    if (!file) return 1;
    double head[2];
    if (std::fread(head, sizeof(double), 2, file) != 2) return 1;
    const size_t count = size_t(head[0]), width = size_t(head[1]);
    std::vector<double> data(width);
    for (size_t k = 0; k < count; ++k) {
        if (std::fread(data.data(), sizeof(double), width, file) != width) return 1;
        solver.load(data.data());
    }
    std::fclose(file);
    char line[128];
    while (std::fgets(line, sizeof line, stdin)) {
        size_t first = 0, number = 0;
        if (std::sscanf(line, "time %zu %zu", &first, &number) == 2 && first + number <= count) {
            const auto start = std::chrono::steady_clock::now();
            size_t found = 0;
            for (size_t k = first; k < first + number; ++k) found += solver.solve(k);
            const auto time = std::chrono::steady_clock::now() - start;
            const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
            std::printf("%lld %zu\n", static_cast<long long>(nanoseconds), found);
        } else if (std::sscanf(line, "solutions %zu", &first) == 1 && first < count) {
            solver.solve(first);
            const std::vector<double> values = solver.solutions();
            std::printf("%zu", values.size());
            for (double value : values) std::printf(" %.17g", value);
            std::printf("\n");
        } else {
            return 2;
        }
        std::fflush(stdout);
    }
    return 0;
}
