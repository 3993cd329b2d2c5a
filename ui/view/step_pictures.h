// Pictures of the steps on white ground, without a window: for paper and for files.
#pragma once

#include "ui/view/offscreen_image.h"
#include "ui/view/steps_scene.h"

#include <optional>
#include <vector>

namespace fff::ui {

class StepPictures
{
public:
    /// looking  gives direction and projection; what is seen is fitted
    StepPictures(AssemblyStepsPointer steps, const Camera &looking);

    /// As OffscreenPainter.
    bool isUsable() const { return m_painter.isUsable(); }
    const AssemblySteps &steps() const { return m_scene.steps(); }

    /// Fitted to what is there and the way of this step's parts; or the same for all steps, as for
    /// the frames of a film.
    enum class Fit { Step, AllSteps };
    /// The parts as the step begins, with the arrow and the numbers. size, pixelRatio: as
    /// OffscreenPainter has them; null where that gives none.
    QImage step(int index, Fit fit, const Vec2 &size, double pixelRatio);
    QImage finished(const Vec2 &size, double pixelRatio);

private:
    QImage paint(const StepsPicture &picture, const Camera &camera, const Vec2 &size,
                 double pixelRatio);
    Camera cameraFor(const std::vector<Scene> &scenes, const Vec2 &size) const;
    Camera cameraForStep(int step, const Vec2 &size) const;
    Camera cameraForAll(const Vec2 &size) const;

    StepsScene m_scene;
    Camera m_looking;
    OffscreenPainter m_painter;
    std::optional<Camera> m_forAll; // worked out once, for this size
    Vec2 m_forAllSize = Vec2::Zero();
};

} // namespace fff::ui
