// The tool bar of a window in which a model is only adjusted: back and forth, the whole model in
// sight, Export.
#pragma once

#include <QToolBar> // first: moc stumbles over some standard headers

namespace fff::ui {

class ActionSet;
class ExportButton;

class AdjustBar : public QToolBar
{
    Q_OBJECT
public:
    AdjustBar(const ActionSet &actions, QWidget *parent);

    /// In the colours of the theme.
    void refresh();

private:
    ExportButton *m_export = nullptr;
};

} // namespace fff::ui
