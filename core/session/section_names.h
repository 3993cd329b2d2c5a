// Names of sections in sentences.
#pragma once

#include "core/model/model.h"

#include <QString>
#include <QStringList>

namespace fff {

/// Empty when the section does not exist now.
QString sectionName(const Model &model, const SectionRef &ref);
/// "Body", "Body and Fin", "Body, Fin and Tail".
QString listed(QStringList names);
/// Where three names or more count up, all of that word are one: "Sections 70–73, 75" of those that
/// nobody has named, "Rib 1–3" of others. In the order of their first ones.
QStringList inRuns(const QStringList &names);

} // namespace fff
