// Equilibrium against the reference cases: a program of its own, for any folder of such cases.
//     tst_reference_cases [--cases DIR]
// Prints quantity, truth, ours and their ratio; 1 when anything is outside its tolerance, 2 when
// cases cannot be read.
#include "tests/core/physics/reference_case.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace fff;
using namespace fff::test;

namespace {

QString key(const char *name)
{
    return QString::fromLatin1(name);
}

/// What may lie between truth and ours; the index's defaults.
struct Tolerances
{
    double mass = 1e-3;     // share
    double centre = 0.1;    // mm
    double reaction = 1e-3; // share of the largest, of determinate structures
    double wrench = 1e-3;   // "
    double resultant = 0.5; // mm; margins too
    double equilibrium = 1e-9;
    bool isDeterminate = false, isIndeterminate = false; // the index says so
};

Tolerances tolerancesOf(const QJsonObject &entry)
{
    Tolerances found;
    const QString stage = entry[key("stage1")].toString();
    found.isIndeterminate = stage == key("indeterminate");
    found.isDeterminate = stage == key("determinate");
    const QJsonObject given = entry[key("tolerances")].toObject();
    const QJsonObject common = given[key("default")].toObject();
    const auto take = [](const QJsonObject &from, const char *name, double &value) {
        if (from[key(name)].isDouble())
            value = from[key(name)].toDouble();
    };
    take(common, "mass_rel", found.mass);
    take(common, "com_mm", found.centre);
    take(common, "reactions_determinate_rel", found.reaction);
    take(common, "joint_wrench_determinate_rel", found.wrench);
    take(given, "resultant_mm", found.resultant);
    return found;
}

const char *word(Balance balance)
{
    switch (balance) {
    case Balance::Stands:
        return "stands";
    case Balance::Topples:
        return "topples";
    case Balance::LineSupport:
        return "line support";
    case Balance::Floating:
        return "floating";
    case Balance::NoContact:
        return "no contact";
    case Balance::Slides:
        return "slides";
    case Balance::Mechanism:
        return "mechanism";
    }
    return "?"; // not reached: every one is above
}

/// The table, and whether all of it was within tolerance.
class Report
{
public:
    explicit Report(const ReferenceCase &found) : m_case(found.id) {}

