// The stocks of the model with their chips, and the buttons to add, copy and remove one.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/document.h"

class QListWidget;
class QMenu;
class QToolButton;

namespace fff::ui {

class Workbench;

class StockList : public QWidget
{
    Q_OBJECT
public:
    explicit StockList(Workbench &bench, QWidget *parent = nullptr);

    /// Nothing happens when the model has no such stock.
    void choose(StockId stock);
    StockId current() const;

Q_SIGNALS:
    void chosen(fff::StockId stock);
    /// A new one asks for its name.
    void nameWanted();

private:
    void refresh();
    void fillAddMenu();
    void fillRemoveMenu();
    void add(Stock stock, bool asksForName);
    void remove(StockId replacement);
    void addFromFile();
    void saveToFile();
    std::string freeName(const std::string &name) const;
    int useCount(StockId stock) const;

    Workbench &m_bench;
    QListWidget *m_list = nullptr;
    QToolButton *m_add = nullptr, *m_copy = nullptr, *m_save = nullptr, *m_remove = nullptr;
    QMenu *m_presets = nullptr, *m_replacements = nullptr;
    bool m_isFilling = false;
};

} // namespace fff::ui
