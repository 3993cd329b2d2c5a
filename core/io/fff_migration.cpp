#include "core/io/fff_migration.h"

namespace fff::io {

std::span<const Migration> fffMigrations()
{
    return {};
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
