// ZIP archives byte by byte, so that a test can say in them what no program would.
#pragma once

#include <QtCore/QByteArray>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fff::test {

inline std::uint32_t crc32Of(std::string_view bytes)
{
    std::uint32_t crc = ~0u;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

/// Without zlib's head and check sum, as ZIP has it.
inline std::string deflated(const std::string &bytes)
{
    constexpr qsizetype kBefore = 4 + 2, kBehind = 4; // Qt's count and zlib's head; its check sum
    const QByteArray all = qCompress(QByteArray::fromStdString(bytes), 9);
    return all.mid(kBefore, all.size() - kBefore - kBehind).toStdString();
}

/// One entry; what is said of it may be untrue.
struct MadeEntry
{
    std::string name, packed;
    std::uint32_t crc = 0;
    std::uint64_t size = 0; // unpacked
    std::uint16_t method = 0, flags = 0;
    std::optional<std::uint64_t> packedSize = std::nullopt;
    std::optional<std::size_t> sameAs = std::nullopt;  // has no bytes of its own, but this one's
    std::optional<std::string> ownName = std::nullopt; // before its bytes, other than in the list
    std::optional<std::uint16_t> ownFlags = std::nullopt;

    static MadeEntry stored(std::string name, const std::string &bytes)
    {
        return {std::move(name), bytes, crc32Of(bytes), bytes.size()};
    }
    static MadeEntry packedOf(std::string name, const std::string &bytes)
    {
        return {std::move(name), deflated(bytes), crc32Of(bytes), bytes.size(), 8};
    }
};

class MadeArchive
{
public:
    /// count: of entries, as the end says.
    static std::string of(const std::vector<MadeEntry> &entries,
                          std::optional<std::uint64_t> count = std::nullopt,
                          const std::string &comment = {})
    {
        MadeArchive archive;
        std::vector<std::uint64_t> places;
        for (const MadeEntry &entry : entries)
            places.push_back(entry.sameAs ? places[*entry.sameAs] : archive.addLocal(entry));
        const std::uint64_t start = archive.m_bytes.size();
        for (std::size_t i = 0; i < entries.size(); ++i)
            archive.addListed(entries[i], places[i]);
        archive.addEnd(start, count.value_or(entries.size()), comment);
        return archive.m_bytes;
    }

private:
    static constexpr std::uint64_t kLarge = std::numeric_limits<std::uint32_t>::max();

    void put(std::uint64_t value, int bytes)
    {
        for (int i = 0; i < bytes; ++i)
            m_bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    }
    static std::uint64_t packedSize(const MadeEntry &entry)
    {
        return entry.packedSize.value_or(entry.packed.size());
    }
    /// Each of the two sizes that 32 bits do not hold stands behind the name.
    static std::uint64_t largeSizes(const MadeEntry &entry)
    {
        return (entry.size >= kLarge ? 1u : 0u) + (packedSize(entry) >= kLarge ? 1u : 0u);
    }
    /// What both headers have: version, flags, method, time, date, check sum, sizes, lengths.
    void putCommon(const MadeEntry &entry)
    {
        put(largeSizes(entry) > 0 ? 45 : 20, 2);
        put(entry.flags, 2);
        put(entry.method, 2);
        put(0, 2);
        put(0x21, 2);
        put(entry.crc, 4);
        put(std::min(packedSize(entry), kLarge), 4);
        put(std::min(entry.size, kLarge), 4);
        put(entry.name.size(), 2);
        put(largeSizes(entry) > 0 ? 4 + 8 * largeSizes(entry) : 0, 2);
    }
    void putLargeSizes(const MadeEntry &entry)
    {
        if (largeSizes(entry) == 0)
            return;
        put(1, 2);
        put(8 * largeSizes(entry), 2);
        if (entry.size >= kLarge)
            put(entry.size, 8);
        if (packedSize(entry) >= kLarge)
            put(packedSize(entry), 8);
    }
    std::uint64_t addLocal(const MadeEntry &entry)
    {
        const std::uint64_t place = m_bytes.size();
        put(0x04034b50, 4);
        MadeEntry itself = entry;
        itself.name = entry.ownName.value_or(entry.name);
        itself.flags = entry.ownFlags.value_or(entry.flags);
        putCommon(itself);
        m_bytes += itself.name;
        putLargeSizes(entry);
        m_bytes += entry.packed;
        return place;
    }
    void addListed(const MadeEntry &entry, std::uint64_t place)
    {
        put(0x02014b50, 4);
        put(45, 2);
        putCommon(entry);
        put(0, 2); // comment
        put(0, 2); // disk
        put(0, 2);
        put(0, 4);
        put(place, 4);
        m_bytes += entry.name;
        putLargeSizes(entry);
    }
    void addEnd(std::uint64_t start, std::uint64_t count, const std::string &comment)
    {
        const std::uint64_t size = m_bytes.size() - start;
        const bool isMany = count > std::numeric_limits<std::uint16_t>::max();
        if (isMany) {
            const std::uint64_t end = m_bytes.size();
            put(0x06064b50, 4);
            put(44, 8);
            put(45, 2);
            put(45, 2);
            put(0, 4);
            put(0, 4);
            put(count, 8);
            put(count, 8);
            put(size, 8);
            put(start, 8);
            put(0x07064b50, 4);
            put(0, 4);
            put(end, 8);
            put(1, 4);
        }
        put(0x06054b50, 4);
        put(0, 2);
        put(0, 2);
        put(isMany ? 0xFFFF : count, 2);
        put(isMany ? 0xFFFF : count, 2);
        put(isMany ? kLarge : size, 4);
        put(isMany ? kLarge : start, 4);
        put(comment.size(), 2);
        m_bytes += comment;
    }

    std::string m_bytes;
};

} // namespace fff::test
