// The letters to press in a menu, for languages whose texts mark none: with a translation in hand
// nobody has to find one for each entry that no other entry beside it has.
#pragma once

#include <QStringList>

namespace fff::ui {

/// The texts of one menu, each with its key behind '&'; those that have one keep it. A letter of
/// the text, if there is one that no other text has: the one that the English text has, else the
/// first of a word, else any. Where the writing has no such letters (Japanese, Chinese) the English
/// key stands behind the text in parentheses, as is the custom there.
///
/// sources  the English texts, as many
QStringList withMenuKeys(const QStringList &texts, const QStringList &sources);

} // namespace fff::ui
