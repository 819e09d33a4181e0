// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"

#include "dec/forms/laplacian.h"
#include "dec/metric/geometry.h"

namespace polydec::benchmarks {

namespace {

const LazyMesh* in_memory = nullptr;

} // namespace

Chain chain(const Mesh& mesh) {
    SimplicialComplex complex(mesh.simplices);
    HodgeStars stars = circumcentric_volumes(complex, mesh.points);
    SparseMatrix laplacian = symmetric_laplacian({complex, stars}, 0);
    return {std::move(complex), std::move(stars), std::move(laplacian)};
}

const Mesh& LazyMesh::get() const {
    if (in_memory && in_memory != this)
        in_memory->drop();
    in_memory = this;
    if (!mesh_)
        mesh_ = std::make_unique<const Mesh>(make_());
    return *mesh_;
}

Amount LazyMesh::amount() const {
    return {static_cast<double>(get().simplices.rows()), bytes(get())};
}

SharedMesh shared_mesh(std::function<Mesh()> make) {
    return std::make_shared<const LazyMesh>(std::move(make));
}

} // namespace polydec::benchmarks
