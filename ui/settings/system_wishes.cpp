#include "ui/settings/system_wishes.h"

#include <QIcon>
#include <QSettings>
#include <QStandardPaths>
#include <QVariant>

#ifdef Q_OS_WIN
#include <windows.h>
#endif

namespace fff::ui {

namespace {

#if defined(Q_OS_WIN)
bool askForMotion()
{
    BOOL animates = TRUE;
    return SystemParametersInfoW(SPI_GETCLIENTAREAANIMATION, 0, &animates, 0) && !animates;
}

bool askForContrast()
{
    HIGHCONTRASTW contrast = {};
    contrast.cbSize = sizeof(contrast);
    return SystemParametersInfoW(SPI_GETHIGHCONTRAST, sizeof(contrast), &contrast, 0) &&
           (contrast.dwFlags & HCF_HIGHCONTRASTON) != 0;
}
#else
QVariant configured(const QString &file, const QString &key)
{
    const QString path = QStandardPaths::locate(QStandardPaths::GenericConfigLocation, file);
    return path.isEmpty() ? QVariant() : QSettings(path, QSettings::IniFormat).value(key);
}

/// Plasma has a factor for all durations; GTK's file has a switch, which other desktops write too.
bool askForMotion()
{
    bool isNumber = false;
    const double factor =
        configured(QStringLiteral("kdeglobals"), QStringLiteral("KDE/AnimationDurationFactor"))
            .toDouble(&isNumber);
    if (isNumber)
        return factor <= 0.0;
    const QVariant gtk = configured(QStringLiteral("gtk-3.0/settings.ini"),
                                    QStringLiteral("Settings/gtk-enable-animations"));
    return gtk.isValid() && !gtk.toBool();
}

/// GNOME's switch changes the theme of widgets and that of icons.
bool askForContrast()
{
    const QLatin1StringView name("HighContrast");
    return QIcon::themeName().startsWith(name) ||
           configured(QStringLiteral("gtk-3.0/settings.ini"),
                      QStringLiteral("Settings/gtk-theme-name"))
               .toString()
               .startsWith(name);
}
#endif

} // namespace

bool systemReducesMotion()
{
    static const bool reduces = askForMotion();
    return reduces;
}

bool systemWantsContrast()
{
    return askForContrast();
}

} // namespace fff::ui
