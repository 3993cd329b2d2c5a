#include "ui/files/format_filters.h"

#include "core/io/formats.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

using io::Format;

struct FormatFiltersTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::FormatFilters)
};

QString withAllFiles(const QString &filter)
{
    return filter + QStringLiteral(";;") + FormatFiltersTexts::tr("All files (*)");
}

QString titled(const Format &format, const char *title)
{
    return QStringLiteral("%1 (%2)").arg(QCoreApplication::translate("Format", title),
                                         io::patternOf(format));
}

} // namespace

QString modelFilter()
{
    //: %1 are patterns such as "*.fff *.txt"
    return withAllFiles(
        FormatFiltersTexts::tr("Models (%1)").arg(io::patternsRead(&Format::readsModels)));
}

QString drawingFilter()
{
    return withAllFiles(
        FormatFiltersTexts::tr("Drawings (%1)").arg(io::patternsRead(&Format::readsDrawings)));
}

QString saveFilter()
{
    return titled(io::nativeFormat(), io::nativeFormat().title);
}

std::vector<ExportKind> exportKinds()
{
    std::vector<ExportKind> kinds;
    const auto add = [&kinds](const Format &format, const char *title, const char *how = "") {
        kinds.push_back({QLatin1String(format.key) + QLatin1String(how),
                         QCoreApplication::translate("Format", title), titled(format, title),
                         &format, title == format.titleOfSheets, title == format.titleOfSkin});
    };
    for (const Format *format : io::formatsThat(&Format::writesCutting)) {
        add(*format, format->title);
        add(*format, format->titleOfSheets, "/sheets");
    }
    for (const Format *format : io::formatsThat(&Format::writesSolids))
        add(*format, format->title);
    for (const Format *format : io::formatsThat(&Format::writesSkins))
        add(*format, format->titleOfSkin, "/skin");
    return kinds;
}

} // namespace fff::ui
