// What letters are to whoever reads what people type, in any language.
#pragma once

#include <string>
#include <string_view>

namespace fff {

/// Also those of print, which stand between a number and its unit.
bool isBlank(char32_t c);
/// 0 … 9.
bool isDigit(char32_t c);
/// Beyond ASCII all that is in none of the blocks of signs: what is quoted is a whole word in any
/// language.
bool isLetter(char32_t c);
/// Of a name; a digit may follow it.
bool isNameLetter(char32_t c);
/// Small: of Latin, Greek and Cyrillic letters that differ in nothing else; others stay.
char32_t folded(char32_t c);
/// UTF-8. Names that are alike but for capitals are the same.
std::string foldedName(std::string_view name);

} // namespace fff
