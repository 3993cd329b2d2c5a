#include "ui/docks/movement_rows.h"

#include "core/session/scheduler.h"
#include "ui/base/icon.h"
#include "ui/base/lengths.h"
#include "ui/bench/held.h"
#include "ui/bench/workbench.h"
#include "ui/properties/property_rows.h"
#include "ui/settings/settings.h"

#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <cmath>
#include <numbers>

namespace fff::ui {

namespace {

constexpr int kMovementSteps = 100;
constexpr int kMovementFrame = 33;         // ms
constexpr double kMovementPeriod = 2400.0; // ms, there and back
constexpr double kPreciseLength = 0.1;     // mm: less is told to a hundredth

} // namespace

MovementRows::MovementRows(Workbench &bench, PropertyGroup *group) : QObject(group), m_bench(bench)
{
    m_slider = new QSlider(Qt::Horizontal);
    m_slider->setRange(0, kMovementSteps);
    m_slider->setPageStep(kMovementSteps / 10);
    auto *row = new EditorRow(tr("Movement"), "physicsMovement", m_slider, {}, group);
    row->setToolTip(tr("Shows where the model bends or comes loose, larger than it is. Nothing is "
                       "changed."));
    m_play = row->addButton(QStringLiteral("play"), "physicsPlay", tr("Play"),
                            [this] { play(!m_frames.isActive()); });
    group->add(row);
    m_words = new QLabel;
    m_words->setObjectName(QStringLiteral("physicsMovementWords"));
    m_words->setWordWrap(true);
    m_words->setForegroundRole(QPalette::PlaceholderText);
    group->add(m_words);
    // Where a section is strong is shown on the model where it stands.
    const Scheduler &scheduler = bench.session().scheduler();
    connect(&scheduler, &Scheduler::asked, this, [this, &scheduler] {
        if (scheduler.questions().bearing)
            stop();
    });
    m_frames.setInterval(kMovementFrame);
    connect(&m_frames, &QTimer::timeout, this, &MovementRows::advance);
    connect(m_slider, &QSlider::sliderPressed, this, [this] { play(false); });
    connect(m_slider, &QSlider::valueChanged, this, [this](int step) {
        m_bench.setMovement(static_cast<double>(step) / kMovementSteps);
        refresh();
    });
}

void MovementRows::refresh()
{
    const auto movement = movementNow(m_bench.session().scheduler());
    m_slider->setEnabled(movement.has_value());
    m_play->setEnabled(movement && !settings().reducesMotion());
    m_play->setToolTip(settings().reducesMotion() ? tr("Motion is reduced: use the slider")
                       : m_frames.isActive()      ? tr("Pause")
                                                  : tr("Play"));
    if (!movement) {
        m_words->setText(settings().bendsSections()
                             ? tr("It is not known how it moves.")
                             : tr("Turn on “Sections bend” to see how it bends."));
        return;
    }
    const QLocale &locale = m_slider->locale();
    if (movement->isLoose) {
        m_words->setText(tr("Shown as it begins to come apart."));
        return;
    }
    const double times = m_bench.movement() * movement->mostTimes();
    const QString length =
        lengthText(movement->most, 0, movement->most < kPreciseLength ? 2 : 1, locale);
    //: %1 is a length, %2 a number of times
    m_words->setText(times > 0.0 ? tr("Bends %1, shown %2 times as far.")
                                       .arg(length, locale.toString(times, 'g', times < 10 ? 2 : 3))
                                 : tr("Bends %1.").arg(length));
}

void MovementRows::stop()
{
    play(false);
    m_slider->setValue(0);
}

void MovementRows::play(bool on)
{
    if (on == m_frames.isActive() || (on && settings().reducesMotion()))
        return;
    if (on) {
        // From where it is, on outwards.
        const double share = static_cast<double>(m_slider->value()) / kMovementSteps;
        m_began = m_bench.clock().now() -
                  kMovementPeriod / (2.0 * std::numbers::pi) * std::acos(1.0 - 2.0 * share);
        m_frames.start();
    } else {
        m_frames.stop();
    }
    m_play->setIcon(themedIcon(on ? QStringLiteral("pause") : QStringLiteral("play")));
    refresh();
}

void MovementRows::advance()
{
    if (!movementNow(m_bench.session().scheduler()))
        return play(false);
    const double turn =
        2.0 * std::numbers::pi * (m_bench.clock().now() - m_began) / kMovementPeriod;
    m_slider->setValue(
        static_cast<int>(std::lround(kMovementSteps * 0.5 * (1.0 - std::cos(turn)))));
}

} // namespace fff::ui
