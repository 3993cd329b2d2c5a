#include "core/session/session_commands.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/fabrication/summary.h"
#include "core/interaction/facing.h"
#include "core/interaction/section_editing.h"
#include "core/session/copy_commands.h"
#include "core/session/drawing_commands.h"
#include "core/session/figure_commands.h"
#include "core/session/joint_commands.h"
#include "core/session/mark_commands.h"
#include "core/session/measure_commands.h"
#include "core/session/operation_commands.h"
#include "core/session/point_commands.h"
#include "core/session/section_commands.h"
#include "core/session/selection_commands.h"
#include "core/session/tool_commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace fff {

namespace {

/// ms, as the view cube turns and as views are fitted.
constexpr double kTurnTime = 400.0;
constexpr double kFitTime = 250.0;
/// Beside a joint that is shown as large as possible, mm.
constexpr double kLeastBeside = 5.0;

/// Round the slits of a joint, with what is beside them.
Box3 jointBounds(const Model &model, const JointRef &joint)
{
    Box3 box;
    const std::optional<JointState> state = jointState(model, joint);
    if (!state)
        return box;
    const Crossing &crossing = state->crossing;
    for (const Overlap &overlap : crossing.overlaps)
        for (const double at : {overlap.from, overlap.to})
            box.extend(crossing.axis.at(at));
    const double beside = 0.5 * box.size().norm() + kLeastBeside;
    for (const Vec3 &corner : {Vec3(box.min), Vec3(box.max)})
        for (const double way : {-beside, beside})
            box.extend(Vec3(corner + Vec3::Constant(way)));
    return box;
}

/// Of what is selected and there. Empty when nothing is.
Box3 selectionBounds(const Session &session, const Interaction &interaction)
{
    Box3 box;
    const Model &model = session.committed();
    if (interaction.selectedJoint())
        return jointBounds(model, *interaction.selectedJoint());
    for (const SectionRef &ref : interaction.sectionsInFocus()) {
        const Section &section = *model.find(ref);
        box.extend(slabBounds(section, model.document.stockOf(section)));
    }
    return box;
}

/// The corner after the one that is looked from, else the first.
Eigen::Quaterniond nextCorner(const Camera &camera)
{
    const std::array<const char *, 4> names{"iso1", "iso2", "iso3", "iso4"};
    std::array<Eigen::Quaterniond, 4> corners;
    for (std::size_t i = 0; i < names.size(); ++i)
        orientationOfView(names[i], corners[i]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (camera.orientation.angularDistance(corners[i]) < kSameView)
            return corners[(i + 1) % corners.size()];
    }
    return corners[0];
}

void registerEdits(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registry.add("file.new",
                 {[&](const CommandParameters &, double) -> Result<void> {
                      session.reset(newDocument());
                      interaction.select({});
                      interaction.setCamera(fitted(Camera(), Box3(), interaction.viewport()));
                      interaction.forgetViews();
                      return {};
                  },
                  {}});
    // Points of an open path first: what a person set last goes first.
    registry.add("edit.undo",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      if (!interaction.undoInTool(time))
                          session.history()->undo();
                      return {};
                  },
                  [&] { return interaction.canUndoInTool() || session.history()->canUndo(); }});
    registry.add("edit.redo",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      if (!interaction.redoInTool(time))
                          session.history()->redo();
                      return {};
                  },
                  [&] { return interaction.canRedoInTool() || session.history()->canRedo(); }});
    registry.add("edit.delete",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      if (interaction.selectedJoint()) {
                          interaction.say(Hint::refusal(hints::kJointNotDeleted), time);
                          return {};
                      }
                      if (interaction.selectedOperation().isValid())
                          return registry.run("operation.delete", {}, time);
                      if (!interaction.points().isEmpty())
                          return registry.run("point.delete", {}, time);
                      interaction.carryOut(deleted(session.committed(), interaction.selection()),
                                           time);
                      return {};
                  },
                  [&] {
                      return !interaction.selection().empty() || interaction.selectedJoint() ||
                             interaction.selectedOperation().isValid();
                  }});
}

void registerTurns(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    for (const char *name : {"front", "right", "back", "left", "top", "bottom"}) {
        registry.add(std::string("view.") + name,
                     {[&, name](const CommandParameters &, double time) -> Result<void> {
                          Eigen::Quaterniond orientation;
                          orientationOfView(name, orientation);
                          interaction.turnTo(turnedTo(orientation, session, interaction), time,
                                             kTurnTime);
                          return {};
                      },
                      {}});
    }
    registry.add("view.iso",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      const Eigen::Quaterniond corner = nextCorner(interaction.targetCamera());
                      interaction.turnTo(turnedTo(corner, session, interaction), time, kTurnTime);
                      return {};
                  },
                  {}});
    registry.add("view.faceSelection",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      const Model &model = session.committed();
                      const std::vector<SectionRef> sections = interaction.sectionsInFocus();
                      if (sections.empty())
                          return {};
                      const Vec3 normal = model.find(sections.back())->frame.normal().normalized();
                      const Eigen::Quaterniond orientation =
                          facingOrientation(interaction.targetCamera().orientation, normal);
                      interaction.turnTo(turnedTo(orientation, session, interaction), time,
                                         kTurnTime);
                      return {};
                  },
                  [&] { return !interaction.sectionsInFocus().empty(); }});
}

/// Faces the eye, through the target; through the model's middle when that plane would miss it.
ClipPlane cutFacingEye(const Session &session, const Interaction &interaction)
{
    const Camera &camera = interaction.targetCamera();
    const Box3 box = session.committed().bounds();
    ClipPlane plane{camera.target, camera.backward()};
    if (!box.isEmpty()) {
        const double reach = plane.normal.cwiseAbs().dot(0.5 * box.size());
        if (std::abs(plane.height(box.center())) >= reach)
            plane.point = box.center();
    }
    return plane;
}

