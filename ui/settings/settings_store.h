// Keys and their values: the person's own file, and below it those that whoever looks after the
// computer has written, which are only read. Of them the first that has a key counts.
#pragma once

#include <QSettings>
#include <QString>
#include <QStringList>
#include <QVariant>

#include <memory>
#include <vector>

namespace fff::ui {

class SettingsStore
{
public:
    /// defaults   INI files; those that are not there or cannot be read have no keys
    SettingsStore(const QString &path, const QStringList &defaults);

    QString fileName() const { return m_own.fileName(); }
    bool contains(const QString &key) const;
    /// Not valid where no file has it.
    QVariant value(const QString &key) const;
    bool isOwn(const QString &key) const { return m_own.contains(key); }
    void setValue(const QString &key, const QVariant &value) { m_own.setValue(key, value); }
    /// From the person's own, with all below it.
    void remove(const QString &key) { m_own.remove(key); }

private:
    QSettings m_own;
    std::vector<std::unique_ptr<QSettings>> m_defaults;
};

} // namespace fff::ui
