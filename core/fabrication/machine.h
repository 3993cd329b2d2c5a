// What a file of cuts is made for: the colours that a machine's program knows, its speeds, and how
// it is told what to do.
#pragma once

#include "core/fabrication/cutting_drawing.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fff {

/// What is done along a line.
enum class Purpose { Engrave, Number, Score, InnerCut, OuterCut, Guide };
inline constexpr std::size_t kPurposes = 6;
Purpose purposeOf(LineRole role);

struct Machine
{
    /// How lines of one purpose look in a file, and how they are followed.
    struct Process
    {
        std::uint32_t colour = 0; // 0xRRGGBB
        int layer = 0;            // of LightBurn: 0 … 29 burn, 30 and 31 do not
        double speed = 10.0;      // mm/s
        double power = 1.0;       // of the most that it has, 0 … 1
    };

    /// Lines of G-code. Those of `sheet` stand before every sheet but the first, when somebody has
    /// to put it in.
    struct GCode
    {
        std::vector<std::string> head = {"G21", "G90", "G17"}, sheet = {"M5", "M0"},
                                 foot = {"M5", "G0 X0 Y0", "M2"};
        std::string on = "M4", off = "M5"; // with the power behind the first
        double mostPower = 1000.0;         // as S says it
    };

    std::string key;           // by which it is asked for
    std::string name;          // as people call it; a proper name
    Vec2 bed = {600.0, 400.0}; // mm
    double stroke = 0.05;      // mm, width of lines in drawings
    double travel = 100.0;     // mm/s, where nothing is burnt
    bool hasGuides = true;     // whether it lets lines alone that are not to be burnt
    std::array<Process, kPurposes> processes;
    CutFinish finish; // of cuts for it, where nothing else is asked for
    GCode gcode;

    Machine();
    const Process &of(Purpose purpose) const
    {
        return processes[static_cast<std::size_t>(purpose)];
    }
};

/// Whether a sheet of that size, mm, lies on the bed, turned or not.
bool fitsBed(const Vec2 &sheet, const Machine &machine);

/// What is written where no machine is asked for: red cuts, blue numbers, black engraving, green
/// scoring, yellow guides. Speeds are those of a small laser in 3 mm plywood, for a first guess.
const Machine &usualMachine();
/// Of the drawing, else the usual one.
const Machine &machineOf(const CuttingDrawing &drawing);

} // namespace fff
