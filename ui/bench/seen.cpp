#include "ui/bench/seen.h"

#include "ui/bench/marked_scene.h"
#include "ui/bench/workbench.h"

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

/// Of those that are to be outlined, the ones that are in the model: others change nothing that is
/// seen.
std::vector<SectionRef> presentlyOutlined(const Workbench &bench)
{
    std::vector<SectionRef> present;
    const Model &model = bench.session().model();
    const std::vector<SectionRef> &wanted = bench.outlined();
    for (std::size_t i = 0; !wanted.empty() && i < model.sectionCount(); ++i) {
        const SectionRef ref = model.ref(i);
        if (std::binary_search(wanted.begin(), wanted.end(), ref))
            present.push_back(ref);
    }
    return present;
}

} // namespace

bool Seen::isSamePicture(const Seen &other) const
{
    return camera == other.camera && view == other.view && isGhosted == other.isGhosted &&
           isBusy == other.isBusy && operation == other.operation;
}

int litMark(const Workbench &bench)
{
    const int hovered = bench.interaction().hovered().problem;
    return hovered > 0 ? hovered : bench.litProblem();
}

Signs selectedSigns(const Workbench &bench)
{
    const Interaction &interaction = bench.interaction();
    Signs signs = interaction.overlay().selected;
    const auto *shown = signs.find<OperationMarks>();
    if (!shown || interaction.hasGesture() || !bench.session().hasPreview())
        return signs;
    OperationMarks marks = operationMarks(bench.session().model(), interaction.selectedOperation());
    marks.hovered = shown->hovered;
    signs.put(std::move(marks));
    return signs;
}

Seen seenOn(const Workbench &bench)
{
    const Interaction &interaction = bench.interaction();
    const Overlay &overlay = interaction.overlay();
    Hovered hovered = interaction.hovered();
    hovered.slitStart.reset(); // nothing is seen of that
    return {interaction.camera(),
            interaction.view(),
            interaction.selection(),
            presentlyOutlined(bench),
            bench.ghosts(),
            hovered,
            selectedSigns(bench),
            overlay.held,
            overlay.offered,
            bench.tracedSigns(),
            !overlay.drawn.isEmpty(),
            interaction.operationInFocus(),
            interaction.hasGesture(),
            interaction.isHandBusy(),
            overlay.find<sign::Stroke>() || hasPath(overlay),
            interaction.marks(),
            litMark(bench),
            bench.problemLook()};
}

} // namespace fff::ui
