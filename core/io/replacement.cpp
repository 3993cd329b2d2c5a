#include "core/io/replacement.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QRandomGenerator>
#include <QtCore/QSaveFile>
#include <cerrno>
#include <cstdio>
#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#else
#include <windows.h>
#endif

namespace fff::io {

namespace {

/// What a chain of symbolic links ends at, there or not.
QString behindLinks(const QString &path)
{
    constexpr int kLongestChain = 40; // as the system has it
    QString target = path;
    for (int i = 0; i < kLongestChain && QFileInfo(target).isSymLink(); ++i)
        target = QFileInfo(target).symLinkTarget();
    return target;
}

} // namespace

QString systemReason(int number)
{
#ifdef Q_OS_UNIX
    const bool isFull = number == ENOSPC;
#else
    const bool isFull = number == ERROR_DISK_FULL || number == ERROR_HANDLE_DISK_FULL;
#endif
    return isFull ? QString(QLatin1String(QT_TRANSLATE_NOOP("Error", "the disk is full")))
                  : qt_error_string(number);
}

bool isRefusal(int number)
{
#ifdef Q_OS_UNIX
    return number == EACCES || number == EPERM || number == EROFS;
#else
    return number == ERROR_ACCESS_DENIED || number == ERROR_WRITE_PROTECT;
#endif
}

#ifdef Q_OS_UNIX

namespace {

constexpr int kMostNames = 100; // that are tried where they are taken

/// "fish.fff.k3xq7a" beside "fish.fff".
QByteArray nameBeside(const QString &target)
{
    constexpr int kLetters = 6;
    QString name = target + u'.';
    for (int i = 0; i < kLetters; ++i)
        name += QLatin1Char(
            "abcdefghijklmnopqrstuvwxyz0123456789"[QRandomGenerator::global()->bounded(36)]);
    return QFile::encodeName(name);
}

/// Calls act(name) with one name after the other until one is free. 0, or the system's error.
template <class Act>
int withFreeName(const QString &target, QByteArray &name, Act act)
{
    for (int i = 0; i < kMostNames; ++i) {
        name = nameBeside(target);
        if (act(name.constData()))
            return 0;
        if (errno != EEXIST)
            break;
    }
    const int number = errno;
    name.clear();
    return number;
}

} // namespace

struct Replacement::File
{
    int handle = -1;
    int number = 0;  // why there is none
    QByteArray name; // empty: none yet, or no more

    void openUnnamed(const QString &folder);
    void open(const QString &target);
    int giveName(const QString &target);
};

void Replacement::File::openUnnamed(const QString &folder)
{
#ifdef O_TMPFILE
    // Its name is given through this folder later.
    if (::access("/proc/self/fd", X_OK) == 0)
        handle =
            ::open(QFile::encodeName(folder).constData(), O_RDWR | O_CLOEXEC | O_TMPFILE, 0666);
#else
    Q_UNUSED(folder)
#endif
}

void Replacement::File::open(const QString &target)
{
    // A file that nobody may write to is not to be replaced either.
    if (::access(QFile::encodeName(target).constData(), W_OK) != 0 && errno != ENOENT) {
        number = errno;
        return;
    }
    openUnnamed(QFileInfo(target).path());
    if (handle < 0)
        number = withFreeName(target, name, [this](const char *free) {
            handle = ::open(free, O_RDWR | O_CLOEXEC | O_CREAT | O_EXCL, 0666);
            return handle >= 0;
        });
    struct stat old = {};
    if (handle >= 0 && ::stat(QFile::encodeName(target).constData(), &old) == 0)
        ::fchmod(handle, old.st_mode & 07777);
}

int Replacement::File::giveName(const QString &target)
{
    const QByteArray from = "/proc/self/fd/" + QByteArray::number(handle);
    return withFreeName(target, name, [&from](const char *free) {
        return ::linkat(AT_FDCWD, from.constData(), AT_FDCWD, free, AT_SYMLINK_FOLLOW) == 0;
    });
}

Replacement::Replacement(const QString &path)
    : m_target(behindLinks(path)), m_file(std::make_unique<File>())
{
    m_file->open(m_target);
}

Replacement::~Replacement()
{
    if (!m_file->name.isEmpty())
        ::unlink(m_file->name.constData());
    if (m_file->handle >= 0)
        ::close(m_file->handle);
}

int Replacement::write(const std::string &bytes)
{
    if (m_file->handle < 0)
        return m_file->number;
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::write(m_file->handle, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno != EINTR)
            return errno;
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return 0;
}

int Replacement::putOnDisk()
{
    // Some file systems know no such thing.
    const bool isDone =
        ::fsync(m_file->handle) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
    return isDone ? 0 : errno;
}

int Replacement::commit()
{
    if (m_file->name.isEmpty()) {
        if (const int number = m_file->giveName(m_target))
            return number;
    }
    if (std::rename(m_file->name.constData(), QFile::encodeName(m_target).constData()) != 0)
        return errno;
    m_file->name.clear();
    return 0;
}

#else

namespace {

/// Why the call before failed. Some fail without the system having said anything.
int lastError()
{
    const DWORD number = GetLastError();
    return number != ERROR_SUCCESS ? static_cast<int>(number) : ERROR_WRITE_FAULT;
}

} // namespace

struct Replacement::File : QSaveFile
{
    using QSaveFile::QSaveFile;

    int number = 0; // why it could not be opened
};

Replacement::Replacement(const QString &path)
    : m_target(behindLinks(path)), m_file(std::make_unique<File>(m_target))
{
    if (!m_file->open(QIODevice::WriteOnly))
        m_file->number = lastError();
}

Replacement::~Replacement() = default;

int Replacement::write(const std::string &bytes)
{
    if (!m_file->isOpen())
        return m_file->number;
    const auto size = static_cast<qint64>(bytes.size());
    return m_file->write(bytes.data(), size) == size && m_file->flush() ? 0 : lastError();
}

int Replacement::putOnDisk()
{
    return 0; // commit() does
}

int Replacement::commit()
{
    return m_file->commit() ? 0 : lastError();
}

#endif

} // namespace fff::io
