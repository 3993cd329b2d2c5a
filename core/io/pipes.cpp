#include "core/io/pipes.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <cerrno>
#include <chrono>
#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#endif

namespace fff::io {

namespace {

tl::unexpected<Error> cannot(const std::string &place, const QString &reason)
{
    return failure(ErrorCode::CannotOpen, place, {reason.toStdString()});
}

#ifdef Q_OS_UNIX
constexpr int kForWriter = 1'000;          // ms, for someone to open the other end
constexpr unsigned kBetweenTries = 10'000; // µs
constexpr int kForMore = 10'000;           // ms, while someone holds it
constexpr std::size_t kChunk = 1 << 16;

class Descriptor
{
public:
    explicit Descriptor(const QString &path)
        : m_number(::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
    {
    }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    ~Descriptor()
    {
        if (isOpen())
            ::close(m_number);
    }

    bool isOpen() const { return m_number >= 0; }
    ssize_t read(char *to, std::size_t size) const { return ::read(m_number, to, size); }
    /// What can be read now, or 0 after that many ms.
    int wait(int milliseconds) const
    {
        pollfd waiting{m_number, POLLIN, 0};
        return ::poll(&waiting, 1, milliseconds) > 0 ? waiting.revents : 0;
    }

private:
    int m_number;
};
#endif

} // namespace

#ifdef Q_OS_UNIX
Result<std::string> readPipe(const QString &path, std::int64_t most, const std::string &place)
{
    const Descriptor pipe(path);
    if (!pipe.isOpen())
        return cannot(place, qt_error_string(errno));
    std::string bytes, chunk(kChunk, '\0');
    bool wasWaitedFor = false;
    while (static_cast<std::int64_t>(bytes.size()) <= most) {
        const ssize_t count = pipe.read(chunk.data(), chunk.size());
        if (count > 0) {
            bytes.append(chunk, 0, static_cast<std::size_t>(count));
        } else if (count == 0) {
            // Also where nobody has opened the other end yet.
            if (!bytes.empty() || wasWaitedFor)
                break;
            wasWaitedFor = true;
            if (pipe.wait(kForWriter) == 0)
                return cannot(place, QLatin1String(QT_TRANSLATE_NOOP(
                                         "Error", "nothing is writing to this pipe")));
        } else if (errno == EAGAIN) {
            if (pipe.wait(kForMore) == 0)
                return cannot(place, QLatin1String(QT_TRANSLATE_NOOP(
                                         "Error", "nothing came out of it for 10 seconds")));
        } else if (errno != EINTR) {
            return cannot(place, qt_error_string(errno));
        }
    }
    return bytes;
}

Result<void> openForWriting(const QString &path, QFile &file)
{
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(kForWriter);
    int number = -1;
    // Without a reader at the other end a pipe cannot be opened so.
    while ((number = ::open(QFile::encodeName(path).constData(),
                            O_WRONLY | O_NONBLOCK | O_CLOEXEC)) < 0 &&
           errno == ENXIO && std::chrono::steady_clock::now() < until)
        ::usleep(kBetweenTries);
    if (number < 0)
        return failure(ErrorCode::CannotWrite, path.toStdString(),
                       {errno == ENXIO ? std::string(QT_TRANSLATE_NOOP(
                                             "Error", "nothing is reading from this pipe"))
                                       : qt_error_string(errno).toStdString()});
    ::fcntl(number, F_SETFL, ::fcntl(number, F_GETFL) & ~O_NONBLOCK);
    if (!file.open(number, QIODevice::WriteOnly | QIODevice::Unbuffered,
                   QFileDevice::AutoCloseHandle))
        return failure(ErrorCode::CannotWrite, path.toStdString(),
                       {file.errorString().toStdString()});
    return {};
}
#else
Result<std::string> readPipe(const QString &path, std::int64_t most, const std::string &place)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return cannot(place, file.errorString());
    const QByteArray bytes = file.read(most + 1);
    if (file.error() != QFileDevice::NoError)
        return cannot(place, file.errorString());
    return bytes.toStdString();
}

Result<void> openForWriting(const QString &path, QFile &file)
{
    file.setFileName(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return failure(ErrorCode::CannotWrite, path.toStdString(),
                       {file.errorString().toStdString()});
    return {};
}
#endif

} // namespace fff::io
