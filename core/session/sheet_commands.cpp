#include "core/session/sheet_commands.h"

#include "core/base/units.h"
#include "core/interaction/sheet_editing.h"
#include "core/model/sheet_edits.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fff {

namespace {

constexpr double kRightAngle = 90.0; // degrees

constexpr CommandWords kSheetWords[] = {
    {"sheets.unpinAll", FFF_TEXT("Command", "&Unpin all parts"), FFF_TEXT("Command", "Unpin all"),
     "", "stocks",
     FFF_TEXT("Command", "Let all parts be moved again when they are laid on sheets")},
};

/// Exact for quarter turns: what lies along the sheet's edge stays along it.
Vec2 turnOfDegrees(double angle)
{
    const double quarters = angle / kRightAngle;
    if (quarters == std::round(quarters)) {
        const int quarter = static_cast<int>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0));
        const Vec2 turns[] = {Vec2::UnitX(), Vec2::UnitY(), -Vec2::UnitX(), -Vec2::UnitY()};
        return turns[quarter];
    }
    return {std::cos(radians(angle)), std::sin(radians(angle))};
}

class SheetCommands
{
public:
    SheetCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> place(const CommandParameters &parameters, double time) const
    {
        const auto sections = sectionsOf(parameters);
        if (!sections)
            return tl::unexpected(sections.error());
        if (sections->size() != 1)
            return failure(ErrorCode::BadValue, "section", {"", "the name of a section"});
        const Result<PinnedPlace> place = placeOf(sections->front(), parameters);
        if (!place)
            return tl::unexpected(place.error());
        // A place that is none is the script's fault.
        if (const auto next = setPin(m_session.committed().document, *place); !next)
            return tl::unexpected(next.error());
        m_interaction.carryOut(placedOnSheet(m_session.committed(), *place), time);
        return {};
    }

    Result<void> unpin(const CommandParameters &parameters, double time) const
    {
        const auto sections = sectionsOf(parameters);
        if (!sections)
            return tl::unexpected(sections.error());
        m_interaction.carryOut(unpinned(m_session.committed(), *sections), time);
        return {};
    }

    Result<void> unpinAll(const CommandParameters &, double time) const
    {
        m_interaction.carryOut(allUnpinned(m_session.committed()), time);
        return {};
    }

    Result<void> turning(const CommandParameters &parameters, double time) const
    {
        const auto sections = sectionsOf(parameters);
        if (!sections)
            return tl::unexpected(sections.error());
        const std::string *name = textOf(parameters, "turning");
        const std::optional<nest::Turning> named = name ? turningNamed(*name) : std::nullopt;
        if (!named && !(name && *name == "all"))
            return failure(ErrorCode::BadValue, "turning",
                           {name ? *name : std::string(), "none, half, quarter, free or all"});
        m_interaction.carryOut(turnedOnSheets(m_session.committed(), *sections, named), time);
        return {};
    }

    bool hasPins() const { return !m_session.committed().document.pins.empty(); }

private:
    Result<std::vector<SectionRef>> sectionsOf(const CommandParameters &parameters) const
    {
        const std::string *name = textOf(parameters, "section");
        if (!name)
            return m_interaction.selection();
        const std::optional<SectionRef> ref = sectionNamed(m_session.committed(), *name);
        if (!ref)
            return failure(ErrorCode::BadValue, "section", {*name, "the name of a section"});
        return std::vector{*ref};
    }

    Result<PinnedPlace> placeOf(const SectionRef &section,
                                const CommandParameters &parameters) const
    {
        const Result<int> body = countedFrom1(parameters, "body", 0);
        if (!body)
            return tl::unexpected(body.error());
        PinnedPlace place{section, *body};
        const PinnedPlace *known = pinOf(m_session.committed().document, section, *body);
        if (known)
            place = *known;
        if (parameters.contains("sheet") || parameters.contains("offcut")) {
            const bool isOffcut = parameters.contains("offcut");
            const Result<int> sheet = countedFrom1(parameters, isOffcut ? "offcut" : "sheet", 0);
            if (!sheet)
                return tl::unexpected(sheet.error());
            place.sheet = isOffcut ? -1 - *sheet : *sheet;
        }
        for (const auto &[key, number] :
             {std::pair("x", &place.offset.x()), std::pair("y", &place.offset.y())}) {
            const Result<double> value = numberOf(parameters, key, *number);
            if (!value)
                return tl::unexpected(value.error());
            if (!known && !parameters.contains(key))
                return failure(ErrorCode::BadValue, key, {"", "a place on the sheet"});
            *number = *value;
        }
        if (parameters.contains("turn")) {
            const Result<double> turn = numberOf(parameters, "turn", 0.0);
            if (!turn)
                return tl::unexpected(turn.error());
            place.turn = turnOfDegrees(*turn);
        }
        return place;
    }

    /// As people count; `otherwise` and the result from 0 on.
    static Result<int> countedFrom1(const CommandParameters &parameters, const char *key,
                                    int otherwise)
    {
        const Result<double> number = numberOf(parameters, key, otherwise + 1.0);
        if (!number)
            return tl::unexpected(number.error());
        if (!(*number >= 1.0 && *number <= kMostPinnedSheets && *number == std::floor(*number)))
            return failure(ErrorCode::BadValue, key, {std::to_string(*number), "1, 2, 3 …"});
        return static_cast<int>(*number) - 1;
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerSheetCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const SheetCommands commands(session, interaction);
    using Run = Result<void> (SheetCommands::*)(const CommandParameters &, double) const;
    const auto add = [&](const char *id, Run run, CommandRule rule) {
        registry.add(id, {[commands, run](const CommandParameters &parameters, double time) {
                              return (commands.*run)(parameters, time);
                          },
                          std::move(rule)});
    };
    const CommandRule selected = needsSelection(interaction);
    const CommandRule named = [selected](const CommandParameters &parameters) -> WhyNot {
        return parameters.contains("section") ? WhyNot() : selected(parameters);
    };
    add("sheets.place", &SheetCommands::place, named);
    add("sheets.unpin", &SheetCommands::unpin, named);
    add("sheets.turning", &SheetCommands::turning, named);
    add("sheets.unpinAll", &SheetCommands::unpinAll,
        needs([commands] { return commands.hasPins(); },
              FFF_TEXT("Command", "No part is pinned to its sheet")));
    registry.offer(kSheetWords);
}

} // namespace fff
