// Edits of the stocks that the Export panel shows, as one step of the history, which can be taken
// back as a whole.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/base/result.h"
#include "core/model/document.h"

#include <functional>
#include <string_view>
#include <vector>

namespace fff::ui {

class Workbench;

class StockEdits : public QObject
{
    Q_OBJECT
public:
    /// From here on. The bench outlives it.
    explicit StockEdits(Workbench &bench, QObject *parent = nullptr);

    /// Those that sections are made of, in the document's order.
    const std::vector<StockId> &stocks() const { return m_stocks; }
    void choose(StockId stock);
    StockId chosen() const { return m_chosen; }
    /// The chosen one as it is now; of an empty model the one of the next section.
    const Stock &stock() const;
    const Document &document() const;

    void edit(const std::function<void(Stock &)> &change);
    /// All of them with what that machine removes of them, where it is known.
    void takeKerfsOf(std::string_view machine);
    bool isEdited() const;
    /// The document as it was; the edits can be had again from the history.
    void takeBack();

Q_SIGNALS:
    /// The chosen one is another, or is otherwise.
    void changed();

private:
    void commit(Result<Document> next);

    Workbench &m_bench;
    std::vector<StockId> m_stocks;
    StockId m_chosen;
    int m_begin = 0;      // step of the history
    std::string m_merges; // of this panel's edits
};

} // namespace fff::ui
