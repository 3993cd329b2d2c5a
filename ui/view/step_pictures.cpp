#include "ui/view/step_pictures.h"

#include <QPainter>

#include <numeric>

namespace fff::ui {

namespace {

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

Camera StepPictures::cameraFor(const std::vector<int> &steps, const Vec2 &size) const
{
    Scene all = m_scene.finished(m_looking, size).scene;
    for (const int step : steps) {
        const Scene begun = m_scene.before(step, m_looking, size).scene;
        for (const SceneSection &section : begun.sections) {
            if (section.isSelected)
                all.sections.push_back(section);
        }
    }
    all.bounds = {};
    for (const SceneSection &section : all.sections)
        all.bounds.extend(section.bounds);
    return fff::ui::cameraFor(all, m_looking, size);
}

QImage StepPictures::step(int index, Fit fit, const Vec2 &size, double pixelRatio)
{
    std::vector<int> steps{index};
    if (fit == Fit::AllSteps) {
        steps.resize(static_cast<std::size_t>(m_scene.steps().playback.stepCount()));
        std::iota(steps.begin(), steps.end(), 0);
    }
    const Camera camera = cameraFor(steps, size);
    return paint(m_scene.before(index, camera, size), camera, size, pixelRatio);
}

QImage StepPictures::finished(const Vec2 &size, double pixelRatio)
{
    const Camera camera = cameraFor({}, size);
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
