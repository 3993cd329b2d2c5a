// A file that takes the place of another one as a whole.
#pragma once

#include <QtCore/QString>

#include <memory>
#include <string>

namespace fff::io {

/// The system's error in words of ours where a person can do something, else as it has it.
QString systemReason(int number);

/// Whether it is the system's error for what nobody, or not this person, may write to.
bool isRefusal(int number);

/// What is written goes to a temporary file beside the old one, without a name as long as the
/// system allows that. Until commit() has succeeded the old file is there as it was; what was not
/// committed leaves nothing. Permissions are kept; a symbolic link stays, what it points to is
/// replaced.
///
/// Instead of QSaveFile, whose commit() says that all is well when a file without a name could not
/// be given one.
class Replacement
{
public:
    explicit Replacement(const QString &path);
    ~Replacement();
    Replacement(const Replacement &) = delete;
    Replacement &operator=(const Replacement &) = delete;

    /// What is replaced: the path behind all links.
    const QString &target() const { return m_target; }

    // In this order, each once; putOnDisk() may also come last. They return the system's error
    // number (an errno; on Windows what GetLastError() says), 0 when done.
    int write(const std::string &bytes);
    /// A power cut after commit() must not leave an empty file.
    int putOnDisk();
    int commit();

private:
    struct File;

    QString m_target;
    std::unique_ptr<File> m_file;
};

} // namespace fff::io
