#include "ui/dialogs/export_rows.h"

#include "core/model/machine_kerfs.h"
#include "ui/dialogs/cut_rows.h"
#include "ui/dialogs/slit_picture.h"
#include "ui/dialogs/stock_edits.h"
#include "ui/dialogs/stock_words.h"
#include "ui/properties/link_row.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/turning_choices.h"
#include "ui/settings/settings.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

ExportRows::ExportRows(StockEdits &stocks, ExportChoices &choices, QWidget *parent)
    : QWidget(parent), m_stocks(stocks), m_choices(choices)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeFit());
    if (!settings().hasSimpleWindow()) { // there these are as they were chosen last, or for all
        column->addWidget(makeLayout());
        column->addWidget(makeCuts());
    }
    PropertyRow::alignLabels(m_rows);
    connect(&stocks, &StockEdits::changed, this, &ExportRows::refresh);
    refresh();
}

PropertyRow *ExportRows::addOfStock(PropertyGroup *group, const QString &name,
                                    const char *objectName, double least, double most,
                                    double Stock::*value,
                                    const std::function<void(Stock &, double)> &write)
{
    auto *row = new LengthRow(
        name, objectName, {least, most, 0.01, 2, 3},
        [this, value] { return std::optional(m_stocks.stock().*value); },
        [this, write](double mm) {
            m_stocks.edit([write, mm](Stock &stock) { write(stock, mm); });
        },
        group);
    row->setThickness([this] { return std::optional(m_stocks.stock().thickness); });
    group->add(row);
    m_rows.push_back(row);
    return row;
}

PropertyGroup *ExportRows::makeFit()
{
    auto *group = new PropertyGroup(tr("Fit"), this);
    PropertyRow *kerf = addOfStock(
        group, tr("Kerf width (full)"), "exportKerf", 0.0, 5.0, &Stock::kerf,
        [this](Stock &stock, double mm) { setKerf(stock, m_choices.machine.toStdString(), mm); });
    kerf->setToolTip(tr("Kept for this stock and the machine that is chosen"));
    addOfStock(group, tr("Slit clearance"), "exportClearance", -1.0, 1.0, &Stock::clearance,
               [](Stock &stock, double mm) { stock.clearance = mm; });
    auto *drawn = new TextRow(
        tr("Drawn slit width"), "exportSlitWidth",
        [this] { return drawnSlitText(m_stocks.stock(), locale()); }, group);
    drawn->setToolTip(drawnSlitTip());
    group->add(drawn);
    m_rows.push_back(drawn);
    auto *picture = new SlitPicture(group);
    auto *shown = new EditorRow(
        QString(), "exportSlitPicture", picture,
        [this, picture] { picture->setStock(m_stocks.stock()); }, group);
    picture->setAccessibleName(tr("Drawn slit width"));
    shown->setToolTip(drawnSlitTip());
    group->add(shown);
    m_rows.push_back(shown);
    auto *coupon = new LinkRow(group);
    coupon->setObjectName(QStringLiteral("exportCoupon"));
    coupon->setTexts({tr("Not sure? Cut a fit coupon first…")});
    connect(coupon, &LinkRow::clicked, this, &ExportRows::couponWanted);
    group->add(coupon);
    m_coupon = new QLabel(group);
    m_coupon->setTextFormat(Qt::PlainText);
    m_coupon->setWordWrap(true);
    m_coupon->setObjectName(QStringLiteral("exportCouponSaid"));
    m_coupon->hide();
    group->add(m_coupon);
    PropertyRow *fitted = fittedSlitRow(
        [this] { return m_stocks.stock().clearance; },
        [this](double mm) { m_stocks.edit([mm](Stock &stock) { stock.clearance = mm; }); }, group);
    group->add(fitted);
    m_rows.push_back(fitted);
    m_ofSheets.insert(m_ofSheets.end(), {kerf, fitted, drawn, shown, coupon});
    return group;
}

void ExportRows::addLength(PropertyGroup *group, const QString &name, const char *objectName,
                           double most, double LayoutOptions::*value)
{
    auto *row = new LengthRow(
        name, objectName, {0.0, most, 0.5, 1, 2},
        [this, value] { return std::optional(m_choices.layout.*value); },
        [this, value](double mm) {
            m_choices.layout.*value = mm;
            Q_EMIT layoutChanged();
        },
        group);
    group->add(row);
    m_rows.push_back(row);
}

PropertyGroup *ExportRows::makeLayout()
{
    auto *group = new PropertyGroup(tr("Layout"), this);
    addLength(group, tr("Spacing"), "exportSpacing", kMostSpacing, &LayoutOptions::spacing);
    addLength(group, tr("Margin at the edge"), "exportMargin", kMostMargin, &LayoutOptions::margin);
    auto *rotation = new ChoiceRow(
        tr("Rotation"), "exportRotation", [this] { return turningChoices(m_choices.turning); },
        [this](int choice) {
            m_choices.turning = turningOf(choice);
            Q_EMIT layoutChanged();
        },
        group);
    rotation->setToolTip(tr("Quarter turns for a sheet with a grain"));
    group->add(rotation);
    m_rows.push_back(rotation);
    auto *bar = new QCheckBox(tr("100 mm, below the sheets"));
    auto *reference = new EditorRow(
        tr("Measuring bar"), "exportReference", bar,
        [this, bar] { bar->setChecked(m_choices.hasReference); }, group);
    reference->setToolTip(
        tr("Drawn beside the sheets, not cut: measure it on your machine to check the size"));
    connect(bar, &QCheckBox::clicked, this, [this](bool isOn) {
        m_choices.hasReference = isOn;
        Q_EMIT layoutChanged();
    });
    group->add(reference);
    m_rows.push_back(reference);
    auto *colours = new QCheckBox(tr("a colour for each joint"));
    m_jointColours = new EditorRow(
        tr("Joint numbers"), "exportJointColours", colours,
        [this, colours] { colours->setChecked(m_choices.hasJointColours); }, group);
    m_jointColours->setToolTip(
        tr("The two parts of a joint have its number in the same colour: for paper, and for "
           "machines that are told what to do with each colour"));
    connect(colours, &QCheckBox::clicked, this, [this](bool isOn) {
        m_choices.hasJointColours = isOn;
        Q_EMIT layoutChanged();
    });
    group->add(m_jointColours);
    m_rows.push_back(m_jointColours);
    m_ofSheets.push_back(group);
    return group;
}

PropertyGroup *ExportRows::makeCuts()
{
    auto *group = new PropertyGroup(tr("Cuts"), this);
    const auto write = [this](const CutFinish &finish) {
        m_choices.finish = finish;
        Q_EMIT layoutChanged();
    };
    for (PropertyRow *row : addCutRows(
             group, [this] { return m_choices.cuts(); }, write))
        m_rows.push_back(row);
    m_ofSheets.push_back(group);
    return group;
}

void ExportRows::setFile(const ExportFile &file)
{
    for (QWidget *one : m_ofSheets)
        one->setVisible(!file.isSolids);
    if (m_jointColours) // in the whole window
        m_jointColours->setVisible(file.isColoured);
}

void ExportRows::tellOfCoupon(const QString &sentence)
{
    m_coupon->setText(sentence);
    m_coupon->show();
}

void ExportRows::refresh()
{
    for (PropertyRow *row : m_rows)
        row->refresh();
}

} // namespace fff::ui
