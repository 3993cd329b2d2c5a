#include "ui/docks/load_tree.h"

#include "core/interaction/load_editing.h"
#include "ui/base/icon.h"
#include "ui/bench/load_words.h"
#include "ui/bench/workbench.h"
#include "ui/docks/outline_marks.h"
#include "ui/view/heading_weight.h"

#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

enum LoadColumn { kLoadName, kLoadAmount, kLoadColumns };

/// Longer lists scroll.
constexpr int kMostRows = 6;

} // namespace

LoadTree::LoadTree(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("loadsTitle"));
    QFont bold = m_title->font();
    bold.setWeight(headingWeight());
    m_title->setFont(bold);
    m_title->setContentsMargins(10, 6, 8, 4);
    m_title->setForegroundRole(QPalette::PlaceholderText);

    m_tree = new QTreeWidget(this);
    m_tree->setObjectName(QStringLiteral("loadTree"));
    m_tree->setAccessibleName(tr("Weights and pushes"));
    m_tree->setAccessibleDescription(tr("F2 renames, Del removes."));
    m_tree->setColumnCount(kLoadColumns);
    m_tree->setHeaderHidden(true);
    dressOutline(m_tree, kLoadAmount);
    m_tree->header()->setSectionResizeMode(kLoadAmount, QHeaderView::ResizeToContents);
    m_tree->setSelectionMode(QAbstractItemView::SingleSelection);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_tree);

    connect(m_tree, &QTreeWidget::itemChanged, this, &LoadTree::rename);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &LoadTree::takeSelection);
    connect(&bench, &Workbench::selectionChanged, this, &LoadTree::showSelection);
    connect(&bench.session(), &Session::modelChanged, this, &LoadTree::followModel);
    followModel();
}

void LoadTree::addKey(QAction *action)
{
    m_tree->addAction(action);
}

void LoadTree::refreshColours()
{
    writeRows();
    showSelection();
}

void LoadTree::followModel()
{
    const std::vector<Load> &loads = m_bench.session().model().document.loads;
    std::vector<QString> titles;
    for (const Load &load : loads)
        titles.push_back(titleOf(load));
    // Where what a row says is the same.
    const auto showTheSame = [](const Load &a, const Load &b) {
        return a.id == b.id && a.mass == b.mass && a.push == b.push;
    };
    if (titles == m_titles &&
        std::equal(loads.begin(), loads.end(), m_shown.begin(), m_shown.end(), showTheSame))
        return;
    m_shown = loads;
    m_titles = std::move(titles);
    writeRows();
    showSelection();
}

QString LoadTree::titleOf(const Load &load) const
{
    return loadTitle(load,
                     QString::fromStdString(m_bench.session().model().nameOf(load.section)));
}

void LoadTree::writeRows()
{
    const QScopedValueRollback filling(m_isFilling, true);
    const auto hasKind = [this](LoadKind kind) {
        return std::any_of(m_shown.begin(), m_shown.end(),
                           [kind](const Load &load) { return load.kind == kind; });
    };
    m_title->setText(!hasKind(LoadKind::Push)     ? tr("Weights")
                     : !hasKind(LoadKind::Weight) ? tr("Pushes")
                                                  : tr("Weights and pushes"));
    while (m_tree->topLevelItemCount() > static_cast<int>(m_shown.size()))
        delete m_tree->takeTopLevelItem(m_tree->topLevelItemCount() - 1);
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        const Load &load = m_shown[i];
        const int row = static_cast<int>(i);
        QTreeWidgetItem *item = m_tree->topLevelItem(row);
        if (!item) {
            item = new QTreeWidgetItem(m_tree);
            item->setSizeHint(kLoadName, {0, kOutlineRow});
            item->setTextAlignment(kLoadAmount, Qt::AlignRight | Qt::AlignVCenter);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        }
        item->setIcon(kLoadName,
                      rowIcon(load.isPush() ? QStringLiteral("push") : QStringLiteral("weight")));
        item->setText(kLoadName, m_titles[i]);
        item->setText(kLoadAmount, loadAmount(load, locale()) + QStringLiteral("  "));
    }
    fit();
    setVisible(!m_shown.empty());
}

void LoadTree::fit()
{
    const int rows = std::min(static_cast<int>(m_shown.size()), kMostRows);
    m_tree->setFixedHeight(rows * kOutlineRow + 4);
}

void LoadTree::rename(QTreeWidgetItem *item)
{
    const int row = m_tree->indexOfTopLevelItem(item);
    if (m_isFilling || row < 0)
        return;
    const QScopedValueRollback filling(m_isFilling, true);
    const Load &load = m_shown[static_cast<std::size_t>(row)];
    const QString name = typedName(item, m_titles[static_cast<std::size_t>(row)]);
    if (name.isEmpty())
        return;
    // Only after the editor has gone: the commit writes the row anew.
    QMetaObject::invokeMethod(
        this,
        [this, id = load.id, name] {
            const Model &model = m_bench.session().committed();
            const Load *known = model.document.find(id);
            if (!known)
                return;
            Load next = *known;
            next.name = name.toStdString();
            m_bench.editSections(changedLoad(model, next));
        },
        Qt::QueuedConnection);
}

void LoadTree::takeSelection()
{
    if (m_isFilling || m_tree->selectedItems().isEmpty())
        return;
    const int row = m_tree->indexOfTopLevelItem(m_tree->selectedItems().front());
    m_bench.run(QStringLiteral("physics.selectLoad"), {{"load", std::to_string(row)}});
}

void LoadTree::showSelection()
{
    const QScopedValueRollback filling(m_isFilling, true);
    const LoadId selected = m_bench.interaction().selectedLoad();
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        QTreeWidgetItem *item = m_tree->topLevelItem(static_cast<int>(i));
        const bool isSelected = m_shown[i].id == selected;
        if (item->isSelected() == isSelected)
            continue;
        item->setSelected(isSelected);
        if (isSelected) {
            m_tree->setCurrentItem(item, kLoadName, QItemSelectionModel::NoUpdate);
            m_tree->scrollToItem(item);
        }
    }
}

} // namespace fff::ui
