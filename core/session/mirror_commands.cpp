#include "core/session/mirror_commands.h"

#include "core/interaction/mirror_tool.h"
#include "core/interaction/section_editing.h"
#include "core/model/edit_words.h"
#include "core/model/operation_edits.h"
#include "core/operations/baking.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "core/operations/operation_words.h"
#include "core/session/command_rules.h"
#include "core/session/operation_commands.h"

#include <memory>

namespace fff {

namespace {

using Plane = MirrorChoice::Plane;
using Outcome = MirrorChoice::Outcome;

constexpr CommandWords kMirrorWords[] = {
    {"edit.mirror", FFF_TEXT("Command", "&Mirror…"), FFF_TEXT("Command", "Mirror"), "Ctrl+Shift+M",
     "mirror",
     FFF_TEXT("Command", "Mirror the selected sections, or one side of the model to the other")},
    {"mirror.x", FFF_TEXT("Command", "Mirror left and right (X)"), FFF_TEXT("Command", "X"), "",
     "mirror", FFF_TEXT("Command", "Mirror across the plane where X is 0")},
    {"mirror.y", FFF_TEXT("Command", "Mirror up and down (Y)"), FFF_TEXT("Command", "Y"), "",
     "mirror", FFF_TEXT("Command", "Mirror across the plane where Y is 0")},
    {"mirror.z", FFF_TEXT("Command", "Mirror front and back (Z)"), FFF_TEXT("Command", "Z"), "",
     "mirror", FFF_TEXT("Command", "Mirror across the plane where Z is 0")},
    {"mirror.section", FFF_TEXT("Command", "Mirror across a section"),
     FFF_TEXT("Command", "Section"), "", "section",
     FFF_TEXT("Command", "Mirror across the plane of the section that is clicked")},
    {"mirror.copy", FFF_TEXT("Command", "Mirror a copy of the selection"),
     FFF_TEXT("Command", "Copy"), "", "mirror_copy",
     FFF_TEXT("Command", "Add a mirror image of the selected sections")},
    {"mirror.always", FFF_TEXT("Command", "Keep both sides the same"),
     FFF_TEXT("Command", "Both sides"), "", "mirror",
     FFF_TEXT("Command", "Mirror everything drawn on one side, now and later")},
    {"mirror.once", FFF_TEXT("Command", "Make symmetric once"), FFF_TEXT("Command", "Once"), "",
     "symmetry", FFF_TEXT("Command", "Copy one side to the other; later edits are not copied")},
    {"mirror.apply", FFF_TEXT("Command", "Mirror as shown"), FFF_TEXT("Command", "Mirror"), "",
     "mirror", FFF_TEXT("Command", "Do what is shown")},
    {"mirror.cancel", FFF_TEXT("Command", "Do not mirror"), FFF_TEXT("Command", "Cancel"), "",
     "close", FFF_TEXT("Command", "Leave everything as it was")},
};

constexpr Text kNoMirrorHeld = FFF_TEXT("Command", "Choose Mirror first");
constexpr Text kNothingToMirror =
    FFF_TEXT("Hint", "Draw a section first: there is nothing to mirror yet.");
constexpr Text kMadeSymmetric = FFF_TEXT("Step", "Make symmetric");
constexpr Text kAlreadySymmetric =
    FFF_TEXT("Hint", "Nothing copied: the model is symmetric already.");

const MirrorTool *heldMirror(const Interaction &interaction)
{
    return dynamic_cast<const MirrorTool *>(interaction.tool());
}

Operation mirrorOperation(const Model &model, const MirrorChoice &choice)
{
    const char *const planes[] = {"x", "y", "z", "section"};
    Operation mirror = newOperation(*operationKind("mirror"));
    mirror.parameters.insert_or_assign("plane",
                                       std::string(planes[static_cast<int>(choice.plane)]));
    if (choice.across)
        mirror.inputs["across"] = {{*choice.across, model.nameOf(*choice.across)}};
    mirror.name = freeOperationName(model.document, mirror);
    return mirror;
}

SectionEdit mirroredAlways(const Model &model, Operation mirror)
{
    Step step{steps::kAddOperation, {Named{mirror.name}}};
    return EditedSections{addOperation(model.document, std::move(mirror)), std::move(step)};
}

/// selected: what is copied.
SectionEdit mirroredAs(const Model &model, const MirrorChoice &choice,
                       const std::vector<SectionRef> &selected)
{
    if (choice.outcome == Outcome::Copy) {
        const Frame plane = mirrorPlane(model, choice);
        return mirroredCopy(model, selected, plane.origin, plane.normal());
    }
    Operation mirror = mirrorOperation(model, choice);
    return choice.outcome == Outcome::Always ? mirroredAlways(model, std::move(mirror))
                                             : madeSymmetric(model, std::move(mirror));
}

void pickUpMirror(Interaction &interaction, const MirrorChoice &choice, bool isChange, double time)
{
    const std::vector<SectionRef> selected = interaction.sectionsInFocus();
    interaction.pickUp(std::make_unique<MirrorTool>(
                           choice,
                           [selected](const Model &model, const MirrorChoice &made) {
                               return mirroredAs(model, made, selected);
                           },
                           isChange),
                       time);
}

/// A button of the bar: the choice in the hand with something else in it.
void addChoice(CommandRegistry &registry, Interaction &interaction, const char *id,
               MirrorChoice (*changed)(MirrorChoice), CommandRule rule)
{
    registry.add(id, {[&interaction, changed](const CommandParameters &, double time) {
                          pickUpMirror(interaction, changed(heldMirror(interaction)->choice()),
                                       true, time);
                          return Result<void>();
                      },
                      [&interaction, rule = std::move(rule)](const CommandParameters &parameters) {
                          if (!heldMirror(interaction))
                              return WhyNot(kNoMirrorHeld);
                          return rule ? rule(parameters) : WhyNot();
                      },
                      [&interaction, changed]() -> std::optional<bool> {
                          const MirrorTool *tool = heldMirror(interaction);
                          if (!tool)
                              return std::nullopt;
                          const MirrorChoice now = tool->choice(), then = changed(now);
                          return then.plane == now.plane && then.outcome == now.outcome;
                      }});
}

template <Plane plane>
MirrorChoice withPlane(MirrorChoice choice)
{
    choice.plane = plane;
    choice.across.reset();
    return choice;
}

template <Outcome outcome>
MirrorChoice withOutcome(MirrorChoice choice)
{
    choice.outcome = outcome;
    return choice;
}

} // namespace

SectionEdit madeSymmetric(const Model &model, Operation mirror)
{
    const OperationId id{model.document.nextId};
    const Model with = evaluate(addOperation(model.document, std::move(mirror)), model);
    const OperationResult *result = with.resultOf(id);
    if (!result || (result->sections.empty() && result->changed.empty()))
        return tl::unexpected(Hint::refusal(kAlreadySymmetric));
    Result<Document> drawn = baked(with, id);
    if (!drawn)
        return tl::unexpected(Hint::refusal(hints::kEditFailed));
    return EditedSections{*std::move(drawn), {kMadeSymmetric}};
}

void registerMirrorCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registry.add("edit.mirror",
                 {[&session, &interaction](const CommandParameters &, double time) -> Result<void> {
                      if (session.committed().sectionCount() == 0) {
                          interaction.carryOut(
                              SectionEdit(tl::unexpected(Hint::refusal(kNothingToMirror))), time);
                          return {};
                      }
                      const bool hasSelection = !interaction.sectionsInFocus().empty();
                      pickUpMirror(interaction,
                                   {.outcome = hasSelection ? Outcome::Copy : Outcome::Always},
                                   false, time);
                      return {};
                  },
                  {},
                  inHand(interaction, "edit.mirror")});
    addChoice(registry, interaction, "mirror.x", withPlane<Plane::X>, {});
    addChoice(registry, interaction, "mirror.y", withPlane<Plane::Y>, {});
    addChoice(registry, interaction, "mirror.z", withPlane<Plane::Z>, {});
    addChoice(registry, interaction, "mirror.section", withPlane<Plane::Section>, {});
    addChoice(registry, interaction, "mirror.copy", withOutcome<Outcome::Copy>,
              needsSelection(interaction));
    addChoice(registry, interaction, "mirror.always", withOutcome<Outcome::Always>, {});
    addChoice(registry, interaction, "mirror.once", withOutcome<Outcome::Once>, {});
    const CommandRule isHeld =
        needs([&interaction] { return heldMirror(interaction) != nullptr; }, kNoMirrorHeld);
    registry.add("mirror.apply", {[&interaction](const CommandParameters &, double time) {
                                      interaction.key(ToolKey::Enter, time);
                                      return Result<void>();
                                  },
                                  needs(
                                      [&interaction] {
                                          return heldMirror(interaction) &&
                                                 interaction.wants(ToolKey::Enter);
                                      },
                                      kNoMirrorHeld)});
    registry.add("mirror.cancel", {[&interaction](const CommandParameters &, double time) {
                                       interaction.layDown(time);
                                       return Result<void>();
                                   },
                                   isHeld});
    registry.offer(kMirrorWords);
}

} // namespace fff
