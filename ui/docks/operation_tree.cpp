#include "ui/docks/operation_tree.h"

#include "core/model/edit_words.h"
#include "core/model/operation_edits.h"
#include "core/operations/operation_words.h"
#include "core/session/operation_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/docks/outline_marks.h"
#include "ui/view/heading_weight.h"

#include <QApplication>
#include <QDropEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <set>

namespace fff::ui {

namespace {

enum Column { kName, kCount, kProblem, kEye, kColumnCount };

constexpr int kKeyRole = Qt::UserRole;        // of a section: its key
constexpr int kMarkedName = Qt::UserRole + 1; // of an operation, as in the model

/// The tree: Space is for the eye, Alt with arrows and drags for the order.
class Tree : public QTreeWidget
{
public:
    using QTreeWidget::QTreeWidget;
    std::function<void(QTreeWidgetItem *)> toggle;
    std::function<void(int from, int to)> move; // of top-level items, to: after the move

protected:
    void keyPressEvent(QKeyEvent *event) override
    {
        const int row = indexOfTopLevelItem(currentItem());
        const bool isArrow = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
        if (event->key() == Qt::Key_Space && currentItem())
            toggle(currentItem());
        else if (isArrow && event->modifiers() == Qt::AltModifier && row >= 0)
            move(row, row + (event->key() == Qt::Key_Up ? -1 : 1));
        else
            QTreeWidget::keyPressEvent(event);
    }
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex &index,
                                                         const QEvent *event) const override
    {
        return isOnButton(index, event, kEye) ? QItemSelectionModel::NoUpdate
                                              : QTreeWidget::selectionCommand(index, event);
    }
    /// The model is told; the rows follow it.
    void dropEvent(QDropEvent *event) override
    {
        const int from = indexOfTopLevelItem(currentItem());
        QTreeWidgetItem *at = itemAt(event->position().toPoint());
        while (at && at->parent())
            at = at->parent();
        int to = at ? indexOfTopLevelItem(at) : topLevelItemCount();
        if (at && dropIndicatorPosition() == QAbstractItemView::BelowItem)
            ++to;
        event->setDropAction(Qt::IgnoreAction);
        event->accept();
        if (from >= 0)
            move(from, to > from ? to - 1 : to);
    }
};

} // namespace

OperationTree::OperationTree(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    auto *title = new QLabel(tr("Operations, in order"), this);
    title->setObjectName(QStringLiteral("operationsTitle"));
    QFont bold = title->font();
    bold.setWeight(headingWeight());
    title->setFont(bold);
    title->setContentsMargins(10, 6, 8, 4);
    title->setForegroundRole(QPalette::PlaceholderText);

    auto *tree = new Tree(this);
    tree->toggle = [this](QTreeWidgetItem *item) { toggleEye(item, kEye); };
    tree->move = [this](int from, int to) {
        if (to < 0 || to >= static_cast<int>(m_rows.size()) || to == from)
            return;
        const Operation &operation = *m_rows[static_cast<std::size_t>(from)].operation;
        m_bench.commit(Step{steps::kMoveOperation, {Named{operation.name}}},
                       moveOperation(m_bench.session().committed().document, operation.id, to));
    };
    m_tree = tree;
    m_tree->setObjectName(QStringLiteral("operationTree"));
    m_tree->setAccessibleName(tr("Operations, in order"));
    m_tree->setAccessibleDescription(
        tr("F2 renames, Space hides and shows, Alt with an arrow key changes the order."));
    m_tree->setColumnCount(kColumnCount);
    m_tree->setHeaderHidden(true);
    dressOutline(m_tree, kEye);
    m_tree->header()->setSectionResizeMode(kCount, QHeaderView::ResizeToContents);
    m_tree->setDragDropMode(QAbstractItemView::InternalMove);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(title);
    column->addWidget(m_tree, 1);

    connect(m_tree, &QTreeWidget::itemChanged, this, &OperationTree::rename);
    connect(m_tree, &QTreeWidget::itemClicked, this, &OperationTree::toggleEye);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &OperationTree::takeSelection);
    connect(m_tree, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem *item) {
        if (Row *row = rowOf(item))
            fill(*row);
        markHidden();
        showSelection();
    });
    connect(&bench, &Workbench::selectionChanged, this, &OperationTree::showSelection);
    connect(&bench, &Workbench::viewStateChanged, this, &OperationTree::markHidden);
    connect(&bench.session(), &Session::modelChanged, this, &OperationTree::followModel);
    // Committing what was previewed changes no model, only its standing.
    connect(&bench.session(), &Session::committedChanged, this, &OperationTree::followModel);
    followModel();
}

