#include "core/session/tool_commands.h"

#include "core/analysis/dropping.h"
#include "core/base/tolerances.h"
#include "core/interaction/draw_tool.h"
#include "core/interaction/draw_words.h"
#include "core/interaction/point_editing.h"
#include "core/model/edit_words.h"
#include "core/model/origin.h"
#include "core/session/command_rules.h"
#include "core/session/message_text.h"
#include "core/session/pen_commands.h"
#include "core/session/session_host.h"

#include <cmath>
#include <memory>
#include <optional>

namespace fff {

namespace {

constexpr CommandWords kToolWords[] = {
    {"section.symmetry", FFF_TEXT("Command", "Local &symmetry"), FFF_TEXT("Command", "Symmetry"),
     "S", "symmetry",
     FFF_TEXT("Command", "Mirror a contour across its slit when it is drawn on one side of it"),
     true},
    {"section.ground", FFF_TEXT("Command", "Cut flat at the &ground"),
     FFF_TEXT("Command", "Ground"), "G", "cut_at_ground",
     FFF_TEXT("Command", "Cut off what is drawn below the ground"), true},
    {"section.planeGround", FFF_TEXT("Command", "On the gr&ound"),
     FFF_TEXT("Command", "On the ground"), "L", "plane_ground",
     FFF_TEXT("Command", "Draw a section that lies on the ground"), true},
    {"section.planeFront", FFF_TEXT("Command", "On the &front plane"),
     FFF_TEXT("Command", "On the front"), "", "plane_front",
     FFF_TEXT("Command", "Draw a section upright in the middle, seen from the front"), true},
    {"section.planeSide", FFF_TEXT("Command", "On the s&ide plane"),
     FFF_TEXT("Command", "On the side"), "", "plane_side",
     FFF_TEXT("Command", "Draw a section upright in the middle, seen from the side"), true},
    {"section.planeParallel", FFF_TEXT("Command", "&Parallel to the section"),
     FFF_TEXT("Command", "Parallel"), "", "plane_parallel",
     FFF_TEXT("Command", "Draw a section parallel to the selected one"), true},
    {"section.redraw", FFF_TEXT("Command", "&Redraw contour"), FFF_TEXT("Command", "Redraw"), "R",
     "redraw", FFF_TEXT("Command", "Draw a new contour for the selected section"), true},
    {"section.addHole", FFF_TEXT("Command", "Draw a &hole"), FFF_TEXT("Command", "Hole"), "O",
     "hole", FFF_TEXT("Command", "Draw a hole in the selected section"), true},
    {"section.dropToGround", FFF_TEXT("Command", "Drop to gro&und"), FFF_TEXT("Command", "Drop"),
     "End", "drop_to_ground", FFF_TEXT("Command", "Set the model down on the ground"), true},
};

/// How far from its section a parallel plane lies, mm, when nobody says (half an inch).
constexpr double kParallelDistance = 12.7;

/// The one section that is selected; null when there is none or are several.
const Section *selectedSection(const Session &session, const Interaction &interaction)
{
    const std::vector<SectionRef> &selection = interaction.selection();
    return selection.size() == 1 ? session.committed().find(selection.front()) : nullptr;
}

/// A plane through a point with these axes as seen from where one looks straight at it.
ContourTarget onPlane(const Vec3 &origin, const Vec3 &x, const Vec3 &y)
{
    return ContourTarget::newSection({origin, x, y});
}

/// With the tool in hand, if it draws on canvases, else with one stroke.
void drawOn(Interaction &interaction, CanvasChoice canvas, double time)
{
    if (!interaction.useCanvas(canvas, time))
        interaction.pickUp(std::make_unique<DrawTool>(std::move(canvas)), time);
}

/// What is drawn on or instead of a section; of an image on the drawn one, which it follows.
struct OfSection
{
    const char *id; // of the command
    ContourTarget (*target)(const Section &);
    Text prompt;

