#include "ui/files/clipboard_picture.h"

#include "core/io/fff_format.h"
#include "core/io/picture_file.h"
#include "ui/bench/clipboard.h"
#include "ui/files/mesh_import.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QMimeData>
#include <QUrl>

namespace fff::ui {

namespace {

/// As they are, so that nothing of them is lost; the first that there is. A drawing says more than
/// a picture of it.
constexpr const char *kClipboardTypes[] = {"image/svg+xml", "image/x-inkscape-svg", "image/png",
                                           "image/jpeg", "image/webp"};

bool hasSections(const QMimeData &data)
{
    const auto read = io::readFff(modelTextIn(data));
    return read && !read->document.sections.empty();
}

std::optional<ClipboardPicture> anyPictureIn(const QMimeData &data)
{
    for (const QUrl &url : data.urls())
        if (url.isLocalFile() && isMeshFile(url.toLocalFile()))
            return ClipboardPicture{url.toLocalFile(), {}, {}};
    for (const char *type : kClipboardTypes)
        if (QByteArray bytes = data.data(QLatin1String(type)); !bytes.isEmpty())
            return ClipboardPicture{{}, std::move(bytes), {}};
    if (!data.hasImage())
        return std::nullopt;
    QImage image = qvariant_cast<QImage>(data.imageData());
    if (image.isNull())
        return std::nullopt;
    return ClipboardPicture{{}, {}, std::move(image)};
}

} // namespace

std::optional<ClipboardPicture> pictureIn(const QMimeData *data)
{
    std::optional<ClipboardPicture> picture;
    if (data)
        picture = anyPictureIn(*data);
    return picture && !hasSections(*data) ? picture : std::nullopt;
}

Result<std::string> bytesOf(const ClipboardPicture &picture, const std::string &name)
{
    if (!picture.bytes.isEmpty())
        return picture.bytes.toStdString();
    if (Result<void> affordable =
            io::checkedPixels(picture.image.width(), picture.image.height(), name);
        !affordable)
        return tl::unexpected(std::move(affordable.error()));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.image.save(&buffer, "png"))
        return failure(ErrorCode::CannotOpen, name,
                       {QT_TRANSLATE_NOOP("Error", "there is not enough memory")});
    return bytes.toStdString();
}

} // namespace fff::ui
