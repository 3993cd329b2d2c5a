#include "ui/docks/physics_dock.h"

#include "core/analysis/accurate.h"
#include "core/analysis/asked_bearing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/holding.h"
#include "core/session/message_text.h"
#include "core/session/scheduler.h"
#include "ui/base/icon.h"
#include "ui/base/lengths.h"
#include "ui/base/theme.h"
#include "ui/bench/bearing_picture.h"
#include "ui/bench/held.h"
#include "ui/bench/load_words.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/movement_rows.h"
#include "ui/docks/place_button.h"
#include "ui/properties/mass_edit.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/varying_rows.h"
#include "ui/settings/settings.h"
#include "ui/view/stress_marks.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr std::size_t kMostPlaces = 8;
constexpr double kLeastPlace = 0.01;          // of what the sheet bears: less is not listed
constexpr int kFieldWidth = 96, kMargin = 12; // px
constexpr double kGrams = 1000.0, kTenths = 10.0;
constexpr NumberEdit::Range kMass{0.1, kMaxWeight *kGrams, 10.0, 0, 1}; // g
constexpr NumberEdit::Range kForce{0.001, kMaxPush, 0.5, 0, 3};         // N
constexpr NumberEdit::Range kShownFrom{Settings::kMinStressShown, Settings::kMaxStressShown, 5.0, 0,
                                       0};
constexpr NumberEdit::Range kNotch{0.1 * Settings::kMinNotch, 0.1 * Settings::kMaxNotch, 0.1, 1, 1};
constexpr NumberEdit::Range kSafety{0.1 * Settings::kMinSafety, 0.1 * Settings::kMaxSafety, 0.1, 1,
                                    1};

} // namespace

PhysicsDock::PhysicsDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Physics"), parent), m_bench(bench)
{
    dressDock(this, "physicsDock");
    auto *area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    area->setAccessibleName(tr("Physics"));
    auto *page = new QWidget(area);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(kMargin, 0, kMargin, kMargin);
    column->setSpacing(0);

    auto *state = new QWidget(page);
    auto *stateRow = new QHBoxLayout(state);
    stateRow->setContentsMargins(0, 8, 0, 4);
    stateRow->setSpacing(8);
    m_stateIcon = new QLabel(state);
    m_state = new QLabel(state);
    m_state->setObjectName(QStringLiteral("physicsState"));
    m_state->setWordWrap(true);
    stateRow->addWidget(m_stateIcon, 0, Qt::AlignTop);
    stateRow->addWidget(m_state, 1);
    column->addWidget(state);

    auto *display = new PropertyGroup(tr("Display"), page);
    m_lines = new QCheckBox;
    connect(m_lines, &QCheckBox::clicked, this, [this](bool on) {
        m_bench.run(QStringLiteral("check.stress"), {{"on", on ? "true" : "false"}});
    });
    display->add(new EditorRow(tr("Stress lines"), "physicsLines", m_lines, {}, display));
    auto *from = new NumberEdit(kShownFrom, QStringLiteral("%"));
    from->setFixedWidth(kFieldWidth);
    connect(from, &NumberEdit::numberEdited, this, [](double percent) {
        settings().setStressShown(static_cast<int>(std::lround(percent)));
    });
    auto *least = new EditorRow(
        tr("Show from"), "physicsShownFrom", from,
        [from] { from->setNumber(settings().stressShown()); }, display);
    least->setToolTip(tr("Share of the sheet's strength; less is not shown"));
    display->add(least);
    m_rules.push_back(least);
    m_bends = new QCheckBox(tr("finite elements"));
    connect(m_bends, &QCheckBox::clicked, this, [](bool on) { settings().setBendsSections(on); });
    auto *bends = new EditorRow(tr("Sections bend"), "physicsBends", m_bends, {}, display);
    bends->setToolTip(tr("Where joints share a load, the stiffness of the sections decides how "
                         "much each carries. Takes a while."));
    m_stop = bends->addButton(QStringLiteral("close"), "physicsStop", tr("Stop"),
                              [this] { m_bench.session().scheduler().cancel(kAccurate.name); });
    display->add(bends);
    m_movement = new MovementRows(bench, display);
    m_strong = new QCheckBox;
    connect(m_strong, &QCheckBox::clicked, this, [this](bool on) {
        m_bench.run(QStringLiteral("physics.whereStrong"), {{"on", on ? "true" : "false"}});
    });
    auto *strong = new EditorRow(tr("Strength map"), "physicsStrong", m_strong, {}, display);
    strong->setToolTip(tr("Colours the selected section by the mass that each place of it can "
                          "hold, besides what is on the model already. Takes a while."));
    m_stopStrong =
        strong->addButton(QStringLiteral("close"), "physicsStopStrong", tr("Stop"),
                          [this] { m_bench.session().scheduler().cancel(kBearing.name); });
    display->add(strong);
    column->addWidget(display);

    makeLoads(page);
    column->addWidget(m_loads);
    m_placesGroup = new PropertyGroup(tr("Weakest places"), page);
    for (std::size_t i = 0; i < kMostPlaces; ++i) {
        auto *button = new PlaceButton;
        button->setObjectName(QStringLiteral("weakPlace%1").arg(i));
        connect(button, &QPushButton::clicked, this, [this, i] {
            if (i < m_shown.size())
                frame(m_shown[i].place);
        });
        button->installEventFilter(this);
        m_placesGroup->add(button);
        m_places.push_back(button);
    }
    column->addWidget(m_placesGroup);
    column->addWidget(makeRules(page));
    column->addStretch(1);
    area->setWidget(page);
    setWidget(area);

    const auto again = [this] { refresh(); };
    connect(&bench.session().scheduler(), &Scheduler::published, this,
            [this](std::string_view stage) {
                if (isOfHolding(stage))
                    refresh();
                if (stage == kBearing.name)
                    refreshStrong();
            });
    connect(&bench.session().scheduler(), &Scheduler::asked, this, &PhysicsDock::refreshStrong);
    connect(&bench.session().scheduler(), &Scheduler::aged, this, again);
    connect(&bench.session().scheduler(), &Scheduler::progressed, this, again);
    connect(&bench.session(), &Session::modelChanged, this, again);
    connect(&bench, &Workbench::viewStateChanged, this, again);
    connect(&settings(), &Settings::checksChanged, this, again);
    connect(&settings(), &Settings::unitChanged, this, again);
}

