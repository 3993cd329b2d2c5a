#include "ui/docks/outline_dock.h"

#include "core/model/edits.h"
#include "ui/docks/dock_title.h"
#include "ui/icon.h"
#include "ui/theme.h"
#include "ui/workbench.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <map>
#include <set>

namespace fff::ui {

namespace {

constexpr int kIdRole = Qt::UserRole;        // SectionId, 0 for a generated section
constexpr int kNameRole = Qt::UserRole + 1;  // as in the model
constexpr int kStockRole = Qt::UserRole + 2; // name of its stock, for the filter
constexpr int kRowHeight = 24;               // px

SectionId idOf(const QTreeWidgetItem *item)
{
    return SectionId{item->data(0, kIdRole).toLongLong()};
}

/// What the tree shows of a section; equal lists need no new tree.
bool showsTheSame(const Model &a, const Model &b)
{
    const auto &before = a.document.sections, &after = b.document.sections;
    return a.document.stocks == b.document.stocks &&
           std::equal(before.begin(), before.end(), after.begin(), after.end(),
                      [](const SectionPointer &p, const SectionPointer &q) {
                          return p == q || (p->id == q->id && p->name == q->name &&
                                            p->stock == q->stock && p->parent == q->parent);
                      });
}

} // namespace

OutlineDock::OutlineDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Outline"), parent), m_bench(bench)
{
    dressDock(this, "outlineDock");
    auto *content = new QWidget(this);
    m_filter = new QLineEdit(content);
    m_filter->setObjectName(QStringLiteral("outlineFilter"));
    m_filter->setPlaceholderText(tr("Filter by name or stock"));
    m_filter->setAccessibleName(tr("Filter by name or stock"));
    m_filter->setClearButtonEnabled(true);
    m_filter->addAction(rowIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);

    m_tree = new QTreeWidget(content);
    m_tree->setObjectName(QStringLiteral("outlineTree"));
    m_tree->setAccessibleName(tr("Sections"));
    m_tree->setHeaderHidden(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_tree->setIconSize({16, 16});
    m_tree->setIndentation(16);
    m_tree->setUniformRowHeights(true);

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
    column->addWidget(m_tree);
    setWidget(content);

    connect(m_filter, &QLineEdit::textChanged, this, &OutlineDock::applyFilter);
    connect(m_tree, &QTreeWidget::itemChanged, this, &OutlineDock::rename);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &OutlineDock::takeSelection);
    connect(&bench, &Workbench::selectionChanged, this, &OutlineDock::showSelection);
    connect(&bench.session(), &Session::modelChanged, this,
            [this](const Model &before, const Model &after) {
                if (m_showsPreview != m_bench.session().hasPreview() ||
                    !showsTheSame(before, after))
                    rebuild();
            });
    // Committing what was previewed changes no model, only its standing.
    connect(bench.session().history(), &QUndoStack::indexChanged, this, [this] {
        if (m_showsPreview != m_bench.session().hasPreview())
            rebuild();
    });
    rebuild();
}

void OutlineDock::refreshColours()
{
    m_tree->viewport()->update();
}

void OutlineDock::rebuild()
{
    {
        const QScopedValueRollback filling(m_isFilling, true);
        std::set<SectionId> folded;
        for (QTreeWidgetItemIterator it(m_tree); *it; ++it) {
            if ((*it)->childCount() > 0 && !(*it)->isExpanded())
                folded.insert(idOf(*it));
        }
        m_tree->clear();
        m_showsPreview = m_bench.session().hasPreview();

        const Document &document = m_bench.session().model().document;
        std::map<SectionId, QTreeWidgetItem *> items;
        for (const SectionPointer &section : document.sections) {
            const QString name = QString::fromStdString(section->name);
            auto *item = new QTreeWidgetItem({name});
            item->setIcon(0, rowIcon(QStringLiteral("section")));
            if (m_bench.session().committed().document.find(section->id)) {
                item->setFlags(item->flags() | Qt::ItemIsEditable);
            } else {
                QFont italic = font();
                italic.setItalic(true);
                item->setFont(0, italic);
                //: %1 is the name of a section
                item->setText(0, tr("%1, being drawn").arg(name));
            }
            item->setSizeHint(0, {0, kRowHeight});
            item->setData(0, kIdRole, static_cast<qlonglong>(section->id.value));
            item->setData(0, kNameRole, name);
            item->setData(0, kStockRole, QString::fromStdString(document.stockOf(*section).name));
            items[section->id] = item;
        }
        // A parent may stand after its child in a file, and a file may hold a ring of parents: a
        // section whose parents lead back to itself goes to the top.
        for (const SectionPointer &section : document.sections) {
            QTreeWidgetItem *item = items[section->id], *above = nullptr;
            if (section->parent) {
                const auto found = items.find(section->parent->section.drawn);
                above = found != items.end() ? found->second : nullptr;
            }
            for (QTreeWidgetItem *up = above; up; up = up->parent()) {
                if (up == item)
                    above = nullptr;
            }
            if (above)
                above->addChild(item);
            else
                m_tree->addTopLevelItem(item);
        }
        for (const auto &[id, item] : items)
            item->setExpanded(!folded.contains(id));
        m_empty->setVisible(items.empty());
    }
    applyFilter();
    showSelection();
}

void OutlineDock::rename(QTreeWidgetItem *item)
{
    if (m_isFilling)
        return;
    const QString before = item->data(0, kNameRole).toString(), name = item->text(0).trimmed();
    if (name == before)
        return;
    if (name.isEmpty()) {
        const QScopedValueRollback filling(m_isFilling, true);
        item->setText(0, before);
        return;
    }
    // Only after the editor has gone: the commit makes a new tree.
    const SectionId id = idOf(item);
    QMetaObject::invokeMethod(
        this,
        [this, id, before, name] {
            m_bench.commit(
                {Step::Kind::RenameSection, {before.toStdString()}},
                renameSection(m_bench.session().committed().document, id, name.toStdString()));
        },
        Qt::QueuedConnection);
}

/// An item stays when its own words fit or those of one below it.
void OutlineDock::applyFilter()
{
    const QString words = m_filter->text().trimmed();
    const std::function<bool(QTreeWidgetItem *)> filter = [&](QTreeWidgetItem *item) {
        bool fits = words.isEmpty() || item->text(0).contains(words, Qt::CaseInsensitive) ||
                    item->data(0, kStockRole).toString().contains(words, Qt::CaseInsensitive);
        for (int i = 0; i < item->childCount(); ++i)
            fits = filter(item->child(i)) || fits;
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
    m_bench.select(std::move(selection));
}

void OutlineDock::showSelection()
{
    const QScopedValueRollback filling(m_isFilling, true);
    const auto &selection = m_bench.interaction().selection();
    QTreeWidgetItem *newest = nullptr;
    for (QTreeWidgetItemIterator it(m_tree); *it; ++it) {
        const bool selected =
            std::find(selection.begin(), selection.end(), SectionRef(idOf(*it))) != selection.end();
        if (selected && !(*it)->isSelected())
            newest = *it;
        if ((*it)->isSelected() != selected)
            (*it)->setSelected(selected);
    }
    if (newest) {
        m_tree->setCurrentItem(newest, 0, QItemSelectionModel::NoUpdate);
        m_tree->scrollToItem(newest);
    }
}

} // namespace fff::ui
