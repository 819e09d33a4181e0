// SPDX-License-Identifier: MIT
#include "backends/tetgen_files.h"
#include "tests/fuzz/targets.h"

#include <fmt/format.h>

#include <filesystem>
#include <sys/mman.h>
#include <unistd.h>

namespace polydec::fuzz {

namespace {

/// A file in memory that has a path.
class MemoryFile {
public:
    MemoryFile() : number_(::memfd_create("mesh", MFD_CLOEXEC)) {
        require(number_ >= 0, "there is memory for a file");
    }
    ~MemoryFile() { ::close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path holding(std::string_view bytes) const {
        const auto size = static_cast<ssize_t>(bytes.size());
        require(::ftruncate(number_, 0) == 0 &&
                    ::pwrite(number_, bytes.data(), bytes.size(), 0) == size,
                "there is memory for the bytes of a file");
        return fmt::format("/proc/self/fd/{}", number_);
    }

private:
    int number_;
};

} // namespace

/// What TetGen may have written: points, cells or, on its output, facets that cross; of 9 each.
void mesher_files(std::string_view bytes) {
    static const MemoryFile file;
    constexpr Index most = 9;
    const auto path = file.holding(bytes);
    accepts<SolverFailure>(
        [&] { require(builtin::read_tetgen_points(path).allFinite(), "coordinates are finite"); });
    accepts<SolverFailure>([&] {
        const auto cells = builtin::read_tetgen_cells(path, most);
        require(cells.size() == 0 || (cells.minCoeff() >= 0 && cells.maxCoeff() < most),
                "vertex numbers are in range");
    });
    for (const auto& [a, b] : builtin::crossing_facets(std::string(bytes), most))
        require(0 <= a && a < b && b < most, "facets are in range");
}

} // namespace polydec::fuzz
