#include "core/model/changes.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace fff {

namespace {

/// Whether the model has the section as it is: what operations made anew is another object.
bool hasEqual(const Model &model, const Section &section)
{
    const Section *own = model.find(section.ref());
    return own && *own == section;
}

/// Those of `after` that are not in `before`, by pointer; what both begin and end with is passed
/// over, since an edit adds at the end or changes in place.
template <class T, class Pointer, class Found>
void eachNew(const std::vector<T> &before, const std::vector<T> &after, Pointer pointer,
             Found found)
{
    const auto isSame = [&](const T &a, const T &b) { return pointer(a) == pointer(b); };
    auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end(), isSame);
    auto bEnd = before.end();
    auto aEnd = after.end();
    while (bEnd != b && aEnd != a && isSame(*(bEnd - 1), *(aEnd - 1))) {
        --bEnd;
        --aEnd;
    }
    std::unordered_set<const void *> known;
    for (; b != bEnd; ++b)
        known.insert(pointer(*b));
    for (; a != aEnd; ++a) {
        if (known.count(pointer(*a)) == 0)
            found(*a);
    }
}

} // namespace

std::vector<SectionRef> changedSections(const Model &before, const Model &after)
{
    std::vector<SectionRef> changed;
    eachNew(
        before.sections(), after.sections(), [](const SectionPointer &s) { return s.get(); },
        [&](const SectionPointer &s) {
            if (!hasEqual(before, *s))
                changed.push_back(s->ref());
        });

    std::vector<StockId> stocks;
    eachNew(
        before.document.stocks, after.document.stocks, [](const auto &s) { return s.get(); },
        [&](const auto &s) { stocks.push_back(s->id); });
    if (!stocks.empty()) {
        for (std::size_t i = 0; i < after.sectionCount(); ++i) {
            if (std::find(stocks.begin(), stocks.end(), after.section(i)->stock) != stocks.end())
                changed.push_back(after.ref(i));
        }
    }
    const auto isOfJoint = [&](const JointOverridePointer &joint) {
        for (const SectionRef &ref : {joint->a, joint->b})
            if (after.indexOf(ref) >= 0)
                changed.push_back(ref);
    };
    const auto pointer = [](const JointOverridePointer &joint) { return joint.get(); };
    const auto &wantedBefore = before.document.jointOverrides,
               &wantedAfter = after.document.jointOverrides;
    eachNew(wantedBefore, wantedAfter, pointer, isOfJoint);
    eachNew(wantedAfter, wantedBefore, pointer, isOfJoint); // by itself again
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

std::vector<SectionPointer> missingSections(const Model &before, const Model &after,
                                            const Model &now)
{
    const auto sorted = [](const Model &model) {
        std::vector<SectionPointer> sections = model.sections();
        std::sort(sections.begin(), sections.end());
        return sections;
    };
    const std::vector<SectionPointer> old = sorted(before), next = sorted(after);
    std::vector<SectionPointer> touched, missing;
    std::set_symmetric_difference(old.begin(), old.end(), next.begin(), next.end(),
                                  std::back_inserter(touched));
    const std::vector<SectionPointer> present = sorted(now);
    std::set_difference(touched.begin(), touched.end(), present.begin(), present.end(),
                        std::back_inserter(missing));
    std::erase_if(missing, [&](const SectionPointer &s) {
        return hasEqual(now, *s) || (hasEqual(before, *s) && hasEqual(after, *s));
    });
    return missing;
}

std::optional<std::vector<int>> placesBefore(const Model &now, const Model &before)
{
    const std::vector<SectionPointer> &these = now.sections(), &those = before.sections();
    const std::size_t common = std::min(these.size(), those.size());
    const auto isSame = [&](const SectionPointer &a, const SectionPointer &b) {
        return a == b || a->ref() == b->ref();
    };
    const auto end = these.begin() + static_cast<std::ptrdiff_t>(common);
    if (std::equal(these.begin(), end, those.begin(), isSame))
        return std::nullopt;
    std::vector<int> places;
    places.reserve(these.size());
    for (const SectionPointer &section : these)
        places.push_back(before.indexOf(section->ref()));
    return places;
}

} // namespace fff
