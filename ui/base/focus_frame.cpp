#include "ui/base/focus_frame.h"

#include <QApplication>
#include <QEvent>
#include <QFocusFrame>

namespace fff::ui {

namespace {

constexpr char kShowsItself[] = "showsFocusItself";

} // namespace

FocusFrame::FocusFrame(QApplication &application) : QObject(&application)
{
    application.installEventFilter(this);
}

FocusFrame::~FocusFrame()
{
    if (m_frame && !m_frame->parent())
        delete m_frame;
}

void FocusFrame::leaveTo(QWidget *widget)
{
    widget->setProperty(kShowsItself, true);
}

void FocusFrame::show(QWidget *widget)
{
    if (widget && (widget->isWindow() || widget->property(kShowsItself).toBool()))
        widget = nullptr;
    if (!m_frame) {
        if (!widget)
            return;
        // It lives in the window that it is shown in, and goes with it.
        m_frame = new QFocusFrame;
        connect(m_frame, &QObject::destroyed, this, [this] { m_frame = nullptr; });
    }
    if (m_frame->widget() != widget)
        m_frame->setWidget(widget);
}

bool FocusFrame::eventFilter(QObject *object, QEvent *event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:
        m_usesKeys = true;
        break;
    case QEvent::MouseButtonPress:
        m_usesKeys = false;
        show(nullptr);
        break;
    case QEvent::FocusIn:
        if (auto *widget = qobject_cast<QWidget *>(object))
            show(m_usesKeys ? widget : nullptr);
        break;
    case QEvent::FocusOut:
        if (m_frame && m_frame->widget() == object)
            show(nullptr);
        break;
    default:
        break;
    }
    return QObject::eventFilter(object, event);
}

} // namespace fff::ui
