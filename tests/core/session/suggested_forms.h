// What tests and the table of suggestions measure: a mesh in a document, the verdicts on a model,
// and how much of a silhouette its sections show.
#pragma once

#include "core/model/document.h"
#include "core/model/model.h"
#include "tests/core/templates/made_forms.h"

#include <QStringList>

namespace fff::test {

/// Standing on the ground, 254 mm large unless said otherwise.
Document documentWith(const MadeForm &form, double size = 254.0);
/// The same in slices across X and Z, as many planes each way: of such even grids the one whose
/// number of sections is nearest to this.
Model evenGridOf(const Document &document, std::size_t sections);

/// The same in slices, `planes` each way.
Model slicesOf(const Document &document, const std::string &direction, int planes);

/// What is wrong by all checks, a line each; empty where all is good: it can be assembled, every
/// piece is held, it stands.
QStringList faultsOf(const Model &model);

/// More than a thin wall beside a slit.
bool isGrave(const QString &fault);

/// Shares of a silhouette that differ by less are as good as each other.
inline constexpr double kAsGood = 0.001;

/// Share of the mesh's silhouette from 12 directions that has something of a section within 3 mm
/// beside it, as it is seen from there. By painting both, so it shares nothing with how sections
/// are chosen; the directions are others, too, but for the front and the side.
/// ground  Y, mm: of the mesh as if all below this were pressed flat
double silhouetteShown(const Template &mesh, const std::vector<SectionPointer> &sections,
                       double ground = -1e9);

} // namespace fff::test
