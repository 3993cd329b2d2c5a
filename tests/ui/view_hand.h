// A window with its view, and a hand that works in it through the window system's interface, so
// that buttons and focus are as in life. For tests that need a display.
#pragma once

#include <QTest>

#include "core/base/units.h"
#include "ui/bench/viewport.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QTemporaryDir>

#include <cmath>
#include <memory>
#include <vector>

namespace fff::ui {

class ViewHand
{
protected:
    /// A new window with settings of its own, shown, its view with the focus.
    void openWindow(const QSize &size = {1440, 900});
    void closeWindow() { m_window.reset(); }

    Workbench &bench() { return m_window->bench(); }
    const Interaction &interaction() const { return m_window->bench().interaction(); }
    Session &session() const { return m_window->bench().session(); }
    const Section &first() const { return *session().committed().section(0); }
    std::size_t count() const { return session().committed().sectionCount(); }
    int steps() const { return session().history()->count(); }
    QPoint middle() const { return {m_view->width() / 2, m_view->height() / 2}; }
    QPoint onScreen(const Vec3 &world) const;

    /// `pause`  ms, how long the button was left alone before
    void press(const QPoint &inView, Qt::KeyboardModifiers keys = {}, int pause = 5);
    void move(const QPoint &inView);
    void release(const QPoint &inView, Qt::KeyboardModifiers keys = {});
    void click(const QPoint &inView, Qt::KeyboardModifiers keys = {});
    void drag(const std::vector<QPoint> &points);
    void key(Qt::Key key, Qt::KeyboardModifiers keys = {})
    {
        QTest::keyClick(m_window->windowHandle(), key, keys, 5);
    }

    /// An oval in the middle of the front view.
    void drawFirst();
    /// Out of the top of the first one: press inside, leave it upwards, wait for the turn.
    void pullSlit();
    /// That, and an oval round the slit.
    void drawSecond();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    Viewport *m_view = nullptr;
    QPoint m_cursor;
};

inline void ViewHand::openWindow(const QSize &size)
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(size);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(
        m_window.get()); // the display may have no window manager to do it
    m_view = m_window->findChild<Viewport *>(QStringLiteral("viewport"));
    QVERIFY(m_view);
    QTRY_VERIFY(m_view->isValid());
    QTRY_COMPARE(m_view->hasFocus(), true);
}

inline QPoint ViewHand::onScreen(const Vec3 &world) const
{
    const Vec2 p = interaction().camera().toScreen(world, Vec2(m_view->width(), m_view->height()));
    return {static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
}

inline void ViewHand::press(const QPoint &inView, Qt::KeyboardModifiers keys, int pause)
{
    QTest::mousePress(m_window->windowHandle(), Qt::LeftButton, keys,
                      m_view->mapTo(m_window.get(), inView), pause);
}

inline void ViewHand::move(const QPoint &inView)
{
    m_cursor = inView;
    QTest::mouseMove(m_window->windowHandle(), m_view->mapTo(m_window.get(), inView), 5);
}

inline void ViewHand::release(const QPoint &inView, Qt::KeyboardModifiers keys)
{
    QTest::mouseRelease(m_window->windowHandle(), Qt::LeftButton, keys,
                        m_view->mapTo(m_window.get(), inView), 5);
}

inline void ViewHand::click(const QPoint &inView, Qt::KeyboardModifiers keys)
{
    move(inView);
    press(inView, keys);
    release(inView, keys);
}

inline void ViewHand::drag(const std::vector<QPoint> &points)
{
    move(points.front());
    press(points.front());
    for (const QPoint &point : points)
        move(point);
    release(points.back());
}

inline void ViewHand::drawFirst()
{
    std::vector<QPoint> points;
    for (int i = 0; i < 48; ++i) {
        const double angle = radians(360.0 * i / 50.0);
        points.push_back(middle() + QPoint(static_cast<int>(220 * std::cos(angle)),
                                           static_cast<int>(-130 * std::sin(angle))));
    }
    drag(points);
    QTRY_COMPARE(count(), std::size_t(1));
}

inline void ViewHand::pullSlit()
{
    const Box3 box = worldBounds(*first().shape, first().frame);
    const Vec3 centre = box.center();
    const QPoint start = onScreen(centre),
                 leave = onScreen({centre.x(), box.max.y() + 4.0, centre.z()});
    move(start);
    press(start);
    for (int i = 1; i <= 24; ++i)
        move(start + (leave - start) * i / 24);
    QTRY_VERIFY(interaction().overlay().find<sign::Capsule>());
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
}

inline void ViewHand::drawSecond()
{
    const std::size_t before = count();
    const QPoint start = onScreen(worldBounds(*first().shape, first().frame).center());
    pullSlit();
    const QPoint centre = (start + m_cursor) / 2;
    for (int i = 0; i <= 40; ++i) {
        const double angle = radians(90.0 + 345.0 * i / 40.0);
        const QPoint to = centre + QPoint(static_cast<int>(90 * std::cos(angle)),
                                          static_cast<int>(-130 * std::sin(angle)));
        move(to);
        if (i == 40)
            release(to);
    }
    QTRY_COMPARE(count(), before + 1);
}

} // namespace fff::ui
