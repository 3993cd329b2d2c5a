// Planes across a contour that is a spine, and what a cut in one of them has to do with its place.
// Internal to operations.
#pragma once

#include "core/geometry/arc_length.h"
#include "core/model/section.h"
#include "core/templates/template_cut.h"

#include <optional>
#include <vector>

namespace fff {

struct SpineRequest
{
    double from = 0.0, to = 1.0; // shares of the contour's length, 0 … 1; from > to: past its start
    bool isByCount = true;
    int count = 1;
    double spacing = 1.0; // mm along the curve, > 0
    double shift = 0.0;   // of all planes, as a share of their spacing
    int most = 1;         // planes
};

struct SpinePlane
{
    int number = 0; // 0 … in the order along the spine
    Frame frame;    // at the spine; its normal is the way it runs, its y the section's normal
};

/// The contour of a section, or a part of it.
class SpinePlanes
{
public:
    /// spine  outlives it.
    SpinePlanes(const Section &spine, const SpineRequest &request);

    /// Evenly by arc length about the middle of the part. By count each has its share of it; by
    /// spacing there are as many as the part has room for, and one at least. All round, places
    /// beyond the start go on from the end, and no two come closer than the spacing; of a part what
    /// a shift takes beyond an end is left out.
    std::vector<SpinePlane> planes() const;

    /// Of what a plane cuts the one loop that is no hole and belongs to its place, by its place in
    /// the list: the smallest that the spine goes through there, else the one that it passes
    /// nearest. Nothing where the part of the spine is nearer to that one elsewhere: so planes do
    /// not cut what is another's across a bend.
    std::optional<std::size_t> loopAt(const SpinePlane &plane,
                                      const std::vector<TemplateLoop> &loops) const;

private:
    bool isRing() const { return m_request.to - m_request.from >= 1.0; }
    double distanceTo(const Vec3 &point) const;

    const Section &m_spine;
    SpineRequest m_request; // from < to
    ArcLength m_length;
    std::vector<Vec3> m_chords; // of the part, in the world
};

} // namespace fff
