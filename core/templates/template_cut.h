// Where the plane of a section cuts templates: the curves that it may follow there.
#pragma once

#include "core/geometry/contour.h"
#include "core/templates/plane_cut.h"
#include "core/templates/template_mesh.h"

namespace fff {

/// A loop of the cut of one template, in coordinates of the frame, mm.
struct TemplateLoop
{
    TemplateId of;
    Polygon points; // counter-clockwise, of a hole clockwise
    bool isHole = false;
    int around = -1;        // of a hole: the loop that it is in, by its place in the list
    bool isBridged = false; // in part it closes what is open in the mesh
};

/// Of the template's mesh, or of one that it was pulled to; largest first.
std::vector<TemplateLoop> loopsOn(const Frame &frame, const Template &one,
                                  const TemplateMesh &mesh);

/// The loop as curves within kGuideError of it; a hole runs clockwise. Errors  as guideCurve().
Result<Contour> curveOf(const TemplateLoop &loop);

} // namespace fff
