// --set NAME=VALUE or --set PRESET: named values of a model for one run.
#pragma once

#include "app/cli/command_line.h"
#include "core/model/bindings.h"

namespace fff::cli {

/// What is typed on the command line: mm, degrees and kg where it has no unit.
Reading typedReading();

/// The document in agreement with these values; each is NAME=VALUE or the name of a preset, and the
/// last of a name counts.
/// What is wrong with one, or what the model would not bear, is one sentence.
tl::expected<Document, QString> withValues(const Document &document, const QStringList &settings);

/// A sentence for each value that has no worth and each number that does not follow what was typed
/// for it: all numbers are then as they last were.
QStringList notFollowing(const Document &document);

} // namespace fff::cli
