// Where a section is strong enough: the mass that each place of it would bear.
#pragma once

#include "core/analysis/bearing_probe.h"
#include "core/analysis/stage.h"

#include <array>
#include <vector>

namespace fff {

/// A section in triangles, and what each of their corners bears: alone, besides all that hangs on
/// the model already.
struct BearingMap
{
    SectionRef section;
    AnalysisPointer analysis;                  // that it is about
    std::vector<Vec2> points;                  // n, frame coordinates, mm
    std::vector<Bearing> bearings;             // n
    std::vector<std::array<int, 3>> triangles; // counter-clockwise, indices of points
    double least = 0.0, most = 0.0; // kg, of all points that were worked out; both 0 without any

    enum class Obstacle {
        None,
        NotThere, // the section has no material, or is no more
        Falls,    // the model does not stand as it is
        Breaks,   // nor does it bear what is on it already
        NotRated, // of no sheet it is known what it bears
    };
    Obstacle obstacle = Obstacle::None;
};

/// The least of strength (as the verdict has it, without the safety factor), of standing and of
/// what joints hold, at each point of a mesh of the section's pieces.
///
/// One solution of the structure for each mass that is tried, with the same factors where the same
/// feet press; about three at each point, since stresses are nearly in proportion, and neighbours
/// tell where to begin. Masses are exact to kBorneAccuracy.
/// Errors  Cancelled; NotWorkedOut, with the section's name, where it cannot be cut into triangles.
Result<BearingMap> bearingMap(AnalysisPointer analysis, const SectionRef &section,
                              const StrengthRules &rules, StrengthCaches &caches,
                              const LongWork &work = {});

/// What a point of the section bears, by its triangle: the mass between its corners', the end of
/// the nearest. Nothing outside of all triangles.
std::optional<Bearing> bearingAt(const BearingMap &map, const Vec2 &point);

/// "Bears 1.2 kg here, then Rib 4 cracks beside its slit."
Message bearingText(const Bearing &bearing, const Model &model);

} // namespace fff
