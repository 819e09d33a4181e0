// SPDX-License-Identifier: MIT
#include "system/unfinished.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace polydec {

namespace {

constexpr std::size_t longest_path = 4096;

// Folders within one another are removed by functions within one another, on the stack of a signal
// handler.
constexpr int deepest = 64;
constexpr std::size_t entries_size = 1024;
constexpr std::size_t all_else = 4096; // of a level, with what sanitizers add
static_assert(deepest * (entries_size + all_else) <= removal_stack);

enum State : int { is_free, is_taken, is_file, is_folder, is_process };

struct Place {
    std::atomic<int> state{is_free};
    std::atomic<int> process{0};
    std::array<char, longest_path> path{};
};
static_assert(std::atomic<int>::is_always_lock_free, "needed in signal handlers");

std::array<Place, Unfinished::most> places;

bool is_itself_or_parent(const char* name) {
    return std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0;
}

void remove_content(int folder, int depth) noexcept;

/// Whether it is gone.
bool remove_entry(int folder, const char* name, int depth) noexcept {
    if (::unlinkat(folder, name, 0) == 0)
        return true;
    const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (inner < 0)
        return false;
    remove_content(inner, depth + 1);
    ::close(inner);
    return ::unlinkat(folder, name, AT_REMOVEDIR) == 0;
}

#ifdef __linux__

/// One pass over the folder; whether something was removed, so that another one may see more.
bool remove_pass(int folder, int depth) noexcept {
    alignas(dirent64) char entries[entries_size];
    bool removed = false;
    ::lseek(folder, 0, SEEK_SET);
    for (;;) {
        const auto bytes = ::getdents64(folder, entries, sizeof entries);
        if (bytes <= 0)
            return removed;
        for (decltype(bytes + 0) at = 0; at < bytes;) {
            const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
            if (!is_itself_or_parent(entry->d_name))
                removed = remove_entry(folder, entry->d_name, depth) || removed;
            at += entry->d_reclen;
        }
    }
}

#else

// Elsewhere the list of a folder cannot be had without memory.
bool remove_pass(int folder, int depth) noexcept {
    bool removed = false;
    DIR* const list = ::fdopendir(::dup(folder));
    if (list == nullptr)
        return false;
    ::rewinddir(list);
    while (const dirent* const entry = ::readdir(list))
        if (!is_itself_or_parent(entry->d_name))
            removed = remove_entry(folder, entry->d_name, depth) || removed;
    ::closedir(list);
    return removed;
}

#endif

void remove_content(int folder, int depth) noexcept {
    while (depth < deepest && remove_pass(folder, depth)) {
    }
}

void remove_folder(const char* path) noexcept {
    const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0)
        return;
    remove_content(folder, 0);
    ::close(folder);
    ::rmdir(path);
}

void remove_noted(const Place& place) noexcept {
    const int state = place.state;
    if (state == is_file)
        ::unlink(place.path.data());
    else if (state == is_folder)
        remove_folder(place.path.data());
}

void end_process(const Place& place) noexcept {
    const int leader = place.process;
    if (place.state != is_process || leader <= 0)
        return;
    ::kill(-leader, SIGKILL);
    while (::waitpid(leader, nullptr, 0) < 0 && errno == EINTR) {
    }
}

} // namespace

Unfinished::Unfinished() noexcept : place_(most) {
    for (std::size_t i = 0; i < most && !has_place(); ++i) {
        int expected = is_free;
        if (places[i].state.compare_exchange_strong(expected, is_taken))
            place_ = i;
    }
}

Unfinished::~Unfinished() {
    remove();
}

bool Unfinished::note(int kind, const char* path) noexcept {
    if (!has_place()) {
        errno = EMFILE;
        return false;
    }
    auto& place = places[place_];
    const std::size_t length = std::strlen(path);
    if (length >= longest_path) {
        errno = ENAMETOOLONG;
        return false;
    }
    place.state = is_taken;
    std::memcpy(place.path.data(), path, length + 1);
    place.state = kind;
    return true;
}

bool Unfinished::note_file(const char* path) noexcept {
    return note(is_file, path);
}

bool Unfinished::note_folder(const char* path) noexcept {
    return note(is_folder, path);
}

bool Unfinished::note_process(int leader) noexcept {
    if (!has_place()) {
        errno = EMFILE;
        return false;
    }
    auto& place = places[place_];
    place.state = is_taken;
    place.process = leader;
    place.state = is_process;
    return true;
}

const char* Unfinished::path() const noexcept {
    return has_place() ? places[place_].path.data() : "";
}

void Unfinished::finish() noexcept {
    if (has_place())
        places[place_].state = is_free;
    place_ = most;
}

void Unfinished::remove() noexcept {
    if (has_place())
        remove_noted(places[place_]);
    finish();
}

void remove_unfinished() noexcept {
    for (const auto& place : places)
        end_process(place);
    for (const auto& place : places)
        remove_noted(place);
}

} // namespace polydec
