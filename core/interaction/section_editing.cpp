#include "core/interaction/section_editing.h"

#include "core/assembly/crossing.h"
#include "core/interaction/point_editing.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/model/origin.h"
#include "core/operations/evaluate.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"
#include "core/operations/moving_model.h"
#include "core/operations/operation_words.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace fff {

namespace {

//: %1 is the name of a section
constexpr CountedText kMoveSection{FFF_TEXT("Step", "Move %1"),
                                   FFF_TEXT_OF_MANY("Step", "Move %n sections")};
//: %1 is the name of a section
constexpr CountedText kTurnSection{FFF_TEXT("Step", "Turn %1"),
                                   FFF_TEXT_OF_MANY("Step", "Turn %n sections")};
//: %1 is the name of a section
constexpr CountedText kScaleSection{FFF_TEXT("Step", "Scale %1"),
                                    FFF_TEXT_OF_MANY("Step", "Scale %n sections")};
//: %1 is the name of a section
constexpr CountedText kCopySections{FFF_TEXT("Step", "Copy %1"),
                                    FFF_TEXT_OF_MANY("Step", "Copy %n sections")};
//: %1 is the name of a section
constexpr CountedText kMirrorSections{FFF_TEXT("Step", "Mirror a copy of %1"),
                                      FFF_TEXT_OF_MANY("Step", "Mirror copies of %n sections")};
//: %1 is the name of a section
constexpr CountedText kMakeOrthogonal{FFF_TEXT("Step", "Make %1 orthogonal"),
                                      FFF_TEXT_OF_MANY("Step", "Make %n sections orthogonal")};
//: %1 is the name of a section
constexpr CountedText kAlignSection{FFF_TEXT("Step", "Align %1 to an axis"),
                                    FFF_TEXT_OF_MANY("Step", "Align %n sections to an axis")};
//: %1 is the name of a section
constexpr Text kPutOn = FFF_TEXT("Step", "Put %1 on another section");
//: %1 is the name of a section
constexpr CountedText kFreeSection{FFF_TEXT("Step", "Free %1"),
                                   FFF_TEXT_OF_MANY("Step", "Free %n sections")};
//: %1 is the name of a section
constexpr CountedText kHoldSection{FFF_TEXT("Step", "Attach %1"),
                                   FFF_TEXT_OF_MANY("Step", "Attach %n sections")};
//: %1 is the name of a section: how its place follows when the one that it is on is stretched
constexpr CountedText kHoldTo{FFF_TEXT("Step", "Change how %1 follows"),
                              FFF_TEXT_OF_MANY("Step", "Change how %n sections follow")};
//: %1 is the name of a section
constexpr CountedText kLockSection{FFF_TEXT("Step", "Lock %1"),
                                   FFF_TEXT_OF_MANY("Step", "Lock %n sections")};
//: %1 is the name of a section
constexpr CountedText kUnlockSection{FFF_TEXT("Step", "Unlock %1"),
                                     FFF_TEXT_OF_MANY("Step", "Unlock %n sections")};

/// Two normals that differ by less are the same to whoever typed one (no unit).
constexpr double kSameNormal = 1e-6;

std::vector<std::string> namesOf(const Model &model, const std::vector<SectionRef> &sections)
{
    std::vector<std::string> names;
    for (const SectionRef &ref : sections)
        names.push_back(model.nameOf(ref));
    return names;
}

SectionEdit edited(Result<Document> document, Step step)
{
    if (!document && document.error().code == ErrorCode::EmptyContour)
        return refused(hints::kWouldBeEmpty, {Named{document.error().place}});
    if (!document)
        return refused(hints::kEditFailed);
    return EditedSections{*std::move(document), std::move(step)};
}

/// Each moved in its own way; a refusal ends it.
SectionEdit movedEach(
    const Model &model, const std::vector<SectionRef> &sections, const CountedText &texts,
    bool takesChildren,
    const std::function<tl::expected<RefMove, Hint>(const Section &, const SectionRef &)> &way)
{
    if (std::optional<Hint> why = whyNotEdited(model, sections))
        return tl::unexpected(*std::move(why));
    std::vector<RefMove> moves;
    for (const SectionRef &ref : sections) {
        tl::expected<RefMove, Hint> move = way(*model.find(ref), ref);
        if (!move)
            return tl::unexpected(move.error());
        moves.push_back(*std::move(move));
    }
    return edited(movedSections(model, moves, takesChildren),
                  ofSections(texts, namesOf(model, sections)));
}

/// Each drawn section changed in its place.
SectionEdit changedEach(const Model &model, const std::vector<SectionRef> &sections,
                        const Step &step, const std::function<void(Section &)> &change)
{
    Document document = model.document;
    for (const SectionRef &ref : sections) {
        const std::optional<Origin> origin = originOf(model, ref);
        if (!origin)
            return madeByOperation(model, ref);
        Section next = *origin->section;
        change(next);
        SectionPointer &place =
            document.sections[static_cast<std::size_t>(document.indexOf(next.id))];
        if (!(next == *place))
            place = std::make_shared<const Section>(std::move(next));
    }
    return EditedSections{std::move(document), step};
}

/// As it is along the frame's axes, in the section's own coordinates.
Eigen::Matrix2d stretchMatrix(const Section &section, const Frame &frame, const Vec2 &stretch)
{
    Eigen::Matrix2d axes;
    axes << section.frame.directionToLocal(frame.x), section.frame.directionToLocal(frame.y);
    return axes * stretch.asDiagonal() * axes.inverse();
}

const CountedText &textsOf(const Transform &transform)
{
    if (!transform.way.isZero(0.0))
        return kMoveSection;
    return transform.angle != 0.0 ? kTurnSection : kScaleSection;
}

} // namespace

