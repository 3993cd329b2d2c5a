#include "ui/docks/dock_title.h"

#include "ui/base/icon.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace fff::ui {

namespace {

constexpr int kHeight = 28; // px
constexpr char kTitle[] = "dockTitle", kNoTitle[] = "noDockTitle";

QToolButton *titleButton(QWidget *title, const char *icon, const QString &text)
{
    auto *button = new QToolButton(title);
    button->setIcon(themedIcon(QLatin1String(icon)));
    button->setIconSize({14, 14});
    button->setFixedSize(24, 24);
    button->setToolTip(text);
    button->setAccessibleName(text);
    return button;
}

} // namespace

void dressDock(QDockWidget *dock, const char *objectName)
{
    dock->setObjectName(QLatin1String(objectName));
    dock->setAttribute(Qt::WA_WindowPropagation); // floating it is a window, in the same colours
    auto *title = new QWidget(dock);
    title->setObjectName(QLatin1String(kTitle));
    title->setFixedHeight(kHeight);
    title->setAttribute(Qt::WA_StyledBackground);
    auto *name = new QLabel(dock->windowTitle(), title);
    QToolButton *floating = titleButton(title, "float", QDockWidget::tr("Float"));
    QToolButton *close = titleButton(title, "close", QDockWidget::tr("Close"));
    auto *row = new QHBoxLayout(title);
    row->setContentsMargins(12, 0, 6, 0);
    row->setSpacing(2);
    row->addStrut(kHeight); // also where no button is shown
    row->addWidget(name, 1);
    row->addWidget(floating);
    row->addWidget(close);
    QObject::connect(floating, &QToolButton::clicked, dock,
                     [dock] { dock->setFloating(!dock->isFloating()); });
    QObject::connect(close, &QToolButton::clicked, dock, &QWidget::close);
    dock->setTitleBarWidget(title);
}

void setDockTitled(QDockWidget &dock, bool isTitled)
{
    auto *title = dock.findChild<QWidget *>(QLatin1String(kTitle), Qt::FindDirectChildrenOnly);
    auto *none = dock.findChild<QWidget *>(QLatin1String(kNoTitle), Qt::FindDirectChildrenOnly);
    if (!none) {
        none = new QWidget(&dock); // without one the dock shows a title of its own
        none->setObjectName(QLatin1String(kNoTitle));
    }
    QWidget *wanted = isTitled ? title : none;
    if (dock.titleBarWidget() == wanted)
        return;
    dock.titleBarWidget()->hide();
    dock.setTitleBarWidget(wanted);
    wanted->show();
}

void setDockFixed(QDockWidget &dock, bool isFixed)
{
    dock.setFeatures(isFixed ? QDockWidget::NoDockWidgetFeatures
                             : QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                                   QDockWidget::DockWidgetFloatable);
    const auto *title = dock.findChild<QWidget *>(QLatin1String(kTitle));
    for (QToolButton *button : title->findChildren<QToolButton *>())
        button->setVisible(!isFixed);
}

} // namespace fff::ui
