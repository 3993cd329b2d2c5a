#include "ui/sheets/layout_group.h"

#include "core/model/edits.h"
#include "core/model/materials.h"
#include "core/session/sheet_nesting.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/stock_words.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/stock_choice.h"
#include "ui/properties/turning_choices.h"
#include "ui/view/view_style.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr Text kChangeSheet = FFF_TEXT("Step", "Set up cutting");

} // namespace

LayoutGroup::LayoutGroup(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    m_group = new PropertyGroup(tr("Layout"), this);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_group);
    addStock();
    addSheet();
    addTurning();
    addLength(tr("Spacing"), "sheetsSpacing", kMostSpacing, &LayoutOptions::spacing);
    addLength(tr("Margin"), "sheetsMargin", kMostMargin, &LayoutOptions::margin);
    addHoles();
    PropertyRow::alignLabels(m_rows);
    refresh();
}

void LayoutGroup::add(PropertyRow *row)
{
    m_group->add(row);
    m_rows.push_back(row);
}

std::vector<StockId> LayoutGroup::stocks() const
{
    const Model &model = m_bench.session().committed();
    std::vector<StockId> used;
    for (const auto &stock : model.document.stocks)
        for (std::size_t i = 0; i < model.sectionCount(); ++i)
            if (model.section(i)->stock == stock->id) {
                used.push_back(stock->id);
                break;
            }
    return used;
}

StockId LayoutGroup::stock() const
{
    const std::vector<StockId> used = stocks();
    if (std::find(used.begin(), used.end(), m_chosen) != used.end())
        return m_chosen;
    return used.empty() ? m_bench.session().committed().document.currentStock : used.front();
}

void LayoutGroup::addStock()
{
    m_stock = new ChoiceRow(
        tr("Stock"), "sheetsStock",
        [this] {
            Choices choices;
            for (const StockId id : stocks()) {
                const Stock &one = *m_bench.session().committed().document.find(id);
                if (id == stock())
                    choices.current = static_cast<int>(choices.all.size());
                choices.all.push_back({stockText(one, locale()), stockLook(one).face});
            }
            return choices;
        },
        [this](int choice) {
            m_chosen = stocks()[static_cast<std::size_t>(choice)];
            refresh();
        },
        m_group);
    add(m_stock);
}

void LayoutGroup::addSheet()
{
    const auto read = [this] {
        const Stock &of = *m_bench.session().committed().document.find(stock());
        // Without their names, which the column has no room for: Export has them.
        const auto choiceOf = [this](const Vec2 &size) {
            return Choice{sizeText({size.x(), size.y()}, 0, locale()), {}};
        };
        Choices choices;
        for (const SheetSize &sheet : commonSheets()) {
            if (sheet.size == of.sheet)
                choices.current = static_cast<int>(choices.all.size());
            choices.all.push_back(choiceOf(sheet.size));
        }
        if (choices.current < 0) { // its own size, as the stock has it
            choices.current = static_cast<int>(choices.all.size());
            choices.all.push_back(choiceOf(of.sheet));
        }
        return choices;
    };
    const auto write = [this](int choice) {
        const auto all = commonSheets();
        const Document &document = m_bench.session().committed().document;
        Stock next = *document.find(stock());
        if (static_cast<std::size_t>(choice) >= all.size())
            return;
        next.sheet = all[static_cast<std::size_t>(choice)].size;
        m_bench.commit(Step{kChangeSheet}, setStock(document, std::move(next)));
    };
    add(new ChoiceRow(tr("Sheet"), "sheetsSheet", read, write, m_group));
}

void LayoutGroup::addTurning()
{
    add(new ChoiceRow(
        tr("Rotation"), "sheetsRotation",
        [] { return turningChoices(rememberedChoices().turning); },
        [this](int choice) {
            choose([choice](ExportChoices &choices) { choices.turning = turningOf(choice); });
        },
        m_group));
}

void LayoutGroup::addLength(const QString &name, const char *objectName, double most,
                            double LayoutOptions::*value)
{
    add(new LengthRow(
        name, objectName, {0.0, most, 0.5, 1, 2},
        [value] { return std::optional(rememberedChoices().layout.*value); },
        [this, value](double mm) {
            choose([value, mm](ExportChoices &choices) { choices.layout.*value = mm; });
        },
        m_group));
}

void LayoutGroup::addHoles()
{
    m_holes = new QCheckBox;
    auto *row = new EditorRow(
        tr("Parts in holes"), "sheetsHoles", m_holes,
        [this] { m_holes->setChecked(rememberedChoices().fillsHoles); }, m_group);
    row->setToolTip(tr("Small parts may lie in the holes of large ones"));
    connect(m_holes, &QCheckBox::clicked, this, [this](bool isOn) {
        choose([isOn](ExportChoices &choices) { choices.fillsHoles = isOn; });
    });
    add(row);
}

void LayoutGroup::choose(const std::function<void(ExportChoices &)> &change)
{
    ExportChoices choices = rememberedChoices();
    change(choices);
    rememberChoices(choices);
    m_bench.nesting().setOptions(choices.nesting());
    refresh();
}

void LayoutGroup::refresh()
{
    m_stock->setVisible(stocks().size() > 1);
    for (PropertyRow *row : m_rows)
        row->refresh();
}

} // namespace fff::ui
