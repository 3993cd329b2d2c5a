// The step of the tour over the view: which one it is, a sentence, and the ways on and out.
#pragma once

#include <QFrame> // first: moc stumbles over some standard headers

class QLabel;
class QPushButton;
class QToolButton;

namespace fff::ui {

class TourCard : public QFrame
{
    Q_OBJECT
public:
    /// top  px below the upper edge of the view; it stands in its middle
    TourCard(QWidget *view, int top);

    /// number  of the step, from 0 on; count: it was the last one
    /// marked  with <b> and <kbd>
    void say(int number, int count, const QString &marked);
    void refreshColours();

Q_SIGNALS:
    void skipWanted();
    void endWanted();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void place();

    const int m_top;
    QLabel *m_dots = nullptr, *m_words = nullptr;
    QPushButton *m_skip = nullptr;
    QToolButton *m_end = nullptr;
    int m_number = 0, m_count = 1;
};

} // namespace fff::ui
