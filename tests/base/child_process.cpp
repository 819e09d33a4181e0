// SPDX-License-Identifier: MIT
#include "system/child_process.h"

#include "system/held_signals.h"
#include "system/temporary_folder.h"
#include "tests/support/test.h"

#include <pthread.h>
#include <thread>
#include <unistd.h>

namespace polydec::test::in_child_process {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using polydec::TemporaryFolder; // not the one of tests

constexpr std::size_t megabyte = std::size_t{1} << 20;
volatile std::sig_atomic_t delivered = 0;

extern "C" void note(int) {
    delivered = 1;
}

/// Notes SIGTERM instead of dying of it.
class NotedSignals {
public:
    NotedSignals() : before_(std::signal(SIGTERM, note)) { delivered = 0; }
    ~NotedSignals() { std::signal(SIGTERM, before_); }
    NotedSignals(const NotedSignals&) = delete;
    NotedSignals& operator=(const NotedSignals&) = delete;

private:
    void (*before_)(int);
};

class ChildProcess : public testing::Test {
protected:
    ChildOutcome shell(const std::string& script, const ChildLimits& limits = {}) const {
        return run_child("/bin/sh", {"-c", script}, folder(), limits);
    }
    const fs::path& folder() const { return folder_.path(); }

private:
    TemporaryFolder folder_;
};

std::string start_failure(const fs::path& program, const fs::path& folder) {
    return message_of<IoError>([&] { run_child(program, {}, folder); });
}

TEST_F(ChildProcess, exit_code_and_both_outputs_come_back) {
    const auto outcome = shell("echo out; echo err >&2; exit 7");
    EXPECT_EQ(outcome.end, ChildEnd::exited);
    EXPECT_EQ(outcome.code, 7);
    EXPECT_EQ(outcome.output, "out\nerr\n");
}

TEST_F(ChildProcess, arguments_arrive_as_they_are_without_a_shell) {
    const std::string odd = "$HOME; `id` 'x' \"y\" *\n";
    EXPECT_EQ(run_child("/bin/sh", {"-c", "printf %s \"$1\"", "sh", odd}, folder()).output, odd);
}

TEST_F(ChildProcess, it_runs_in_the_folder_and_reads_nothing) {
    EXPECT_EQ(shell("cat; pwd -P").output, fs::canonical(folder()).string() + "\n");
}

TEST_F(ChildProcess, death_by_a_signal_is_told) {
    const auto outcome = shell("kill -SEGV $$");
    EXPECT_EQ(outcome.end, ChildEnd::signaled);
    EXPECT_EQ(outcome.code, SIGSEGV);
    EXPECT_TRUE(fs::is_empty(folder())) << "a core file";
}

TEST_F(ChildProcess, it_is_stopped_when_its_time_is_over) {
    const auto begin = std::chrono::steady_clock::now();
    const auto outcome = shell("echo begun; exec sleep 60", {.seconds = 0.2});
    EXPECT_EQ(outcome.end, ChildEnd::timed_out);
    EXPECT_EQ(outcome.output, "begun\n");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

TEST_F(ChildProcess, what_it_started_is_stopped_with_it) {
    const std::string late = "(sleep 0.4; touch late) & ";
    shell(late + "sleep 60", {.seconds = 0.1});
    shell(late + "exit 0");
    std::this_thread::sleep_for(800ms);
    EXPECT_FALSE(fs::exists(folder() / "late"));

    shell(late + "wait"); // and is not, if it has the time
    EXPECT_TRUE(fs::exists(folder() / "late"));
}

TEST_F(ChildProcess, memory_is_limited) {
    // one line, which tail has to keep: more than this program has, sanitizers and MPI included
    const std::string greedy = "head -c 800000000 /dev/zero | tail > /dev/null";
    const auto outcome = shell(greedy, {.bytes = 64 * megabyte});
    EXPECT_NE(outcome.code, 0);
    EXPECT_LE(outcome.peak_bytes, 64 * megabyte);

    const auto free = shell(greedy);
    EXPECT_EQ(free.code, 0);
    EXPECT_GT(free.peak_bytes, 100 * megabyte);
}

TEST_F(ChildProcess, the_length_of_its_files_is_limited) {
    const auto write = [&](const ChildLimits& limits) {
        shell("head -c 70000000 /dev/zero > file", limits);
        return fs::file_size(folder() / "file");
    };
    EXPECT_EQ(write({.bytes = 64 * megabyte}), 64 * megabyte);
    EXPECT_EQ(write({}), 70000000U);
}

TEST_F(ChildProcess, of_much_output_the_beginning_is_kept) {
    const auto outcome = shell("echo first; head -c 3000000 /dev/zero; exit 5", {});
    EXPECT_EQ(outcome.code, 5);
    EXPECT_EQ(outcome.output.size(), ChildLimits{}.output_bytes);
    EXPECT_EQ(outcome.output.substr(0, 6), "first\n");
}

TEST_F(ChildProcess, output_may_end_long_before_the_program) {
    const auto outcome = shell("exec >&- 2>&-; sleep 0.2; exit 3");
    EXPECT_EQ(outcome.end, ChildEnd::exited);
    EXPECT_EQ(outcome.code, 3);
}

TEST_F(ChildProcess, what_cannot_be_started_is_an_error_that_says_why) {
    EXPECT_SAYS(start_failure("/no/program", folder()), "/no/program", "No such file");
    EXPECT_SAYS(start_failure("/bin/sh", folder() / "none"), "/bin/sh", "No such file");
    std::ofstream(folder() / "plain") << "text";
    EXPECT_SAYS(start_failure(folder() / "plain", folder()), (folder() / "plain").string(),
                "Permission");
}

TEST_F(ChildProcess, a_signal_to_end_stops_it_and_is_delivered_afterwards) {
    const NotedSignals noted;
    const auto here = ::pthread_self();
    std::thread sender([here] {
        std::this_thread::sleep_for(100ms);
        ::pthread_kill(here, SIGTERM);
    });
    {
        const HeldSignals held;
        EXPECT_EQ(shell("exec sleep 60").end, ChildEnd::interrupted);
        EXPECT_TRUE(held.arrived());
        EXPECT_EQ(delivered, 0);
    }
    EXPECT_EQ(delivered, 1);
    sender.join();
}

TEST_F(ChildProcess, held_signals_that_are_ignored_stay_ignored) {
    const auto before = std::signal(SIGHUP, SIG_IGN);
    {
        const HeldSignals held;
        std::raise(SIGHUP);
        EXPECT_FALSE(held.arrived());
    }
    std::signal(SIGHUP, before);
}

TEST_F(ChildProcess, its_own_signals_are_not_held) {
    const HeldSignals held;
    EXPECT_EQ(shell("kill -TERM $$").code, SIGTERM);
    EXPECT_FALSE(held.arrived());
}

TEST_F(ChildProcess, a_broken_pipe_ends_it_though_this_program_ignores_it) {
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    EXPECT_EQ(shell("kill -PIPE $$; exit 5").code, SIGPIPE);
    std::signal(SIGPIPE, before);
}

TEST_F(ChildProcess, programs_are_found_on_the_path) {
    EXPECT_TRUE(find_program("sh").has_value());
    EXPECT_FALSE(find_program("no-such-program").has_value());
}

TEST(TemporaryFolder, it_is_private_and_goes_with_all_that_is_in_it) {
    fs::path path;
    {
        const TemporaryFolder folder;
        path = folder.path();
        fs::create_directory(path / "inner");
        std::ofstream(path / "inner" / "file") << "text";
        EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
    }
    EXPECT_FALSE(fs::exists(path));
}

} // namespace polydec::test::in_child_process
