#include "core/session/value_commands.h"

#include "core/interaction/value_editing.h"
#include "core/model/value_names.h"
#include "core/operations/drivable.h"
#include "core/session/command_rules.h"
#include "core/session/message_text.h"
#include "core/session/operation_script.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fff {

namespace {

constexpr CommandWords kValueWords[] = {
    {"value.handOn", FFF_TEXT("Command", "Share for adjusting"), FFF_TEXT("Command", "Share"), "",
     "hand_on",
     FFF_TEXT("Command",
              "Whoever opens the saved model sees the view, the shown values and Export, "
              "and nothing else")}};
constexpr Text kEditDesignAgain = FFF_TEXT("Command", "Edit the design");

Reading scriptReading()
{
    Reading reading;
    reading.massUnit = 1.0;
    return reading;
}

std::vector<std::string> choicesIn(const std::string &text)
{
    std::vector<std::string> choices;
    std::size_t begin = 0;
    for (std::size_t bar = text.find('|'); bar != text.npos; bar = text.find('|', begin)) {
        choices.push_back(text.substr(begin, bar - begin));
        begin = bar + 1;
    }
    choices.push_back(text.substr(begin));
    return choices;
}

/// A bound of a range is an expression of the value's kind, too.
Result<std::optional<double>> boundIn(const CommandParameters &parameters, const char *key,
                                      ValueKind kind, std::optional<double> otherwise)
{
    const std::string *text = textOf(parameters, key);
    if (!text)
        return otherwise;
    const Understood<Typed> typed = Typed::read(*text, kind, scriptReading());
    const Names none = [](std::string_view) -> const Worth * { return nullptr; };
    const Understood<Worth> worth = typed ? typed->worth(none) : tl::unexpected(typed.error());
    if (!worth)
        return failure(ErrorCode::BadValue, key, {*text, "a number of the value's kind"});
    return std::optional(worth->number);
}

/// The value with what the parameters say of it.
Result<Value> withSaid(const CommandParameters &parameters, Value value)
{
    if (const std::string *kind = textOf(parameters, "kind")) {
        const auto known = namedIn(kValueKindNames, *kind);
        if (!known)
            return failure(ErrorCode::BadValue, "kind", {*kind, "a kind of values"});
        value.kind = *known;
    }
    if (const std::string *expression = textOf(parameters, "expression")) {
        value.typed = *expression;
        value.reading = scriptReading();
    }
    for (const auto &[key, bound] :
         {std::pair{"least", &value.range.least}, std::pair{"most", &value.range.most},
          std::pair{"step", &value.range.step}}) {
        const Result<std::optional<double>> read = boundIn(parameters, key, value.kind, *bound);
        if (!read)
            return tl::unexpected(read.error());
        *bound = *read;
    }
    if (const std::string *choices = textOf(parameters, "choices"))
        value.choices = choicesIn(*choices);
    if (const std::string *note = textOf(parameters, "note"))
        value.note = *note;
    if (const std::string *group = textOf(parameters, "group"))
        value.group = *group;
    if (const std::string *shown = textOf(parameters, "shown"))
        value.isShown = *shown == "true";
    return value;
}

class ValueCommands
{
public:
    ValueCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> add(const CommandParameters &parameters, double time) const
    {
        const std::string name = said(parameters, "name");
        Value value;
        value.name = name;
        const Result<Value> wanted = withSaid(parameters, std::move(value));
        if (!wanted)
            return tl::unexpected(wanted.error());
        return carryOut(valueAdded(document(), *wanted), "expression", parameters, time);
    }

    Result<void> set(const CommandParameters &parameters, double time) const
    {
        const Value *known = document().values.find(std::string_view(said(parameters, "name")));
        if (!known)
            return unknown(parameters);
        const Result<Value> wanted = withSaid(parameters, *known);
        if (!wanted)
            return tl::unexpected(wanted.error());
        return carryOut(valueChanged(document(), *wanted, said(parameters, "merges")), "expression",
                        parameters, time);
    }

    Result<void> rename(const CommandParameters &parameters, double time) const
    {
        const Value *known = document().values.find(std::string_view(said(parameters, "name")));
        if (!known)
            return unknown(parameters);
        return carryOut(valueRenamed(document(), known->id, said(parameters, "to")), "to",
                        parameters, time);
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Value *known = document().values.find(std::string_view(said(parameters, "name")));
        if (!known)
            return unknown(parameters);
        return carryOut(valueRemoved(document(), known->id), "name", parameters, time);
    }

