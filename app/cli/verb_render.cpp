#include "app/cli/command_line.h"
#include "app/cli/mesh_options.h"
#include "app/cli/output.h"
#include "app/cli/picture_options.h"
#include "core/analysis/checks.h"
#include "core/fabrication/wholeness.h"
#include "core/operations/evaluate.h"
#include "core/skin/skin.h"
#include "core/templates/template_mesh.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/skin_scene.h"
#include "ui/view/strained_scene.h"
#include "ui/view/stress_marks.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <vector>

namespace fff::cli {

namespace {

const QColor kProblem(0xb3, 0x26, 0x1e); // UI.md, section 4, light

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

struct Picture : PictureOptions
{
    bool showsLabels = false, showsChecks = false, showsStress = false, showsForces = false;
    bool showsSkin = false, isAccurate = false;
};

/// What was asked for, or why not.
QString readPicture(const QCommandLineParser &parser, Picture &picture)
{
    if (!parser.isSet(QStringLiteral("output")))
        return tr("-o is missing: give the file to write.");
    const QString output = parser.value(QStringLiteral("output"));
    if (output.isEmpty())
        return tr("-o: a file needs a name.");
    if (output != QStringLiteral("-") &&
        QFileInfo(output).suffix().toLower() != QStringLiteral("png"))
        return tr("%1: this kind of file cannot be written; expected .png.").arg(output);
    if (const QString reason = readPictureOptions(parser, picture); !reason.isEmpty())
        return reason;
    picture.isAccurate = parser.isSet(QStringLiteral("accurate"));
    const QString shows = parser.value(QStringLiteral("show"));
    for (const QString &what : shows.split(u',', Qt::SkipEmptyParts)) {
        if (what == QStringLiteral("labels"))
            picture.showsLabels = true;
        else if (what == QStringLiteral("checks"))
            picture.showsChecks = true;
        else if (what == QStringLiteral("stress"))
            picture.showsStress = true;
        else if (what == QStringLiteral("forces"))
            picture.showsForces = true;
        else if (what == QStringLiteral("skin"))
            picture.showsSkin = true;
        else
            return tr("--show: found \"%1\", expected labels, checks, stress, forces, skin, or "
                      "several separated by commas.")
                .arg(what);
    }
    return {};
}

/// The sections that something is wrong with.
void markProblems(const Analysis &analysis, ui::Scene &scene)
{
    for (const Finding &finding : checks(analysis)) {
        if (finding.severity != Severity::Error && finding.severity != Severity::Warning)
            continue;
        for (const SectionRef &ref : finding.sections) {
            const int index = analysis.model.indexOf(ref);
            scene.sections[static_cast<std::size_t>(index)].isSelected = true;
        }
    }
}

/// The sections' names at their middles, readable on any ground; the nearer ones where there is no
/// room for all.
void drawLabels(const Analysis &analysis, const Camera &camera, const Vec2 &viewport, QImage &image)
{
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font;
    font.setPixelSize(13);
    const QFontMetricsF metrics(font);
    const ui::ViewStyle style;
    std::vector<std::pair<double, std::size_t>> byDistance;
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const Section &section = *analysis.model.section(i);
        const Vec3 middle = section.frame.toWorld(section.shape->centroid());
        byDistance.emplace_back(camera.forward().dot(middle), i);
    }
    std::sort(byDistance.begin(), byDistance.end());
    std::vector<QRectF> taken;
    for (const auto &[distance, i] : byDistance) {
        const Section &section = *analysis.model.section(i);
        const Vec2 at = camera.toScreen(section.frame.toWorld(section.shape->centroid()), viewport);
        const QString name = QString::fromStdString(section.name);
        QRectF box = metrics.boundingRect(name);
        const QPointF start(at.x() - 0.5 * box.width(), at.y() + 0.5 * metrics.capHeight());
        box.translate(start);
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const QRectF &other) { return other.intersects(box); }))
            continue;
        taken.push_back(box);
        QPainterPath path;
        path.addText(start, font, name);
        painter.strokePath(path,
                           QPen(style.panel, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.fillPath(path, style.text);
    }
}

/// Why there is none is said; the picture is made all the same.
void showSkin(const Model &model, ui::Scene &scene, const QString &file)
{
    const Result<Skin> skin = skinOf(model.sections());
    if (!skin || !skin->mesh) {
        report(skin ? noSkin(*skin) : skin.error(), file);
        return;
    }
    if (Result<TemplateMeshPointer> mesh = makeTemplateMesh(skin->mesh, {}))
        scene.templates.push_back(ui::sceneSkin(*std::move(mesh)));
    else
        report(mesh.error(), file);
}

