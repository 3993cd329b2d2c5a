// Where words go that lie over the view: each beside what it names, none on another one, on the
// marks that are in the hand, or beyond the view's edge. One place decides for all kinds of them.
#pragma once

#include "core/geometry/vector.h"

#include <optional>
#include <vector>

namespace fff {

/// Boxes in px, y down, as the screen has them.
class LabelRoom
{
public:
    /// What stays free between two boxes, and between a box and the view's edge, px.
    static constexpr double kApart = 2.0, kEdge = 4.0;
    /// More px than any view has.
    static constexpr double kAnywhere = 1e6;

    /// viewport  width and height, px
    explicit LabelRoom(const Vec2 &viewport) : m_viewport(viewport) {}

    /// No words come there.
    void take(const Box2 &box) { m_taken.push_back(box); }
    /// The same of a line, some px to both sides of it.
    void takeLine(const Vec2 &from, const Vec2 &to, double halfWidth);
    const std::vector<Box2> &taken() const { return m_taken; }

    /// In the view, and on nothing that is taken.
    bool isFree(const Box2 &box) const;
    /// Where a box of this size goes whose middle is wanted there: the free place nearest to that,
    /// upright ways first, since words are wide. Nothing where there is none within `farthest` px
    /// of the wanted place, or of the view where that lies outside it. What is farther away costs
    /// nothing.
    std::optional<Box2> placeFor(const Vec2 &middle, const Vec2 &size,
                                 double farthest = kAnywhere) const;

private:
    bool isInView(const Box2 &box) const;

    Vec2 m_viewport;
    std::vector<Box2> m_taken;
};

bool overlap(const Box2 &a, const Box2 &b);

} // namespace fff
