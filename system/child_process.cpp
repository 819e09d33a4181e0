// SPDX-License-Identifier: MIT
#include "system/child_process.h"

#include "base/errors.h"
#include "system/descriptor.h"
#include "system/held_signals.h"
#include "system/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace polydec {

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::milliseconds;

[[noreturn]] void refuse(const std::filesystem::path& program, int reason) {
    throw IoError(fmt::format("cannot run {}: {}", program.string(),
                              std::generic_category().message(reason)));
}

struct Pipe {
    Descriptor read, write;
};

/// Off the numbers 0 to 2, which the child fills anew, and closed in the child by exec.
Descriptor moved_up(int number) {
    const int moved = ::fcntl(number, F_DUPFD_CLOEXEC, 3);
    ::close(number);
    return Descriptor(moved);
}

Pipe make_pipe(const std::filesystem::path& program) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0)
        refuse(program, errno);
    Pipe pipe{moved_up(ends[0]), moved_up(ends[1])};
    if (pipe.read.number() < 0 || pipe.write.number() < 0)
        refuse(program, errno);
    return pipe;
}

void limit(decltype(RLIMIT_AS) resource, std::size_t most) {
    const rlimit both{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
    ::setrlimit(resource, &both);
}

/// What the child needs, made before the fork: afterwards no memory may be allocated.
struct Start {
    const char* program;
    char* const* arguments;
    const char* folder;
    std::size_t bytes;
    int output, report;
};

/// Signals are as they were for this program at its start, except that a broken pipe ends the
/// child.
void forget_handlers() {
    for (int signal = 1; signal < NSIG; ++signal) {
        struct sigaction action {};
        const bool is_known = ::sigaction(signal, nullptr, &action) == 0;
        if (is_known && (action.sa_handler != SIG_IGN || signal == SIGPIPE)) {
            action = {};
            action.sa_handler = SIG_DFL;
            ::sigaction(signal, &action, nullptr);
        }
    }
}

/// All signals wait while a child comes to be, so that it never runs a handler of this program,
/// which would remove what is not the child's.
class NoSignals {
public:
    NoSignals() noexcept {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~NoSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    NoSignals(const NoSignals&) = delete;
    NoSignals& operator=(const NoSignals&) = delete;

private:
    sigset_t before_;
};

/// The new process becomes the program; what hinders it goes into the report.
[[noreturn]] void become(const Start& start, pid_t parent) {
    ::setpgid(0, 0);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent)
        ::_exit(127); // it ended before it was asked for
#else
    static_cast<void>(parent);
#endif
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, start.bytes);
    limit(RLIMIT_AS, start.bytes);

    const int nothing = ::open("/dev/null", O_RDONLY);
    const bool ready = nothing >= 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
                       ::dup2(start.output, STDOUT_FILENO) >= 0 &&
                       ::dup2(start.output, STDERR_FILENO) >= 0 && ::chdir(start.folder) == 0;
    if (ready) {
        forget_handlers();
        sigset_t none;
        sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        ::execv(start.program, start.arguments);
    }
    const int reason = errno;
    static_cast<void>(!::write(start.report, &reason, sizeof reason));
    ::_exit(127);
}

/// A process that runs; killed with its whole group, and reaped, unless that is done.
class Child {
public:
    Child() = default;
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() { reap(); }

    bool can_start() const { return noted_.has_place(); }
    void start(pid_t id) {
        id_ = id;
        noted_.note_process(id);
    }

    /// Not yet reaped, so that its number cannot be given to another group before that is killed.
    bool has_ended() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
               info.si_pid == id_;
    }

    /// Status and use of memory; false if the system does not tell, because SIGCHLD is ignored.
    bool reap(int* status = nullptr, rusage* usage = nullptr) {
        if (id_ < 0)
            return false;
        ::kill(-id_, SIGKILL);
        noted_.finish(); // its number may be another's once it is reaped
        pid_t reaped = -1;
        do {
            reaped = ::wait4(id_, status, 0, usage);
        } while (reaped < 0 && errno == EINTR);
        id_ = -1;
        return reaped >= 0;
    }

private:
    Unfinished noted_;
    pid_t id_ = -1;
};

