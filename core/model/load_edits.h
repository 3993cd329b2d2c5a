// The edits of loads. Errors  BadValue, place = the member, for a mass that is not above 0, a push
// without a force, and what else is beyond its range (load.h); UnknownReference for a drawn section
// that is not there.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

namespace fff {

/// Appends it (its id is given).
Result<Document> addLoad(Document document, Load load);
/// Replaces the one with the same id.
Result<Document> setLoad(Document document, const Load &load);
Result<Document> removeLoad(Document document, LoadId id);

} // namespace fff
