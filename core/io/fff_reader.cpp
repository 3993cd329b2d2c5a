#include "core/base/tolerances.h"
#include "core/io/fff_annotations.h"
#include "core/io/fff_blobs.h"
#include "core/io/fff_format.h"
#include "core/io/fff_loads.h"
#include "core/io/fff_migration.h"
#include "core/io/fff_operations.h"
#include "core/io/fff_sheets.h"
#include "core/io/fff_stocks.h"
#include "core/io/fff_templates.h"
#include "core/io/fff_values.h"
#include "core/io/json_cursor.h"
#include "core/io/json_syntax.h"
#include "core/model/holds_to_names.h"
#include "core/model/joint_kind_names.h"
#include "core/model/mended_shape.h"
#include "core/model/value_names.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace fff::io {

namespace {

/// Whole numbers up to here are exact in every reader of JSON.
constexpr std::int64_t kMaxId = std::int64_t(1) << 53;

class FffReader
{
public:
    FffReader(Problems &problems, const BlobSource &blobs) : m_problems(problems), m_blobs(blobs) {}

    Document read(const JsonCursor &root);

private:
    std::int64_t readId(const JsonCursor &cursor);
    template <class Known>
    std::int64_t readReference(const JsonCursor &cursor, const Known &known);
    SectionRef readRef(const JsonCursor &cursor);
    Contour readContour(const JsonCursor &cursor);
    ShapePointer readShape(const JsonCursor &cursor);
    Frame readFrame(const JsonCursor &cursor, const std::string &ofWhat);
    std::optional<Parent> readParent(const JsonCursor &cursor);
    std::optional<MirrorAxis> readSymmetry(const JsonCursor &cursor);
    SectionPointer readSection(const JsonCursor &cursor, const std::vector<ShapePointer> &shapes);
    JointOverride readJoint(const JsonCursor &cursor);
    void readJoints(const JsonCursor &cursor, std::vector<JointOverridePointer> &joints);
    std::int64_t readGivenId(const JsonCursor &cursor);
    OperationPointer readOperation(const JsonCursor &cursor);
    void checkAncestry(const std::vector<JsonCursor> &items,
                       const std::vector<SectionPointer> &sections);

    Problems &m_problems;
    const BlobSource &m_blobs;
    std::int64_t m_nextId = 1;
    std::unordered_set<std::int64_t> m_ids; // of everything: all come from one counter
    std::unordered_set<std::int64_t> m_stockIds, m_sectionIds;
};

std::int64_t FffReader::readId(const JsonCursor &cursor)
{
    const std::int64_t id = cursor.integer(1, kMaxId);
    if (id >= m_nextId)
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "an id below nextId"));
    else if (!m_ids.insert(id).second)
        cursor.fail(ErrorCode::DuplicateId, {std::to_string(id)});
    return id;
}

template <class Known>
std::int64_t FffReader::readReference(const JsonCursor &cursor, const Known &known)
{
    const std::int64_t id = cursor.integer(1, kMaxId);
    if (!known.contains(id))
        cursor.fail(ErrorCode::UnknownReference, {std::to_string(id)});
    return id;
}

/// Of what is, or was, in the document.
std::int64_t FffReader::readGivenId(const JsonCursor &cursor)
{
    const std::int64_t id = cursor.integer(1, kMaxId);
    if (id >= m_nextId)
        cursor.fail(ErrorCode::UnknownReference, {std::to_string(id)});
    return id;
}

SectionRef FffReader::readRef(const JsonCursor &cursor)
{
    if (!cursor.isObject())
        return SectionId{readReference(cursor, m_sectionIds)};
    // An operation that is gone leaves its references dormant; ids are never given twice.
    const std::int64_t id = readGivenId(cursor.member("operation"));
    return {OperationId{id}, cursor.member("instance").text()};
}

Contour FffReader::readContour(const JsonCursor &cursor)
{
    std::vector<Vec2> points = cursor.points();
    if (m_problems.failed())
        return {};
    const std::size_t count = points.size();
    Result<Contour> contour = Contour::fromPoints(std::move(points));
    if (contour)
        return *std::move(contour);
    cursor.fail(contour.error().code,
                {std::to_string(count),
                 QT_TRANSLATE_NOOP("Error", "three control points per segment, at least 6")});
    return {};
}

