#include "app/cli/sheet_options.h"

#include "core/io/offcut_file.h"
#include "core/model/stock.h"

#include <QCoreApplication>

#include <utility>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// "300x200:4" is four of them; without a number, one.
std::pair<QString, std::optional<int>> counted(const QString &text)
{
    const qsizetype colon = text.lastIndexOf(u':');
    bool isNumber = false;
    const int count = colon > 0 ? text.mid(colon + 1).toInt(&isNumber) : 0;
    return isNumber ? std::pair(text.left(colon), std::optional(count))
                    : std::pair(text, std::optional<int>());
}

/// Of a size, else of a drawing.
std::optional<SpareSheet> offcutOf(const QString &text, const Verb &verb,
                                   std::optional<int> &status)
{
    const auto [what, several] = counted(text);
    const int count = several.value_or(1);
    const std::optional<Vec2> size = sizeOf(what);
    const bool isDrawing = what.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive);
    if (count < 1 || count > kMostSpares || (!size && !isDrawing)) {
        status = wrongUse(verb, tr("--offcut: found \"%1\", expected width x height in mm, such as "
                                   "300x200, or an .svg file, and behind them how many there are, "
                                   "such as :2.")
                                    .arg(text));
        return std::nullopt;
    }
    const Result<SpareSheet> spare =
        size ? rectangularSheet(*size, count) : io::readOffcut(what, count);
    if (!spare)
        status = report(spare.error());
    return spare ? std::optional(*spare) : std::nullopt;
}

} // namespace

void addSheetOptions(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &text, const char *value) {
        parser.addOption({QLatin1String(name), text, QLatin1String(value)});
    };
    add("sheet", tr("Size of a sheet, such as 600x400; with :N behind it, how many there are."),
        "WxH");
    add("offcut",
        tr("A sheet of another size, or what is left of one as the largest outline of an .svg file "
           "in true size, which is used up before whole ones; with :N behind it, so many of them; "
           "may be repeated."),
        "SHEET");
}

void readSheets(const QCommandLineParser &parser, const Verb &verb, DocumentOptions &options,
                std::optional<int> &status)
{
    if (parser.isSet(QStringLiteral("sheet"))) {
        const QString sheet = parser.value(QStringLiteral("sheet"));
        const auto [size, count] = counted(sheet);
        options.sheet = sizeOf(size);
        options.sheetCount = count;
        if (!options.sheet || (count && (*count < 1 || *count > kMostSheets)))
            status = wrongUse(verb, tr("--sheet: found \"%1\", expected width x height in mm, such "
                                       "as 600x400.")
                                        .arg(sheet));
    }
    for (const QString &offcut : parser.values(QStringLiteral("offcut")))
        if (!status)
            if (auto spare = offcutOf(offcut, verb, status))
                options.offcuts.push_back(*std::move(spare));
}

} // namespace fff::cli
