#include "ui/docks/model_page.h"

#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/properties/dimension_group.h"
#include "ui/properties/drawing_group.h"
#include "ui/properties/named_number_group.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/stock_choice.h"

#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace fff::ui {

namespace {

constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch};

} // namespace

ModelPage::ModelPage(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    auto *model = new PropertyGroup(tr("Model"), this);
    auto *drawing = new DrawingGroup(this);
    const auto add = [this](PropertyGroup *group, PropertyRow *row) {
        group->add(row);
        m_rows.push_back(row);
    };
    add(model, new ChoiceRow(
                   tr("Units"), "modelUnits",
                   [] {
                       Choices choices;
                       for (LengthUnit unit : kUnits)
                           choices.all.push_back({unitName(unit), QColor()});
                       choices.current = static_cast<int>(
                           std::find(std::begin(kUnits), std::end(kUnits), settings().unit()) -
                           std::begin(kUnits));
                       return choices;
                   },
                   [](int index) { settings().setUnit(kUnits[index]); }, model));
    add(model, new TextRow(
                   tr("Size"), "modelSize",
                   [this] {
                       const Vec3 size = Measures(m_bench.session()).size();
                       if (size.isZero())
                           return tr("nothing drawn yet");
                       return sizeText({size.x(), size.y(), size.z()}, 1, locale());
                   },
                   model));
    add(model,
        new TextRow(
            tr("Mass"), "modelMass",
            [this] { return massText(Measures(m_bench.session()).mass(), locale()); }, model));
    auto *stock = new ChoiceRow(
        tr("New sections"), "newStock",
        [this] {
            const Document &document = m_bench.session().model().document;
            return choicesOfStock(document, document.currentStock);
        },
        [this](int index) { chooseNewStock(m_bench, index); }, model);
    stock->setToolTip(tr("Stock of the sections that are drawn next"));
    stock->addButton(QStringLiteral("stocks"), "newStockEdit", tr("Edit the stock"), [this] {
        Q_EMIT stockWanted(m_bench.session().committed().document.currentStock);
    });
    add(model, stock);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(model);
    m_dimensions = new DimensionGroup(m_bench, this);
    m_numbers = new NamedNumberGroup(m_bench, this);
    column->addWidget(m_dimensions);
    column->addWidget(drawing);
    column->addWidget(m_numbers);
    // What is set once is out of the way until it is asked for.
    drawing->fold();
}

void ModelPage::refresh()
{
    for (PropertyRow *row : m_rows)
        row->refresh();
    m_dimensions->refresh();
    m_numbers->refresh();
}

} // namespace fff::ui
