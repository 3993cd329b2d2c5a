// The curves that a contour on a canvas may follow: where its plane cuts the meshes that are seen,
// and the lines of drawings that lie in it. For strokes, the pen and points alike.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/overlay.h"
#include "core/interaction/snapping.h"
#include "core/model/model.h"
#include "core/stroke/guided_line.h"
#include "core/templates/pulled_templates.h"
#include "core/templates/template_cut.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// How near to one a click is on it, px.
inline constexpr double kGuideClick = 10.0;

class TemplateGuides
{
public:
    TemplateGuides() = default;
    /// Of templates that are not hidden, meshes as magnets pull them. O(what the plane meets).
    /// pulled  may be null
    TemplateGuides(const Model &model, const PulledTemplates *pulled, const Frame &canvas);

    bool isEmpty() const { return m_loops.empty(); }
    const Frame &canvas() const { return m_canvas; }
    /// The template that the line follows for longest; without one, that the largest loop is of.
    /// Null without any.
    const Template *followed(const Document &document, const GuidedLine *line = nullptr) const;

    /// The loops as curves, for a stroke to follow; null without any. reach: mm.
    std::shared_ptr<const Guides> curves(double reach) const;

    /// The loops as they are cut, for points to be caught by; null without any.
    GuideLoops loops() const;

    /// A section that follows a guide all round.
    struct Whole
    {
        Contour contour;
        std::vector<Contour> holes;
    };
    /// Of the largest loop that is touched by the slit, from the canvas' origin so far along x,
    /// with the holes in it; without a slit (0) of the largest of all.
    std::optional<Whole> whole(double slitLength) const;
    /// Whether there is such a loop, without working it out.
    bool canTake(double slitLength) const { return loopToTake(slitLength) != m_loops.end(); }

    /// A loop passes so near to the point, canvas coordinates, mm.
    bool isAt(const Vec2 &point, double reach) const;

    /// line: what follows them so far, where there is one. isOffered: the whole of one can be
    /// taken, which is said beside it.
    void show(const GuidedLine *line, bool isOffered, Signs &signs) const;

private:
    void prepareShown();
    bool touches(const TemplateLoop &loop, double slitLength) const;
    std::vector<TemplateLoop>::const_iterator loopToTake(double slitLength) const;

    Frame m_canvas;
    std::shared_ptr<const std::vector<sign::Guides::Loop>> m_shown; // the same, as they are seen
    Vec2 m_beside = Vec2::Zero();      // where the largest reaches furthest to the right and up
    std::vector<TemplateLoop> m_loops; // of one template after the other, largest first
};

/// As drawContour(), with the holes in what that makes. Those that the ground leaves nothing of are
/// left out.
tl::expected<DrawnContour, Hint> drawWhole(const Document &document, const ContourTarget &target,
                                           const TemplateGuides::Whole &whole,
                                           const DrawingRules &rules);

} // namespace fff
