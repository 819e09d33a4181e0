// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// Everything a function may ask for, of one mesh.
struct Sample {
    std::string name;
    Discretization mesh;

    Sample(std::string title, const Mesh& input, const DiscretizeOptions& options = {})
        : name(std::move(title)), mesh(discretize(input, options)) {}
    Sample(std::string title, Discretization made)
        : name(std::move(title)), mesh(std::move(made)) {}

    int n() const { return mesh.dimension(); }
    Index size(int k) const { return mesh.complex().size(k); }
    const SimplicialComplex& K() const { return mesh.input(); }
    const CellComplex& P() const { return mesh.complex(); }
    const CellVolumes& V() const { return mesh.volumes(); }
    Cells cells() const { return {P(), V()}; } ///< of no mesh
    const CellVolumes& W() const { return mesh.input_geometry().volumes(); }
    const Pieces& pieces() const { return mesh.pieces(); }
    const Geometry& geometry() const { return mesh.geometry(); }
    bool has_points() const { return mesh.points().cols() > 0; }
};

/// Merged meshes of dimension 1 to 4; then one of each kind: simplices as they are, with vertices
/// that no cell uses, of which lengths alone are known, with tags, with centroids, flipped, flipped
/// and split.
const std::vector<Sample>& samples();

/// The one of a name.
const Sample& sample(const std::string& name);

/// What comes of a call: `refused` with InvalidInput, `accepted`, or another error.
std::string outcome(const std::function<void()>& call);

/// What goes into one call. One of the inputs, counted in the order in which they are asked for,
/// may be of another size than is asked for, a degree that does not exist, or a form with a value
/// that is no number.
class Inputs {
public:
    enum class Flaw { none, fewer, more, wider, not_finite };

    Inputs() = default;
    Inputs(int which, Flaw flaw) : which_(which), flaw_(flaw) {}

    /// Whether there was such an input, and one that can have the flaw.
    bool asked() const { return asked_ > which_; }
    bool flawed() const { return flawed_; }

    /// Values that follow no pattern; a flawed one lacks a row, or has one or a column too many.
    Vector vector(Eigen::Index size) { return matrix(size, 1); }
    DenseMatrix matrix(Eigen::Index rows, Eigen::Index columns);
    /// Points may have any number of coordinates: where they are flawed, there are too few or many.
    Points points(Eigen::Index rows, Eigen::Index coordinates) {
        return Inputs().matrix(matrix(rows, 1).size(), coordinates);
    }
    SparseMatrix operator_matrix(Eigen::Index rows, Eigen::Index columns) {
        return matrix(rows, columns).sparseView();
    }
    /// Two inputs: the degree, without values where it is flawed, and the values.
    Cochain form(const Sample& s, Side side, int degree);
    Cochain form_on(const CellComplex& complex, Side side, int degree);
    Chain chain(const Sample& s, Side side, int degree);
    /// One of the degrees from `least` to `beyond` more than the dimension, k; a flawed one is just
    /// outside of these, or farther: how far, differs from sample to sample and degree to degree.
    int degree(const Sample& s, int k, int least = 0, int beyond = 0) {
        return degree_of(s.n(), k, least, beyond);
    }
    template <class Item>
    std::vector<Item> list(Eigen::Index size, Item item) {
        return std::vector<Item>(static_cast<std::size_t>(matrix(size, 1).size()), item);
    }

private:
    Flaw next(bool may_be_not_finite = false);
    int degree_of(int n, int k, int least = 0, int beyond = 0);

    int which_ = -1, asked_ = 0;
    Flaw flaw_ = Flaw::none;
    bool flawed_ = false;
};

/// What is wrong with an answer: "" where it is of the shape that it is to have and finite.
std::string fit(const DenseMatrix& found, Eigen::Index rows, Eigen::Index columns = 1);
std::string fit(const SparseMatrix& found, Eigen::Index rows, Eigen::Index columns);
std::string fit(const Cochain& found, const CellComplex& complex, Side side, int degree);
std::string fit(double found);
std::string fit(bool right);

/// A call of a public function: what is wrong with what it gives.
using Question = std::function<std::string(Inputs& in)>;

/// Asks with right inputs, to which the answer must be right or InvalidInput, or right where
/// `is_answered`; then with one input after the other flawed, which must be refused. What was not
/// so, in words.
std::vector<std::string> complaints(const Question& question, bool is_answered = false);

/// Asks one question after the other, and expects no complaint of any.
struct Asking {
    std::string where;
    bool all_answered = false;

    void operator()(const char* name, const Question& question) const;
};

} // namespace polydec::test
