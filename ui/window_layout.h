// Where the docks of a window are: at first, hidden all together, and back where they were.
#pragma once

#include <QByteArray>
#include <QObject>

#include <vector>

class QDockWidget;
class QMainWindow;

namespace fff::ui {

class WindowLayout : public QObject
{
    Q_OBJECT
public:
    /// Where a dock is at first in a wide window; a narrow one has all of them at the right.
    enum class Place { Left, Right };

    explicit WindowLayout(QMainWindow &window);

    void add(QDockWidget *dock, Place place);
    const std::vector<QDockWidget *> &docks() const { return m_docks; }

    /// Every dock where it is at first, for the window's present width.
    void reset();
    /// All docks away, and back exactly as they were.
    void setHidden(bool hidden);
    bool isHidden() const { return m_isHidden; }

Q_SIGNALS:
    void hiddenChanged(bool hidden);

private:
    QMainWindow &m_window;
    std::vector<QDockWidget *> m_docks;
    std::vector<Place> m_places; // one a dock
    QByteArray m_beforeHiding;
    bool m_isHidden = false;
};

} // namespace fff::ui
