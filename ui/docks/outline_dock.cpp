#include "ui/docks/outline_dock.h"

#include "core/interaction/section_editing.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/session/check_list.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/load_tree.h"
#include "ui/docks/operation_tree.h"
#include "ui/docks/outline_marks.h"
#include "ui/docks/outline_tree.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/stock_choice.h"
#include "ui/view/view_style.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <utility>

namespace fff::ui {

namespace {

enum Column { kName, kStock, kProblem, kLock, kEye, kColumnCount };

constexpr int kIdRole = Qt::UserRole;        // SectionId
constexpr int kNameRole = Qt::UserRole + 1;  // as in the model
constexpr int kStockRole = Qt::UserRole + 2; // name of its stock, for the filter

SectionId idOf(const QTreeWidgetItem *item)
{
    return SectionId{item->data(0, kIdRole).toLongLong()};
}

/// What a row shows of stocks: name and colour, which hangs on the name. A thickness that is
/// dragged changes no row.
bool showTheSame(const std::vector<std::shared_ptr<const Stock>> &a,
                 const std::vector<std::shared_ptr<const Stock>> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto &p, const auto &q) {
        return p == q || (p->id == q->id && p->name == q->name);
    });
}

} // namespace

OutlineDock::OutlineDock(Workbench &bench, const CheckList &list, QWidget *parent)
    : QDockWidget(tr("Outline"), parent), m_bench(bench), m_list(list)
{
    dressDock(this, "outlineDock");
    auto *content = new QWidget(this);
    m_filter = new QLineEdit(content);
    m_filter->setObjectName(QStringLiteral("outlineFilter"));
    m_filter->setPlaceholderText(tr("Filter by name or stock"));
    m_filter->setAccessibleName(tr("Filter by name or stock"));
    m_filter->setClearButtonEnabled(true);
    m_filter->addAction(rowIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);

    auto *tree = new OutlineTree(kLock, content);
    tree->toggle = [this](QTreeWidgetItem *item) { press(item, kEye); };
    tree->left = [this] { pointAt(nullptr); };
    m_tree = tree;
    m_tree->setMouseTracking(true);
    connect(m_tree, &QTreeWidget::itemEntered, this, &OutlineDock::pointAt);
    connect(m_tree, &QTreeWidget::viewportEntered, this, [this] { pointAt(nullptr); });
    m_tree->setObjectName(QStringLiteral("outlineTree"));
    m_tree->setAccessibleName(tr("Sections"));
    m_tree->setAccessibleDescription(tr("F2 renames, Space hides and shows."));
    m_tree->setColumnCount(kColumnCount);
    m_tree->setHeaderHidden(true);
    dressOutline(m_tree, kEye);

    m_empty = new QLabel(tr("Sections appear here as you draw them."), m_tree);
    m_empty->setObjectName(QStringLiteral("outlineEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setGeometry(12, 12, 220, 40);

    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *filterRow = new QVBoxLayout;
    filterRow->setContentsMargins(8, 4, 8, 8);
    filterRow->addWidget(m_filter);
    column->addLayout(filterRow);
    m_operations = new OperationTree(bench, content);
    auto *halves = new QSplitter(Qt::Vertical, content);
    halves->setChildrenCollapsible(false);
    halves->addWidget(m_tree);
    halves->addWidget(m_operations);
    halves->setStretchFactor(0, 3);
    halves->setStretchFactor(1, 2);
    column->addWidget(halves, 1);
    m_loads = new LoadTree(bench, content);
    column->addWidget(m_loads);
    setWidget(content);

    offerMenu(m_tree);
    offerMenu(m_operations->tree());
    connect(m_filter, &QLineEdit::textChanged, this, &OutlineDock::applyFilter);
    connect(m_tree, &QTreeWidget::itemChanged, this, &OutlineDock::rename);
    connect(m_tree, &QTreeWidget::itemClicked, this, &OutlineDock::press);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &OutlineDock::takeSelection);
    connect(&bench, &Workbench::selectionChanged, this, &OutlineDock::showSelection);
    connect(&bench, &Workbench::viewStateChanged, this, &OutlineDock::markHidden);
    connect(&list, &CheckList::changed, this, &OutlineDock::markProblems);
    connect(&bench.session(), &Session::modelChanged, this, &OutlineDock::followModel);
    // Committing what was previewed changes no model, only its standing.
    connect(bench.session().history(), &QUndoStack::indexChanged, this, [this] {
        if (!m_drafts.empty())
            followModel();
    });
    followModel();
}

void OutlineDock::offerMenu(QTreeWidget *tree)
{
    tree->setContextMenuPolicy(Qt::CustomContextMenu);
    auto *rename = new QAction(tr("Rename") + QStringLiteral("\tF2"), tree);
    rename->setObjectName(QStringLiteral("outlineRename"));
    connect(rename, &QAction::triggered, tree, [tree] {
        if (QTreeWidgetItem *item = tree->currentItem())
            tree->editItem(item);
    });
    connect(tree, &QWidget::customContextMenuRequested, this, [this, tree, rename](QPoint at) {
        const QTreeWidgetItem *item = tree->itemAt(at);
        rename->setEnabled(item && item->flags().testFlag(Qt::ItemIsEditable));
        Q_EMIT menuWanted(tree->viewport()->mapToGlobal(at), rename);
    });
}

void OutlineDock::addKey(QAction *action)
{
    m_tree->addAction(action);
    m_loads->addKey(action);
}

void OutlineDock::refreshColours()
{
    markProblems();
    markHidden();
    m_tree->viewport()->update();
    m_operations->refreshColours();
    m_loads->refreshColours();
}

/// What is shown only while a section is drawn.
std::set<SectionId> OutlineDock::drafts() const
{
    std::set<SectionId> drafts;
    if (!m_bench.session().hasPreview())
        return drafts;
    const Document &committed = m_bench.session().committed().document;
    for (const SectionPointer &section : m_bench.session().model().document.sections) {
        if (!committed.find(section->id))
            drafts.insert(section->id);
    }
    return drafts;
}

/// Drops the rows of what is gone. Those below them go to the top, to be placed anew.
void OutlineDock::dropRows(const Document &document, std::set<SectionId> &moved)
{
    std::set<SectionId> there;
    for (const SectionPointer &section : document.sections)
        there.insert(section->id);
    for (auto it = m_items.begin(); it != m_items.end();) {
        if (there.contains(it->first)) {
            ++it;
            continue;
        }
        QTreeWidgetItem *item = it->second;
        if (m_pointedAt == item)
            m_pointedAt = nullptr;
        for (QTreeWidgetItem *child : item->takeChildren()) {
            m_tree->addTopLevelItem(child);
            moved.insert(idOf(child));
        }
        it = m_items.erase(it);
        delete item;
    }
}

/// Makes the row or writes it anew.
void OutlineDock::writeRow(QTreeWidgetItem *&item, const Section &section, bool isDraft)
{
    if (!item) {
        item = new QTreeWidgetItem;
        item->setIcon(kName, rowIcon(QStringLiteral("section")));
        item->setSizeHint(kName, {0, kOutlineRow});
        item->setData(kName, kIdRole, static_cast<qlonglong>(section.id.value));
    }
    fill(item, section);
    QFont words = font();
    words.setItalic(isDraft);
    item->setFont(kName, words);
    const auto flags = item->flags();
    item->setFlags(isDraft ? flags & ~Qt::ItemIsEditable : flags | Qt::ItemIsEditable);
    const QString name = QString::fromStdString(section.name);
    item->setText(kName, name);
    //: %1 is the name of a section
    const QString draft = isDraft ? tr("%1, being drawn").arg(name) : QString();
    item->setToolTip(kName, draft);
    item->setData(kName, Qt::AccessibleTextRole, isDraft ? QVariant(draft) : QVariant());
}

/// Makes the rows of what is new, drops those of what is gone, and writes those whose section is
/// another object than the one they were made of. Every move of a drag comes by here: the sections
/// that stay cost a look at their pointers.
void OutlineDock::followModel()
{
    const Document &document = m_bench.session().model().document;
    const auto &sections = document.sections;
    const bool hasSameRows =
        std::equal(m_shown.begin(), m_shown.end(), sections.begin(), sections.end(),
                   [](const auto &a, const auto &b) { return a == b || a->id == b->id; });
    bool isTouched = !hasSameRows;
    {
        const QScopedValueRollback filling(m_isFilling, true);
        const bool stocksDiffer = !showTheSame(m_stocks, document.stocks);
        m_stocks = document.stocks;
        std::set<SectionId> moved, drafts = this->drafts();
        if (!hasSameRows)
            dropRows(document, moved);
        std::unordered_map<SectionId, SectionPointer> before;
        for (const SectionPointer &section : hasSameRows ? SectionList() : m_shown)
            before.emplace(section->id, section);
        for (std::size_t i = 0; i < sections.size(); ++i) {
            const Section &section = *sections[i];
            const auto known = before.find(section.id);
            const Section *shown = hasSameRows             ? m_shown[i].get()
                                   : known != before.end() ? known->second.get()
                                                           : nullptr;
            const bool isDraft = !drafts.empty() && drafts.contains(section.id);
            const bool wasDraft = !m_drafts.empty() && m_drafts.contains(section.id);
            if (shown == &section && !stocksDiffer && isDraft == wasDraft)
                continue;
            if (!shown || !(shown->parent == section.parent))
                moved.insert(section.id);
            if (shown != &section)
                ++m_rowsTouched;
            writeRow(m_items[section.id], section, isDraft);
            isTouched = true;
        }
        m_shown = sections;
        m_drafts = std::move(drafts);
        place(document, moved);
        m_empty->setVisible(m_items.empty() && m_bench.session().model().sectionCount() == 0);
        showColumns();
    }
    if (!hasSameRows) {
        markHidden();
        markProblems();
        showSelection();
    }
    if (isTouched && !m_filter->text().isEmpty())
        applyFilter();
}

void OutlineDock::fill(QTreeWidgetItem *item, const Section &section)
{
    const Stock &stock = m_bench.session().model().document.stockOf(section);
    const QString name = QString::fromStdString(section.name);
    item->setData(kName, kNameRole, name);
    item->setData(kName, kStockRole, stockName(stock));
    const QColor face = stockLook(stock).face;
    setMark(item, kStock, face.name() + stockName(stock), colourChip(face), stockName(stock));
    item->setToolTip(kName, name);
    markLock(item, section.isLocked);
}

/// Open ones only where the mouse is: a column of them would be noise.
void OutlineDock::markLock(QTreeWidgetItem *item, bool isLocked)
{
    if (isLocked)
        setMark(item, kLock, QStringLiteral("lock"), rowIcon(QStringLiteral("lock")),
                tr("Locked: unlock it"));
    else if (item == m_pointedAt)
        setMark(item, kLock, QStringLiteral("lock_open"), rowIcon(QStringLiteral("lock_open")),
                tr("Lock it"));
    else
        setMark(item, kLock, QString(), QIcon(), QString());
}

void OutlineDock::pointAt(QTreeWidgetItem *item)
{
    const QScopedValueRollback filling(m_isFilling, true);
    QTreeWidgetItem *before = std::exchange(m_pointedAt, item);
    for (QTreeWidgetItem *changed : {before, item}) {
        const Section *section =
            changed ? m_bench.session().model().document.find(idOf(changed)) : nullptr;
        if (section)
            markLock(changed, section->isLocked);
    }
}

/// Puts rows under their parents, in the document's order. A parent may stand after its child in a
/// file, and a file may hold a ring of parents: a section whose parents lead back to itself goes to
/// the top.
void OutlineDock::place(const Document &document, const std::set<SectionId> &moved)
{
    if (moved.empty())
        return;
    std::unordered_map<SectionId, std::size_t> order;
    for (std::size_t i = 0; i < document.sections.size(); ++i)
        order[document.sections[i]->id] = i;
    for (const SectionPointer &section : document.sections) {
        if (!moved.contains(section->id))
            continue;
        QTreeWidgetItem *item = m_items[section->id], *above = nullptr;
        if (section->parent) {
            const auto found = m_items.find(section->parent->section.drawn);
            above = found != m_items.end() ? found->second : nullptr;
        }
        for (QTreeWidgetItem *up = above; up; up = up->parent()) {
            if (up == item)
                above = nullptr;
        }
        const bool isExpanded = !item->treeWidget() || item->isExpanded();
        if (QTreeWidgetItem *before = item->parent())
            before->removeChild(item);
        else if (item->treeWidget())
            m_tree->takeTopLevelItem(m_tree->indexOfTopLevelItem(item));
        QTreeWidgetItem *under = above ? above : m_tree->invisibleRootItem();
        // Most are the newest: look from the end.
        int at = under->childCount();
        while (at > 0 && order[idOf(under->child(at - 1))] > order[section->id])
            --at;
        const bool wasLeaf = under->childCount() == 0;
        under->insertChild(at, item);
        if (above && wasLeaf)
            above->setExpanded(true);
        if (item->childCount() > 0)
            item->setExpanded(isExpanded);
    }
}

/// A chip says something only where there is more than one stock.
void OutlineDock::showColumns()
{
    m_tree->setColumnHidden(kStock, m_stocks.size() < 2);
}

void OutlineDock::markProblems()
{
    const QScopedValueRollback filling(m_isFilling, true);
    std::map<SectionId, const Finding *> worst;
    for (const Finding &finding : m_list.all()) {
        if (finding.severity < Severity::Warning)
            continue;
        for (const SectionRef &ref : concerned(finding)) {
            const Finding *&known = worst[ref.drawn];
            if (!known || finding.severity > known->severity)
                known = &finding;
        }
    }
    for (const auto &[id, item] : m_items) {
        const auto found = worst.find(id);
        if (found == worst.end()) {
            setMark(item, kProblem, QString(), QIcon(), QString());
            continue;
        }
        const Finding &finding = *found->second;
        const QString title = checkWords(finding, m_list.model()).title;
        const QColor colour = checkColour(finding.severity);
        setMark(item, kProblem, checkGlyph(finding.severity) + colour.name() + title,
                colouredIcon(checkGlyph(finding.severity), colour), title);
    }
}

void OutlineDock::markHidden()
{
    const QScopedValueRollback filling(m_isFilling, true);
    for (const auto &[id, item] : m_items) {
        const bool isHidden = m_bench.isHidden(SectionRef(id));
        const QString icon = isHidden ? QStringLiteral("eye_off") : QStringLiteral("eye");
        setMark(item, kEye, icon, rowIcon(icon), isHidden ? tr("Hidden: show it") : tr("Hide it"));
        const QBrush words = isHidden ? QBrush(theme().muted) : QBrush();
        if (item->foreground(kName) != words)
            item->setForeground(kName, words);
    }
}

void OutlineDock::press(QTreeWidgetItem *item, int column)
{
    const SectionRef ref(idOf(item));
    if (column == kEye)
        m_bench.setHidden(ref, !m_bench.isHidden(ref));
    const Model &model = m_bench.session().committed();
    const Section *section = model.document.find(ref.drawn);
    if (column == kLock && section)
        m_bench.editSections(locked(model, {ref}, !section->isLocked));
}

void OutlineDock::rename(QTreeWidgetItem *item)
{
    if (m_isFilling)
        return;
    const QScopedValueRollback filling(m_isFilling, true);
    const QString before = item->data(kName, kNameRole).toString(), name = typedName(item, before);
    if (name.isEmpty())
        return;
    // Only after the editor has gone: the commit writes the row anew.
    const SectionId id = idOf(item);
    QMetaObject::invokeMethod(
        this,
        [this, id, before, name] {
            m_bench.commit(
                Step{steps::kRename, {Named{before.toStdString()}}},
                renameSection(m_bench.session().committed().document, id, name.toStdString()));
        },
        Qt::QueuedConnection);
}

/// An item stays when its own words fit or those of one below it.
void OutlineDock::applyFilter()
{
    const QString words = m_filter->text().trimmed();
    m_operations->setFilter(words);
    const std::function<bool(QTreeWidgetItem *)> filter = [&](QTreeWidgetItem *item) {
        bool fits = words.isEmpty() || item->text(kName).contains(words, Qt::CaseInsensitive) ||
                    item->data(kName, kStockRole).toString().contains(words, Qt::CaseInsensitive);
        for (int i = 0; i < item->childCount(); ++i)
            fits = filter(item->child(i)) || fits;
        if (item->isHidden() == fits)
            item->setHidden(!fits);
        return fits;
    };
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i)
        filter(m_tree->topLevelItem(i));
}

