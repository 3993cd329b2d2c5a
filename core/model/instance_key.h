// Keys of the sections that an operation makes: structural, so that they mean the same section
// after an edit. Parts are numbers or words, put together with "/": "3", "-1/12", "0/2/1".
#pragma once

#include <string>
#include <string_view>

namespace fff {

/// The order in which an operation lists what it makes: part by part, numbers by their value, also
/// those that a word ends with, and before words; what begins alike and is shorter comes first. A
/// strict weak order, total for different keys.
bool isKeyBefore(std::string_view a, std::string_view b);

/// One key below another.
std::string keyBelow(std::string_view key, std::string_view part);
std::string keyBelow(std::string_view key, long part);

} // namespace fff
