#include "ui/dialogs/stock_list.h"

#include "core/io/material_library.h"
#include "core/io/stock_file.h"
#include "core/model/edits.h"
#include "ui/base/file_dialog.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/stock_choice.h"
#include "ui/view/view_style.h"

#include <QListWidget>
#include <QMenu>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kWidth = 250, kRowHeight = 28; // px
constexpr int kIdRole = Qt::UserRole;

QToolButton *button(QWidget *parent, const char *objectName, const char *icon, const QString &text)
{
    auto *made = new QToolButton(parent);
    made->setObjectName(QLatin1String(objectName));
    made->setIcon(themedIcon(QLatin1String(icon)));
    made->setIconSize({16, 16});
    made->setText(text);
    made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    made->setFocusPolicy(Qt::StrongFocus);
    made->setMinimumHeight(28);
    made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return made;
}

} // namespace

StockList::StockList(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    setMinimumWidth(kWidth);
    m_list = new QListWidget(this);
    m_list->setObjectName(QStringLiteral("stockList"));
    m_list->setAccessibleName(tr("Stocks of this model"));
    m_list->setIconSize({14, 14});
    m_list->setUniformItemSizes(true);
    setFocusProxy(m_list);
    m_add = button(this, "stockAdd", "plus", tr("Add"));
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setToolTip(tr("Add a stock from the presets"));
    m_presets = new QMenu(m_add);
    m_add->setMenu(m_presets);
    m_copy = button(this, "stockCopy", "duplicate", tr("Duplicate"));
    m_copy->setToolTip(tr("Add a stock with the same numbers"));
    m_save = button(this, "stockSave", "save", tr("Save…"));
    m_save->setToolTip(tr("Save this stock in a file, for other models and other people"));
    m_save->setAccessibleName(tr("Save the stock in a file"));
    m_remove = button(this, "stockRemove", "trash", tr("Remove"));
    m_remove->setAccessibleName(tr("Remove the stock"));
    m_replacements = new QMenu(m_remove);
    m_remove->setPopupMode(QToolButton::InstantPopup);

    auto *buttons = new QGridLayout;
    buttons->setSpacing(4);
    buttons->addWidget(m_add, 0, 0);
    buttons->addWidget(m_copy, 0, 1);
    buttons->addWidget(m_save, 1, 0);
    buttons->addWidget(m_remove, 1, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_list, 1);
    column->addLayout(buttons);

    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        if (!m_isFilling) {
            refresh();
            Q_EMIT chosen(current());
        }
    });
    connect(m_presets, &QMenu::aboutToShow, this, &StockList::fillAddMenu);
    connect(m_replacements, &QMenu::aboutToShow, this, &StockList::fillRemoveMenu);
    connect(m_copy, &QToolButton::clicked, this, [this] {
        if (const Stock *stock = m_bench.session().committed().document.find(current()))
            add(*stock, true);
    });
    connect(m_save, &QToolButton::clicked, this, &StockList::saveToFile);
    connect(m_remove, &QToolButton::clicked, this, [this] {
        const Document &document = m_bench.session().committed().document;
        for (const auto &stock : document.stocks) {
            if (stock->id != current())
                return remove(stock->id);
        }
    });
    connect(&bench.session(), &Session::modelChanged, this, [this] {
        if (!m_isFilling)
            refresh();
    });
    refresh();
}

StockId StockList::current() const
{
    const QListWidgetItem *item = m_list->currentItem();
    return StockId{item ? item->data(kIdRole).toLongLong() : 0};
}

void StockList::choose(StockId stock)
{
    for (int i = 0; i < m_list->count(); ++i) {
        if (m_list->item(i)->data(kIdRole).toLongLong() == stock.value)
            m_list->setCurrentRow(i);
    }
    Q_EMIT chosen(current());
}

int StockList::useCount(StockId stock) const
{
    const auto &sections = m_bench.session().committed().document.sections;
    return static_cast<int>(std::count_if(sections.begin(), sections.end(),
                                          [stock](const auto &s) { return s->stock == stock; }));
}

void StockList::refresh()
{
    const StockId before = current();
    bool isGone = true;
    {
        const QScopedValueRollback filling(m_isFilling, true);
        const auto &stocks = m_bench.session().model().document.stocks;
        while (m_list->count() > static_cast<int>(stocks.size()))
            delete m_list->takeItem(m_list->count() - 1);
        while (m_list->count() < static_cast<int>(stocks.size()))
            m_list->addItem(new QListWidgetItem);
        for (int i = 0; i < m_list->count(); ++i) {
            const Stock &stock = *stocks[static_cast<std::size_t>(i)];
            QListWidgetItem *item = m_list->item(i);
            item->setText(stockText(stock, locale()));
            item->setIcon(colourChip(stockLook(stock).face));
            item->setData(kIdRole, static_cast<qlonglong>(stock.id.value));
            item->setSizeHint({0, kRowHeight});
            item->setToolTip(tr("%n section(s)", nullptr, useCount(stock.id)));
            if (stock.id == before) {
                isGone = false;
                m_list->setCurrentRow(i);
            }
        }
        if (isGone && m_list->count() > 0)
            m_list->setCurrentRow(0);
    }
    const bool isOnly = m_list->count() < 2;
    const int uses = useCount(current());
    m_remove->setEnabled(!isOnly);
    m_remove->setToolTip(isOnly ? tr("A model needs a stock; add another one first")
                                : tr("Remove this stock"));
    // A stock in use goes with the question what its sections shall be made of.
    m_remove->setMenu(uses > 0 && !isOnly ? m_replacements : nullptr);
    if (isGone)
        Q_EMIT chosen(current());
}

