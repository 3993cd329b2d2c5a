#include "core/session/view_commands.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/fabrication/summary.h"
#include "core/interaction/facing.h"
#include "core/interaction/view_fit.h"
#include "core/session/command_rules.h"

#include <array>
#include <cmath>
#include <functional>

namespace fff {

namespace {

constexpr CommandWords kViewWords[] = {
    {"view.front", FFF_TEXT("Command", "&Front"), FFF_TEXT("Command", "Front"), "1", "view_front",
     FFF_TEXT("Command", "Look from the front"), true},
    {"view.top", FFF_TEXT("Command", "&Top"), FFF_TEXT("Command", "Top"), "2", "view_top",
     FFF_TEXT("Command", "Look from the top"), true},
    {"view.right", FFF_TEXT("Command", "&Right"), FFF_TEXT("Command", "Right"), "3", "view_right",
     FFF_TEXT("Command", "Look from the right"), true},
    {"view.back", FFF_TEXT("Command", "&Back"), FFF_TEXT("Command", "Back"), "4", "view_back",
     FFF_TEXT("Command", "Look from the back"), true},
    {"view.bottom", FFF_TEXT("Command", "Botto&m"), FFF_TEXT("Command", "Bottom"), "5",
     "view_bottom", FFF_TEXT("Command", "Look from below"), true},
    {"view.left", FFF_TEXT("Command", "&Left"), FFF_TEXT("Command", "Left"), "6", "view_left",
     FFF_TEXT("Command", "Look from the left"), true},
    {"view.iso", FFF_TEXT("Command", "Next &corner"), FFF_TEXT("Command", "Corner"), "0",
     "view_iso", FFF_TEXT("Command", "Look from the next corner"), true},
    {"view.faceSelection", FFF_TEXT("Command", "Face the &section"), FFF_TEXT("Command", "Face"),
     "N", "face_section", FFF_TEXT("Command", "Look straight at the selected section"), true},
    {"view.fitAll", FFF_TEXT("Command", "Fit &everything"), FFF_TEXT("Command", "Fit"), "Home",
     "fit", FFF_TEXT("Command", "Show the whole model"), true},
    {"view.fitSelection", FFF_TEXT("Command", "F&it selection"),
     FFF_TEXT("Command", "Fit selection"), "F", "fit_selection",
     FFF_TEXT("Command", "Show the selected sections as large as possible"), true},
    {"view.previous", FFF_TEXT("Command", "&Previous view"), FFF_TEXT("Command", "Previous"),
     "Alt+Left", "view_previous", FFF_TEXT("Command", "Go back to the view before this one")},
    {"view.perspective", FFF_TEXT("Command", "Perspecti&ve"), FFF_TEXT("Command", "Perspective"),
     "V", "perspective",
     FFF_TEXT("Command", "Show what is farther away smaller, as the eye sees it"), true},
    {"view.xray", FFF_TEXT("Command", "&X-ray"), FFF_TEXT("Command", "X-ray"), "X", "xray",
     FFF_TEXT("Command", "See through all sections, down to their slits"), true},
    {"view.isolate", FFF_TEXT("Command", "Onl&y the selection"), FFF_TEXT("Command", "Isolate"),
     "I", "isolate", FFF_TEXT("Command", "Fade all other sections"), true},
    {"view.hide", FFF_TEXT("Command", "&Hide"), FFF_TEXT("Command", "Hide"), "H", "hide",
     FFF_TEXT("Command", "Hide the selected sections"), true},
    {"view.showAll", FFF_TEXT("Command", "Show &all"), FFF_TEXT("Command", "Show all"), "Shift+H",
     "show_all", FFF_TEXT("Command", "Show the hidden sections again"), true},
    {"view.clip", FFF_TEXT("Command", "Cut view &open"), FFF_TEXT("Command", "Cut open"), "C",
     "cut_open", FFF_TEXT("Command", "Cut the model open with a plane, to look inside"), true},
    {"view.shadow", FFF_TEXT("Command", "&Ground and shadow"), FFF_TEXT("Command", "Ground"), "",
     "ground_shadow", FFF_TEXT("Command", "Show the ground with its grid and the model's shadow")},
    {"check.stress", FFF_TEXT("Command", "Stress &lines"), FFF_TEXT("Command", "Stress"), "Shift+S",
     "stress", FFF_TEXT("Command", "Show where the model is strained most"), true},
};

/// ms, as the view cube turns and as views are fitted.
constexpr double kTurnTime = 400.0;
constexpr double kFitTime = 250.0;
/// Beside a joint that is shown as large as possible, mm.
constexpr double kLeastBeside = 5.0;
/// Of the view that a selection may be asked to take.
constexpr double kLeastShare = 0.1;
/// A small thing is looked at from no nearer than so many times as near as all: where in a model
/// it is depends on the model, not on its own size.
constexpr double kMostCloser = 3.0;

/// Round the slits of a joint, with what is beside them.
std::vector<Vec3> pointsRound(const Model &model, const JointRef &joint)
{
    Box3 box;
    const std::optional<JointState> state = jointState(model, joint);
    if (!state)
        return {};
    const Crossing &crossing = state->crossing;
    for (const Overlap &overlap : crossing.overlaps)
        for (const double at : {overlap.from, overlap.to})
            box.extend(crossing.axis.at(at));
    const double beside = 0.5 * box.size().norm() + kLeastBeside;
    std::vector<Vec3> points;
    for (const Vec3 &end : {Vec3(box.min), Vec3(box.max)})
        for (const Vec3 &way : {Vec3::UnitX().eval(), Vec3::UnitY().eval(), Vec3::UnitZ().eval()})
            for (const double side : {-beside, beside})
                points.push_back(end + side * way);
    return points;
}

/// Of what is selected and there. None when nothing is.
std::vector<Vec3> selectedPoints(const Session &session, const Interaction &interaction)
{
    const Model &model = session.committed();
    if (interaction.selectedJoint())
        return pointsRound(model, *interaction.selectedJoint());
    return outlinePoints(model, interaction.sectionsInFocus());
}

/// What is selected takes this part of the view's width and height, and the rest is for what is
/// round it, as far as there is any.
Camera fittedAmid(double share, const Session &session, const Interaction &interaction)
{
    const Vec2 &viewport = interaction.viewport();
    const ViewMargins margins = fitMargins(viewport, interaction.covered());
    const std::vector<Vec3> selected = selectedPoints(session, interaction);
    const auto near = [&](double part) {
        return fittedClear(interaction.targetCamera(), selected, viewport,
                           withRoomAround(margins, viewport, part));
    };
    const Camera all =
        fittedClear(interaction.targetCamera(),
                    outlinePoints(session.committed(), interaction.view()), viewport, margins);
    const Camera camera = near(share);
    const double closer = all.millimetresPerPixel / camera.millimetresPerPixel;
    if (closer <= 1.0)
        return all; // round all that there is nothing is left to be seen
    return closer > kMostCloser ? near(share * kMostCloser / closer) : camera;
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
                     }});
    }
    registry.add("view.iso", {[&](const CommandParameters &, double time) -> Result<void> {
                     const Eigen::Quaterniond corner = nextCorner(interaction.targetCamera());
                     interaction.turnTo(turnedTo(corner, session, interaction), time, kTurnTime);
                     return {};
                 }});
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
                  needsSelection(interaction)});
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
               Set set, CommandRule rule = {})
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
                      std::move(rule), [&interaction, isOn] { return isOn(interaction.view()); }});
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
        registry, "check.stress", interaction,
        [](const ViewState &view) { return view.showsStress; },
        [](ViewState &view, bool on) { view.showsStress = on; },
        needs(
            [&session, &interaction] {
                return interaction.view().showsStress || session.committed().sectionCount() > 0;
            },
            kNothingThere));
    addSwitch(
        registry, "view.isolate", interaction,
        [](const ViewState &view) { return !view.isolated.empty(); },
        [&interaction](ViewState &view, bool on) {
            view.isolated.clear();
            const std::vector<SectionRef> sections = interaction.sectionsInFocus();
            if (on)
                view.isolated.insert(sections.begin(), sections.end());
        },
        needs(
            [&interaction] {
                return !interaction.view().isolated.empty() ||
                       !interaction.sectionsInFocus().empty();
            },
            kNothingSelected));
    addSwitch(
        registry, "view.clip", interaction,
        [](const ViewState &view) { return view.clip.has_value(); },
        [&session, &interaction](ViewState &view, bool on) {
            view.clip.reset();
            if (on)
                view.clip = cutFacingEye(session, interaction);
        },
        needs(
            [&session, &interaction] {
                return interaction.view().clip || session.committed().sectionCount() > 0;
            },
            kNothingThere));
    registry.add("view.hide", {[&](const CommandParameters &, double) -> Result<void> {
                                   ViewState view = interaction.view();
                                   const std::vector<SectionRef> sections =
                                       interaction.sectionsInFocus();
                                   view.hidden.insert(sections.begin(), sections.end());
                                   interaction.select({}); // what is not seen is not worked on
                                   interaction.setView(std::move(view));
                                   return {};
                               },
                               needsSelection(interaction)});
    registry.add("view.showAll", {[&](const CommandParameters &, double) -> Result<void> {
                                      ViewState view = interaction.view();
                                      view.hidden.clear();
                                      view.isolated.clear();
                                      interaction.setView(std::move(view));
                                      return {};
                                  },
                                  needs(
                                      [&] {
                                          return !interaction.view().hidden.empty() ||
                                                 !interaction.view().isolated.empty();
                                      },
                                      FFF_TEXT("Command", "No section is hidden"))});
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
         {},
         [&] { return interaction.targetCamera().isPerspective(); }});
    registry.add("view.previous", {[&](const CommandParameters &, double time) -> Result<void> {
                                       interaction.goBack(time, kTurnTime);
                                       return {};
                                   },
                                   needs([&] { return interaction.canGoBack(); },
                                         FFF_TEXT("Command", "There is no view before this one"))});
}

