#include "ui/view/thing.h"

#include "core/geometry/triangulation.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <map>
#include <numbers>

namespace fff::ui {

namespace {

constexpr double kSteel = 7.85e-6;   // kg/mm³: what a plain block is taken to be of
constexpr double kLeastBlock = 6.0;  // mm: smaller ones would not be seen
constexpr double kMostBlock = 400.0; // mm
constexpr double kLying = 0.7;       // cosine: what leans by less carries things on its face
constexpr double kWithin = 0.94;     // of a vessel's radius: what is in it
constexpr double kUprightCosine = 1e-6;
constexpr double kClear = 0.20, kSolid = 0.27; // of each of its two sides
constexpr int kRoundCorners = 48;
const QColor kBlock(0x8d, 0x97, 0xa3), kWater(0x4f, 0xa3, 0xd1);

/// How a thing looks, mm; y up from where it stands, or hangs.
struct Look
{
    std::vector<Vec2> turned;  // radius and height, of a vessel's outside from below
    std::vector<Vec2> outline; // in the plane of what it hangs on, counter-clockwise
    Vec3 box = Vec3::Zero();   // width, height, depth
    double thickness = 0.0;    // of the outline
    double holds = 0.0;        // kg of water
    QColor colour = kBlock;
};

std::vector<Vec2> pointsOf(const QJsonValue &value)
{
    std::vector<Vec2> points;
    for (const QJsonValue &point : value.toArray())
        points.emplace_back(point.toArray().at(0).toDouble(), point.toArray().at(1).toDouble());
    return points;
}

Look lookOf(const QJsonObject &row)
{
    Look look;
    look.turned = pointsOf(row[QLatin1String("turned")]);
    look.outline = pointsOf(row[QLatin1String("outline")]);
    look.thickness = row[QLatin1String("thickness")].toDouble();
    look.holds = row[QLatin1String("holds")].toDouble();
    const QJsonArray box = row[QLatin1String("box")].toArray();
    look.box = {box.at(0).toDouble(), box.at(1).toDouble(), box.at(2).toDouble()};
    const QColor colour(row[QLatin1String("colour")].toString());
    if (colour.isValid())
        look.colour = colour;
    return look;
}

/// By the keys of the presets, from the file that has these.
const std::map<std::string, Look> &looks()
{
    static const std::map<std::string, Look> all = [] {
        std::map<std::string, Look> read;
        QFile file(QStringLiteral(":/loads/presets.json"));
        if (file.open(QIODevice::ReadOnly))
            for (const QJsonValue &row : QJsonDocument::fromJson(file.readAll()).array())
                read.emplace(row.toObject()[QLatin1String("key")].toString().toStdString(),
                             lookOf(row.toObject()));
        return read;
    }();
    return all;
}

/// Puts triangles where the thing is.
class Shaper
{
public:
    Shaper(const SceneThing &thing, std::vector<ThingVertex> &out)
        : m_at(thing.at), m_x(thing.along), m_z(thing.along.cross(Vec3::UnitY())), m_out(out)
    {
    }
    void use(const QColor &colour, double opacity)
    {
        m_colour = {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                    static_cast<float>(colour.blueF()), static_cast<float>(opacity)};
    }

    /// Round the vertical, from below to above, closed at both ends.
    void turn(const std::vector<Vec2> &profile)
    {
        for (int k = 0; k < kRoundCorners; ++k) {
            const Vec3 one = around(k), next = around(k + 1);
            const auto point = [](const Vec2 &p, const Vec3 &way) {
                return Vec3(p.x() * way.x(), p.y(), p.x() * way.z());
            };
            for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
                const Vec2 &low = profile[i], &high = profile[i + 1];
                const Vec2 slope = (high - low).normalized();
                const auto out = [&](const Vec3 &way) {
                    return Vec3(slope.y() * way.x(), -slope.x(), slope.y() * way.z());
                };
                quad({point(low, one), point(low, next), point(high, next), point(high, one)},
                     {out(one), out(next), out(next), out(one)});
            }
            cap(profile.front(), one, next, -1.0);
            cap(profile.back(), next, one, 1.0);
        }
    }

    /// From −depth/2 to depth/2, over what is at y = 0.
    void box(const Vec3 &size)
    {
        const double w = 0.5 * size.x();
        prism({{-w, 0.0}, {w, 0.0}, {w, size.y()}, {-w, size.y()}}, size.z());
    }

