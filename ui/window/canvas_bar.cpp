#include "ui/window/canvas_bar.h"

#include "core/base/units.h"
#include "core/session/message_text.h"
#include "ui/actions/action_set.h"
#include "ui/base/theme.h"
#include "ui/bench/viewport.h"
#include "ui/bench/workbench.h"
#include "ui/properties/length_edit.h"

#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kBelow = 14;     // px to the view's lower edge
constexpr int kScaleBar = 160; // px that the scale bar takes at its left end
constexpr int kOverScale = 48; // px to the lower edge where the bar would lie on that
constexpr NumberEdit::Range kPlace{-10000.0, 10000.0, 0.1, 1, 3};
constexpr NumberEdit::Range kLength{0.0, 10000.0, 0.1, 1, 3};
constexpr NumberEdit::Range kWanted{0.001, 1000000.0, 0.5, 1, 2};
constexpr NumberEdit::Range kAngle{-360.0, 360.0, 0.5, 1, 3};

constexpr NumberEdit::Range kPercent{1.0, 10000.0, 5.0, 0, 2};
constexpr NumberEdit::Range kCopies{0.0, 500.0, 1.0, 0, 0};
constexpr int kFieldWidth = 104, kNarrowField = 88;             // px
const QString kNumber = QStringLiteral("\u22121888.8");         // fields have room for it
constexpr int kBetweenCommands = 6, kBetweenCommandGroups = 20; // px
constexpr int kFewFields = 3;     // in a row of a view that is not wide
constexpr int kTypingPause = 400; // ms, after which what is typed is taken for the whole number

/// Numbers of points come and go with what is typed; others stay with their tool.
bool isOfPoint(ToolNumber::Kind kind)
{
    using Kind = ToolNumber::Kind;
    return kind == Kind::X || kind == Kind::Y || kind == Kind::DeltaX || kind == Kind::DeltaY ||
           kind == Kind::Length || kind == Kind::Angle;
}

/// As people say it, and back.
double shownNumber(const ToolNumber &number)
{
    switch (number.kind) {
    case ToolNumber::Kind::Angle:
    case ToolNumber::Kind::Turn:
        return degrees(number.value);
    case ToolNumber::Kind::Size:
        return 100.0 * number.value;
    default:
        return number.value;
    }
}

double numberShown(ToolNumber::Kind kind, double shown)
{
    switch (kind) {
    case ToolNumber::Kind::Angle:
    case ToolNumber::Kind::Turn:
        return radians(shown);
    case ToolNumber::Kind::Size:
        return shown / 100.0;
    default:
        return shown;
    }
}

} // namespace

