// The fixed piece of work by which timings of different machines are compared.
#pragma once

#include "core/base/result.h"

#include <QString>
#include <QTemporaryDir>

namespace fff::bench {

class Kernel
{
public:
    /// path: a program that prints its milliseconds, or its C++ source, which is compiled with
    /// -O2 into a temporary folder. Errors  CannotOpen with the compiler's words.
    static Result<Kernel> open(const QString &path);

    /// Runs it once, as a process of its own. Milliseconds, 0 when it fails.
    double run() const;

private:
    QString m_program;
    std::shared_ptr<QTemporaryDir> m_folder; // of what was compiled
};

} // namespace fff::bench
