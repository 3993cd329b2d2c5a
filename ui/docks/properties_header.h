// The head of the properties: what the numbers below are of. The name of a single section can be
// changed there.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/section.h"

#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace fff {
struct JointState;
struct Operation;
} // namespace fff

namespace fff::ui {

class Workbench;

class PropertiesHeader : public QWidget
{
    Q_OBJECT
public:
    PropertiesHeader(Workbench &bench, QWidget *parent);

    /// Reads everything again; also for another theme.
    void refresh();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QString kindOf(int section) const;
    QString kindOf(const Operation &operation) const;
    static QString stateOf(const JointState &joint);
    void nameWhatIsSelected();
    void rename();

    Workbench &m_bench;
    QLabel *m_icon = nullptr;
    QLabel *m_title = nullptr; // of what has no name to change
    QLineEdit *m_name = nullptr;
    QLabel *m_kind = nullptr;
    QCheckBox *m_isOn = nullptr; // of an operation
    /// Whose name the field has: one drawn section or an operation; none unless one is selected.
    SectionRef m_named;
    LoadId m_namedLoad; // likewise
};

/// Indices in the model that is shown, of those selected sections that exist in it.
std::vector<int> selectedSections(const Workbench &bench);

} // namespace fff::ui
