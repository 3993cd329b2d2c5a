#include "ui/properties/dimension_group.h"

#include "core/base/tolerances.h"
#include "core/interaction/value_editing.h"
#include "core/model/dimensions.h"
#include "core/operations/drivable.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"

#include <QCoreApplication>

#include <algorithm>

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

/// Of one drawn section: what can be stretched.
std::optional<DrivenPlace> DimensionGroup::place(std::size_t index) const
{
    const Document &document = m_bench.session().model().document;
    if (index >= document.dimensions.size())
        return std::nullopt;
    const DrivenPlace place{.of = DrivenPlace::Of::Dimension,
                            .id = document.dimensions[index].id.value,
                            .field = "length"};
    return drivenNumber(document, place) ? std::optional(place) : std::nullopt;
}

void DimensionGroup::change(std::size_t index, double length)
{
    const std::string number = QString::number(length, 'g', 17).toStdString();
    if (const std::optional<DrivenPlace> stretched = place(index))
        m_bench.editSections(numberBound(m_bench.session().committed().document, *stretched,
                                         number + " mm", Reading()));
    else
        m_bench.run(QStringLiteral("measure.scale"),
                    {{"dimension", std::to_string(index)}, {"length", number}});
    m_rows.refresh(); // what was refused goes back to what it was
}

/// Of one that is on a section alone, that; several of it are told apart by their places in the
/// list.
QString DimensionGroup::name(std::size_t index) const
{
    const Document &document = m_bench.session().model().document;
    const auto sectionOf = [&document](const Dimension &of) {
        return of.from.section == of.to.section ? document.find(of.from.section.drawn) : nullptr;
    };
    const Section *section = sectionOf(document.dimensions[index]);
    if (!section)
        //: %1 is a number
        return DimensionGroupTexts::tr("Dimension %1").arg(index + 1);
    const auto begin = document.dimensions.begin();
    const auto isOnIt = [&](const Dimension &other) { return sectionOf(other) == section; };
    const QString name = QString::fromStdString(section->name);
    if (std::count_if(begin, document.dimensions.end(), isOnIt) == 1)
        return name;
    //: %1 is the name of a section, %2 a number
    return DimensionGroupTexts::tr("%1 (%2)").arg(name).arg(
        1 + std::count_if(begin, begin + static_cast<std::ptrdiff_t>(index), isOnIt));
}

QString DimensionGroup::tip(std::size_t index) const
{
    const Document &document = m_bench.session().model().document;
    if (!place(index))
        return DimensionGroupTexts::tr("Changing this length scales the whole model");
    const Section *section = document.find(document.dimensions[index].from.section.drawn);
    //: %1 is the name of a section
    return DimensionGroupTexts::tr("Changing this length stretches %1 between the two places")
        .arg(QString::fromStdString(section->name));
}

void DimensionGroup::add(std::size_t index)
{
    const QString id = QStringLiteral("dimension%1").arg(index);
    auto *row = new LengthRow(
        name(index), id.toLatin1().constData(), kLength, [this, index] { return length(index); },
        [this, index](double value) { change(index, value); }, this);
    row->setFollowed(followedAt(m_bench, [this, index] { return place(index); }));
    row->addButton(
        QStringLiteral("trash"), (id + QStringLiteral(".delete")).toLatin1().constData(),
        DimensionGroupTexts::tr("Delete this dimension"), [this, index] {
            m_bench.run(QStringLiteral("measure.remove"), {{"dimension", std::to_string(index)}});
        });
    m_lengths.push_back(row);
    m_rows.add(row);
}

void DimensionGroup::refresh()
{
    const std::size_t count = m_bench.session().model().document.dimensions.size();
    setVisible(count > 0);
    QStringList names;
    for (std::size_t i = 0; i < count; ++i)
        names += name(i);
    if (m_rows.become(names.join(u'\n'))) {
        m_lengths.clear();
        for (std::size_t i = 0; i < count; ++i)
            add(i);
    }
    m_rows.refresh();
    for (std::size_t i = 0; i < m_lengths.size(); ++i)
        m_lengths[i]->setToolTip(tip(i));
}

} // namespace fff::ui
