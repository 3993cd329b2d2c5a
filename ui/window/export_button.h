// The button that stands out of a tool bar: what all the rest is for.
#pragma once

#include <QPushButton> // first: moc stumbles over some standard headers

class QAction;

namespace fff::ui {

class ExportButton : public QPushButton
{
    Q_OBJECT
public:
    /// exporting  the action that it triggers, and that says whether it can
    ExportButton(QAction *exporting, QWidget *parent);

    /// In the colours of the theme.
    void refresh();
};

} // namespace fff::ui
