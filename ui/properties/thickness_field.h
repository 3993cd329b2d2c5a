// A stock's thickness: a slider for the useful range and a field for the full one. Dragging is told
// all along, and once more when it is done.
#pragma once

#include "ui/properties/length_edit.h"

#include <QWidget>

class QSlider;

namespace fff::ui {

class ThicknessField : public QWidget
{
    Q_OBJECT
public:
    static constexpr NumberEdit::Range kRange{0.1, 100.0, 0.05, 2, 3}; // mm, of the field
    static constexpr double kSliderLeast = 0.5, kSliderMost = 5.0;     // mm

    explicit ThicknessField(QWidget *parent = nullptr);

    /// Announces nothing. Nothing: several stocks that differ.
    void setThickness(std::optional<double> millimetres);
    /// What waits to be announced is, now: the field is about to be for something else.
    void settle();

Q_SIGNALS:
    void dragged(double millimetres); // on the way
    void settled(double millimetres); // done: one step of the history
    void cancelled();                 // Esc during a drag

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void follow(int notch);

    QSlider *m_slider = nullptr;
    LengthEdit *m_edit = nullptr;
    QTimer m_settled;                  // after the last key or click on the slider
    std::optional<double> m_thickness; // as last set: "t" in the field
    std::optional<double> m_before;    // of the drag that runs
    bool m_isSetting = false;
    bool m_isGivenUp = false; // by Esc, with the button still down
};

} // namespace fff::ui
