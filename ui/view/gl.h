// OpenGL 3.3 core as this room uses it: the functions of the current context, shaders from the
// resources, and matrices from double to float. Everything here needs a current context.
#pragma once

#include "core/interaction/camera.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>

#include <Eigen/Core>

#include <memory>

namespace fff::ui {

using Gl = QOpenGLFunctions_3_3_Core;

/// Compiles :/shaders/`vertex`.vert and :/shaders/`fragment`.frag, with `define` as a name defined
/// in both. Null when the driver refuses them; the reason goes to the log.
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char *vertex, const char *fragment,
                                                  const char *define = "");

QMatrix4x4 toFloat(const Eigen::Matrix4d &matrix);
QMatrix3x3 toFloat(const Eigen::Matrix3d &matrix);
inline QVector4D toFloat(const Eigen::Vector4d &v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(v.w())};
}

/// World to clip space; `nearest` and `farthest` are distances from the camera's target towards the
/// eye and away from it, mm. A perspective view ends a little before its eye.
Eigen::Matrix4d clipMatrix(const Camera &camera, const Vec2 &viewport, double nearest,
                           double farthest);

} // namespace fff::ui
