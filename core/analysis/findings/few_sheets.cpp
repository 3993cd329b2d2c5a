#include "core/analysis/findings/few_sheets.h"

#include "core/fabrication/sheet_supply.h"

namespace fff {

namespace {

Message fewSentence(const Finding &finding, const Model &)
{
    const FewSheets &few = *finding.details<FewSheets>();
    //: %n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it
    return {FFF_TEXT_OF_MANY("Checks",
                             "May run out of sheets. It takes up to %n sheets of %1, and you have "
                             "%2."),
            {Named{few.stock}, few.there},
            few.taken};
}

} // namespace

const FindingKind kFewSheets{
    .name = "fewSheets",
    .subject = Subject::Size,
    .title = FFF_TEXT("Checks", "May run out of sheets"),
    .sentence = fewSentence,
    .advice = FFF_TEXT("Checks", "Look in Sheets how closely the parts can lie.")};

void findFewSheets(const Model &model, const Layout &layout, std::vector<Finding> &found)
{
    for (const auto &stock : model.document.stocks) {
        const int missing = missingSheets(layout, *stock);
        if (missing > 0)
            found.push_back(makeFinding(
                kFewSheets, Severity::Warning,
                FewSheets{stock->name, *stock->sheetCount + missing, *stock->sheetCount}));
    }
}

} // namespace fff
