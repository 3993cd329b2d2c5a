#include "ui/steps/steps_bar.h"

#include "ui/base/icon.h"
#include "ui/base/sentence_label.h"
#include "ui/base/theme.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr int kBelow = 14;    // px to the view's edges
constexpr int kNarrow = 640;  // px
constexpr int kWidest = 860;  // px
constexpr int kOfStep = 100;  // of the slider's values
constexpr int kOfApart = 100; // of the other one's
constexpr int kTickApart = 5; // px at least

} // namespace

StepsBar::StepsBar(QWidget *view) : QFrame(view)
{
    setObjectName(QStringLiteral("stepsBar"));
    setAccessibleName(tr("Steps of the assembly"));
    setCursor(Qt::ArrowCursor);
    setAttribute(Qt::WA_NoMousePropagation); // beside its buttons is not in the view
    m_sentence = new SentenceLabel(this);
    m_sentence->setObjectName(QStringLiteral("stepsSentence"));
    m_export = new QToolButton(this);
    m_export->setObjectName(QStringLiteral("stepsExport"));
    m_export->setText(tr("Export steps…"));
    m_export->setIcon(themedIcon(QStringLiteral("export")));
    m_export->setIconSize({16, 16});
    m_export->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_export->setAccessibleName(tr("Export steps…"));
    m_export->setToolTip(
        tr("Write all steps to a PDF to print, a web page for phones, or a picture of each"));
    m_export->setFocusPolicy(Qt::TabFocus);
    m_close = addButton("stepsClose", "close", tr("Close the steps (Esc)"));
    m_previous = addButton("stepsPrevious", "step_previous", tr("Previous step (Left)"));
    m_play = addButton("stepsPlay", "play", tr("Play (Space)"));
    m_next = addButton("stepsNext", "step_next", tr("Next step (Right)"));
    m_time = new QSlider(Qt::Horizontal, this);
    m_time->setObjectName(QStringLiteral("stepsTime"));
    m_time->setAccessibleName(tr("Step"));
    m_time->setSingleStep(kOfStep);
    m_time->setPageStep(kOfStep);
    m_time->setMinimumWidth(90);
    const QString apart = tr("Pull the parts apart");
    m_apartLabel = new QLabel(tr("Exploded"), this);
    m_apartLabel->setForegroundRole(QPalette::PlaceholderText);
    m_apartLabel->setToolTip(apart);
    m_apart = new QSlider(Qt::Horizontal, this);
    m_apart->setObjectName(QStringLiteral("stepsApart"));
    m_apart->setAccessibleName(apart);
    m_apart->setToolTip(apart);
    m_apart->setRange(0, kOfApart);
    m_apart->setPageStep(kOfApart / 4);
    m_apart->setSingleStep(kOfApart / 20);
    m_apart->setMinimumWidth(60);
    m_apartLabel->setBuddy(m_apart);

    auto *top = new QHBoxLayout;
    top->setSpacing(8);
    top->addWidget(m_sentence, 1);
    top->addWidget(m_export);
    top->addWidget(m_close);
    auto *below = new QHBoxLayout;
    below->setSpacing(2);
    below->addWidget(m_previous);
    below->addWidget(m_play);
    below->addWidget(m_next);
    below->addSpacing(8);
    below->addWidget(m_time, 4);
    below->addSpacing(12);
    below->addWidget(m_apartLabel);
    below->addSpacing(4);
    below->addWidget(m_apart, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(14, 8, 10, 8);
    column->setSpacing(6);
    column->addLayout(top);
    column->addLayout(below);

    connect(m_previous, &QToolButton::clicked, this, &StepsBar::previousWanted);
    connect(m_play, &QToolButton::clicked, this, &StepsBar::playWanted);
    connect(m_next, &QToolButton::clicked, this, &StepsBar::nextWanted);
    connect(m_export, &QToolButton::clicked, this, &StepsBar::exportWanted);
    connect(m_close, &QToolButton::clicked, this, &StepsBar::closeWanted);
    connect(m_time, &QSlider::valueChanged, this,
            [this](int value) { Q_EMIT timeChosen(double(value) / kOfStep); });
    connect(m_apart, &QSlider::valueChanged, this, &StepsBar::drawnApartChanged);
    // In the order that they are read.
    QWidget *const order[] = {m_previous, m_play, m_next, m_time, m_apart, m_export, m_close};
    for (std::size_t i = 1; i < std::size(order); ++i)
        setTabOrder(order[i - 1], order[i]);
    for (QWidget *part : order)
        part->installEventFilter(this);
    hide();
    view->installEventFilter(this);
}

QToolButton *StepsBar::addButton(const char *name, const char *icon, const QString &text)
{
    auto *button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setIcon(themedIcon(QLatin1String(icon)));
    button->setIconSize({18, 18});
    button->setFixedSize(28, 28);
    button->setToolTip(text);
    button->setAccessibleName(text);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void StepsBar::setStepCount(int count)
{
    const QSignalBlocker quiet(m_time);
    m_stepCount = count;
    m_time->setRange(0, kOfStep * count);
    place();
}

/// One a step, or one for as many as can be told apart. Fusion's own are not seen in the dark.
void StepsBar::paintTicks(QPainter &painter) const
{
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, m_time);
    const int span = m_time->width() - handle;
    const int most = std::max(1, span / kTickApart);
    const int interval = std::max(1, (m_stepCount + most - 1) / most);
    const QRect place = m_time->geometry();
    painter.setPen(QPen(theme().strong, 1.0));
    for (int step = 0; step <= m_stepCount; step += interval) {
        const double x = place.left() + 0.5 * handle + 0.5 +
                         QStyle::sliderPositionFromValue(0, m_stepCount, step, span);
        painter.drawLine(QPointF(x, place.center().y() + 9.5),
                         QPointF(x, place.center().y() + 13.5));
    }
}

void StepsBar::show(double time, const QString &sentence, bool isPlaying)
{
    const QSignalBlocker quiet(m_time);
    const int value = static_cast<int>(std::lround(kOfStep * time));
    if (m_time->value() != value)
        m_time->setValue(value);
    m_sentence->setSentence(sentence);
    if (m_time->accessibleDescription() != m_sentence->text())
        m_time->setAccessibleDescription(m_sentence->text());
    const bool canGoBack = value > 0, canGoOn = value < m_time->maximum();
    // The focus stays with the two, or the next Space would be for something else.
    if (!canGoOn && m_next->hasFocus()) {
        m_previous->setEnabled(true);
        m_previous->setFocus();
    } else if (!canGoBack && m_previous->hasFocus()) {
        m_next->setEnabled(true);
        m_next->setFocus();
    }
    m_previous->setEnabled(canGoBack);
    m_next->setEnabled(canGoOn);
    if (std::exchange(m_isPlaying, isPlaying) != isPlaying) {
        const QString text = isPlaying ? tr("Pause (Space)") : tr("Play (Space)");
        m_play->setIcon(themedIcon(isPlaying ? QStringLiteral("pause") : QStringLiteral("play")));
        m_play->setToolTip(text);
        m_play->setAccessibleName(text);
    }
}

double StepsBar::drawnApart() const
{
    return double(m_apart->value()) / kOfApart;
}

void StepsBar::resetDrawnApart()
{
    const QSignalBlocker quiet(m_apart);
    m_apart->setValue(0);
}

void StepsBar::refresh()
{
    update();
}

bool StepsBar::eventFilter(QObject *object, QEvent *event)
{
    if (object == parent()) {
        if (event->type() == QEvent::Resize)
            place();
        return QFrame::eventFilter(object, event);
    }
    const auto *slider = qobject_cast<QSlider *>(object);
    if (slider && event->type() == QEvent::Wheel && !slider->hasFocus()) {
        event->ignore(); // scrolling must not change the step on the way
        return true;
    }
    if (!slider && event->type() == QEvent::KeyPress) {
        auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Left || key->key() == Qt::Key_Right) {
            keyPressEvent(key); // a button would give the focus to the one beside it
            return true;
        }
    }
    return QFrame::eventFilter(object, event);
}

void StepsBar::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        Q_EMIT closeWanted();
        break;
    case Qt::Key_Space:
        Q_EMIT playWanted();
        break;
    case Qt::Key_Left:
        Q_EMIT previousWanted();
        break;
    case Qt::Key_Right:
        Q_EMIT nextWanted();
        break;
    default:
        event->accept(); // letters are no shortcuts of the view here
    }
}

void StepsBar::place()
{
    const QWidget *view = parentWidget();
    const bool isNarrow = view->width() < kNarrow; // the sentence needs the room
    m_export->setToolButtonStyle(isNarrow ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
    const int width =
        std::max(minimumSizeHint().width(), std::min(kWidest, view->width() - 2 * kBelow));
    resize(width, sizeHint().height());
    move((view->width() - width) / 2, view->height() - height() - kBelow);
    layout()->activate();
}

void StepsBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().accent, 1.5));
    painter.setBrush(theme().panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintTicks(painter);
}

} // namespace fff::ui
