#include "ui/dialogs/export_questions.h"

#include "core/io/machine_library.h"
#include "core/model/materials.h"
#include "ui/base/lengths.h"
#include "ui/base/rich_text.h"
#include "ui/dialogs/export_place_row.h"
#include "ui/dialogs/question_row.h"
#include "ui/dialogs/stock_words.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/length_edit.h"
#include "ui/properties/link_row.h"
#include "ui/properties/stock_choice.h"
#include "ui/properties/thickness_field.h"
#include "ui/view/view_style.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace fff::ui {

namespace {

constexpr NumberEdit::Range kSheetSide{1.0, 10000.0, 10.0, 0, 1}; // mm

ChoiceBox *choiceBox(const char *objectName, const QString &name, QWidget *parent)
{
    auto *box = new ChoiceBox(parent);
    box->setObjectName(QLatin1String(objectName));
    box->setAccessibleName(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(20);
    return box;
}

/// In commonSheets(); −1: it is none of them.
int commonSheetOf(const Vec2 &size)
{
    const auto all = commonSheets();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const SheetSize &sheet) { return sheet.size == size; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

} // namespace

ExportQuestions::ExportQuestions(StockEdits &stocks, ExportChoices &choices,
                                 std::vector<ExportFile> files, const QStringList &chosen,
                                 QWidget *parent)
    : QWidget(parent), m_stocks(stocks), m_choices(choices),
      m_file(new FileQuestion(std::move(files), chosen, this)), m_place(new ExportPlaceRow(m_file))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    m_questions.push_back(makeStock());
    m_questions.push_back(m_sheetQuestion = makeSheet());
    m_questions.push_back(m_machineQuestion = makeMachine());
    m_file->add(m_place);
    m_questions.push_back(m_file);
    for (QuestionRow *question : m_questions)
        column->addWidget(question);
    connect(m_file, &FileQuestion::fileChanged, this, [this] {
        refresh();
        Q_EMIT fileChanged();
    });
    connect(&stocks, &StockEdits::changed, this, &ExportQuestions::refresh);
    refresh();
}

QuestionRow *ExportQuestions::makeStock()
{
    auto *question = new QuestionRow(tr("Which stock?"), this);
    m_stockBox = choiceBox("exportStock", tr("Which stock?"), question);
    m_onlyStock = new QLabel(question);
    m_onlyStock->setObjectName(QStringLiteral("exportOnlyStock"));
    m_onlyStock->setTextFormat(Qt::RichText); // a chip and a name
    m_onlyStock->setMinimumHeight(24);
    m_measure = new LinkRow(question); // before the field
    m_measure->setObjectName(QStringLiteral("exportMeasure"));
    m_measured = new QWidget(question);
    auto *row = new QHBoxLayout(m_measured);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    auto *words = new QLabel(tr("Measured thickness"), m_measured);
    m_thickness = new LengthEdit(ThicknessField::kRange, m_measured);
    m_thickness->setObjectName(QStringLiteral("exportThickness"));
    m_thickness->setAccessibleName(tr("Measured thickness"));
    m_thickness->setAccessibleDescription(
        tr("Measure the sheet that you will cut with calipers: slits are drawn to fit it."));
    m_thickness->setToolTip(m_thickness->accessibleDescription());
    words->setBuddy(m_thickness);
    row->addWidget(words);
    row->addWidget(m_thickness, 1);
    question->add(m_stockBox);
    question->add(m_onlyStock);
    question->add(m_measure);
    question->add(m_measured);
    connect(m_stockBox, &QComboBox::activated, this, [this](int choice) {
        m_stocks.choose(m_stocks.stocks()[static_cast<std::size_t>(choice)]);
    });
    connect(m_measure, &LinkRow::clicked, this, &ExportQuestions::measure);
    connect(m_thickness, &LengthEdit::lengthEdited, this, [this](double mm) {
        m_stocks.edit([mm](Stock &stock) {
            setThickness(stock, mm, true);
            stock.isMeasured = true;
        });
    });
    return question;
}

/// It is asked for once: until then its field is open, and the link says that it is right.
void ExportQuestions::measure()
{
    m_measuresAgain = m_stocks.stock().isMeasured;
    m_stocks.edit([](Stock &stock) { stock.isMeasured = true; });
    if (!m_measuresAgain)
        return;
    refreshStock();
    m_thickness->setFocus();
    m_thickness->selectAll();
}

/// The first of the library is what files are made for that nobody chose one for.
QuestionRow *ExportQuestions::makeMachine()
{
    auto *question = new QuestionRow(tr("Which machine?"), this);
    m_machineBox = choiceBox("exportMachine", tr("Which machine?"), question);
    m_machineBox->setToolTip(tr("Colours, layers, speeds and G-code as this machine and its "
                                "program take them, and what it removes of each stock"));
    question->add(m_machineBox);
    connect(m_machineBox, &QComboBox::activated, this, &ExportQuestions::chooseMachine);
    return question;
}

void ExportQuestions::chooseMachine(int choice)
{
    const Machine &machine = *io::machineLibrary()[static_cast<std::size_t>(choice)];
    m_choices.machine = QString::fromStdString(machine.key);
    if (!machine.finish.isPlain())
        m_choices.finish.reset(); // it has its own
    m_stocks.takeKerfsOf(machine.key);
    refresh();
    Q_EMIT machineChanged();
}

QuestionRow *ExportQuestions::makeSheet()
{
    auto *question = new QuestionRow(tr("Which sheet?"), this);
    m_sheetBox = choiceBox("exportSheet", tr("Which sheet?"), question);
    m_ownSheet = new QWidget(question);
    auto *row = new QHBoxLayout(m_ownSheet);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    for (const int axis : {0, 1}) {
        m_sides[axis] = makeSide(axis);
        if (axis == 1)
            row->addWidget(new QLabel(QStringLiteral("×"), m_ownSheet));
        row->addWidget(m_sides[axis], 1);
    }
    m_offcuts = new QLabel(question);
    m_offcuts->setObjectName(QStringLiteral("exportOffcuts"));
    m_offcuts->setWordWrap(true);
    m_offcuts->setForegroundRole(QPalette::PlaceholderText);
    question->add(m_sheetBox);
    question->add(m_ownSheet);
    question->add(m_offcuts);
    connect(m_sheetBox, &QComboBox::activated, this, &ExportQuestions::chooseSheet);
    return question;
}

LengthEdit *ExportQuestions::makeSide(int axis)
{
    auto *side = new LengthEdit(kSheetSide, m_ownSheet);
    side->setObjectName(axis == 0 ? QStringLiteral("exportSheetWidth")
                                  : QStringLiteral("exportSheetHeight"));
    side->setAccessibleName(axis == 0 ? tr("Width of the sheet") : tr("Height of the sheet"));
    connect(side, &LengthEdit::lengthEdited, this, [this, axis](double mm) {
        m_ownSizeOf = m_stocks.chosen();
        m_stocks.edit([axis, mm](Stock &stock) { stock.sheet[axis] = mm; });
    });
    return side;
}

void ExportQuestions::chooseSheet(int choice)
{
    const auto all = commonSheets();
    if (static_cast<std::size_t>(choice) < all.size()) {
        m_ownSizeOf = {};
        m_stocks.edit(
            [&](Stock &stock) { stock.sheet = all[static_cast<std::size_t>(choice)].size; });
        return;
    }
    m_ownSizeOf = m_stocks.chosen();
    refresh();
    m_sides[0]->setFocus();
    m_sides[0]->selectAll();
}

int ExportQuestions::leastWidth() const
{
    int width = minimumSizeHint().width();
    for (const QWidget *folded : {m_measured, m_ownSheet})
        width = std::max(width, QuestionRow::kIndent + folded->minimumSizeHint().width());
    return width;
}

void ExportQuestions::refresh()
{
    refreshStock();
    refreshSheet();
    refreshMachine();
    m_sheetQuestion->setVisible(!file().isSolids);
    m_machineQuestion->setVisible(!file().isSolids);
    QuestionRow::number(m_questions);
}

void ExportQuestions::refreshStock()
{
    const auto text = [this](const Stock &stock) {
        const QString thickness = lengthText(stock.thickness, 2, 3, locale());
        return stock.isMeasured
                   //: %1 is the name of a stock, %2 its thickness
                   ? tr("%1, measured %2").arg(stockName(stock), thickness)
                   //: %1 is the name of a stock, %2 its thickness
                   : tr("%1, %2 thick").arg(stockName(stock), thickness);
    };
    Choices stocks;
    for (const StockId id : m_stocks.stocks()) {
        const Stock &stock = *m_stocks.document().find(id);
        if (id == m_stocks.chosen())
            stocks.current = static_cast<int>(stocks.all.size());
        stocks.all.push_back({text(stock), stockLook(stock).face});
    }
    m_stockBox->setChoices(stocks);
    m_stockBox->setVisible(stocks.all.size() > 1);
    m_onlyStock->setVisible(stocks.all.size() <= 1);
    const Stock &stock = m_stocks.stock();
    m_onlyStock->setText(keepingUnits(
        QStringLiteral("<span style='color:%1'>&#9632;</span>&nbsp; %2")
            .arg(stockLook(stock).face.darker(115).name(), text(stock).toHtmlEscaped())));
    m_thickness->setLength(stock.thickness);
    m_measure->setTexts({stock.isMeasured ? tr("Measure again") : tr("That is what I measured")});
    m_measured->setVisible(!stock.isMeasured || m_measuresAgain);
}

void ExportQuestions::refreshSheet()
{
    const Stock &stock = m_stocks.stock();
    Choices sheets;
    for (const SheetSize &sheet : commonSheets())
        sheets.all.push_back({sheetText(sheet, locale()), {}});
    sheets.all.push_back({tr("Own size"), {}});
    const int common = commonSheetOf(stock.sheet);
    const bool isOwn = common < 0 || m_ownSizeOf == m_stocks.chosen();
    sheets.current = isOwn ? static_cast<int>(sheets.all.size()) - 1 : common;
    m_sheetBox->setChoices(sheets);
    m_ownSheet->setVisible(isOwn);
    for (const int axis : {0, 1})
        m_sides[axis]->setLength(stock.sheet[axis]);
    refreshOffcuts();
}

void ExportQuestions::setLayout(std::shared_ptr<const Layout> layout)
{
    if (layout == m_layout)
        return;
    m_layout = std::move(layout);
    refreshOffcuts();
}

/// Of those that there are, what parts do lie on.
void ExportQuestions::refreshOffcuts()
{
    const Stock &stock = m_stocks.stock();
    const int offcuts =
        std::accumulate(stock.spares.begin(), stock.spares.end(), 0,
                        [](int sum, const SpareSheet &spare) { return sum + spare.count; });
    m_offcuts->setVisible(offcuts > 0 && m_layout);
    if (m_offcuts->isHidden())
        return;
    const auto used = static_cast<int>(
        std::count_if(m_layout->sheets.begin(), m_layout->sheets.end(), [&](const Sheet &sheet) {
            return sheet.stock == stock.id && sheet.index < 0;
        }));
    if (used == 0)
        m_offcuts->setText(tr("No part lies on an offcut."));
    else if (used < offcuts)
        //: %1 is a number
        m_offcuts->setText(tr("%1 of %n offcut(s) used up first.", nullptr, offcuts).arg(used));
    else
        m_offcuts->setText(tr("%n offcut(s) are used up first.", nullptr, offcuts));
}

void ExportQuestions::refreshMachine()
{
    Choices machines;
    for (const auto &machine : io::machineLibrary()) {
        if (QString::fromStdString(machine->key) == m_choices.machine)
            machines.current = static_cast<int>(machines.all.size());
        machines.all.push_back(
            {machines.all.empty() ? tr("Any laser") : QString::fromStdString(machine->name), {}});
    }
    machines.current = std::max(machines.current, 0);
    m_machineBox->setChoices(machines);
}

} // namespace fff::ui
