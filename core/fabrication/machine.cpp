#include "core/fabrication/machine.h"

namespace fff {

Purpose purposeOf(LineRole role)
{
    switch (role) {
    case LineRole::Engrave:
        return Purpose::Engrave;
    case LineRole::Score:
        return Purpose::Score;
    case LineRole::InnerCut:
        return Purpose::InnerCut;
    case LineRole::OuterCut:
        return Purpose::OuterCut;
    }
    return Purpose::OuterCut; // not reached: every role is above
}

Machine::Machine()
    // In the order of Purpose. Layers of LightBurn as boxes.py takes them: C00 for the outside, C01
    // for holes, C03, C06, and T1 for what is not burnt.
    : processes{{{0x000000, 6, 50.0, 0.2},
                 {0x0000FF, 6, 50.0, 0.2},
                 {0x00FF00, 3, 30.0, 0.2},
                 {0xFF0000, 1, 10.0, 1.0},
                 {0xFF0000, 0, 10.0, 1.0},
                 {0xFFCC00, 30, 100.0, 0.0}}}
{
}

const Machine &usualMachine()
{
    static const Machine machine = [] {
        Machine usual;
        usual.key = "generic";
        usual.name = "Laser cutter";
        return usual;
    }();
    return machine;
}

bool fitsBed(const Vec2 &sheet, const Machine &machine)
{
    return sheet.minCoeff() <= machine.bed.minCoeff() && sheet.maxCoeff() <= machine.bed.maxCoeff();
}

const Machine &machineOf(const CuttingDrawing &drawing)
{
    return drawing.machine ? *drawing.machine : usualMachine();
}

} // namespace fff
