#include "ui/view/renderer.h"

#include "ui/view/gl.h"
#include "ui/view/ground_shadow.h"
#include "ui/view/slab_buffers.h"

#include <QOpenGLVersionFunctionsFactory>

#include <cmath>

namespace fff::ui {

namespace {

constexpr double kGhostFace = 0.26, kGhostEdge = 0.40; // of the opacity
constexpr double kEdgeOn = 1e-3;                       // sine of the angle to the ground
constexpr double kHiddenOutline = 0.4;                 // opacity
constexpr double kLeastGridRadius = 320.0;             // mm

struct Frustum
{
    Eigen::Matrix4d toClip;
    double depth = 1.0; // mm from the nearest to the farthest that is drawn
};

QVector3D rgb(const QColor &c)
{
    return {static_cast<float>(c.redF()), static_cast<float>(c.greenF()),
            static_cast<float>(c.blueF())};
}

QVector4D premultiplied(const QColor &c, double alpha = 1.0)
{
    return QVector4D(rgb(c) * static_cast<float>(alpha), static_cast<float>(alpha));
}

QColor mixed(const QColor &a, const QColor &b, double share)
{
    const auto f = static_cast<float>(share);
    return QColor::fromRgbF(a.redF() + f * (b.redF() - a.redF()),
                            a.greenF() + f * (b.greenF() - a.greenF()),
                            a.blueF() + f * (b.blueF() - a.blueF()));
}

QColor scaled(const QColor &c, double factor)
{
    return mixed(QColor(0, 0, 0), c, factor);
}

} // namespace

class Renderer::Private
{
public:
    Gl *gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> background, ground, slab, edge;
    std::unique_ptr<SlabBuffers> slabs;
    std::unique_ptr<GroundShadow> shadow;
    GLuint emptyArray = 0; // for shaders that make their vertices themselves

    Camera camera;
    Vec2 pixels = Vec2::Zero(); // device pixels
    double ratio = 1.0;
    Frustum frustum;
    Vec2 gridCentre = Vec2::Zero();
    double gridRadius = kLeastGridRadius;

