#include "core/analysis/straining.h"

#include "core/base/tolerances.h"
#include "core/physics/sample_stresses.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <numeric>

namespace fff {

namespace {

/// Of a force, the share across the vertical that is more than rounding.
constexpr double kSideways = 1e-9;

constexpr double kCubicMetre = 1e9; // mm³
/// Of several ways to bear a load those are refined whose stresses by the grid are within this
/// share of the worst: refining adds less.
constexpr double kNearlyWorst = 0.8;
/// Lines that are strained by less than this, a share of what the sheet bears, are not kept.
constexpr double kLeastShown = 0.005;

/// A wrench about a point of the world, in a body's frame.
AppliedForce appliedIn(const Frame &frame, ForceKind kind, const Vec2 &at, const Vec3 &point,
                       const Vec3 &force, const Vec3 &moment)
{
    AppliedForce applied;
    applied.kind = kind;
    applied.at = at;
    applied.force = inFrame(frame, force);
    applied.moment = inFrame(frame, moment + (point - frame.toWorld(at)).cross(force));
    return applied;
}

/// What acts on each body.
using ForcesOnBodies = std::vector<std::vector<AppliedForce>>;
ForcesOnBodies forcesOn(const Bodies &bodies, const ModelStructure &made, const Structure &loaded,
                        const Equilibrium &equilibrium)
{
    ForcesOnBodies forces(bodies.size());
    const auto add = [&](int body, ForceKind kind, const Vec2 &at, const Vec3 &point,
                         const Vec3 &force, const Vec3 &moment) -> AppliedForce & {
        auto &list = forces[static_cast<std::size_t>(body)];
        list.push_back(appliedIn(bodies.at(body).frame(), kind, at, point, force, moment));
        return list.back();
    };
    for (std::size_t i = 0; i < loaded.links.size(); ++i) {
        const Link &link = loaded.links[i];
        const LinkPlace &place = made.links[i];
        const Wrench &onA = equilibrium.links[i].onA;
        add(link.a, ForceKind::Link, place.slits[0].root, link.point, onA.force, onA.moment).slit =
            place.slits[0];
        add(link.b, ForceKind::Link, place.slits[1].root, link.point, -onA.force, -onA.moment)
            .slit = place.slits[1];
    }
    for (std::size_t i = 0; i < loaded.feet.size(); ++i) {
        const Foot &foot = loaded.feet[i];
        add(foot.member, ForceKind::Foot, bodies.at(foot.member).frame().toLocal(foot.point),
            foot.point, equilibrium.feet[i].force, Vec3::Zero());
    }
    for (const MemberLoad &load : loaded.loads)
        add(load.member, ForceKind::Load, bodies.at(load.member).frame().toLocal(load.point),
            load.point, load.force, load.moment);
    return forces;
}

Structure loadedBy(double scale, const Strength &strength)
{
    Structure loaded = strength.made.structure;
    for (MemberLoad &load : loaded.loads) {
        load.force *= scale;
        load.moment *= scale;
    }
    return loaded;
}

/// The forces of bodies that bend in place of those of rigid ones.
Equilibrium bentBy(const ElasticEquilibrium &solved, const Structure &loaded, Equilibrium rigid)
{
    for (std::size_t i = 0; i < loaded.links.size(); ++i) {
        LinkForce &force = rigid.links[i];
        force.onA = {solved.links[i].head<3>(), solved.links[i].tail<3>()};
        force.pull = force.onA.force.dot(loaded.links[i].axis);
        force.isOpen = solved.isParted[i];
        force.asked = std::max(0.0, force.pull);
    }
    for (std::size_t i = 0; i < loaded.feet.size(); ++i)
        rigid.feet[i] = {solved.feet[i], !solved.isLifted[i]};
    rigid.residuals = solved.residual;
    rigid.worstResidual = solved.worstResidual;
    return rigid;
}

void keepWorse(const SectionStress &stress, int neck, double NeckStress::*use,
               std::optional<NeckStress> &worst)
{
    if (neck < 0)
        return;
    const NeckStress &found = stress.necks[static_cast<std::size_t>(neck)];
    if (!worst || found.*use > (*worst).*use)
        worst = found;
}

bool actsWhere(const AppliedForce &a, const AppliedForce &b)
{
    return a.kind == b.kind && a.at == b.at && a.radius == b.radius && a.slit.root == b.slit.root &&
           a.slit.opening == b.slit.opening && a.slit.depth == b.slit.depth &&
           a.slit.width == b.slit.width && isUsableForce(a) == isUsableForce(b);
}

bool isPushedSideways(const Structure &structure)
{
    return std::any_of(structure.loads.begin(), structure.loads.end(), [&](const MemberLoad &load) {
        const Vec3 sideways = load.force - load.force.dot(structure.up) * structure.up;
        return sideways.norm() > kSideways * load.force.norm();
    });
}

/// With all of its face on the ground and nothing else at it: the ground bears each bit of it where
/// that is, not only at the corners that are looked at as feet.
bool liesFlat(const Frame &frame, const Vec3 &up, const std::vector<AppliedForce> &forces)
{
    return frame.normal().cross(up).norm() <= kSameDirection && !forces.empty() &&
           std::all_of(forces.begin(), forces.end(),
                       [](const AppliedForce &force) { return force.kind == ForceKind::Foot; });
}

/// Cut alike wherever they are.
bool isAlike(const PieceShape &a, const PieceShape &b)
{
    return a.outline.rings() == b.outline.rings() && a.slits == b.slits;
}

/// Of what follows from all of it.
std::size_t hashOf(const PieceShape &shape)
{
    std::size_t hash = shape.slits.size();
    const AreaMoment &total = shape.outline.total();
    for (const double value : {total.area, total.first.x(), total.first.y(), shape.size}) {
        constexpr std::size_t kFactor = 0x100000001b3; // of FNV
        hash = (hash ^ std::hash<double>()(value)) * kFactor;
    }
    return hash;
}

/// Of each line the worst of several ways to bear a load.
class KeptLines
{
public:
    void add(const SectionStress &stress, std::size_t samples)
    {
        for (std::size_t i = 0; i < stress.necks.size(); ++i) {
            const NeckStress &neck = stress.necks[i];
            if (!neck.counts() || neck.cornerUse < kLeastShown)
                continue;
            m_samples.resize(samples); // of most bodies nothing is kept
            if (i >= samples)
                m_refined.push_back(neck);
            else if (!m_samples[i] || neck.cornerUse > m_samples[i]->cornerUse)
                m_samples[i] = neck;
        }
    }

