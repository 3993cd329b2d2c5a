#include "core/io/file_set.h"

#include "core/io/replacement.h"

#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <algorithm>
#include <memory>
#include <optional>

namespace fff::io {

namespace {

tl::unexpected<Error> cannotWrite(const QString &path, const QString &reason)
{
    return failure(ErrorCode::CannotWrite, path.toStdString(), {reason.toStdString()});
}

/// What was at a path, for the case that a later file cannot be put in its place.
struct Before
{
    QString path;
    std::optional<QByteArray> bytes; // none: there was no file
};

void restore(const std::vector<Before> &done)
{
    for (const Before &before : done) {
        if (!before.bytes) {
            QFile::remove(before.path);
            continue;
        }
        Replacement file(before.path);
        if (file.write(before.bytes->toStdString()) == 0)
            file.commit();
    }
}

/// What numbers stand between in the names of a set.
struct SetName
{
    QString before, behind;

    SetName(const QString &path, const QString &usual)
    {
        const QString suffix = QFileInfo(path).suffix();
        before = (suffix.isEmpty() ? path : path.chopped(suffix.size() + 1)) + u'-';
        behind = u'.' + (suffix.isEmpty() ? usual : suffix);
    }
    QString of(std::size_t number, int digits) const
    {
        return before + QString::number(number).rightJustified(digits, u'0') + behind;
    }
};

} // namespace

int digitsFor(std::size_t count)
{
    return std::max(2, static_cast<int>(QString::number(count).size()));
}

std::vector<NamedBytes> numberedFiles(const QString &path, const std::vector<std::string> &contents,
                                      const QString &usual, int digits)
{
    const SetName name(path, usual);
    std::vector<NamedBytes> files;
    for (const std::string &bytes : contents)
        files.push_back({name.of(files.size() + 1, digits), bytes});
    return files;
}

std::vector<QString> olderFiles(const QString &path, std::size_t count, const QString &usual)
{
    const SetName name(path, usual);
    std::vector<QString> older;
    for (std::size_t number = count + 1; number <= kMostLeft; ++number)
        if (const QString file = name.of(number, 1); QFileInfo::exists(file))
            older.push_back(file);
    return older;
}

Result<void> writeFiles(const std::vector<NamedBytes> &files)
{
    std::vector<std::unique_ptr<Replacement>> waiting;
    for (const NamedBytes &named : files) {
        auto file = std::make_unique<Replacement>(named.path);
        if (const int number = file->write(named.bytes))
            return cannotWrite(named.path, systemReason(number));
        waiting.push_back(std::move(file));
    }
    std::vector<Before> done;
    for (std::size_t i = 0; i < files.size(); ++i) {
        Before before{files[i].path, std::nullopt};
        if (QFile old(before.path); old.open(QIODevice::ReadOnly))
            before.bytes = old.readAll();
        if (const int number = waiting[i]->commit()) {
            restore(done);
            return cannotWrite(files[i].path, systemReason(number));
        }
        done.push_back(std::move(before));
    }
    return {};
}

} // namespace fff::io
