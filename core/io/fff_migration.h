// Brings a `.fff` of an older version to the newest, as JSON and before it is read: a step a
// version, so that the reader knows the newest form alone. Internal to fff_reader.cpp.
//
// To change the format so that older programs must not read it: raise kFffVersion, add the step
// from the version before to kMigrations, and keep a file of that version in tests/data/migration
// with the document that it must give.
#pragma once

#include <QtCore/QJsonObject>

#include <cstdint>
#include <span>

namespace fff::io {

struct Migration
{
    std::int64_t from = 0;                         // to from + 1
    QJsonObject (*migrate)(QJsonObject) = nullptr; // what it does not know stays as it is
};

/// In their order.
std::span<const Migration> fffMigrations();

/// The document in the newest version that the steps lead to, "version" with it. What was wrong in
/// it is as wrong after: the reader says so.
QJsonObject migrated(QJsonObject document, std::int64_t version,
                     std::span<const Migration> migrations = fffMigrations());

} // namespace fff::io