/// It is not kept up to date while nobody sees it.
void PhysicsDock::showEvent(QShowEvent *event)
{
    QDockWidget::showEvent(event);
    refresh();
}

/// Nothing moves unless somebody sees why.
void PhysicsDock::hideEvent(QHideEvent *event)
{
    m_movement->stop();
    QDockWidget::hideEvent(event);
}

void PhysicsDock::makeLoads(QWidget *parent)
{
    m_loads = new PropertyGroup(tr("Loads"), parent);
    m_empty = new QLabel(tr("Put a weight on the model to see what it can hold."));
    m_empty->setWordWrap(true);
    m_empty->setContentsMargins(0, 4, 0, 4);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_loads->add(m_empty);
    auto *weights = new PropertyGroup(QString(), parent); // under the heading of the loads
    m_loads->add(weights);
    m_weights = new VaryingRows(*weights);
    const auto sum = [this](const QString &name, const char *objectName,
                            std::function<QString()> read) {
        auto *row = new TextRow(name, objectName, std::move(read), m_loads);
        m_loads->add(row);
        m_sums.push_back(row);
    };
    sum(tr("Own weight"), "physicsOwn",
        [this] { return massText(Measures(m_bench.session()).mass(), locale()); });
    sum(tr("On the ground"), "physicsGround", [this] {
        double force = 0.0;
        if (m_held)
            for (const FootForce &foot : m_held->strength.equilibrium().feet)
                force += foot.force.y();
        return force > 0.0 ? forceText(force, locale()) : QString(QChar(0x2013));
    });
    auto *row = new QWidget;
    auto *buttons = new QHBoxLayout(row);
    buttons->setContentsMargins(0, 4, 0, 8);
    const auto addButton = [&](const char *icon, const QString &text, const char *name,
                               const char *command) {
        auto *button = new QPushButton(themedIcon(QLatin1String(icon)), text);
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this,
                [this, command] { m_bench.run(QLatin1String(command)); });
        buttons->addWidget(button);
    };
    addButton("weight", tr("Add weight"), "physicsAdd", "physics.addWeight");
    addButton("push", tr("Add push"), "physicsPush", "physics.addPush");
    m_loads->add(row);
}

