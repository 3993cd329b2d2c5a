#include "tests/bench/counted_memory.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

// One a thread, which alone writes it. Pools begin and end threads all day.
constexpr std::size_t kThreads = 1u << 16;
std::array<std::atomic<std::int64_t>, kThreads> counts;
std::atomic<std::size_t> threads = 0;

std::atomic<std::int64_t> &ownCount()
{
    thread_local std::atomic<std::int64_t> &count = counts[threads++ % kThreads];
    return count;
}

void add(std::int64_t bytes)
{
    std::atomic<std::int64_t> &count = ownCount();
    count.store(count.load(std::memory_order_relaxed) + bytes, std::memory_order_relaxed);
}

// Before each block stands its size, in as many bytes as keep the block's alignment.
constexpr std::size_t kHeader = alignof(std::max_align_t);
static_assert(kHeader >= sizeof(std::size_t));

} // namespace

std::int64_t fff::bench::liveBytes()
{
    return ownCount().load(std::memory_order_relaxed);
}

std::int64_t fff::bench::liveBytesOfAll()
{
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < std::min(threads.load(), kThreads); ++i)
        sum += counts[i].load(std::memory_order_relaxed);
    return sum;
}

void *operator new(std::size_t size)
{
    void *block = std::malloc(size + kHeader);
    if (!block)
        throw std::bad_alloc();
    *static_cast<std::size_t *>(block) = size;
    add(static_cast<std::int64_t>(size));
    return static_cast<char *>(block) + kHeader;
}

void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    try {
        return ::operator new(size);
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}

void *operator new[](std::size_t size, const std::nothrow_t &) noexcept
{
    return ::operator new(size, std::nothrow);
}

void operator delete(void *pointer) noexcept
{
    if (!pointer)
        return;
    void *block = static_cast<char *>(pointer) - kHeader;
    add(-static_cast<std::int64_t>(*static_cast<std::size_t *>(block)));
    std::free(block);
}

void operator delete(void *pointer, std::size_t) noexcept
{
    ::operator delete(pointer);
}

void *operator new[](std::size_t size)
{
    return ::operator new(size);
}

void operator delete[](void *pointer) noexcept
{
    ::operator delete(pointer);
}

void operator delete[](void *pointer, std::size_t) noexcept
{
    ::operator delete(pointer);
}
