// What the Properties dock shows when nothing is selected: the model, and how new sections are
// drawn.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/base/ids.h"

#include <vector>

namespace fff::ui {

class DimensionGroup;
class NamedNumberGroup;
class PropertyRow;
class Workbench;

class ModelPage : public QWidget
{
    Q_OBJECT
public:
    ModelPage(Workbench &bench, QWidget *parent);

    void refresh();

Q_SIGNALS:
    /// The stock editor shall show this one.
    void stockWanted(fff::StockId stock);

private:
    Workbench &m_bench;
    std::vector<PropertyRow *> m_rows;
    DimensionGroup *m_dimensions = nullptr;
    NamedNumberGroup *m_numbers = nullptr;
};

} // namespace fff::ui
