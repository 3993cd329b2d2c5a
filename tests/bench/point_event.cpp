#include "tests/bench/point_event.h"

#include "core/analysis/checks.h"
#include "core/model/edits.h"
#include "core/model/point_edits.h"
#include "core/operations/evaluate.h"
#include "tests/bench/stopwatch.h"
#ifdef FFF_BENCH_VIEW
#include "ui/view/scene.h"
#include "ui/view/slab_mesh.h"
#endif

#include <algorithm>
#include <set>

namespace fff::bench {

namespace {

using ModelPointer = std::shared_ptr<const Model>;

constexpr int kMoves = 7;            // of each point
constexpr int kPoints = 4;           // of each boundary that is tried
constexpr double kStep = 0.0137;     // mm, each
constexpr std::size_t kSections = 8; // that are tried

/// What the window does with an analysis until something can be uploaded.
class Drawing
{
public:
    void show(const AnalysisPointer &analysis)
    {
#ifdef FFF_BENCH_VIEW
        m_builder.setAnalysis(analysis);
        ui::Scene scene = m_builder.build(analysis->model);
        ui::applyView(scene, analysis->model, {});
        std::vector<Uploaded> used;
        used.reserve(scene.sections.size());
        for (const ui::SceneSection &section : scene.sections)
            used.push_back({section.cut.get(), section.covers.get(), &section});
        std::sort(used.begin(), used.end(), isBefore);
        used.erase(std::unique(used.begin(), used.end(), isSame), used.end());
        for (const Uploaded &item : used)
            if (!std::binary_search(m_uploaded.begin(), m_uploaded.end(), item, isBefore))
                m_vertices += ui::meshOf(*item.section).vertices.size();
        m_uploaded = std::move(used);
        m_shown = std::move(scene);
#else
        m_shown = analysis;
#endif
    }

private:
#ifdef FFF_BENCH_VIEW
    /// Sections that look alike share it.
    struct Uploaded
    {
        const void *cut = nullptr, *covers = nullptr;
        const ui::SceneSection *section = nullptr; // one of them, in the newest scene
    };
    static bool isSame(const Uploaded &a, const Uploaded &b)
    {
        return a.cut == b.cut && a.covers == b.covers;
    }
    static bool isBefore(const Uploaded &a, const Uploaded &b)
    {
        return std::pair(a.cut, a.covers) < std::pair(b.cut, b.covers);
    }

    ui::SceneBuilder m_builder;
    ui::Scene m_shown; // keeps what its addresses say
    std::vector<Uploaded> m_uploaded;
    std::size_t m_vertices = 0; // so that the work is not left out
#else
    AnalysisPointer m_shown;
#endif
};

/// What a person may drag.
struct Target
{
    std::size_t section = 0;
    PointAddress point;
    bool isHandle = false;
};

Result<ShapePointer> dragged(const Shape &shape, const Target &target, double offset)
{
    const Vec2 by = offset * Vec2(0.6, 0.8);
    const std::vector<PointAddress> points{target.point};
    if (!target.isHandle)
        return movedPoints(shape, points, by);
    const Contour &contour = boundary(shape, target.point.boundary);
    return movedHandle(shape, target.point, HandleSide::Out,
                       handle(contour, target.point.index, HandleSide::Out) + by, false);
}

/// Of one session: every move starts from the committed model, and what is worked out for it from
/// the move before.
class Dragging
{
public:
    explicit Dragging(ModelPointer committed) : m_committed(std::move(committed))
    {
        m_analysis = analyseNext(*m_committed, m_caches);
        prepareDrawing(*m_analysis);
        checks(*m_analysis, m_checks);
        m_drawing.show(m_analysis);
    }

