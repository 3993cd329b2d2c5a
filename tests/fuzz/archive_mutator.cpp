#include "tests/fuzz/archive_mutator.h"

#include "core/io/archive.h"
#include "core/io/blobs.h"
#include "tests/fuzz/json_mutator.h"

#include <algorithm>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t maxSize);

namespace fff::fuzz {

namespace {

using Entries = std::vector<io::ArchiveEntry>;
using Random = std::minstd_rand;

std::string nameOf(const std::string &bytes)
{
    return "blobs/" + io::sha256Of(bytes);
}

/// What comes out of a mutator that works on a buffer.
template <class Mutate>
void change(std::string &text, std::size_t maxSize, Mutate mutate)
{
    const std::size_t size = text.size();
    text.resize(std::max(maxSize, size));
    text.resize(mutate(reinterpret_cast<std::uint8_t *>(text.data()), size, text.size()));
}

Entries withBlob(std::string text, Random &random)
{
    const std::string bytes(random() % 16, static_cast<char>('a' + random() % 4));
    const std::size_t brace = text.find('{');
    if (brace != std::string::npos && random() % 8 != 0)
        text.insert(brace + 1, "\"blobs\": [{\"sha256\": \"" + io::sha256Of(bytes) + "\"}],");
    return {{"document.json", std::move(text)}, {nameOf(bytes), bytes}};
}

void changeEntry(Entries &entries, std::size_t maxSize, Random &random)
{
    const std::size_t index = random() % entries.size();
    io::ArchiveEntry &entry = entries[index];
    const auto bytes = [&](std::string &text) { change(text, maxSize, LLVMFuzzerMutate); };
    switch (random() % 8) {
    case 0:
        bytes(entry.name);
        std::replace(entry.name.begin(), entry.name.end(), '\0', '0');
        break;
    case 1:
        entries.push_back(entry);
        break;
    case 2:
        entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(index));
        break;
    case 3:
        bytes(entry.bytes);
        break;
    default:
        if (index == 0) {
            change(entry.bytes, maxSize,
                   [&](std::uint8_t *data, std::size_t size, std::size_t most) {
                       return mutateJson(data, size, most, static_cast<unsigned>(random()));
                   });
        } else {
            bytes(entry.bytes);
            entry.name = nameOf(entry.bytes);
        }
    }
}

} // namespace

std::size_t mutateFff(std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned int seed)
{
    Random random(seed);
    random.discard(4); // its first numbers follow the seed
    std::string text(reinterpret_cast<const char *>(data), size);
    Entries entries;
    if (io::isArchive(text)) {
        if (Result<Entries> unpacked = io::unpacked(text, {}))
            entries = *std::move(unpacked);
        if (entries.empty() || random() % 4 == 0)
            return LLVMFuzzerMutate(data, size, maxSize);
        changeEntry(entries, maxSize, random);
    } else if (random() % 16 == 0) {
        entries = withBlob(std::move(text), random);
    } else {
        return mutateJson(data, size, maxSize, seed);
    }
    std::vector<io::PackedEntry> views;
    for (const io::ArchiveEntry &entry : entries)
        views.push_back({entry.name, entry.bytes});
    const Result<std::string> packed = io::packed(views);
    if (!packed || packed->size() > maxSize)
        return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, packed->data(), packed->size());
    return packed->size();
}

} // namespace fff::fuzz
