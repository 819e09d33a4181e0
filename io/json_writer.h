// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace polydec {

/// Makes one JSON text in memory, in the order of the calls and without a tree of values: whoever
/// wants it out writes it at once, or not at all if it could not be finished. Numbers read back
/// exactly. Text that is no UTF-8 is made printable. Throws std::bad_alloc where memory ends.
class JsonWriter {
public:
    JsonWriter();
    ~JsonWriter();
    JsonWriter(const JsonWriter&) = delete;
    JsonWriter& operator=(const JsonWriter&) = delete;

    /// An object whose members `fill` writes; as a value, or as a member of the one around it.
    template <std::invocable Fill>
    void object(Fill fill) {
        begin_object();
        fill();
        end_object();
    }
    template <std::invocable Fill>
    void object(std::string_view name, Fill fill) {
        key(name);
        object(fill);
    }

    /// An array whose values `fill` writes.
    template <std::invocable Fill>
    void array(Fill fill) {
        begin_array();
        fill();
        end_array();
    }
    template <std::invocable Fill>
    void array(std::string_view name, Fill fill) {
        key(name);
        array(fill);
    }

    /// A member: truth, number, text, null for an empty optional, or a range of such values.
    /// Throws SolverFailure, naming the member, for a number that is NaN or infinite.
    template <class Value>
    void member(std::string_view name, const Value& content) {
        key(name);
        value(content);
    }

    /// The same as an entry of an array.
    template <class Value>
    void value(const Value& content) {
        if constexpr (std::same_as<Value, bool>) {
            truth(content);
        } else if constexpr (std::integral<Value>) {
            integer(static_cast<std::int64_t>(content));
        } else if constexpr (std::floating_point<Value>) {
            number(content);
        } else if constexpr (std::convertible_to<const Value&, std::string_view>) {
            text(content);
        } else if constexpr (is_optional<Value>::value) {
            if (content)
                value(*content);
            else
                null();
        } else {
            array([&] {
                for (const auto& entry : content)
                    value(entry);
            });
        }
    }

    /// What was written so far, which is a JSON text once the outermost object has ended. Valid
    /// until the next call.
    std::string_view view() const;

private:
    template <class Value>
    struct is_optional : std::false_type {};
    template <class Value>
    struct is_optional<std::optional<Value>> : std::true_type {};

    void begin_object();
    void end_object();
    void begin_array();
    void end_array();
    void key(std::string_view name);
    void truth(bool value);
    void integer(std::int64_t value);
    void number(double value);
    void text(std::string_view value);
    void null();

    struct State;
    std::unique_ptr<State> state_;
};

} // namespace polydec
