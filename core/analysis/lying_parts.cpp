#include "core/analysis/lying_parts.h"

#include "core/model/sheet_edits.h"

#include <algorithm>
#include <map>

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

/// Of the same stock, no side of its box moved by more than a kerf or a slit's play may move it.
bool isAbout(const Part &a, const Part &b)
{
    constexpr double kLittle = 2.0; // mm
    const Box2 box = bounds(a.outline.region.outer), other = bounds(b.outline.region.outer);
    return a.stock == b.stock && (box.min - other.min).cwiseAbs().maxCoeff() <= kLittle &&
           (box.max - other.max).cwiseAbs().maxCoeff() <= kLittle;
}

/// Where each part lay on the sheets of its stock; those that fit none left out.
std::map<int, PinnedPart> places(const LyingParts &before)
{
    std::map<int, PinnedPart> all;
    for (const Sheet &sheet : before.layout.sheets) {
        if (sheet.placements.empty())
            continue;
        const std::vector<int> &oversized = before.layout.oversized;
        if (std::find(oversized.begin(), oversized.end(), sheet.placements.front().part) !=
            oversized.end())
            continue;
        for (const Placement &placement : sheet.placements)
            all[placement.part] = {placement.part, sheet.index, placement.turn, placement.offset,
                                   true};
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

void addWishes(const Model &model, const BodiesOfParts &bodies, NestOptions &options)
{
    options.pinned.clear();
    for (const PinnedPlace &one : model.document.pins)
        if (const auto part = bodies.partOf.find({one.section, one.body});
            part != bodies.partOf.end())
            options.pinned.push_back({part->second, one.sheet, one.turn, one.offset, false});
    options.turnings.clear();
    if (model.document.turnings.empty())
        return;
    for (const BodiesOfParts::Body &body : bodies.ofPart) {
        const Section *section = model.find(body.first);
        options.turnings.push_back((section ? turningOf(model.document, *section) : std::nullopt)
                                       .value_or(options.turning));
    }
}

bool mayLieSo(const PinnedPart &part, const NestOptions &options)
{
    const auto index = static_cast<std::size_t>(part.part);
    const nest::Turning turning =
        index < options.turnings.size() ? options.turnings[index] : options.turning;
    const std::vector<Vec2> turns = nest::turnsOf(turning);
    return turning == nest::Turning::Free ||
           std::any_of(turns.begin(), turns.end(), [&](const Vec2 &turn) {
               return (turn - part.turn).norm() <= kPinnedTurnError;
           });
}

std::vector<PinnedPlace> layBeforePins(const LyingParts &before,
                                       const std::vector<PinnedPlace> &known,
                                       const Document &document)
{
    std::vector<PinnedPlace> all;
    if (document.pins.empty())
        return all;
    const std::map<int, PinnedPart> lying = places(before);
    const BodiesOfParts old = bodiesOfParts(before.model, before.parts);
    for (const PinnedPlace &pin : document.pins) {
        const auto same = std::find_if(known.begin(), known.end(), [&](const PinnedPlace &one) {
            return one.section == pin.section && one.body == pin.body;
        });
        if (same != known.end()) {
            all.push_back(*same);
            continue;
        }
        const auto part = old.partOf.find({pin.section, pin.body});
        if (part == old.partOf.end() || pinOf(before.model.document, pin.section, pin.body))
            continue;
        if (const auto place = lying.find(part->second); place != lying.end())
            all.push_back({pin.section, pin.body, place->second.sheet, place->second.turn,
                           place->second.offset});
    }
    return all;
}

void goBack(const std::vector<PinnedPlace> &layBefore, const BodiesOfParts &bodies,
            std::vector<PinnedPart> &lying)
{
    for (const PinnedPlace &one : layBefore) {
        const auto part = bodies.partOf.find({one.section, one.body});
        if (part == bodies.partOf.end())
            continue;
        for (PinnedPart &place : lying)
            if (place.part == part->second)
                place = {part->second, one.sheet, one.turn, one.offset, true};
    }
}

std::vector<PinnedPart> layBefore(const LyingParts &before, const std::vector<Part> &parts,
                                  const BodiesOfParts &bodies)
{
    const BodiesOfParts old = bodiesOfParts(before.model, before.parts);
    std::vector<PinnedPart> all;
    for (auto [index, place] : places(before)) {
        const auto was = static_cast<std::size_t>(index);
        const auto now = bodies.partOf.find(old.ofPart[was]);
        if (now == bodies.partOf.end() ||
            !isAbout(parts[static_cast<std::size_t>(now->second)], before.parts[was]))
            continue;
        place.part = now->second;
        all.push_back(place);
    }
    return all;
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
