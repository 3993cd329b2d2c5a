#include "ui/properties/slider_field.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QSlider>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr int kSettleTime = 350; // ms
constexpr int kSliderWidth = 40; // px at least
constexpr int kBesideWidth = 80; // px, of a slider that stands beside its field
constexpr int kBetween = 8;      // px

} // namespace

SliderField::SliderField(const Scale &scale, NumberEdit *edit, QWidget *parent)
    : QWidget(parent), m_scale(scale), m_edit(edit)
{
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setRange(toNotch(scale.least), toNotch(scale.most));
    m_slider->setPageStep(scale.page);
    m_slider->setMinimumWidth(kSliderWidth);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    m_slider->installEventFilter(this);
    m_edit->setParent(this);
    m_edit->setFixedWidth(m_edit->minimumWidth());
    setFocusProxy(m_edit);
    m_row = new QBoxLayout(QBoxLayout::LeftToRight, this);
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(kBetween);
    m_row->addWidget(m_slider, 1);
    m_row->addWidget(m_edit);

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleTime);
    connect(&m_settled, &QTimer::timeout, this, &SliderField::settle);
    connect(m_slider, &QSlider::valueChanged, this, &SliderField::follow);
    connect(m_slider, &QSlider::sliderReleased, this, &SliderField::settle);
    connect(m_edit, &NumberEdit::numberEdited, this, &SliderField::settled);
}

void SliderField::setNames(const char *slider, const char *edit)
{
    m_slider->setObjectName(QLatin1String(slider));
    m_edit->setObjectName(QLatin1String(edit));
}

void SliderField::setSpoken(const QString &name, const QString &description)
{
    for (QWidget *part : {static_cast<QWidget *>(m_slider), static_cast<QWidget *>(m_edit)}) {
        part->setAccessibleName(name);
        part->setAccessibleDescription(description);
    }
}

void SliderField::comeAfter(const SliderField &other)
{
    setTabOrder(other.m_edit, m_slider);
    setTabOrder(m_slider, m_edit);
}

int SliderField::toNotch(double number) const
{
    return static_cast<int>(
        std::lround(std::clamp(number, m_scale.least, m_scale.most) / m_scale.notch));
}

void SliderField::setMost(double most)
{
    m_isSetting = true;
    m_scale.most = most;
    m_slider->setMaximum(toNotch(most));
    m_isSetting = false;
}

void SliderField::setNumber(std::optional<double> number)
{
    m_isSetting = true;
    if (!m_slider->isSliderDown() && !m_settled.isActive())
        m_slider->setValue(toNotch(number.value_or(m_scale.least)));
    m_edit->setNumber(number);
    m_isSetting = false;
}

void SliderField::follow(int notch)
{
    if (m_isSetting)
        return;
    if (!m_before)
        m_before = m_edit->value();
    const double number = notch * m_scale.notch;
    m_edit->setNumber(number);
    Q_EMIT dragged(number);
    if (!m_slider->isSliderDown())
        m_settled.start();
}

void SliderField::settle()
{
    m_settled.stop();
    if (!m_before)
        return;
    m_before.reset();
    Q_EMIT settled(m_slider->value() * m_scale.notch);
}

/// A slider of a few pixels cannot be aimed with: in a narrow panel it has a line of its own.
void SliderField::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool isBeside = width() >= kBesideWidth + kBetween + m_edit->width();
    const auto direction = isBeside ? QBoxLayout::LeftToRight : QBoxLayout::BottomToTop;
    if (direction == m_row->direction())
        return;
    m_row->setDirection(direction);
    m_row->setSpacing(isBeside ? kBetween : 0);
    updateGeometry();
}

bool SliderField::eventFilter(QObject *object, QEvent *event)
{
    if (event->type() == QEvent::Wheel && !m_slider->hasFocus()) {
        event->ignore(); // scrolling must not change numbers on the way
        return true;
    }
    if (event->type() == QEvent::FocusOut)
        settle(); // what is selected next may be something else
    if (m_isGivenUp && event->type() == QEvent::MouseMove)
        return true; // the button is still down, but drags nothing any more
    if (event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseButtonPress)
        m_isGivenUp = false;
    const bool isEscape = event->type() == QEvent::KeyPress &&
                          static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape;
    if (isEscape && m_before) {
        m_settled.stop();
        m_before.reset();
        m_isGivenUp = m_slider->isSliderDown();
        m_slider->setSliderDown(false);
        Q_EMIT cancelled();
        return true;
    }
    return QWidget::eventFilter(object, event);
}

} // namespace fff::ui
