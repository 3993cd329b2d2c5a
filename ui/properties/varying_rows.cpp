#include "ui/properties/varying_rows.h"

#include "ui/base/theme.h"

namespace fff::ui {

bool VaryingRows::become(const QString &what)
{
    if (what == m_what)
        return false;
    m_what = what;
    for (PropertyRow *row : m_rows) {
        row->hide();
        row->deleteLater();
    }
    m_rows.clear();
    return true;
}

void VaryingRows::add(PropertyRow *row)
{
    m_group.add(row);
    dress(row); // the window is dressed by then
    m_rows.push_back(row);
}

void VaryingRows::refresh()
{
    for (PropertyRow *row : m_rows)
        row->refresh();
}

} // namespace fff::ui
