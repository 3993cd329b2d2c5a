#include "core/assembly/collisions.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace fff {

namespace {

/// Answers kept at most; some 64 bytes each.
constexpr std::size_t kMostAnswers = 1'000'000;

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

void Collisions::use(std::vector<SolidPointer> solids, Depths depths)
{
    std::unordered_map<const Solid *, int> before;
    for (std::size_t i = 0; i < m_solids.size(); ++i)
        before.emplace(m_solids[i].get(), m_numbers[i]);
    m_numbers.clear();
    for (const SolidPointer &solid : solids) {
        const auto known = before.find(solid.get());
        m_numbers.push_back(known != before.end() ? known->second : m_nextNumber++);
    }
    m_solids = std::move(solids); // addresses of those before are free from here on
    m_lifted.solid = -1;
    m_ways.forgetOld();
    m_lifts.forgetOld();

    std::vector<int> there = m_numbers;
    std::sort(there.begin(), there.end());
    const auto isThere = [&](int number) {
        return std::binary_search(there.begin(), there.end(), number);
    };
    const auto forget = [&](auto &answers) {
        if (answers.size() > kMostAnswers)
            answers.clear();
        std::erase_if(answers, [&](const auto &answer) {
            const Question &asked = answer.first;
            return !isThere(asked.a) || !isThere(asked.b) ||
                   (asked.way >= 0 && !m_ways.isInUse(asked.way)) ||
                   (asked.lift >= 0 && !m_lifts.isInUse(asked.lift));
        });
    };
    forget(m_isFree);
    forget(m_until);
    forget(m_clear);
    forget(m_overlaps);
    m_depths = std::move(depths);
}

Collisions::Question Collisions::question(int a, int b, int way, int lift) const
{
    return {m_numbers[static_cast<std::size_t>(a)], m_numbers[static_cast<std::size_t>(b)], way,
            lift, depth(a, b)};
}

double Collisions::pressed(int a, int b) const
{
    const auto known = m_depths.find(std::minmax(a, b));
    return known == m_depths.end() ? kTouchingDepth : known->second;
}

const Solid &Collisions::lifted(int a, int lift)
{
    if (lift == kNotLifted)
        return solid(a);
    if (m_lifted.solid != a || m_lifted.lift != lift) {
        m_lifted.moved = movedBy(solid(a), m_lifts.vector(lift));
        m_lifted.solid = a;
        m_lifted.lift = lift;
    }
    return m_lifted.moved;
}

bool Collisions::comesFree(int a, int b, int way, int lift)
{
    const auto [known, isNew] = m_isFree.try_emplace(question(a, b, way, lift), false);
    if (isNew)
        known->second = fff::comesFree(lifted(a, lift), solid(b), m_ways.vector(way), depth(a, b));
    return known->second;
}

double Collisions::wayUntil(int a, int b, int way)
{
    const auto [known, isNew] = m_until.try_emplace(question(a, b, way, kNotLifted),
                                                    std::numeric_limits<double>::infinity());
    if (isNew) {
        if (const auto met = collisionAlong(solid(a), solid(b), m_ways.vector(way), depth(a, b)))
            known->second = met->from;
    }
    return known->second;
}

double Collisions::wayToClear(int a, int b, int way, int lift)
{
    const auto [known, isNew] = m_clear.try_emplace(question(a, b, way, lift), 0.0);
    if (isNew)
        known->second = fff::wayToClear(lifted(a, lift), solid(b), m_ways.vector(way), kNearParts);
    return known->second;
}

const std::optional<Interpenetration> &Collisions::overlap(int a, int b)
{
    const auto [known, isNew] = m_overlaps.try_emplace(question(a, b, -1, kNotLifted));
    if (isNew)
        known->second = interpenetration(solid(a), solid(b), depth(a, b));
    return known->second;
}

} // namespace fff
