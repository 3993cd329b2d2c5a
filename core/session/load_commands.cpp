#include "core/session/load_commands.h"

#include "core/interaction/load_editing.h"
#include "core/interaction/load_tool.h"
#include "core/interaction/section_edit.h"
#include "core/model/load_edits.h"
#include "core/model/load_names.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <utility>

namespace fff {

namespace {

constexpr double kUsualPush = 5.0; // N

constexpr CommandWords kLoadWords[] = {
    {"physics.addWeight", FFF_TEXT("Command", "Add &weight"), FFF_TEXT("Command", "Weight"), "W",
     "weight", FFF_TEXT("Command", "Put a weight on a section to see what it can hold"), true},
    {"physics.addPush", FFF_TEXT("Command", "Add p&ush"), FFF_TEXT("Command", "Push"), "", "push",
     FFF_TEXT("Command", "Push or pull a section in one place to see what it can hold"), true},
    {"physics.pull", FFF_TEXT("Command", "Pull &here"), FFF_TEXT("Command", "Pull"), "", "pull",
     FFF_TEXT("Command", "Pull a section with the mouse to see what happens; nothing is kept"),
     true},
};

using Numbers = std::initializer_list<std::pair<const char *, double *>>;

Result<void> readNumbers(const CommandParameters &parameters, Numbers numbers)
{
    for (const auto &[key, number] : numbers) {
        const Result<double> value = numberOf(parameters, key, *number);
        if (!value)
            return tl::unexpected(value.error());
        *number = *value;
    }
    return {};
}

/// "force" and its direction, in the world. Longer than nothing, or an error that says so.
Result<void> readPush(const CommandParameters &parameters, const Frame &frame, Load &load)
{
    double force = load.push.norm();
    Vec3 direction = pushInWorld(load.push, frame).normalized();
    const std::array keys{"dx", "dy", "dz"};
    if (std::any_of(keys.begin(), keys.end(),
                    [&](const char *key) { return parameters.contains(key); }))
        direction.setZero();
    if (auto read = readNumbers(parameters, {{"force", &force},
                                             {"dx", &direction.x()},
                                             {"dy", &direction.y()},
                                             {"dz", &direction.z()}});
        !read)
        return read;
    if (direction.isZero(0.0))
        return failure(ErrorCode::BadValue, "dx", {"0", "a direction"});
    load.push = pushInFrame(force * direction.normalized(), frame);
    return {};
}

/// What is said of a load; the rest stays.
Result<Load> withParameters(const CommandParameters &parameters, Load load, const Frame &frame)
{
    if (auto read = readNumbers(parameters, {{"x", &load.position.x()},
                                             {"y", &load.position.y()},
                                             {"mass", &load.mass},
                                             {"filled", &load.filled},
                                             {"height", &load.height},
                                             {"width", &load.width}});
        !read)
        return tl::unexpected(read.error());
    if (load.isPush())
        if (auto read = readPush(parameters, frame, load); !read)
            return tl::unexpected(read.error());
    if (const std::string *spread = textOf(parameters, "spread")) {
        const std::optional<Spread> named = spreadNamed(*spread);
        if (!named)
            return failure(ErrorCode::BadValue, "spread",
                           {*spread, "point, patch, edge or hanging"});
        load.spread = *named;
    }
    if (const std::string *repeated = textOf(parameters, "repeated"))
        load.isRepeated = *repeated == "true";
    for (const auto &[key, text] :
         {std::pair("name", &load.name), std::pair("preset", &load.preset)})
        if (const std::string *said = textOf(parameters, key))
            *text = *said;
    return load;
}

class LoadCommands
{
public:
    LoadCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> addWeight(const CommandParameters &parameters, double time) const
    {
        Load weight; // as heavy as the one that was hung last
        for (const Load &load : m_session.committed().document.loads)
            if (!load.isPush())
                weight.mass = load.mass;
        return add(LoadTool::Use::Weight, weight, parameters, time);
    }
    Result<void> addPush(const CommandParameters &parameters, double time) const
    {
        return add(LoadTool::Use::Push, usualPush(), parameters, time);
    }
    Result<void> pull(const CommandParameters &, double time) const
    {
        m_interaction.pickUp(std::make_unique<LoadTool>(LoadTool::Use::Pull, usualPush()), time);
        return {};
    }

