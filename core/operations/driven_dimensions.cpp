// Lengths that stay, of two places of one drawn section: what is typed for one stretches the
// section between them.
#include "core/base/tolerances.h"
#include "core/model/symmetric_section.h"
#include "core/operations/driven_owner.h"
#include "core/operations/stretched_by_numbers.h"

#include <algorithm>
#include <cmath>

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

std::optional<DrivenLength> lengthOf(const Document &document, const Dimension &dimension)
{
    const Anchor &from = dimension.from, &to = dimension.to;
    const Section *section = document.find(from.section.drawn);
    if (!section || from.section != to.section || std::abs(from.at.z() - to.at.z()) > kSameHeight)
        return std::nullopt;
    const DrivenLength length{&dimension, section, from.at.head<2>(), to.at.head<2>()};
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

/// What is measured by hand lies hardly ever quite along an axis of the section: it is stretched
/// along that, so that right angles stay such, until the two places are as far apart as is wanted.
StretchBand bandOf(const DrivenLength &length, double wanted)
{
    const Vec2 way = length.to - length.from;
    const int axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
    const double across = std::abs(way[1 - axis]);
    StretchBand band{length.from, length.to, wanted};
    if (across > kNearlyAlong * std::abs(way[axis]) || across >= wanted)
        return band;
    band.to[1 - axis] = band.from[1 - axis];
    band.length = std::sqrt(wanted * wanted - across * across);
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

/// About its slit, as its width and height; without one about the line to which it is symmetric, or
/// the first of the two places stays.
Result<Document> writeLength(Document document, const DrivenPlace &place, const Worth &worth)
{
    const DrivenLength length = *lengthAt(document, place);
    if (!(worth.number >= kLeastLength))
        return failure(ErrorCode::BadValue, kLengthOfDimension);
    const Section section = *length.section;
    StretchBand band = bandOf(length, worth.number);
    band.mirroredAt = mirroredAt(section, band);
    band.stays = slitMiddleOn(document, section).value_or(band.mirroredAt.value_or(length.from));
    return stretchedByNumbers(std::move(document), section, {.band = band});
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
