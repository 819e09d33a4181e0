// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "io/meshes/gmsh_blocks.h"
#include "io/meshes/gmsh_groups.h"
#include "io/meshes/mesh_layout.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace polydec {

namespace {

using Stretch = RecordTable::Stretch;

constexpr std::int64_t integer_bytes = 4, real_bytes = 8;

/// Hops from section to section and from block to block, and reads what stands in front of each.
class GmshHopper {
public:
    explicit GmshHopper(const PartialFile& file) : file_(file) {}

    std::optional<MeshLayout> layout() {
        while (place_ < file_.size && read_section())
            if (format_ && !format_->order)
                return std::nullopt;
        if (!has_elements_)
            refuse_layout(file_, "there is no section $Elements");
        take_cells();
        layout_.has_tags = has_groups_[layout_.dimension()];
        if (const auto more = second_groups_[layout_.dimension()]; more > 0)
            layout_.warnings.push_back(second_groups_warning(more));
        layout_.order = *format_->order;
        return std::move(layout_);
    }

private:
    /// Reads of a window that begins at this place, and goes behind what was read.
    template <class Work>
    auto read(std::int64_t bytes, Work work) {
        const std::string text = file_.read(place_, std::min(file_.size, place_ + bytes));
        Scanner scanner(file_.name, text);
        scanner.set_bytes_behind(static_cast<std::size_t>(file_.size - place_) - text.size());
        auto result = work(scanner);
        place_ += std::ssize(text) - static_cast<std::int64_t>(scanner.remaining());
        return result;
    }

    template <class Work>
    auto read_numbers(Work work) {
        constexpr std::int64_t front_of_block = 256;
        return read(front_of_block, [&](Scanner& scanner) {
            GmshSource source(scanner, *format_);
            return work(source);
        });
    }

    std::string read_word(std::string_view expected) {
        constexpr std::int64_t longest_word = 256;
        return read(longest_word, [&](Scanner& scanner) {
            return scanner.at_end() ? std::string() : std::string(scanner.word(expected));
        });
    }

    /// False behind the last one.
    bool read_section() {
        const std::string keyword = read_word("a section");
        if (keyword.empty())
            return false;
        if (!is_gmsh_keyword(keyword))
            refuse_layout(file_, "a word is outside the sections");
        const std::string name = keyword.substr(1);
        if (name == "MeshFormat" && !format_)
            format_ =
                read(longest_header, [](Scanner& scanner) { return read_gmsh_format(scanner); });
        else if (!format_)
            refuse_layout(file_, "$MeshFormat is not the first section");
        else if (!format_->order)
            return true;
        else if (name == "Entities" || name == "PartitionedEntities")
            read_entities(name);
        else if (name == "PhysicalNames")
            read_section_of_any_length(
                [&](Scanner& scanner) { read_gmsh_names(scanner, *format_); });
        else if (name == "Nodes" && layout_.points.count() == 0)
            read_nodes();
        else if (name == "Elements" && layout_.points.count() > 0 && !has_elements_)
            read_elements();
        else
            skip_section(name);
        if (read_word("the end of a section") != "$End" + name)
            refuse_layout(file_, "a section does not have the announced length");
        return true;
    }

    /// In version 4, bytes begin behind the line of the keyword.
    void open_section() {
        if (format_->major_version < 4)
            return;
        read(integer_bytes, [](Scanner& scanner) {
            scanner.end_line("the keyword of a section");
            return 0;
        });
    }

    /// Of a section that shows how long it is when it is read: of ever more of the file.
    template <class Work>
    void read_section_of_any_length(Work work) {
        constexpr std::int64_t most = std::int64_t{1} << 28;
        for (std::int64_t bytes = longest_header;; bytes *= 4)
            try {
                read(bytes, [&](Scanner& scanner) {
                    work(scanner);
                    return 0;
                });
                return;
            } catch (const InvalidInput&) {
                if (bytes >= most || place_ + bytes >= file_.size)
                    throw;
            }
    }

