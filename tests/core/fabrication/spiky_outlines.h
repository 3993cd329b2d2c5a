// Outlines that are hard to run round with a round tool: by name, and by seed.
#pragma once

#include "core/geometry/boolean.h"
#include "tests/core/shapes.h"

#include <optional>
#include <string>

namespace fff::test {

struct NamedOutline
{
    std::string name;
    CurvedRegion region;
};

/// The largest piece of what is left of the contour; nothing where that is dust.
inline std::optional<CurvedRegion> outlineOf(const Contour &contour,
                                             const std::vector<Contour> &holes = {},
                                             const std::vector<Polygon> &cuts = {})
{
    const auto whole = resolveCrossings(contour);
    if (!whole)
        return std::nullopt;
    const Contour outer =
        whole->contour.signedArea() < 0.0 ? whole->contour.reversed() : whole->contour;
    const Result<std::vector<CurvedRegion>> pieces = subtract(outer, holes, cuts, 0.01);
    if (!pieces || pieces->empty() || area(pieces->front().region) < 1.0)
        return std::nullopt;
    return pieces->front();
}

class SpikyOutlines
{
public:
    explicit SpikyOutlines(unsigned seed) : m_random(seed) {}

    /// One of a dozen kinds. clearance widens its slits, mm.
    std::optional<NamedOutline> next(double clearance)
    {
        const int kind = static_cast<int>(number(0, 9));
        static const char *const names[] = {"star",      "star of curves", "blob",
                                            "wild",      "hairs",          "tiny segments",
                                            "near miss", "rounded cracks", "jagged"};
        const Contour contour = contourOf(kind);
        std::vector<Polygon> cuts;
        std::vector<Contour> holes;
        const Vec2 middle = contour.bounds().center();
        const double size = contour.bounds().size().maxCoeff();
        for (int i = static_cast<int>(number(0, 4)); i-- > 0;)
            cuts.push_back(
                turnedRectangle(middle + size * Vec2(number(-0.5, 0.5), number(-0.5, 0.5)),
                                3.0 + clearance, number(5, 0.6 * size), number(0, 3.1)));
        if (number(0, 1) < 0.3)
            holes.push_back(star(middle + size * Vec2(number(-0.2, 0.2), number(-0.2, 0.2)),
                                 0.05 * size, 0.2 * size));
        auto region = outlineOf(contour, holes, cuts);
        if (!region)
            return std::nullopt;
        return NamedOutline{names[kind], std::move(*region)};
    }

private:
    double number(double from, double to)
    {
        // Not a distribution of the library: those differ between libraries.
        return from + (to - from) * (static_cast<double>(m_random()) / 4294967296.0);
    }

