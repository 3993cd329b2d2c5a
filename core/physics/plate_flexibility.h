// How far a plate gives where it is attached.
#pragma once

#include "core/geometry/frame.h"
#include "core/physics/plate_attachment.h"

namespace fff {

/// n attachments, six rows each: displacement (mm) and rotation (rad) of the attachment, as work
/// counts them, for forces (N) and moments (N·mm) there. Right in equilibrium only: for forces on
/// one plate whose sum and moment vanish.
struct PlateFlexibility
{
    Eigen::MatrixXd compliance; // 6n × 6n, symmetric, positive semi-definite
    Eigen::VectorXd deflection; // 6n, under what acts besides: weight and loads

    /// The same with vectors as the world sees them.
    PlateFlexibility inWorld(const Frame &frame) const;
};

///     C = G' K⁻¹ G,   d = G' K⁻¹ f,   G: forces on the mesh of unit wrenches, f: `forces`
/// Errors  Cancelled.
Result<PlateFlexibility> plateFlexibility(const PlateModel &model,
                                          const std::vector<PlateAttachment> &attachments,
                                          const PlateField &forces, const LongWork &work = {});

} // namespace fff
