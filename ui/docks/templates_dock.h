// What sections are drawn after: a list, and the numbers of the one that is chosen in it.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/base/text.h"
#include "core/model/template.h"

#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QScrollArea;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff {
struct WantedTrace;
}

namespace fff::ui {

class FlatGroup;
class MakingGroup;
class PropertyGroup;
class PropertyRow;
class TemplateSource;
class TemplateTools;
class Workbench;

class TemplatesDock : public QDockWidget
{
    Q_OBJECT
public:
    explicit TemplatesDock(Workbench &bench, QWidget *parent = nullptr);

    void refreshColours();
    /// What was suggested last is the newest step.
    void setHasSuggestion(bool hasLast);

Q_SIGNALS:
    void addWanted();
    void slicesWanted(fff::TemplateId of);
    void suggestionWanted(fff::TemplateId of, int count);
    void oneMoreWanted(fff::TemplateId of);
    void anotherWanted();
    void facetsWanted(fff::TemplateId of, int faces);
    void netWanted(fff::TemplateId of, int faces);
    void traceWanted(const fff::WantedTrace &wanted);
    /// What it holds is to be read from a file that is asked for, or from its own.
    void fileWanted(fff::TemplateId of, bool isByReference);
    void keepWanted(fff::TemplateId of);
    /// A tool was picked up here whose keys are the view's.
    void viewWanted();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeFields();
    QWidget *makeMaking();
    void addPlaces();
    void addContent();
    void followModel();
    void writeRows();
    void writeRow(QTreeWidgetItem *item, const Template &one);
    /// "Mesh, 12 triangles", "Picture, 640 × 480 pixels"
    QString contentOf(const Template &one) const;
    void rename(QTreeWidgetItem *item);
    void press(QTreeWidgetItem *item, int column);
    bool key(int key);
    void refreshFields();

    /// The one whose fields are shown; null without any.
    const Template *chosen() const;
    void change(const std::function<void(Template &)> &change, Text step);

    Workbench &m_bench;
    QTreeWidget *m_tree = nullptr;
    QLabel *m_empty = nullptr;
    QScrollArea *m_area = nullptr;
    QWidget *m_fields = nullptr;
    PropertyGroup *m_group = nullptr;
    MakingGroup *m_making = nullptr;
    FlatGroup *m_flat = nullptr;
    TemplateTools *m_tools = nullptr;
    TemplateSource *m_source = nullptr;
    QWidget *m_turns = nullptr;                           // of meshes
    QPushButton *m_slices = nullptr, *m_turnUp = nullptr; // of meshes
    std::vector<PropertyRow *> m_rows;
    std::vector<TemplatePointer> m_shown; // what the rows are of
    bool m_isFilling = false;
};

} // namespace fff::ui
