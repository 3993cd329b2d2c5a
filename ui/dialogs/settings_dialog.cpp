#include "ui/dialogs/settings_dialog.h"

#include "ui/base/focus_frame.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/dialogs/shortcut_editor.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/number_edit.h"
#include "ui/settings/languages.h"
#include "ui/settings/settings.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <cmath>
#include <functional>

namespace fff::ui {

namespace {

constexpr int kFieldWidth = 200; // px, at least
/// px: labels break into lines rather than take more, and all fields begin at one line.
constexpr int kLabelWidth = 190;
/// px: a note is near what it is about, and the next question farther off; a group farther still.
constexpr int kNoteGap = 4, kRowGap = 14, kGroupGap = 26;

} // namespace

/// A form of two columns, with room for what German needs.
class SettingsForm : public QWidget
{
public:
    SettingsForm()
    {
        m_form = new QFormLayout(this);
        m_form->setContentsMargins(0, 0, 0, 0);
        m_form->setHorizontalSpacing(16);
        m_form->setVerticalSpacing(kNoteGap);
        m_form->setRowWrapPolicy(QFormLayout::DontWrapRows);
        m_form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
        m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }

    void add(const char *name, const QString &label, QWidget *field)
    {
        field->setObjectName(QLatin1String(name));
        field->setAccessibleName(label);
        auto *words = new QLabel(label, this);
        words->setWordWrap(true);
        words->setFixedWidth(kLabelWidth);
        words->setBuddy(field);
        addRow(words, field);
    }

    /// What follows is about something else.
    void beginGroup() { m_gap = kGroupGap; }

    /// What the row above it is about.
    void note(const QString &sentence)
    {
        auto *text = new QLabel(sentence, this);
        text->setWordWrap(true);
        text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        policy.setHeightForWidth(true); // no more lines than it takes
        text->setSizePolicy(policy);
        text->setMinimumHeight(1); // in place of that of a narrower one
        text->setForegroundRole(QPalette::PlaceholderText);
        m_form->addRow(QString(), text);
        if (QWidget *field = m_described)
            field->setAccessibleDescription(sentence);
    }

    QComboBox *choice(const char *name, const QString &label, const QStringList &choices,
                      int current, const std::function<void(int)> &chosen)
    {
        auto *box = new ChoiceBox(this);
        box->addItems(choices);
        box->setCurrentIndex(current);
        box->setMinimumWidth(kFieldWidth);
        box->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
        QObject::connect(box, &QComboBox::activated, box, chosen);
        add(name, label, box);
        m_described = box;
        return box;
    }

    void number(const char *name, const QString &label, const NumberEdit::Range &range,
                const QString &unit, double current, const std::function<void(double)> &edited)
    {
        auto *field = new NumberEdit(range, unit, this);
        field->setNumber(current);
        field->setMinimumWidth(kFieldWidth / 2);
        field->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
        QObject::connect(field, &NumberEdit::numberEdited, field, edited);
        add(name, label, field);
        m_described = field;
    }

    struct Whole
    {
        int least = 0, most = 0, step = 1;
    };
    void wholeNumber(const char *name, const QString &label, const Whole &range,
                     const QString &unit, int current, const std::function<void(int)> &edited)
    {
        number(name, label, {double(range.least), double(range.most), double(range.step), 0, 0},
               unit, current, [edited](double value) {
                   // What is shown of a sum that was typed is rounded, too.
                   edited(static_cast<int>(std::lround(value)));
               });
    }

    QCheckBox *box(const char *name, const QString &label, bool current,
                   const std::function<void(bool)> &toggled)
    {
        auto *box = new QCheckBox(label, this);
        box->setObjectName(QLatin1String(name));
        box->setChecked(current);
        QObject::connect(box, &QCheckBox::toggled, box, toggled);
        addRow(nullptr, box);
        m_described = box;
        return box;
    }

private:
    void addRow(QWidget *label, QWidget *field)
    {
        if (m_form->rowCount() > 0)
            m_form->addItem(new QSpacerItem(0, m_gap - 2 * kNoteGap));
        m_gap = kRowGap;
        m_form->addRow(label, field);
    }

    QFormLayout *m_form = nullptr;
    int m_gap = kRowGap; // px before the next row
    QWidget *m_described = nullptr;
};

SettingsDialog::SettingsDialog(const QList<ListedAction> &actions, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("settingsDialog"));
    setWindowTitle(tr("Settings"));
    resize(QSize(780, 560).boundedTo(screen()->availableSize() - QSize(40, 60)));

