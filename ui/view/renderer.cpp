#include "ui/view/renderer.h"

#include "ui/view/ground_painter.h"
#include "ui/view/marks_over.h"
#include "ui/view/occlusion.h"
#include "ui/view/section_passes.h"
#include "ui/view/template_painter.h"
#include "ui/view/thing_painter.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLVersionFunctionsFactory>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kEdgeOn = 1e-3;       // sine of the angle to the ground
constexpr double kShadeRadius = 0.055; // of the model's diagonal: how far corners are darkened
/// Drawn pixels a device-independent one that smooth edges take.
constexpr double kSmooth = 2.0;
constexpr double kMostPixels = 24e6;

/// All that the picture below the outlines depends on.
struct Picture
{
    std::vector<SceneSection> sections;
    std::vector<SceneThing> things;
    std::vector<SceneTemplate> templates;
    std::vector<SceneFlat> flats;
    Camera camera;
    Vec2 viewport = Vec2::Zero();
    double pixelRatio = 0.0;
    ViewStyle style;
    RenderOptions options;

    bool isOf(const Scene &scene, const Camera &c, const Vec2 &size, double ratio,
              const ViewStyle &s, const RenderOptions &o) const
    {
        return camera == c && viewport == size && pixelRatio == ratio && style == s &&
               options == o && things == scene.things && templates == scene.templates &&
               flats == scene.flats &&
               std::equal(
                   sections.begin(), sections.end(), scene.sections.begin(), scene.sections.end(),
                   [](const SceneSection &a, const SceneSection &b) { return a.looksTheSame(b); });
    }
};

} // namespace

class Renderer::Private
{
public:
    explicit Private(Gl &functions)
        : gl(functions), background(loadProgram("screen", "background")),
          copy(loadProgram("screen", "copy")), pass(gl), slabs(gl), sections(gl, pass, slabs),
          things(gl), templates(gl), flats(gl), ground(gl, pass), occlusion(gl, pass), over(gl),
          picture(gl, GL_RGBA8, true, GL_LINEAR), rest(gl, GL_RGBA8, true, GL_LINEAR),
          shown(gl, GL_RGBA8, true, GL_LINEAR)
    {
    }
    bool isReady() const
    {
        return background && copy && sections.isReady() && things.isReady() &&
               templates.isReady() && flats.isReady() && ground.isReady() && occlusion.isReady() &&
               over.isReady();
    }

    void look(const Scene &scene, const Camera &camera, const Vec2 &viewport, double ratio,
              const RenderOptions &options);
    void beginOn(RenderTarget &target, const Scene &scene, const ViewStyle &style,
                 const RenderOptions &options);
    void drawPicture(const Scene &scene, const ViewStyle &style, const RenderOptions &options);
    void drawBackground(const ViewStyle &style);
    void show(const RenderTarget &image);
    const RenderTarget &base() const { return hasLayers ? rest : picture; }

    Gl &gl;
    std::unique_ptr<QOpenGLShaderProgram> background, copy;
    ScreenPass pass;
    SlabBuffers slabs;
    SectionPasses sections;
    ThingPainter things;
    TemplatePainter templates;
    FlatPainter flats;
    GroundPainter ground;
    Occlusion occlusion;
    MarksOver over;

    RenderTarget picture; // what is opaque, smooth: at a higher resolution than is shown
    RenderTarget rest;    // with what lets light through, whose edges are smooth by themselves
    RenderTarget shown;   // with the outlines of what is selected and hovered
    std::optional<Picture> drawn;
    int drawCount = 0;

    QSize pixels; // of the framebuffer
    FrameView view;
    bool hasLayers = false; // something lets light through
    double diagonal = 0.0;  // of the model, mm
};

Renderer::Renderer() = default;
Renderer::~Renderer() = default;

bool Renderer::initialize()
{
    auto *context = QOpenGLContext::currentContext();
    Gl *gl = context ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
    if (!gl || !gl->initializeOpenGLFunctions())
        return false;
    d = std::make_unique<Private>(*gl);
    if (!d->isReady())
        d.reset();
    context->functions()->glReleaseShaderCompiler(); // there is nothing more to compile
    return d != nullptr;
}

void Renderer::release()
{
    d.reset();
}

void Renderer::tidy()
{
    if (!d || !d->drawn || d->picture.isEmpty())
        return;
    const BoundTarget target(d->gl);
    if (!d->hasLayers) { // as smooth as it is shown, and small
        d->rest.resize(d->pixels);
        d->rest.copyFrom(d->picture);
        d->hasLayers = true;
    }
    d->picture.free();
    d->shown.free();
    d->sections.tidy();
    target.restore();
}

int Renderer::uploadCount() const
{
    return d ? d->slabs.uploadCount() : 0;
}

int Renderer::drawCount() const
{
    return d ? d->drawCount : 0;
}

