// The drawn sections as a tree by parent, with a filter, and below them the operations. Selecting
// works both ways with the view; F2 renames; the eye hides. Follows an edit by what it changed:
// nothing else is touched.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/model/model.h"

#include <map>
#include <set>
#include <unordered_map>

class QAction;
class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff {
class CheckList;
}

namespace fff::ui {

class LoadTree;
class OperationTree;
class Workbench;

class OutlineDock : public QDockWidget
{
    Q_OBJECT
public:
    OutlineDock(Workbench &bench, const CheckList &list, QWidget *parent = nullptr);

    /// In the colours of the theme.
    void refreshColours();
    /// Its key is also one of the list of sections, as of the view: it does something to what is
    /// selected there.
    void addKey(QAction *action);
    /// Rows made or placed since the start: a test sees that an edit does not make all of them.
    int rowsTouched() const { return m_rowsTouched; }

Q_SIGNALS:
    /// At a place on the screen, about what is selected; rename: begins to rename its row.
    void menuWanted(const QPoint &onScreen, QAction *rename);

private:
    void offerMenu(QTreeWidget *tree);
    void followModel();
    std::set<SectionId> drafts() const;
    void dropRows(const Document &document, std::set<SectionId> &moved);
    void writeRow(QTreeWidgetItem *&item, const Section &section, bool isDraft);
    void fill(QTreeWidgetItem *item, const Section &section);
    void place(const Document &document, const std::set<SectionId> &moved);
    void markProblems();
    void markHidden();
    void showColumns();
    void rename(QTreeWidgetItem *item);
    /// What stands in the column is a button.
    void press(QTreeWidgetItem *item, int column);
    void pointAt(QTreeWidgetItem *item);
    void markLock(QTreeWidgetItem *item, bool isLocked);
    void applyFilter();
    void takeSelection();
    void showSelection();

    using SectionList = std::vector<SectionPointer>;

    Workbench &m_bench;
    const CheckList &m_list;
    QLineEdit *m_filter = nullptr;
    QTreeWidget *m_tree = nullptr;
    QLabel *m_empty = nullptr;
    QTreeWidgetItem *m_pointedAt = nullptr; // by the mouse
    OperationTree *m_operations = nullptr;
    LoadTree *m_loads = nullptr;
    std::unordered_map<SectionId, QTreeWidgetItem *> m_items;
    SectionList m_shown;                                // what the items were made of
    std::vector<std::shared_ptr<const Stock>> m_stocks; // likewise
    std::set<SectionId> m_drafts;                       // shown, but not committed
    int m_rowsTouched = 0;
    bool m_isFilling = false;
};

} // namespace fff::ui
