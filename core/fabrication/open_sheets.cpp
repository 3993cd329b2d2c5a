#include "core/fabrication/open_sheets.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>

namespace fff {

OpenSheets::Place OpenSheets::put(std::span<const Vec2> boxes)
{
    constexpr std::size_t kMostBoxes = 2;
    assert(!boxes.empty() && boxes.size() <= kMostBoxes && "a part lies in one of two ways");
    std::array<Known, kMostBoxes> known;
    double height = std::numeric_limits<double>::infinity();
    std::size_t sheet = m_skylines.size();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        known[i] = knownOf(boxes[i]);
        height = std::min(height, boxes[i].y());
        sheet = std::min(sheet, known[i].first);
    }
    Place place;
    place.on.top = std::numeric_limits<double>::infinity();
    for (;; ++sheet) {
        sheet = next(sheet, height);
        if (sheet == m_skylines.size())
            add();
        std::array<bool, kMostBoxes> fits{};
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (known[i].first > sheet)
                continue;
            ++m_searches;
            const Skyline::Place on = m_skylines[sheet].find(boxes[i]);
            fits[i] = on.top < std::numeric_limits<double>::infinity();
            if (on.top < place.on.top)
                place = {sheet, i, on};
        }
        if (!fits[0] && !fits[1])
            continue;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            knownOf(boxes[i]).first = std::max(known[i].first, fits[i] ? sheet : sheet + 1);
        break;
    }
    m_skylines[sheet].put(boxes[place.box], place.on);
    setLowest(sheet);
    return place;
}

OpenSheets::Known &OpenSheets::knownOf(const Vec2 &box)
{
    constexpr std::uint64_t kMixer = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
    std::uint64_t hash = std::bit_cast<std::uint64_t>(box.x()) * kMixer;
    hash = (hash ^ std::bit_cast<std::uint64_t>(box.y())) * kMixer;
    // In the first of a few places that is its own or free; else another size gives way.
    constexpr std::size_t kPlaces = 4;
    const std::size_t first = hash >> (64 - kKnownBits);
    const auto at = [&](std::size_t i) -> Known & { return m_known[(first + i) % m_known.size()]; };
    for (std::size_t i = 0; i < kPlaces; ++i) {
        if (at(i).box == box)
            return at(i);
        if (at(i).box.isZero())
            return at(i) = {box, 0};
    }
    return at(m_searches % kPlaces) = {box, 0};
}

/// The first sheet from there on whose lowest place is low enough, or their number.
std::size_t OpenSheets::next(std::size_t from, double height) const
{
    const std::size_t width = m_lowest.size() / 2;
    std::size_t node = width + from;
    if (from >= m_skylines.size())
        return m_skylines.size();
    while (!Skyline::isWithin(m_lowest[node] + height, m_size)) {
        while (node % 2 == 1)
            node /= 2;
        if (node == 0)
            return m_skylines.size(); // there was nothing to the right any more
        ++node;
    }
    while (node < width) {
        node *= 2;
        node += Skyline::isWithin(m_lowest[node] + height, m_size) ? 0 : 1;
    }
    return node - width;
}

void OpenSheets::add()
{
    constexpr double kNoSheet = std::numeric_limits<double>::infinity();
    m_skylines.emplace_back(m_size);
    if (std::size_t width = m_lowest.size() / 2; m_skylines.size() > width) {
        width *= 2;
        m_lowest.assign(2 * width, kNoSheet);
        for (std::size_t i = 0; i < m_skylines.size(); ++i)
            m_lowest[width + i] = m_skylines[i].lowest();
        for (std::size_t node = width - 1; node > 0; --node)
            m_lowest[node] = std::min(m_lowest[2 * node], m_lowest[2 * node + 1]);
    }
    setLowest(m_skylines.size() - 1);
}

void OpenSheets::setLowest(std::size_t sheet)
{
    std::size_t node = m_lowest.size() / 2 + sheet;
    m_lowest[node] = m_skylines[sheet].lowest();
    while (node /= 2)
        m_lowest[node] = std::min(m_lowest[2 * node], m_lowest[2 * node + 1]);
}

} // namespace fff
