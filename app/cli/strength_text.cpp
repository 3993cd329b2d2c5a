#include "app/cli/strength_text.h"

#include "core/analysis/findings/strength_findings.h"
#include "core/io/json_writer.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <map>

namespace fff::cli {

namespace {

using io::JsonWriter;

/// N: less is rounding, or as good as nothing.
constexpr double kNamedForce = 0.05;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString figure(double value)
{
    constexpr double kWhole = 100.0; // from there on without a fraction
    return std::abs(value) < kWhole ? QLocale::c().toString(value, 'g', 3)
                                    : QString::number(value, 'f', 0);
}

QString percent(double share)
{
    return QStringLiteral("%1 %").arg(figure(100.0 * share));
}

QString massText(double kg)
{
    return kg < 1.0 ? QStringLiteral("%1 g").arg(figure(1000.0 * kg))
                    : QStringLiteral("%1 kg").arg(figure(kg));
}

const char *nameOf(Balance balance)
{
    switch (balance) {
    case Balance::Stands:
        return "stable";
    case Balance::Topples:
        return "topples";
    case Balance::LineSupport:
        return "lineSupport";
    case Balance::Floating:
        return "floating";
    case Balance::NoContact:
        return "noContact";
    case Balance::Slides:
        return "slides";
    case Balance::Mechanism:
        return "mechanism";
    }
    return "?"; // not reached: every one is above
}

/// NotWorkedOut is no verdict: null.
const char *nameOf(HoldVerdict verdict)
{
    switch (verdict) {
    case HoldVerdict::Holds:
        return "holds";
    case HoldVerdict::BarelyHolds:
        return "barelyHolds";
    case HoldVerdict::Breaks:
        return "breaks";
    case HoldVerdict::PullsOut:
        return "pullsOut";
    case HoldVerdict::Unstable:
        return "unstable";
    case HoldVerdict::NotRated:
        return "notRated";
    case HoldVerdict::NotWorkedOut:
        break;
    }
    return nullptr;
}

QString balanceText(Balance balance)
{
    switch (balance) {
    case Balance::Stands:
        return tr("Stands.");
    case Balance::Topples:
        return tr("Falls over.");
    case Balance::LineSupport:
        return tr("Falls over: it has only a single line to stand on.");
    case Balance::Floating:
        return tr("A part of it has nothing to stand on.");
    case Balance::NoContact:
        return tr("It is not on the ground.");
    case Balance::Slides:
        return tr("Slides away over the ground.");
    case Balance::Mechanism:
        return tr("Its parts move against each other.");
    }
    return {};
}

QString verdictText(HoldVerdict verdict)
{
    switch (verdict) {
    case HoldVerdict::Holds:
        return tr("Holds.");
    case HoldVerdict::BarelyHolds:
        return tr("Barely holds: it may crack in a corner.");
    case HoldVerdict::Breaks:
        return tr("Breaks.");
    case HoldVerdict::PullsOut:
        return tr("A joint is pulled open.");
    case HoldVerdict::Unstable:
        return tr("Strength is worked out only for what stands still.");
    case HoldVerdict::NotRated:
        return tr("Not rated: the strength of a stock is not known.");
    case HoldVerdict::NotWorkedOut:
        return tr("Whether it holds could not be worked out.");
    }
    return {};
}

/// As `check` says it, of what is green by itself.
QString standingText(const Simulated &simulated)
{
    const Balance balance = simulated.strength.equilibrium().balance();
    const Text &doubt = simulated.doubts.standing;
    if (balance != Balance::Stands || !doubt.source)
        return balanceText(balance);
    //: %1 is such as "if it held together"
    return tr("Would stand %1.").arg(QCoreApplication::translate(doubt.context, doubt.source));
}

bool holdsOnlyIf(const Simulated &simulated)
{
    const HoldVerdict verdict = simulated.strength.verdict;
    return simulated.doubts.strength.source &&
           (verdict == HoldVerdict::Holds || verdict == HoldVerdict::BarelyHolds);
}

QString holdingText(const Simulated &simulated)
{
    if (simulated.strength.verdict == HoldVerdict::Breaks && simulated.strength.neckUse <= 1.0)
        return tr("Too weak: it holds, but not with the safety that is asked for.");
    if (!holdsOnlyIf(simulated))
        return verdictText(simulated.strength.verdict);
    const Text &doubt = simulated.doubts.strength;
    //: %1 is such as "if it held together"
    return tr("Would hold %1.").arg(QCoreApplication::translate(doubt.context, doubt.source));
}

const std::string &nameOfBody(const Analysis &analysis, int body)
{
    return analysis.model.section(static_cast<std::size_t>(analysis.bodies.sectionOf(body)))->name;
}

QString quoted(const Analysis &analysis, int body)
{
    return QString::fromStdString(nameOfBody(analysis, body));
}

/// Of all bodies of one section.
struct SectionStrength
{
    double neck = 0.0, corner = 0.0; // MPa
    double use = 0.0;
    bool isRated = true, isWorkedOut = true;
    std::optional<NeckStress> worst;
};

SectionStrength strengthOfSection(const Strength &strength, const Analysis &analysis,
                                  std::size_t section)
{
    SectionStrength all;
    const int first = analysis.bodies.firstOf(static_cast<int>(section));
    for (int i = 0; i < analysis.bodies.countOf(static_cast<int>(section)); ++i) {
        const BodyStrength &body = strength.bodies[static_cast<std::size_t>(first + i)];
        all.isRated = all.isRated && body.strength;
        all.isWorkedOut = all.isWorkedOut && body.isWorkedOut;
        all.use = std::max(all.use, body.neckUse);
        if (body.neck)
            all.neck = std::max(all.neck, body.neck->stress.neck);
        if (body.corner && (!all.worst || body.corner->stress.corner > all.corner)) {
            all.corner = body.corner->stress.corner;
            all.worst = body.corner;
        }
    }
    return all;
}

void writeJoints(JsonWriter &json, const Strength &strength, const Analysis &analysis)
{
    json.key("joints");
    json.beginArray();
    for (std::size_t i = 0; i < strength.made.links.size(); ++i) {
        const Link &link = strength.made.structure.links[i];
        const LinkForce &force = strength.equilibrium().links[i];
        json.beginObject(JsonWriter::Layout::Line);
        json.member("id", strength.made.links[i].joint);
        json.member("a", nameOfBody(analysis, link.a));
        json.member("b", nameOfBody(analysis, link.b));
        json.member("overlap", strength.made.links[i].overlap);
        json.member("point", link.point);
        json.member("force", force.onA.force);
        json.member("moment", force.onA.moment);
        json.member("pullOut", std::max(0.0, force.asked));
        json.endObject();
    }
    json.endArray();
}

void writeSections(JsonWriter &json, const Strength &strength, const Analysis &analysis)
{
    json.key("sections");
    json.beginArray();
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const SectionStrength section = strengthOfSection(strength, analysis, i);
        json.beginObject();
        json.member("name", analysis.model.section(i)->name);
        if (section.isWorkedOut) {
            json.member("maxStress", section.neck);
            json.member("maxStressFactored", section.corner);
        }
        if (section.isWorkedOut && section.isRated)
            json.member("utilisation", section.use);
        if (section.isWorkedOut && section.worst) {
            const CutForces &forces = section.worst->forces;
            json.key("worst");
            json.beginObject(JsonWriter::Layout::Line);
            json.member("from", section.worst->begin);
            json.member("to", section.worst->end);
            json.member("N", forces.axial);
            json.member("V", forces.shear);
            json.member("Q", forces.plate);
            json.member("Mn", forces.inPlane);
            json.member("Mv", forces.bending);
            json.member("T", forces.torsion);
            json.endObject();
        }
        json.endObject();
    }
    json.endArray();
}

/// One line a section that stands on the ground.
QStringList reactionsText(const Strength &strength, const Analysis &analysis)
{
    std::map<int, double> forces; // by section, N
    for (std::size_t i = 0; i < strength.made.structure.feet.size(); ++i)
        forces[analysis.bodies.sectionOf(strength.made.structure.feet[i].member)] +=
            strength.equilibrium().feet[i].force.y();
    QStringList lines;
    for (const auto &[section, force] : forces)
        lines += tr("%1 presses on the ground with %2 N.")
                     .arg(QString::fromStdString(
                              analysis.model.section(static_cast<std::size_t>(section))->name),
                          figure(force));
    return lines;
}

double totalWeight(const Structure &structure)
{
    double sum = 0.0;
    for (const Member &member : structure.members)
        sum += member.mass * structure.gravity.norm();
    for (const MemberLoad &load : structure.loads)
        sum -= load.force.dot(structure.up);
    return sum;
}

} // namespace

