// Where forces act on a plate, and how they are spread there.
//
// All in the section's frame (u, v, n), mm. A wrench is a force (N) and a moment (N·mm) about the
// attachment's point: six numbers.
#pragma once

#include "core/physics/plate_model.h"

#include <vector>

namespace fff {

using WrenchVector = Eigen::Matrix<double, 6, 1>;

/// A point that may press or be pressed along one direction.
struct PatchPoint
{
    Vec2 point = Vec2::Zero();
    Vec3 way = Vec3::UnitX(); // unit
    double extent = 1.0;      // mm or mm² of the patch that it stands for
};

/// Where something holds the plate: points at which it presses.
struct PlateAttachment
{
    Vec2 about = Vec2::Zero(); // moments of a wrench are about this
    double size = 1.0;         // mm, of the patch: the scale of moments
    std::vector<PatchPoint> points;
};

/// A slit joint as one of its two sections sees it.
struct SlitAttachment
{
    Vec2 inner = Vec2::Zero();  // where the two slits meet
    Vec2 opens = Vec2::UnitX(); // unit: the way in which the slit of this section opens
    double depth = 0.0;         // mm, of the slit of this section
    double width = 3.0;         // mm, of it
    double heldDepth = 0.0;     // mm, of the partner's slit, which holds this section's faces
    double heldWidth = 3.0;     // mm, of the strip of faces that it holds: the partner's thickness
};

/// What presses in a slit joint: the walls of the own slit along the plate's surface square to
/// them, its bottom along the slit, and the two faces that the partner's slit holds across the
/// plate. A patch on the slit's walls alone would be far too soft about the slit's axis.
PlateAttachment slitAttachment(const PlateModel &model, const SlitAttachment &slit);

/// A slot round the whole of the partner: walls all round. axis: unit, along its length.
PlateAttachment slotAttachment(const PlateModel &model, const Vec2 &middle, const Vec2 &axis,
                               double length, double width);

/// What presses in every direction within a disc: a foot (half a thickness), a weight.
PlateAttachment discAttachment(const PlateModel &model, const Vec2 &middle, double radius);

/// The forces at the points (n), N, that together are the wrench: those of least squares. What the
/// patch cannot carry stays out.
///     minimise Σ c²/extent   subject to   Σ c way = f,   Σ c (point − about) × way = tau
Eigen::VectorXd pressures(const PlateAttachment &attachment, const WrenchVector &wrench);

/// Adds the forces of a wrench on an attachment.
void addWrench(PlateField &field, const PlateModel &model, const PlateAttachment &attachment,
               const WrenchVector &wrench);

/// How far it moves and turns where the plate is displaced so, as work counts it: (mm, rad) about
/// the attachment's point.
WrenchVector attachmentMotion(const PlateModel &model, const PlateField &displacements,
                              const PlateAttachment &attachment);

} // namespace fff
