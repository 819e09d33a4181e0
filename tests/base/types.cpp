// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/exponent.h"
#include "tests/support/test.h"

#include <complex>

namespace polydec::test::in_types {

double sum(const Vector& values) {
    return values.sum();
}

template <class Argument>
constexpr bool is_taken = std::is_invocable_v<decltype(sum), Argument>;

// what by its type has several columns does not compile, in whatever way a Vector is made of it
static_assert(!is_taken<Eigen::Matrix3d> && !is_taken<Eigen::MatrixX3d>);
static_assert(!std::is_constructible_v<Vector, Eigen::MatrixX3d>);
static_assert(!std::is_assignable_v<Vector&, Eigen::MatrixX3d>);
static_assert(!is_taken<double> && !is_taken<int>);
// and a Vector takes what is one
static_assert(is_taken<Vector> && is_taken<Eigen::VectorXd> && is_taken<Eigen::Vector3d>);
static_assert(is_taken<Eigen::RowVectorXd> && is_taken<DenseMatrix> && is_taken<Points>);
static_assert(std::is_nothrow_move_constructible_v<Vector>);
static_assert(std::is_constructible_v<Column<std::complex<double>>, Eigen::VectorXcd>);
static_assert(!std::is_constructible_v<Column<std::complex<double>>, Eigen::Matrix2cd>);
// the twin: Eigen's own takes any dense matrix
static_assert(std::is_convertible_v<DenseMatrix, Eigen::VectorXd>);

std::string message(Eigen::Index rows, Eigen::Index columns) {
    return std::to_string(rows) + " x " + std::to_string(columns);
}

TEST(Vector, takes_no_matrix_of_other_than_one_column) {
    for (const Eigen::Index rows : {0, 1, 3})
        for (const Eigen::Index columns : {0, 1, 2, 3}) {
            const DenseMatrix matrix = DenseMatrix::Ones(rows, columns);
            const Points row_by_row = matrix;
            Vector assigned;
            const std::function<void()> ways[] = {
                [&] { sum(matrix); },          [&] { sum(2 * matrix); },
                [&] { sum(row_by_row); },      [&] { sum(matrix.topRows(rows)); },
                [&] { Vector made(matrix); },  [&] { assigned = matrix; },
                [&] { assigned = 2 * matrix; }};
            for (const auto& way : ways)
                if (columns == 1)
                    EXPECT_EQ(refusal(way), "accepted");
                else
                    EXPECT_SAYS(refusal(way), "vector", message(rows, columns));
        }
}

TEST(Vector, is_what_it_is_made_of) {
    const Vector expected{{1, 2, 3}};
    ASSERT_EQ(expected.size(), 3);
    const Eigen::VectorXd plain = expected;
    const DenseMatrix column = expected;
    const Eigen::RowVectorXd row = expected.transpose();
    Points table(2, 3);
    table << 1, 2, 3, 4, 5, 6;
    for (const Vector& made :
         {Vector(plain), Vector(Eigen::VectorXd(plain)), Vector(column), Vector(row),
          Vector(table.row(0)), Vector(Eigen::Vector3d(1, 2, 3)), Vector(2 * expected - expected),
          Vector(Eigen::Map<const Vector>(expected.data(), 3)),
          Vector(Eigen::Ref<const Vector>(expected)), Vector(expected.array() * 1)})
        EXPECT_EQ(made, expected);
    const Vector upright{{1}, {2}, {3}};
    EXPECT_EQ(upright, expected);
    EXPECT_EQ((Vector{{7}}), Vector::Constant(1, 7));
    EXPECT_EQ((Vector{{}}).size(), 0);
    EXPECT_EQ(refusal([] { Vector{{1, 2}, {3, 4}}; }), refusal([] { sum(DenseMatrix(2, 2)); }));
    EXPECT_EQ(sum({}), 0);
    EXPECT_EQ(sum(expected.head(2)), 3);
}

TEST(Vector, is_moved_out_of_eigens_without_a_copy) {
    Eigen::VectorXd plain = Eigen::VectorXd::Ones(5);
    const double* const place = plain.data();
    Vector made(std::move(plain));
    EXPECT_EQ(made.data(), place);
    Vector assigned;
    assigned = std::move(made);
    EXPECT_EQ(assigned.data(), place);
}

TEST(ScaledNumber, out_of_range_is_an_error_of_its_own) {
    EXPECT_EQ(ScaledNumber({0.5, 3}).in_range("a square"), 4);
    EXPECT_THROW(ScaledNumber({1, 5000}).in_range("a square"), OutOfRange);
    EXPECT_THROW(ScaledNumber({1, -5000}).in_range("a square"), OutOfRange);
    EXPECT_THROW(in_input_units(Vector{{1}}, 0x1p1000, 2, "areas"), OutOfRange);
}

TEST(checks, say_what_is_asked_for_and_what_there_is) {
    EXPECT_NO_THROW(check_number("degree", 0, 0, 3));
    EXPECT_NO_THROW(check_number("degree", 3, 0, 3));
    EXPECT_REFUSED(check_number("degree", 4, 0, 3), "degree 4", "0", "3");
    EXPECT_REFUSED(check_number("degree", -1, 0, 3), "degree -1", "0", "3");
    EXPECT_REFUSED(check_number("2-cell", 0, 0, -1), "2-cell 0", "none");
    EXPECT_EQ(expected_numbers(1, 1), "expected 1 to 1");
    EXPECT_EQ(expected_numbers(1, 0), "there are none");
    EXPECT_NO_THROW(check_as_many("labels", 3, 3));
    EXPECT_REFUSED(check_as_many("labels", 3, 4), "3 labels", "4");
}

} // namespace polydec::test::in_types
