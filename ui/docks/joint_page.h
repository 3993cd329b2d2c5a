// What the Properties dock shows of the joint that is selected: its kind, where its slits open to
// and meet, and the way back to what it is by itself.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/assembly/joint_measures.h"

#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace fff::ui {

class ChoiceRow;
class EditorRow;
class ProblemBox;
class PropertyGroup;
class PropertyRow;
class SliderField;
class TextRow;
class Workbench;

class JointPage : public QWidget
{
    Q_OBJECT
public:
    JointPage(Workbench &bench, QWidget *parent);

    /// Another joint may be selected, or none: what is dragged for the one before is done.
    void follow();
    void refresh();

Q_SIGNALS:
    /// One of its two sections, of the joint with the other one.
    void sectionWanted(const fff::SectionRef &section, const fff::SectionRef &other);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    /// Where slits meet: one for each place that the two sections share.
    struct ShareRow
    {
        SliderField *field;
        EditorRow *row;
    };

    void addChoices(PropertyGroup *group);
    void outline(const QString &target);
    void addMeasures(PropertyGroup *group);
    void addShareRow();
    void refreshShares();
    void chooseSide(int index);
    double shareOf(double percent) const { return 1.0 - 0.01 * percent; }
    QString name(int section) const;
    QString slitText(const SlitMeasure &slit) const;
    QString slitsText(const std::vector<SlitMeasure> &slits) const;
    QString problemText(const QString &a, const QString &b) const;

    Workbench &m_bench;
    std::optional<JointRef> m_joint;
    std::optional<JointState> m_state; // as it is shown
    QLabel *m_links = nullptr;
    bool m_isOutlining = false; // the section whose link is under the cursor
    ProblemBox *m_problem = nullptr;
    ChoiceRow *m_kind = nullptr, *m_opens = nullptr;
    PropertyGroup *m_slits = nullptr;
    std::vector<ShareRow> m_shares; // as many as places, or more, hidden
    QWidget *m_shareRows = nullptr;
    TextRow *m_slitsOfA = nullptr, *m_slitsOfB = nullptr, *m_angle = nullptr;
    QPushButton *m_reset = nullptr;
};

} // namespace fff::ui
