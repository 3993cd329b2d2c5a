// How long the edges of a plate's mesh should be, place by place.
#pragma once

#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// A place where edges should be short, mm.
struct FinePlace
{
    Vec2 point = Vec2::Zero();
    double edge = 0.0;
};

/// Corners of the region whose inner angle is above 200°.
std::vector<Vec2> sharpCorners(const Region &region);

class PlateSizing
{
public:
    /// edge: where nothing asks for less, mm; linesAcross: edges across what is narrow.
    /// O(vertices²) at most.
    PlateSizing(const Region &region, double edge, double linesAcross);

    /// mm
    double edgeAt(const Vec2 &point) const;

private:
    void addNarrowPlaces(const Region &region, double linesAcross);

    double m_edge;
    std::vector<FinePlace> m_fine;
};

} // namespace fff
