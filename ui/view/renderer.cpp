#include "ui/view/renderer.h"

#include "ui/view/cap_buffers.h"
#include "ui/view/ground_shadow.h"
#include "ui/view/layers.h"
#include "ui/view/occlusion.h"

#include <QOpenGLVersionFunctionsFactory>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kGhostFace = 0.26, kGhostEdge = 0.40; // opacity
constexpr double kXrayFace = 0.20, kXrayEdge = 0.60;
constexpr double kEdgeOn = 1e-3;           // sine of the angle to the ground
constexpr double kHiddenOutline = 0.4;     // opacity
constexpr double kLeastGridRadius = 320.0; // mm
constexpr double kShadeRadius = 0.055;     // of the model's diagonal: how far corners are darkened
/// Layers of what lets light through: behind so many, next to nothing is seen.
constexpr int kAcrylicLayers = 4, kXrayLayers = 6;
/// Drawn pixels a device-independent one that smooth edges take.
constexpr double kSmooth = 2.0;
constexpr double kMostPixels = 24e6;

QColor scaled(const QColor &c, double factor)
{
    const auto f = static_cast<float>(factor);
    return QColor::fromRgbF(f * c.redF(), f * c.greenF(), f * c.blueF());
}

/// All that the picture below the outlines depends on.
struct Picture
{
    std::vector<SceneSection> sections;
    Camera camera;
    Vec2 viewport = Vec2::Zero();
    double pixelRatio = 0.0;
    ViewStyle style;
    RenderOptions options;

