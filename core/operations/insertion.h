// One document added to another: pasting, and inserting models.
#pragma once

#include "core/model/document.h"

#include <vector>

namespace fff {

struct Insertion
{
    Document document;
    std::vector<SectionRef> sections; // what came in: drawn ones, and then made ones
    std::vector<OperationId> operations;
};

/// All of the other document added to this one: equal to it but for ids, and names that were taken,
/// which get a number. Its stocks are those of this document where there are such, by all that they
/// say but their ids, and so are values, with all that they are made of; other values come along,
/// with a number behind names that were taken, and drive what they drove. The current stock stays,
/// unless this document has nothing yet.
Insertion inserted(Document into, const Document &other);
/// The same of an attachedExcerpt() of this document: what that does not have is meant to be here.
Insertion insertedAttached(Document into, const Document &other);

} // namespace fff
