#include "ui/bench/marked_scene.h"

#include "ui/bench/workbench.h"

#include <algorithm>
#include <set>

namespace fff::ui {

bool hasPath(const Overlay &overlay)
{
    const PenMarks *path = overlay.find<PenMarks>();
    return path && !path->points.empty();
}

void markScene(Scene &scene, const Workbench &bench)
{
    const Interaction &interaction = bench.interaction();
    const Model &model = bench.shownModel();
    if (model.sectionCount() != scene.sections.size())
        return; // rebuilt at once after this
    const std::set<SectionRef> selected(interaction.selection().begin(),
                                        interaction.selection().end());
    const auto &outlined = bench.outlined();
    const OperationId inFocus = interaction.operationInFocus();
    const int hovered = interaction.hovered().section;
    OperationId hoveredOperation;
    if (hovered >= 0 && static_cast<std::size_t>(hovered) < model.sectionCount())
        hoveredOperation = model.ref(static_cast<std::size_t>(hovered)).operation;
    applyView(scene, model, interaction.view());
    const bool isBusy = interaction.isHandBusy();
    const bool isDrawing =
        interaction.overlay().find<sign::Stroke>() || hasPath(interaction.overlay());
    // All stand back for the section that is being drawn: the one that is not as it was.
    const Model &committed = bench.session().committed();
    // What the operation made or changed; one that is not committed yet is about to be.
    std::set<SectionRef> made;
    for (const OperationResultPointer &result : model.evaluation.results) {
        const OperationId id = result->operation->id;
        if (id != inFocus && committed.document.find(id))
            continue;
        for (const SectionPointer &section : result->sections)
            made.insert(section->ref());
        for (const auto &[ref, section] : result->changed)
            if (section)
                made.insert(ref);
    }
    // Of what is only tried, what differs is what it is looked at for.
    const bool isTried = bench.tried() != nullptr;
    const auto isAsItWas = [&](std::size_t i) {
        return i < committed.sectionCount() && committed.section(i) == model.section(i);
    };
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        SceneSection &section = scene.sections[i];
        const SectionRef ref = model.ref(i);
        section.isHovered = hovered == static_cast<int>(i) ||
                            std::binary_search(outlined.begin(), outlined.end(), ref);
        section.isSelected = !selected.empty() && selected.contains(ref);
        section.isSibling = hoveredOperation.isValid() && ref.operation == hoveredOperation;
        section.isMade = !made.empty() && made.contains(ref);
        section.isGhost = isDrawing ? isAsItWas(i) : section.isGhost;
        if (isBusy) // what the hand has is all that is looked at
            section.isProblem = section.isFaulty = false;
        if (isTried) {
            section.isHovered = bench.differsInTrial(ref);
            section.isGhost = bench.tellsDifferences() && !section.isHovered;
            section.isProblem = section.isFaulty = false; // those are of what is there
        }
    }
}

QString nameUnderCursor(const Workbench &bench)
{
    const Interaction &interaction = bench.interaction();
    const Model &model = bench.session().model();
    const int hovered = interaction.hovered().section;
    if (hovered < 0 || static_cast<std::size_t>(hovered) >= model.sectionCount())
        return {};
    const auto index = static_cast<std::size_t>(hovered);
    if (interaction.selection() == std::vector{model.ref(index)})
        return {};
    return QString::fromStdString(model.section(index)->name);
}

} // namespace fff::ui
