#include "tests/core/session/random_drawings.h"

#include "core/base/units.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/session/dice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fff::test {

namespace {

/// Smooth and closed through all of these.
Contour smooth(const Polygon &through)
{
    const auto count = through.size();
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 &before = through[(i + count - 1) % count], &from = through[i],
                   &to = through[(i + 1) % count], &after = through[(i + 2) % count];
        points.push_back(from);
        points.push_back(from + (to - before) / 6.0);
        points.push_back(to - (after - from) / 6.0);
    }
    return Contour::fromPoints(std::move(points)).value();
}

/// About the middle of a box, in and out three to seven times.
Contour wavy(Dice &dice, const Box2 &box)
{
    const Vec2 radii = 0.5 * box.size(), middle = box.center();
    const double waves = 3.0 + dice.below(5), phase = dice.between(0.0, 6.0),
                 height = dice.between(0.05, 0.3);
    constexpr int kPoints = 36;
    Polygon through;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        const double reach = 1.0 + height * std::sin(waves * angle + phase);
        through.push_back(middle +
                          reach * radii.cwiseProduct(Vec2(std::cos(angle), std::sin(angle))));
    }
    return smooth(through);
}

/// A post at the left of the box with two or three arms to the right.
Contour arms(Dice &dice, const Box2 &box)
{
    const int count = 2 + dice.below(2);
    const double step = box.size().y() / (2 * count - 1);
    Polygon polygon{box.min};
    for (int i = 0; i < count; ++i) {
        const double reach = box.max.x() - dice.between(0.0, 0.3) * box.size().x(),
                     low = box.min.y() + 2 * i * step;
        polygon.push_back({reach, low});
        polygon.push_back({reach, low + step});
        if (i + 1 < count) {
            const double inner = box.min.x() + dice.between(0.15, 0.4) * box.size().x();
            polygon.push_back({inner, low + step});
            polygon.push_back({inner, low + 2 * step});
        }
    }
    polygon.push_back({box.min.x(), box.max.y()});
    return Contour::fromPolygon(polygon).value();
}

Contour rectangleOf(const Box2 &box)
{
    return Contour::fromPolygon(rectangle(box.min.x(), box.min.y(), box.max.x(), box.max.y()))
        .value();
}

/// Some with a window beside the middle.
ShapePointer shapeIn(Dice &dice, const Box2 &box)
{
    const int kind = dice.below(8);
    const Contour contour = kind == 0   ? arms(dice, box)
                            : kind <= 2 ? rectangleOf(box)
                                        : wavy(dice, box);
    if (kind != 0 && dice.oneIn(4)) {
        const double half = 0.08 * box.size().minCoeff() + 1.0;
        const Vec2 at = box.center() + dice.between(-0.2, 0.2) * box.size();
        return *Shape::make(contour, {rectangleOf({at.array() - half, at.array() + half})});
    }
    return *Shape::make(contour);
}

Box2 boxOf(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y1}};
}

/// Where a stroke leaves its parent, from inside to outside, in the parent's frame coordinates.
struct DrawnSlit
{
    Vec2 from, to;

    Vec2 direction() const { return (to - from).normalized(); }
};

/// The ends of the stretch of a line through `p` that is in the ring and has p in it.
std::pair<double, double> stretchAt(const Polygon &ring, const Vec2 &p, const Vec2 &direction)
{
    double low = -1e3, high = 1e3;
    for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
        const double before = cross(direction, ring[k] - p), here = cross(direction, ring[i] - p);
        if ((before > 0.0) == (here > 0.0))
            continue;
        const double at =
            direction.dot(ring[k] + before / (before - here) * (ring[i] - ring[k]) - p);
        (at > 0.0 ? high : low) = at > 0.0 ? std::min(high, at) : std::max(low, at);
    }
    return {low, high};
}

class Drawing
{
public:
    explicit Drawing(std::uint64_t seed) : m_dice(seed), m_document(newDocument()) {}

    Document made()
    {
        chooseSheets();
        const double size = m_dice.between(30.0, 80.0);
        NewSection body;
        body.shape = shapeIn(m_dice, boxOf(-size, -0.7 * size, size, 0.7 * size));
        body.frame = front();
        add(std::move(body));
        const int count = 1 + m_dice.below(7);
        for (int i = 0; i < count; ++i) {
            if (m_dice.oneIn(10))
                addThrough();
            else if (i > 0 && m_dice.oneIn(4))
                add(shelf());
            else
                add(onSlit());
        }
        return std::move(m_document);
    }

private:
    void chooseSheets()
    {
        const double clearance = m_dice.oneIn(2) ? 0.0 : m_dice.between(0.0, 0.2);
        Stock stock = *m_document.stocks.front();
        stock.clearance = clearance;
        stock.thickness = m_dice.between(1.0, 6.0);
        m_document = *setStock(std::move(m_document), stock);
        if (m_dice.oneIn(3)) {
            stock.name = "Other";
            stock.thickness = m_dice.between(1.0, 6.0);
            m_document = *addStock(std::move(m_document), stock);
        }
    }

