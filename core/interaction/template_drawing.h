// What of a picture or a drawing that is a template can be cut or engraved: its lines, where it
// lies, and what is made of them.
#pragma once

#include "core/interaction/drawing_editing.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_picture.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// How a picture is traced (traced_picture.h).
struct PictureTrace
{
    TraceBy by = TraceBy::Darkness;
    std::optional<double> threshold = {}; // 0 … 1; none: as suggested, of opacity one half
    bool isInverted = false;
    double smoothing = 0.5;
    int smallest = 16; // px²

    bool operator==(const PictureTrace &) const = default;
};

/// The threshold that counts where none is given. O(pixels).
double thresholdOf(const TemplatePicture &picture, const PictureTrace &trace);

/// What a trace of a picture came to. Immutable.
struct TracedPicture
{
    TemplatePicturePointer picture;
    PictureTrace trace;
    std::vector<CurvePath> lines; // px about its middle, y upwards; regions, largest first
    std::size_t regions = 0;

    bool isOf(const Template &one, const PictureTrace &with) const
    {
        return picture && picture == one.picture && trace == with;
    }
};
using TracedPicturePointer = std::shared_ptr<const TracedPicture>;

/// Traces a picture again and again: what does not change with the numbers is worked out once. Not
/// for several threads at once.
class PictureTracer
{
public:
    /// Errors  those of traced()
    Result<TracedPicturePointer> traced(TemplatePicturePointer picture, const PictureTrace &trace,
                                        const LongWork &work = {});

private:
    TemplatePicturePointer m_picture;
    TraceBy m_by = TraceBy::Darkness;
    GreyPicture m_grey; // of it
};

enum class DrawingAs {
    Sections, // on its own plane
    Contour,  // in place of a section's contour and holes
    Holes,    // in a section
    Engraved, // on it
    Scored,
};

/// A trace that is asked for. known: what it comes to, where that was worked out already.
struct WantedTrace
{
    TemplateId of;
    DrawingAs as = DrawingAs::Sections;
    PictureTrace trace = {};
    TracedPicturePointer known = {};
};

/// Of a picture what is traced of it, of a drawing its own lines; the drawing has the template's
/// place. There may be no line. The same for a live preview, beside the window, and for what is
/// committed.
///
/// Errors  BadValue, place = "template", for a mesh, for one that is not read, and for one on a
///         section that is not there; those of traced()
Result<Drawing> drawingOf(const Model &model, const Template &one, const PictureTrace &trace = {},
                          const LongWork &work = {});
/// The same of what is known where that is of this picture and these numbers.
Result<Drawing> drawingOf(const Model &model, const Template &one, const WantedTrace &wanted,
                          const LongWork &work = {});

/// section: for all but Sections. Refused as the edits of drawing_editing.h; kNothingTraced where
/// there is no line.
SectionEdit madeOfDrawing(const Model &model, const Drawing &drawing, DrawingAs as,
                          const SectionRef &section, const DrawingRules &rules);

} // namespace fff
