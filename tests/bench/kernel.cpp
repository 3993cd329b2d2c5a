#include "tests/bench/kernel.h"

#include <QFileInfo>
#include <QProcess>

#include <memory>

namespace fff::bench {

Result<Kernel> Kernel::open(const QString &path)
{
    Kernel kernel;
    kernel.m_program = QFileInfo(path).absoluteFilePath();
    if (QFileInfo(path).suffix() != QStringLiteral("cpp"))
        return kernel;
    kernel.m_folder = std::make_shared<QTemporaryDir>();
    kernel.m_program = kernel.m_folder->filePath(QStringLiteral("kernel"));
    QProcess compiler;
    compiler.start(QStringLiteral("c++"),
                   {QStringLiteral("-O2"), path, QStringLiteral("-o"), kernel.m_program});
    if (!compiler.waitForFinished() || compiler.exitCode() != 0)
        return failure(ErrorCode::CannotOpen, path.toStdString(),
                       {compiler.readAllStandardError().toStdString()});
    return kernel;
}

double Kernel::run() const
{
    QProcess process;
    process.start(m_program, QStringList());
    if (!process.waitForFinished())
        return 0.0;
    return process.readAllStandardOutput().trimmed().toDouble();
}

} // namespace fff::bench
