// Makes the samples of resources/samples that are built from numbers rather than drawn:
//     make_samples FOLDER [NAME …]
// Run by hand when a sample is to change; its output is committed. tests/ui/start/tst_samples looks
// at what is there.
#include "tests/tools/samples/samples.h"

#include <algorithm>
#include <cstdio>

using namespace fff;

namespace {

struct Row
{
    const char *name;
    void (*make)(const std::string &folder);
};

const Row kRows[] = {
    {"fish", samples::fish},
    {"glass_holder", samples::glassHolder},
    {"tree", samples::tree},
    {"chair", samples::chair},
    {"organiser", samples::organiser},
    {"lamp", samples::lamp},
    {"bony_fish", samples::bonyFish},
    {"bridge", samples::bridge},
    {"beetle", samples::beetle},
    {"two_poses", samples::twoPoses},
    {"dinosaur", samples::dinosaur},
    {"growing_tree", samples::growingTree},
    {"whale", samples::whale},
    {"gears", samples::gears},
    {"cutlery_man", samples::cutleryMan},
    {"glass_three_legs", samples::glassOnThreeLegs},
    {"glass_four_legs", samples::glassOnFourLegs},
    {"acrylic_thin_three", samples::acrylicThinThree},
    {"acrylic_thin_four", samples::acrylicThinFour},
    {"acrylic_thick_three", samples::acrylicThickThree},
    {"acrylic_thick_four", samples::acrylicThickFour},
    {"shelf", samples::shelf},
    {"drawer_organiser", samples::drawerOrganiser},
    {"name_plate", samples::namePlate},
};

} // namespace

int main(int argc, char *argv[])
{
    if (argc < 2) {
        std::fprintf(stderr, "usage: make_samples FOLDER [NAME ...]\n");
        return 1;
    }
    const auto isAsked = [&](const std::string &name) {
        return argc == 2 || std::find(argv + 2, argv + argc, name) != argv + argc;
    };
    for (const Row &row : kRows)
        if (isAsked(row.name))
            row.make(argv[1]);
    return 0;
}
