// Which parts of a model are those of an earlier one, and can stay on their sheets.
#pragma once

#include "core/analysis/nested.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace fff {

/// Parts by their section, and which of its bodies they are: what edits elsewhere do not change.
struct BodiesOfParts
{
    using Body = std::pair<SectionRef, int>;

    std::vector<Body> ofPart;   // one a part
    std::map<Body, int> partOf; // index into the parts
};

BodiesOfParts bodiesOfParts(const Model &model, const std::vector<Part> &parts);

/// Those of them that are there.
std::vector<PinnedPart> pinnedParts(const std::vector<PinnedBody> &pinned,
                                    const BodiesOfParts &bodies);

struct LyingParts
{
    const Model &model;
    const std::vector<Part> &parts;
    const Layout &layout;
};

/// All that lay there stays, and yields: what was changed before what was not, to be tried first
/// where it was. Nothing where so much has changed, come or gone that all is to be laid anew.
std::optional<std::vector<PinnedPart>>
lyingStill(const LyingParts &before, const std::vector<Part> &parts, const BodiesOfParts &bodies);

} // namespace fff
