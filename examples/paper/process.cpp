// SPDX-License-Identifier: MIT
#include "examples/paper/process.h"

#include "examples/paper/console.h"
#include "system/memory.h"
#include "system/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <iterator>
#include <new>
#include <pthread.h>
#include <thread>
#include <unistd.h>

namespace polydec {

namespace {

constexpr const char* no_memory = "memory does not suffice for this mesh";
char over_limit[160]; ///< message when the limit is exceeded

const char* program = "";
std::atomic<bool> is_working{false};

/// The program ends for one reason: a limit that is exceeded meanwhile is not told.
int fail(ExitCode code, const char* text) noexcept {
    sigset_t limits{};
    sigemptyset(&limits);
    sigaddset(&limits, SIGXCPU);
    pthread_sigmask(SIG_BLOCK, &limits, nullptr);
    console::tell(program);
    console::tell(": ");
    console::tell(text);
    console::tell("\n");
    return code;
}

pthread_t main_thread;
std::atomic<bool> is_over_limit{false};

void watch(int signal) noexcept;

// The handler is reset once it is called, so a second signal ends the program. Unfinished files
// belong to the main thread: in another thread, the handler would remove them while they are made,
// even while that thread blocks signals.
extern "C" void end_by(int signal) {
    const auto *begin = std::begin(ending_signals), *end = std::end(ending_signals);
    if (std::find(begin, end, signal) != end &&
        ::pthread_equal(::pthread_self(), main_thread) == 0) {
        watch(signal);
        ::pthread_kill(main_thread, signal);
        return;
    }
    remove_unfinished();
    if (is_over_limit)
        ::_exit(fail(resource_failure, over_limit));
    ::raise(signal);
}

void watch(int signal) noexcept {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL)
        return; // ignored, or handled elsewhere
    action = {};
    action.sa_handler = end_by;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    sigfillset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

/// All signals that end a program by default and can be caught.
void watch_signals() noexcept {
    alignas(16) static char
        stack[removal_stack + (1 << 16)]; // the program's own stack may have run out
    stack_t other{};
    other.ss_sp = stack;
    other.ss_size = sizeof stack;
    ::sigaltstack(&other, nullptr);

    main_thread = ::pthread_self();
    for (const int signal : ending_signals)
        watch(signal);
    for (const int signal : {SIGABRT, SIGALRM, SIGBUS, SIGFPE, SIGILL, SIGPROF, SIGSEGV, SIGSYS,
                             SIGTRAP, SIGUSR1, SIGUSR2, SIGVTALRM})
        watch(signal);
    std::signal(SIGPIPE, SIG_IGN);
}

/// For libraries, such as OpenMP, that call exit() when memory is short.
extern "C" void end_early() {
    if (!is_working)
        return;
    remove_unfinished();
    ::_exit(fail(resource_failure, "a library ended the program, as a resource did not suffice"));
}

/// An error in a function that must not throw; most likely memory is short.
[[noreturn]] void end_by_error() noexcept {
    remove_unfinished();
    try {
        if (std::current_exception())
            throw;
    } catch (const std::bad_alloc&) {
        ::_exit(fail(resource_failure, no_memory));
    } catch (const std::exception& error) {
        fail(resource_failure, error.what());
    } catch (...) {
    }
    std::abort();
}

int guarded(int (*work)(int, char**), int argc, char** argv) noexcept {
    try {
        return work(argc, argv);
    } catch (const InvalidInput& error) {
        return fail(bad_input, error.what());
    } catch (const OutOfMemory& error) {
        return fail(resource_failure, error.what());
    } catch (const SolverFailure& error) {
        return fail(numerical_failure, error.what());
    } catch (const std::bad_alloc&) {
        return fail(resource_failure, no_memory);
    } catch (const std::exception& error) {
        return fail(resource_failure, error.what());
    } catch (...) {
        return fail(resource_failure, "an error of an unknown kind");
    }
}

/// Failed output is not a success, and neither is partial output.
int finish_output(int code) noexcept {
    if (code != done) {
        console::forget();
        return code;
    }
    const int error = console::flush();
    if (error == 0)
        return done;
    console::tell(program);
    console::tell(": standard output is not writable: ");
    console::tell(std::strerror(error));
    console::tell("\n");
    return resource_failure;
}

/// Memory of the program in bytes, without the pages of files, such as code that is loaded when it
/// is first used; 0 if unknown. Allocates no memory.
std::uint64_t memory_in_use() noexcept {
    static const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    char text[64] = "";
    unsigned long long resident = 0, of_files = 0;
    if (::pread(file, text, sizeof text - 1, 0) <= 0 ||
        std::sscanf(text, "%*u %llu %llu", &resident, &of_files) != 2 || resident < of_files)
        return 0;
    return (resident - of_files) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Threads that wait by spinning take the time of other programs. OpenMP asks for this once, when
/// it is loaded, so the program starts again; if it cannot, it goes on as it is.
void wait_passively(char** argv) noexcept {
    static char path[4096] = "";
    if (std::getenv("OMP_WAIT_POLICY") == nullptr &&
        ::readlink("/proc/self/exe", path, sizeof path - 1) > 0 &&
        ::setenv("OMP_WAIT_POLICY", "passive", 1) == 0)
        ::execv(path, argv);
}

} // namespace

void hold_memory_limit() {
    const std::uint64_t most = memory_limit(), before = memory_in_use();
    *fmt::format_to_n(
         over_limit, sizeof over_limit - 1,
         "more than the {:.3g} MB of memory that may be used are needed: take fewer or "
         "simpler cells, or allow more (--max-memory)",
         static_cast<double>(most) / 1e6)
         .out = 0;
    // the main thread handles signals
    sigset_t all{}, held{};
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &held);
    std::thread([=] {
        while (memory_in_use() <= before + most)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        is_over_limit = true;
        ::pthread_kill(main_thread, SIGXCPU);
    }).detach();
    pthread_sigmask(SIG_SETMASK, &held, nullptr);
}

int run_process(const char* name, int (*work)(int, char**), int argc, char** argv) noexcept {
    wait_passively(argv);
    program = name;
    keep_freed_memory();
    console::open_standard_streams();
    watch_signals();
    std::set_terminate(end_by_error);
    static_cast<void>(std::atexit(end_early));

    is_working = true;
    const int code = finish_output(guarded(work, argc, argv));
    is_working = false;
    return code;
}

} // namespace polydec
