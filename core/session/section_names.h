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

} // namespace fff
