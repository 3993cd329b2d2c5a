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
    const auto add = [&kinds](const Format &format, const char *title, bool isFilePerSheet) {
        const QString key = QLatin1String(format.key);
        kinds.push_back({isFilePerSheet ? key + QStringLiteral("/sheets") : key,
                         QCoreApplication::translate("Format", title), titled(format, title),
                         &format, isFilePerSheet});
    };
    for (const Format *format : io::formatsThat(&Format::writesCutting)) {
        add(*format, format->title, false);
        add(*format, format->titleOfSheets, true);
    }
    for (const Format *format : io::formatsThat(&Format::writesSolids))
        add(*format, format->title, false);
    return kinds;
}

} // namespace fff::ui
