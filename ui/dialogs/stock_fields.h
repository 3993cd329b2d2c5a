// The numbers of one stock. Every change is one step of the history; dragging the thickness shows
// all slits following.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/properties/followed.h"

#include "core/model/document.h"

#include <functional>
#include <vector>

class QLabel;
class QLineEdit;

namespace fff::ui {

class OffcutRows;
class PropertyGroup;
class PropertyRow;
class ThicknessField;
class Workbench;

class StockFields : public QWidget
{
    Q_OBJECT
public:
    explicit StockFields(Workbench &bench, QWidget *parent = nullptr);

    void setStock(fff::StockId stock);
    void editName();
    /// The number in the field of this name: in sight, and selected; "stockOffcuts": where one is
    /// added.
    void editNumber(const QString &field);
    void refresh();

private:
    void makeSheet();
    void makeMeasuring(PropertyGroup *group);
    void makeSheets();
    void addOffcutDrawing();
    void makeStrength();
    void makeCutting();
    void makeSlits();
    PropertyGroup *addGroup(const QString &name);
    void addNumber(PropertyGroup *group, const QString &name, const char *objectName, double least,
                   double most, double step, int digits, const QString &unit,
                   std::function<double &(Stock &)> value);
    /// 0 stands for "not rated". `perUnit`: of the unit that is shown in that of the model.
    void addPrice(PropertyGroup *group);
    void addRating(PropertyGroup *group, const QString &name, const char *objectName, double most,
                   double step, const QString &unit, double perUnit,
                   std::optional<double> Stock::*value);
    void addLength(PropertyGroup *group, const QString &name, const char *objectName, double least,
                   double most, double Stock::*value, const char *field,
                   const std::function<void(Stock &, double)> &write);
    Followed followedOf(const char *field);
    QWidget *makeSheetSize();
    const Stock *stock() const;
    void edit(const std::function<void(Stock &)> &change);
    void rename();

    Workbench &m_bench;
    StockId m_stock;
    QLineEdit *m_name = nullptr;
    QLabel *m_uses = nullptr;
    ThicknessField *m_thickness = nullptr;
    OffcutRows *m_offcuts = nullptr;
    PropertyRow *m_kerfs = nullptr; // of machines
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
