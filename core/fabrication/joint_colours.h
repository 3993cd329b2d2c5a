// Colours by which the two parts of a joint are found (paper, "Fabrication", Figure 19).
#pragma once

#include "core/fabrication/machine.h"

#include <cstdint>

namespace fff {

struct CuttingDrawing;

/// 0xRRGGBB, dark enough to be read on paper; far from each colour that means something to the
/// machine, which would cut what it takes for a cut. There are about a dozen: the numbers tell
/// joints of the same colour apart.
/// joint  its number, from 1 on
std::uint32_t jointColour(int joint, const Machine &machine);

/// Of a line of the drawing: by its purpose, or of a joint's number by the joint where that is
/// asked for. joint  0: it is none
std::uint32_t colourOf(Purpose purpose, int joint, const CuttingDrawing &drawing);

} // namespace fff
