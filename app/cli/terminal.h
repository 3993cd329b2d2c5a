// What people and other programs read of the verbs: standard output and standard error. All text
// goes through here.
#pragma once

#include <QString>
#include <QStringList>

#include <string>

namespace fff::cli {

/// As one line that does nothing to a terminal: names come from files, which anybody may have made,
/// and each control character in them becomes its picture (␊, ␀, ␛), or U+FFFD where it has none.
QString asLine(const QString &text);

/// One line on standard error.
void printError(const QString &line);
/// Lines on standard output. CannotWrite when it was closed.
int printLines(const QStringList &lines);
/// Bytes that are for programs, or hold nothing of a file, as they are. CannotWrite likewise.
int print(const std::string &bytes);

} // namespace fff::cli
