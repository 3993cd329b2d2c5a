#include "core/analysis/lying_parts.h"

#include <algorithm>

namespace fff {

namespace {

/// So many parts, or this share of all, may be others than before: with more, what comes of keeping
/// the rest is no good any more.
constexpr std::size_t kFewParts = 3;
constexpr double kFewShare = 0.1;

bool isTheSame(const Part &a, const Part &b)
{
    return a.stock == b.stock && a.outline.outer == b.outline.outer &&
           a.outline.holes == b.outline.holes;
}

/// Where each part lay on the sheets of its stock; those that fit none left out.
std::map<int, PinnedPart> places(const LyingParts &before)
{
    std::map<int, PinnedPart> all;
    std::map<StockId, int> sheets;
    for (const Sheet &sheet : before.layout.sheets) {
        if (sheet.placements.empty())
            continue;
        const std::vector<int> &oversized = before.layout.oversized;
        if (std::find(oversized.begin(), oversized.end(), sheet.placements.front().part) !=
            oversized.end())
            continue;
        const int index = sheets[sheet.stock]++;
        for (const Placement &placement : sheet.placements)
            all[placement.part] = {placement.part, index, placement.turn, placement.offset, true};
    }
    return all;
}

} // namespace

BodiesOfParts bodiesOfParts(const Model &model, const std::vector<Part> &parts)
{
    BodiesOfParts bodies;
    std::map<int, int> counts; // by section
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int section = parts[i].section;
        const BodiesOfParts::Body body{model.ref(static_cast<std::size_t>(section)),
                                       counts[section]++};
        bodies.ofPart.push_back(body);
        bodies.partOf[body] = static_cast<int>(i);
    }
    return bodies;
}

std::vector<PinnedPart> pinnedParts(const std::vector<PinnedBody> &pinned,
                                    const BodiesOfParts &bodies)
{
    std::vector<PinnedPart> parts;
    for (const PinnedBody &one : pinned)
        if (const auto part = bodies.partOf.find({one.section, one.body});
            part != bodies.partOf.end())
            parts.push_back({part->second, one.sheet, one.turn, one.offset, false});
    return parts;
}

std::optional<std::vector<PinnedPart>>
lyingStill(const LyingParts &before, const std::vector<Part> &parts, const BodiesOfParts &bodies)
{
    const BodiesOfParts old = bodiesOfParts(before.model, before.parts);
    std::vector<PinnedPart> changed, kept;
    std::size_t stayed = 0;
    for (const auto &[index, place] : places(before)) {
        const auto now = bodies.partOf.find(old.ofPart[static_cast<std::size_t>(index)]);
        if (now == bodies.partOf.end())
            continue;
        const Part &part = parts[static_cast<std::size_t>(now->second)];
        const Part &was = before.parts[static_cast<std::size_t>(index)];
        if (part.stock != was.stock)
            continue;
        PinnedPart pinned = place;
        pinned.part = now->second;
        const bool isSame = isTheSame(part, was);
        stayed += isSame ? 1 : 0;
        (isSame ? kept : changed).push_back(pinned);
    }
    const std::size_t most = std::max(before.parts.size(), parts.size());
    const auto few =
        std::max(kFewParts, static_cast<std::size_t>(kFewShare * static_cast<double>(most)));
    if (most - stayed > few)
        return std::nullopt;
    // Where two clash, the later one goes.
    kept.insert(kept.end(), changed.begin(), changed.end());
    return kept;
}

} // namespace fff
