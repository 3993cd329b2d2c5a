// Copies of sections in the same document: in place, or each one a step further.
#pragma once

#include "core/geometry/similarity.h"
#include "core/model/model.h"

#include <functional>
#include <vector>

namespace fff {

/// More copies than this are a slip of the keyboard's.
inline constexpr double kMostCopies = 500.0;

struct Copies
{
    Document document;                         // with all of them, where the originals are
    std::vector<std::vector<SectionId>> drawn; // of each copy
    std::vector<SectionRef> sections; // of the last one, drawn ones and those that are made of them
};

/// As excerpt() and inserted() have it, `count` times; they stay on what the originals are on.
Copies copied(const Model &model, const std::vector<SectionRef> &sections, int count = 1);

/// Copy k, 1 …, moved by placementOf(k). One that is held by what it is on keeps its angle to that.
/// Errors  as movedSections().
Result<Document> placedCopies(const Copies &copies,
                              const std::function<Similarity(int)> &placementOf);

} // namespace fff
