#include "core/physics/plate_attachment.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr int kAlong = 16;         // points along a wall or a strip
constexpr int kAcross = 3;         // across a strip, on a slit's bottom
constexpr double kOffPlate = 0.25; // of the patch's width: farther from the plate is not on it
constexpr double kNotHeld = 1e-9;  // least eigenvalue over the largest of what a patch can carry

Vec3 inPlane(const Vec2 &way)
{
    return {way.x(), way.y(), 0.0};
}

/// Adds a point where the plate is; what lies beside it is drawn to it.
void addPoint(PlateAttachment &attachment, const PlateModel &model, const Vec2 &point,
              const Vec3 &way, double extent, double off)
{
    const PlateLocator::Place place = model.place(point);
    if (place.distance <= off)
        attachment.points.push_back({place.point, way, extent});
}

using Gathering = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Columns: the wrench of a unit force at each point, moments over the patch's size.
Gathering gathering(const PlateAttachment &attachment)
{
    Gathering columns(6, static_cast<Eigen::Index>(attachment.points.size()));
    for (std::size_t i = 0; i < attachment.points.size(); ++i) {
        const PatchPoint &p = attachment.points[i];
        const Vec2 arm = p.point - attachment.about;
        columns.col(static_cast<Eigen::Index>(i)) << p.way,
            Vec3(arm.x(), arm.y(), 0.0).cross(p.way) / attachment.size;
    }
    return columns;
}

Eigen::VectorXd extents(const PlateAttachment &attachment)
{
    Eigen::VectorXd result(static_cast<Eigen::Index>(attachment.points.size()));
    for (std::size_t i = 0; i < attachment.points.size(); ++i)
        result[static_cast<Eigen::Index>(i)] = attachment.points[i].extent;
    return result;
}

