// Lengths that stay, of two places of one drawn section: what is typed for one stretches the
// section between them.
#include "core/base/tolerances.h"
#include "core/geometry/contour_points.h"
#include "core/geometry/turning.h"
#include "core/model/bindings.h"
#include "core/model/symmetric_section.h"
#include "core/operations/driven_owner.h"
#include "core/operations/stretched_by_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace fff {

namespace {

constexpr const char *kLengthOfDimension = "length";
/// Places this near to each other have no direction that one could stretch in, mm.
constexpr double kLeastLength = 1e-3;
/// Tangent of the angle to an axis of its section within which a length is along that: 5 degrees.
constexpr double kNearlyAlong = 0.0875;
/// Places are on one plane of a section where their heights above it differ by less, mm.
constexpr double kSameHeight = 1e-6;

struct DrivenLength
{
    const Dimension *dimension = nullptr;
    const Section *section = nullptr;
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

/// Left before right, below before above: it does not matter from which end it was measured, and
/// what stands goes on standing.
bool isBefore(const Frame &frame, const Vec2 &a, const Vec2 &b)
{
    const Vec2 way = b - a;
    const bool isAcross = std::abs(way.x()) >= std::abs(way.y());
    const bool hangsDown = (isAcross ? frame.x : frame.y).y() < -0.5;
    return ((isAcross ? way.x() : way.y()) > 0.0) != hangsDown;
}

std::optional<DrivenLength> lengthOf(const Document &document, const Dimension &dimension)
{
    const Anchor &from = dimension.from, &to = dimension.to;
    const Section *section = document.find(from.section.drawn);
    if (!section || from.section != to.section || std::abs(from.at.z() - to.at.z()) > kSameHeight)
        return std::nullopt;
    DrivenLength length{&dimension, section, from.at.head<2>(), to.at.head<2>()};
    if (!isBefore(section->frame, length.from, length.to))
        std::swap(length.from, length.to);
    return (length.to - length.from).norm() >= kLeastLength ? std::optional(length) : std::nullopt;
}

std::optional<DrivenLength> lengthAt(const Document &document, const DrivenPlace &place)
{
    const auto found =
        std::find_if(document.dimensions.begin(), document.dimensions.end(),
                     [&place](const Dimension &one) { return one.id.value == place.id; });
    return found == document.dimensions.end() ? std::nullopt : lengthOf(document, *found);
}

std::optional<DrivenNumber> readLength(const Document &document, const DrivenPlace &place)
{
    const std::optional<DrivenLength> length =
        place.field == kLengthOfDimension ? lengthAt(document, place) : std::nullopt;
    if (!length)
        return std::nullopt;
    return DrivenNumber{ValueKind::Length,
                        worthOf(ValueKind::Length, (length->to - length->from).norm()),
                        FFF_TEXT("Driven", "Dimension")};
}

bool isNearlyAlong(const Vec2 &way, int axis)
{
    return std::abs(way[1 - axis]) <= kNearlyAlong * std::abs(way[axis]);
}

/// Its straight edges lie along both of its axes, rather than along the way or across it: what
/// stretches it along the way makes its right angles others.
bool hasRightAnglesToKeep(const Section &section, const Vec2 &way)
{
    const Vec2 along = way.normalized();
    Vec2 alongAxes = Vec2::Zero();
    double alongWay = 0.0;
    const Contour &contour = section.shape->contour();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier segment = contour.segment(i);
        if (!isLine(segment))
            continue;
        const Vec2 edge = segment.p3 - segment.p0;
        const Vec2 onWay(edge.dot(along), cross(along, edge));
        for (const int axis : {0, 1}) {
            if (isNearlyAlong(edge, axis))
                alongAxes[axis] += edge.norm();
            if (isNearlyAlong(onWay, axis))
                alongWay += edge.norm();
        }
    }
    return alongAxes.minCoeff() > 0.0 && alongAxes.sum() > alongWay;
}

/// An expression says how large the section is along the axis.
bool isSizeDriven(const Document &document, const DrivenLength &length, int axis)
{
    return bindingOf(document, {.of = DrivenPlace::Of::Section,
                                .id = length.section->id.value,
                                .field = axis == 0 ? "width" : "height"});
}

/// An expression says how long another length along the axis is.
bool isOtherDriven(const Document &document, const DrivenLength &length, int axis)
{
    return std::any_of(
        document.dimensions.begin(), document.dimensions.end(), [&](const Dimension &other) {
            const auto known =
                other.id == length.dimension->id ? std::nullopt : lengthOf(document, other);
            return known && known->section == length.section &&
                   isNearlyAlong(known->to - known->from, axis) &&
                   bindingOf(document, {.of = DrivenPlace::Of::Dimension,
                                        .id = other.id.value,
                                        .field = kLengthOfDimension});
        });
}

struct Stretch
{
    StretchBand band;
    bool staysAtFrom = false; // whatever else would stay
};

/// Along an axis, so that the two places are that far apart on it.
StretchBand bandAlong(const DrivenLength &length, int axis, double wanted)
{
    StretchBand band{length.from, length.to, wanted};
    band.to[1 - axis] = band.from[1 - axis];
    return band;
}

/// One half of a symmetric section: the other one does the same. Nothing where the line would not
/// stay one, or lies between the two places.
std::optional<Vec2> mirroredAt(const Section &section, const StretchBand &band)
{
    const MirrorAxis *axis = symmetryOf(section);
    if (!axis || std::abs(axis->direction.dot(band.along())) > kPracticallyParallel)
        return std::nullopt;
    const double from = axis->height(band.from), to = axis->height(band.to);
    const bool isBetween = std::min(from, to) < -kEqualEnds && std::max(from, to) > kEqualEnds;
    return isBetween ? std::nullopt : std::optional(axis->point);
}

/// Of a section whose size along the axis is driven, too: what lies before the two places and what
/// lies behind them make room in proportion. So its ends stay where they are, whatever the length
/// was before. None: there is no room.
std::vector<Stretch> stretchesWithin(const DrivenLength &length, int axis, double wanted)
{
    const StretchBand alone = bandAlong(length, axis, wanted);
    const Box2 box = turnedBounds(length.section->shape->contour(), Vec2::UnitX());
    const double low = std::min(length.from[axis], length.to[axis]);
    const double high = std::max(length.from[axis], length.to[axis]);
    const double before = std::max(low - box.min[axis], 0.0);
    const double behind = std::max(box.max[axis] - high, 0.0);
    if (before + behind < kLeastLength || mirroredAt(*length.section, alone))
        return {{alone}};
    const double factor = (before + behind + (high - low) - wanted) / (before + behind);
    if (factor * (before + behind) < kLeastLength)
        return {};
    const auto band = [&](double from, double to, double becomes) {
        StretchBand one{length.from, length.from, becomes};
        one.from[axis] = from;
        one.to[axis] = to;
        return Stretch{one, true};
    };
    std::vector<Stretch> stretches{band(low, high, wanted)};
    if (behind >= kLeastLength)
        stretches.push_back(band(low + wanted, low + wanted + behind, factor * behind));
    if (before >= kLeastLength)
        stretches.push_back(band(low - before, low, factor * before));
    return stretches;
}

/// What makes the length as long as is wanted; none: it cannot be.
/// What is measured by hand lies hardly ever quite along an axis of the section: it is stretched
/// along that, so that right angles stay such. One that is aslant is stretched along both axes, or
/// along the one that no other expression drives, where right angles have to be kept.
std::vector<Stretch> stretchesOf(const Document &document, const DrivenLength &length,
                                 double wanted)
{
    const Vec2 way = length.to - length.from;
    const auto along = [&](int axis, double reach) -> std::vector<Stretch> {
        return isSizeDriven(document, length, axis)
                   ? stretchesWithin(length, axis, reach)
                   : std::vector<Stretch>{{bandAlong(length, axis, reach)}};
    };
    const auto alone = [&](int axis) -> std::vector<Stretch> {
        const double across = std::abs(way[1 - axis]);
        return across < wanted ? along(axis, std::sqrt(wanted * wanted - across * across))
                               : std::vector<Stretch>();
    };
    const std::vector<Stretch> straight{{StretchBand{length.from, length.to, wanted}}};
    for (const int axis : {0, 1})
        if (isNearlyAlong(way, axis))
            return std::abs(way[1 - axis]) < wanted ? alone(axis) : straight;
    const bool keepsAngles = hasRightAnglesToKeep(*length.section, way);
    const auto isDriven = [&](int axis) {
        return isSizeDriven(document, length, axis) ||
               (keepsAngles && isOtherDriven(document, length, axis));
    };
    if (isDriven(0) != isDriven(1))
        return alone(isDriven(0) ? 1 : 0);
    if (!isDriven(0) && !keepsAngles)
        return straight;
    std::vector<Stretch> both;
    const double factor = wanted / way.norm();
    for (const int axis : {0, 1}) {
        const std::vector<Stretch> one = along(axis, factor * std::abs(way[axis]));
        if (one.empty())
            return {};
        both.insert(both.end(), one.begin(), one.end());
    }
    return both;
}

/// About its slit, as its width and height; without one about the line to which it is symmetric, or
/// the first of the two places stays.
Result<Document> writeLength(Document document, const DrivenPlace &place, const Worth &worth)
{
    const DrivenLength length = *lengthAt(document, place);
    const std::vector<Stretch> stretches = worth.number >= kLeastLength
                                               ? stretchesOf(document, length, worth.number)
                                               : std::vector<Stretch>();
    if (stretches.empty())
        return failure(ErrorCode::BadValue, kLengthOfDimension);
    const SectionId id = length.section->id;
    Result<Document> next = std::move(document);
    for (std::size_t i = 0; next && i < stretches.size(); ++i) {
        const Section section = *next->find(id);
        StretchBand band = stretches[i].band;
        band.stays = band.from;
        if (!stretches[i].staysAtFrom) {
            band.mirroredAt = mirroredAt(section, band);
            band.stays = slitHolding(*next, section, band.along())
                             .value_or(band.mirroredAt.value_or(band.from));
        }
        next = stretchedByNumbers(*std::move(next), section, {.band = band});
    }
    return next;
}

void listLengths(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const Dimension &dimension : document.dimensions)
        if (lengthOf(document, dimension))
            places.push_back({.of = DrivenPlace::Of::Dimension,
                              .id = dimension.id.value,
                              .field = kLengthOfDimension});
}

std::string nameOfSection(const Document &document, const DrivenPlace &place)
{
    const std::optional<DrivenLength> length = lengthAt(document, place);
    return length ? length->section->name : std::string();
}

} // namespace

const DrivenOwner kDrivenDimensions{readLength, writeLength, listLengths, nameOfSection};

} // namespace fff
