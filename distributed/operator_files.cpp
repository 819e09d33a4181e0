// SPDX-License-Identifier: MIT
#include "distributed/operator_files.h"

#include "backends/linear/petsc_session.h"
#include "base/errors.h"
#include "dec/stars/star.h"
#include "distributed/petsc_calls.h"
#include "distributed/shared_folder.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <petscviewer.h>

namespace polydec {

namespace {

constexpr std::string_view extension = ".petsc";

bool is_operator_file(std::string_view name) {
    return name.size() > extension.size() &&
           name.substr(name.size() - extension.size()) == extension;
}

/// Takes what is given by rows to the order of cell numbers: each rank has an equal stretch.
OwnedMat in_order_of_numbers(const Ranks& ranks, const DistributedCells::Degree& cells) {
    struct Told {
        GlobalIndex number, row;
    };
    const EqualStretches stretches(cells.count, ranks.size());
    auto parcels = ranks.empty_parcels<Told>();
    for (std::size_t i = 0; i < cells.number.size(); ++i)
        parcels[stretches.rank_of(cells.number[i])].push_back(
            {cells.number[i], cells.first_row + static_cast<GlobalIndex>(i)});
    const GlobalIndex begin = stretches.begin(ranks.rank()),
                      count = stretches.end(ranks.rank()) - begin;
    std::vector<PetscInt> begins(static_cast<std::size_t>(count) + 1),
        columns(static_cast<std::size_t>(count));
    for (const auto& parcel : ranks.deliver(std::move(parcels)))
        for (const auto& [number, row] : parcel)
            columns[number - begin] = static_cast<PetscInt>(row);
    std::iota(begins.begin(), begins.end(), 0);
    const std::vector<double> ones(columns.size(), 1);
    return made("ordering rows", [&](Mat* matrix) {
        return MatCreateMPIAIJWithArrays(
            communicator(ranks), static_cast<PetscInt>(count),
            static_cast<PetscInt>(cells.number.size()), static_cast<PetscInt>(cells.count),
            static_cast<PetscInt>(cells.count), begins.data(), columns.data(), ones.data(), matrix);
    });
}

class OperatorWriter {
public:
    OperatorWriter(const Ranks& ranks, const DistributedMesh& mesh, std::filesystem::path folder)
        : ranks_(ranks), mesh_(mesh), folder_(std::move(folder)) {
        for (int k = 0; k <= mesh.dimension(); ++k)
            orders_.push_back(in_order_of_numbers(ranks, mesh.cells.degree(k)));
    }

    std::vector<std::string> write_all() {
        const int n = mesh_.dimension();
        const CellVolumes& volumes = mesh_.cells.volumes;
        for (int k = 0; k <= n; ++k) {
            if (k < n)
                write(fmt::format("d_{}", k), coboundary(ranks_, mesh_.cells, k), k + 1, k);
            write(fmt::format("star_{}", k), HodgeStar(volumes, k).diagonal(), k, n - 2 * k);
            write(fmt::format("volume_{}", k), volumes.primal(k), k, k);
            write(fmt::format("dual_volume_{}", k), volumes.dual(k), k, n - k);
            write_laplacians(k);
        }
        return std::move(left_out_);
    }

private:
    /// A file is opened, filled and closed by all ranks together. Where one cannot write, others
    /// may wait for it within PETSc for ever; then it throws alone, and the program has to end.
    template <class View>
    void view(const std::string& name, View view) const {
        const petsc::Session session("files of PETSc");
        const auto path = folder_ / (name + std::string(extension));
        PetscViewer viewer = nullptr;
        auto error =
            PetscViewerBinaryOpen(communicator(ranks_), path.c_str(), FILE_MODE_WRITE, &viewer);
        if (!error)
            error = PetscViewerBinarySetSkipInfo(viewer, PETSC_TRUE);
        if (!error)
            error = view(viewer);
        if (const auto closed = PetscViewerDestroy(&viewer); !error)
            error = closed;
        const auto check = [&] {
            if (error)
                throw IoError(fmt::format("cannot write {}: PETSc error {}", path.string(),
                                          static_cast<int>(error)),
                              {.path = path});
        };
        constexpr double patience = 5; // seconds
        if (!ranks_.all_come(error ? patience : std::numeric_limits<double>::infinity()))
            check();
        ranks_.together("write", check);
    }

    void write(const std::string& name, OwnedMat matrix, int row_degree, int column_degree) const {
        OwnedMat rows = multiplied(orders_[row_degree].get(), matrix.get());
        const OwnedMat back = made("ordering columns", [&](Mat* transposed) {
            return MatTranspose(orders_[column_degree].get(), MAT_INITIAL_MATRIX, transposed);
        });
        const OwnedMat ordered = multiplied(rows.get(), back.get());
        view(name, [&](PetscViewer viewer) { return MatView(ordered.get(), viewer); });
    }

    void write(const std::string& name, const Vector& own, int degree, int power) const {
        const Vector scaled =
            ranks_.together("units", [&] { return in_input_units(own, mesh_.unit, power, name); });
        const Vector ordered = product(ranks_, orders_[degree].get(), scaled);
        const OwnedVec vector = vector_of(ranks_, ordered);
        view(name, [&](PetscViewer viewer) { return VecView(vector.get(), viewer); });
    }

    void write_laplacians(int k) {
        const int j = mesh_.dimension() - k;
        const double scale = std::ldexp(1.0, -2 * std::ilogb(mesh_.unit));
        const auto in_units = [&](OwnedMat matrix) {
            require(MatScale(matrix.get(), scale), "scaling");
            return matrix;
        };
        const auto primal = fmt::format("laplacian_primal_{}", k),
                   dual = fmt::format("laplacian_dual_{}", j);
        try {
            OwnedMat of_primal = in_units(laplacian(ranks_, mesh_.cells, Side::primal, k));
            OwnedMat of_dual = in_units(laplacian(ranks_, mesh_.cells, Side::dual, j));
            write(primal, std::move(of_primal), k, k);
            write(dual, std::move(of_dual), k, k);
        } catch (const InvalidInput& error) { // of all ranks
            left_out_.push_back(fmt::format("{0}{2} and {1}{2} are not written: {3}", primal, dual,
                                            extension, error.what()));
        }
    }

    const Ranks& ranks_;
    const DistributedMesh& mesh_;
    std::filesystem::path folder_;
    std::vector<OwnedMat> orders_; // by degree
    std::vector<std::string> left_out_;
};

} // namespace

std::vector<std::string> write_operators(const Ranks& ranks, const DistributedMesh& mesh,
                                         const std::filesystem::path& folder) {
    SharedFolder shared(ranks, folder, is_operator_file);
    auto left_out = OperatorWriter(ranks, mesh, shared.path()).write_all();
    shared.commit();
    return left_out;
}

} // namespace polydec
