#include "app/cli/info.h"

#include "core/analysis/check_rules.h"
#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/footing.h"
#include "core/assembly/cycles.h"
#include "core/assembly/step_groups.h"
#include "core/base/units.h"
#include "core/fabrication/summary.h"
#include "core/geometry/convex_hull.h"
#include "core/io/json_writer.h"
#include "core/model/joint_kind_names.h"

#include <algorithm>
#include <set>

namespace fff::cli {

namespace {

using io::JsonWriter;

/// Scripts know tabs by what a person sees of them: an edge on a face.
std::string_view kindName(JointKind kind)
{
    return kind == JointKind::Tabs ? "edge" : nameOf(kind);
}

void writeFrame(JsonWriter &json, const Frame &frame)
{
    json.key("frame");
    json.beginObject(JsonWriter::Layout::Line);
    json.member("origin", frame.origin);
    json.member("x", frame.x);
    json.member("y", frame.y);
    json.endObject();
}

void writeStocks(JsonWriter &json, const Document &document)
{
    json.key("stocks");
    json.beginArray();
    for (const auto &stock : document.stocks) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("name", stock->name);
        json.member("thickness", stock->thickness);
        json.member("density", stock->density);
        json.member("kerf", stock->kerf);
        json.member("clearance", stock->clearance);
        json.member("sheet", stock->sheet);
        json.endObject();
    }
    json.endArray();
}

/// Those that are cut, or the tabs.
void writeSlits(JsonWriter &json, const Model &model, const std::vector<Slit> &slits, SlitRole role)
{
    json.key(role == SlitRole::Tab ? "tabs" : "slits");
    json.beginArray();
    for (const Slit &slit : slits) {
        if (slit.role != role)
            continue;
        json.beginObject(JsonWriter::Layout::Line);
        json.member("joint", slit.joint);
        json.member("with", model.section(static_cast<std::size_t>(slit.guest))->name);
        json.member("from", slit.mouth);
        json.member("to", slit.inner);
        json.member("width", slit.width);
        if (role == SlitRole::Slit)
            json.member("open", slit.isOpen);
        json.endObject();
    }
    json.endArray();
}

void writeSection(JsonWriter &json, const Analysis &analysis, std::size_t index)
{
    const Model &model = analysis.model;
    const Section &section = *model.section(index);
    const Stock &stock = model.stockOf(index);
    const MassProperties mass = analysis.bodies.massOf(static_cast<int>(index));
    json.beginObject();
    json.member("id", section.id.value);
    json.member("name", section.name);
    json.member("area", section.shape->area());
    json.member("thickness", stock.thickness);
    json.member("mass", mass.mass);
    json.member("centroid", section.frame.toWorld(section.shape->centroid()));
    writeFrame(json, section.frame);
    writeSlits(json, model, analysis.assembly.slits[index], SlitRole::Slit);
    writeSlits(json, model, analysis.assembly.slits[index], SlitRole::Tab);
    json.endObject();
}

void writeJoint(JsonWriter &json, const Model &model, const Joint &joint)
{
    const Axis &axis = joint.crossing->axis;
    json.beginObject();
    json.member("id", joint.id);
    json.member("a", model.section(static_cast<std::size_t>(joint.a))->name);
    json.member("b", model.section(static_cast<std::size_t>(joint.b))->name);
    json.member("angle", degrees(joint.crossing->angle));
    json.key("axis");
    json.beginObject(JsonWriter::Layout::Line);
    json.member("point", axis.point);
    json.member("direction", axis.direction);
    json.endObject();
    json.member("kind", kindName(joint.kind));
    json.key("overlaps");
    json.beginArray();
    for (const Overlap &overlap : joint.crossing->overlaps) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("from", axis.at(overlap.from));
        json.member("to", axis.at(overlap.to));
        json.member("meet", axis.at(overlap.meet));
        json.endObject();
    }
    json.endArray();
    json.endObject();
}

