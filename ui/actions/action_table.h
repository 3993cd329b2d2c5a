// The table of all actions: id, words, shortcut, icon. ActionSet makes a window's actions of it.
// The ids are those of the command registry (core/interaction/commands.h) and of ui/UI.md,
// section 5.
#pragma once

#include <span>

namespace fff::ui {

/// Texts are in English; ActionSet::tr() looks them up.
struct ActionRow
{
    const char *id;
    const char *text;      // in menus
    const char *shortText; // in the tool bar
    const char *shortcuts; // at first; separated by blanks
    const char *icon;
    const char *tip;        // the sentence of its tooltip
    bool isForView = false; // its shortcut needs the focus in the view: single keys are free there
    bool isCheckable = false;
};

std::span<const ActionRow> actionTable();

/// A menu of the menu bar. Ids are separated by blanks; "|" is a separator, "@recent" and "@docks"
/// are what the window puts in their place, ">plane" is the menu with the key "plane", which opens
/// beside it and is none of the bar. Those with "context.…" as their key open in the view.
struct MenuRow
{
    const char *title;
    const char *ids;
    const char *key = nullptr;
};

std::span<const MenuRow> menuTable();

} // namespace fff::ui