void Renderer::render(const Scene &scene, const Camera &camera, const Vec2 &viewport,
                      double pixelRatio, const ViewStyle &style, const RenderOptions &options)
{
    if (!d)
        return;
    Gl &gl = d->gl;
    const BoundTarget target(gl);
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glDisable(GL_STENCIL_TEST);
    gl.glDisable(GL_BLEND);
    gl.glDepthMask(GL_TRUE);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.glClearDepth(1.0);
    gl.glBlendEquation(GL_FUNC_ADD);
    gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // everything is premultiplied
    gl.glDepthFunc(GL_LEQUAL);

    if (!d->drawn || !d->drawn->isOf(scene, camera, viewport, pixelRatio, style, options)) {
        d->slabs.update(scene);
        d->things.update(scene.things);
        d->templates.update(scene.templates);
        d->flats.update(scene.flats);
        d->look(scene, camera, viewport, pixelRatio, options);
        d->drawPicture(scene, style, options);
        d->drawn = {scene.sections, scene.things, scene.templates, scene.flats, camera,
                    viewport,       pixelRatio,   style,           options};
        ++d->drawCount;
    }
    const bool hasOutlines =
        std::any_of(scene.sections.begin(), scene.sections.end(), [](const SceneSection &s) {
            return s.isSelected || s.isHovered || s.isSibling;
        });
    if (hasOutlines) {
        d->shown.resize(d->pixels);
        d->shown.copyFrom(d->base());
        d->beginOn(d->shown, scene, style, options);
        d->sections.drawOutlines();
    }
    target.restore();
    gl.glViewport(0, 0, d->pixels.width(), d->pixels.height());
    d->show(hasOutlines ? d->shown : d->base());

    gl.glDisable(GL_DEPTH_TEST);
    gl.glDisable(GL_CULL_FACE);
    gl.glDisable(GL_BLEND);
    gl.glBindVertexArray(0);
    gl.glUseProgram(0);
}

void Renderer::drawOver(const QImage &marks)
{
    if (d)
        d->over.draw(marks);
}

/// Resolution, depth range and grid from what is there to see.
void Renderer::Private::look(const Scene &scene, const Camera &camera, const Vec2 &viewport,
                             double pixelRatio, const RenderOptions &options)
{
    // As smooth as memory allows: a large picture for a file has pixels enough.
    const double room = std::sqrt(kMostPixels / std::max(1.0, viewport.x() * viewport.y()));
    const double ratio = options.quality == FrameQuality::Full
                             ? std::max(std::min(kSmooth, room), pixelRatio)
                         : options.quality == FrameQuality::Plain ? pixelRatio
                                                                  : 0.5 * pixelRatio;
    const auto size = [&](double r) {
        const auto side = [&](double n) {
            return std::max(1, static_cast<int>(std::lround(n * r)));
        };
        return QSize(side(viewport.x()), side(viewport.y()));
    };
    pixels = size(pixelRatio);
    picture.resize(size(ratio));
    rest.resize(size(std::min(ratio, pixelRatio)));

    const Box3 bounds = scene.allBounds();
    const bool empty = bounds.isEmpty();
    const Vec3 middle = empty ? Vec3::Zero() : bounds.center();
    const double reach = empty ? 0.0 : 0.5 * bounds.size().norm();
    diagonal = 2.0 * reach;
    ground.place(scene.bounds);

    const double around = reach + std::abs(middle.y()) + 1.5 * ground.radius();
    const double offset = camera.backward().dot(middle - camera.target);
    view.camera = camera;
    view.viewport = viewport;
    view.toClip = clipMatrix(camera, viewport, offset + around, around - offset);
    view.clip = options.clip;
}

void Renderer::Private::beginOn(RenderTarget &target, const Scene &scene, const ViewStyle &style,
                                const RenderOptions &options)
{
    target.bind();
    view.pixels = Vec2(target.size().width(), target.size().height());
    sections.begin(scene, view, style, options);
}

void Renderer::Private::drawPicture(const Scene &scene, const ViewStyle &style,
                                    const RenderOptions &options)
{
    // Seen from the side the ground is a line, which is not this one's to draw.
    const Camera &camera = view.camera;
    const double rise = camera.isPerspective()
                            ? camera.eye(view.viewport).y() / camera.eyeDistance(view.viewport)
                            : camera.backward().y();
    const bool seesGround = options.hasGround && std::abs(rise) > kEdgeOn;
    if (seesGround)
        ground.updateShadow(scene, slabs);

    beginOn(picture, scene, style, options);
    gl.glClear(GL_DEPTH_BUFFER_BIT);
    drawBackground(style);
    sections.drawOpaque();
    if (options.quality == FrameQuality::Full)
        occlusion.darken(picture, view, kShadeRadius * diagonal);
    if (seesGround)
        ground.draw(view, style);
    sections.drawOpaqueEdges();
    hasLayers = sections.hasLayers() || things.isAny() || templates.isAny() || flats.isAny();
    if (hasLayers) {
        rest.copyFrom(picture);
        beginOn(rest, scene, style, options);
        sections.drawLayers(rest, picture);
        rest.bind();
        if (things.isAny())
            things.draw(view);
        if (flats.isAny())
            flats.draw(view);
        if (templates.isAny())
            templates.draw(view, style, options.quality);
    }
}

void Renderer::Private::drawBackground(const ViewStyle &style)
{
    gl.glDisable(GL_DEPTH_TEST);
    gl.glDisable(GL_CULL_FACE);
    gl.glDisable(GL_BLEND);
    background->bind();
    background->setUniformValue("top", rgb(style.top));
    background->setUniformValue("bottom", rgb(style.bottom));
    pass.draw();
}

/// Twice as many points as pixels are smoothed to their mean.
void Renderer::Private::show(const RenderTarget &image)
{
    gl.glDisable(GL_DEPTH_TEST);
    copy->bind();
    pass.setTexture(*copy, "image", 0, image.colour());
    pass.draw();
}

} // namespace fff::ui
