#include "ui/view/offscreen_image.h"

#include "core/interaction/view_fit.h"
#include "ui/view/renderer.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include <cmath>

namespace fff::ui {

namespace {

constexpr int kSamples = 4;

QSurfaceFormat pictureFormat()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

} // namespace

class OffscreenPainter::Private
{
public:
    Private();
    ~Private();

    /// Makes this context current for as long as it lives, then the one that was before.
    class Current
    {
    public:
        explicit Current(Private &d)
            : m_context(QOpenGLContext::currentContext()),
              m_surface(m_context ? m_context->surface() : nullptr), m_own(d.context),
              m_isCurrent(d.context.makeCurrent(&d.surface))
        {
        }
        ~Current()
        {
            if (m_context)
                m_context->makeCurrent(m_surface);
            else
                m_own.doneCurrent();
        }
        Current(const Current &) = delete;
        Current &operator=(const Current &) = delete;
        explicit operator bool() const { return m_isCurrent; }

    private:
        QOpenGLContext *m_context;
        QSurface *m_surface;
        QOpenGLContext &m_own;
        bool m_isCurrent;
    };

    QOffscreenSurface surface;
    QOpenGLContext context;
    Renderer renderer;
    bool isUsable = false;
};

OffscreenPainter::Private::Private()
{
    surface.setFormat(pictureFormat());
    surface.create();
    context.setFormat(pictureFormat());
    if (!surface.isValid() || !context.create())
        return;
    const Current current(*this);
    isUsable = current && renderer.initialize();
}

OffscreenPainter::Private::~Private()
{
    if (!isUsable)
        return;
    const Current current(*this);
    if (current)
        renderer.release();
}

OffscreenPainter::OffscreenPainter() : d(std::make_unique<Private>()) {}
OffscreenPainter::~OffscreenPainter() = default;

bool OffscreenPainter::isUsable() const
{
    return d->isUsable;
}

QImage OffscreenPainter::paint(const Scene &scene, const Camera &camera, const Vec2 &viewport,
                               double pixelRatio, const ViewStyle &style,
                               const RenderOptions &options)
{
    const Vec2 pixels = viewport * pixelRatio;
    if (!d->isUsable || !(pixels.minCoeff() >= 1.0) || pixels.maxCoeff() > kMaxPictureSide)
        return {};
    const Private::Current current(*d);
    if (!current)
        return {};
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(kSamples);
    QOpenGLFramebufferObject target(static_cast<int>(std::lround(pixels.x())),
                                    static_cast<int>(std::lround(pixels.y())), format);
    if (!target.isValid() || !target.bind())
        return {};
    d->renderer.render(scene, camera, viewport, pixelRatio, style, options);
    QImage image = target.toImage().convertToFormat(QImage::Format_RGB32); // resolves the samples
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

Scene sceneOf(const Analysis &analysis)
{
    SceneBuilder builder;
    builder.setAnalysis(std::make_shared<const Analysis>(analysis));
    if (Result<PulledTemplates> pulled = pullTemplates(analysis.model, nullptr))
        builder.setPulled(std::make_shared<const PulledTemplates>(*std::move(pulled)));
    return builder.build(analysis.model);
}

Camera cameraFor(const Scene &scene, const std::string &view, const Vec2 &viewport)
{
    Camera camera;
    orientationOfView(view, camera.orientation);
    return cameraFor(scene, camera, viewport);
}

Camera cameraFor(const Scene &scene, Camera camera, const Vec2 &viewport)
{
    std::vector<Vec3> points = cornersOf(scene.things); // weights are seen, too
    for (const SceneSection &section : scene.sections) {
        const Vec3 half = 0.5 * section.thickness * section.frame.normal();
        for (const Vec2 &p : section.shape->region().outer)
            for (const double side : {-1.0, 1.0})
                points.push_back(section.frame.toWorld(p) + side * half);
    }
    if (points.empty())
        return fitted(camera, scene.bounds, viewport);
    return fitted(camera, points, viewport, fitMargins(viewport, {}));
}

} // namespace fff::ui
