#include "core/fabrication/joint_colours.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace fff {

namespace {

/// Neighbours differ most: joints with numbers in a row are often on one part.
constexpr std::array<std::uint32_t, 14> kColours = {
    0x1B6CA8, 0xB85C00, 0x1E7B34, 0x8E2C9B, 0x7A5C00, 0x00777A, 0xB3206E,
    0x5B4FC4, 0x5D6B00, 0x8A3B12, 0x3C5A78, 0x6E2C5C, 0x2F6B57, 0x5A5A5A};

/// Of each channel: programs take what is nearer for the same.
constexpr int kApart = 48;

bool isLike(std::uint32_t a, std::uint32_t b)
{
    for (const int shift : {16, 8, 0}) {
        const int difference =
            static_cast<int>(a >> shift & 0xFFU) - static_cast<int>(b >> shift & 0xFFU);
        if (std::abs(difference) >= kApart)
            return false;
    }
    return true;
}

} // namespace

std::uint32_t jointColour(int joint, const Machine &machine)
{
    std::array<std::uint32_t, kColours.size()> free{};
    const auto end = std::copy_if(
        kColours.begin(), kColours.end(), free.begin(), [&machine](std::uint32_t colour) {
            return std::none_of(machine.processes.begin(), machine.processes.end(),
                                [colour](const Machine::Process &process) {
                                    return isLike(process.colour, colour);
                                });
        });
    const auto count = end - free.begin();
    if (count == 0)
        return machine.of(Purpose::Number).colour;
    return free[static_cast<std::size_t>((joint - 1) % count)];
}

std::uint32_t colourOf(Purpose purpose, int joint, const CuttingDrawing &drawing)
{
    const Machine &machine = machineOf(drawing);
    return joint > 0 && drawing.hasJointColours ? jointColour(joint, machine)
                                                : machine.of(purpose).colour;
}

} // namespace fff
