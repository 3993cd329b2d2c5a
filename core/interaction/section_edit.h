// What an edit of whole sections comes to.
#pragma once

#include "core/model/document.h"
#include "core/model/hint.h"
#include "core/model/step.h"

#include <optional>
#include <vector>

namespace fff {

/// Between a model and what comes beside it, mm.
inline constexpr double kBeside = 20.0;

struct EditedSections
{
    Document document;
    Step step;
    std::optional<std::vector<SectionRef>> select = {}; // others than before
    std::optional<Hint> note = {}; // what became of it beyond what was asked for
};

/// The document, or the refusal that says why there is none.
using SectionEdit = tl::expected<EditedSections, Hint>;

} // namespace fff
