#include "core/assembly/collisions.h"

#include "core/assembly/encounter.h"
#include "core/assembly/overlap_depth.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace fff {

namespace {

/// Answers kept at most; some 80 bytes each.
constexpr std::size_t kMostAnswers = 1'000'000;
/// Prisms of a pair that are kept.
constexpr std::size_t kMostMet = 4;

} // namespace

int Collisions::Numbers::number(const Vec3 &vector)
{
    const auto [entry, isNew] =
        m_numbers.try_emplace({vector.x(), vector.y(), vector.z()}, Entry{m_next, true});
    if (isNew)
        m_vectors.emplace(m_next++, vector);
    entry->second.isInUse = true;
    return entry->second.number;
}

void Collisions::Numbers::forgetOld()
{
    for (auto known = m_numbers.begin(); known != m_numbers.end();) {
        if (std::exchange(known->second.isInUse, false)) {
            ++known;
            continue;
        }
        m_vectors.erase(known->second.number);
        known = m_numbers.erase(known);
    }
}

std::size_t Collisions::Hash::operator()(const Question &question) const
{
    // Odd numbers whose products mix the bits well (D. Lemire, M. Thorup: multiply-shift).
    std::uint64_t mixed = static_cast<std::uint32_t>(question.a) * 0x9E3779B97F4A7C15ull;
    mixed = (std::rotl(mixed, 23) ^ static_cast<std::uint32_t>(question.b)) * 0xC2B2AE3D27D4EB4Full;
    mixed =
        (std::rotl(mixed, 23) ^ static_cast<std::uint32_t>(question.way)) * 0x165667B19E3779F9ull;
    mixed =
        (std::rotl(mixed, 23) ^ static_cast<std::uint32_t>(question.lift)) * 0x9E3779B97F4A7C15ull;
    return static_cast<std::size_t>(mixed ^ (mixed >> 29));
}

/// A solid that is still there keeps its name; a new one takes that of the one that is gone from
/// its place among them. Who is whom is a guess that costs time alone where it is wrong.
void Collisions::name(const std::vector<SolidPointer> &solids)
{
    std::unordered_map<const Solid *, std::size_t> before;
    for (std::size_t i = 0; i < m_solids.size(); ++i)
        before.emplace(m_solids[i].get(), i);
    std::vector<char> isTaken(m_solids.size(), char(false));
    for (const SolidPointer &solid : solids)
        if (const auto known = before.find(solid.get()); known != before.end())
            isTaken[known->second] = true;
    std::vector<Name> names;
    std::size_t place = 0; // among those before
    for (const SolidPointer &solid : solids) {
        if (const auto known = before.find(solid.get()); known != before.end()) {
            names.push_back(m_names[known->second]);
            place = known->second + 1;
        } else if (place < m_solids.size() && !isTaken[place]) {
            isTaken[place] = true;
            names.push_back({m_names[place++].number, m_nextVersion++});
        } else {
            names.push_back({m_nextNumber++, m_nextVersion++});
        }
    }
    m_names = std::move(names);
}

void Collisions::use(std::vector<SolidPointer> solids, Depths depths)
{
    name(solids);
    m_solids = std::move(solids); // addresses of those before are free from here on
    m_ways.forgetOld();
    m_lifts.forgetOld();

    std::vector<char> isThere(static_cast<std::size_t>(m_nextNumber), char(false));
    for (const Name &name : m_names)
        isThere[static_cast<std::size_t>(name.number)] = true;
    const auto forget = [&](auto &answers) {
        if (answers.size() > kMostAnswers)
            answers.clear();
        std::erase_if(answers, [&](const auto &answer) {
            const Question &asked = answer.first;
            return !isThere[static_cast<std::size_t>(asked.a)] ||
                   !isThere[static_cast<std::size_t>(asked.b)] ||
                   (asked.way >= 0 && !m_ways.isInUse(asked.way)) ||
                   (asked.lift >= 0 && !m_lifts.isInUse(asked.lift));
        });
    };
    forget(m_isFree);
    forget(m_until);
    forget(m_clear);
    forget(m_overlaps);
    forget(m_measured);
    m_met.clear();
    m_depths = std::move(depths);
}

Collisions::Question Collisions::question(int a, int b, int way, int lift) const
{
    return {m_names[static_cast<std::size_t>(a)].number,
            m_names[static_cast<std::size_t>(b)].number, way, lift, depth(a, b)};
}

double Collisions::pressed(int a, int b) const
{
    const auto known = m_depths.find(std::minmax(a, b));
    return known == m_depths.end() ? kTouchingDepth : known->second;
}

