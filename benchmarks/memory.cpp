// SPDX-License-Identifier: MIT
#include "benchmarks/memory.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <malloc.h>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define POLYDEC_COUNTS_MEMORY 1
#else
#define POLYDEC_COUNTS_MEMORY 0
#endif

namespace {

// Constant-initialized: malloc is called before any constructor runs.
std::atomic<std::size_t> live{0};
std::atomic<std::size_t> peak{0};

} // namespace

#if POLYDEC_COUNTS_MEMORY

namespace {

void* counted(void* block) {
    const std::size_t size = malloc_usable_size(block);
    const std::size_t now = live.fetch_add(size, std::memory_order_relaxed) + size;
    std::size_t highest = peak.load(std::memory_order_relaxed);
    while (now > highest && !peak.compare_exchange_weak(highest, now, std::memory_order_relaxed)) {
    }
    return block;
}

void forget(void* block) {
    live.fetch_sub(malloc_usable_size(block), std::memory_order_relaxed);
}

} // namespace

extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept {
    return counted(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return counted(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) noexcept {
    const std::size_t before = malloc_usable_size(block);
    void* const moved = __libc_realloc(block, size);
    if (moved || size == 0)
        live.fetch_sub(before, std::memory_order_relaxed);
    return counted(moved);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return counted(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    *block = memalign(alignment, size);
    return *block ? 0 : ENOMEM;
}

void free(void* block) noexcept {
    forget(block);
    __libc_free(block);
}

} // extern "C"

#endif

namespace polydec::benchmarks {

bool counts_memory() {
    return POLYDEC_COUNTS_MEMORY != 0;
}

double live_bytes() {
    return static_cast<double>(live.load());
}

double peak_bytes() {
    return static_cast<double>(peak.load());
}

void forget_peak() {
    peak.store(live.load());
}

} // namespace polydec::benchmarks