/// Each connected group stands or falls by itself: the model is stable when all of them are, by the
/// smallest of their margins. It is not stable where some of it is held by nothing, or what was
/// found says so.
void writeStability(JsonWriter &json, const Analysis &analysis,
                    const std::vector<std::vector<int>> &groups, const std::vector<Finding> &found)
{
    int contacts = 0;
    std::vector<Vec2> corners;
    bool isStable = groups.size() == 1 && !verdictDoubts(found).standing.source;
    std::optional<double> margin, tipAngle;
    for (const std::vector<int> &group : groups) {
        if (&group != &groups.front() && isLoosePiece(analysis.bodies, group))
            continue;
        const Stability stability = stabilityOf(analysis, group);
        contacts += stability.contacts;
        corners.insert(corners.end(), stability.support.begin(), stability.support.end());
        if (stability.contacts > 0)
            margin = std::min(margin.value_or(stability.margin), stability.margin);
        if (stability.standing == Standing::Stands)
            tipAngle = std::min(tipAngle.value_or(stability.tipAngle), stability.tipAngle);
        else
            isStable = false;
    }
    json.member("contacts", contacts);
    json.key("supportPolygon");
    json.beginArray(JsonWriter::Layout::Line);
    for (const Vec2 &corner : convexHull(corners))
        json.value(corner);
    json.endArray();
    json.member("stable", isStable);
    json.key("stabilityMargin");
    if (margin)
        json.value(*margin);
    else
        json.null(); // nothing touches the ground
    if (isStable && tipAngle)
        json.member("tipAngle", degrees(*tipAngle));
}

void writeRing(JsonWriter &json, const Polygon &ring)
{
    constexpr int kPointsPerLine = 8;
    json.beginArray(JsonWriter::Layout::Block, kPointsPerLine);
    for (const Vec2 &point : ring)
        json.value(point);
    json.endArray();
}

/// Rings whose axes are not parallel.
void writeCycles(JsonWriter &json, const Analysis &analysis)
{
    json.key("cycles");
    json.beginArray();
    for (const std::vector<int> &cycle :
         cyclesOf(analysis.model.sectionCount(), analysis.assembly.joints)) {
        json.beginArray(JsonWriter::Layout::Line);
        for (const int section : cycle)
            json.value(analysis.model.section(static_cast<std::size_t>(section))->name);
        json.endArray();
    }
    json.endArray();
}

/// Whether there is an order, and the sections in it, or those that block each other.
void writeAssemblability(JsonWriter &json, const Model &model, const ModelPlan &plan,
                         const std::vector<Finding> &found)
{
    json.key("assemblable");
    // What takes up the same place is passed over by the plan, and so is how slits are cut.
    if (plan.plan.verdict == AssemblyPlan::Verdict::NotFound ||
        pairsInEachOther(plan, CheckRules().touching) > 0 ||
        (plan.plan.verdict == AssemblyPlan::Verdict::Possible &&
         verdictDoubts(found).assembly.source))
        json.value("unknown");
    else
        json.value(plan.plan.verdict == AssemblyPlan::Verdict::Possible);
    const auto writeName = [&](int part) {
        const int section = plan.bodies.sectionOf(part);
        json.value(model.section(static_cast<std::size_t>(section))->name);
    };
    json.key("assemblyOrder");
    json.beginArray(JsonWriter::Layout::Line);
    for (const AssemblyStep &step : plan.plan.steps)
        if (step.parts.size() == 1) // each part has one such step
            writeName(step.parts.front());
    json.endArray();
    json.key("blocked");
    json.beginArray(JsonWriter::Layout::Line);
    for (const int part : plan.plan.locked)
        writeName(part);
    json.endArray();
}

/// Parts by their numbers, steps counted from 0. Nothing where there is no order.
void writeAssembly(JsonWriter &json, const AssemblyPlan &plan)
{
    if (plan.verdict != AssemblyPlan::Verdict::Possible)
        return;
    json.key("assembly");
    json.beginArray();
    const std::vector<StepGroup> groups = stepGroups(plan);
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const AssemblyStep &step = plan.steps[i];
        const Move last = step.moves.empty() ? Move() : step.moves.back();
        json.beginObject();
        json.key("parts");
        json.beginArray(JsonWriter::Layout::Line);
        for (const int part : step.parts)
            json.value(part + 1);
        json.endArray();
        json.member("direction", last.direction);
        json.member("distance", last.distance);
        if (step.moves.size() > 1) {
            json.key("before"); // what brings them to where that begins
            json.beginArray();
            for (std::size_t m = 0; m + 1 < step.moves.size(); ++m) {
                json.beginObject();
                json.member("direction", step.moves[m].direction);
                json.member("distance", step.moves[m].distance);
                json.endObject();
            }
            json.endArray();
        }
        json.member("group", groups[i].group);
        if (!groups[i].joins.empty()) {
            json.key("joins");
            json.beginArray(JsonWriter::Layout::Line);
            for (const int joined : groups[i].joins)
                json.value(joined);
            json.endArray();
        }
        json.endObject();
    }
    json.endArray();
}

} // namespace

