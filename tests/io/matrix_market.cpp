// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <rapidcheck.h>

namespace polydec::test::in_matrix_market {

const std::string banner = "%%MatrixMarket matrix coordinate real general\n";

SparseMatrix matrix_from(const std::string& text) {
    const TemporaryFolder folder;
    return read_matrix_market(folder.write("a.mtx", text));
}

DenseMatrix dense(const SparseMatrix& matrix) {
    return DenseMatrix(matrix);
}

double any_double() {
    const double mantissa = *rc::gen::inRange<std::int64_t>(-(1LL << 53), 1LL << 53);
    return std::ldexp(mantissa, *rc::gen::inRange(-1100, 960));
}

TEST(MatrixMarket, SparseMatricesAreTheSame) {
    EXPECT_TRUE(rc::check([] {
        SparseMatrix matrix(*rc::gen::inRange(0, 8), *rc::gen::inRange(0, 8));
        for (Index row = 0; row < matrix.rows(); ++row) {
            for (Index column = 0; column < matrix.cols(); ++column)
                if (*rc::gen::inRange(0, 3) == 0)
                    matrix.insert(row, column) = any_double();
        }
        const TemporaryFolder folder;
        write_matrix_market(folder.path("a.mtx"), matrix);
        const auto read = read_matrix_market(folder.path("a.mtx"));
        RC_ASSERT(read.nonZeros() == matrix.nonZeros());
        RC_ASSERT(read.rows() == matrix.rows() && read.cols() == matrix.cols());
        RC_ASSERT(dense(read) == dense(matrix));
    }));
}

TEST(MatrixMarket, VectorsAreTheSame) {
    EXPECT_TRUE(rc::check([] {
        const Vector vector =
            Vector::NullaryExpr(*rc::gen::inRange(0, 20), [] { return any_double(); });
        const TemporaryFolder folder;
        write_matrix_market(folder.path("a.mtx"), vector);
        RC_ASSERT(read_matrix_market_array(folder.path("a.mtx")) == vector);
    }));
}

TEST(MatrixMarket, IncidencesAreIntegers) {
    IncidenceMatrix matrix(2, 3);
    matrix.insert(0, 2) = 1;
    matrix.insert(1, 0) = -1;
    matrix.insert(1, 1) = 0;
    const TemporaryFolder folder;
    write_matrix_market(folder.path("a.mtx"), matrix);
    EXPECT_EQ(read_text(folder.path("a.mtx")),
              "%%MatrixMarket matrix coordinate integer general\n2 3 3\n1 3 1\n2 1 -1\n2 2 0\n");
    EXPECT_EQ(dense(read_matrix_market(folder.path("a.mtx"))),
              (DenseMatrix(2, 3) << 0, 0, 1, -1, 0, 0).finished());
}

TEST(MatrixMarket, VectorsAreArraysOfOneColumn) {
    const TemporaryFolder folder;
    write_matrix_market(folder.path("a.mtx"), Vector(Eigen::Vector2d(0.1, -2e300)));
    EXPECT_EQ(read_text(folder.path("a.mtx")),
              "%%MatrixMarket matrix array real general\n2 1\n0.1\n-2e+300\n");
}

TEST(MatrixMarket, ArraysGoDownTheirColumnsAndNoRowsTakeNoTime) {
    const auto array = [](const std::string& sizes_and_entries) {
        const TemporaryFolder folder;
        return read_matrix_market_array(folder.write(
            "a.mtx", "%%MatrixMarket matrix array real general\n" + sizes_and_entries));
    };
    EXPECT_EQ(array("2 3\n1 2\n3 4\n5 6\n"), (DenseMatrix(2, 3) << 1, 3, 5, 2, 4, 6).finished());
    EXPECT_EQ(array("0 2000000000\n").cols(), 2000000000);
}

TEST(MatrixMarket, SymmetricFilesGiveBothTriangles) {
    const std::string body = "% comment\n\n2 2 2\n1 1 5\n2 1 3\n";
    EXPECT_EQ(dense(matrix_from("%%MatrixMarket matrix coordinate real symmetric\n" + body)),
              (DenseMatrix(2, 2) << 5, 3, 3, 0).finished());
    EXPECT_EQ(dense(matrix_from("%%MatrixMarket matrix coordinate integer skew-symmetric\n2 2 1\n"
                                "2 1 3\n")),
              (DenseMatrix(2, 2) << 0, -3, 3, 0).finished());
}

TEST(MatrixMarket, RefusesWhatDoesNotFit) {
    EXPECT_REFUSED(matrix_from("%%MatrixMarket matrix coordinate complex general\n1 1 0\n"),
                   "a.mtx:1", "complex", "real", "integer", "double");
    EXPECT_REFUSED(matrix_from("%%MatrixMarket matrix array real general\n1 1\n5\n"), "a.mtx:1",
                   "array", "coordinate");
    EXPECT_REFUSED(matrix_from(banner + "2 2 1\n1 3 5\n"), "a.mtx:3", "column 3", "range", "1",
                   "2");
    EXPECT_REFUSED(matrix_from(banner + "2 2 1\n0 1 5\n"), "a.mtx:3", "row 0", "range", "1", "2");
    EXPECT_REFUSED(matrix_from(banner + "2 2 2\n1 1 5\n1 1 6\n"), "a.mtx:5", "entry", "row 1",
                   "column 1", "twice");
    EXPECT_REFUSED(matrix_from(banner + "2 2 1\n1 1 nan\n"), "a.mtx:3", "entry", "NaN");
    EXPECT_REFUSED(matrix_from(banner + "2 2 1\n1 1 5\n2 2 5\n"), "a.mtx:4", "more entries");
    EXPECT_REFUSED(matrix_from(banner + "2 2 2000000000\n1 1 5\n"), "a.mtx:2", "2000000000 entries",
                   "7 bytes", "6 bytes");
    EXPECT_REFUSED(matrix_from(banner + "2000000000 2 1\n1 1 5\n"), "a.mtx:3", "2000000000 rows",
                   "6 bytes");
    EXPECT_REFUSED(matrix_from(banner + "3000000000 2 1\n1 1 5\n"), "a.mtx:2", "rows", "3000000000",
                   "2^31 - 1");
}

TEST(MatrixMarket, RefusesToWriteWhatIsNotFinite) {
    const TemporaryFolder folder;
    const auto path = folder.path("a.mtx");
    SparseMatrix matrix(2, 3);
    matrix.insert(1, 2) = std::nan("");
    EXPECT_REFUSED(write_matrix_market(path, matrix), path.string(), "entry (1, 2)", "NaN");
    const Vector vector = Vector::Constant(1, std::numeric_limits<double>::infinity());
    EXPECT_REFUSED(write_matrix_market(path, vector), path.string(), "entry (0, 0)", "NaN");
    EXPECT_TRUE(folder.names().empty());
}

} // namespace polydec::test::in_matrix_market