QStringList strengthWarnings(const Simulated &simulated, const Analysis &analysis)
{
    QStringList lines;
    const Strength &strength = simulated.strength;
    const Equilibrium &equilibrium = strength.equilibrium();
    if (equilibrium.balance() != Balance::Stands)
        for (const ComponentState &state : equilibrium.components)
            if (state.balance == equilibrium.balance() && !state.offenders.empty() &&
                state.openLinks.empty()) // what pulls these open is said below
                lines += tr("%1: %2").arg(quoted(analysis, state.offenders.front()),
                                          balanceText(state.balance));
    for (std::size_t i = 0; i < strength.made.links.size(); ++i) {
        const Link &link = strength.made.structure.links[i];
        if (equilibrium.links[i].isOpen)
            lines += tr("Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.")
                         .arg(quoted(analysis, link.a), quoted(analysis, link.b),
                              figure(equilibrium.links[i].asked));
    }
    for (const int body : strength.stiff)
        lines += tr("How %1 bends could not be worked out; it is treated as rigid.")
                     .arg(quoted(analysis, body));
    if (strength.isBendingLost)
        lines += tr("How sections bend could not be worked out; they are treated as rigid.");
    if (equilibrium.indeterminacy() > 0 && !strength.isElastic)
        lines += tr("Joints can share the load in more than one way (indeterminate, %1); the worst "
                    "way counts.")
                     .arg(equilibrium.indeterminacy());
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const SectionStrength section = strengthOfSection(strength, analysis, i);
        const QString name = QString::fromStdString(analysis.model.section(i)->name);
        if (equilibrium.balance() == Balance::Stands && !section.isWorkedOut)
            lines += tr("The stress in %1 could not be worked out.").arg(name);
        else if (!section.isRated)
            lines += tr("%1 is not rated: the strength of its stock is not known.").arg(name);
    }
    for (const PlacedLoad &placed : strength.made.besideLoads) {
        const Load &load = analysis.model.document.loads[static_cast<std::size_t>(placed.load)];
        const QString name = QString::fromStdString(
            analysis.model.section(static_cast<std::size_t>(placed.section))->name);
        lines += load.isPush()
                     ? tr("A push of %1 N misses the material of %2; the nearest place takes it.")
                           .arg(figure(load.push.norm()), name)
                     : tr("A weight of %1 misses the material of %2; the nearest place takes it.")
                           .arg(massText(load.mass), name);
    }
    return lines;
}

