#include "tests/core/session/suggested_forms.h"

#include "core/analysis/checks.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/holding.h"
#include "core/analysis/plan_checks.h"
#include "core/model/operation_edits.h"
#include "core/model/template_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/slices.h"
#include "core/session/finding_text.h"
#include "core/templates/template_mesh.h"
#include "tests/core/analysed.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <iterator>

namespace fff::test {

namespace {

constexpr int kPixelsAcross = 640;

struct PaintedView
{
    Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();
    Vec3 middle = Vec3::Zero();
    double pixel = 1.0; // mm

    QPointF at(const Vec3 &p) const
    {
        const Vec3 way = (p - middle) / pixel;
        return {0.5 * kPixelsAcross + right.dot(way), 0.5 * kPixelsAcross - up.dot(way)};
    }
};

QImage blank()
{
    QImage image(kPixelsAcross, kPixelsAcross, QImage::Format_Grayscale8);
    image.fill(0);
    return image;
}

QImage paintedMesh(const PaintedView &view, const Template &mesh, double ground)
{
    const Similarity toWorld = worldPlacement(mesh, *mesh.mesh);
    QImage image = blank();
    QPainter painter(&image);
    painter.setPen(Qt::white);
    painter.setBrush(Qt::white);
    for (const Triangle &t : mesh.mesh->mesh->triangles()) {
        QPolygonF polygon;
        for (const std::uint32_t corner : t) {
            Vec3 p = toWorld(mesh.mesh->mesh->positions()[corner]);
            p.y() = std::max(p.y(), ground);
            polygon << view.at(p);
        }
        painter.drawPolygon(polygon);
    }
    return image;
}

QImage paintedSections(const PaintedView &view, const std::vector<SectionPointer> &sections)
{
    QImage image = blank();
    QPainter painter(&image);
    painter.setPen(Qt::white);
    painter.setBrush(Qt::white);
    for (const SectionPointer &section : sections) {
        QPainterPath path;
        const auto add = [&](const Contour &contour) {
            QPolygonF polygon;
            for (const Vec2 &p : contour.polygon(0.05))
                polygon << view.at(section->frame.toWorld(p));
            path.addPolygon(polygon);
            path.closeSubpath();
        };
        add(section->shape->contour());
        for (const Contour &hole : section->shape->holes())
            add(hole);
        painter.drawPath(path);
    }
    return image;
}

bool isWhite(const QImage &image, int x, int y)
{
    return image.valid(x, y) && image.constScanLine(y)[x] > 127;
}

bool hasWhiteNear(const QImage &image, int x, int y, double radius)
{
    const int reach = static_cast<int>(radius);
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            if (dx * dx + dy * dy <= radius * radius && isWhite(image, x + dx, y + dy))
                return true;
    return false;
}

Model evenGrid(const Document &document, int planes)
{
    Operation slices;
    slices.id = {document.nextId};
    slices.kind = "slices";
    slices.version = 1;
    slices.name = "Slices";
    slices.parameters = {{"direction", std::string("xz")}, {"count", double(planes)}};
    slices.subject = document.templates.front()->id;
    Document next = document;
    next.operations.push_back(std::make_shared<const Operation>(slices));
    ++next.nextId;
    return evaluate(next);
}

} // namespace

Document documentWith(const MadeForm &form, double size)
{
    Template one;
    one.name = form.name;
    one.file = std::string(form.name) + ".obj";
    one.mesh = makeTemplateMesh(mended(form.draft).value().mesh, {}).value();
    return addTemplate(newDocument(),
                       stood(one, *one.mesh, form.isUpright ? UpAxis::Y : UpAxis::Z, size))
        .value();
}

Model slicesOf(const Document &document, const std::string &direction, int planes)
{
    Operation slices = newOperation(kSlices);
    slices.name = "Slices";
    slices.subject = document.templates.front()->id;
    slices.parameters.insert_or_assign("direction", direction);
    slices.parameters.insert_or_assign("count", double(planes));
    return evaluate(addOperation(document, std::move(slices)));
}

Model evenGridOf(const Document &document, std::size_t sections)
{
    Model best = evenGrid(document, 1);
    const auto off = [sections](const Model &model) {
        return std::abs(double(model.sectionCount()) - double(sections));
    };
    for (int planes = 2; planes <= int(sections) / 2; ++planes)
        if (Model grid = evenGrid(document, planes); off(grid) <= off(best))
            best = std::move(grid);
    return best;
}

QStringList faultsOf(const Model &model)
{
    const Analysis analysis = analysed(model);
    const ModelPlan plan = planOf(analysis);
    std::vector<Finding> all = checks(analysis);
    const std::vector<Finding> planned = planChecks(analysis, plan);
    all.insert(all.end(), planned.begin(), planned.end());
    const Holding held = holdingOf(std::make_shared<const Analysis>(analysis), {},
                                   std::make_shared<StrengthCaches>());
    // That something is near its strength is told, and no reason to show less.
    std::copy_if(held.findings.begin(), held.findings.end(), std::back_inserter(all),
                 [](const Finding &finding) { return finding.severity == Severity::Error; });
    QStringList faults;
    for (const Finding &finding : all)
        if (finding.severity >= Severity::Warning || finding.severity == Severity::Unknown)
            faults += QStringLiteral("%1: ").arg(QLatin1String(finding.kind->name)) +
                      findingText(finding, analysis.model);
    if (plan.plan.verdict != AssemblyPlan::Verdict::Possible)
        faults += QStringLiteral("there is no order of assembly");
    if (analysis.bodies.size() != model.sectionCount())
        faults += QStringLiteral("sections fall into pieces");
    if (heldGroups(analysis.bodies, analysis.assembly.joints, analysis.grips).size() != 1)
        faults += QStringLiteral("not all pieces are held");
    if (std::none_of(all.begin(), all.end(), [](const Finding &f) { return f.is(kStands); }))
        faults += QStringLiteral("it does not stand");
    return faults;
}

bool isGrave(const QString &fault)
{
    return !fault.startsWith(QLatin1String(kThinWeb.name));
}

double silhouetteShown(const Template &mesh, const std::vector<SectionPointer> &sections,
                       double ground)
{
    const Box3 box = worldBounds(mesh, *mesh.mesh);
    long all = 0, shown = 0;
    for (int i = 0; i < 12; ++i) {
        const double around = std::numbers::pi * i / 6.0;
        const double above = std::numbers::pi / 180.0 * std::array{0.0, 25.0, 50.0}[i % 3];
        const Vec3 from(std::cos(above) * std::cos(around), std::sin(above),
                        std::cos(above) * std::sin(around));
        PaintedView view;
        view.right = Vec3::UnitY().cross(from).normalized();
        view.up = from.cross(view.right);
        view.middle = box.center();
        view.pixel = 1.1 * box.size().norm() / kPixelsAcross;
        const QImage whole = paintedMesh(view, mesh, ground),
                     found = paintedSections(view, sections);
        for (int y = 0; y < kPixelsAcross; ++y)
            for (int x = 0; x < kPixelsAcross; ++x) {
                const bool isEdge = isWhite(whole, x, y) &&
                                    !(isWhite(whole, x - 1, y) && isWhite(whole, x + 1, y) &&
                                      isWhite(whole, x, y - 1) && isWhite(whole, x, y + 1));
                if (!isEdge)
                    continue;
                ++all;
                shown += hasWhiteNear(found, x, y, 3.0 / view.pixel);
            }
    }
    return all > 0 ? double(shown) / double(all) : 0.0;
}

} // namespace fff::test
