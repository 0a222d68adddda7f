// The circle solvers of Gummeson and Oskarsson behind the harness: `circles CASE FILE`. What comes
// before and after them is MATLAB in their code; it is done here as they describe it.
#include "harness.hpp"

#include <Eigen/Dense>

#include <array>
#include <complex>
#include <cmath>
#include <memory>

#define mexFunction mexFunctionMinimal
#include <solver_triang_null.cpp>
#undef mexFunction
#define mexFunction mexFunctionLeastSquares
#include <solver_triang_opt.cpp>
#undef mexFunction

// A solution is real if no imaginary part is larger, as in their code.
static const double REAL = 1e-8;

struct Circles : Solver {
    std::vector<double> found;
    std::vector<double> solutions() const override { return found; }
    void add(double x, double y, double square) {
        if (square > 0) found.insert(found.end(), {x, y, std::sqrt(square)});
    }
};

struct Minimal : Circles {
    std::vector<std::array<double, 9>> instances;
    void load(const double *data) override {
        std::array<double, 9> lines;
        std::copy(data, data + 9, lines.begin());
        instances.push_back(lines);
    }
    size_t solve(size_t k) override {
        found.clear();
        Eigen::Matrix<double, 6, 3> rows;
        for (int i = 0; i < 3; ++i) {
            const double *line = instances[k].data() + 3 * i, a = line[0], b = line[1], c = line[2];
            rows.col(i) << a * a, 2 * a * b, 2 * a * c, b * b, 2 * b * c, c * c;
        }
        const Eigen::Matrix<double, 6, 6> q = rows.householderQr().householderQ();
        const Eigen::Matrix<double, 6, 3> basis = q.rightCols<3>();
        const Eigen::VectorXd data = Eigen::Map<const Eigen::VectorXd>(basis.data(), 18);
        const Eigen::MatrixXcd solutions = solver_triang_null(data);
        for (int i = 0; i < solutions.cols(); ++i) {
            if (std::abs(solutions(0, i).imag()) + std::abs(solutions(1, i).imag()) > REAL) continue;
            const Eigen::Vector3d weights(solutions(0, i).real(), solutions(1, i).real(), 1);
            Eigen::Matrix<double, 6, 1> d = basis * weights;
            d /= -d(5);
            add(-d(2), -d(4), d(0) + d(2) * d(2));
        }
        return found.size() / 3;
    }
};

struct LeastSquares : Circles {
    std::vector<std::array<double, 60>> instances;
    void load(const double *data) override {
        std::array<double, 60> lines;
        std::copy(data, data + 60, lines.begin());
        instances.push_back(lines);
    }
    size_t solve(size_t k) override {
        found.clear();
        const Eigen::VectorXd d = sums(instances[k]);
        const Eigen::MatrixXcd solutions = solver_triang_opt(d);
        for (int i = 0; i < solutions.cols(); ++i) {
            double imaginary = 0;
            for (int j = 3; j < 7; ++j) imaginary += std::abs(solutions(j, i).imag());
            if (!(imaginary <= REAL)) continue;
            const double d4 = solutions(3, i).real(), d5 = solutions(4, i).real();
            const double lambda1 = solutions(5, i).real(), lambda2 = solutions(6, i).real();
            // Five equations, linear in d1, d2, d3.
            Eigen::Matrix<double, 5, 3> left;
            Eigen::Matrix<double, 5, 1> right;
            left << 2 * d[0], d[1], d[2], d[1], 2 * d[6], d[7], d[2], d[7], 2 * d[11] + 2 * lambda2, d[3], d[8], d[12],
                d[4], d[9], d[13] + lambda1;
            right << lambda2 - d[5] + d4 * d[3] + d5 * d[4], lambda1 - d[10] + d4 * d[8] + d5 * d[9],
                d4 * d[12] - d[14] + d5 * d[13] + d5 * lambda1, 2 * d4 * d[15] - lambda2 - d[17] + d5 * d[16],
                d4 * d[16] - d[19] + 2 * d5 * d[18] - 2 * d5 * lambda2;
            const Eigen::Vector3d others = left.householderQr().solve(-right);
            add(-others(2), -d5, d4 + d5 * d5);
        }
        return found.size() / 3;
    }
    // The coefficients of the cost: sums of products of a^2, 2ab, 2ac, b^2, 2bc, c^2 over all lines,
    // those of different factors twice.
    static Eigen::VectorXd sums(const std::array<double, 60> &lines) {
        Eigen::VectorXd sums = Eigen::VectorXd::Zero(21);
        for (int k = 0; k < 20; ++k) {
            double a = lines[3 * k], b = lines[3 * k + 1], c = lines[3 * k + 2];
            const double norm = std::sqrt(a * a + b * b);
            a /= norm, b /= norm, c /= norm;
            const double row[6] = {a * a, 2 * a * b, 2 * a * c, b * b, 2 * b * c, c * c};
            for (int i = 0, at = 0; i < 6; ++i)
                for (int j = i; j < 6; ++j, ++at) sums[at] += (i == j ? 1 : 2) * row[i] * row[j];
        }
        return sums;
    }
};

int main(int count, char **arguments) {
    if (count != 3) return 2;
    const std::string name = arguments[1];
    std::unique_ptr<Solver> solver;
    if (name == "circle_minimal") solver = std::make_unique<Minimal>();
    if (name == "circle_least_squares") solver = std::make_unique<LeastSquares>();
    return solver ? serve(*solver, arguments[2]) : 2;
}
