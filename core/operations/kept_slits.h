// Slits that open as they did, whatever the order of the sections has become.
#pragma once

#include "core/model/model.h"
#include "core/operations/renamed_instances.h"

namespace fff {

/// The document, in which sections that operations of the model made are drawn ones: slits of these
/// that would open to another side than in the model are wished to stay.
/// drawn   what became of those sections, each a section of the document
/// Errors  those of setJointOverride().
Result<Document> withSlitsKept(Document document, const Model &model, const Replacements &drawn);

} // namespace fff
