#include "core/io/compressed.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <limits>
#include <memory>
#include <zlib.h>

namespace fff::io {

namespace {

constexpr std::size_t kChunk = 1 << 16;
constexpr int kGzip = 16 + MAX_WBITS; // for inflateInit2: with gzip's head and its check sum

struct End
{
    void operator()(z_stream *stream) const
    {
        inflateEnd(stream);
        delete stream;
    }
};

} // namespace

bool isCompressed(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b");
}

Result<std::string> uncompressed(std::string_view bytes, std::size_t most, const std::string &place)
{
    const std::unique_ptr<z_stream, End> stream(new z_stream{});
    const auto damaged = [&place] {
        return failure(ErrorCode::BadSyntax, place,
                       {"", QT_TRANSLATE_NOOP("Error", "undamaged gzip data")});
    };
    if (inflateInit2(stream.get(), kGzip) != Z_OK)
        return damaged();
    std::string text, chunk(kChunk, '\0');
    int state = Z_OK;
    while (!bytes.empty() || stream->avail_in > 0 || state == Z_OK) {
        if (stream->avail_in == 0) {
            const std::size_t next =
                std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
            stream->next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
            stream->avail_in = static_cast<uInt>(next);
            bytes.remove_prefix(next);
        }
        if (state == Z_STREAM_END) {
            // Zeros may fill up the last block of a tape; another file may follow.
            if (*stream->next_in == 0)
                break;
            inflateReset(stream.get());
        }
        stream->next_out = reinterpret_cast<Bytef *>(chunk.data());
        stream->avail_out = static_cast<uInt>(chunk.size());
        state = inflate(stream.get(), Z_NO_FLUSH);
        if (state == Z_BUF_ERROR)
            return failure(ErrorCode::Truncated, place,
                           {QT_TRANSLATE_NOOP("Error", "the rest of the gzip data")});
        if (state != Z_OK && state != Z_STREAM_END)
            return damaged();
        text.append(chunk, 0, chunk.size() - stream->avail_out);
        if (text.size() > most)
            return failure(ErrorCode::BadCount, place,
                           {std::to_string(text.size()), std::to_string(most),
                            QT_TRANSLATE_NOOP("Error", "bytes")});
    }
    return text;
}

} // namespace fff::io
