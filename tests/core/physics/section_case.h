// The reference cases of mechanics, read for one section: its material and all that acts on it.
#pragma once

#include "core/physics/applied_force.h"

#include <polyclipping/clipper.hpp>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include <cmath>
#include <vector>

namespace fff::test {

/// A cut that a case names, with what finite elements say of it.
struct CaseCut
{
    QString name;
    Vec2 p0 = Vec2::Zero(), p1 = Vec2::Zero();
    double linear = 0.0; // MPa, sigma_lin
    QJsonObject fem, statics;
};

struct SectionCase
{
    QString section;
    Region region;
    std::vector<SlitLine> slits;
    std::vector<AppliedForce> forces;
    SheetMaterial sheet;
    std::vector<CaseCut> cuts;
};

inline Vec3 threeOf(const QJsonValue &value)
{
    const QJsonArray a = value.toArray();
    return {a[0].toDouble(), a[1].toDouble(), a[2].toDouble()};
}

inline Vec2 twoOf(const QJsonValue &value)
{
    const QJsonArray a = value.toArray();
    return {a[0].toDouble(), a[1].toDouble()};
}

inline Polygon polygonOf(const QJsonValue &value)
{
    Polygon polygon;
    for (const QJsonValue &p : value.toArray())
        polygon.push_back(twoOf(p));
    return polygon;
}

inline QJsonObject readCase(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}

/// Clipper's integers: nanometres.
constexpr double kPerMm = 1e6;

inline ClipperLib::Path pathOf(const Polygon &polygon)
{
    ClipperLib::Path path;
    for (const Vec2 &p : polygon)
        path.emplace_back(std::llround(p.x() * kPerMm), std::llround(p.y() * kPerMm));
    return path;
}

inline Polygon ringOf(const ClipperLib::Path &path)
{
    Polygon ring;
    for (const ClipperLib::IntPoint &p : path)
        ring.emplace_back(static_cast<double>(p.X) / kPerMm, static_cast<double>(p.Y) / kPerMm);
    return ring;
}

/// The largest piece of an outline without its holes and slits.
inline Region withoutSlits(const Polygon &outline, const std::vector<Polygon> &taken)
{
    ClipperLib::Clipper clipper;
    const auto add = [&clipper](const Polygon &polygon, ClipperLib::PolyType type) {
        ClipperLib::Path path = pathOf(polygon);
        if (!ClipperLib::Orientation(path))
            ClipperLib::ReversePath(path);
        clipper.AddPath(path, type, true);
    };
    add(outline, ClipperLib::ptSubject);
    for (const Polygon &polygon : taken)
        add(polygon, ClipperLib::ptClip);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    Region best;
    for (const ClipperLib::PolyNode *node : tree.Childs) {
        Region region{ringOf(node->Contour), {}};
        for (const ClipperLib::PolyNode *hole : node->Childs)
            region.holes.push_back(ringOf(hole->Contour));
        if (best.outer.empty() || area(region) > area(best))
            best = region;
    }
    return best;
}

/// World to a section's frame.
struct CaseFrame
{
    Vec3 origin, u, v, n;