std::string strengthJson(const Simulated &simulated, const Analysis &analysis, const QString &file)
{
    const Strength &strength = simulated.strength;
    const Equilibrium &equilibrium = strength.equilibrium();
    JsonWriter json;
    json.beginObject();
    json.member("file", file.toStdString());
    json.member("equilibrium", nameOf(equilibrium.balance()));
    json.member("indeterminacy", equilibrium.indeterminacy());
    json.member("residual", equilibrium.worstResidual);
    json.member("totalWeight", totalWeight(strength.made.structure));
    json.key("reactions");
    json.beginArray();
    for (std::size_t i = 0; i < strength.made.structure.feet.size(); ++i) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("section", nameOfBody(analysis, strength.made.structure.feet[i].member));
        json.member("point", strength.made.structure.feet[i].point);
        json.member("force", equilibrium.feet[i].force);
        json.endObject();
    }
    json.endArray();
    writeJoints(json, strength, analysis);
    writeSections(json, strength, analysis);
    json.member("maxUtilisation", strength.neckUse);
    if (simulated.bent && simulated.bent->mostIn >= 0) {
        json.key("displacement");
        json.beginObject(JsonWriter::Layout::Line);
        json.member("largest", simulated.bent->most);
        json.member("section", nameOfBody(analysis, simulated.bent->mostIn));
        json.endObject();
    }
    json.key("verdict");
    // What comes apart does not stand still.
    if (const char *verdict =
            nameOf(holdsOnlyIf(simulated) ? HoldVerdict::Unstable : strength.verdict))
        json.value(verdict);
    else
        json.null();
    for (const auto &[name, mass] : {std::pair("cracksFrom", simulated.bearable.cracksFrom),
                                     std::pair("breaksAt", simulated.bearable.breaksAt)})
        if (mass)
            json.member(name, *mass);
    json.key("warnings");
    json.beginArray();
    if (equilibrium.balance() == Balance::Stands && simulated.doubts.standing.source)
        json.value(standingText(simulated).toStdString());
    for (const QString &line : strengthWarnings(simulated, analysis))
        json.value(line.toStdString());
    json.endArray();
    json.key("milliseconds");
    json.beginObject(JsonWriter::Layout::Line);
    json.member("equilibrium", simulated.millisecondsOfForces);
    json.member("stress", simulated.millisecondsOfStresses);
    json.endObject();
    json.endObject();
    return json.take();
}

