// SPDX-License-Identifier: MIT
#include "backends/engine_module.h"

#include "backends/blas.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <cstdint>
#include <dlfcn.h>
#include <fstream>
#include <mutex>
#include <set>
#include <sys/resource.h>
#include <unistd.h>

namespace polydec {

namespace {

// A library that is loaded, its threads and their storage may need so much of address space. Where
// that is not available, the system's loader ends the program instead of failing.
constexpr std::uint64_t room_of_module = std::uint64_t{256} << 20;

void require_room(const std::filesystem::path& path) {
    rlimit limit{};
    std::uint64_t used_pages = 0;
    const bool is_limited = ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    if (!is_limited || !(std::ifstream("/proc/self/statm") >> used_pages))
        return;
    const auto used = used_pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    if (used + room_of_module > limit.rlim_cur)
        throw BackendUnavailable(
            fmt::format("{}: the module is not loaded: {} MB of address space are in use, the "
                        "limit is {} MB, and a module may need {} MB\n"
                        "Raise the limit.",
                        path.string(), used >> 20, limit.rlim_cur >> 20, room_of_module >> 20));
}

// A name without a slash would be searched for in the system's folders instead of here. No file is
// closed again: one that is no module may have registered engines as it was loaded.
void* open_module(const std::filesystem::path& path) {
    const std::string file = std::filesystem::absolute(path).string();
    void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) {
        const char* reason = dlerror();
        throw IoError(fmt::format("{}: cannot be loaded as an engine module: {}", path.string(),
                                  reason ? reason : "unknown reason"),
                      {.path = path});
    }
    return module;
}

template <typename Function>
Function* find_function(void* module, const char* name, const std::filesystem::path& path) {
    void* const symbol = dlsym(module, name);
    if (!symbol)
        throw IoError(
            fmt::format("{}: not an engine module: it exports no function {}", path.string(), name),
            {.path = path});
    return reinterpret_cast<Function*>(symbol);
}

} // namespace

void load_engine_module(const std::filesystem::path& path, EngineRegistrar& registrar) {
    static std::recursive_mutex mutex;
    static std::set<void*> loaded;
    const std::lock_guard lock(mutex);

    require_room(path);
    prepare_blas();
    void* const module = open_module(path);
    if (loaded.contains(module))
        return;
    const int version = find_function<int()>(module, "polydec_engine_module_version", path)();
    if (version != engine_module_version)
        throw BackendUnavailable(
            fmt::format("{}: the engine module has version {}, but this polydec needs version {}\n"
                        "Build it against the headers of this polydec.",
                        path.string(), version, engine_module_version));
    const auto register_engines =
        find_function<void(EngineRegistrar&)>(module, "polydec_register_engines", path);
    find_blas(module);
    register_engines(registrar);
    loaded.insert(module);
}

} // namespace polydec