    void prism(const std::vector<Vec2> &outline, double depth)
    {
        const double half = 0.5 * depth;
        const auto at = [](const Vec2 &p, double z) { return Vec3(p.x(), p.y(), z); };
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
            const Vec2 way = (q - p).normalized();
            const Vec3 out(way.y(), -way.x(), 0.0);
            quad({at(p, -half), at(q, -half), at(q, half), at(p, half)}, {out, out, out, out});
        }
        const Result<Triangulation> faces = triangulate(Region{outline, {}});
        if (!faces)
            return;
        for (const auto &t : faces->triangles) {
            const auto corner = [&](int k) -> const Vec2 & {
                return faces->points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
            };
            const Vec3 front = Vec3::UnitZ();
            triangle(at(corner(0), half), at(corner(1), half), at(corner(2), half), front, front,
                     front);
            triangle(at(corner(0), -half), at(corner(2), -half), at(corner(1), -half), -front,
                     -front, -front);
        }
    }

private:
    static Vec3 around(int k)
    {
        const double angle = 2.0 * std::numbers::pi * (k % kRoundCorners) / kRoundCorners;
        return {std::cos(angle), 0.0, -std::sin(angle)};
    }
    void cap(const Vec2 &rim, const Vec3 &from, const Vec3 &to, double side)
    {
        const Vec3 middle(0.0, rim.y(), 0.0), out(0.0, side, 0.0);
        triangle(middle, middle + rim.x() * to, middle + rim.x() * from, out, out, out);
    }
    void quad(const std::array<Vec3, 4> &p, const std::array<Vec3, 4> &n)
    {
        triangle(p[0], p[1], p[2], n[0], n[1], n[2]);
        triangle(p[0], p[2], p[3], n[0], n[2], n[3]);
    }
    void triangle(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &na, const Vec3 &nb,
                  const Vec3 &nc)
    {
        add(a, na);
        add(b, nb);
        add(c, nc);
    }
    void add(const Vec3 &p, const Vec3 &normal)
    {
        const Vec3 at = m_at + turned(p), n = turned(normal);
        m_out.push_back(
            {{static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())},
             {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())},
             m_colour});
    }
    Vec3 turned(const Vec3 &p) const { return p.x() * m_x + p.y() * Vec3::UnitY() + p.z() * m_z; }

    Vec3 m_at, m_x, m_z;
    std::array<float, 4> m_colour{};
    std::vector<ThingVertex> &m_out;
};

/// What is in a vessel that is filled to this share of its volume, by its outside.
std::vector<Vec2> contents(const std::vector<Vec2> &profile, double share)
{
    // Of cones on each other, from below.
    const auto volume = [](const Vec2 &a, const Vec2 &b) {
        return (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
    };
    double all = 0.0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        all += volume(profile[i], profile[i + 1]);
    double left = share * all;
    std::vector<Vec2> inside{{kWithin * profile.front().x(), profile.front().y()}};
    for (std::size_t i = 0; i + 1 < profile.size() && left > 0.0; ++i) {
        const Vec2 &a = profile[i], &b = profile[i + 1];
        const double here = volume(a, b);
        double from = 0.0, to = 1.0;
        if (here > left) {
            constexpr int kHalvings = 30;
            for (int k = 0; k < kHalvings; ++k) {
                const double middle = 0.5 * (from + to);
                (volume(a, a + middle * (b - a)) < left ? from : to) = middle;
            }
        }
        const Vec2 top = a + to * (b - a);
        inside.emplace_back(kWithin * top.x(), top.y());
        left -= here;
    }
    return inside;
}

/// Where it stands: on the face of what lies, in the middle of what does not.
Vec3 footOf(const Load &load, const PlacedLoad &placed, const Section &section, double thickness)
{
    const Vec3 at = section.frame.toWorld(placed.position);
    const double lean = std::abs(section.frame.normal().y());
    return load.spread == Spread::Hanging || lean < kLying
               ? at
               : Vec3(at + 0.5 * thickness / lean * Vec3::UnitY());
}

/// Horizontal and in the section's plane.
Vec3 alongOf(const Frame &frame)
{
    const Vec3 level = Vec3::UnitY().cross(frame.normal());
    if (level.norm() > kUprightCosine)
        return level.normalized();
    Vec3 x = frame.x;
    x.y() = 0.0;
    return x.normalized();
}

} // namespace

std::vector<SceneThing> thingsOf(const Model &model)
{
    std::vector<SceneThing> things;
    for (const PlacedLoad &placed : placedLoads(model)) {
        const Load &load = model.document.loads[static_cast<std::size_t>(placed.load)];
        if (load.isPush())
            continue;
        if (things.size() == kMostThings)
            return {};
        const auto index = static_cast<std::size_t>(placed.section);
        const Section &section = *model.section(index);
        things.push_back({load.preset, load.mass, load.filled,
                          footOf(load, placed, section, model.stockOf(index).thickness),
                          alongOf(section.frame), placed.section, false});
    }
    return things;
}

void addTriangles(const SceneThing &thing, std::vector<ThingVertex> &vertices)
{
    static const Look plain;
    const auto found = looks().find(thing.preset);
    const Look &look = found == looks().end() ? plain : found->second;
    Shaper shaper(thing, vertices);
    if (!look.turned.empty() && thing.filled > 0.0 && look.holds > 0.0) {
        shaper.use(kWater, kClear);
        shaper.turn(contents(look.turned, std::min(thing.filled / look.holds, 1.0)));
    }
    shaper.use(look.colour, look.turned.empty() ? kSolid : kClear);
    if (!look.turned.empty())
        shaper.turn(look.turned);
    else if (!look.outline.empty())
        shaper.prism(look.outline, look.thickness);
    else if (look.box.x() > 0.0)
        shaper.box(look.box);
    else
        shaper.box(
            Vec3::Constant(std::clamp(std::cbrt(thing.mass / kSteel), kLeastBlock, kMostBlock)));
}

std::vector<Vec3> cornersOf(const std::vector<SceneThing> &things)
{
    std::vector<ThingVertex> vertices;
    for (const SceneThing &thing : things)
        if (!thing.isHidden)
            addTriangles(thing, vertices);
    std::vector<Vec3> corners;
    for (const ThingVertex &vertex : vertices)
        corners.emplace_back(vertex.position[0], vertex.position[1], vertex.position[2]);
    return corners;
}

} // namespace fff::ui
