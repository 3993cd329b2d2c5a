// The edits of templates. Errors  BadValue, place = the member, for what is beyond its range
// (template.h), magnets of what is flat, or a blob that the document does not have;
// UnknownReference for a template or a drawn section that is not there.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

namespace fff {

/// Appends it (its id is given). A name that another one has gets a number.
Result<Document> addTemplate(Document document, Template added);
/// Replaces the one with the same id; bytes that no other one is made of go with it.
Result<Document> setTemplate(Document document, Template changed);
/// With its bytes, unless another one is made of them.
Result<Document> removeTemplate(Document document, TemplateId id);
/// So that it stands before the one that is at `place` now, or last.
Result<Document> moveTemplate(Document document, TemplateId id, std::size_t place);

} // namespace fff
