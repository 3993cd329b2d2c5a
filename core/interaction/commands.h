// The registry of commands by name: menus, tool bar, keys and recorded scripts all run these, so
// that whatever the window can do a script can do. Ids: ui/UI.md, section 5 ("edit.undo").
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

/// By name, as text: a script has numbers and booleans as text too ("12.7", "true").
using CommandParameters = std::map<std::string, std::string>;

/// The parameter "on", else the other way round than it is.
bool switched(const CommandParameters &parameters, bool isNow);
/// A number among the parameters. Errors  BadValue, place = name, for what is none.
Result<double> numberOf(const CommandParameters &parameters, const std::string &name,
                        double otherwise);

/// Why a command would do nothing now; none: it can run. Parameters that name what it works on may
/// let it run where a press of its button would find nothing.
using WhyNot = std::optional<Text>;
using CommandRule = std::function<WhyNot(const CommandParameters &parameters)>;
/// With this reason while `can` says no.
CommandRule needs(std::function<bool()> can, Text reason);

struct Command
{
    /// time: ms, that of the event which asks for it; animations start there.
    std::function<Result<void>(const CommandParameters &parameters, double time)> run;
    /// Empty: it can always run.
    CommandRule rule = {};
    /// Of a switch or a tool: whether it is on, in the hand. None: at present it is neither. Empty:
    /// it never is.
    std::function<std::optional<bool>()> isOn = {};
    /// What it would do now, where that says more than its text does. Empty, or an empty one: it
    /// does not.
    std::function<Message()> does = {};
};

/// How a person finds a command: in menus, in the tool bar, by its keys.
struct CommandWords
{
    const char *id;
    Text text;             // in menus, with '&' before the key that picks it there
    Text shortText;        // in the tool bar
    const char *shortcuts; // at first; separated by blanks
    const char *icon;
    Text tip;               // the sentence of its tooltip
    bool isForView = false; // its shortcut needs the focus in the view: single keys are free there
    /// The menu at whose end it stands, where no menu names it itself (ui/actions/menu_table.h).
    const char *menu = "";
};

class CommandRegistry
{
public:
    /// Replaces a command with the same id: the window asks about unsaved work where a script does
    /// not.
    void add(std::string id, Command command);
    /// Of commands that people find; they live as long as the program.
    void offer(std::span<const CommandWords> words);

    /// From now on only those that it lets through run and are shown; empty: all of them. What
    /// others say of themselves is this reason.
    void limit(std::function<bool(std::string_view id)> lets, Text reason);

    bool contains(const std::string &id) const;
    /// False for what the limit does not let through.
    bool isShown(const std::string &id) const;
    WhyNot whyNot(const std::string &id, const CommandParameters &parameters = {}) const;
    /// False for an unknown id.
    bool isEnabled(const std::string &id) const;
    std::optional<bool> isOn(const std::string &id) const;
    /// May be empty.
    Message does(const std::string &id) const;
    /// Does nothing when there is a reason why not, as its key does nothing in the window.
    /// Errors  UnknownCommand, and what the command itself says.
    Result<void> run(const std::string &id, const CommandParameters &parameters = {},
                     double time = 0.0) const;
    /// Sorted.
    std::vector<std::string> ids() const;
    /// In the order in which they came.
    const std::vector<const CommandWords *> &offered() const { return m_offered; }

private:
    std::map<std::string, Command> m_commands;
    std::vector<const CommandWords *> m_offered;
    std::function<bool(std::string_view)> m_lets; // empty: all
    Text m_limit;                                 // why not
};

} // namespace fff
