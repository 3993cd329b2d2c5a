// What sections are to show of a mesh: points of its outlines, seen from all around, and of its
// surface; and how much of that a section shows.
#pragma once

#include "core/analysis/suggesting/main_faces.h"
#include "core/analysis/suggesting/point_buckets.h"
#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/templates/triangle_mesh.h"

#include <vector>

namespace fff {

/// Immutable.
class FormSamples
{
public:
    /// positions  n × 3, in the world, mm; the triangles are of these. Everything is measured by
    ///            the mesh's size, so that a larger one has the same samples.
    /// Errors     Cancelled. O(triangles · directions).
    static Result<FormSamples> of(const std::vector<Vec3> &positions,
                                  const std::vector<Triangle> &triangles, const LongWork &work);

    std::size_t size() const { return m_weights.size(); }
    /// Of the surface, spread evenly over it, world, mm.
    const std::vector<Vec3> &surface() const { return m_surface.points(); }
    const std::vector<MainFace> &faces() const { return m_faces; }
    /// Of the mesh, its largest extent, mm.
    double meshSize() const { return m_meshSize; }
    /// Distance between neighbours among these, about, mm.
    double spacing() const { return m_spacing; }
    /// So far apart, mm, points of a contour have to be for shownBy().
    double step() const { return m_step; }

    /// How well one sample is shown.
    struct Shown
    {
        std::uint32_t sample = 0;
        float share = 0.0F; // of the sample's weight, above 0
    };
    /// By lines with these points on them, step() apart, in the world. A sample of an outline is
    /// shown all by a point that is seen beside it, within kNearOutline of the size, one of the
    /// surface by a point within kNearSurface; from there on by less, down to nothing at four times
    /// and at twice and a half as far.
    std::vector<Shown> shownBy(const std::vector<Vec3> &points) const;
    double weight(std::uint32_t sample) const { return m_weights[sample]; } // all together: 1

private:
    struct View
    {
        Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();
        PointBuckets outline; // as (right, up, 0)
        std::uint32_t first = 0;
        Vec3 seen(const Vec3 &p) const { return {right.dot(p), up.dot(p), 0.0}; }
    };

    std::vector<View> m_views;
    PointBuckets m_surface;
    std::vector<MainFace> m_faces;
    std::uint32_t m_firstOfSurface = 0;
    std::vector<double> m_weights;
    double m_meshSize = 1.0, m_spacing = 1.0, m_step = 1.0, m_nearOutline = 1.0,
           m_nearSurface = 1.0; // mm
};

/// Of the mesh's size: 3 mm of what is 254 mm large, with a little to spare.
inline constexpr double kNearOutline = 2.5 / 254.0;
/// The same for the surface.
inline constexpr double kNearSurface = 8.0 / 254.0;

} // namespace fff
