#include "core/io/fff_file.h"

#include "core/io/archive.h"
#include "core/io/fff_format.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <map>

namespace fff::io {

namespace {

constexpr std::string_view kDocument = "document.json", kBlobs = "blobs/";

std::string blobName(const std::string &sha256)
{
    return std::string(kBlobs) + sha256;
}

/// No other name has a place in there, so none can lead out of a folder. Other programs pack the
/// folder of the blobs, too.
bool belongs(std::string_view name)
{
    return name == kDocument || name == kBlobs ||
           (name.starts_with(kBlobs) && isSha256(name.substr(kBlobs.size())));
}

tl::unexpected<Error> bad(const std::string &name, const std::string &entry, const char *what)
{
    return failure(ErrorCode::BadArchive, placeIn(name, entry), {what});
}

/// What is in the archive: the document's text, and the bytes of each blob under its hash.
struct Content
{
    std::string document;
    std::map<std::string, BlobBytes> blobs;
};

/// A ZIP that has nothing of ours is some other file.
Result<void> checkNames(std::string_view bytes, const std::string &name)
{
    const Result<std::vector<std::string>> names = entryNames(bytes, name);
    if (!names)
        return tl::unexpected(names.error());
    const auto foreign = std::find_if_not(names->begin(), names->end(), belongs);
    if (std::none_of(names->begin(), names->end(), belongs))
        return failure(ErrorCode::NotAModel, name);
    if (foreign != names->end())
        return failure(
            ErrorCode::BadArchive, placeOfEntry(name, *foreign),
            {QT_TRANSLATE_NOOP("Error", "an entry with this name does not belong here")});
    return {};
}

Result<Content> contentOf(std::string_view bytes, const std::string &name)
{
    if (const Result<void> checked = checkNames(bytes, name); !checked)
        return tl::unexpected(checked.error());
    Result<std::vector<ArchiveEntry>> entries = unpacked(bytes, name);
    if (!entries)
        return tl::unexpected(std::move(entries.error()));
    Content content;
    bool hasDocument = false;
    for (ArchiveEntry &entry : *entries) {
        if (entry.name == kDocument) {
            content.document = std::move(entry.bytes);
            hasDocument = true;
            continue;
        }
        if (entry.name == kBlobs && entry.bytes.empty())
            continue;
        std::string hash = entry.name.substr(kBlobs.size());
        if (sha256Of(entry.bytes) != hash)
            return bad(name, entry.name,
                       QT_TRANSLATE_NOOP(
                           "Error", "the data of this entry does not match its name, a SHA-256"));
        content.blobs.emplace(std::move(hash),
                              std::make_shared<const std::string>(std::move(entry.bytes)));
    }
    if (!hasDocument)
        return bad(name, std::string(kDocument),
                   QT_TRANSLATE_NOOP("Error", "this entry is missing"));
    return content;
}

/// With all the blobs that it names, or not at all: what is left out would be gone with the next
/// save. place  what errors call the document
Result<LoadedDocument> readWhole(std::string_view document, const std::string &place,
                                 const std::map<std::string, BlobBytes> &blobs,
                                 const std::string &name)
{
    std::string missing;
    const BlobSource source = [&](const std::string &hash) -> Result<BlobBytes> {
        const auto found = blobs.find(hash);
        if (found != blobs.end())
            return found->second;
        missing = missing.empty() ? hash : missing;
        return failure(ErrorCode::BadArchive);
    };
    Result<LoadedDocument> loaded = readFff(document, place, source);
    if (loaded && !missing.empty())
        return bad(name, blobName(missing), QT_TRANSLATE_NOOP("Error", "this entry is missing"));
    return loaded;
}

Result<LoadedDocument> readArchive(std::string_view bytes, const std::string &name)
{
    const Result<Content> content = contentOf(bytes, name);
    if (!content)
        return tl::unexpected(content.error());
    Result<LoadedDocument> loaded =
        readWhole(content->document, placeIn(name, std::string(kDocument)), content->blobs, name);
    if (!loaded)
        return loaded;
    for (const auto &[hash, blob] : content->blobs) {
        if (!loaded->document.findBlob(hash))
            return bad(name, blobName(hash),
                       QT_TRANSLATE_NOOP("Error", "nothing in the document refers to this entry"));
    }
    return loaded;
}

bool looksLikeFff(std::string_view bytes)
{
    if (isArchive(bytes))
        return true;
    const std::string_view text = withoutByteOrderMark(bytes);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    // Text has no zero bytes; what has is a picture, a program or the like.
    return begin != std::string_view::npos && text[begin] == '{' &&
           text.find('\0') == std::string_view::npos;
}

} // namespace

Result<std::string> writeFffFile(const Document &document)
{
    Result<std::string> text = writeFff(document);
    if (!text || document.blobs.empty())
        return text;
    std::vector<PackedEntry> entries{{std::string(kDocument), *text}};
    for (const BlobPointer &blob : document.blobs)
        entries.push_back({blobName(blob->sha256), *blob->bytes});
    return packed(entries);
}

Result<LoadedDocument> readFffFile(std::string_view bytes, const std::string &name,
                                   const BlobSource &blobs)
{
    if (isArchive(bytes))
        return readArchive(bytes, name);
    return blobs ? readFff(bytes, name, blobs) : readWhole(bytes, name, {}, name);
}

const Format &fffFormat()
{
    static const Format format = {
        .key = "fff",
        .suffixes = {"fff"},
        .title = QT_TRANSLATE_NOOP("Format", "FlatFitFab models"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "the model itself"),
        .recognises = looksLikeFff,
        .readModel =
            [](std::string_view bytes, const std::string &name, const ReadOptions &options) {
                return readFffFile(bytes, name, options.blobs);
            },
        .writeModel = [](const Document &document,
                         const FormatValues &) { return writeFffFile(document); }};
    return format;
}

} // namespace fff::io
