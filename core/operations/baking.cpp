#include "core/operations/baking.h"

#include "core/geometry/contour_points.h"
#include "core/model/edits.h"
#include "core/model/figures.h"
#include "core/model/operation_edits.h"
#include "core/model/placed_loads.h"
#include "core/model/point_edits.h"
#include "core/model/sheet_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/kept_slits.h"
#include "core/operations/renamed_instances.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fff {

namespace {

SectionRef follow(const Replacements &replacements, const SectionRef &ref)
{
    const auto it = replacements.find(ref);
    return it == replacements.end() ? ref : it->second;
}

/// What was wanted of two sections, of the same two under other names. frame: by section, by its
/// name before.
template <class FrameOf>
JointOverride followed(const JointOverride &joint, const Replacements &replacements,
                       FrameOf frameOf)
{
    JointOverride next = joint;
    next.a = follow(replacements, joint.a);
    next.b = follow(replacements, joint.b);
    if (next.a < next.b)
        return next;
    // The other one is first now, so all is said in its frame.
    const Frame *from = frameOf(joint.a), *to = frameOf(joint.b);
    std::swap(next.a, next.b);
    for (JointOverride::Share &share : next.shares) {
        share.ofA = 1.0 - share.ofA;
        if (from && to)
            share.at = to->toLocal(from->toWorld(share.at));
    }
    // What lies across b's plane is lost; the axis, along which slits open, lies in both.
    if (next.opens && from && to) {
        const Vec2 opens = to->directionToLocal(-from->directionToWorld(*next.opens));
        next.opens = opens.norm() > 0.0 ? std::optional(opens.normalized()) : std::nullopt;
    }
    return next;
}

void followInDocument(Document &document, const Model &model, const Replacements &replacements)
{
    const auto frameOf = [&model](const SectionRef &ref) {
        const Section *section = model.find(ref);
        return section ? &section->frame : nullptr;
    };
    for (SectionPointer &pointer : document.sections) {
        if (!pointer->parent || !replacements.contains(pointer->parent->section))
            continue;
        Section next = *pointer;
        next.parent->section = follow(replacements, next.parent->section);
        pointer = std::make_shared<const Section>(std::move(next));
    }
    for (Load &load : document.loads)
        load.section = follow(replacements, load.section);
    for (Dimension &dimension : document.dimensions)
        for (Anchor *anchor : {&dimension.from, &dimension.to})
            anchor->section = follow(replacements, anchor->section);
    for (TemplatePointer &pointer : document.templates) {
        Template next = *pointer;
        next.on = follow(replacements, next.on);
        for (Magnet &magnet : next.magnets)
            magnet.section = follow(replacements, magnet.section);
        settleMagnets(next);
        if (next != *pointer)
            pointer = std::make_shared<const Template>(std::move(next));
    }
    renameSheetWishes(document, [&](const SectionRef &ref) { return follow(replacements, ref); });
    std::vector<JointOverridePointer> joints;
    joints.swap(document.jointOverrides);
    for (const JointOverridePointer &joint : joints) {
        if (!replacements.contains(joint->a) && !replacements.contains(joint->b))
            document.jointOverrides.push_back(joint);
        else if (JointOverride next = followed(*joint, replacements, frameOf); !next.isEmpty())
            document.jointOverrides.push_back(
                std::make_shared<const JointOverride>(std::move(next)));
    }
    std::sort(document.jointOverrides.begin(), document.jointOverrides.end(),
              [](const JointOverridePointer &a, const JointOverridePointer &b) {
                  return std::tie(a->a, a->b) < std::tie(b->a, b->b);
              });
    for (OperationPointer &pointer : document.operations) {
        Operation next = *pointer;
        for (auto &[role, inputs] : next.inputs)
            for (OperationInput &input : inputs)
                input.section = follow(replacements, input.section);
        if (!(next == *pointer))
            pointer = std::make_shared<const Operation>(std::move(next));
    }
}

/// What acts on a copy since it acts on the source is on what is drawn in its place by itself.
void keepCarriedLoads(Document &document, const Document &before, const Section &copy,
                      const SectionRef &drawn)
{
    for (Load own : carriedLoads(before, copy)) {
        own.id = LoadId{document.nextId++};
        own.section = drawn;
        document.loads.push_back(std::move(own));
    }
}

/// Operations below may call what they make otherwise: all that is said of that follows, one
/// operation after the other, as each may work on what the one before makes.
Document withRenamed(Document document, const Model &model, Replacements &replacements)
{
    std::vector<OperationId> all;
    for (const OperationPointer &operation : document.operations)
        all.push_back(operation->id);
    Model now = evaluate(document, model);
    for (const OperationId id : all) {
        const Replacements renamed = renamedInstances(model, now, id);
        if (renamed.empty())
            continue;
        followInDocument(document, model, renamed);
        for (OperationPointer &pointer : document.operations) {
            if (pointer->id != id || pointer->exceptions.empty())
                continue;
            Operation next = *pointer;
            next.exceptions.clear();
            for (const auto &[key, exception] : pointer->exceptions)
                next.exceptions.emplace(follow(renamed, SectionRef(id, key)).key, exception);
            pointer = std::make_shared<const Operation>(std::move(next));
        }
        replacements.insert(renamed.begin(), renamed.end());
        now = evaluate(document, now);
    }
    return document;
}

/// Puts the section, as it stands in the model, among the drawn ones; its id is the next one.
SectionRef draw(Document &document, const Section &section)
{
    Section drawn = section;
    drawn.id = SectionId{document.nextId++};
    drawn.made = {};
    drawn.copyOf.reset();
    document.sections.push_back(std::make_shared<const Section>(std::move(drawn)));
    const SectionRef ref = document.sections.back()->ref();
    // Also what it has from the section that it was a copy of.
    if (const auto turning = turningOf(document, section))
        document = *setTurning(std::move(document), ref, turning);
    return ref;
}

/// Of boundaries that are the same, how far apart they may be where one was put together anew, mm.
constexpr double kSameBoundary = 1e-3;

bool runsAlong(const Contour &a, const Contour &b)
{
    const Polygon vertices = a.polygon(kSameBoundary);
    return std::all_of(vertices.begin(), vertices.end(), [&b](const Vec2 &vertex) {
        const auto nearest = nearestPlace(b, vertex);
        return nearest.distance <= 2.0 * kSameBoundary;
    });
}

/// Of however many segments, and wherever it begins.
bool isSameBoundary(const Contour &a, const Contour &b)
{
    return std::abs(a.signedArea() - b.signedArea()) <=
               kSameBoundary * (std::abs(b.signedArea()) + 1.0) &&
           runsAlong(a, b) && runsAlong(b, a);
}

/// That of the shape as it was drawn, where it is the same still.
Contour asDrawn(const Contour &now, const Shape &drawn)
{
    for (int i = 0; i < boundaryCount(drawn); ++i)
        if (isSameBoundary(boundary(drawn, i), now))
            return boundary(drawn, i);
    return now;
}

/// What the operation made the same again, a round disc round, stays the drawn boundary, and with
/// it the shape by numbers that it is; other shapes by numbers are gone.
SectionPointer withFiguresOf(const Section &drawn, const SectionPointer &changed)
{
    if (changed->shape == drawn.shape || drawn.figures.empty())
        return changed; // nothing is lost, whichever boundary stays
    std::vector<Contour> holes;
    for (const Contour &hole : changed->shape->holes())
        holes.push_back(asDrawn(hole, *drawn.shape));
    Result<ShapePointer> shape =
        Shape::make(asDrawn(changed->shape->contour(), *drawn.shape), std::move(holes));
    if (!shape)
        return changed;
    Section next = *changed;
    next.shape = *std::move(shape);
    next.figures = drawn.figures;
    std::vector<Figure> figures;
    for (int i = 0; i < boundaryCount(*next.shape); ++i)
        if (const Figure *figure = figureOf(next, i))
            figures.push_back(*figure);
    next.figures = std::move(figures);
    return std::make_shared<const Section>(std::move(next));
}

const SectionPointer *changeOf(const OperationResult *result, const SectionRef &ref)
{
    if (!result)
        return nullptr;
    const auto found = std::find_if(result->changed.begin(), result->changed.end(),
                                    [&ref](const auto &change) { return change.first == ref; });
    return found == result->changed.end() ? nullptr : &found->second;
}

/// What the operation alone makes of a drawn section that others change, too, and go on to. Null:
/// nothing, or no other one does.
SectionPointer changedAlone(const Model &model, OperationId id, const SectionRef &ref)
{
    Document alone = model.document;
    std::erase_if(alone.operations, [&](const OperationPointer &other) {
        return other->id != id && changeOf(model.resultOf(other->id), ref);
    });
    if (alone.operations.size() == model.document.operations.size())
        return nullptr;
    const Model of = evaluate(std::move(alone), model);
    const SectionPointer *change = changeOf(of.resultOf(id), ref);
    return change ? *change : nullptr;
}

bool isSameShape(const Shape &a, const Shape &b)
{
    const auto isInB = [&b](const Contour &hole) {
        return std::any_of(b.holes().begin(), b.holes().end(),
                           [&hole](const Contour &other) { return isSameBoundary(hole, other); });
    };
    return a.holes().size() == b.holes().size() && isSameBoundary(a.contour(), b.contour()) &&
           std::all_of(a.holes().begin(), a.holes().end(), isInB);
}

/// What of a drawn section that others change, too, is drawn.
enum class Draws { OwnChange, AllChanges };

Result<Document> bakedAs(const Model &model, const OperationResult &result, Draws draws)
{
    const OperationId id = result.operation->id;
    Document document = model.document;
    Replacements replacements;
    const auto replace = [&](const SectionRef &ref, const Section &section) {
        const SectionRef drawn = draw(document, section);
        replacements.emplace(ref, drawn);
        keepCarriedLoads(document, model.document, section, drawn);
    };
    std::vector<SectionId> gone;
    // What it changes of others first: it may take the place of a drawn section.
    for (const auto &[ref, section] : result.changed) {
        if (!ref.drawn.isValid()) {
            Result<Document> without =
                setException(std::move(document), ref, {Exception::State::Detached});
            if (!without)
                return without;
            document = *std::move(without);
            if (section)
                replace(ref, *section);
            continue;
        }
        const int index = document.indexOf(ref.drawn);
        if (index < 0)
            continue;
        SectionPointer &drawn = document.sections[static_cast<std::size_t>(index)];
        const SectionPointer own =
            draws == Draws::OwnChange ? changedAlone(model, id, ref) : nullptr;
        if (section)
            drawn = withFiguresOf(*drawn, own ? own : section);
        else
            gone.push_back(ref.drawn);
    }
    for (const SectionPointer &section : result.sections)
        replace(section->made, *section);
    followInDocument(document, model, replacements);
    Result<Document> without = removeOperation(std::move(document), id);
    if (without)
        without = removeSections(*std::move(without), gone);
    if (!without)
        return without;
    Document next = withRenamed(*std::move(without), model, replacements);
    return withSlitsKept(std::move(next), model, replacements);
}

/// Drawn sections that the operation changed look as they did.
bool looksTheSame(const Document &document, const Model &before, const OperationResult &result)
{
    const Model now = evaluate(document, before);
    return std::all_of(result.changed.begin(), result.changed.end(), [&](const auto &change) {
        const Section *was = before.find(change.first), *is = now.find(change.first);
        return !change.first.drawn.isValid() || (!was && !is) ||
               (was && is && isSameShape(*was->shape, *is->shape));
    });
}

} // namespace

Result<Document> baked(const Model &model, OperationId id)
{
    const OperationResult *result = model.resultOf(id);
    if (!result)
        return removeOperation(model.document, id);
    // Those that change the same section go on to: of what is drawn as this one alone changes it,
    // shapes by numbers are left that drive what the others make.
    Result<Document> next = bakedAs(model, *result, Draws::OwnChange);
    if (next && looksTheSame(*next, model, *result))
        return next;
    return bakedAs(model, *result, Draws::AllChanges);
}

Result<Document> detached(const Model &model, const SectionRef &instance)
{
    const Section *section = model.find(instance);
    if (!section || instance.drawn.isValid())
        return failure(ErrorCode::UnknownReference, instance.key, {instance.key});
    Result<Document> next = setException(model.document, instance, {Exception::State::Detached});
    if (!next)
        return next;
    Replacements replacements{{instance, draw(*next, *section)}};
    followInDocument(*next, model, replacements);
    keepCarriedLoads(*next, model.document, *section, replacements.at(instance));
    return withSlitsKept(withRenamed(*std::move(next), model, replacements), model, replacements);
}

} // namespace fff
