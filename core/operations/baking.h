// From sections that operations make to drawn ones that look the same.
#pragma once

#include "core/model/model.h"

namespace fff {

/// The operation goes, what it makes becomes drawn; what it changes is drawn as it was changed.
/// Nothing that is seen or cut changes: parents, weights, what is wanted of joints, and the inputs
/// of operations below follow to the drawn sections, and a slit that would open to another side
/// because of the new order of the sections keeps its own as a person's wish.
/// Errors  UnknownReference, place = the id.
Result<Document> baked(const Model &model, OperationId id);

/// This one of its sections becomes drawn, and an exception of the operation; all that refers to it
/// follows, as above. The drawn section is the document's last.
/// Errors  UnknownReference, place = the key, when the model has no such section now.
Result<Document> detached(const Model &model, const SectionRef &instance);

} // namespace fff
