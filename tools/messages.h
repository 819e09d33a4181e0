// SPDX-License-Identifier: MIT
#pragma once

#include "base/memory.h"

#include <filesystem>
#include <string>

namespace polydec::tools {

/// Calls work(); the messages of errors that it throws are put as `reword` says, and where their
/// places name no file, it is this one.
template <class Work, class Reword>
auto reworded(Reword reword, Work work, const std::filesystem::path& file = {}) {
    const auto place = [&](const Error& error) {
        auto result = error.place();
        if (result.path.empty())
            result.path = file;
        return result;
    };
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw InvalidInput(reword(error.what()), place(error));
    } catch (const OutOfMemory& error) {
        throw OutOfMemory(reword(error.what()), error.report(), place(error));
    } catch (const SolverFailure& error) {
        throw SolverFailure(reword(error.what()), error.report(), place(error));
    } catch (const BackendUnavailable& error) {
        throw BackendUnavailable(reword(error.what()), place(error));
    } catch (const IoError& error) {
        throw IoError(reword(error.what()), place(error));
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
    return reworded([&](const char* message) { return naming(file, message); }, work, file);
}

} // namespace polydec::tools
