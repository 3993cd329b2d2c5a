#include "tests/core/physics/reference_case.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/moments.h"
#include "tests/core/physics/reference_json.h"

#include <QFile>
#include <QJsonDocument>

#include <cmath>
#include <limits>

namespace fff::test {

namespace {

constexpr double kPlayOfTightSlit = 0.01;     // mm
constexpr double kHandedness = 1e-6;          // no unit
constexpr double kBeyondOutline = 2.0;        // mm, of slits without a rectangle
constexpr double kStandardGravity = 9.81;     // m/s²
constexpr double kCubicMillimetreInM3 = 1e-9; // m³
constexpr double kPoissonOfPlastics = 0.37;   // no unit
const Vec3 kUpOfCases = Vec3::UnitZ();

double numberOf(const QJsonObject &json, const char *name, double otherwise)
{
    return json[key(name)].toDouble(otherwise);
}

/// `common` where it is not said.
ReferenceMaterial materialOf(const QJsonObject &json, const ReferenceMaterial &common)
{
    return {numberOf(json, "E_MPa", common.modulus), numberOf(json, "nu", common.poisson),
            numberOf(json, "density_kg_m3", common.density),
            numberOf(json, "tensile_strength_MPa", common.tensileStrength)};
}

/// What slits and holes leave of it, and what that weighs.
bool cutOut(ReferenceSection &section)
{
    const auto contour = [](const Polygon &polygon) { return Contour::fromPolygon(polygon); };
    const Result<Contour> outline = contour(section.outline);
    if (!outline)
        return false;
    std::vector<Contour> holes;
    for (const Polygon &hole : section.holes) {
        if (const Result<Contour> closed = contour(hole))
            holes.push_back(*closed);
    }
    std::vector<Polygon> cuts;
    for (const ReferenceSlit &slit : section.slits)
        cuts.push_back(slit.rectangle);
    const Result<std::vector<CurvedRegion>> pieces = subtract(*outline, holes, cuts, kCutChord);
    if (!pieces || pieces->empty())
        return false;
    Moments sum;
    for (const CurvedRegion &piece : *pieces) {
        section.regions.push_back(piece.region);
        sum += moments(piece.outer);
        for (const Contour &hole : piece.holes)
            sum += moments(hole);
    }
    section.mass.mass =
        section.material.density * section.thickness * sum.area * kCubicMillimetreInM3;
    section.mass.centre = section.frame.toWorld(sum.centroid());
    return true;
}

ReferenceSlit slitOf(const QJsonObject &json)
{
    ReferenceSlit slit{textOf(json[key("joint")]),    pointOf(json[key("p")]),
                       pointOf(json[key("d")]),       json[key("length")].toDouble(),
                       json[key("width")].toDouble(), polygonOf(json[key("rect")])};
    if (slit.opening.norm() > 0.0)
        slit.opening.normalize();
    if (slit.rectangle.size() < 3) {
        const Vec2 along = (slit.length + kBeyondOutline) * slit.opening;
        const Vec2 across = 0.5 * slit.width * Vec2(-slit.opening.y(), slit.opening.x());
        slit.rectangle = {slit.innerEnd - across, slit.innerEnd - across + along,
                          slit.innerEnd + across + along, slit.innerEnd + across};
    }
    return slit;
}

std::optional<ReferenceSection> sectionOf(const QJsonObject &json, const ReferenceMaterial &common)
{
    ReferenceSection section;
    section.id = textOf(json[key("id")]);
    const QJsonObject frame = json[key("frame")].toObject();
    section.frame.origin = vectorOf(frame[key("origin_mm")]);
    // Files round the axes to nine digits.
    section.frame.x = directionOf(frame[key("u")], Vec3::UnitX());
    const Vec3 y = directionOf(frame[key("v")], Vec3::UnitY());
    section.frame.y = (y - y.dot(section.frame.x) * section.frame.x).normalized();
    if (frame.contains(key("n")) &&
        (section.frame.normal() - vectorOf(frame[key("n")])).norm() > kHandedness)
        return {};
    section.thickness = json[key("thickness_mm")].toDouble();
    section.material = materialOf(json[key("material")].toObject(), common);
    section.outline = polygonOf(json[key("outline_mm")]);
    for (const QJsonValue &hole : json[key("holes_mm")].toArray())
        section.holes.push_back(polygonOf(hole));
    for (const QJsonValue &value : json[key("slits")].toArray())
        section.slits.push_back(slitOf(value.toObject()));
    if (section.thickness <= 0.0 || !cutOut(section))
        return {};
    return section;
}

/// By its id, which files may leave out where there is one section only; −1: there is none.
int sectionNamed(const ReferenceCase &found, const QJsonValue &id)
{
    if (id.isUndefined() && found.sections.size() == 1)
        return 0;
    for (std::size_t i = 0; i < found.sections.size(); ++i) {
        if (found.sections[i].id == textOf(id))
            return static_cast<int>(i);
    }
    return -1;
}

void addMembers(ReferenceCase &found)
{
    Structure &structure = found.structure;
    Box3 box;
    structure.thickness = std::numeric_limits<double>::infinity();
    for (const ReferenceSection &section : found.sections) {
        structure.members.push_back({section.mass.mass, section.mass.centre});
        structure.thickness = std::min(structure.thickness, section.thickness);
        for (const Vec2 &p : section.outline)
            box.extend(section.frame.toWorld(p));
    }
    structure.size = box.size().norm();
}

const ReferenceSlit *slitOfJoint(const ReferenceSection &section, const std::string &joint)
{
    for (const ReferenceSlit &slit : section.slits) {
        if (slit.joint == joint)
            return &slit;
    }
    return nullptr;
}

Link linkOf(const QJsonObject &json, const std::string &id, int first, int second,
            const ReferenceCase &found)
{
    Link link;
    link.a = first;
    link.b = second;
    const ReferenceSection &a = found.sections[static_cast<std::size_t>(first)],
                           &b = found.sections[static_cast<std::size_t>(second)];
    const ReferenceSlit *inA = slitOfJoint(a, id), *inB = slitOfJoint(b, id);
    link.point = json.contains(key("point_mm")) ? vectorOf(json[key("point_mm")])
                 : inA                          ? a.frame.toWorld(inA->innerEnd)
                 : inB                          ? b.frame.toWorld(inB->innerEnd)
                                                : Vec3(Vec3::Zero());
    link.axis =
        directionOf(json[key("axis_open_a")], inA   ? a.frame.directionToWorld(inA->opening)
                                              : inB ? Vec3(-b.frame.directionToWorld(inB->opening))
                                                    : Vec3(Vec3::UnitZ()));
    link.normalA = a.frame.normal();
    link.normalB = b.frame.normal();
    link.depthA = numberOf(json, "slit_len_a_mm", inA ? inA->length : 0.0);
    link.depthB = numberOf(json, "slit_len_b_mm", inB ? inB->length : 0.0);
    link.thicknessA = a.thickness;
    link.thicknessB = b.thickness;
    link.modulusA = a.material.modulus;
    link.modulusB = b.material.modulus;
    link.grip = numberOf(json, "grip_N", std::numeric_limits<double>::infinity());
    const double sine = link.normalA.cross(link.normalB).norm();
    if (inA)
        link.isTight = inA->width * sine - b.thickness < kPlayOfTightSlit;
    return link;
}

bool addLinks(const QJsonArray &joints, ReferenceCase &found)
{
    for (const QJsonValue &value : joints) {
        const QJsonObject json = value.toObject();
        const int a = sectionNamed(found, json[key("a")]), b = sectionNamed(found, json[key("b")]);
        if (a < 0 || b < 0)
            return false;
        const std::string id = textOf(json[key("id")]);
        found.joints.push_back(id);
        found.structure.links.push_back(linkOf(json, id, a, b, found));
    }
    return true;
}

bool addContacts(const QJsonArray &contacts, ReferenceCase &found)
{
    for (const QJsonValue &value : contacts) {
        const QJsonObject json = value.toObject();
        Foot foot;
        foot.member = sectionNamed(found, json[key("section")]);
        if (foot.member < 0)
            return false;
        foot.point = vectorOf(json[key("point_mm")]);
        const QJsonValue friction = json[key("friction")];
        foot.isPinned = friction.toString() == key("pinned");
        if (friction.isDouble())
            found.friction = std::max(found.friction, friction.toDouble());
        const ReferenceSection &section = found.sections[static_cast<std::size_t>(foot.member)];
        foot.stiffness = section.material.modulus * section.thickness;
        found.structure.feet.push_back(foot);
    }
    return true;
}

bool addLoads(const QJsonArray &loads, ReferenceCase &found)
{
    for (const QJsonValue &value : loads) {
        const QJsonObject json = value.toObject();
        MemberLoad load;
        load.member = sectionNamed(found, json[key("section")]);
        if (load.member < 0)
            return false;
        load.point = vectorOf(json[key("point_mm")]);
        load.force = vectorOf(json[key("force_N")]);
        load.moment = vectorOf(json[key("moment_Nmm")]);
        found.structure.loads.push_back(load);
        found.patches.push_back({load, json[key("patch_radius_mm")].toDouble()});
    }
    return true;
}

bool addClamps(const QJsonArray &clamps, ReferenceCase &found)
{
    for (const QJsonValue &value : clamps) {
        const QJsonObject json = value.toObject();
        const int section = sectionNamed(found, json[key("section")]);
        if (section < 0)
            return false;
        found.clamps.push_back({section, vectorOf(json[key("plane_point_mm")]),
                                directionOf(json[key("plane_normal")], Vec3::UnitX())});
    }
    return true;
}

/// Where nobody glued the slits to have forces, they hold nothing: only the verdict is asked.
void releaseUnglued(ReferenceCase &found)
{
    if (found.truth.isThere() || found.contact.isThere() || found.contactWithPlay.isThere())
        return;
    for (Link &link : found.structure.links) {
        if (!std::isfinite(link.grip))
            link.grip = 0.0;
    }
}

} // namespace

std::optional<ReferenceCase> readReferenceCase(const QString &path, QString *error)
{
    const auto failed = [&](const QString &what) {
        if (error)
            *error = path + key(": ") + what;
        return std::optional<ReferenceCase>();
    };
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failed(file.errorString());
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &fault);
    if (!document.isObject())
        return failed(fault.errorString());
    ReferenceCase found;
    const QJsonObject &json = found.json = document.object();
    found.id = textOf(json[key("id")]);
    found.title = textOf(json[key("title")]);
    found.notes = textOf(json[key("notes")]);
    ReferenceMaterial usual;
    usual.poisson = kPoissonOfPlastics;
    const ReferenceMaterial material = materialOf(json[key("material")].toObject(), usual);
    for (const QJsonValue &value : json[key("sections")].toArray()) {
        std::optional<ReferenceSection> section = sectionOf(value.toObject(), material);
        if (!section)
            return failed(key("a section that is none"));
        found.sections.push_back(std::move(*section));
    }
    found.structure.up = directionOf(json[key("ground")].toObject()[key("normal")], kUpOfCases);
    found.structure.gravity = json.contains(key("gravity_m_s2"))
                                  ? vectorOf(json[key("gravity_m_s2")])
                                  : Vec3(-kStandardGravity * found.structure.up);
    addMembers(found);
    if (!addLinks(json[key("joints")].toArray(), found) ||
        !addContacts(json[key("contacts")].toArray(), found) ||
        !addLoads(json[key("loads")].toArray(), found) ||
        !addClamps(json[key("clamps")].toArray(), found))
        return failed(key("it names a section that is not there"));
    found.truth = readReferenceTruth(found, "truth");
    found.contact = readReferenceTruth(found, "truth_contact");
    found.contactWithPlay = readReferenceTruth(found, "truth_contact_play");
    releaseUnglued(found);
    return found;
}

} // namespace fff::test
