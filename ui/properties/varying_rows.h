// Rows of a group that are of one thing now and of another one later.
#pragma once

#include "ui/properties/property_rows.h"

#include <QString>

#include <vector>

namespace fff::ui {

class VaryingRows
{
public:
    explicit VaryingRows(PropertyGroup &group) : m_group(group) {}

    /// They are to be of this; true where they were of something else, and are gone.
    bool become(const QString &what);
    void add(PropertyRow *row);
    void refresh();

private:
    PropertyGroup &m_group;
    QString m_what;
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