CanvasBar::CanvasBar(Workbench &bench, const ActionSet &actions, QWidget *view)
    : QFrame(view), m_bench(bench), m_actions(actions)
{
    setObjectName(QStringLiteral("canvasBar"));
    setProperty(kPassingCover, true);
    setAccessibleName(tr("Numbers of the drawing tool"));
    setCursor(Qt::ArrowCursor);
    m_grid = new QGridLayout(this);
    m_grid->setContentsMargins(12, 8, 12, 8);
    m_grid->setSpacing(6);
    using Kind = ToolNumber::Kind;
    addField(Kind::Distance, new LengthEdit(kPlace, this), tr("Distance"), "canvasDistance");
    addField(Kind::X, new LengthEdit(kPlace, this), tr("X"), "canvasX");
    addField(Kind::Y, new LengthEdit(kPlace, this), tr("Y"), "canvasY");
    addField(Kind::Length, new LengthEdit(kLength, this), tr("Length"), "canvasLength");
    addField(Kind::Angle, new NumberEdit(kAngle, tr("°"), this), tr("Angle"), "canvasAngle");
    addField(Kind::MoveX, new LengthEdit(kPlace, this), tr("X"), "canvasMoveX");
    addField(Kind::MoveY, new LengthEdit(kPlace, this), tr("Y"), "canvasMoveY");
    addField(Kind::MoveZ, new LengthEdit(kPlace, this), tr("Z"), "canvasMoveZ");
    addField(Kind::MoveRight, new LengthEdit(kPlace, this), tr("Right"), "canvasMoveRight");
    addField(Kind::MoveUp, new LengthEdit(kPlace, this), tr("Up"), "canvasMoveUp");
    //: away from its plane
    addField(Kind::MoveOut, new LengthEdit(kPlace, this), tr("Out"), "canvasMoveOut");
    addField(Kind::Turn, new NumberEdit(kAngle, tr("°"), this), tr("Turn"), "canvasTurn");
    addField(Kind::Size, new NumberEdit(kPercent, tr("%"), this), tr("Size"), "canvasSize");
    addField(Kind::Copies, new NumberEdit(kCopies, QString(), this), tr("Copies"), "canvasCopies");
    addField(Kind::Wanted, new LengthEdit(kWanted, this), tr("Length"), "canvasWanted");
    m_buttons = new QWidget(this);
    m_buttonGrid = new QGridLayout(m_buttons);
    m_buttonGrid->setContentsMargins(0, 0, 0, 0);
    m_buttonGrid->setSpacing(kBetweenCommands);
    hide();
    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingPause);
    connect(&m_typing, &QTimer::timeout, this, &CanvasBar::takeTyped);
    view->installEventFilter(this);
    connect(&bench, &Workbench::viewChanged, this, &CanvasBar::refresh);
    connect(qApp, &QApplication::focusChanged, this,
            [this](QWidget *, QWidget *now) { follow(now); });
}

void CanvasBar::addField(ToolNumber::Kind kind, NumberEdit *edit, const QString &name,
                         const char *objectName)
{
    auto *label = new QLabel(name, this);
    label->setBuddy(edit);
    label->setForegroundRole(QPalette::PlaceholderText);
    edit->setObjectName(QLatin1String(objectName));
    edit->setAccessibleName(name);
    edit->setFixedWidth(
        std::max(isOfPoint(kind) ? kFieldWidth : kNarrowField, edit->widthFor(kNumber)));
    m_fields.push_back({kind, label, edit});
    auto *line = edit->findChild<QLineEdit *>();
    connect(line, &QLineEdit::textEdited, this, [this, kind, edit] {
        // A model of a tenth of its size leaps at who types "50" and is at its 5.
        if (kind == ToolNumber::Kind::Wanted)
            m_typing.start();
        else if (const std::optional<double> typed = edit->typed())
            take(kind, *typed);
    });
    connect(edit, &NumberEdit::numberEdited, this, [this, kind](double value) {
        m_typing.stop();
        take(kind, value);
    });
}

CanvasBar::Field *CanvasBar::field(ToolNumber::Kind kind)
{
    const auto found = std::find_if(m_fields.begin(), m_fields.end(),
                                    [kind](const Field &f) { return f.kind == kind; });
    return found != m_fields.end() && found->isWanted ? &*found : nullptr;
}

void CanvasBar::begin(const QString &text)
{
    using Kind = ToolNumber::Kind;
    const bool isFromLast = text == QStringLiteral("@");
    m_isOpen = field(Kind::Distance) == nullptr && field(Kind::Wanted) == nullptr;
    refresh();
    Field *first = field(isFromLast ? Kind::Length : Kind::X);
    for (const Kind kind : {Kind::X, Kind::MoveX, Kind::MoveRight, Kind::Distance, Kind::Wanted}) {
        if (!first || !first->edit->isVisibleTo(this))
            first = field(kind);
    }
    if (!first)
        return;
    first->edit->setFocus(Qt::OtherFocusReason);
    first->edit->selectAll();
    if (isFromLast)
        return;
    QKeyEvent typed(QEvent::KeyPress, 0, Qt::NoModifier, text);
    QCoreApplication::sendEvent(first->edit, &typed);
}

void CanvasBar::take(ToolNumber::Kind kind, double shown)
{
    if (field(kind) && isVisible())
        m_bench.setNumbers({{kind, numberShown(kind, shown)}});
}

