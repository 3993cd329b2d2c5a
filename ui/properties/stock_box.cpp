#include "ui/properties/stock_box.h"

#include "ui/base/lengths.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/stock_choice.h"
#include "ui/properties/thickness_field.h"
#include "ui/view/heading_weight.h"
#include "ui/view/view_style.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QWidgetAction>

#include <array>

namespace fff::ui {

namespace {

constexpr int kFieldWidth = 230; // px, slider and number together

} // namespace

StockBox::StockBox(Workbench &bench, QWidget *parent) : ChoiceBox(parent), m_bench(bench)
{
    setObjectName(QStringLiteral("toolStock"));
    setAccessibleName(tr("Stock of the next section"));
    setMinimumHeight(28);
    setSizeAdjustPolicy(QComboBox::AdjustToContents);

    m_menu = new QMenu(this);
    m_menu->setObjectName(QStringLiteral("toolStockMenu"));
    auto *row = new QWidget(m_menu);
    auto *label = new QLabel(tr("Thickness"), row);
    m_thickness = new ThicknessField(row);
    m_thickness->setMinimumWidth(kFieldWidth);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->setSpacing(12);
    layout->addWidget(label);
    layout->addWidget(m_thickness, 1);
    auto *action = new QWidgetAction(m_menu);
    action->setObjectName(QStringLiteral("toolThickness"));
    action->setDefaultWidget(row);
    m_menu->addAction(action);

    const auto current = [this] {
        return std::array{m_bench.session().committed().document.currentStock};
    };
    m_thickness->setFollowed(followedAt(m_bench, [this] {
        return std::optional(
            DrivenPlace{.of = DrivenPlace::Of::Stock,
                        .id = m_bench.session().model().document.currentStock.value,
                        .field = "thickness"});
    }));
    connect(m_thickness, &ThicknessField::dragged, this,
            [this, current](double mm) { previewThickness(m_bench, current(), mm); });
    connect(m_thickness, &ThicknessField::settled, this,
            [this, current](double mm) { commitThickness(m_bench, current(), mm); });
    connect(m_thickness, &ThicknessField::cancelled, this,
            [this] { m_bench.session().cancelPreview(); });
    connect(&m_bench.session(), &Session::modelChanged, this,
            [this](const Model &before, const Model &after) {
                if (before.document.stocks != after.document.stocks ||
                    before.document.currentStock != after.document.currentStock)
                    refresh();
            });
    connect(&settings(), &Settings::unitChanged, this, &StockBox::refresh);
    refresh();
}

void StockBox::setShort(bool isShort)
{
    if (isShort == m_isShort)
        return;
    m_isShort = isShort;
    refresh();
}

void StockBox::refresh()
{
    const Document &document = m_bench.session().model().document;
    const Stock *stock = document.find(document.currentStock);
    if (!stock)
        return;
    const QString whole = stockText(*stock, locale());
    setChoices({{{m_isShort ? lengthText(stock->thickness, 1, 3, locale()) : whole,
                  stockLook(*stock).face}},
                0});
    setToolTip(tr("Stock of the next section: %1").arg(whole));
    m_thickness->setThickness(stock->thickness);
    setFixedWidth(sizeHint().width());
}

/// The stocks above the slider, anew: they may have changed.
void StockBox::fillMenu()
{
    const QList<QAction *> actions = m_menu->actions();
    QAction *const slider = m_menu->findChild<QAction *>(QStringLiteral("toolThickness"));
    for (QAction *action : actions) {
        if (action != slider)
            delete action;
    }
    const Document &document = m_bench.session().committed().document;
    const std::vector<Stock> stocks = stockChoices(document);
    for (std::size_t i = 0; i < stocks.size(); ++i) {
        auto *action = new QAction(colourChip(stockLook(stocks[i]).face),
                                   stockText(stocks[i], locale()), m_menu);
        action->setIconVisibleInMenu(true);
        if (stocks[i].id == document.currentStock) {
            QFont bold = m_menu->font();
            bold.setWeight(headingWeight());
            action->setFont(bold);
        }
        connect(action, &QAction::triggered, this,
                [this, i] { chooseNewStock(m_bench, static_cast<int>(i)); });
        m_menu->insertAction(slider, action);
    }
    m_menu->insertSeparator(slider);
    if (m_editorAction && !m_editorAction->isVisible())
        return;
    m_menu->addSeparator();
    auto *editor = m_menu->addAction(tr("Stocks…"));
    connect(editor, &QAction::triggered, this, &StockBox::editorWanted);
}

void StockBox::showPopup()
{
    fillMenu();
    m_menu->setPalette(theme().palette());
    m_menu->setMinimumWidth(width());
    const QSize size = m_menu->sizeHint();
    QPoint at = mapToGlobal(QPoint(width() - std::max(size.width(), width()), height() + 2));
    m_menu->popup(at);
}

void StockBox::hidePopup()
{
    m_menu->hide();
}

} // namespace fff::ui
