#include "core/session/selection_commands.h"

#include "core/base/tolerances.h"
#include "core/session/command_rules.h"

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

namespace fff {

namespace {

constexpr CommandWords kSelectionWords[] = {
    {"edit.selectAll", FFF_TEXT("Command", "Select &all"), FFF_TEXT("Command", "Select all"),
     "Ctrl+A", "select_all", FFF_TEXT("Command", "Select all sections")},
    {"edit.selectNext", FFF_TEXT("Command", "Select ne&xt"), FFF_TEXT("Command", "Next"), "PgDown",
     "move_down", FFF_TEXT("Command", "Select the next section"), true},
    {"edit.selectPrevious", FFF_TEXT("Command", "Select pre&vious"),
     FFF_TEXT("Command", "Previous"), "PgUp", "move_up",
     FFF_TEXT("Command", "Select the section before this one"), true},
    {"edit.selectConnected", FFF_TEXT("Command", "Select co&nnected"),
     FFF_TEXT("Command", "Connected"), "Ctrl+Shift+A", "select_connected",
     FFF_TEXT("Command", "Select all sections that are connected to the selected ones")},
    {"edit.selectParallel", FFF_TEXT("Command", "&Select parallel"),
     FFF_TEXT("Command", "Parallel"), "", "select_parallel",
     FFF_TEXT("Command", "Select all sections parallel to the selected ones")},
    {"edit.selectSameStock", FFF_TEXT("Command", "Select same stoc&k"),
     FFF_TEXT("Command", "Same stock"), "", "stocks",
     FFF_TEXT("Command", "Select all sections of the same stock as the selected ones")},
};

class SelectionCommands
{
public:
    SelectionCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    void selectAll() const
    {
        select([](std::size_t) { return true; });
    }

    /// By the joints of the model as it is committed.
    void selectConnected() const
    {
        const std::size_t count = model().sectionCount();
        std::vector<char> isIn(count, char(false));
        std::vector<int> open;
        const auto take = [&](int index) {
            if (index >= 0 && !isIn[static_cast<std::size_t>(index)]) {
                isIn[static_cast<std::size_t>(index)] = char(true);
                open.push_back(index);
            }
        };
        for (const SectionRef &ref : m_interaction.sectionsInFocus())
            take(model().indexOf(ref));
        const Assembly assembly = assemble(model());
        std::vector<std::vector<int>> mates(count);
        for (const Joint &joint : assembly.joints) {
            if (joint.kind == JointKind::None)
                continue;
            mates[static_cast<std::size_t>(joint.a)].push_back(joint.b);
            mates[static_cast<std::size_t>(joint.b)].push_back(joint.a);
        }
        while (!open.empty()) {
            const int next = open.back();
            open.pop_back();
            for (const int mate : mates[static_cast<std::size_t>(next)])
                take(mate);
        }
        select([&](std::size_t index) { return isIn[index] != 0; });
    }

    void selectParallel() const
    {
        std::vector<Vec3> normals;
        for (const SectionRef &ref : m_interaction.sectionsInFocus())
            normals.push_back(model().find(ref)->frame.normal());
        select([&](std::size_t index) {
            const Vec3 normal = model().section(index)->frame.normal();
            return std::any_of(normals.begin(), normals.end(), [&](const Vec3 &other) {
                return normal.cross(other).norm() <= kPracticallyParallel;
            });
        });
    }

    void selectSameStock() const
    {
        std::set<StockId> stocks;
        for (const SectionRef &ref : m_interaction.sectionsInFocus())
            stocks.insert(model().find(ref)->stock);
        select([&](std::size_t index) { return stocks.contains(model().section(index)->stock); });
    }

    Result<void> selectNamed(const CommandParameters &parameters) const
    {
        const auto names = parameters.find("section");
        if (names == parameters.end())
            return failure(ErrorCode::BadValue, "section", {"", "the name of a section"});
        std::vector<SectionRef> refs;
        std::istringstream lines(names->second);
        for (std::string name; std::getline(lines, name);) {
            const auto &all = model().sections();
            const auto found = std::find_if(all.begin(), all.end(), [&name](const auto &section) {
                return section->name == name;
            });
            if (found == all.end())
                return failure(ErrorCode::BadValue, "section", {name, "the name of a section"});
            refs.push_back((*found)->ref());
        }
        m_interaction.select(std::move(refs));
        return {};
    }

    void selectNext() const { step(1); }
    void selectPrevious() const { step(-1); }

private:
    /// To the next one that is seen, in the order of the Outline; after the last one the first.
    void step(int way) const
    {
        const auto count = static_cast<int>(model().sectionCount());
        const std::vector<SectionRef> now = m_interaction.sectionsInFocus();
        int index = now.empty() ? (way > 0 ? -1 : count) : model().indexOf(now.back());
        for (int tried = 0; tried < count; ++tried) {
            index = (index + way + count) % count;
            const SectionRef ref = model().ref(static_cast<std::size_t>(index));
            if (!m_interaction.view().isPicked(ref))
                continue;
            m_interaction.select({ref});
            return;
        }
    }

    const Model &model() const { return m_session.committed(); }

    /// What is not seen is not worked on.
    void select(const std::function<bool(std::size_t)> &isWanted) const
    {
        std::vector<SectionRef> refs;
        for (std::size_t i = 0; i < model().sectionCount(); ++i)
            if (isWanted(i) && m_interaction.view().isPicked(model().ref(i)))
                refs.push_back(model().ref(i));
        m_interaction.select(std::move(refs));
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerSelectionCommands(CommandRegistry &registry, Session &session,
                               Interaction &interaction)
{
    const SelectionCommands commands(session, interaction);
    using Work = void (SelectionCommands::*)() const;
    const auto add = [&](const char *id, Work work, CommandRule rule) {
        registry.add(id, {[commands, work](const CommandParameters &, double) -> Result<void> {
                              (commands.*work)();
                              return {};
                          },
                          std::move(rule)});
    };
    add("edit.selectAll", &SelectionCommands::selectAll, needsSections(session));
    add("edit.selectNext", &SelectionCommands::selectNext, needsSections(session));
    add("edit.selectPrevious", &SelectionCommands::selectPrevious, needsSections(session));
    add("edit.selectConnected", &SelectionCommands::selectConnected, needsSelection(interaction));
    add("edit.selectParallel", &SelectionCommands::selectParallel, needsSelection(interaction));
    add("edit.selectSameStock", &SelectionCommands::selectSameStock, needsSelection(interaction));
    registry.add("edit.select", {[commands](const CommandParameters &parameters, double) {
                     return commands.selectNamed(parameters);
                 }});
    registry.offer(kSelectionWords);
}

} // namespace fff
