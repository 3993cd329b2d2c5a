#include "ui/dialogs/slit_rows.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct SlitRowsTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::SlitRows)
};

/// In the order of SlitEnd.
Choices endChoices(SlitEnd current)
{
    return {{{SlitRowsTexts::tr("Square"), {}},
             {SlitRowsTexts::tr("Round"), {}},
             {SlitRowsTexts::tr("Dogbone"), {}},
             {SlitRowsTexts::tr("T-bone"), {}}},
            static_cast<int>(current)};
}

void explain(PropertyRow *row, const char *editor, const QString &text)
{
    row->setToolTip(text);
    if (auto *widget = row->findChild<QWidget *>(QLatin1String(editor)))
        widget->setAccessibleDescription(text);
}

LengthRow *lengthRow(PropertyGroup *group, const StockAccess &stock, const QString &name,
                     const char *objectName, const LengthEdit::Range &range, double Stock::*value,
                     const char *field)
{
    auto *row = new LengthRow(
        name, objectName, range, [stock, value] { return std::optional(stock.read()->*value); },
        [stock, value](double mm) { stock.edit([&](Stock &s) { s.*value = mm; }); }, group);
    row->setThickness([stock] { return std::optional(stock.read()->thickness); });
    row->setFollowed(stock.followed(field));
    group->add(row);
    return row;
}

} // namespace

std::vector<PropertyRow *> addSlitRows(PropertyGroup *group, const StockAccess &stock)
{
    auto *end = new ChoiceRow(
        SlitRowsTexts::tr("Slit end"), "stockSlitEnd",
        [stock] { return endChoices(stock.read()->slitEnd); },
        [stock](int choice) {
            stock.edit([choice](Stock &s) { s.slitEnd = static_cast<SlitEnd>(choice); });
        },
        group);
    explain(end, "stockSlitEnd",
            SlitRowsTexts::tr(
                "The inner end of a slit. A laser cuts it square; a mill's round tool cannot reach "
                "its corners. Round: a round bottom beyond the square one. Dogbone: an arc through "
                "each corner. T-bone: an arc in each wall; the bottom stays flat."));
    group->add(end);

    LengthRow *tool = lengthRow(group, stock, SlitRowsTexts::tr("Tool"), "stockTool",
                                {0.1, 25.0, 0.1, 2, 3}, &Stock::toolDiameter, "toolDiameter");
    // Shows nothing: whether there is a tool hangs on the end.
    auto *reason = new EditorRow(
        QString(), "", nullptr,
        [stock, tool] {
            const bool isMilled = stock.read()->slitEnd != SlitEnd::Square;
            tool->setEnabled(isMilled);
            explain(
                tool, "stockTool",
                isMilled
                    ? SlitRowsTexts::tr("Diameter of the mill's tool. The arcs are drawn a little "
                                        "larger, so that it goes round them.")
                    : SlitRowsTexts::tr("A square end has no tool. Choose another slit end for a "
                                        "mill."));
        },
        group);

    LengthRow *leadIn = lengthRow(group, stock, SlitRowsTexts::tr("Lead-in"), "stockLeadIn",
                                  {0.0, 20.0, 0.1, 1, 3}, &Stock::leadIn, "leadIn");
    explain(leadIn, "stockLeadIn",
            SlitRowsTexts::tr("Chamfer of both walls at a slit's mouth, at 45°, so that sections "
                              "slide in easily. Half to all of the thickness is usual; 0: none."));
    LengthRow *bumps = lengthRow(group, stock, SlitRowsTexts::tr("Friction bumps"), "stockBumps",
                                 {0.0, 1.0, 0.01, 2, 3}, &Stock::bumps, "bumps");
    explain(bumps, "stockBumps",
            SlitRowsTexts::tr(
                "Height of a small bump on each wall of a slit, which presses on the section "
                "in it. It has to be more than half of the clearance; 0: none."));
    return {end, tool, reason, leadIn, bumps};
}

} // namespace fff::ui
