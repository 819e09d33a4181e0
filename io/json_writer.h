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

/// Builds a JSON text in memory, in the order of calls and without a tree of values. The caller
/// outputs it whole, or not at all after an error. Numbers read back exactly. Text that is not
/// UTF-8 is made printable. Throws std::bad_alloc if memory runs out.
class JsonWriter {
public:
    JsonWriter();
    ~JsonWriter();
    JsonWriter(const JsonWriter&) = delete;
    JsonWriter& operator=(const JsonWriter&) = delete;

    /// An object with members written by `fill`; as a value, or as a member of its parent.
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

    /// An array with values written by `fill`.
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

    /// An array with an object for each entry of a range, with members written by `fill(entry)`.
    template <class Range, class Fill>
    void objects(std::string_view name, const Range& range, Fill fill) {
        array(name, [&] {
            for (const auto& entry : range)
                object([&] { fill(entry); });
        });
    }

    /// A member: boolean, number, text, null for an empty optional, or a range of such values.
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

    /// The text so far, which is valid JSON once the outermost object has ended. Valid until the
    /// next call.
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
