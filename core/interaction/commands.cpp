#include "core/interaction/commands.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

namespace fff {

bool switched(const CommandParameters &parameters, bool isNow)
{
    const auto found = parameters.find("on");
    return found == parameters.end() ? !isNow : found->second == "true" || found->second == "1";
}

Result<double> numberOf(const CommandParameters &parameters, const std::string &name,
                        double otherwise)
{
    const auto found = parameters.find(name);
    if (found == parameters.end())
        return otherwise;
    const std::string &text = found->second;
    double number = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(number))
        return failure(ErrorCode::BadValue, name, {text, "a number"});
    return number;
}

CommandRule needs(std::function<bool()> can, Text reason)
{
    return [can = std::move(can), reason](const CommandParameters &) {
        return can() ? WhyNot() : WhyNot(reason);
    };
}

void CommandRegistry::add(std::string id, Command command)
{
    assert(command.run && "a command does something");
    m_commands.insert_or_assign(std::move(id), std::move(command));
}

void CommandRegistry::offer(std::span<const CommandWords> words)
{
    // A command that is added anew has one set of words, and one action.
    for (const CommandWords &each : words)
        if (!std::ranges::count(m_offered, &each))
            m_offered.push_back(&each);
}

void CommandRegistry::limit(std::function<bool(std::string_view id)> lets, Text reason)
{
    m_lets = std::move(lets);
    m_limit = reason;
}

bool CommandRegistry::isShown(const std::string &id) const
{
    return !m_lets || m_lets(id);
}

bool CommandRegistry::contains(const std::string &id) const
{
    return m_commands.count(id) > 0;
}

WhyNot CommandRegistry::whyNot(const std::string &id, const CommandParameters &parameters) const
{
    if (!isShown(id))
        return m_limit;
    const auto found = m_commands.find(id);
    if (found == m_commands.end() || !found->second.rule)
        return {};
    return found->second.rule(parameters);
}

bool CommandRegistry::isEnabled(const std::string &id) const
{
    return contains(id) && !whyNot(id);
}

std::optional<bool> CommandRegistry::isOn(const std::string &id) const
{
    const auto found = m_commands.find(id);
    if (found == m_commands.end() || !found->second.isOn)
        return {};
    return found->second.isOn();
}

Message CommandRegistry::does(const std::string &id) const
{
    const auto found = m_commands.find(id);
    if (found == m_commands.end() || !found->second.does)
        return {};
    return found->second.does();
}

Result<void> CommandRegistry::run(const std::string &id, const CommandParameters &parameters,
                                  double time) const
{
    const auto found = m_commands.find(id);
    if (found == m_commands.end())
        return failure(ErrorCode::UnknownCommand, id, {id});
    if (whyNot(id, parameters))
        return {};
    return found->second.run(parameters, time);
}

std::vector<std::string> CommandRegistry::ids() const
{
    std::vector<std::string> result;
    for (const auto &[id, command] : m_commands)
        result.push_back(id);
    return result;
}

} // namespace fff
