#include "ui/properties/dimension_group.h"

#include "core/base/tolerances.h"
#include "core/model/dimensions.h"
#include "ui/bench/workbench.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct DimensionGroupTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::DimensionGroup)
};

constexpr LengthEdit::Range kLength{0.001, kMaxCoordinate, 0.5, 1, 3};

} // namespace

DimensionGroup::DimensionGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(DimensionGroupTexts::tr("Dimensions"), parent), m_bench(bench), m_rows(*this)
{
}

std::optional<double> DimensionGroup::length(std::size_t index) const
{
    const Model &model = m_bench.session().model();
    if (index >= model.document.dimensions.size())
        return std::nullopt;
    const Dimension &dimension = model.document.dimensions[index];
    const auto from = placeOf(model, dimension.from), to = placeOf(model, dimension.to);
    return from && to ? std::optional((*to - *from).norm()) : std::nullopt;
}

void DimensionGroup::add(std::size_t index)
{
    const QString id = QStringLiteral("dimension%1").arg(index);
    auto *row = new LengthRow(
        //: %1 is a number
        DimensionGroupTexts::tr("Dimension %1").arg(index + 1), id.toLatin1().constData(), kLength,
        [this, index] { return length(index); },
        [this, index](double value) {
            m_bench.run(QStringLiteral("measure.scale"),
                        {{"dimension", std::to_string(index)},
                         {"length", QString::number(value, 'g', 17).toStdString()}});
        },
        this);
    row->setToolTip(DimensionGroupTexts::tr("Changing this length scales the whole model"));
    row->addButton(
        QStringLiteral("trash"), (id + QStringLiteral(".delete")).toLatin1().constData(),
        DimensionGroupTexts::tr("Delete this dimension"), [this, index] {
            m_bench.run(QStringLiteral("measure.remove"), {{"dimension", std::to_string(index)}});
        });
    m_rows.add(row);
}

void DimensionGroup::refresh()
{
    const std::size_t count = m_bench.session().model().document.dimensions.size();
    setVisible(count > 0);
    if (m_rows.become(QString::number(count)))
        for (std::size_t i = 0; i < count; ++i)
            add(i);
    m_rows.refresh();
}

} // namespace fff::ui
