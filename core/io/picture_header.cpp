#include "core/io/picture_header.h"

#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>

#include <array>
#include <optional>

namespace fff::io {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n"sv, kJpeg = "\xff\xd8\xff"sv;
/// Others that people have; they are refused by name, not as damaged meshes.
constexpr std::array kOthers = {std::pair("GIF8"sv, "GIF"), std::pair("BM"sv, "BMP"),
                                std::pair("II*\0"sv, "TIFF"), std::pair("MM\0*"sv, "TIFF"),
                                std::pair("8BPS"sv, "PSD")};
/// A mesh in text may begin with BM; a bitmap has four zeros there.
constexpr std::size_t kBitmapReserved = 6;

bool isWebp(std::string_view bytes)
{
    return bytes.starts_with("RIFF") &&
           bytes.substr(std::min<std::size_t>(8, bytes.size()), 4) == "WEBP";
}

const char *otherFormat(std::string_view bytes)
{
    for (const auto &[signature, name] : kOthers)
        if (bytes.starts_with(signature) &&
            (signature != "BM" ||
             bytes.substr(std::min(kBitmapReserved, bytes.size()), 4) == "\0\0\0\0"sv))
            return name;
    const std::string_view brand = bytes.substr(std::min<std::size_t>(4, bytes.size()), 8);
    if (brand == "ftypheic" || brand == "ftypheix" || brand == "ftypmif1")
        return "HEIC";
    return brand == "ftypavif" ? "AVIF" : nullptr;
}

/// A number of so many bytes; none where the file ends before it does.
std::optional<std::uint32_t> bigEndian(std::string_view bytes, std::size_t at, std::size_t count)
{
    if (at > bytes.size() || bytes.size() - at < count)
        return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

std::optional<std::uint32_t> littleEndian(std::string_view bytes, std::size_t at, std::size_t count)
{
    if (at > bytes.size() || bytes.size() - at < count)
        return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = count; i > 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
    return value;
}

tl::unexpected<Error> endsEarly(std::string_view bytes, const std::string &name)
{
    return failure(ErrorCode::Truncated, placeIn(name, "byte " + std::to_string(bytes.size())),
                   {QT_TRANSLATE_NOOP("Error", "the rest of the picture")});
}

/// Chunks: length, name, so many bytes, a checksum.
Result<PictureHeader> pngHeader(std::string_view bytes, const std::string &name)
{
    constexpr std::size_t kAround = 12;
    PictureHeader header{"png", "PNG", "image/png"};
    std::size_t at = kPng.size();
    while (true) {
        const auto length = bigEndian(bytes, at, 4);
        if (!length || bytes.size() - at < kAround || bytes.size() - at - kAround < *length)
            return endsEarly(bytes, name);
        const std::string_view kind = bytes.substr(at + 4, 4);
        if (kind == "IHDR" && *length >= 8) {
            header.width = *bigEndian(bytes, at + 8, 4);
            header.height = *bigEndian(bytes, at + 12, 4);
        }
        header.isAnimated = header.isAnimated || kind == "acTL";
        at += kAround + *length;
        if (kind == "IEND")
            return header;
    }
}

/// Of a marker that begins a frame: what is not a table or an extension among C0 … CF.
bool beginsFrame(std::uint32_t marker)
{
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// From here to the next marker: behind the head of a scan there are pixels, in which FF stands
/// before 00, or before the count of a restart.
std::size_t behindPixels(std::string_view bytes, std::size_t at)
{
    for (; at + 1 < bytes.size(); ++at) {
        const auto next = static_cast<unsigned char>(bytes[at + 1]);
        if (bytes[at] == '\xff' && next != 0 && next != 0xFF && !(next >= 0xD0 && next <= 0xD7))
            return at;
    }
    return bytes.size();
}

/// Segments: FF, a marker, their length with its own two bytes.
Result<PictureHeader> jpegHeader(std::string_view bytes, const std::string &name)
{
    constexpr std::uint32_t kEnd = 0xFFD9, kScan = 0xFFDA;
    PictureHeader header{"jpeg", "JPEG", "image/jpeg"};
    std::size_t at = 2;
    while (true) {
        while (at + 1 < bytes.size() && bytes[at] == '\xff' && bytes[at + 1] == '\xff')
            ++at; // they may be filled up
        const auto marker = bigEndian(bytes, at, 2);
        if (marker == kEnd)
            return header;
        const auto length = bigEndian(bytes, at + 2, 2);
        if (!marker || !length)
            return endsEarly(bytes, name);
        if ((*marker & 0xFF00) != 0xFF00 || *length < 2)
            return failure(ErrorCode::BadArchive, placeIn(name, "byte " + std::to_string(at)),
                           {QT_TRANSLATE_NOOP("Error", "the picture is damaged here")});
        if (beginsFrame(*marker & 0xFF)) {
            header.height = bigEndian(bytes, at + 5, 2).value_or(0);
            header.width = bigEndian(bytes, at + 7, 2).value_or(0);
        }
        at += 2 + *length;
        if (marker == kScan)
            at = behindPixels(bytes, at);
        if (at > bytes.size())
            return endsEarly(bytes, name);
    }
}

/// A container that says how long it is; an extended one says how large all of it is, too.
Result<PictureHeader> webpHeader(std::string_view bytes, const std::string &name)
{
    constexpr std::size_t kHead = 8, kFlags = 20, kWidth = 24, kHeight = 27;
    constexpr std::uint32_t kAnimation = 2;
    PictureHeader header{"webp", "WebP", "image/webp"};
    const auto length = littleEndian(bytes, 4, 4);
    if (!length || bytes.size() - kHead < *length)
        return endsEarly(bytes, name);
    const auto flags = littleEndian(bytes, kFlags, 1);
    const auto width = littleEndian(bytes, kWidth, 3), height = littleEndian(bytes, kHeight, 3);
    if (bytes.substr(12, 4) == "VP8X" && flags && width && height) {
        header.isAnimated = (*flags & kAnimation) != 0;
        header.width = std::int64_t(*width) + 1;
        header.height = std::int64_t(*height) + 1;
    }
    return header;
}

} // namespace

bool looksLikePicture(std::string_view head)
{
    return head.starts_with(kPng) || head.starts_with(kJpeg) || isWebp(head) || otherFormat(head);
}

Result<PictureHeader> pictureHeader(std::string_view bytes, const std::string &name)
{
    if (isWebp(bytes))
        return webpHeader(bytes, name);
    const bool isPng = bytes.starts_with(kPng);
    if (!isPng && !bytes.starts_with(kJpeg)) {
        const char *other = otherFormat(bytes);
        return failure(ErrorCode::BadSyntax, name,
                       {other ? other : quoted(bytes),
                        QT_TRANSLATE_NOOP("Error", "a picture as PNG, JPEG or WebP")});
    }
    Result<PictureHeader> header = isPng ? pngHeader(bytes, name) : jpegHeader(bytes, name);
    if (header && !(header->width > 0 && header->height > 0))
        return failure(ErrorCode::BadValue, name,
                       {std::to_string(header->width) + " × " + std::to_string(header->height),
                        QT_TRANSLATE_NOOP("Error", "a picture with at least one pixel")});
    return header;
}

} // namespace fff::io
