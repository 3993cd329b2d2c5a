#include "ui/bench/stress_picture.h"

#include "core/session/scheduler.h"
#include "ui/bench/held.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"

#include <QGuiApplication>
#include <QStyleHints>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kCardDelay = 400;  // ms that the cursor rests before a card comes
constexpr double kTenths = 10.0; // that the settings have factors in

} // namespace

StressPicture::StressPicture(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kCardDelay);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_marks.hasCard = m_marks.lit >= 0;
        Q_EMIT changed();
    });
    const auto tell = [this] {
        if (m_bench.interaction().view().showsStress)
            Q_EMIT changed();
    };
    connect(&bench.session().scheduler(), &Scheduler::published, this,
            [tell](std::string_view stage) {
                if (isOfHolding(stage))
                    tell();
            });
    connect(&bench.session().scheduler(), &Scheduler::aged, this, tell);
    connect(&bench, &Workbench::weakPlaceAsked, this, &StressPicture::ask);
    connect(&settings(), &Settings::checksChanged, this, [this, tell] {
        m_held = nullptr; // what is shown of it is another part
        tell();
    });
}

const StressMarks *StressPicture::marks()
{
    const Scheduler &scheduler = m_bench.session().scheduler();
    const auto held = heldNow(scheduler);
    const Interaction &interaction = m_bench.interaction();
    // Of what is only tried it is not known: what is there would be shown on that.
    if (!interaction.view().showsStress || !held || m_bench.tried() ||
        m_bench.session().model().sectionCount() == 0)
        return nullptr;
    if (held != m_held) {
        m_held = held;
        m_isKept = m_hasWeaker = false;
        m_marks = stressMarksOf(held->analysis, held->strength, 0.01 * settings().stressShown());
        m_marks.safety = settings().safetyFactor() / kTenths;
        m_marks.bent = bentNow(scheduler);
        m_feet = footForces(held->strength);
    }
    m_marks.isOlder = scheduler.age(kHolding.name) != Scheduler::Age::Current;
    m_marks.forces = m_feet;
    // Those at joints of the section that is chosen, or else under the cursor.
    const Model &model = held->analysis->model;
    int section = interaction.hovered().section;
    if (!interaction.selection().empty())
        section = model.indexOf(interaction.selection().front());
    if (section >= 0 && section < static_cast<int>(model.sectionCount()))
        for (const ForceMark &mark : jointForces(*held->analysis, held->strength, section))
            m_marks.forces.push_back(mark);
    return &m_marks;
}

void StressPicture::hover(const QPointF &point, const Vec2 &viewport)
{
    const Interaction &interaction = m_bench.interaction();
    const bool isAsking =
        interaction.view().showsStress && m_held && !interaction.hasGesture() && !m_marks.isOlder;
    light(isAsking ? lineAt(point, m_marks, interaction.camera(), viewport, interaction.view())
                   : -1);
}

void StressPicture::leave()
{
    light(-1);
}

void StressPicture::press(const QPointF &point)
{
    m_pressed = m_marks.lit;
    m_pressedAt = point;
    light(-1);
}

void StressPicture::release(const QPointF &point)
{
    const int pressed = std::exchange(m_pressed, -1);
    if ((point - m_pressedAt).manhattanLength() >=
        QGuiApplication::styleHints()->startDragDistance())
        return;
    if (m_isKept)
        return close();
    if (pressed < 0 || pressed >= static_cast<int>(m_marks.lines.size()))
        return;
    keep(pressed);
}

void StressPicture::keep(int line)
{
    m_isKept = true;
    m_marks.lit = line;
    m_marks.hasCard = true;
    Q_EMIT changed();
}

/// A list beside the view asks: its line is the one with the same ends. One that is strained by
/// less than what is shown is there as long as it is asked about.
void StressPicture::ask(const WeakPlace *place, bool opensCard)
{
    const bool isShown = marks() != nullptr; // they may only now be wanted
    if (place && opensCard)
        close(); // of another one
    const auto indexIn = [place](const std::vector<StressLine> &lines) {
        const auto found = std::find_if(lines.begin(), lines.end(), [&](const StressLine &line) {
            return line.from == place->from && line.to == place->to;
        });
        return found == lines.end() ? -1 : static_cast<int>(found - lines.begin());
    };
    int line = place ? indexIn(m_marks.lines) : -1;
    if (place && line < 0 && isShown && !m_isKept) {
        dropWeaker();
        const std::vector<StressLine> all = stressLines(*m_held->analysis, m_held->strength, 0.0);
        if (const int weaker = indexIn(all); weaker >= 0) {
            m_marks.lines.insert(m_marks.lines.begin(), all[static_cast<std::size_t>(weaker)]);
            m_marks.lit += m_marks.lit >= 0 ? 1 : 0;
            m_hasWeaker = true;
            line = 0;
        }
    }
    if (!opensCard)
        light(line);
    else if (line >= 0)
        keep(line);
    m_rest.stop(); // the card comes when it is opened
}

void StressPicture::close()
{
    if (std::exchange(m_isKept, false))
        light(-1);
}

void StressPicture::dropWeaker()
{
    if (!std::exchange(m_hasWeaker, false))
        return;
    m_marks.lines.erase(m_marks.lines.begin()); // they are in order
    m_marks.lit = std::max(m_marks.lit - 1, -1);
}

void StressPicture::light(int line)
{
    if (line == m_marks.lit || m_isKept)
        return;
    m_marks.lit = line;
    m_marks.hasCard = false;
    if (line != 0)
        dropWeaker();
    line < 0 ? m_rest.stop() : m_rest.start();
    Q_EMIT changed();
}

} // namespace fff::ui
