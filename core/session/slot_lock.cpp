#include "core/session/slot_lock.h"

#include <QFile>
#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#else
#include <QLockFile>
#endif

namespace fff {

#ifdef Q_OS_UNIX

namespace {

// Who asks whether a lock is held has it for a moment: it is tried again after one.
constexpr int kTries = 20;
constexpr unsigned kMoment = 2'000; // µs

class OpenFile
{
public:
    /// place: its path, or the folder of one that has no name yet.
    OpenFile(const QString &path, int flags, const QString &place)
        : m_name(QFile::encodeName(path)),
          m_handle(::open(QFile::encodeName(place).constData(), flags | O_CLOEXEC, 0666))
    {
    }
    OpenFile(const QString &path, int flags) : OpenFile(path, flags, path) {}
    ~OpenFile()
    {
        if (m_handle >= 0)
            ::close(m_handle);
    }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;

    bool isOpen() const { return m_handle >= 0; }
    const QByteArray &name() const { return m_name; }
    /// False when somebody else has it.
    bool lock(int kind) const
    {
        return ::flock(m_handle, kind | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    }
    /// Gives one without a name its name. False when another file has it, or it cannot be done.
    bool giveName() const
    {
        const QByteArray from = "/proc/self/fd/" + QByteArray::number(m_handle);
        return ::linkat(AT_FDCWD, from.constData(), AT_FDCWD, m_name.constData(),
                        AT_SYMLINK_FOLLOW) == 0;
    }
    /// Not taken away, with its lock, by who held it before.
    bool isThere() const
    {
        struct stat here = {}, there = {};
        return ::fstat(m_handle, &here) == 0 && ::stat(m_name.constData(), &there) == 0 &&
               here.st_ino == there.st_ino && here.st_dev == there.st_dev;
    }

private:
    QByteArray m_name;
    int m_handle;
};

} // namespace

struct SlotLock::File : OpenFile
{
    using OpenFile::OpenFile;
};

namespace {

/// A lock that is held before it has its name: nobody ever sees it free and takes it away.
template <class File>
std::unique_ptr<File> makeHeld(const QString &path)
{
#ifdef O_TMPFILE
    auto file = std::make_unique<File>(path, O_RDWR | O_TMPFILE, QFileInfo(path).path());
    if (file->isOpen() && file->lock(LOCK_EX) && file->giveName())
        return file;
#endif
    return nullptr;
}

/// The lock that is there, or else a new one.
template <class File>
std::unique_ptr<File> hold(const QString &path)
{
    auto file = std::make_unique<File>(path, O_RDWR);
    if (!file->isOpen() && errno == ENOENT) {
        if (auto made = makeHeld<File>(path))
            return made;
        file = std::make_unique<File>(path, O_RDWR | O_CREAT);
    }
    return file->isOpen() && file->lock(LOCK_EX) && file->isThere() ? std::move(file) : nullptr;
}

} // namespace

SlotLock::SlotLock(const QString &path) : m_path(path) {}

SlotLock::~SlotLock()
{
    if (m_file) // first taken away: nobody else may have it by then
        ::unlink(m_file->name().constData());
}

bool SlotLock::tryLock()
{
    for (int i = 0; i < kTries; ++i) {
        if (i > 0)
            ::usleep(kMoment);
        m_file = hold<File>(m_path);
        if (m_file)
            return true;
    }
    return false;
}

bool SlotLock::isHeld(const QString &path)
{
    const OpenFile file(path, O_RDONLY);
    return file.isOpen() && !file.lock(LOCK_SH);
}

#else

struct SlotLock::File : QLockFile
{
    using QLockFile::QLockFile;
};

SlotLock::SlotLock(const QString &path) : m_path(path) {}

SlotLock::~SlotLock() = default;

bool SlotLock::tryLock()
{
    auto file = std::make_unique<File>(m_path);
    file->setStaleLockTime(0); // stale when its program is gone, however long it runs
    if (!file->tryLock(0))
        return false;
    m_file = std::move(file);
    return true;
}

bool SlotLock::isHeld(const QString &path)
{
    return QFile::exists(path) && !SlotLock(path).tryLock();
}

#endif

} // namespace fff
