// Sentences as a person reads them, in English and without a window.
#pragma once

#include "core/base/message.h"

#include <string>
#include <type_traits>

namespace fff::test {

inline std::string said(const Message &message)
{
    std::string sentence;
    const std::string source = message.text.source ? message.text.source : "";
    for (std::size_t i = 0; i < source.size(); ++i) {
        const bool isPlace = source[i] == '%' && i + 1 < source.size() && source[i + 1] >= '1' &&
                             source[i + 1] <= '9';
        if (!isPlace) {
            sentence += source[i];
            continue;
        }
        const auto which = static_cast<std::size_t>(source[++i] - '1');
        if (which >= message.arguments.size())
            return "a place without an argument: " + source;
        const auto words = [](const auto &argument) -> std::string {
            using T = std::decay_t<decltype(argument)>;
            if constexpr (std::is_same_v<T, int>)
                return std::to_string(argument);
            else if constexpr (std::is_same_v<T, Named>)
                return argument.name;
            else if constexpr (std::is_same_v<T, Text>)
                return argument.source;
            else if constexpr (std::is_same_v<T, Message>)
                return said(argument);
            else if constexpr (std::is_same_v<T, Decimal> || std::is_same_v<T, Quantity>)
                return std::to_string(argument.value);
            else
                return "something else";
        };
        sentence +=
            std::visit(words, static_cast<const Argument::variant &>(message.arguments[which]));
    }
    return sentence;
}

} // namespace fff::test
