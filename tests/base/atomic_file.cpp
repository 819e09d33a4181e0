// SPDX-License-Identifier: MIT
#include "system/atomic_file.h"

#include "tests/io/support.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace polydec::test::in_atomic_file {

using Names = std::vector<std::string>;

/// While it lives, no file may grow beyond this size: the same as a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST(AtomicFile, AppearsWholeWithItsCommit) {
    const TemporaryFolder folder;
    AtomicFile file(folder.path("a.txt"));
    std::string expected;
    for (int i = 0; i < 300000; ++i) {
        const auto line = std::to_string(i) + "\n";
        file.write(line);
        expected += line;
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path("a.txt")));
    file.commit();
    EXPECT_EQ(folder.names(), Names{"a.txt"});
    EXPECT_EQ(read_text(folder.path("a.txt")), expected);
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
    const TemporaryFolder folder;
    folder.write("a.txt", "old");
    {
        AtomicFile file(folder.path("a.txt"));
        file.write(std::string(3000000, 'x'));
        EXPECT_EQ(folder.names().size(), 2U);
    }
    EXPECT_EQ(folder.names(), Names{"a.txt"});
    EXPECT_EQ(read_text(folder.path("a.txt")), "old");
}

TEST(AtomicFile, ReplacesAFileAndKeepsItsPermissions) {
    const TemporaryFolder folder;
    const auto path = folder.write("a.txt", "old");
    ::chmod(path.c_str(), 0604);
    AtomicFile file(path);
    file.write("new");
    file.commit();
    EXPECT_EQ(read_text(path), "new");
    struct stat status {};
    ::stat(path.c_str(), &status);
    EXPECT_EQ(status.st_mode & 0777U, 0604U);
}

TEST(AtomicFile, FollowsSymbolicLinks) {
    const TemporaryFolder folder;
    folder.write("a.txt", "old");
    std::filesystem::create_symlink("a.txt", folder.path("link.txt"));
    AtomicFile file(folder.path("link.txt"));
    file.write("new");
    file.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.txt")));
    EXPECT_EQ(read_text(folder.path("a.txt")), "new");
}

TEST(AtomicFile, FollowsSymbolicLinksToWhatIsNotThere) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("b"));
    std::filesystem::create_symlink("b/second.txt", folder.path("link.txt"));
    std::filesystem::create_symlink("../a.txt", folder.path("b/second.txt"));
    AtomicFile file(folder.path("link.txt"));
    file.write("new");
    file.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.txt")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("b/second.txt")));
    EXPECT_EQ(read_text(folder.path("a.txt")), "new");
    std::filesystem::create_symlink("no/c.txt", folder.path("lost.txt"));
    EXPECT_ERROR(IoError, AtomicFile(folder.path("lost.txt")), "lost.txt", "No such file");
    std::filesystem::create_symlink("circle.txt", folder.path("circle.txt"));
    EXPECT_ERROR(IoError, AtomicFile(folder.path("circle.txt")), "circle.txt", "symbolic links");
}

TEST(AtomicFile, NamesWithManyLettersFit) {
    const TemporaryFolder folder;
    const std::string name(255, 'n');
    AtomicFile file(folder.path(name));
    file.commit();
    EXPECT_EQ(folder.names(), Names{name});
}

TEST(AtomicFile, SaysThatTheFolderIsMissing) {
    const TemporaryFolder folder;
    const auto missing = folder.path("out");
    EXPECT_ERROR(IoError, AtomicFile(missing / "a.txt"), (missing / "a.txt").string(),
                 "No such file", missing.string());
}

TEST(AtomicFile, RefusesFoldersAndDevices) {
    const TemporaryFolder folder;
    EXPECT_ERROR(IoError, AtomicFile(folder.path()), folder.path().string(), "regular file");
    EXPECT_ERROR(IoError, AtomicFile("/dev/null"), "/dev/null", "regular file");
}

TEST(AtomicFile, AReadOnlyFileStays) {
    const TemporaryFolder folder;
    const auto path = folder.write("a.txt", "precious");
    std::filesystem::create_symlink("a.txt", folder.path("link.txt"));
    ::chmod(path.c_str(), 0444);
    for (const auto& name : {path, folder.path("link.txt")})
        EXPECT_ERROR(IoError, AtomicFile(name).commit(), name.string(), "read-only");
    EXPECT_EQ(read_text(path), "precious");
    EXPECT_EQ(folder.names(), (Names{"a.txt", "link.txt"}));
    ::chmod(path.c_str(), 0644);
    AtomicFile(path).commit();
    EXPECT_EQ(read_text(path), "");
}

TEST(AtomicFile, SaysThatThereIsNoRoom) {
    const TemporaryFolder folder;
    const auto path = folder.path("a.txt");
    const FileSizeLimit limit(1000);
    EXPECT_SAYS(error_of([&path] {
                    AtomicFile file(path);
                    file.write(std::string(2000, 'x'));
                    file.commit();
                }),
                "IoError", path.string(), "File too large");
    EXPECT_TRUE(folder.names().empty());
}

TEST(AtomicFile, ASignalHandlerCanRemoveUnfinishedFiles) {
    const TemporaryFolder folder;
    AtomicFile done(folder.path("done.txt"));
    done.commit();
    const AtomicFile first(folder.path("first.txt"));
    const AtomicFile second(folder.path("second.txt"));
    EXPECT_EQ(folder.names().size(), 3U);
    std::signal(SIGUSR1, [](int) { remove_unfinished(); });
    std::raise(SIGUSR1);
    std::signal(SIGUSR1, SIG_DFL);
    EXPECT_EQ(folder.names(), Names{"done.txt"});
}

TEST(AtomicFile, RefusesMoreThanItCanRemove) {
    const TemporaryFolder folder;
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (int i = 0; i < 64; ++i)
        files.push_back(std::make_unique<AtomicFile>(folder.path(std::to_string(i))));
    const auto path = folder.path("a.txt");
    EXPECT_ERROR(IoError, AtomicFile file(path), path.string(), "64 files");
    files.clear();
    EXPECT_TRUE(folder.names().empty());
    AtomicFile(path).commit();
}

} // namespace polydec::test::in_atomic_file
