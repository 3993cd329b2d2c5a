#include "core/assembly/slice_wish.h"

#include "core/assembly/upwards.h"
#include "core/model/instance_key.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace fff {

namespace {

/// Both follow one mesh, so they end at the same places of it, but for how near curves are fitted
/// to it where it is oblique. mm.
constexpr double kFittedEnds = 1.0;
/// Where one of them was closed over a gap in the mesh, or left out in part, they end apart. By no
/// more than this, as a share of what they have in common, a direction for all is worth the longer
/// slit.
constexpr double kWorthOneSide = 0.5;

/// The row of those around an axis; those of one axis are turned by so much at least, radians.
constexpr std::string_view kAround = "r";
constexpr double kLeastTurn = 1e-3;

/// What the section was to begin with, before it was copied.
const SectionRef &firstRef(const Section &section)
{
    if (!section.copyOf)
        return section.made;
    const CopyOf *copy = &*section.copyOf;
    while (copy->before)
        copy = copy->before.get();
    return copy->section;
}

/// Of a slice's key ("x/3/0") the row.
std::string_view rowOf(const SectionRef &ref)
{
    return std::string_view(ref.key).substr(0, ref.key.find('/'));
}

/// Whether one operation cut both of a template.
bool areOfOneTemplate(const Document &document, const SectionRef &a, const SectionRef &b)
{
    if (!a.operation.isValid() || a.operation != b.operation)
        return false;
    const Operation *operation = document.find(a.operation);
    return operation && operation->subject.isValid();
}

/// Of a slice's key the number of its plane.
int planeOf(const SectionRef &ref)
{
    const std::size_t from = std::min(ref.key.find('/') + 1, ref.key.size());
    int plane = 0;
    std::from_chars(ref.key.data() + from, ref.key.data() + ref.key.size(), plane);
    return plane;
}

/// To which end of the axis slits of a open, ±1; 0: it is not worth it.
int sideInGrid(const SectionRef &a, const SectionRef &b, const Crossing &crossing)
{
    double shared = 0.0, apart = 0.0;
    for (const Overlap &o : crossing.overlaps) {
        shared += o.to - o.from;
        apart += (o.a.to.at - o.b.to.at) + (o.a.from.at - o.b.from.at);
    }
    if (std::abs(apart) > std::max(kFittedEnds, kWorthOneSide * shared))
        return 0;
    const bool isAFirst = isKeyBefore(rowOf(a), rowOf(b));
    return pointsUp(crossing.axis.direction) == isAFirst ? 1 : -1;
}

/// How many planes stand around the axis, by how far these two are turned from each other.
int planesAround(const Frame &a, const Frame &b, int between)
{
    const double turn = std::acos(std::clamp(a.x.dot(b.x), -1.0, 1.0));
    return static_cast<int>(std::lround(std::numbers::pi * between / std::max(turn, kLeastTurn)));
}

JointWish wishAround(const Section &a, const Section &b, int planeA, int planeB,
                     const Crossing &crossing)
{
    const int planes = planesAround(a.frame, b.frame, std::abs(planeA - planeB));
    if (planes < 3)
        return {};
    const bool isAUpper = planeA < planeB;
    JointWish wish;
    wish.sign = pointsUp(crossing.axis.direction) == isAUpper ? -1 : 1;
    if (planeA + planeB + 1 == planes)
        return wish; // in the middle, as by themselves
    // From the top: half-way between the end of the upper one's stretch and the beginning of the
    // lower one's.
    const double meet = 0.5 * (planeA + planeB + 1) / planes;
    wish.shares.assign(crossing.overlaps.size(), isAUpper ? 1.0 - meet : meet);
    return wish;
}

} // namespace

JointWish wishInSlices(const Model &model, int a, int b, const Crossing &crossing)
{
    const Section &sectionA = *model.section(static_cast<std::size_t>(a));
    const Section &sectionB = *model.section(static_cast<std::size_t>(b));
    const SectionRef &first = firstRef(sectionA), &second = firstRef(sectionB);
    if (!areOfOneTemplate(model.document, first, second))
        return {};
    if (rowOf(first) != rowOf(second)) {
        JointWish wish;
        wish.sign = sideInGrid(first, second, crossing);
        return wish;
    }
    const int planeA = planeOf(first), planeB = planeOf(second);
    if (rowOf(first) != kAround || planeA == planeB)
        return {};
    return wishAround(sectionA, sectionB, planeA, planeB, crossing);
}

} // namespace fff
