// SPDX-License-Identifier: MIT
//
// The rows of docs/performance.md. Besides Google Benchmark's options:
//   --smoke         small meshes, one round: only whether it runs
//   --rounds=N      of each row, 5
//   --fresh-memory  leaves the allocator as it is: results come to lie in memory never touched
#include "backends/blas.h"
#include "backends/registry.h"
#include "base/errors.h"
#include "benchmarks/bandwidth.h"
#include "benchmarks/memory.h"
#include "benchmarks/rows.h"
#include "benchmarks/threads.h"
#include "system/memory.h"
#include "system/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>

namespace polydec::benchmarks {

void add_row(const std::string& name, int rounds, Row row) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [row = std::move(row)](benchmark::State& state) {
                                     try {
                                         row(state);
                                     } catch (const Error& error) {
                                         state.SkipWithError(error.what());
                                     }
                                 })
        ->Iterations(rounds)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

namespace {

/// The rows of the bare engines must not have more threads than the library's.
void take_one_blas_thread() {
    using Setter = void (*)(int);
    if (const auto set = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
        set(1);
}

/// Takes our own options out of the arguments; the rest is Google Benchmark's.
Settings take_settings(int& argc, char** argv) {
    Settings settings;
    bool keep = true;
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--smoke")
            settings.smoke = true, settings.rounds = 1;
        else if (argument == "--fresh-memory")
            keep = false;
        else if (argument.starts_with("--rounds="))
            settings.rounds = std::max(1, std::atoi(argument.c_str() + 9));
        else
            argv[kept++] = argv[i];
    }
    argc = kept;
    if (keep)
        keep_freed_memory();
    if (settings.smoke)
        measure_bandwidth_roughly();
    benchmark::AddCustomContext("memory", keep ? "kept" : "fresh");
    return settings;
}

/// OpenBLAS, with which the program is linked, reads the environment when it is loaded: with what
/// the library says to it before it loads an engine, the program begins once more.
void take_fitting_kernels(char** argv) {
    constexpr const char* kernels = "OPENBLAS_CORETYPE";
    if (std::getenv(kernels))
        return;
    prepare_blas();
    if (std::getenv(kernels))
        execv("/proc/self/exe", argv);
}

int run(int argc, char** argv) {
    take_fitting_kernels(argv);
    Settings settings = take_settings(argc, argv);
    const TemporaryFolder folder;
    settings.folder = folder.path();
    take_one_blas_thread();
    set_threads(1);

    add_operator_rows(settings);
    add_product_rows(settings);
    add_engine_rows(settings);
    add_thread_rows(settings);
    add_file_rows(settings);
    add_size_rows(settings);
    benchmark::AddCustomContext("copy_bandwidth", std::to_string(copy_bandwidth()));
    benchmark::AddCustomContext("compiler", POLYDEC_COMPILER);

    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace

} // namespace polydec::benchmarks

int main(int argc, char** argv) {
    try {
        return polydec::benchmarks::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "benchmarks: %s\n", error.what());
        return 4;
    }
}
