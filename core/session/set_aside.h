// Models at which the program broke, kept for a report.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

#include <QString>

#include <string_view>

namespace fff {

/// Writes the document into the folder, named after the stage and the time; of those that are there
/// the newest kMostReports stay. Returns its path. Errors  those of io::writeFile.
Result<QString> setAside(const QString &folder, const Document &document, std::string_view stage,
                         const Error &why);

inline constexpr int kMostReports = 10;

} // namespace fff
