// What verbs that make pictures are asked for: their size and from where one looks.
#pragma once

#include "core/geometry/vector.h"

#include <QCommandLineParser>
#include <QString>

namespace fff::cli {

struct PictureOptions
{
    Vec2 size{1280.0, 800.0}; // px
    QString view = QStringLiteral("iso1");
};

/// --size and --view
void addPictureOptions(QCommandLineParser &parser);
/// What was asked for; the reason when that makes no sense, else empty.
QString readPictureOptions(const QCommandLineParser &parser, PictureOptions &options);

} // namespace fff::cli