Vec3 Collisions::liftedBy(int lift) const
{
    return lift == kNotLifted ? Vec3(Vec3::Zero()) : m_lifts.vector(lift);
}

std::pair<int, int> Collisions::versions(int a, int b) const
{
    return {m_names[static_cast<std::size_t>(a)].version,
            m_names[static_cast<std::size_t>(b)].version};
}

/// Whether two prisms meet that did so on another way.
bool Collisions::haveMet(const Question &question, int a, int b)
{
    const auto known = m_met.find(std::minmax(a, b));
    if (known == m_met.end())
        return false;
    std::vector<PrismIndices> &met = known->second;
    const Vec3 &along = m_ways.vector(question.way);
    const Vec3 by = liftedBy(question.lift);
    const auto meets = std::find_if(met.begin(), met.end(), [&](const PrismIndices &prisms) {
        return prismsMeet(solid(a), solid(b), a < b ? prisms : prisms.swapped(), along,
                          question.depth, by);
    });
    if (meets == met.end())
        return false;
    std::rotate(met.begin(), meets, std::next(meets));
    return true;
}

void Collisions::keepMet(int a, int b, const PrismIndices &prisms)
{
    std::vector<PrismIndices> &met = m_met[std::minmax(a, b)];
    if (met.size() == kMostMet)
        met.pop_back();
    met.insert(met.begin(), a < b ? prisms : prisms.swapped());
}

template <typename Answer, typename Meet, typename Find>
const Answer &Collisions::answer(Answers<Answer> &all, const Question &question, int a, int b,
                                 const Meet &meet, const Find &find)
{
    Known<Answer> &known = all[question];
    const auto [versionA, versionB] = versions(a, b);
    if (known.versionA == versionA && known.versionB == versionB)
        return known.answer;
    ++m_work.encounters;
    Encounter encounter = meet();
    if (!known.signature || *known.signature != encounter.signature()) {
        ++m_work.answers;
        known.answer = find(encounter);
        known.signature.reset();
        if (encounter.isComplete())
            known.signature = encounter.signature();
        m_work.prismPairs += encounter.pairsLookedAt();
    }
    known.versionA = versionA;
    known.versionB = versionB;
    return known.answer;
}

bool Collisions::comesFree(int a, int b, int way, int lift)
{
    const Question asked = question(a, b, way, lift);
    Known<bool> &known = m_isFree[asked];
    const auto [versionA, versionB] = versions(a, b);
    if (known.versionA == versionA && known.versionB == versionB)
        return known.answer;
    if (haveMet(asked, a, b)) {
        known = {versionA, versionB, {}, false};
        return false;
    }
    return answer(
        m_isFree, asked, a, b,
        [&] {
            return Encounter(solid(a), solid(b), m_ways.vector(way), asked.depth, liftedBy(lift));
        },
        [&](Encounter &encounter) {
            const std::optional<PrismIndices> meeting = encounter.meeting();
            if (meeting)
                keepMet(a, b, *meeting);
            return !meeting;
        });
}

double Collisions::wayUntil(int a, int b, int way)
{
    return answer(
        m_until, question(a, b, way, kNotLifted), a, b,
        [&] { return Encounter(solid(a), solid(b), m_ways.vector(way), depth(a, b)); },
        [](Encounter &encounter) {
            const std::optional<Travel> met = encounter.first();
            return met ? met->from : std::numeric_limits<double>::infinity();
        });
}

double Collisions::wayToClear(int a, int b, int way, int lift)
{
    return answer(
        m_clear, question(a, b, way, lift), a, b,
        [&] {
            return Encounter(solid(a), solid(b), m_ways.vector(way), -kNearParts, liftedBy(lift));
        },
        [](Encounter &encounter) { return encounter.wayToClear(); });
}

const std::optional<Interpenetration> &Collisions::overlap(int a, int b)
{
    const Question asked = question(a, b, -1, kNotLifted);
    // From the prisms that an Encounter of them holds, and no others.
    const auto of = [&](auto &known, const Solid &first, const Solid &second) -> const auto &
    {
        return answer(
            known, asked, a, b, [&] { return Encounter(first, second, asked.depth); },
            [&](Encounter &still) { return overlapOf(first, second, still); });
    };
    const auto &found = of(m_overlaps, solid(a), solid(b));
    const std::shared_ptr<const Solid> &wholeA = solid(a).whole, &wholeB = solid(b).whole;
    if (!found || (!wholeA && !wholeB))
        return found;
    const auto &measured = of(m_measured, wholeA ? *wholeA : solid(a), wholeB ? *wholeB : solid(b));
    return measured ? measured : found;
}

void Collisions::press(int a, int b, double depth)
{
    m_depths[std::minmax(a, b)] = depth;
}

} // namespace fff
