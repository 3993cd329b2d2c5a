#include "ui/view/occlusion.h"

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kStrength = 0.85; // part of the darkness that is shown
constexpr double kLargest = 0.12;  // part of the picture's height that the radius may take
constexpr double kSameSurface =
    0.12; // of the radius: depths that differ by less are blurred together

} // namespace

Occlusion::Occlusion(Gl &gl, ScreenPass &pass)
    : m_gl(gl), m_pass(pass), m_sample(loadProgram("screen", "occlusion")),
      m_blur(loadProgram("screen", "occlusion_blur")),
      m_apply(loadProgram("screen", "occlusion_apply")), m_image(gl, GL_R8, false, GL_LINEAR),
      m_other(gl, GL_R8, false, GL_LINEAR)
{
}

void Occlusion::darken(RenderTarget &picture, const FrameView &view, double radius)
{
    const int part =
        view.ratio() >= 2.0 ? 4 : 2; // shades are soft: a quarter of the points is enough
    const QSize size(std::max(1, picture.size().width() / part),
                     std::max(1, picture.size().height() / part));
    m_image.resize(size);
    m_other.resize(size);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_BLEND);

    const double scale = view.camera.millimetresPerPixel;
    const double shown = std::min(radius, kLargest * view.viewport.y() * scale);
    Eigen::Matrix4d toView = Eigen::Matrix4d::Identity();
    toView.block<3, 3>(0, 0) = view.camera.orientation.conjugate().toRotationMatrix();
    const bool isPerspective = view.camera.isPerspective();
    const Vec3 origin = isPerspective ? view.camera.eye(view.viewport) : view.camera.target;
    toView.block<3, 1>(0, 3) = -(toView.block<3, 3>(0, 0) * origin);

    m_image.bind();
    m_sample->bind();
    m_pass.setTexture(*m_sample, "depths", 0, picture.depth());
    m_sample->setUniformValue("fromClip", toFloat(Eigen::Matrix4d(toView * view.toClip.inverse())));
    m_sample->setUniformValue("radius", static_cast<float>(shown));
    m_sample->setUniformValue("reach", static_cast<float>(shown / (scale * view.viewport.x())),
                              static_cast<float>(shown / (scale * view.viewport.y())));
    m_sample->setUniformValue("isPerspective", isPerspective ? 1.0f : 0.0f);
    m_sample->setUniformValue("eyeDistance",
                              static_cast<float>(view.camera.eyeDistance(view.viewport)));
    m_pass.draw();

    const auto depthAt = [&](const Vec3 &p) {
        const Eigen::Vector4d clip = view.toClip * p.homogeneous();
        return 0.5 * clip.z() / clip.w();
    };
    const Vec3 &target = view.camera.target;
    const double sameDepth =
        std::abs(depthAt(target - kSameSurface * shown * view.camera.backward()) - depthAt(target));
    blur(m_image, m_other, picture, Vec2::UnitX(), sameDepth);
    blur(m_other, m_image, picture, Vec2::UnitY(), sameDepth);

    picture.bind();
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    m_apply->bind();
    m_pass.setTexture(*m_apply, "image", 0, m_image.colour());
    m_apply->setUniformValue("strength", static_cast<float>(kStrength));
    // Where depths are those of slabs, not of the background.
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glDepthFunc(GL_GREATER);
    m_pass.draw();
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void Occlusion::blur(RenderTarget &from, RenderTarget &to, const RenderTarget &picture,
                     const Vec2 &direction, double sameDepth)
{
    to.bind();
    m_blur->bind();
    m_pass.setTexture(*m_blur, "image", 0, from.colour());
    m_pass.setTexture(*m_blur, "depths", 1, picture.depth());
    m_blur->setUniformValue("sameDepth", static_cast<float>(sameDepth));
    m_blur->setUniformValue("step", static_cast<float>(direction.x() / to.size().width()),
                            static_cast<float>(direction.y() / to.size().height()));
    m_pass.draw();
}

} // namespace fff::ui
