// SPDX-License-Identifier: MIT
#include "io/meshes/pdm.h"

#include "base/checks.h"
#include "io/byte_order.h"
#include "io/meshes/mesh_files.h"
#include "io/meshes/readers.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <zlib.h>

namespace polydec {

namespace {

constexpr std::string_view magic = "pdmesh1\n";
constexpr std::size_t header_words = 7; // behind the magic; a checksum follows

template <typename Number>
Number little(const std::string& bytes, std::size_t place) {
    return number_at<Number>(bytes.data() + place, std::endian::little);
}

/// A file of so many bytes would have offsets that are no 64-bit numbers.
constexpr std::int64_t most_cells = std::int64_t{1} << 40, most_coordinates = 1 << 16;

} // namespace

std::string header_of(const PdmLayout& layout) {
    const std::array<std::int64_t, header_words> words{
        layout.ambient_dimension, layout.dimension, layout.vertices,       layout.cells,
        layout.number_bytes(),    layout.has_tags,  PdmLayout::block_bytes};
    std::string header(magic);
    header += bytes_of_all<std::int64_t>(words);
    header += checksum_of(header);
    header.resize(PdmLayout::header_bytes, '\0');
    return header;
}

std::string checksum_of(std::string_view block) {
    const auto sum = static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const Bytef*>(block.data()), static_cast<uInt>(block.size())));
    return bytes_of(sum);
}

std::string pdm_bytes(const Eigen::Ref<const Points>& points) {
    return bytes_of_all<double>({points.data(), static_cast<std::size_t>(points.size())});
}

std::string pdm_bytes(const std::vector<Index>& tags) {
    return bytes_of_all<Index>(tags);
}

std::string pdm_bytes(const std::vector<std::int64_t>& vertices, std::int64_t bytes_each) {
    if (bytes_each == sizeof(std::int64_t))
        return bytes_of_all<std::int64_t>(vertices);
    return pdm_bytes(std::vector<Index>(vertices.begin(), vertices.end()));
}

PdmReader::PdmReader(PartialFile file) : file_(std::move(file)) {
    const std::string header = file_.read(0, std::min(file_.size, PdmLayout::header_bytes));
    if (!header.starts_with(magic))
        fail("the file is not a .pdm file of version 1; write the mesh again");
    if (std::ssize(header) < PdmLayout::header_bytes)
        fail("the file ends within its header; write it again");
    const std::size_t words_end = magic.size() + header_words * sizeof(std::int64_t);
    if (header.compare(words_end, PdmLayout::sum_bytes,
                       checksum_of(std::string_view(header).substr(0, words_end))) != 0)
        fail("the header is damaged: its checksum does not match; write the file again");
    std::array<std::int64_t, header_words> words{};
    for (std::size_t i = 0; i < header_words; ++i)
        words[i] = little<std::int64_t>(header, magic.size() + i * sizeof(std::int64_t));
    layout_ = {words[0], words[1], words[2], words[3], words[5] != 0};
    const auto& [N, n, vertices, cells, has_tags] = layout_;
    if (n < 1 || n > N || N > most_coordinates)
        fail(fmt::format("cells of dimension {} in {} coordinates; expected 1 <= n <= N", n, N));
    if (vertices < 1 || cells < 1 || vertices > most_cells || cells > most_cells)
        fail(fmt::format("{} vertices and {} cells; expected at least one of each", vertices,
                         cells));
    if (words[4] != layout_.number_bytes() || words[6] != PdmLayout::block_bytes)
        fail("the widths of its numbers do not belong to this version; write the mesh again");
    if (file_.size != layout_.file_bytes())
        fail(fmt::format("the file has {} bytes, but {} vertices and {} cells need {}: it was cut "
                         "off or extended; write it again",
                         file_.size, vertices, cells, layout_.file_bytes()));
}

void PdmReader::fail(const std::string& text) const {
    refuse_contents(file_.name, text);
}

