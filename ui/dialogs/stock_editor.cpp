#include "ui/dialogs/stock_editor.h"

#include "ui/actions/action_set.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/stock_fields.h"
#include "ui/dialogs/stock_list.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kInset = 12;      // px from the window's right edge
constexpr int kBelowBars = 116; // px from its upper one: title, menus and tools stay in sight

} // namespace

StockEditor::StockEditor(Workbench &bench, const ActionSet &actions, QWidget *parent)
    : QDialog(parent), m_bench(bench)
{
    setObjectName(QStringLiteral("stockEditor"));
    setWindowTitle(tr("Stocks"));
    setMinimumSize(600, 420);
    resize(QSize(820, 560).boundedTo(screen()->availableSize() - QSize(40, 60)));
    // A window of its own has no part in the other's shortcuts.
    for (const char *id : {"edit.undo", "edit.redo"})
        addAction(actions.action(id));

    m_list = new StockList(bench, this);
    auto *area = new QScrollArea(this);
    area->setObjectName(QStringLiteral("stockArea"));
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus); // its fields have it
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_fields = new StockFields(bench, area);
    area->setWidget(m_fields);
    // Nothing of it is cut off at the right, in any language.
    m_fields->ensurePolished();
    area->setMinimumWidth(m_fields->minimumSizeHint().width() +
                          area->verticalScrollBar()->sizeHint().width());
    auto *row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(m_list);
    row->addWidget(area, 1);
    auto *buttons = new QDialogButtonBox(this);
    // A text of our own: Qt's are in English where its translations are not installed.
    QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    // Enter in a field is for the field.
    close->setAutoDefault(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    column->addLayout(row, 1);
    column->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_list, &StockList::chosen, m_fields, &StockFields::setStock);
    connect(m_list, &StockList::nameWanted, m_fields, &StockFields::editName);
    setTabOrder(m_list, m_fields);
}

void StockEditor::open(StockId stock, const QString &field)
{
    const Document &document = m_bench.session().committed().document;
    m_list->choose(document.find(stock) ? stock : document.currentStock);
    if (!m_wasPlaced) {
        // At the right, where numbers are: the slits in the view follow, which one wants to see.
        m_wasPlaced = true;
        const QRect window = parentWidget()->frameGeometry();
        // Its own frame, not there yet, will be as wide as the window's.
        const QSize size = this->size() + window.size() - parentWidget()->size();
        QRect free = screen()->availableGeometry();
        free.setSize((free.size() - size).expandedTo({1, 1})); // for its corner
        move(std::clamp(window.right() - size.width() - kInset, free.left(), free.right()),
             std::clamp(window.top() + kBelowBars, free.top(), free.bottom()));
    }
    show();
    raise();
    activateWindow();
    if (!field.isEmpty())
        m_fields->editNumber(field);
}

void StockEditor::refresh()
{
    setPalette(theme().palette());
    m_fields->refresh();
}

} // namespace fff::ui
