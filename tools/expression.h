// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// A function of the position, in x, y, z (and x1, x2, .. in any dimension). It has no state: the
/// value at a site depends on that site alone.
class Expression {
public:
    /// Throws CLI::ValidationError, with the place, for an invalid expression. `option` is the name
    /// of the option with this text, `label` an additional variable, if any, with a value at every
    /// site.
    Expression(const std::string& option, const std::string& text, const std::string& label = "");
    ~Expression();

    /// Values at the rows of `sites`, with the label's values there if known, or one for all sites,
    /// e.g. a time. Throws InvalidInput, naming the place, where the value is undefined, and for a
    /// missing coordinate or an unknown label.
    Vector operator()(const Points& sites, const Vector& labels = {}) const;

    bool uses_label() const;
    /// The value for a label alone, e.g. a time. Throws InvalidInput if it is undefined, and for an
    /// expression with coordinates.
    double of_label(double label) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Values of an option at sites: numbers from a file, if one of that name exists, or values of an
/// expression. A file holds one number per site, separated by white space. Construct before any
/// work, so that errors are reported at once.
class SiteValues {
public:
    /// Throws like Expression; also for text that is both a file and an expression. Throws
    /// InvalidInput for a file with anything but finite numbers, IoError for an unreadable one.
    SiteValues(const std::string& option, const std::string& text, const std::string& label = "");

    /// Throws InvalidInput for a file with a wrong number of values, else like Expression.
    Vector at(const Points& sites, const Vector& labels = {}) const;

    /// Whether they are an expression that uses the label.
    bool uses_label() const { return expression_ && expression_->uses_label(); }

    /// The same at some of `count` sites, with these numbers.
    Vector at(const Points& sites, const std::vector<std::int64_t>& numbers,
              std::int64_t count) const;

    bool are_of_file() const { return !expression_; }

private:
    void check_count(std::int64_t places) const;

    std::string file_;
    Vector values_;
    std::unique_ptr<const Expression> expression_; ///< none for a file
};

/// Values that an option gives, none if it is not there.
template <class Values>
std::optional<Values> if_given(const std::string& option, const std::string& text,
                               const std::string& label = "") {
    return text.empty() ? std::nullopt : std::optional<Values>(std::in_place, option, text, label);
}

} // namespace polydec::tools
