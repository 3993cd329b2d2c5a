#include "ui/properties/triple_row.h"

#include <QHBoxLayout>

namespace fff::ui {

namespace {

constexpr int kTripleLabel = 54, kBetweenFields = 4; // px

} // namespace

TripleRow::TripleRow(const QString &name, const std::array<NumberEdit *, 3> &edits,
                     const std::array<QString, 3> &tips, Read read, QWidget *parent)
    : PropertyRow(name, parent), m_edits(edits), m_read(std::move(read))
{
    narrowLabel(kTripleLabel);
    auto *fields = new QWidget(this);
    auto *row = new QHBoxLayout(fields);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBetweenFields);
    for (std::size_t axis = 0; axis < m_edits.size(); ++axis) {
        NumberEdit *edit = m_edits[axis];
        edit->setParent(fields);
        edit->setCompact();
        edit->setToolTip(tips[axis]);
        edit->setAccessibleName(tips[axis]);
        row->addWidget(edit, 1);
    }
    setEditor(fields, "", true);
    fields->setFocusProxy(m_edits.front());
}

void TripleRow::refresh()
{
    for (std::size_t axis = 0; axis < m_edits.size(); ++axis)
        m_edits[axis]->setNumber(m_read(static_cast<int>(axis)));
}

} // namespace fff::ui
