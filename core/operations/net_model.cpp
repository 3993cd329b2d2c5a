#include "core/operations/net_model.h"

#include "core/model/edits.h"
#include "core/model/lettering.h"
#include "core/model/marks.h"
#include "core/operations/facet_model.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Dashes of folds that rise, and gaps between them, mm.
constexpr double kDash = 3.0, kGap = 2.0;
/// Heights of numbers, mm, and as a part of their seam; a shorter seam than `kLeastSeam` has none.
constexpr double kLeastNumber = 2.0, kMostNumber = 4.0, kNumberOfSeam = 0.25, kLeastSeam = 5.0;
/// From a seam to its number, in heights.
constexpr double kNumberGap = 0.6;
/// What is left of the sheet between parts of a net beside what the cut takes away, mm.
constexpr double kNetGap = 0.2;

void addLine(const Vec2 &from, const Vec2 &to, std::vector<CurvePath> &paths)
{
    if (Result<CurvePath> path = CurvePath::fromLine({from, to}))
        paths.push_back(*std::move(path));
}

void addFold(const NetFold &fold, std::vector<CurvePath> &paths)
{
    const auto &[from, to] = fold.line;
    if (!fold.isValley)
        return addLine(from, to, paths);
    const double length = (to - from).norm();
    const Vec2 way = (to - from) / length;
    for (double at = 0.0; at < length; at += kDash + kGap)
        addLine(from + at * way, from + std::min(at + kDash, length) * way, paths);
}

/// Within the net, to be read from there.
void addNumber(const NetSeam &seam, std::vector<CurvePath> &paths)
{
    const Vec2 way = seam.line.to - seam.line.from;
    const double length = way.norm();
    if (length < kLeastSeam)
        return;
    const double height = std::clamp(kNumberOfSeam * length, kLeastNumber, kMostNumber);
    const Vec2 inwards = perpendicular(way) / length;
    Lettering number;
    number.text = std::to_string(seam.number);
    number.height = height;
    number.at = 0.5 * (seam.line.from + seam.line.to) + (0.5 + kNumberGap) * height * inwards;
    number.turn = std::atan2(way.y(), way.x());
    if (const Result<std::vector<CurvePath>> letters = letterPaths(number))
        paths.insert(paths.end(), letters->begin(), letters->end());
}

Result<Document> withMark(Document document, SectionId section, Mark::Kind kind,
                          std::vector<CurvePath> paths)
{
    if (paths.empty())
        return document;
    auto mark = std::make_shared<const Mark>(Mark{kind, std::move(paths)});
    return addMark(std::move(document), section, std::move(mark));
}

Result<Document> withLines(Document document, SectionId section, const MeshNet &net)
{
    std::vector<CurvePath> folds, numbers;
    for (const NetFold &fold : net.folds)
        addFold(fold, folds);
    for (const NetSeam &seam : net.seams)
        addNumber(seam, numbers);
    Result<Document> scored =
        withMark(std::move(document), section, Mark::Kind::Scored, std::move(folds));
    if (!scored)
        return scored;
    return withMark(*std::move(scored), section, Mark::Kind::Engraved, std::move(numbers));
}

/// On the ground, its box from the corner on.
Frame lying(const Contour &outline, double thickness, const Vec3 &corner)
{
    const Box2 box = outline.bounds();
    Frame frame{Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()};
    frame.origin = {corner.x() - box.min.x(), corner.y() + 0.5 * thickness,
                    corner.z() + box.min.y()};
    return frame;
}

Result<NetModel> modelOf(Document document, const std::vector<MeshNet> &nets,
                         const std::string &name, Vec3 corner, double thickness)
{
    NetModel model;
    std::vector<NewSection> sections;
    for (const MeshNet &net : nets) {
        Result<ShapePointer> shape = Shape::make(net.outline, net.holes);
        if (!shape)
            return tl::unexpected(std::move(shape.error()));
        NewSection section;
        section.name = name + " net " + std::to_string(sections.size() + 1);
        section.shape = *std::move(shape);
        section.frame = lying(net.outline, thickness, corner);
        corner.x() += net.outline.bounds().size().x() + kNetMargin;
        sections.push_back(std::move(section));
        model.folds += static_cast<int>(net.folds.size());
        for (const NetSeam &seam : net.seams)
            model.seams = std::max(model.seams, seam.number);
    }
    const std::size_t first = document.sections.size();
    Result<Document> next = addSections(std::move(document), std::move(sections));
    for (std::size_t i = 0; next && i < nets.size(); ++i) {
        const SectionId id = next->sections[first + i]->id;
        model.sections.push_back(id);
        next = withLines(*std::move(next), id, nets[i]);
    }
    if (!next)
        return tl::unexpected(std::move(next.error()));
    model.document = *std::move(next);
    return model;
}

} // namespace

double usualFlap(const Stock &stock)
{
    constexpr double kFlap = 8.0;
    return stock.thickness <= kThickestFlap ? kFlap : 0.0;
}

Result<NetModel> netModel(Document document, const TriangleMesh &mesh, const std::string &name,
                          const Vec3 &corner, double flap, const LongWork &work)
{
    const Stock &stock = *document.find(document.currentStock);
    const double thickness = stock.thickness;
    if (thickness > kThickestFolded)
        return failure(ErrorCode::BadValue, "thickness",
                       {std::to_string(thickness), std::to_string(kThickestFolded)});
    const std::vector<MeshFacet> facets = meshFacets(mesh);
    if (facets.size() > kMostFacets)
        return failure(ErrorCode::BadCount, name,
                       {std::to_string(facets.size()), std::to_string(kMostFacets)});
    const NetOptions options{stock.sheet - Vec2::Constant(2.0 * kNetMargin), flap,
                             stock.kerf + kNetGap};
    const Result<std::vector<MeshNet>> nets = meshNets(mesh, facets, options, work);
    if (!nets)
        return tl::unexpected(nets.error());
    if (nets->empty())
        return failure(ErrorCode::EmptyContour, name);
    return modelOf(std::move(document), *nets, name, corner, thickness);
}

} // namespace fff
