#include "tests/bench/adjust_cost.h"

#include "core/analysis/analysis.h"
#include "core/analysis/ranged_values.h"
#include "core/io/document_file.h"
#include "core/operations/driven.h"
#include "core/operations/evaluate.h"
#include "tests/bench/generated_models.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/text_table.h"

#include <QDir>
#include <QTextStream>

#include <utility>

namespace fff::bench {

namespace {

constexpr int kSliderMoves = 21;

/// The model before the next move, and what is known of it.
struct Adjusted
{
    Model model;
    AnalysisCaches caches;
};

struct MoveTimes
{
    double model = 0.0, event = 0.0; // ms
};

MoveTimes moveTimes(Adjusted &now, const std::vector<RangedValue> &values, const TrialPlace &place)
{
    MoveTimes times;
    Model next = timed(times.model, [&] {
        return evaluate(placed(now.model.document, values, place).value(), now.model);
    });
    double analysis = 0.0;
    timed(analysis, [&] { return analyseNext(next, now.caches); });
    times.event = times.model + analysis;
    now.model = std::move(next);
    return times;
}

/// The middle ones of a slider's moves from end to end; the others stay.
MoveTimes sliderTimes(const Model &model, const std::vector<RangedValue> &values, std::size_t which)
{
    Adjusted now;
    now.model = model;
    analyseNext(now.model, now.caches);
    TrialPlace place;
    for (const RangedValue &value : values)
        place.push_back(value.now(model));
    const RangedValue &moved = values[which];
    std::vector<double> models, events;
    for (int i = 0; i < kSliderMoves; ++i) {
        place[which] =
            moved.settable(moved.least + (moved.most - moved.least) * i / (kSliderMoves - 1.0));
        const MoveTimes times = moveTimes(now, values, place);
        models.push_back(times.model);
        events.push_back(times.event);
    }
    return {median(std::move(models)), median(std::move(events))};
}

/// Nothing of a model without values to adjust.
std::optional<AdjustCost> adjustCost(const std::string &name, const Model &model,
                                     const std::optional<Kernel> &kernel)
{
    const std::vector<RangedValue> values = rangedValues(model);
    if (values.empty())
        return std::nullopt;
    AdjustCost cost;
    cost.name = name;
    cost.sections = static_cast<int>(model.sectionCount());
    const double before = kernel ? kernel->run() : 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const MoveTimes times = sliderTimes(model, values, i);
        if (times.event <= cost.event)
            continue;
        cost.slider = values[i].name;
        cost.model = times.model;
        cost.event = times.event;
    }
    cost.kernel = kernel ? 0.5 * (before + kernel->run()) : 0.0;
    return cost;
}

/// The number of the place follows a value of that name, which is what it is, more or less.
Document withDriving(Document document, const char *name, const std::string &key)
{
    const DrivenPlace place = placeOfKey(document, key).value();
    const double now = drivenNumber(document, place).value().worth.number;
    Value value;
    value.name = name;
    value.kind = ValueKind::Length;
    value.typed = std::to_string(now) + " mm";
    value.range = {0.8 * now, 1.2 * now, std::nullopt};
    value.isShown = true;
    document = addValue(std::move(document), std::move(value)).value();
    return bound(std::move(document), place, name).value();
}

/// 50 ribs along a spine by an operation, whose thickness, width and height are values.
Document drivenReplicas()
{
    Document document = repeated("linear", false, false);
    const std::string rib = "section/" + std::to_string(document.sections[1]->id.value);
    const std::string stock = "stock/" + std::to_string(document.sections[1]->stock.value);
    document = withDriving(std::move(document), "thick", stock + "/thickness");
    document = withDriving(std::move(document), "wide", rib + "/width");
    return withDriving(std::move(document), "high", rib + "/height");
}

} // namespace

Result<std::vector<AdjustCost>> adjustCosts(const QStringList &folders,
                                            const std::optional<Kernel> &kernel)
{
    std::vector<AdjustCost> costs;
    costs.push_back(adjustCost("50 replicas", evaluate(drivenReplicas()), kernel).value());
    for (const QString &folder : folders)
        for (const QFileInfo &file :
             QDir(folder, QStringLiteral("*.fff")).entryInfoList(QDir::Files, QDir::Name)) {
            const Result<io::LoadedDocument> loaded = io::readDocument(file.filePath());
            if (!loaded)
                return tl::unexpected(loaded.error());
            std::optional<AdjustCost> cost = adjustCost(file.completeBaseName().toStdString(),
                                                        evaluate(loaded->document), kernel);
            if (!cost)
                continue;
            QTextStream(stderr) << file.completeBaseName() << Qt::endl;
            costs.push_back(*std::move(cost));
        }
    return costs;
}

std::string adjustTable(const std::vector<AdjustCost> &costs)
{
    if (costs.empty())
        return {};
    const bool inKernels = costs.front().kernel > 0.0;
    std::vector<TableRow> rows{{"", "sections", "slider", "model", "event"}};
    for (const AdjustCost &cost : costs) {
        const double unit = inKernels ? cost.kernel : 1.0;
        rows.push_back({cost.name, std::to_string(cost.sections), cost.slider,
                        fixed(cost.model / unit, 4), fixed(cost.event / unit, 4)});
    }
    return aligned(
        std::string("A move of a slider, in ") + (inKernels ? "kernels" : "milliseconds"), rows);
}

} // namespace fff::bench
