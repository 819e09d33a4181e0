// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// A function of the position, written in x, y, z (and x1, x2, .. in any dimension). It has no
/// memory: the value at a site depends on that site alone.
class Expression {
public:
    /// Throws CLI::ValidationError, with the place, for text that is no expression. `option` names
    /// the option the text was given to, `label` another variable, if there is one: a number that
    /// is known at every site.
    Expression(const std::string& option, const std::string& text, const std::string& label = "");
    ~Expression();

    /// Values at the rows of `sites`, with the label's values there if it is known. Throws
    /// InvalidInput, naming the place, where there is none, and for a coordinate that sites do not
    /// have, or a label that is not known.
    Vector operator()(const Points& sites, const std::vector<Index>& labels = {}) const;

    /// The same with one value of the label for all sites, as a time.
    Vector operator()(const Points& sites, double label) const;

    bool uses_label() const;
    /// The value for a label alone, such as a time. Throws InvalidInput where there is none, and
    /// for an expression that has coordinates in it.
    double of_label(double label) const;

private:
    Vector values(const Points& sites, const std::vector<Index>& labels) const;

    struct State;
    std::unique_ptr<State> state_;
};

/// What an option gives at sites: numbers of a file, if there is one of that name, or the values of
/// an expression. A file holds one number for each site, separated by white space. Made before any
/// work, so that what is no expression is told at once.
class SiteValues {
public:
    /// Throws like Expression; also for text that is both a file and an expression. InvalidInput
    /// for a file with anything but finite numbers, IoError for one that cannot be read.
    SiteValues(const std::string& option, const std::string& text, const std::string& label = "");
    SiteValues(SiteValues&&) noexcept;
    ~SiteValues();

    /// Throws InvalidInput for a file with another number of values, else like Expression.
    Vector at(const Points& sites, const std::vector<Index>& labels = {}) const;
    Vector at(const Points& sites, double label) const;

    /// Whether they are an expression that uses the label.
    bool uses_label() const { return expression_ && expression_->uses_label(); }

    /// The same at some of `count` sites, of which these have the given numbers.
    Vector at(const Points& sites, const std::vector<std::int64_t>& numbers,
              std::int64_t count) const;

    /// The file, if it is one.
    const std::optional<std::filesystem::path>& file() const { return file_; }

private:
    void check_count(std::int64_t places) const;

    std::optional<std::filesystem::path> file_;
    Vector values_;
    std::unique_ptr<const Expression> expression_;
};

} // namespace polydec::tools
