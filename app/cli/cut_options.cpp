#include "app/cli/cut_options.h"

#include "core/fabrication/cutting_order.h"
#include "core/fabrication/fit_coupon.h"
#include "core/fabrication/machine.h"
#include "core/fabrication/sheet_supply.h"
#include "core/io/coupon_words.h"
#include "core/io/document_file.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

const QString kTabs = QStringLiteral("tabs"), kLead = QStringLiteral("lead"),
              kCommonLines = QStringLiteral("common-lines");

/// "3" or "3:0.4".
bool readTabs(const QString &text, CutFinish &finish)
{
    const QStringList words = text.split(u':');
    bool isCount = false, isWidth = true;
    finish.tabs = words.front().toInt(&isCount);
    if (words.size() > 1)
        finish.tabWidth = words[1].toDouble(&isWidth);
    return words.size() <= 2 && isCount && isWidth && finish.tabs >= 0 &&
           finish.tabs <= kMostTabs && finish.tabWidth >= kLeastTabWidth &&
           finish.tabWidth <= kMostTabWidth;
}

/// Of an empty model that of the next section.
std::vector<Stock> stocksOfSections(const Document &document)
{
    std::vector<Stock> stocks;
    for (const auto &stock : document.stocks)
        if (std::any_of(document.sections.begin(), document.sections.end(),
                        [&](const auto &section) { return section->stock == stock->id; }))
            stocks.push_back(*stock);
    const Stock *next = document.find(document.currentStock);
    if (stocks.empty() && next)
        stocks.push_back(*next);
    return stocks;
}

/// A sentence for each range of slits, with the names of stocks where there are several.
void explainCoupon(const std::vector<Stock> &stocks)
{
    const auto number = [](double mm) { return QString::number(mm, 'f', 2); };
    std::vector<std::pair<CouponRange, QStringList>> ranges;
    for (const Stock &stock : stocks) {
        const CouponRange range = couponRange(stock).value_or(CouponRange());
        const auto known = std::find_if(ranges.begin(), ranges.end(),
                                        [&](const auto &one) { return one.first == range; });
        const QString name = QString::fromStdString(stock.name);
        if (known == ranges.end())
            ranges.emplace_back(range, QStringList(name));
        else
            known->second += name;
    }
    for (const auto &[range, names] : ranges) {
        const QString sentence =
            tr("Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the "
               "stock the clearance of the one that fits.")
                .arg(QString::number(range.first), QString::number(range.last),
                     number(clearanceOfSlit(range.first)), number(clearanceOfSlit(range.last)));
        //: %1 are names of stocks, %2 is a sentence
        printError(ranges.size() < 2
                       ? sentence
                       : tr("%1: %2").arg(names.join(QStringLiteral(", ")), sentence));
    }
    printError(tr("Push all %1 slats together: what their width is less than %2 mm, divided by %1, "
                  "is the kerf.")
                   .arg(kCouponSlats)
                   .arg(kCouponSlats * kCouponSlat));
}

} // namespace

void addCutOptions(QCommandLineParser &parser)
{
    parser.addOption({kTabs,
                      tr("Bridges that hold each part in its sheet, and their width in mm, such as "
                         "3:0.4 (none)."),
                      QStringLiteral("N:W")});
    parser.addOption({kLead,
                      tr("Begins and ends each cut so far beside its line, in the waste (0)."),
                      QStringLiteral("MM")});
    parser.addOption(
        {kCommonLines,
         tr("Cuts edges of two parts that lie on each other once; with --spacing 0.")});
    parser.addOption({QStringLiteral("coupon"),
                      tr("Writes a test piece in place of the parts: slits of numbered widths, and "
                         "slats that tell the kerf.")});
}

std::optional<CutFinish> finishAsked(const QCommandLineParser &parser, const Machine *machine,
                                     QString &why)
{
    if (!parser.isSet(kTabs) && !parser.isSet(kLead) && !parser.isSet(kCommonLines))
        return std::nullopt;
    CutFinish finish = machine ? machine->finish : CutFinish();
    if (parser.isSet(kTabs) && !readTabs(parser.value(kTabs), finish))
        why = tr("--tabs: found \"%1\", expected a number from 0 to %2, then a colon and a width "
                 "from %3 to %4.")
                  .arg(parser.value(kTabs))
                  .arg(kMostTabs)
                  .arg(kLeastTabWidth)
                  .arg(kMostTabWidth);
    if (parser.isSet(kLead)) {
        bool isNumber = false;
        finish.lead = parser.value(kLead).toDouble(&isNumber);
        if (!isNumber || !(finish.lead >= 0.0 && finish.lead <= kMostLead))
            why = tr("--%1: found \"%2\", expected a number from 0 to %3.")
                      .arg(kLead, parser.value(kLead), QString::number(kMostLead, 'f', 0));
    }
    finish.sharesCuts = finish.sharesCuts || parser.isSet(kCommonLines);
    return finish;
}

QString whyNoRoom(const std::vector<Stock> &stocks, const LayoutOptions &options)
{
    const auto stock = std::find_if(stocks.begin(), stocks.end(),
                                    [&](const Stock &one) { return !hasRoom(one, options); });
    return stock == stocks.end()
               ? QString()
               //: %1 is a stock, %2 a length
               : tr("Sheets of %1 have no room within margins of %2 mm.")
                     .arg(QString::fromStdString(stock->name), QString::number(options.margin));
}

void explainSharedCuts(const CuttingDrawing &drawing)
{
    const Machine &machine = machineOf(drawing);
    double once = 0.0;
    bool isAsked = false;
    for (CuttingSheet sheet : drawing.sheets) {
        if (!sheet.finish.sharesCuts)
            continue;
        isAsked = true;
        const auto cutBy = [&](const CutFinish &finish) {
            sheet.finish = finish;
            return wayAlong(inCuttingOrder(sheet), machine).cut;
        };
        CutFinish shared;
        shared.sharesCuts = true;
        once += cutBy({}) - cutBy(shared);
    }
    constexpr double kLeastSaid = 0.5; // mm
    if (once >= kLeastSaid)
        //: %1 is a length
        printError(
            tr("Cut once for two parts: %1 mm.").arg(QString::number(std::round(once), 'f', 0)));
    else if (isAsked)
        printError(tr("No edges of two parts lie on each other: nothing is cut once. With "
                      "--spacing 0 straight edges can."));
}

void explainLeads(const CuttingDrawing &drawing)
{
    QStringList names;
    for (const CuttingSheet &sheet : drawing.sheets)
        for (const std::size_t part : partsWithoutLead(sheet))
            names += QString::fromStdString(sheet.parts[part].name());
    names.removeDuplicates();
    if (!names.isEmpty())
        printError(
            tr("No room for the leads of all cuts: %1").arg(names.join(QStringLiteral(", "))));
}

int writeCoupon(const io::Format &format, const io::FormatValues &values, const QString &path,
                const Document &document, const std::shared_ptr<const Machine> &machine)
{
    const std::vector<Stock> stocks = stocksOfSections(document);
    const Result<void> written =
        fitCoupon(stocks, machine, io::couponWords())
            .and_then(
                [&](const CuttingDrawing &drawing) { return format.writeCutting(drawing, values); })
            .and_then([&path](const std::string &bytes) { return io::writeFile(path, bytes); });
    if (!written)
        return report(written.error());
    explainCoupon(stocks);
    return Done;
}

} // namespace fff::cli
