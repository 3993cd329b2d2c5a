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

/// Compiles :/shaders/`vertex`.vert and :/shaders/`fragment`.frag. Null when the driver refuses
/// them; the reason goes to the log.
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char *vertex, const char *fragment);

void setTransform(QOpenGLShaderProgram &program, const char *name, const Eigen::Matrix4d &matrix);
void setRotation(QOpenGLShaderProgram &program, const char *name, const Eigen::Matrix3d &matrix);

/// World to clip space; `nearest` and `farthest` are distances from the camera's target towards the
/// eye and away from it, mm.
Eigen::Matrix4d clipMatrix(const Camera &camera, const Vec2 &viewport, double nearest,
                           double farthest);

} // namespace fff::ui
