// SPDX-License-Identifier: MIT
#include "backends/engine_folder.h"

#include "backends/engine_module.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <vector>

namespace polydec {

namespace {

namespace files = std::filesystem;

/// Modules that were tried, by name, with the reason why they are of no use; empty: they are.
struct TriedModules {
    std::recursive_mutex mutex;
    std::map<std::string, std::string> reasons;
};

TriedModules& tried_modules() {
    static TriedModules instance;
    return instance;
}

// The file that this code is in and the program's; a path that was not absolute when it was loaded
// may mean anything by now.
std::vector<files::path> own_files() {
    std::vector<files::path> result;
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&load_all_modules), &info) != 0 && info.dli_fname)
        result.emplace_back(info.dli_fname);
    std::error_code error;
    result.push_back(files::read_symlink("/proc/self/exe", error));
    std::erase_if(result, [](const files::path& file) { return !file.is_absolute(); });
    return result;
}

// The folders that the loader searches for libraries of the file that this code is in: its run
// path, LD_LIBRARY_PATH and those of the system.
std::vector<files::path> loader_folders() {
    std::vector<files::path> result;
#ifdef __GLIBC__
    Dl_info info{};
    void* own_file = nullptr;
    Dl_serinfo size{};
    if (dladdr1(reinterpret_cast<const void*>(&load_all_modules), &info, &own_file,
                RTLD_DL_LINKMAP) == 0 ||
        dlinfo(own_file, RTLD_DI_SERINFOSIZE, &size) != 0)
        return result;
    std::vector<std::max_align_t> memory(size.dls_size / sizeof(std::max_align_t) + 1);
    auto* const found = reinterpret_cast<Dl_serinfo*>(memory.data());
    if (dlinfo(own_file, RTLD_DI_SERINFOSIZE, found) != 0 ||
        dlinfo(own_file, RTLD_DI_SERINFO, found) != 0)
        return result;
    const Dl_serpath* const folders = found->dls_serpath;
    for (unsigned i = 0; i < found->dls_cnt; ++i)
        result.emplace_back(folders[i].dls_name);
    std::erase_if(result, [](const files::path& folder) { return !folder.is_absolute(); });
#endif
    return result;
}

std::vector<files::path> engine_folders() {
    if (const char* folder = std::getenv("POLYDEC_ENGINES"))
        return {folder};
    std::vector<files::path> result;
    for (const auto& file : own_files()) {
        std::error_code error;
        const auto home = files::canonical(file, error).parent_path();
        if (error)
            continue;
        result.push_back(home / "polydec");
        result.push_back(home / "engines");
        result.push_back((home / POLYDEC_LIB_FROM_BIN / "polydec").lexically_normal());
    }
    for (const auto& folder : loader_folders())
        result.push_back((folder / "polydec").lexically_normal());
    result.emplace_back(POLYDEC_LIB "/polydec");
    return result;
}

std::string module_name(const std::string& engine) {
    const auto name = engine.substr(0, engine.find('.'));
    return name.find('/') == std::string::npos ? name : std::string{};
}

void load_tried(const files::path& file, std::string& reason) {
    try {
        load_engine_module(file, registrar_of_missing());
        reason.clear();
    } catch (const std::exception& failure) {
        reason = failure.what();
        std::replace(reason.begin(), reason.end(), '\n', ' ');
    }
}

// From the first of the folders that has it.
void load_module(const std::string& name) {
    auto& tried = tried_modules();
    const std::lock_guard lock(tried.mutex);
    if (name.empty() || tried.reasons.contains(name))
        return;
    auto& reason = tried.reasons[name];
    for (const auto& folder : engine_folders()) {
        std::error_code error;
        if (const auto file = folder / (name + ".so"); files::is_regular_file(file, error))
            return load_tried(file, reason);
    }
}

} // namespace

void load_module_of(const std::string& engine) {
    load_module(module_name(engine));
}

void load_all_modules() {
    for (const auto& folder : engine_folders()) {
        std::error_code error;
        for (files::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error))
            if (entry->path().extension() == ".so")
                load_module(entry->path().stem().string());
    }
}

std::string why_missing(const std::string& engine) {
    auto& tried = tried_modules();
    const std::lock_guard lock(tried.mutex);
    const auto found = tried.reasons.find(module_name(engine));
    return found == tried.reasons.end() ? std::string{} : found->second;
}

} // namespace polydec
