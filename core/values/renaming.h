// Names of values in what people typed: where they are, and other ones in their places.
#pragma once

#include "core/values/expression_error.h"
#include "core/values/worth.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

/// Ascending; no functions and no units. Also of a text that cannot be read, as far as its words
/// tell.
std::vector<TextRange> namePlaces(std::string_view text, ValueKind kind);

/// By the folded name.
using Renames = std::map<std::string, std::string, std::less<>>;
/// All at once, so that two names may change places. The rest stays as it was typed.
std::string renamedIn(std::string_view text, ValueKind kind, const Renames &renames);

/// Of "yes" and "no", "true" and "false", "on" and "off", capitals or not; else nothing. They are
/// typed where a switch is, and name nothing.
std::optional<bool> switchWord(std::string_view text);

inline constexpr std::size_t kLongestName = 40; // letters

/// Errors  what is no name: it begins with a letter or _ and has letters of any language, digits
/// and _; what would be read as something else: the thickness "t", a unit, a function, "pi", "yes".
Understood<void> checkName(std::string_view name);
/// The name, or with a number behind it, so that none of the taken ones is like it; one that
/// checkName() takes. isTaken  of a folded name.
std::string freeName(std::string_view name,
                     const std::function<bool(const std::string &)> &isTaken);

} // namespace fff
