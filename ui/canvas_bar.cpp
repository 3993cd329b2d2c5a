#include "ui/canvas_bar.h"

#include "core/base/units.h"
#include "ui/properties/length_edit.h"
#include "ui/theme.h"
#include "ui/workbench.h"

#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kBelow = 14; // px to the view's lower edge
constexpr NumberEdit::Range kPlace{-10000.0, 10000.0, 0.1, 1, 3};
constexpr NumberEdit::Range kLength{0.0, 10000.0, 0.1, 1, 3};
constexpr NumberEdit::Range kAngle{-360.0, 360.0, 0.5, 1, 3};

bool isAngle(ToolNumber::Kind kind)
{
    return kind == ToolNumber::Kind::Angle;
}

} // namespace

CanvasBar::CanvasBar(Workbench &bench, QWidget *view) : QFrame(view), m_bench(bench)
{
    setObjectName(QStringLiteral("canvasBar"));
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
    hide();
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
    edit->setFixedWidth(104);
    m_fields.push_back({kind, label, edit});
    auto *line = edit->findChild<QLineEdit *>();
    connect(line, &QLineEdit::textEdited, this, [this, kind, edit] {
        if (const std::optional<double> typed = edit->typed())
            take(kind, *typed);
    });
    connect(edit, &NumberEdit::numberEdited, this,
            [this, kind](double value) { take(kind, value); });
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
    m_isOpen = field(Kind::Distance) == nullptr;
    refresh();
    Field *first = field(isFromLast ? Kind::Length : Kind::X);
    for (const Kind kind : {Kind::X, Kind::Distance}) {
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
        m_bench.setNumbers({{kind, isAngle(kind) ? radians(shown) : shown}});
}

/// The fields of what the tool takes now, with the numbers that it has.
void CanvasBar::refresh()
{
    const std::vector<ToolNumber> numbers = m_bench.interaction().numbers();
    bool hasDistance = false;
    for (Field &field : m_fields)
        field.isWanted = false;
    for (const ToolNumber &number : numbers) {
        for (Field &field : m_fields) {
            if (field.kind != number.kind)
                continue;
            field.isWanted = true;
            field.edit->setNumber(isAngle(number.kind) ? degrees(number.value) : number.value);
        }
        hasDistance = hasDistance || number.kind == ToolNumber::Kind::Distance;
    }
    m_isOpen = m_isOpen && !numbers.empty();
    for (Field &field : m_fields) {
        const bool isDistance = field.kind == ToolNumber::Kind::Distance;
        const bool isSeen = field.isWanted && (isDistance || m_isOpen);
        if (!isSeen && field.edit->hasFocus())
            parentWidget()->setFocus();
        field.label->setVisible(isSeen);
        field.edit->setVisible(isSeen);
    }
    const bool isSeen = hasDistance || m_isOpen;
    if (isSeen)
        place();
    setVisible(isSeen);
}

void CanvasBar::accept()
{
    for (Field &field : m_fields) {
        if (field.edit->isVisible() && !field.edit->refusal().isEmpty())
            return; // it says why, and stays
    }
    const bool isPoint = m_isOpen;
    m_isOpen = false;
    parentWidget()->setFocus();
    if (isPoint)
        m_bench.key(ToolKey::Enter);
    refresh();
}

void CanvasBar::close()
{
    const bool isPoint = m_isOpen;
    m_isOpen = false;
    parentWidget()->setFocus();
    if (isPoint)
        m_bench.dropNumbers();
    refresh();
}

/// Whoever goes elsewhere, sets no point.
void CanvasBar::follow(QWidget *focus)
{
    if (m_isOpen && focus && !isAncestorOf(focus) && focus->window() == window()) {
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

/// Two fields a row where all of them would be wider than the view.
void CanvasBar::arrange(int fieldsInRow)
{
    int shown = 0;
    for (Field &field : m_fields) {
        const int row = shown / fieldsInRow, column = 2 * (shown % fieldsInRow);
        m_grid->addWidget(field.label, row, column);
        m_grid->addWidget(field.edit, row, column + 1);
        shown += field.edit->isVisibleTo(this) ? 1 : 0;
    }
    m_grid->activate();
}

void CanvasBar::place()
{
    arrange(static_cast<int>(m_fields.size()));
    if (sizeHint().width() > parentWidget()->width() - 2 * kBelow)
        arrange(2);
    const QSize size = sizeHint();
    resize(size);
    move((parentWidget()->width() - size.width()) / 2,
         parentWidget()->height() - size.height() - kBelow);
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
