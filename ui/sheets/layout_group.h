// How parts are to lie on their sheets: the same choices as the Export panel's, kept with them.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/dialogs/export_choices.h"

#include <functional>
#include <vector>

class QCheckBox;

namespace fff::ui {

class PropertyGroup;
class PropertyRow;
class Workbench;

class LayoutGroup : public QWidget
{
    Q_OBJECT
public:
    LayoutGroup(Workbench &bench, QWidget *parent = nullptr);

    void refresh();
    /// Whose sheet is shown.
    StockId stock() const;

private:
    void addStock();
    void addSheet();
    void addLength(const QString &name, const char *objectName, double most,
                   double LayoutOptions::*value);
    void addTurning();
    void addHoles();
    void add(PropertyRow *row);
    std::vector<StockId> stocks() const; // that sections are made of
    void choose(const std::function<void(ExportChoices &)> &change);

    Workbench &m_bench;
    StockId m_chosen; // whose sheet is shown, where there are several
    PropertyGroup *m_group = nullptr;
    PropertyRow *m_stock = nullptr;
    QCheckBox *m_holes = nullptr;
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