QWidget *PhysicsDock::makeRules(QWidget *parent)
{
    auto *rules = new PropertyGroup(tr("How strict"), parent);
    auto *safety = new NumberEdit(kSafety, QString());
    safety->setFixedWidth(kFieldWidth);
    connect(safety, &NumberEdit::numberEdited, this, [](double factor) {
        settings().setSafetyFactor(static_cast<int>(std::lround(kTenths * factor)));
    });
    auto *row = new EditorRow(
        tr("Safety factor"), "physicsSafety", safety,
        [safety] { safety->setNumber(settings().safetyFactor() / kTenths); }, rules);
    row->setToolTip(
        tr("How many times its load the model must be able to carry to count as holding"));
    rules->add(row);
    m_rules.push_back(row);
    auto *notch = new NumberEdit(kNotch, QString());
    notch->setFixedWidth(kFieldWidth);
    connect(notch, &NumberEdit::numberEdited, this, [](double factor) {
        settings().setNotchFactor(static_cast<int>(std::lround(kTenths * factor)));
    });
    row = new EditorRow(
        tr("Notch factor, at most"), "physicsNotch", notch,
        [notch] { notch->setNumber(settings().notchFactor() / kTenths); }, rules);
    row->setToolTip(tr("How far stress rises at inner corners follows from the length of the neck, "
                       "up to this factor; slits with round ends need less"));
    rules->add(row);
    m_rules.push_back(row);
    auto *lasting = new QCheckBox(tr("for months"));
    connect(lasting, &QCheckBox::clicked, this, [](bool on) { settings().setLoadLasting(on); });
    row = new EditorRow(
        tr("Loads stay"), "physicsLasting", lasting,
        [lasting] { lasting->setChecked(settings().isLoadLasting()); }, rules);
    row->setToolTip(tr("A stock then holds less, as set for it: acrylic only a quarter"));
    rules->add(row);
    m_rules.push_back(row);
    return rules;
}

void PhysicsDock::addLoadRow(std::size_t index)
{
    const QString id = QStringLiteral("load%1").arg(index);
    const Load load = m_bench.session().model().document.loads[index];
    NumberEdit *amount = load.isPush() ? new NumberEdit(kForce, tr("N")) : new MassEdit(kMass);
    amount->setFixedWidth(kFieldWidth);
    const char *key = load.isPush() ? "force" : "mass";
    const double unit = load.isPush() ? 1.0 : kGrams;
    connect(amount, &NumberEdit::numberEdited, this, [this, index, key, unit](double value) {
        m_bench.run(QStringLiteral("physics.setLoad"),
                    {{"load", std::to_string(index)},
                     {key, QString::number(value / unit, 'g', 17).toStdString()}});
    });
    const QString section = QString::fromStdString(m_bench.session().model().nameOf(load.section));
    auto *row = new EditorRow(
        //: what a weight or a push is called, and the section that it is on
        load.name.empty() ? section : tr("%1, %2").arg(loadName(load), section),
        id.toLatin1().constData(), amount, [this, index, amount, unit] {
            const auto &loads = m_bench.session().model().document.loads;
            if (index < loads.size())
                amount->setNumber(
                    unit * (loads[index].isPush() ? loads[index].push.norm() : loads[index].mass));
        });
    row->giveNameTheRest();
    row->addButton(
        QStringLiteral("trash"), (id + QStringLiteral(".delete")).toLatin1().constData(),
        load.isPush() ? tr("Remove this push") : tr("Remove this weight"), [this, index] {
            m_bench.run(QStringLiteral("physics.removeLoad"), {{"load", std::to_string(index)}});
        });
    m_weights->add(row);
}

