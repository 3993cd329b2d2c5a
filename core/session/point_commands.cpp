#include "core/session/point_commands.h"

#include "core/model/edits.h"
#include "core/model/origin.h"
#include "core/model/step.h"
#include "core/session/command_rules.h"
#include "core/session/message_text.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr CommandWords kPointWords[] = {
    {"section.removeHoles", FFF_TEXT("Command", "Re&move holes"), FFF_TEXT("Command", "No holes"),
     "", "holes_remove", FFF_TEXT("Command", "Close all holes of the selected sections"), true},
    {"point.insert", FFF_TEXT("Command", "&Add point"), FFF_TEXT("Command", "Add point"), "+",
     "point_add",
     FFF_TEXT("Command", "Add a control point under the cursor, or beside the selected one"), true},
    {"point.delete", FFF_TEXT("Command", "De&lete point"), FFF_TEXT("Command", "Delete point"), "-",
     "point_remove", FFF_TEXT("Command", "Delete the selected control points"), true},
    {"point.smooth", FFF_TEXT("Command", "Smoo&th point"), FFF_TEXT("Command", "Smooth"), "Ctrl+1",
     "point_smooth", FFF_TEXT("Command", "Make the contour smooth at the selected points")},
    {"point.symmetric", FFF_TEXT("Command", "S&ymmetric point"), FFF_TEXT("Command", "Symmetric"),
     "Ctrl+3", "point_symmetric",
     FFF_TEXT("Command", "Make the contour smooth, with handles of equal length on both sides")},
    {"point.corner", FFF_TEXT("Command", "&Corner point"), FFF_TEXT("Command", "Corner"), "Ctrl+2",
     "point_corner", FFF_TEXT("Command", "Make the selected points corners")},
};

//: %1 is the name of a section
constexpr CountedText kRemoveHoles{FFF_TEXT("Step", "Remove holes of %1"),
                                   FFF_TEXT_OF_MANY("Step", "Remove holes of %n sections")};

constexpr double kNudge = 1.0; // mm

/// A place of a contour that a script names. None: it names none.
Result<std::optional<std::pair<int, CurvePoint>>> placeIn(const CommandParameters &parameters,
                                                          const Shape &shape)
{
    if (!parameters.contains("segment"))
        return std::nullopt;
    const auto ring = numberOf(parameters, "boundary", 0.0);
    const auto segment = numberOf(parameters, "segment", 0.0);
    const auto t = numberOf(parameters, "t", 0.5);
    for (const auto *number : {&ring, &segment, &t})
        if (!*number)
            return tl::unexpected(number->error());
    const PointAddress start{static_cast<int>(*ring), static_cast<int>(*segment)};
    if (!isPoint(shape, start) || !(*t > 0.0 && *t < 1.0))
        return failure(ErrorCode::BadValue, "segment", {std::to_string(*segment), "a place"});
    return std::pair(start.boundary, CurvePoint{start.index, *t});
}

std::optional<std::pair<int, CurvePoint>> placeToInsert(const Interaction &interaction)
{
    const SectionPointer section = interaction.sectionOfPoints();
    if (!section)
        return std::nullopt;
    const auto hovered = interaction.hoveredPoint();
    if (hovered && hovered->kind == PointTarget::Kind::Line)
        return std::pair(hovered->point.boundary, CurvePoint{hovered->point.index, hovered->t});
    return placeBetween(*section->shape, interaction.points());
}

Result<void> insertPoint(Interaction &interaction, const CommandParameters &parameters, double time)
{
    const SectionPointer section = interaction.sectionOfPoints();
    if (!section)
        return {};
    auto place = placeIn(parameters, *section->shape);
    if (!place)
        return tl::unexpected(place.error());
    if (!*place)
        *place = placeToInsert(interaction);
    if (*place)
        interaction.carryOut(withInsertedPoint(interaction.documentOfPoints(), section->id,
                                               (*place)->first, (*place)->second,
                                               interaction.pointRules()),
                             time);
    return {};
}

Result<void> selectPoint(Interaction &interaction, const CommandParameters &parameters)
{
    const auto ring = numberOf(parameters, "boundary", 0.0);
    const auto index = numberOf(parameters, "index", 0.0);
    for (const auto *number : {&ring, &index})
        if (!*number)
            return tl::unexpected(number->error());
    std::vector<PointAddress> points;
    const auto add = parameters.find("add");
    if (add != parameters.end() && add->second == "true")
        points = interaction.points().points();
    points.push_back({static_cast<int>(*ring), static_cast<int>(*index)});
    interaction.selectPoints(std::move(points));
    return {};
}