    /// What is not said stays. One step, whatever is said.
    Result<void> set(const CommandParameters &parameters, double time) const
    {
        const Result<Load> load = loadOf(parameters);
        if (!load)
            return tl::unexpected(load.error());
        const Section *section = m_session.committed().find(load->section);
        const Result<Load> next =
            withParameters(parameters, *load, section ? section->frame : Frame());
        if (!next)
            return tl::unexpected(next.error());
        // A number that is none is the script's fault; what is refused is said to the person.
        if (const auto document = setLoad(m_session.committed().document, *next); !document)
            return tl::unexpected(document.error());
        m_interaction.carryOut(changedLoad(m_session.committed(), *next), time);
        return {};
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Result<Load> load = loadOf(parameters);
        if (!load)
            return tl::unexpected(load.error());
        m_interaction.carryOut(removedLoad(m_session.committed(), load->id), time);
        return {};
    }

    Result<void> select(const CommandParameters &parameters, double) const
    {
        const Result<Load> load = loadOf(parameters);
        if (!load)
            return tl::unexpected(load.error());
        m_interaction.selectLoad(load->id);
        return {};
    }

    Result<void> heavier(const CommandParameters &parameters, double time) const
    {
        return addMore(1.0, parameters, time);
    }
    Result<void> lighter(const CommandParameters &parameters, double time) const
    {
        return addMore(-1.0, parameters, time);
    }

private:
    static Load usualPush()
    {
        Load push;
        push.kind = LoadKind::Push;
        push.push = {0.0, 0.0, -kUsualPush};
        return push;
    }

    Result<void> add(LoadTool::Use use, Load load, const CommandParameters &parameters,
                     double time) const
    {
        const std::string *name = textOf(parameters, "section");
        if (!name) {
            m_interaction.pickUp(std::make_unique<LoadTool>(use, load), time);
            return {};
        }
        const std::optional<SectionRef> ref = sectionNamed(m_session.committed(), *name);
        if (!ref)
            return failure(ErrorCode::BadValue, "section", {*name, "the name of a section"});
        const Section *section = m_session.committed().find(*ref);
        load.section = section->ref();
        load.position = section->shape->centroid();
        const Result<Load> put = withParameters(parameters, load, section->frame);
        if (!put)
            return tl::unexpected(put.error());
        Result<Document> next = addLoad(m_session.committed().document, *put);
        if (!next)
            return tl::unexpected(next.error());
        const Step step = LoadDrag(*put).step(m_session.committed());
        m_interaction.carryOut(EditedSections{*std::move(next), step}, time);
        return {};
    }

    Result<void> addMore(double sign, const CommandParameters &parameters, double time) const
    {
        const Result<Load> load = loadOf(parameters);
        if (!load)
            return tl::unexpected(load.error());
        const Result<double> by =
            numberOf(parameters, "by", load->isPush() ? kForceStep : kMassStep);
        if (!by)
            return tl::unexpected(by.error());
        m_interaction.carryOut(withMore(m_session.committed(), load->id, sign * *by), time);
        return {};
    }

    /// The one that is meant, or without a number the selected one, else the first.
    Result<Load> loadOf(const CommandParameters &parameters) const
    {
        const Document &document = m_session.committed().document;
        if (const Load *selected = document.find(m_interaction.selectedLoad());
            selected && !parameters.contains("load"))
            return *selected;
        const std::vector<Load> &loads = document.loads;
        const Result<double> index = numberOf(parameters, "load", 0.0);
        if (!index)
            return tl::unexpected(index.error());
        if (!(*index >= 0.0 && *index < static_cast<double>(loads.size())))
            return failure(ErrorCode::BadValue, "load",
                           {std::to_string(*index), "the number of a load"});
        return loads[static_cast<std::size_t>(*index)];
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerLoadCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const LoadCommands commands(session, interaction);
    using Run = Result<void> (LoadCommands::*)(const CommandParameters &, double) const;
    const auto runner = [commands](Run run) {
        return [commands, run](const CommandParameters &parameters, double time) {
            return (commands.*run)(parameters, time);
        };
    };
    for (const auto &[id, run] : {std::pair(LoadTool::kAddWeight, &LoadCommands::addWeight),
                                  std::pair(LoadTool::kAddPush, &LoadCommands::addPush),
                                  std::pair(LoadTool::kPull, &LoadCommands::pull)})
        registry.add(std::string(id),
                     {runner(run), needsSections(session), inHand(interaction, std::string(id))});
    const CommandRule hasLoads =
        needs([&session] { return !session.committed().document.loads.empty(); },
              FFF_TEXT("Command", "Nothing acts on the model: add a weight or a push first"));
    for (const auto &[id, run] : {std::pair("physics.setLoad", &LoadCommands::set),
                                  std::pair("physics.removeLoad", &LoadCommands::remove),
                                  std::pair("physics.selectLoad", &LoadCommands::select),
                                  std::pair("physics.heavier", &LoadCommands::heavier),
                                  std::pair("physics.lighter", &LoadCommands::lighter)})
        registry.add(id, {runner(run), hasLoads});
    registry.offer(kLoadWords);
}

} // namespace fff
