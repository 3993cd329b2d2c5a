#include "ui/tour/tour.h"

#include "core/base/units.h"
#include "ui/bench/workbench.h"

#include <algorithm>

namespace fff::ui {

namespace {

/// Turned or zoomed by so much, somebody has tried it.
const double kTurned = radians(12.0);
constexpr double kZoomed = 1.25;
/// mm, of a section that the next steps can be done with: less is a slip of the hand, or no room
/// for a slit.
constexpr double kLeastLong = 40.0, kLeastWide = 15.0;

bool isLargeEnough(const Section &section)
{
    const Vec2 size = section.shape->bounds().size();
    return std::max(size.x(), size.y()) >= kLeastLong && std::min(size.x(), size.y()) >= kLeastWide;
}

/// One that was drawn across another one.
bool hasCross(const Model &model)
{
    return std::any_of(
        model.sections().begin(), model.sections().end(),
        [](const SectionPointer &section) { return section->parent && isLargeEnough(*section); });
}

std::vector<double> thicknessesOf(const Document &document)
{
    std::vector<double> all;
    for (const auto &stock : document.stocks)
        all.push_back(stock->thickness);
    return all;
}

} // namespace

const Section *bodyOf(const Model &model)
{
    for (const SectionPointer &section : model.sections())
        if (isLargeEnough(*section))
            return section.get();
    return nullptr;
}

Tour::Tour(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    connect(&bench.session(), &Session::committedChanged, this, &Tour::followModel);
    connect(&bench.session(), &Session::replaced, this, &Tour::end);
    connect(&bench, &Workbench::viewChanged, this, &Tour::followView);
}

void Tour::begin(bool canRepeat)
{
    m_steps = {Step::Draw, Step::Cross, Step::Turn, Step::Thickness, Step::Check};
    if (canRepeat)
        m_steps.push_back(Step::Repeat);
    m_steps.push_back(Step::Export);
    m_isOn = true;
    m_hadBody = false;
    m_done.clear();
    m_skipped.clear();
    m_at = 0;
    m_camera.reset();
    const Document &document = m_bench.session().committed().document;
    m_operations = document.operations.size();
    m_thicknesses = thicknessesOf(document);
    Q_EMIT changed();
    followModel();
}

void Tour::end()
{
    if (std::exchange(m_isOn, false))
        Q_EMIT changed();
}

void Tour::skip()
{
    if (!m_isOn || isDone())
        return;
    m_hadBody = false;
    m_done.insert(m_steps[m_at]);
    m_skipped.insert(m_steps[m_at]);
    goOn();
}

void Tour::leaveOutRepeat()
{
    const auto repeat = std::find(m_steps.begin(), m_steps.end(), Step::Repeat);
    if (!m_isOn || isDone() || repeat == m_steps.end())
        return;
    if (repeat - m_steps.begin() < static_cast<std::ptrdiff_t>(m_at))
        --m_at;
    m_steps.erase(repeat);
    Q_EMIT changed();
}

bool Tour::lacksBody() const
{
    return m_hadBody && !bodyOf(m_bench.session().committed());
}

Tour::Step Tour::step() const
{
    return lacksBody() ? Step::Draw : m_steps[m_at];
}

bool Tour::isWaitingForSections() const
{
    return m_isOn && !isDone() && (step() == Step::Draw || step() == Step::Cross);
}

bool Tour::isTooSmall() const
{
    const Model &model = m_bench.session().committed();
    return isWaitingForSections() && model.drawnCount() > 0 &&
           !isLargeEnough(*model.section(model.drawnCount() - 1));
}

int Tour::number() const
{
    return !isDone() && lacksBody() ? 0 : static_cast<int>(m_at);
}

void Tour::did(Step what)
{
    if (!m_isOn || isDone())
        return;
    m_skipped.erase(what);
    if (m_done.insert(what).second)
        goOn();
}

/// To the first step that is not done yet.
void Tour::goOn()
{
    const std::size_t before = m_at;
    while (m_at < m_steps.size() && m_done.contains(m_steps[m_at]))
        ++m_at;
    if (m_at == before)
        return;
    m_camera.reset();
    Q_EMIT changed();
}

void Tour::followModel()
{
    if (!m_isOn)
        return;
    if (isDone()) { // who goes on has read the last words
        end();
        return;
    }
    const Model &model = m_bench.session().committed();
    const std::size_t before = m_at;
    if (bodyOf(model)) {
        m_hadBody = true;
        did(Step::Draw);
    }
    if (hasCross(model))
        did(Step::Cross);
    if (thicknessesOf(model.document) != m_thicknesses)
        did(Step::Thickness);
    if (model.document.operations.size() > m_operations)
        did(Step::Repeat);
    if (m_at == before)
        Q_EMIT changed(); // the body may be gone, or back
}

void Tour::followView()
{
    if (!m_isOn || isDone() || step() != Step::Turn)
        return;
    const Interaction &interaction = m_bench.interaction();
    const Camera &now = interaction.camera();
    // What turns by itself, as behind a stroke, was nobody's hand.
    if (interaction.isAnimating() || !m_camera) {
        m_camera = now;
        return;
    }
    const double scale = now.millimetresPerPixel / m_camera->millimetresPerPixel;
    if (now.orientation.angularDistance(m_camera->orientation) > kTurned ||
        std::max(scale, 1.0 / scale) > kZoomed)
        did(Step::Turn);
}

} // namespace fff::ui
