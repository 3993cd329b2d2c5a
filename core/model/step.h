// What a commit did, for the history.
#pragma once

#include "core/base/message.h"

#include <string>
#include <utility>
#include <vector>

namespace fff {

/// "Draw Section 3". Its texts stand with what says them, in the namespace steps.
struct Step
{
    Message words;
    /// Not empty: with a step before it of the same it makes one (an arrow key pressed again).
    std::string merges;

    Step() = default;
    Step(Message message) : words(std::move(message)) {}
    Step(Text text, std::vector<Argument> arguments = {}) : words{text, std::move(arguments)} {}
};

/// Of what can be done to one and to several.
struct CountedText
{
    Text one;  // with %1, its name
    Text many; // with %n
};

/// "Move Section 3", "Move 4 sections". One is named, so that the texts with a number need no
/// singular.
Message ofSections(const CountedText &texts, const std::vector<std::string> &names);
/// The same of parts of one: "Move 3 points of Section 2".
Message ofParts(const CountedText &texts, const std::string &name, std::size_t count);

} // namespace fff
