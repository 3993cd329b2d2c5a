#include "ui/theme.h"

#include "ui/settings/settings.h"

#include <QFile>
#include <QGuiApplication>
#include <QToolTip>
#include <QWidget>

namespace fff::ui {

namespace {

Theme light()
{
    Theme t;
    t.window = QColor(0xec, 0xee, 0xf2);
    t.panel = QColor(0xff, 0xff, 0xff);
    t.alternate = QColor(0xf5, 0xf7, 0xf9);
    t.text = QColor(0x1b, 0x21, 0x27);
    t.muted = QColor(0x54, 0x5f, 0x6b);
    t.border = QColor(0xc6, 0xcc, 0xd4);
    t.strong = QColor(0x7d, 0x87, 0x93);
    t.accent = QColor(0x1b, 0x62, 0xc9);
    t.onAccent = QColor(0xff, 0xff, 0xff);
    t.soft = QColor(0xdc, 0xe8, 0xfa);
    t.hover = QColor(0xe1, 0xe7, 0xef);
    t.problem = QColor(0xb3, 0x26, 0x1e);
    t.problemSoft = QColor(0xfb, 0xe3, 0xe0);
    t.warning = QColor(0x8a, 0x53, 0x00);
    t.warningSoft = QColor(0xff, 0xf0, 0xd2);
    t.good = QColor(0x1a, 0x73, 0x37);
    t.button = QColor(0xf6, 0xf7, 0xf9);
    return t;
}

Theme dark()
{
    Theme t;
    t.isDark = true;
    t.window = QColor(0x2a, 0x2e, 0x34);
    t.panel = QColor(0x1e, 0x22, 0x27);
    t.alternate = QColor(0x24, 0x28, 0x2e);
    t.text = QColor(0xe8, 0xeb, 0xef);
    t.muted = QColor(0xa7, 0xb1, 0xbc);
    t.border = QColor(0x41, 0x48, 0x51);
    t.strong = QColor(0x76, 0x81, 0x8d);
    t.accent = QColor(0x74, 0xae, 0xff);
    t.onAccent = QColor(0x0c, 0x1a, 0x2b);
    t.soft = QColor(0x25, 0x3d, 0x58);
    t.hover = QColor(0x37, 0x3d, 0x45);
    t.problem = QColor(0xff, 0x8f, 0x86);
    t.problemSoft = QColor(0x4a, 0x26, 0x24);
    t.warning = QColor(0xf0, 0xb8, 0x49);
    t.warningSoft = QColor(0x47, 0x37, 0x18);
    t.good = QColor(0x6c, 0xcb, 0x8a);
    t.button = QColor(0x36, 0x3b, 0x43);
    return t;
}

Theme &current()
{
    static Theme chosen = light();
    return chosen;
}

constexpr char kDressed[] = "dressed";

bool wantsDark()
{
    switch (settings().colourScheme()) {
    case ColourScheme::Light:
        return false;
    case ColourScheme::Dark:
        return true;
    case ColourScheme::System:
        break;
    }
    return QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
}

QColor withAlpha(QColor colour, double alpha)
{
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

} // namespace

const Theme &theme()
{
    return current();
}

QPalette Theme::palette() const
{
    QPalette p(button, window);
    p.setColor(QPalette::Window, window);
    p.setColor(QPalette::WindowText, text);
    p.setColor(QPalette::Base, panel);
    p.setColor(QPalette::AlternateBase, alternate);
    p.setColor(QPalette::Text, text);
    p.setColor(QPalette::Button, button);
    p.setColor(QPalette::ButtonText, text);
    p.setColor(QPalette::Highlight, accent);
    p.setColor(QPalette::HighlightedText, onAccent);
    p.setColor(QPalette::PlaceholderText, muted);
    p.setColor(QPalette::Link, accent);
    p.setColor(QPalette::LinkVisited, accent);
    p.setColor(QPalette::ToolTipBase, panel);
    p.setColor(QPalette::ToolTipText, text);
    const QColor off = withAlpha(text, 0.38);
    for (QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        p.setColor(QPalette::Disabled, role, off);
    p.setColor(QPalette::Disabled, QPalette::Highlight, border);
    return p;
}

QString Theme::styleSheet() const
{
    QFile file(QStringLiteral(":/style/window.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const std::pair<QString, QColor> names[] = {
        {QStringLiteral("@window"), window},
        {QStringLiteral("@panel"), panel},
        {QStringLiteral("@text"), text},
        {QStringLiteral("@muted"), muted},
        {QStringLiteral("@border"), border},
        {QStringLiteral("@strong"), strong},
        {QStringLiteral("@accentHover"), isDark ? accent.lighter(110) : accent.darker(112)},
        {QStringLiteral("@accent"), accent},
        {QStringLiteral("@onAccent"), onAccent},
        {QStringLiteral("@soft"), soft},
        {QStringLiteral("@hover"), hover},
        {QStringLiteral("@problemSoft"), problemSoft},
        {QStringLiteral("@problem"), problem},
        {QStringLiteral("@warningSoft"), warningSoft},
        {QStringLiteral("@warning"), warning},
    };
    for (const auto &[name, colour] : names)
        sheet.replace(name, colour.name());
    return sheet;
}

ViewStyle Theme::viewStyle() const
{
    ViewStyle style; // the light one
    if (!isDark)
        return style;
    style.top = QColor(0x34, 0x3a, 0x43);
    style.bottom = QColor(0x1a, 0x1d, 0x22);
    style.gridFine = QColor(0x3f, 0x46, 0x50);
    style.gridStrong = QColor(0x5a, 0x64, 0x70);
    style.shadow = QColor(0, 0, 0, 158);
    style.text = text;
    style.muted = muted;
    style.strong = strong;
    style.panel = panel;
    style.accent = accent;
    style.slit = QColor(0xff, 0x9a, 0x5c);
    style.deadZone = muted;
    style.casing = QColor(0x15, 0x11, 0x0c);
    style.problem = problem;
    style.faceBrightness = 0.94;
    return style;
}

void applyTheme(QWidget *window)
{
    current() = wantsDark() ? dark() : light();
    // Without this a style sheet keeps the window's palette from the widgets in it.
    QCoreApplication::setAttribute(Qt::AA_UseStyleSheetPropagationInWidgetStyles);
    window->setPalette(theme().palette());
    window->setStyleSheet(theme().styleSheet());
    QToolTip::setPalette(theme().palette());
}

void dress(QWidget *widget)
{
    widget->setProperty(kDressed, true);
    widget->setPalette(theme().palette());
}

void refreshDressed(QWidget *window)
{
    for (QWidget *child : window->findChildren<QWidget *>()) {
        if (child->property(kDressed).toBool())
            child->setPalette(theme().palette());
    }
}

} // namespace fff::ui
