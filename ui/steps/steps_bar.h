// The bar over the view while the steps of the assembly are shown: which step it is, the way
// through all of them, how far the parts are drawn apart, export, and the way out.
#pragma once

#include <QFrame> // first: moc stumbles over some standard headers

class QLabel;
class QPainter;
class QSlider;
class QToolButton;

namespace fff::ui {

class SentenceLabel;

class StepsBar : public QFrame
{
    Q_OBJECT
public:
    /// At the lower edge of the view.
    explicit StepsBar(QWidget *view);

    void setStepCount(int count);
    /// time: in steps, as Playback counts it. sentence: marked.
    void show(double time, const QString &sentence, bool isPlaying);
    using QFrame::show;
    double drawnApart() const;
    void resetDrawnApart();
    /// In the colours of the theme.
    void refresh();

Q_SIGNALS:
    void previousWanted();
    void nextWanted();
    void playWanted(); // or pause
    void timeChosen(double time);
    void drawnApartChanged();
    void exportWanted();
    void closeWanted();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QToolButton *addButton(const char *name, const char *icon, const QString &text);
    void place();
    void paintTicks(QPainter &painter) const;

    SentenceLabel *m_sentence = nullptr;
    QToolButton *m_previous = nullptr, *m_play = nullptr, *m_next = nullptr;
    QToolButton *m_export = nullptr, *m_close = nullptr;
    QSlider *m_time = nullptr, *m_apart = nullptr;
    QLabel *m_apartLabel = nullptr;
    int m_stepCount = 0;
    bool m_isPlaying = false;
};

} // namespace fff::ui
