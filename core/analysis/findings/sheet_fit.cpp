#include "core/analysis/findings/sheet_fit.h"

#include "core/analysis/findings/few_sheets.h"
#include "core/analysis/nested.h"
#include "core/fabrication/summary.h"

#include <algorithm>

namespace fff {

namespace {

Message sheetCount(const SheetUse &use)
{
    if (use.sheets == 1)
        return {FFF_TEXT("Checks", "1 sheet"), {}};
    if (use.isNested)
        return {FFF_TEXT_OF_MANY("Checks", "%n sheets"), {}, use.sheets};
    //: in the middle of a sentence that begins with something else
    return {FFF_TEXT_OF_MANY("Checks", "At most %n sheets"), {}, use.sheets};
}

Message fitsSentence(const Finding &finding, const Model &)
{
    const SheetUse &use = *finding.details<SheetUse>();
    if (use.sheets == 0)
        return {FFF_TEXT("Checks", "Fits the sheets and offcuts that there are."), {}};
    const Message sheets = sheetCount(use);
    const WidthAndHeight size{use.sheet.x(), use.sheet.y()};
    if (use.sheet.isZero())
        return use.isNested ? Message{FFF_TEXT("Checks", "Fits the sheet. %1, %2 % used."),
                                      {sheets, percentOf(use.share)}}
                            : Message{FFF_TEXT("Checks", "Fits the sheet. %1."), {sheets}};
    return use.isNested ? Message{FFF_TEXT("Checks", "Fits the sheet. %1 of %2, %3 % used."),
                                  {sheets, size, percentOf(use.share)}}
                        : Message{FFF_TEXT("Checks", "Fits the sheet. %1 of %2."), {sheets, size}};
}

Message tooLargeSentence(const Finding &finding, const Model &model)
{
    const TooLargePart &part = *finding.details<TooLargePart>();
    const Named name = nameAt(finding, model, 0);
    const WidthAndHeight sheet{part.sheet.x(), part.sheet.y()};
    if (part.parts > 1)
        return {FFF_TEXT("Checks", "%1 parts of %2 fit no sheet of %3 with a margin of %4, however "
                                   "they are turned."),
                {part.parts, name, sheet, lengthOf(part.margin)}};
    return {FFF_TEXT("Checks", "%1 measures %2 and fits no sheet of %3 with a margin of %4, "
                               "however it is turned."),
            {name, WidthAndHeight{part.size.x(), part.size.y()}, sheet, lengthOf(part.margin)}};
}

/// Of all sheets; zero where they are of several sizes.
Vec2 commonSize(const std::vector<Sheet> &sheets)
{
    const bool areSame =
        !sheets.empty() && std::all_of(sheets.begin(), sheets.end(), [&](const Sheet &sheet) {
            return sheet.size == sheets.front().size;
        });
    return areSame ? sheets.front().size : Vec2::Zero();
}

bool hasSpares(const Document &document)
{
    return std::any_of(document.stocks.begin(), document.stocks.end(),
                       [](const auto &stock) { return !stock->spares.empty(); });
}

/// Beside whole sheets there is a rectangular one that it fits.
bool fitsSpare(const Model &model, const Bodies &bodies, int part, const LayoutOptions &options)
{
    const Stock &stock = model.stockOf(static_cast<std::size_t>(bodies.sectionOf(part)));
    return std::any_of(stock.spares.begin(), stock.spares.end(), [&](const SpareSheet &spare) {
        return rectangleOf(spare) && !sizeOf(bodies.at(part).outline(),
                                             roomOf(spare.size(), options), options.turnsFreely)
                                          .isTooLarge;
    });
}

constexpr Text kChooseText = FFF_TEXT("Checks", "Choose a sheet");

std::vector<FindingAction> chooseSheet(const Finding &, const Analysis &)
{
    return {{&kChooseSheet}};
}

} // namespace

const ActionKind kChooseSheet{plainWords<kChooseText>};

const FindingKind kFitsSheet{"fitsSheet", Subject::Size, FFF_TEXT("Checks", "Fits the sheet"),
                             fitsSentence};
const FindingKind kTooLarge{"tooLarge", Subject::Size,
                            FFF_TEXT("Checks", "Too large for the sheet"), tooLargeSentence,
                            chooseSheet};

void findSheetFit(const Looked &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    const LayoutOptions &options = at.layout;
    std::vector<SizedPart> parts;
    for (std::size_t i = 0; i < at.caches.sections.size(); ++i)
        for (const auto &size : at.caches.sections[i].sizes)
            parts.push_back({model.section(i)->stock, size});
    const Layout layout = layOutBySize(parts, model, options, at.caches.layout);
    const Bodies &bodies = at.analysis.bodies;
    std::vector<int> oversized = layout.oversized;
    std::erase_if(oversized, [&](int part) { return fitsSpare(model, bodies, part, options); });
    std::sort(oversized.begin(), oversized.end());
    for (std::size_t i = 0; i < oversized.size();) {
        const Body &body = bodies.at(oversized[i]);
        const int section = bodies.sectionOf(oversized[i]);
        const Box2 box = bounds(body.outline().region.outer);
        TooLargePart part;
        part.size = {box.size().maxCoeff(), box.size().minCoeff()};
        part.sheet = options.sheet.value_or(model.stockOf(static_cast<std::size_t>(section)).sheet);
        part.margin = options.margin;
        part.parts = 0;
        while (i < oversized.size() && bodies.sectionOf(oversized[i]) == section) {
            ++part.parts;
            ++i;
        }
        Finding finding = makeFinding(kTooLarge, Severity::Error, part);
        finding.sections = {body.key().section};
        finding.at = body.frame().toWorld(box.center());
        found.push_back(std::move(finding));
    }
    const auto before = found.size();
    if (!options.sheet)
        findFewSheets(model, layout, found);
    if (!oversized.empty() || found.size() > before)
        return;
    if (hasSpares(model.document)) {
        found.push_back(makeFinding(kFitsSheet, Severity::Good, SheetUse()));
        return;
    }
    const SheetUse use{static_cast<int>(layout.sheets.size()), commonSize(layout.sheets)};
    found.push_back(makeFinding(kFitsSheet, Severity::Good, use));
}

std::optional<SheetUse> sheetUseOf(const Nested &nested)
{
    if (!nested.layout || !nested.cutting || !nested.layout->oversized.empty())
        return std::nullopt;
    const std::vector<Sheet> &sheets = nested.layout->sheets;
    return SheetUse{nested.cutting->sheetCount(), commonSize(sheets), true, nested.filled};
}

} // namespace fff
