#include "core/io/fff_migration.h"

namespace fff::io {

namespace {

QJsonObject unchanged(QJsonObject document)
{
    return document;
}

/// Version 2 has joints of which something is wanted, version 3 operations; before there were none.
constexpr Migration kMigrations[] = {{1, unchanged}, {2, unchanged}};

} // namespace

std::span<const Migration> fffMigrations()
{
    return kMigrations;
}

QJsonObject migrated(QJsonObject document, std::int64_t version,
                     std::span<const Migration> migrations)
{
    for (const Migration &step : migrations) {
        if (step.from != version)
            continue;
        document = step.migrate(std::move(document));
        document[QLatin1String("version")] = static_cast<qint64>(++version);
    }
    return document;
}

} // namespace fff::io
