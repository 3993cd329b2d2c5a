// frame_bench MODEL [TRIANGLES]: what a frame of the view costs with a mesh of a million triangles
// beside the model, and without it, while the view turns. Run by hand, on the OpenGL that there is:
//
//     xvfb-run -a build/release/tests/frame_bench resources/samples/bear.fff
#include "core/analysis/analysis.h"
#include "core/io/document_file.h"
#include "core/model/template_edits.h"
#include "core/operations/evaluate.h"
#include "core/templates/template_mesh.h"
#include "tests/core/templates/made_meshes.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/renderer.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QTextStream>

#include <algorithm>
#include <vector>

using namespace fff;
using namespace fff::ui;

namespace {

constexpr int kFrames = 15;
const Vec2 kView(1100.0, 760.0); // px

Document withMesh(Document document, int triangles)
{
    const int columns = static_cast<int>(std::sqrt(triangles / 4.0));
    Template one;
    one.name = "Ring";
    one.file = "ring.stl";
    one.mesh =
        makeTemplateMesh(test::meshOf(test::torus(80.0, 30.0, 2 * columns, columns)), {}).value();
    return addTemplate(std::move(document), stood(one, *one.mesh, UpAxis::Y, 250.0)).value();
}

/// The middle of so many frames, ms, each from a little further round.
double frame(Renderer &renderer, QOpenGLFunctions &gl, const Scene &scene, FrameQuality quality)
{
    QOpenGLFramebufferObject target(static_cast<int>(kView.x()), static_cast<int>(kView.y()),
                                    QOpenGLFramebufferObject::CombinedDepthStencil);
    Camera camera = cameraFor(scene, "iso1", kView);
    RenderOptions options;
    options.quality = quality;
    std::vector<double> times;
    for (int i = 0; i < kFrames; ++i) {
        camera.orientation =
            Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Vec3::UnitY())) * camera.orientation;
        target.bind();
        QElapsedTimer timer;
        timer.start();
        renderer.render(scene, camera, kView, 1.0, {}, options);
        gl.glFinish();
        if (i > 0) // the first one uploads
            times.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    std::nth_element(times.begin(), times.begin() + kFrames / 2, times.end());
    return times[kFrames / 2];
}

} // namespace

int main(int argc, char **argv)
{
    QGuiApplication application(argc, argv);
    QTextStream out(stdout);
    const auto loaded = io::readDocument(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString());
    if (!loaded) {
        out << "no such model\n";
        return 1;
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    QOpenGLContext context;
    context.setFormat(format);
    Renderer renderer;
    if (!context.create() || !context.makeCurrent(&surface) || !renderer.initialize()) {
        out << "no OpenGL 3.3\n";
        return 1;
    }
    const int triangles = argc > 2 ? std::atoi(argv[2]) : 1'000'000;
    Document plain = loaded->document;
    for (TemplatePointer &one : plain.templates) {
        Template hidden = *one;
        hidden.isHidden = true;
        one = std::make_shared<const Template>(hidden);
    }
    AnalysisCaches caches;
    const Scene without = sceneOf(analyse(evaluate(plain), caches));
    const Scene with = sceneOf(analyse(evaluate(withMesh(plain, triangles)), caches));
    for (const auto &[name, quality] :
         {std::pair("at rest", FrameQuality::Full), std::pair("moving", FrameQuality::Plain),
          std::pair("moving, coarse", FrameQuality::Coarse)}) {
        const double before = frame(renderer, *context.functions(), without, quality);
        const double after = frame(renderer, *context.functions(), with, quality);
        out << QString::asprintf("%-15s %7.1f ms without, %7.1f ms with: %.2f times\n", name,
                                 before, after, after / before);
        out.flush();
    }
    renderer.release();
    return 0;
}
