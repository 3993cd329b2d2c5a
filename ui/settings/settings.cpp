#include "ui/settings/settings.h"

#include "ui/settings/languages.h"
#include "ui/settings/places.h"
#include "ui/settings/stored_values.h"
#include "ui/settings/system_wishes.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>
#include <iterator>
#include <memory>

namespace fff::ui {

namespace {

// Keys of the file. No group is called "general": INI files have a special one of that name.
const QString kUnit = QStringLiteral("display/unit");
const QString kScheme = QStringLiteral("display/theme");
const QString kLanguage = QStringLiteral("display/language");
const QString kStartPage = QStringLiteral("start/page");
const QString kSimpleWindow = QStringLiteral("display/simple");
const QString kTurnTime = QStringLiteral("view/turnTime");
const QString kMotion = QStringLiteral("view/motion");
const QString kGuideReachKey = QStringLiteral("drawing/guideReach");
const QString kTurnAngle = QStringLiteral("drawing/turnAngle");
const QString kNavigation = QStringLiteral("view/navigation");
const QString kAutosave = QStringLiteral("files/autosaveInterval");
const QString kBackup = QStringLiteral("files/backup");
const QString kWorkFolder = QStringLiteral("files/folder");
const QString kNewModel = QStringLiteral("files/newModel");
const QString kRecent = QStringLiteral("files/recent");
const QString kRecentTimes = QStringLiteral("files/recentTimes"); // "2026-11-28T10:00:00Z path"
const QString kShortcuts = QStringLiteral("shortcuts");
const QString kGeometry = QStringLiteral("window/geometry");
const QString kState = QStringLiteral("window/state");

constexpr int kTurnTimeDefault = 800;   // ms
constexpr int kTurnAngleDefault = 90;   // degrees
constexpr int kGuideReachDefault = 127; // tenths of a mm
constexpr int kAutosaveDefault = 10;    // s

const Words<LengthUnit> kUnits = {
    {LengthUnit::Millimetre, "mm"}, {LengthUnit::Centimetre, "cm"}, {LengthUnit::Inch, "in"}};
const Words<ColourScheme> kSchemes = {{ColourScheme::System, "system"},
                                      {ColourScheme::Light, "light"},
                                      {ColourScheme::Dark, "dark"},
                                      {ColourScheme::HighContrast, "contrast"}};
const Words<Motion> kMotions = {
    {Motion::System, "system"}, {Motion::Full, "full"}, {Motion::Reduced, "reduced"}};

const Words<NavigationPreset> kNavigations = {{NavigationPreset::FlatFitFab, "flatfitfab"},
                                              {NavigationPreset::Blender, "blender"},
                                              {NavigationPreset::FreeCad, "freecad"},
                                              {NavigationPreset::Onshape, "onshape"}};

struct SwitchRow
{
    DrawingSwitch what;
    const char *key;
    bool byDefault;
};
constexpr SwitchRow kSwitches[] = {{DrawingSwitch::Symmetry, "drawing/symmetry", true},
                                   {DrawingSwitch::FirstSymmetry, "drawing/firstSymmetry", false},
                                   {DrawingSwitch::Ground, "drawing/ground", true},
                                   {DrawingSwitch::Snap, "drawing/snap", true}};

const SwitchRow &rowOf(DrawingSwitch what)
{
    return *std::find_if(std::begin(kSwitches), std::end(kSwitches),
                         [what](const SwitchRow &row) { return row.what == what; });
}

std::unique_ptr<Settings> &theSettings()
{
    places(); // made first, so that a place that ends with the program does so after they are
              // written
    static std::unique_ptr<Settings> one;
    return one;
}

/// "~" is each person's own folder.
QString pathOf(const QString &text)
{
    return text == u"~" || text.startsWith(QStringLiteral("~/")) ? QDir::homePath() + text.mid(1)
                                                                 : text;
}

/// See dataFolder().
QString &theFolder()
{
    static QString folder;
    return folder;
}

} // namespace

void Settings::setFile(const QString &path, const QStringList &defaults)
{
    const Places here = places();
    const bool isUsual = path.isEmpty();
    theSettings() = std::make_unique<Settings>(
        isUsual ? here.settings : path, isUsual && defaults.isEmpty() ? here.defaults : defaults);
    theFolder() = isUsual ? here.data : QFileInfo(path).absolutePath();
}

void Settings::startSafely()
{
    static const QTemporaryDir once;
    theSettings() = std::make_unique<Settings>(once.filePath(QStringLiteral("settings.ini")));
    theFolder() = places().data; // unsaved work is no setting
}

QString Settings::dataFolder()
{
    settings(); // it may be the first to ask
    return theFolder();
}

Settings &settings()
{
    if (!theSettings())
        Settings::setFile({});
    return *theSettings();
}

Settings::Settings(const QString &path, const QStringList &defaults, QObject *parent)
    : QObject(parent), m_store(path, defaults)
{
}

/// True when it differs from what was there.
bool Settings::store(const QString &key, const QVariant &value)
{
    if (m_store.isOwn(key) && m_store.value(key) == value)
        return false;
    m_store.setValue(key, value);
    return true;
}

LengthUnit Settings::unit() const
{
    return valueOf(m_store.value(kUnit), kUnits);
}

void Settings::setUnit(LengthUnit unit)
{
    if (unit == this->unit())
        return;
    store(kUnit, wordOf(unit, kUnits));
    Q_EMIT unitChanged();
}

ColourScheme Settings::colourScheme() const
{
    return valueOf(m_store.value(kScheme), kSchemes);
}

void Settings::setColourScheme(ColourScheme scheme)
{
    if (scheme == colourScheme())
        return;
    store(kScheme, wordOf(scheme, kSchemes));
    Q_EMIT colourSchemeChanged();
}

QString Settings::language() const
{
    const QString language = m_store.value(kLanguage).toString();
    return languagesThere().contains(language) ? language : QString();
}

void Settings::setLanguage(const QString &language)
{
    if (language == this->language())
        return;
    store(kLanguage, language);
    Q_EMIT languageChanged();
}

bool Settings::showsStartPage() const
{
    return truthOf(m_store.value(kStartPage), true);
}

void Settings::setShowsStartPage(bool shows)
{
    if (shows == showsStartPage())
        return;
    store(kStartPage, shows);
    Q_EMIT startPageChanged();
}

bool Settings::hasSimpleWindow() const
{
    return truthOf(m_store.value(kSimpleWindow), false);
}

void Settings::setSimpleWindow(bool isSimple)
{
    if (isSimple == hasSimpleWindow())
        return;
    store(kSimpleWindow, isSimple);
    Q_EMIT simpleWindowChanged();
}

int Settings::turnTime() const
{
    return numberOf(m_store.value(kTurnTime), 0, kMaxTurnTime, kTurnTimeDefault);
}

void Settings::setTurnTime(int milliseconds)
{
    if (milliseconds == turnTime())
        return;
    store(kTurnTime, std::clamp(milliseconds, 0, kMaxTurnTime));
    Q_EMIT viewChanged();
}

Motion Settings::motion() const
{
    return valueOf(m_store.value(kMotion), kMotions);
}

void Settings::setMotion(Motion motion)
{
    if (motion == this->motion())
        return;
    store(kMotion, wordOf(motion, kMotions));
    Q_EMIT viewChanged();
}

bool Settings::reducesMotion() const
{
    const Motion chosen = motion();
    return chosen == Motion::Reduced || (chosen == Motion::System && systemReducesMotion());
}

bool Settings::isOn(DrawingSwitch what) const
{
    const SwitchRow &row = rowOf(what);
    return truthOf(m_store.value(QLatin1String(row.key)), row.byDefault);
}

void Settings::setOn(DrawingSwitch what, bool on)
{
    if (on == isOn(what))
        return;
    store(QLatin1String(rowOf(what).key), on);
    Q_EMIT drawingChanged();
}

int Settings::turnAngle() const
{
    return numberOf(m_store.value(kTurnAngle), kMinTurnAngle, kMaxTurnAngle, kTurnAngleDefault);
}

void Settings::setTurnAngle(int degrees)
{
    if (degrees == turnAngle())
        return;
    store(kTurnAngle, std::clamp(degrees, kMinTurnAngle, kMaxTurnAngle));
    Q_EMIT drawingChanged();
}

int Settings::guideReach() const
{
    return numberOf(m_store.value(kGuideReachKey), kMinGuideReach, kMaxGuideReach,
                    kGuideReachDefault);
}

void Settings::setGuideReach(int tenths)
{
    if (tenths == guideReach())
        return;
    store(kGuideReachKey, std::clamp(tenths, kMinGuideReach, kMaxGuideReach));
    Q_EMIT drawingChanged();
}

NavigationPreset Settings::navigation() const
{
    return valueOf(m_store.value(kNavigation), kNavigations);
}

void Settings::setNavigation(NavigationPreset preset)
{
    if (preset == navigation())
        return;
    store(kNavigation, wordOf(preset, kNavigations));
    Q_EMIT drawingChanged();
}

QString Settings::workFolder() const
{
    const QString folder = pathOf(m_store.value(kWorkFolder).toString());
    return QFileInfo(folder).isDir() ? folder : QString();
}

QString Settings::newModelFile() const
{
    return pathOf(m_store.value(kNewModel).toString());
}

int Settings::autosaveInterval() const
{
    return numberOf(m_store.value(kAutosave), kMinAutosaveInterval, kMaxAutosaveInterval,
                    kAutosaveDefault);
}

void Settings::setAutosaveInterval(int seconds)
{
    if (seconds == autosaveInterval())
        return;
    store(kAutosave, std::clamp(seconds, kMinAutosaveInterval, kMaxAutosaveInterval));
    Q_EMIT autosaveChanged();
}

bool Settings::keepsBackup() const
{
    return truthOf(m_store.value(kBackup), true);
}

void Settings::setKeepsBackup(bool keeps)
{
    if (keeps == keepsBackup())
        return;
    store(kBackup, keeps);
    Q_EMIT autosaveChanged();
}

QStringList Settings::recentFiles() const
{
    return m_store.value(kRecent).toStringList().mid(0, kMaxRecentFiles);
}

void Settings::addRecentFile(const QString &path, const QDateTime &opened)
{
    const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    QStringList times;
    for (const QString &file : files.mid(0, kMaxRecentFiles)) {
        const QDateTime time = file == absolute ? opened : recentTime(file);
        if (time.isValid())
            times += time.toUTC().toString(Qt::ISODate) + u' ' + file;
    }
    store(kRecentTimes, times);
    if (store(kRecent, QStringList(files.mid(0, kMaxRecentFiles))))
        Q_EMIT recentFilesChanged();
}

QDateTime Settings::recentTime(const QString &path) const
{
    for (const QString &row : m_store.value(kRecentTimes).toStringList())
        if (row.section(u' ', 1) == path)
            return QDateTime::fromString(row.section(u' ', 0, 0), Qt::ISODate).toLocalTime();
    return {};
}

void Settings::removeRecentFile(const QString &path)
{
    QStringList files = recentFiles();
    if (files.removeAll(path) > 0 && store(kRecent, files))
        Q_EMIT recentFilesChanged();
}

void Settings::clearRecentFiles()
{
    if (recentFiles().isEmpty())
        return;
    store(kRecent, QStringList());
    Q_EMIT recentFilesChanged();
}

std::optional<QList<QKeySequence>> Settings::shortcuts(const QString &id) const
{
    const QString key = kShortcuts + u'/' + id;
    if (!m_store.contains(key))
        return std::nullopt;
    const QString text = m_store.value(key).toString();
    return text.isEmpty() ? QList<QKeySequence>()
                          : QKeySequence::listFromString(text, QKeySequence::PortableText);
}

void Settings::setShortcuts(const QString &id, const std::optional<QList<QKeySequence>> &keys)
{
    if (keys == shortcuts(id))
        return;
    const QString key = kShortcuts + u'/' + id;
    if (keys)
        m_store.setValue(key, QKeySequence::listToString(*keys, QKeySequence::PortableText));
    else
        m_store.remove(key);
    Q_EMIT shortcutsChanged();
}

void Settings::resetShortcuts()
{
    m_store.remove(kShortcuts);
    Q_EMIT shortcutsChanged();
}

QByteArray Settings::windowGeometry() const
{
    return m_store.value(kGeometry).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray &geometry)
{
    store(kGeometry, geometry);
}

QByteArray Settings::windowState() const
{
    return m_store.value(kState).toByteArray();
}

void Settings::setWindowState(const QByteArray &state)
{
    store(kState, state);
}

QVariant Settings::memory(const QString &key) const
{
    return m_store.value(key);
}

void Settings::setMemory(const QString &key, const QVariant &value)
{
    store(key, value);
}

} // namespace fff::ui
