// Meshes as the magnets on them pull them. The originals stay: this is what is shown of them, and
// what guides are cut of.
#pragma once

#include "core/model/model.h"
#include "core/templates/magnetic_cut.h"
#include "core/templates/template_mesh.h"

#include <vector>

namespace fff {

/// A mesh with what it was made of.
struct PulledTemplate
{
    TemplateId of;
    TemplateMeshPointer original;
    std::vector<MagneticPlane> planes;                // in the coordinates of its file
    std::shared_ptr<const std::vector<Vec3>> normals; // of the original's vertices
    TemplateMeshPointer mesh;                         // in the same coordinates; never null
};

struct PulledTemplates
{
    std::vector<PulledTemplate> all; // those that a magnet pulls

    /// What there is to see of it: null where its file is missing.
    const TemplateMeshPointer &meshOf(const Template &one) const;
};

/// Of a model's templates. What has the mesh and the magnets that it had in `before` (may be null)
/// is taken from there; a magnet on a section that is not there pulls nothing. O(vertices) of the
/// others, and their trees. Errors  Cancelled.
Result<PulledTemplates> pullTemplates(const Model &model, const PulledTemplates *before,
                                      const LongWork &work = {});

} // namespace fff
