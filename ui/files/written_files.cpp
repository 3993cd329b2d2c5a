#include "ui/files/written_files.h"

#include "ui/settings/settings.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace fff::ui {

namespace {

const QString kWrittenKey = QStringLiteral("export/written");
constexpr qsizetype kFields = 3; // model, path, hash: newest first

/// Of what is in a file and where it lies: a link may lead elsewhere by now, to a copy.
QByteArray hashOfFile(const QString &path)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QFileInfo(path).canonicalFilePath().toUtf8());
    return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result().toHex()
                                                                 : QByteArray(); // unreadable
}

} // namespace

void WrittenFiles::remember(const QString &model, const std::vector<io::NamedBytes> &files)
{
    QStringList next;
    for (const io::NamedBytes &file : files) {
        const QByteArray hash = hashOfFile(file.path);
        m_written.insert(file.path, hash);
        next += {model, file.path, QString::fromLatin1(hash)};
    }
    if (model.isEmpty())
        return;
    const QStringList kept = settings().memory(kWrittenKey).toStringList();
    for (qsizetype i = 0; i + kFields <= kept.size(); i += kFields) {
        const bool isNewer = kept[i] == model && m_written.contains(kept[i + 1]);
        if (!isNewer && next.size() < kFields * kMostWritten)
            next += kept.mid(i, kFields);
    }
    settings().setMemory(kWrittenKey, next);
}

bool WrittenFiles::isOurs(const QString &model, const QString &path) const
{
    QByteArray written = m_written.value(path);
    const QStringList kept = settings().memory(kWrittenKey).toStringList();
    for (qsizetype i = 0; written.isEmpty() && !model.isEmpty() && i + kFields <= kept.size();
         i += kFields)
        if (kept[i] == model && kept[i + 1] == path)
            written = kept[i + 2].toLatin1();
    return !written.isEmpty() && hashOfFile(path) == written;
}

} // namespace fff::ui
