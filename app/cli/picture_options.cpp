#include "app/cli/picture_options.h"

#include "app/cli/command_line.h"
#include "ui/view/offscreen_image.h"

#include <cmath>

namespace fff::cli {

namespace {

constexpr const char *kViews[] = {"iso1", "iso2", "iso3", "iso4",   "front", "right",
                                  "top",  "left", "back", "bottom", "fit"};

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

} // namespace

void addPictureOptions(QCommandLineParser &parser)
{
    parser.addOption(
        {QStringLiteral("size"), tr("Pixels of the picture (1280x800)."), QStringLiteral("WxH")});
    parser.addOption({QStringLiteral("view"),
                      tr("iso1 to iso4, front, right, top, left, back, bottom, or fit: the front "
                         "again (iso1)."),
                      QStringLiteral("VIEW")});
}

QString readPictureOptions(const QCommandLineParser &parser, PictureOptions &options)
{
    if (parser.isSet(QStringLiteral("size"))) {
        const QString text = parser.value(QStringLiteral("size"));
        const std::optional<Vec2> size = sizeOf(text);
        if (!size || size->minCoeff() < 1.0 || size->maxCoeff() > ui::kMaxPictureSide)
            return tr("--size: found \"%1\", expected width x height in pixels up to %2, such as "
                      "1280x800.")
                .arg(text)
                .arg(ui::kMaxPictureSide);
        options.size = {std::floor(size->x()), std::floor(size->y())};
    }
    if (parser.isSet(QStringLiteral("view"))) {
        options.view = parser.value(QStringLiteral("view"));
        QStringList known;
        for (const char *name : kViews)
            known += QLatin1String(name);
        if (!known.contains(options.view))
            return tr("--view: found \"%1\", expected one of %2.")
                .arg(options.view, known.join(QStringLiteral(", ")));
    }
    return {};
}

} // namespace fff::cli