/// The length that the whole is to have, once it stands there to its last digit.
void CanvasBar::takeTyped()
{
    m_typing.stop();
    const Field *wanted = field(ToolNumber::Kind::Wanted);
    if (const auto typed = wanted ? wanted->edit->typed() : std::nullopt)
        take(ToolNumber::Kind::Wanted, *typed);
}

/// The fields of what the tool takes now, with the numbers that it has.
void CanvasBar::refresh()
{
    const std::vector<ToolNumber> numbers = m_bench.interaction().numbers();
    bool isSeen = false;
    for (Field &field : m_fields)
        field.isWanted = false;
    for (const ToolNumber &number : numbers) {
        for (Field &field : m_fields) {
            if (field.kind != number.kind)
                continue;
            field.isWanted = true;
            field.edit->setNumber(shownNumber(number));
        }
    }
    m_isOpen = m_isOpen && !numbers.empty();
    for (Field &field : m_fields) {
        const bool isFieldSeen = field.isWanted && (m_isOpen || !isOfPoint(field.kind));
        if (!isFieldSeen && field.edit->hasFocus())
            parentWidget()->setFocus();
        field.label->setVisible(isFieldSeen);
        field.edit->setVisible(isFieldSeen);
        isSeen = isSeen || isFieldSeen;
    }
    showCommands();
    isSeen = isSeen || !m_commands.empty();
    if (isSeen)
        place();
    setVisible(isSeen);
}

/// A button for each; they are made anew only where they are others.
void CanvasBar::showCommands()
{
    const Tool *tool = m_bench.interaction().tool();
    std::vector<CommandGroup> groups = tool ? tool->commandGroups() : std::vector<CommandGroup>();
    std::erase_if(groups, [](const CommandGroup &group) { return group.commands.empty(); });
    if (groups == m_commands)
        return;
    m_commands = std::move(groups);
    for (QWidget *old : std::exchange(m_commandCells, {})) {
        old->hide();
        m_buttonGrid->removeWidget(old);
        old->deleteLater();
    }
    const std::string_view main = tool ? tool->mainCommand() : std::string_view();
    m_buttonGrid->setHorizontalSpacing(m_commands.size() > 1 ? kBetweenCommandGroups
                                                             : kBetweenCommands);
    if (m_commands.size() > 1)
        for (const CommandGroup &group : m_commands)
            m_commandCells.push_back(cellOf(group, main));
    else if (!m_commands.empty())
        for (const std::string_view command : m_commands.front().commands)
            m_commandCells.push_back(buttonOf(command, command == main, m_buttons));
    m_buttons->setVisible(!m_commands.empty());
}

/// Side by side, what is said before them at their left.
QWidget *CanvasBar::cellOf(const CommandGroup &group, std::string_view main)
{
    auto *cell = new QWidget(m_buttons);
    auto *row = new QHBoxLayout(cell);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBetweenCommands);
    if (group.title.source) {
        auto *title = new QLabel(messageText(group.title), cell);
        title->setForegroundRole(QPalette::PlaceholderText);
        row->addWidget(title);
    }
    for (const std::string_view command : group.commands) {
        QToolButton *button = buttonOf(command, command == main, cell);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly); // its group says what it is
        row->addWidget(button);
    }
    dress(cell); // what is said before buttons was black in the dark
    return cell;
}

QToolButton *CanvasBar::buttonOf(std::string_view command, bool isMain, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setDefaultAction(m_actions.action(std::string(command).c_str()));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setIconSize({16, 16});
    button->setFocusPolicy(Qt::TabFocus);
    button->setObjectName(QStringLiteral("canvas.") + button->defaultAction()->objectName());
    button->setProperty("isMain", isMain);
    return button;
}

void CanvasBar::accept()
{
    for (Field &field : m_fields) {
        if (field.edit->isVisible() && !field.edit->refusal().isEmpty())
            return; // it says why, and stays
    }
    if (m_typing.isActive())
        takeTyped();
    const bool isTyped = m_isOpen;
    m_isOpen = false;
    parentWidget()->setFocus();
    if (isTyped)
        m_bench.key(ToolKey::Enter);
    refresh();
}

