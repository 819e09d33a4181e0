// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

#include <cerrno>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace polydec::test::in_unfinished {

namespace fs = std::filesystem;

class unfinished : public testing::Test {
protected:
    unfinished() {
        std::string name = (fs::temp_directory_path() / "unfinished-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~unfinished() override { fs::remove_all(folder_); }

    fs::path make_file(const fs::path& name) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << "text";
        return folder_ / name;
    }
    bool is_empty() const { return fs::is_empty(folder_); }

    fs::path folder_;
};

TEST_F(unfinished, a_file_goes_with_it_unless_it_is_finished) {
    const auto path = make_file("a");
    {
        Unfinished noted;
        ASSERT_TRUE(noted.note_file(path.c_str()));
        EXPECT_EQ(noted.path(), path);
        noted.finish();
    }
    EXPECT_TRUE(fs::exists(path));
    {
        Unfinished noted;
        ASSERT_TRUE(noted.note_file(path.c_str()));
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST_F(unfinished, a_folder_goes_with_all_that_is_in_it_but_not_what_links_lead_to) {
    const auto kept = make_file("kept/file");
    make_file("gone/inner/inmost/file");
    for (int i = 0; i < 500; ++i)
        make_file("gone/" + std::string(40, 'n') + std::to_string(i));
    fs::create_directory_symlink(kept.parent_path(), folder_ / "gone" / "link");
    Unfinished noted;
    ASSERT_TRUE(noted.note_folder((folder_ / "gone").c_str()));
    noted.remove();
    EXPECT_FALSE(fs::exists(folder_ / "gone"));
    EXPECT_TRUE(fs::exists(kept));
}

TEST_F(unfinished, a_signal_handler_can_remove_it_all) {
    const auto file = make_file("file");
    make_file("folder/file");
    const pid_t child = ::fork();
    if (child == 0) {
        ::setpgid(0, 0);
        for (;;)
            ::pause();
    }
    ::setpgid(child, child);
    Unfinished first, second, third;
    ASSERT_TRUE(first.note_file(file.c_str()));
    ASSERT_TRUE(second.note_folder((folder_ / "folder").c_str()));
    ASSERT_TRUE(third.note_process(child));
    const auto before = std::signal(SIGUSR1, [](int) { remove_unfinished(); });
    std::raise(SIGUSR1);
    std::signal(SIGUSR1, before);
    EXPECT_TRUE(is_empty());
    EXPECT_EQ(::kill(child, 0), -1) << "it is killed and reaped";
    third.finish();
}

/// A stack of a handler; what is below it cannot be written.
class HandlerStack {
public:
    HandlerStack() {
        const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
        size_ = removal_stack + page;
        start_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        ::mprotect(start_, page, PROT_NONE);
        stack_t stack{};
        stack.ss_sp = static_cast<char*>(start_) + page;
        stack.ss_size = removal_stack;
        ::sigaltstack(&stack, &before_);
    }
    ~HandlerStack() {
        ::sigaltstack(&before_, nullptr);
        ::munmap(start_, size_);
    }
    HandlerStack(const HandlerStack&) = delete;
    HandlerStack& operator=(const HandlerStack&) = delete;

private:
    stack_t before_{};
    void* start_;
    std::size_t size_;
};

TEST_F(unfinished, a_signal_handler_has_stack_for_folders_as_deep_as_they_are_removed) {
    fs::path inner = "folder";
    for (int i = 1; i < 64; ++i)
        inner /= "d";
    make_file(inner / "file");
    Unfinished noted;
    ASSERT_TRUE(noted.note_folder((folder_ / "folder").c_str()));
    const HandlerStack stack;
    struct sigaction action {
    }, before{};
    action.sa_handler = [](int) { remove_unfinished(); };
    action.sa_flags = SA_ONSTACK;
    ::sigaction(SIGUSR1, &action, &before);
    std::raise(SIGUSR1);
    ::sigaction(SIGUSR1, &before, nullptr);
    EXPECT_TRUE(is_empty());
}

TEST_F(unfinished, places_are_limited_and_given_back) {
    std::vector<std::unique_ptr<Unfinished>> all;
    while (all.empty() || all.back()->has_place())
        all.push_back(std::make_unique<Unfinished>());
    EXPECT_EQ(all.size(), Unfinished::most + 1);
    errno = 0;
    EXPECT_FALSE(all.back()->note_file(make_file("kept").c_str()));
    EXPECT_EQ(errno, EMFILE);
    EXPECT_FALSE(all.back()->note_folder(folder_.c_str()));
    EXPECT_FALSE(all.back()->note_process(::getpid()));
    EXPECT_STREQ(all.back()->path(), "");
    all.clear();
    EXPECT_FALSE(is_empty());
    EXPECT_TRUE(Unfinished().has_place());
}

TEST_F(unfinished, a_path_that_is_too_long_is_not_noted) {
    Unfinished noted;
    EXPECT_FALSE(noted.note_file(std::string(5000, 'n').c_str()));
    EXPECT_EQ(errno, ENAMETOOLONG);
}

} // namespace polydec::test::in_unfinished