/// What is known of whether the model holds.
struct Strained
{
    Strength strength;
    std::shared_ptr<const BentModel> bent; // null: not asked for, or not known
};

/// Why there is nothing to be seen is said; the picture is made all the same.
Strained strained(AnalysisPointer analysis, const Picture &picture, const QString &file)
{
    StrengthRules rules;
    rules.isElastic = picture.isAccurate;
    StrengthCaches caches;
    Strained known{strengthOf(*analysis, rules, caches), nullptr};
    if (!areStressesKnown(known.strength)) {
        printError(tr("%1: no forces are shown; it does not stand, or they could not be worked "
                      "out. \"check\" says why.")
                       .arg(file));
    } else if (picture.isAccurate && picture.showsStress) {
        auto bent = bentModel(std::move(analysis), known.strength, caches);
        if (bent)
            known.bent = std::make_shared<const BentModel>(*std::move(bent));
    }
    return known;
}

void drawStrength(AnalysisPointer analysis, const Strained &known, const Picture &picture,
                  const Camera &camera, QImage &image)
{
    if (!areStressesKnown(known.strength))
        return;
    ui::StressMarks marks = ui::stressMarksOf(analysis, known.strength);
    marks.bent = known.bent;
    if (picture.showsForces) {
        marks.forces = ui::footForces(known.strength);
        for (const ui::ForceMark &mark : ui::jointForces(*analysis, known.strength))
            marks.forces.push_back(mark);
    }
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const ui::ViewStyle style;
    ui::MarkPen pen(painter, camera, picture.size, style);
    if (picture.showsStress)
        ui::paintStress(pen, marks, ViewState(), QLocale());
    else
        ui::paintForces(pen, marks.forces, false, QLocale());
}

} // namespace

int runRender(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      tr("The PNG file to write; - is standard output."),
                      QStringLiteral("OUT")});
    addPictureOptions(parser);
    parser.addOption({QStringLiteral("show"),
                      tr("labels: the sections' names; checks: outlines sections with a problem; "
                         "stress: the weakest cross-sections; forces: what feet and joints carry; "
                         "skin: the form that the sections suggest."),
                      QStringLiteral("WHAT,...")});
    parser.addOption({QStringLiteral("accurate"),
                      tr("Stress by finite elements, in colours all over the sections; takes "
                         "seconds.")});
    addTemplateOption(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("render");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    Picture picture;
    if (const QString reason = readPicture(parser, picture); !reason.isEmpty())
        return wrongUse(verb, reason);
    std::optional<int> status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    Loaded loaded = load(parsed.files.first(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    if (const auto wrong = addTemplates(loaded.document, parser, verb))
        return *wrong;

    AnalysisCaches caches;
    const auto shared =
        std::make_shared<const Analysis>(analyse(evaluate(std::move(loaded.document)), caches));
    const Analysis &analysis = *shared;
    // What could not be worked out is shown as far as it is known.
    if (const auto known = haveSolids(analysis.model, analysis.bodies); !known)
        report(known.error(), parsed.files.first());
    ui::Scene scene = ui::sceneOf(analysis);
    ui::ViewStyle style;
    if (picture.showsChecks) {
        markProblems(analysis, scene);
        style.accent = kProblem;
    }
    if (picture.showsSkin)
        showSkin(analysis.model, scene, parsed.files.first());
    Strained known;
    if (picture.showsStress || picture.showsForces) {
        known = strained(shared, picture, parsed.files.first());
        ui::showStress(scene, analysis.model, known.bent.get());
    }
    const Camera camera = ui::cameraFor(scene, picture.view.toStdString(), picture.size);
    QImage image = ui::OffscreenPainter().paint(scene, camera, picture.size, 1.0, style);
    if (image.isNull()) {
        printError(tr("A picture needs a display with OpenGL 3.3; there is none."));
        return CannotWrite;
    }
    if (picture.showsStress || picture.showsForces)
        drawStrength(shared, known, picture, camera, image);
    if (picture.showsLabels)
        drawLabels(analysis, camera, picture.size, image);
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    if (!image.save(&png, "PNG")) {
        printError(tr("The picture could not be written as a PNG file."));
        return CannotWrite;
    }
    const Result<void> written =
        io::writeFile(parser.value(QStringLiteral("output")), png.data().toStdString());
    return written ? Done : report(written.error());
}

} // namespace fff::cli
