// The reference cases of the product's mechanics, as plates and as a structure of them.
#pragma once

#include "core/geometry/boolean.h"
#include "core/physics/elastic_equilibrium.h"
#include "core/physics/plate_stress.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <optional>

namespace fff {

using namespace Qt::Literals::StringLiterals;

struct CaseSlit
{
    QString joint;
    Vec2 inner = Vec2::Zero(), opens = Vec2::UnitX();
    double depth = 0.0, width = 0.0;
};

struct CaseSection
{
    QString id;
    Frame frame;
    double thickness = 0.0;
    Region region; // without its slits
    std::vector<CaseSlit> slits;
    Vec2 centroid = Vec2::Zero();
};

struct PlateCase
{
    QJsonObject json;
    std::vector<CaseSection> sections;
    Structure structure;
    PlateMaterial material; // thickness is the section's
};

inline Vec2 vec2Of(const QJsonValue &value)
{
    return {value.toArray()[0].toDouble(), value.toArray()[1].toDouble()};
}
inline Vec3 vec3Of(const QJsonValue &value)
{
    const QJsonArray a = value.toArray();
    return {a[0].toDouble(), a[1].toDouble(), a[2].toDouble()};
}
inline Polygon polygonOf(const QJsonValue &value)
{
    Polygon polygon;
    for (const QJsonValue p : value.toArray())
        polygon.push_back(vec2Of(p));
    return polygon;
}

inline Vec2 centroidOf(const Region &region)
{
    Vec2 first = Vec2::Zero();
    double whole = 0.0;
    const auto add = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
            whole += 0.5 * cross(p, q);
            first += cross(p, q) / 6.0 * (p + q);
        }
    };
    add(region.outer);
    for (const Polygon &hole : region.holes)
        add(hole);
    return first / whole;
}

inline CaseSection sectionOf(const QJsonObject &json)
{
    CaseSection section;
    section.id = json["id"_L1].toString();
    const QJsonObject frame = json["frame"_L1].toObject();
    section.frame = {vec3Of(frame["origin_mm"_L1]), vec3Of(frame["u"_L1]), vec3Of(frame["v"_L1])};
    section.thickness = json["thickness_mm"_L1].toDouble();
    std::vector<Contour> holes;
    for (const QJsonValue hole : json["holes_mm"_L1].toArray())
        holes.push_back(Contour::ofPolygon(polygonOf(hole)));
    std::vector<Polygon> cuts;
    for (const QJsonValue value : json["slits"_L1].toArray()) {
        const QJsonObject slit = value.toObject();
        cuts.push_back(polygonOf(slit["rect"_L1]));
        section.slits.push_back({slit["joint"_L1].toString(), vec2Of(slit["p"_L1]),
                                 vec2Of(slit["d"_L1]), slit["length"_L1].toDouble(),
                                 slit["width"_L1].toDouble()});
    }
    const auto pieces =
        subtract(Contour::ofPolygon(polygonOf(json["outline_mm"_L1])), holes, cuts, 1e-3);
    if (pieces && !pieces->empty())
        section.region = pieces->front().region;
    section.centroid = centroidOf(section.region);
    return section;
}

inline int sectionIndex(const PlateCase &plates, const QJsonValue &id)
{
    for (std::size_t i = 0; i < plates.sections.size(); ++i) {
        if (plates.sections[i].id == id.toString())
            return static_cast<int>(i);
    }
    return -1;
}

inline Link linkOf(const PlateCase &plates, const QJsonObject &joint)
{
    Link link;
    link.a = sectionIndex(plates, joint["a"_L1]);
    link.b = sectionIndex(plates, joint["b"_L1]);
    const CaseSection &a = plates.sections[static_cast<std::size_t>(link.a)];
    const CaseSection &b = plates.sections[static_cast<std::size_t>(link.b)];
    link.point = vec3Of(joint["point_mm"_L1]);
    link.axis = vec3Of(joint["axis_open_a"_L1]);
    link.normalA = a.frame.normal();
    link.normalB = b.frame.normal();
    link.depthA = joint["slit_len_a_mm"_L1].toDouble();
    link.depthB = joint["slit_len_b_mm"_L1].toDouble();
    link.thicknessA = a.thickness;
    link.thicknessB = b.thickness;
    link.modulusA = link.modulusB = plates.material.modulus;
    return link;
}

