// Where people keep what they make, in tests: a folder that the settings name.
#pragma once

#include "ui/settings/settings.h"

#include <QSettings>

namespace fff::ui {

/// Settings of their own in that folder, which is the one for documents.
inline void workIn(const QString &folder)
{
    const QString path = folder + QStringLiteral("/settings.ini");
    {
        QSettings file(path, QSettings::IniFormat);
        file.setValue(QStringLiteral("files/folder"), folder);
    }
    Settings::setFile(path);
}

} // namespace fff::ui
