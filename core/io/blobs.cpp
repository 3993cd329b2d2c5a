#include "core/io/blobs.h"

#include <QtCore/QCryptographicHash>

#include <algorithm>

namespace fff::io {

std::string sha256Of(std::string_view bytes)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    return hash.result().toHex().toStdString();
}

bool isSha256(std::string_view text)
{
    constexpr std::size_t kDigits = 64;
    return text.size() == kDigits && std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

BlobPointer makeBlob(std::string bytes, std::string mediaType, std::string name)
{
    std::string hash = sha256Of(bytes);
    return std::make_shared<const Blob>(
        Blob{std::move(hash), std::move(mediaType), std::move(name),
             std::make_shared<const std::string>(std::move(bytes))});
}

} // namespace fff::io
