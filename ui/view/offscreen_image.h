// Pictures of a model without a window: for `render` on the command line and for thumbnails.
#pragma once

#include "core/analysis/analysis.h"
#include "core/interaction/camera.h"
#include "ui/view/render_options.h"
#include "ui/view/scene.h"

#include <QImage>

#include <memory>
#include <string>

namespace fff::ui {

/// The largest side of a picture, px: what every OpenGL of the last ten years offers.
inline constexpr int kMaxPictureSide = 8192;

/// A whole model as it is cut, nothing selected.
Scene sceneOf(const Analysis &analysis);

/// Sees the whole scene from a named view (camera.h; "fit" is the front). Unknown names: the front.
Camera cameraFor(const Scene &scene, const std::string &view, const Vec2 &viewport);
/// The same looking as this camera does.
Camera cameraFor(const Scene &scene, Camera camera, const Vec2 &viewport);

/// An OpenGL context of its own and a renderer in it. Needs a QGuiApplication and belongs to its
/// thread; whatever context was current stays current. Making one takes about a tenth of a second,
/// so several pictures should come from one.
class OffscreenPainter
{
public:
    OffscreenPainter();
    ~OffscreenPainter();

    /// False when there is no display or it offers no OpenGL 3.3.
    bool isUsable() const;

    /// viewport    device-independent pixels
    /// pixelRatio  the image has that many times as many, and says so; at most kMaxPictureSide
    /// Null when the painter is not usable or the picture is too large for the driver.
    QImage paint(const Scene &scene, const Camera &camera, const Vec2 &viewport,
                 double pixelRatio = 1.0, const ViewStyle &style = {},
                 const RenderOptions &options = {});

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff::ui
