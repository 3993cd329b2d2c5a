// The pass before operations: numbers of a document become what was typed for them comes to.
#pragma once

#include "core/model/evaluation.h"
#include "core/operations/drivable.h"

#include <optional>
#include <string>
#include <vector>

namespace fff {

struct Driven
{
    Document document;
    EvaluatedValues values;
    std::vector<DrivingError> errors; // in the order of the places
};

/// The document in agreement with its values. Bindings whose number is another one than they came
/// to, or is gone, end first. Then all numbers follow, or, with an error, none: the model stays as
/// it was. A document in agreement comes back as it came (isSame), so the pass can be done any
/// number of times; `previous` saves work and changes nothing.
///
/// What one expression sets may move what another one has set, as a section takes along what is on
/// it; so numbers are looked at until all agree. O(bindings) a round, and what the edits cost of
/// those that change.
Driven driven(Document document, const EvaluatedValues &previous = {});

/// The number follows this text from now on; a plain number or text (Typed::isConstant()) is set
/// once, and ends a binding. What comes back is in agreement.
/// Errors  one sentence that names the place.
tl::expected<Document, Message> bound(Document document, const DrivenPlace &place,
                                      std::string typed, const Reading &reading = {});

/// What the edit made wrong that was not before: a value that has no worth, or a number that does
/// not follow. Nothing: it may be committed. Both documents are looked at as evaluate() would.
std::optional<Message> newlyWrong(const Document &before, const Document &after);

} // namespace fff