    /// Nothing where the shape would not be whole.
    std::optional<PointEvent> move(const Target &target)
    {
        PointEvent event;
        const SectionPointer &section = m_committed->section(target.section);
        m_offset += kStep;
        const ModelPointer next = timed(event.shape, [&]() -> ModelPointer {
            const auto shape = dragged(*section->shape, target, m_offset);
            if (!shape)
                return nullptr;
            return std::make_shared<const Model>(
                evaluate(*setShape(m_committed->document, section->id, *shape), *m_committed));
        });
        if (!next)
            return std::nullopt;
        // As analyseNext does it, with a look at the watch in between.
        Assembly assembly = timed(
            event.slits, [&] { return assemble(*next, m_analysis->model, m_analysis->assembly); });
        double all = 0.0;
        const AnalysisPointer analysis = timed(all, [&] {
            AnalysisPointer result = analyseNext(*next, m_caches);
            prepareDrawing(*result);
            return result;
        });
        event.parts = std::max(all - event.slits, 0.0);
        timed(event.checks, [&] { return checks(*analysis, m_checks); });
        timed(event.arrays, [&] {
            m_drawing.show(analysis);
            return 0;
        });
        event.section = static_cast<int>(target.section);
        for (std::size_t i = 0; i < analysis->cuts.size(); ++i)
            event.touched += analysis->cuts[i] != m_analysis->cuts[i] ? 1 : 0;
        m_analysis = analysis;
        return event;
    }

private:
    ModelPointer m_committed;
    AnalysisCaches m_caches;
    AnalysisPointer m_analysis;
    CheckCaches m_checks;
    Drawing m_drawing;
    double m_offset = 0.0; // mm
};

std::vector<std::size_t> sectionsToTry(const Model &model, const Assembly &assembly)
{
    std::vector<std::size_t> all(model.drawnCount());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    std::set<std::size_t> tried;
    const auto addBest = [&](auto key) {
        std::sort(all.begin(), all.end(),
                  [&](std::size_t a, std::size_t b) { return key(a) > key(b); });
        tried.insert(all.begin(), all.begin() + std::min<std::ptrdiff_t>(2, std::ssize(all)));
        tried.insert(all[all.size() / 2]);
    };
    addBest([&](std::size_t i) { return assembly.slits[i].size(); });
    addBest([&](std::size_t i) { return model.section(i)->shape->controlPointCount(); });
    addBest([&](std::size_t i) { return model.section(i)->shape->area(); });
    while (tried.size() > kSections)
        tried.erase(std::prev(tried.end()));
    return {tried.begin(), tried.end()};
}

std::vector<Target> targetsOf(const Shape &shape, std::size_t section)
{
    std::vector<Target> targets;
    for (int b = 0; b < std::min(boundaryCount(shape), 2); ++b) {
        const int count = boundary(shape, b).segmentCount();
        for (int k = 0; k < std::min(kPoints, count); ++k)
            targets.push_back({section, {b, k * count / std::min(kPoints, count)}, false});
        targets.push_back({section, {b, count / 2}, true});
    }
    return targets;
}

PointEvent median(std::vector<PointEvent> events)
{
    const auto middle = events.begin() + std::ssize(events) / 2;
    std::nth_element(events.begin(), middle, events.end(),
                     [](const PointEvent &a, const PointEvent &b) { return a.sum() < b.sum(); });
    return *middle;
}

} // namespace

PointEvent worstPointEvent(const ModelPointer &model)
{
    PointEvent worst;
    if (model->sectionCount() == 0)
        return worst;
    Dragging dragging(model);
    for (const std::size_t section : sectionsToTry(*model, assemble(*model))) {
        for (const Target &target : targetsOf(*model->section(section)->shape, section)) {
            std::vector<PointEvent> events;
            for (int i = 0; i < kMoves; ++i)
                if (const auto event = dragging.move(target))
                    events.push_back(*event);
            if (events.empty())
                continue;
            if (const PointEvent event = median(std::move(events)); event.sum() > worst.sum())
                worst = event;
        }
    }
    return worst;
}

} // namespace fff::bench
