// Several files packed into one, as ZIP. Internal to io.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

// What an archive may hold, so that none can fill the memory. Sizes are of what is unpacked, in
// bytes.
inline constexpr std::size_t kMostEntries = 10'000;
inline constexpr std::size_t kMostEntryBytes = std::size_t(256) << 20;
inline constexpr std::size_t kMostUnpackedBytes = std::size_t(512) << 20; // of all entries
/// Bytes that one packed byte may stand for; deflate has no more than 1032. What a person draws or
/// photographs stays far below.
inline constexpr std::size_t kMostRatio = 200;
inline constexpr std::size_t kSmallEntryBytes = std::size_t(1) << 20; // which may have any ratio

struct ArchiveEntry
{
    std::string name; // within the archive
    std::string bytes;
};

/// What errors call one: its name may be anything, also nothing.
std::string placeOfEntry(const std::string &archive, const std::string &entry);

/// By the first bytes, whatever the file is called.
bool isArchive(std::string_view bytes);

struct PackedEntry
{
    std::string name; // ASCII
    std::string_view bytes;
};

/// In the given order; with neither time nor owner, so that the same entries make the same bytes.
/// Packed with deflate where that makes them smaller, and not beyond kMostRatio.
/// Errors  BadCount beyond what an archive may hold.
Result<std::string> packed(std::span<const PackedEntry> entries);

/// The names of all entries as they are listed, whatever they are. Errors  as unpacked().
Result<std::vector<std::string>> entryNames(std::string_view bytes, const std::string &place);

/// All entries in the archive's order. Nothing that the archive says of itself is relied on: bytes
/// are counted while they are unpacked.
///
/// place   how errors call the file; those of an entry are at place:NAME
/// Errors  BadArchive  a list of entries that is damaged; bytes beside the archive; an entry that
/// is there twice, encrypted,
///                     packed in an unknown way, damaged, or called otherwise than the list says,
///                     or that has more than kMostRatio bytes a packed one; entries that share
///                     bytes
///         BadCount    more entries or bytes than the limits above
Result<std::vector<ArchiveEntry>> unpacked(std::string_view bytes, const std::string &place);

} // namespace fff::io