    m_groups = new QListWidget(this);
    m_groups->setObjectName(QStringLiteral("settingsGroups"));
    m_groups->setAccessibleName(tr("Groups of settings"));
    m_groups->setIconSize({20, 20});
    m_groups->setFrameShape(QFrame::NoFrame);
    FocusFrame::leaveTo(m_groups); // its row has one
    m_groups->setSpacing(2);
    m_pages = new QStackedWidget(this);
    addPage(tr("General"), QStringLiteral("settings"), makeGeneral());
    addPage(tr("View"), QStringLiteral("eye"), makeView());
    addPage(tr("Checks"), QStringLiteral("check"), makeChecks());
    addPage(tr("Files"), QStringLiteral("save"), makeFiles());
    addPage(tr("Keyboard"), QStringLiteral("keyboard"), new ShortcutEditor(actions));
    m_groups->setFixedWidth(
        std::max(150, m_groups->sizeHintForColumn(0) + 4 * m_groups->spacing() + 16));
    connect(m_groups, &QListWidget::currentRowChanged, m_pages, &QStackedWidget::setCurrentIndex);
    m_groups->setCurrentRow(0);

    auto *buttons = new QDialogButtonBox(this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole)
        ->setAutoDefault(false); // Enter in a field accepts the field

    auto *row = new QHBoxLayout;
    row->setSpacing(24);
    row->addWidget(m_groups);
    row->addWidget(m_pages, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    column->addLayout(row, 1);
    column->addWidget(buttons);
    m_groups->setFocus();
    dress(this);
}

void SettingsDialog::showPage(Page page)
{
    m_groups->setCurrentRow(static_cast<int>(page));
}

void SettingsDialog::addPage(const QString &name, const QString &icon, QWidget *content)
{
    auto *page = new QWidget;
    auto *title = new QLabel(name, page);
    QFont font = title->font();
    font.setBold(true);
    font.setPointSizeF(font.pointSizeF() * 1.2);
    title->setFont(font);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 8, 0);
    column->setSpacing(16);
    column->addWidget(title);
    const bool fills = qobject_cast<ShortcutEditor *>(content);
    column->addWidget(content, fills ? 1 : 0);
    if (!fills)
        column->addStretch(1);

    auto *scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(page);
    scroll->viewport()->setAutoFillBackground(false);
    page->setAutoFillBackground(false);
    m_pages->addWidget(scroll);
    auto *group = new QListWidgetItem(themedIcon(icon), name, m_groups);
    group->setSizeHint({0, 34});
}

QWidget *SettingsDialog::makeGeneral()
{
    auto *form = new SettingsForm;
    form->choice("settingsUnit", tr("Units"),
                 {tr("Millimetres (mm)"), tr("Centimetres (cm)"), tr("Inches (in)")},
                 static_cast<int>(settings().unit()),
                 [](int index) { settings().setUnit(static_cast<LengthUnit>(index)); });
    form->note(tr("What is shown and typed. Files always hold millimetres."));
    form->choice("settingsTheme", tr("Colours"),
                 {tr("Same as the system"), tr("Light"), tr("Dark"), tr("High contrast")},
                 static_cast<int>(settings().colourScheme()),
                 [](int index) { settings().setColourScheme(static_cast<ColourScheme>(index)); });
    const QStringList codes = QStringList{QString()} + languagesThere();
    QStringList languages{tr("Same as the system")};
    for (const QString &code : languagesThere())
        languages += nameOfLanguage(code);
    form->choice("settingsLanguage", tr("Language"), languages,
                 static_cast<int>(codes.indexOf(settings().language())),
                 [codes](int index) { settings().setLanguage(codes.at(index)); });
    form->note(tr("Takes effect after a restart."));
    form->box("settingsStartPage", tr("Show the start page at startup"),
              settings().showsStartPage(), [](bool on) { settings().setShowsStartPage(on); });
    form->box("settingsSimpleWindow", tr("Simple window"), settings().hasSimpleWindow(),
              [](bool on) { settings().setSimpleWindow(on); });
    form->note(tr("To draw, check and export; all else is out of the way."));
    return form;
}

