#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

#include "core/base/units.h"

#include <cmath>

namespace fff::samples {

namespace {

constexpr double kScale = 0.84;

/// Where an arm of the trunk ends, and in which direction, in degrees from the upright.
struct Arm
{
    Vec2 tip;
    double degrees;

    Vec2 way() const { return {std::sin(radians(degrees)), std::cos(radians(degrees))}; }
    Vec2 at(double across, double along) const
    {
        return tip + across * Vec2(way().y(), -way().x()) + along * way();
    }
};
const Arm kLeft{{-25, 92}, -28}, kRight{{32, 84}, 42};

/// A letter Y whose arms are not alike.
Contour trunk()
{
    return flowing({{{0, 13}},           {{9, 16}},
                    {{9, 34}},           {{10, 48}},
                    {{17, 60}},          {kRight.at(9, -11)},
                    {kRight.at(9, -1)},  {kRight.at(0, 1.5)},
                    {kRight.at(-9, -1)}, {kRight.at(-9, -11)},
                    {{4, 70}},           {{-3, 71}},
                    {kLeft.at(9, -11)},  {kLeft.at(9, -1)},
                    {kLeft.at(0, 1.5)},  {kLeft.at(-9, -1)},
                    {kLeft.at(-9, -11)}, {{-14, 62}},
                    {{-9.5, 48}},        {{-9, 34}},
                    {{-9, 16}}});
}

Contour leaf()
{
    return flowingBothSides({{{0, -15}},
                             {{9.4, -12.5}},
                             {{10, -3}},
                             {{18, 8}},
                             {{22, 24}},
                             {{15, 44}},
                             {{0, 66}, true}});
}

Frame acrossAt(const Arm &arm)
{
    return {{arm.tip.x(), arm.tip.y(), 0.0}, Vec3::UnitZ(), {arm.way().x(), arm.way().y(), 0.0}};
}

Contour foot()
{
    return flowingBothSides({{{0, 36}},
                             {{10, 34}},
                             {{22, 22}},
                             {{46, 17}},
                             {{62, 10}},
                             {{66, 0}, true},
                             {{48, 0}, true},
                             {{28, 5}},
                             {{0, 6}}});
}

Contour toe()
{
    return flowingBothSides({{{0, 26}},
                             {{14, 24}},
                             {{44, 13}},
                             {{58, 7}},
                             {{60, 0}, true},
                             {{36, 0}, true},
                             {{16, 5}},
                             {{0, 6}}});
}

const Section *find(const std::vector<SectionPointer> &sections, const SectionRef &ref)
{
    for (const SectionPointer &section : sections)
        if (section->ref() == ref)
            return section.get();
    return nullptr;
}

bool isLeaf(const Section &section)
{
    return section.name.find("eaf") != std::string::npos;
}

} // namespace

/// A letter Y with a leaf on each arm; nine times a leaf gives its place to a copy of all that is
/// on its branch.
void growingTree(const std::string &folder)
{
    Maker maker;
    const SectionRef stand = maker.add("Foot", facingRight(0.0), foot());
    const SectionRef stem = maker.addOn(stand, "Trunk", facingFront(0.0), trunk());
    maker.addOn(stem, "Left leaf", acrossAt(kLeft), leaf());
    maker.addOn(stem, "Right leaf", acrossAt(kRight), leaf());
    const SectionRef front = maker.addOn(stand, "Toe", facingFront(34.0), toe());
    for (int i = 1; i <= 9; ++i) {
        // The largest leaf, of equal ones the first.
        const std::vector<SectionPointer> all = maker.sections();
        const Section *chosen = nullptr;
        for (const SectionPointer &section : all)
            if (isLeaf(*section) &&
                (!chosen || section->shape->area() > chosen->shape->area() + 1.0))
                chosen = section.get();
        const Section *branch = find(all, chosen->parent->section);
        maker.apply("branch", "Branch " + std::to_string(i),
                    {{"root", {branch->ref()}},
                     {"where", {branch->parent->section}},
                     {"children", {chosen->ref()}}},
                    {{"scale", kScale}});
    }
    maker.apply("mirror", "Other toe", {{"sections", {front}}},
                {{"plane", "z"}, {"what", "selection"}});
    maker.write(folder, "growing_tree");
}

} // namespace fff::samples