std::vector<const Section *> selectedWithHoles(const Session &session,
                                               const Interaction &interaction)
{
    std::vector<const Section *> sections;
    for (const SectionRef &ref : interaction.selection()) {
        const std::optional<Origin> origin = originOf(session.committed(), ref);
        if (origin && !origin->section->shape->holes().empty() &&
            std::find(sections.begin(), sections.end(), origin->section) == sections.end())
            sections.push_back(origin->section);
    }
    return sections;
}

Result<void> removeHoles(Session &session, const Interaction &interaction)
{
    std::vector<std::string> names;
    Result<Document> next = session.committed().document;
    for (const Section *section : selectedWithHoles(session, interaction)) {
        const Result<ShapePointer> shape = withoutHoles(*section->shape);
        if (!shape)
            return tl::unexpected(shape.error());
        names.push_back(section->name);
        if (next)
            next = setShape(*std::move(next), section->id, *shape);
    }
    if (!next)
        return tl::unexpected(next.error());
    session.commit(messageText(ofSections(kRemoveHoles, names)), *std::move(next));
    return {};
}

CommandRule needsPoints(const Interaction &interaction)
{
    return needs([&interaction] { return !interaction.points().isEmpty(); },
                 FFF_TEXT("Command", "No point of a contour is selected"));
}

CommandRule needsContour(const Interaction &interaction)
{
    return needs([&interaction] { return interaction.sectionOfPoints() != nullptr; },
                 FFF_TEXT("Command", "Select one section whose contour can be edited"));
}

void registerKinds(CommandRegistry &registry, Interaction &interaction)
{
    const auto add = [&](const char *id, PointKind kind) {
        registry.add(id,
                     {[&, kind](const CommandParameters &, double time) -> Result<void> {
                          interaction.carryOut(withSelectionOfKind(interaction.documentOfPoints(),
                                                                   interaction.points(), kind,
                                                                   interaction.pointRules()),
                                               time);
                          return {};
                      },
                      needsPoints(interaction)});
    };
    add("point.smooth", PointKind::Smooth);
    add("point.symmetric", PointKind::Symmetric);
    add("point.corner", PointKind::Corner);
}

void registerNudges(CommandRegistry &registry, Interaction &interaction)
{
    const auto add = [&](const char *id, const Vec2 &arrow) {
        registry.add(id, {[&interaction, arrow](const CommandParameters &parameters,
                                                double time) -> Result<void> {
                              const Result<double> distance =
                                  numberOf(parameters, "distance", kNudge);
                              if (!distance)
                                  return tl::unexpected(distance.error());
                              interaction.nudge(arrow, *distance, time);
                              return {};
                          },
                          needs(
                              [&interaction] {
                                  return !interaction.selection().empty() ||
                                         interaction.selectedJoint().has_value() ||
                                         interaction.selectedLoad().isValid();
                              },
                              kNothingSelected)});
    };
    add("nudge.left", -Vec2::UnitX());
    add("nudge.right", Vec2::UnitX());
    add("nudge.up", Vec2::UnitY());
    add("nudge.down", -Vec2::UnitY());
}

} // namespace

void registerPointCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    registry.add("point.insert", {[&](const CommandParameters &parameters, double time) {
                                      return insertPoint(interaction, parameters, time);
                                  },
                                  needsContour(interaction)});
    registry.add("point.delete",
                 {[&](const CommandParameters &, double time) -> Result<void> {
                      interaction.carryOut(withoutSelection(interaction.documentOfPoints(),
                                                            interaction.points(),
                                                            interaction.pointRules()),
                                           time);
                      return {};
                  },
                  needsPoints(interaction)});
    registry.add("point.select", {[&](const CommandParameters &parameters, double) {
                                      return selectPoint(interaction, parameters);
                                  },
                                  needsContour(interaction)});
    registry.add(
        "section.removeHoles",
        {[&](const CommandParameters &, double) { return removeHoles(session, interaction); },
         needsAmongSelected(
             interaction, [&] { return !selectedWithHoles(session, interaction).empty(); },
             FFF_TEXT("Command", "The selection has no holes"))});
    registerKinds(registry, interaction);
    registerNudges(registry, interaction);
    registry.offer(kPointWords);
}

} // namespace fff