    Result<void> keepPreset(const CommandParameters &parameters, double time) const
    {
        return carryOut(presetKept(document(), said(parameters, "name")), "name", parameters, time);
    }

    Result<void> takePreset(const CommandParameters &parameters, double time) const
    {
        return carryOut(presetTaken(document(), said(parameters, "name")), "name", parameters,
                        time);
    }

    Result<void> removePreset(const CommandParameters &parameters, double time) const
    {
        return carryOut(presetRemoved(document(), said(parameters, "name")), "name", parameters,
                        time);
    }

    Result<void> bind(const CommandParameters &parameters, double time) const
    {
        const std::optional<DrivenPlace> place = placeOfKey(document(), said(parameters, "place"));
        if (!place)
            return noPlace(parameters);
        return carryOut(
            numberBound(document(), *place, said(parameters, "expression"), scriptReading()),
            "expression", parameters, time);
    }

    Result<void> release(const CommandParameters &parameters, double time) const
    {
        const std::optional<DrivenPlace> place = placeOfKey(document(), said(parameters, "place"));
        if (!place)
            return noPlace(parameters);
        return carryOut(numberReleased(document(), *place), "place", parameters, time);
    }

    Result<void> handOn(const CommandParameters &parameters, double time) const
    {
        const bool isOn = document().opensForAdjusting;
        return carryOut(handedOn(document(), switched(parameters, isOn)), "on", parameters, time);
    }

private:
    const Document &document() const { return m_session.committed().document; }

    static std::string said(const CommandParameters &parameters, const char *key)
    {
        const std::string *text = textOf(parameters, key);
        return text ? *text : std::string();
    }
    static tl::unexpected<Error> unknown(const CommandParameters &parameters)
    {
        return failure(ErrorCode::BadValue, "name",
                       {said(parameters, "name"), "the name of a value"});
    }
    static tl::unexpected<Error> noPlace(const CommandParameters &parameters)
    {
        return failure(ErrorCode::BadValue, "place",
                       {said(parameters, "place"), "a number of the model"});
    }

    /// The person reads why; a script learns where.
    Result<void> carryOut(SectionEdit edit, const char *key, const CommandParameters &parameters,
                          double time) const
    {
        const std::string why =
            edit ? std::string() : messageText(edit.error().words).toStdString();
        const bool isMade = edit.has_value();
        m_interaction.carryOut(std::move(edit), time);
        if (isMade)
            return {};
        return failure(ErrorCode::BadValue, key, {said(parameters, key), why});
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerValueCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const ValueCommands commands(session, interaction);
    using Run = Result<void> (ValueCommands::*)(const CommandParameters &, double) const;
    const auto add = [&](const char *id, Run run) {
        registry.add(id, {[commands, run](const CommandParameters &parameters, double time) {
                         return (commands.*run)(parameters, time);
                     }});
    };
    add("value.add", &ValueCommands::add);
    add("value.set", &ValueCommands::set);
    add("value.rename", &ValueCommands::rename);
    add("value.remove", &ValueCommands::remove);
    add("preset.keep", &ValueCommands::keepPreset);
    add("preset.take", &ValueCommands::takePreset);
    add("preset.remove", &ValueCommands::removePreset);
    add("value.bind", &ValueCommands::bind);
    add("value.release", &ValueCommands::release);
    // It says which of the two it does, so that neither has to be looked for.
    registry.add("value.handOn", {[commands](const CommandParameters &parameters, double time) {
                                      return commands.handOn(parameters, time);
                                  },
                                  needs(
                                      [&session] {
                                          const Document &document = session.committed().document;
                                          return document.opensForAdjusting ||
                                                 hasShownValue(document.values);
                                      },
                                      FFF_TEXT("Command", "Others can adjust no value yet")),
                                  {},
                                  [&session]() -> Message {
                                      if (session.committed().document.opensForAdjusting)
                                          return {kEditDesignAgain, {}};
                                      return {};
                                  }});
    registry.offer(kValueWords);
}

} // namespace fff