void registerFits(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registry.add("view.fitAll",
                 {[&interaction](const CommandParameters &, double time) -> Result<void> {
                     interaction.fitAll(interaction.targetCamera(), time, kFitTime);
                     return {};
                 }});
    const auto hasSelection = [&session, &interaction] {
        return interaction.selectedJoint()
                   ? jointState(session.committed(), *interaction.selectedJoint()).has_value()
                   : !interaction.sectionsInFocus().empty();
    };
    registry.add("view.fitSelection",
                 {[&session, &interaction](const CommandParameters &parameters,
                                           double time) -> Result<void> {
                      const Result<double> share = numberOf(parameters, "share", 1.0);
                      if (!share)
                          return tl::unexpected(share.error());
                      if (!(*share >= kLeastShare && *share <= 1.0))
                          return failure(ErrorCode::BadValue, "share",
                                         {parameters.at("share"), "0.1 to 1"});
                      if (*share == 1.0)
                          interaction.fit(selectedPoints(session, interaction), time, kFitTime);
                      else
                          interaction.turnTo(fittedAmid(*share, session, interaction), time,
                                             kFitTime);
                      return {};
                  },
                  needs(hasSelection, kNothingSelected)});
}

} // namespace

void registerViewCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registerTurns(registry, session, interaction);
    registerFits(registry, session, interaction);
    registerCamera(registry, interaction);
    registerLooks(registry, session, interaction);
    registry.offer(kViewWords);
}

Camera turnedTo(const Eigen::Quaterniond &orientation, const Session &session,
                const Interaction &interaction)
{
    Box3 box;
    for (const Vec3 &point : selectedPoints(session, interaction))
        box.extend(point);
    if (box.isEmpty())
        box = session.committed().bounds();
    const Vec3 pivot = box.isEmpty() ? Vec3(0.0, kFirstPlaneHeight, 0.0) : box.center();
    return turned(interaction.targetCamera(), orientation, pivot, interaction.viewport());
}

} // namespace fff
