// A number as a slider for the useful range and a field for the full one. Dragging is told all
// along, and once more when it is done.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/properties/number_edit.h"

class QBoxLayout;
class QSlider;

namespace fff::ui {

class SliderField : public QWidget
{
    Q_OBJECT
public:
    /// Of the slider.
    struct Scale
    {
        double least = 0.0, most = 1.0;
        double notch = 0.1;
        int page = 10; // notches
    };
    SliderField(const Scale &scale, NumberEdit *edit, QWidget *parent = nullptr);

    /// Of the slider's scale.
    void setMost(double most);
    /// Announces nothing. Nothing: several things that differ.
    void setNumber(std::optional<double> number);
    /// What waits to be announced is, now: the field is about to be for something else.
    void settle();
    /// Object names of the slider and the field.
    void setNames(const char *slider, const char *edit);
    /// What is read out of both: they have the focus, not what they lie in.
    void setSpoken(const QString &name, const QString &description);
    /// The Tab key goes from there to here.
    void comeAfter(const SliderField &other);

Q_SIGNALS:
    void dragged(double number); // on the way
    void settled(double number); // done: one step of the history
    void cancelled();            // Esc during a drag

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void follow(int notch);
    int toNotch(double number) const;

    Scale m_scale;
    QBoxLayout *m_row = nullptr;
    QSlider *m_slider = nullptr;
    NumberEdit *m_edit = nullptr;
    QTimer m_settled;               // after the last key or click on the slider
    std::optional<double> m_before; // of the drag that runs
    bool m_isSetting = false;
    bool m_isGivenUp = false; // by Esc, with the button still down
};

} // namespace fff::ui
