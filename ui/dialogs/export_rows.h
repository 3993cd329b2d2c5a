// Fit and layout in the Export panel: kerf and clearance of the chosen stock with the slit width
// that they come to, and how parts lie on their sheets; in the simple window fit alone.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/dialogs/export_choices.h"

#include <functional>
#include <vector>

class QLabel;

namespace fff::ui {

class PropertyGroup;
class PropertyRow;
class StockEdits;

class ExportRows : public QWidget
{
    Q_OBJECT
public:
    /// choices  changed as a person chooses; it outlives this
    ExportRows(StockEdits &stocks, ExportChoices &choices, QWidget *parent = nullptr);

    /// Solids have no kerf, and lie on no sheet; in some files colours say something.
    void setFile(const ExportFile &file);
    void refresh();
    /// What came of it, below the link.
    void tellOfCoupon(const QString &sentence);

Q_SIGNALS:
    void couponWanted();
    /// Of how parts lie; a stock's numbers are announced by the document.
    void layoutChanged();

private:
    PropertyGroup *makeFit();
    PropertyGroup *makeLayout();
    PropertyGroup *makeCuts();
    PropertyRow *addOfStock(PropertyGroup *group, const QString &name, const char *objectName,
                            double least, double most, double Stock::*value,
                            const std::function<void(Stock &, double)> &write);
    void addLength(PropertyGroup *group, const QString &name, const char *objectName, double most,
                   double LayoutOptions::*value);

    StockEdits &m_stocks;
    ExportChoices &m_choices;
    std::vector<PropertyRow *> m_rows;
    std::vector<QWidget *> m_ofSheets; // of no use to solids
    PropertyRow *m_jointColours = nullptr;
    QLabel *m_coupon = nullptr; // what came of it
};

} // namespace fff::ui
