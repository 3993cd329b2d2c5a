// The pure edits of a document's operations, as those of edits.h.
// Errors of all: UnknownReference, place = the id, when there is no such operation.
#pragma once

#include "core/model/document.h"

namespace fff {

/// Appends it; its id is the document's nextId.
Document addOperation(Document document, Operation operation);
/// Replaces the one with the same id.
Result<Document> setOperation(Document document, Operation operation);
Result<Document> renameOperation(Document document, OperationId id, std::string name);
/// Sections that were drawn on what it made stay, without a parent; weights there and what was
/// wanted of its joints go.
Result<Document> removeOperation(Document document, OperationId id);
/// To another place in their order, 0 … their number − 1.
Result<Document> moveOperation(Document document, OperationId id, int index);
/// What is other than made of one of its sections; an empty exception makes it as the others again.
Result<Document> setException(Document document, const SectionRef &instance,
                              const Exception &exception);
/// The same of its state alone: it keeps a stock of its own.
Result<Document> setExceptionState(Document document, const SectionRef &instance,
                                   Exception::State state);
/// The same of its stock alone.
Result<Document> setExceptionStock(Document document, const SectionRef &instance, StockId stock);

} // namespace fff
