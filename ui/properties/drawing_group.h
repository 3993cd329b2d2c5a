// The rows of Properties that say how strokes are drawn: what the settings hold under "Drawing".
#pragma once

#include "ui/properties/property_rows.h"

#include <vector>

namespace fff::ui {

class DrawingGroup : public PropertyGroup
{
    Q_OBJECT
public:
    explicit DrawingGroup(QWidget *parent);
    void refresh();

private:
    void addRow(PropertyRow *row);

    std::vector<PropertyRow *> m_all;
};

} // namespace fff::ui
