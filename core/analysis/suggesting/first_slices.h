// The planes that slices of a mesh begin with.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/model/model.h"

#include <string>

namespace fff {

/// Parameters of slices, by their keys: of an operation that nobody has said anything of yet.
struct FirstSlices
{
    std::string direction = "xz";
    int count = 6;
    double shift = 0.0; // of the distance between planes

    bool operator==(const FirstSlices &) const = default;
};

/// Of a few, the first that can be made by themselves: all hold each other and stand, they can be
/// assembled, and nothing is wrong with them. The usual ones where that is true of none.
///
/// Errors  UnknownReference for a template that is not there or has no mesh; Cancelled.
/// Cost    of an analysis and a plan each, of sixteen at most.
Result<FirstSlices> firstSlices(const Model &model, TemplateId of, const LongWork &work = {});

} // namespace fff
