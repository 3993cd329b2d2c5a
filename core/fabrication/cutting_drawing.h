// What is sent to a machine: the lines of all parts as they lie on their sheets, by what is done
// along them. Every format of cutting files is written from this alone.
#pragma once

#include "core/base/tolerances.h"
#include "core/fabrication/cut_finish.h"
#include "core/fabrication/layout.h"
#include "core/fabrication/listed_part.h"
#include "core/fabrication/marks.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fff {

struct Machine;

enum class LineRole {
    Engrave,  // that people drew on sections
    Score,    // the same, to fold along
    InnerCut, // round a hole
    OuterCut, // round the part
};

/// Sheet coordinates: mm, origin at the sheet's lower left, y up. A view of what its part keeps,
/// put there point by point as it is read: a copy of all lines would cost more than writing them.
class CuttingLine
{
public:
    /// points     of a contour (3k), or of a path (3k + 1)
    /// placement  of the part on its sheet; both outlive this
    CuttingLine(LineRole role, std::span<const Vec2> points, const Placement &placement)
        : m_points(points), m_placement(&placement), m_role(role)
    {
    }

    LineRole role() const { return m_role; }
    bool isClosed() const // cuts always are
    {
        return m_points.size() % 3 == 0 || m_points.front() == m_points.back();
    }
    int segmentCount() const { return static_cast<int>(m_points.size() / 3); }
    Vec2 start() const { return m_placement->apply(m_points.front()); }
    CubicBezier segment(int index) const;
    /// To kClipGrid, as the part's own points tell: mostly the segment's end is all that is asked
    /// for then.
    bool isStraight(int index) const { return segmentOf(index).isStraight(kClipGrid); }
    Vec2 end(int index) const { return m_placement->apply(pointAt(3 * index + 3)); }

private:
    /// Behind the last one comes the first.
    const Vec2 &pointAt(int index) const
    {
        const auto i = static_cast<std::size_t>(index);
        return m_points[i < m_points.size() ? i : 0];
    }
    /// The part's.
    CubicBezier segmentOf(int index) const
    {
        const int first = 3 * index;
        return {pointAt(first), pointAt(first + 1), pointAt(first + 2), pointAt(first + 3)};
    }

    std::span<const Vec2> m_points;
    const Placement *m_placement;
    LineRole m_role;
};

/// What is cut out, and what is drawn on it.
class CuttingPart
{
public:
    /// What drawings share.
    struct Source
    {
        std::vector<Part> parts;
        std::vector<Engraving> engravings; // of each part, or none at all
    };
    /// name  of its section
    CuttingPart(std::shared_ptr<const Source> source, const Placement &placement, std::string name)
        : m_source(std::move(source)), m_name(std::move(name)), m_placement(placement)
    {
    }

    int number() const { return part().number; } // engraved
    const std::string &name() const { return m_name; }
    /// As it is cut, in the part's own coordinates.
    const CurvedRegion &outline() const { return part().outline; }
    /// Its number, and those of its joints, sheet coordinates: stroke by stroke the points. Empty
    /// where there is no room for any. joint: whose number it is; 0: the part's
    template <class Visit> // Visit(bool isFirstOfStroke, const Vec2 &, int joint)
    void forLabel(const Visit &visit) const;
    /// Its own, which too slim parts do not bear.
    bool hasNumber() const { return engraving() && engraving()->hasNumber; }
    bool hasLabel() const { return engraving() && !engraving()->strokes.isEmpty(); }
    /// Whether the point of a sheet is at a slit: beside or before its bottom, with so much room,
    /// mm. All the way from there in the slit's direction, so rather too often.
    bool isAtSlit(const Vec2 &point, double room) const;
    /// As they are to be cut: what is drawn, holes, the outside.
    template <class Visit> // Visit(const CuttingLine &)
    void forLines(const Visit &visit) const;
    /// Of all its lines, and of its label.
    std::size_t pointCount() const;

private:
    const Part &part() const { return m_source->parts[static_cast<std::size_t>(m_placement.part)]; }
    const Engraving *engraving() const
    {
        return m_source->engravings.empty()
                   ? nullptr
                   : &m_source->engravings[static_cast<std::size_t>(m_placement.part)];
    }

    std::shared_ptr<const Source> m_source;
    std::string m_name;
    Placement m_placement;
};

struct CuttingSheet
{
    int number = 1;
    Vec2 size = Vec2::Zero();              // mm
    std::shared_ptr<const Region> outline; // of an offcut; null: a rectangle of that size
    StockId stock;
    std::vector<CuttingPart> parts;
    CutFinish finish; // of its cuts, as a machine follows them (cutting_order.h)
};

struct CuttingDrawing
{
    std::vector<CuttingSheet> sheets;
    std::vector<Stock> stocks;    // that are on them, in the document's order
    std::vector<ListedPart> list; // of all parts of the model
    bool isKerfApplied = false;
    bool hasReference = true; // a bar of 100 mm x 10 mm, to measure after cutting: a guide
    std::shared_ptr<const Machine> machine; // that it is for (machine.h); none: no particular one
    /// The numbers of joints are in a colour for each (joint_colours.h), where a format has colours
    /// that say nothing else.
    bool hasJointColours = false;
};

struct DrawingOptions
{
    bool hasReference = true;
    bool isKerfApplied = false; // what `parts` are: outlines as designed, or compensated already
    std::shared_ptr<const Machine> machine = nullptr;
    std::optional<CutFinish> finish = {}; // none: the machine's
    bool hasJointColours = false;
};

/// `layout` and `parts` belong to `model`; `engravings` to the parts, one each, or none at all.
CuttingDrawing cuttingDrawing(const Layout &layout, std::vector<Part> parts,
                              std::vector<Engraving> engravings, const Model &model,
                              const DrawingOptions &options = {});

/// The rings of an offcut, closed, or the four corners of a rectangle.
std::vector<Polygon> edgesOf(const CuttingSheet &sheet);

/// The sheet at the index alone, with its stock.
CuttingDrawing onSheet(const CuttingDrawing &drawing, std::size_t index);

template <class Visit>
void CuttingPart::forLabel(const Visit &visit) const
{
    if (!hasLabel())
        return;
    const Strokes &strokes = engraving()->strokes;
    const std::vector<int> &joints = engraving()->joints;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const int joint = i < joints.size() ? joints[i] : 0;
        bool isFirst = true;
        for (const Vec2 &p : strokes[i])
            visit(std::exchange(isFirst, false), m_placement.apply(p), joint);
    }
}

template <class Visit>
void CuttingPart::forLines(const Visit &visit) const
{
    const auto visitAll = [&](LineRole role, const auto &lines) {
        for (const auto &line : lines)
            visit(CuttingLine(role, line.points(), m_placement));
    };
    if (const Engraving *drawn = engraving()) {
        visitAll(LineRole::Engrave, drawn->lines.engraved);
        visitAll(LineRole::Score, drawn->lines.scored);
    }
    visitAll(LineRole::InnerCut, part().outline.holes);
    visit(CuttingLine(LineRole::OuterCut, part().outline.outer.points(), m_placement));
}

} // namespace fff
