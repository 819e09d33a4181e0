// SPDX-License-Identifier: MIT
//
// Preloaded into a program, makes one call of the system fail, or all from one on, or sends a
// signal. The program is loaded once, stops before main, and goes on in a copy of itself for each
// request that faults.py sends; so what is counted begins at main, and ends with the process. Where
// POLYDEC_FULL_DISK is "RANK NUMBER FOLDER" it goes on itself, and on this rank of MPI each write
// into that folder from the n-th on finds the disk full.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace {

/// Of which calls the n-th fails; `shortened` ones do their work a few bytes at a time.
/// `untaken` ones to standard output return 0, as those to a device may.
enum Kind : std::int32_t { nothing, allocation, writing, reading, shortened, signaled, untaken };

struct Request {
    std::int32_t kind, forever;
    std::int64_t number; // from 1; of a signal, microseconds until it comes
    std::int32_t signal, seconds;
};

struct Answer {
    std::int32_t status, timed_out;
    std::int64_t allocations, writings, readings;
};

// Shared with the copies, so that the original can tell what they have counted.
struct Counts {
    std::atomic<std::int64_t> of[untaken + 1];
};

Counts* counts = nullptr;
Request plan{};
std::atomic<bool> is_copy{false};
std::atomic<bool> is_loading{false};
const char* full_folder = nullptr; // that alone is full

bool fails(Kind kind) {
    if (!is_copy.load(std::memory_order_relaxed))
        return false;
    const auto number = counts->of[kind].fetch_add(1) + 1;
    return plan.kind == kind &&
           (number == plan.number || (plan.forever != 0 && number > plan.number));
}

/// Libraries that are being loaded are spared: what Fortran's does first is to end the program.
bool no_memory() {
    if (is_loading || !fails(allocation))
        return false;
    errno = ENOMEM;
    return true;
}

bool is_spared(int file) {
    if (full_folder == nullptr)
        return file == STDERR_FILENO; // what is told there is what the tests read
    char link[64], path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const auto length = ::readlink(link, path, sizeof path - 1);
    return length < 0 || std::strncmp(path, full_folder, std::strlen(full_folder)) != 0;
}

bool no_space(int file) {
    if (is_spared(file) || !fails(writing))
        return false;
    errno = ENOSPC;
    return true;
}

bool no_space() {
    return no_space(-1);
}

/// Whether POLYDEC_FULL_DISK is there.
bool fill_disk() {
    const char* const told = std::getenv("POLYDEC_FULL_DISK");
    const char* const rank = std::getenv("OMPI_COMM_WORLD_RANK");
    long full = 0, number = 0;
    int at = 0;
    if (told == nullptr || std::sscanf(told, "%ld %ld %n", &full, &number, &at) != 2)
        return false;
    static Counts own{};
    counts = &own;
    full_folder = told + at;
    plan = {writing, 1, number, 0, 0};
    is_copy = rank != nullptr && std::atol(rank) == full;
    return true;
}

bool unreadable() {
    if (!fails(reading))
        return false;
    errno = EIO;
    return true;
}

std::size_t piece(std::size_t size) {
    const auto most = static_cast<std::size_t>(plan.number);
    return is_copy && plan.kind == shortened && size > most ? most : size;
}

template <typename Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

#define NEXT(name) static auto* const original = next<decltype(::name)>(#name)

bool transfer(int file, void* data, std::size_t size, bool out) {
    auto* at = static_cast<char*>(data);
    while (size > 0) {
        const auto done = out ? ::write(file, at, size) : ::read(file, at, size);
        if (done <= 0 && errno != EINTR)
            return false;
        at += done;
        size -= static_cast<std::size_t>(done);
    }
    return true;
}

void redirect(const char* path, int stream) {
    const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file != stream) {
        ::dup2(file, stream);
        ::close(file);
    }
}

void pause_for(long microseconds) {
    const timespec time{microseconds / 1000000, microseconds % 1000000 * 1000};
    ::nanosleep(&time, nullptr);
}

Answer watch(pid_t copy, const Request& request) {
    Answer answer{};
    if (request.kind == signaled) {
        pause_for(request.number);
        ::kill(copy, request.signal);
    }
    constexpr long glance = 200;
    for (long waited = 0; ::waitpid(copy, &answer.status, WNOHANG) == 0; waited += glance) {
        pause_for(glance);
        if (waited > request.seconds * 1000000L && answer.timed_out == 0) {
            answer.timed_out = 1;
            ::kill(copy, SIGKILL);
        }
    }
    answer.allocations = counts->of[allocation];
    answer.writings = counts->of[writing];
    answer.readings = counts->of[reading];
    return answer;
}

using Main = int(int, char**, char**);
Main* real_main = nullptr;

