// What is cut: every connected piece of a section after its slits, with the marks engraved on it.
#pragma once

#include "core/assembly/body.h"
#include "core/model/model.h"

namespace fff {

struct Part
{
    int number = 0;  // 1 … n over the whole model, engraved
    int section = 0; // index in the Model
    StockId stock;
    CurvedRegion outline; // as designed: contour − holes − slits, clearance included, kerf not

    /// A joint's number beside its slit; the same at both mates.
    struct JointMark
    {
        int joint = 0;
        Vec2 inner = Vec2::Zero();     // of the slit, frame coordinates
        Vec2 direction = Vec2::Zero(); // from mouth to inner, unit
        double width = 0.0;            // of the slit
    };
    std::vector<JointMark> joints;
};

/// One of each body, in their order. `bodies` and `assembly` belong to the model. A slit's mark
/// goes to the part that its bottom touches.
std::vector<Part> makeParts(const Model &model, const Assembly &assembly, const Bodies &bodies);

} // namespace fff