    std::vector<NeckStress> take()
    {
        std::vector<NeckStress> lines = std::move(m_refined);
        const auto isKept = [](const std::optional<NeckStress> &line) { return line.has_value(); };
        const auto kept = std::count_if(m_samples.begin(), m_samples.end(), isKept);
        lines.reserve(lines.size() + static_cast<std::size_t>(kept));
        for (const auto &line : m_samples)
            if (line)
                lines.push_back(*line);
        return lines;
    }

private:
    std::vector<std::optional<NeckStress>> m_samples;
    std::vector<NeckStress> m_refined;
};

} // namespace

std::vector<char> bodiesWithForces(const Equilibrium &equilibrium, std::size_t bodies)
{
    std::vector<char> has(bodies, 0);
    for (const ComponentState &state : equilibrium.components)
        for (const int member : state.parts.members)
            has[static_cast<std::size_t>(member)] =
                state.hasForces && state.balance == Balance::Stands;
    return has;
}

Support supportOf(const Structure &loaded, const StrengthRules &rules)
{
    Support support = rules.support;
    if (isPushedSideways(loaded))
        support.friction = std::max(support.friction, rules.footFriction);
    return support;
}

void Straining::balance(double scale, Strength &strength) const
{
    const Structure loaded = loadedBy(scale, strength);
    strength.envelope = solveEnvelope(loaded, supportOf(loaded, m_rules), m_caches.equilibria);
    if (m_rules.isElastic && strength.equilibrium().indeterminacy() > 0 &&
        strength.equilibrium().balance() == Balance::Stands)
        bend(scale, loaded, strength);
}

/// The forces of bodies that bend in place of those of rigid ones, where there are such.
void Straining::bend(double scale, const Structure &loaded, Strength &strength) const
{
    const auto bending =
        BendingBodies::of(m_analysis, strength.made, m_caches.bending, m_caches.meshes, m_work);
    if (!bending)
        return; // it was stopped: whoever did so wants none of this
    strength.stiff = bending->stiff();
    auto structure = ElasticStructure::make(loaded, bending->under(scale));
    const auto sliding =
        structure ? structure->solve(FootHold::Frictionless) : tl::unexpected(structure.error());
    if (!sliding || !sliding->isBalanced()) {
        strength.isBendingLost = true;
        return;
    }
    std::vector<Equilibrium> bent{bentBy(*sliding, loaded, strength.equilibrium())};
    const auto pinned = structure->solve(FootHold::Pinned);
    if (pinned && pinned->isBalanced())
        bent.push_back(bentBy(*pinned, loaded, strength.equilibrium()));
    strength.envelope = std::move(bent);
    strength.isElastic = true;
}

void Straining::stress(double scale, Strength &strength) const
{
    strength.bodies.assign(m_analysis.bodies.size(), {});
    std::vector<int> all(m_analysis.bodies.size());
    std::iota(all.begin(), all.end(), 0);
    strain(scale, all, Detail::WithLines, strength);
}

void Straining::stressOfWorst(double scale, Strength &strength) const
{
    strength.bodies.assign(m_analysis.bodies.size(), {});
    std::vector<int> bodies(m_analysis.bodies.size());
    std::iota(bodies.begin(), bodies.end(), 0);
    strain(scale, bodies, Detail::Grid, strength);
    std::erase_if(bodies, [&](int body) {
        const BodyStrength &strained = strength.bodies[static_cast<std::size_t>(body)];
        return !(strained.cornerUse > 0.0 &&
                 strained.cornerUse >= kNearlyWorst * strength.cornerUse) &&
               !(strained.neckUse > 0.0 && strained.neckUse >= kNearlyWorst * strength.neckUse);
    });
    strain(scale, bodies, Detail::Refined, strength);
}

void Straining::stress(double scale, std::span<const int> bodies, Strength &strength) const
{
    strength.bodies.resize(m_analysis.bodies.size());
    strain(scale, bodies, Detail::Refined, strength);
}

void Straining::strain(double scale, std::span<const int> bodies, Detail detail,
                       Strength &strength) const
{
    const Structure loaded = loadedBy(scale, strength);
    std::vector<std::vector<char>> hasForces;
    std::vector<ForcesOnBodies> forces;
    for (const Equilibrium &equilibrium : strength.envelope) {
        hasForces.push_back(bodiesWithForces(equilibrium, m_analysis.bodies.size()));
        forces.push_back(forcesOn(m_analysis.bodies, strength.made, loaded, equilibrium));
    }
    Rooms rooms(forces.size());
    for (const int index : bodies) {
        if (isStopped())
            return; // whoever did so wants none of this
        const auto i = static_cast<std::size_t>(index);
        std::vector<const std::vector<AppliedForce> *> cases;
        for (std::size_t k = 0; k < forces.size(); ++k)
            if (hasForces[k][i])
                cases.push_back(&forces[k][i]);
        BodyStrength &body = strength.bodies[i];
        body = BodyStrength();
        // What hangs by nothing does so before anybody can say which forces pull at it.
        if (!cases.empty() || detail == Detail::WithLines)
            lookForNecks(index, body);
        if (!cases.empty())
            strain(index, cases, loaded, detail, rooms, body);
        body.strength = strengthOf(stockOf(index), m_rules);
        body.isWorkedOut = hasForces.front()[i] && (cases.empty() || body.isWorkedOut);
    }
    strength.worst = -1;
    strength.neckUse = strength.cornerUse = 0.0;
    for (std::size_t i = 0; i < strength.bodies.size(); ++i) {
        const BodyStrength &body = strength.bodies[i];
        if (body.neckUse > strength.neckUse) {
            strength.neckUse = body.neckUse;
            strength.worstNeck = static_cast<int>(i);
        }
        if (body.cornerUse > strength.cornerUse) {
            strength.cornerUse = body.cornerUse;
            strength.worst = static_cast<int>(i);
        }
    }
}

const Stock &Straining::stockOf(int body) const
{
    return m_analysis.model.stockOf(static_cast<std::size_t>(m_analysis.bodies.sectionOf(body)));
}

std::shared_ptr<const SectionCuts> Straining::cutsOf(int body) const
{
    auto &kept = m_caches.cuts[m_analysis.bodies.pointer(body)];
    if (kept)
        return kept;
    PieceShape shape(m_analysis.bodies.at(body).outline().region, slitsOf(m_analysis, body));
    const std::size_t hash = hashOf(shape);
    const auto [first, last] = m_caches.alike.equal_range(hash);
    const auto same = std::find_if(
        first, last, [&](const auto &other) { return isAlike(other.second->shape(), shape); });
    if (same != last)
        return kept = same->second;
    kept = std::make_shared<const SectionCuts>(std::move(shape));
    m_caches.alike.emplace(hash, kept);
    return kept;
}

const CutShares &Straining::sharesOf(int body, const std::shared_ptr<const SectionCuts> &cuts,
                                     const std::vector<AppliedForce> &forces,
                                     double thickness) const
{
    std::shared_ptr<const KeptShares> &kept = m_caches.shares[m_analysis.bodies.pointer(body)];
    const auto isFor = [&](const std::shared_ptr<const KeptShares> &shares) {
        return shares && shares->cuts == cuts && shares->thickness == thickness &&
               std::equal(forces.begin(), forces.end(), shares->forces.begin(),
                          shares->forces.end(), actsWhere);
    };
    if (isFor(kept))
        return kept->shares;
    std::shared_ptr<const KeptShares> &last = m_caches.lastShares[cuts.get()];
    if (!isFor(last))
        last = std::make_shared<const KeptShares>(
            KeptShares{cuts, forces, thickness, cutShares(*cuts, forces, thickness)});
    kept = last;
    return kept->shares;
}

SheetMaterial Straining::sheetOf(int body, const Structure &structure) const
{
    const Stock &stock = stockOf(body);
    const Frame &frame = m_analysis.bodies.at(body).frame();
    const Vec3 weight = stock.density / kCubicMetre * stock.thickness * structure.gravity;
    SheetMaterial sheet;
    sheet.thickness = stock.thickness;
    sheet.arealWeight = inFrame(frame, weight);
    sheet.strength =
        strengthOf(stock, m_rules).value_or(1.0); // unknown: uses are MPa, and not looked at
    if (stock.modulus)
        sheet.modulus = *stock.modulus;
    sheet.isDuctile = stock.isDuctile;
    return sheet;
}

void Straining::lookForNecks(int index, BodyStrength &body) const
{
    const std::shared_ptr<const SectionCuts> cuts = cutsOf(index);
    body.isPinched = cuts->isPinched();
    if (const CutSample *sample = cuts->thinnest())
        body.thinnest = sample->neck;
}

/// Of the cases, which act in the same places, those are looked at closely that may be worst.
void Straining::strain(int index, const std::vector<const std::vector<AppliedForce> *> &cases,
                       const Structure &structure, Detail detail, Rooms &rooms,
                       BodyStrength &body) const
{
    body.isWorkedOut = true;
    if (liesFlat(m_analysis.bodies.at(index).frame(), structure.up, *cases.front()))
        return;
    const std::shared_ptr<const SectionCuts> kept = cutsOf(index);
    const SectionCuts &cuts = *kept;
    const SheetMaterial sheet = sheetOf(index, structure);
    const CutShares &shares = sharesOf(index, kept, *cases.front(), sheet.thickness);
    std::deque<SampleStresses> stresses; // by cases
    double worstNeck = 0.0, worstCorner = 0.0;
    for (const std::vector<AppliedForce> *forces : cases) {
        SampleStresses &stress = stresses.emplace_back(cuts, shares, *forces, sheet, m_rules.notch,
                                                       std::move(rooms[stresses.size()]));
        worstNeck = std::max(worstNeck, stress.worstNeck());
        worstCorner = std::max(worstCorner, stress.worstCorner());
    }
    KeptLines lines;
    for (SampleStresses &stress : stresses) {
        // Which of several ways is refined, and covers lines of the grid there, is not to tell
        // which of these are known.
        if (detail == Detail::WithLines && stresses.size() > 1)
            lines.add(stress.result(kLeastShown), cuts.samples().size());
        if (detail != Detail::Grid && (stress.worstNeck() >= kNearlyWorst * worstNeck ||
                                       stress.worstCorner() >= kNearlyWorst * worstCorner))
            stress.refine(StressOptions().refined);
        const SectionStress &found = stress.result(
            detail == Detail::WithLines ? kLeastShown : std::numeric_limits<double>::infinity());
        body.isWorkedOut = body.isWorkedOut && found.isWorkedOut;
        keepWorse(found, found.worstNeck, &NeckStress::neckUse, body.neck);
        keepWorse(found, found.worstCorner, &NeckStress::cornerUse, body.corner);
        if (detail == Detail::WithLines)
            lines.add(found, cuts.samples().size());
    }
    for (std::size_t i = 0; i < stresses.size(); ++i)
        rooms[i] = stresses[i].takeRoom();
    if (strengthOf(stockOf(index))) {
        body.neckUse = body.neck ? body.neck->neckUse : 0.0;
        body.cornerUse = body.corner ? body.corner->cornerUse : 0.0;
        body.lines = lines.take();
    }
}

} // namespace fff
