// eliminant.hpp: the solvers of eliminant.h for C++17.
//
// Written by eliminant-capi-generator 0.1.0. Do not edit.
//
// Each problem is a namespace:
//
//     using namespace eliminant;
//     const auto found = NAME::solve(data, ..);          // throws eliminant::Error
//     const auto result = NAME::try_solve(data, ..);     // result.code(), result.text()
//     for (const NAME::Solution &solution : found)
//         use(solution, NAME::error_bound(data, .., solution));
//     const auto quick = NAME::solve_with(SecondAttempts::never(), data, ..);
//
// Data are numbers, or arrays row by row: `double[5][3]`, nested `std::array`, `std::vector` of
// such, a `Span` of numbers, and with Eigen matrices of fixed size that are stored by rows, vectors,
// and arrays of such. Solutions are structs of numbers and nested `std::array`, stored in place.
// Nothing is allocated but by `Batch`. With ELIMINANT_NO_EIGEN defined, Eigen is left alone.
#ifndef ELIMINANT_HPP
#define ELIMINANT_HPP

#include "eliminant.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#if !defined(ELIMINANT_NO_EIGEN) && __has_include(<Eigen/Core>)
#define ELIMINANT_HAS_EIGEN 1
#include <Eigen/Core>
#endif

namespace eliminant {

/// What went wrong, as an exception.
class Error : public std::runtime_error {
public:
    explicit Error(std::int32_t code) : std::runtime_error(eliminant_error_text(code)), code_(code) {}
    /// One of the codes of eliminant.h.
    std::int32_t code() const noexcept { return code_; }

private:
    std::int32_t code_;
};

/// When a solve that misses solutions is repeated at twice the precision, which takes some twenty
/// times as long.
class SecondAttempts {
public:
    /// Wherever solutions are missing, as `solve` does. Only so are they followed from data nearby.
    static constexpr SecondAttempts always() noexcept { return SecondAttempts(ELIMINANT_ALWAYS); }
    /// Never: solutions that only a second attempt finds are missing, and an elimination that fails
    /// is an error.
    static constexpr SecondAttempts never() noexcept { return SecondAttempts(ELIMINANT_NEVER); }
    /// If it has at most so many operations. A problem has `second_attempt_operations()`.
    static constexpr SecondAttempts at_most(std::uint64_t operations) noexcept { return SecondAttempts(operations); }
    /// As the C functions take it.
    constexpr std::uint64_t operations() const noexcept { return operations_; }

private:
    explicit constexpr SecondAttempts(std::uint64_t operations) noexcept : operations_(operations) {}
    std::uint64_t operations_;
};

/// A list that belongs to somebody else.
template <class T> class Span {
public:
    constexpr Span() noexcept = default;
    constexpr Span(T *pointer, std::size_t size) noexcept : pointer_(pointer), size_(size) {}
    constexpr T *data() const noexcept { return pointer_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T *begin() const noexcept { return pointer_; }
    constexpr T *end() const noexcept { return pointer_ + size_; }
    constexpr T &operator[](std::size_t at) const noexcept { return pointer_[at]; }

private:
    T *pointer_ = nullptr;
    std::size_t size_ = 0;
};

namespace detail {

/// How many numbers a type consists of; 0 for a type that does not.
template <class T> struct Numbers : std::integral_constant<std::size_t, 0> {};
template <> struct Numbers<double> : std::integral_constant<std::size_t, 1> {};
template <class T, std::size_t N>
struct Numbers<T[N]> : std::integral_constant<std::size_t, N * Numbers<T>::value> {};
template <class T, std::size_t N>
struct Numbers<std::array<T, N>> : std::integral_constant<std::size_t, N * Numbers<T>::value> {};
#ifdef ELIMINANT_HAS_EIGEN
template <int Rows, int Columns, int Options, int MaxRows, int MaxColumns>
struct Numbers<Eigen::Matrix<double, Rows, Columns, Options, MaxRows, MaxColumns>>
    : std::integral_constant<std::size_t, (Rows > 0 && Columns > 0 &&
                                           (Rows == 1 || Columns == 1 || (Options & Eigen::RowMajor) != 0))
                                              ? static_cast<std::size_t>(Rows) * static_cast<std::size_t>(Columns)
                                              : 0> {};
#endif

template <class T> const double *first_number(const T &array) noexcept {
    static_assert(sizeof(T) == Numbers<T>::value * sizeof(double), "numbers without anything between them");
    return reinterpret_cast<const double *>(&array);
}

} // namespace detail

/// Numbers, row by row: an argument of a call. It refers to what it is made from, and their number
/// is checked by the call.
class Many {
public:
    Many(Span<const double> numbers) noexcept : Many(numbers.data(), numbers.size()) {}
    Many(Span<double> numbers) noexcept : Many(numbers.data(), numbers.size()) {}
    template <class T, class = std::enable_if_t<detail::Numbers<T>::value != 0>>
    Many(const T &array) noexcept : Many(detail::first_number(array), detail::Numbers<T>::value) {}
    template <class T, class A, class = std::enable_if_t<detail::Numbers<T>::value != 0>>
    Many(const std::vector<T, A> &list) noexcept
        : Many(list.empty() ? nullptr : detail::first_number(list.front()), list.size() * detail::Numbers<T>::value) {}
    const double *data() const noexcept { return pointer_; }
    std::size_t size() const noexcept { return size_; }

private:
    Many(const double *pointer, std::size_t size) noexcept : pointer_(pointer), size_(size) {}
    const double *pointer_;
    std::size_t size_;
};

/// N numbers, row by row: an argument of a call. An array of another size does not compile, and
/// another length of a list is an error of the call.
template <std::size_t N> class Values : public Many {
public:
    Values(Span<const double> numbers) noexcept : Many(numbers) {}
    Values(Span<double> numbers) noexcept : Many(numbers) {}
    template <class T, class = std::enable_if_t<detail::Numbers<T>::value != 0>>
    Values(const T &array) noexcept : Many(array) {
        static_assert(detail::Numbers<T>::value == N, "these data have another number of numbers");
    }
    template <class T, class A, class = std::enable_if_t<detail::Numbers<T>::value != 0>>
    Values(const std::vector<T, A> &list) noexcept : Many(list) {}
};

/// Up to `Max` solutions, stored in place.
template <class S, std::size_t Max> class Solutions {
public:
    using value_type = S;
    static constexpr std::size_t max_size() noexcept { return Max; }
    std::size_t size() const noexcept { return count_; }
    bool empty() const noexcept { return count_ == 0; }
    const S *data() const noexcept { return rows_.data(); }
    const S *begin() const noexcept { return rows_.data(); }
    const S *end() const noexcept { return rows_.data() + count_; }
    const S &operator[](std::size_t at) const noexcept { return rows_[at]; }

    /// Fills the list by a call that takes room for numbers and a count, and returns its code.
    template <class Call> std::int32_t fill(const Call &call) noexcept {
        static_assert(std::is_standard_layout_v<S> && sizeof(S) % sizeof(double) == 0, "a row of numbers");
        return call(reinterpret_cast<double *>(rows_.data()), &count_);
    }

private:
    std::array<S, Max> rows_{};
    std::size_t count_ = 0;
};

/// A value, or the code of what went wrong.
template <class T> class Result {
public:
    /// Makes the value by a call that returns a code.
    template <class Call> static Result of(const Call &call) noexcept {
        Result result;
        result.code_ = result.value_.fill(call);
        return result;
    }
    explicit operator bool() const noexcept { return code_ == ELIMINANT_OK; }
    std::int32_t code() const noexcept { return code_; }
    const char *text() const noexcept { return eliminant_error_text(code_); }
    /// The value; an empty list if something went wrong.
    const T &operator*() const noexcept { return value_; }
    const T *operator->() const noexcept { return &value_; }
    /// The value; throws if something went wrong.
    const T &value() const {
        if (code_ != ELIMINANT_OK) throw Error(code_);
        return value_;
    }

private:
    T value_;
    std::int32_t code_ = ELIMINANT_OK;
};

/// The results of many instances. Its memory serves batch after batch.
template <class S, std::size_t Max> class Batch {
public:
    std::size_t size() const noexcept { return counts_.size(); }
    /// The solutions of an instance; none if something went wrong.
    Span<const S> operator[](std::size_t at) const noexcept { return {rows_.data() + at * Max, counts_[at]}; }
    /// The code of an instance.
    std::int32_t code(std::size_t at) const noexcept { return codes_[at]; }

    /// Fills the results by a call that takes room for numbers, its length, counts and codes.
    template <class Call> void fill(std::size_t instances, const Call &call) {
        static_assert(std::is_standard_layout_v<S> && sizeof(S) % sizeof(double) == 0, "a row of numbers");
        rows_.resize(instances * Max);
        counts_.assign(instances, 0);
        codes_.assign(instances, ELIMINANT_OK);
        const std::size_t length = rows_.size() * (sizeof(S) / sizeof(double));
        const std::int32_t code =
            call(reinterpret_cast<double *>(rows_.data()), length, counts_.data(), codes_.data());
        if (code != ELIMINANT_OK) throw Error(code);
    }

private:
    std::vector<S> rows_;
    std::vector<std::size_t> counts_;
    std::vector<std::int32_t> codes_;
};

#ifdef ELIMINANT_HAS_EIGEN
/// A matrix of a solution as an Eigen matrix, without a copy.
template <std::size_t Rows, std::size_t Columns>
Eigen::Map<const Eigen::Matrix<double, int(Rows), int(Columns), Eigen::RowMajor>>
map(const std::array<std::array<double, Columns>, Rows> &matrix) noexcept {
    return Eigen::Map<const Eigen::Matrix<double, int(Rows), int(Columns), Eigen::RowMajor>>(
        detail::first_number(matrix));
}

/// A vector of a solution as an Eigen vector, without a copy.
template <std::size_t N>
Eigen::Map<const Eigen::Matrix<double, int(N), 1>> map(const std::array<double, N> &vector) noexcept {
    return Eigen::Map<const Eigen::Matrix<double, int(N), 1>>(vector.data());
}

/// An Eigen expression of fixed size as an argument: a copy that is stored by rows.
template <class D> auto by_rows(const Eigen::MatrixBase<D> &matrix) {
    constexpr int rows = D::RowsAtCompileTime, columns = D::ColsAtCompileTime;
    static_assert(rows > 0 && columns > 0, "a matrix of fixed size");
    std::array<std::array<double, std::size_t(columns)>, std::size_t(rows)> copy{};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            copy[std::size_t(row)][std::size_t(column)] = matrix(row, column);
    return copy;
}
#endif

/// Positions of six receivers and four senders from all ranges between them: 38 solutions, of which
/// those that can be placed in space are returned.
///
/// Kuang, Burgess, Torstensson, Åström, "A complete characterization and solution to the microphone
/// position self-calibration problem", ICASSP 2013. Published as `toa_46`.
///
/// `ranges[i][j]` is the distance between receiver i and sender j. Relative to one of the senders,
/// which is called the first, let G be the Gram matrix of the other three and K its inverse, [k11 v
/// w; v k22 x; w x y]. A receiver with the squares r of its range to the first sender and s of
/// those to the others satisfies 4 r = c K c + 2 c g + a with c_j = r - s_j, g = K n, a = n K n and
/// n = diag(G). Six receivers give k11, k22, g and a as combinations of v, w, x, y and 1. How well
/// depends on which sender is the first and which the last: the best of 12 choices is taken. With C
/// = adj(K) and z = det(K), n is diag(C) / z. M = [K g; g a] is K times [1 n] from both sides: its
/// adjugate is z times the square of (n, -1).
///
/// Positions are known up to a motion and a mirror: the first of the senders is returned as the
/// origin, another one on the x axis, and the third in the plane of x and y.
namespace calibration_6_receivers_4_senders {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 38;

/// A solution of `calibration_6_receivers_4_senders`.
struct Solution {
    double v;
    double w;
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<24> ranges) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_calibration_6_receivers_4_senders_solve(ranges.data(), ranges.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<24> ranges) {
    return try_solve(ranges).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<24> ranges) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_calibration_6_receivers_4_senders_solve_with(
            second_attempts.operations(), ranges.data(), ranges.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<24> ranges) {
    return try_solve_with(second_attempts, ranges).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many ranges, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_calibration_6_receivers_4_senders_solve_batch(
            instances, ranges.data(), ranges.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `calibration_6_receivers_4_senders` returns beside its unknowns.
struct Positions {
    std::array<std::array<double, 3>, 4> senders;
    std::array<std::array<double, 3>, 6> receivers;
};
static_assert(sizeof(Positions) == 30 * sizeof(double), "a row");

/// Real solutions of one instance: each positions, or the code of an error.
[[nodiscard]] inline Result<Solutions<Positions, max_solutions>> try_solve_for_positions(Values<24> ranges) noexcept {
    return Result<Solutions<Positions, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_calibration_6_receivers_4_senders_solve_for_positions(ranges.data(), ranges.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each positions. Throws `Error`.
[[nodiscard]] inline Solutions<Positions, max_solutions> solve_for_positions(Values<24> ranges) {
    return try_solve_for_positions(ranges).value();
}

/// As `try_solve_for_positions`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Positions, max_solutions>> try_solve_with_for_positions(SecondAttempts second_attempts, Values<24> ranges) noexcept {
    return Result<Solutions<Positions, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_calibration_6_receivers_4_senders_solve_with_for_positions(
            second_attempts.operations(), ranges.data(), ranges.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_positions`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Positions, max_solutions> solve_with_for_positions(SecondAttempts second_attempts, Values<24> ranges) {
    return try_solve_with_for_positions(second_attempts, ranges).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_positions(
    std::size_t instances, Many ranges, Batch<Positions, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_calibration_6_receivers_4_senders_solve_batch_for_positions(
            instances, ranges.data(), ranges.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<24> ranges, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_calibration_6_receivers_4_senders_relative_residual(
        ranges.data(), ranges.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<24> ranges, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_calibration_6_receivers_4_senders_error_bound(
        ranges.data(), ranges.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_calibration_6_receivers_4_senders_second_attempt_operations();
}

} // namespace calibration_6_receivers_4_senders

/// Circle tangent to n lines in the least-squares sense: the stationary points of the constrained
/// dual conic, 9 solutions.
///
/// Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", eq. (23)-(26): the
/// Lagrangian as printed.
///
/// `gram` is the mean over all lines l = (a, b, c) of r r^T with r = (a^2, ab, ac, b^2, bc, c^2).
/// The dual conic is [d1 d2 d3; d2 d4 d5; d3 d5 -1]: a circle with centre (-d3, -d5) and squared
/// radius d1 + d3^2 = d4 + d5^2, which is negative at some stationary points. The cost is the mean
/// of (l^T D l)^2.
namespace circle_least_squares {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 9;

/// A solution of `circle_least_squares`.
struct Solution {
    double d1;
    double d2;
    double d3;
    double d4;
    double d5;
    double lambda1;
    double lambda2;
};
static_assert(sizeof(Solution) == 7 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<36> gram) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_solve(gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<36> gram) {
    return try_solve(gram).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<36> gram) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_solve_with(
            second_attempts.operations(), gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<36> gram) {
    return try_solve_with(second_attempts, gram).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many gram, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_circle_least_squares_solve_batch(
            instances, gram.data(), gram.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `circle_least_squares` returns beside its unknowns.
struct Circle {
    std::array<double, 2> centre;
    double squared_radius;
    double cost;
};
static_assert(sizeof(Circle) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each circle, or the code of an error.
[[nodiscard]] inline Result<Solutions<Circle, max_solutions>> try_solve_for_circle(Values<36> gram) noexcept {
    return Result<Solutions<Circle, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_solve_for_circle(gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each circle. Throws `Error`.
[[nodiscard]] inline Solutions<Circle, max_solutions> solve_for_circle(Values<36> gram) {
    return try_solve_for_circle(gram).value();
}

/// As `try_solve_for_circle`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Circle, max_solutions>> try_solve_with_for_circle(SecondAttempts second_attempts, Values<36> gram) noexcept {
    return Result<Solutions<Circle, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_solve_with_for_circle(
            second_attempts.operations(), gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_circle`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Circle, max_solutions> solve_with_for_circle(SecondAttempts second_attempts, Values<36> gram) {
    return try_solve_with_for_circle(second_attempts, gram).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_circle(
    std::size_t instances, Many gram, Batch<Circle, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_circle_least_squares_solve_batch_for_circle(
            instances, gram.data(), gram.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<36> gram, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_circle_least_squares_relative_residual(
        gram.data(), gram.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<36> gram, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_circle_least_squares_error_bound(
        gram.data(), gram.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_circle_least_squares_second_attempt_operations();
}

/// What a line a x + b y + c = 0 gives.
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline std::array<std::array<double, 6>, 6> mean_of_line(std::size_t measurements, Many line) {
    std::array<std::array<double, 6>, 6> mean{};
    static_assert(sizeof(mean) == 36 * sizeof(double), "an array of numbers");
    const std::int32_t code =
        eliminant_circle_least_squares_mean_of_line(measurements, line.data(), line.size(), reinterpret_cast<double *>(&mean), 36);
    if (code != ELIMINANT_OK) throw Error(code);
    return mean;
}

} // namespace circle_least_squares

/// Circle tangent to n lines in the least-squares sense, in three unknowns of the dual conic, 9
/// solutions.
///
/// Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation": the two constraints give d1
/// and d2, which leaves the cost as a polynomial in d3, d4, d5. Data and conic are those of
/// `circle_least_squares`.
namespace circle_least_squares_dual {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 9;

/// A solution of `circle_least_squares_dual`.
struct Solution {
    double d3;
    double d4;
    double d5;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<36> gram) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_dual_solve(gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<36> gram) {
    return try_solve(gram).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<36> gram) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_dual_solve_with(
            second_attempts.operations(), gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<36> gram) {
    return try_solve_with(second_attempts, gram).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many gram, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_circle_least_squares_dual_solve_batch(
            instances, gram.data(), gram.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `circle_least_squares_dual` returns beside its unknowns.
struct Circle {
    std::array<double, 2> centre;
    double squared_radius;
    double cost;
};
static_assert(sizeof(Circle) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each circle, or the code of an error.
[[nodiscard]] inline Result<Solutions<Circle, max_solutions>> try_solve_for_circle(Values<36> gram) noexcept {
    return Result<Solutions<Circle, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_dual_solve_for_circle(gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each circle. Throws `Error`.
[[nodiscard]] inline Solutions<Circle, max_solutions> solve_for_circle(Values<36> gram) {
    return try_solve_for_circle(gram).value();
}

/// As `try_solve_for_circle`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Circle, max_solutions>> try_solve_with_for_circle(SecondAttempts second_attempts, Values<36> gram) noexcept {
    return Result<Solutions<Circle, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_least_squares_dual_solve_with_for_circle(
            second_attempts.operations(), gram.data(), gram.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_circle`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Circle, max_solutions> solve_with_for_circle(SecondAttempts second_attempts, Values<36> gram) {
    return try_solve_with_for_circle(second_attempts, gram).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_circle(
    std::size_t instances, Many gram, Batch<Circle, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_circle_least_squares_dual_solve_batch_for_circle(
            instances, gram.data(), gram.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<36> gram, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_circle_least_squares_dual_relative_residual(
        gram.data(), gram.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<36> gram, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_circle_least_squares_dual_error_bound(
        gram.data(), gram.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_circle_least_squares_dual_second_attempt_operations();
}

/// What a line a x + b y + c = 0 gives.
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline std::array<std::array<double, 6>, 6> mean_of_line(std::size_t measurements, Many line) {
    std::array<std::array<double, 6>, 6> mean{};
    static_assert(sizeof(mean) == 36 * sizeof(double), "an array of numbers");
    const std::int32_t code =
        eliminant_circle_least_squares_dual_mean_of_line(measurements, line.data(), line.size(), reinterpret_cast<double *>(&mean), 36);
    if (code != ELIMINANT_OK) throw Error(code);
    return mean;
}

} // namespace circle_least_squares_dual

/// The circles tangent to three lines: 4 solutions (the incircle and the three excircles of the
/// triangle).
///
/// Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", the minimal three-line
/// solver.
///
/// A line l = (a, b, c) is tangent to the circle with dual conic D = [d1 d2 d3; d2 d4 d5; d3 d5 d6]
/// if l^T D l = 0: one linear equation in d = (d1, .., d6), (a^2, 2ab, 2ac, b^2, 2bc, c^2) d = 0.
/// Three lines leave a null space of dimension three, d = a d_alpha + b d_beta + d_gamma, in which
/// the two constraints of a circle, d2 d6 = d3 d5 and (d1 - d4) d6 = d3^2 - d5^2, pick four points.
namespace circle_minimal {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 4;

/// A solution of `circle_minimal`.
struct Solution {
    double a;
    double b;
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<6> d_alpha, Values<6> d_beta, Values<6> d_gamma) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_minimal_solve(d_alpha.data(), d_alpha.size(), d_beta.data(), d_beta.size(), d_gamma.data(), d_gamma.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<6> d_alpha, Values<6> d_beta, Values<6> d_gamma) {
    return try_solve(d_alpha, d_beta, d_gamma).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<6> d_alpha, Values<6> d_beta, Values<6> d_gamma) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_circle_minimal_solve_with(
            second_attempts.operations(), d_alpha.data(), d_alpha.size(), d_beta.data(), d_beta.size(), d_gamma.data(), d_gamma.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<6> d_alpha, Values<6> d_beta, Values<6> d_gamma) {
    return try_solve_with(second_attempts, d_alpha, d_beta, d_gamma).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many d_alpha, Many d_beta, Many d_gamma, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_circle_minimal_solve_batch(
            instances, d_alpha.data(), d_alpha.size(), d_beta.data(), d_beta.size(), d_gamma.data(), d_gamma.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<6> d_alpha, Values<6> d_beta, Values<6> d_gamma, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_circle_minimal_relative_residual(
        d_alpha.data(), d_alpha.size(), d_beta.data(), d_beta.size(), d_gamma.data(), d_gamma.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<6> d_alpha, Values<6> d_beta, Values<6> d_gamma, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_circle_minimal_error_bound(
        d_alpha.data(), d_alpha.size(), d_beta.data(), d_beta.size(), d_gamma.data(), d_gamma.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_circle_minimal_second_attempt_operations();
}

} // namespace circle_minimal

/// Fundamental matrix of two cameras from seven points: 3 solutions.
///
/// Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.2.
///
/// `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
/// `(second[k], 1) . F (first[k], 1) = 0`; it is the sum of the two matrices that span the null
/// space of these equations, each times its weight.
namespace fundamental_7pt {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 3;

/// A solution of `fundamental_7pt`.
struct Solution {
    std::array<double, 2> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_7pt_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<14> first, Values<14> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_7pt_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_7pt_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `fundamental_7pt` returns beside its unknowns.
struct Epipolar {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
};
static_assert(sizeof(Epipolar) == 9 * sizeof(double), "a row");

/// Real solutions of one instance: each epipolar, or the code of an error.
[[nodiscard]] inline Result<Solutions<Epipolar, max_solutions>> try_solve_for_epipolar(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Epipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_7pt_solve_for_epipolar(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each epipolar. Throws `Error`.
[[nodiscard]] inline Solutions<Epipolar, max_solutions> solve_for_epipolar(Values<14> first, Values<14> second) {
    return try_solve_for_epipolar(first, second).value();
}

/// As `try_solve_for_epipolar`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Epipolar, max_solutions>> try_solve_with_for_epipolar(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Epipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_7pt_solve_with_for_epipolar(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_epipolar`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Epipolar, max_solutions> solve_with_for_epipolar(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with_for_epipolar(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_epipolar(
    std::size_t instances, Many first, Many second, Batch<Epipolar, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_7pt_solve_batch_for_epipolar(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_7pt_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_7pt_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_fundamental_7pt_second_attempt_operations();
}

} // namespace fundamental_7pt

/// Fundamental matrix of two cameras from eight points: 1 solution.
///
/// Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.
///
/// `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
/// `(second[k], 1) . F (first[k], 1) = 0`. It is the sum of the two matrices that span the null
/// space of the first seven of these equations, each times its weight, which the last one gives. Of
/// images with errors F has rank 3; that of seven points, `fundamental_7pt`, has rank 2.
namespace fundamental_8pt {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 1;

/// A solution of `fundamental_8pt`.
struct Solution {
    std::array<double, 2> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<16> first, Values<16> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<16> first, Values<16> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_8pt_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `fundamental_8pt` returns beside its unknowns.
struct Epipolar {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
};
static_assert(sizeof(Epipolar) == 9 * sizeof(double), "a row");

/// Real solutions of one instance: each epipolar, or the code of an error.
[[nodiscard]] inline Result<Solutions<Epipolar, max_solutions>> try_solve_for_epipolar(Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Epipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_solve_for_epipolar(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each epipolar. Throws `Error`.
[[nodiscard]] inline Solutions<Epipolar, max_solutions> solve_for_epipolar(Values<16> first, Values<16> second) {
    return try_solve_for_epipolar(first, second).value();
}

/// As `try_solve_for_epipolar`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Epipolar, max_solutions>> try_solve_with_for_epipolar(SecondAttempts second_attempts, Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Epipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_solve_with_for_epipolar(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_epipolar`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Epipolar, max_solutions> solve_with_for_epipolar(SecondAttempts second_attempts, Values<16> first, Values<16> second) {
    return try_solve_with_for_epipolar(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_epipolar(
    std::size_t instances, Many first, Many second, Batch<Epipolar, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_8pt_solve_batch_for_epipolar(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<16> first, Values<16> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_8pt_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<16> first, Values<16> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_8pt_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_fundamental_8pt_second_attempt_operations();
}

} // namespace fundamental_8pt

/// Fundamental matrix and the radial distortion common to both cameras from eight points: 16
/// solutions.
///
/// Kukelova, Pajdla, "A minimal solution to the autocalibration of radial distortion", CVPR 2007.
/// Published as `8ptF_radial`, with f33 = 1, which loses planar motions and those without a
/// rotation: f33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
/// distortion. An image x lies along (x, 1 + radial |x|^2), the division model. Then x2^T F x1 = 0
/// is linear in f11, f21, f31, f12, f22, f32, radial f31, radial f32 and the monomials radial f13,
/// radial f23, radial^2 f33, f13, f23, radial f33, f33: eight points give the former as
/// combinations of these. `third` is the third column of F, which is given up to scale. It vanishes
/// where the first camera moves along its optical axis; without a rotation such points tell nothing
/// of the distortion.
namespace fundamental_8pt_radial {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 16;

/// A solution of `fundamental_8pt_radial`.
struct Solution {
    double radial;
    std::array<double, 3> third; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<16> first, Values<16> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<16> first, Values<16> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_8pt_radial_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `fundamental_8pt_radial` returns beside its unknowns.
struct RadialEpipolar {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double radial;
};
static_assert(sizeof(RadialEpipolar) == 10 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_epipolar, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_for_radial_epipolar(Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_solve_for_radial_epipolar(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_epipolar. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_for_radial_epipolar(Values<16> first, Values<16> second) {
    return try_solve_for_radial_epipolar(first, second).value();
}

/// As `try_solve_for_radial_epipolar`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_solve_with_for_radial_epipolar(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_epipolar`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<16> first, Values<16> second) {
    return try_solve_with_for_radial_epipolar(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_epipolar(
    std::size_t instances, Many first, Many second, Batch<RadialEpipolar, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_8pt_radial_solve_batch_for_radial_epipolar(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<16> first, Values<16> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_8pt_radial_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<16> first, Values<16> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_8pt_radial_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_fundamental_8pt_radial_second_attempt_operations();
}

} // namespace fundamental_8pt_radial

/// Fundamental matrix and radial distortion of the second camera from eight points: 8 solutions.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `8ptF_radial_1s`, with f33 = 1, which loses planar motions
/// and those without a rotation: f33 is 0.
///
/// `first[k]` is the image of point k in a camera without distortion, `second[k]` the distorted one
/// in the other, relative to the centre of distortion. There an image x lies along (x, 1 + radial
/// |x|^2), the division model. Then x2^T F x1 = 0 is, with f32 = 1, linear in the first two rows of
/// F, radial f31, radial f32 and in radial f33, f31, 1, f33: eight points give the former as
/// combinations of these. The first image is turned, which turns (f31, f32): for usual motions one
/// of these is 0 if it is not. Both vanish where the second camera moves along its optical axis:
/// then the points tell nothing of the distortion.
namespace fundamental_8pt_radial_one_side {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `fundamental_8pt_radial_one_side`.
struct Solution {
    double f_31;
    double f_33;
    double radial;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_one_side_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<16> first, Values<16> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_one_side_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<16> first, Values<16> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_8pt_radial_one_side_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `fundamental_8pt_radial_one_side` returns beside its unknowns.
struct RadialEpipolar {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double radial;
};
static_assert(sizeof(RadialEpipolar) == 10 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_epipolar, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_for_radial_epipolar(Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_one_side_solve_for_radial_epipolar(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_epipolar. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_for_radial_epipolar(Values<16> first, Values<16> second) {
    return try_solve_for_radial_epipolar(first, second).value();
}

/// As `try_solve_for_radial_epipolar`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<16> first, Values<16> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_8pt_radial_one_side_solve_with_for_radial_epipolar(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_epipolar`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<16> first, Values<16> second) {
    return try_solve_with_for_radial_epipolar(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_epipolar(
    std::size_t instances, Many first, Many second, Batch<RadialEpipolar, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_8pt_radial_one_side_solve_batch_for_radial_epipolar(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<16> first, Values<16> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_8pt_radial_one_side_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<16> first, Values<16> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_8pt_radial_one_side_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_fundamental_8pt_radial_one_side_second_attempt_operations();
}

} // namespace fundamental_8pt_radial_one_side

/// Fundamental matrix and the two different radial distortions of two cameras from nine points: 24
/// solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `rdist9p`, with f33 =
/// 1, which loses planar motions and those without a rotation: f33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centres of
/// distortion. An image x lies along (x, 1 + radial |x|^2), the division model: with s for `radial`
/// in the second image and t in the first. Then x2^T F x1 = 0 is, with f23 = 1, linear in f11, f12,
/// f21, f22, t f13, t, t f33, s t f33, f13 and in s f31, s f32, s f33, f31, f32, f33, 1: nine
/// points give the former as combinations of these. The second image is turned, which turns (f13,
/// f23): for usual motions one of these is 0 if it is not. Both vanish where the first camera moves
/// along its optical axis; without a rotation such points tell nothing of the distortions.
namespace fundamental_9pt_two_radials {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 24;

/// A solution of `fundamental_9pt_two_radials`.
struct Solution {
    double s;
    double f_31;
    double f_32;
    double f_33;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<18> first, Values<18> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_9pt_two_radials_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<18> first, Values<18> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<18> first, Values<18> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_9pt_two_radials_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<18> first, Values<18> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_9pt_two_radials_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `fundamental_9pt_two_radials` returns beside its unknowns.
struct RadialEpipolar {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    std::array<double, 2> radials;
};
static_assert(sizeof(RadialEpipolar) == 11 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_epipolar, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_for_radial_epipolar(Values<18> first, Values<18> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_9pt_two_radials_solve_for_radial_epipolar(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_epipolar. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_for_radial_epipolar(Values<18> first, Values<18> second) {
    return try_solve_for_radial_epipolar(first, second).value();
}

/// As `try_solve_for_radial_epipolar`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<18> first, Values<18> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_fundamental_9pt_two_radials_solve_with_for_radial_epipolar(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_epipolar`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<18> first, Values<18> second) {
    return try_solve_with_for_radial_epipolar(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_epipolar(
    std::size_t instances, Many first, Many second, Batch<RadialEpipolar, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_fundamental_9pt_two_radials_solve_batch_for_radial_epipolar(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<18> first, Values<18> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_9pt_two_radials_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<18> first, Values<18> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_fundamental_9pt_two_radials_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_fundamental_9pt_two_radials_second_attempt_operations();
}

} // namespace fundamental_9pt_two_radials

/// Homography of two images of a plane, or of two cameras with one centre, from four points: 1
/// solution.
///
/// Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 4.1; here by the
/// projective bases of the four points, as Heckbert, "Fundamentals of texture mapping and image
/// warping", 1989.
///
/// `first[k]` and `second[k]` are the images of point k, in pixels or any other unit; no three of
/// either may lie on a line. The homography H takes (`first[k]`, 1) to a multiple of (`second[k]`,
/// 1): that of point k < 3 is `multiples[k]`. The fourth point is the sum of these three with
/// weights, which are known in both images and proportional when multiplied.
namespace homography_4pt {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 1;

/// A solution of `homography_4pt`.
struct Solution {
    std::array<double, 3> multiples; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<8> first, Values<8> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_homography_4pt_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<8> first, Values<8> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<8> first, Values<8> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_homography_4pt_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<8> first, Values<8> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_homography_4pt_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `homography_4pt` returns beside its unknowns.
struct Homography {
    std::array<std::array<double, 3>, 3> homography; ///< given up to scale
};
static_assert(sizeof(Homography) == 9 * sizeof(double), "a row");

/// Real solutions of one instance: each homography, or the code of an error.
[[nodiscard]] inline Result<Solutions<Homography, max_solutions>> try_solve_for_homography(Values<8> first, Values<8> second) noexcept {
    return Result<Solutions<Homography, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_homography_4pt_solve_for_homography(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each homography. Throws `Error`.
[[nodiscard]] inline Solutions<Homography, max_solutions> solve_for_homography(Values<8> first, Values<8> second) {
    return try_solve_for_homography(first, second).value();
}

/// As `try_solve_for_homography`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Homography, max_solutions>> try_solve_with_for_homography(SecondAttempts second_attempts, Values<8> first, Values<8> second) noexcept {
    return Result<Solutions<Homography, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_homography_4pt_solve_with_for_homography(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_homography`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Homography, max_solutions> solve_with_for_homography(SecondAttempts second_attempts, Values<8> first, Values<8> second) {
    return try_solve_with_for_homography(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_homography(
    std::size_t instances, Many first, Many second, Batch<Homography, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_homography_4pt_solve_batch_for_homography(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<8> first, Values<8> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_homography_4pt_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<8> first, Values<8> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_homography_4pt_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_homography_4pt_second_attempt_operations();
}

} // namespace homography_4pt

/// Katsura's equations for the magnetic field of a spin glass with six unknowns: 32 solutions.
/// There are no data.
///
/// Katsura, "Spin glass problem by the method of integral equation of the effective field", in: New
/// Trends in Magnetism, 1990; as in the data base of PHCpack (Verschelde, ACM TOMS 795, 1999).
/// Published as `katsura5`.
namespace katsura_5 {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 32;

/// A solution of `katsura_5`.
struct Solution {
    double t;
    double u;
    double v;
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 6 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve() noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_katsura_5_solve(to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve() {
    return try_solve().value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_katsura_5_solve_with(
            second_attempts.operations(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts) {
    return try_solve_with(second_attempts).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_katsura_5_solve_batch(
            instances, to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_katsura_5_relative_residual(
        reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_katsura_5_error_bound(
        reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_katsura_5_second_attempt_operations();
}

} // namespace katsura_5

/// Keplerian orbit from five lines of sight without times: 66 solutions.
///
/// Mancini, Duff, Leykin, Christian, "Geometric solution to the angles-only initial orbit
/// determination problem", 2023; Huang, Leykin, Mancini, "Projective plane subdivision method for
/// initial orbit determination", arXiv 2509.14397, 2025. Published as `IOD`.
///
/// `sights` holds for each line the position of the observer and the direction; the Sun is the
/// origin. The plane of the orbit has the normal n = (a, b, 1). It meets the line with direction d
/// and moment m in x = n x m / n.d. The orbit is |x| = h - e.x, where e points to the pericentre
/// and has the eccentricity as its length. With w = n x e / h = (-q, p, r), where (p, q, 0) is e /
/// h up to a multiple of n, this is (n.d + w.m)^2 = |n x m|^2 / h^2, and `square` is 1 / h^2. The
/// published unknowns are the entries of the orbit's dual quadric.
///
/// Returned are the normal of the plane, of length 1, e and h, which is the semi-latus rectum.
///
/// With directions and moments exchanged these are the cylinders that touch five lines: n is the
/// direction of the axis, w its moment, and `square` that of the radius.
namespace orbit_5_lines_of_sight {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 66;

/// A solution of `orbit_5_lines_of_sight`.
struct Solution {
    double a;
    double b;
    double p;
    double q;
    double r;
    double square;
};
static_assert(sizeof(Solution) == 6 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<30> sights) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_orbit_5_lines_of_sight_solve(sights.data(), sights.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<30> sights) {
    return try_solve(sights).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<30> sights) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_orbit_5_lines_of_sight_solve_with(
            second_attempts.operations(), sights.data(), sights.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<30> sights) {
    return try_solve_with(second_attempts, sights).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many sights, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_orbit_5_lines_of_sight_solve_batch(
            instances, sights.data(), sights.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `orbit_5_lines_of_sight` returns beside its unknowns.
struct Orbit {
    std::array<double, 3> normal;
    std::array<double, 3> eccentricity;
    double semi_latus_rectum;
};
static_assert(sizeof(Orbit) == 7 * sizeof(double), "a row");

/// Real solutions of one instance: each orbit, or the code of an error.
[[nodiscard]] inline Result<Solutions<Orbit, max_solutions>> try_solve_for_orbit(Values<30> sights) noexcept {
    return Result<Solutions<Orbit, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_orbit_5_lines_of_sight_solve_for_orbit(sights.data(), sights.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each orbit. Throws `Error`.
[[nodiscard]] inline Solutions<Orbit, max_solutions> solve_for_orbit(Values<30> sights) {
    return try_solve_for_orbit(sights).value();
}

/// As `try_solve_for_orbit`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Orbit, max_solutions>> try_solve_with_for_orbit(SecondAttempts second_attempts, Values<30> sights) noexcept {
    return Result<Solutions<Orbit, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_orbit_5_lines_of_sight_solve_with_for_orbit(
            second_attempts.operations(), sights.data(), sights.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_orbit`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Orbit, max_solutions> solve_with_for_orbit(SecondAttempts second_attempts, Values<30> sights) {
    return try_solve_with_for_orbit(second_attempts, sights).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_orbit(
    std::size_t instances, Many sights, Batch<Orbit, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_orbit_5_lines_of_sight_solve_batch_for_orbit(
            instances, sights.data(), sights.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<30> sights, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_orbit_5_lines_of_sight_relative_residual(
        sights.data(), sights.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<30> sights, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_orbit_5_lines_of_sight_error_bound(
        sights.data(), sights.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_orbit_5_lines_of_sight_second_attempt_operations();
}

} // namespace orbit_5_lines_of_sight

/// Forward kinematics of the general Stewart-Gough platform, all poses with given lengths of its
/// six legs: 40 solutions.
///
/// Husty, "An algorithm for solving the direct kinematics of general Stewart-Gough-type platforms",
/// Mechanism and Machine Theory 31, 1996. Published as `parallel_robot_66`.
///
/// Leg k joins `base[k]`, in the frame of the base, and `platform[k]`, in that of the platform, and
/// has the length `lengths[k]`. Base or platform may be flat, but not both. Returned is the pose
/// x -> rotation x + translation that takes the platform to the frame of the base.
///
/// Joints are taken relative to those of the first leg. Let t be that leg in the base's
/// coordinates, s = R^T t in the platform's. The length of the leg from X to x, less that of the
/// first, gives x s - X t as a linear combination of the entries of R and 1: five equations for s
/// and t. The null vector of these has a part p of s and a part q of t, and the longer one is p,
/// else base and platform are exchanged. Both are turned so that p and q are along their third
/// axes. R is that of the quaternion 1 + a i + b j + c k, so n s and n t, with n = 1 + a a + b b +
/// c c, are quadratic polynomials: `sums` has the coefficients of n (s_i + t_i), `differences`
/// those of n (s_i - t_i), for i = 1, 2, and s_3 + t_3 = `ratio` (s_3 - t_3) + `shift`.
///
/// That t q = q s gives n (s_3 - t_3) times 1, a, b and c as cubic polynomials, and that |s| = |t|
/// its square: with these |t|^2 = `square` and its product with n (s_3 - t_3) have degrees of four
/// and six.
namespace platform_forward_kinematics {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 40;

/// A solution of `platform_forward_kinematics`.
struct Solution {
    double a;
    double b;
    double c;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<18> base, Values<18> platform, Values<6> lengths) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_platform_forward_kinematics_solve(base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<18> base, Values<18> platform, Values<6> lengths) {
    return try_solve(base, platform, lengths).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<18> base, Values<18> platform, Values<6> lengths) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_platform_forward_kinematics_solve_with(
            second_attempts.operations(), base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<18> base, Values<18> platform, Values<6> lengths) {
    return try_solve_with(second_attempts, base, platform, lengths).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many base, Many platform, Many lengths, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_platform_forward_kinematics_solve_batch(
            instances, base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `platform_forward_kinematics` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<18> base, Values<18> platform, Values<6> lengths) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_platform_forward_kinematics_solve_for_pose(base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<18> base, Values<18> platform, Values<6> lengths) {
    return try_solve_for_pose(base, platform, lengths).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<18> base, Values<18> platform, Values<6> lengths) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_platform_forward_kinematics_solve_with_for_pose(
            second_attempts.operations(), base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<18> base, Values<18> platform, Values<6> lengths) {
    return try_solve_with_for_pose(second_attempts, base, platform, lengths).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many base, Many platform, Many lengths, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_platform_forward_kinematics_solve_batch_for_pose(
            instances, base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<18> base, Values<18> platform, Values<6> lengths, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_platform_forward_kinematics_relative_residual(
        base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<18> base, Values<18> platform, Values<6> lengths, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_platform_forward_kinematics_error_bound(
        base.data(), base.size(), platform.data(), platform.size(), lengths.data(), lengths.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_platform_forward_kinematics_second_attempt_operations();
}

} // namespace platform_forward_kinematics

/// Pose of a calibrated camera from a point and two lines: 8 solutions, of which those with the
/// point in front of the camera are returned.
///
/// Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
/// ICRA 2011; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose estimation for minimal
/// configurations of 2D/3D point and line correspondences", ACCV 2018.
///
/// `ray` is the ray of the point in the camera, of any length, and `point` its position.
/// `normals[k]` is the image of line k: the plane through it and the centre of the camera is
/// perpendicular to that vector, of any length. It is the cross product of the rays of two points
/// of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
/// if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
/// `quaternion` is that of the rotation. The depth of the point along its ray is eliminated.
namespace pose_1pt_2line {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_1pt_2line`.
struct Solution {
    std::array<double, 4> quaternion; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_1pt_2line_solve(ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) {
    return try_solve(ray, point, normals, lines).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_1pt_2line_solve_with(
            second_attempts.operations(), ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) {
    return try_solve_with(second_attempts, ray, point, normals, lines).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many ray, Many point, Many normals, Many lines, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_1pt_2line_solve_batch(
            instances, ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_1pt_2line` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_1pt_2line_solve_for_pose(ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) {
    return try_solve_for_pose(ray, point, normals, lines).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_1pt_2line_solve_with_for_pose(
            second_attempts.operations(), ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines) {
    return try_solve_with_for_pose(second_attempts, ray, point, normals, lines).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many ray, Many point, Many normals, Many lines, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_1pt_2line_solve_batch_for_pose(
            instances, ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_1pt_2line_relative_residual(
        ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<3> ray, Values<3> point, Values<6> normals, Values<12> lines, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_1pt_2line_error_bound(
        ray.data(), ray.size(), point.data(), point.size(), normals.data(), normals.size(), lines.data(), lines.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_1pt_2line_second_attempt_operations();
}

} // namespace pose_1pt_2line

/// Pose of a calibrated camera from two points and a line: at most 2 solutions, those with the
/// points in front of the camera.
///
/// Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
/// ICRA 2011, who have 4 solutions, which are 2 with both signs of the depths.
///
/// `rays[k]` is the ray of point k in the camera, of any length, and `points[k]` its position.
/// `normal` is the image of the line: the plane through it and the centre of the camera is
/// perpendicular to that vector, of any length. It is the cross product of the rays of two points
/// of the image. `line` are two points of the line in space, other ones than the rays are of, if
/// need be. A point X has the coordinates `rotation` X + `translation` in the camera. In the frame
/// of the points the normal is perpendicular to the line: it is the sum of two vectors that are,
/// each times its weight. The depths of the points along their rays are linear in it, since it is
/// perpendicular to the plane, and the distance of the points gives a quadratic equation. The
/// points must not lie on the line, nor their images on its image.
namespace pose_2pt_1line {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 2;

/// A solution of `pose_2pt_1line`.
struct Solution {
    std::array<double, 2> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_1line_solve(rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) {
    return try_solve(rays, points, normal, line).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_1line_solve_with(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) {
    return try_solve_with(second_attempts, rays, points, normal, line).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many rays, Many points, Many normal, Many line, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_2pt_1line_solve_batch(
            instances, rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_2pt_1line` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_1line_solve_for_pose(rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) {
    return try_solve_for_pose(rays, points, normal, line).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_1line_solve_with_for_pose(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<6> rays, Values<6> points, Values<3> normal, Values<6> line) {
    return try_solve_with_for_pose(second_attempts, rays, points, normal, line).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many rays, Many points, Many normal, Many line, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_2pt_1line_solve_batch_for_pose(
            instances, rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<6> rays, Values<6> points, Values<3> normal, Values<6> line, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_2pt_1line_relative_residual(
        rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<6> rays, Values<6> points, Values<3> normal, Values<6> line, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_2pt_1line_error_bound(
        rays.data(), rays.size(), points.data(), points.size(), normal.data(), normal.size(), line.data(), line.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_2pt_1line_second_attempt_operations();
}

} // namespace pose_2pt_1line

/// Pose of a camera whose vertical is known, as by an inertial sensor, from two points: 2
/// solutions.
///
/// Kukelova, Bujnak, Pajdla, "Closed-form solutions to minimal absolute pose problems with known
/// vertical direction", ACCV 2010; here by the depths, as Haralick, Lee, Ottenberg, Nölle, IJCV
/// 1994, state the pose from three points.
///
/// `rays[k]` is the ray of point k in a frame of the camera whose y axis is vertical, of any
/// length, and `points[k]` its position in a world with the same vertical. The unknowns are the
/// depths along the rays. A pose X -> rotation X + translation takes the world to the camera; the
/// rotation is about the y axis, and both points are in front. The points must not be above each
/// other, nor both rays level.
namespace pose_2pt_upright {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 2;

/// A solution of `pose_2pt_upright`.
struct Solution {
    double a;
    double b;
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<6> rays, Values<6> points) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_upright_solve(rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<6> rays, Values<6> points) {
    return try_solve(rays, points).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<6> rays, Values<6> points) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_upright_solve_with(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<6> rays, Values<6> points) {
    return try_solve_with(second_attempts, rays, points).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many rays, Many points, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_2pt_upright_solve_batch(
            instances, rays.data(), rays.size(), points.data(), points.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_2pt_upright` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<6> rays, Values<6> points) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_upright_solve_for_pose(rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<6> rays, Values<6> points) {
    return try_solve_for_pose(rays, points).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<6> rays, Values<6> points) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_2pt_upright_solve_with_for_pose(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<6> rays, Values<6> points) {
    return try_solve_with_for_pose(second_attempts, rays, points).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many rays, Many points, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_2pt_upright_solve_batch_for_pose(
            instances, rays.data(), rays.size(), points.data(), points.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<6> rays, Values<6> points, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_2pt_upright_relative_residual(
        rays.data(), rays.size(), points.data(), points.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<6> rays, Values<6> points, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_2pt_upright_error_bound(
        rays.data(), rays.size(), points.data(), points.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_2pt_upright_second_attempt_operations();
}

} // namespace pose_2pt_upright

/// Pose and focal length of a camera from three points and one image coordinate of a fourth: 10
/// solutions.
///
/// Wu, "P3.5P: Pose estimation with unknown focal length", CVPR 2015. Published as `pose_35pt`.
///
/// `points` holds the points, one a row; `horizontal` and `vertical` their image coordinates,
/// centred at the principal point. The rotation is, up to scale, that about the optical axis times
/// that of the quaternion (1, x, y, 0). Each row of the matrix eliminates the rotation about the
/// optical axis, and what is unknown of the focal length, from three points: it annihilates (cos,
/// sin, 1/f). Where the camera looks against the third axis x and y are infinite. Points are turned
/// before, so that this is no direction in which one would look. A point X has the coordinates
/// `rotation` X + `translation` in the camera.
namespace pose_35pt_focal {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 10;

/// A solution of `pose_35pt_focal`.
struct Solution {
    double x;
    double y;
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> points, Values<4> horizontal, Values<3> vertical) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_35pt_focal_solve(points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> points, Values<4> horizontal, Values<3> vertical) {
    return try_solve(points, horizontal, vertical).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> points, Values<4> horizontal, Values<3> vertical) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_35pt_focal_solve_with(
            second_attempts.operations(), points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> points, Values<4> horizontal, Values<3> vertical) {
    return try_solve_with(second_attempts, points, horizontal, vertical).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many horizontal, Many vertical, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_35pt_focal_solve_batch(
            instances, points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_35pt_focal` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
    double focal;
};
static_assert(sizeof(Pose) == 13 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<12> points, Values<4> horizontal, Values<3> vertical) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_35pt_focal_solve_for_pose(points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<12> points, Values<4> horizontal, Values<3> vertical) {
    return try_solve_for_pose(points, horizontal, vertical).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<12> points, Values<4> horizontal, Values<3> vertical) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_35pt_focal_solve_with_for_pose(
            second_attempts.operations(), points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<12> points, Values<4> horizontal, Values<3> vertical) {
    return try_solve_with_for_pose(second_attempts, points, horizontal, vertical).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many points, Many horizontal, Many vertical, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_35pt_focal_solve_batch_for_pose(
            instances, points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> points, Values<4> horizontal, Values<3> vertical, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_35pt_focal_relative_residual(
        points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> points, Values<4> horizontal, Values<3> vertical, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_35pt_focal_error_bound(
        points.data(), points.size(), horizontal.data(), horizontal.size(), vertical.data(), vertical.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_35pt_focal_second_attempt_operations();
}

} // namespace pose_35pt_focal

/// Pose of a calibrated camera from three lines: 8 solutions.
///
/// Dhome, Richetin, Lapresté, Rives, "Determination of the attitude of 3D objects from a single
/// perspective view", PAMI 1989; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose
/// estimation for minimal configurations of 2D/3D point and line correspondences", ACCV 2018.
///
/// `normals[k]` is the image of line k: the plane through it and the centre of the camera is
/// perpendicular to that vector, of any length. It is the cross product of the rays of two points
/// of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
/// if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
/// `quaternion` is that of the rotation: `normals[k]` is perpendicular to the turned direction of
/// line k. Three planes give the translation. The lines must not be parallel, nor the planes meet
/// in a line.
namespace pose_3line {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_3line`.
struct Solution {
    std::array<double, 4> quaternion; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> normals, Values<18> lines) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3line_solve(normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> normals, Values<18> lines) {
    return try_solve(normals, lines).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> normals, Values<18> lines) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3line_solve_with(
            second_attempts.operations(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> normals, Values<18> lines) {
    return try_solve_with(second_attempts, normals, lines).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many normals, Many lines, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3line_solve_batch(
            instances, normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_3line` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<9> normals, Values<18> lines) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3line_solve_for_pose(normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<9> normals, Values<18> lines) {
    return try_solve_for_pose(normals, lines).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<9> normals, Values<18> lines) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3line_solve_with_for_pose(
            second_attempts.operations(), normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<9> normals, Values<18> lines) {
    return try_solve_with_for_pose(second_attempts, normals, lines).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many normals, Many lines, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3line_solve_batch_for_pose(
            instances, normals.data(), normals.size(), lines.data(), lines.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> normals, Values<18> lines, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3line_relative_residual(
        normals.data(), normals.size(), lines.data(), lines.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> normals, Values<18> lines, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3line_error_bound(
        normals.data(), normals.size(), lines.data(), lines.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_3line_second_attempt_operations();
}

} // namespace pose_3line

/// Pose of a calibrated camera from three points: at most 4 of 8 solutions, in front of the camera.
///
/// The problem `pose_3pt_depths` from measurements. `rays[k]` is the ray of point k in the camera,
/// of any length, and `points[k]` its position. The unknowns are the distances of the points from
/// the centre of the camera. A point x has the coordinates `rotation` x + `translation` in the
/// camera: the rotation takes the differences of positions, and their cross product, to those in
/// the camera.
namespace pose_3pt {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_3pt`.
struct Solution {
    std::array<double, 3> distances;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> rays, Values<9> points) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_solve(rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> rays, Values<9> points) {
    return try_solve(rays, points).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> rays, Values<9> points) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_solve_with(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> rays, Values<9> points) {
    return try_solve_with(second_attempts, rays, points).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many rays, Many points, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3pt_solve_batch(
            instances, rays.data(), rays.size(), points.data(), points.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_3pt` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<9> rays, Values<9> points) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_solve_for_pose(rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<9> rays, Values<9> points) {
    return try_solve_for_pose(rays, points).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<9> rays, Values<9> points) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_solve_with_for_pose(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<9> rays, Values<9> points) {
    return try_solve_with_for_pose(second_attempts, rays, points).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many rays, Many points, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3pt_solve_batch_for_pose(
            instances, rays.data(), rays.size(), points.data(), points.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> rays, Values<9> points, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3pt_relative_residual(
        rays.data(), rays.size(), points.data(), points.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> rays, Values<9> points, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3pt_error_bound(
        rays.data(), rays.size(), points.data(), points.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_3pt_second_attempt_operations();
}

} // namespace pose_3pt

/// Pose of a calibrated camera from three points: their distances from the centre of the camera, 8
/// solutions, which are 4 with both signs.
///
/// Grunert, "Das Pothenotische Problem in erweiterter Gestalt", 1841; in this form Haralick, Lee,
/// Ottenberg, Nölle, "Review and analysis of solutions of the three point perspective pose
/// estimation problem", IJCV 1994, equation (1).
///
/// `cosines` are those of the angles between the viewing rays of the points b and c, a and c, a and
/// b; `squares` the squared distances of these points. Those of the solutions are poses in which
/// all depths are positive.
namespace pose_3pt_depths {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_3pt_depths`.
struct Solution {
    double a;
    double b;
    double c;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<3> cosines, Values<3> squares) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_depths_solve(cosines.data(), cosines.size(), squares.data(), squares.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<3> cosines, Values<3> squares) {
    return try_solve(cosines, squares).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<3> cosines, Values<3> squares) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_depths_solve_with(
            second_attempts.operations(), cosines.data(), cosines.size(), squares.data(), squares.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<3> cosines, Values<3> squares) {
    return try_solve_with(second_attempts, cosines, squares).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many cosines, Many squares, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3pt_depths_solve_batch(
            instances, cosines.data(), cosines.size(), squares.data(), squares.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<3> cosines, Values<3> squares, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3pt_depths_relative_residual(
        cosines.data(), cosines.size(), squares.data(), squares.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<3> cosines, Values<3> squares, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3pt_depths_error_bound(
        cosines.data(), cosines.size(), squares.data(), squares.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_3pt_depths_second_attempt_operations();
}

} // namespace pose_3pt_depths

/// Poses of a camera with known vertical direction in which the errors of three points equal their
/// bounds and are stationary: 48 solutions.
///
/// Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
/// direction", PAMI 2017. Published as `optpose3pt_v2`. A pose with the largest number of points
/// within the bound can be moved until four errors equal it, or three where it can be moved no
/// further.
///
/// `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
/// `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
/// turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
/// in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
/// The derivatives of the three left sides by w, y and z are linearly dependent.
namespace pose_3pt_upright_error_bound {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 48;

/// A solution of `pose_3pt_upright_error_bound`.
struct Solution {
    double u;
    double v;
    double w;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> points, Values<6> images, double bound) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_upright_error_bound_solve(points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> points, Values<6> images, double bound) {
    return try_solve(points, images, bound).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> points, Values<6> images, double bound) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_upright_error_bound_solve_with(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> points, Values<6> images, double bound) {
    return try_solve_with(second_attempts, points, images, bound).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many images, Many bound, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3pt_upright_error_bound_solve_batch(
            instances, points.data(), points.size(), images.data(), images.size(), bound.data(), bound.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_3pt_upright_error_bound` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<9> points, Values<6> images, double bound) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_upright_error_bound_solve_for_pose(points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<9> points, Values<6> images, double bound) {
    return try_solve_for_pose(points, images, bound).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<9> points, Values<6> images, double bound) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_3pt_upright_error_bound_solve_with_for_pose(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<9> points, Values<6> images, double bound) {
    return try_solve_with_for_pose(second_attempts, points, images, bound).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many points, Many images, Many bound, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_3pt_upright_error_bound_solve_batch_for_pose(
            instances, points.data(), points.size(), images.data(), images.size(), bound.data(), bound.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> points, Values<6> images, double bound, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3pt_upright_error_bound_relative_residual(
        points.data(), points.size(), images.data(), images.size(), bound, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> points, Values<6> images, double bound, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_3pt_upright_error_bound_error_bound(
        points.data(), points.size(), images.data(), images.size(), bound, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_3pt_upright_error_bound_second_attempt_operations();
}

} // namespace pose_3pt_upright_error_bound

/// Pose and focal lengths of a camera from four points: 8 solutions, of which those with the points
/// in front of the camera are returned.
///
/// Bujnak, Kukelova, Pajdla, "A general solution to the P4P problem for camera with unknown focal
/// length", CVPR 2008, by three quadrics as Kukelova, Heller, Fitzgibbon, "Efficient intersection
/// of three quadrics and applications in computer vision", CVPR 2016.
///
/// `points[k]` is the position of point k, in a plane or not, and `images[k]` its image, relative
/// to the principal point. Eight equations leave a null space of dimension four of the camera
/// diag(f_x, f_y, 1) \[R t\], which is the sum of its vectors, each times its weight, up to scale.
/// Its first three columns have perpendicular rows. One focal length would be one equation too
/// many: it is left out, and of the results that one is wanted whose two `focal` lengths differ
/// least. A point X has the coordinates `rotation` X + `translation` in the camera.
namespace pose_4pt_focal {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_4pt_focal`.
struct Solution {
    std::array<double, 4> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_solve(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> points, Values<8> images) {
    return try_solve(points, images).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_solve_with(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images) {
    return try_solve_with(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many images, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_focal_solve_batch(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_4pt_focal` returns beside its unknowns.
struct FocalPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
    std::array<double, 2> focal;
};
static_assert(sizeof(FocalPose) == 14 * sizeof(double), "a row");

/// Real solutions of one instance: each focal_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_for_focal_pose(Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_solve_for_focal_pose(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each focal_pose. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_for_focal_pose(Values<12> points, Values<8> images) {
    return try_solve_for_focal_pose(points, images).value();
}

/// As `try_solve_for_focal_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_with_for_focal_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_solve_with_for_focal_pose(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_focal_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_with_for_focal_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images) {
    return try_solve_with_for_focal_pose(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_focal_pose(
    std::size_t instances, Many points, Many images, Batch<FocalPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_focal_solve_batch_for_focal_pose(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> points, Values<8> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_focal_relative_residual(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> points, Values<8> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_focal_error_bound(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_4pt_focal_second_attempt_operations();
}

} // namespace pose_4pt_focal

/// Pose, focal length and radial distortion of a camera from four points: 16 solutions.
///
/// Josephson, Byröd, "Pose estimation with radial distortion and unknown focal length", CVPR 2009,
/// in the form of Bujnak, Kukelova, Pajdla, "New efficient solution to the absolute pose problem
/// for camera with unknown focal length and radial distortion", ACCV 2010. Published as `p4p_fr`.
///
/// `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
/// principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
/// v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
/// 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
/// null space of dimension four: these rows are the sum of its vectors, each times its weight. The
/// third row follows from the four points. `projection` is P up to scale.
namespace pose_4pt_focal_radial {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 16;

/// A solution of `pose_4pt_focal_radial`.
struct Solution {
    std::array<double, 4> weights; ///< given up to scale: of length 1
    double radial;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_solve(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> points, Values<8> images) {
    return try_solve(points, images).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_solve_with(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images) {
    return try_solve_with(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many images, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_focal_radial_solve_batch(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_4pt_focal_radial` returns beside its unknowns.
struct RadialPose {
    std::array<std::array<double, 4>, 3> projection;
    double focal;
    double radial;
};
static_assert(sizeof(RadialPose) == 14 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialPose, max_solutions>> try_solve_for_radial_pose(Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<RadialPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_solve_for_radial_pose(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RadialPose, max_solutions> solve_for_radial_pose(Values<12> points, Values<8> images) {
    return try_solve_for_radial_pose(points, images).value();
}

/// As `try_solve_for_radial_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialPose, max_solutions>> try_solve_with_for_radial_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<RadialPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_solve_with_for_radial_pose(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialPose, max_solutions> solve_with_for_radial_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images) {
    return try_solve_with_for_radial_pose(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_pose(
    std::size_t instances, Many points, Many images, Batch<RadialPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_focal_radial_solve_batch_for_radial_pose(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> points, Values<8> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_focal_radial_relative_residual(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> points, Values<8> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_focal_radial_error_bound(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_4pt_focal_radial_second_attempt_operations();
}

} // namespace pose_4pt_focal_radial

/// Pose, focal length and radial distortion of a camera from four points, without the degenerate
/// solutions: 12 solutions.
///
/// Larsson, Kukelova, Zheng, "Making minimal solvers for absolute pose estimation compact and
/// robust", ICCV 2017. Published as `p4p_fr_iccv17`; `pose_4pt_focal_radial` is the older
/// formulation of the same problem, with 16.
///
/// `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
/// principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
/// v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
/// 1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
/// null space of dimension four: these rows are the sum of its vectors, each times its weight. The
/// third row follows from the four points. `projection` is P up to scale.
namespace pose_4pt_focal_radial_cut {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 12;

/// A solution of `pose_4pt_focal_radial_cut`.
struct Solution {
    double radial;
    std::array<double, 4> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_cut_solve(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> points, Values<8> images) {
    return try_solve(points, images).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_cut_solve_with(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images) {
    return try_solve_with(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many images, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_focal_radial_cut_solve_batch(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_4pt_focal_radial_cut` returns beside its unknowns.
struct RadialPose {
    std::array<std::array<double, 4>, 3> projection;
    double focal;
    double radial;
};
static_assert(sizeof(RadialPose) == 14 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialPose, max_solutions>> try_solve_for_radial_pose(Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<RadialPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_cut_solve_for_radial_pose(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RadialPose, max_solutions> solve_for_radial_pose(Values<12> points, Values<8> images) {
    return try_solve_for_radial_pose(points, images).value();
}

/// As `try_solve_for_radial_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialPose, max_solutions>> try_solve_with_for_radial_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images) noexcept {
    return Result<Solutions<RadialPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_focal_radial_cut_solve_with_for_radial_pose(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialPose, max_solutions> solve_with_for_radial_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images) {
    return try_solve_with_for_radial_pose(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_pose(
    std::size_t instances, Many points, Many images, Batch<RadialPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_focal_radial_cut_solve_batch_for_radial_pose(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> points, Values<8> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_focal_radial_cut_relative_residual(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> points, Values<8> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_focal_radial_cut_error_bound(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_4pt_focal_radial_cut_second_attempt_operations();
}

} // namespace pose_4pt_focal_radial_cut

/// Pose and scale of a generalised camera from four points: 8 solutions, of which those with a
/// positive scale are returned.
///
/// Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
/// problem", CVPR 2014. Published as `gp4p_scale`. As three quadrics: Kukelova, Heller, Fitzgibbon,
/// "Efficient intersection of three quadrics and applications in computer vision", CVPR 2016.
///
/// `rays[k]` is the ray of point k, of any length, from `centres[k]`, and `points[k]` its position.
/// With R = `rotation`, that of the quaternion, t = `translation` and s = `scale`,
/// R `points[k]` + t - s `centres[k]` is along `rays[k]`: for each point two equations, linear in
/// R, t and s. Seven of the eight are combined so that t and s vanish. `residual` is what the
/// eighth, of the last point, leaves over: the solution that fits it best is wanted.
namespace pose_4pt_generalized_scale {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_4pt_generalized_scale`.
struct Solution {
    std::array<double, 4> quaternion; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> centres, Values<12> rays, Values<12> points) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_generalized_scale_solve(centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> centres, Values<12> rays, Values<12> points) {
    return try_solve(centres, rays, points).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> centres, Values<12> rays, Values<12> points) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_generalized_scale_solve_with(
            second_attempts.operations(), centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> centres, Values<12> rays, Values<12> points) {
    return try_solve_with(second_attempts, centres, rays, points).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many centres, Many rays, Many points, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_generalized_scale_solve_batch(
            instances, centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_4pt_generalized_scale` returns beside its unknowns.
struct ScaledPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
    double scale;
    double residual;
};
static_assert(sizeof(ScaledPose) == 14 * sizeof(double), "a row");

/// Real solutions of one instance: each scaled_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<ScaledPose, max_solutions>> try_solve_for_scaled_pose(Values<12> centres, Values<12> rays, Values<12> points) noexcept {
    return Result<Solutions<ScaledPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_generalized_scale_solve_for_scaled_pose(centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each scaled_pose. Throws `Error`.
[[nodiscard]] inline Solutions<ScaledPose, max_solutions> solve_for_scaled_pose(Values<12> centres, Values<12> rays, Values<12> points) {
    return try_solve_for_scaled_pose(centres, rays, points).value();
}

/// As `try_solve_for_scaled_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<ScaledPose, max_solutions>> try_solve_with_for_scaled_pose(SecondAttempts second_attempts, Values<12> centres, Values<12> rays, Values<12> points) noexcept {
    return Result<Solutions<ScaledPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_generalized_scale_solve_with_for_scaled_pose(
            second_attempts.operations(), centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_scaled_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<ScaledPose, max_solutions> solve_with_for_scaled_pose(SecondAttempts second_attempts, Values<12> centres, Values<12> rays, Values<12> points) {
    return try_solve_with_for_scaled_pose(second_attempts, centres, rays, points).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_scaled_pose(
    std::size_t instances, Many centres, Many rays, Many points, Batch<ScaledPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_generalized_scale_solve_batch_for_scaled_pose(
            instances, centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> centres, Values<12> rays, Values<12> points, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_generalized_scale_relative_residual(
        centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> centres, Values<12> rays, Values<12> points, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_generalized_scale_error_bound(
        centres.data(), centres.size(), rays.data(), rays.size(), points.data(), points.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_4pt_generalized_scale_second_attempt_operations();
}

} // namespace pose_4pt_generalized_scale

/// Poses of a camera with known vertical direction in which the errors of four points equal their
/// bounds: 28 solutions.
///
/// Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
/// direction", PAMI 2017. Published as `optpose4pt_v2`. A pose with the largest number of points
/// within the bound can be moved until four errors equal it.
///
/// `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
/// `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
/// turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
/// in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
namespace pose_4pt_upright_error_bound {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 28;

/// A solution of `pose_4pt_upright_error_bound`.
struct Solution {
    double u;
    double v;
    double w;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> points, Values<8> images, double bound) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_upright_error_bound_solve(points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> points, Values<8> images, double bound) {
    return try_solve(points, images, bound).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images, double bound) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_upright_error_bound_solve_with(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> points, Values<8> images, double bound) {
    return try_solve_with(second_attempts, points, images, bound).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many images, Many bound, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_upright_error_bound_solve_batch(
            instances, points.data(), points.size(), images.data(), images.size(), bound.data(), bound.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_4pt_upright_error_bound` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<12> points, Values<8> images, double bound) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_upright_error_bound_solve_for_pose(points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<12> points, Values<8> images, double bound) {
    return try_solve_for_pose(points, images, bound).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images, double bound) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_4pt_upright_error_bound_solve_with_for_pose(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), bound, to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<12> points, Values<8> images, double bound) {
    return try_solve_with_for_pose(second_attempts, points, images, bound).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many points, Many images, Many bound, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_4pt_upright_error_bound_solve_batch_for_pose(
            instances, points.data(), points.size(), images.data(), images.size(), bound.data(), bound.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> points, Values<8> images, double bound, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_upright_error_bound_relative_residual(
        points.data(), points.size(), images.data(), images.size(), bound, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> points, Values<8> images, double bound, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_4pt_upright_error_bound_error_bound(
        points.data(), points.size(), images.data(), images.size(), bound, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_4pt_upright_error_bound_second_attempt_operations();
}

} // namespace pose_4pt_upright_error_bound

/// Pose of a calibrated camera that looks at five points through a plane at which light is
/// refracted: 8 solutions.
///
/// Haner, Åström, "Absolute pose for cameras under flat refractive interfaces", CVPR 2015.
/// Published as `refract5p`.
///
/// The plane is Z = 0, with the camera on one side of it and the points on the other. `rays[k]` is
/// the ray of point k in the camera, of any length, and `points[k]` its position; `index` is the
/// index of refraction on the side of the points, relative to that on the side of the camera.
/// Refraction keeps a ray in its plane with the normal, so that R ray and the point X minus the
/// centre (v, w, ..) of the camera are parallel in their first two coordinates:
/// (r1 ray) (X2 - w) - (r2 ray) (X1 - v) = 0 with the rows r1, r2, r3 of R. This is linear in r1,
/// r2 and u = v r2 - w r1, so these are a sum of four vectors, each times its weight. r1 and r2
/// have one length and are orthogonal, and u is in their plane: the determinant is 0. Four complex
/// solutions with r1 and r2 of length 0 satisfy that for any u. They are none of the other form, in
/// which u is the sum of its parts along r1 and r2. The two together are all cubic equations.
///
/// The published system is stated in a quaternion and has 16 solutions: with (r1, r2, r3) also
/// (-r1, -r2, r3), the same turned by a half about the normal. Both have the same weights here, up
/// to sign. Of the two, `rotation` is the one with the points ahead of the camera. It takes rays to
/// the frame of the points, and `centre` is that of the camera. Its height follows from how much
/// the rays are bent, by least squares.
namespace pose_5pt_refraction {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `pose_5pt_refraction`.
struct Solution {
    std::array<double, 4> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<15> rays, Values<15> points, double index) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5pt_refraction_solve(rays.data(), rays.size(), points.data(), points.size(), index, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<15> rays, Values<15> points, double index) {
    return try_solve(rays, points, index).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<15> rays, Values<15> points, double index) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5pt_refraction_solve_with(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), index, to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<15> rays, Values<15> points, double index) {
    return try_solve_with(second_attempts, rays, points, index).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many rays, Many points, Many index, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_5pt_refraction_solve_batch(
            instances, rays.data(), rays.size(), points.data(), points.size(), index.data(), index.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_5pt_refraction` returns beside its unknowns.
struct RefractedPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> centre;
};
static_assert(sizeof(RefractedPose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each refracted_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RefractedPose, max_solutions>> try_solve_for_refracted_pose(Values<15> rays, Values<15> points, double index) noexcept {
    return Result<Solutions<RefractedPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5pt_refraction_solve_for_refracted_pose(rays.data(), rays.size(), points.data(), points.size(), index, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each refracted_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RefractedPose, max_solutions> solve_for_refracted_pose(Values<15> rays, Values<15> points, double index) {
    return try_solve_for_refracted_pose(rays, points, index).value();
}

/// As `try_solve_for_refracted_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RefractedPose, max_solutions>> try_solve_with_for_refracted_pose(SecondAttempts second_attempts, Values<15> rays, Values<15> points, double index) noexcept {
    return Result<Solutions<RefractedPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5pt_refraction_solve_with_for_refracted_pose(
            second_attempts.operations(), rays.data(), rays.size(), points.data(), points.size(), index, to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_refracted_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RefractedPose, max_solutions> solve_with_for_refracted_pose(SecondAttempts second_attempts, Values<15> rays, Values<15> points, double index) {
    return try_solve_with_for_refracted_pose(second_attempts, rays, points, index).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_refracted_pose(
    std::size_t instances, Many rays, Many points, Many index, Batch<RefractedPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_5pt_refraction_solve_batch_for_refracted_pose(
            instances, rays.data(), rays.size(), points.data(), points.size(), index.data(), index.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<15> rays, Values<15> points, double index, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_5pt_refraction_relative_residual(
        rays.data(), rays.size(), points.data(), points.size(), index, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<15> rays, Values<15> points, double index, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_5pt_refraction_error_bound(
        rays.data(), rays.size(), points.data(), points.size(), index, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_5pt_refraction_second_attempt_operations();
}

} // namespace pose_5pt_refraction

/// Pose of two receivers close to each other from the time differences with which they hear five
/// senders: 24 solutions.
///
/// Burgess, Kuang, Åström, "Pose estimation from minimal dual-receiver configurations", ICPR 2012.
/// Published as `tdoa_pose_5pt`.
///
/// `senders` are positions, `differences` the differences of the ranges of each to the two
/// receivers, and `distance` is that of the receivers. They are at C, one from the other in the
/// direction n = (u, v, w). Divided by `distance`, the difference of the ranges of a sender U is
/// the cosine c of an angle: (n U - t)^2 = c^2 |n|^2 |U - C|^2 with t = n C. Five such equations
/// are linear in |n|^2 |C|^2 and |n|^2 C, and otherwise have the terms u u, u v, u w, v v, v w, w
/// w, t u, t v, t w and t t. They are solved for the former, and a fifth linear combination has
/// none of them. C follows from n and t, which are `plane`: n X = t passes through the receivers,
/// across their line. t is in units of the length of all positions.
namespace pose_5tdoa_two_receivers {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 24;

/// A solution of `pose_5tdoa_two_receivers`.
struct Solution {
    std::array<double, 4> plane; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<15> senders, Values<5> differences, double distance) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5tdoa_two_receivers_solve(senders.data(), senders.size(), differences.data(), differences.size(), distance, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<15> senders, Values<5> differences, double distance) {
    return try_solve(senders, differences, distance).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<15> senders, Values<5> differences, double distance) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5tdoa_two_receivers_solve_with(
            second_attempts.operations(), senders.data(), senders.size(), differences.data(), differences.size(), distance, to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<15> senders, Values<5> differences, double distance) {
    return try_solve_with(second_attempts, senders, differences, distance).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many senders, Many differences, Many distance, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_5tdoa_two_receivers_solve_batch(
            instances, senders.data(), senders.size(), differences.data(), differences.size(), distance.data(), distance.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_5tdoa_two_receivers` returns beside its unknowns.
struct ReceiverPair {
    std::array<double, 3> direction;
    std::array<double, 3> centre;
};
static_assert(sizeof(ReceiverPair) == 6 * sizeof(double), "a row");

/// Real solutions of one instance: each receiver_pair, or the code of an error.
[[nodiscard]] inline Result<Solutions<ReceiverPair, max_solutions>> try_solve_for_receiver_pair(Values<15> senders, Values<5> differences, double distance) noexcept {
    return Result<Solutions<ReceiverPair, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5tdoa_two_receivers_solve_for_receiver_pair(senders.data(), senders.size(), differences.data(), differences.size(), distance, to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each receiver_pair. Throws `Error`.
[[nodiscard]] inline Solutions<ReceiverPair, max_solutions> solve_for_receiver_pair(Values<15> senders, Values<5> differences, double distance) {
    return try_solve_for_receiver_pair(senders, differences, distance).value();
}

/// As `try_solve_for_receiver_pair`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<ReceiverPair, max_solutions>> try_solve_with_for_receiver_pair(SecondAttempts second_attempts, Values<15> senders, Values<5> differences, double distance) noexcept {
    return Result<Solutions<ReceiverPair, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_5tdoa_two_receivers_solve_with_for_receiver_pair(
            second_attempts.operations(), senders.data(), senders.size(), differences.data(), differences.size(), distance, to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_receiver_pair`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<ReceiverPair, max_solutions> solve_with_for_receiver_pair(SecondAttempts second_attempts, Values<15> senders, Values<5> differences, double distance) {
    return try_solve_with_for_receiver_pair(second_attempts, senders, differences, distance).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_receiver_pair(
    std::size_t instances, Many senders, Many differences, Many distance, Batch<ReceiverPair, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_5tdoa_two_receivers_solve_batch_for_receiver_pair(
            instances, senders.data(), senders.size(), differences.data(), differences.size(), distance.data(), distance.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<15> senders, Values<5> differences, double distance, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_5tdoa_two_receivers_relative_residual(
        senders.data(), senders.size(), differences.data(), differences.size(), distance, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<15> senders, Values<5> differences, double distance, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_5tdoa_two_receivers_error_bound(
        senders.data(), senders.size(), differences.data(), differences.size(), distance, reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_5tdoa_two_receivers_second_attempt_operations();
}

} // namespace pose_5tdoa_two_receivers

/// Pose and motion of a camera with rolling shutter from six points: 20 solutions.
///
/// Albl, Kukelova, Pajdla, "R6P - rolling shutter absolute camera pose", CVPR 2015. Published as
/// `r6p`.
///
/// `points[k]` is the position of a point and `images[k]` its image, in units of the focal length.
/// A point X is seen at q, in the row q\[0\], where (q, 1) and (I + q\[0\] \[(x, y, z)\]x) (I +
/// \[(u, v, w)\]x) X + C + q\[0\] t are parallel: both rotations linearised, the first for an
/// angular velocity. Three of the points, linear in the position C and the velocity t, give them as
/// position m and velocity m, m being the products of x, y, z (slower) with u, v, w, and then u, v,
/// w, x, y, z, 1.
namespace pose_6pt_rolling_shutter {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 20;

/// A solution of `pose_6pt_rolling_shutter`.
struct Solution {
    double u;
    double v;
    double w;
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 6 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<18> points, Values<12> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_6pt_rolling_shutter_solve(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<18> points, Values<12> images) {
    return try_solve(points, images).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<18> points, Values<12> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_6pt_rolling_shutter_solve_with(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<18> points, Values<12> images) {
    return try_solve_with(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many points, Many images, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_6pt_rolling_shutter_solve_batch(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_6pt_rolling_shutter` returns beside its unknowns.
struct RollingPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> position;
    std::array<double, 3> angular_velocity;
    std::array<double, 3> velocity;
};
static_assert(sizeof(RollingPose) == 18 * sizeof(double), "a row");

/// Real solutions of one instance: each rolling_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RollingPose, max_solutions>> try_solve_for_rolling_pose(Values<18> points, Values<12> images) noexcept {
    return Result<Solutions<RollingPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_6pt_rolling_shutter_solve_for_rolling_pose(points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each rolling_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RollingPose, max_solutions> solve_for_rolling_pose(Values<18> points, Values<12> images) {
    return try_solve_for_rolling_pose(points, images).value();
}

/// As `try_solve_for_rolling_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RollingPose, max_solutions>> try_solve_with_for_rolling_pose(SecondAttempts second_attempts, Values<18> points, Values<12> images) noexcept {
    return Result<Solutions<RollingPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_6pt_rolling_shutter_solve_with_for_rolling_pose(
            second_attempts.operations(), points.data(), points.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_rolling_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RollingPose, max_solutions> solve_with_for_rolling_pose(SecondAttempts second_attempts, Values<18> points, Values<12> images) {
    return try_solve_with_for_rolling_pose(second_attempts, points, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_rolling_pose(
    std::size_t instances, Many points, Many images, Batch<RollingPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_6pt_rolling_shutter_solve_batch_for_rolling_pose(
            instances, points.data(), points.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<18> points, Values<12> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_6pt_rolling_shutter_relative_residual(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<18> points, Values<12> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_6pt_rolling_shutter_error_bound(
        points.data(), points.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_6pt_rolling_shutter_second_attempt_operations();
}

} // namespace pose_6pt_rolling_shutter

/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost in
/// Cayley parameters: 27 solutions.
///
/// Hesch, Roumeliotis, "A direct least-squares (DLS) method for PnP", ICCV 2011. Published as
/// `opt_pnp_hesch`.
///
/// The cost is the mean squared distance of the points from the rays along which the camera sees
/// them, with the best translation, which is linear in the rotation. Without the common denominator
/// 1 + x^2 + y^2 + z^2 of the rotation of the quaternion (1, x, y, z) it is a polynomial of degree
/// four. `means` are those of `of_point` over 3 points or more. Rounding errors are smallest if the
/// origin is amid the points. Half turns would be at infinity. Points are turned before, so that
/// none of the poses that are at infinity is one that scenes are made of.
namespace pose_npt_direct_least_squares {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 27;

/// A solution of `pose_npt_direct_least_squares`.
struct Solution {
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<60> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_direct_least_squares_solve(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<60> means) {
    return try_solve(means).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<60> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_direct_least_squares_solve_with(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<60> means) {
    return try_solve_with(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many means, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_direct_least_squares_solve_batch(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_npt_direct_least_squares` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<60> means) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_direct_least_squares_solve_for_pose(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<60> means) {
    return try_solve_for_pose(means).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<60> means) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_direct_least_squares_solve_with_for_pose(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<60> means) {
    return try_solve_with_for_pose(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many means, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_direct_least_squares_solve_batch_for_pose(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<60> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_direct_least_squares_relative_residual(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<60> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_direct_least_squares_error_bound(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_npt_direct_least_squares_second_attempt_operations();
}

/// What a point gives: the products of its coordinates and 1, times the entries of the projection
/// across its ray. `ray` is the ray of the point in the camera, of any length.
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline std::array<std::array<double, 10>, 6> mean_of_point(std::size_t measurements, Many ray, Many point) {
    std::array<std::array<double, 10>, 6> mean{};
    static_assert(sizeof(mean) == 60 * sizeof(double), "an array of numbers");
    const std::int32_t code =
        eliminant_pose_npt_direct_least_squares_mean_of_point(measurements, ray.data(), ray.size(), point.data(), point.size(), reinterpret_cast<double *>(&mean), 60);
    if (code != ELIMINANT_OK) throw Error(code);
    return mean;
}

} // namespace pose_npt_direct_least_squares

/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost over
/// the rotations, by Cayley parameters: 40 solutions.
///
/// Nakano, "Globally optimal DLS method for PnP problem with Cayley parameterization", BMVC 2015.
/// Published as `opt_pnp_nakanoC`.
///
/// The cost is the mean squared distance of the points from the rays along which the camera sees
/// them, with the best translation, which is linear in the rotation: r^T `cost` r, r being the
/// entries of the rotation of the quaternion q, row by row. With r times |q|^2 in its place the
/// cost grows with the fourth power of the length of q, so q is stationary up to its length where
/// the gradient d is parallel to it. `means` are those of `of_point` over 3 points or more.
/// Rounding errors are smallest if the origin is amid the points.
namespace pose_npt_least_squares_cayley {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 40;

/// A solution of `pose_npt_least_squares_cayley`.
struct Solution {
    std::array<double, 4> q; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<60> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_cayley_solve(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<60> means) {
    return try_solve(means).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<60> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_cayley_solve_with(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<60> means) {
    return try_solve_with(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many means, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_least_squares_cayley_solve_batch(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_npt_least_squares_cayley` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<60> means) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_cayley_solve_for_pose(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<60> means) {
    return try_solve_for_pose(means).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<60> means) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_cayley_solve_with_for_pose(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<60> means) {
    return try_solve_with_for_pose(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many means, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_least_squares_cayley_solve_batch_for_pose(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<60> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_least_squares_cayley_relative_residual(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<60> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_least_squares_cayley_error_bound(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_npt_least_squares_cayley_second_attempt_operations();
}

/// What a point gives: the products of its coordinates and 1, times the entries of the projection
/// across its ray. `ray` is the ray of the point in the camera, of any length.
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline std::array<std::array<double, 10>, 6> mean_of_point(std::size_t measurements, Many ray, Many point) {
    std::array<std::array<double, 10>, 6> mean{};
    static_assert(sizeof(mean) == 60 * sizeof(double), "an array of numbers");
    const std::int32_t code =
        eliminant_pose_npt_least_squares_cayley_mean_of_point(measurements, ray.data(), ray.size(), point.data(), point.size(), reinterpret_cast<double *>(&mean), 60);
    if (code != ELIMINANT_OK) throw Error(code);
    return mean;
}

} // namespace pose_npt_least_squares_cayley

/// Pose of a calibrated camera from n points, all stationary points of a least-squares cost in a
/// quaternion that is not normalised: 40 solutions.
///
/// Zheng, Kuang, Sugimoto, Åström, Okutomi, "Revisiting the PnP problem: a fast, general and
/// optimal solution", ICCV 2013. Published as `opt_pnp_zheng`.
///
/// With depths relative to their mean, and P the rotation over the mean depth, the image (u, v) of
/// a point satisfies (u, v) (1 + P3 X) = (P1 X, P2 X) + constants, X relative to the mean of the
/// points. With the best constants the mean square of the differences is a quadratic form in 1 and
/// the entries of P, which are the products of two entries of a quaternion. The square of its
/// length, the inverse of the mean depth, is free: it is an unknown scale s times the unknown
/// direction q below. The derivatives, divided by s, are linear in the square of s, with the
/// coefficients `cubic` and `linear`: it follows from any of them, and is eliminated here.
///
/// `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
/// origin is amid the points.
namespace pose_npt_least_squares_quaternion {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 40;

/// A solution of `pose_npt_least_squares_quaternion`.
struct Solution {
    std::array<double, 4> q; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<39> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_quaternion_solve(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<39> means) {
    return try_solve(means).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<39> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_quaternion_solve_with(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<39> means) {
    return try_solve_with(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many means, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_least_squares_quaternion_solve_batch(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_npt_least_squares_quaternion` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<39> means) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_quaternion_solve_for_pose(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<39> means) {
    return try_solve_for_pose(means).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<39> means) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_least_squares_quaternion_solve_with_for_pose(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<39> means) {
    return try_solve_with_for_pose(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many means, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_least_squares_quaternion_solve_batch_for_pose(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<39> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_least_squares_quaternion_relative_residual(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<39> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_least_squares_quaternion_error_bound(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_npt_least_squares_quaternion_second_attempt_operations();
}

/// What a point and its image give: the products of two of the point's coordinates and 1, then
/// those with 1 times the coordinates of the image and times the square of its distance from the
/// principal point.
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline std::array<double, 39> mean_of_point(std::size_t measurements, Many image, Many point) {
    std::array<double, 39> mean{};
    static_assert(sizeof(mean) == 39 * sizeof(double), "an array of numbers");
    const std::int32_t code =
        eliminant_pose_npt_least_squares_quaternion_mean_of_point(measurements, image.data(), image.size(), point.data(), point.size(), reinterpret_cast<double *>(&mean), 39);
    if (code != ELIMINANT_OK) throw Error(code);
    return mean;
}

} // namespace pose_npt_least_squares_quaternion

/// Pose of a weak-perspective camera from n points, all stationary points of the least-squares
/// cost: 16 solutions.
///
/// Larsson, Åström, "Uncovering symmetries in polynomial systems", ECCV 2016. Published as `wpnp`.
///
/// The image of a point X is P X + t, with P the first two rows of a rotation times a scale, that
/// is, of the rotation of a quaternion q that is not normalised. With the best t the mean square of
/// the differences is a quadratic form in P, whose matrix is the covariance of the points. Since q
/// and -q are the same rotation, the unknowns are the ratios in q = root (w, 1, y, z), and
/// `square`, that of the root. Points are turned before, so that the entry of 1 is not 0 for poses
/// that scenes are made of. Published templates take the principal axes of the points instead, in
/// which the covariance is diagonal.
///
/// `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
/// origin is amid the points.
namespace pose_npt_weak_perspective {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 16;

/// A solution of `pose_npt_weak_perspective`.
struct Solution {
    double w;
    double square;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<17> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_weak_perspective_solve(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<17> means) {
    return try_solve(means).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<17> means) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_weak_perspective_solve_with(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<17> means) {
    return try_solve_with(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many means, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_weak_perspective_solve_batch(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `pose_npt_weak_perspective` returns beside its unknowns.
struct WeakPose {
    std::array<std::array<double, 3>, 3> rotation;
    double scale;
    std::array<double, 2> translation;
};
static_assert(sizeof(WeakPose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each weak_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<WeakPose, max_solutions>> try_solve_for_weak_pose(Values<17> means) noexcept {
    return Result<Solutions<WeakPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_weak_perspective_solve_for_weak_pose(means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each weak_pose. Throws `Error`.
[[nodiscard]] inline Solutions<WeakPose, max_solutions> solve_for_weak_pose(Values<17> means) {
    return try_solve_for_weak_pose(means).value();
}

/// As `try_solve_for_weak_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<WeakPose, max_solutions>> try_solve_with_for_weak_pose(SecondAttempts second_attempts, Values<17> means) noexcept {
    return Result<Solutions<WeakPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_pose_npt_weak_perspective_solve_with_for_weak_pose(
            second_attempts.operations(), means.data(), means.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_weak_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<WeakPose, max_solutions> solve_with_for_weak_pose(SecondAttempts second_attempts, Values<17> means) {
    return try_solve_with_for_weak_pose(second_attempts, means).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_weak_pose(
    std::size_t instances, Many means, Batch<WeakPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_pose_npt_weak_perspective_solve_batch_for_weak_pose(
            instances, means.data(), means.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<17> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_weak_perspective_relative_residual(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<17> means, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_pose_npt_weak_perspective_error_bound(
        means.data(), means.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_pose_npt_weak_perspective_second_attempt_operations();
}

/// What a point and its image give: the products of two of the point's coordinates and 1, then
/// those of the coordinates and 1 with those of the image.
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline std::array<double, 17> mean_of_point(std::size_t measurements, Many image, Many point) {
    std::array<double, 17> mean{};
    static_assert(sizeof(mean) == 17 * sizeof(double), "an array of numbers");
    const std::int32_t code =
        eliminant_pose_npt_weak_perspective_mean_of_point(measurements, image.data(), image.size(), point.data(), point.size(), reinterpret_cast<double *>(&mean), 17);
    if (code != ELIMINANT_OK) throw Error(code);
    return mean;
}

} // namespace pose_npt_weak_perspective

/// Relative pose of two calibrated cameras from three point correspondences where the motion turns
/// by a known angle about an axis without moving along it: 12 solutions.
///
/// Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
/// of known relative rotation angle", JMIV 62, 2020. Published as `3pra_st0`.
///
/// `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
/// the cosine and the sine of half the angle: the rotation from the first camera to the second is
/// that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
/// follows from any other point, and from the translation being orthogonal to (u, v, w). All
/// polynomials are written p + w q, with p and q in u and v only, and stated with their multiple by
/// w.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
/// The length of the translation is open, and it is of length 1; where the motion is a rotation it
/// is not known. Its sign is the one for which the first point is in front of the first camera.
namespace relpose_3pt_angle_zero_screw {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 12;

/// A solution of `relpose_3pt_angle_zero_screw`.
struct Solution {
    double u;
    double v;
    double w;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> first, Values<9> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_angle_zero_screw_solve(first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> first, Values<9> second, Values<2> half_angle) {
    return try_solve(first, second, half_angle).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_angle_zero_screw_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<2> half_angle) {
    return try_solve_with(second_attempts, first, second, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Many half_angle, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_3pt_angle_zero_screw_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_3pt_angle_zero_screw` returns beside its unknowns.
struct RelativePose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(RelativePose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each relative_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_for_relative_pose(Values<9> first, Values<9> second, Values<2> half_angle) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_angle_zero_screw_solve_for_relative_pose(first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each relative_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_for_relative_pose(Values<9> first, Values<9> second, Values<2> half_angle) {
    return try_solve_for_relative_pose(first, second, half_angle).value();
}

/// As `try_solve_for_relative_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_with_for_relative_pose(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<2> half_angle) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_angle_zero_screw_solve_with_for_relative_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_relative_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_with_for_relative_pose(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<2> half_angle) {
    return try_solve_with_for_relative_pose(second_attempts, first, second, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_relative_pose(
    std::size_t instances, Many first, Many second, Many half_angle, Batch<RelativePose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_3pt_angle_zero_screw_solve_batch_for_relative_pose(
            instances, first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> first, Values<9> second, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_3pt_angle_zero_screw_relative_residual(
        first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> first, Values<9> second, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_3pt_angle_zero_screw_error_bound(
        first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_3pt_angle_zero_screw_second_attempt_operations();
}

} // namespace relpose_3pt_angle_zero_screw

/// Relative pose of two calibrated cameras from three points with depths that are known up to scale
/// and shift, as a network estimates them from each image: at most 4 solutions.
///
/// Ding, Kocur, Vávra, Berger Haladová, Yang, Sattler, Kukelova, "RePoseD: Efficient relative pose
/// estimation with known depth information", ICCV 2025; Yu, Liu, Pautrat, Pollefeys, Larsson,
/// "Relative pose estimation through affine corrections of monocular depth priors", CVPR 2025.
///
/// `first[k]` and `second[k]` are the images of point k, (x, y) of the ray (x, y, 1), and
/// `first_depths[k]` and `second_depths[k]` its depths, the third coordinates, as estimated. The
/// point is at (`first_depths[k]` + u) (x, y, 1) in the first camera and at `scale`
/// (`second_depths[k]` + v) (x, y, 1) in the second; `shifts` are u and v. Squared distances of the
/// points are quadratic in the shifts, and those in the second camera are 1 / `scale`^2 of those in
/// the first. Three of them, solved for 1, u and u^2, give these times 1 / `scale`^2 as `powers`,
/// which are quadratic in v: the first times the third is the square of the second. A point X in
/// the first camera is at `rotation` X + `translation` in the second.
namespace relpose_3pt_depths {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 4;

/// A solution of `relpose_3pt_depths`.
struct Solution {
    double v;
};
static_assert(sizeof(Solution) == 1 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_depths_solve(first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) {
    return try_solve(first, first_depths, second, second_depths).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_depths_solve_with(
            second_attempts.operations(), first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) {
    return try_solve_with(second_attempts, first, first_depths, second, second_depths).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many first_depths, Many second, Many second_depths, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_3pt_depths_solve_batch(
            instances, first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_3pt_depths` returns beside its unknowns.
struct DepthPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
    double scale;
    std::array<double, 2> shifts;
};
static_assert(sizeof(DepthPose) == 15 * sizeof(double), "a row");

/// Real solutions of one instance: each depth_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<DepthPose, max_solutions>> try_solve_for_depth_pose(Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) noexcept {
    return Result<Solutions<DepthPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_depths_solve_for_depth_pose(first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each depth_pose. Throws `Error`.
[[nodiscard]] inline Solutions<DepthPose, max_solutions> solve_for_depth_pose(Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) {
    return try_solve_for_depth_pose(first, first_depths, second, second_depths).value();
}

/// As `try_solve_for_depth_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<DepthPose, max_solutions>> try_solve_with_for_depth_pose(SecondAttempts second_attempts, Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) noexcept {
    return Result<Solutions<DepthPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_depths_solve_with_for_depth_pose(
            second_attempts.operations(), first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_depth_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<DepthPose, max_solutions> solve_with_for_depth_pose(SecondAttempts second_attempts, Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths) {
    return try_solve_with_for_depth_pose(second_attempts, first, first_depths, second, second_depths).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_depth_pose(
    std::size_t instances, Many first, Many first_depths, Many second, Many second_depths, Batch<DepthPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_3pt_depths_solve_batch_for_depth_pose(
            instances, first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_3pt_depths_relative_residual(
        first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<6> first, Values<3> first_depths, Values<6> second, Values<3> second_depths, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_3pt_depths_error_bound(
        first.data(), first.size(), first_depths.data(), first_depths.size(), second.data(), second.size(), second_depths.data(), second_depths.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_3pt_depths_second_attempt_operations();
}

} // namespace relpose_3pt_depths

/// Relative pose of two cameras whose vertical is known, as by an inertial sensor, from three
/// points: 4 solutions.
///
/// Fraundorfer, Tanskanen, Pollefeys, "A minimal case solution to the calibrated relative pose
/// problem for the case of two known orientation angles", ECCV 2010.
///
/// `first[k]` and `second[k]` are the rays of point k in frames of the cameras whose y axes are
/// vertical, of any length. The unknowns are cosine and sine of the turn about the vertical.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
/// The length of the translation is open, and it is of length 1; where the motion is a rotation it
/// is not known. Its sign is the one for which the first point is in front of the first camera.
namespace relpose_3pt_upright {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 4;

/// A solution of `relpose_3pt_upright`.
struct Solution {
    double c;
    double s;
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> first, Values<9> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_upright_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> first, Values<9> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> first, Values<9> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_upright_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> first, Values<9> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_3pt_upright_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_3pt_upright` returns beside its unknowns.
struct RelativePose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(RelativePose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each relative_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_for_relative_pose(Values<9> first, Values<9> second) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_upright_solve_for_relative_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each relative_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_for_relative_pose(Values<9> first, Values<9> second) {
    return try_solve_for_relative_pose(first, second).value();
}

/// As `try_solve_for_relative_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_with_for_relative_pose(SecondAttempts second_attempts, Values<9> first, Values<9> second) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_3pt_upright_solve_with_for_relative_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_relative_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_with_for_relative_pose(SecondAttempts second_attempts, Values<9> first, Values<9> second) {
    return try_solve_with_for_relative_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_relative_pose(
    std::size_t instances, Many first, Many second, Batch<RelativePose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_3pt_upright_solve_batch_for_relative_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> first, Values<9> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_3pt_upright_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> first, Values<9> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_3pt_upright_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_3pt_upright_second_attempt_operations();
}

} // namespace relpose_3pt_upright

/// Relative pose of two calibrated cameras with a known angle of rotation from four point
/// correspondences: 20 solutions.
///
/// Li, Heng, Lee, Pollefeys, "A 4-point algorithm for relative pose estimation of a calibrated
/// camera with a known relative rotation angle", IROS 2013. Published as `relpose_4pt`, with the
/// translation among the unknowns; it is eliminated here as in Martyushev, Li, "Efficient relative
/// pose estimation for cameras and generalized cameras in case of known relative rotation angle",
/// JMIV 62, 2020.
///
/// `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
/// the cosine and the sine of half the angle: the rotation from the first camera to the second is
/// that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
/// follows from any other point. All polynomials are written p + w q, with p and q in u and v only,
/// and stated with their multiple by w.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
/// The length of the translation is open, and it is of length 1; where the motion is a rotation it
/// is not known. Its sign is the one for which the first point is in front of the first camera.
namespace relpose_4pt_angle {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 20;

/// A solution of `relpose_4pt_angle`.
struct Solution {
    double u;
    double v;
    double w;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> first, Values<12> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_4pt_angle_solve(first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> first, Values<12> second, Values<2> half_angle) {
    return try_solve(first, second, half_angle).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> first, Values<12> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_4pt_angle_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> first, Values<12> second, Values<2> half_angle) {
    return try_solve_with(second_attempts, first, second, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Many half_angle, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_4pt_angle_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_4pt_angle` returns beside its unknowns.
struct RelativePose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(RelativePose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each relative_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_for_relative_pose(Values<12> first, Values<12> second, Values<2> half_angle) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_4pt_angle_solve_for_relative_pose(first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each relative_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_for_relative_pose(Values<12> first, Values<12> second, Values<2> half_angle) {
    return try_solve_for_relative_pose(first, second, half_angle).value();
}

/// As `try_solve_for_relative_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_with_for_relative_pose(SecondAttempts second_attempts, Values<12> first, Values<12> second, Values<2> half_angle) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_4pt_angle_solve_with_for_relative_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_relative_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_with_for_relative_pose(SecondAttempts second_attempts, Values<12> first, Values<12> second, Values<2> half_angle) {
    return try_solve_with_for_relative_pose(second_attempts, first, second, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_relative_pose(
    std::size_t instances, Many first, Many second, Many half_angle, Batch<RelativePose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_4pt_angle_solve_batch_for_relative_pose(
            instances, first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> first, Values<12> second, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_4pt_angle_relative_residual(
        first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> first, Values<12> second, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_4pt_angle_error_bound(
        first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_4pt_angle_second_attempt_operations();
}

} // namespace relpose_4pt_angle

/// Relative pose of two calibrated cameras from five point correspondences: 10 essential matrices.
///
/// Nistér, "An efficient solution to the five-point relative pose problem", PAMI 2004; in this form
/// Stewénius, Engels, Nistér, "Recent developments on direct relative orientation", ISPRS 2006.
/// Published as `5p`.
///
/// `basis` spans the null space of the five epipolar equations; the essential matrix is the sum
/// of its matrices, each times its weight.
namespace relpose_5pt {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 10;

/// A solution of `relpose_5pt`.
struct Solution {
    std::array<double, 4> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<36> basis) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_solve(basis.data(), basis.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<36> basis) {
    return try_solve(basis).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<36> basis) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_solve_with(
            second_attempts.operations(), basis.data(), basis.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<36> basis) {
    return try_solve_with(second_attempts, basis).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many basis, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_solve_batch(
            instances, basis.data(), basis.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<36> basis, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_relative_residual(
        basis.data(), basis.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<36> basis, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_error_bound(
        basis.data(), basis.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_5pt_second_attempt_operations();
}

} // namespace relpose_5pt

/// Relative pose of two generalized cameras with a known angle of rotation from five point
/// correspondences: 44 solutions.
///
/// Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
/// of known relative rotation angle", JMIV 62, 2020. Published as `gen5pra`.
///
/// `first` and `second` hold the rays of the points in either system of cameras: a point of the
/// ray, and its direction. `half_angle` holds the cosine and the sine of half the angle: the
/// rotation from the first system to the second is that of the unit quaternion cosine + u i + v j +
/// w k. That the rays of one point meet gives the translation up to the depths of that point along
/// either ray; that the rays of any three others meet, too, are linear equations for these depths.
/// All polynomials are written p + w q, with p and q in u and v only, and stated with their
/// multiple by w.
///
/// A pose X -> rotation X + translation takes the first system to the second, in the unit of the
/// points of the rays.
namespace relpose_5pt_generalized_angle {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 44;

/// A solution of `relpose_5pt_generalized_angle`.
struct Solution {
    double u;
    double v;
    double w;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<30> first, Values<30> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_generalized_angle_solve(first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<30> first, Values<30> second, Values<2> half_angle) {
    return try_solve(first, second, half_angle).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<30> first, Values<30> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_generalized_angle_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<30> first, Values<30> second, Values<2> half_angle) {
    return try_solve_with(second_attempts, first, second, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Many half_angle, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_generalized_angle_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_5pt_generalized_angle` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<30> first, Values<30> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_generalized_angle_solve_for_pose(first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<30> first, Values<30> second, Values<2> half_angle) {
    return try_solve_for_pose(first, second, half_angle).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<30> first, Values<30> second, Values<2> half_angle) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_generalized_angle_solve_with_for_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<30> first, Values<30> second, Values<2> half_angle) {
    return try_solve_with_for_pose(second_attempts, first, second, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many first, Many second, Many half_angle, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_generalized_angle_solve_batch_for_pose(
            instances, first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<30> first, Values<30> second, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_generalized_angle_relative_residual(
        first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<30> first, Values<30> second, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_generalized_angle_error_bound(
        first.data(), first.size(), second.data(), second.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_5pt_generalized_angle_second_attempt_operations();
}

} // namespace relpose_5pt_generalized_angle

/// Relative pose of two calibrated cameras from five points: 10 essential matrices.
///
/// The problem `relpose_5pt` from measurements. `first[k]` and `second[k]` are the rays of point k
/// in both cameras, of any length. An essential matrix E satisfies `second[k] . E first[k] = 0`; it
/// is the sum of the matrices that span the null space of these equations, each times its weight.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
/// the translation has the length 1. Of the four poses of an essential matrix it is the one with
/// the first point in front of both cameras: Horn, "Recovering baseline and orientation from
/// essential matrix", 1990. For a solution that belongs to the scene all points are in front.
namespace relpose_5pt_rays {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 10;

/// A solution of `relpose_5pt_rays`.
struct Solution {
    std::array<double, 4> weights; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<15> first, Values<15> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_rays_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<15> first, Values<15> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<15> first, Values<15> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_rays_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<15> first, Values<15> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_rays_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_5pt_rays` returns beside its unknowns.
struct RelativePose {
    std::array<std::array<double, 3>, 3> essential; ///< given up to scale
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(RelativePose) == 21 * sizeof(double), "a row");

/// Real solutions of one instance: each relative_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_for_relative_pose(Values<15> first, Values<15> second) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_rays_solve_for_relative_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each relative_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_for_relative_pose(Values<15> first, Values<15> second) {
    return try_solve_for_relative_pose(first, second).value();
}

/// As `try_solve_for_relative_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RelativePose, max_solutions>> try_solve_with_for_relative_pose(SecondAttempts second_attempts, Values<15> first, Values<15> second) noexcept {
    return Result<Solutions<RelativePose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_rays_solve_with_for_relative_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_relative_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RelativePose, max_solutions> solve_with_for_relative_pose(SecondAttempts second_attempts, Values<15> first, Values<15> second) {
    return try_solve_with_for_relative_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_relative_pose(
    std::size_t instances, Many first, Many second, Batch<RelativePose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_rays_solve_batch_for_relative_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<15> first, Values<15> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_rays_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<15> first, Values<15> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_rays_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_5pt_rays_second_attempt_operations();
}

} // namespace relpose_5pt_rays

/// Pose and focal length of a camera from five points that calibrated cameras of known poses see,
/// too, and one point of known position: 56 solutions.
///
/// Bhayani, Sattler, Larsson, Heikkilä, Kukelova, "Partially calibrated semi-generalized pose from
/// hybrid point correspondences", WACV 2023. Published as `hyb51f`.
///
/// `image` is that of the known `point`, relative to the principal point, and must not be there.
/// `images[k]` is that of point k, which a calibrated camera sees along the ray from `centres[k]`
/// in the direction `directions[k]`. Positions are relative to `point`; images are turned and
/// scaled so that that of `point` is (1, 0), and its depth is the unknown `depth`. The rotation of
/// the camera, which is turned with the images, is that of the quaternion 1 + x i + y j, and a turn
/// about its axis after it, by the angle of which c and s are cosine and sine, times the focal
/// length. An image lies on that of the ray: det(M) M^-T, the cofactors of M, maps moments of rays
/// to lines of the image where M maps directions to points of it. The squared norm of the
/// quaternion, which divides all cofactors, is left out.
///
/// A pose X -> rotation X + translation takes the world to the camera; `focal` is in the unit of
/// images. The known point is in front of the camera.
namespace relpose_5pt_semi_generalized_focal {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 56;

/// A solution of `relpose_5pt_semi_generalized_focal`.
struct Solution {
    double x;
    double y;
    double c;
    double s;
    double depth;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_semi_generalized_focal_solve(point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) {
    return try_solve(point, image, images, centres, directions).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_semi_generalized_focal_solve_with(
            second_attempts.operations(), point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) {
    return try_solve_with(second_attempts, point, image, images, centres, directions).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many point, Many image, Many images, Many centres, Many directions, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_semi_generalized_focal_solve_batch(
            instances, point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_5pt_semi_generalized_focal` returns beside its unknowns.
struct FocalPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
    double focal;
};
static_assert(sizeof(FocalPose) == 13 * sizeof(double), "a row");

/// Real solutions of one instance: each focal_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_for_focal_pose(Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_semi_generalized_focal_solve_for_focal_pose(point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each focal_pose. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_for_focal_pose(Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) {
    return try_solve_for_focal_pose(point, image, images, centres, directions).value();
}

/// As `try_solve_for_focal_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_with_for_focal_pose(SecondAttempts second_attempts, Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_5pt_semi_generalized_focal_solve_with_for_focal_pose(
            second_attempts.operations(), point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_focal_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_with_for_focal_pose(SecondAttempts second_attempts, Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions) {
    return try_solve_with_for_focal_pose(second_attempts, point, image, images, centres, directions).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_focal_pose(
    std::size_t instances, Many point, Many image, Many images, Many centres, Many directions, Batch<FocalPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_5pt_semi_generalized_focal_solve_batch_for_focal_pose(
            instances, point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_semi_generalized_focal_relative_residual(
        point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<3> point, Values<2> image, Values<10> images, Values<15> centres, Values<15> directions, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_5pt_semi_generalized_focal_error_bound(
        point.data(), point.size(), image.data(), image.size(), images.data(), images.size(), centres.data(), centres.size(), directions.data(), directions.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_5pt_semi_generalized_focal_second_attempt_operations();
}

} // namespace relpose_5pt_semi_generalized_focal

/// Relative pose of two cameras with one unknown shared focal length from six point
/// correspondences: 15 solutions.
///
/// Stewénius, Nistér, Kahl, Schaffalitzky, "A minimal solution for relative pose with unknown focal
/// length", CVPR 2005; the form with w = 1/f^2 as in Kukelova, Bujnak, Pajdla, "Polynomial
/// eigenvalue solutions to the 5-pt and 6-pt relative pose problems", BMVC 2008. Published as
/// `focal6p`.
///
/// `basis` spans the null space of the six epipolar equations; the fundamental matrix is the
/// sum of its matrices, each times its weight.
namespace relpose_6pt_focal {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 15;

/// A solution of `relpose_6pt_focal`.
struct Solution {
    std::array<double, 3> weights; ///< given up to scale: of length 1
    double w;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<27> basis) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_solve(basis.data(), basis.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<27> basis) {
    return try_solve(basis).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<27> basis) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_solve_with(
            second_attempts.operations(), basis.data(), basis.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<27> basis) {
    return try_solve_with(second_attempts, basis).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many basis, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_focal_solve_batch(
            instances, basis.data(), basis.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<27> basis, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_focal_relative_residual(
        basis.data(), basis.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<27> basis, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_focal_error_bound(
        basis.data(), basis.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_6pt_focal_second_attempt_operations();
}

} // namespace relpose_6pt_focal

/// Relative pose of a camera with unknown focal length and a calibrated one from six points: 9
/// solutions, of which those with a real focal length are returned.
///
/// Bujnak, Kukelova, Pajdla, "3D reconstruction from image collections with a single known focal
/// length", ICCV 2009. Published as `focal6p_1s`.
///
/// `first[k]` is the image of point k in the camera with unknown focal length, relative to the
/// principal point, `second[k]` its ray in the calibrated one, of any length. A fundamental matrix
/// F satisfies `second[k] . F (first[k], 1) = 0`; it is the sum of the matrices that span the null
/// space of these equations, each times its weight. w is 1 / focal^2 in units of the length of all
/// images.
namespace relpose_6pt_focal_one_side {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 9;

/// A solution of `relpose_6pt_focal_one_side`.
struct Solution {
    std::array<double, 3> weights; ///< given up to scale: of length 1
    double w;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> first, Values<18> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_one_side_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> first, Values<18> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> first, Values<18> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_one_side_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> first, Values<18> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_focal_one_side_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_6pt_focal_one_side` returns beside its unknowns.
struct FocalPose {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double focal;
};
static_assert(sizeof(FocalPose) == 10 * sizeof(double), "a row");

/// Real solutions of one instance: each focal_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_for_focal_pose(Values<12> first, Values<18> second) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_one_side_solve_for_focal_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each focal_pose. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_for_focal_pose(Values<12> first, Values<18> second) {
    return try_solve_for_focal_pose(first, second).value();
}

/// As `try_solve_for_focal_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_with_for_focal_pose(SecondAttempts second_attempts, Values<12> first, Values<18> second) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_one_side_solve_with_for_focal_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_focal_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_with_for_focal_pose(SecondAttempts second_attempts, Values<12> first, Values<18> second) {
    return try_solve_with_for_focal_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_focal_pose(
    std::size_t instances, Many first, Many second, Batch<FocalPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_focal_one_side_solve_batch_for_focal_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> first, Values<18> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_focal_one_side_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> first, Values<18> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_focal_one_side_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_6pt_focal_one_side_second_attempt_operations();
}

} // namespace relpose_6pt_focal_one_side

/// Relative pose of two cameras with one unknown shared focal length from six points: 15 solutions,
/// of which those with a real focal length are returned.
///
/// The problem `relpose_6pt_focal` from measurements. `first[k]` and `second[k]` are the images of
/// point k, relative to the principal points. The fundamental matrix is the sum of the matrices
/// that span the null space of the epipolar equations, each times its weight. w is 1 / focal^2 in
/// units of the length of all images.
///
/// A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
/// the translation has the length 1. Of the four poses of an essential matrix it is the one with
/// the first point in front of both cameras, as in `relpose_5pt_rays`. For a solution that belongs
/// to the scene all points are in front.
namespace relpose_6pt_focal_points {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 15;

/// A solution of `relpose_6pt_focal_points`.
struct Solution {
    std::array<double, 3> weights; ///< given up to scale: of length 1
    double w;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_points_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> first, Values<12> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_points_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> first, Values<12> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_focal_points_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_6pt_focal_points` returns beside its unknowns.
struct FocalPose {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double focal;
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(FocalPose) == 22 * sizeof(double), "a row");

/// Real solutions of one instance: each focal_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_for_focal_pose(Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_points_solve_for_focal_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each focal_pose. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_for_focal_pose(Values<12> first, Values<12> second) {
    return try_solve_for_focal_pose(first, second).value();
}

/// As `try_solve_for_focal_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<FocalPose, max_solutions>> try_solve_with_for_focal_pose(SecondAttempts second_attempts, Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<FocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_focal_points_solve_with_for_focal_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_focal_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<FocalPose, max_solutions> solve_with_for_focal_pose(SecondAttempts second_attempts, Values<12> first, Values<12> second) {
    return try_solve_with_for_focal_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_focal_pose(
    std::size_t instances, Many first, Many second, Batch<FocalPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_focal_points_solve_batch_for_focal_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> first, Values<12> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_focal_points_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> first, Values<12> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_focal_points_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_6pt_focal_points_second_attempt_operations();
}

} // namespace relpose_6pt_focal_points

/// Relative pose of two generalized cameras from six point correspondences: 64 solutions.
///
/// Stewénius, Nistér, Oskarsson, Åström, "Solutions to minimal generalized relative pose problems",
/// OMNIVIS 2005. Published as `gen6p`.
///
/// `first` and `second` hold the rays of the points in either system of cameras: a point of the
/// ray, and its direction. The rotation from the first system to the second is that of the
/// quaternion q. That the rays of one point meet gives the translation up to the
/// depths of that point along either ray; that the rays of any three others meet, too, are linear
/// equations for these depths.
///
/// A pose X -> rotation X + translation takes the first system to the second, in the unit of the
/// points of the rays.
namespace relpose_6pt_generalized {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 64;

/// A solution of `relpose_6pt_generalized`.
struct Solution {
    std::array<double, 4> q; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<36> first, Values<36> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_generalized_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<36> first, Values<36> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<36> first, Values<36> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_generalized_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<36> first, Values<36> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_generalized_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_6pt_generalized` returns beside its unknowns.
struct Pose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
};
static_assert(sizeof(Pose) == 12 * sizeof(double), "a row");

/// Real solutions of one instance: each pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_for_pose(Values<36> first, Values<36> second) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_generalized_solve_for_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each pose. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_for_pose(Values<36> first, Values<36> second) {
    return try_solve_for_pose(first, second).value();
}

/// As `try_solve_for_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Pose, max_solutions>> try_solve_with_for_pose(SecondAttempts second_attempts, Values<36> first, Values<36> second) noexcept {
    return Result<Solutions<Pose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_generalized_solve_with_for_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Pose, max_solutions> solve_with_for_pose(SecondAttempts second_attempts, Values<36> first, Values<36> second) {
    return try_solve_with_for_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_pose(
    std::size_t instances, Many first, Many second, Batch<Pose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_generalized_solve_batch_for_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<36> first, Values<36> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_generalized_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<36> first, Values<36> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_generalized_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_6pt_generalized_second_attempt_operations();
}

} // namespace relpose_6pt_generalized

/// The essential matrix and the radial distortion common to two otherwise calibrated cameras from
/// six points: 52 solutions.
///
/// Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
/// problems for cameras with radial distortion", CVIU 114, 2010. Published as `relpose_6p_rad`,
/// with e33 = 1, which loses planar motions and those without a rotation: e33 is 0.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
/// distortion and in units of the focal length. An image x lies along (x, 1 + radial |x|^2), the
/// division model. Then x1^T E x2 = 0 is, with e23 = 1, linear in e11, e21, e12, e22, radial e31,
/// e31 and the monomials e32, radial e32, e13, radial e13, 1, radial, radial^2 e33, radial e33,
/// e33: six points give the former as combinations of these. How well depends on which image is the
/// first, and on how the second one is turned about its centre: the best of eight choices is taken.
/// The first image is turned, too, which turns (e13, e23): for usual motions one of these is 0 if
/// it is not.
namespace relpose_6pt_radial {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 52;

/// A solution of `relpose_6pt_radial`.
struct Solution {
    double e_13;
    double e_32;
    double e_33;
    double radial;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_radial_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<12> first, Values<12> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_radial_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<12> first, Values<12> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_radial_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_6pt_radial` returns beside its unknowns.
struct RadialPose {
    std::array<std::array<double, 3>, 3> essential; ///< given up to scale
    double radial;
};
static_assert(sizeof(RadialPose) == 10 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialPose, max_solutions>> try_solve_for_radial_pose(Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<RadialPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_radial_solve_for_radial_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RadialPose, max_solutions> solve_for_radial_pose(Values<12> first, Values<12> second) {
    return try_solve_for_radial_pose(first, second).value();
}

/// As `try_solve_for_radial_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialPose, max_solutions>> try_solve_with_for_radial_pose(SecondAttempts second_attempts, Values<12> first, Values<12> second) noexcept {
    return Result<Solutions<RadialPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_6pt_radial_solve_with_for_radial_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialPose, max_solutions> solve_with_for_radial_pose(SecondAttempts second_attempts, Values<12> first, Values<12> second) {
    return try_solve_with_for_radial_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_pose(
    std::size_t instances, Many first, Many second, Batch<RadialPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_6pt_radial_solve_batch_for_radial_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<12> first, Values<12> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_radial_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<12> first, Values<12> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_6pt_radial_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_6pt_radial_second_attempt_operations();
}

} // namespace relpose_6pt_radial

/// Focal length and principal point common to two cameras from their fundamental matrix and the
/// angle of rotation between them: 6 solutions.
///
/// Martyushev, "Self-calibration of cameras with Euclidean image plane in case of two views and
/// known relative rotation angle", ECCV 2018. Published as `relpose_7p_fuv_angle`.
///
/// `fundamental` comes from seven points or more, in pixels or any other unit; `half_angle` holds
/// the cosine and the sine of half the angle. The principal point is (x, y), `z` the square of the
/// focal length. With the matrix K of these K^T F K is an essential matrix. F is a multiple of
/// `left`\[0\] `right`\[0\]^T + `left`\[1\] `right`\[1\]^T: with the products A of the left vectors
/// in the quadratic form K K^T, and B of the right ones, B A is a multiple of the identity. With
/// z = 0 all points of a conic are solutions; four combinations of the equations that are divisible
/// by z are stated divided.
namespace relpose_7pt_angle_focal_centre {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 6;

/// A solution of `relpose_7pt_angle_focal_centre`.
struct Solution {
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> fundamental, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_angle_focal_centre_solve(fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> fundamental, Values<2> half_angle) {
    return try_solve(fundamental, half_angle).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> fundamental, Values<2> half_angle) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_angle_focal_centre_solve_with(
            second_attempts.operations(), fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> fundamental, Values<2> half_angle) {
    return try_solve_with(second_attempts, fundamental, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many fundamental, Many half_angle, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_angle_focal_centre_solve_batch(
            instances, fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_7pt_angle_focal_centre` returns beside its unknowns.
struct Camera {
    double focal;
    std::array<double, 2> centre;
};
static_assert(sizeof(Camera) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each camera, or the code of an error.
[[nodiscard]] inline Result<Solutions<Camera, max_solutions>> try_solve_for_camera(Values<9> fundamental, Values<2> half_angle) noexcept {
    return Result<Solutions<Camera, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_angle_focal_centre_solve_for_camera(fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each camera. Throws `Error`.
[[nodiscard]] inline Solutions<Camera, max_solutions> solve_for_camera(Values<9> fundamental, Values<2> half_angle) {
    return try_solve_for_camera(fundamental, half_angle).value();
}

/// As `try_solve_for_camera`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Camera, max_solutions>> try_solve_with_for_camera(SecondAttempts second_attempts, Values<9> fundamental, Values<2> half_angle) noexcept {
    return Result<Solutions<Camera, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_angle_focal_centre_solve_with_for_camera(
            second_attempts.operations(), fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_camera`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Camera, max_solutions> solve_with_for_camera(SecondAttempts second_attempts, Values<9> fundamental, Values<2> half_angle) {
    return try_solve_with_for_camera(second_attempts, fundamental, half_angle).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_camera(
    std::size_t instances, Many fundamental, Many half_angle, Batch<Camera, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_angle_focal_centre_solve_batch_for_camera(
            instances, fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> fundamental, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_angle_focal_centre_relative_residual(
        fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> fundamental, Values<2> half_angle, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_angle_focal_centre_error_bound(
        fundamental.data(), fundamental.size(), half_angle.data(), half_angle.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_7pt_angle_focal_centre_second_attempt_operations();
}

} // namespace relpose_7pt_angle_focal_centre

/// Relative pose, focal length and radial distortion common to two cameras from seven point
/// correspondences: 68 solutions, of which those with a real focal length are returned.
///
/// Jiang, Kuang, Solem, Åström, "A minimal solution to relative pose with unknown focal length and
/// radial distortion", ACCV 2014. Published as `relpose_7p_fr`.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
/// An image x lies along (x, 1 + radial |x|^2), the division model. Then x1^T F x2 = 0 is, with f33
/// = 1, linear in f11, f21, f12, f22, radial f31, radial^2, f31 and the monomials f32, radial f32,
/// f13, radial f13, f23, radial f23, radial, 1: seven points give the former as combinations of
/// these. How well depends on which image is the first, and on how the second one is turned about
/// its centre: the best of eight choices is taken. The first image may be turned, too, which turns
/// (f13, f23), and `radial` may have any unit: they are such that in f31 radial f23 has the
/// coefficient 0 and radial f13 the coefficient 1. With the focal length, diag(focal, focal, 1) F
/// diag(focal, focal, 1) is an essential matrix; `w` is 1 / focal^2.
///
/// Everything is p + radial q, two polynomials without `radial`, modulo the equation that gives
/// radial^2, and most equations are stated times `radial`, too. There are points at infinity, near
/// which residuals are small; there the factors that are stated not to vanish are small beside
/// their terms.
namespace relpose_7pt_focal_radial {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 68;

/// A solution of `relpose_7pt_focal_radial`.
struct Solution {
    double w;
    double f_32;
    double f_13;
    double f_23;
    double radial;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<14> first, Values<14> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_focal_radial_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_7pt_focal_radial` returns beside its unknowns.
struct RadialFocalPose {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double focal;
    double radial;
};
static_assert(sizeof(RadialFocalPose) == 11 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_focal_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialFocalPose, max_solutions>> try_solve_for_radial_focal_pose(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<RadialFocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_solve_for_radial_focal_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_focal_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RadialFocalPose, max_solutions> solve_for_radial_focal_pose(Values<14> first, Values<14> second) {
    return try_solve_for_radial_focal_pose(first, second).value();
}

/// As `try_solve_for_radial_focal_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialFocalPose, max_solutions>> try_solve_with_for_radial_focal_pose(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<RadialFocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_solve_with_for_radial_focal_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_focal_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialFocalPose, max_solutions> solve_with_for_radial_focal_pose(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with_for_radial_focal_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_focal_pose(
    std::size_t instances, Many first, Many second, Batch<RadialFocalPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_focal_radial_solve_batch_for_radial_focal_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_focal_radial_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_focal_radial_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_7pt_focal_radial_second_attempt_operations();
}

} // namespace relpose_7pt_focal_radial

/// Relative pose, focal length and radial distortion of the first camera, the second calibrated,
/// from seven points: 19 solutions, of which those with a real focal length are returned.
///
/// Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
/// distortion", CVPR 2014. Published as `relpose_7p_fr_1s`;
/// `relpose_7pt_focal_radial_one_side_eliminated` is a formulation without the focal length.
///
/// `first[k]` is the distorted image of point k in the first camera, relative to the principal
/// point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
/// first image lies along (x1, 1 + radial |x1|^2), the division model. Then x1^T F x2 = 0 is linear
/// in the first two rows of F, radial f33 and the monomials radial f31, radial f32, f31, f32, f33:
/// seven points give the former as combinations of these. `third` is the third row of F, which is
/// given up to scale. It vanishes where the first camera moves along its optical axis: then the
/// points tell nothing of the distortion. With f33 = 1, as published, planar motions and those
/// without a rotation are lost. With the focal length, diag(focal, focal, 1) F is an essential
/// matrix; `w` is 1 / focal^2.
namespace relpose_7pt_focal_radial_one_side {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 19;

/// A solution of `relpose_7pt_focal_radial_one_side`.
struct Solution {
    double w;
    std::array<double, 3> third; ///< given up to scale: of length 1
    double radial;
};
static_assert(sizeof(Solution) == 5 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<14> first, Values<14> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_focal_radial_one_side_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_7pt_focal_radial_one_side` returns beside its unknowns.
struct RadialFocalPose {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double focal;
    double radial;
};
static_assert(sizeof(RadialFocalPose) == 11 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_focal_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialFocalPose, max_solutions>> try_solve_for_radial_focal_pose(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<RadialFocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_solve_for_radial_focal_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_focal_pose. Throws `Error`.
[[nodiscard]] inline Solutions<RadialFocalPose, max_solutions> solve_for_radial_focal_pose(Values<14> first, Values<14> second) {
    return try_solve_for_radial_focal_pose(first, second).value();
}

/// As `try_solve_for_radial_focal_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialFocalPose, max_solutions>> try_solve_with_for_radial_focal_pose(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<RadialFocalPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_solve_with_for_radial_focal_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_focal_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialFocalPose, max_solutions> solve_with_for_radial_focal_pose(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with_for_radial_focal_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_focal_pose(
    std::size_t instances, Many first, Many second, Batch<RadialFocalPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_focal_radial_one_side_solve_batch_for_radial_focal_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_focal_radial_one_side_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_focal_radial_one_side_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_7pt_focal_radial_one_side_second_attempt_operations();
}

} // namespace relpose_7pt_focal_radial_one_side

/// Relative pose and radial distortion of the first camera, whose focal length is unknown, too, and
/// eliminated, the second calibrated, from seven points: 19 solutions.
///
/// Kukelova, Kileel, Sturmfels, Pajdla, "A clever elimination strategy for efficient minimal
/// solvers", CVPR 2017. Published as `relpose_7p_fr_1s_elr`.
///
/// `first[k]` is the distorted image of point k in the first camera, relative to the principal
/// point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
/// first image lies along (x1, 1 + radial |x1|^2), the division model. Then x2^T F x1 = 0 is linear
/// in radial f33, the first two columns of F and the monomials radial f13, radial f23, f13, f23,
/// f33: seven points give the former as combinations of these. `third` is the third column of F,
/// which is given up to scale. It vanishes where the first camera moves along its optical axis:
/// then the points tell nothing of the distortion. With f33 = 1, as published, planar motions and
/// those without a rotation are lost. F diag(focal, focal, 1) is an essential matrix for some focal
/// length: with A the first two columns of F, the third is an eigenvector of A A^T, and where mu is
/// its eigenvalue, |third column|^2 / focal^2 = trace(A A^T) - 2 mu.
namespace relpose_7pt_focal_radial_one_side_eliminated {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 19;

/// A solution of `relpose_7pt_focal_radial_one_side_eliminated`.
struct Solution {
    std::array<double, 3> third; ///< given up to scale: of length 1
    double radial;
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<14> first, Values<14> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_7pt_focal_radial_one_side_eliminated` returns beside its unknowns.
struct RadialEpipolar {
    std::array<std::array<double, 3>, 3> fundamental; ///< given up to scale
    double radial;
};
static_assert(sizeof(RadialEpipolar) == 10 * sizeof(double), "a row");

/// Real solutions of one instance: each radial_epipolar, or the code of an error.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_for_radial_epipolar(Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_for_radial_epipolar(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each radial_epipolar. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_for_radial_epipolar(Values<14> first, Values<14> second) {
    return try_solve_for_radial_epipolar(first, second).value();
}

/// As `try_solve_for_radial_epipolar`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<RadialEpipolar, max_solutions>> try_solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<14> first, Values<14> second) noexcept {
    return Result<Solutions<RadialEpipolar, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_with_for_radial_epipolar(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_radial_epipolar`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<RadialEpipolar, max_solutions> solve_with_for_radial_epipolar(SecondAttempts second_attempts, Values<14> first, Values<14> second) {
    return try_solve_with_for_radial_epipolar(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_radial_epipolar(
    std::size_t instances, Many first, Many second, Batch<RadialEpipolar, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_focal_radial_one_side_eliminated_solve_batch_for_radial_epipolar(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_focal_radial_one_side_eliminated_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<14> first, Values<14> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_focal_radial_one_side_eliminated_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_7pt_focal_radial_one_side_eliminated_second_attempt_operations();
}

} // namespace relpose_7pt_focal_radial_one_side_eliminated

/// Relative pose and relative scale of two generalized cameras from seven point correspondences:
/// 140 solutions.
///
/// Kneip, Sweeney, Hartley, "The generalized relative pose and scale problem: View-graph fusion via
/// 2D-2D registration", WACV 2016. Published as `gen_relpose_scale`.
///
/// `first` and `second` hold the rays of the points in either system of cameras: a point of the
/// ray, and its direction. The rotation from the first system to the second is that of the
/// quaternion q, and points of the second system are multiplied by its scale.
/// That the rays of one point meet gives the translation up to the depths of that point along
/// either ray and the scale; that the rays of any four others meet, too, are linear equations for
/// these three. What is stated depends on these five points, not on which is the first.
///
/// For a point of the rays, rotation p1 + translation = scale p2, with p1 in the first system and
/// p2 in the second.
namespace relpose_7pt_generalized_scale {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 140;

/// A solution of `relpose_7pt_generalized_scale`.
struct Solution {
    std::array<double, 4> q; ///< given up to scale: of length 1
};
static_assert(sizeof(Solution) == 4 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<42> first, Values<42> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_generalized_scale_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<42> first, Values<42> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<42> first, Values<42> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_generalized_scale_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<42> first, Values<42> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_generalized_scale_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `relpose_7pt_generalized_scale` returns beside its unknowns.
struct ScaledPose {
    std::array<std::array<double, 3>, 3> rotation;
    std::array<double, 3> translation;
    double scale;
};
static_assert(sizeof(ScaledPose) == 13 * sizeof(double), "a row");

/// Real solutions of one instance: each scaled_pose, or the code of an error.
[[nodiscard]] inline Result<Solutions<ScaledPose, max_solutions>> try_solve_for_scaled_pose(Values<42> first, Values<42> second) noexcept {
    return Result<Solutions<ScaledPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_generalized_scale_solve_for_scaled_pose(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each scaled_pose. Throws `Error`.
[[nodiscard]] inline Solutions<ScaledPose, max_solutions> solve_for_scaled_pose(Values<42> first, Values<42> second) {
    return try_solve_for_scaled_pose(first, second).value();
}

/// As `try_solve_for_scaled_pose`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<ScaledPose, max_solutions>> try_solve_with_for_scaled_pose(SecondAttempts second_attempts, Values<42> first, Values<42> second) noexcept {
    return Result<Solutions<ScaledPose, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_relpose_7pt_generalized_scale_solve_with_for_scaled_pose(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_scaled_pose`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<ScaledPose, max_solutions> solve_with_for_scaled_pose(SecondAttempts second_attempts, Values<42> first, Values<42> second) {
    return try_solve_with_for_scaled_pose(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_scaled_pose(
    std::size_t instances, Many first, Many second, Batch<ScaledPose, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_relpose_7pt_generalized_scale_solve_batch_for_scaled_pose(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<42> first, Values<42> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_generalized_scale_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<42> first, Values<42> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_relpose_7pt_generalized_scale_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_relpose_7pt_generalized_scale_second_attempt_operations();
}

} // namespace relpose_7pt_generalized_scale

/// Rotation between two photographs with common unknown focal length and radial distortion, a
/// panorama, from three points: 18 solutions, of which those with a real focal length are returned.
///
/// Naroditsky, Daniilidis, "Optimizing polynomial solvers for minimal geometry problems", ICCV
/// 2011, after Byröd, Brown, Åström, "Minimal solutions for panoramic stitching with radial
/// distortion", BMVC 2009. Published as `stitching`.
///
/// `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
/// A point p lies along (p, focal (1 + radial |p|^2)), the division model. Two points with the
/// inner product xy of their rays, in the first image, and x'y' in the second, satisfy xy^2 x'x'
/// y'y' = x'y'^2 xx yy. With w = 1/focal^2 both sides divided by focal^8 are polynomials in w whose
/// difference has no term without w; it is divided by w.
namespace stitching_3pt_radial_focal {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 18;

/// A solution of `stitching_3pt_radial_focal`.
struct Solution {
    double radial;
    double w;
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<6> first, Values<6> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_stitching_3pt_radial_focal_solve(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<6> first, Values<6> second) {
    return try_solve(first, second).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<6> first, Values<6> second) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_stitching_3pt_radial_focal_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<6> first, Values<6> second) {
    return try_solve_with(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_stitching_3pt_radial_focal_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `stitching_3pt_radial_focal` returns beside its unknowns.
struct Panorama {
    double focal;
    double radial;
};
static_assert(sizeof(Panorama) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each panorama, or the code of an error.
[[nodiscard]] inline Result<Solutions<Panorama, max_solutions>> try_solve_for_panorama(Values<6> first, Values<6> second) noexcept {
    return Result<Solutions<Panorama, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_stitching_3pt_radial_focal_solve_for_panorama(first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each panorama. Throws `Error`.
[[nodiscard]] inline Solutions<Panorama, max_solutions> solve_for_panorama(Values<6> first, Values<6> second) {
    return try_solve_for_panorama(first, second).value();
}

/// As `try_solve_for_panorama`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Panorama, max_solutions>> try_solve_with_for_panorama(SecondAttempts second_attempts, Values<6> first, Values<6> second) noexcept {
    return Result<Solutions<Panorama, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_stitching_3pt_radial_focal_solve_with_for_panorama(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_panorama`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Panorama, max_solutions> solve_with_for_panorama(SecondAttempts second_attempts, Values<6> first, Values<6> second) {
    return try_solve_with_for_panorama(second_attempts, first, second).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_panorama(
    std::size_t instances, Many first, Many second, Batch<Panorama, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_stitching_3pt_radial_focal_solve_batch_for_panorama(
            instances, first.data(), first.size(), second.data(), second.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<6> first, Values<6> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_stitching_3pt_radial_focal_relative_residual(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<6> first, Values<6> second, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_stitching_3pt_radial_focal_error_bound(
        first.data(), first.size(), second.data(), second.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_stitching_3pt_radial_focal_second_attempt_operations();
}

} // namespace stitching_3pt_radial_focal

/// Eigenvectors of a 3 x 3 x 3 tensor, scaled to eigenvalue 1: x_i = sum over j and k of a_ijk x_j
/// x_k, 8 solutions with x = 0.
///
/// Cartwright and Sturmfels, "The number of eigenvalues of a tensor", Linear Algebra and its
/// Applications 2013: 7 of them for general data. The method of moments reads the parts of a
/// mixture from them (Anandkumar, Ge, Hsu, Kakade, Telgarsky, "Tensor decompositions for learning
/// latent variable models", JMLR 2014, section 4).
namespace tensor_eigenvectors {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `tensor_eigenvectors`.
struct Solution {
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<27> a) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_tensor_eigenvectors_solve(a.data(), a.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<27> a) {
    return try_solve(a).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<27> a) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_tensor_eigenvectors_solve_with(
            second_attempts.operations(), a.data(), a.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<27> a) {
    return try_solve_with(second_attempts, a).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many a, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_tensor_eigenvectors_solve_batch(
            instances, a.data(), a.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<27> a, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_tensor_eigenvectors_relative_residual(
        a.data(), a.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<27> a, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_tensor_eigenvectors_error_bound(
        a.data(), a.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_tensor_eigenvectors_second_attempt_operations();
}

} // namespace tensor_eigenvectors

/// The intersection of three general quadrics: 8 solutions by Bézout's theorem.
///
/// Kukelova, Heller, Fitzgibbon, "Efficient intersection of three quadrics and applications in
/// computer vision", CVPR 2016.
///
/// `quadrics` holds the coefficients of x^2, x y, x z, y^2, y z, z^2, x, y, z, 1, a quadric in each
/// row.
namespace three_quadrics {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 8;

/// A solution of `three_quadrics`.
struct Solution {
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<30> quadrics) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_three_quadrics_solve(quadrics.data(), quadrics.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<30> quadrics) {
    return try_solve(quadrics).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<30> quadrics) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_three_quadrics_solve_with(
            second_attempts.operations(), quadrics.data(), quadrics.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<30> quadrics) {
    return try_solve_with(second_attempts, quadrics).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many quadrics, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_three_quadrics_solve_batch(
            instances, quadrics.data(), quadrics.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<30> quadrics, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_three_quadrics_relative_residual(
        quadrics.data(), quadrics.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<30> quadrics, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_three_quadrics_error_bound(
        quadrics.data(), quadrics.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_three_quadrics_second_attempt_operations();
}

} // namespace three_quadrics

/// Triangulation from three views, all stationary points of the sum of squared reprojection errors:
/// 47 solutions.
///
/// Stewénius, Schaffalitzky, Nistér, "How hard is 3-view triangulation really?", ICCV 2005.
/// Published as `3v_triang_laurent`.
///
/// `cameras` are the projection matrices of the views and `images` where they see the point. The
/// unknowns are projective coordinates (x, y, z, 1) of the point: x and y its depths in the first
/// and second view over that in the third, each times a constant, and z its first error in the
/// third view. Every image is turned so that its second error does not depend on z, and scales are
/// such that in the errors of the first two views over their depths, x and y, z has the
/// coefficient 1. The planes of depth zero must meet in one point: the three images must not all be
/// parallel, as rectified ones are.
///
/// Stated are derivatives towards seven points. Where the depth of a view vanishes, so does a power
/// of it in the denominators; where the errors of a view vanish, too, at its centre, they do not
/// change at all.
namespace triangulation_3view {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 47;

/// A solution of `triangulation_3view`.
struct Solution {
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<36> cameras, Values<6> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_solve(cameras.data(), cameras.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<36> cameras, Values<6> images) {
    return try_solve(cameras, images).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<36> cameras, Values<6> images) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_solve_with(
            second_attempts.operations(), cameras.data(), cameras.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<36> cameras, Values<6> images) {
    return try_solve_with(second_attempts, cameras, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many cameras, Many images, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_triangulation_3view_solve_batch(
            instances, cameras.data(), cameras.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `triangulation_3view` returns beside its unknowns.
struct Point {
    std::array<double, 3> position;
};
static_assert(sizeof(Point) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each point, or the code of an error.
[[nodiscard]] inline Result<Solutions<Point, max_solutions>> try_solve_for_point(Values<36> cameras, Values<6> images) noexcept {
    return Result<Solutions<Point, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_solve_for_point(cameras.data(), cameras.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each point. Throws `Error`.
[[nodiscard]] inline Solutions<Point, max_solutions> solve_for_point(Values<36> cameras, Values<6> images) {
    return try_solve_for_point(cameras, images).value();
}

/// As `try_solve_for_point`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Point, max_solutions>> try_solve_with_for_point(SecondAttempts second_attempts, Values<36> cameras, Values<6> images) noexcept {
    return Result<Solutions<Point, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_solve_with_for_point(
            second_attempts.operations(), cameras.data(), cameras.size(), images.data(), images.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_point`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Point, max_solutions> solve_with_for_point(SecondAttempts second_attempts, Values<36> cameras, Values<6> images) {
    return try_solve_with_for_point(second_attempts, cameras, images).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_point(
    std::size_t instances, Many cameras, Many images, Batch<Point, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_triangulation_3view_solve_batch_for_point(
            instances, cameras.data(), cameras.size(), images.data(), images.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<36> cameras, Values<6> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_triangulation_3view_relative_residual(
        cameras.data(), cameras.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<36> cameras, Values<6> images, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_triangulation_3view_error_bound(
        cameras.data(), cameras.size(), images.data(), images.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_triangulation_3view_second_attempt_operations();
}

} // namespace triangulation_3view

/// Triangulation from three views with two of the three epipolar constraints, all stationary points
/// of the least-squares cost: 27 solutions.
///
/// Kukelova, Pajdla, Bujnak, "Fast and stable algebraic solution to L2 three-view triangulation",
/// 3DV 2013. Published as `l2_3view_triang`, for matrices of full rank, which give 31 solutions.
/// Fundamental and essential matrices have rank 2, and with them four of the 31 are at infinity.
///
/// `image` holds the measured image points, one a row. The corrected ones (x1, x2), (x3, x4) and
/// (x5, x6) are the closest to these that satisfy p1^T `first` p2 = 0 and p2^T `second` p3 = 0,
/// with the multipliers x7 and x8. The cost is the sum of the squared distances.
namespace triangulation_3view_relaxed {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 27;

/// A solution of `triangulation_3view_relaxed`.
struct Solution {
    double x1;
    double x2;
    double x3;
    double x4;
    double x5;
    double x6;
    double x7;
    double x8;
};
static_assert(sizeof(Solution) == 8 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> first, Values<9> second, Values<6> image) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_relaxed_solve(first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> first, Values<9> second, Values<6> image) {
    return try_solve(first, second, image).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<6> image) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_relaxed_solve_with(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<6> image) {
    return try_solve_with(second_attempts, first, second, image).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many first, Many second, Many image, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_triangulation_3view_relaxed_solve_batch(
            instances, first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// What `triangulation_3view_relaxed` returns beside its unknowns.
struct Corrected {
    std::array<std::array<double, 2>, 3> images;
    double cost;
};
static_assert(sizeof(Corrected) == 7 * sizeof(double), "a row");

/// Real solutions of one instance: each corrected, or the code of an error.
[[nodiscard]] inline Result<Solutions<Corrected, max_solutions>> try_solve_for_corrected(Values<9> first, Values<9> second, Values<6> image) noexcept {
    return Result<Solutions<Corrected, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_relaxed_solve_for_corrected(first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each corrected. Throws `Error`.
[[nodiscard]] inline Solutions<Corrected, max_solutions> solve_for_corrected(Values<9> first, Values<9> second, Values<6> image) {
    return try_solve_for_corrected(first, second, image).value();
}

/// As `try_solve_for_corrected`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Corrected, max_solutions>> try_solve_with_for_corrected(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<6> image) noexcept {
    return Result<Solutions<Corrected, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_triangulation_3view_relaxed_solve_with_for_corrected(
            second_attempts.operations(), first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve_for_corrected`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Corrected, max_solutions> solve_with_for_corrected(SecondAttempts second_attempts, Values<9> first, Values<9> second, Values<6> image) {
    return try_solve_with_for_corrected(second_attempts, first, second, image).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch_for_corrected(
    std::size_t instances, Many first, Many second, Many image, Batch<Corrected, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_triangulation_3view_relaxed_solve_batch_for_corrected(
            instances, first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> first, Values<9> second, Values<6> image, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_triangulation_3view_relaxed_relative_residual(
        first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> first, Values<9> second, Values<6> image, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_triangulation_3view_relaxed_error_bound(
        first.data(), first.size(), second.data(), second.size(), image.data(), image.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_triangulation_3view_relaxed_second_attempt_operations();
}

} // namespace triangulation_3view_relaxed

/// A point at given distances from three known points: 2 solutions, mirror images in the plane of
/// the three.
///
/// Thomas & Ros, "Revisiting trilateration for robot localization", IEEE Transactions on Robotics
/// 21(1), 2005.
///
/// `centres` holds the known points, one a row; `distances` the distances from them, in the same
/// unit.
namespace trilateration {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 2;

/// A solution of `trilateration`.
struct Solution {
    double x;
    double y;
    double z;
};
static_assert(sizeof(Solution) == 3 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<9> centres, Values<3> distances) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_trilateration_solve(centres.data(), centres.size(), distances.data(), distances.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<9> centres, Values<3> distances) {
    return try_solve(centres, distances).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<9> centres, Values<3> distances) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_trilateration_solve_with(
            second_attempts.operations(), centres.data(), centres.size(), distances.data(), distances.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<9> centres, Values<3> distances) {
    return try_solve_with(second_attempts, centres, distances).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many centres, Many distances, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_trilateration_solve_batch(
            instances, centres.data(), centres.size(), distances.data(), distances.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<9> centres, Values<3> distances, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_trilateration_relative_residual(
        centres.data(), centres.size(), distances.data(), distances.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<9> centres, Values<3> distances, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_trilateration_error_bound(
        centres.data(), centres.size(), distances.data(), distances.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_trilateration_second_attempt_operations();
}

} // namespace trilateration

/// The intersection of two general conics: 4 solutions by Bézout's theorem.
///
/// Kukelova, Bujnak, Pajdla, "Automatic Generator of Minimal Problem Solvers", ECCV 2008, use two
/// such quadrics as their running example.
///
/// `p` and `q` hold the coefficients of x^2, x y, y^2, x, y, 1.
namespace two_conics {

/// No call returns more solutions.
inline constexpr std::size_t max_solutions = 4;

/// A solution of `two_conics`.
struct Solution {
    double x;
    double y;
};
static_assert(sizeof(Solution) == 2 * sizeof(double), "a row");

/// Real solutions of one instance: each solution, or the code of an error.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve(Values<6> p, Values<6> q) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_two_conics_solve(p.data(), p.size(), q.data(), q.size(), to_solutions, max_solutions, to_count);
    });
}

/// Real solutions of one instance: each solution. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve(Values<6> p, Values<6> q) {
    return try_solve(p, q).value();
}

/// As `try_solve`, with a bound on second attempts.
[[nodiscard]] inline Result<Solutions<Solution, max_solutions>> try_solve_with(SecondAttempts second_attempts, Values<6> p, Values<6> q) noexcept {
    return Result<Solutions<Solution, max_solutions>>::of([&](double *to_solutions, std::size_t *to_count) {
        return eliminant_two_conics_solve_with(
            second_attempts.operations(), p.data(), p.size(), q.data(), q.size(), to_solutions, max_solutions, to_count);
    });
}

/// As `solve`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline Solutions<Solution, max_solutions> solve_with(SecondAttempts second_attempts, Values<6> p, Values<6> q) {
    return try_solve_with(second_attempts, p, q).value();
}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch(
    std::size_t instances, Many p, Many q, Batch<Solution, max_solutions> &batch) {
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {
        return eliminant_two_conics_solve_batch(
            instances, p.data(), p.size(), q.data(), q.size(), to_solutions, solutions_length, counts, codes);
    });
}

/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a
/// solution. Throws `Error`.
[[nodiscard]] inline double relative_residual(Values<6> p, Values<6> q, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_two_conics_relative_residual(
        p.data(), p.size(), q.data(), q.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is
/// known to be near. Throws `Error`.
[[nodiscard]] inline double error_bound(Values<6> p, Values<6> q, const Solution &solution) {
    double number = 0.0;
    const std::int32_t code = eliminant_two_conics_error_bound(
        p.data(), p.size(), q.data(), q.size(), reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != ELIMINANT_OK) throw Error(code);
    return number;
}

/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {
    return eliminant_two_conics_second_attempt_operations();
}

} // namespace two_conics

} // namespace eliminant

#endif
