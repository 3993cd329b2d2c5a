#include "ui/files/file_stamp.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace fff::ui {

FileStamp FileStamp::of(const QString &path)
{
    FileStamp stamp;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return stamp;
    QCryptographicHash hash(QCryptographicHash::Sha1);
    if (!hash.addData(&file))
        return stamp;
    const QFileInfo info(path);
    stamp.m_path = path;
    stamp.m_modified = info.lastModified();
    stamp.m_size = info.size();
    stamp.m_hash = hash.result();
    return stamp;
}

FileStamp FileStamp::outdated(const QString &path)
{
    FileStamp stamp;
    stamp.m_path = path;
    return stamp;
}

bool FileStamp::isCurrent() const
{
    if (m_path.isEmpty())
        return true;
    const QFileInfo info(m_path);
    if (!info.exists() || (info.size() == m_size && info.lastModified() == m_modified))
        return true;
    return of(m_path).m_hash == m_hash;
}

} // namespace fff::ui
