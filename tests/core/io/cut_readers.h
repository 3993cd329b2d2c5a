// What a program that reads a file of cuts makes of it: the ways of the tool as points, mm, y up.
// Shares no code with what writes them. Of files with one sheet and nothing but cuts.
#pragma once

#include "core/geometry/polygon.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace fff::test {

struct ReadCut
{
    Polygon points;
    bool isClosed = false; // its last point is then not its first
};

/// Curves as chords: no farther off than this.
inline constexpr double kReadChord = 0.0004; // mm

inline void addCubic(const std::array<Vec2, 4> &c, Polygon &points, int depth = 0)
{
    const Vec2 one = c[1] - (2.0 * c[0] + c[3]) / 3.0, two = c[2] - (c[0] + 2.0 * c[3]) / 3.0;
    if (depth >= 16 || std::max(one.norm(), two.norm()) <= kReadChord) {
        points.push_back(c[3]);
        return;
    }
    const Vec2 a = 0.5 * (c[0] + c[1]), m = 0.5 * (c[1] + c[2]), b = 0.5 * (c[2] + c[3]);
    const Vec2 d = 0.5 * (a + m), e = 0.5 * (m + b), f = 0.5 * (d + e);
    addCubic({c[0], a, d, f}, points, depth + 1);
    addCubic({f, e, b, c[3]}, points, depth + 1);
}

/// From the last point, counter-clockwise by `sweep`, radians; below 0 the other way.
inline void addArc(const Vec2 &centre, double sweep, const Vec2 &end, Polygon &points)
{
    const Vec2 from = points.back() - centre;
    const double radius = from.norm();
    const double step = 2.0 * std::acos(std::max(0.0, 1.0 - kReadChord / std::max(radius, 1e-3)));
    const int count = 1 + static_cast<int>(std::abs(sweep) / step);
    for (int i = 1; i < count; ++i) {
        const double angle = sweep * i / count, c = std::cos(angle), s = std::sin(angle);
        points.push_back(centre + Vec2(c * from.x() - s * from.y(), s * from.x() + c * from.y()));
    }
    points.push_back(end);
}

inline ReadCut closedWhereItEnds(Polygon points, bool saysSo)
{
    constexpr double kSame = 2e-4; // mm, of numbers with four decimals
    const bool ends = points.size() > 2 && (points.front() - points.back()).norm() <= kSame;
    if (ends)
        points.pop_back();
    return {std::move(points), saysSo || ends};
}

/// Paths with that stroke: M, L, C, Z with absolute numbers.
inline std::vector<ReadCut> cutsInSvg(const std::string &svg, const QString &stroke)
{
    std::vector<ReadCut> cuts;
    double height = 0.0;
    const auto addPath = [&](const QString &data) {
        const QStringList words = data.split(u' ', Qt::SkipEmptyParts);
        Polygon points;
        const auto at = [&](qsizetype i) {
            return Vec2(words[i].toDouble(), height - words[i + 1].toDouble());
        };
        for (qsizetype i = 0; i < words.size();) {
            const QString command = words[i++];
            if (command == u"Z") {
                cuts.push_back(closedWhereItEnds(std::exchange(points, {}), true));
                continue;
            }
            if (command == u"M" && !points.empty())
                cuts.push_back(closedWhereItEnds(std::exchange(points, {}), false));
            for (; i < words.size() && !words[i].front().isLetter();) {
                if (command == u"C") {
                    addCubic({points.back(), at(i), at(i + 2), at(i + 4)}, points);
                    i += 6;
                } else {
                    points.push_back(at(i));
                    i += 2;
                }
            }
        }
        if (!points.empty())
            cuts.push_back(closedWhereItEnds(std::move(points), false));
    };
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QXmlStreamAttributes attributes = reader.attributes();
        if (reader.name() == QLatin1String("svg"))
            height =
                attributes.value(QLatin1String("viewBox")).toString().split(u' ')[3].toDouble();
        else if (reader.name() == QLatin1String("path") &&
                 attributes.value(QLatin1String("stroke")) == stroke)
            addPath(attributes.value(QLatin1String("d")).toString());
    }
    return cuts;
}

