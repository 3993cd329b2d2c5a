#include "core/session/set_aside.h"

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_file.h"

#include <QDateTime>
#include <QDir>

namespace fff {

Result<QString> setAside(const QString &folder, const Document &document, std::string_view stage,
                         const Error &why)
{
    QDir dir(folder);
    if (!dir.mkpath(QStringLiteral(".")))
        return failure(ErrorCode::CannotWrite, folder.toStdString());
    const QString name = QStringLiteral("%1-%2").arg(
        QString::fromLatin1(stage.data(), static_cast<qsizetype>(stage.size())),
        QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz")));
    const Result<std::string> bytes = io::writeFffFile(document);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const QString path = dir.filePath(name + QStringLiteral(".fff"));
    if (const auto written = io::writeFile(path, *bytes); !written)
        return tl::unexpected(written.error());
    // What it said goes beside it; without that the model alone has to do.
    (void)io::writeFile(dir.filePath(name + QStringLiteral(".txt")),
                        io::errorText(why).toStdString() + "\n");
    const QStringList all = dir.entryList({QStringLiteral("*.fff")}, QDir::Files, QDir::Time);
    for (const QString &old : all.mid(kMostReports)) {
        dir.remove(old);
        dir.remove(old.chopped(4) + QStringLiteral(".txt"));
    }
    return path;
}

} // namespace fff