void CanvasBar::close()
{
    m_typing.stop();
    const bool isTyped = m_isOpen;
    m_isOpen = false;
    parentWidget()->setFocus();
    if (isTyped)
        m_bench.dropNumbers();
    refresh();
}

/// Whoever goes elsewhere, sets no point and moves nothing.
void CanvasBar::follow(QWidget *focus)
{
    const auto isEdit = [focus](const Field &field) { return field.edit == focus; };
    const auto entered = std::find_if(m_fields.begin(), m_fields.end(), isEdit);
    if (entered != m_fields.end() && entered->kind != ToolNumber::Kind::Distance)
        m_isOpen = true;
    if (m_isOpen && focus && !isAncestorOf(focus) && focus->window() == window()) {
        m_typing.stop();
        m_isOpen = false;
        m_bench.dropNumbers();
        refresh();
    }
}

void CanvasBar::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        accept();
    else if (event->key() == Qt::Key_Escape)
        close();
    else
        event->accept(); // letters are no shortcuts of the view here
}

/// Round in the bar: Enter and Esc leave it.
bool CanvasBar::focusNextPrevChild(bool next)
{
    std::vector<NumberEdit *> seen;
    for (const Field &field : m_fields) {
        if (field.edit->isVisible())
            seen.push_back(field.edit);
    }
    const auto here = std::find_if(seen.begin(), seen.end(),
                                   [](const NumberEdit *edit) { return edit->hasFocus(); });
    if (here == seen.end())
        return QFrame::focusNextPrevChild(next);
    const std::size_t count = seen.size();
    const auto index = static_cast<std::size_t>(here - seen.begin());
    NumberEdit *to = seen[(index + (next ? 1 : count - 1)) % count];
    to->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    to->selectAll();
    return true;
}

bool CanvasBar::eventFilter(QObject *object, QEvent *event)
{
    if (object == parent() && event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(object, event);
}

/// The commands stand below the fields, beside a single one where there is room.
void CanvasBar::arrange(int fieldsInRow, int cellsInRow)
{
    for (std::size_t i = 0; i < m_commandCells.size(); ++i) {
        const int at = static_cast<int>(i);
        m_buttonGrid->addWidget(m_commandCells[i], at / cellsInRow, at % cellsInRow, Qt::AlignLeft);
    }
    int shown = 0;
    for (Field &field : m_fields) {
        const int row = shown / fieldsInRow, column = 2 * (shown % fieldsInRow);
        m_grid->addWidget(field.label, row, column);
        m_grid->addWidget(field.edit, row, column + 1);
        shown += field.edit->isVisibleTo(this) ? 1 : 0;
    }
    if (shown == 1 && fieldsInRow > kFewFields)
        m_grid->addWidget(m_buttons, 0, 2);
    else
        m_grid->addWidget(m_buttons, (shown + fieldsInRow - 1) / fieldsInRow, 0, 1,
                          std::max(1, 2 * std::min(shown, fieldsInRow)), Qt::AlignLeft);
    m_grid->activate();
}

void CanvasBar::place()
{
    const int all = std::max(1, static_cast<int>(m_commandCells.size()));
    const auto fits = [this] { return sizeHint().width() <= parentWidget()->width() - 2 * kBelow; };
    for (const int fieldsInRow : {static_cast<int>(m_fields.size()), kFewFields, 2}) {
        arrange(fieldsInRow, all);
        if (fits())
            break;
    }
    // Then it is the buttons that are too wide.
    for (int cellsInRow = (all + 1) / 2; !fits() && cellsInRow > 0; cellsInRow /= 2)
        arrange(2, cellsInRow);
    const QSize size = sizeHint();
    resize(size);
    const int left = (parentWidget()->width() - size.width()) / 2;
    move(left, parentWidget()->height() - size.height() - (left < kScaleBar ? kOverScale : kBelow));
}

void CanvasBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().strong, 1.0));
    painter.setBrush(theme().panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

} // namespace fff::ui