void fork_into(Child& child, const Start& start, const std::filesystem::path& program) {
    const NoSignals quiet;
    const pid_t parent = ::getpid();
    const pid_t id = ::fork();
    if (id < 0)
        refuse(program, errno);
    if (id == 0)
        become(start, parent);
    child.start(id);
}

/// Reads what is there; false at the end.
bool read_some(int file, std::string& text, std::size_t most) {
    std::array<char, 4096> buffer;
    while (true) {
        const auto count = ::read(file, buffer.data(), buffer.size());
        if (count > 0) {
            const auto room = most - std::min(most, text.size());
            text.append(buffer.data(), std::min(room, static_cast<std::size_t>(count)));
        } else if (count == 0 || errno != EINTR) {
            return count < 0 && errno == EAGAIN;
        }
    }
}

/// Gathers the output until the program ends or has to.
ChildEnd watch(const Child& child, int output, std::string& text, const ChildLimits& limits,
               const HeldSignals& held) {
    const auto last = Clock::now() + std::chrono::duration<double>(limits.seconds);
    constexpr Milliseconds glance{20};
    bool is_open = true;
    while (true) {
        const bool ended = child.has_ended(); // asked before reading, so that nothing is missed
        if (is_open)
            is_open = read_some(output, text, limits.output_bytes);
        if (ended)
            return ChildEnd::exited;
        if (held.arrived())
            return ChildEnd::interrupted;
        if (Clock::now() >= last)
            return ChildEnd::timed_out;
        const auto left = std::chrono::duration_cast<Milliseconds>(last - Clock::now());
        const auto pause = std::clamp(left, Milliseconds{1}, glance);
        pollfd file{output, POLLIN, 0};
        if (is_open)
            ::poll(&file, 1, static_cast<int>(pause.count()));
        else
            std::this_thread::sleep_for(Milliseconds{1});
    }
}

/// A program that could not be started says why; exec closes the pipe of one that could.
void check_start(int report, const std::filesystem::path& program) {
    int reason = 0;
    ssize_t count = -1;
    do {
        count = ::read(report, &reason, sizeof reason);
    } while (count < 0 && errno == EINTR);
    if (count == static_cast<ssize_t>(sizeof reason))
        refuse(program, reason);
}

/// The system counts what the child had as a copy of this program, before it became another.
std::size_t peak_bytes(const rusage& child) {
    rusage own{};
    ::getrusage(RUSAGE_SELF, &own);
    constexpr std::size_t unit = 1024;
    return child.ru_maxrss > own.ru_maxrss ? static_cast<std::size_t>(child.ru_maxrss) * unit : 0;
}

} // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable == nullptr ? "" : variable;
    while (!folders.empty()) {
        const auto end = folders.find(':');
        const std::filesystem::path folder(folders.substr(0, end));
        folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);

        // an empty entry means the current folder, where nothing should be run from unasked
        const auto path = folder / name;
        std::error_code ignored;
        if (!folder.empty() && std::filesystem::is_regular_file(path, ignored) &&
            ::access(path.c_str(), X_OK) == 0)
            return std::filesystem::absolute(path, ignored);
    }
    return std::nullopt;
}

ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments,
                       const std::filesystem::path& folder, const ChildLimits& limits) {
    const HeldSignals held;
    Pipe output = make_pipe(program);
    Pipe report = make_pipe(program);
    ::fcntl(output.read.number(), F_SETFL, O_NONBLOCK);

    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (auto& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const Start start{program.c_str(), pointers.data(),       folder.c_str(),
                      limits.bytes,    output.write.number(), report.write.number()};
    Child child;
    if (!child.can_start())
        refuse(program, EAGAIN);
    fork_into(child, start, program);
    output.write.close();
    report.write.close();
    check_start(report.read.number(), program);

    ChildOutcome outcome;
    outcome.end = watch(child, output.read.number(), outcome.output, limits, held);
    int status = 0;
    rusage usage{};
    if (!child.reap(&status, &usage))
        throw IoError(fmt::format("the system did not report how {} ended: do not ignore SIGCHLD",
                                  program.string()));
    outcome.peak_bytes = peak_bytes(usage);
    if (outcome.end == ChildEnd::exited && WIFSIGNALED(status))
        outcome.end = ChildEnd::signaled;
    outcome.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return outcome;
}

} // namespace polydec