/// Adds a command that switches something of the view's state on and off.
template <class IsOn, class Set>
void addSwitch(CommandRegistry &registry, const char *id, Interaction &interaction, IsOn isOn,
               Set set, std::function<bool()> isEnabled = {})
{
    registry.add(id, {[&interaction, isOn, set](const CommandParameters &parameters,
                                                double) -> Result<void> {
                          ViewState view = interaction.view();
                          const bool on = switched(parameters, isOn(view));
                          if (on != isOn(view)) {
                              set(view, on);
                              interaction.setView(std::move(view));
                          }
                          return {};
                      },
                      std::move(isEnabled)});
}

void registerLooks(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    addSwitch(
        registry, "view.xray", interaction, [](const ViewState &view) { return view.isXray; },
        [](ViewState &view, bool on) { view.isXray = on; });
    addSwitch(
        registry, "view.shadow", interaction, [](const ViewState &view) { return view.hasGround; },
        [](ViewState &view, bool on) { view.hasGround = on; });
    addSwitch(
        registry, "view.isolate", interaction,
        [](const ViewState &view) { return !view.isolated.empty(); },
        [&interaction](ViewState &view, bool on) {
            view.isolated.clear();
            const std::vector<SectionRef> sections = interaction.sectionsInFocus();
            if (on)
                view.isolated.insert(sections.begin(), sections.end());
        },
        [&interaction] {
            return !interaction.view().isolated.empty() || !interaction.sectionsInFocus().empty();
        });
    addSwitch(
        registry, "view.clip", interaction,
        [](const ViewState &view) { return view.clip.has_value(); },
        [&session, &interaction](ViewState &view, bool on) {
            view.clip.reset();
            if (on)
                view.clip = cutFacingEye(session, interaction);
        },
        [&session, &interaction] {
            return interaction.view().clip || session.committed().sectionCount() > 0;
        });
    registry.add("view.hide", {[&](const CommandParameters &, double) -> Result<void> {
                                   ViewState view = interaction.view();
                                   const std::vector<SectionRef> sections =
                                       interaction.sectionsInFocus();
                                   view.hidden.insert(sections.begin(), sections.end());
                                   interaction.select({}); // what is not seen is not worked on
                                   interaction.setView(std::move(view));
                                   return {};
                               },
                               [&] { return !interaction.sectionsInFocus().empty(); }});
    registry.add("view.showAll", {[&](const CommandParameters &, double) -> Result<void> {
                                      ViewState view = interaction.view();
                                      view.hidden.clear();
                                      view.isolated.clear();
                                      interaction.setView(std::move(view));
                                      return {};
                                  },
                                  [&] {
                                      return !interaction.view().hidden.empty() ||
                                             !interaction.view().isolated.empty();
                                  }});
}

void registerCamera(CommandRegistry &registry, Interaction &interaction)
{
    registry.add(
        "view.perspective",
        {[&](const CommandParameters &parameters, double) -> Result<void> {
             const bool on = switched(parameters, interaction.targetCamera().isPerspective());
             interaction.setProjection(on ? Projection::Perspective : Projection::Orthographic);
             return {};
         },
         {}});
    registry.add("view.previous", {[&](const CommandParameters &, double time) -> Result<void> {
                                       interaction.goBack(time, kTurnTime);
                                       return {};
                                   },
                                   [&] { return interaction.canGoBack(); }});
}

void registerFits(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const auto fitTo = [&interaction](const Box3 &box, double time) {
        interaction.turnTo(fitted(interaction.targetCamera(), box, interaction.viewport()), time,
                           kFitTime);
    };
    registry.add("view.fitAll",
                 {[&session, fitTo](const CommandParameters &, double time) -> Result<void> {
                      fitTo(session.committed().bounds(), time);
                      return {};
                  },
                  {}});
    registry.add(
        "view.fitSelection",
        {[&session, &interaction, fitTo](const CommandParameters &, double time) -> Result<void> {
             fitTo(selectionBounds(session, interaction), time);
             return {};
         },
         [&session, &interaction] { return !selectionBounds(session, interaction).isEmpty(); }});
}

} // namespace

void registerSessionCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registerEdits(registry, session, interaction);
    registerTurns(registry, session, interaction);
    registerFits(registry, session, interaction);
    registerCamera(registry, interaction);
    registerLooks(registry, session, interaction);
    registerSelectionCommands(registry, session, interaction);
    registerToolCommands(registry, session, interaction);
    registerSectionCommands(registry, session, interaction);
    registerFigureCommands(registry, session, interaction);
    registerMarkCommands(registry, session, interaction);
    registerDrawingCommands(registry, session, interaction);
    registerMeasureCommands(registry, session, interaction);
    registerCopyCommands(registry, session, interaction, memoryClipboard());
    registerPointCommands(registry, session, interaction);
    registerJointCommands(registry, session, interaction);
    registerOperationCommands(registry, session, interaction);
}

Camera turnedTo(const Eigen::Quaterniond &orientation, const Session &session,
                const Interaction &interaction)
{
    Box3 box = selectionBounds(session, interaction);
    if (box.isEmpty())
        box = session.committed().bounds();
    const Vec3 pivot = box.isEmpty() ? Vec3(0.0, kFirstPlaneHeight, 0.0) : box.center();
    return turned(interaction.targetCamera(), orientation, pivot, interaction.viewport());
}

} // namespace fff
