#include "ui/settings/system_motion.h"

#include <QSettings>
#include <QStandardPaths>
#include <QVariant>

#ifdef Q_OS_WIN
#include <windows.h>
#endif

namespace fff::ui {

namespace {

#if defined(Q_OS_WIN)
bool ask()
{
    BOOL animates = TRUE;
    return SystemParametersInfoW(SPI_GETCLIENTAREAANIMATION, 0, &animates, 0) && !animates;
}
#else
QVariant configured(const QString &file, const QString &key)
{
    const QString path = QStandardPaths::locate(QStandardPaths::GenericConfigLocation, file);
    return path.isEmpty() ? QVariant() : QSettings(path, QSettings::IniFormat).value(key);
}

/// Plasma has a factor for all durations; GTK's file has a switch, which other desktops write too.
bool ask()
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
#endif

} // namespace

bool systemReducesMotion()
{
    static const bool reduces = ask();
    return reduces;
}

} // namespace fff::ui
