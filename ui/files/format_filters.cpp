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

namespace {

/// In how many ways a format has what is cut, or the solids: as it is usual, and as each choice
/// that has a title of its own.
void addWays(const Format &format, std::vector<ExportKind> &kinds)
{
    const auto add = [&](const QString &key, const char *title, const char *titleOfSheets,
                         const io::FormatValues &values) {
        const auto addOne = [&](const char *how, const char *text, bool isFilePerSheet) {
            if (*text != '\0')
                kinds.push_back({QLatin1String(format.key) + key + QLatin1String(how),
                                 QCoreApplication::translate("Format", text), titled(format, text),
                                 &format, isFilePerSheet, false, values});
        };
        addOne("", title, false);
        if (format.writesCutting())
            addOne("/sheets", titleOfSheets, true);
    };
    add({}, format.title, format.titleOfSheets, {});
    for (const io::FormatOption &option : format.options) {
        double value = 0.0;
        for (const io::FormatOption::Choice &choice : option.choices) {
            add(u'/' + QLatin1String(choice.name), choice.title, choice.titleOfSheets,
                {{option.name, value}});
            ++value;
        }
    }
}

} // namespace

std::vector<ExportKind> exportKinds()
{
    std::vector<ExportKind> kinds;
    for (const Format *format : io::formatsThat(&Format::writesCutting))
        addWays(*format, kinds);
    for (const Format *format : io::formatsThat(&Format::writesSolids))
        addWays(*format, kinds);
    for (const Format *format : io::formatsThat(&Format::writesSkins))
        kinds.push_back({QLatin1String(format->key) + QStringLiteral("/skin"),
                         QCoreApplication::translate("Format", format->titleOfSkin),
                         titled(*format, format->titleOfSkin),
                         format,
                         false,
                         true,
                         {}});
    return kinds;
}

} // namespace fff::ui
