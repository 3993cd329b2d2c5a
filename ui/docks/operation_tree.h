// The operations in their order, each with what it makes beneath it. Selecting works both ways with
// the view; F2 renames; the eye hides; drag, or Alt with an arrow key, changes the order.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/model.h"

#include <vector>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff::ui {

class Workbench;

class OperationTree : public QWidget
{
    Q_OBJECT
public:
    OperationTree(Workbench &bench, QWidget *parent);

    /// In the colours of the theme.
    void refreshColours();
    /// Shows those that have these words in their name, or in that of something they make.
    void setFilter(const QString &words);
    QTreeWidget *tree() const { return m_tree; }

private:
    struct Row
    {
        OperationPointer operation;    // that the item was made of
        OperationResultPointer result; // likewise; null: it is off
        QTreeWidgetItem *item = nullptr;
        bool isFilled = false; // with what it makes
    };

    void followModel();
    void writeRow(Row &row);
    void fill(Row &row);
    void markHidden();
    void applyFilter();
    void toggleEye(QTreeWidgetItem *item, int column);
    void rename(QTreeWidgetItem *item);
    void takeSelection();
    void showSelection();
    Row *rowOf(const QTreeWidgetItem *item);
    /// What is hidden with the eye of an item.
    std::vector<SectionRef> sectionsOf(const QTreeWidgetItem *item);

    Workbench &m_bench;
    QTreeWidget *m_tree = nullptr;
    QString m_words;
    std::vector<Row> m_rows;         // in the order of the operations
    std::vector<SectionRef> m_shown; // sections that were selected when the rows were last marked
    bool m_isFilling = false;
};

} // namespace fff::ui
