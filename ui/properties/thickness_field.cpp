#include "ui/properties/thickness_field.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSlider>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kNotch = 0.05;  // mm, of the slider
constexpr int kSettleTime = 350; // ms
constexpr int kSliderWidth = 64; // px at least

int toNotch(double millimetres)
{
    const double clamped =
        std::clamp(millimetres, ThicknessField::kSliderLeast, ThicknessField::kSliderMost);
    return static_cast<int>(std::lround(clamped / kNotch));
}

} // namespace

ThicknessField::ThicknessField(QWidget *parent) : QWidget(parent)
{
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setObjectName(QStringLiteral("thicknessSlider"));
    m_slider->setAccessibleName(tr("Thickness"));
    m_slider->setRange(toNotch(kSliderLeast), toNotch(kSliderMost));
    m_slider->setPageStep(10);
    m_slider->setMinimumWidth(kSliderWidth);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    m_slider->installEventFilter(this);
    m_edit = new LengthEdit(kRange, this);
    m_edit->setObjectName(QStringLiteral("thicknessEdit"));
    m_edit->setFixedWidth(m_edit->minimumWidth());
    m_edit->setAccessibleName(tr("Thickness"));
    m_edit->setThickness([this] { return m_thickness; });
    setFocusProxy(m_edit);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_slider, 1);
    row->addWidget(m_edit);

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleTime);
    connect(&m_settled, &QTimer::timeout, this, &ThicknessField::settle);
    connect(m_slider, &QSlider::valueChanged, this, &ThicknessField::follow);
    connect(m_slider, &QSlider::sliderReleased, this, &ThicknessField::settle);
    connect(m_edit, &LengthEdit::lengthEdited, this, &ThicknessField::settled);
}

void ThicknessField::setThickness(std::optional<double> millimetres)
{
    m_isSetting = true;
    m_thickness = millimetres;
    if (!m_slider->isSliderDown() && !m_settled.isActive())
        m_slider->setValue(toNotch(millimetres.value_or(kSliderLeast)));
    m_edit->setLength(millimetres);
    m_isSetting = false;
}

void ThicknessField::follow(int notch)
{
    if (m_isSetting)
        return;
    if (!m_before)
        m_before = m_edit->value();
    const double thickness = notch * kNotch;
    m_edit->setLength(thickness);
    Q_EMIT dragged(thickness);
    if (!m_slider->isSliderDown())
        m_settled.start();
}

void ThicknessField::settle()
{
    m_settled.stop();
    if (!m_before)
        return;
    m_before.reset();
    Q_EMIT settled(m_slider->value() * kNotch);
}

bool ThicknessField::eventFilter(QObject *object, QEvent *event)
{
    if (event->type() == QEvent::Wheel && !m_slider->hasFocus()) {
        event->ignore(); // scrolling must not change numbers on the way
        return true;
    }
    if (event->type() == QEvent::FocusOut)
        settle(); // what is selected next may be another stock
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