/// The names of two descriptors are in the environment; its end is the end of the requests.
int serve(int argc, char** argv, char** environment) {
    const char* const control = std::getenv("POLYDEC_FAULTS");
    int in = -1, out = -1;
    if (fill_disk() || control == nullptr || std::sscanf(control, "%d %d", &in, &out) != 2)
        return real_main(argc, argv, environment);
    ::unsetenv("LD_PRELOAD");
    ::unsetenv("POLYDEC_FAULTS");
    counts = static_cast<Counts*>(
        ::mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    Request request{};
    while (transfer(in, &request, sizeof request, false)) {
        for (auto& count : counts->of)
            count = 0;
        const pid_t copy = ::fork();
        if (copy == 0) {
            ::close(in);
            ::close(out);
            redirect("stdout", STDOUT_FILENO);
            redirect("stderr", STDERR_FILENO);
            plan = request;
            is_copy = true;
            return real_main(argc, argv, environment);
        }
        auto answer = watch(copy, request);
        transfer(out, &answer, sizeof answer, true);
    }
    ::_exit(0);
}

} // namespace

extern "C" {

int __libc_start_main(Main* program, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader_fini)(), void* stack_end) {
    using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
    real_main = program;
    return next<Start>("__libc_start_main")(serve, argc, argv, init, fini, loader_fini, stack_end);
}

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
    return no_memory() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return no_memory() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) noexcept {
    return size > 0 && no_memory() ? nullptr : __libc_realloc(block, size);
}

void* reallocarray(void* block, std::size_t count, std::size_t size) noexcept {
    std::size_t bytes = 0;
    if (__builtin_mul_overflow(count, size, &bytes)) {
        errno = ENOMEM;
        return nullptr;
    }
    return ::realloc(block, bytes);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return no_memory() ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return no_memory() ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    void* const made = no_memory() ? nullptr : __libc_memalign(alignment, size);
    if (made == nullptr)
        return ENOMEM;
    *block = made;
    return 0;
}

void* dlopen(const char* path, int mode) noexcept {
    NEXT(dlopen);
    is_loading = true;
    void* const library = original(path, mode);
    is_loading = false;
    return library;
}

ssize_t write(int file, const void* data, std::size_t size) {
    NEXT(write);
    if (file == STDOUT_FILENO && fails(untaken))
        return 0;
    return no_space(file) ? -1 : original(file, data, piece(size));
}

ssize_t pwrite(int file, const void* data, std::size_t size, off_t offset) {
    NEXT(pwrite);
    return no_space(file) ? -1 : original(file, data, piece(size), offset);
}

ssize_t pwrite64(int file, const void* data, std::size_t size, off64_t offset) {
    NEXT(pwrite64);
    return no_space(file) ? -1 : original(file, data, piece(size), offset);
}

ssize_t writev(int file, const iovec* pieces, int count) {
    NEXT(writev);
    return no_space(file) ? -1 : original(file, pieces, count);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, FILE* stream) {
    NEXT(fwrite);
    return no_space(::fileno(stream)) ? 0 : original(data, size, count, stream);
}

ssize_t read(int file, void* data, std::size_t size) {
    NEXT(read);
    return unreadable() ? -1 : original(file, data, piece(size));
}

ssize_t pread(int file, void* data, std::size_t size, off_t offset) {
    NEXT(pread);
    return unreadable() ? -1 : original(file, data, piece(size), offset);
}

int fsync(int file) {
    NEXT(fsync);
    return no_space() ? -1 : original(file);
}

int fdatasync(int file) {
    NEXT(fdatasync);
    return no_space() ? -1 : original(file);
}

int ftruncate(int file, off_t size) noexcept {
    NEXT(ftruncate);
    return no_space() ? -1 : original(file, size);
}

/// The descriptor is gone all the same, as POSIX has it for a close that fails.
int close(int file) {
    NEXT(close);
    const bool fault = no_space(file);
    const int done = original(file);
    if (fault)
        errno = ENOSPC;
    return fault ? -1 : done;
}

int rename(const char* from, const char* to) noexcept {
    NEXT(rename);
    return no_space() ? -1 : original(from, to);
}

int renameat(int folder, const char* from, int other, const char* to) noexcept {
    NEXT(renameat);
    return no_space() ? -1 : original(folder, from, other, to);
}

int renameat2(int folder, const char* from, int other, const char* to, unsigned flags) noexcept {
    NEXT(renameat2);
    return no_space() ? -1 : original(folder, from, other, to, flags);
}

int mkdir(const char* path, mode_t mode) noexcept {
    NEXT(mkdir);
    return no_space() ? -1 : original(path, mode);
}

char* mkdtemp(char* pattern) noexcept {
    NEXT(mkdtemp);
    return no_space() ? nullptr : original(pattern);
}

static int open_or_fail(int (*original)(const char*, int, ...), const char* path, int flags,
                        mode_t mode) {
    return (flags & O_CREAT) != 0 && no_space() ? -1 : original(path, flags, mode);
}

int open(const char* path, int flags, ...) {
    NEXT(open);
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open_or_fail(original, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    NEXT(open64);
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open_or_fail(original, path, flags, mode);
}

FILE* fopen64(const char* path, const char* mode) {
    NEXT(fopen64);
    return *mode != 'r' && no_space() ? nullptr : original(path, mode);
}

} // extern "C"
