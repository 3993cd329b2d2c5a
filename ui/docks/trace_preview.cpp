#include "ui/docks/trace_preview.h"

#include "ui/bench/workbench.h"

#include <utility>

namespace fff::ui {

namespace {

constexpr double kShownChord = 0.1; // px of the picture
/// More places are not drawn: of a photograph the largest regions say enough.
constexpr std::size_t kMostShownPlaces = 40'000;

std::shared_ptr<const std::vector<Polygon>> shownLines(const TracedPicture &traced)
{
    auto lines = std::make_shared<std::vector<Polygon>>();
    std::size_t places = 0;
    for (const CurvePath &line : traced.lines) {
        Polygon flat = line.flatten(kShownChord);
        places += flat.size();
        if (places > kMostShownPlaces && !lines->empty())
            break;
        lines->push_back(std::move(flat));
    }
    return lines;
}

} // namespace

TracePreview::TracePreview(Workbench &bench, QObject *parent)
    : QObject(parent), m_bench(&bench),
      m_job(
          [tracer = std::make_shared<PictureTracer>()](const Asked &asked) -> Seen {
              if (!asked.picture) {
                  *tracer = {};
                  return {};
              }
              const auto traced = tracer->traced(asked.picture, asked.trace, {asked.stop, {}});
              return traced ? Seen{*traced, shownLines(**traced)} : Seen{};
          },
          [this](std::uint64_t revision, Seen seen) { take(revision, std::move(seen)); })
{
}

TracePreview::~TracePreview()
{
    m_stop.request_stop();
}

void TracePreview::ask(TemplatePicturePointer picture, const PictureTrace &trace)
{
    m_stop.request_stop();
    m_stop = {};
    m_job.request(++m_revision, {std::move(picture), trace, m_stop.get_token()});
}

void TracePreview::show(const Template &one, const PictureTrace &trace)
{
    const bool isSeen = m_seen.traced && m_seen.traced->picture == one.picture;
    if (std::exchange(m_of, one.id) != one.id || !isSeen)
        m_bench->setTraced(m_of, isSeen ? m_seen.lines : nullptr);
    if (m_picture == one.picture && m_trace == trace)
        return;
    m_picture = one.picture;
    m_trace = trace;
    ask(m_picture, trace);
    Q_EMIT changed();
}

void TracePreview::hide()
{
    if (!m_picture)
        return;
    m_picture.reset();
    m_seen = {};
    ask({}, {});
    if (m_bench)
        m_bench->setTraced({}, nullptr);
}

TracedPicturePointer TracePreview::known(const Template &one, const PictureTrace &trace) const
{
    return m_seen.traced && m_seen.traced->isOf(one, trace) ? m_seen.traced : nullptr;
}

void TracePreview::take(std::uint64_t revision, Seen seen)
{
    if (revision != m_revision || !m_picture || !m_bench)
        return; // of other numbers
    m_seen = std::move(seen);
    m_bench->setTraced(m_of, m_seen.lines);
    Q_EMIT changed();
}

} // namespace fff::ui
