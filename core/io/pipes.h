// Reading and writing what is no file on a disk: pipes and devices. Internal to io.
#pragma once

#include "core/base/result.h"

#include <QtCore/QFile>
#include <QtCore/QString>
#include <cstdint>
#include <string>

namespace fff::io {

/// All that comes out of a pipe or a device until it ends, at most `most` bytes and one. Never
/// waits for ever: a pipe that nobody writes into is given up after a second, one from which
/// nothing comes after ten.
/// place  how errors call it
/// Errors  CannotOpen, with the reason.
Result<std::string> readPipe(const QString &path, std::int64_t most, const std::string &place);

/// Opens a pipe or a device to write into: a pipe that nobody reads is given up after a second.
/// Errors  CannotWrite, with the reason.
Result<void> openForWriting(const QString &path, QFile &file);

} // namespace fff::io
