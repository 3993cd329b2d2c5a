// What the program had to complain of, in a file that one can send: "log.txt" in the folder of a
// person's data. The program itself sends nothing anywhere.
#pragma once

#include <QString>

namespace fff::ui {

/// At this size the file becomes "log-before.txt" at the next start, bytes.
inline constexpr qint64 kLongLog = 256 * 1024;

/// Messages of Qt and of the program go into the file from now on, a line each, and to where they
/// went before, too. Once; from any thread. A folder that cannot be written has no log.
void keepLog(const QString &folder);

/// A line in the file alone.
void noteInLog(const QString &line);

/// The last lines of it; empty without a log.
QString endOfLog(int lines);

} // namespace fff::ui
