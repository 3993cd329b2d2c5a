#include "app/cli/sheet_options.h"

#include "core/io/listing.h"
#include "core/io/offcut_file.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
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

/// What a person may not expect of it is printed.
Result<SpareSheet> offcutDrawn(const QString &path, int count)
{
    QStringList remarks;
    Result<SpareSheet> spare = io::readOffcut(path, count, &remarks);
    for (const QString &sentence : std::as_const(remarks))
        printError(sentence);
    return spare;
}

/// Whether it is one, so that no = in it is behind a name.
bool isSheet(const QString &text)
{
    const QString what = counted(text).first;
    return sizeOf(what) || QFileInfo::exists(what);
}

/// "Birch plywood=300x200:2": stocks and files may have an = in their names.
std::pair<QString, QString> namedSheet(const QString &text)
{
    if (isSheet(text))
        return {QString(), text};
    for (qsizetype at = text.indexOf(u'='); at > 0; at = text.indexOf(u'=', at + 1))
        if (isSheet(text.mid(at + 1)))
            return {text.left(at), text.mid(at + 1)};
    const qsizetype last = text.lastIndexOf(u'=');
    return {text.left(std::max<qsizetype>(0, last)), text.mid(last + 1)};
}

/// Of a size, else of a drawing.
std::optional<AskedOffcut> offcutOf(const QString &text, const Verb &verb,
                                    std::optional<int> &status)
{
    const auto [stock, sheet] = namedSheet(text);
    const auto [what, several] = counted(sheet);
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
        size ? rectangularSheet(*size, count) : offcutDrawn(what, count);
    if (!spare)
        status = report(spare.error());
    return spare ? std::optional(AskedOffcut{text, stock, *spare}) : std::nullopt;
}

/// Whose sections there are; of a model without any, that of the next one.
std::vector<StockId> stocksOf(const Document &document)
{
    const Model model = evaluate(document);
    std::vector<StockId> used;
    for (const auto &stock : document.stocks)
        for (std::size_t i = 0; i < model.sectionCount(); ++i)
            if (model.section(i)->stock == stock->id) {
                used.push_back(stock->id);
                break;
            }
    return used.empty() ? std::vector{document.currentStock} : used;
}

QString namesOf(const Document &document, const std::vector<StockId> &stocks)
{
    QStringList names;
    for (const StockId stock : stocks)
        names += QString::fromStdString(document.find(stock)->name);
    return io::enumerated(names, tr("%1 and %2"));
}

/// Of the stock that is named, whatever the case, or the only one; else why not.
tl::expected<StockId, QString> stockFor(const AskedOffcut &asked, const Document &document,
                                        const std::vector<StockId> &used)
{
    for (const auto &stock : document.stocks)
        if (QString::fromStdString(stock->name).compare(asked.stock, Qt::CaseInsensitive) == 0)
            return stock->id;
    if (!asked.stock.isEmpty())
        //: %1 is what was typed, %2 the name of a stock, %3 names of stocks
        return tl::unexpected(tr("--offcut %1: the model has no stock \"%2\"; it is cut from %3.")
                                  .arg(asked.text, asked.stock, namesOf(document, used)));
    if (used.size() == 1)
        return used.front();
    return tl::unexpected(tr("--offcut %1: the model is cut from %2. Say of which this one is, as "
                             "in \"%3=%1\".")
                              .arg(asked.text, namesOf(document, used),
                                   QString::fromStdString(document.find(used.front())->name)));
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
           "in true size, which is used up before whole ones; with :N behind it, so many of them. "
           "Of a model of several stocks with the stock's name in front: \"Birch "
           "plywood=300x200\". May be repeated."),
        "[STOCK=]SHEET");
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
            if (auto asked = offcutOf(offcut, verb, status))
                options.offcuts.push_back(*std::move(asked));
}

std::optional<int> applyOffcuts(Document &document, const DocumentOptions &options,
                                const Verb &verb)
{
    if (options.offcuts.empty())
        return std::nullopt;
    const std::vector<StockId> used = stocksOf(document);
    for (const AskedOffcut &asked : options.offcuts) {
        const auto id = stockFor(asked, document, used);
        if (!id)
            return wrongUse(verb, id.error());
        Stock stock = *document.find(*id);
        stock.spares.push_back(asked.sheet);
        Result<Document> next = setStock(document, stock);
        if (!next)
            return wrongUse(verb, tr("--offcut: so many offcuts of the stock %1 are too many.")
                                      .arg(QString::fromStdString(stock.name)));
        document = std::move(*next);
    }
    return std::nullopt;
}

} // namespace fff::cli
