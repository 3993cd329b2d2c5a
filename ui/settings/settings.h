// What a person has set, for all windows and the next start: one store, typed, with defaults and
// ranges. A value that cannot be made sense of reads as its default, so that a file written by hand
// or by another version never stops the program.
//
//     settings().turnTime();                                             read, in the main thread
//     connect(&settings(), &Settings::viewChanged, this, &X::follow);    live
//     Settings::setFile(folder.filePath("settings.ini"));                tests, before a window is
//     made
//
// Every setter writes at once and announces only what differs.
#pragma once

#include "core/interaction/navigation.h"
#include "ui/settings/settings_store.h"
#include "ui/view/length_unit.h"

#include <QByteArray>
#include <QDateTime>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QStringList>

#include <optional>

namespace fff::ui {

enum class ColourScheme { System, Light, Dark, HighContrast };
enum class Motion { System, Full, Reduced };
/// How sections are drawn: local symmetry, also for the first section, cut flat at the ground, and
/// snapping of points.
enum class DrawingSwitch { Symmetry, FirstSymmetry, Ground, Snap };

class Settings : public QObject
{
    Q_OBJECT
public:
    /// Where settings() keeps them from now on; empty: the person's own file, the same on all
    /// systems (~/.config/flatfitfab/settings.ini and its like).
    /// defaults: for what it does not say; empty: those of this computer (places.h).
    static void setFile(const QString &path, const QStringList &defaults = {});
    /// From now on nothing counts that a person or who looks after the computer has set, and what
    /// is set is forgotten with the program's end.
    static void startSafely();

    /// Where the program keeps other things of this person: beside the file of setFile(), else
    /// where the system wants data to be.
    static QString dataFolder();

    explicit Settings(const QString &path, const QStringList &defaults = {},
                      QObject *parent = nullptr);

    // General
    LengthUnit unit() const; // lengths are shown and typed in it; files and the core have mm
    void setUnit(LengthUnit unit);
    ColourScheme colourScheme() const;
    void setColourScheme(ColourScheme scheme);
    QString language() const; // "" follows the system, else one of languagesThere()
    void setLanguage(const QString &language);
    bool showsStartPage() const;
    void setShowsStartPage(bool shows);
    bool hasSimpleWindow() const; // to draw, check and export, and nothing else
    void setSimpleWindow(bool isSimple);

    // View
    static constexpr int kMaxTurnTime = 3000; // ms
    int turnTime() const;                     // ms, of the view in a stroke; as it was set
    void setTurnTime(int milliseconds);
    Motion motion() const;
    void setMotion(Motion motion);
    /// What animations ask: also true when the system wants little motion.
    bool reducesMotion() const;
    /// ms that an animation of `milliseconds` takes: none with reduced motion.
    int animationTime(int milliseconds) const { return reducesMotion() ? 0 : milliseconds; }

    // Drawing
    bool isOn(DrawingSwitch what) const;
    void setOn(DrawingSwitch what, bool on);
    static constexpr int kMinTurnAngle = 60, kMaxTurnAngle = 90; // degrees
    /// To which the view turns in a stroke; below 90° the slit's section stays to be seen.
    int turnAngle() const;
    void setTurnAngle(int degrees);
    static constexpr int kMinGuideReach = 1, kMaxGuideReach = 1000; // tenths of a mm
    int guideReach() const; // from which what is drawn is caught by templates
    void setGuideReach(int tenths);
    NavigationPreset navigation() const;
    void setNavigation(NavigationPreset preset);

    // Checks
    static constexpr int kMinShallowAngle = 10, kMaxShallowAngle = 60; // degrees
    int shallowAngle() const; // at which sections meet, below it is said; degrees
    void setShallowAngle(int degrees);
    static constexpr int kMinTouching = 50, kMaxTouching = 2000; // µm
    int touching() const; // sections that overlap by less only touch; µm
    void setTouching(int micrometres);
    static constexpr int kMinPlanningTime = 100, kMaxPlanningTime = 60000; // ms
    int planningTime() const; // that an order of assembly is looked for; ms
    void setPlanningTime(int milliseconds);
    static constexpr int kMinSafety = 10, kMaxSafety = 100; // tenths
    int safetyFactor() const;                               // on every stress; tenths
    void setSafetyFactor(int tenths);
    static constexpr int kMinNotch = 10, kMaxNotch = 50; // tenths
    int notchFactor() const; // by which inner corners raise a stress at most; tenths
    void setNotchFactor(int tenths);
    bool isLoadLasting() const; // what acts stays for months
    void setLoadLasting(bool isLasting);
    static constexpr int kMinStressShown = 0, kMaxStressShown = 95; // %
    int stressShown() const; // from which on stresses are shown; % of what the sheet bears
    void setStressShown(int percent);
    bool isStressColourSafe() const; // told by lightness, for those who cannot tell the hues
    void setStressColourSafe(bool isSafe);
    bool bendsSections() const; // whether forces are also worked out with sections that bend
    void setBendsSections(bool bends);

    // Files
    static constexpr int kMinAutosaveInterval = 5, kMaxAutosaveInterval = 30; // s
    int autosaveInterval() const;                                             // s
    void setAutosaveInterval(int seconds);
    bool keepsBackup() const; // the file as it was before the last save, beside it
    void setKeepsBackup(bool keeps);
    /// Where files are looked for and written that have no folder yet; one that is not there is
    /// empty. Set by whoever looks after the computer, like the next.
    QString workFolder() const;
    QString newModelFile() const; // what new models begin as; empty: as empty ones
    /// Newest first, absolute. Also such that are gone by now.
    QStringList recentFiles() const;
    /// opened: when; the newest is the first of the list.
    void addRecentFile(const QString &path, const QDateTime &opened = QDateTime::currentDateTime());
    /// When one of them was opened or saved last here; not valid: that is not known.
    QDateTime recentTime(const QString &path) const;
    void removeRecentFile(const QString &path);
    void clearRecentFiles();
    static constexpr int kMaxRecentFiles = 12;

    // Keyboard: only what differs from the program's own shortcuts, by the action's id. A list
    // without entries: the person wants none.
    std::optional<QList<QKeySequence>> shortcuts(const QString &id) const;
    void setShortcuts(const QString &id, const std::optional<QList<QKeySequence>> &keys);
    void resetShortcuts();

    // The window, as saveGeometry() and saveState() have it; nobody is told.
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray &geometry);
    QByteArray windowState() const;
    void setWindowState(const QByteArray &state);

    /// Anything else that a part of the window remembers; key "dock/thing".
    QVariant memory(const QString &key) const;
    void setMemory(const QString &key, const QVariant &value);

Q_SIGNALS:
    void unitChanged();
    void colourSchemeChanged();
    void languageChanged();
    void startPageChanged();
    void simpleWindowChanged();
    void viewChanged();     // turn time, motion
    void drawingChanged();  // all of Drawing
    void checksChanged();   // all of Checks
    void autosaveChanged(); // interval, backup
    void exportChanged();   // how sheets are cut, remembered from one export to the next
    void recentFilesChanged();
    void shortcutsChanged();

private:
    bool store(const QString &key, const QVariant &value);

    SettingsStore m_store;
};

/// The one that the program uses.
Settings &settings();

} // namespace fff::ui