/// Blocks are read as a whole, because sums are of these.
std::string PdmReader::checked(std::int64_t begin, std::int64_t end) const {
    if (begin == end)
        return {};
    const auto block_of = [](std::int64_t place) {
        return (place - PdmLayout::header_bytes) / PdmLayout::block_bytes;
    };
    const std::int64_t first = block_of(begin), last = block_of(end - 1) + 1;
    std::string bytes = file_.read(layout_.block_begin(first), layout_.block_begin(last));
    const std::string sums = file_.read(layout_.sums_begin() + first * PdmLayout::sum_bytes,
                                        layout_.sums_begin() + last * PdmLayout::sum_bytes);
    for (std::int64_t block = first; block < last; ++block) {
        const std::string_view one = std::string_view(bytes).substr(
            (block - first) * PdmLayout::block_bytes,
            layout_.block_begin(block + 1) - layout_.block_begin(block));
        if (sums.compare((block - first) * PdmLayout::sum_bytes, PdmLayout::sum_bytes,
                         checksum_of(one)) != 0)
            fail(fmt::format("the bytes {} to {} are damaged: their checksum does not match; write "
                             "the file again",
                             layout_.block_begin(block), layout_.block_begin(block + 1) - 1));
    }
    bytes.resize(end - layout_.block_begin(first));
    bytes.erase(0, begin - layout_.block_begin(first));
    return bytes;
}

Points PdmReader::points(std::int64_t begin, std::int64_t end) const {
    const std::int64_t first = PdmLayout::header_bytes, each = layout_.point_bytes();
    const std::string bytes = checked(first + begin * each, first + end * each);
    Points result(end - begin, layout_.ambient_dimension);
    for (Eigen::Index i = 0; i < result.size(); ++i) {
        result.data()[i] = little<double>(bytes, static_cast<std::size_t>(i) * sizeof(double));
        if (!std::isfinite(result.data()[i]))
            fail(fmt::format("vertex {} has a coordinate that is not finite",
                             begin + i / layout_.ambient_dimension));
    }
    return result;
}

std::vector<std::int64_t> PdmReader::cells(std::int64_t begin, std::int64_t end) const {
    const std::int64_t first = layout_.cells_begin(), each = layout_.cell_bytes();
    const std::string bytes = checked(first + begin * each, first + end * each);
    const std::int64_t corners = layout_.dimension + 1;
    const bool is_wide = layout_.number_bytes() == sizeof(std::int64_t);
    std::vector<std::int64_t> result((end - begin) * corners);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = is_wide ? little<std::int64_t>(bytes, i * sizeof(std::int64_t))
                            : little<std::int32_t>(bytes, i * sizeof(std::int32_t));
        if (result[i] < 0 || result[i] >= layout_.vertices)
            fail(fmt::format("cell {} has vertex {}; {}",
                             begin + static_cast<std::int64_t>(i) / corners, result[i],
                             expected_numbers(0, layout_.vertices - 1)));
    }
    return result;
}

std::vector<Index> PdmReader::tags(std::int64_t begin, std::int64_t end) const {
    if (!layout_.has_tags)
        return {};
    const std::int64_t first = layout_.tags_begin();
    const std::string bytes = checked(first + begin * 4, first + end * 4);
    std::vector<Index> result(end - begin);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = little<std::int32_t>(bytes, i * sizeof(std::int32_t));
    return result;
}

Mesh read_pdm(const SourceFile& file) {
    const PdmReader reader(
        {file.name, std::ssize(file.text), [&](std::int64_t begin, std::int64_t end) {
             return file.text.substr(begin, end - begin);
         }});
    const PdmLayout& layout = reader.layout();
    checked_count(static_cast<std::size_t>(std::max(layout.vertices, layout.cells)),
                  "vertices or cells", file);
    Mesh mesh;
    mesh.points = reader.points(0, layout.vertices);
    const auto corners = reader.cells(0, layout.cells);
    mesh.simplices.resize(layout.cells, layout.dimension + 1);
    std::copy(corners.begin(), corners.end(), mesh.simplices.data());
    mesh.tags = reader.tags(0, layout.cells);
    return mesh;
}

void write_pdm(const std::filesystem::path& path, const Mesh& mesh) {
    const PdmLayout layout{mesh.ambient_dimension(), mesh.dimension(), mesh.points.rows(),
                           mesh.simplices.rows(), !mesh.tags.empty()};
    const std::vector<std::int64_t> corners(mesh.simplices.data(),
                                            mesh.simplices.data() + mesh.simplices.size());
    std::string data = pdm_bytes(mesh.points);
    data += pdm_bytes(corners, layout.number_bytes());
    data += pdm_bytes(mesh.tags);
    AtomicFile file(path);
    file.write(header_of(layout));
    file.write(data);
    for (std::int64_t block = 0; block < layout.blocks(); ++block)
        file.write(checksum_of(
            std::string_view(data).substr(block * PdmLayout::block_bytes, PdmLayout::block_bytes)));
    file.commit();
}

} // namespace polydec
