#include "tests/core/physics/reference_case.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/moments.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <limits>

namespace fff::test {

namespace {

constexpr double kPlayOfTightSlit = 0.01; // mm
constexpr double kHandedness = 1e-6;      // no unit

QString key(const char *name)
{
    return QString::fromLatin1(name);
}

std::string textOf(const QJsonValue &value)
{
    return value.toString().toStdString();
}

Vec2 pointOf(const QJsonValue &value)
{
    const QJsonArray array = value.toArray();
    return {array.at(0).toDouble(), array.at(1).toDouble()};
}

Vec3 vectorOf(const QJsonValue &value)
{
    const QJsonArray array = value.toArray();
    return {array.at(0).toDouble(), array.at(1).toDouble(), array.at(2).toDouble()};
}

Polygon polygonOf(const QJsonValue &value)
{
    Polygon polygon;
    for (const QJsonValue &point : value.toArray())
        polygon.push_back(pointOf(point));
    return polygon;
}

ReferenceMaterial materialOf(const QJsonObject &json)
{
    return {json[key("E_MPa")].toDouble(), json[key("nu")].toDouble(),
            json[key("density_kg_m3")].toDouble(), json[key("tensile_strength_MPa")].toDouble()};
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
    constexpr double kCubicMillimetres = 1e-9; // m³
    section.mass.mass = section.material.density * section.thickness * sum.area * kCubicMillimetres;
    section.mass.centre = section.frame.toWorld(sum.centroid());
    return true;
}

std::optional<ReferenceSection> sectionOf(const QJsonObject &json, const ReferenceMaterial &common)
{
    ReferenceSection section;
    section.id = textOf(json[key("id")]);
    const QJsonObject frame = json[key("frame")].toObject();
    section.frame.origin = vectorOf(frame[key("origin_mm")]);
    // Files round the axes to nine digits.
    section.frame.x = vectorOf(frame[key("u")]).normalized();
    const Vec3 y = vectorOf(frame[key("v")]);
    section.frame.y = (y - y.dot(section.frame.x) * section.frame.x).normalized();
    if (frame.contains(key("n")) &&
        (section.frame.normal() - vectorOf(frame[key("n")])).norm() > kHandedness)
        return {};
    section.thickness = json[key("thickness_mm")].toDouble();
    const QJsonObject own = json[key("material")].toObject();
    section.material = own.isEmpty() ? common : materialOf(own);
    section.outline = polygonOf(json[key("outline_mm")]);
    for (const QJsonValue &hole : json[key("holes_mm")].toArray())
        section.holes.push_back(polygonOf(hole));
    for (const QJsonValue &value : json[key("slits")].toArray()) {
        const QJsonObject slit = value.toObject();
        section.slits.push_back({textOf(slit[key("joint")]), pointOf(slit[key("p")]),
                                 pointOf(slit[key("d")]), slit[key("length")].toDouble(),
                                 slit[key("width")].toDouble(), polygonOf(slit[key("rect")])});
    }
    if (!cutOut(section))
        return {};
    return section;
}

/// By its id; −1: there is none.
int sectionNamed(const ReferenceCase &found, const QJsonValue &id)
{
    for (std::size_t i = 0; i < found.sections.size(); ++i) {
        if (found.sections[i].id == textOf(id))
            return static_cast<int>(i);
    }
    return -1;
}

std::optional<Balance> balanceOf(const QString &verdict)
{
    const std::pair<const char *, Balance> words[] = {
        {"float", Balance::Floating},       {"no contact", Balance::NoContact},
        {"toppl", Balance::Topples},        {"line support", Balance::LineSupport},
        {"unstable", Balance::LineSupport}, {"slide", Balance::Slides},
        {"mechanism", Balance::Mechanism},  {"stand", Balance::Stands}};
    for (const auto &[word, balance] : words) {
        if (verdict.contains(key(word), Qt::CaseInsensitive))
            return balance;
    }
    return {};
}

std::map<std::string, double> numbersOf(const QJsonObject &json)
{
    std::map<std::string, double> numbers;
    for (auto i = json.begin(); i != json.end(); ++i) {
        if (i.value().isDouble())
            numbers[i.key().toStdString()] = i.value().toDouble();
    }
    return numbers;
}

std::vector<std::vector<std::string>> groupsOf(const QJsonValue &value)
{
    std::vector<std::vector<std::string>> groups;
    for (const QJsonValue &group : value.toArray()) {
        groups.emplace_back();
        for (const QJsonValue &id : group.toArray())
            groups.back().push_back(textOf(id));
    }
    return groups;
}

/// A point of the ground, given in space or by the two coordinates that are not its normal's.
Vec3 groundPointOf(const QJsonValue &value, const Structure &structure, const Vec3 &ground)
{
    const QJsonArray array = value.toArray();
    if (array.size() == 3)
        return vectorOf(value);
    Vec3 point = ground;
    int given = 0;
    Eigen::Index height = 0;
    structure.up.cwiseAbs().maxCoeff(&height);
    for (int i = 0; i < 3; ++i) {
        if (i != height)
            point[i] = array.at(given++).toDouble();
    }
    return point;
}

ReferenceTruth truthOf(const QJsonObject &json, const ReferenceCase &found, const Vec3 &ground)
{
    ReferenceTruth truth;
    if (json.contains(key("mass_kg")))
        truth.mass = json[key("mass_kg")].toDouble();
    if (json.contains(key("com_mm")))
        truth.centre = vectorOf(json[key("com_mm")]);
    for (const QJsonValue &reaction : json[key("contact_reactions_N")].toArray())
        truth.reactions.push_back(vectorOf(reaction));
    const QJsonObject joints = json[key("joint_wrenches")].toObject();
    for (auto i = joints.begin(); i != joints.end(); ++i) {
        const QJsonObject wrench = i.value().toObject();
        truth.joints[i.key().toStdString()] = {
            vectorOf(wrench[key("force_on_a_N")]),
            vectorOf(wrench[key("moment_on_a_about_point_Nmm")])};
    }
    for (const QJsonValue &value : json[key("cuts")].toArray()) {
        const QJsonObject cut = value.toObject();
        truth.cuts.push_back({textOf(cut[key("name")]), sectionNamed(found, cut[key("section")]),
                              pointOf(cut[key("p0")]), pointOf(cut[key("p1")]),
                              numbersOf(cut[key("fem")].toObject()),
                              numbersOf(cut[key("statics_resultant")].toObject())});
    }
    truth.balance = balanceOf(json[key("verdict")].toString());
    if (json.contains(key("margin_mm")))
        truth.margin = json[key("margin_mm")].toDouble();
    if (json.contains(key("resultant_point_mm")))
        truth.resultant = groundPointOf(json[key("resultant_point_mm")], found.structure, ground);
    truth.components = groupsOf(json[key("components")]);
    truth.unsupported = groupsOf(json[key("unsupported")]);
    return truth;
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

bool addLinks(const QJsonArray &joints, ReferenceCase &found)
{
    for (const QJsonValue &value : joints) {
        const QJsonObject json = value.toObject();
        Link link;
        link.a = sectionNamed(found, json[key("a")]);
        link.b = sectionNamed(found, json[key("b")]);
        if (link.a < 0 || link.b < 0)
            return false;
        const ReferenceSection &a = found.sections[link.a], &b = found.sections[link.b];
        const std::string id = textOf(json[key("id")]);
        link.point = vectorOf(json[key("point_mm")]);
        link.axis = vectorOf(json[key("axis_open_a")]).normalized();
        link.normalA = a.frame.normal();
        link.normalB = b.frame.normal();
        link.depthA = json[key("slit_len_a_mm")].toDouble();
        link.depthB = json[key("slit_len_b_mm")].toDouble();
        link.thicknessA = a.thickness;
        link.thicknessB = b.thickness;
        link.modulusA = a.material.modulus;
        link.modulusB = b.material.modulus;
        link.grip = std::numeric_limits<double>::infinity(); // the solver's slits are glued
        for (const ReferenceSlit &slit : a.slits) {
            const double sine = link.normalA.cross(link.normalB).norm();
            if (slit.joint == id)
                link.isTight = slit.width * sine - b.thickness < kPlayOfTightSlit;
        }
        found.joints.push_back(id);
        found.structure.links.push_back(link);
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
        foot.stiffness =
            found.sections[foot.member].material.modulus * found.sections[foot.member].thickness;
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
        if (json.contains(key("moment_Nmm")))
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
                                vectorOf(json[key("plane_normal")]).normalized()});
    }
    return true;
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
    const ReferenceMaterial material = materialOf(json[key("material")].toObject());
    for (const QJsonValue &value : json[key("sections")].toArray()) {
        std::optional<ReferenceSection> section = sectionOf(value.toObject(), material);
        if (!section)
            return failed(key("a section that is none"));
        found.sections.push_back(std::move(*section));
    }
    const QJsonObject ground = json[key("ground")].toObject();
    found.structure.gravity = vectorOf(json[key("gravity_m_s2")]);
    found.structure.up = vectorOf(ground[key("normal")]).normalized();
    addMembers(found);
    if (!addLinks(json[key("joints")].toArray(), found) ||
        !addContacts(json[key("contacts")].toArray(), found) ||
        !addLoads(json[key("loads")].toArray(), found) ||
        !addClamps(json[key("clamps")].toArray(), found))
        return failed(key("it names a section that is not there"));
    const Vec3 onGround = vectorOf(ground[key("point_mm")]);
    found.truth = truthOf(json[key("truth")].toObject(), found, onGround);
    found.contact = truthOf(json[key("truth_contact")].toObject(), found, onGround);
    found.contactWithPlay = truthOf(json[key("truth_contact_play")].toObject(), found, onGround);
    return found;
}

} // namespace fff::test
