// The contour that the samples of a stroke make.
#pragma once

#include "core/geometry/contour.h"
#include "core/stroke/guided_line.h"
#include "core/stroke/meant_line.h"
#include "core/stroke/slit_neck.h"
#include "core/stroke/symmetry.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

struct StrokeContourOptions
{
    double tolerance = 0.5; // mm that the fit may be off the samples
    /// Across which a stroke on one side is mirrored; none where there is nothing to mirror at.
    std::optional<MirrorAxis> axis = {};
    double mirrorRatio = kMirrorRatio;
    bool isSymmetryOn = true;                  // off: the axis is judged, not used
    std::shared_ptr<const Guides> guides = {}; // that it follows; null: none
    std::vector<FreeSamples> free = {};        // of the samples, by which it does not
    std::optional<SlitToReach> slit = {};      // that is to hold it; none: nothing is
};

/// What is seen while drawing and what a release makes, from one and the same fit.
///
/// The contour is closed by what `isMirrored` says: plain, the chain fitted - closing; mirrored,
/// the chain opening - fitted - closing, which runs from the axis to the axis, and `mirrored`.
struct StrokeContour
{
    /// Why there is no contour.
    enum class Refusal {
        None,
        TooShort,           // no line yet, or a dot
        Twitch,             // twitch.h
        NoArea,             // it goes there and back, along a line
        CrossesWithoutLoop, // it crosses itself, but no loop of it is large enough
    };

    std::vector<CubicBezier> fitted;    // open chain along the samples (of the half that is kept)
    std::optional<CubicBezier> opening; // from the axis to its start
    std::optional<CubicBezier> closing; // from its end to its start or the axis; none when there
    std::vector<CubicBezier> mirrored;  // the other half, from the chain's end back to its start
    /// Closed, free of crossings; none while nothing is enclosed that can be told from a line or a
    /// dot: its area is below the tolerance times its extent, or that below five tolerances.
    std::optional<Contour> contour;
    Refusal refusal = Refusal::None; // None if and only if there is a contour
    bool wasCrossing = false;        // the closed chain crossed itself, the largest loop was kept
    bool wasCutAtAxis = false;       // it came over the axis and back, the largest half was kept

    /// What was drawn beside its slit; the contour has a neck that reaches into that.
    std::optional<Contour> beside;
    bool isApart = false; // too far beside it for that

    std::optional<MirrorAxis> axis;          // as in the options
    std::optional<SymmetryVerdict> symmetry; // of the samples, where there is an axis
    bool isMirrored = false;                 // one-sided, symmetry is on, and the halves meet
    bool doHalvesMeet = true;                // false: not mirrored for this, it would be two pieces

    std::optional<GuidedLine> guided; // where there are guides: what it follows of them

    /// What it took, in samples that were looked at: the same on every machine.
    std::size_t work = 0;
};

/// samples: canvas coordinates, mm. A function of all samples, so that nothing jumps at the
/// release.
StrokeContour strokeContour(const std::vector<Vec2> &samples, const StrokeContourOptions &options);
/// The same while it is drawn: `meant` follows the samples, all of which are looked at
/// (SampledLine::usable), with fitOptions().
StrokeContour strokeContour(const std::vector<Vec2> &samples, const MeantLine &meant,
                            const StrokeContourOptions &options);

/// How such a stroke is fitted.
FitOptions fitOptions(const StrokeContourOptions &options);

} // namespace fff
