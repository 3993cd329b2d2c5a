#include "ui/main_tool_bar.h"

#include "ui/actions/action_set.h"
#include "ui/icon.h"
#include "ui/properties/stock_choice.h"
#include "ui/theme.h"
#include "ui/workbench.h"

#include <QPushButton>

namespace fff::ui {

namespace {

constexpr int kToolLabels = 1100; // px; a narrower tool bar has no labels

} // namespace

MainToolBar::MainToolBar(Workbench &bench, const ActionSet &actions, QWidget *parent)
    : QToolBar(tr("Tool bar"), parent), m_bench(bench)
{
    setObjectName(QStringLiteral("mainToolBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setIconSize({20, 20});
    actions.fill(this, {"file.new", "file.open", "file.save", "", "edit.undo", "edit.redo", "",
                        "edit.delete", "", "view.fitAll", "view.front", "view.right", "view.top",
                        "view.iso"});

    auto *stretch = new QWidget(this);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(stretch);
    makeStock();
    auto *gap = new QWidget(this);
    gap->setFixedWidth(8);
    addWidget(gap);
    makeExport(actions.action("file.export"));
}

void MainToolBar::makeStock()
{
    m_stock = new ChoiceBox(this);
    m_stock->setObjectName(QStringLiteral("toolStock"));
    m_stock->setToolTip(tr("Stock of the next section"));
    m_stock->setAccessibleName(tr("Stock of the next section"));
    m_stock->setMinimumHeight(28);
    m_stock->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(m_stock, &QComboBox::activated, this,
            [this](int index) { chooseNewStock(m_bench, index); });
    connect(&m_bench.session(), &Session::modelChanged, m_stock, [this] {
        const Document &document = m_bench.session().model().document;
        Choices choices = choicesOfStock(document, document.currentStock);
        const std::vector<Stock> stocks = stockChoices(document);
        for (std::size_t i = 0; i < stocks.size(); ++i)
            choices.all[i].text = stockText(stocks[i], locale());
        m_stock->setChoices(choices);
    });
    addWidget(m_stock);
}

void MainToolBar::makeExport(QAction *exporting)
{
    m_export = new QPushButton(exporting->iconText(), this);
    m_export->setObjectName(QStringLiteral("exportButton"));
    m_export->setIconSize({18, 18});
    const auto follow = [this, exporting] {
        m_export->setEnabled(exporting->isEnabled());
        m_export->setToolTip(exporting->toolTip());
    };
    follow();
    connect(exporting, &QAction::changed, m_export, follow);
    connect(m_export, &QPushButton::clicked, exporting, &QAction::trigger);
    addWidget(m_export);
}

void MainToolBar::fold(int windowWidth)
{
    const bool labels = windowWidth >= kToolLabels;
    setToolButtonStyle(labels ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
    setFixedHeight(labels ? 56 : 44);
}

void MainToolBar::refresh()
{
    const auto mask = [this](const QColor &colour) {
        return tintedPixmap(QStringLiteral("export"), 18, colour, devicePixelRatioF());
    };
    QIcon exporting(mask(theme().onAccent));
    exporting.addPixmap(mask(theme().muted), QIcon::Disabled);
    m_export->setIcon(exporting);
}

} // namespace fff::ui
