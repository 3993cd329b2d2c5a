// The registry of commands by name: menus, tool bar, keys and recorded scripts all run these, so
// that whatever the window can do a script can do. Ids: ui/UI.md, section 5 ("edit.undo").
#pragma once

#include "core/base/result.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace fff {

/// By name, as text: a script has numbers and booleans as text too ("12.7", "true").
using CommandParameters = std::map<std::string, std::string>;

/// The parameter "on", else the other way round than it is.
bool switched(const CommandParameters &parameters, bool isNow);
/// A number among the parameters. Errors  BadValue, place = name, for what is none.
Result<double> numberOf(const CommandParameters &parameters, const std::string &name,
                        double otherwise);

struct Command
{
    /// time: ms, that of the event which asks for it; animations start there.
    std::function<Result<void>(const CommandParameters &parameters, double time)> run;
    /// Whether it would do something now. Empty: always.
    std::function<bool()> isEnabled;
};

class CommandRegistry
{
public:
    /// Replaces a command with the same id: the window asks about unsaved work where a script does
    /// not.
    void add(std::string id, Command command);

    bool contains(const std::string &id) const;
    /// False for an unknown id.
    bool isEnabled(const std::string &id) const;
    /// Does nothing when the command is not enabled, as its key does nothing in the window.
    /// Errors  UnknownCommand, and what the command itself says.
    Result<void> run(const std::string &id, const CommandParameters &parameters = {},
                     double time = 0.0) const;
    /// Sorted.
    std::vector<std::string> ids() const;

private:
    std::map<std::string, Command> m_commands;
};

} // namespace fff
