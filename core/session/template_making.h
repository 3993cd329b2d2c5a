// What is made of a template at once, as a step of the history: the new sections selected, with a
// note of what is not as it was wanted; a refusal where nothing came of it.
#pragma once

#include "core/analysis/suggesting/suggestion.h"
#include "core/interaction/section_edit.h"

namespace fff {

/// Errors  those of suggestSections().
Result<SectionEdit> suggestedEdit(const Model &model, TemplateId of,
                                  const SuggestionOptions &options = {}, const LongWork &work = {});

/// Flat sheets in place of the template, which is hidden. Errors  those of simplified(); Cancelled;
/// UnknownReference.
/// faces  the mesh is simplified to so many first
/// As nets to fold, with flaps as usual for the stock.
Result<SectionEdit> netEdit(const Document &document, TemplateId of, std::size_t faces,
                            const LongWork &work = {});
Result<SectionEdit> facetEdit(const Document &document, TemplateId of, std::size_t faces,
                              const LongWork &work = {});

} // namespace fff
