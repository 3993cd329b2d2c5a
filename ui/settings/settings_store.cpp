#include "ui/settings/settings_store.h"

#include <QFileInfo>

#include <algorithm>

namespace fff::ui {

SettingsStore::SettingsStore(const QString &path, const QStringList &defaults)
    : m_own(path, QSettings::IniFormat)
{
    for (const QString &file : defaults)
        if (QFileInfo(file).isReadable())
            m_defaults.push_back(std::make_unique<QSettings>(file, QSettings::IniFormat));
}

bool SettingsStore::contains(const QString &key) const
{
    return isOwn(key) ||
           std::any_of(m_defaults.begin(), m_defaults.end(),
                       [&key](const auto &defaults) { return defaults->contains(key); });
}

QVariant SettingsStore::value(const QString &key) const
{
    if (isOwn(key))
        return m_own.value(key);
    for (const auto &defaults : m_defaults)
        if (defaults->contains(key))
            return defaults->value(key);
    return {};
}

} // namespace fff::ui