void OperationTree::refreshColours()
{
    for (Row &row : m_rows)
        writeRow(row);
    markHidden();
    m_tree->viewport()->update();
}

OperationTree::Row *OperationTree::rowOf(const QTreeWidgetItem *item)
{
    for (Row &row : m_rows)
        if (item && (row.item == item || row.item == item->parent()))
            return &row;
    return nullptr;
}

/// Rows stay with their operations; what an operation makes is listed once it is unfolded, and anew
/// only when it came to something else.
void OperationTree::followModel()
{
    const Model &model = m_bench.session().model();
    bool isTouched = false;
    {
        const QScopedValueRollback filling(m_isFilling, true);
        std::vector<Row> rows;
        const Document &committed = m_bench.session().committed().document;
        for (const OperationPointer &operation : model.document.operations) {
            if (!committed.find(operation->id))
                continue; // what it works on is still being chosen
            const auto known = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row &row) {
                return row.operation->id == operation->id;
            });
            Row row;
            if (known != m_rows.end())
                row = *known;
            OperationResultPointer result;
            for (const OperationResultPointer &each : model.evaluation.results)
                if (each->operation->id == operation->id)
                    result = each;
            const bool isSame = row.item && row.operation == operation && row.result == result;
            row.operation = operation;
            row.result = std::move(result);
            const int at = static_cast<int>(rows.size());
            if (!row.item) {
                row.item = new QTreeWidgetItem;
                m_tree->insertTopLevelItem(at, row.item);
            } else if (m_tree->indexOfTopLevelItem(row.item) != at) {
                const bool isOpen = row.item->isExpanded();
                m_tree->takeTopLevelItem(m_tree->indexOfTopLevelItem(row.item));
                m_tree->insertTopLevelItem(at, row.item);
                row.item->setExpanded(isOpen);
                isTouched = true;
            }
            if (!isSame) {
                isTouched = true;
                writeRow(row);
            }
            rows.push_back(std::move(row));
        }
        for (const Row &row : m_rows)
            if (std::none_of(rows.begin(), rows.end(),
                             [&](const Row &stays) { return stays.item == row.item; }))
                delete row.item;
        m_rows = std::move(rows);
    }
    setVisible(!m_rows.empty());
    if (!isTouched)
        return;
    markHidden();
    showSelection();
    applyFilter();
}

void OperationTree::writeRow(Row &row)
{
    const QScopedValueRollback filling(m_isFilling, true);
    const Operation &operation = *row.operation;
    QTreeWidgetItem *item = row.item;
    const QString name = QString::fromStdString(operation.name);
    item->setData(kName, kMarkedName, name);
    item->setText(kName, name);
    item->setIcon(kName, rowIcon(QString::fromStdString(operation.kind)));
    item->setSizeHint(kName, {0, kOutlineRow});
    // Others go between it and the next one, never into it.
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable |
                   Qt::ItemIsDragEnabled);
    const int count = row.result ? countOf(*row.result) : 0;
    item->setText(kCount, operation.isOn ? QLocale().toString(count) : tr("off"));
    item->setTextAlignment(kCount, Qt::AlignRight | Qt::AlignVCenter);
    item->setForeground(kCount, QBrush(theme().muted));
    const bool hasSections = row.result && !row.result->sections.empty();
    item->setChildIndicatorPolicy(hasSections ? QTreeWidgetItem::ShowIndicator
                                              : QTreeWidgetItem::DontShowIndicator);
    QStringList told{QStringLiteral("%1 · %2").arg(name, kindName(operation))};
    QString mark;
    for (const OperationNotice &notice :
         row.result ? row.result->notices : std::vector<OperationNotice>()) {
        told += noticeText(notice, operation);
        if (mark.isEmpty() || isFailure(notice))
            mark = isFailure(notice) ? QStringLiteral("err") : QStringLiteral("warn");
    }
    const QColor colour = mark == QStringLiteral("err") ? theme().problem : theme().warning;
    setMark(item, kProblem, mark.isEmpty() ? mark : mark + colour.name() + told.last(),
            mark.isEmpty() ? QIcon() : colouredIcon(mark, colour),
            mark.isEmpty() ? QString() : told.mid(1).join(QLatin1Char('\n')));
    item->setToolTip(kName, told.join(QLatin1Char('\n')));
    if (item->isExpanded())
        fill(row);
    else
        row.isFilled = false;
}

