// All keys and what the hand does in the view, to read on a page of the help or on a sheet of paper
// beside the keyboard.
#pragma once

#include "ui/actions/action_finder.h"

#include <QList>
#include <QString>

#include <utility>

namespace fff::ui {

struct KeyGroup
{
    QString title;                           // a menu's
    QList<std::pair<QString, QString>> rows; // what is done, and with what
};

/// First what is done with the mouse, then the keys that are set, by menus.
QList<KeyGroup> keyGroups(const QList<ListedAction> &actions);
/// As a page of the help.
QString keysHtml(const QList<KeyGroup> &groups);
/// One page, A4 or Letter as the country has it, lying. False: the file could not be written.
bool writeCheatSheet(const QString &path, const QList<KeyGroup> &groups);

} // namespace fff::ui