    Contour star(const Vec2 &middle, double least, double most)
    {
        const int count = static_cast<int>(number(4, 24));
        Polygon polygon;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + number(-0.4, 0.4)) / count;
            polygon.push_back(middle +
                              number(least, most) * Vec2(std::cos(angle), std::sin(angle)));
        }
        return polygonContour(polygon);
    }

    Contour curvedStar(double size)
    {
        const int count = static_cast<int>(number(3, 14));
        std::vector<Vec2> points, through;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            through.push_back(number(0.2 * size, size) * Vec2(std::cos(angle), std::sin(angle)));
        }
        for (std::size_t i = 0; i < through.size(); ++i) {
            const Vec2 &a = through[i], &b = through[(i + 1) % through.size()];
            const double bend = 0.4 * (b - a).norm();
            points.push_back(a);
            points.push_back(a + (b - a) / 3.0 + bend * Vec2(number(-1, 1), number(-1, 1)));
            points.push_back(b - (b - a) / 3.0 + bend * Vec2(number(-1, 1), number(-1, 1)));
        }
        return Contour::fromPoints(points).value();
    }

    /// Hair-fine spikes and cracks on a rectangle's edge.
    Contour hairs()
    {
        Polygon polygon{{0, 0}, {100, 0}, {100, 60}};
        double x = 100.0;
        while (x > 12.0) {
            x -= number(0.5, 8.0);
            const double tip = number(-40, 60);
            const double width = std::abs(tip) * std::pow(10.0, number(-4, -1));
            if (x - width < 2.0)
                break;
            polygon.push_back({x, 60});
            polygon.push_back({x - number(0, 1) * width, 60 + tip});
            polygon.push_back({x - width, 60});
            x -= width;
        }
        polygon.push_back({0, 60});
        return polygonContour(polygon);
    }

    /// As a scanner or another program gives it.
    Contour tinySegments()
    {
        const int count = static_cast<int>(number(200, 1500));
        const double noise = std::pow(10.0, number(-5, -0.5));
        const double waves = std::floor(number(2, 12)), depth = number(0, 12);
        Polygon polygon;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            const double radius = 30.0 + depth * std::sin(waves * angle) + number(-noise, noise);
            polygon.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
        }
        return polygonContour(polygon);
    }

    /// Edges a micron to a millimetre apart.
    Contour nearMiss()
    {
        Polygon polygon{{0, 0}, {80, 0}, {80, 50}};
        double x = 80.0;
        while (x > 10.0) {
            const double wide = std::pow(10.0, number(-3, 0.3));
            const double slant = number(0, 1) < 0.5 ? 0.0 : number(-0.5, 0.5) * wide;
            x -= number(1.0, 5.0);
            polygon.insert(polygon.end(),
                           {{x, 50}, {x + slant, 10}, {x - wide, 10}, {x - wide, 50}});
            x -= wide;
            if (number(0, 1) < 0.3)
                polygon.insert(
                    polygon.end(),
                    {{x - 1.0, 50}, {x - 1.0, 80}, {x - 1.0 - wide, 80}, {x - 1.0 - wide, 50}});
            x -= 1.0 + wide;
        }
        polygon.push_back({std::min(0.0, x - 1.0), 50});
        return polygonContour(polygon);
    }

    /// Cracks whose ends bend with a radius about that of the tool.
    Contour roundedCracks()
    {
        static const double kerfs[] = {0.05, 0.1, 0.2, 0.5, 3.0};
        std::vector<CubicBezier> chain{CubicBezier::line({0, 0}, {100, 0}),
                                       CubicBezier::line({100, 0}, {100, 50})};
        Vec2 at(100, 50);
        while (at.x() > 15.0) {
            const double kerf = kerfs[static_cast<int>(number(0, 5))];
            const double share[] = {1.0, 1.0001, 0.9999, 1.01, 0.99, number(0.5, 2.0)};
            const double radius = 0.5 * kerf * share[static_cast<int>(number(0, 6))];
            const double h = 0.5522847498 * radius, x = at.x() - number(1, 4), deep = number(5, 40);
            const Vec2 a(x, 50), b(x, 50 - deep), c(x - radius, 50 - deep - radius),
                d(x - 2 * radius, 50 - deep), e(x - 2 * radius - number(-1, 1) * radius, 50);
            chain.push_back(CubicBezier::line(at, a));
            chain.push_back(CubicBezier::line(a, b));
            chain.push_back({b, b - Vec2(0, h), c + Vec2(h, 0), c});
            chain.push_back({c, c - Vec2(h, 0), d - Vec2(0, h), d});
            chain.push_back(CubicBezier::line(d, e));
            at = e;
        }
        chain.push_back(CubicBezier::line(at, {0, 50}));
        chain.push_back(CubicBezier::line({0, 50}, {0, 0}));
        return Contour::fromSegments(chain).value();
    }

    /// An edge of teeth, finer than the tool or coarser.
    Contour jagged()
    {
        const double height = std::pow(10.0, number(-3.0, 0.7));
        const int count = number(0, 1) < 0.5 ? 50 : 300;
        Polygon polygon{{0, -30}, {200, -30}, {200, 0}};
        double y = 0.0;
        for (int i = count; i-- > 0;) {
            y = std::clamp(0.9 * y + number(-2 * height, 2 * height), -25.0, 60.0);
            polygon.emplace_back(5.0 + (190.0 * i + number(0, 180)) / count, y);
        }
        polygon.emplace_back(0, 0);
        return polygonContour(polygon);
    }

    Contour contourOf(int kind)
    {
        const double size = number(0, 1) < 0.1 ? number(200, 500) : number(15, 60);
        switch (kind) {
        case 0:
            return star({0, 0}, 0.1 * size, size);
        case 1:
            return curvedStar(size);
        case 2:
            return blob(m_random, static_cast<int>(number(4, 40)), size);
        case 3: {
            std::vector<Vec2> points;
            for (int i = 3 * static_cast<int>(number(2, 8)); i-- > 0;)
                points.emplace_back(number(-size, size), number(-size, size));
            return Contour::fromPoints(points).value();
        }
        case 4:
            return hairs();
        case 5:
            return tinySegments();
        case 6:
            return nearMiss();
        case 7:
            return roundedCracks();
        default:
            return jagged();
        }
    }

    std::mt19937 m_random;
};

} // namespace fff::test
