#include "ui/settings/places.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTemporaryFile>

#include <optional>

namespace fff::ui {

namespace {

const QString kOwnFolder = QStringLiteral("/flatfitfab");
const QString kSettingsFile = QStringLiteral("/settings.ini");
constexpr qint64 kLongestLine = 4096; // bytes: no path is longer

Places ofSystem()
{
    using Paths = QStandardPaths;
    return {Paths::writableLocation(Paths::GenericConfigLocation) + kOwnFolder + kSettingsFile,
            Paths::writableLocation(Paths::GenericDataLocation) + kOwnFolder,
            Paths::writableLocation(Paths::GenericCacheLocation) + kOwnFolder};
}

QStringList defaultsFor(const QString &programFolder)
{
    using Paths = QStandardPaths;
    QStringList folders{programFolder};
    const QString own = Paths::writableLocation(Paths::GenericConfigLocation);
    for (const QString &folder : Paths::standardLocations(Paths::GenericConfigLocation))
        if (folder != own) // what is there is the person's
            folders += folder + kOwnFolder;
    for (QString &folder : folders)
        folder += QStringLiteral("/defaults.ini");
    return folders;
}

/// The folder that portable.txt names; empty when it names none, nothing without the file.
std::optional<QString> wishOf(const QString &programFolder)
{
    QFile file(programFolder + QStringLiteral("/portable.txt"));
    if (!file.exists())
        return std::nullopt;
    if (!file.open(QIODevice::ReadOnly))
        return QString(); // it is there: nothing may be left on this computer
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine(kLongestLine)).trimmed();
        if (!line.isEmpty() && !line.startsWith(u'#'))
            return line;
    }
    return QString();
}

/// Permissions do not tell of sticks that are locked: one has to try.
bool canBeWritten(const QString &folder)
{
    return QDir().mkpath(folder) && QTemporaryFile(folder + QStringLiteral("/.try")).open();
}

/// Gone at the program's end, but for unsaved work, which is what one wants back after a crash.
Places ofThisRun()
{
    static const QTemporaryDir once;
#ifdef Q_OS_WIN
    const auto kind = QStandardPaths::TempLocation; // the other one is the person's own folder
#else
    const auto kind = QStandardPaths::RuntimeLocation;
#endif
    const QString runtime = QStandardPaths::writableLocation(kind);
    return {once.path() + kSettingsFile, (runtime.isEmpty() ? once.path() : runtime) + kOwnFolder,
            once.path()};
}

/// Nothing without the file.
std::optional<Places> portablePlaces(const QString &programFolder)
{
    const std::optional<QString> wish = wishOf(programFolder);
    if (!wish)
        return std::nullopt;
    const QString folder = QDir::cleanPath(QDir(programFolder).absoluteFilePath(*wish));
    if (wish->isEmpty() || !canBeWritten(folder))
        return ofThisRun();
    return Places{folder + kSettingsFile, folder, folder + QStringLiteral("/cache")};
}

} // namespace

Places placesFor(const QString &programFolder)
{
    Places found = portablePlaces(programFolder).value_or(ofSystem());
    found.defaults = defaultsFor(programFolder);
    return found;
}

Places places()
{
    // What is beside the program is asked for once: a stick may be pulled out.
    static const std::optional<Places> portable =
        portablePlaces(QCoreApplication::applicationDirPath());
    Places found = portable.value_or(ofSystem());
    found.defaults = defaultsFor(QCoreApplication::applicationDirPath());
    return found;
}

} // namespace fff::ui
