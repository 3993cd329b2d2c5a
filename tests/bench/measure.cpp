#include "tests/bench/measure.h"

#include "core/analysis/checks.h"
#include "core/analysis/plan_checks.h"
#include "core/fabrication/kerf.h"
#include "core/fabrication/marks.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/io/svg_writer.h"
#include "core/operations/evaluate.h"
#include "core/session/kept_models.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/edited_section.h"
#include "tests/bench/gizmo_event.h"
#include "tests/bench/stopwatch.h"

#include <memory>

namespace fff::bench {

namespace {

constexpr double kDragStep = 0.01; // mm; every move is one that no cache has seen
constexpr int kMoves = 9;          // a run
constexpr double kStretch = 3.0;   // mm between which a dragged section goes to and fro

ModelPointer modelOf(Document document, const Model &previous = {})
{
    return std::make_shared<const Model>(evaluate(std::move(document), previous));
}

/// The step as the undo history keeps it: the model after the edit, beside the one before it.
StepMemory memoryOfStep(const ModelPointer &model, SectionId id)
{
    const std::int64_t before = liveBytes();
    ModelPointer after = modelOf(moved(model->document, id, kDragStep), *model);
    StepMemory memory;
    memory.held = liveBytes() - before;
    KeptModels models(0);
    const KeptModelPointer kept = models.keep(std::move(after));
    after = kept->drawn;
    models.clear();
    memory.counted = liveBytes() - before;
    // Objects made shared carry two counters and a table of functions.
    constexpr std::int64_t kShared = 16;
    constexpr std::int64_t kInlineText = 15;
    const Section &changed = *after->document.find(id);
    const auto size = [](const std::string &text) {
        const auto length = static_cast<std::int64_t>(text.size());
        return length > kInlineText ? length + 1 : 0;
    };
    memory.expected =
        static_cast<std::int64_t>(16 * (model->sectionCount() + model->document.stocks.size()) +
                                  sizeof(Section) + sizeof(Model) + sizeof(KeptModel)) +
        3 * kShared + size(changed.name);
    return memory;
}

struct Edits
{
    std::vector<double> drag, edit, undo, anew;
};

/// A drag: each move starts from the committed model, as previews do, and follows the move before.
void measureEdits(const ModelPointer &committed, SectionId id, AnalysisCaches &caches,
                  double &offset, Edits &edits)
{
    prepareDrawing(*analyseNext(*committed, caches));
    for (int i = 0; i < kMoves; ++i) {
        offset = offset < kStretch ? offset + kDragStep : -kStretch;
        double drag = 0.0, follow = 0.0, undo = 0.0;
        const ModelPointer next = timed(
            drag, [&] { return modelOf(moved(committed->document, id, offset), *committed); });
        const auto analysed = [&](const ModelPointer &model) {
            const AnalysisPointer before = caches.last;
            AnalysisPointer result = analyseNext(*model, caches);
            prepareDrawing(*result, before.get());
            return result;
        };
        AnalysisPointer analysis = timed(follow, [&] { return analysed(next); });
        analysis = timed(undo, [&] { return analysed(committed); });
        edits.drag.push_back(drag);
        edits.edit.push_back(drag + follow);
        edits.undo.push_back(undo);
        analysis = analysed(next);
        analysis = timed(edits.anew.emplace_back(),
                         [&] { return analysed(modelOf(committed->document, *next)); });
        analysis = analysed(committed);
    }
}

/// Everything that is said of a model.
class Verdicts
{
public:
    void check(const Analysis &analysis) { checks(analysis, m_checks); }
    void plan(const Analysis &analysis)
    {
        planChecks(analysis, planOf(analysis, m_plans, timeLimit(kPlanningTime)), m_webs);
    }

private:
    CheckCaches m_checks;
    PlanCaches m_plans;
    PlanCheckCaches m_webs;
};

void measureVerdicts(const ModelPointer &model, SectionId id, AnalysisCaches &caches, Timings &t)
{
    AnalysisPointer analysis = analyseNext(*model, caches);
    prepareDrawing(*analysis);
    Verdicts verdicts;
    timed(t.check, [&] {
        verdicts.check(*analysis);
        return 0;
    });
    timed(t.plan, [&] {
        verdicts.plan(*analysis);
        return 0;
    });
    std::vector<double> again;
    for (int i = 1; i <= 3; ++i) {
        analysis = analyseNext(*modelOf(moved(model->document, id, i * kDragStep), *model), caches);
        prepareDrawing(*analysis);
        timed(again.emplace_back(), [&] {
            verdicts.check(*analysis);
            verdicts.plan(*analysis);
            return 0;
        });
    }
    t.again = median(std::move(again));
}

double drawingTime(const Analysis &analysis)
{
    std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    std::vector<Engraving> engravings;
    for (const Part &part : parts)
        engravings.push_back(engrave(part, {}));
    if (auto paths = compensateKerf(parts, analysis.model, analysis.bodies))
        parts = std::move(*paths);
    const Layout layout = layOut(parts, analysis.model, LayoutOptions());
    double milliseconds = 0.0;
    CuttingDrawing drawing; // outlives it, so that the parts are not taken down within
    timed(milliseconds, [&] {
        drawing = cuttingDrawing(layout, std::move(parts), std::move(engravings), analysis.model);
        return io::writeSvg(drawing);
    });
    return milliseconds;
}

} // namespace

Result<Measurement> measure(const std::string &name, const QString &path, int runs, int edited)
{
    Measurement result;
    result.name = name;
    std::vector<Timings> all;
    Edits edits;
    std::vector<PointEvent> points;
    double offset = 0.0;
    for (int run = 0; run < runs; ++run) {
        Timings t;
        Result<io::LoadedDocument> loaded = timed(t.load, [&] { return io::readDocument(path); });
        if (!loaded)
            return tl::unexpected(loaded.error());
        Document document = std::move(loaded->document);
        const ModelPointer model = timed(t.evaluate, [&] { return modelOf(std::move(document)); });
        AnalysisCaches caches;
        Analysis analysis;
        analysis.model = *model;
        analysis.assembly = timed(t.slits, [&] { return assemble(*model); });
        analysis.cuts = timed(t.parts, [&] {
            CutCache cache;
            std::vector<CutSectionPointer> cuts;
            for (std::size_t i = 0; i < model->sectionCount(); ++i)
                cuts.push_back(
                    cutSection(model->section(i)->shape, analysis.assembly.slits[i], cache));
            return cuts;
        });
        const auto file = timed(t.svg, [&] {
            analysis.bodies = bodiesOf(*model, analysis.cuts);
            return io::makeCuttingFile(analysis);
        });
        if (!file)
            return tl::unexpected(file.error());
        t.drawing = drawingTime(analysis);

        const std::vector<int> counts = jointCounts(analysis);
        const int index = edited >= 0 ? edited : middleSection(analysis, counts);
        result.sections = static_cast<int>(model->sectionCount());
        result.joints = static_cast<int>(analysis.assembly.joints.size());
        result.neighbours = counts[static_cast<std::size_t>(index)];
        const SectionId id = model->section(static_cast<std::size_t>(index))->id;
        result.step = memoryOfStep(model, id);
        measureEdits(model, id, caches, offset, edits);
        measureVerdicts(model, id, caches, t);
        t.gizmo = gizmoMove(model->document, id);
        all.push_back(t);
        points.push_back(worstPointEvent(model));
    }
    const auto middle = [&](double Timings::*field) {
        std::vector<double> values;
        for (const Timings &t : all)
            values.push_back(t.*field);
        return median(std::move(values));
    };
    for (double Timings::*field :
         {&Timings::load, &Timings::evaluate, &Timings::slits, &Timings::parts, &Timings::svg,
          &Timings::drawing, &Timings::gizmo, &Timings::check, &Timings::plan, &Timings::again})
        result.milliseconds.*field = middle(field);
    result.milliseconds.drag = median(edits.drag);
    result.milliseconds.edit = median(edits.edit);
    result.milliseconds.undo = median(edits.undo);
    result.milliseconds.anew = median(edits.anew);
    // Of the runs the one in the middle, with the shares of its steps.
    const auto run = points.begin() + (std::ssize(points) - 1) / 2;
    std::nth_element(points.begin(), run, points.end(),
                     [](const auto &a, const auto &b) { return a.sum() < b.sum(); });
    result.point = *run;
    result.milliseconds.point = run->sum();
    return result;
}

} // namespace fff::bench
