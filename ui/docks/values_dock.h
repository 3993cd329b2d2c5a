// The values of the design, to be adjusted: a row each, in their groups, and presets above them.
// Pointing at one lights the sections that follow it.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/values/values.h"

#include <QString>

class QLabel;
class QPushButton;

namespace fff::ui {

class PresetRow;
class ValueRows;
class ValueTrialRows;
class Workbench;

class ValuesDock : public QDockWidget
{
    Q_OBJECT
public:
    ValuesDock(Workbench &bench, QWidget *parent = nullptr);

    /// In the colours of the theme.
    void refreshColours();
    /// Another value, whose name is to be typed next.
    void addNew();
    /// Whoever only adjusts the design sees the shown values, and neither closes nor moves this.
    void setAdjustsOnly(bool only);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void refresh();
    void refreshAround();
    void light(ValueId value, bool isOver);
    QString notFollowing() const;
    QString stocks() const;

    Workbench &m_bench;
    QLabel *m_purpose = nullptr; // for whoever only adjusts
    QPushButton *m_add = nullptr, *m_handOn = nullptr;
    QLabel *m_empty = nullptr;
    QLabel *m_problems = nullptr; // of numbers that do not follow
    PresetRow *m_presets = nullptr;
    ValueRows *m_rows = nullptr;
    ValueTrialRows *m_trials = nullptr;
    ValueId m_lit;
    bool m_adjustsOnly = false;
};

} // namespace fff::ui
