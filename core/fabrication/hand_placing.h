// A part of a layout that somebody puts elsewhere by hand: where it may lie, and where it goes when
// it is let go near others.
#pragma once

#include "core/fabrication/layout.h"

#include <vector>

namespace fff {

/// Where a part lies on one of the sheets of a layout, as a Placement.
struct HandPlace
{
    int sheet = 0; // index into Layout::sheets
    Vec2 turn = Vec2::UnitX();
    Vec2 offset = Vec2::Zero();

    bool operator==(const HandPlace &) const = default;
};

/// Turned about the middle of its box there. turn: cosine and sine
HandPlace turnedInPlace(const Part &part, const HandPlace &place, const Vec2 &turn);

class HandPlacing
{
public:
    /// Parts and layout outlive it.
    HandPlacing(const std::vector<Part> &parts, const Layout &layout, const LayoutOptions &options,
                int part);

    /// Off the sheet's edge by the margin, off all others there by the spacing, by the judge of all
    /// layouts (nesting/proof.h); on a sheet of its stock that has room for others.
    bool isSound(const HandPlace &place) const;
    /// Within `reach`, mm, to where it has its distance from others and from the edge, and no more;
    /// the place itself where there is none.
    HandPlace snapped(HandPlace place, double reach) const;
    /// Whether others of its stock lie on that sheet, or may.
    bool takes(int sheet) const;

private:
    std::vector<Region> neighbours(const HandPlace &place, double reach) const;

    const std::vector<Part> &m_parts;
    const Layout &m_layout;
    const LayoutOptions m_options;
    const int m_part;
};

} // namespace fff
