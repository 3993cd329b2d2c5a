// A body as a plate of finite elements, and where it is held and loaded.
#pragma once

#include "core/analysis/structure_of.h"
#include "core/physics/elastic_equilibrium.h"
#include "core/physics/plate_attachment.h"

#include <map>
#include <memory>
#include <vector>

namespace fff {

/// What holds and loads a body; points and vectors of the world, mm and N.
struct BodyHold
{
    std::vector<MemberAttachment> at;
    std::vector<Link> links; // of those, to tell whether the same holds it
    std::vector<Vec3> feet, loadPoints, loadForces;
};

/// Of each member.
std::vector<BodyHold> holdsOf(const Structure &structure);
/// But for the numbers of links and feet, which change with others.
bool isHeldAlike(const BodyHold &a, const BodyHold &b);

/// Meshes of bodies that are still there: what takes longest of a plate's model, and little room.
using PlateMeshes = std::map<BodyPointer, std::shared_ptr<const PlateMesh>>;
/// Forgets those of bodies that are gone.
void keepMeshesOf(const Bodies &bodies, PlateMeshes &meshes);

/// Errors  as those of plateMesh() and PlateModel.
Result<PlateModel> plateOf(const BodyPointer &body, const Stock &stock, PlateMeshes &meshes,
                           const LongWork &work);
/// Of its links, then of its feet, which act on the middle of the sheet.
std::vector<PlateAttachment> attachmentsOf(const PlateModel &model, const BodyHold &hold, int index,
                                           const Body &body);
/// Adds the forces of its loads.
void addLoads(PlateField &field, const PlateModel &model, const BodyHold &hold, const Body &body);

} // namespace fff
