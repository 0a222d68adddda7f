// Many five-point problems: one call for each, and one call for all. Both give the same solutions
// up to rounding; the times are printed.
#include <eliminant.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace five_point = eliminant::relpose_5pt_rays;

using Rays = std::array<std::array<double, 3>, 5>;
using Clock = std::chrono::steady_clock;

namespace {

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Five points before two cameras that are turned against each other a little.
void add_instance(std::mt19937 &random, std::vector<Rays> &first, std::vector<Rays> &second) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const double angle = 0.3 * uniform(random), c = std::cos(angle), s = std::sin(angle);
    const double t[3] = {uniform(random), uniform(random), uniform(random)};
    Rays a{}, b{};
    for (std::size_t k = 0; k < 5; ++k) {
        const double x = 2.0 * uniform(random), y = 2.0 * uniform(random), z = 6.0 + 2.0 * uniform(random);
        a[k] = {x, y, z};
        b[k] = {c * x + s * z + t[0], y + t[1], c * z - s * x + t[2]};
    }
    first.push_back(a);
    second.push_back(b);
}

// The distance of a solution from the nearest of a list. Weights are given up to sign.
double distance_to(const five_point::Solution &solution, eliminant::Span<const five_point::Solution> list) {
    double least = INFINITY;
    for (const auto &other : list) {
        double plus = 0.0, minus = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            plus = std::fmax(plus, std::fabs(solution.weights[i] - other.weights[i]));
            minus = std::fmax(minus, std::fabs(solution.weights[i] + other.weights[i]));
        }
        least = std::fmin(least, std::fmin(plus, minus));
    }
    return least;
}

} // namespace

int main(int arguments, char **argument) {
    const std::size_t instances = arguments > 1 ? std::strtoul(argument[1], nullptr, 10) : 2000;
    std::mt19937 random(1);
    std::vector<Rays> first, second;
    for (std::size_t k = 0; k < instances; ++k) add_instance(random, first, second);

    double single = INFINITY, many = INFINITY;
    std::vector<eliminant::Solutions<five_point::Solution, five_point::max_solutions>> one_by_one(instances);
    eliminant::Batch<five_point::Solution, five_point::max_solutions> batch;
    // The first round allocates; the fastest counts.
    for (int round = 0; round < 5; ++round) {
        auto start = Clock::now();
        for (std::size_t k = 0; k < instances; ++k) one_by_one[k] = *five_point::try_solve(first[k], second[k]);
        single = std::fmin(single, seconds_since(start));
        start = Clock::now();
        five_point::solve_batch(instances, first, second, batch);
        many = std::fmin(many, seconds_since(start));
    }
    std::size_t solutions = 0, lost = 0;
    for (std::size_t k = 0; k < instances; ++k) {
        for (const auto &solution : one_by_one[k]) {
            ++solutions;
            lost += !(distance_to(solution, batch[k]) < 1e-6);
        }
    }
    const double n = static_cast<double>(instances);
    std::printf("%zu instances, %zu solutions, of which %zu are not in the batch to 1e-6\n", instances, solutions, lost);
    std::printf("one call each %.0f ns, one call for all %.0f ns an instance, ratio %.2f\n", 1e9 * single / n,
                1e9 * many / n, single / many);
    // Solutions of nearly multiple roots may differ.
    return lost * 1000 <= solutions ? 0 : 1;
}
