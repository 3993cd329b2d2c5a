#include "ui/files/format_filters.h"

#include "core/io/formats.h"

#include <QCoreApplication>

#include <algorithm>

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

ExportKind exportKind(const Format &format, const QString &way, const char *text, io::FileUse use)
{
    ExportKind kind;
    kind.key = QLatin1String(format.key) + way;
    kind.title = QCoreApplication::translate("Format", text);
    kind.filter = titled(format, text);
    kind.format = &format;
    kind.use = use;
    return kind;
}

/// In how many ways a format has what is cut, or the solids: as it is usual, and as each choice
/// that has a title of its own.
void addWays(const Format &format, std::vector<ExportKind> &kinds)
{
    const auto add = [&](const QString &way, const char *title, const char *titleOfSheets,
                         const io::FormatValues &values, io::FileUse use) {
        const auto addOne = [&](const QString &how, const char *text, bool isFilePerSheet) {
            if (*text == '\0')
                return;
            ExportKind &kind = kinds.emplace_back(exportKind(format, how, text, use));
            kind.isFilePerSheet = isFilePerSheet;
            kind.values = values;
        };
        addOne(way, title, false);
        if (format.writesCutting())
            addOne(way + QStringLiteral("/sheets"), titleOfSheets, true);
    };
    const io::FileUse usual = format.writesCutting() ? format.use : io::FileUse::Solids;
    add({}, format.title, format.titleOfSheets, {}, usual);
    for (const io::FormatOption &option : format.options) {
        double value = 0.0;
        for (const io::FormatOption::Choice &choice : option.choices) {
            add(u'/' + QLatin1String(choice.name), choice.title, choice.titleOfSheets,
                {{option.name, value}}, choice.use.value_or(usual));
            ++value;
        }
    }
    if (*format.titleOfFolder != '\0') {
        kinds.push_back(exportKind(format, QStringLiteral("/folder"), format.titleOfFolder, usual));
        kinds.back().isFolder = true;
        kinds.back().filter = kinds.back().title;
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
    for (const Format *format : io::formatsThat(&Format::writesSkins)) {
        kinds.push_back(
            exportKind(*format, QStringLiteral("/skin"), format->titleOfSkin, io::FileUse::Solids));
        kinds.back().isSkin = true;
    }
    return kinds;
}

ExportKind exportKindNamed(const QString &key)
{
    const std::vector<ExportKind> kinds = exportKinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&key](const ExportKind &kind) { return kind.key == key; });
    return found == kinds.end() ? kinds.front() : *found;
}

} // namespace fff::ui
