// How a joint presses on the walls of its slit, and with that on the prongs to both sides of it.
#pragma once

#include "core/physics/applied_force.h"

namespace fff {

/// How the partner sits in a slit.
enum class SlitFit { Loose, Tight };

/// Force along a wall's normal and its moment about the slit's root: N, N·mm.
struct WallForce
{
    double force = 0.0, moment = 0.0;
};

/// The part of a joint's wrench that only walls can bear: its force across the slit F and its
/// moment M about n, as a pressure that is linear along the slit,
///
///     p(s) = a + b s,   ∫ p ds = F,   ∫ p s ds = M,   s = 0 … depth from the root
///
/// which is that of least squares. A tight slit holds the partner on both walls, each bears half of
/// it. In one with play a wall is pressed but never pulled: where p > 0 the wall to the left of the
/// opening has it all, where p < 0 the one to the right. Nobody knows which of them a slit is, so
/// that a prong is judged by what is worse for it. Finite elements with walls that can only be
/// pressed find up to a fourth less of a moment, and next to nothing of a force right through the
/// root.
///
/// What presses on the bottom or pulls out of the slit, and all that acts across the sheet, stays
/// at the root: beyond it are the faces that the partner's slit holds.
///
/// Source  the product's mechanics, 2.1 and 3.
class WallPressure
{
public:
    /// None.
    WallPressure() = default;
    /// Of the force of a link with a slit of some depth.
    explicit WallPressure(const AppliedForce &link);

    /// On the wall to the left of the opening, or to the right, from one share of the depth to
    /// another (0 at the root, 1 at the mouth).
    WallForce on(bool isLeft, double from, double to, SlitFit fit = SlitFit::Loose) const;

private:
    WallForce all(double begin, double end) const; // mm from the root

    double m_depth = 0.0;
    double m_atRoot = 0.0; // a, N/mm
    double m_slope = 0.0;  // b, N/mm²
};

} // namespace fff
