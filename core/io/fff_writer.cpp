#include "core/io/fff_annotations.h"
#include "core/io/fff_blobs.h"
#include "core/io/fff_format.h"
#include "core/io/fff_loads.h"
#include "core/io/fff_operations.h"
#include "core/io/fff_sheets.h"
#include "core/io/fff_stocks.h"
#include "core/io/fff_templates.h"
#include "core/io/fff_values.h"
#include "core/io/json_writer.h"
#include "core/model/holds_to_names.h"
#include "core/model/joint_kind_names.h"
#include "core/model/value_names.h"

#include <unordered_map>

namespace fff::io {

namespace {

using Layout = JsonWriter::Layout;

constexpr int kPointsPerLine = 3; // one segment: its start and two handles

void writeContour(JsonWriter &json, const Contour &contour)
{
    json.beginArray(Layout::Block, kPointsPerLine);
    for (const Vec2 &point : contour.points())
        json.value(point);
    json.endArray();
}

void writeShape(JsonWriter &json, const Shape &shape)
{
    json.beginObject();
    json.key("contour");
    writeContour(json, shape.contour());
    if (!shape.holes().empty()) {
        json.key("holes");
        json.beginArray();
        for (const Contour &hole : shape.holes())
            writeContour(json, hole);
        json.endArray();
    }
    json.endObject();
}

void writeParent(JsonWriter &json, const Parent &parent)
{
    json.beginObject(Layout::Line);
    json.key("section");
    writeRef(json, parent.section);
    json.member("slitFrom", parent.slitFrom);
    json.member("slitTo", parent.slitTo);
    if (parent.isFree)
        json.member("free", true);
    if (parent.holdsTo != HoldsTo::Proportion)
        json.member("holdsTo", nameIn(kHoldsToNames, parent.holdsTo));
    json.endObject();
}

void writeSection(JsonWriter &json, const Section &section, std::size_t shapeIndex)
{
    json.beginObject();
    json.member("id", section.id.value);
    json.member("name", section.name);
    json.member("stock", section.stock.value);
    json.member("shape", shapeIndex);
    if (section.isLocked)
        json.member("locked", true);
    if (section.parent) {
        json.key("parent");
        writeParent(json, *section.parent);
    }
    writeFrame(json, section.frame);
    if (section.symmetry) {
        json.key("symmetry");
        json.beginObject(Layout::Line);
        json.member("point", section.symmetry->point);
        json.member("direction", section.symmetry->direction);
        json.endObject();
    }
    writeFigures(json, section);
    writeMarks(json, section);
    json.endObject();
}

void writeJoint(JsonWriter &json, const JointOverride &joint)
{
    json.beginObject();
    json.key("a");
    writeRef(json, joint.a);
    json.key("b");
    writeRef(json, joint.b);
    if (joint.kind) // an extended cross lap is one that geometry extends: the format has no other
        json.member("kind", nameOf(*joint.kind == JointKind::ExtendedCrossLap ? JointKind::CrossLap
                                                                              : *joint.kind));
    if (joint.opens)
        json.member("opens", *joint.opens);
    if (!joint.shares.empty()) {
        json.key("shares");
        json.beginArray();
        for (const JointOverride::Share &share : joint.shares) {
            json.beginObject(Layout::Line);
            json.member("at", share.at);
            json.member("ofA", share.ofA);
            json.endObject();
        }
        json.endArray();
    }
    json.endObject();
}

/// Shapes by order of first use, and where each stands.
struct ShapeTable
{
    std::vector<const Shape *> shapes;
    std::unordered_map<const Shape *, std::size_t> indices;

    explicit ShapeTable(const Document &document)
    {
        for (const SectionPointer &section : document.sections) {
            if (indices.emplace(section->shape.get(), shapes.size()).second)
                shapes.push_back(section->shape.get());
        }
    }
};

} // namespace

Result<std::string> writeFff(const Document &document)
{
    const ShapeTable table(document);

    JsonWriter json;
    json.beginObject();
    json.member("format", "FlatFitFab");
    json.member("version", kFffVersion);
    json.member("nextId", document.nextId);
    json.member("currentStock", document.currentStock.value);
    if (document.opensForAdjusting)
        json.member("opensForAdjusting", true);
    json.key("stocks");
    json.beginArray();
    for (const auto &stock : document.stocks)
        writeStock(json, *stock, writeShape);
    json.endArray();
    json.key("shapes");
    json.beginArray();
    for (const Shape *shape : table.shapes)
        writeShape(json, *shape);
    json.endArray();
    json.key("sections");
    json.beginArray();
    for (const SectionPointer &section : document.sections)
        writeSection(json, *section, table.indices.at(section->shape.get()));
    json.endArray();
    json.key("operations");
    json.beginArray();
    for (const OperationPointer &operation : document.operations)
        writeOperation(json, *operation);
    json.endArray();
    writeLoads(json, document);
    json.key("joints");
    json.beginArray();
    for (const JointOverridePointer &joint : document.jointOverrides)
        writeJoint(json, *joint);
    json.endArray();
    writeDimensions(json, document);
    writePins(json, document);
    writeTurnings(json, document);
    writeNumbers(json, document);
    writeValues(json, document);
    writeBindings(json, document);
    writeTemplates(json, document);
    writeBlobs(json, document);
    json.endObject();
    // A file with a null for a number could not be read again.
    if (json.sawNonFinite())
        return failure(ErrorCode::NonFinite);
    return json.take();
}

} // namespace fff::io