bool holdsAll(const PlateAttachment &attachment)
{
    const Gathering columns = gathering(attachment);
    if (columns.cols() < 6)
        return false;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(
        columns * columns.transpose(), Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()[0] > kNotHeld * eigen.eigenvalues()[5];
}

/// Points of a disc that press every way: a middle and two rings.
void addDisc(PlateAttachment &attachment, const PlateModel &model, const Vec2 &middle,
             double radius, double off)
{
    const double extent = std::numbers::pi * radius * radius / 17.0;
    const auto add = [&](const Vec2 &point) {
        for (const Vec3 &way : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
            addPoint(attachment, model, point, way, extent, off);
    };
    add(middle);
    for (int k = 0; k < 16; ++k) {
        const double turn = (k + 0.5) * std::numbers::pi / 8.0;
        const double from = radius * (k % 2 == 0 ? 0.5 : 0.9);
        add(middle + from * Vec2(std::cos(turn), std::sin(turn)));
    }
}

/// What cannot hold everything is held as by a spot of glue as well.
void completed(PlateAttachment &attachment, const PlateModel &model)
{
    for (double radius = attachment.size; !holdsAll(attachment); radius *= 2.0) {
        addDisc(attachment, model, attachment.about, radius, radius);
        if (radius > 1e3 * attachment.size)
            return; // a plate without width
    }
}

} // namespace

PlateAttachment slitAttachment(const PlateModel &model, const SlitAttachment &slit)
{
    PlateAttachment attachment;
    attachment.about = slit.inner;
    attachment.size = std::max({slit.depth, slit.heldDepth, slit.width, slit.heldWidth});
    const Vec2 d = slit.opens, e = perpendicular(d);
    const double off = kOffPlate * slit.width;
    for (int i = 0; i < kAlong; ++i) {
        const double share = (i + 0.5) / kAlong;
        for (const double side : {-0.5, 0.5})
            addPoint(attachment, model, slit.inner + share * slit.depth * d + side * slit.width * e,
                     inPlane(e), slit.depth / kAlong, off);
        for (int k = 0; k < kAcross; ++k) {
            const double side = k / (kAcross - 1.0) - 0.5;
            addPoint(attachment, model,
                     slit.inner - share * slit.heldDepth * d + side * slit.heldWidth * e,
                     Vec3::UnitZ(), slit.heldDepth / kAlong, off);
        }
    }
    for (int k = 0; k < kAcross; ++k) {
        const double side = (k + 0.5) / kAcross - 0.5;
        addPoint(attachment, model, slit.inner + side * slit.width * e, inPlane(d),
                 slit.width / kAcross, off);
    }
    completed(attachment, model);
    return attachment;
}

PlateAttachment slotAttachment(const PlateModel &model, const Vec2 &middle, const Vec2 &axis,
                               double length, double width)
{
    PlateAttachment attachment;
    attachment.about = middle;
    attachment.size = std::max(length, width);
    const Vec2 e = perpendicular(axis);
    const double off = kOffPlate * width;
    for (int i = 0; i < kAlong; ++i) {
        const double share = (i + 0.5) / kAlong - 0.5;
        for (const double side : {-0.5, 0.5}) {
            const Vec2 onWall = middle + share * length * axis + side * width * e;
            addPoint(attachment, model, onWall, inPlane(e), length / kAlong, off);
            addPoint(attachment, model, onWall, Vec3::UnitZ(), length / kAlong, off);
        }
    }
    for (int k = 0; k < kAcross; ++k) {
        const double share = (k + 0.5) / kAcross - 0.5;
        for (const double end : {-0.5, 0.5})
            addPoint(attachment, model, middle + end * length * axis + share * width * e,
                     inPlane(axis), width / kAcross, off);
    }
    completed(attachment, model);
    return attachment;
}

PlateAttachment discAttachment(const PlateModel &model, const Vec2 &middle, double radius)
{
    PlateAttachment attachment;
    attachment.about = middle;
    attachment.size = radius;
    addDisc(attachment, model, middle, radius, kOffPlate * radius);
    completed(attachment, model);
    return attachment;
}

Eigen::VectorXd pressures(const PlateAttachment &attachment, const WrenchVector &wrench)
{
    const Gathering columns = gathering(attachment);
    const Eigen::VectorXd weights = extents(attachment);
    WrenchVector scaled = wrench;
    scaled.tail<3>() /= attachment.size;
    const Eigen::Matrix<double, 6, 6> normal = columns * weights.asDiagonal() * columns.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(normal);
    WrenchVector inverse = WrenchVector::Zero();
    for (int i = 0; i < 6; ++i) {
        if (eigen.eigenvalues()[i] > kNotHeld * eigen.eigenvalues()[5])
            inverse[i] = 1.0 / eigen.eigenvalues()[i];
    }
    const Eigen::Matrix<double, 6, 6> turn = eigen.eigenvectors();
    return weights.asDiagonal() * columns.transpose() *
           (turn * (inverse.asDiagonal() * (turn.transpose() * scaled)));
}

void addWrench(PlateField &field, const PlateModel &model, const PlateAttachment &attachment,
               const WrenchVector &wrench)
{
    const Eigen::VectorXd forces = pressures(attachment, wrench);
    for (std::size_t i = 0; i < attachment.points.size(); ++i)
        model.addForce(field, model.place(attachment.points[i].point),
                       forces[static_cast<Eigen::Index>(i)] * attachment.points[i].way);
}

WrenchVector attachmentMotion(const PlateModel &model, const PlateField &displacements,
                              const PlateAttachment &attachment)
{
    Eigen::VectorXd moved(static_cast<Eigen::Index>(attachment.points.size()));
    for (std::size_t i = 0; i < attachment.points.size(); ++i) {
        const PatchPoint &p = attachment.points[i];
        moved[static_cast<Eigen::Index>(i)] =
            p.way.dot(model.displacement(displacements, model.place(p.point)));
    }
    WrenchVector motion;
    for (int k = 0; k < 6; ++k)
        motion[k] = moved.dot(pressures(attachment, WrenchVector::Unit(k)));
    return motion;
}

} // namespace fff