void OutlineDock::takeSelection()
{
    if (m_isFilling)
        return;
    std::vector<SectionRef> selection;
    for (const QTreeWidgetItem *item : m_tree->selectedItems())
        selection.emplace_back(idOf(item));
    // Ctrl and Shift add to what is selected below.
    if (QApplication::keyboardModifiers() & (Qt::ControlModifier | Qt::ShiftModifier))
        for (const SectionRef &ref : m_bench.interaction().selection())
            if (!ref.drawn.isValid())
                selection.push_back(ref);
    m_bench.select(std::move(selection));
}

void OutlineDock::showSelection()
{
    const QScopedValueRollback filling(m_isFilling, true);
    std::set<SectionId> wanted;
    for (const SectionRef &ref : m_bench.interaction().selection())
        if (ref.drawn.isValid())
            wanted.insert(ref.drawn);
    for (QTreeWidgetItem *item : m_tree->selectedItems()) {
        if (!wanted.contains(idOf(item)))
            item->setSelected(false);
    }
    QTreeWidgetItem *newest = nullptr;
    for (const SectionRef &ref : m_bench.interaction().selection()) {
        const auto found = m_items.find(ref.drawn);
        if (found == m_items.end() || found->second->isSelected())
            continue;
        newest = found->second;
        newest->setSelected(true);
    }
    if (newest) {
        m_tree->setCurrentItem(newest, kName, QItemSelectionModel::NoUpdate);
        m_tree->scrollToItem(newest);
    }
}

} // namespace fff::ui
