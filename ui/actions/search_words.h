// What else people call a command than its name: the search finds it by that, too.
#pragma once

#include <QString>

#include <span>

namespace fff::ui {

struct SearchWords
{
    const char *id;
    const char *words; // English, separated by blanks
};
std::span<const SearchWords> searchWords();

/// Of a command, in the language of the window and in English; empty: its name says all.
QString searchWordsOf(const QString &id);

} // namespace fff::ui
