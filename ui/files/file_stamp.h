// What a file on disk was like when it was read or written, to notice that another program has
// changed it since.
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

namespace fff::ui {

class FileStamp
{
public:
    FileStamp() = default; // of no file
    /// Reads the file once, for its contents' hash.
    static FileStamp of(const QString &path);

    /// Of an earlier state that nobody knows: any file at that path differs from it.
    static FileStamp outdated(const QString &path);

    /// False when there is a file at that path now with other contents. A file that is gone, or was
    /// only touched, has not changed: nothing in it could be lost.
    bool isCurrent() const;

private:
    QString m_path;
    QDateTime m_modified;
    qint64 m_size = -1;
    QByteArray m_hash;
};

} // namespace fff::ui