    void frame(const Scene &scene, const Vec2 &viewport);
    void drawBackground(const ViewStyle &style);
    void drawGround(const ViewStyle &style);
    void useSlab(const SceneSection &section, const ViewStyle &style, double alpha);
    void fill(const SceneSection &section);
    void drawEdges(const SceneSection &section, const QVector4D &colour, double width,
                   double silhouetteWidth, double nearer);
    void drawOpaque(const Scene &scene, const ViewStyle &style);
    void drawTranslucent(const Scene &scene, const ViewStyle &style);
    void drawOutlines(const Scene &scene, const ViewStyle &style);
};

Renderer::Renderer() : d(std::make_unique<Private>()) {}
Renderer::~Renderer() = default;

bool Renderer::initialize()
{
    auto *context = QOpenGLContext::currentContext();
    d->gl = context ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
    if (!d->gl || !d->gl->initializeOpenGLFunctions()) {
        d->gl = nullptr;
        return false;
    }
    d->background = loadProgram("screen", "background");
    d->ground = loadProgram("ground", "ground");
    d->slab = loadProgram("slab", "slab");
    d->edge = loadProgram("edge", "edge");
    d->slabs = std::make_unique<SlabBuffers>(*d->gl);
    d->shadow = std::make_unique<GroundShadow>(*d->gl);
    d->gl->glGenVertexArrays(1, &d->emptyArray);
    if (!d->background || !d->ground || !d->slab || !d->edge || !d->shadow->isReady()) {
        release();
        return false;
    }
    return true;
}

void Renderer::release()
{
    if (!d->gl)
        return;
    d->gl->glDeleteVertexArrays(1, &d->emptyArray);
    d = std::make_unique<Private>();
}

void Renderer::render(const Scene &scene, const Camera &camera, const Vec2 &viewport,
                      double pixelRatio, const ViewStyle &style)
{
    if (!d->gl)
        return;
    Gl &gl = *d->gl;
    d->camera = camera;
    d->ratio = pixelRatio;
    d->pixels = viewport * pixelRatio;
    d->frame(scene, viewport);
    d->slabs->update(scene);
    // Seen from the side the ground is a line, which is not this one's to draw.
    const bool seesGround = std::abs(camera.forward().y()) > kEdgeOn;
    if (seesGround)
        d->shadow->update(scene, *d->slabs, d->emptyArray);

    gl.glViewport(0, 0, static_cast<GLsizei>(std::lround(d->pixels.x())),
                  static_cast<GLsizei>(std::lround(d->pixels.y())));
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glDisable(GL_STENCIL_TEST);
    gl.glEnable(GL_MULTISAMPLE);
    gl.glDepthMask(GL_TRUE);
    gl.glClearDepth(1.0);
    gl.glClear(GL_DEPTH_BUFFER_BIT);
    gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // everything is premultiplied
    gl.glDepthFunc(GL_LEQUAL);

    d->drawBackground(style);
    gl.glEnable(GL_DEPTH_TEST);
    d->drawOpaque(scene, style);
    if (seesGround)
        d->drawGround(style);
    d->drawTranslucent(scene, style);
    d->drawOutlines(scene, style);

    gl.glDisable(GL_DEPTH_TEST);
    gl.glDisable(GL_CULL_FACE);
    gl.glDisable(GL_BLEND);
    gl.glBindVertexArray(0);
    gl.glUseProgram(0);
}

/// Depth range and grid from what is there to see.
void Renderer::Private::frame(const Scene &scene, const Vec2 &viewport)
{
    const bool empty = scene.bounds.isEmpty();
    const Vec3 middle = empty ? Vec3::Zero() : scene.bounds.center();
    const double reach = empty ? 0.0 : 0.5 * scene.bounds.size().norm();
    gridCentre = Vec2(middle.x(), middle.z());
    gridRadius = std::max(kLeastGridRadius, 2.6 * reach);

    const double around = reach + std::abs(middle.y()) + 1.5 * gridRadius;
    const double offset = camera.backward().dot(middle - camera.target);
    frustum.depth = 2.0 * around;
    frustum.toClip = clipMatrix(camera, viewport, offset + around, around - offset);
}

void Renderer::Private::drawBackground(const ViewStyle &style)
{
    gl->glDisable(GL_DEPTH_TEST);
    gl->glDisable(GL_CULL_FACE);
    gl->glDisable(GL_BLEND);
    gl->glBindVertexArray(emptyArray);
    background->bind();
    background->setUniformValue("top", rgb(style.top));
    background->setUniformValue("bottom", rgb(style.bottom));
    gl->glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Private::drawGround(const ViewStyle &style)
{
    // 10 and 50 mm; far away 100 and 500, and so on.
    double spacing = 10.0;
    while (spacing / camera.millimetresPerPixel < 2.2)
        spacing *= 10.0;

    gl->glDisable(GL_CULL_FACE);
    gl->glEnable(GL_BLEND);
    gl->glDepthMask(GL_FALSE);
    ground->bind();
    setTransform(*ground, "toClip", frustum.toClip);
    ground->setUniformValue("centre", static_cast<float>(gridCentre.x()),
                            static_cast<float>(gridCentre.y()));
    ground->setUniformValue("radius", static_cast<float>(gridRadius));
    ground->setUniformValue("spacing", static_cast<float>(spacing));
    ground->setUniformValue("lineWidth", static_cast<float>(ratio));
    ground->setUniformValue("fine", rgb(style.gridFine));
    ground->setUniformValue("strong", rgb(style.gridStrong));
    ground->setUniformValue(
        "shadowColour", QVector4D(rgb(style.shadow), static_cast<float>(style.shadow.alphaF())));
    shadow->use(*ground);
    gl->glBindVertexArray(emptyArray);
    gl->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->glDepthMask(GL_TRUE);
    gl->glDisable(GL_BLEND);
}

void Renderer::Private::useSlab(const SceneSection &section, const ViewStyle &style, double alpha)
{
    const Eigen::Matrix4d place = slabMatrix(section);
    Eigen::Matrix3d turned;
    turned << section.frame.x, section.frame.y, section.frame.normal();
    slab->bind();
    setTransform(*slab, "toClip", frustum.toClip * place);
    setRotation(*slab, "normalToView", camera.orientation.conjugate().toRotationMatrix() * turned);
    const Eigen::Vector4f row = place.row(1).cast<float>();
    slab->setUniformValue("heightRow", row.x(), row.y(), row.z(), row.w());
    slab->setUniformValue("face", rgb(scaled(section.look.face, style.faceBrightness)));
    slab->setUniformValue("side", rgb(section.look.side));
    slab->setUniformValue("alpha", static_cast<float>(alpha));
}

void Renderer::Private::fill(const SceneSection &section)
{
    const SlabBuffers::Slab &buffers = slabs->slab(section);
    gl->glBindVertexArray(buffers.fillArray);
    gl->glDrawElements(GL_TRIANGLES, buffers.indexCount, GL_UNSIGNED_INT, nullptr);
}

/// Widths in device-independent pixels, `nearer` in mm.
void Renderer::Private::drawEdges(const SceneSection &section, const QVector4D &colour,
                                  double width, double silhouetteWidth, double nearer)
{
    const SlabBuffers::Slab &buffers = slabs->slab(section);
    const Vec3 eye = camera.backward();
    edge->bind();
    setTransform(*edge, "toClip", frustum.toClip * slabMatrix(section));
    edge->setUniformValue("eye", static_cast<float>(section.frame.x.dot(eye)),
                          static_cast<float>(section.frame.y.dot(eye)),
                          static_cast<float>(section.frame.normal().dot(eye)));
    edge->setUniformValue("viewport", static_cast<float>(pixels.x()),
                          static_cast<float>(pixels.y()));
    edge->setUniformValue("width", static_cast<float>(width * ratio));
    edge->setUniformValue("silhouetteWidth", static_cast<float>(silhouetteWidth * ratio));
    edge->setUniformValue("nearer", static_cast<float>(2.0 * nearer / frustum.depth));
    edge->setUniformValue("line", colour);
    gl->glBindVertexArray(buffers.edgeArray);
    gl->glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, buffers.edgeCount);
}

void Renderer::Private::drawOpaque(const Scene &scene, const ViewStyle &style)
{
    const auto isOpaque = [](const SceneSection &s) { return !s.isGhost && s.look.alpha >= 1.0; };
    gl->glDisable(GL_BLEND);
    gl->glEnable(GL_CULL_FACE);
    gl->glEnable(GL_POLYGON_OFFSET_FILL);
    gl->glPolygonOffset(1.0f, 1.0f); // faces give way to the lines on them
    for (const SceneSection &section : scene.sections) {
        if (isOpaque(section)) {
            useSlab(section, style, 1.0);
            fill(section);
        }
    }
    gl->glDisable(GL_POLYGON_OFFSET_FILL);
    gl->glDisable(GL_CULL_FACE);
    for (const SceneSection &section : scene.sections) {
        if (isOpaque(section))
            drawEdges(section, premultiplied(style.edge), style.edgeWidth, style.silhouetteWidth,
                      0.02);
    }
}

/// Ghosts and acrylic: first their depth alone, then only the nearest of them is blended over what
/// is there, so that the order in which they are drawn does not matter.
void Renderer::Private::drawTranslucent(const Scene &scene, const ViewStyle &style)
{
    const auto alphaOf = [](const SceneSection &s) {
        return s.look.alpha * (s.isGhost ? kGhostFace : 1.0);
    };
    std::vector<const SceneSection *> sections;
    for (const SceneSection &section : scene.sections) {
        if (alphaOf(section) < 1.0)
            sections.push_back(&section);
    }
    if (sections.empty())
        return;

    gl->glEnable(GL_CULL_FACE);
    gl->glEnable(GL_POLYGON_OFFSET_FILL);
    gl->glPolygonOffset(1.0f, 1.0f);
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const SceneSection *section : sections) {
        useSlab(*section, style, 1.0);
        fill(*section);
    }
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->glEnable(GL_BLEND);
    gl->glDepthMask(GL_FALSE);
    for (const SceneSection *section : sections) {
        useSlab(*section, style, alphaOf(*section));
        fill(*section);
    }
    gl->glDisable(GL_POLYGON_OFFSET_FILL);
    gl->glDisable(GL_CULL_FACE);
    for (const SceneSection *section : sections) {
        const double alpha = section->isGhost ? kGhostEdge : 1.0;
        drawEdges(*section, premultiplied(style.edge, alpha), style.edgeWidth,
                  style.silhouetteWidth, 0.02);
    }
    gl->glDepthMask(GL_TRUE);
    gl->glDisable(GL_BLEND);
}

