// What a person reads when a file could not be read or written: what happened, where, what to do.
#pragma once

#include "core/base/result.h"

#include <QString>

namespace fff::ui {

/// One sentence or two, about the file's name; the path and the place in it are for the details.
QString openFailure(const QString &path, const Error &error);
QString saveFailure(const QString &path, const Error &error);
/// All there is to know, for whoever looks into it.
QString failureDetails(const QString &path, const Error &error);

} // namespace fff::ui
