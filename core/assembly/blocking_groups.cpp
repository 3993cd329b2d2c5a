// Groups that come off the rest as one: what slits hold together in a direction is a heap.
#include "core/assembly/blocking.h"
#include "core/assembly/smallest_sink.h"

#include <algorithm>
#include <utility>

namespace fff {

/// In which directions groups of what is there could come off the rest.
std::vector<int> Blocking::waysApart() const
{
    std::vector<char> isUsed(m_ways.size(), char(false));
    std::fill_n(isUsed.begin(), m_freeWays, char(true));
    for (const int part : m_group)
        if (has(part))
            for (const auto &[direction, count] : m_holding[static_cast<std::size_t>(part)].ways)
                if (count > 0)
                    isUsed[static_cast<std::size_t>(direction)] = true;
    std::vector<int> ways;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i])
            ways.push_back(static_cast<int>(i));
    }
    return ways;
}

const std::vector<int> &Blocking::looseSlides(int direction)
{
    const auto [known, isNew] = m_loose.try_emplace(direction);
    if (isNew) {
        const Vec3 &along = way(direction).along;
        for (std::size_t i = 0; i < m_holds.size(); ++i)
            if (along.cross(m_holds[i].slide).squaredNorm() <= m_holds[i].from)
                known->second.push_back(static_cast<int>(i));
    }
    return known->second;
}

Blocking::HeldParts Blocking::heldParts()
{
    HeldParts held;
    held.parts = there();
    std::reverse(held.parts.begin(), held.parts.end());
    for (std::size_t i = 0; i < held.parts.size(); ++i)
        m_placeOf[static_cast<std::size_t>(held.parts[i])] = static_cast<int>(i);
    for (const int part : held.parts) {
        held.begins.push_back(held.mates.size());
        for (const Mate &mate : m_mates[static_cast<std::size_t>(part)])
            if (mate.slide != kNone && has(mate.part))
                held.mates.push_back({m_placeOf[static_cast<std::size_t>(mate.part)], mate.slide});
    }
    held.begins.push_back(held.mates.size());
    return held;
}

std::optional<Blocking::Heaps> Blocking::heaps(const HeldParts &held, int direction)
{
    const std::vector<int> &loose = looseSlides(direction);
    for (const int slide : loose)
        m_isLoose[static_cast<std::size_t>(slide)] = true;
    Heaps heaps;
    heaps.heapOf.assign(held.parts.size(), kNone);
    heaps.places.reserve(held.parts.size());
    for (std::size_t i = 0; i < held.parts.size(); ++i) {
        if (heaps.heapOf[i] != kNone)
            continue;
        const int heap = static_cast<int>(heaps.begins.size());
        heaps.begins.push_back(heaps.places.size());
        heaps.places.push_back(static_cast<int>(i));
        heaps.heapOf[i] = heap;
        for (std::size_t next = heaps.begins.back(); next < heaps.places.size(); ++next) {
            const auto place = static_cast<std::size_t>(heaps.places[next]);
            for (std::size_t k = held.begins[place]; k < held.begins[place + 1]; ++k) {
                const HeldParts::Mate &mate = held.mates[k];
                int &ofMate = heaps.heapOf[static_cast<std::size_t>(mate.place)];
                if (ofMate != kNone || m_isLoose[static_cast<std::size_t>(mate.slide)])
                    continue;
                ofMate = heap;
                heaps.places.push_back(mate.place);
            }
        }
    }
    for (const int slide : loose)
        m_isLoose[static_cast<std::size_t>(slide)] = false;
    if (heaps.begins.size() < 2)
        return {};
    heaps.begins.push_back(heaps.places.size());
    return heaps;
}

std::optional<Group> Blocking::smallestOff(const HeldParts &held, const Heaps &heaps, int direction,
                                           std::size_t fewerThan)
{
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < heaps.count(); ++i)
        sizes.push_back(heaps.size(i));
    std::vector<std::vector<Obstacle> *> known(held.parts.size(), nullptr);
    // On to the next heap that is in the way of this one.
    const auto next = [&](int heap, EdgeCursor &cursor) -> std::optional<int> {
        const std::size_t begin = heaps.begins[static_cast<std::size_t>(heap)];
        for (; cursor.first < sizes[static_cast<std::size_t>(heap)];
             ++cursor.first, cursor.second = 0) {
            const auto place = static_cast<std::size_t>(heaps.places[begin + cursor.first]);
            const int part = held.parts[place];
            if (!known[place])
                known[place] = &obstaclesOf(part, direction).all;
            std::vector<Obstacle> &obstacles = *known[place];
            while (cursor.second < obstacles.size()) {
                Obstacle &obstacle = obstacles[cursor.second++];
                if (!has(obstacle.part))
                    continue;
                const int placeOfOther = m_placeOf[static_cast<std::size_t>(obstacle.part)];
                const int other = heaps.heapOf[static_cast<std::size_t>(placeOfOther)];
                if (other != heap && isInTheWay(obstacle, part, direction))
                    return other;
            }
        }
        return {};
    };
    const auto moved = smallestSink(sizes, fewerThan, next);
    if (!moved)
        return {};
    Group together;
    for (const int heap : *moved) {
        const auto i = static_cast<std::size_t>(heap);
        for (std::size_t k = heaps.begins[i]; k < heaps.begins[i + 1]; ++k)
            together.push_back(held.parts[static_cast<std::size_t>(heaps.places[k])]);
    }
    std::sort(together.begin(), together.end());
    return together;
}

std::optional<Blocking::Removal> Blocking::smallestOff()
{
    const HeldParts held = heldParts();
    std::optional<Group> smallest;
    int along = 0;
    std::optional<Heaps> heaps;
    Vec3 before = Vec3::Zero(); // the direction that they are of
    for (const int direction : waysApart()) {
        if (isOutOfTime())
            return {};
        if (before != -way(direction).along) // there and back they are the same
            heaps = this->heaps(held, direction);
        before = way(direction).along;
        if (!heaps)
            continue;
        std::optional<Group> moved =
            smallestOff(held, *heaps, direction, smallest ? smallest->size() : held.parts.size());
        if (moved) {
            smallest = std::move(moved);
            along = direction;
        }
    }
    if (!smallest)
        return {};
    return Removal{*std::move(smallest), {{way(along).along, 0.0}}};
}

} // namespace fff