void OperationTree::fill(Row &row)
{
    const QScopedValueRollback filling(m_isFilling, true);
    const auto &sections = row.result ? row.result->sections : std::vector<SectionPointer>();
    while (row.item->childCount() > static_cast<int>(sections.size()))
        delete row.item->takeChild(row.item->childCount() - 1);
    QFont words = font();
    words.setItalic(true);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const int at = static_cast<int>(i);
        if (at == row.item->childCount()) {
            auto *made = new QTreeWidgetItem(row.item);
            made->setIcon(kName, rowIcon(QStringLiteral("section")));
            made->setFont(kName, words);
            made->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled); // called after its source
        }
        QTreeWidgetItem *item = row.item->child(at);
        const QString name = QString::fromStdString(sections[i]->name);
        item->setData(kName, kKeyRole, QString::fromStdString(sections[i]->made.key));
        if (item->text(kName) != name) {
            item->setText(kName, name);
            item->setToolTip(kName, name);
        }
    }
    row.isFilled = true;
}

std::vector<SectionRef> OperationTree::sectionsOf(const QTreeWidgetItem *item)
{
    const Row *row = rowOf(item);
    if (!row)
        return {};
    if (row->item != item)
        return {
            SectionRef(row->operation->id, item->data(kName, kKeyRole).toString().toStdString())};
    std::vector<SectionRef> sections;
    for (const SectionPointer &section :
         row->result ? row->result->sections : std::vector<SectionPointer>())
        sections.push_back(section->ref());
    return sections;
}

void OperationTree::markHidden()
{
    const QScopedValueRollback filling(m_isFilling, true);
    const auto mark = [this](QTreeWidgetItem *item, bool isMade) {
        const std::vector<SectionRef> sections = sectionsOf(item);
        const bool isHidden = !sections.empty() && std::all_of(sections.begin(), sections.end(),
                                                               [this](const SectionRef &ref) {
                                                                   return m_bench.isHidden(ref);
                                                               });
        const QString icon = sections.empty() ? QString()
                             : isHidden       ? QStringLiteral("eye_off")
                                              : QStringLiteral("eye");
        setMark(item, kEye, icon, icon.isEmpty() ? QIcon() : rowIcon(icon),
                icon.isEmpty() ? QString()
                : isHidden     ? tr("Hidden: show it")
                               : tr("Hide it"));
        const QBrush words = isHidden || !isMade ? QBrush(theme().muted) : QBrush();
        if (item->foreground(kName) != words)
            item->setForeground(kName, words);
    };
    for (Row &row : m_rows) {
        mark(row.item, row.operation->isOn);
        for (int i = 0; row.isFilled && i < row.item->childCount(); ++i)
            mark(row.item->child(i), true);
    }
}

void OperationTree::toggleEye(QTreeWidgetItem *item, int column)
{
    if (column != kEye)
        return;
    const std::vector<SectionRef> sections = sectionsOf(item);
    if (sections.empty())
        return;
    const bool hides = std::any_of(sections.begin(), sections.end(), [this](const SectionRef &ref) {
        return !m_bench.isHidden(ref);
    });
    m_bench.setHidden(sections, hides);
}

