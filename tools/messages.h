// SPDX-License-Identifier: MIT
#pragma once

#include "system/memory.h"

#include <filesystem>
#include <string>

namespace polydec::tools {

/// Calls work() and rewords the messages of its errors by `reword`; places without a file get this
/// one.
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

/// A library message for command-line users: C++ names are replaced by options, and the text is
/// printable and at most a few hundred characters long.
std::string told(std::string message);

/// The message with the file in front, in printable form, unless it already names the file.
std::string naming(const std::filesystem::path& file, std::string message);

/// Calls work(), a computation on a file's mesh; its errors name the file.
template <class Work>
auto computed_on(const std::filesystem::path& file, Work work) {
    return reworded([&](const char* message) { return naming(file, message); }, work, file);
}

} // namespace polydec::tools
