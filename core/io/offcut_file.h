// What is left of a sheet, from a drawing of another program.
#pragma once

#include "core/base/result.h"
#include "core/model/spare_sheet.h"

#include <QtCore/QString>

namespace fff::io {

/// The largest closed line of the drawing, true to size, with the closed lines in it as holes; all
/// else of it is passed over. Lines that end where others begin are one.
/// Errors  those of reading; EmptyContour, with the file as its place, where no line is closed; as
///         spareSheet().
Result<SpareSheet> readOffcut(const QString &path, int count = 1);

} // namespace fff::io
