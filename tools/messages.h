// SPDX-License-Identifier: MIT
#pragma once

#include "base/memory.h"

#include <filesystem>
#include <string>

namespace polydec::tools {

/// Calls work(); the messages of errors that it throws are put as `reword` says.
template <class Work, class Reword>
auto reworded(Reword reword, Work work) {
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw InvalidInput(reword(error.what()));
    } catch (const OutOfMemory& error) {
        throw OutOfMemory(reword(error.what()));
    } catch (const SolverFailure& error) {
        throw SolverFailure(reword(error.what()));
    } catch (const BackendUnavailable& error) {
        throw BackendUnavailable(reword(error.what()));
    } catch (const IoError& error) {
        throw IoError(reword(error.what()));
    }
}

/// A message of the library as the command tells it: with its options where the library names what
/// stands for them in C++, printable, and at most a few hundred characters long.
std::string told(std::string message);

/// The message with the file in front, unless it is named already; its name is printable then.
std::string naming(const std::filesystem::path& file, std::string message);

/// Calls work(), which computes on the mesh of a file; its errors name the file.
template <class Work>
auto computed_on(const std::filesystem::path& file, Work work) {
    return reworded([&](const char* message) { return naming(file, message); }, work);
}

} // namespace polydec::tools