ShapePointer FffReader::readShape(const JsonCursor &cursor)
{
    const auto placed = [this](const JsonCursor &item) {
        return PlacedContour{readContour(item), item.path()};
    };
    const PlacedContour contour = placed(cursor.member("contour"));
    std::vector<PlacedContour> holes;
    if (const JsonCursor list = cursor.member("holes"); list.exists()) {
        for (const JsonCursor &item : list.items())
            holes.push_back(placed(item));
    }
    if (m_problems.failed())
        return nullptr;
    // Sections may share it: it has no name of its own.
    std::vector<Warning> mended;
    Result<ShapePointer> shape = makeMendedShape(contour, holes, {}, mended);
    m_problems.warn(mended);
    if (shape)
        return *std::move(shape);
    cursor.fail(shape.error().code, shape.error().args);
    return nullptr;
}

Frame FffReader::readFrame(const JsonCursor &cursor, const std::string &ofWhat)
{
    Frame frame;
    frame.origin = cursor.member("origin").point3();
    frame.x = cursor.member("x").point3();
    frame.y = cursor.member("y").point3();
    if (m_problems.failed())
        return frame;
    const double deviation =
        std::max({std::abs(frame.x.norm() - 1.0), std::abs(frame.y.norm() - 1.0),
                  std::abs(frame.x.dot(frame.y))});
    if (deviation <= kExactFrame)
        return frame;
    const Result<Frame> mended = makeFrame(frame.origin, frame.x, frame.y);
    if (!mended || deviation > kFrameRounding) {
        cursor.fail(ErrorCode::DegenerateFrame);
        return frame;
    }
    m_problems.warn(WarningCode::SkewFrame, cursor.path(), {ofWhat, shortNumber(deviation)});
    return *mended;
}

std::optional<Parent> FffReader::readParent(const JsonCursor &cursor)
{
    if (!cursor.exists() || cursor.isNull())
        return std::nullopt;
    Parent parent;
    parent.section = readRef(cursor.member("section"));
    parent.slitFrom = cursor.member("slitFrom").point2();
    parent.slitTo = cursor.member("slitTo").point2();
    if (const JsonCursor free = cursor.member("free"); free.exists())
        parent.isFree = free.truth();
    if (const JsonCursor holdsTo = cursor.member("holdsTo"); holdsTo.exists()) {
        if (const auto known = namedIn(kHoldsToNames, holdsTo.text()))
            parent.holdsTo = *known;
        else
            holdsTo.failExpected(
                QT_TRANSLATE_NOOP("Error", "proportion, left, right, bottom or top"));
    }
    return parent;
}

std::optional<MirrorAxis> FffReader::readSymmetry(const JsonCursor &cursor)
{
    if (!cursor.exists())
        return std::nullopt;
    const JsonCursor direction = cursor.member("direction");
    MirrorAxis axis{cursor.member("point").point2(), direction.point2()};
    if (!m_problems.failed() && std::abs(axis.direction.norm() - 1.0) > kExactFrame)
        direction.failExpected(QT_TRANSLATE_NOOP("Error", "a direction of length 1"));
    return axis;
}

SectionPointer FffReader::readSection(const JsonCursor &cursor,
                                      const std::vector<ShapePointer> &shapes)
{
    auto section = std::make_shared<Section>();
    section->id = SectionId{cursor.member("id").integer(1, kMaxId)}; // looked at before, by all
    section->name = cursor.member("name").text();
    section->stock = StockId{readReference(cursor.member("stock"), m_stockIds)};
    const JsonCursor shape = cursor.member("shape");
    const auto index = static_cast<std::size_t>(shape.integer(0, kMaxId));
    if (index < shapes.size())
        section->shape = shapes[index];
    else
        shape.fail(ErrorCode::UnknownReference, {std::to_string(index)});
    if (const JsonCursor locked = cursor.member("locked"); locked.exists())
        section->isLocked = locked.truth();
    section->parent = readParent(cursor.member("parent"));
    section->frame = readFrame(cursor.member("frame"), section->name);
    section->symmetry = readSymmetry(cursor.member("symmetry"));
    section->figures = readFigures(cursor.member("figures"), section->shape);
    section->marks = readMarks(cursor.member("marks"));
    return section;
}