    bool isOf(const Scene &scene, const Camera &c, const Vec2 &size, double ratio,
              const ViewStyle &s, const RenderOptions &o) const
    {
        return camera == c && viewport == size && pixelRatio == ratio && style == s &&
               options == o &&
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
          ground(loadProgram("ground", "ground")), copy(loadProgram("screen", "copy")), pass(gl),
          slabs(gl), painter(gl, slabs), shadow(gl, pass), occlusion(gl, pass), layers(gl, pass),
          caps(gl), picture(gl, GL_RGBA8, true, GL_LINEAR), rest(gl, GL_RGBA8, true, GL_LINEAR),
          shown(gl, GL_RGBA8, true, GL_LINEAR)
    {
    }
    bool isReady() const
    {
        return background && ground && copy && painter.isReady() && shadow.isReady() &&
               occlusion.isReady() && layers.isReady() && caps.isReady();
    }

    void look(const Scene &scene, const Camera &camera, const Vec2 &viewport, double ratio,
              const RenderOptions &options);
    void beginOn(RenderTarget &target, const Scene &scene);
    void drawPicture(const Scene &scene, const ViewStyle &style, const RenderOptions &options);
    void drawBackground(const ViewStyle &style);
    void drawGround(const ViewStyle &style);
    void drawOpaque(const Scene &scene, const ViewStyle &style, const RenderOptions &options);
    void drawOpaqueEdges(const Scene &scene, const ViewStyle &style);
    void drawTranslucent(const Scene &scene, const ViewStyle &style, const RenderOptions &options);
    void drawGhosts(const Scene &scene, const ViewStyle &style);
    void drawOutlines(const Scene &scene, const ViewStyle &style);
    void show(const RenderTarget &image);
    const RenderTarget &base() const { return hasLayers ? rest : picture; }

    /// Pixels that a line reaches over its surface: so many slopes the surface is set back.
    float setBack(const ViewStyle &style) const
    {
        return static_cast<float>(0.5 * style.silhouetteWidth * view.ratio() + 0.5);
    }
    /// How a section is drawn.
    enum class Kind { None, Opaque, Translucent, Ghost };
    Kind kindOf(std::size_t section, const Scene &scene) const;
    SlabLook lookOf(const SceneSection &section, const ViewStyle &style, double alpha) const;
    EdgeLook edgesOf(const SceneSection &section, const ViewStyle &style, double alpha) const;

    Gl &gl;
    std::unique_ptr<QOpenGLShaderProgram> background, ground, copy;
    ScreenPass pass;
    SlabBuffers slabs;
    SlabPainter painter;
    GroundShadow shadow;
    Occlusion occlusion;
    Layers layers;
    CapBuffers caps;

    RenderTarget picture; // what is opaque, smooth: at a higher resolution than is shown
    RenderTarget rest;    // with what lets light through, whose edges are smooth by themselves
    RenderTarget shown;   // with the outlines of what is selected and hovered
    std::optional<Picture> drawn;
    int drawCount = 0;

    QSize pixels; // of the framebuffer
    FrameView view;
    bool isXray = false;
    bool hasLayers = false; // something lets light through
    Vec2 gridCentre = Vec2::Zero();
    double gridRadius = kLeastGridRadius;
    double diagonal = 0.0; // of the model, mm
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
    return d != nullptr;
}

void Renderer::release()
{
    d.reset();
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
        d->look(scene, camera, viewport, pixelRatio, options);
        d->drawPicture(scene, style, options);
        d->drawn = {scene.sections, camera, viewport, pixelRatio, style, options};
        ++d->drawCount;
    }
    const bool hasOutlines =
        std::any_of(scene.sections.begin(), scene.sections.end(),
                    [](const SceneSection &s) { return s.isSelected || s.isHovered; });
    if (hasOutlines) {
        d->shown.resize(d->pixels);
        d->shown.copyFrom(d->base());
        d->beginOn(d->shown, scene);
        d->drawOutlines(scene, style);
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

    const bool empty = scene.bounds.isEmpty();
    const Vec3 middle = empty ? Vec3::Zero() : scene.bounds.center();
    const double reach = empty ? 0.0 : 0.5 * scene.bounds.size().norm();
    diagonal = 2.0 * reach;
    gridCentre = Vec2(middle.x(), middle.z());
    gridRadius = std::max(kLeastGridRadius, 2.6 * reach);

    const double around = reach + std::abs(middle.y()) + 1.5 * gridRadius;
    const double offset = camera.backward().dot(middle - camera.target);
    view.camera = camera;
    view.viewport = viewport;
    view.toClip = clipMatrix(camera, viewport, offset + around, around - offset);
    view.clip = options.clip;
    isXray = options.isXray;
}

void Renderer::Private::beginOn(RenderTarget &target, const Scene &scene)
{
    target.bind();
    view.pixels = Vec2(target.size().width(), target.size().height());
    painter.begin(view, scene);
}

Renderer::Private::Kind Renderer::Private::kindOf(std::size_t index, const Scene &scene) const
{
    const SceneSection &section = scene.sections[index];
    if (!painter.isSeen(index))
        return Kind::None;
    if (section.isGhost)
        return Kind::Ghost;
    return isXray || section.look.alpha < 1.0 ? Kind::Translucent : Kind::Opaque;
}

SlabLook Renderer::Private::lookOf(const SceneSection &section, const ViewStyle &style,
                                   double alpha) const
{
    if (section.isProblem)
        return {style.problemFace, style.problemSide, alpha, style.problemHatch};
    return {scaled(section.look.face, style.faceBrightness), section.look.side, alpha, QColor()};
}

EdgeLook Renderer::Private::edgesOf(const SceneSection &section, const ViewStyle &style,
                                    double alpha) const
{
    return {premultiplied(section.isProblem ? style.problem : style.edge, alpha), style.edgeWidth,
            style.silhouetteWidth, 0.02};
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
        shadow.update(scene, slabs);

    beginOn(picture, scene);
    gl.glClear(GL_DEPTH_BUFFER_BIT);
    drawBackground(style);
    if (options.clip) {
        caps.update(scene, *options.clip, style);
        gl.glEnable(GL_CLIP_DISTANCE0);
    }
    drawOpaque(scene, style, options);
    if (options.quality == FrameQuality::Full)
        occlusion.darken(picture, view, kShadeRadius * diagonal);
    gl.glEnable(GL_DEPTH_TEST);
    if (seesGround)
        drawGround(style);
    if (options.clip)
        gl.glEnable(GL_CLIP_DISTANCE0);
    drawOpaqueEdges(scene, style);
    hasLayers = false;
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        const Kind kind = kindOf(i, scene);
        hasLayers = hasLayers || kind == Kind::Translucent || kind == Kind::Ghost;
    }
    if (hasLayers) {
        rest.copyFrom(picture);
        beginOn(rest, scene);
        drawTranslucent(scene, style, options);
        drawGhosts(scene, style);
    }
    gl.glDisable(GL_CLIP_DISTANCE0);
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

void Renderer::Private::drawGround(const ViewStyle &style)
{
    // 10 and 50 mm; far away 100 and 500, and so on.
    double spacing = 10.0;
    while (spacing / view.camera.millimetresPerPixel < 2.2)
        spacing *= 10.0;

    gl.glDisable(GL_CLIP_DISTANCE0);
    gl.glDisable(GL_CULL_FACE);
    gl.glEnable(GL_BLEND);
    gl.glDepthMask(GL_FALSE);
    ground->bind();
    ground->setUniformValue("toClip", toFloat(view.toClip));
    ground->setUniformValue("centre", static_cast<float>(gridCentre.x()),
                            static_cast<float>(gridCentre.y()));
    ground->setUniformValue("radius", static_cast<float>(gridRadius));
    ground->setUniformValue("spacing", static_cast<float>(spacing));
    ground->setUniformValue("lineWidth", static_cast<float>(view.ratio()));
    ground->setUniformValue("fine", rgb(style.gridFine));
    ground->setUniformValue("strong", rgb(style.gridStrong));
    ground->setUniformValue(
        "shadowColour", QVector4D(rgb(style.shadow), static_cast<float>(style.shadow.alphaF())));
    shadow.use(*ground);
    gl.glBindVertexArray(pass.array());
    gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.glDepthMask(GL_TRUE);
    gl.glDisable(GL_BLEND);
}

void Renderer::Private::drawOpaque(const Scene &scene, const ViewStyle &style,
                                   const RenderOptions &options)
{
    gl.glEnable(GL_DEPTH_TEST);
    gl.glEnable(GL_CULL_FACE);
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (kindOf(i, scene) != Kind::Opaque)
            continue;
        // Faces give way to the lines on them; and where two sections lie in one plane, one of them
        // does to the other, always the same.
        gl.glPolygonOffset(setBack(style), 1.0f + 4.0f * static_cast<float>(i % 8));
        painter.fill(i, lookOf(scene.sections[i], style, 1.0));
    }
    gl.glPolygonOffset(setBack(style), 1.0f);
    if (options.clip) {
        gl.glDisable(GL_CLIP_DISTANCE0);
        caps.fill(view);
        gl.glEnable(GL_CLIP_DISTANCE0);
    }
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glDisable(GL_CULL_FACE);
}