/// Nothing where the file is not there or is none of them.
inline std::optional<PlateCase> readCase(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    PlateCase plates;
    plates.json = QJsonDocument::fromJson(file.readAll()).object();
    const QJsonObject material = plates.json["material"_L1].toObject();
    plates.material = {3.0, material["E_MPa"_L1].toDouble(), material["nu"_L1].toDouble(),
                       material["density_kg_m3"_L1].toDouble() * 1e-9};
    for (const QJsonValue section : plates.json["sections"_L1].toArray())
        plates.sections.push_back(sectionOf(section.toObject()));
    if (plates.sections.empty())
        return std::nullopt;
    Structure &structure = plates.structure;
    structure.gravity = vec3Of(plates.json["gravity_m_s2"_L1]);
    structure.up = vec3Of(plates.json["ground"_L1].toObject()["normal"_L1]);
    Box3 box;
    for (const CaseSection &section : plates.sections) {
        structure.members.push_back(
            {area(section.region) * section.thickness * plates.material.density,
             section.frame.toWorld(section.centroid)});
        for (const Vec2 &p : section.region.outer)
            box.extend(section.frame.toWorld(p));
    }
    structure.size = box.size().maxCoeff();
    for (const QJsonValue joint : plates.json["joints"_L1].toArray())
        structure.links.push_back(linkOf(plates, joint.toObject()));
    for (const QJsonValue value : plates.json["contacts"_L1].toArray()) {
        const QJsonObject contact = value.toObject();
        Foot foot{sectionIndex(plates, contact["section"_L1]), vec3Of(contact["point_mm"_L1]), 0.0};
        foot.stiffness = plates.material.modulus *
                         plates.sections[static_cast<std::size_t>(foot.member)].thickness;
        structure.feet.push_back(foot);
    }
    for (const QJsonValue value : plates.json["loads"_L1].toArray()) {
        const QJsonObject load = value.toObject();
        structure.loads.push_back({sectionIndex(plates, load["section"_L1]),
                                   vec3Of(load["point_mm"_L1]), vec3Of(load["force_N"_L1]),
                                   Vec3::Zero()});
    }
    return plates;
}

/// A section as finite elements, with what holds it and what acts on it.
struct CasePlate
{
    PlateModel model;
    std::vector<MemberAttachment> at;
    std::vector<PlateAttachment> attachments;
    PlateField loads;
};

inline Vec3 inFrame(const Frame &frame, const Vec3 &way)
{
    return {frame.x.dot(way), frame.y.dot(way), frame.normal().dot(way)};
}

/// A clamp as the stretch of the outline that lies in its plane.
inline std::vector<PlateClamp> clampsOf(const PlateCase &plates, int index)
{
    const CaseSection &section = plates.sections[static_cast<std::size_t>(index)];
    std::vector<PlateClamp> clamps;
    for (const QJsonValue value : plates.json["clamps"_L1].toArray()) {
        const QJsonObject clamp = value.toObject();
        if (clamp["section"_L1].toString() != section.id)
            continue;
        const Vec3 point = vec3Of(clamp["plane_point_mm"_L1]),
                   normal = vec3Of(clamp["plane_normal"_L1]);
        const auto isOn = [&](const Vec2 &p) {
            return std::abs(normal.dot(section.frame.toWorld(p) - point)) < 1e-6;
        };
        const Polygon &ring = section.region.outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
            if (isOn(p) && isOn(q))
                clamps.push_back({p, q});
        }
    }
    return clamps;
}

