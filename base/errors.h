// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "base/solve_report.h"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// Base of all errors of polydec. The text states the error, its place and a remedy.
class Error : public std::runtime_error {
public:
    /// Place of the error: the objects named in the text, by the same numbers; lists are complete
    /// where the text names only the first few.
    struct Place {
        int degree = -1; ///< degree of the cells; -1 if none are named
        std::vector<Index> cells = {};
        std::vector<Index> vertices = {};
        std::filesystem::path path = {};
        std::int64_t line = 0; ///< line of the file, from 1; 0 if none is named
    };

    explicit Error(const std::string& text) : Error(text, Place()) {}
    Error(const std::string& text, Place place)
        : std::runtime_error(text), place_(std::make_shared<const Place>(std::move(place))) {}

    const Place& place() const noexcept { return *place_; }

private:
    Shared<const Place> place_; // copies of errors must not throw
};

/// Invalid data: the text names the cell, vertex or line, the expected value, and a remedy.
class InvalidInput : public Error {
public:
    using Error::Error;
};

/// An engine failed: the text names engine, iterations, residual and the probable cause.
class SolverFailure : public Error {
public:
    explicit SolverFailure(const std::string& text, SolveReport report = SolveReport::failed(""),
                           Place place = {})
        : Error(text, std::move(place)),
          report_(std::make_shared<const SolveReport>(std::move(report))) {}

    /// Progress of the engine, as far as the text reports it.
    const SolveReport& report() const noexcept { return *report_; }

private:
    Shared<const SolveReport> report_;
};

/// The engine is not part of this build: the text names the package and the build option.
class BackendUnavailable : public Error {
public:
    using Error::Error;
};

/// A file cannot be opened, read or written, or memory does not suffice for its contents.
class IoError : public Error {
public:
    using Error::Error;
};

} // namespace polydec
