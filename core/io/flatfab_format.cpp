#include "core/io/flatfab_format.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/io/flatfab_text.h"

#include <Eigen/Geometry>
#include <QtCore/QCoreApplication>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace fff::io {

namespace {

/// The last point of a curve repeats the first: they may be this far apart, mm. Both were printed
/// from one number, to six digits.
constexpr double kClosingGap = 0.01;

/// How far T, N, B are from three orthonormal axes (no unit). N gives a direction only.
double skewness(const FlatfabSection &section, const Frame &frame)
{
    const double normalOff = (section.n.stableNormalized() - frame.normal()).norm();
    return std::max({std::abs(section.t.stableNorm() - 1.0), std::abs(section.b.stableNorm() - 1.0),
                     std::abs(section.t.stableNormalized().dot(section.b.stableNormalized())),
                     normalOff});
}

double perimeter(const Polygon &polygon)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
    return sum;
}

/// What reaches beyond the contour is no more than a rim of the width of kCutChord.
bool liesInside(const Contour &hole, const Contour &contour)
{
    double outside = 0.0;
    for (const CurvedRegion &piece : subtract(hole, {contour}, {}, kCutChord))
        outside += area(piece.region);
    return outside <= kMinArea + kCutChord * perimeter(hole.flatten(kCutChord).points);
}

class SectionBuilder
{
public:
    SectionBuilder(const FlatfabSection &source, std::string name, double unitMm,
                   Problems &problems)
        : m_source(source), m_name(std::move(name)), m_unitMm(unitMm), m_problems(problems)
    {
    }

    /// Null with an error in the problems.
    std::shared_ptr<Section> build();

private:
    void fail(int line, const Error &error);
    void warn(WarningCode code, int line, std::vector<std::string> more = {});
    bool makeSectionFrame();
    Result<Contour> contourOf(const FlatfabCurve &curve);
    bool addHole(const FlatfabCurve &curve, const Contour &contour, std::vector<Contour> &holes);

    const FlatfabSection &m_source;
    std::string m_name;
    double m_unitMm;
    Problems &m_problems;
    Frame m_frame;
};

void SectionBuilder::fail(int line, const Error &error)
{
    m_problems.fail(error.code, std::to_string(line), error.args);
}

void SectionBuilder::warn(WarningCode code, int line, std::vector<std::string> more)
{
    more.insert(more.begin(), m_name);
    m_problems.warn(code, std::to_string(line), std::move(more));
}

bool SectionBuilder::makeSectionFrame()
{
    const Vec3 origin = m_unitMm * m_source.p;
    if (!(origin.cwiseAbs().maxCoeff() <= kMaxCoordinate)) {
        fail(m_source.line, {ErrorCode::BadValue,
                             {},
                             {shortNumber(origin.cwiseAbs().maxCoeff()),
                              QT_TRANSLATE_NOOP("Error", "a length of at most 1000000 mm")}});
        return false;
    }
    const Result<Frame> frame = makeFrame(origin, m_source.t, m_source.b);
    if (!frame) {
        fail(m_source.line, frame.error());
        return false;
    }
    m_frame = *frame;
    if (const double skew = skewness(m_source, m_frame); skew > kFrameRounding)
        warn(WarningCode::SkewFrame, m_source.line, {shortNumber(skew)});
    return true;
}

/// uT + vB in the coordinates of the frame. Its x and y span the plane of T and B, so nothing is
/// lost however T and B stand to each other.
Result<Contour> SectionBuilder::contourOf(const FlatfabCurve &curve)
{
    const Vec2 t = m_frame.directionToLocal(m_source.t);
    const Vec2 b = m_frame.directionToLocal(m_source.b);
    std::vector<Vec2> points;
    points.reserve(curve.points.size());
    for (const Vec2 &p : curve.points) {
        points.push_back(m_unitMm * (p.x() * t + p.y() * b));
        const double size = points.back().cwiseAbs().maxCoeff();
        if (!(size <= kMaxCoordinate) || !points.back().allFinite())
            return failure(
                ErrorCode::BadValue, {},
                {shortNumber(size), QT_TRANSLATE_NOOP("Error", "a length of at most 1000000 mm")});
    }
    if (const double gap = (points.back() - points.front()).norm(); gap > kClosingGap)
        return failure(ErrorCode::BadContour, {},
                       {shortNumber(gap) + " mm",
                        QT_TRANSLATE_NOOP("Error", "a last control point that repeats the first")});
    points.pop_back();
    return Contour::fromPoints(std::move(points));
}