    tl::expected<CanvasChoice, Hint> canvas(const Model &model, const SectionRef &ref) const
    {
        const auto origin = originOf(model, ref);
        if (!origin)
            return tl::unexpected(madeByOperation(model, ref).value());
        const Section &section = *origin->section;
        if (section.isLocked)
            return tl::unexpected(Hint::refusal(hints::kLocked, {Named{section.name}}));
        return CanvasChoice{target(section), id, prompt, section.name};
    }
};

void registerDrawing(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    constexpr OfSection redraw{"section.redraw", &ContourTarget::redraw, hints::kDrawNewContour};
    constexpr OfSection hole{"section.addHole", &ContourTarget::hole, hints::kDrawHole};
    const auto draw = [&session, &interaction](const OfSection &what, double time) {
        const Section *selected = selectedSection(session, interaction);
        if (!selected)
            return interaction.layDown(time);
        tl::expected<CanvasChoice, Hint> canvas = what.canvas(session.committed(), selected->ref());
        if (canvas)
            return drawOn(interaction, *std::move(canvas), time);
        interaction.layDown(time);
        interaction.say(canvas.error(), time);
    };
    registry.add(redraw.id,
                 {[draw, redraw](const CommandParameters &, double time) -> Result<void> {
                      draw(redraw, time);
                      return {};
                  },
                  needsOneSection(interaction, redraw.id), inHand(interaction, redraw.id)});
    // With none selected it is the one that the first drag begins on.
    registry.add(hole.id, {[&session, &interaction, draw, hole](const CommandParameters &,
                                                                double time) -> Result<void> {
                               if (selectedSection(session, interaction)) {
                                   draw(hole, time);
                                   return {};
                               }
                               const auto of = [hole](const Model &model, const SectionRef &ref) {
                                   return hole.canvas(model, ref);
                               };
                               interaction.pickUp(std::make_unique<DrawTool>(AskedCanvas{
                                                      hole.id, hints::kDrawHoleOnAny, of}),
                                                  time);
                               return {};
                           },
                           needsSections(session), inHand(interaction, hole.id)});
}

void registerPlanes(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const auto add = [&](const char *id, Text prompt, std::function<ContourTarget()> target) {
        registry.add(id, {[&interaction, id, prompt, target](const CommandParameters &,
                                                             double time) -> Result<void> {
                              drawOn(interaction, {target(), id, prompt}, time);
                              return {};
                          },
                          {},
                          inHand(interaction, id)});
    };
    // What is drawn on the ground lies on it with its lower face.
    add("section.planeGround", hints::kDrawOnGround, [&session] {
        const Document &document = session.committed().document;
        const double half = 0.5 * document.find(document.currentStock)->thickness;
        return onPlane({0.0, half, 0.0}, Vec3::UnitX(), -Vec3::UnitZ());
    });
    add("section.planeFront", hints::kDrawOnFront,
        [] { return onPlane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()); });
    add("section.planeSide", hints::kDrawOnSide,
        [] { return onPlane(Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()); });
    registry.add("section.planeParallel",
                 {[&](const CommandParameters &parameters, double time) -> Result<void> {
                      const Result<double> distance =
                          numberOf(parameters, "distance", kParallelDistance);
                      if (!distance)
                          return tl::unexpected(distance.error());
                      if (!selectedSection(session, interaction)) {
                          interaction.layDown(time);
                          return {};
                      }
                      const Section &section = *selectedSection(session, interaction);
                      Frame canvas = section.frame;
                      canvas.origin += *distance * canvas.normal();
                      drawOn(interaction,
                             {ContourTarget::newSection(canvas), "section.planeParallel",
                              hints::kDrawParallel, section.name, *distance},
                             time);
                      return {};
                  },
                  needsOneSection(interaction, "section.planeParallel"),
                  inHand(interaction, "section.planeParallel")});
}

void registerGround(CommandRegistry &registry, Session &session)
{
    registry.add("section.dropToGround",
                 {[&session](const CommandParameters &, double) -> Result<void> {
                      if (std::optional<Document> next = droppedToGround(session.committed()))
                          session.commit(messageText(steps::kDropToGround), *std::move(next));
                      return {};
                  },
                  [&session](const CommandParameters &) -> WhyNot {
                      if (session.committed().sectionCount() == 0)
                          return kNothingThere;
                      if (!droppedToGround(session.committed()))
                          return FFF_TEXT("Command", "The model is on the ground already");
                      return {};
                  }});
}

void registerSwitches(CommandRegistry &registry, Interaction &interaction)
{
    const auto add = [&](const char *id, bool InteractionSettings::*field) {
        registry.add(id, {[&interaction, field](const CommandParameters &parameters,
                                                double) -> Result<void> {
                              bool &is = interaction.settings().*field;
                              is = switched(parameters, is);
                              return {};
                          },
                          {},
                          [&interaction, field] { return interaction.settings().*field; }});
    };
    add("section.symmetry", &InteractionSettings::mirrors);
    add("section.ground", &InteractionSettings::cutsAtGround);
}

} // namespace

void registerToolCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registerDrawing(registry, session, interaction);
    registerPlanes(registry, session, interaction);
    registerGround(registry, session);
    registerSwitches(registry, interaction);
    registerPenCommands(registry, interaction);
    registry.offer(kToolWords);
}

} // namespace fff
