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

/// So that names of so many files sort as their numbers do; two at least.
int digitsFor(std::size_t count);

/// OUT.svg -> OUT-1.svg, OUT-2.svg, … in their order.
/// usual   the suffix that they get without one
/// digits  of each number at least, so that names sort as the numbers do
std::vector<NamedBytes> numberedFiles(const QString &path, const std::vector<std::string> &contents,
                                      const QString &usual, int digits = 1);

/// All of them or none: everything is on the disk under temporary names before the first is put in
/// its place. Errors  CannotWrite with the path and the system's reason; what was there before is
/// there again.
Result<void> writeFiles(const std::vector<NamedBytes> &files);

} // namespace fff::io
