#include "ui/dialogs/export_preview.h"

#include "ui/bench/measures.h"
#include "ui/dialogs/cutting_work.h"
#include "ui/dialogs/parts_table.h"
#include "ui/dialogs/sheet_view.h"
#include "ui/dialogs/stock_edits.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/segmented_box.h"
#include "ui/properties/stock_choice.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

enum PreviewTab { SheetTab, ListTab };

} // namespace

ExportPreview::ExportPreview(const CuttingWork &work, const StockEdits &stocks,
                             const ExportChoices &choices, QWidget *parent)
    : QWidget(parent), m_work(work), m_stocks(stocks), m_choices(choices)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    makeHead();
    m_pages = new QStackedWidget(this);
    m_view = new SheetView(m_pages);
    m_table = new PartsTable(m_pages);
    m_pages->addWidget(m_view);
    m_pages->addWidget(m_table);
    column->addWidget(m_pages, 1);
    connect(m_fit, &QToolButton::clicked, m_view, &SheetView::fit);
    connect(m_view, &SheetView::fittedChanged, this, &ExportPreview::refreshHead);
    connect(&work, &CuttingWork::changed, this, &ExportPreview::refresh);
    connect(&stocks, &StockEdits::changed, this, &ExportPreview::refresh);
    refresh();
}

void ExportPreview::makeHead()
{
    m_tabs = new SegmentedBox({tr("Sheet %1 of %2").arg(1).arg(1), tr("Parts list")}, this);
    m_tabs->setObjectName(QStringLiteral("exportTabs"));
    m_tabs->setCurrent(SheetTab);
    m_previous = smallButton(QStringLiteral("step_previous"), "exportPreviousSheet",
                             tr("Previous sheet (Page Up)"), this);
    m_next = smallButton(QStringLiteral("step_next"), "exportNextSheet",
                         tr("Next sheet (Page Down)"), this);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("exportState"));
    m_state->setForegroundRole(QPalette::PlaceholderText);
    m_fit = smallButton(QStringLiteral("fit"), "exportFitSheet", tr("Show the whole sheet"), this);
    auto *head = new QHBoxLayout;
    head->setSpacing(6);
    head->addWidget(m_tabs);
    head->addWidget(m_previous);
    head->addWidget(m_next);
    head->addStretch(1);
    head->addWidget(m_state);
    head->addWidget(m_fit);
    static_cast<QVBoxLayout *>(layout())->addLayout(head);
    connect(m_tabs, &SegmentedBox::activated, this, [this](int tab) {
        m_pages->setCurrentIndex(tab);
        refreshHead();
    });
    connect(m_previous, &QToolButton::clicked, this, [this] { turnBy(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { turnBy(1); });
}

std::vector<std::size_t> ExportPreview::sheetsOfStock() const
{
    std::vector<std::size_t> sheets;
    if (!m_work.cutting())
        return sheets;
    for (std::size_t i = 0; i < m_work.made()->sheets.size(); ++i)
        if (m_work.made()->sheets[i].stock == m_stocks.chosen())
            sheets.push_back(i);
    return sheets;
}

int ExportPreview::sheetCount() const
{
    return static_cast<int>(sheetsOfStock().size());
}

QWidget *ExportPreview::lastInOrder() const
{
    return m_table;
}

void ExportPreview::turnBy(int sheets)
{
    m_sheet += sheets; // refresh() keeps it among those that there are
    if (m_isSolids)
        return;
    m_tabs->setCurrent(SheetTab);
    m_pages->setCurrentIndex(SheetTab);
    refresh();
}

void ExportPreview::setFile(const ExportFile &file)
{
    m_isSolids = file.isSolids;
    m_isSkin = file.isSkin;
    m_isFilePerSheet = file.isFilePerSheet;
    if (m_isSolids)
        m_pages->setCurrentIndex(SheetTab); // where that is said
    m_tabs->setCurrent(m_pages->currentIndex());
    refresh();
}

void ExportPreview::refresh()
{
    m_sheet = std::clamp(m_sheet, 0, std::max(0, sheetCount() - 1));
    showSheet();
    if (const Cutting *cutting = m_work.cutting(); cutting != m_listed) {
        m_listed = cutting;
        m_table->setParts(cutting ? cutting->drawing.list : std::vector<ListedPart>());
    }
    refreshHead();
}

void ExportPreview::showSheet()
{
    const std::vector<std::size_t> sheets = sheetsOfStock();
    SheetView::Content content;
    content.isOlder = m_work.isWorking();
    if (m_isSkin) {
        content.note = tr("A skin has no sheets: the file holds the form that the sections "
                          "suggest, as a surface over their contours.");
    } else if (m_isSolids) {
        content.note = tr("Solids have no sheets: the file holds the model as it stands, true to "
                          "size, with its slits.");
    } else if (!sheets.empty()) {
        const std::size_t index = sheets[static_cast<std::size_t>(m_sheet)];
        const std::shared_ptr<const CuttingWork::Made> made = m_work.made();
        const SheetPaths &sheet = made->sheets[index];
        content.sheet = std::shared_ptr<const SheetPaths>(made, &sheet); // shares its life
        content.margin = m_choices.layout.margin;
        const bool isLast = index + 1 == made->sheets.size();
        content.hasReference = m_choices.hasReference && (isLast || m_isFilePerSheet);
        //: %1 is the number of a sheet, %2 the name of a stock, %3 the sheet's size
        content.caption =
            tr("Sheet %1 \u00B7 %2 \u00B7 %3")
                .arg(sheet.number)
                .arg(stockName(m_stocks.stock()),
                     sizeText({sheet.size.width(), sheet.size.height()}, 0, locale()));
    } else {
        content.note =
            m_work.isWorking() ? tr("Laying the parts on sheets…") : tr("There is nothing to cut.");
    }
    m_view->setContent(content);
}

void ExportPreview::refreshHead()
{
    const int count = sheetCount();
    m_tabs->setText(SheetTab, tr("Sheet %1 of %2").arg(m_sheet + 1).arg(std::max(1, count)));
    for (QToolButton *button : {m_previous, m_next})
        button->setVisible(count > 1 && !m_isSolids);
    m_previous->setEnabled(m_sheet > 0);
    m_next->setEnabled(m_sheet + 1 < count);
    m_tabs->setVisible(!m_isSolids);
    m_fit->setVisible(m_pages->currentIndex() == SheetTab && !m_isSolids);
    m_fit->setEnabled(!m_view->isFitted());
    const Cutting *cutting = m_work.cutting();
    m_state->setVisible(!m_isSolids);
    if (m_work.isWorking())
        m_state->setText(tr("Working…"));
    else if (cutting)
        //: %1 is a number with a percent sign
        m_state->setText(
            tr("Used: %1")
                .arg(QStringLiteral("<b>%1 %</b>")
                         .arg(locale().toString(qRound(100.0 * m_work.made()->nested->filled)))));
    else
        m_state->clear();
}

} // namespace fff::ui
