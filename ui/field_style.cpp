#include "ui/field_style.h"

#include "ui/theme.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace fff::ui {

namespace {

constexpr double kCorner = 3.0; // px

void drawBorder(QPainter *painter, const QStyleOption *option)
{
    const bool focused = option->state.testFlag(QStyle::State_HasFocus);
    QColor colour = focused ? theme().accent : theme().strong;
    if (!option->state.testFlag(QStyle::State_Enabled))
        colour = theme().border;
    const double width = focused ? 2.0 : 1.0, inset = 0.5 * width;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(colour, width));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(inset, inset, -inset, -inset), kCorner,
                             kCorner);
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
    if (element == PE_FrameLineEdit)
        drawBorder(painter, option);
}

void FieldStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                    QPainter *painter, const QWidget *widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox || control == CC_ComboBox)
        drawBorder(painter, option);
}

} // namespace fff::ui
