// The sheets of a stock besides whole ones, one below the other: how large, how many, and a button
// to take each away; below them the buttons to add one by its size, or from a drawing.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/dialogs/slit_rows.h"

#include <vector>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace fff::ui {

class LengthEdit;
class NumberEdit;

class OffcutRows : public QWidget
{
    Q_OBJECT
public:
    explicit OffcutRows(StockAccess stock, QWidget *parent = nullptr);

    /// Reads the stock.
    void refresh();
    void focusAdd();
    /// About the drawing that an offcut was read from, below all; nothing: what was said is over.
    void say(const QStringList &sentences);

Q_SIGNALS:
    /// A drawing is to be chosen.
    void drawingWanted();

private:
    struct Row
    {
        QWidget *widget = nullptr;
        LengthEdit *sides[2] = {nullptr, nullptr}; // of rectangles
        QLabel *outline = nullptr;                 // in their place for all others
        NumberEdit *count = nullptr;
    };
    Row makeRow(std::size_t index);
    void add(Result<SpareSheet> sheet);
    void setSide(std::size_t index, int axis, double mm);

    StockAccess m_stock;
    QVBoxLayout *m_column = nullptr;
    std::vector<Row> m_rows;
    QToolButton *m_addSize = nullptr;
    QLabel *m_said = nullptr;
};

} // namespace fff::ui
