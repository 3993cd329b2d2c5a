// A value of the document: its name, what it is set with, and under it what else there is to say
// of it, or what is wrong with it.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/values/values.h"

#include <QString>

class QGridLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace fff::ui {

class ValueDetails;
class ValueEditor;
class Workbench;

class ValueRow : public QWidget
{
    Q_OBJECT
public:
    ValueRow(Workbench &bench, ValueId value, QWidget *parent);

    ValueId value() const { return m_id; }
    /// Whoever only adjusts the design renames nothing, and reads what each value is for.
    void setAdjustsOnly(bool only);
    /// As the value is now.
    void refresh();
    /// Its name is to be typed.
    void beginNaming();
    void unfold(bool unfolds);
    /// What was refused before is not said any more.
    void forgetRefusal();

Q_SIGNALS:
    void hovered(bool isOver);

protected:
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void rename();
    void showEditor(const KnownValue &known);
    void orderTabs();
    void say(const QString &why);

    Workbench &m_bench;
    const ValueId m_id;
    QGridLayout *m_grid = nullptr;
    QLineEdit *m_name = nullptr;
    QToolButton *m_more = nullptr;
    ValueEditor *m_editor = nullptr;
    QLabel *m_note = nullptr; // for whoever only adjusts
    QLabel *m_problem = nullptr;
    ValueDetails *m_details = nullptr; // once it was asked for
    QString m_refusal;                 // of the last edit
    bool m_adjustsOnly = false;
};

} // namespace fff::ui