std::string infoJson(const Analysis &analysis, const ModelPlan &plan,
                     const std::vector<Finding> &found, const InfoContext &context)
{
    const Model &model = analysis.model;
    const Assembly &assembly = analysis.assembly;
    std::size_t holes = 0, controlPoints = 0, overlaps = 0, slits = 0;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Shape &shape = *model.section(i)->shape;
        holes += shape.holes().size();
        // Counted as written in path formats: each closed curve names its first point again at its
        // end.
        controlPoints +=
            static_cast<std::size_t>(shape.controlPointCount()) + 1 + shape.holes().size();
        slits += static_cast<std::size_t>(
            std::count_if(assembly.slits[i].begin(), assembly.slits[i].end(),
                          [](const Slit &slit) { return slit.role == SlitRole::Slit; }));
    }
    for (const Joint &joint : assembly.joints)
        overlaps += joint.crossing->overlaps.size();
    const auto groups = heldGroups(analysis);

    JsonWriter json;
    json.beginObject();
    json.member("file", context.file);
    json.member("format", context.format);
    json.member("sections", model.sectionCount());
    json.member("holes", holes);
    json.member("controlPoints", controlPoints);
    writeStocks(json, model.document);
    json.member("joints", assembly.joints.size());
    json.member("overlaps", overlaps);
    json.member("slits", slits);
    json.member("components", groups.size());
    json.key("unconnected");
    json.beginArray(JsonWriter::Layout::Line);
    std::set<int> unconnected; // each once, whatever fell off it
    for (std::size_t g = 1; g < groups.size(); ++g)
        for (const int section : sectionsOf(analysis.bodies, groups[g]))
            unconnected.insert(section);
    for (const int section : unconnected)
        json.value(model.section(static_cast<std::size_t>(section))->name);
    json.endArray();
    writeCycles(json, analysis);
    writeAssemblability(json, model, plan, found);
    const MassProperties mass = analysis.bodies.mass();
    json.member("mass", mass.mass);
    json.member("centreOfMass", mass.centre);
    const Box3 bounds = slabBounds(model);
    json.key("bounds");
    if (bounds.isEmpty()) {
        json.null();
    } else {
        json.beginArray(JsonWriter::Layout::Line);
        json.value(bounds.min);
        json.value(bounds.max);
        json.endArray();
    }
    writeStability(json, analysis, groups, found);
    json.key("sectionList");
    json.beginArray();
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        writeSection(json, analysis, i);
    json.endArray();
    json.key("jointList");
    json.beginArray();
    for (const Joint &joint : assembly.joints)
        writeJoint(json, model, joint);
    json.endArray();
    json.endObject();
    return json.take();
}

std::string partsJson(const std::vector<Part> &parts, const Model &model, const AssemblyPlan &plan)
{
    JsonWriter json;
    json.beginObject();
    json.key("parts");
    json.beginArray();
    for (const Part &part : parts) {
        const Section &section = *model.section(static_cast<std::size_t>(part.section));
        json.beginObject();
        json.member("section", section.name);
        json.member("number", part.number);
        json.member("thickness", model.stockOf(static_cast<std::size_t>(part.section)).thickness);
        writeFrame(json, section.frame);
        json.key("outer");
        writeRing(json, part.outline.region.outer);
        json.key("holes");
        json.beginArray();
        for (const Polygon &hole : part.outline.region.holes)
            writeRing(json, hole);
        json.endArray();
        json.endObject();
    }
    json.endArray();
    writeAssembly(json, plan);
    json.endObject();
    return json.take();
}

} // namespace fff::cli
