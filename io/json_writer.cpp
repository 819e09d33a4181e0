// SPDX-License-Identifier: MIT
#include "io/json_writer.h"

#include "base/errors.h"
#include "base/printable.h"

#include <fmt/format.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <cmath>
#include <cstdlib>
#include <new>

namespace polydec {

namespace {

/// The library's own allocators give null where memory ends, which it does not look for.
class ThrowingAllocator {
public:
    [[maybe_unused]] static constexpr bool kNeedFree = true;
    void* Malloc(std::size_t size) { return Realloc(nullptr, 0, size); }
    void* Realloc(void* old, std::size_t, std::size_t size) {
        if (size == 0) {
            std::free(old);
            return nullptr;
        }
        void* const place = std::realloc(old, size);
        if (place == nullptr)
            throw std::bad_alloc();
        return place;
    }
    static void Free(void* place) { std::free(place); }
};

using Utf8 = rapidjson::UTF8<>;
using Buffer = rapidjson::GenericStringBuffer<Utf8, ThrowingAllocator>;
using Writer = rapidjson::Writer<Buffer, Utf8, Utf8, ThrowingAllocator>;

rapidjson::SizeType size_of(std::string_view text) {
    return static_cast<rapidjson::SizeType>(text.size());
}

} // namespace

struct JsonWriter::State {
    ThrowingAllocator memory;
    Buffer buffer{&memory};
    Writer writer{buffer, &memory};
    std::string last_key;
};

JsonWriter::JsonWriter() : state_(std::make_unique<State>()) {}
JsonWriter::~JsonWriter() = default;

void JsonWriter::begin_object() {
    state_->writer.StartObject();
}

void JsonWriter::end_object() {
    state_->writer.EndObject();
}

void JsonWriter::begin_array() {
    state_->writer.StartArray();
}

void JsonWriter::end_array() {
    state_->writer.EndArray();
}

void JsonWriter::key(std::string_view name) {
    state_->last_key = name;
    state_->writer.Key(name.data(), size_of(name));
}

void JsonWriter::truth(bool value) {
    state_->writer.Bool(value);
}

void JsonWriter::integer(std::int64_t value) {
    state_->writer.Int64(value);
}

void JsonWriter::number(double value) {
    if (!std::isfinite(value))
        throw SolverFailure(
            fmt::format("the result for '{}' is {}, not a finite number: coordinates or data are "
                        "too large, too small or too far apart; scale them",
                        state_->last_key, value));
    state_->writer.Double(value);
}

void JsonWriter::text(std::string_view value) {
    const std::string valid =
        is_utf8(value) ? std::string(value) : printable(value, 6 * value.size());
    state_->writer.String(valid.data(), size_of(valid));
}

void JsonWriter::null() {
    state_->writer.Null();
}

std::string_view JsonWriter::view() const {
    return {state_->buffer.GetString(), state_->buffer.GetSize()};
}

} // namespace polydec
