// Machines from JSON: those that come with the program, and one's own.
#pragma once

#include "core/base/result.h"
#include "core/fabrication/machine.h"

#include <QtCore/QString>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

/// {"colours": {NAME: {...}}, "machines": [{...}]}
///
///   colours   by purpose "#rrggbb": engrave, numbers, score, innerCut, outerCut, guide (null: the
///             machine burns what it is given, so nothing else is in its files); stroke, mm
///   machines  key, name, bed [width, height] mm, colours (a NAME). As they are usual where not
///             said: speeds {engrave, score, cut, travel} mm/s; powers {engrave, score, cut}
///             0 … 1; layers of LightBurn by purpose, 0 … 31; finish
///             {tabs, tabWidth mm, lead mm, sharesCuts} of cuts; gcode {head, sheet, foot: lists of
///             lines; on, off; mostPower}
///
/// Members of other names are passed over. At most 1000 machines of 100 lines of G-code.
/// name    how errors call the file
/// Errors  as parseJson(); BadValue, UnknownReference, DuplicateId (a key), BadCount, with where in
///         the file
Result<std::vector<Machine>> readMachines(std::string_view bytes, const std::string &name);

/// Those that come with the program, the usual one first, then one's own.
std::span<const std::shared_ptr<const Machine>> machineLibrary();
/// For the rest of the time; one of a key that is there already comes in place of that.
void addOwnMachines(std::vector<Machine> own);

/// By its key, whatever the case, or the first one of a file whose name ends in .json.
/// Errors  UnknownReference with the key; as readFile() and readMachines().
Result<std::shared_ptr<const Machine>> machineNamed(const QString &keyOrFile);

} // namespace fff::io