void Renderer::Private::drawOutlines(const Scene &scene, const ViewStyle &style)
{
    // Opaque mixtures instead of blending: neighbouring edges overlap at their ends.
    for (const SceneSection &section : scene.sections) {
        if (section.isHovered && !section.isSelected) {
            const QColor colour = mixed(section.look.face, style.accent, 0.6);
            drawEdges(section, premultiplied(colour), style.hoverWidth, style.hoverWidth, 0.3);
        }
    }
    // Selected ones are seen through what is before them, but faintly.
    gl->glEnable(GL_BLEND);
    gl->glDepthMask(GL_FALSE);
    gl->glDepthFunc(GL_GREATER);
    for (const SceneSection &section : scene.sections) {
        if (section.isSelected)
            drawEdges(section, premultiplied(style.accent, kHiddenOutline), 1.4, 1.4, 0.4);
    }
    gl->glDepthFunc(GL_LEQUAL);
    gl->glDepthMask(GL_TRUE);
    gl->glDisable(GL_BLEND);
    for (const SceneSection &section : scene.sections) {
        if (!section.isSelected)
            continue;
        if (style.casing.isValid()) {
            const double width = style.selectionWidth + 2.0;
            drawEdges(section, premultiplied(style.casing), width, width, 0.3);
        }
        drawEdges(section, premultiplied(style.accent), style.selectionWidth, style.selectionWidth,
                  0.4);
    }
}

} // namespace fff::ui
