// What of the clipboard can be drawn over: a picture, or a file of one that was copied.
#pragma once

#include "core/base/result.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <optional>
#include <string>

class QMimeData;

namespace fff::ui {

/// One of the three.
struct ClipboardPicture
{
    QString path;     // of a file
    QByteArray bytes; // as a program gave them: PNG, JPEG, WebP or SVG
    QImage image;     // pixels alone
};

/// None where there is nothing of that kind, or sections of a model besides: these are meant.
std::optional<ClipboardPicture> pictureIn(const QMimeData *data);

/// As a file would have it. May take long.
///
/// name    how errors call it
/// Errors  BadCount for one of too many pixels, as readPicture(); CannotOpen where there is not
///         enough memory
Result<std::string> bytesOf(const ClipboardPicture &picture, const std::string &name);

} // namespace fff::ui