namespace {

/// Of all that acts, scaled alike: pushes are no mass. kilograms: as BearableMass has it.
QString amountText(double kilograms, const ModelStructure &made)
{
    if (made.pushes == 0.0)
        return tr("%1 in all").arg(massText(kilograms));
    const double times = kilograms / placedMass(made.structure);
    if (made.weights == 0.0)
        return tr("%1 N in all").arg(figure(times * made.pushes));
    return tr("%1 times the load").arg(figure(times));
}

} // namespace

QStringList strengthText(const Simulated &simulated, const Analysis &analysis)
{
    const Strength &strength = simulated.strength;
    QStringList lines{standingText(simulated), holdingText(simulated)};
    const bool isShown = strength.equilibrium().balance() == Balance::Stands;
    if (isShown && strength.worst >= 0) {
        const BodyStrength &body = strength.bodies[static_cast<std::size_t>(strength.worst)];
        lines += tr("Weakest in %1: %2 of its stock's strength in the neck, %3 in the corner.")
                     .arg(quoted(analysis, strength.worst), percent(body.neckUse),
                          percent(body.cornerUse));
    }
    if (isShown && simulated.bent && simulated.bent->most >= kToldBending)
        lines += tr("Bends %1 mm, most of all %2.")
                     .arg(figure(simulated.bent->most), quoted(analysis, simulated.bent->mostIn));
    if (simulated.bearable.cracksFrom)
        lines +=
            tr("May crack from %1.").arg(amountText(*simulated.bearable.cracksFrom, strength.made));
    if (simulated.bearable.breaksAt)
        lines += tr("Breaks at %1.").arg(amountText(*simulated.bearable.breaksAt, strength.made));
    lines +=
        tr("Weighs %1 N with everything on it.").arg(figure(totalWeight(strength.made.structure)));
    if (isShown)
        lines += reactionsText(strength, analysis);
    return lines + strengthWarnings(simulated, analysis);
}

} // namespace fff::cli
