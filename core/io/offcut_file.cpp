#include "core/io/offcut_file.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/tangle.h"
#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "core/io/svg_format.h"
#include "core/io/svg_reader.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtCore/QLocale>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace fff::io {

namespace {

struct OffcutTexts
{
    Q_DECLARE_TR_FUNCTIONS(Offcut)
};

/// A line of the drawing and what it encloses, closed as it would be to fill it.
struct Enclosing
{
    std::vector<CurvedRegion> regions; // largest first; never none
    double gap = 0.0;                  // mm between its ends

    double area() const { return regions.front().outer.signedArea(); }
    bool isOpen() const { return gap > 0.0; }
};

/// Nothing for what encloses no area.
Result<std::optional<Enclosing>> enclosing(const CurvePath &line)
{
    std::vector<Vec2> points = line.points();
    Enclosing made;
    if (!line.isClosed()) {
        const CubicBezier closing = CubicBezier::line(points.back(), points.front());
        made.gap = (points.back() - points.front()).norm();
        points.insert(points.end(), {closing.p1, closing.p2, closing.p3});
    }
    const Result<CurvePath> closed = CurvePath::fromPoints(std::move(points));
    const Result<Contour> ring = closed ? closed->ring() : tl::unexpected(closed.error());
    if (!ring)
        return tl::unexpected(ring.error());
    if (crossingWork(*ring) > kMostCrossingWork)
        return failure(ErrorCode::NotWorkedOut);
    const Result<ResolvedContour> whole = resolveCrossings(*ring);
    if (!whole && whole.error().code == ErrorCode::EmptyContour)
        return std::nullopt;
    if (!whole)
        return tl::unexpected(whole.error());
    if (!whole->wasCrossing) {
        // As it is drawn, to the last bit.
        Contour outer = ring->signedArea() < 0.0 ? ring->reversed() : *ring;
        Region region{outer.flatten(kCutChord).points, {}};
        made.regions.push_back({std::move(outer), {}, std::move(region)});
        return made;
    }
    auto regions = windingRegions({*ring}, WindingRule::NonZero, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    made.regions = *std::move(regions);
    return made.regions.empty() ? std::optional<Enclosing>() : std::optional(std::move(made));
}

double areaOf(const std::vector<CurvedRegion> &regions)
{
    double sum = 0.0;
    for (const CurvedRegion &region : regions)
        sum += area(region.region);
    return sum;
}

double lengthOf(const Polygon &ring)
{
    double length = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        length += (ring[i] - ring[j]).norm();
    return length;
}

/// Whether the line is the outline once more, as programs that draw plans do: of the outline less
/// is left than ends that meet may be off, all along it.
Result<bool> isDrawnAgain(const CurvedRegion &outline, const Contour &line)
{
    const double rim = kDrawnGap * lengthOf(outline.region.outer);
    if (line.signedArea() < outline.outer.signedArea() - rim)
        return false;
    return subtractContours(outline.outer, {}, {line}, kCutChord).map([&](const auto &left) {
        return areaOf(left) < rim;
    });
}

struct Left
{
    Outline outline;
    bool isCrossing = false; // its outline crossed itself
    std::size_t pieces = 1;  // of which this is the largest
    bool hasOpen = false;    // lines that take something of it
};

Result<Left> leftOf(std::vector<Enclosing> lines)
{
    const auto largest =
        std::max_element(lines.begin(), lines.end(), [](const Enclosing &a, const Enclosing &b) {
            return a.area() < b.area();
        });
    if (largest == lines.end())
        return failure(ErrorCode::EmptyContour);
    if (largest->isOpen())
        return failure(ErrorCode::EmptyContour, {},
                       {QString::number(largest->gap, 'f', 2).toStdString()});
    std::iter_swap(lines.begin(), largest);
    const CurvedRegion &whole = lines.front().regions.front();
    Left left{{whole.outer, whole.holes, false}, lines.front().regions.size() > 1, 1, false};
    std::vector<Contour> cuts = whole.holes;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        bool isCut = false;
        for (const CurvedRegion &region : lines[i].regions) {
            if (nesting(whole.outer, region.outer, kCutChord) == Nesting::Apart)
                continue;
            const Result<bool> again = isDrawnAgain(whole, region.outer);
            if (!again)
                return tl::unexpected(again.error());
            if (*again)
                continue;
            cuts.push_back(region.outer);
            isCut = true;
        }
        left.hasOpen = left.hasOpen || (isCut && lines[i].isOpen());
    }
    left.pieces = lines.front().regions.size();
    if (cuts.size() == whole.holes.size())
        return left;
    const auto pieces = subtractContours(whole.outer, {}, cuts, kCutChord);
    if (!pieces)
        return tl::unexpected(pieces.error());
    if (pieces->empty())
        return failure(ErrorCode::EmptyContour);
    left.outline = {pieces->front().outer, pieces->front().holes, false};
    left.pieces += pieces->size() - 1;
    return left;
}

Result<Left> leftIn(const SvgDrawing &drawing)
{
    std::vector<CurvePath> lines;
    for (const SvgDrawing::Line &line : drawing.lines)
        lines.push_back(line.path);
    std::vector<Enclosing> enclosed;
    for (const CurvePath &line : joined(std::move(lines), kDrawnGap)) {
        auto one = enclosing(line);
        if (!one)
            return tl::unexpected(one.error());
        if (*one)
            enclosed.push_back(**std::move(one));
    }
    return leftOf(std::move(enclosed));
}

QStringList remarksOn(const Left &left, const SpareSheet &spare, const QString &file,
                      const SvgDrawing &drawing)
{
    const auto number = [](double mm) { return QLocale().toString(mm, 'f', 1); };
    const QString width = number(spare.size().x()), height = number(spare.size().y());
    QStringList remarks;
    if (!drawing.isTrueSize)
        //: %1 is a file's name, %2 x %3 the size of an offcut
        remarks += OffcutTexts::tr("%1 does not say how large it is in mm or inches; the offcut is "
                                   "taken as %2 × %3 mm.")
                       .arg(file, width, height);
    if (left.pieces > 1)
        remarks +=
            (left.isCrossing
                 //: %1 is a file's name, %2 x %3 the size of an offcut
                 ? OffcutTexts::tr("%1: the outline crosses itself; the largest piece of it is "
                                   "taken, %2 × %3 mm.")
                 //: %1 is a file's name, %2 x %3 the size of an offcut
                 : OffcutTexts::tr("%1: lines cut the offcut into pieces; the largest is taken, "
                                   "%2 × %3 mm."))
                .arg(file, width, height);
    if (left.hasOpen)
        //: %1 is a file's name
        remarks += OffcutTexts::tr("%1: lines in the offcut are open; what they would enclose if "
                                   "they were closed is left free.")
                       .arg(file);
    return remarks;
}

Result<SpareSheet> offcutIn(const SvgDrawing &drawing, const QString &file, int count,
                            QStringList *remarks)
{
    const Result<Left> left = leftIn(drawing);
    if (!left)
        return tl::unexpected(left.error());
    Result<SpareSheet> spare = spareSheet(left->outline, count);
    if (!spare && spare.error().code == ErrorCode::BadContour)
        return failure(ErrorCode::BoundariesMeet); // what is left hangs together by a point
    if (spare && remarks)
        *remarks += remarksOn(*left, *spare, file, drawing);
    return spare;
}

} // namespace

Result<SpareSheet> readOffcut(const QString &path, int count, QStringList *remarks)
{
    const std::string name = path.toStdString();
    Result<SpareSheet> spare = readFile(path).and_then([&](const std::string &bytes) {
        return svgFormat().readDrawing(bytes, name).and_then([&](const SvgDrawing &drawing) {
            return offcutIn(drawing, QFileInfo(path).fileName(), count, remarks);
        });
    });
    if (!spare && spare.error().place.empty())
        spare.error().place = name;
    return spare;
}

} // namespace fff::io
