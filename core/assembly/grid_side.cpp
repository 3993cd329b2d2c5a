#include "core/assembly/grid_side.h"

#include "core/assembly/upwards.h"
#include "core/model/instance_key.h"

#include <algorithm>
#include <cmath>
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

} // namespace

int sideInGrid(const Model &model, int a, int b, const Crossing &crossing)
{
    const SectionRef &first = firstRef(*model.section(static_cast<std::size_t>(a)));
    const SectionRef &second = firstRef(*model.section(static_cast<std::size_t>(b)));
    if (!areOfOneTemplate(model.document, first, second) || rowOf(first) == rowOf(second))
        return 0;
    double shared = 0.0, apart = 0.0;
    for (const Overlap &o : crossing.overlaps) {
        shared += o.to - o.from;
        apart += (o.a.to.at - o.b.to.at) + (o.a.from.at - o.b.from.at);
    }
    if (std::abs(apart) > std::max(kFittedEnds, kWorthOneSide * shared))
        return 0;
    const bool isAFirst = isKeyBefore(rowOf(first), rowOf(second));
    return pointsUp(crossing.axis.direction) == isAFirst ? 1 : -1;
}

} // namespace fff
