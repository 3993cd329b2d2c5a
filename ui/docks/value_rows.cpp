#include "ui/docks/value_rows.h"

#include "core/interaction/value_editing.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/docks/value_row.h"
#include "ui/properties/property_rows.h"

#include <QPointer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

/// Of those that are not shown to others: as many are no burden.
constexpr std::size_t kMostUnfolded = 3;

} // namespace

ValueRows::ValueRows(Workbench &bench, QWidget *parent)
    : QWidget(parent), m_bench(bench), m_column(new QVBoxLayout(this))
{
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
}

void ValueRows::setAdjustsOnly(bool only)
{
    m_adjustsOnly = only;
    for (ValueRow *row : m_rows)
        row->setAdjustsOnly(only);
}

/// In the order in which each is first met, without a name first. While nothing is shown to others,
/// whether something is says nothing.
std::vector<ValueRows::Heading> ValueRows::headings() const
{
    const Values &values = m_bench.session().model().document.values;
    const bool hasShown = hasShownValue(values);
    std::vector<Heading> headings{{}};
    Heading hidden{{}, true, {}};
    for (const ValuePointer &known : values.list) {
        const Value &value = known->value;
        if (!value.isShown && (hasShown || m_adjustsOnly)) {
            hidden.values.push_back(value.id);
            continue;
        }
        auto heading = std::find_if(headings.begin(), headings.end(), [&value](const Heading &one) {
            return one.group == value.group;
        });
        if (heading == headings.end())
            heading = headings.insert(heading, {value.group, false, {}});
        heading->values.push_back(value.id);
    }
    if (headings.front().values.empty())
        headings.erase(headings.begin());
    if (!m_adjustsOnly && !hidden.values.empty())
        headings.push_back(std::move(hidden));
    return headings;
}

ValueRow *ValueRows::takenRow(std::vector<ValueRow *> &before, ValueId value)
{
    const auto found = std::find_if(before.begin(), before.end(), [value](const ValueRow *row) {
        return row && row->value() == value;
    });
    if (found != before.end())
        return std::exchange(*found, nullptr);
    auto *row = new ValueRow(m_bench, value, this);
    row->setObjectName(QStringLiteral("valueRow"));
    row->setAdjustsOnly(m_adjustsOnly);
    connect(row, &ValueRow::hovered, this,
            [this, value](bool isOver) { Q_EMIT hovered(value, isOver); });
    row->refresh();
    dress(row);
    return row;
}

void ValueRows::arrange(const std::vector<Heading> &headings)
{
    const QPointer<QWidget> focus =
        isAncestorOf(window()->focusWidget()) ? window()->focusWidget() : nullptr;
    std::vector<ValueRow *> before = std::move(m_rows);
    const std::vector<PropertyGroup *> groupsBefore = std::move(m_groups);
    m_rows.clear();
    m_groups.clear();
    for (const Heading &heading : headings) {
        const QString name =
            heading.isHidden ? tr("Only for you") : QString::fromStdString(heading.group);
        auto *group = new PropertyGroup(name, this);
        group->setObjectName(QStringLiteral("valueHeading"));
        for (const ValueId value : heading.values) {
            ValueRow *row = takenRow(before, value);
            group->add(row);
            row->show();
            m_rows.push_back(row);
        }
        m_column->addWidget(group);
        dress(group);
        group->fold(heading.isHidden && heading.values.size() > kMostUnfolded && !isHiddenWrong());
        group->show();
        m_groups.push_back(group);
    }
    m_headings = headings;
    for (ValueRow *row : before) {
        if (!row)
            continue;
        Q_EMIT hovered(row->value(), false);
        row->setParent(this); // not with the group that it was in
        row->hide();
        row->deleteLater(); // it may be the one who asks
    }
    for (PropertyGroup *group : groupsBefore)
        delete group;
    if (focus)
        focus->setFocus(Qt::OtherFocusReason);
}

/// What is wrong is not folded away.
bool ValueRows::isHiddenWrong() const
{
    const Model &model = m_bench.session().model();
    return std::any_of(model.document.values.list.begin(), model.document.values.list.end(),
                       [&model](const ValuePointer &known) {
                           return !known->value.isShown &&
                                  model.evaluation.values.error(known->value.id);
                       });
}

void ValueRows::refresh()
{
    if (const std::vector<Heading> now = headings(); now != m_headings)
        arrange(now);
    for (ValueRow *row : m_rows)
        row->refresh();
    if (!m_headings.empty() && m_headings.back().isHidden && isHiddenWrong())
        m_groups.back()->fold(false);
    setHidden(m_rows.empty());
}

void ValueRows::forgetRefusals()
{
    for (ValueRow *row : m_rows)
        row->forgetRefusal();
}

void ValueRows::beginNaming(ValueId value)
{
    for (std::size_t i = 0, first = 0; i < m_headings.size();
         first += m_headings[i++].values.size())
        for (std::size_t k = 0; k < m_headings[i].values.size(); ++k)
            if (m_headings[i].values[k] == value) {
                m_groups[i]->fold(false);
                m_rows[first + k]->beginNaming();
            }
}

} // namespace fff::ui
