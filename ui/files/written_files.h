// What a model's exports have written, so that nobody else's file, and nothing that was changed by
// hand since, is replaced without a question.
#pragma once

#include "core/io/file_set.h"

#include <QByteArray>
#include <QHash>
#include <QString>

#include <vector>

namespace fff::ui {

class WrittenFiles
{
public:
    /// Of files that are on the disk.
    /// model  its file's path; empty: it has none, and this is forgotten with it
    void remember(const QString &model, const std::vector<io::NamedBytes> &files);
    /// Another model comes in its place.
    void forget() { m_written.clear(); }
    /// The file has what was written there last, to the last byte.
    bool isOurs(const QString &model, const QString &path) const;

private:
    QHash<QString, QByteArray> m_written; // of the model that is open: hashes by path
};

/// The last so many files' are kept from one start to the next.
inline constexpr int kMostWritten = 400;

} // namespace fff::ui
