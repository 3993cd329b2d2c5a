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

/// What numberedFiles() of more contents has left beside `count` of them: files of higher numbers,
/// up to kMostLeft, in their order. They may be anybody's.
std::vector<QString> olderFiles(const QString &path, std::size_t count, const QString &usual);

/// Nobody cuts as many sheets; higher numbers are years and the like.
inline constexpr std::size_t kMostLeft = 999;

/// All of them or none: everything is on the disk under temporary names before the first is put in
/// its place. Errors  CannotWrite with the path and the system's reason; what was there before is
/// there again.
Result<void> writeFiles(const std::vector<NamedBytes> &files);

} // namespace fff::io
