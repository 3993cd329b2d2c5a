#include "core/io/flatfab_format.h"

#include "core/base/tolerances.h"
#include "core/io/flatfab_text.h"
#include "core/model/mended_shape.h"

#include <Eigen/Geometry>
#include <QtCore/QCoreApplication>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

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

std::shared_ptr<Section> SectionBuilder::build()
{
    if (!makeSectionFrame())
        return nullptr;
    std::vector<PlacedContour> curves;
    for (const FlatfabCurve &curve : m_source.curves) {
        Result<Contour> contour = contourOf(curve);
        if (!contour) {
            fail(curve.line, contour.error());
            return nullptr;
        }
        curves.push_back({*std::move(contour), std::to_string(curve.line)});
    }
    const std::vector<PlacedContour> holes(curves.begin() + 1, curves.end());
    std::vector<Warning> mended;
    Result<ShapePointer> shape = makeMendedShape(curves.front(), holes, m_name, mended);
    m_problems.warn(mended);
    if (!shape) {
        fail(m_source.curves.front().line, shape.error());
        return nullptr;
    }
    auto section = std::make_shared<Section>();
    section->name = m_name;
    section->frame = m_frame;
    section->shape = *std::move(shape);
    return section;
}

/// Shapes that sections share where they are equal: the format writes each down.
class SharedShapes
{
public:
    ShapePointer of(const ShapePointer &shape)
    {
        const Vec2 start = shape->contour().points().front();
        const auto [known, isNew] =
            m_shapes.try_emplace({shape->area(), start.x(), start.y()}, shape);
        return isNew || *known->second == *shape ? known->second : shape;
    }

private:
    std::map<std::array<double, 3>, ShapePointer> m_shapes;
};

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
    SharedShapes shapes;
    for (const FlatfabSection &source : sources) {
        const std::string sectionName =
            numberedName(options.naming.section, document.sections.size() + 1);
        const auto section = SectionBuilder(source, sectionName, options.unitMm, problems).build();
        if (!section)
            return tl::unexpected(*problems.error);
        section->id = SectionId{document.nextId++};
        section->stock = document.currentStock;
        section->shape = shapes.of(section->shape);
        document.sections.push_back(section);
    }
    // Trailing lines were found before the sections were made: back into file order.
    const auto isTrailing = [](const Warning &w) { return w.code == WarningCode::TrailingLines; };
    std::stable_partition(problems.warnings.begin(), problems.warnings.end(),
                          [&](const Warning &w) { return !isTrailing(w); });
    return LoadedDocument{std::move(document), std::move(problems.warnings)};
}

const Format &flatfabFormat()
{
    constexpr double kSmallestUnit = 1e-6; // mm
    static const char *const kUnit = "unit-mm";
    static const Format format = {
        .key = "flatfab",
        .suffixes = {"txt"},
        .program = "FlatFab",
        .options = {{.name = kUnit,
                     .value = "MM",
                     .help = QT_TRANSLATE_NOOP("CommandLine",
                                               "Millimetres per unit of a FlatFab file (25.4)."),
                     .least = kSmallestUnit,
                     .most = kMaxCoordinate,
                     .of = FormatOption::Of::Reading}},
        .recognises = looksLikeFlatfab,
        .readModel = [](std::string_view bytes, const std::string &name,
                        const ReadOptions &options) {
            FlatfabOptions flatfab;
            if (const auto unit = options.values.find(kUnit); unit != options.values.end())
                flatfab.unitMm = unit->second;
            flatfab.naming = options.naming;
            return readFlatfab(bytes, name, flatfab);
        }};
    return format;
}

} // namespace fff::io
