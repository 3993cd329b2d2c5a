// How stiffly two plates hold each other where their slits meet.
#pragma once

#include "core/physics/structure.h"

#include <Eigen/Core>

namespace fff {

/// Of a link about its point, in world axes: rows and columns are three of translation, then three
/// of rotation. What `a` has moved and turned more than `b`, times this, is the wrench that holds
/// it back. N/mm, N, N·mm/rad.
using LinkStiffness = Eigen::Matrix<double, 6, 6>;

/// What a link resists with, but for the translation along its axis, which is apart because it may
/// be bounded (pulled out).
struct LinkSprings
{
    LinkStiffness across = LinkStiffness::Zero(); // all but the translation along the axis
    double along = 0.0;                           // N/mm
};

/// Unit: along which two plates meet.
Vec3 edgeOf(const Link &link);

/// The springs of a link.
///
///     about n_a   c E_a t_a L_a²,  c = 0.29 tight, 0.155 with play (one wall of two presses)
///     about n_b   c E_b t_b L_b²
///     about axis  0.15 (E_a t_a² L_b + E_b t_b² L_a)       an estimate, to a factor of two
///     along n_b   1.0 E_a t_a      along n_a  1.0 E_b t_b      along axis  0.5 min(E_a t_a, E_b
///     t_b)
///
/// n are the plates' normals, t their thickness, L the depth of their slits. Of plates that are not
/// square to each other, the mean of both choices of which normal is an axis: which of the two
/// sections is called `a` then makes no difference. A slot of length L, as deep as its host h is
/// thick, holds its guest g in the same ways, by analogy: 1.0 E_h t_h across the guest, 1.0 E_g t_g
/// along the slot, c E_g t_g t_h² about the guest's normal, c E_h t_h L² about the way out, c E_h
/// t_h² L about the slot; the last is an estimate, and is what an axis that is free leaves out.
/// Fingers, by analogy, half of it for each of the two links: 1.0 E t along the edge, c E t · t L
/// about what is square to it, nothing about the edge; 0.5 E t along either axis. What is no
/// positive number is taken for very little, so that the stiffness is positive definite but for
/// what is freed.
///
/// isAxisFree  without the resistance about the axis
/// Source  the product's mechanics, section 1.3: plane stress of a slit with a rigid insert.
LinkSprings linkSprings(const Link &link, bool isAxisFree);

} // namespace fff
