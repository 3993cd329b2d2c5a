#include "core/io/fff_blobs.h"

#include "core/model/edits.h"

#include <QtCore/QCoreApplication>

#include <set>

namespace fff::io {

namespace {

std::string textIfThere(const JsonCursor &cursor)
{
    return cursor.exists() ? cursor.text() : std::string();
}

Result<BlobBytes> bytesFrom(const BlobSource &source, const std::string &sha256)
{
    if (source)
        return source(sha256);
    return failure(ErrorCode::BadArchive, {}, {QT_TRANSLATE_NOOP("Error", "its data is missing")});
}

} // namespace

void writeBlobs(JsonWriter &json, const Document &document)
{
    if (document.blobs.empty())
        return;
    json.key("blobs");
    json.beginArray();
    for (const BlobPointer &blob : document.blobs) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("sha256", blob->sha256);
        if (!blob->mediaType.empty())
            json.member("mediaType", blob->mediaType);
        if (!blob->name.empty())
            json.member("name", blob->name);
        json.endObject();
    }
    json.endArray();
}

std::vector<BlobPointer> readBlobs(const JsonCursor &cursor, const BlobSource &source,
                                   Problems &problems)
{
    if (!cursor.exists())
        return {};
    Document known;
    std::set<std::string> hashes;
    for (const JsonCursor &item : cursor.items()) {
        const JsonCursor hash = item.member("sha256");
        Blob blob{hash.text(), textIfThere(item.member("mediaType")),
                  textIfThere(item.member("name")), nullptr};
        if (!isSha256(blob.sha256))
            hash.failExpected(QT_TRANSLATE_NOOP("Error", "a SHA-256 in 64 hexadecimal digits"));
        else if (!hashes.insert(blob.sha256).second)
            hash.fail(ErrorCode::DuplicateId, {blob.sha256});
        if (problems.failed())
            return {};
        Result<BlobBytes> bytes = bytesFrom(source, blob.sha256);
        if (!bytes) {
            problems.warn(WarningCode::MissingBlob, item.path(),
                          {io::quoted(blob.name.empty() ? blob.sha256 : blob.name),
                           bytes.error().args.empty() ? std::string() : bytes.error().args[0]});
            continue;
        }
        blob.bytes = *std::move(bytes);
        known = addBlob(std::move(known), std::make_shared<const Blob>(std::move(blob)));
    }
    return std::move(known.blobs);
}

} // namespace fff::io
