#include "ui/dialogs/stock_fields.h"

#include "core/io/offcut_file.h"
#include "core/model/edits.h"
#include "core/model/machine_kerfs.h"
#include "core/model/materials.h"
#include "ui/base/file_dialog.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/export_choices.h"
#include "ui/dialogs/offcut_rows.h"
#include "ui/dialogs/slit_rows.h"
#include "ui/dialogs/stock_words.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/stock_choice.h"
#include "ui/properties/thickness_field.h"
#include "ui/view/heading_weight.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace fff::ui {

namespace {

//: %1 is the name of a stock
constexpr Text kEditStock = FFF_TEXT("Step", "Edit %1");

constexpr double kMegapascalsPerGigapascal = 1000.0;
constexpr double kPercent = 100.0;
constexpr double kMostPrice = 100000.0;
constexpr NumberEdit::Range kLasting{1.0, 100.0, 5.0, 0, 1};
constexpr LengthEdit::Range kSheetRange{1.0, 10000.0, 10.0, 0, 1};

} // namespace

StockFields::StockFields(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 12, 0);
    column->setSpacing(0);
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("stockName"));
    m_name->setAccessibleName(tr("Name"));
    QFont bold = m_name->font();
    bold.setWeight(headingWeight());
    m_name->setFont(bold);
    m_uses = new QLabel(this);
    m_uses->setObjectName(QStringLiteral("stockUses"));
    m_uses->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(m_name);
    column->addSpacing(6);
    column->addWidget(m_uses);
    column->addSpacing(12);
    makeSheet();
    makeSheets();
    makeCutting();
    makeStrength();
    makeSlits();
    column->addStretch(1);
    std::vector<PropertyRow *> rows; // fields of all groups begin at one line
    for (QWidget *widget : findChildren<QWidget *>())
        if (auto *row = dynamic_cast<PropertyRow *>(widget))
            rows.push_back(row);
    PropertyRow::alignLabels(rows);

    connect(m_name, &QLineEdit::editingFinished, this, &StockFields::rename);
    connect(&bench.session(), &Session::modelChanged, this,
            [this](const Model &before, const Model &after) {
                if (isVisible() && (before.document.stocks != after.document.stocks ||
                                    before.document.sections != after.document.sections))
                    refresh();
            });
    connect(&settings(), &Settings::unitChanged, this, &StockFields::refresh);
}

PropertyGroup *StockFields::addGroup(const QString &name)
{
    auto *group = new PropertyGroup(name, this);
    layout()->addWidget(group);
    return group;
}

void StockFields::makeSheet()
{
    PropertyGroup *group = addGroup(tr("Sheet"));
    auto *thickness = m_thickness = new ThicknessField(group);
    connect(thickness, &ThicknessField::dragged, this,
            [this](double mm) { previewThickness(m_bench, std::array{m_stock}, mm); });
    connect(thickness, &ThicknessField::settled, this,
            [this](double mm) { commitThickness(m_bench, std::array{m_stock}, mm); });
    connect(thickness, &ThicknessField::cancelled, this,
            [this] { m_bench.session().cancelPreview(); });
    thickness->setFollowed(followedOf("thickness"));
    auto *row = new EditorRow(
        tr("Thickness"), "stockThickness", thickness,
        [this, thickness] { thickness->setThickness(stock()->thickness); }, group);
    group->add(row);
    m_rows.push_back(row);
    makeMeasuring(group);
    addNumber(group, tr("Density"), "stockDensity", 10.0, 20000.0, 10.0, 0, tr("kg/m³"),
              [](Stock &s) -> double & { return s.density; });
    addPrice(group);
}

/// What it is sold as, and whether somebody has measured it.
void StockFields::makeMeasuring(PropertyGroup *group)
{
    auto *sold = new LengthRow(
        tr("Sold as"), "stockNominal", ThicknessField::kRange,
        [this] { return std::optional(stock()->nominalThickness.value_or(stock()->thickness)); },
        [this](double mm) {
            edit([mm](Stock &s) {
                s.nominalThickness = mm == s.thickness ? std::nullopt : std::optional(mm);
            });
        },
        group);
    sold->setToolTip(tr("The thickness by which the sheet is bought; as a rule it is not quite "
                        "that"));
    group->add(sold);
    m_rows.push_back(sold);
    auto *box = new QCheckBox(tr("with calipers, by me"));
    auto *measured = new EditorRow(
        tr("Measured"), "stockMeasured", box, [this, box] { box->setChecked(stock()->isMeasured); },
        group);
    measured->setToolTip(tr("Export asks once how thick the sheets are that you will cut"));
    connect(box, &QCheckBox::clicked, this,
            [this](bool on) { edit([on](Stock &s) { s.isMeasured = on; }); });
    group->add(measured);
    m_rows.push_back(measured);
}