inline void addHolds(CasePlate &plate, const PlateCase &plates, int index)
{
    const CaseSection &section = plates.sections[static_cast<std::size_t>(index)];
    const QJsonArray joints = plates.json["joints"_L1].toArray();
    for (int j = 0; j < static_cast<int>(plates.structure.links.size()); ++j) {
        const Link &link = plates.structure.links[static_cast<std::size_t>(j)];
        if (link.a != index && link.b != index)
            continue;
        const bool isA = link.a == index;
        SlitAttachment slit;
        slit.inner = section.frame.toLocal(link.point);
        slit.opens = section.frame.directionToLocal(isA ? link.axis : Vec3(-link.axis));
        slit.depth = isA ? link.depthA : link.depthB;
        slit.heldDepth = isA ? link.depthB : link.depthA;
        slit.width = slit.heldWidth = isA ? link.thicknessB : link.thicknessA;
        plate.at.push_back({MemberAttachment::Kind::Link, j});
        plate.attachments.push_back(slitAttachment(plate.model, slit));
    }
    for (int k = 0; k < static_cast<int>(plates.structure.feet.size()); ++k) {
        const Foot &foot = plates.structure.feet[static_cast<std::size_t>(k)];
        if (foot.member != index)
            continue;
        plate.at.push_back({MemberAttachment::Kind::Foot, k});
        plate.attachments.push_back(discAttachment(plate.model, section.frame.toLocal(foot.point),
                                                   0.5 * section.thickness));
    }
}

inline void addLoads(CasePlate &plate, const PlateCase &plates, int index)
{
    const CaseSection &section = plates.sections[static_cast<std::size_t>(index)];
    plate.loads = plate.model.noField();
    plate.model.addWeight(plate.loads, inFrame(section.frame, plates.structure.gravity));
    const QJsonArray loads = plates.json["loads"_L1].toArray();
    for (int k = 0; k < static_cast<int>(loads.size()); ++k) {
        const MemberLoad &load = plates.structure.loads[static_cast<std::size_t>(k)];
        if (load.member != index)
            continue;
        const Vec2 at = section.frame.toLocal(load.point);
        const Vec3 force = inFrame(section.frame, load.force);
        const double above = section.frame.height(load.point);
        WrenchVector wrench;
        wrench << force, Vec3(0.0, 0.0, above).cross(force);
        addWrench(
            plate.loads, plate.model,
            discAttachment(plate.model, at, loads[k].toObject()["patch_radius_mm"_L1].toDouble()),
            wrench);
    }
}

inline Result<CasePlate> casePlate(const PlateCase &plates, int index,
                                   const PlateMeshOptions &options = {})
{
    const CaseSection &section = plates.sections[static_cast<std::size_t>(index)];
    PlateMaterial material = plates.material;
    material.thickness = section.thickness;
    auto mesh = plateMesh(section.region, options);
    if (!mesh)
        return tl::unexpected(mesh.error());
    auto model = PlateModel::make(*std::move(mesh), material, clampsOf(plates, index));
    if (!model)
        return tl::unexpected(model.error());
    CasePlate plate{*std::move(model), {}, {}, {}};
    addHolds(plate, plates, index);
    addLoads(plate, plates, index);
    return plate;
}

/// The forces on a section of a solved structure, and its displacements under them.
inline PlateField caseDisplacements(const PlateCase &plates, const CasePlate &plate, int index,
                                    const ElasticEquilibrium &solved)
{
    const Frame &frame = plates.sections[static_cast<std::size_t>(index)].frame;
    PlateField forces = plate.loads;
    for (std::size_t i = 0; i < plate.at.size(); ++i) {
        const auto k = static_cast<std::size_t>(plate.at[i].index);
        WrenchVector world = WrenchVector::Zero();
        if (plate.at[i].kind == MemberAttachment::Kind::Foot)
            world.head<3>() = solved.feet[k];
        else
            world = (plates.structure.links[k].a == index ? 1.0 : -1.0) * solved.links[k];
        WrenchVector local;
        local << inFrame(frame, world.head<3>()), inFrame(frame, world.tail<3>());
        addWrench(forces, plate.model, plate.attachments[i], local);
    }
    return plate.model.solve(forces);
}

} // namespace fff