void Renderer::Private::drawOpaqueEdges(const Scene &scene, const ViewStyle &style)
{
    gl.glEnable(GL_BLEND);
    gl.glDepthMask(GL_FALSE);
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (kindOf(i, scene) == Kind::Opaque)
            painter.edges(i, edgesOf(scene.sections[i], style, 1.0));
    }
    if (view.clip && caps.edgeCount() > 0)
        painter.edges(
            caps.edgeArray(), caps.edgeCount(),
            {premultiplied(style.edge), style.silhouetteWidth, style.silhouetteWidth, 0.05});
    gl.glDepthMask(GL_TRUE);
    gl.glDisable(GL_BLEND);
}

void Renderer::Private::drawTranslucent(const Scene &scene, const ViewStyle &style,
                                        const RenderOptions &options)
{
    std::vector<std::size_t> sections;
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (kindOf(i, scene) == Kind::Translucent)
            sections.push_back(i);
    }
    if (sections.empty())
        return;
    const auto drawAll = [&] {
        gl.glEnable(GL_CULL_FACE);
        for (const std::size_t i : sections) {
            const SceneSection &section = scene.sections[i];
            painter.fill(i, lookOf(section, style, isXray ? kXrayFace : section.look.alpha));
        }
        gl.glDisable(GL_CULL_FACE);
        for (const std::size_t i : sections)
            painter.edges(i, edgesOf(scene.sections[i], style, isXray ? kXrayEdge : 1.0));
    };
    if (options.quality == FrameQuality::Full) {
        layers.draw(rest, painter, isXray ? kXrayLayers : kAcrylicLayers, drawAll);
    } else if (isXray) {
        // All of them in any order: most are of one colour, which comes to the same.
        gl.glEnable(GL_DEPTH_TEST);
        gl.glDepthMask(GL_FALSE);
        gl.glEnable(GL_BLEND);
        drawAll();
        gl.glDisable(GL_BLEND);
        gl.glDepthMask(GL_TRUE);
    }
    gl.glPolygonOffset(setBack(style), 1.0f);
    if (isXray)
        return;
    // Their depths, so that outlines and ghosts behind them are told from those before them.
    rest.bind();
    gl.glEnable(GL_DEPTH_TEST);
    gl.glEnable(GL_CULL_FACE);
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const std::size_t i : sections)
        painter.fill(i, {});
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (options.quality != FrameQuality::Full) {
        // The nearest ones alone.
        gl.glEnable(GL_BLEND);
        gl.glDepthMask(GL_FALSE);
        drawAll();
        gl.glDepthMask(GL_TRUE);
        gl.glDisable(GL_BLEND);
    }
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glDisable(GL_CULL_FACE);
    // Half of a line at a silhouette lies beyond its slab; what shines through was drawn over it.
    drawOpaqueEdges(scene, style);
}