/// Whole ones, and what there is besides.
void StockFields::makeSheets()
{
    PropertyGroup *group = addGroup(tr("Size and number"));
    auto *size = new EditorRow(tr("Sheet W × H"), "stockSheet", makeSheetSize(), {}, group);
    group->add(size);
    auto *count = new NumberEdit({0.0, kMostSheets, 1.0, 0, 0}, QString(), group);
    count->setSpecialValueText(tr("as many as it takes"));
    count->setToolTip(tr("0 means as many as it takes"));
    auto *there = new EditorRow(
        tr("How many there are"), "stockSheetCount", count,
        [this, count] { count->setNumber(stock()->sheetCount.value_or(0)); }, group);
    connect(count, &NumberEdit::numberEdited, this, [this](double number) {
        const int sheets = static_cast<int>(std::lround(number));
        edit([sheets](Stock &s) {
            s.sheetCount = sheets > 0 ? std::optional(sheets) : std::nullopt;
        });
    });
    group->add(there);
    m_rows.push_back(there);
    m_offcuts = new OffcutRows({[this] { return stock(); },
                                [this](const std::function<void(Stock &)> &by) { edit(by); },
                                [this](const char *field) { return followedOf(field); }},
                               group);
    m_offcuts->setObjectName(QStringLiteral("stockOffcuts"));
    auto *offcuts = new EditorRow(
        tr("Used up first"), "stockOffcuts", m_offcuts, [this] { m_offcuts->refresh(); }, group);
    group->add(offcuts);
    m_rows.push_back(offcuts);
    connect(m_offcuts, &OffcutRows::drawingWanted, this, &StockFields::addOffcutDrawing);
}

/// What is to be said of the drawing stands where the offcut is listed.
void StockFields::addOffcutDrawing()
{
    FileDialog dialog(window(), tr("An offcut from a drawing"), documentsFolder(),
                      tr("Drawings (%1)").arg(QStringLiteral("*.svg *.svgz")));
    dialog.setObjectName(QStringLiteral("offcutDialog"));
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() != QDialog::Accepted)
        return;
    QStringList remarks;
    const Result<SpareSheet> spare =
        io::readOffcut(dialog.selectedFiles().constFirst(), 1, &remarks);
    m_offcuts->say(remarks);
    if (spare)
        edit([&](Stock &s) { s.spares.push_back(*spare); });
    else
        Q_EMIT m_bench.editFailed(spare.error());
}

/// Of one sheet, in the money of where the person is.
void StockFields::addPrice(PropertyGroup *group)
{
    auto *field = new NumberEdit({0.0, kMostPrice, 0.5, 2, 2},
                                 locale().currencySymbol(QLocale::CurrencySymbol), group);
    field->setSpecialValueText(tr("not known"));
    field->setToolTip(tr("0 means not known"));
    auto *row = new EditorRow(
        tr("Price of a sheet"), "stockPrice", field,
        [this, field] { field->setNumber(stock()->price.value_or(0.0)); }, group);
    connect(field, &NumberEdit::numberEdited, this, [this](double number) {
        edit([&](Stock &s) { s.price = number > 0.0 ? std::optional(number) : std::nullopt; });
    });
    group->add(row);
    m_rows.push_back(row);
}

/// Two fields and the sizes that are common.
QWidget *StockFields::makeSheetSize()
{
    auto *editor = new QWidget(this);
    auto *row = new QHBoxLayout(editor);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    for (int axis : {0, 1}) {
        auto *length = new LengthEdit(kSheetRange, editor);
        length->setObjectName(axis == 0 ? QStringLiteral("stockSheetWidth")
                                        : QStringLiteral("stockSheetHeight"));
        length->setFollowed(followedOf(axis == 0 ? "sheetWidth" : "sheetHeight"));
        length->setAccessibleName(axis == 0 ? tr("Width of the sheet") : tr("Height of the sheet"));
        length->setFixedWidth(94);
        length->setThickness([this] { return std::optional(stock()->thickness); });
        connect(length, &LengthEdit::lengthEdited, this,
                [this, axis](double mm) { edit([axis, mm](Stock &s) { s.sheet[axis] = mm; }); });
        // A row that is not shown: it only reads.
        auto *reader = new EditorRow(
            QString(), "", nullptr,
            [this, length, axis] { length->setLength(stock()->sheet[axis]); }, this);
        m_rows.push_back(reader);
        if (axis == 1)
            row->addWidget(new QLabel(QStringLiteral("×"), editor));
        row->addWidget(length);
    }
    auto *common = new QToolButton(editor);
    common->setObjectName(QStringLiteral("stockCommonSheets"));
    common->setIcon(themedIcon(QStringLiteral("chevron_down")));
    common->setIconSize({14, 14});
    common->setFixedSize(26, 26);
    common->setToolTip(tr("Common sheets"));
    common->setAccessibleName(tr("Common sheets"));
    common->setPopupMode(QToolButton::InstantPopup);
    common->setFocusPolicy(Qt::StrongFocus);
    common->setProperty("plainMenu", true);
    auto *menu = new QMenu(common);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        menu->setPalette(theme().palette());
        for (const SheetSize &sheet : commonSheets()) {
            QAction *action = menu->addAction(sheetText(sheet, locale()));
            connect(action, &QAction::triggered, this,
                    [this, &sheet] { edit([&sheet](Stock &s) { s.sheet = sheet.size; }); });
        }
    });
    common->setMenu(menu);
    row->addWidget(common);
    row->addStretch(1);
    return editor;
}