void PhysicsDock::refresh()
{
    if (!isVisible())
        return;
    showStressOnce();
    const bool isEmpty = m_bench.session().model().sectionCount() == 0;
    m_held = isEmpty ? nullptr : heldNow(m_bench.session().scheduler());
    m_lines->setChecked(m_bench.interaction().view().showsStress);
    m_lines->setEnabled(!m_bench.commands().whyNot("check.stress"));
    refreshBending();
    m_movement->refresh();
    refreshStrong();
    refreshState();
    refreshLoads();
    refreshPlaces();
    for (PropertyRow *row : m_rules)
        row->refresh();
}

/// How far it has come, while it is worked out.
void PhysicsDock::refreshBending()
{
    const Scheduler &scheduler = m_bench.session().scheduler();
    const bool isOn = settings().bendsSections();
    const bool isRunning = isOn && scheduler.isRunning(kAccurate.name);
    m_bends->setChecked(isOn);
    m_stop->setVisible(isRunning);
    const double share = scheduler.progress(kAccurate.name);
    QString text = tr("finite elements");
    if (isRunning)
        text = share >= 0.0 ? tr("working… %1\u202f%").arg(std::lround(100.0 * share))
                            : tr("working…");
    else if (isOn && scheduler.failureOf(kAccurate.name))
        text = scheduler.failureOf(kAccurate.name)->code == ErrorCode::Cancelled
                   ? tr("stopped")
                   : tr("could not be worked out");
    m_bends->setText(text);
}

/// Of which section it is shown, how far it has come, or why not.
void PhysicsDock::refreshStrong()
{
    const Scheduler &scheduler = m_bench.session().scheduler();
    const std::optional<SectionRef> &section = scheduler.questions().bearing;
    m_strong->setChecked(section.has_value());
    m_strong->setEnabled(!m_bench.commands().whyNot("physics.whereStrong"));
    m_stopStrong->setVisible(section && scheduler.isRunning(kBearing.name));
    const QString state = bearingState(scheduler);
    if (!section)
        m_strong->setText(m_strong->isEnabled() ? tr("the selected section")
                                                : tr("select a section"));
    else
        m_strong->setText(state.isEmpty()
                              ? QString::fromStdString(m_bench.session().model().nameOf(*section))
                              : state);
}

/// What is known, how old it is, and why it is not.
void PhysicsDock::refreshState()
{
    const Scheduler &scheduler = m_bench.session().scheduler();
    const auto say = [&](const char *icon, const QColor &colour, const QString &words) {
        m_stateIcon->setPixmap(tintedPixmap(QLatin1String(icon), 16, colour, devicePixelRatioF()));
        m_state->setText(words);
    };
    if (m_bench.session().model().sectionCount() == 0)
        return say("unknown", theme().muted, tr("Draw a section to see what it can hold."));
    if (scheduler.failureOf(kHolding.name))
        return say("warn", theme().warning, tr("Whether it holds could not be worked out."));
    if (!m_held || scheduler.age(kHolding.name) != Scheduler::Age::Current)
        return say("working", theme().muted, tr("Older than the drawing, working…"));
    const Strength &strength = m_held->strength;
    switch (strength.verdict) {
    case HoldVerdict::Unstable:
        return say("err", theme().problem, tr("It does not stand; no stress is shown."));
    case HoldVerdict::PullsOut:
        return say("err", theme().problem, tr("A joint is pulled open; no stress is shown."));
    case HoldVerdict::NotWorkedOut:
        return say("warn", theme().warning, tr("Whether it holds could not be worked out."));
    case HoldVerdict::NotRated:
        return say("warn", theme().warning,
                   tr("Strength unknown: a stock is not rated. Set its strength under Stocks."));
    case HoldVerdict::Holds:
    case HoldVerdict::BarelyHolds:
    case HoldVerdict::Breaks:
        break;
    }
    if (strength.equilibrium().indeterminacy() > 0 && !strength.isElastic)
        return say("check", theme().good,
                   tr("Up to date. Joints may share the load in many ways; the worst counts."));
    QString words = tr("Up to date. All forces balance.");
    if (const auto bent = bentNow(scheduler); bent && bent->most >= kToldBending)
        //: the state of what is worked out, and a length
        words = tr("%1 Bends %2.").arg(words, lengthText(bent->most, 0, 1, locale()));
    say("check", theme().good, words);
}

