// Settings of the values that have a name: one is chosen, what is set now is kept as one, and one
// is deleted.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace fff::ui {

class ChoiceBox;
class Workbench;

class PresetRow : public QWidget
{
    Q_OBJECT
public:
    PresetRow(Workbench &bench, QWidget *parent);

    /// Whoever only adjusts the design chooses one.
    void setAdjustsOnly(bool only);
    /// Hidden where there is nothing to choose.
    void refresh();
    /// Keeps the first one; hidden where there is one, or nothing to keep.
    QPushButton *first() const { return m_first; }

Q_SIGNALS:
    /// The field for the name is there; it may have to be scrolled to.
    void namingBegun();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void choose(int index);
    void beginNaming();
    void endNaming();
    void keep();
    void remove();
    void say(const QString &why);

    Workbench &m_bench;
    QLabel *m_label = nullptr;
    ChoiceBox *m_box = nullptr;
    QLineEdit *m_name = nullptr; // in place of the box while one is named
    QToolButton *m_keep = nullptr, *m_remove = nullptr;
    QPushButton *m_first = nullptr; // stands elsewhere
    QLabel *m_problem = nullptr;
    bool m_adjustsOnly = false, m_isNaming = false;
};

} // namespace fff::ui