std::optional<Hint> whyNotEdited(const Model &model, const std::vector<SectionRef> &sections)
{
    for (const SectionRef &ref : sections) {
        const std::optional<Origin> origin = originOf(model, ref);
        if (!origin)
            return madeByOperation(model, ref).value();
        if (origin->section->isLocked)
            return Hint::refusal(hints::kLocked, {Named{origin->section->name}});
    }
    return std::nullopt;
}

tl::expected<const Section *, Hint> drawnSection(const Model &model, const SectionRef &ref)
{
    if (std::optional<Hint> why = whyNotEdited(model, {ref}))
        return tl::unexpected(*std::move(why));
    return originOf(model, ref)->section;
}

SectionEdit transformed(const Model &model, const std::vector<SectionRef> &sections,
                        const Transform &transform, const Frame &frame, bool takesChildren,
                        bool merges)
{
    if (std::optional<Hint> why = whyNotEdited(model, sections))
        return tl::unexpected(*std::move(why));
    if (sections.empty())
        return refused(hints::kEditFailed);
    Step step = ofSections(textsOf(transform), namesOf(model, sections));
    if (merges) {
        step.merges = "sections";
        for (const SectionRef &ref : sections)
            step.merges.append(" ").append(std::to_string(originOf(model, ref)->section->id.value));
    }
    if (transform.stretch != Vec2::Ones()) {
        const Section &section = *model.find(sections.front());
        return edited(stretchedSection(model, sections.front(),
                                       stretchMatrix(section, frame, transform.stretch),
                                       section.frame.toLocal(transform.pivot), takesChildren),
                      std::move(step));
    }
    const Similarity placement = transform.times(1);
    std::vector<RefMove> moves;
    for (const SectionRef &ref : sections)
        moves.push_back({ref, placement});
    return edited(movedSections(model, moves, takesChildren), std::move(step));
}

SectionEdit transformedCopies(const Copies &copies, const Model &model,
                              const std::vector<SectionRef> &sections, Transform transform)
{
    if (transform.stretch.x() == transform.stretch.y())
        transform.factor *= transform.stretch.x();
    SectionEdit edit = edited(placedCopies(copies, [&](int k) { return transform.times(k); }),
                              ofSections(kCopySections, namesOf(model, sections)));
    if (edit)
        edit->select = copies.sections;
    return edit;
}

Vec3 positionOf(const Section &section)
{
    return section.frame.toWorld(section.shape->bounds().center());
}

SectionEdit withPosition(const Model &model, const std::vector<SectionRef> &sections, int axis,
                         double value, bool takesChildren)
{
    return movedEach(model, sections, kMoveSection, takesChildren,
                     [&](const Section &section, const SectionRef &ref) {
                         const double by = value - positionOf(section)[axis];
                         return RefMove{ref, Similarity::moved(by * Vec3::Unit(axis))};
                     });
}

