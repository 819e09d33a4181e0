// SPDX-License-Identifier: MIT
#include "io/checkpoint.h"

#include "base/errors.h"
#include "base/printable.h"
#include "dec/discretization/fingerprint.h"
#include "io/byte_order.h"
#include "io/source_file.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

#include <bit>

namespace polydec {

namespace {

constexpr std::string_view heading = "polydec checkpoint 1\n";
constexpr std::size_t word_size = sizeof(std::uint64_t);

/// Words of a file, the lowest byte first.
class WordReader {
public:
    explicit WordReader(const SourceFile& file) : file_(file) {}

    std::uint64_t next() {
        if (left() == 0)
            fail("it ends too early");
        const auto word = number_at<std::uint64_t>(file_.text.data() + at_, std::endian::little);
        at_ += word_size;
        return word;
    }
    std::size_t left() const { return (file_.text.size() - at_) / word_size; }

    [[noreturn]] void fail(std::string_view reason) const {
        throw InvalidInput(fmt::format("{} cannot be resumed: {}", printable(file_.name), reason),
                           {.path = file_.name});
    }

private:
    const SourceFile& file_;
    std::size_t at_ = heading.size();
};

/// The last word holds of those before it, and there are whole words alone.
void check_whole(const SourceFile& file) {
    WordReader words(file);
    if (!file.text.starts_with(heading))
        words.fail("it is not a checkpoint of this version of polydec");
    if ((file.text.size() - heading.size()) % word_size != 0 || words.left() == 0)
        words.fail("it is cut off");
    Fingerprint found;
    while (words.left() > 1)
        found.add(words.next());
    if (words.next() != found.value())
        words.fail("it is damaged");
}

} // namespace

/// The file, and the fingerprint of all its words, which is the last one.
struct CheckpointWriter::Words {
    explicit Words(const std::filesystem::path& path) : file(path) {}

    void write(std::uint64_t word) {
        fingerprint.add(word);
        put(word);
    }
    void put(std::uint64_t word) { file.write(bytes_of(word)); }

    AtomicFile file;
    Fingerprint fingerprint;
};

CheckpointWriter::CheckpointWriter(const std::filesystem::path& path,
                                   const Checkpoint& without_state,
                                   const std::vector<std::int64_t>& sizes)
    : words_(std::make_unique<Words>(path)) {
    words_->file.write(heading);
    words_->write(without_state.problem);
    words_->write(without_state.step);
    words_->write(std::bit_cast<std::uint64_t>(without_state.time));
    words_->write(sizes.size());
    for (const std::int64_t size : sizes)
        words_->write(static_cast<std::uint64_t>(size));
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::add(const Vector& values) {
    for (const double value : values)
        words_->write(std::bit_cast<std::uint64_t>(value));
}

void CheckpointWriter::commit() {
    words_->put(words_->fingerprint.value());
    words_->file.commit();
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
    std::vector<std::int64_t> sizes;
    for (const Vector& values : checkpoint.state)
        sizes.push_back(values.size());
    CheckpointWriter writer(path, checkpoint, sizes);
    for (const Vector& values : checkpoint.state)
        writer.add(values);
    writer.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& path, std::uint64_t problem) {
    const SourceFile file = read_source_file(path);
    check_whole(file);
    WordReader words(file);
    Checkpoint result;
    result.problem = words.next();
    if (result.problem != problem)
        words.fail("it belongs to another mesh, equation or option; start a new run, or use the "
                   "same inputs");
    result.step = words.next();
    result.time = std::bit_cast<double>(words.next());
    const std::uint64_t count = words.next();
    std::vector<std::uint64_t> sizes;
    for (std::uint64_t i = 0; i < count; ++i)
        sizes.push_back(words.next());
    for (const std::uint64_t size : sizes) {
        if (size >= words.left())
            words.fail("its sizes do not match its numbers");
        Vector& values = result.state.emplace_back(static_cast<Eigen::Index>(size));
        for (double& value : values)
            value = std::bit_cast<double>(words.next());
    }
    return result;
}

} // namespace polydec
