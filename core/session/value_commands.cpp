#include "core/session/value_commands.h"

#include "core/interaction/section_edit.h"
#include "core/model/value_names.h"
#include "core/operations/driven.h"
#include "core/session/command_rules.h"
#include "core/session/message_text.h"
#include "core/session/operation_script.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fff {

namespace {

//: %1 is the name of a value
constexpr Text kAddValue = FFF_TEXT("Step", "Add %1");
//: %1 is the name of a value
constexpr Text kSetValue = FFF_TEXT("Step", "Set %1");
//: %1 is the name a value had, %2 the one that it has now
constexpr Text kRenameValue = FFF_TEXT("Step", "Rename %1 to %2");
//: %1 is the name of a value
constexpr Text kDeleteValue = FFF_TEXT("Step", "Delete %1");
//: %n numbers were made of a value that is removed
constexpr Text kNowNumbers =
    FFF_TEXT_OF_MANY("Hint", "%n that were made of it are plain numbers now.");

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
        return carryOut(addValue(document(), *wanted), {kAddValue, {Named{name}}}, "expression",
                        parameters, time);
    }

    Result<void> set(const CommandParameters &parameters, double time) const
    {
        const Value *known = document().values.find(std::string_view(said(parameters, "name")));
        if (!known)
            return unknown(parameters);
        const Result<Value> wanted = withSaid(parameters, *known);
        if (!wanted)
            return tl::unexpected(wanted.error());
        Step step{kSetValue, {Named{known->name}}};
        step.merges = said(parameters, "merges");
        return carryOut(changeValue(document(), *wanted), std::move(step), "expression", parameters,
                        time);
    }

    Result<void> rename(const CommandParameters &parameters, double time) const
    {
        const Value *known = document().values.find(std::string_view(said(parameters, "name")));
        if (!known)
            return unknown(parameters);
        const std::string to = said(parameters, "to");
        return carryOut(renameValue(document(), known->id, to),
                        {kRenameValue, {Named{known->name}, Named{to}}}, "to", parameters, time);
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Value *known = document().values.find(std::string_view(said(parameters, "name")));
        if (!known)
            return unknown(parameters);
        RemovedValue removed = removeValue(document(), known->id);
        EditedSections edit{std::move(removed.document), {kDeleteValue, {Named{known->name}}}};
        if (removed.users > 0)
            edit.note = Hint(Message{kNowNumbers, {}, removed.users});
        m_interaction.carryOut(std::move(edit), time);
        return {};
    }

    Result<void> bind(const CommandParameters &parameters, double time) const
    {
        const std::optional<DrivenPlace> place = placeOfKey(document(), said(parameters, "place"));
        if (!place)
            return noPlace(parameters);
        auto next = bound(document(), *place, said(parameters, "expression"), scriptReading());
        if (!next)
            return refuse(next.error(), "expression", parameters, time);
        m_interaction.carryOut(EditedSections{*std::move(next), stepOf(*place)}, time);
        return {};
    }

    Result<void> release(const CommandParameters &parameters, double time) const
    {
        const std::optional<DrivenPlace> place = placeOfKey(document(), said(parameters, "place"));
        if (!place)
            return noPlace(parameters);
        m_interaction.carryOut(EditedSections{withoutBinding(document(), *place), stepOf(*place)},
                               time);
        return {};
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
    Step stepOf(const DrivenPlace &place) const { return {kSetValue, {nameOf(document(), place)}}; }

    /// The person reads why; a script learns where.
    Result<void> refuse(const Message &why, const char *key, const CommandParameters &parameters,
                        double time) const
    {
        Hint hint(why);
        hint.isRefusal = true;
        m_interaction.say(std::move(hint), time);
        return failure(ErrorCode::BadValue, key,
                       {said(parameters, key), messageText(why).toStdString()});
    }

    Result<void> carryOut(Understood<Document> next, Step step, const char *key,
                          const CommandParameters &parameters, double time) const
    {
        if (!next)
            return refuse(next.error().message, key, parameters, time);
        if (const std::optional<Message> wrong = newlyWrong(document(), *next))
            return refuse(*wrong, key, parameters, time);
        m_interaction.carryOut(EditedSections{*std::move(next), std::move(step)}, time);
        return {};
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
    add("value.bind", &ValueCommands::bind);
    add("value.release", &ValueCommands::release);
}

} // namespace fff
