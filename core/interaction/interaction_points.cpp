#include "core/interaction/interaction_private.h"

namespace fff {

// Control points.

/// Soon after a click at the same place. The window may know before us, scripts do not say it.
bool Interaction::Private::isSecondClick(const PointerEvent &press)
{
    const std::optional<PointerEvent> first = std::exchange(lastClick, std::nullopt);
    return press.button == Button::Left && first &&
           (press.type == PointerEvent::Type::DoubleClick ||
            press.time - first->time <= kDoubleClickTime) &&
           (press.position - first->position).norm() <= settings.dragThreshold;
}

bool Interaction::Private::addPointAt(const PointerEvent &press)
{
    const sign::Points *shown = overlay.find<sign::Points>();
    if (!shown || isOnViewMark(sight(), press.position) || jointMarkAt(press.position))
        return false;
    const SectionRef ref = shown->section;
    const auto target = pointTargetAt(sight(), ref, points, press.position);
    if (!target || target->kind != PointTarget::Kind::Line)
        return false;
    const SectionId id = originOf(host.model(), ref)->section->id;
    carryOut(withInsertedPoint(documentOfPoints(), id, target->point.boundary,
                               {target->point.index, target->t}, rulesOfPoints()));
    return true;
}

/// True when there is something of the contour's there: the click is none on a section.
bool Interaction::Private::clickPoint(const PointerEvent &press)
{
    const sign::Points *shown = overlay.find<sign::Points>();
    if (!shown)
        return false;
    const SectionRef ref = shown->section;
    const auto target = pointTargetAt(sight(), ref, points, press.position);
    if (!target)
        return false;
    const SectionPointer edited = editedSection(host.model(), ref);
    const Section &section = *edited;
    if (target->kind == PointTarget::Kind::Anchor) {
        if (press.modifiers.control)
            points.toggle(section, target->point);
        else
            points.select(section, {target->point});
    }
    return true;
}

/// of: another document than the committed one may be shown, with the same sections.
void Interaction::Private::selectPoints(std::vector<PointAddress> addresses, const Document &of)
{
    const std::vector<SectionRef> &sections = selection.sections();
    const std::optional<Origin> origin =
        sections.size() == 1 ? originOf(host.model(), sections.front()) : std::nullopt;
    const Section *section = origin ? of.find(origin->section->id) : nullptr;
    if (section && !addresses.empty())
        points.select(*section, std::move(addresses));
    else
        points.clear();
}

Document Interaction::Private::documentOfPoints() const
{
    const std::vector<SectionRef> &sections = selection.sections();
    return sections.size() == 1 ? documentToEdit(host.model(), sections.front())
                                : host.model().document;
}

PointRules Interaction::Private::rulesOfPoints() const
{
    PointRules rules{settings.cutsAtGround};
    const std::vector<SectionRef> &sections = selection.sections();
    const std::optional<Origin> origin =
        sections.size() == 1 ? originOf(host.model(), sections.front()) : std::nullopt;
    if (origin && origin->mirror)
        rules.mirror = *origin->mirror;
    return rules;
}

/// One that leaves a symmetric section as it is shown is none.
bool Interaction::Private::isEdited(const EditedPoints &edit) const
{
    const Section *section = edit.document.find(edit.section);
    const Document before = documentOfPoints();
    const Section *was = before.find(edit.section);
    return !section || !was || section->shape != was->shape;
}

void Interaction::Private::carryOut(PointEdit edit)
{
    if (!isTaken(edit))
        return;
    if (isEdited(*edit)) {
        document = edit->document;
        host.commit(edit->step, std::move(edit->document));
    }
    clicks.forget();
    selectPoints(std::move(edit->points), documentOfPoints());
    hover();
}

} // namespace fff