SectionEdit withNormal(const Model &model, const std::vector<SectionRef> &sections, int axis,
                       double value, bool takesChildren)
{
    const double wanted = std::clamp(value, -1.0, 1.0);
    const auto normalFor = [&](const Section &section) {
        Vec3 rest = section.frame.normal();
        rest[axis] = 0.0;
        if (rest.norm() < kSameNormal)
            rest = Vec3::Unit((axis + 1) % 3);
        return Vec3(std::sqrt(1.0 - wanted * wanted) * rest.normalized() +
                    wanted * Vec3::Unit(axis));
    };
    SectionEdit edit = movedEach(
        model, sections, kTurnSection, takesChildren,
        [&](const Section &section, const SectionRef &ref) {
            const Section *host = section.parent ? model.find(section.parent->section) : nullptr;
            return RefMove{
                ref, turnToNormal(section, host ? &host->frame : nullptr, normalFor(section))};
        });
    for (const SectionRef &ref : sections) {
        const Section *section = model.find(ref);
        const Section *after = edit ? edit->document.find(ref.drawn) : nullptr;
        const Section *host = holderOf(model, *section);
        if (after && host && after->frame.normal().cross(normalFor(*section)).norm() > kSameNormal)
            edit->note = Hint(hints::kHeldByParent, {Named{section->name}, Named{host->name}});
    }
    return edit;
}

SectionEdit withAngle(const Model &model, const std::vector<SectionRef> &sections, double angle,
                      bool takesChildren)
{
    return movedEach(
        model, sections, kTurnSection, takesChildren,
        [&](const Section &section, const SectionRef &ref) -> tl::expected<RefMove, Hint> {
            const Section *host = section.parent ? model.find(section.parent->section) : nullptr;
            if (!host)
                return refused(hints::kOnNothing, {Named{section.name}});
            return RefMove{ref, turnToAngle(section, host->frame, angle), true};
        });
}

SectionEdit madeOrthogonal(const Model &model, const std::vector<SectionRef> &sections,
                           bool takesChildren)
{
    SectionEdit edit = withAngle(model, sections, 0.5 * std::numbers::pi, takesChildren);
    if (!edit)
        return edit;
    edit->step = ofSections(kMakeOrthogonal, namesOf(model, sections));
    for (const SectionRef &ref : sections) {
        Result<Document> next =
            setFree(std::move(edit->document), originOf(model, ref)->section->id, false);
        if (!next)
            return refused(hints::kEditFailed);
        edit->document = *std::move(next);
    }
    return edit;
}

SectionEdit alignedToAxis(const Model &model, const std::vector<SectionRef> &sections,
                          bool takesChildren)
{
    SectionEdit edit = movedEach(
        model, sections, kAlignSection, takesChildren,
        [&](const Section &section, const SectionRef &ref) -> tl::expected<RefMove, Hint> {
            const Section *host = holderOf(model, section);
            const Vec3 normal = section.frame.normal();
            std::optional<Vec3> best;
            for (int axis : {0, 1, 2}) {
                const Vec3 to = Vec3::Unit(axis);
                const bool isAllowed =
                    !host || std::abs(std::abs(to.dot(host->frame.normal())) -
                                      std::abs(normal.dot(host->frame.normal()))) < kSameNormal;
                if (isAllowed && (!best || std::abs(normal.dot(to)) > std::abs(normal.dot(*best))))
                    best = to;
            }
            if (!best)
                return refused(hints::kHeldByParent, {Named{section.name}, Named{host->name}});
            const Section *on = section.parent ? model.find(section.parent->section) : nullptr;
            return RefMove{ref, turnToNormal(section, on ? &on->frame : nullptr, *best)};
        });
    return edit;
}

SectionEdit putOn(const Model &model, const SectionRef &image, const SectionRef &parent)
{
    if (std::optional<Hint> why = whyNotEdited(model, {image}))
        return tl::unexpected(*std::move(why));
    std::optional<Parent> link;
    const Section &section = *originOf(model, image)->section;
    const SectionRef ref = section.id;
    if (parent.drawn.isValid() || parent.operation.isValid()) {
        const Section *host = model.find(parent);
        if (!host)
            return refused(hints::kEditFailed);
        // What it carries cannot carry it.
        for (const Section *on = host; on;
             on = on->parent ? model.find(on->parent->section) : nullptr)
            if (on->ref() == ref)
                return refused(hints::kCannotBeOn, {Named{section.name}, Named{host->name}});
        const Crossing crossing =
            findCrossing(*section.shape, section.frame, *host->shape, host->frame);
        if (crossing.overlaps.empty())
            return refused(hints::kDoNotMeet, {Named{section.name}, Named{host->name}});
        const auto longest = std::max_element(
            crossing.overlaps.begin(), crossing.overlaps.end(),
            [](const Overlap &a, const Overlap &b) { return a.to - a.from < b.to - b.from; });
        link = Parent{parent, host->frame.toLocal(crossing.axis.at(longest->from)),
                      host->frame.toLocal(crossing.axis.at(longest->to))};
    }
    return changedEach(model, {ref}, {kPutOn, {Named{model.nameOf(ref)}}},
                       [&](Section &next) { next.parent = link; });
}

