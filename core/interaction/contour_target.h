// What a contour that is drawn on a canvas becomes: a new section, another contour or a hole of one
// that is there. Strokes and the pen differ in how they get to a contour, not in this.
#pragma once

#include "core/model/hint.h"
#include "core/model/model.h"
#include "core/model/naming.h"
#include "core/model/step.h"
#include "core/stroke/symmetry.h"

#include <optional>

namespace fff {

struct ContourTarget
{
    enum class Purpose { NewSection, Redraw, Hole };

    Purpose purpose = Purpose::NewSection;
    Frame canvas;                 // of Redraw and Hole: the section's own frame
    std::optional<Parent> parent; // NewSection: what it stands on, and its slit
    SectionId section;            // Redraw, Hole
    /// NewSection: what is to the right as it is drawn; zero: x of the canvas' grid (snapping.h).
    Vec3 right = Vec3::Zero();

    static ContourTarget newSection(const Frame &canvas, std::optional<Parent> parent = {});
    static ContourTarget redraw(const Section &section);
    static ContourTarget hole(const Section &section);
};

/// The frame of a new section: that of the canvas with its x to the right and its y up, level or
/// uphill as the canvas is looked at.
Frame seenFrame(const ContourTarget &target);

/// The slit across which what is drawn can be mirrored, in canvas coordinates; none where no slit
/// is known.
std::optional<MirrorAxis> slitAxis(const ContourTarget &target, const Document &document);

/// A canvas that was picked to draw on.
struct CanvasChoice
{
    ContourTarget target;
    std::string command;                 // that picked it
    Text prompt = {};                    // what is to be drawn on it, of %1
    std::string name = {};               // of the section that it is about
    std::optional<double> distance = {}; // of a plane parallel to a section, mm; it can be changed
};

/// The canvas moved to another distance. Only of one that has a distance.
void moveToDistance(CanvasChoice &canvas, double distance);

/// A document with the contour in it.
struct DrawnContour
{
    Document document;
    Step step;
    std::string name; // of the section that it is part of
    SectionRef section;
    bool isCutAtGround = false; // what was drawn below the ground is left out
    std::optional<Hint> note;   // what became of it beyond what was drawn
};

struct DrawingRules
{
    bool cutsAtGround = true; // contours end at Y = 0; holes are not cut
    Naming naming = {};       // of a new section
    /// Across which the contour was mirrored, canvas coordinates: the section stays symmetric to
    /// it.
    std::optional<MirrorAxis> axis = {};
};

/// The committed document with this contour (canvas coordinates, mm, not crossing itself) in its
/// place. A redrawn section keeps the holes that lie in the new contour, a hole that overlaps
/// others becomes one with them, and one that reaches over the contour's edge is cut out of it.
/// Where cutting at the ground takes a contour apart, its largest piece is kept, and the note says
/// so. The frame of a new section has its x to the right and its y up as the canvas is looked at
/// (the side that its normal points to): coordinates of points mean what is seen. Refused, with the
/// hint that says why: Locked, BelowGround (nothing of it is above), HoleOutside, Failed.
tl::expected<DrawnContour, Hint> drawContour(const Document &document, const ContourTarget &target,
                                             const Contour &contour, const DrawingRules &rules);
/// The same of a figure (canvas coordinates), whose numbers the section keeps as long as the
/// boundary stays as it makes it.
tl::expected<DrawnContour, Hint> drawFigure(const Document &document, const ContourTarget &target,
                                            const Figure &figure, const DrawingRules &rules);

} // namespace fff
