// @name@.hpp: the solvers of @name@.h for C++17.
//
// Written by eliminant-capi-generator @version@. Do not edit.
//
// Each problem is a namespace:
//
//     using namespace @name@;
//     const auto found = NAME::solve(data, ..);          // throws @name@::Error
//     const auto result = NAME::try_solve(data, ..);     // result.code(), result.text()
//     for (const NAME::Solution &solution : found)
//         use(solution, NAME::error_bound(data, .., solution));
//     const auto quick = NAME::solve_with(SecondAttempts::never(), data, ..);
//
// Data are numbers, or arrays row by row: `double[5][3]`, nested `std::array`, `std::vector` of
// such, a `Span` of numbers, and with Eigen matrices of fixed size that are stored by rows, vectors,
// and arrays of such. Solutions are structs of numbers and nested `std::array`, stored in place.
// Nothing is allocated but by `Batch`. With @NAME@_NO_EIGEN defined, Eigen is left alone.
#ifndef @NAME@_HPP
#define @NAME@_HPP

#include "@name@.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#if !defined(@NAME@_NO_EIGEN) && __has_include(<Eigen/Core>)
#define @NAME@_HAS_EIGEN 1
#include <Eigen/Core>
#endif

namespace @name@ {

/// What went wrong, as an exception.
class Error : public std::runtime_error {
public:
    explicit Error(std::int32_t code) : std::runtime_error(@name@_error_text(code)), code_(code) {}
    /// One of the codes of @name@.h.
    std::int32_t code() const noexcept { return code_; }

private:
    std::int32_t code_;
};

/// When a solve that misses solutions is repeated at twice the precision, which takes some twenty
/// times as long.
class SecondAttempts {
public:
    /// Wherever solutions are missing, as `solve` does. Only so are they followed from data nearby.
    static constexpr SecondAttempts always() noexcept { return SecondAttempts(@NAME@_ALWAYS); }
    /// Never: solutions that only a second attempt finds are missing, and an elimination that fails
    /// is an error.
    static constexpr SecondAttempts never() noexcept { return SecondAttempts(@NAME@_NEVER); }
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
#ifdef @NAME@_HAS_EIGEN
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
    explicit operator bool() const noexcept { return code_ == @NAME@_OK; }
    std::int32_t code() const noexcept { return code_; }
    const char *text() const noexcept { return @name@_error_text(code_); }
    /// The value; an empty list if something went wrong.
    const T &operator*() const noexcept { return value_; }
    const T *operator->() const noexcept { return &value_; }
    /// The value; throws if something went wrong.
    const T &value() const {
        if (code_ != @NAME@_OK) throw Error(code_);
        return value_;
    }

private:
    T value_;
    std::int32_t code_ = @NAME@_OK;
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
        codes_.assign(instances, @NAME@_OK);
        const std::size_t length = rows_.size() * (sizeof(S) / sizeof(double));
        const std::int32_t code =
            call(reinterpret_cast<double *>(rows_.data()), length, counts_.data(), codes_.data());
        if (code != @NAME@_OK) throw Error(code);
    }

private:
    std::vector<S> rows_;
    std::vector<std::size_t> counts_;
    std::vector<std::int32_t> codes_;
};

#ifdef @NAME@_HAS_EIGEN
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

@problems@
} // namespace @name@

#endif