QWidget *SettingsDialog::makeView()
{
    auto *form = new SettingsForm;
    form->wholeNumber("settingsTurnTime", tr("Turning time"), {0, Settings::kMaxTurnTime, 50},
                      tr("ms"), settings().turnTime(),
                      [](int time) { settings().setTurnTime(time); });
    form->note(tr("How long the view takes, while you draw, to turn to the new plane. With 0 it "
                  "jumps."));
    form->wholeNumber("settingsTurnAngle", tr("View turns by"),
                      {Settings::kMinTurnAngle, Settings::kMaxTurnAngle}, tr("°"),
                      settings().turnAngle(), [](int angle) { settings().setTurnAngle(angle); });
    form->note(tr("At 90° you look straight at the new plane. With less, the section that you "
                  "started on stays visible."));
    form->number("settingsGuideReach", tr("Strokes follow a template within"),
                 {0.1 * Settings::kMinGuideReach, 0.1 * Settings::kMaxGuideReach, 1.0, 1, 1},
                 tr("mm"), 0.1 * settings().guideReach(), [](double value) {
                     settings().setGuideReach(static_cast<int>(std::lround(10.0 * value)));
                 });
    form->choice("settingsNavigation", tr("Mouse buttons like"),
                 {QStringLiteral("FlatFitFab"), QStringLiteral("Blender"),
                  QStringLiteral("FreeCAD"), QStringLiteral("Onshape")},
                 static_cast<int>(settings().navigation()),
                 [](int index) { settings().setNavigation(static_cast<NavigationPreset>(index)); });
    form->note(tr("Which buttons turn, move and zoom the view. Ctrl with the left button always "
                  "turns it, Space with the left button moves it."));
    form->choice("settingsMotion", tr("Motion"),
                 {tr("Same as the system"), tr("Always"), tr("As little as possible")},
                 static_cast<int>(settings().motion()),
                 [](int index) { settings().setMotion(static_cast<Motion>(index)); });
    form->note(tr("With as little as possible, the view jumps instead of turning."));
    form->box("settingsColourSafe", tr("Stress colours for the colour-blind"),
              settings().isStressColourSafe(), [](bool on) { settings().setStressColourSafe(on); });
    form->note(tr("From light to dark instead of blue to red. Always so in high contrast."));
    return form;
}

QWidget *SettingsDialog::makeChecks()
{
    auto *form = new SettingsForm;
    form->wholeNumber("settingsShallowAngle", tr("Warn about angles below"),
                      {Settings::kMinShallowAngle, Settings::kMaxShallowAngle}, tr("°"),
                      settings().shallowAngle(),
                      [](int angle) { settings().setShallowAngle(angle); });
    form->note(tr("The flatter two sections meet, the wider their slits have to be."));
    form->number("settingsTouching", tr("Ignore overlaps below"),
                 {0.001 * Settings::kMinTouching, 0.001 * Settings::kMaxTouching, 0.1, 2, 4},
                 tr("mm"), 0.001 * settings().touching(), [](double value) {
                     settings().setTouching(static_cast<int>(std::lround(1000.0 * value)));
                 });
    form->note(tr("An overlap of less than this is no problem."));
    form->number(
        "settingsPlanningTime", tr("Look for an order of assembly for"),
        {0.001 * Settings::kMinPlanningTime, 0.001 * Settings::kMaxPlanningTime, 0.5, 1, 3},
        tr("s"), 0.001 * settings().planningTime(), [](double value) {
            settings().setPlanningTime(static_cast<int>(std::lround(1000.0 * value)));
        });
    form->note(
        tr("In the background, after each change. Allow more time if the checks find no order."));
    form->beginGroup();
    addStrength(*form);
    return form;
}

/// How strict verdicts about strength are; the Physics panel has the same.
void SettingsDialog::addStrength(SettingsForm &form)
{
    const auto tenths = [&form](const char *name, const QString &label, int least, int most,
                                int current, const std::function<void(int)> &edited) {
        form.number(
            name, label, {0.1 * least, 0.1 * most, 0.1, 1, 1}, QString(), 0.1 * current,
            [edited](double value) { edited(static_cast<int>(std::lround(10.0 * value))); });
    };
    tenths("settingsSafety", tr("Safety factor"), Settings::kMinSafety, Settings::kMaxSafety,
           settings().safetyFactor(), [](int factor) { settings().setSafetyFactor(factor); });
    form.note(tr("How many times its load a model has to hold before it counts as strong enough."));
    tenths("settingsNotch", tr("Notch factor, at most"), Settings::kMinNotch, Settings::kMaxNotch,
           settings().notchFactor(), [](int factor) { settings().setNotchFactor(factor); });
    form.note(tr("How many times higher stress is taken to be at inner corners."));
    form.box("settingsLasting", tr("Loads stay on for months"), settings().isLoadLasting(),
             [](bool on) { settings().setLoadLasting(on); });
}

QWidget *SettingsDialog::makeFiles()
{
    auto *form = new SettingsForm;
    form->wholeNumber("settingsAutosave", tr("Back up unsaved work every"),
                      {Settings::kMinAutosaveInterval, Settings::kMaxAutosaveInterval}, tr("s"),
                      settings().autosaveInterval(),
                      [](int interval) { settings().setAutosaveInterval(interval); });
    form->note(tr("After a crash or a power cut you get it back, even if it was never saved. Your "
                  "file is not touched."));
    form->box("settingsBackup", tr("Keep the previous version when saving"),
              settings().keepsBackup(), [](bool on) { settings().setKeepsBackup(on); });
    return form;
}

} // namespace fff::ui
