// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace polydec {

/// What every error of polydec is. The text says what is wrong, where, and what to do.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The data do not fit: the text names the cell, vertex or line, what was expected, what to do.
class InvalidInput : public Error {
public:
    using Error::Error;
};

/// An engine did not deliver: the text names engine, iterations, residual and the probable cause.
class SolverFailure : public Error {
public:
    using Error::Error;
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
