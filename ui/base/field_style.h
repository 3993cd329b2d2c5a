// Fusion, but fields, check boxes and menus have the border that the theme gives them (three to one
// against the window, which Fusion's own is not in dark), and a frame in the accent's colour while
// they have the focus.
// Scroll bars are thin and have no arrows: what they scroll has the room.
// A selected row is of one colour from edge to edge. The frame of FocusFrame lies over the edge of
// its widget.
#pragma once

#include <QProxyStyle>

namespace fff::ui {

class FieldStyle : public QProxyStyle
{
public:
    FieldStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
    void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override;
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex *option, SubControl part,
                         const QWidget *widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption *option,
                    const QWidget *widget) const override;
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *returned) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                            QPainter *painter, const QWidget *widget) const override;
};

} // namespace fff::ui
