// A plate as finite elements: how it gives under forces, in its plane and across it.
//
// Frame: that of the section, mm. A force is (u, v, n), a moment likewise; n = u × v.
#pragma once

#include "core/physics/plate_locator.h"
#include "core/physics/plate_mesh.h"

#include <Eigen/Core>
#include <memory>

namespace fff {

/// All of it has to be said: there is no usual plate.
struct PlateMaterial
{
    PlateMaterial(double thick, double stiff, double narrowing, double dense)
        : thickness(thick), modulus(stiff), poisson(narrowing), density(dense)
    {
    }

    double thickness; // mm
    double modulus;   // MPa
    double poisson;   // no unit
    double density;   // kg/mm³
};

/// Forces on the points of a mesh, or their displacements.
struct PlateField
{
    Eigen::VectorXd membrane; // u, v of every point: N or mm
    Eigen::VectorXd bending;  // w, rotation about u, about v of every corner: N, N·mm or mm, rad
};

/// A stretch of the boundary that is built in.
struct PlateClamp
{
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

/// Membrane of linear strain triangles and bending of discrete Kirchhoff triangles, both factored.
/// Without clamps it stands on 3 + 3 supports at corners far apart: what they carry is 0 for forces
/// in equilibrium, and displacements are then right but for a motion of the whole.
class PlateModel
{
public:
    /// Errors  NotWorkedOut for what hangs together by points only, is a thousand times longer than
    ///         wide, or has no thickness or
    ///         stiffness; Cancelled.
    static Result<PlateModel> make(PlateMesh mesh, const PlateMaterial &material,
                                   const std::vector<PlateClamp> &clamps = {},
                                   const LongWork &work = {});

    const PlateMesh &mesh() const { return m_mesh; }
    const PlateMaterial &material() const { return m_material; }

    PlateField noField() const;
    /// Where of the mesh the point is; the nearest where it is outside.
    PlateLocator::Place place(const Vec2 &point) const { return m_locator.place(m_mesh, point); }
    /// A force at a place, spread over its triangle so that force and moment are the same.
    void addForce(PlateField &field, const PlateLocator::Place &place, const Vec3 &force) const;
    /// Of what it weighs; gravity in m/s², in the section's frame.
    void addWeight(PlateField &field, const Vec3 &gravity) const;

    /// Displacements under forces.
    PlateField solve(const PlateField &forces) const;
    /// The same for many, columns as in PlateField.
    Eigen::MatrixXd solveMembrane(const Eigen::MatrixXd &forces) const;
    Eigen::MatrixXd solveBending(const Eigen::MatrixXd &forces) const;

    /// (u, v, w) of a place, mm.
    Vec3 displacement(const PlateField &displacements, const PlateLocator::Place &place) const;

private:
    struct Factors;

    PlateModel(PlateMesh mesh, const PlateMaterial &material)
        : m_mesh(std::move(mesh)), m_locator(m_mesh), m_material(material)
    {
    }

    PlateMesh m_mesh;
    PlateLocator m_locator;
    PlateMaterial m_material;
    std::shared_ptr<const Factors> m_factors;
};

} // namespace fff
