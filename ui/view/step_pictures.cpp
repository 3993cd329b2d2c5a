#include "ui/view/step_pictures.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr double kNearest = 2.0; // times as large as in the picture of the whole

ViewStyle onPaper()
{
    ViewStyle style;
    style.top = style.bottom = Qt::white;
    return style;
}

} // namespace

StepPictures::StepPictures(AssemblyStepsPointer steps, const Camera &looking)
    : m_scene(std::move(steps)), m_looking(looking)
{
}

/// The whole of these scenes.
Camera StepPictures::cameraFor(const std::vector<Scene> &scenes, const Vec2 &size) const
{
    Scene all;
    for (const Scene &scene : scenes) {
        for (const SceneSection &section : scene.sections) {
            all.sections.push_back(section);
            all.bounds.extend(section.bounds);
        }
    }
    return fff::ui::cameraFor(all, m_looking, size);
}

/// On what is there and the way of what comes, but not so near that a person loses the whole.
Camera StepPictures::cameraForStep(int step, const Vec2 &size) const
{
    const Camera whole = cameraFor({m_scene.finishedScene()}, size);
    Camera camera = cameraFor({m_scene.sceneBefore(step), m_scene.sceneAt(step + 1.0, 0.0)}, size);
    camera.millimetresPerPixel =
        std::max(camera.millimetresPerPixel, whole.millimetresPerPixel / kNearest);
    return camera;
}

/// The same for all steps: the finished model, and all that ever comes.
Camera StepPictures::cameraForAll(const Vec2 &size) const
{
    std::vector<Scene> scenes{m_scene.finishedScene()};
    for (int step = 0; step < m_scene.steps().playback.stepCount(); ++step) {
        Scene begun = m_scene.sceneBefore(step);
        std::erase_if(begun.sections, [](const SceneSection &s) { return !s.isSelected; });
        scenes.push_back(std::move(begun));
    }
    return cameraFor(scenes, size);
}

QImage StepPictures::step(int index, Fit fit, const Vec2 &size, double pixelRatio)
{
    if (fit == Fit::AllSteps && (!m_forAll || m_forAllSize != size)) {
        m_forAll = cameraForAll(size);
        m_forAllSize = size;
    }
    const Camera camera = fit == Fit::AllSteps ? *m_forAll : cameraForStep(index, size);
    return paint(m_scene.before(index, camera, size), camera, size, pixelRatio);
}

QImage StepPictures::finished(const Vec2 &size, double pixelRatio)
{
    const Camera camera = cameraFor({m_scene.finishedScene()}, size);
    return paint(m_scene.finished(camera, size), camera, size, pixelRatio);
}

QImage StepPictures::paint(const StepsPicture &picture, const Camera &camera, const Vec2 &size,
                           double pixelRatio)
{
    RenderOptions options;
    options.hasGround = false;
    const ViewStyle style = onPaper();
    QImage image = m_painter.paint(picture.scene, camera, size, pixelRatio, style, options);
    if (image.isNull())
        return image;
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    MarkPen pen(painter, camera, size, style);
    paintSteps(pen, picture.marks, QLocale());
    return image;
}

} // namespace fff::ui