JointOverride FffReader::readJoint(const JsonCursor &cursor)
{
    JointOverride joint;
    joint.a = readRef(cursor.member("a"));
    joint.b = readRef(cursor.member("b"));
    if (const JsonCursor kind = cursor.member("kind"); kind.exists()) {
        joint.kind = jointKindNamed(kind.text());
        if (!joint.kind ||
            joint.kind == JointKind::ExtendedCrossLap) // which is for geometry to say
            kind.failExpected(QT_TRANSLATE_NOOP("Error", "crossLap, mortise, tabs or none"));
    }
    if (const JsonCursor opens = cursor.member("opens"); opens.exists()) {
        joint.opens = opens.point2();
        if (std::abs(joint.opens->norm() - 1.0) > kExactFrame)
            opens.failExpected(QT_TRANSLATE_NOOP("Error", "a direction of length 1"));
    }
    if (const JsonCursor shares = cursor.member("shares"); shares.exists()) {
        for (const JsonCursor &item : shares.items()) {
            const JsonCursor ofA = item.member("ofA");
            joint.shares.push_back({item.member("at").point2(), ofA.number()});
            const double share = joint.shares.back().ofA;
            if (!(share >= kLeastShare && share <= 1.0 - kLeastShare))
                ofA.failExpected(QT_TRANSLATE_NOOP("Error", "a share from 0.05 to 0.95"));
        }
    }
    return joint;
}

/// In their order, each pair once.
void FffReader::readJoints(const JsonCursor &cursor, std::vector<JointOverridePointer> &joints)
{
    if (!cursor.exists())
        return;
    for (const JsonCursor &item : cursor.items()) {
        JointOverride joint = readJoint(item);
        if (m_problems.failed())
            return;
        const bool isInOrder =
            joint.a < joint.b && (joints.empty() || std::tie(joints.back()->a, joints.back()->b) <
                                                        std::tie(joint.a, joint.b));
        if (!isInOrder || joint.isEmpty())
            item.failExpected(
                QT_TRANSLATE_NOOP("Error", "something wanted of two sections, pairs ascending"));
        joints.push_back(std::make_shared<const JointOverride>(std::move(joint)));
    }
}

OperationPointer FffReader::readOperation(const JsonCursor &cursor)
{
    OperationSurroundings surroundings;
    // A section that is gone is still known by its id: the operation says what it misses.
    surroundings.readRef = [this](const JsonCursor &item) {
        return item.isObject() ? readRef(item) : SectionRef(SectionId{readGivenId(item)});
    };
    surroundings.readStock = [this](const JsonCursor &item) {
        return StockId{readReference(item, m_stockIds)};
    };
    surroundings.readGivenId = [this](const JsonCursor &item) { return readGivenId(item); };
    const OperationId id{readId(cursor.member("id"))};
    auto operation = std::make_shared<Operation>(fff::io::readOperation(cursor, surroundings));
    operation->id = id;
    return operation;
}

/// No section is its own ancestor. Each chain of parents is walked until known ground: O(n).
void FffReader::checkAncestry(const std::vector<JsonCursor> &items,
                              const std::vector<SectionPointer> &sections)
{
    std::unordered_map<std::int64_t, const Section *> byId;
    for (const SectionPointer &section : sections)
        byId.emplace(section->id.value, section.get());
    std::unordered_map<std::int64_t, std::size_t> visitedFrom;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section *section = sections[i].get();
        while (section) {
            const auto [visit, isNew] = visitedFrom.emplace(section->id.value, i);
            if (!isNew && visit->second == i)
                items[i].member("parent").failExpected(
                    QT_TRANSLATE_NOOP("Error", "a parent that does not descend from its child"));
            if (!isNew || !section->parent)
                break;
            const auto parent = byId.find(section->parent->section.drawn.value);
            section = parent == byId.end() ? nullptr : parent->second;
        }
    }
}

