// The head of the properties: what the numbers below are of. The name of a single section can be
// changed there.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/section.h"

#include <vector>

class QLabel;
class QLineEdit;

namespace fff {
struct JointState;
}

namespace fff::ui {

class Workbench;

class PropertiesHeader : public QWidget
{
    Q_OBJECT
public:
    PropertiesHeader(Workbench &bench, QWidget *parent);

    /// Reads everything again; also for another theme.
    void refresh();

private:
    QString kindOf(int section) const;
    static QString stateOf(const JointState &joint);
    void nameWhatIsSelected();
    void rename();

    Workbench &m_bench;
    QLabel *m_icon = nullptr;
    QLabel *m_title = nullptr; // of what has no name to change
    QLineEdit *m_name = nullptr;
    QLabel *m_kind = nullptr;
    SectionRef m_named; // whose name the field has; none unless one is selected
};

/// Indices in the model that is shown, of those selected sections that exist in it.
std::vector<int> selectedSections(const Workbench &bench);

} // namespace fff::ui