void StockFields::makeStrength()
{
    PropertyGroup *group = addGroup(tr("Strength"));
    addRating(group, tr("Tensile strength"), "stockTensile", 5000.0, 1.0, tr("MPa"), 1.0,
              &Stock::tensileStrength);
    addRating(group, tr("Flexural strength"), "stockFlexural", 5000.0, 1.0, tr("MPa"), 1.0,
              &Stock::flexuralStrength);
    addRating(group, tr("Stiffness"), "stockModulus", 1000.0, 0.1, tr("GPa"),
              kMegapascalsPerGigapascal, &Stock::modulus);
    auto *ductile = new QCheckBox(tr("before it breaks"));
    auto *bends = new EditorRow(
        tr("Bends"), "stockDuctile", ductile,
        [this, ductile] { ductile->setChecked(stock()->isDuctile); }, group);
    bends->setToolTip(tr("Like metal: above these strengths it stays bent"));
    connect(ductile, &QCheckBox::clicked, this,
            [this](bool on) { edit([on](Stock &s) { s.isDuctile = on; }); });
    group->add(bends);
    m_rows.push_back(bends);
    auto *lasting = new NumberEdit(kLasting, QStringLiteral("%"), group);
    auto *months = new EditorRow(
        tr("Holds for months"), "stockLasting", lasting,
        [this, lasting] { lasting->setNumber(kPercent * stock()->lastingShare); }, group);
    months->setToolTip(
        tr("Share of its strength under a load that stays: acrylic creeps and crazes"));
    connect(lasting, &NumberEdit::numberEdited, this, [this](double percent) {
        edit([&](Stock &s) { s.lastingShare = percent / kPercent; });
    });
    group->add(months);
    m_rows.push_back(months);
}

void StockFields::makeCutting()
{
    PropertyGroup *group = addGroup(tr("Cutting"));
    addLength(
        group, tr("Kerf width (full)"), "stockKerf", 0.0, 5.0, &Stock::kerf, "kerf",
        [](Stock &s, double mm) { setKerf(s, rememberedChoices().machine.toStdString(), mm); });
    m_kerfs = new TextRow(
        tr("By machine"), "stockKerfs", [this] { return machineKerfsText(*stock(), locale()); },
        group);
    m_kerfs->setToolTip(tr("Kept where a kerf was typed while that machine was chosen in Export"));
    group->add(m_kerfs);
    m_rows.push_back(m_kerfs);
    addLength(group, tr("Slit clearance"), "stockClearance", -1.0, 1.0, &Stock::clearance,
              "clearance", [](Stock &s, double mm) { s.clearance = mm; });
    auto *drawn = new TextRow(
        tr("Drawn slit width"), "stockSlitWidth",
        [this] { return drawnSlitText(*stock(), locale()); }, group);
    drawn->setToolTip(drawnSlitTip());
    group->add(drawn);
    m_rows.push_back(drawn);
}

void StockFields::makeSlits()
{
    const StockAccess access{[this] { return stock(); },
                             [this](const std::function<void(Stock &)> &change) { edit(change); },
                             [this](const char *field) { return followedOf(field); }};
    for (PropertyRow *row : addSlitRows(addGroup(tr("Slits")), access))
        m_rows.push_back(row);
}

void StockFields::addNumber(PropertyGroup *group, const QString &name, const char *objectName,
                            double least, double most, double step, int digits, const QString &unit,
                            std::function<double &(Stock &)> value)
{
    auto *field = new NumberEdit({least, most, step, digits, digits + 1}, unit, group);
    auto *row = new EditorRow(
        name, objectName, field,
        [this, field, value] {
            Stock copy = *stock();
            field->setNumber(value(copy));
        },
        group);
    connect(field, &NumberEdit::numberEdited, this,
            [this, value](double number) { edit([&](Stock &s) { value(s) = number; }); });
    group->add(row);
    m_rows.push_back(row);
}

