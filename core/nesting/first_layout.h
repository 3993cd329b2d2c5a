// A layout without a search: one piece after the other where there is room. Internal to nesting.
#pragma once

#include "core/nesting/filling.h"
#include "core/nesting/prepared.h"

namespace fff::nest {

struct Laid
{
    struct Sheet
    {
        int kind = 0;
        std::vector<int> pieces;
        std::vector<Pose> poses; // of these; the sheet is where its kind's box is
    };
    std::vector<Sheet> sheets; // used ones
    std::vector<int> left;     // what fits nowhere

    std::size_t count() const;
};

/// How far the last sheet is used.
double usedLength(const Prepared &prepared, const Laid &laid);
/// Less is left, fewer sheets are taken, or less of the last one.
bool isBetter(const Prepared &prepared, const Laid &a, const Laid &b);

/// The largest piece first, on the first sheet that has room for it. A sheet that has no room for a
/// piece is asked again when pieces are a good deal smaller, so that the time grows about in line
/// with their number. Always all of it: what is to be stopped is the search.
Laid firstLayout(const Prepared &prepared, const Problem &problem, Steps &steps);

} // namespace fff::nest