/// False with an error in the problems. A hole that cannot be one is left out with a warning.
bool SectionBuilder::addHole(const FlatfabCurve &curve, const Contour &contour,
                             std::vector<Contour> &holes)
{
    const Result<Contour> drawn = contourOf(curve);
    if (!drawn) {
        fail(curve.line, drawn.error());
        return false;
    }
    Result<ResolvedContour> hole = resolveCrossings(*drawn);
    if (!hole || std::abs(hole->contour.signedArea()) < kMinArea) {
        warn(WarningCode::DegenerateHole, curve.line);
        return true;
    }
    if (!liesInside(hole->contour, contour)) {
        warn(WarningCode::HoleOutside, curve.line);
        return true;
    }
    if (hole->wasCrossing)
        warn(WarningCode::SelfCrossingContour, curve.line);
    holes.push_back(std::move(hole->contour));
    return true;
}

std::shared_ptr<Section> SectionBuilder::build()
{
    if (!makeSectionFrame())
        return nullptr;
    const FlatfabCurve &outer = m_source.curves.front();
    Result<ResolvedContour> contour = contourOf(outer).and_then(resolveCrossings);
    if (!contour) {
        fail(outer.line, contour.error());
        return nullptr;
    }
    if (contour->wasCrossing)
        warn(WarningCode::SelfCrossingContour, outer.line);
    std::vector<Contour> holes;
    for (std::size_t i = 1; i < m_source.curves.size(); ++i) {
        if (!addHole(m_source.curves[i], contour->contour, holes))
            return nullptr;
    }
    Result<ShapePointer> shape = Shape::make(std::move(contour->contour), std::move(holes));
    if (!shape) {
        fail(outer.line, shape.error());
        return nullptr;
    }
    auto section = std::make_shared<Section>();
    section->name = m_name;
    section->frame = m_frame;
    section->shape = *std::move(shape);
    return section;
}

} // namespace

bool looksLikeFlatfab(std::string_view bytes)
{
    bytes = withoutByteOrderMark(bytes);
    bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
    return bytes.starts_with("HeaderParameters");
}

Result<LoadedDocument> readFlatfab(std::string_view bytes, const std::string &name,
                                   const FlatfabOptions &options)
{
    assert(options.unitMm > 0.0 && std::isfinite(options.unitMm) && "a unit has a length");
    Problems problems{.file = name};
    const std::vector<FlatfabSection> sources = parseFlatfab(bytes, problems);
    if (problems.failed())
        return tl::unexpected(*problems.error);

    Document document;
    Stock stock = flatfabAcrylic();
    stock.id = StockId{document.nextId++};
    document.currentStock = stock.id;
    document.stocks.push_back(std::make_shared<const Stock>(std::move(stock)));
    document.sections.reserve(sources.size());
    for (const FlatfabSection &source : sources) {
        const std::string sectionName = "Section " + std::to_string(document.sections.size() + 1);
        const auto section = SectionBuilder(source, sectionName, options.unitMm, problems).build();
        if (!section)
            return tl::unexpected(*problems.error);
        section->id = SectionId{document.nextId++};
        section->stock = document.currentStock;
        document.sections.push_back(section);
    }
    // Trailing lines were found before the sections were made: back into file order.
    const auto isTrailing = [](const Warning &w) { return w.code == WarningCode::TrailingLines; };
    std::stable_partition(problems.warnings.begin(), problems.warnings.end(),
                          [&](const Warning &w) { return !isTrailing(w); });
    return LoadedDocument{std::move(document), std::move(problems.warnings),
                          ModelFormat::Flatfab};
}

} // namespace fff::io
