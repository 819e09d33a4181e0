// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/bytes.h"
#include "benchmarks/measure.h"
#include "dec/stars/star.h"

#include <functional>
#include <memory>
#include <vector>

namespace polydec::benchmarks {

/// From points and top simplices to all operators.
struct Chain {
    SimplicialComplex complex; ///< with d_0 .. d_(n-1)
    HodgeStars stars;          ///< star_0 .. star_n: handles on the volumes
    SparseMatrix laplacian;    ///< of 0-forms, symmetric
};

Chain chain(const Mesh& mesh);

inline double bytes(const Chain& chain) {
    return bytes(chain.complex) + bytes(chain.stars.volumes()) + bytes(chain.laplacian);
}

/// A mesh that is made when it is first asked for.
class LazyMesh {
public:
    explicit LazyMesh(std::function<Mesh()> make) : make_(std::move(make)) {}

    const Mesh& get() const;
    Amount amount() const; ///< its cells, and the bytes of points and cells
    void drop() const { mesh_.reset(); }

private:
    std::function<Mesh()> make_;
    mutable std::unique_ptr<const Mesh> mesh_;
};

using SharedMesh = std::shared_ptr<const LazyMesh>;

/// A mesh for several rows, kept until another one is asked for, so that only one is in memory.
SharedMesh shared_mesh(std::function<Mesh()> make);

} // namespace polydec::benchmarks
