#include "ui/dialogs/export_remarks.h"

#include "core/analysis/findings/few_sheets.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/fabrication/machine.h"
#include "core/fabrication/sheet_supply.h"
#include "core/io/error_text.h"
#include "core/session/check_list.h"
#include "core/session/message_text.h"
#include "ui/base/lengths.h"
#include "ui/bench/check_words.h"
#include "ui/bench/cutting_words.h"
#include "ui/bench/measures.h"
#include "ui/properties/stock_choice.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace fff::ui {

namespace {

struct ExportRemarksTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ExportRemarks)
};

// In the order in which they are said.
constexpr Subject kSaidGood[] = {Subject::Stability, Subject::Connection, Subject::Assembly,
                                 Subject::Strength, Subject::Size};

/// Whether all parts fit, and how many sheets that takes, is the drawing's to say: with the margin
/// that is chosen here, and as close together as parts lie.
bool isOfSheets(const Finding &finding)
{
    return finding.is(kTooLarge) || finding.is(kFitsSheet) || finding.is(kFewSheets);
}

ExportRemark remarkOf(const FindingRow &row, const Model &model)
{
    const CheckWords words = checkWords(row.finding, model);
    if (row.count() > 1)
        return {
            row.finding.severity,
            //: %1 is a verdict, %2 how often it is so, two at least
            ExportRemarksTexts::tr("%1, %2 times").arg(verdictText(row.finding)).arg(row.count()),
            {},
            row.finding,
            {}};
    return {row.finding.severity, words.title, words.text, row.finding, {}};
}

std::vector<SectionRef> sectionsCalled(const Model &model, const std::string &name)
{
    std::vector<SectionRef> found;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        if (model.section(i)->name == name)
            found.push_back(model.ref(i));
    return found;
}

void addOfChecks(const CheckList &checks, bool isDrawn, std::vector<ExportRemark> &remarks)
{
    for (const FindingRow &row : inRows(checks.all())) {
        const Severity severity = row.finding.severity;
        const bool isUnknown = severity == Severity::Unknown;
        if ((severity >= Severity::Warning || isUnknown) && !(isDrawn && isOfSheets(row.finding)))
            remarks.push_back(remarkOf(row, checks.model()));
    }
}

void addOfDrawing(const CuttingWork &work, std::vector<ExportRemark> &remarks)
{
    const Cutting *cutting = work.cutting();
    if (!cutting)
        return;
    const LayoutOptions &layout = work.made()->nested->question->nesting.layout;
    for (const Stock &stock : cutting->drawing.stocks)
        if (const QString why = noRoomText(stock, layout.margin); !why.isEmpty())
            remarks.push_back({Severity::Error, {}, why, {}, {}});
    if (work.made()->nested->question->compensatesKerf)
        for (const Stock &stock : cutting->drawing.stocks)
            if (!(stock.kerf > 0.0)) // as models of FlatFab have it
                remarks.push_back({Severity::Warning,
                                   {},
                                   //: %1 is a stock
                                   ExportRemarksTexts::tr("The kerf width of %1 is 0: slits become "
                                                          "wider, and parts smaller, by what the "
                                                          "machine removes.")
                                       .arg(stockName(stock)),
                                   {},
                                   {}});
    for (const CuttingRemark &remark : cuttingRemarks(*cutting))
        remarks.push_back({Severity::Warning,
                           {},
                           remark.text,
                           {},
                           sectionsCalled(work.made()->analysis->model, remark.section)});
}

/// Whoever does not look at the machine's numbers would send it beyond its end.
void addOfBed(const CuttingWork &work, const Machine &machine, std::vector<ExportRemark> &remarks)
{
    const Cutting *cutting = work.cutting();
    if (!cutting ||
        std::all_of(cutting->drawing.sheets.begin(), cutting->drawing.sheets.end(),
                    [&machine](const CuttingSheet &sheet) { return fitsBed(sheet.size, machine); }))
        return;
    remarks.push_back(
        {Severity::Warning,
         {},
         //: %1 is a machine, %2 the size of its bed
         ExportRemarksTexts::tr("Sheets are larger than the bed of %1, which is %2. Choose smaller "
                                "ones.")
             .arg(QString::fromStdString(machine.name),
                  sizeText({machine.bed.x(), machine.bed.y()}, 0, QLocale())),
         {},
         {}});
}

/// The verdict of a subject that nothing is said against; notes are not. Null: there is none.
const Finding *goodOf(const CheckList &checks, Subject subject)
{
    const Finding *good = nullptr;
    for (const Finding &finding : checks.all()) {
        if (finding.subject() != subject || finding.severity == Severity::Note)
            continue;
        if (finding.severity != Severity::Good)
            return nullptr;
        good = good ? good : &finding;
    }
    return good;
}

/// Nothing where none is known to be.
void addGood(const CheckList &checks, const CuttingWork &work, std::vector<ExportRemark> &remarks)
{
    QStringList verdicts;
    for (const Subject subject : kSaidGood) {
        if (const Cutting *cutting = work.cutting(); cutting && subject == Subject::Size) {
            if (cutting->oversized.empty() && cutting->missing.empty())
                verdicts += messageText(kFitsSheet.title);
            continue;
        }
        if (const Finding *good = goodOf(checks, subject))
            verdicts += verdictText(*good);
    }
    if (!verdicts.isEmpty())
        remarks.push_back({Severity::Good, {}, verdicts.join(QStringLiteral(" \u00B7 ")), {}, {}});
}

} // namespace

QString noRoomText(const Stock &stock, double margin)
{
    LayoutOptions layout;
    layout.margin = margin;
    if (hasRoom(stock, layout))
        return {};
    //: %1 is a stock, %2 a length
    return ExportRemarksTexts::tr("A sheet of %1 has no room within margins of %2.")
        .arg(stockName(stock), lengthText(margin, 0, 2, QLocale()));
}

bool ExportRemark::operator==(const ExportRemark &other) const
{
    return severity == other.severity && title == other.title && text == other.text &&
           sections == other.sections && finding.has_value() == other.finding.has_value() &&
           (!finding || isSameVerdict(*finding, *other.finding));
}

std::vector<ExportRemark> exportRemarks(const CheckList &checks, const CuttingWork &work,
                                        const Machine *machine)
{
    std::vector<ExportRemark> remarks;
    if (const auto why = work.whyNot())
        remarks.push_back({Severity::Error,
                           ExportRemarksTexts::tr("Cannot be cut"),
                           io::errorSentence(*why),
                           {},
                           {}});
    addOfChecks(checks, work.cutting() != nullptr, remarks);
    addOfDrawing(work, remarks);
    if (machine)
        addOfBed(work, *machine, remarks);
    std::stable_sort(
        remarks.begin(), remarks.end(),
        [](const ExportRemark &a, const ExportRemark &b) { return a.severity > b.severity; });
    // What was good of an older model is not said of this one.
    if (checks.age() == CheckList::Age::Current)
        addGood(checks, work, remarks);
    else
        remarks.push_back({Severity::Unknown, {}, ExportRemarksTexts::tr("Checking…"), {}, {}});
    if (remarks.empty())
        remarks.push_back(
            {Severity::Good, {}, ExportRemarksTexts::tr("Nothing to look out for."), {}, {}});
    return remarks;
}

} // namespace fff::ui
