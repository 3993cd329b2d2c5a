#include "ui/base/theme.h"

#include "ui/settings/settings.h"
#include "ui/settings/system_wishes.h"
#include "ui/view/heading_weight.h"

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

/// Text and lines have 7:1 on every ground that they stand on; grounds have no shades.
Theme contrastLight()
{
    Theme t;
    t.isHighContrast = true;
    t.window = t.panel = t.alternate = t.onAccent = t.button = QColor(0xff, 0xff, 0xff);
    t.text = t.border = QColor(0x00, 0x00, 0x00);
    t.muted = QColor(0x26, 0x26, 0x26);
    t.strong = QColor(0x4a, 0x4a, 0x4a);
    t.accent = QColor(0x00, 0x3c, 0x9e);
    t.soft = QColor(0xdc, 0xe8, 0xff);
    t.hover = QColor(0xe6, 0xe6, 0xe6);
    t.problem = QColor(0x8c, 0x0d, 0x0d);
    t.problemSoft = QColor(0xff, 0xec, 0xea);
    t.warning = QColor(0x5e, 0x35, 0x00);
    t.warningSoft = QColor(0xff, 0xf3, 0xdc);
    t.good = QColor(0x00, 0x4d, 0x1f);
    return t;
}

Theme contrastDark()
{
    Theme t;
    t.isDark = true;
    t.isHighContrast = true;
    t.window = t.panel = t.alternate = t.onAccent = t.button = QColor(0x00, 0x00, 0x00);
    t.text = t.border = QColor(0xff, 0xff, 0xff);
    t.muted = QColor(0xe0, 0xe0, 0xe0);
    t.strong = QColor(0xb5, 0xb5, 0xb5);
    t.accent = QColor(0x8f, 0xc7, 0xff);
    t.soft = QColor(0x00, 0x26, 0x4d);
    t.hover = QColor(0x26, 0x26, 0x26);
    t.problem = QColor(0xff, 0xa1, 0x99);
    t.problemSoft = QColor(0x3d, 0x0a, 0x08);
    t.warning = QColor(0xff, 0xd1, 0x66);
    t.warningSoft = QColor(0x33, 0x25, 0x00);
    t.good = QColor(0x7f, 0xe0, 0xa0);
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
    case ColourScheme::HighContrast:
        break;
    }
    return QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
}

bool wantsContrast()
{
    const ColourScheme scheme = settings().colourScheme();
    return scheme == ColourScheme::HighContrast ||
           (scheme == ColourScheme::System && systemWantsContrast());
}

Theme wanted()
{
    if (wantsContrast())
        return wantsDark() ? contrastDark() : contrastLight();
    return wantsDark() ? dark() : light();
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
    p.setColor(QPalette::Disabled, QPalette::Highlight, isHighContrast ? hover : border);
    return p;
}

QString Theme::styleSheet() const
{
    QFile file(QStringLiteral(":/style/window.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    QFile more(QStringLiteral(":/style/contrast.qss"));
    if (isHighContrast && more.open(QIODevice::ReadOnly))
        sheet += QString::fromUtf8(more.readAll());
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
    sheet.replace(QStringLiteral("@heading"), QString::number(headingWeight()));
    return sheet;
}

ViewStyle Theme::viewStyle() const
{
    ViewStyle style; // the light one
    style.isForColourBlind = isHighContrast || settings().isStressColourSafe();
    if (!isDark && !isHighContrast)
        return style;
    style.text = text;
    style.muted = muted;
    style.strong = strong;
    style.panel = panel;
    style.accent = accent;
    style.deadZone = muted;
    style.problem = problem;
    style.warning = warning;
    if (isDark) {
        style.top = QColor(0x34, 0x3a, 0x43);
        style.bottom = QColor(0x1a, 0x1d, 0x22);
        style.gridFine = QColor(0x3f, 0x46, 0x50);
        style.gridStrong = QColor(0x5a, 0x64, 0x70);
        style.shadow = QColor(0, 0, 0, 158);
        style.slit = QColor(0xff, 0x9a, 0x5c);
        style.symmetry = QColor(0xf0, 0x7b, 0xe3);
        style.guide = QColor(0x3f, 0xd0, 0xc0);
        style.made = QColor(0xb9, 0xa8, 0xff);
        style.madeFace = QColor(0xc3, 0xb6, 0xee);
        style.madeSide = QColor(0x75, 0x63, 0xc4);
        style.casing = QColor(0x15, 0x11, 0x0c);
        style.faceBrightness = 0.94;
    }
    if (isHighContrast) {
        style.top = style.bottom = window;
        // It is no line of the model: what is to be told apart from it comes first.
        style.gridFine = isDark ? QColor(0x3c, 0x3c, 0x3c) : QColor(0xd6, 0xd6, 0xd6);
        style.gridStrong = isDark ? QColor(0x6a, 0x6a, 0x6a) : QColor(0xa2, 0xa2, 0xa2);
        style.slit = isDark ? QColor(0xff, 0xb0, 0x80) : QColor(0x7a, 0x26, 0x00);
        style.symmetry = isDark ? QColor(0xff, 0x9c, 0xf2) : QColor(0x7a, 0x00, 0x6c);
        style.guide = isDark ? QColor(0x6f, 0xf0, 0xe0) : QColor(0x00, 0x4f, 0x48);
        style.made = isDark ? QColor(0xd3, 0xc8, 0xff) : QColor(0x3a, 0x28, 0x8c);
        style.edge = QColor(0x00, 0x00, 0x00);
        style.edgeWidth = 1.5;
        style.silhouetteWidth = 2.2;
        // A line is seen against its casing, whatever lies under both.
        style.casing = window;
        style.casesHover = true;
        style.hoverAlpha = 1.0;
        style.hoverWidth = 2.4;
        style.selectionWidth = 3.4;
    }
    return style;
}

void applyTheme(QWidget *window)
{
    current() = wanted();
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
