#include "core/io/archive.h"

#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include <minizip/unzip.h>
#include <minizip/zip.h>

namespace fff::io {

namespace {

constexpr std::size_t kChunk = 1 << 16;         // bytes unpacked at a time
constexpr std::size_t kLongestName = 255;       // bytes
constexpr uLong kFirstDay = (1 << 5 | 1) << 16; // 1 January 1980, the first that ZIP knows

/// What minizip reads from and writes to, in place of a file.
struct Memory
{
    std::string_view read;
    std::string written;
    std::size_t at = 0;
    bool isWritten = false;
    bool isShort = false; // there was less than was to be read; minizip takes that for zeros else

    std::size_t size() const { return isWritten ? written.size() : read.size(); }

    static Memory &of(voidpf opaque) { return *static_cast<Memory *>(opaque); }
};

uLong readSome(voidpf opaque, voidpf, void *to, uLong size)
{
    Memory &memory = Memory::of(opaque);
    const std::size_t count = std::min<std::size_t>(size, memory.read.size() - memory.at);
    std::memcpy(to, memory.read.data() + memory.at, count);
    memory.at += count;
    memory.isShort = count < size;
    return static_cast<uLong>(count);
}

uLong writeSome(voidpf opaque, voidpf, const void *from, uLong size)
{
    Memory &memory = Memory::of(opaque);
    memory.written.resize(std::max(memory.written.size(), memory.at + size));
    std::memcpy(memory.written.data() + memory.at, from, size);
    memory.at += size;
    return size;
}

long seekTo(voidpf opaque, voidpf, ZPOS64_T offset, int origin)
{
    Memory &memory = Memory::of(opaque);
    const ZPOS64_T from = origin == ZLIB_FILEFUNC_SEEK_CUR   ? memory.at
                          : origin == ZLIB_FILEFUNC_SEEK_END ? memory.size()
                                                             : 0;
    // The sum may run over: where it ends up has to be inside all the same.
    const ZPOS64_T to = from + offset;
    if (to > memory.size())
        return -1;
    memory.at = static_cast<std::size_t>(to);
    return 0;
}

zlib_filefunc64_def functionsOf(Memory &memory)
{
    zlib_filefunc64_def functions = {};
    functions.zopen64_file = [](voidpf opaque, const void *, int) { return opaque; };
    functions.zread_file = readSome;
    functions.zwrite_file = writeSome;
    functions.ztell64_file = [](voidpf opaque, voidpf) { return ZPOS64_T(Memory::of(opaque).at); };
    functions.zseek64_file = seekTo;
    functions.zclose_file = [](voidpf, voidpf) { return 0; };
    functions.zerror_file = [](voidpf opaque, voidpf) { return int(Memory::of(opaque).isShort); };
    functions.opaque = &memory;
    return functions;
}

tl::unexpected<Error> bad(const std::string &place, const char *what)
{
    return failure(ErrorCode::BadArchive, place, {what});
}

tl::unexpected<Error> tooMany(const std::string &place, std::uint64_t count, std::size_t most,
                              const char *of)
{
    return failure(ErrorCode::BadCount, place, {std::to_string(count), std::to_string(most), of});
}

constexpr const char *kBytes = QT_TRANSLATE_NOOP("Error", "bytes");
constexpr const char *kEntries = QT_TRANSLATE_NOOP("Error", "entries");
constexpr const char *kListDamaged = QT_TRANSLATE_NOOP("Error", "its list of contents is damaged");
constexpr const char *kDamaged = QT_TRANSLATE_NOOP("Error", "this entry is damaged");
constexpr const char *kEncrypted = QT_TRANSLATE_NOOP("Error", "this entry is encrypted");

/// What stands beside the archive would be gone with the next save.
constexpr const char *kMoreThanPacked =
    QT_TRANSLATE_NOOP("Error", "there is more in this file than its contents");

std::uint32_t numberAt(std::string_view bytes, std::size_t at)
{
    std::uint32_t number = 0;
    for (std::size_t i = 4; i-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

std::size_t shortAt(std::string_view bytes, std::size_t at)
{
    return static_cast<unsigned char>(bytes[at]) |
           std::size_t(static_cast<unsigned char>(bytes[at + 1])) << 8;
}

constexpr std::size_t kEndSize = 22; // bytes of the record that ends an archive, but its comment

/// Whether the list of entries ends where this record of its end begins, and that, with its
/// comment, ends the file.
bool isEnd(std::string_view bytes, std::size_t at)
{
    constexpr std::size_t kLocator = 20;
    if (bytes.size() < kEndSize || at > bytes.size() - kEndSize ||
        at + kEndSize + shortAt(bytes, at + 20) != bytes.size())
        return false;
    const bool is64 = at >= kLocator && bytes.substr(at - kLocator, 4) == "PK\6\7";
    return is64 || std::size_t(numberAt(bytes, at + 12)) + numberAt(bytes, at + 16) == at;
}

/// The archive without its comment, in which minizip would take any such bytes for the end; nothing
/// where its end is not to be found, or may be in two places.
std::optional<std::string_view> withoutComment(std::string_view bytes)
{
    constexpr std::size_t kLongestEnd = kEndSize + 0xFFFF;
    constexpr std::string_view kSignature = "PK\5\6";
    std::optional<std::size_t> end;
    std::size_t at = bytes.size() - std::min(bytes.size(), kLongestEnd);
    for (at = bytes.find(kSignature, at); at < bytes.size(); at = bytes.find(kSignature, at + 1)) {
        if (!isEnd(bytes, at))
            continue;
        if (end)
            return std::nullopt;
        end = at;
    }
    return end ? std::optional(bytes.substr(0, *end + kEndSize)) : std::nullopt;
}

bool isTooDense(std::size_t unpacked, std::uint64_t packed)
{
    return unpacked > kSmallEntryBytes && unpacked / kMostRatio > packed;
}

/// What the list says of an entry.
struct Listed
{
    std::string name;
    unz_file_info64 info;
    ZPOS64_T at; // in the list

    /// For places: a name that is not one of ours may be anything.
    std::string in(const std::string &archive) const { return placeOfEntry(archive, name); }
};

class Unpacker
{
public:
    Unpacker(std::string_view bytes, const std::string &place)
        : m_place(place), m_hasEnd(withoutComment(bytes).has_value())
    {
        m_memory.read = withoutComment(bytes).value_or(bytes);
        zlib_filefunc64_def functions = functionsOf(m_memory);
        m_file.reset(unzOpen2_64(nullptr, &functions));
    }

    Result<void> list();
    Result<void> check() const;
    Result<std::vector<ArchiveEntry>> unpack();
    const std::vector<Listed> &entries() const { return m_entries; }

private:
    struct Close
    {
        void operator()(void *file) const { unzClose(file); }
    };

    Result<void> checkSum() const;
    Result<void> checkItself(const Listed &entry) const;
    Result<std::string> unpack(const Listed &entry);

    const std::string &m_place;
    bool m_hasEnd;
    Memory m_memory;
    std::unique_ptr<void, Close> m_file;
    std::vector<Listed> m_entries;
    std::size_t m_unpacked = 0; // bytes so far
};

/// Once.
Result<void> Unpacker::list()
{
    unz_global_info64 global = {};
    if (!m_file || unzGetGlobalInfo64(m_file.get(), &global) != UNZ_OK)
        return bad(m_place, kListDamaged);
    if (!m_hasEnd)
        return bad(m_place, kMoreThanPacked);
    if (global.number_entry > kMostEntries)
        return tooMany(m_place, global.number_entry, kMostEntries, kEntries);
    for (ZPOS64_T i = 0; i < global.number_entry; ++i) {
        std::array<char, kLongestName + 1> name = {};
        Listed entry = {};
        const int moved = i == 0 ? unzGoToFirstFile(m_file.get()) : unzGoToNextFile(m_file.get());
        if (moved != UNZ_OK ||
            unzGetCurrentFileInfo64(m_file.get(), &entry.info, name.data(), name.size(), nullptr, 0,
                                    nullptr, 0) != UNZ_OK)
            return bad(m_place, kListDamaged);
        entry.name.assign(name.data(),
                          std::min<std::size_t>(entry.info.size_filename, kLongestName));
        entry.at = unzGetOffset64(m_file.get());
        m_entries.push_back(std::move(entry));
    }
    return {};
}

/// What the list says, before anything is unpacked.
Result<void> Unpacker::check() const
{
    std::set<std::string_view> known;
    for (const Listed &entry : m_entries) {
        const std::string place = entry.in(m_place);
        if (!known.insert(entry.name).second)
            return bad(place, QT_TRANSLATE_NOOP("Error", "this entry occurs twice"));
        if (entry.info.flag & 1)
            return bad(place, kEncrypted);
        // Sizes of 64 bits, which minizip reads on some systems only.
        constexpr ZPOS64_T k64 = 0xFFFFFFFF;
        const bool is64 = entry.info.compressed_size == k64 || entry.info.uncompressed_size == k64;
        if (is64 ||
            (entry.info.compression_method != 0 && entry.info.compression_method != Z_DEFLATED))
            return bad(place, QT_TRANSLATE_NOOP("Error", "this entry is packed in an unknown way"));
        if (entry.info.uncompressed_size > kMostEntryBytes)
            return tooMany(place, entry.info.uncompressed_size, kMostEntryBytes, kBytes);
    }
    if (Result<void> sum = checkSum(); !sum)
        return sum;
    for (const Listed &entry : m_entries)
        if (Result<void> itself = checkItself(entry); !itself)
            return itself;
    return {};
}

/// What stands before an entry's bytes must say what the list says, or programs that go by the one
/// and by the other would see two different archives. minizip compares the rest.
Result<void> Unpacker::checkItself(const Listed &entry) const
{
    constexpr std::size_t kListedSize = 46, kHeadSize = 30;
    const std::string_view bytes = m_memory.read;
    if (entry.at + kListedSize > bytes.size() || bytes.substr(entry.at, 4) != "PK\1\2")
        return bad(m_place, kListDamaged);
    const std::size_t head = numberAt(bytes, entry.at + 42);
    if (head + kHeadSize > bytes.size() || bytes.substr(head, 4) != "PK\3\4")
        return bad(entry.in(m_place), kDamaged);
    if (shortAt(bytes, head + 6) & 1)
        return bad(entry.in(m_place), kEncrypted);
    if (bytes.substr(head + kHeadSize, shortAt(bytes, head + 26)) != entry.name)
        return bad(
            entry.in(m_place),
            QT_TRANSLATE_NOOP("Error", "this entry has another name than in the list of contents"));
    return {};
}

/// No byte is packed in two entries, or a small file would unpack to their product.
Result<void> Unpacker::checkSum() const
{
    std::uint64_t packed = 0, unpacked = 0; // no more than kMostEntries times the size of a file
    for (const Listed &entry : m_entries) {
        if (entry.info.compressed_size > m_memory.read.size())
            return bad(entry.in(m_place), kDamaged);
        packed += entry.info.compressed_size;
        unpacked += entry.info.uncompressed_size;
    }
    if (packed > m_memory.read.size())
        return bad(m_place, QT_TRANSLATE_NOOP("Error", "entries in it share their bytes"));
    if (unpacked > kMostUnpackedBytes)
        return tooMany(m_place, unpacked, kMostUnpackedBytes, kBytes);
    return {};
}

Result<std::vector<ArchiveEntry>> Unpacker::unpack()
{
    std::vector<ArchiveEntry> entries;
    for (const Listed &entry : m_entries) {
        const int moved =
            entries.empty() ? unzGoToFirstFile(m_file.get()) : unzGoToNextFile(m_file.get());
        if (moved != UNZ_OK || unzOpenCurrentFile(m_file.get()) != UNZ_OK)
            return bad(entry.in(m_place), kDamaged);
        Result<std::string> bytes = unpack(entry);
        if (!bytes)
            return tl::unexpected(std::move(bytes.error()));
        entries.push_back({entry.name, *std::move(bytes)});
    }
    return entries;
}

Result<std::string> Unpacker::unpack(const Listed &entry)
{
    std::string text, chunk(kChunk, '\0');
    int count = 0;
    while ((count = unzReadCurrentFile(m_file.get(), chunk.data(), kChunk)) > 0) {
        text.append(chunk, 0, static_cast<std::size_t>(count));
        m_unpacked += static_cast<std::size_t>(count);
        if (text.size() > kMostEntryBytes)
            return tooMany(entry.in(m_place), text.size(), kMostEntryBytes, kBytes);
        if (m_unpacked > kMostUnpackedBytes)
            return tooMany(m_place, m_unpacked, kMostUnpackedBytes, kBytes);
        if (isTooDense(text.size(), entry.info.compressed_size))
            return bad(entry.in(m_place),
                       QT_TRANSLATE_NOOP("Error", "this entry unpacks to far too much"));
    }
    // Closing it says whether the check sum is right.
    const bool isWhole = unzCloseCurrentFile(m_file.get()) == UNZ_OK && count == 0 &&
                         text.size() == entry.info.uncompressed_size;
    if (!isWhole)
        return bad(entry.in(m_place), kDamaged);
    return text;
}

/// Without zlib's head, as ZIP has it; empty when that makes it no smaller.
std::string deflated(std::string_view bytes)
{
    z_stream stream = {};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL - 1,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        return {};
    std::string out(bytes.size(), '\0');
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef *>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const bool isSmaller = deflate(&stream, Z_FINISH) == Z_STREAM_END;
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return isSmaller && !isTooDense(bytes.size(), out.size()) ? out : std::string();
}

bool add(zipFile zip, const PackedEntry &entry)
{
    const std::string smaller = deflated(entry.bytes);
    const std::string_view bytes = smaller.empty() ? entry.bytes : smaller;
    const auto size = static_cast<uInt>(bytes.size());
    zip_fileinfo info = {};
    info.dosDate = kFirstDay;
    constexpr int kRaw = 1, kSmall = 0;
    return zipOpenNewFileInZip2_64(zip, entry.name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                                   smaller.empty() ? 0 : Z_DEFLATED, Z_DEFAULT_COMPRESSION, kRaw,
                                   kSmall) == ZIP_OK &&
           zipWriteInFileInZip(zip, bytes.data(), size) == ZIP_OK &&
           zipCloseFileInZipRaw64(zip, entry.bytes.size(),
                                  crc32(0, reinterpret_cast<const Bytef *>(entry.bytes.data()),
                                        static_cast<uInt>(entry.bytes.size()))) == ZIP_OK;
}

} // namespace

std::string placeOfEntry(const std::string &archive, const std::string &entry)
{
    return placeIn(archive, entry.empty() ? "\"\"" : io::quoted(entry));
}

bool isArchive(std::string_view bytes)
{
    // An entry, the end of an empty archive, one of several volumes.
    return bytes.starts_with("PK\3\4") || bytes.starts_with("PK\5\6") ||
           bytes.starts_with("PK\7\10");
}

Result<std::string> packed(std::span<const PackedEntry> entries)
{
    if (entries.size() > kMostEntries)
        return tooMany({}, entries.size(), kMostEntries, kEntries);
    std::size_t sum = 0;
    for (const PackedEntry &entry : entries) {
        sum += entry.bytes.size();
        if (entry.bytes.size() > kMostEntryBytes)
            return tooMany(entry.name, entry.bytes.size(), kMostEntryBytes, kBytes);
    }
    if (sum > kMostUnpackedBytes)
        return tooMany({}, sum, kMostUnpackedBytes, kBytes);
    Memory memory;
    memory.isWritten = true;
    zlib_filefunc64_def functions = functionsOf(memory);
    zipFile zip = zipOpen2_64(nullptr, APPEND_STATUS_CREATE, nullptr, &functions);
    bool isDone = zip != nullptr;
    for (const PackedEntry &entry : entries)
        isDone = isDone && add(zip, entry);
    isDone = zip && zipClose(zip, nullptr) == ZIP_OK && isDone;
    if (!isDone)
        return failure(ErrorCode::NotWorkedOut);
    return std::move(memory.written);
}

Result<std::vector<std::string>> entryNames(std::string_view bytes, const std::string &place)
{
    Unpacker unpacker(bytes, place);
    if (const Result<void> listed = unpacker.list(); !listed)
        return tl::unexpected(listed.error());
    std::vector<std::string> names;
    for (const Listed &entry : unpacker.entries())
        names.push_back(entry.name);
    return names;
}

Result<std::vector<ArchiveEntry>> unpacked(std::string_view bytes, const std::string &place)
{
    Unpacker unpacker(bytes, place);
    return unpacker.list().and_then([&] { return unpacker.check(); }).and_then([&] {
        return unpacker.unpack();
    });
}

} // namespace fff::io
