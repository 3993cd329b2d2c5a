// Where the plane of a section cuts templates, or has the lines of a drawing in it: the curves that
// it may follow there.
#pragma once

#include "core/geometry/contour.h"
#include "core/templates/plane_cut.h"
#include "core/templates/template_curves.h"
#include "core/templates/template_mesh.h"

#include <optional>

namespace fff {

/// A loop of the cut of one template, in coordinates of the frame, mm.
struct TemplateLoop
{
    TemplateId of;
    Polygon points; // counter-clockwise, of a hole clockwise
    bool isHole = false;
    int around = -1;        // of a hole: the loop that it is in, by its place in the list
    bool isBridged = false; // in part it closes what is open in the mesh
    bool isOpen = false;    // a line of a drawing, which encloses nothing
    std::optional<CurvePath> curve = {}; // of a drawing: the very line
};

/// Of the template's mesh, or of one that it was pulled to; largest first.
std::vector<TemplateLoop> loopsOn(const Frame &frame, const Template &one,
                                  const TemplateMesh &mesh);

/// A drawing has its lines in a plane that is no further from it than this, mm.
inline constexpr double kInPlane = 0.05;
/// What its closed lines enclose, each outer one before its holes, largest first, and then the open
/// lines; none where the drawing does not lie in the plane. placement: from the drawing's
/// coordinates to the world.
std::vector<TemplateLoop> loopsOn(const Frame &frame, const Template &one,
                                  const Similarity &placement, const TemplateCurves &curves);

/// The loop, which is none of an open line, as curves within kGuideError of it; a hole runs
/// clockwise. Errors  as guideCurve().
Result<Contour> curveOf(const TemplateLoop &loop);

} // namespace fff
