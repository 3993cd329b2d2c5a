// Things whose weight is known, to put on a model: a resource file has them, so that one more is a
// line there.
#pragma once

#include "core/model/load.h"

#include <QString>

#include <vector>

namespace fff::ui {

struct LoadPreset
{
    std::string key;
    QString name;       // in the language of the window
    double mass = 0.1;  // kg, empty
    double holds = 0.0; // kg of water; 0: it is no vessel
    double filled = 0.0;
    double height = 0.0; // mm, as of a Load
    Spread spread = Spread::Point;
    double width = 20.0; // mm
};

/// In the order in which they are offered.
const std::vector<LoadPreset> &loadPresets();
/// Null for one that is not among them.
const LoadPreset *loadPreset(const std::string &key);

/// The load as such a thing; where it is and what it is called stay, unless its name is that of the
/// thing it was.
Load taken(const LoadPreset &preset, Load load);

} // namespace fff::ui