    void read_entities(const std::string& name) {
        if (format_->major_version != 4)
            refuse_layout(file_, "a section of another version");
        open_section();
        read_section_of_any_length([&](Scanner& scanner) {
            GmshGroups groups;
            GmshSource source(scanner, *format_);
            groups.read(source, name == "PartitionedEntities");
            groups_ = std::move(groups);
        });
    }

    void skip_section(const std::string& name) {
        if (name == "NOD" || name == "ELM" || name == "ParametricNodes" || name == "MeshFormat" ||
            name == "Nodes" || name == "Elements")
            refuse_layout(file_, "a section at the wrong place");
        const std::string mark = "$End" + name;
        constexpr std::int64_t bytes = 4 << 20;
        while (true) {
            const std::string text = file_.read(place_, std::min(file_.size, place_ + bytes));
            const std::size_t found = end_of_gmsh_section(text, mark);
            if (found != std::string::npos) {
                place_ += static_cast<std::int64_t>(found);
                return;
            }
            if (place_ + std::ssize(text) >= file_.size)
                refuse_layout(file_, "a section has no end");
            place_ += std::ssize(text) - std::ssize(mark) - 1; // it may stand across two windows
        }
    }

    void hop(std::int64_t bytes) {
        place_ += bytes;
        if (place_ > file_.size)
            refuse_layout(file_, "the file ends within a block");
    }

    void add_nodes(const Stretch& numbers, const Stretch& points) {
        layout_.nodes->stretches.push_back(numbers);
        layout_.points.stretches.push_back(points);
    }

    NumberType number_type() const {
        return format_->number_bytes() == sizeof(std::int64_t) ? NumberType::int64
                                                               : NumberType::int32;
    }

    void read_nodes() {
        open_section();
        layout_.points = table_of(NumberType::float64, 3);
        layout_.nodes = table_of(number_type(), 1);
        const auto section = read_numbers(read_gmsh_nodes);
        const auto width = static_cast<std::int64_t>(format_->number_bytes());
        Index before = 0;
        for (std::int64_t b = 0; b < section.blocks; ++b) {
            const auto block = read_numbers([&](GmshSource& source) {
                return read_gmsh_node_block(source, before, section.records);
            });
            const std::int64_t point = (3 + block.parameters) * real_bytes;
            if (format_->numbers_first())
                add_nodes({block.count, place_, width},
                          {block.count, place_ + block.count * width, point});
            else
                add_nodes({block.count, place_, width + point},
                          {block.count, place_ + width, width + point});
            hop(block.count * (width + point));
            before += block.count;
        }
        if (before < section.records)
            refuse_layout(file_, "there are fewer nodes than announced");
    }

    void read_elements() {
        has_elements_ = true;
        format_->major_version == 4 ? read_new_elements() : read_old_elements();
    }

    void add_cells(const GmshKind& kind, NumberType type, const Stretch& stretch) {
        if (kind.nodes > kind.corners)
            refuse_layout(file_, "there are cells of second or higher order");
        auto& table = cells_[kind.dimension][kind.corners];
        if (table.fields.empty())
            table = table_of(type, kind.corners);
        table.stretches.push_back(stretch);
    }

    void read_new_elements() {
        open_section();
        const auto section = read_numbers(read_gmsh_elements);
        const auto width = static_cast<std::int64_t>(format_->number_bytes());
        Index before = 0;
        for (std::int64_t b = 0; b < section.blocks; ++b) {
            const auto block = read_numbers([&](GmshSource& source) {
                return read_gmsh_element_block(source, section.records - before);
            });
            const std::int64_t stride = width * (1 + block.kind.nodes);
            add_cells(block.kind, number_type(), {block.count, place_ + width, stride});
            hop(block.count * stride);
            before += block.count;
            const auto tags = groups_.tags_of(block.entity_dimension, block.entity);
            has_groups_[block.kind.dimension] |= tags[0] != 0;
            second_groups_[block.kind.dimension] +=
                (tags.size() - 1) * static_cast<std::size_t>(block.count);
        }
        if (before < section.records)
            refuse_layout(file_, "there are fewer elements than announced");
    }

