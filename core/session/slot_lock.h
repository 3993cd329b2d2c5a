// Whether the program that writes a slot of the recovery folder still runs.
#pragma once

#include <QString>

#include <memory>

namespace fff {

/// Held by an open file, which the system lets go of when its program is gone, however that went.
/// Instead of a number of a process in the file, as QLockFile has it: a copy would not be offered
/// as long as another program has that number, or when the program was killed before it had
/// written the number.
class SlotLock
{
public:
    explicit SlotLock(const QString &path);
    ~SlotLock(); // lets go, and takes the file away
    SlotLock(const SlotLock &) = delete;
    SlotLock &operator=(const SlotLock &) = delete;

    /// False when it is held, or no file can be made there. Where files cannot be locked nothing is
    /// ever held: work that is offered twice is better than work that is not offered.
    bool tryLock();
    /// By any program, this one included. Leaves no trace.
    static bool isHeld(const QString &path);

private:
    struct File;

    QString m_path;
    std::unique_ptr<File> m_file; // null: not held
};

} // namespace fff
