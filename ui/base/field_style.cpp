#include "ui/base/field_style.h"

#include "ui/base/theme.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kCorner = 3.0;                     // px
constexpr int kScrollBar = 10, kLeastScrolled = 24; // px, across and along

void drawBorder(QPainter *painter, const QStyleOption *option)
{
    const bool focused = option->state.testFlag(QStyle::State_HasFocus);
    QColor colour = focused ? theme().accent : theme().strong;
    if (!option->state.testFlag(QStyle::State_Enabled)) // in high contrast separators are black
        colour = theme().isHighContrast ? theme().palette().color(QPalette::Disabled, QPalette::Text)
                                        : theme().border;
    const double width = focused ? 2.0 : 1.0, inset = 0.5 * width;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(colour, width));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(inset, inset, -inset, -inset), kCorner,
                             kCorner);
    painter->restore();
}

void drawScrollBar(QPainter *painter, const QStyleOptionSlider &bar, const QRect &handle)
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->fillRect(bar.rect, bar.palette.brush(QPalette::Window));
    const bool isHeld = bar.activeSubControls.testFlag(QStyle::SC_ScrollBarSlider) &&
                        bar.state.testFlag(QStyle::State_Sunken);
    const bool isOver = bar.state.testFlag(QStyle::State_MouseOver);
    if (bar.maximum > bar.minimum) {
        painter->setPen(Qt::NoPen);
        painter->setBrush(isHeld ? theme().text : isOver ? theme().muted : theme().strong);
        const QRectF shown = QRectF(handle).adjusted(2.0, 2.0, -2.0, -2.0);
        const double round = 0.5 * std::min(shown.width(), shown.height());
        painter->drawRoundedRect(shown, round, round);
    }
    painter->restore();
}

} // namespace

FieldStyle::FieldStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void FieldStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option,
                               QPainter *painter, const QWidget *widget) const
{
    const bool isRow = element == PE_PanelItemViewRow || element == PE_PanelItemViewItem;
    if (isRow && option->state.testFlag(State_Selected)) {
        painter->fillRect(option->rect, option->palette.brush(QPalette::Highlight));
        return;
    }
    if (element == PE_FrameFocusRect && qobject_cast<const QAbstractItemView *>(widget)) {
        // Fusion's own fills what it frames, so that a selected row gets two colours.
        const bool isSelected = option->state.testFlag(State_Selected);
        painter->save();
        painter->setPen(
            option->palette.color(isSelected ? QPalette::HighlightedText : QPalette::Highlight));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(1, 1, -2, -2));
        painter->restore();
        return;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_PanelMenu || element == PE_FrameMenu) {
        painter->save();
        painter->setPen(theme().strong);
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
    if (element == PE_FrameLineEdit || element == PE_IndicatorCheckBox ||
        element == PE_IndicatorItemViewItemCheck)
        drawBorder(painter, option);
}

/// With a line of the ground's colour inside, so that it is seen on what has the accent's, too.
void FieldStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                             const QWidget *widget) const
{
    if (element != CE_FocusFrame) {
        QProxyStyle::drawControl(element, option, painter, widget);
        return;
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme().panel, 1.0));
    painter->drawRoundedRect(QRectF(option->rect).adjusted(2.5, 2.5, -2.5, -2.5), 2.0, 2.0);
    painter->setPen(QPen(theme().accent, 2.0));
    painter->drawRoundedRect(QRectF(option->rect).adjusted(1.0, 1.0, -1.0, -1.0), kCorner, kCorner);
    painter->restore();
}

int FieldStyle::pixelMetric(PixelMetric metric, const QStyleOption *option,
                            const QWidget *widget) const
{
    // Outside of a widget there may be nothing to draw on. Of rows it is the air beside their
    // words.
    if ((metric == PM_FocusFrameHMargin || metric == PM_FocusFrameVMargin) &&
        !qobject_cast<const QAbstractItemView *>(widget))
        return 0;
    if (metric == PM_ScrollBarExtent)
        return kScrollBar;
    return QProxyStyle::pixelMetric(metric, option, widget);
}

int FieldStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                          QStyleHintReturn *returned) const
{
    if (hint == SH_FocusFrame_AboveWidget)
        return 1;
    return QProxyStyle::styleHint(hint, option, widget, returned);
}

QRect FieldStyle::subControlRect(ComplexControl control, const QStyleOptionComplex *option,
                                 SubControl part, const QWidget *widget) const
{
    const auto *bar = qstyleoption_cast<const QStyleOptionSlider *>(option);
    if (control != CC_ScrollBar || !bar)
        return QProxyStyle::subControlRect(control, option, part, widget);
    const bool isLevel = bar->orientation == Qt::Horizontal;
    const int length = isLevel ? bar->rect.width() : bar->rect.height();
    const int range = bar->maximum - bar->minimum;
    int handle = length;
    if (range > 0)
        handle = std::clamp(
            static_cast<int>(static_cast<qint64>(length) * bar->pageStep / (range + bar->pageStep)),
            std::min(kLeastScrolled, length), length);
    const int start = sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition,
                                              length - handle, bar->upsideDown);
    const auto along = [&](int from, int to) {
        const QRect place = isLevel ? QRect(from, 0, to - from, bar->rect.height())
                                    : QRect(0, from, bar->rect.width(), to - from);
        return visualRect(bar->direction, bar->rect, place.translated(bar->rect.topLeft()));
    };
    switch (part) {
    case SC_ScrollBarGroove:
        return along(0, length);
    case SC_ScrollBarSlider:
        return along(start, start + handle);
    case SC_ScrollBarSubPage:
        return along(0, start);
    case SC_ScrollBarAddPage:
        return along(start + handle, length);
    default: // arrows
        return {};
    }
}

void FieldStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                    QPainter *painter, const QWidget *widget) const
{
    const auto *bar = qstyleoption_cast<const QStyleOptionSlider *>(option);
    if (control == CC_ScrollBar && bar) {
        drawScrollBar(painter, *bar, subControlRect(control, option, SC_ScrollBarSlider, widget));
        return;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox || control == CC_ComboBox)
        drawBorder(painter, option);
}

} // namespace fff::ui
