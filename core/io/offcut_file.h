// What is left of a sheet, from a drawing of another program.
#pragma once

#include "core/base/result.h"
#include "core/model/spare_sheet.h"

#include <QtCore/QString>
#include <QtCore/QStringList>

namespace fff::io {

/// The largest closed line of the drawing, true to size, less all that other lines of it enclose:
/// those within it are holes, those over its edge are cut out of it. Lines that end where others
/// begin are one; open ones enclose what they would if they were filled. A line that crosses itself
/// encloses what it winds round (non-zero). Of several pieces the largest is taken.
///
/// remarks  sentences about what a person may not expect, each with the file's name: a size that
///          the file does not say, lines that were open, pieces that were left out
/// Errors  those of reading; EmptyContour, with the file as its place, where no line is closed, or
///         nothing is left; with how far its ends are apart, mm, where the outline itself is open:
///         material would be guessed; BoundariesMeet where a hole touches the edge, or another
///         one, in a point; as spareSheet().
Result<SpareSheet> readOffcut(const QString &path, int count = 1, QStringList *remarks = nullptr);

} // namespace fff::io
