// Documents as they come about when somebody edits at random.
#pragma once

#include "core/model/point_edits.h"
#include "core/session/session.h"
#include "tests/core/assembly/plates.h"

#include <random>

namespace fff::test {

/// Edits one after another, each at random. Our own in place of RapidCheck: what it would leave out
/// of a sequence to make it shorter, the edits behind it are made for.
class RandomEdits
{
public:
    explicit RandomEdits(unsigned seed) : m_random(seed) {}

    Document next(const Document &document)
    {
        const int count = static_cast<int>(document.sections.size());
        const int kind = below(count > 14 ? 16 : 13);
        if (count < 3 || kind < 2)
            return withSection(document, shape(), frame());
        const SectionId id = document.sections[static_cast<std::size_t>(below(count))]->id;
        switch (kind) {
        case 2:
        case 3:
            return *moveSection(document, id, frame());
        case 4: {
            Frame a_little = document.find(id)->frame;
            a_little.origin += 2.0 * (number() - 0.5) * a_little.normal() + 1e-9 * a_little.x;
            return *moveSection(document, id, a_little);
        }
        case 5:
            return *setShape(document, id, shape());
        case 6:
            return *renameSection(document, id, "renamed " + std::to_string(below(100)));
        case 7: {
            Stock stock = *document.stocks[static_cast<std::size_t>(
                below(static_cast<int>(document.stocks.size())))];
            if (below(2) == 0)
                stock.thickness = 1.0 + 4.0 * number();
            else
                stock.kerf = 0.3 * number(); // slits do not follow from it
            return *setStock(document, stock);
        }
        case 8: {
            if (document.stocks.size() < 3) {
                Stock stock = birchPlywood();
                stock.thickness = 1.0 + 4.0 * number();
                return *addStock(document, stock);
            }
            return *setSectionStock(document, id,
                                    document.stocks[static_cast<std::size_t>(below(3))]->id);
        }
        case 9:
            return withPointEdit(document, id);
        case 10:
            return withPointEdit(document, id);
        case 11: // a hole more, or none
            return withShape(document, id,
                             below(3) > 0 ? Shape::make(document.find(id)->shape->contour(),
                                                        holes(*document.find(id)->shape))
                                          : withoutHoles(*document.find(id)->shape));
        case 12:
            return *setCurrentStock(document, document.stocks.back()->id);
        default: {
            // Mostly one, also the last, also several.
            std::vector<SectionId> ids{below(3) == 0 ? document.sections.back()->id : id};
            if (below(3) == 0 && document.sections.front()->id != ids.front())
                ids.push_back(document.sections.front()->id);
            return *removeSections(document, ids);
        }
        }
    }

    int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(m_random); }

private:
    double number() { return std::uniform_real_distribution<double>(0.0, 1.0)(m_random); }

    /// Another name where there is no such shape.
    Document withShape(const Document &document, SectionId id, Result<ShapePointer> shape)
    {
        if (shape)
            return *setShape(document, id, *std::move(shape));
        return *renameSection(document, id, "refused " + std::to_string(below(1000)));
    }

    std::vector<Contour> holes(const Shape &shape)
    {
        std::vector<Contour> all = shape.holes();
        const Vec2 at = shape.centroid() + Vec2(30.0 * (number() - 0.5), 8.0 * number());
        all.push_back(*Contour::fromPolygon(rectangle(at.x(), at.y(), at.x() + 3, at.y() + 3)));
        return all;
    }

    Document withPointEdit(const Document &document, SectionId id)
    {
        const Shape &shape = *document.find(id)->shape;
        const int ring = below(boundaryCount(shape));
        const int count = boundary(shape, ring).segmentCount();
        const PointAddress point{ring, below(count)};
        const std::vector<PointAddress> two{point, {ring, below(count)}};
        const Vec2 by(6.0 * (number() - 0.5), 6.0 * (number() - 0.5));
        switch (count > 12 ? 5 : below(7)) {
        case 0:
            return withShape(document, id, movedPoint(shape, point, position(shape, point) + by));
        case 1:
            return withShape(document, id, movedPoints(shape, two, by));
        case 2:
            return withShape(document, id,
                             movedHandle(shape, point,
                                         below(2) == 0 ? HandleSide::In : HandleSide::Out,
                                         position(shape, point) + 2.0 * by, below(2) == 0));
        case 3:
            return withShape(document, id,
                             movedSegment(shape, ring, {point.index, number()}, by, below(2) == 0));
        case 4:
            return withShape(document, id,
                             insertedPoint(shape, ring, {point.index, 0.1 + 0.8 * number()}));
        case 5:
            return withShape(document, id, withoutPoints(shape, two));
        default:
            return withShape(document, id, withKind(shape, two, static_cast<PointKind>(below(3))));
        }
    }

    ShapePointer shape()
    {
        const double w = 40.0 + 120.0 * number(), h = 30.0 + 40.0 * number();
        const Polygon outer = rectangle(-0.5 * w, 0, 0.5 * w, h);
        if (below(4) != 0)
            return polygonShape(outer);
        return polygonShape(outer, {rectangle(-5, 8, 5, 0.5 * h)});
    }

    Frame frame()
    {
        const double at = 120.0 * (number() - 0.5);
        switch (below(4)) {
        case 0:
            return front(at);
        case 1:
            return side(at);
        case 2:
            return {{0, 10.0 + 20.0 * number(), 0}, Vec3::UnitX(), -Vec3::UnitZ()};
        default: {
            Frame turnedFrame = turned(3.0 * number());
            turnedFrame.origin = Vec3(at, 0, -at);
            return turnedFrame;
        }
        }
    }

    std::mt19937 m_random;
};

} // namespace fff::test
