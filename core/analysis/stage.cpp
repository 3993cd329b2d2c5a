#include "core/analysis/stage.h"

#include <cmath>

namespace fff {

Message workOf(const Stage &stage, double share)
{
    if (share < 0.0)
        //: %1 is what is found out: "the order of assembly"
        return {FFF_TEXT("Stage", "Working out %1…"), {stage.title}};
    //: %1 is what is found out: "the order of assembly", %2 a number
    return {FFF_TEXT("Stage", "Working out %1… %2\u202f%"),
            {stage.title, static_cast<int>(std::floor(100.0 * share))}};
}

} // namespace fff
