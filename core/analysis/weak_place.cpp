#include "core/analysis/weak_place.h"

#include "core/analysis/finding.h"

namespace fff {

namespace {

/// mm: a line that ends so near to the end of a slit, besides half the slit's width, begins at it.
constexpr double kAtSlit = 0.5;

} // namespace

WeakPlace weakPlaceOf(const Analysis &analysis, int body, const NeckStress &neck)
{
    const Frame &frame = analysis.bodies.at(body).frame();
    const int section = analysis.bodies.sectionOf(body);
    WeakPlace place;
    place.section = analysis.model.ref(static_cast<std::size_t>(section));
    place.from = frame.toWorld(neck.begin);
    place.to = frame.toWorld(neck.end);
    if (neck.stress.notch > 1.0)
        place.spot = WeakPlace::Spot::Corner;
    for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(section)]) {
        const double reach = 0.5 * slit.width + kAtSlit;
        const bool isAtIt =
            (neck.begin - slit.inner).norm() < reach || (neck.end - slit.inner).norm() < reach;
        if (!isAtIt)
            continue;
        place.spot = slit.role == SlitRole::Slit ? WeakPlace::Spot::Slit : WeakPlace::Spot::Edge;
        place.guest = analysis.model.ref(static_cast<std::size_t>(slit.guest));
        break;
    }
    return place;
}

Message spotText(const WeakPlace &place, const Model &model)
{
    switch (place.spot) {
    case WeakPlace::Spot::Slit:
        //: where a part may break; %1 is the name of a section
        return {FFF_TEXT("Checks", "beside its slit for %1"), {nameOf(model, *place.guest)}};
    case WeakPlace::Spot::Edge:
        //: where a part may break; %1 is the name of a section
        return {FFF_TEXT("Checks", "where it joins %1"), {nameOf(model, *place.guest)}};
    case WeakPlace::Spot::Corner:
        //: where a part may break
        return {FFF_TEXT("Checks", "at an inner corner"), {}};
    case WeakPlace::Spot::Neck:
        break;
    }
    //: where a part may break
    return {FFF_TEXT("Checks", "at its neck"), {}};
}

} // namespace fff
