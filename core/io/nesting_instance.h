// Problems of strip packing as research has them: the JSON of ESICUP's instances.
#pragma once

#include "core/base/result.h"
#include "core/nesting/problem.h"

namespace fff::io {

/// Their place in a file's list is not always what items are called by.
struct NestingInstance
{
    std::string name;
    std::vector<std::int64_t> ids; // of each piece
    nest::Problem problem;      // without margin and spacing
};

/// Items with their demand, the angles at which they may lie (degrees; none are named: any) and
/// their outline, `simple_polygon` or `polygon` with `outer` and `inner` ones. Lengths are taken
/// for mm. What is no instance is BadValue at its path; file: what errors call it.
Result<NestingInstance> readNestingInstance(std::string_view json, const std::string &file = {});

} // namespace fff::io
