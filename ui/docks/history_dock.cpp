#include "ui/docks/history_dock.h"

#include "core/model/changes.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/view/heading_weight.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QUndoView>
#include <QVBoxLayout>

namespace fff::ui {

namespace {

constexpr int kRowHeight = 24, kMargin = 8, kIcon = 14; // px

/// The step that the model stands at is bold, those that were undone are muted.
class StepDelegate : public QStyledItemDelegate
{
public:
    StepDelegate(const QUndoStack &history, QObject *parent)
        : QStyledItemDelegate(parent), m_history(history)
    {
    }

    /// With room at the left, where the view has none.
    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override
    {
        if (option.state.testFlag(QStyle::State_Selected))
            painter->fillRect(option.rect, option.palette.highlight());
        QStyleOptionViewItem inset = option;
        inset.rect.setLeft(inset.rect.left() + kMargin);
        QStyledItemDelegate::paint(painter, inset, index);
    }

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.row() == m_history.index())
            option->font.setWeight(headingWeight());
        if (index.row() > m_history.index())
            option->palette.setColor(QPalette::Text, theme().muted);
        // Words stand in one line whether a step is the saved one or not.
        option->features |= QStyleOptionViewItem::HasDecoration;
        option->decorationSize = {kIcon, kIcon};
        option->decorationAlignment = Qt::AlignLeft | Qt::AlignVCenter;
    }
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        return {QStyledItemDelegate::sizeHint(option, index).width(), kRowHeight};
    }

private:
    const QUndoStack &m_history;
};

} // namespace

HistoryDock::HistoryDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("History"), parent), m_bench(bench)
{
    dressDock(this, "historyDock");
    auto *content = new QWidget(this);
    QUndoStack *history = bench.session().history();
    m_view = new QUndoView(history, content);
    m_view->setObjectName(QStringLiteral("historyList"));
    m_view->setAccessibleName(tr("History"));
    m_view->setAccessibleDescription(tr("Every step; choosing one goes back to it."));
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setUniformItemSizes(true);
    m_view->setMouseTracking(true);
    m_view->setItemDelegate(new StepDelegate(*history, m_view));
    m_view->setIconSize({kIcon, kIcon});
    m_empty = new QLabel(tr("Every step will be listed here; go back to any of them."), m_view);
    m_empty->setObjectName(QStringLiteral("historyEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAutoFillBackground(true);
    m_empty->setBackgroundRole(QPalette::Base);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setMargin(12);
    m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    auto *over = new QVBoxLayout(m_view);
    over->setContentsMargins(0, 0, 0, 0);
    over->addWidget(m_empty);
    setWidget(content);

    connect(m_view, &QAbstractItemView::entered, this,
            [this](const QModelIndex &index) { hoverStep(index.row()); });
    connect(m_view, &QAbstractItemView::viewportEntered, this, &HistoryDock::leaveSteps);
    m_view->viewport()->installEventFilter(this);
    // A click in the list: the stack has jumped by then.
    connect(m_view, &QAbstractItemView::clicked, this, [this](const QModelIndex &index) {
        const QString step = index.data().toString().toHtmlEscaped();
        if (index.row() == 0)
            Q_EMIT said(tr("Back to the beginning. Click a later step to do it again."));
        else
            Q_EMIT said(tr("The model is as it was after \u201c%1\u201d.").arg(step));
    });
    connect(history, &QUndoStack::indexChanged, this, &HistoryDock::refresh);
    connect(history, &QUndoStack::cleanChanged, this, &HistoryDock::refresh);
    refresh();
}

void HistoryDock::refreshColours()
{
    m_view->setCleanIcon(rowIcon(QStringLiteral("save")));
    m_view->viewport()->update();
}

void HistoryDock::refresh()
{
    QUndoStack &history = *m_bench.session().history();
    m_empty->setVisible(history.count() == 0);
    const auto first = m_bench.session().modelAfter(0);
    m_view->setEmptyLabel(first && first->sectionCount() > 0 ? tr("As it was opened")
                                                             : tr("New model"));
    m_view->viewport()->update(); // also rows whose index is the old one
    // Another step may be under the cursor by now, or the same one have another effect.
    const QWidget *rows = m_view->viewport();
    const QModelIndex under =
        rows->underMouse() ? m_view->indexAt(rows->mapFromGlobal(QCursor::pos())) : QModelIndex();
    if (under.isValid())
        hoverStep(under.row());
    else
        leaveSteps();
}

/// Outlines what the step changed, of what is there now, and shows what is not as ghosts: what it
/// took away, what was of another shape, what a step that is undone would bring back. It is done
/// when the cursor comes to it, not with every move.
void HistoryDock::hoverStep(int row)
{
    const Session &session = m_bench.session();
    m_view->setToolTip(row == session.history()->cleanIndex() ? tr("Saved here") : QString());
    const auto before = row > 0 ? session.modelAfter(row - 1) : nullptr;
    const auto after = session.modelAfter(row);
    if (!before || !after) {
        m_bench.setOutlined({});
        return;
    }
    m_bench.setOutlined(changedSections(*before, *after),
                        missingSections(*before, *after, session.committed()));
}

void HistoryDock::leaveSteps()
{
    m_view->setToolTip(QString());
    m_bench.setOutlined({});
}

bool HistoryDock::eventFilter(QObject *object, QEvent *event)
{
    if (event->type() == QEvent::Leave || event->type() == QEvent::Hide)
        leaveSteps();
    return QDockWidget::eventFilter(object, event);
}

} // namespace fff::ui
