#include "core/interaction/template_guides.h"

#include "core/geometry/polygon.h"
#include "core/geometry/segment_distance.h"
#include "core/interaction/stroke_words.h"
#include "core/templates/flat_template.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// From the guide to the words that offer it, px.
const Vec2 kBesideGuide(110.0, -30.0);

/// The stretch from (0, 0) to (length, 0) crosses this edge.
bool crossesSlit(const Vec2 &p, const Vec2 &q, double length)
{
    if ((p.y() < 0.0) == (q.y() < 0.0))
        return false;
    const double x = p.x() + (q.x() - p.x()) * p.y() / (p.y() - q.y());
    return x >= 0.0 && x <= length;
}

} // namespace

TemplateGuides::TemplateGuides(const Model &model, const PulledTemplates *pulled,
                               const Frame &canvas)
    : m_canvas(canvas)
{
    for (const TemplatePointer &one : model.document.templates) {
        if (one->isHidden)
            continue;
        std::vector<TemplateLoop> loops;
        if (one->mesh)
            loops = loopsOn(canvas, *one, pulled ? *pulled->meshOf(*one) : *one->mesh);
        else if (const auto placement = worldPlacement(*one, model); one->curves && placement)
            loops = loopsOn(canvas, *one, *placement, *one->curves);
        for (TemplateLoop &loop : loops) {
            if (loop.around >= 0)
                loop.around += static_cast<int>(m_loops.size());
        }
        std::move(loops.begin(), loops.end(), std::back_inserter(m_loops));
    }
    prepareShown();
}

/// Once for a canvas: signs are made and painted with every move of the hand.
void TemplateGuides::prepareShown()
{
    if (m_loops.empty())
        return;
    auto shown = std::make_shared<std::vector<sign::Guides::Loop>>();
    for (const TemplateLoop &loop : m_loops) {
        Polygon points = loop.points;
        const auto nearest =
            std::min_element(points.begin(), points.end(), [](const Vec2 &a, const Vec2 &b) {
                return a.squaredNorm() < b.squaredNorm();
            });
        if (!loop.isOpen)
            std::rotate(points.begin(), nearest, points.end());
        shown->push_back({std::move(points), loop.isHole, loop.isOpen});
    }
    m_shown = std::move(shown);
    const Polygon &largest = m_loops.front().points;
    m_beside = *std::max_element(largest.begin(), largest.end(), [](const Vec2 &a, const Vec2 &b) {
        return a.x() + a.y() < b.x() + b.y();
    });
}

const Template *TemplateGuides::followed(const Document &document, const GuidedLine *line) const
{
    if (m_loops.empty())
        return nullptr;
    const bool isOfOne = m_loops.back().of == m_loops.front().of; // one after the other
    if (isOfOne || !line || !line->mostOn)
        return document.find(m_loops.front().of);
    const auto distance = [&](const TemplateLoop &loop) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + (loop.isOpen ? 1 : 0) < loop.points.size(); ++i)
            least = std::min(least, distanceToSegment(*line->mostOn, loop.points[i],
                                                      loop.points[(i + 1) % loop.points.size()]));
        return least;
    };
    const auto nearest = std::min_element(
        m_loops.begin(), m_loops.end(),
        [&](const TemplateLoop &a, const TemplateLoop &b) { return distance(a) < distance(b); });
    return document.find(nearest->of);
}

std::shared_ptr<const Guides> TemplateGuides::curves(double reach) const
{
    if (m_loops.empty())
        return nullptr;
    auto guides = std::make_shared<Guides>();
    guides->reach = reach;
    for (const TemplateLoop &loop : m_loops)
        if (loop.curve)
            guides->lines.emplace_back(*loop.curve);
        else if (const Result<Contour> curve = curveOf(loop))
            guides->lines.emplace_back(CurvePath::around(*curve));
    return guides;
}

GuideLoops TemplateGuides::loops() const
{
    if (m_loops.empty())
        return nullptr;
    auto loops = std::make_shared<std::vector<GuideLine>>();
    for (const TemplateLoop &loop : m_loops)
        loops->push_back({loop.points, loop.isOpen});
    return loops;
}

bool TemplateGuides::touches(const TemplateLoop &loop, double slitLength) const
{
    for (std::size_t i = 0; i < loop.points.size(); ++i)
        if (crossesSlit(loop.points[i], loop.points[(i + 1) % loop.points.size()], slitLength))
            return true;
    return locate(Vec2::Zero(), loop.points) != Side::Outside;
}

std::vector<TemplateLoop>::const_iterator TemplateGuides::loopToTake(double slitLength) const
{
    return std::find_if(m_loops.begin(), m_loops.end(), [&](const TemplateLoop &loop) {
        return !loop.isHole && !loop.isOpen && (slitLength <= 0.0 || touches(loop, slitLength));
    });
}

std::optional<TemplateGuides::Whole> TemplateGuides::whole(double slitLength) const
{
    const auto outer = loopToTake(slitLength);
    if (outer == m_loops.end())
        return std::nullopt;
    Result<Contour> contour = curveOf(*outer);
    if (!contour)
        return std::nullopt;
    Whole whole{*std::move(contour), {}};
    const auto place = static_cast<int>(outer - m_loops.begin());
    for (const TemplateLoop &hole : m_loops)
        if (hole.isHole && hole.around == place)
            if (Result<Contour> curve = curveOf(hole))
                whole.holes.push_back(*std::move(curve));
    return whole;
}

bool TemplateGuides::isAt(const Vec2 &point, double reach) const
{
    for (const TemplateLoop &loop : m_loops)
        for (std::size_t i = 0; i + (loop.isOpen ? 1 : 0) < loop.points.size(); ++i)
            if (distanceToSegment(point, loop.points[i],
                                  loop.points[(i + 1) % loop.points.size()]) <= reach)
                return true;
    return false;
}

tl::expected<DrawnContour, Hint> drawWhole(const Document &document, const ContourTarget &target,
                                           const TemplateGuides::Whole &whole,
                                           const DrawingRules &rules)
{
    tl::expected<DrawnContour, Hint> drawn = drawContour(document, target, whole.contour, rules);
    if (!drawn || target.purpose == ContourTarget::Purpose::Hole)
        return drawn;
    for (const Contour &hole : whole.holes) {
        const Section &made = *drawn->document.find(drawn->section.drawn);
        // The section's own frame may be another one than the canvas.
        std::vector<Vec2> points;
        for (const Vec2 &p : hole.points())
            points.push_back(made.frame.toLocal(target.canvas.toWorld(p)));
        DrawingRules holeRules = rules;
        holeRules.axis.reset();
        if (const auto with = drawContour(drawn->document, ContourTarget::hole(made),
                                          Contour::ofPoints(std::move(points)), holeRules))
            drawn->document = with->document;
    }
    return drawn;
}

void TemplateGuides::show(const GuidedLine *line, bool isOffered, Signs &signs) const
{
    if (m_loops.empty())
        return;
    sign::Guides guides{m_canvas, m_shown, {}, {}};
    if (line) {
        guides.turnouts = line->turnouts;
        if (line->isCaughtAtEnd)
            guides.caught = line->points.back();
    }
    signs.add(std::move(guides));
    if (isOffered)
        signs.add(sign::Label{SignRole::Offer,
                              {m_canvas.toWorld(m_beside)},
                              Message{hints::kTakeGuide, {}},
                              kBesideGuide});
}

} // namespace fff