/// LWPOLYLINE, and POLYLINE of VERTEX: with bulges.
inline std::vector<ReadCut> cutsInDxf(const std::string &dxf)
{
    struct Vertex
    {
        Vec2 at = Vec2::Zero();
        double bulge = 0.0;
    };
    std::vector<ReadCut> cuts;
    std::vector<Vertex> vertices;
    bool isClosed = false, isLine = false, isVertex = false, isThere = false;
    const auto end = [&] {
        if (vertices.empty())
            return;
        Polygon points{vertices.front().at};
        const std::size_t edges = vertices.size() - (isClosed ? 0 : 1);
        for (std::size_t i = 0; i < edges; ++i) {
            const Vec2 &to = vertices[(i + 1) % vertices.size()].at;
            const double bulge = vertices[i].bulge;
            if (bulge == 0.0) {
                points.push_back(to);
                continue;
            }
            const Vec2 chord = to - vertices[i].at, across(-chord.y(), chord.x());
            const Vec2 centre =
                vertices[i].at + 0.5 * chord + 0.25 * (1.0 / bulge - bulge) * across;
            addArc(centre, 4.0 * std::atan(bulge), to, points);
        }
        cuts.push_back(closedWhereItEnds(std::move(points), isClosed));
        vertices.clear();
    };
    const QStringList lines = QString::fromStdString(dxf).split(u'\n');
    for (qsizetype i = 0; i + 1 < lines.size(); i += 2) {
        const int code = lines[i].trimmed().toInt();
        const QString value = lines[i + 1].trimmed();
        isThere |= code == 2 && value == u"ENTITIES";
        if (!isThere)
            continue;
        if (code == 0) {
            isVertex = value == u"VERTEX";
            if (!isVertex) {
                if (value != u"SEQEND")
                    end();
                isLine = value == u"LWPOLYLINE" || value == u"POLYLINE";
                if (isLine)
                    isClosed = false;
            }
        } else if (code == 70 && isLine && !isVertex) {
            isClosed = value == u"1";
        } else if (code == 10 && (isVertex || (isLine && dxf.find("LWPOLY") != dxf.npos))) {
            vertices.push_back({{value.toDouble(), 0.0}, 0.0});
        } else if (code == 20 && !vertices.empty()) {
            vertices.back().at.y() = value.toDouble();
        } else if (code == 42 && !vertices.empty()) {
            vertices.back().bulge = value.toDouble();
        }
    }
    end();
    return cuts;
}

/// Shapes of paths: vertices with their handles, and what joins which.
inline std::vector<ReadCut> cutsInLightBurn(const std::string &project)
{
    static const QRegularExpression vertex(QStringLiteral(
        "V(-?[\\d.]+) "
        "(-?[\\d.]+)c0x(-?[\\d.]+)(?:c0y(-?[\\d.]+))?c1x(-?[\\d.]+)(?:c1y(-?[\\d.]+))?")),
        primitive(QStringLiteral("([LB])(\\d+) (\\d+)"));
    struct Vertex
    {
        Vec2 at, leaving, arriving;
    };
    std::vector<ReadCut> cuts;
    std::vector<Vertex> vertices;
    QXmlStreamReader reader(QByteArray::fromStdString(project));
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (reader.name() == QLatin1String("VertList")) {
            vertices.clear();
            auto all = vertex.globalMatch(reader.readElementText());
            while (all.hasNext()) {
                const auto one = all.next();
                const auto number = [&one](int i) { return one.captured(i).toDouble(); };
                vertices.push_back(
                    {{number(1), number(2)}, {number(3), number(4)}, {number(5), number(6)}});
            }
        } else if (reader.name() == QLatin1String("PrimList")) {
            Polygon points;
            auto all = primitive.globalMatch(reader.readElementText());
            while (all.hasNext()) {
                const auto one = all.next();
                const Vertex &from = vertices[one.captured(2).toULong()],
                             &to = vertices[one.captured(3).toULong()];
                if (points.empty())
                    points.push_back(from.at);
                if (one.captured(1) == u"L")
                    points.push_back(to.at);
                else
                    addCubic({from.at, from.leaving, to.arriving, to.at}, points);
            }
            cuts.push_back(closedWhereItEnds(std::move(points), false));
        }
    }
    return cuts;
}

/// Moves that burn: G1, and the arcs G2 and G3.
inline std::vector<ReadCut> cutsInGCode(const std::string &gcode)
{
    static const QRegularExpression word(QStringLiteral("([XYIJ])(-?[\\d.]+)"));
    std::vector<ReadCut> cuts;
    Polygon points{Vec2::Zero()};
    const auto end = [&] {
        if (points.size() > 1)
            cuts.push_back(closedWhereItEnds(points, false));
    };
    for (const QString &line : QString::fromStdString(gcode).split(u'\n')) {
        const QString move = line.section(u' ', 0, 0);
        if (move != u"G0" && move != u"G1" && move != u"G2" && move != u"G3")
            continue;
        Vec2 to = points.back(), off = Vec2::Zero();
        auto words = word.globalMatch(line.section(u';', 0, 0));
        while (words.hasNext()) {
            const auto one = words.next();
            const double value = one.captured(2).toDouble();
            switch (one.captured(1).front().unicode()) {
            case 'X':
                to.x() = value;
                break;
            case 'Y':
                to.y() = value;
                break;
            case 'I':
                off.x() = value;
                break;
            default:
                off.y() = value;
                break;
            }
        }
        if (move == u"G0") {
            end();
            points = {to};
        } else if (move == u"G1") {
            points.push_back(to);
        } else {
            const Vec2 a = -off, b = to - points.back() - off;
            const double way = move == u"G3" ? 1.0 : -1.0;
            double sweep = way * std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
            if (sweep <= 0.0)
                sweep += 2.0 * std::numbers::pi;
            addArc(points.back() + off, way * sweep, to, points);
        }
    }
    end();
    return cuts;
}

} // namespace fff::test
