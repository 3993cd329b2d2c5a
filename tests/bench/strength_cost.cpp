#include "tests/bench/strength_cost.h"

#include "core/analysis/strength.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/bench/edited_section.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/text_table.h"

#include <array>
#include <functional>
#include <limits>

namespace fff::bench {

namespace {

constexpr double kEditStep = 0.01; // mm; every edit is one that no cache has seen
/// Flexibilities of bodies with so many joints take minutes.
constexpr int kMostBendingJoints = 500;

/// Of several times what was not held up.
double shortest(int runs, const std::function<double()> &once)
{
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run)
        least = std::min(least, once());
    return least;
}

/// One equilibrium of rigid bodies and its stresses.
Strength rigidStrength(const Analysis &analysis, StrengthCaches &caches)
{
    const StrengthRules rules;
    Strength strength;
    strength.made = structureOf(analysis);
    strength.envelope = {
        solveEquilibrium(strength.made.structure, rules.support, caches.equilibria)};
    addStresses(analysis, rules, caches, strength);
    return strength;
}

template <class Work>
double timeOf(Work &&work)
{
    double milliseconds = 0.0;
    timed(milliseconds, std::forward<Work>(work));
    return milliseconds;
}

std::vector<SectionCuts> cutsOfAll(const Analysis &analysis)
{
    std::vector<SectionCuts> cuts;
    for (int i = 0; i < static_cast<int>(analysis.bodies.size()); ++i)
        cuts.emplace_back(PieceShape(analysis.bodies.at(i).outline().region, slitsOf(analysis, i)));
    return cuts;
}

/// The next of a row of models that each have one section moved.
class EditedModels
{
public:
    EditedModels(const Model &model, SectionId section) : m_model(model), m_section(section) {}

    AnalysisPointer first() { return analyseNext(m_model, m_caches); }
    AnalysisPointer next()
    {
        m_offset += kEditStep;
        return analyseNext(evaluate(moved(m_model.document, m_section, m_offset), m_model),
                           m_caches);
    }

private:
    const Model &m_model;
    SectionId m_section;
    AnalysisCaches m_caches;
    double m_offset = 0.0;
};

/// What `strain` takes after an edit, when it has seen the model before that.
template <class Strain>
double timeAfterEdit(EditedModels &models, int runs, Strain strain)
{
    StrengthCaches caches;
    strain(*models.first(), caches);
    return shortest(runs, [&] {
        const AnalysisPointer analysis = models.next();
        return timeOf([&] { return strain(*analysis, caches); });
    });
}

std::optional<double> bendingTime(const Analysis &analysis, int runs)
{
    StrengthRules rules;
    rules.isElastic = true;
    StrengthCaches caches;
    if (static_cast<int>(analysis.assembly.joints.size()) > kMostBendingJoints ||
        !forcesIn(analysis, rules, caches).isElastic)
        return std::nullopt;
    return shortest(runs,
                    [&] { return timeOf([&] { return forcesIn(analysis, rules, caches); }); });
}

struct StrengthColumn
{
    const char *name;
    double StrengthCost::*field;
};

constexpr std::array<StrengthColumn, 7> kStrengthColumns{
    {{"structure", &StrengthCost::structure},
     {"forces", &StrengthCost::forces},
     {"cuts", &StrengthCost::cuts},
     {"rigid", &StrengthCost::rigid},
     {"envelope", &StrengthCost::envelope},
     {"edited", &StrengthCost::edited},
     {"envelope, edited", &StrengthCost::envelopeEdited}}};

std::string costTable(const std::vector<StrengthCost> &rows, const std::optional<Peer> &peer,
                      bool inKernels)
{
    std::vector<TableRow> table{{"model", "sections", "joints", "edited has"}};
    for (const StrengthColumn &column : kStrengthColumns)
        table.front().emplace_back(column.name);
    table.front().emplace_back("bent");
    if (inKernels && peer)
        table.front().insert(table.front().end(), {"old program", "rigid/old"});
    for (const StrengthCost &row : rows) {
        const double unit = inKernels ? row.kernel : 1.0;
        if (!(unit > 0.0))
            continue;
        const int decimals = inKernels ? 4 : 2;
        TableRow cells{row.name, std::to_string(row.sections), std::to_string(row.joints),
                       std::to_string(row.neighbours)};
        for (const StrengthColumn &column : kStrengthColumns)
            cells.push_back(fixed(row.*column.field / unit, decimals));
        cells.push_back(row.bent ? fixed(*row.bent / unit, decimals) : std::string("-"));
        const PeerRow *old = inKernels && peer ? peer->find(row.name) : nullptr;
        if (old && old->physics > 0.0) {
            const double oldKernels = old->physics / peer->kernel;
            cells.push_back(fixed(oldKernels, 2));
            cells.push_back(fixed(row.rigid / unit / oldKernels, 4));
        }
        table.push_back(std::move(cells));
    }
    return aligned(inKernels ? "Whether it holds, kernels"
                             : "Whether it holds, milliseconds of CPU time of one thread",
                   table);
}

std::string costGrowthTable(const std::vector<StrengthCost> &rows)
{
    std::vector<TableRow> table{{"model", "sections ×", "joints ×"}};
    for (const StrengthColumn &column : kStrengthColumns)
        table.front().emplace_back(std::string(column.name) + " ×");
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const StrengthCost &row = rows[i], &before = rows[i - 1];
        if (familyOf(row.name).empty() || familyOf(row.name) != familyOf(before.name))
            continue;
        const double kernels = row.kernel > 0.0 ? row.kernel / before.kernel : 1.0;
        TableRow cells{row.name, fixed(static_cast<double>(row.sections) / before.sections, 1),
                       fixed(static_cast<double>(row.joints) / before.joints, 1)};
        for (const StrengthColumn &column : kStrengthColumns)
            cells.push_back(fixed(row.*column.field / (before.*column.field) / kernels, 1));
        table.push_back(std::move(cells));
    }
    return aligned("Growth: times the model before", table);
}

} // namespace

