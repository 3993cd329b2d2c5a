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

/// What the model's document wants of parts that are there: which are pinned, and how each may be
/// turned.
void addWishes(const Model &model, const BodiesOfParts &bodies, NestOptions &options);
/// Whether it is turned as it may be.
bool mayLieSo(const PinnedPart &part, const NestOptions &options);

struct LyingParts
{
    const Model &model;
    const std::vector<Part> &parts;
    const Layout &layout;
};

/// Where those lie that the document has pinned now and had not then; of the others what is known
/// already.
std::vector<PinnedPlace> layBeforePins(const LyingParts &before,
                                       const std::vector<PinnedPlace> &known,
                                       const Document &document);
/// Those that were pinned then go back to where they lay before that. `lying` has all that lay.
void goBack(const std::vector<PinnedPlace> &layBefore, const BodiesOfParts &bodies,
            std::vector<PinnedPart> &lying);

/// Where parts lay that are there still, of the same stock and about as large as they were.
std::vector<PinnedPart> layBefore(const LyingParts &before, const std::vector<Part> &parts,
                                  const BodiesOfParts &bodies);

/// All that lay there stays, and yields: what was changed before what was not, to be tried first
/// where it was. Nothing where so much has changed, come or gone that all is to be laid anew.
std::optional<std::vector<PinnedPart>>
lyingStill(const LyingParts &before, const std::vector<Part> &parts, const BodiesOfParts &bodies);

} // namespace fff
