#include "core/session/session_commands.h"

#include "core/interaction/load_editing.h"
#include "core/interaction/section_editing.h"
#include "core/session/bearing_commands.h"
#include "core/session/command_rules.h"
#include "core/session/copy_commands.h"
#include "core/session/drawing_commands.h"
#include "core/session/figure_commands.h"
#include "core/session/flat_template_commands.h"
#include "core/session/joint_commands.h"
#include "core/session/load_commands.h"
#include "core/session/magnet_commands.h"
#include "core/session/mark_commands.h"
#include "core/session/measure_commands.h"
#include "core/session/mirror_commands.h"
#include "core/session/offer_commands.h"
#include "core/session/operation_commands.h"
#include "core/session/point_commands.h"
#include "core/session/section_commands.h"
#include "core/session/selection_commands.h"
#include "core/session/sheet_commands.h"
#include "core/session/skin_commands.h"
#include "core/session/template_commands.h"
#include "core/session/tool_commands.h"
#include "core/session/value_commands.h"
#include "core/session/view_commands.h"

namespace fff {

namespace {

constexpr CommandWords kSessionWords[] = {
    {"file.new", FFF_TEXT("Command", "&New"), FFF_TEXT("Command", "New"), "Ctrl+N", "new",
     FFF_TEXT("Command", "Start a new model")},
    {"edit.undo", FFF_TEXT("Command", "&Undo"), FFF_TEXT("Command", "Undo"), "Ctrl+Z", "undo",
     FFF_TEXT("Command", "Undo the last step")},
    {"edit.redo", FFF_TEXT("Command", "&Redo"), FFF_TEXT("Command", "Redo"), "Ctrl+Shift+Z Ctrl+Y",
     "redo", FFF_TEXT("Command", "Redo the step that was undone")},
    {"edit.delete", FFF_TEXT("Command", "&Delete"), FFF_TEXT("Command", "Delete"), "Del", "trash",
     FFF_TEXT("Command", "Delete the selected sections")},
};

/// Of a pen's path (Interaction::undoInTool).
constexpr Text kSetPoint = FFF_TEXT("Command", "Set a point");

Argument stepNamed(const QString &step)
{
    return Named{step.toStdString()};
}

void registerEdits(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registry.add("file.new", {[&](const CommandParameters &, double time) -> Result<void> {
                     session.reset(newDocument());
                     interaction.select({});
                     interaction.fitAll(Camera(), time, 0.0);
                     interaction.forgetViews();
                     return {};
                 }});
    // Points of an open path first: what a person set last goes first.
    registry.add("edit.undo",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      if (!interaction.undoInTool(time))
                          session.history()->undo();
                      return {};
                  },
                  needs([&] { return interaction.canUndoInTool() || session.history()->canUndo(); },
                        FFF_TEXT("Command", "Nothing to undo")),
                  {},
                  [&] {
                      //: %1 is a step of the history
                      return Message{FFF_TEXT("Command", "&Undo \u201c%1\u201d"),
                                     {interaction.canUndoInTool()
                                          ? Argument(kSetPoint)
                                          : stepNamed(session.history()->undoText())}};
                  }});
    registry.add("edit.redo",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      if (!interaction.redoInTool(time))
                          session.history()->redo();
                      return {};
                  },
                  needs([&] { return interaction.canRedoInTool() || session.history()->canRedo(); },
                        FFF_TEXT("Command", "Nothing to redo")),
                  {},
                  [&] {
                      //: %1 is a step of the history
                      return Message{FFF_TEXT("Command", "&Redo \u201c%1\u201d"),
                                     {interaction.canRedoInTool()
                                          ? Argument(kSetPoint)
                                          : stepNamed(session.history()->redoText())}};
                  }});
    registry.add("edit.delete",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      if (interaction.selectedJoint()) {
                          interaction.say(Hint::refusal(hints::kJointNotDeleted), time);
                          return {};
                      }
                      if (interaction.selectedOperation().isValid())
                          return registry.run("operation.delete", {}, time);
                      if (interaction.selectedLoad().isValid()) {
                          interaction.carryOut(
                              removedLoad(session.committed(), interaction.selectedLoad()), time);
                          return {};
                      }
                      if (!interaction.points().isEmpty())
                          return registry.run("point.delete", {}, time);
                      interaction.carryOut(deleted(session.committed(), interaction.selection()),
                                           time);
                      return {};
                  },
                  needs(
                      [&] {
                          return !interaction.selection().empty() || interaction.selectedJoint() ||
                                 interaction.selectedOperation().isValid() ||
                                 interaction.selectedLoad().isValid();
                      },
                      kNothingSelected)});
    registry.offer(kSessionWords);
}

} // namespace

void registerSessionCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registerEdits(registry, session, interaction);
    registerViewCommands(registry, session, interaction);
    registerLoadCommands(registry, session, interaction);
    registerSheetCommands(registry, session, interaction);
    registerBearingCommands(registry, session, interaction);
    registerSkinCommands(registry, session);
    registerTemplateCommands(registry, session, interaction);
    registerFlatTemplateCommands(registry, session, interaction);
    registerSelectionCommands(registry, session, interaction);
    registerToolCommands(registry, session, interaction);
    registerSectionCommands(registry, session, interaction);
    registerFigureCommands(registry, session, interaction);
    registerOfferCommands(registry, interaction);
    registerMagnetCommands(registry, session, interaction);
    registerMarkCommands(registry, session, interaction);
    registerDrawingCommands(registry, session, interaction);
    registerMeasureCommands(registry, session, interaction);
    registerValueCommands(registry, session, interaction);
    registerCopyCommands(registry, session, interaction, memoryClipboard());
    registerMirrorCommands(registry, session, interaction);
    registerPointCommands(registry, session, interaction);
    registerJointCommands(registry, session, interaction);
    registerOperationCommands(registry, session, interaction);
}

} // namespace fff
