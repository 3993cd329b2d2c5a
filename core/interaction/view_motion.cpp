#include "core/interaction/view_motion.h"

namespace fff {

void ViewMotion::refit(const Camera &to)
{
    fit = to;
    if (animation)
        animation->to = to;
    else
        camera = to;
}

void ViewMotion::animate(const Camera &to, double start, double duration)
{
    isTouched = true;
    animation.reset();
    if (duration > 0.0)
        animation = CameraAnimation{camera, to, start, duration};
    else
        camera = to;
}

void ViewMotion::finish()
{
    if (!animation)
        return;
    camera = animation->to;
    animation.reset();
}

bool ViewMotion::advance(double time)
{
    if (!animation)
        return false;
    camera = animation->at(time);
    if (!animation->isOver(time))
        return false;
    animation.reset();
    return true;
}

} // namespace fff
