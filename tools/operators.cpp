// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/forms/laplacian.h"
#include "io/matrices/matrix_market.h"
#include "meshes/unit_of_length.h"
#include "system/atomic_file.h"
#include "system/atomic_folder.h"
#include "system/memory.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/manifest.h"
#include "tools/outputs.h"
#include "tools/written.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace polydec::tools {

namespace {

struct OperatorsArguments {
    MeshArguments mesh;
    std::filesystem::path out;
};

template <class VerticesOf>
void write_vertex_lists(const std::filesystem::path& path, Index cells, VerticesOf vertices) {
    AtomicFile file(path);
    for (Index i = 0; i < cells; ++i)
        file.write(fmt::format("{}\n", fmt::join(vertices(i), " ")));
    file.commit();
}

/// From K to P, and back; after flips these are the products of all flips and the merging.
struct Maps {
    std::vector<SparseMatrix> diamonds, lifts;
};

Maps maps(const Discretization& mesh) {
    Maps result;
    const auto& lift = mesh.merged().lift();
    for (int k = 0; k <= mesh.dimension(); ++k) {
        const SparseMatrix pieces = mesh.merging().diamond(k).cast<double>();
        if (mesh.passage().is_identity()) {
            result.diamonds.push_back(pieces);
            result.lifts.push_back(lift[k]);
        } else {
            result.diamonds.emplace_back(pieces * mesh.passage().matrix(k));
            result.lifts.emplace_back(mesh.passage().matrix_back(k) * lift[k]);
        }
    }
    return result;
}

class Writer {
public:
    Writer(const Discretization& mesh, std::filesystem::path folder, Log& log)
        : mesh_(mesh),
          P_(mesh.complex()),
          K_(mesh.input()),
          folder_(std::move(folder)),
          log_(log) {}

    void write_all() {
        check_laplacians();
        const auto [diamonds, lifts] = maps(mesh_);
        for (int k = 0; k <= mesh_.dimension(); ++k) {
            if (k < mesh_.dimension())
                write_matrix_market(file("d", k), P_.coboundary(k));
            const int n = mesh_.dimension();
            write_star(k);
            write_scaled("volume", k, mesh_.volumes().primal(k), k);
            write_scaled("dual_volume", k, mesh_.volumes().dual(k), n - k);
            write_matrix_market(file("diamond", k), diamonds[k]);
            write_matrix_market(file("lift", k), lifts[k]);
            write_laplacians(k);
            write_cells(k);
        }
    }

private:
    std::filesystem::path file(const char* name, int k, const char* extension = "mtx") const {
        return folder_ / fmt::format("{}_{}.{}", name, k, extension);
    }

    /// Of a diagonal the values.
    void write_star(int k) const {
        const int power = mesh_.dimension() - 2 * k;
        const HodgeStar star = mesh_.stars()[k];
        if (star.is_diagonal())
            write_scaled("star", k, star.diagonal(), power);
        else
            write_scaled(file("star", k), star.matrix(), power);
    }

    /// Values that are a length to some power, in the units of the file.
    void write_scaled(const char* name, int k, const Vector& values, int power) const {
        const auto path = file(name, k);
        write_matrix_market(path,
                            in_input_units(values, mesh_.unit(), power, path.filename().string()));
    }
    void write_scaled(const std::filesystem::path& path, SparseMatrix matrix, int power) const {
        matrix.makeCompressed();
        matrix.coeffs() =
            in_input_units(matrix.coeffs().matrix(), mesh_.unit(), power, path.filename().string())
                .array();
        write_matrix_market(path, matrix);
    }

    /// All cells around one become neighbors, so what many cells share costs its square.
    void check_laplacians() const {
        constexpr double bytes_each = 2 * (sizeof(double) + sizeof(Index));
        for (int k = 0; k <= mesh_.dimension(); ++k) {
            double entries = 0;
            if (k > 0)
                for (Index s = 0; s < P_.size(k - 1); ++s)
                    entries += std::pow(P_.coface_counts(k - 1)[s], 2);
            for (Index t = 0; t < P_.size(k + 1); ++t) {
                double faces = 0;
                for ([[maybe_unused]] const SignedFace& face : P_.incidences(k)[t])
                    ++faces;
                entries += faces * faces;
            }
            check_memory(bytes_each * entries,
                         fmt::format("Laplacians of {}-cells with {:.3g} entries", k, entries));
        }
    }

    /// A Laplacian that would divide by zero, or invert a matrix, is left out.
    void write_laplacians(int k) const {
        const int j = mesh_.dimension() - k;
        const auto primal = file("laplacian_primal", k), dual = file("laplacian_dual", j);
        try {
            write_scaled(primal, laplacian({P_, mesh_.stars()}, k), -2);
            write_scaled(dual, dual_laplacian({P_, mesh_.stars()}, j), -2);
        } catch (const InvalidInput& error) {
            log_.warn(fmt::format("{} and {} are not written: {}", primal.filename().string(),
                                  dual.filename().string(), error.what()));
            std::filesystem::remove(primal);
            std::filesystem::remove(dual);
        }
    }

    void write_cells(int k) const {
        write_vertex_lists(file("simplices", k, "txt"), K_.size(k),
                           [&](Index s) { return K_.vertex_numbers(k, s); });
        write_vertex_lists(file("cells", k, "txt"), P_.size(k),
                           [&](Index cell) { return cell_vertices(mesh_, k, cell); });
    }

    const Discretization& mesh_;
    const CellComplex& P_;
    const SimplicialComplex& K_;
    std::filesystem::path folder_;
    Log& log_;
};

/// What the manifest of an earlier result lists is ours.
AtomicFolder::IsOurs earlier_result(const std::filesystem::path& folder) {
    return [names = files_of_result(folder)](std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
}

void run_operators(const OperatorsArguments& arguments) {
    Log log;
    const auto is_ours = earlier_result(arguments.out);
    check_replaced_folder(arguments.out);
    check_replaceable(arguments.out, is_ours);
    const auto files = fingerprints(arguments.mesh.mesh);
    const Discretization mesh = load(arguments.mesh, log);
    check_unchanged(arguments.mesh.mesh, files);
    log.timing.begin("write");
    AtomicFolder folder(arguments.out, is_ours);
    Writer(mesh, folder.path(), log).write_all();
    write_manifest(folder.path(),
                   {"operators", files, arguments.mesh, mesh.dimension(), log.warnings});
    folder.commit();
    tell(operators(arguments.out.string(), mesh.dimension()), log, arguments.mesh.tell);
}

} // namespace

void add_operators(CLI::App& app) {
    const auto [command, arguments] = add_command<OperatorsArguments>(
        app, "operators", "writes all operators and maps to files", run_operators);
    add_mesh_arguments(*command, arguments->mesh, StarKind::circumcentric);
    command
        ->add_option("--out", arguments->out,
                     "FOLDER\tfolder for the files, created or replaced as a whole")
        ->required();
    command->footer(
        "Files (P merged, K input complex): d_k star_k volume_k dual_volume_k diamond_k (P x K) "
        "lift_k (K x P) laplacian_primal_k laplacian_dual_j in Matrix Market format; "
        "simplices_k.txt (K) and cells_k.txt (P) with the vertices of each cell; manifest.json "
        "with "
        "the input and options.\n\n"
        "Example:\n"
        "  polydec operators grid.nsc --out operators");
}

} // namespace polydec::tools
