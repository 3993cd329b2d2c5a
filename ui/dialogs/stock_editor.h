// The stock editor: the stocks of the model at the left, the numbers of one of them at the right.
// Not modal: every change is a step of the history at once, and the view shows it.
#pragma once

#include <QDialog> // first: moc stumbles over some standard headers

#include "core/base/ids.h"

namespace fff::ui {

class ActionSet;
class StockFields;
class StockList;
class Workbench;

class StockEditor : public QDialog
{
    Q_OBJECT
public:
    StockEditor(Workbench &bench, const ActionSet &actions, QWidget *parent);

    /// Shows it with this stock, or with that of the next section; the number in the field of this
    /// name is in sight and selected. The first time beside the model, later where it was left.
    void open(StockId stock, const QString &field = {});
    /// In the colours of the theme.
    void refresh();

private:
    StockList *m_list = nullptr;
    StockFields *m_fields = nullptr;
    Workbench &m_bench;
    bool m_wasPlaced = false;
};

} // namespace fff::ui
