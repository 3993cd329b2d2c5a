// A number that a person gave a name, to be used wherever a number is typed.
#pragma once

#include <string>

namespace fff {

struct NamedNumber
{
    std::string name;       // a letter or _, then letters, digits and _; no two alike
    std::string expression; // as typed
    double value = 0.0;     // what it was worth: a plain number, mm where a length is wanted

    bool operator==(const NamedNumber &) const = default;
};

} // namespace fff
