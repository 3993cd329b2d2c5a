// Models of which a person knows whether they can be put together.
#pragma once

#include "core/base/units.h"
#include "tests/core/assembly/plates.h"

#include <cmath>

namespace fff::test {

/// Standing strips with a spacing of 20, so many each way.
inline Document eggCrate(int across, int along)
{
    Document document = newDocument();
    const ShapePointer wide = polygonShape(rectangle(0, 0, 20.0 * (along + 1), 40));
    const ShapePointer deep = polygonShape(rectangle(0, 0, 20.0 * (across + 1), 40));
    for (int i = 0; i < across; ++i)
        document = withSection(std::move(document), wide, front(-20.0 * (i + 1)));
    for (int i = 0; i < along; ++i)
        document = withSection(std::move(document), deep, side(20.0 * (i + 1)));
    return document;
}

/// A spine with ribs that hang on its upper edge.
inline Document combModel(int ribs)
{
    Document document = newDocument();
    document = withSection(std::move(document),
                           polygonShape(rectangle(0, 0, 20.0 * (ribs + 1), 30)), front());
    for (int i = 0; i < ribs; ++i)
        document = withSection(std::move(document), polygonShape(rectangle(-20, 10, 20, 50)),
                               side(20.0 * (i + 1)));
    return document;
}

/// Each on the one before, crosswise, like beads.
inline Document chain(int links)
{
    Document document = newDocument();
    const ShapePointer link = polygonShape(rectangle(0, 0, 50, 30));
    for (int i = 0; i < links; ++i) {
        const double at = 40.0 * static_cast<double>(i / 2);
        document =
            withSection(std::move(document), link,
                        i % 2 == 0 ? Frame{{at, 0, -at}, Vec3::UnitX(), Vec3::UnitY()}
                                   : Frame{{at + 45, 0, -at + 5}, -Vec3::UnitZ(), Vec3::UnitY()});
    }
    return document;
}

/// Three plates, each through both others: their axes are those of the world. Slits stay apart.
inline Document triangle()
{
    const ShapePointer plate = polygonShape(rectangle(-30, -30, 30, 30));
    Document document = withSection(newDocument(), plate, front(10));
    document = withSection(std::move(document), plate, side(-20));
    return withSection(std::move(document), plate, {{0, 20, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
}

inline Frame level(double height)
{
    return {{0, height, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
}

/// A rib of this height on the lower arm of a C, whose upper arm hangs over it.
inline Document underAnArm(double height)
{
    const ShapePointer arms = polygonShape(
        {{0, 0}, {100, 0}, {100, 30}, {20, 30}, {20, 80}, {100, 80}, {100, 100}, {0, 100}});
    return withSection(withSection(newDocument(), arms, front()),
                       polygonShape(rectangle(-20, 15, 20, 15 + height)), side(60));
}

/// Two U that cross at their feet, each with a shelf that goes into its arm from within and then
/// reaches so near to the other U that it does not come out any more.
inline Document furnished()
{
    const ShapePointer arms = polygonShape(
        {{-60, 0}, {60, 0}, {60, 100}, {35, 100}, {35, 20}, {-35, 20}, {-35, 100}, {-60, 100}});
    Document document = withSection(newDocument(), arms, front());
    document = withSection(std::move(document), arms, side());
    document = withSection(std::move(document), polygonShape(rectangle(-45, -4, -5, 4)), level(60));
    return withSection(std::move(document), polygonShape(rectangle(-4, 5, 4, 45)), level(60));
}

/// A disc with ribs about it, each across its rim.
inline Document star(int ribs)
{
    Polygon disc;
    for (int i = 0; i < 60; ++i)
        disc.push_back(Vec2(50 * std::cos(i * radians(6.0)), 50 * std::sin(i * radians(6.0))));
    Document document = withSection(newDocument(), polygonShape(disc), level(20));
    for (int i = 0; i < ribs; ++i)
        document = withSection(std::move(document), polygonShape(rectangle(35, 0, 70, 40)),
                               turned(radians(360.0 * i / ribs)));
    return document;
}

/// Three ribs on a spine, and over them a comb that holds each between two of its teeth: it goes in
/// from above alone. Its index is 4.
inline Document combOverRibs()
{
    Document document = withSection(newDocument(), polygonShape(rectangle(0, 0, 160, 40)), front());
    for (const double at : {30.0, 80.0, 130.0})
        document =
            withSection(std::move(document), polygonShape(rectangle(-30, 10, 30, 80)), side(at));
    Polygon teeth{{0, 100}, {0, 50}};
    for (const double at : {30.0, 80.0, 130.0})
        teeth.insert(teeth.end(), {{at - 12, 50}, {at - 8, 65}, {at + 8, 65}, {at + 12, 50}});
    teeth.insert(teeth.end(), {{160, 50}, {160, 100}});
    return withSection(std::move(document), polygonShape(teeth), front(-20));
}

/// A short rib (index 1) and two high ones on a spine; a beam (index 4) from one high rib to the
/// other hangs over the short one, which must be there first.
inline Document ribUnderABeam()
{
    Document document = withSection(newDocument(), polygonShape(rectangle(0, 0, 120, 30)), front());
    document = withSection(std::move(document), polygonShape(rectangle(-20, 10, 20, 50)), side(60));
    for (const double at : {20.0, 100.0})
        document =
            withSection(std::move(document), polygonShape(rectangle(-20, 10, 20, 80)), side(at));
    return withSection(std::move(document), polygonShape(rectangle(0, 60, 120, 100)), front(-8));
}

/// The joint of two sections with the slit of the first one opening downwards.
inline Document downwards(Document document, std::size_t first, std::size_t second)
{
    JointOverride wanted;
    wanted.a = document.sections[first]->id;
    wanted.b = document.sections[second]->id;
    wanted.opens = -Vec2::UnitY();
    return *setJointOverride(std::move(document), wanted);
}

/// Of a crate of 2 by 2 that begins with the section `first`: each above the next, and the last
/// above the first one again.
inline Document roundabout(Document crate, std::size_t first)
{
    crate = downwards(std::move(crate), first, first + 2);
    return downwards(std::move(crate), first + 1, first + 3);
}

} // namespace fff::test