    /// judged: else it is only told.
    void number(const std::string &what, double truth, double ours, double tolerance,
                bool isJudged = true)
    {
        const bool isIn = std::abs(ours - truth) <= tolerance; // not so for NaN
        char ratio[32] = "-";
        if (std::abs(truth) > tolerance)
            std::snprintf(ratio, sizeof(ratio), "%.5f", ours / truth);
        std::printf("%-34s %-26s %13.6g %13.6g %9s  %s\n", m_case.c_str(), what.c_str(), truth,
                    ours, ratio,
                    isIn       ? "ok"
                    : isJudged ? "OUT"
                               : "(open)");
        m_isWithin = m_isWithin && (isIn || !isJudged);
    }
    void vector(const std::string &what, const Vec3 &truth, const Vec3 &ours, double tolerance,
                bool isJudged = true)
    {
        // Parts that are nothing in both say nothing.
        for (int i = 0; i < 3; ++i) {
            const double least = 1e-3 * tolerance;
            if (std::abs(truth[i]) > least || !(std::abs(ours[i]) <= least))
                number(what + "." + "xyz"[i], truth[i], ours[i], tolerance, isJudged);
        }
    }
    void claim(const std::string &what, const std::string &truth, const std::string &ours)
    {
        const bool isIn = truth == ours;
        std::printf("%-34s %-26s %13s %13s %9s  %s\n", m_case.c_str(), what.c_str(), truth.c_str(),
                    ours.c_str(), "-", isIn ? "ok" : "OUT");
        m_isWithin = m_isWithin && isIn;
    }
    bool isWithin() const { return m_isWithin; }

private:
    std::string m_case;
    bool m_isWithin = true;
};

void compareMasses(const ReferenceCase &found, const Tolerances &tolerances, Report &report)
{
    MassProperties all;
    for (const ReferenceSection &section : found.sections)
        all += section.mass;
    if (found.truth.mass)
        report.number("mass kg", *found.truth.mass, all.mass, tolerances.mass * *found.truth.mass);
    if (found.truth.centre)
        report.vector("centre mm", *found.truth.centre, all.centre, tolerances.centre);
}

/// Ids of the sections, in order, joined.
std::string namesOf(std::vector<std::string> ids)
{
    std::sort(ids.begin(), ids.end());
    std::string all;
    for (const std::string &id : ids)
        all += (all.empty() ? "" : "+") + id;
    return all;
}

std::string groupsOf(const std::vector<std::vector<std::string>> &groups)
{
    std::vector<std::string> names;
    for (const std::vector<std::string> &group : groups)
        names.push_back(namesOf(group));
    std::sort(names.begin(), names.end());
    std::string all;
    for (const std::string &name : names)
        all += (all.empty() ? "" : " ") + name;
    return all;
}

void compareVerdicts(const ReferenceCase &found, const Equilibrium &ours,
                     const Tolerances &tolerances, Report &report)
{
    const ReferenceTruth &truth = found.truth;
    const Balance expected =
        truth.balance.value_or(found.structure.feet.empty() ? Balance::NoContact : Balance::Stands);
    report.claim("verdict", word(expected), word(ours.balance()));
    std::vector<std::vector<std::string>> components, unsupported;
    double least = std::numeric_limits<double>::infinity();
    Vec3 resultant = Vec3::Zero();
    for (const ComponentState &component : ours.components) {
        std::vector<std::string> ids;
        for (int member : component.parts.members)
            ids.push_back(found.sections[member].id);
        if (component.balance == Balance::Floating || component.balance == Balance::NoContact)
            unsupported.push_back(ids);
        else if (component.body.margin < least) {
            least = component.body.margin;
            resultant = component.body.onGround;
        }
        components.push_back(std::move(ids));
    }
    if (!truth.components.empty())
        report.claim("components", groupsOf(truth.components), groupsOf(components));
    if (!truth.unsupported.empty())
        report.claim("unsupported", groupsOf(truth.unsupported), groupsOf(unsupported));
    if (truth.margin)
        report.number("margin mm", *truth.margin, least, tolerances.resultant);
    if (truth.resultant)
        report.vector("resultant mm", *truth.resultant, resultant, tolerances.resultant);
}

void compareForces(const ReferenceCase &found, const Equilibrium &ours,
                   const Tolerances &tolerances, Report &report)
{
    const Structure &structure = found.structure;
    const bool isOpen = ours.indeterminacy() > 0;
    Vec3 sum = Vec3::Zero(), load = Vec3::Zero();
    double largest = 0.0, leverage = 0.0;
    for (const ComponentState &component : ours.components) {
        if (!component.hasForces)
            continue;
        for (int foot : component.parts.feet)
            sum += ours.feet[foot].force;
        for (int member : component.parts.members)
            load += structure.members[member].mass * structure.gravity;
        for (int given : component.parts.loads)
            load += structure.loads[given].force;
    }
    report.number("residual", 0.0, ours.worstResidual, tolerances.equilibrium);
    report.vector("sum of reactions N", -load, sum, tolerances.equilibrium * load.norm());
    if (tolerances.isDeterminate || tolerances.isIndeterminate)
        report.claim("indeterminate", tolerances.isIndeterminate ? "yes" : "no",
                     isOpen ? "yes" : "no");

    // A foot that carries little is judged by what the others carry.
    for (const Vec3 &reaction : found.truth.reactions)
        largest = std::max(largest, reaction.norm());
    for (std::size_t i = 0; i < found.truth.reactions.size() && i < ours.feet.size(); ++i)
        report.vector("foot " + std::to_string(i) + " N", found.truth.reactions[i],
                      ours.feet[i].force, tolerances.reaction * largest, !isOpen);
    for (const auto &[id, wrench] : found.truth.joints) {
        largest = std::max(largest, wrench.force.norm());
        leverage =
            std::max({leverage, wrench.moment.norm(), wrench.force.norm() * structure.thickness});
    }
    for (std::size_t i = 0; i < found.joints.size(); ++i) {
        const auto truth = found.truth.joints.find(found.joints[i]);
        if (truth == found.truth.joints.end())
            continue;
        const Wrench &wrench = ours.links[i].onA;
        report.vector(found.joints[i] + " force N", truth->second.force, wrench.force,
                      tolerances.wrench * largest, !isOpen);
        report.vector(found.joints[i] + " moment Nmm", truth->second.moment, wrench.moment,
                      tolerances.wrench * leverage, !isOpen);
    }
}

bool compare(const ReferenceCase &found, const QJsonObject &entry)
{
    Report report(found);
    const Tolerances tolerances = tolerancesOf(entry);
    compareMasses(found, tolerances, report);
    if (!found.clamps.empty())
        return report.isWithin(); // nothing stands: what is built in is another test's
    Support support;
    support.friction = found.friction;
    const Equilibrium ours = solveEquilibrium(found.structure, support);
    compareVerdicts(found, ours, tolerances, report);
    const bool hasForces =
        std::any_of(ours.components.begin(), ours.components.end(),
                    [](const ComponentState &component) { return component.hasForces; });
    if (hasForces)
        compareForces(found, ours, tolerances, report);
    else if (!found.truth.reactions.empty())
        report.claim("forces", "some", "none");
    return report.isWithin();
}

QJsonObject indexEntries(const QDir &folder)
{
    QJsonObject entries;
    QFile file(folder.filePath(key("index.json")));
    if (!file.open(QIODevice::ReadOnly))
        return entries;
    const QJsonObject index = QJsonDocument::fromJson(file.readAll()).object();
    for (const QJsonValue &value : index[key("cases")].toArray())
        entries[value.toObject()[key("id")].toString()] = value;
    return entries;
}

int compareAll(const QDir &folder)
{
    const QJsonObject entries = indexEntries(folder);
    int read = 0, outside = 0;
    std::printf("%-34s %-26s %13s %13s %9s\n", "case", "quantity", "truth", "ours", "ratio");
    for (const QString &name : folder.entryList({key("*.json")}, QDir::Files, QDir::Name)) {
        if (name == key("index.json"))
            continue;
        QString error;
        const std::optional<ReferenceCase> found = readReferenceCase(folder.filePath(name), &error);
        if (!found) {
            std::fprintf(stderr, "%s\n", qPrintable(error));
            return 2;
        }
        if (!found->json.contains(key("truth")))
            continue;
        ++read;
        outside += !compare(*found, entries[QString::fromStdString(found->id)].toObject());
    }
    std::printf("%d cases, %d outside\n", read, outside);
    if (read == 0) {
        std::fprintf(stderr, "no cases in %s\n", qPrintable(folder.path()));
        return 2;
    }
    return outside > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char *argv[])
{
    QString path = key(FFF_SHARED "/mechanics/cases");
    bool isGiven = false;
    for (int i = 1; i < argc; ++i) {
        if (QString::fromLocal8Bit(argv[i]) == key("--cases") && i + 1 < argc) {
            path = QString::fromLocal8Bit(argv[++i]);
            isGiven = true;
        } else {
            std::fprintf(stderr, "tst_reference_cases [--cases DIR]\n");
            return 2;
        }
    }
    if (!isGiven && !QDir(key(FFF_SHARED)).exists()) {
        std::printf("there is no " FFF_SHARED ", so nothing real was compared\n");
        return 0;
    }
    if (!QDir(path).exists()) {
        std::fprintf(stderr, "no folder %s\n", qPrintable(path));
        return 2;
    }
    return compareAll(QDir(path));
}
