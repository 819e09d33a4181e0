// SPDX-License-Identifier: MIT
#include "io/matrices/parse_matrix_market.h"
#include "io/meshes/readers.h"
#include "system/memory.h"
#include "tests/fuzz/targets.h"

#include <algorithm>
#include <cstdint>

namespace polydec::fuzz {

namespace {

/// Finite, with every vertex number in range, and with a tag for every cell or none.
void require_usable(const Mesh& mesh) {
    require(mesh.points.allFinite(), "coordinates are finite");
    require(mesh.tags.empty() ||
                static_cast<Eigen::Index>(mesh.tags.size()) == mesh.simplices.rows(),
            "every cell has a tag, or none has");
    require(mesh.simplices.size() == 0 ||
                (mesh.simplices.minCoeff() >= 0 && mesh.simplices.maxCoeff() < mesh.points.rows()),
            "vertex numbers are in range");
    for (const auto& warning : mesh.warnings)
        require_message(warning);
}

/// Less memory for the time of a run: a few bytes can promise large grids and compressed arrays.
class LittleMemory {
public:
    LittleMemory() { set_memory_limit(std::uint64_t{1} << 22U); }
    ~LittleMemory() { set_memory_limit(before_); }
    LittleMemory(const LittleMemory&) = delete;
    LittleMemory& operator=(const LittleMemory&) = delete;

private:
    std::uint64_t before_ = memory_limit();
};

} // namespace

void read_file(const char* name, std::string_view bytes) {
    const LittleMemory little;
    const SourceFile file{name, std::string(bytes)};
    Mesh mesh;
    bool is_mesh = false;
    accepts<IoError>([&] { is_mesh = accepts([&] { mesh = parse_mesh(file); }); });
    if (is_mesh) {
        require_usable(mesh);
        require(mesh.simplices.rows() > 0, "a mesh has cells");
    }
}

/// Two files with a line of --- between them, the second one an .ele or, after ---f, a .face.
void tetgen(std::string_view bytes) {
    constexpr std::string_view cut = "---";
    const auto place = std::min(bytes.find(cut), bytes.size());
    auto rest = bytes.substr(std::min(place + cut.size(), bytes.size()));
    const bool is_face = rest.substr(0, 1) == "f";
    rest.remove_prefix(is_face ? 1 : 0);
    const SourceFile nodes{"a.node", std::string(bytes.substr(0, place))};
    const SourceFile cells{is_face ? "a.face" : "a.ele", std::string(rest)};
    Mesh mesh;
    if (accepts([&] { mesh = parse_tetgen(nodes, {cells}); }))
        require_usable(mesh);
}

void nsl(std::string_view bytes) {
    const SourceFile file{"a.nsl", std::string(bytes)};
    LengthMesh mesh;
    if (!accepts([&] { mesh = parse_lengths(file); }))
        return;
    require(accepts([&] { check(mesh); }), "what was read passes the check");
    require(mesh.lengths.allFinite() && (mesh.lengths.array() > 0).all(), "lengths are positive");
}

void matrix_market(std::string_view bytes) {
    const SourceFile file{"a.mtx", std::string(bytes)};
    SparseMatrix sparse;
    if (accepts([&] { sparse = parse_matrix_market(file); })) {
        require(sparse.coeffs().allFinite(), "entries are finite");
        const Eigen::Map<const Eigen::Array<Index, Eigen::Dynamic, 1>> columns(
            sparse.innerIndexPtr(), sparse.nonZeros());
        require((columns >= 0).all() && (columns < sparse.cols()).all(), "columns are in range");
    }
    DenseMatrix dense;
    if (accepts([&] { dense = parse_matrix_market_array(file); }))
        require(dense.reshaped().allFinite(), "entries are finite");
}

} // namespace polydec::fuzz