Result<StrengthCost> strengthCost(const std::string &name, const QString &path, int runs,
                                  int edited)
{
    Result<io::LoadedDocument> loaded = io::readDocument(path);
    if (!loaded)
        return tl::unexpected(loaded.error());
    const Model model = evaluate(std::move(loaded->document));
    AnalysisCaches analysisCaches;
    const Analysis analysis = analyse(model, analysisCaches);
    const std::vector<int> counts = jointCounts(analysis);
    const int index = edited >= 0 ? edited : middleSection(analysis, counts);

    StrengthCost cost;
    cost.name = name;
    cost.sections = static_cast<int>(model.sectionCount());
    cost.joints = static_cast<int>(analysis.assembly.joints.size());
    cost.neighbours = counts[static_cast<std::size_t>(index)];
    const StrengthRules rules;
    const auto rigid = [](const Analysis &of, StrengthCaches &caches) {
        return rigidStrength(of, caches);
    };
    const auto enveloped = [&rules](const Analysis &of, StrengthCaches &caches) {
        return strengthOf(of, rules, caches);
    };
    const auto anew = [&](auto strain) {
        return shortest(runs, [&] {
            StrengthCaches caches;
            return timeOf([&] { return strain(analysis, caches); });
        });
    };
    // What bodies and cut sections work out when they are first asked is not of what holds.
    const ModelStructure made = structureOf(analysis);
    cost.structure = shortest(runs, [&] { return timeOf([&] { return structureOf(analysis); }); });
    cost.forces = shortest(runs, [&] {
        return timeOf([&] { return solveEquilibrium(made.structure, rules.support); });
    });
    cost.cuts = shortest(runs, [&] { return timeOf([&] { return cutsOfAll(analysis); }); });
    cost.rigid = anew(rigid);
    cost.envelope = anew(enveloped);
    EditedModels models(model, model.section(static_cast<std::size_t>(index))->id);
    cost.edited = timeAfterEdit(models, runs, rigid);
    cost.envelopeEdited = timeAfterEdit(models, runs, enveloped);
    cost.bent = bendingTime(analysis, runs);
    return cost;
}

std::string strengthTables(const std::vector<StrengthCost> &rows, const std::optional<Peer> &peer)
{
    std::string out = costTable(rows, peer, false);
    if (std::any_of(rows.begin(), rows.end(), [](const auto &row) { return row.kernel > 0.0; }))
        out += costTable(rows, peer, true);
    return out + costGrowthTable(rows);
}

} // namespace fff::bench