void StockList::fillAddMenu()
{
    m_presets->clear();
    m_presets->setPalette(theme().palette());
    const auto offer = [this](QMenu &menu, const Stock &stock, const QString &text) {
        QAction *action = menu.addAction(colourChip(stockLook(stock).face), text);
        action->setIconVisibleInMenu(true);
        connect(action, &QAction::triggered, this, [this, stock] { add(stock, false); });
    };
    offer(*m_presets, birchPlywood(), stockName(birchPlywood()));
    for (const Material &material : io::materialLibrary()) {
        const Stock &usual = material.stocks.front();
        if (material.stocks.size() == 1) {
            offer(*m_presets, usual, stockName(usual));
            continue;
        }
        QMenu *menu = m_presets->addMenu(colourChip(stockLook(usual).face), stockName(usual));
        menu->menuAction()->setIconVisibleInMenu(true);
        for (const Stock &stock : material.stocks)
            offer(*menu, stock,
                  lengthText(stock.nominalThickness.value_or(stock.thickness), 1, 3, locale()));
    }
    offer(*m_presets, flatfabAcrylic(), stockName(flatfabAcrylic()));
    m_presets->addSeparator();
    connect(m_presets->addAction(tr("From a file…")), &QAction::triggered, this,
            &StockList::addFromFile);
}

/// Of any model: that of its next section.
void StockList::addFromFile()
{
    FileDialog dialog(window(), tr("Add a stock from a file"), documentsFolder(),
                      tr("FlatFitFab models (%1)").arg(QStringLiteral("*.fff")));
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() != QDialog::Accepted)
        return;
    Result<Stock> stock = io::readStock(dialog.selectedFiles().constFirst());
    if (stock)
        add(*std::move(stock), false);
    else
        Q_EMIT m_bench.editFailed(stock.error());
}

void StockList::saveToFile()
{
    const Stock *stock = m_bench.session().committed().document.find(current());
    if (!stock)
        return;
    FileDialog dialog(window(), tr("Save the stock in a file"), documentsFolder(),
                      tr("FlatFitFab models (%1)").arg(QStringLiteral("*.fff")));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("fff"));
    dialog.selectFile(stockName(*stock) + QStringLiteral(".fff"));
    const QString path = dialog.target();
    if (path.isEmpty())
        return;
    if (const Result<void> written = io::writeStock(path, *stock); !written)
        Q_EMIT m_bench.editFailed(written.error());
}

void StockList::fillRemoveMenu()
{
    m_replacements->clear();
    m_replacements->setPalette(theme().palette());
    const Document &document = m_bench.session().committed().document;
    const int uses = useCount(current());
    m_replacements->addSection(tr("Make its %n section(s) of", nullptr, uses));
    for (const auto &stock : document.stocks) {
        if (stock->id == current())
            continue;
        QAction *action = m_replacements->addAction(colourChip(stockLook(*stock).face),
                                                    stockText(*stock, locale()));
        action->setIconVisibleInMenu(true);
        connect(action, &QAction::triggered, this, [this, id = stock->id] { remove(id); });
    }
}

/// "MDF 2" when there is an MDF.
std::string StockList::freeName(const std::string &name) const
{
    const auto &stocks = m_bench.session().committed().document.stocks;
    std::string free = name;
    for (int n = 2; std::any_of(stocks.begin(), stocks.end(),
                                [&](const auto &stock) { return stock->name == free; });
         ++n)
        free = name + " " + std::to_string(n);
    return free;
}

void StockList::add(Stock stock, bool asksForName)
{
    const Document &document = m_bench.session().committed().document;
    const StockId before = document.currentStock;
    stock.name = freeName(stock.name);
    const QString name = stockName(stock);
    Result<Document> next = addStock(document, std::move(stock));
    StockId id;
    if (next) {
        id = next->currentStock;
        next = setCurrentStock(std::move(*next), before); // what is drawn next is another question
    }
    m_bench.commit(tr("Add stock %1").arg(name), std::move(next));
    choose(id);
    if (asksForName)
        Q_EMIT nameWanted();
}

void StockList::remove(StockId replacement)
{
    const Document &document = m_bench.session().committed().document;
    const Stock *stock = document.find(current());
    if (!stock)
        return;
    m_bench.commit(tr("Remove stock %1").arg(stockName(*stock)),
                   removeStock(document, stock->id, replacement));
}

} // namespace fff::ui
