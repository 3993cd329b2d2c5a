// Finds actions by words: for the search and for the editor of shortcuts. Works on what the menus
// hold, so that whatever a menu offers can be found.
#pragma once

#include <QList>
#include <QPointer>
#include <QString>

class QAction;
class QMenuBar;

namespace fff::ui {

struct ListedAction
{
    QPointer<QAction> action;
    QString name;      // as in its menu, without marks
    QString menuPath;  // "File", "File › Open recent"
    QString id;        // "file.open"; not of every action
    QString does = {}; // a sentence, where there is one
    QString also = {}; // what else people call it, separated by blanks (search_words.h)
};

/// In the order of the menus, without separators.
QList<ListedAction> listedActions(const QMenuBar &menus);

/// How well it fits; negative when it does not, 0 when it is a guess. Every word of the query must
/// be found: in the name, else as the beginning of what else it is called, else in the menu's path
/// or the id, else as the beginning of a word in what the action does, else its letters in their
/// order in the name. Upper case and accents do not
/// matter. An empty query fits all alike.
int matchScore(const QString &query, const ListedAction &action);

/// Those that fit, the best first; alike ones keep their order. Scattered letters count only where
/// no word is found as it was typed.
QList<ListedAction> foundActions(const QString &query, const QList<ListedAction> &actions);

} // namespace fff::ui