void PhysicsDock::refreshLoads()
{
    const Model &model = m_bench.session().model();
    QString what;
    for (const Load &load : model.document.loads)
        what += QStringLiteral("%1 %2 %3\n")
                    .arg(QString::number(load.id.value), QString::fromStdString(load.name),
                         QString::fromStdString(model.nameOf(load.section)));
    m_empty->setVisible(model.document.loads.empty());
    if (m_weights->become(what))
        for (std::size_t i = 0; i < model.document.loads.size(); ++i)
            addLoadRow(i);
    m_weights->refresh();
    for (PropertyRow *row : m_sums)
        row->refresh();
}

std::vector<PhysicsDock::Place> PhysicsDock::weakestPlaces() const
{
    std::vector<Place> places;
    if (!m_held || !areStressesKnown(m_held->strength))
        return places;
    const auto &bodies = m_held->strength.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].corner && bodies[i].cornerUse >= kLeastPlace)
            places.push_back(
                {weakPlaceOf(*m_held->analysis, static_cast<int>(i), *bodies[i].corner),
                 bodies[i].cornerUse});
    std::stable_sort(places.begin(), places.end(),
                     [](const Place &a, const Place &b) { return a.use > b.use; });
    if (places.size() > kMostPlaces)
        places.resize(kMostPlaces);
    return places;
}

void PhysicsDock::refreshPlaces()
{
    m_shown = weakestPlaces();
    m_placesGroup->setVisible(!m_shown.empty());
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        m_places[i]->setVisible(i < m_shown.size());
        if (i >= m_shown.size())
            continue;
        const Model &model = m_held->analysis->model;
        const QString where = QString::fromStdString(model.nameOf(m_shown[i].place.section));
        const QString spot = messageText(spotText(m_shown[i].place, model));
        const QString share = locale().toString(100.0 * m_shown[i].use, 'f', 0);
        m_places[i]->tell(
            //: the name of a section, and a place in it such as "at its neck"
            tr("%1, %2").arg(where, spot), QStringLiteral("%1\u202f%").arg(share),
            stressColour(m_shown[i].use, theme().viewStyle().isForColourBlind),
            //: the name of a section, a place in it such as "at its neck", a number of percent
            tr("%1, %2: %3\u202f%").arg(where, spot, share));
    }
}

bool PhysicsDock::eventFilter(QObject *watched, QEvent *event)
{
    const auto row = std::find(m_places.begin(), m_places.end(), watched);
    const auto index = static_cast<std::size_t>(row - m_places.begin());
    if (row == m_places.end() || index >= m_shown.size())
        return QDockWidget::eventFilter(watched, event);
    if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn)
        Q_EMIT m_bench.weakPlaceAsked(&m_shown[index].place, false);
    else if (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut)
        Q_EMIT m_bench.weakPlaceAsked(nullptr, false);
    else if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            Q_EMIT m_bench.weakPlaceAsked(&m_shown[index].place, true);
            return true;
        }
    }
    return QDockWidget::eventFilter(watched, event);
}

/// With its line and what is known of it; handles of the section would lie over that.
void PhysicsDock::frame(WeakPlace place)
{
    m_bench.run(QStringLiteral("check.stress"), {{"on", "true"}});
    m_bench.select({place.section});
    m_bench.run(QStringLiteral("view.fitSelection"));
    m_bench.select({});
    Q_EMIT m_bench.weakPlaceAsked(&place, true);
}

/// Who opens this to see how the model bears what is on it sees that at once, and turns it off for
/// good.
void PhysicsDock::showStressOnce()
{
    if (m_hasShownStress || m_bench.session().model().document.loads.empty())
        return;
    m_hasShownStress = true;
    m_bench.run(QStringLiteral("check.stress"), {{"on", "true"}});
}

} // namespace fff::ui
