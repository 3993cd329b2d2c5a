#include "ui/view/gl.h"

#include <QFile>
#include <QLoggingCategory>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

/// A perspective view shows nothing nearer to its eye than this part of the target's distance: the
/// depth buffer's digits are worth most there.
constexpr double kNearestPart = 0.02;

/// The shader's text with `define` after its first line, the version.
QByteArray shaderText(const char *name, const QString &suffix, const char *define)
{
    QFile file(QStringLiteral(":/shaders/") + QLatin1String(name) + suffix);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray text = file.readAll();
    if (*define)
        text.insert(text.indexOf('\n') + 1, QByteArray("#define ") + define + '\n');
    return text;
}

} // namespace

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char *vertex, const char *fragment,
                                                  const char *define)
{
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const bool done =
        program->addShaderFromSourceCode(QOpenGLShader::Vertex,
                                         shaderText(vertex, QStringLiteral(".vert"), define)) &&
        program->addShaderFromSourceCode(QOpenGLShader::Fragment,
                                         shaderText(fragment, QStringLiteral(".frag"), define)) &&
        program->link();
    if (!done) {
        qWarning("Shader %s/%s: %s", vertex, fragment, qPrintable(program->log()));
        return nullptr;
    }
    // What it was made of is not needed any more, and takes more room than itself.
    program->removeAllShaders();
    program->link(); // finds that it is
    return program;
}

QMatrix4x4 toFloat(const Eigen::Matrix4d &matrix)
{
    const Eigen::Matrix<float, 4, 4, Eigen::RowMajor> rows = matrix.cast<float>();
    return QMatrix4x4(rows.data());
}

QMatrix3x3 toFloat(const Eigen::Matrix3d &matrix)
{
    const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> rows = matrix.cast<float>();
    return QMatrix3x3(rows.data());
}

Eigen::Matrix4d clipMatrix(const Camera &camera, const Vec2 &viewport, double nearest,
                           double farthest)
{
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = camera.right().transpose();
    view.block<1, 3>(1, 0) = camera.up().transpose();
    view.block<1, 3>(2, 0) = camera.backward().transpose();
    view.block<3, 1>(0, 3) = -(view.block<3, 3>(0, 0) * camera.target);

    const Vec2 halfSize = 0.5 * camera.millimetresPerPixel * viewport; // at the target
    Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
    if (!camera.isPerspective()) {
        projection(0, 0) = 1.0 / halfSize.x();
        projection(1, 1) = 1.0 / halfSize.y();
        projection(2, 2) = -2.0 / (nearest + farthest);
        projection(2, 3) = (nearest - farthest) / (nearest + farthest);
        return projection * view;
    }
    const double distance = camera.eyeDistance(viewport);
    view(2, 3) -= distance;
    const double n = std::max(distance - nearest, kNearestPart * distance);
    const double f = std::max(distance + farthest, 2.0 * n);
    projection(0, 0) = distance / halfSize.x();
    projection(1, 1) = distance / halfSize.y();
    projection(2, 2) = (n + f) / (n - f);
    projection(2, 3) = 2.0 * n * f / (n - f);
    projection(3, 2) = -1.0;
    projection(3, 3) = 0.0;
    return projection * view;
}

} // namespace fff::ui
