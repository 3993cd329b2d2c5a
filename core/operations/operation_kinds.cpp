// The table of the kinds: a new one is its file and its line here.
#include "core/operations/array.h"
#include "core/operations/blend.h"
#include "core/operations/branch.h"
#include "core/operations/grid.h"
#include "core/operations/linear.h"
#include "core/operations/radial.h"
#include "core/operations/revolve.h"
#include "core/operations/slices.h"
#include "core/operations/symmetry.h"

namespace fff {

std::span<const OperationKind *const> operationKinds()
{
    static constexpr const OperationKind *kKinds[] = {
        &kLinear,     //
        &kRevolve,    //
        &kBlend,      //
        &kBranch,     //
        &kGrid,       //
        &kRadial,     //
        &kMirror,     //
        &kRotational, //
        &kArray,      //
        &kSlices,     //
    };
    return kKinds;
}

} // namespace fff
