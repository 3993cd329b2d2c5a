// What stands where in the menus. Ids are those of the command registry
// (core/interaction/commands.h) and of ui/UI.md, section 5.
#pragma once

#include <span>

namespace fff::ui {

/// A menu of the menu bar. Ids are separated by blanks; "|" is a separator, "@recent", "@docks"
/// and "@rename" are what the window puts in their place, ">plane" is the menu with the key
/// "plane", which opens beside it and is none of the bar. Those with "context.…" as their key open
/// in the view. A command that no row has stands at the end of the menu that its words name. Menus
/// with the key kSearchedMenu are not seen: the search and the shortcuts have what is in them,
/// under their title.
struct MenuRow
{
    const char *title; // in English; ActionSet::tr() looks it up
    const char *ids;
    const char *key = nullptr;
};

inline constexpr char kSearchedMenu[] = "searched";

std::span<const MenuRow> menuTable();

} // namespace fff::ui