Document FffReader::read(const JsonCursor &root)
{
    Document document;
    document.nextId = m_nextId = root.member("nextId").integer(1, kMaxId);
    const JsonCursor stocks = root.member("stocks");
    const StockReaders stockReaders{
        .readId = [this](const JsonCursor &item) { return readId(item); },
        .readShape = [this](const JsonCursor &item) { return readShape(item); }};
    for (const JsonCursor &item : stocks.items()) {
        document.stocks.push_back(std::make_shared<const Stock>(readStock(item, stockReaders)));
        m_stockIds.insert(document.stocks.back()->id.value);
        if (m_problems.failed())
            return {};
    }
    // Whatever is drawn is of the current one.
    if (document.stocks.empty())
        stocks.failExpected(QT_TRANSLATE_NOOP("Error", "at least one stock"));
    document.currentStock = StockId{readReference(root.member("currentStock"), m_stockIds)};
    if (const JsonCursor adjusting = root.member("opensForAdjusting"); adjusting.exists())
        document.opensForAdjusting = adjusting.truth();
    std::vector<ShapePointer> shapes;
    for (const JsonCursor &item : root.member("shapes").items()) {
        shapes.push_back(readShape(item));
        if (m_problems.failed())
            return {};
    }
    // All ids first: a parent may stand below its child.
    const std::vector<JsonCursor> sections = root.member("sections").items();
    for (const JsonCursor &item : sections)
        m_sectionIds.insert(readId(item.member("id")));
    for (const JsonCursor &item : sections) {
        if (m_problems.failed())
            return {};
        document.sections.push_back(readSection(item, shapes));
    }
    if (m_problems.failed())
        return {};
    checkAncestry(sections, document.sections);
    if (const JsonCursor operations = root.member("operations"); operations.exists()) {
        for (const JsonCursor &item : operations.items()) {
            document.operations.push_back(readOperation(item));
            if (m_problems.failed())
                return {};
        }
    }
    const ReferenceReaders readers{
        .readRef = [this](const JsonCursor &item) { return readRef(item); },
        .readId = [this](const JsonCursor &item) { return readId(item); },
        .readFrame = [this](const JsonCursor &item,
                            const std::string &ofWhat) { return readFrame(item, ofWhat); }};
    document.loads = readLoads(root.member("weights"), root.member("pushes"), readers);
    readJoints(root.member("joints"), document.jointOverrides);
    document.dimensions = readDimensions(root.member("dimensions"), readers);
    document.pins = readPins(root.member("pins"), readers);
    document.turnings = readTurnings(root.member("turnings"), readers);
    document.numbers = readNumbers(root.member("numbers"));
    document.values = readValues(root, document.nextId, readers);
    document.templates = readTemplates(root.member("templates"), readers);
    if (!m_problems.failed())
        document.bindings =
            readBindings(root.member("bindings"), document, readers,
                         [this](const JsonCursor &item, const std::string &typed) {
                             m_problems.warn(WarningCode::LostBinding, item.path(), {typed});
                         });
    if (!m_problems.failed())
        document.blobs = readBlobs(root.member("blobs"), m_blobs, m_problems);
    return document;
}

} // namespace

Result<LoadedDocument> readFff(std::string_view bytes, const std::string &name,
                               const BlobSource &blobs)
{
    Problems problems{.file = name};
    const QJsonDocument json = parseJson(bytes, problems);
    if (problems.failed())
        return tl::unexpected(*problems.error);
    if (json.object().value(QLatin1String("format")) != QLatin1String("FlatFitFab"))
        return failure(ErrorCode::NotAModel, name);

    const JsonCursor versionCursor = JsonCursor(json.object(), "$", problems).member("version");
    const std::int64_t version = versionCursor.integer(1, kMaxId);
    if (version > kFffVersion)
        versionCursor.fail(ErrorCode::NewerVersion,
                           {std::to_string(version), std::to_string(kFffVersion)});
    if (problems.failed())
        return tl::unexpected(*problems.error);

    FffReader reader(problems, blobs);
    Document document = reader.read({migrated(json.object(), version), "$", problems});
    if (problems.failed())
        return tl::unexpected(*problems.error);
    return LoadedDocument{std::move(document), std::move(problems.warnings)};
}

} // namespace fff::io
