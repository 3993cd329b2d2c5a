#include "tests/bench/counted_memory.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local std::int64_t live = 0;

// Before each block stands its size, in as many bytes as keep the block's alignment.
constexpr std::size_t kHeader = alignof(std::max_align_t);
static_assert(kHeader >= sizeof(std::size_t));

} // namespace

std::int64_t fff::bench::liveBytes()
{
    return live;
}

void *operator new(std::size_t size)
{
    void *block = std::malloc(size + kHeader);
    if (!block)
        throw std::bad_alloc();
    *static_cast<std::size_t *>(block) = size;
    live += static_cast<std::int64_t>(size);
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
    live -= static_cast<std::int64_t>(*static_cast<std::size_t *>(block));
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
