// SPDX-License-Identifier: MIT
#include "backends/linear/petsc_options.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cctype>
#include <sstream>

namespace polydec::petsc {

namespace {

// The names among the words of a line of options; what follows a name is its value.
std::vector<std::string> option_names(const std::string& options) {
    std::vector<std::string> names;
    std::istringstream words(options);
    for (std::string word; words >> word;)
        if (word.size() > 1 && word[0] == '-' &&
            std::isalpha(static_cast<unsigned char>(word[1])) != 0)
            names.push_back(prefix + word.substr(1));
    return names;
}

} // namespace

void check_options(const std::string& engine, const std::string& options) {
    const auto first = options.find_first_not_of(" \t\n");
    if (first != std::string::npos && options[first] != '-')
        throw InvalidInput(fmt::format("{}: the engine options `{}` must begin with a minus sign, "
                                       "such as -ksp_type fcg",
                                       engine, options));
}

SetOptions::SetOptions(const Session& session, const std::string& options)
    : names_(option_names(options)) {
    PetscOptionsPrefixPush(nullptr, prefix);
    const auto error = PetscOptionsInsertString(nullptr, options.c_str());
    PetscOptionsPrefixPop(nullptr);
    if (error) {
        clear();
        session.require(error, "reading the options");
    }
}

void SetOptions::clear() const {
    for (const auto& name : names_)
        PetscOptionsClearValue(nullptr, ("-" + name).c_str());
}

void require_read(const std::string& engine, const std::string& options) {
    for (const auto& option : option_names(options)) {
        PetscBool used = PETSC_FALSE;
        PetscOptionsUsed(nullptr, option.c_str(), &used);
        const std::string own_name = option.substr(std::string(prefix).size());
        if (!used && !own_name.starts_with("mg_"))
            throw InvalidInput(
                fmt::format("{}: the engine option -{} has no effect\n"
                            "It is misspelled, or belongs to another method of PETSc.",
                            engine, own_name));
    }
}

} // namespace polydec::petsc