void OperationTree::rename(QTreeWidgetItem *item)
{
    Row *row = rowOf(item);
    if (m_isFilling || !row || row->item != item)
        return;
    const QScopedValueRollback filling(m_isFilling, true);
    const QString name = typedName(item, item->data(kName, kMarkedName).toString());
    if (name.isEmpty())
        return;
    // Only after the editor has gone: the commit writes the row anew.
    const OperationId id = row->operation->id;
    QMetaObject::invokeMethod(
        this,
        [this, id, name] {
            const Document &document = m_bench.session().committed().document;
            if (const Operation *operation = document.find(id))
                m_bench.commit(Step{steps::kRename, {Named{operation->name}}},
                               renameOperation(document, id, name.toStdString()));
        },
        Qt::QueuedConnection);
}

void OperationTree::setFilter(const QString &words)
{
    m_words = words;
    applyFilter();
}

void OperationTree::applyFilter()
{
    for (const Row &row : m_rows) {
        const auto fits = [this](const std::string &name) {
            return QString::fromStdString(name).contains(m_words, Qt::CaseInsensitive);
        };
        bool isShown = m_words.isEmpty() || fits(row.operation->name);
        if (!isShown && row.result)
            isShown = std::any_of(row.result->sections.begin(), row.result->sections.end(),
                                  [&](const SectionPointer &s) { return fits(s->name); });
        row.item->setHidden(!isShown);
    }
}

/// An operation is selected alone, sections that operations made in any number.
void OperationTree::takeSelection()
{
    if (m_isFilling)
        return;
    std::vector<SectionRef> sections;
    for (const QTreeWidgetItem *item : m_tree->selectedItems()) {
        const Row *row = rowOf(item);
        if (!row)
            continue;
        if (row->item == item) {
            m_bench.selectOperation(row->operation->id);
            showSelection();
            return;
        }
        const std::vector<SectionRef> own = sectionsOf(item);
        sections.insert(sections.end(), own.begin(), own.end());
    }
    // Ctrl and Shift add to what is selected elsewhere.
    if (QApplication::keyboardModifiers() & (Qt::ControlModifier | Qt::ShiftModifier))
        for (const SectionRef &ref : m_bench.interaction().selection())
            if (ref.drawn.isValid())
                sections.push_back(ref);
    m_bench.select(std::move(sections));
}

void OperationTree::showSelection()
{
    const QScopedValueRollback filling(m_isFilling, true);
    const OperationId selected = m_bench.interaction().selectedOperation();
    const std::vector<SectionRef> &sections = m_bench.interaction().selection();
    const std::set<SectionRef> wanted(sections.begin(), sections.end());
    QTreeWidgetItem *newest = nullptr;
    const auto show = [&](QTreeWidgetItem *item, bool isSelected) {
        if (item->isSelected() == isSelected)
            return;
        item->setSelected(isSelected);
        if (isSelected)
            newest = item;
    };
    for (Row &row : m_rows) {
        const bool holdsOne = std::any_of(wanted.begin(), wanted.end(), [&](const SectionRef &ref) {
            return ref.operation == row.operation->id;
        });
        const bool isNews = sections != m_shown;
        if (holdsOne && isNews && !row.item->isExpanded())
            row.item->setExpanded(true);
        if (holdsOne && !row.isFilled)
            fill(row);
        show(row.item, row.operation->id == selected);
        for (int i = 0; row.isFilled && i < row.item->childCount(); ++i) {
            QTreeWidgetItem *item = row.item->child(i);
            show(item, holdsOne && wanted.contains(sectionsOf(item).front()));
        }
    }
    m_shown = sections;
    if (newest) {
        m_tree->setCurrentItem(newest, kName, QItemSelectionModel::NoUpdate);
        m_tree->scrollToItem(newest);
    }
}

} // namespace fff::ui
