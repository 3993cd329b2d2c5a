#include "ui/dialogs/stock_edits.h"

#include "core/model/edits.h"
#include "core/model/machine_kerfs.h"
#include "ui/bench/workbench.h"

#include <algorithm>

namespace fff::ui {

namespace {

constexpr Text kSetUpCutting = FFF_TEXT("Step", "Set up cutting");

std::vector<StockId> stocksInUse(const Model &model)
{
    std::vector<StockId> used;
    for (const auto &stock : model.document.stocks) {
        bool isUsed = false;
        for (std::size_t i = 0; i < model.sectionCount() && !isUsed; ++i)
            isUsed = model.section(i)->stock == stock->id;
        if (isUsed)
            used.push_back(stock->id);
    }
    return used;
}

} // namespace

StockEdits::StockEdits(Workbench &bench, QObject *parent)
    : QObject(parent), m_bench(bench), m_stocks(stocksInUse(bench.session().committed())),
      m_begin(bench.session().history()->index()),
      // Of this panel alone: what an earlier one has done is a step of its own.
      m_merges("export " + std::to_string(bench.session().revision()))
{
    m_chosen = m_stocks.empty() ? document().currentStock : m_stocks.front();
}

const Document &StockEdits::document() const
{
    return m_bench.session().committed().document;
}

const Stock &StockEdits::stock() const
{
    return *document().find(m_chosen);
}

void StockEdits::choose(StockId stock)
{
    m_chosen = stock;
    Q_EMIT changed();
}

void StockEdits::edit(const std::function<void(Stock &)> &change)
{
    Stock next = stock();
    change(next);
    if (next != stock())
        commit(setStock(document(), std::move(next)));
    Q_EMIT changed(); // what was refused goes back to what it was
}

void StockEdits::takeKerfsOf(std::string_view machine)
{
    Document next = cutOn(document(), machine);
    if (next.isSame(document()))
        return;
    commit(std::move(next));
    Q_EMIT changed();
}

void StockEdits::commit(Result<Document> next)
{
    Step step{kSetUpCutting};
    step.merges = m_merges;
    m_bench.commit(step, std::move(next));
}

bool StockEdits::isEdited() const
{
    return m_bench.session().history()->index() > m_begin;
}

void StockEdits::takeBack()
{
    if (isEdited())
        m_bench.session().history()->setIndex(m_begin);
}

} // namespace fff::ui
