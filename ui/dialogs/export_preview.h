// The sheets that would be cut, one at a time, and the list of all parts beside them.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/dialogs/export_choices.h"

class QLabel;
class QStackedWidget;
class QToolButton;

namespace fff::ui {

class CuttingWork;
class PartsTable;
class SegmentedBox;
class SheetView;
class StockEdits;

class ExportPreview : public QWidget
{
    Q_OBJECT
public:
    /// All of them outlive it.
    ExportPreview(const CuttingWork &work, const StockEdits &stocks, const ExportChoices &choices,
                  QWidget *parent = nullptr);

    /// Solids have no sheets; the bar to measure is in each file.
    void setFile(const ExportFile &file);
    void refresh();

    /// Which of the chosen stock's sheets is shown, from 0 on; and how many there are.
    int sheet() const { return m_sheet; }
    int sheetCount() const;
    /// So many sheets further, if there is one.
    void turnBy(int sheets);
    /// What Tab goes to last.
    QWidget *lastInOrder() const;

private:
    void makeHead();
    std::vector<std::size_t> sheetsOfStock() const; // among all
    void showSheet();
    void refreshHead();

    const CuttingWork &m_work;
    const StockEdits &m_stocks;
    const ExportChoices &m_choices;
    bool m_isSolids = false, m_isSkin = false, m_isFilePerSheet = false;
    int m_sheet = 0;
    SegmentedBox *m_tabs = nullptr;
    QToolButton *m_previous = nullptr, *m_next = nullptr, *m_fit = nullptr;
    QLabel *m_state = nullptr; // how much of the sheets is used, or that it is being worked out
    QStackedWidget *m_pages = nullptr;
    SheetView *m_view = nullptr;
    PartsTable *m_table = nullptr;
    const void *m_listed = nullptr; // what the table shows
};

} // namespace fff::ui