    void read_old_elements() {
        const Index elements = read_numbers(read_gmsh_elements).records;
        for (Index before = 0; before < elements;) {
            const std::int64_t front = place_;
            const auto block = read_numbers([&](GmshSource& source) {
                return read_old_gmsh_element_block(source, elements - before);
            });
            has_groups_[block.kind.dimension] |= block.tags > 0;
            before += block.count == 1 ? add_single_cells(block, front, elements - before)
                                       : add_block(block);
        }
    }

    static std::int64_t stride_of(const OldGmshElementBlock& block) {
        return integer_bytes * (1 + block.tags + block.kind.nodes);
    }

    Index add_block(const OldGmshElementBlock& block) {
        const std::int64_t stride = stride_of(block);
        add_cells(block.kind, NumberType::int32,
                  {block.count, place_ + (1 + block.tags) * integer_bytes, stride});
        hop(block.count * stride);
        return block.count;
    }

    /// Gmsh writes blocks of one element. How many of one kind follow each other is found by
    /// halving, with the first numbers of a few; that all others are like these is expected.
    Index add_single_cells(const OldGmshElementBlock& block, std::int64_t front, Index left) {
        constexpr std::int64_t front_bytes = 3 * integer_bytes;
        const std::int64_t stride = front_bytes + stride_of(block);
        const std::string pattern = file_.read(front, front + front_bytes);
        const auto is_like = [&](std::int64_t i) {
            const std::int64_t place = front + i * stride;
            return i < left && place + stride <= file_.size &&
                   file_.read(place, place + front_bytes) == pattern;
        };
        std::int64_t like = 0, unlike = 1;
        while (is_like(unlike)) {
            like = unlike;
            unlike *= 2;
        }
        while (unlike - like > 1) {
            const std::int64_t middle = like + (unlike - like) / 2;
            (is_like(middle) ? like : unlike) = middle;
        }
        const std::int64_t count = like + 1;
        add_cells(block.kind, NumberType::int32,
                  {count, front + front_bytes + (1 + block.tags) * integer_bytes, stride});
        constexpr double one = 1;
        const std::array numbers{static_cast<double>(block.kind.type), one,
                                 static_cast<double>(block.tags)};
        for (std::size_t i = 0; i < numbers.size(); ++i)
            layout_.expected.push_back(
                {{{{static_cast<std::int64_t>(i) * integer_bytes, NumberType::int32}},
                  {{count, front, stride}}},
                 numbers[i],
                 0});
        place_ = front;
        hop(count * stride);
        return static_cast<Index>(count);
    }

    /// Those of the largest dimension make the mesh.
    void take_cells() {
        for (int n = CellLists::most_dimensions - 1; n >= 0; --n)
            for (auto& [corners, table] : cells_[n]) {
                if (table.count() == 0)
                    continue;
                const bool are_simplices = corners == n + 1;
                if (layout_.cells.fields.empty() && n > 0 && are_simplices)
                    layout_.cells = std::move(table);
                else
                    layout_.others.push_back(std::move(table));
                if (layout_.cells.fields.empty() ||
                    (n == layout_.dimension() && layout_.others.size() > 0))
                    refuse_layout(file_, "there are cells other than simplices");
            }
    }

    const PartialFile& file_;
    std::int64_t place_ = 0;
    std::optional<GmshFormat> format_;
    bool has_elements_ = false;
    GmshGroups groups_;
    MeshLayout layout_;

    /// By dimension and number of corners.
    std::array<std::map<int, RecordTable>, CellLists::most_dimensions> cells_;
    std::array<bool, CellLists::most_dimensions> has_groups_{};           // by dimension
    std::array<std::size_t, CellLists::most_dimensions> second_groups_{}; // of cells, by dimension
};

} // namespace

std::optional<MeshLayout> gmsh_layout(const PartialFile& file) {
    return GmshHopper(file).layout();
}

} // namespace polydec