    void add(NewSection section)
    {
        section.stock = m_document
                            .stocks[static_cast<std::size_t>(
                                m_dice.below(static_cast<int>(m_document.stocks.size())))]
                            ->id;
        m_document = *addSection(std::move(m_document), std::move(section));
    }

    const Section &any()
    {
        return *m_document.sections[static_cast<std::size_t>(
            m_dice.below(static_cast<int>(m_document.sections.size())))];
    }

    /// From somewhere at the edge inwards, or along the edge.
    DrawnSlit slitIn(const Section &parent)
    {
        const Polygon &ring = parent.shape->region().outer;
        const auto i = static_cast<std::size_t>(m_dice.below(static_cast<int>(ring.size())));
        const Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
        const Vec2 along = (to - from).normalized(), inwards = perpendicular(along);
        const Vec2 edge = 0.5 * (from + to);
        if (m_dice.oneIn(5)) {
            const Vec2 inner = edge + m_dice.between(0.2, 4.0) * inwards;
            const Vec2 direction = m_dice.oneIn(2) ? along : Vec2(-along);
            const auto [low, high] = stretchAt(ring, inner, direction);
            return {inner + std::max(low, -20.0) * direction, inner + high * direction};
        }
        const Vec2 direction = Eigen::Rotation2Dd(m_dice.between(-0.6, 0.6)) * inwards;
        const auto [low, high] = stretchAt(ring, edge + 0.01 * direction, direction);
        const double depth = std::min(m_dice.between(6.0, 40.0), 0.8 * high);
        return {edge + depth * direction, edge};
    }

    /// A plane that holds the slit, at an angle to the parent's.
    Frame planeOn(const Section &parent, const DrawnSlit &slit)
    {
        const Vec3 x = parent.frame.directionToWorld(slit.direction());
        const double angle = m_dice.oneIn(3) ? m_dice.between(20.0, 160.0) : 90.0;
        const Vec3 beside = parent.frame.normal().cross(x);
        const Vec3 y =
            std::cos(radians(angle)) * beside + std::sin(radians(angle)) * parent.frame.normal();
        return *makeFrame(parent.frame.toWorld(slit.to), x, y);
    }

    NewSection onSlit()
    {
        const Section &parent = any();
        const DrawnSlit slit = slitIn(parent);
        NewSection section;
        section.parent = Parent{SectionRef(parent.id), slit.from, slit.to};
        section.frame = planeOn(parent, slit);
        const double length = (slit.to - slit.from).norm();
        const double half = m_dice.between(12.0, 50.0);
        const double lift = m_dice.oneIn(3) ? m_dice.between(-0.9, 0.9) * half : 0.0;
        Box2 box = boxOf(-length, lift - half, m_dice.between(8.0, 60.0), lift + half);
        if (m_dice.oneIn(4)) { // across all of the parent, some to its very ends
            const auto [low, high] = stretchAt(parent.shape->region().outer,
                                               0.5 * (slit.from + slit.to), slit.direction());
            const double beyond = m_dice.oneIn(2) ? 0.0 : m_dice.between(-6.0, 20.0);
            box.min.x() = low - 0.5 * length - beyond;
            box.max.x() = high - 0.5 * length + beyond;
            if (m_dice.oneIn(2)) {
                section.shape = *Shape::make(rectangleOf(box));
                return section;
            }
        }
        section.shape = shapeIn(m_dice, box);
        return section;
    }

    /// On a slit that stays inside, no longer than that, and wanted in a mortise.
    void addThrough()
    {
        const Section &parent = any();
        DrawnSlit slit = slitIn(parent);
        slit.to += 0.3 * (slit.from - slit.to);
        NewSection section;
        section.parent = Parent{SectionRef(parent.id), slit.from, slit.to};
        section.frame = planeOn(parent, slit);
        const double length = (slit.to - slit.from).norm(), half = m_dice.between(12.0, 50.0);
        const Box2 box = boxOf(-length, -half, 0.0, half);
        section.shape = *Shape::make(m_dice.oneIn(2) ? rectangleOf(box) : wavy(m_dice, box));
        JointOverride wanted;
        wanted.a = parent.id;
        add(std::move(section));
        wanted.b = m_document.sections.back()->id;
        wanted.kind = JointKind::Mortise;
        m_document = *setJointOverride(std::move(m_document), std::move(wanted));
    }

    /// Square to the slit of a section, and so across both it and its parent.
    NewSection shelf()
    {
        const Section &standing = *m_document.sections[static_cast<std::size_t>(
            1 + m_dice.below(static_cast<int>(m_document.sections.size()) - 1))];
        NewSection section;
        // Its x runs along the slit; of a shelf that is its own x, nothing crosses there.
        section.frame = *makeFrame(standing.frame.toWorld({m_dice.between(-15.0, 5.0), 0.0}),
                                   standing.frame.y, standing.frame.normal());
        const double across = m_dice.between(10.0, 45.0), along = m_dice.between(10.0, 45.0);
        section.shape = shapeIn(m_dice, boxOf(-across, -along, across, along));
        return section;
    }

    Dice m_dice;
    Document m_document;
};

} // namespace

Document randomDrawing(std::uint64_t seed)
{
    return Drawing(seed).made();
}

} // namespace fff::test