    Vec2 point(const Vec3 &p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
    double height(const Vec3 &p) const { return n.dot(p - origin); }
    Vec3 vector(const Vec3 &a) const { return {u.dot(a), v.dot(a), n.dot(a)}; }
};

class SectionReader
{
public:
    SectionReader(const QJsonObject &given, const QString &section, const QString &truthKey)
        : m_given(given), m_truth(given[truthKey].toObject())
    {
        m_case.section = section;
        for (const QJsonValue &value : given[u"sections"].toArray())
            if (value[u"id"].toString() == section)
                readSection(value.toObject());
        readLoads();
        readFeet();
        readJoints();
        readClamps();
        readCuts();
    }
    const SectionCase &result() const { return m_case; }

private:
    void readSection(const QJsonObject &section)
    {
        const QJsonObject f = section[u"frame"].toObject();
        m_frame = {threeOf(f[u"origin_mm"]), threeOf(f[u"u"]), threeOf(f[u"v"]), threeOf(f[u"n"])};
        std::vector<Polygon> taken;
        for (const QJsonValue &hole : section[u"holes_mm"].toArray())
            taken.push_back(polygonOf(hole));
        for (const QJsonValue &slit : section[u"slits"].toArray()) {
            taken.push_back(polygonOf(slit[u"rect"]));
            m_case.slits.push_back({twoOf(slit[u"p"]), twoOf(slit[u"d"]),
                                    slit[u"length"].toDouble(), slit[u"width"].toDouble()});
            m_slitJoints.push_back(slit[u"joint"].toString());
        }
        m_case.region = withoutSlits(polygonOf(section[u"outline_mm"]), taken);
        const QJsonObject material = m_given[u"material"].toObject();
        m_case.sheet.thickness = section[u"thickness_mm"].toDouble();
        m_case.sheet.strength = material[u"tensile_strength_MPa"].toDouble();
        m_case.sheet.modulus = material[u"E_MPa"].toDouble();
        const double areal =
            material[u"density_kg_m3"].toDouble() * 1e-9 * m_case.sheet.thickness; // kg/mm²
        m_case.sheet.arealWeight = areal * m_frame.vector(threeOf(m_given[u"gravity_m_s2"]));
    }
    void add(ForceKind kind, const Vec3 &point, const Vec3 &force, const Vec3 &moment,
             double radius, const SlitLine &slit = {})
    {
        AppliedForce f;
        f.kind = kind;
        f.at = m_frame.point(point);
        f.force = m_frame.vector(force);
        // From the face of the sheet to its middle.
        f.moment = m_frame.vector(moment) + Vec3(0, 0, m_frame.height(point)).cross(f.force);
        f.radius = radius;
        f.slit = slit;
        m_case.forces.push_back(f);
    }
    void readLoads()
    {
        for (const QJsonValue &load : m_given[u"loads"].toArray())
            if (load[u"section"].toString() == m_case.section)
                add(ForceKind::Load, threeOf(load[u"point_mm"]), threeOf(load[u"force_N"]),
                    Vec3::Zero(), load[u"patch_radius_mm"].toDouble());
    }
    void readFeet()
    {
        const QJsonArray feet = m_given[u"contacts"].toArray();
        const QJsonArray reactions = m_truth[u"contact_reactions_N"].toArray();
        for (int i = 0; i < feet.size(); ++i)
            if (feet[i][u"section"].toString() == m_case.section)
                add(ForceKind::Foot, threeOf(feet[i][u"point_mm"]), threeOf(reactions[i]),
                    Vec3::Zero(), 0.0);
    }
    void readJoints()
    {
        const QJsonObject wrenches = m_truth[u"joint_wrenches"].toObject();
        for (const QJsonValue &joint : m_given[u"joints"].toArray()) {
            const QString id = joint[u"id"].toString();
            const bool isA = joint[u"a"].toString() == m_case.section;
            if (!isA && joint[u"b"].toString() != m_case.section)
                continue;
            const double sign = isA ? 1.0 : -1.0;
            const QJsonObject wrench = wrenches[id].toObject();
            SlitLine slit;
            for (std::size_t i = 0; i < m_slitJoints.size(); ++i)
                if (m_slitJoints[i] == id)
                    slit = m_case.slits[i];
            add(ForceKind::Link, threeOf(joint[u"point_mm"]),
                sign * threeOf(wrench[u"force_on_a_N"]),
                sign * threeOf(wrench[u"moment_on_a_about_point_Nmm"]), 0.0, slit);
        }
    }
    /// The clamp holds whatever else there is.
    void readClamps()
    {
        for (const QJsonValue &clamp : m_given[u"clamps"].toArray()) {
            if (clamp[u"section"].toString() != m_case.section)
                continue;
            const Vec3 point = threeOf(clamp[u"plane_point_mm"]);
            const Vec2 at = m_frame.point(point);
            Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
            for (const AppliedForce &f : m_case.forces) {
                const Vec2 lever = f.at - at;
                force -= f.force;
                moment -= f.moment + Vec3(lever.x(), lever.y(), 0).cross(f.force);
            }
            AppliedForce held;
            held.kind = ForceKind::Clamp;
            held.at = at;
            held.force = force;
            held.moment = moment;
            m_case.forces.push_back(held);
        }
    }
    void readCuts()
    {
        const QJsonArray named = m_given[u"truth"].toObject()[u"cuts"].toArray();
        for (const QJsonValue &value : m_truth[u"cuts"].toArray()) {
            if (value[u"section"].toString() != m_case.section)
                continue;
            CaseCut cut;
            cut.name = value[u"name"].toString();
            for (const QJsonValue &place : named) {
                if (place[u"name"].toString() == cut.name) {
                    cut.p0 = twoOf(place[u"p0"]);
                    cut.p1 = twoOf(place[u"p1"]);
                }
            }
            cut.fem = value[u"fem"].toObject();
            cut.statics = value[u"statics_resultant"].toObject();
            cut.linear = cut.fem[u"sigma_lin"].toDouble();
            m_case.cuts.push_back(cut);
        }
    }

    QJsonObject m_given, m_truth;
    CaseFrame m_frame;
    std::vector<QString> m_slitJoints;
    SectionCase m_case;
};

inline SectionCase sectionCase(const QJsonObject &given, const QString &section,
                               const QString &truthKey = QStringLiteral("truth"))
{
    return SectionReader(given, section, truthKey).result();
}

} // namespace fff::test
