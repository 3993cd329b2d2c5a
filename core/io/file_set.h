// Several files that belong together.
#pragma once

#include "core/base/result.h"

#include <QtCore/QString>

#include <string>
#include <vector>

namespace fff::io {

struct NamedBytes
{
    QString path;
    std::string bytes;
};

/// OUT.svg -> OUT-1.svg, OUT-2.svg, … in their order. Without a suffix they get that of drawings.
std::vector<NamedBytes> numberedFiles(const QString &path,
                                      const std::vector<std::string> &contents);

/// All of them or none: everything is on the disk under temporary names before the first is put in
/// its place. Errors  CannotWrite with the path and the system's reason; what was there before is
/// there again.
Result<void> writeFiles(const std::vector<NamedBytes> &files);

} // namespace fff::io
