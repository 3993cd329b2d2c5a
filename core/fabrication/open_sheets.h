// The sheets on which one try of a layout puts its boxes. Internal to fabrication.
#pragma once

#include "core/fabrication/skyline.h"

#include <array>
#include <span>
#include <vector>

namespace fff {

/// Sheets of one size, as many as it takes: every box goes on the first that has room for it.
/// Sheets only get fuller, so one that had no room for a box has none for an equal one, nor has one
/// whose lowest place is too high for it. Neither is looked at again: parts of a few sizes take
/// time in line with their number.
class OpenSheets
{
public:
    explicit OpenSheets(const Vec2 &size) : m_size(size), m_lowest(2) {}

    std::size_t count() const { return m_skylines.size(); }
    /// How often a sheet was searched for a place: what it cost.
    std::size_t searches() const { return m_searches; }

    struct Place
    {
        std::size_t sheet = 0;
        std::size_t box = 0; // which one it was
        Skyline::Place on;
    };
    /// Puts one of the boxes, which are the ways in which a part may lie; at least one of them fits
    /// an empty sheet. On its sheet it is the one that comes lowest, of equal ones the first.
    Place put(std::span<const Vec2> boxes);

private:
    /// Before which sheet there is no room for a box of this size.
    struct Known
    {
        Vec2 box = Vec2::Zero();
        std::size_t first = 0;
    };
    /// That of the box, or one that is given up for it.
    Known &knownOf(const Vec2 &box);
    std::size_t next(std::size_t from, double height) const;
    void add();
    void setLowest(std::size_t sheet);

    Vec2 m_size;
    std::size_t m_searches = 0;
    std::vector<Skyline> m_skylines;
    // Of each sheet how low something can lie; before them the least of every two, of every two of
    // these, and so on: the least of all is at 1.
    std::vector<double> m_lowest;
    static constexpr int kKnownBits = 9;
    std::array<Known, 1u << kKnownBits> m_known;
};

} // namespace fff
