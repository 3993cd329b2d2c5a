// What a widget's tip says.
#pragma once

#include <QTest> // first: moc stumbles over some standard headers

#include <QApplication>
#include <QHelpEvent>
#include <QToolTip>

namespace fff::test {

/// With the cursor resting on its middle; empty: there is none.
inline QString tipOf(QWidget &widget)
{
    QToolTip::hideText(); // soon
    if (!QTest::qWaitFor([] { return !QToolTip::isVisible(); }))
        return QStringLiteral("one of before");
    const QPoint middle = widget.rect().center();
    QHelpEvent event(QEvent::ToolTip, middle, widget.mapToGlobal(middle));
    QApplication::sendEvent(&widget, &event);
    return QToolTip::isVisible() ? QToolTip::text() : QString();
}

} // namespace fff::test