SectionEdit freed(const Model &model, const std::vector<SectionRef> &sections, bool isFree)
{
    return changedEach(model, sections,
                       ofSections(isFree ? kFreeSection : kHoldSection, namesOf(model, sections)),
                       [isFree](Section &section) {
                           if (section.parent)
                               section.parent->isFree = isFree;
                       });
}

SectionEdit heldTo(const Model &model, const std::vector<SectionRef> &sections, HoldsTo end)
{
    return changedEach(model, sections, ofSections(kHoldTo, namesOf(model, sections)),
                       [end](Section &section) {
                           if (section.parent)
                               section.parent->holdsTo = end;
                       });
}

SectionEdit locked(const Model &model, const std::vector<SectionRef> &sections, bool isLocked)
{
    return changedEach(
        model, sections,
        ofSections(isLocked ? kLockSection : kUnlockSection, namesOf(model, sections)),
        [isLocked](Section &section) { section.isLocked = isLocked; });
}

SectionEdit deleted(const Model &model, const std::vector<SectionRef> &sections,
                    const CountedText *step)
{
    Result<Document> next = model.document;
    std::vector<std::string> names;
    std::vector<SectionId> ids;
    for (const SectionRef &ref : sections) {
        // One whose place an operation has taken is not shown.
        const std::optional<Origin> origin = originOf(model, ref);
        const Section *drawn = origin ? origin->section : model.document.find(ref.drawn);
        if (drawn && drawn->isLocked)
            return refused(hints::kLocked, {Named{drawn->name}});
        if (drawn && std::find(ids.begin(), ids.end(), drawn->id) == ids.end()) {
            ids.push_back(drawn->id);
            names.push_back(drawn->name);
        } else if (const Section *made = model.find(ref); made && !drawn) {
            names.push_back(made->name);
            if (next)
                next = setExceptionState(*std::move(next), ref, Exception::State::Hidden);
        }
    }
    if (next && !ids.empty())
        next = removeSections(*std::move(next), ids);
    const CountedText &own = ids.empty() ? steps::kHideInstance : steps::kDeleteSections;
    return edited(std::move(next), ofSections(step ? *step : own, names));
}

SectionEdit added(const Model &model, const Document &other, const Vec3 &way, Step step)
{
    Insertion insertion = inserted(model.document, selfContained(evaluate(other)));
    std::vector<SectionMove> moves;
    for (const SectionRef &ref : insertion.sections)
        if (insertion.document.find(ref.drawn))
            moves.push_back({ref.drawn, Similarity::moved(way)});
    SectionEdit edit = edited(movedSections(insertion.document, moves), std::move(step));
    if (edit)
        edit->select = std::move(insertion.sections);
    return edit;
}

Vec3 wayBeside(const Model &model, const Document &other)
{
    const Box3 here = model.bounds(), there = evaluate(other).bounds();
    if (here.isEmpty() || there.isEmpty())
        return Vec3::Zero();
    return Vec3(here.max.x() + kBeside - there.min.x(), 0.0, 0.0);
}

SectionEdit duplicated(const Model &model, const std::vector<SectionRef> &sections, const Vec3 &way)
{
    if (sections.empty())
        return refused(hints::kEditFailed);
    Transform transform;
    transform.way = way;
    return transformedCopies(copied(model, sections), model, sections, transform);
}

SectionEdit mirroredCopy(const Model &model, const std::vector<SectionRef> &sections,
                         const Vec3 &point, const Vec3 &normal)
{
    if (sections.empty())
        return refused(hints::kEditFailed);
    const Copies copies = copied(model, sections);
    const Similarity mirror =
        Similarity::turned(Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose(), point);
    SectionEdit edit = edited(placedCopies(copies, [&](int) { return mirror; }),
                              ofSections(kMirrorSections, namesOf(model, sections)));
    if (edit)
        edit->select = copies.sections;
    return edit;
}

} // namespace fff
