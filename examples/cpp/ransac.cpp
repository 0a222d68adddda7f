// Relative pose of two cameras from point correspondences, many of them wrong: five-point RANSAC.
//
// The scene is synthetic, so that the essential matrix is known. Every sample of five
// correspondences gives up to ten essential matrices; the one with most inliers wins.
#include <eliminant.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace five_point = eliminant::relpose_5pt_rays;

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

namespace {

constexpr std::size_t points = 200, wrong = 80, samples = 300, sample_size = 5;
// Image coordinates are in units of the focal length.
constexpr double noise = 1e-4, threshold = 4 * noise;

struct Scene {
    std::vector<Vector> first, second;
    Matrix essential;
};

double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector times(const Matrix &m, const Vector &v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Matrix transposed(const Matrix &m) {
    Matrix t{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) t[i][j] = m[j][i];
    return t;
}

Matrix product(const Matrix &a, const Matrix &b) {
    const Matrix columns = transposed(b);
    return {times(columns, a[0]), times(columns, a[1]), times(columns, a[2])};
}

// Two cameras, points before them, noise, and correspondences of which the first are wrong.
Scene make_scene(std::mt19937 &random) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::normal_distribution<double> normal(0.0, noise);
    const double angle = 0.2, c = std::cos(angle), s = std::sin(angle);
    const Matrix rotation = {{{c, 0.0, s}, {0.0, 1.0, 0.0}, {-s, 0.0, c}}};
    const Vector t = {1.0, 0.2, 0.1};
    Scene scene;
    const Matrix skew = {{{0.0, -t[2], t[1]}, {t[2], 0.0, -t[0]}, {-t[1], t[0], 0.0}}};
    scene.essential = product(skew, rotation);
    for (std::size_t k = 0; k < points; ++k) {
        const Vector point = {2.0 * uniform(random), 2.0 * uniform(random), 6.0 + 2.0 * uniform(random)};
        Vector there = times(rotation, point);
        for (std::size_t i = 0; i < 3; ++i) there[i] += t[i];
        const auto image = [&](const Vector &x) {
            return Vector{x[0] / x[2] + normal(random), x[1] / x[2] + normal(random), 1.0};
        };
        scene.first.push_back(image(point));
        scene.second.push_back(k < wrong ? Vector{0.4 * uniform(random), 0.4 * uniform(random), 1.0} : image(there));
    }
    return scene;
}

// The distance of the second ray from the epipolar line, and of the first, by Sampson.
double sampson(const Matrix &e, const Vector &first, const Vector &second) {
    const Vector line = times(e, first), other = times(transposed(e), second);
    const double gradient = line[0] * line[0] + line[1] * line[1] + other[0] * other[0] + other[1] * other[1];
    return std::fabs(dot(second, line)) / std::sqrt(gradient);
}

std::size_t inliers(const Matrix &e, const Scene &scene) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < points; ++k) count += sampson(e, scene.first[k], scene.second[k]) < threshold;
    return count;
}

// The sine of the angle between two matrices as vectors: they are given up to scale.
double difference(const Matrix &a, const Matrix &b) {
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        ab += dot(a[i], b[i]);
        aa += dot(a[i], a[i]);
        bb += dot(b[i], b[i]);
    }
    return std::sqrt(std::fmax(0.0, 1.0 - ab * ab / (aa * bb)));
}

} // namespace

int main() {
    std::mt19937 random(1);
    const Scene scene = make_scene(random);
    std::uniform_int_distribution<std::size_t> any(0, points - 1);
    Matrix best{};
    std::size_t most = 0, solutions = 0;
    for (std::size_t sample = 0; sample < samples; ++sample) {
        std::array<Vector, sample_size> first{}, second{};
        for (std::size_t k = 0; k < sample_size; ++k) {
            const std::size_t index = any(random);
            first[k] = scene.first[index];
            second[k] = scene.second[index];
        }
        // A sample with a point twice is degenerate: its code says so, and its list is empty. One that
        // would need a second attempt is not worth it: there are others.
        const auto result =
            five_point::try_solve_with_for_relative_pose(eliminant::SecondAttempts::never(), first, second);
        for (const five_point::RelativePose &pose : *result) {
            ++solutions;
            const std::size_t count = inliers(pose.essential, scene);
            if (count > most) {
                most = count;
                best = pose.essential;
            }
        }
    }
    const double error = difference(best, scene.essential);
    std::printf("%zu samples, %zu essential matrices, %zu inliers of %zu points, of which %zu are wrong\n", samples,
                solutions, most, points, wrong);
    std::printf("difference from the true essential matrix: %.2e\n", error);
    // All but few of the right points agree, and noise of a sample is enlarged some tens of times.
    if (most < (points - wrong) * 9 / 10 || !(error < 1e-2)) {
        std::fprintf(stderr, "error: the estimate is not good\n");
        return 1;
    }
    return 0;
}