void StockFields::addRating(PropertyGroup *group, const QString &name, const char *objectName,
                            double most, double step, const QString &unit, double perUnit,
                            std::optional<double> Stock::*value)
{
    auto *field = new NumberEdit({0.0, most, step, 0, 2}, unit, group);
    field->setSpecialValueText(tr("not rated"));
    field->setToolTip(tr("0 means not rated"));
    auto *row = new EditorRow(
        name, objectName, field,
        [this, field, value, perUnit] {
            field->setNumber((stock()->*value).value_or(0.0) / perUnit);
        },
        group);
    connect(field, &NumberEdit::numberEdited, this, [this, value, perUnit](double number) {
        edit([&](Stock &s) {
            s.*value = number > 0.0 ? std::optional(number * perUnit) : std::nullopt;
        });
    });
    group->add(row);
    m_rows.push_back(row);
}

void StockFields::addLength(PropertyGroup *group, const QString &name, const char *objectName,
                            double least, double most, double Stock::*value, const char *field,
                            const std::function<void(Stock &, double)> &write)
{
    auto *row = new LengthRow(
        name, objectName, {least, most, 0.01, 2, 3},
        [this, value] { return std::optional(stock()->*value); },
        [this, write](double mm) { edit([&](Stock &s) { write(s, mm); }); }, group);
    row->setThickness([this] { return std::optional(stock()->thickness); });
    row->setFollowed(followedOf(field));
    group->add(row);
    m_rows.push_back(row);
}

Followed StockFields::followedOf(const char *field)
{
    return followedAt(m_bench, [this, field] {
        return std::optional(
            DrivenPlace{.of = DrivenPlace::Of::Stock, .id = m_stock.value, .field = field});
    });
}

const Stock *StockFields::stock() const
{
    return m_bench.session().model().document.find(m_stock);
}

void StockFields::setStock(StockId stock)
{
    if (m_name->isModified())
        rename(); // of the one that was shown
    m_thickness->settle();
    m_stock = stock;
    refresh();
}

void StockFields::editName()
{
    m_name->setFocus();
    m_name->selectAll();
}

void StockFields::editNumber(const QString &field)
{
    auto *number = findChild<NumberEdit *>(field);
    QWidget *wanted = number;
    if (field == m_offcuts->objectName())
        wanted = m_offcuts;
    if (!wanted)
        return;
    for (QWidget *above = parentWidget(); above; above = above->parentWidget()) {
        if (auto *area = qobject_cast<QScrollArea *>(above)) {
            layout()->activate();
            area->ensureWidgetVisible(wanted);
            break;
        }
    }
    if (!number)
        return m_offcuts->focusAdd();
    number->setFocus(Qt::OtherFocusReason);
    number->selectAll();
}

void StockFields::refresh()
{
    const Stock *shown = stock();
    setEnabled(shown != nullptr);
    if (!shown)
        return;
    const QString name = stockName(*shown);
    if (!(m_name->hasFocus() && m_name->isModified()) && m_name->text() != name)
        m_name->setText(name);
    const auto &sections = m_bench.session().model().document.sections;
    const auto uses = std::count_if(sections.begin(), sections.end(),
                                    [this](const auto &s) { return s->stock == m_stock; });
    m_uses->setText(uses == 0 ? tr("No sections are made of it")
                              : tr("%n section(s)", nullptr, static_cast<int>(uses)));
    m_kerfs->setVisible(!shown->kerfs.empty());
    for (PropertyRow *row : m_rows)
        row->refresh();
}

void StockFields::edit(const std::function<void(Stock &)> &change)
{
    const Document &document = m_bench.session().committed().document;
    const Stock *before = document.find(m_stock);
    if (!before)
        return;
    Stock next = *before;
    change(next);
    m_bench.commit(Step{kEditStock, {Named{stockName(*before).toStdString()}}},
                   fff::setStock(document, std::move(next)));
    refresh(); // a refused value goes back to what it was
}

void StockFields::rename()
{
    const bool isTyped = m_name->isModified();
    m_name->setModified(false);
    const QString name = m_name->text().trimmed();
    const Stock *shown = stock();
    if (isTyped && shown && !name.isEmpty() && name != stockName(*shown))
        edit([&](Stock &s) { s.name = name.toStdString(); });
    else
        refresh();
}

} // namespace fff::ui