/// Only the nearest of them, once, so that many ghosts are no thicker than one.
void Renderer::Private::drawGhosts(const Scene &scene, const ViewStyle &style)
{
    std::vector<std::size_t> ghosts;
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (kindOf(i, scene) == Kind::Ghost)
            ghosts.push_back(i);
    }
    if (ghosts.empty())
        return;
    rest.bind();
    gl.glEnable(GL_DEPTH_TEST);
    gl.glEnable(GL_CULL_FACE);
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    gl.glPolygonOffset(setBack(style), 1.0f);
    gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const std::size_t i : ghosts)
        painter.fill(i, {});
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.glEnable(GL_BLEND);
    gl.glDepthMask(GL_FALSE);
    for (const std::size_t i : ghosts)
        painter.fill(i, lookOf(scene.sections[i], style, kGhostFace));
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glDisable(GL_CULL_FACE);
    for (const std::size_t i : ghosts)
        painter.edges(i, edgesOf(scene.sections[i], style, kGhostEdge));
    gl.glDepthMask(GL_TRUE);
    gl.glDisable(GL_BLEND);
    rest.copyDepthFrom(picture); // a ghost covers no outline
}

void Renderer::Private::drawOutlines(const Scene &scene, const ViewStyle &style)
{
    gl.glEnable(GL_DEPTH_TEST);
    gl.glEnable(GL_BLEND);
    gl.glDepthMask(GL_FALSE);
    if (view.clip)
        gl.glEnable(GL_CLIP_DISTANCE0);
    // Wide lines reach far over slanted surfaces: nearer by as many pixels.
    const double pixel = view.camera.millimetresPerPixel;
    const auto outline = [&](std::size_t i, const QColor &colour, double alpha, double width,
                             double nearer) {
        painter.edges(i, {premultiplied(colour, alpha), width, width, nearer + width * pixel});
    };
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (!scene.sections[i].isHovered || scene.sections[i].isSelected)
            continue;
        if (style.casesHover && style.casing.isValid())
            outline(i, style.casing, 1.0, style.hoverWidth + 2.0, 0.2);
        outline(i, style.accent, style.hoverAlpha, style.hoverWidth, 0.3);
    }
    // Selected ones are seen through what is before them, but faintly.
    gl.glDepthFunc(GL_GREATER);
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (scene.sections[i].isSelected)
            outline(i, style.accent, kHiddenOutline, 1.4, 0.4);
    }
    gl.glDepthFunc(GL_LEQUAL);
    for (std::size_t i = 0; i < scene.sections.size(); ++i) {
        if (!scene.sections[i].isSelected)
            continue;
        if (style.casing.isValid())
            outline(i, style.casing, 1.0, style.selectionWidth + 2.0, 0.3);
        outline(i, style.accent, 1.0, style.selectionWidth, 0.4);
    }
    gl.glDisable(GL_CLIP_DISTANCE0);
    gl.glDepthMask(GL_TRUE);
    gl.glDisable(GL_DEPTH_TEST);
    gl.glDisable(GL_BLEND);
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
