// The reference cases of ../shared/mechanics, and others like them: what is put in, and what came
// out of a solver in three dimensions, or of a formula. Each says which way is up; units are those
// of core/physics.
#pragma once

#include "core/assembly/mass.h"
#include "core/geometry/frame.h"
#include "core/geometry/polygon.h"
#include "core/physics/equilibrium.h"
#include "core/physics/structure.h"

#include <QJsonObject>
#include <QString>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fff::test {

struct ReferenceMaterial
{
    double modulus = 0.0;         // MPa
    double poisson = 0.0;         // no unit
    double density = 0.0;         // kg/m³
    double tensileStrength = 0.0; // MPa
};

/// In its section's plane.
struct ReferenceSlit
{
    std::string joint;
    Vec2 innerEnd = Vec2::Zero();
    Vec2 opening = Vec2::UnitX(); // unit
    double length = 0.0, width = 0.0;
    Polygon rectangle; // taken off the outline; may reach beyond it
};

struct ReferenceSection
{
    std::string id;
    Frame frame;
    double thickness = 0.0;
    ReferenceMaterial material;
    Polygon outline; // without slits
    std::vector<Polygon> holes;
    std::vector<ReferenceSlit> slits;
    std::vector<Region> regions; // what is left of it, largest first
    MassProperties mass;         // of that
};

/// A section's edge that is built in: all of it in this plane.
struct ReferenceClamp
{
    int section = 0;
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
};

struct ReferencePatch
{
    MemberLoad load;
    double radius = 0.0; // mm, over which the solver spread it; 0: not said
};

/// A straight cut through a section, and what goes over it: N, V, Q, Mn, Mv, T, sigma_lin, … by the
/// names of the file.
struct ReferenceCut
{
    std::string name;
    int section = -1;
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    std::map<std::string, double> fem, statics;

    std::optional<double> said(const char *quantity) const; // of `fem`
};

/// What a solver found; what is absent the file does not say.
struct ReferenceTruth
{
    std::optional<double> mass;
    std::optional<Vec3> centre;
    std::vector<Vec3> reactions;          // as the contacts
    std::map<std::string, Wrench> joints; // on a, about the joint's point
    std::vector<ReferenceCut> cuts;
    std::optional<Balance> balance;
    std::optional<double> margin;  // mm
    std::optional<Vec3> resultant; // mm; on the ground
    std::vector<std::vector<std::string>> components, unsupported;

    bool isThere() const { return !reactions.empty() || !joints.empty() || !cuts.empty(); }
};

struct ReferenceCase
{
    std::string id, title, notes;
    std::vector<ReferenceSection> sections;
    std::vector<std::string> joints; // ids, as structure.links
    std::vector<ReferenceClamp> clamps;
    std::vector<ReferencePatch> patches;     // as structure.loads
    Structure structure;                     // links hold whatever pulls at them (nothing where a
                                             // verdict is all there is), unless the file says what
                                             // they hold ("grip_N")
    double friction = 0.0;                   // no unit
    ReferenceTruth truth;                    // slit faces glued
    ReferenceTruth contact, contactWithPlay; // slit faces that only press
    QJsonObject json;                        // all of it
};

/// Reads one. What a file leaves out is what the others mostly have: gravity down, the ground at 0
/// with z up, slits as their joints say. An error is a sentence, and nothing is read.
std::optional<ReferenceCase> readReferenceCase(const QString &path, QString *error);

/// What one of its solvers found, by its name in the file.
ReferenceTruth readReferenceTruth(const ReferenceCase &found, const char *name);

} // namespace fff::test
