#include "tests/fuzz/png_mutator.h"

#include <zlib.h>

#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t maxSize);

namespace fff::fuzz {

namespace {

constexpr std::size_t kSignature = 8, kLength = 4, kKind = 4, kChecksum = 4;

std::uint32_t numberAt(const std::uint8_t *data)
{
    return std::uint32_t(data[0]) << 24 | std::uint32_t(data[1]) << 16 |
           std::uint32_t(data[2]) << 8 | data[3];
}

/// Of the kind and what is in it, behind these, for each part as far as they go.
void mendChecksums(std::uint8_t *data, std::size_t size)
{
    std::size_t at = kSignature;
    while (at + kLength + kKind + kChecksum <= size) {
        const std::size_t length = numberAt(data + at);
        if (length > size - at - kLength - kKind - kChecksum)
            return;
        const std::uint8_t *part = data + at + kLength;
        const auto sum =
            static_cast<std::uint32_t>(crc32(0, part, static_cast<uInt>(kKind + length)));
        std::uint8_t *to = data + at + kLength + kKind + length;
        for (std::size_t i = 0; i < kChecksum; ++i)
            to[i] = static_cast<std::uint8_t>(sum >> (8 * (kChecksum - 1 - i)));
        at += kLength + kKind + length + kChecksum;
    }
}

} // namespace

std::size_t mutatePng(std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned int seed)
{
    const std::size_t changed = LLVMFuzzerMutate(data, size, maxSize);
    const bool isPng = changed > kSignature && std::memcmp(data, "\x89PNG\r\n\x1a\n", 8) == 0;
    if (isPng && seed % 8 != 0) // wrong ones have to be seen, too
        mendChecksums(data, changed);
    return changed;
}

} // namespace fff::fuzz
