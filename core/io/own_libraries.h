// One's own machines and materials, beside those that come with the program.
#pragma once

#include "core/base/result.h"

#include <QtCore/QString>

#include <vector>

namespace fff::io {

/// Adds those of machines.json (machine_library.h) and materials.json (material_library.h) in that
/// folder, as far as these are there, for the rest of the time. To be called before anybody asks
/// for one. Gives what is wrong with the files; such a file adds nothing.
std::vector<Error> addOwnLibraries(const QString &folder);

} // namespace fff::io
