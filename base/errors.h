// SPDX-License-Identifier: MIT
#pragma once

#include "base/solve_report.h"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// What every error of polydec is. The text says what is wrong, where, and what to do.
class Error : public std::runtime_error {
public:
    /// Where it is wrong: what the text names, by the same numbers; lists are whole where it names
    /// the first few.
    struct Place {
        int degree = -1; ///< of the cells; -1 if none are named
        std::vector<Index> cells = {};
        std::vector<Index> vertices = {};
        std::filesystem::path path = {};
        std::int64_t line = 0; ///< of the file, from 1; 0 if none is named
    };

    explicit Error(const std::string& text) : Error(text, Place()) {}
    Error(const std::string& text, Place place)
        : std::runtime_error(text), place_(std::make_shared<const Place>(std::move(place))) {}

    const Place& place() const noexcept { return *place_; }

private:
    std::shared_ptr<const Place> place_; // copies of errors must not throw
};

/// The data do not fit: the text names the cell, vertex or line, what was expected, what to do.
class InvalidInput : public Error {
public:
    using Error::Error;
};

/// An engine did not deliver: the text names engine, iterations, residual and the probable cause.
class SolverFailure : public Error {
public:
    explicit SolverFailure(const std::string& text, SolveReport report = SolveReport::failed(""),
                           Place place = {})
        : Error(text, std::move(place)),
          report_(std::make_shared<const SolveReport>(std::move(report))) {}

    /// How far the engine came, as far as the text tells.
    const SolveReport& report() const noexcept { return *report_; }

private:
    std::shared_ptr<const SolveReport> report_;
};

/// The engine is not part of this build: the text names the package and the build option.
class BackendUnavailable : public Error {
public:
    using Error::Error;
};

/// A file cannot be opened, read or written, or memory does not suffice for what it holds.
class IoError : public Error {
public:
    using Error::Error;
};

} // namespace polydec
