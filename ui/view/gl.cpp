#include "ui/view/gl.h"

#include <QLoggingCategory>

namespace fff::ui {

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char *vertex, const char *fragment)
{
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const QString folder = QStringLiteral(":/shaders/");
    const bool done =
        program->addShaderFromSourceFile(QOpenGLShader::Vertex, folder + QLatin1String(vertex) +
                                                                    QStringLiteral(".vert")) &&
        program->addShaderFromSourceFile(QOpenGLShader::Fragment, folder + QLatin1String(fragment) +
                                                                      QStringLiteral(".frag")) &&
        program->link();
    if (!done) {
        qWarning("Shader %s/%s: %s", vertex, fragment, qPrintable(program->log()));
        return nullptr;
    }
    return program;
}

void setTransform(QOpenGLShaderProgram &program, const char *name, const Eigen::Matrix4d &matrix)
{
    const Eigen::Matrix<float, 4, 4, Eigen::RowMajor> rows = matrix.cast<float>();
    program.setUniformValue(name, QMatrix4x4(rows.data()));
}

void setRotation(QOpenGLShaderProgram &program, const char *name, const Eigen::Matrix3d &matrix)
{
    const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> rows = matrix.cast<float>();
    program.setUniformValue(name, QMatrix3x3(rows.data()));
}

Eigen::Matrix4d clipMatrix(const Camera &camera, const Vec2 &viewport, double nearest,
                           double farthest)
{
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = camera.right().transpose();
    view.block<1, 3>(1, 0) = camera.up().transpose();
    view.block<1, 3>(2, 0) = camera.backward().transpose();
    view.block<3, 1>(0, 3) = -(view.block<3, 3>(0, 0) * camera.target);

    Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
    const Vec2 halfSize = 0.5 * camera.millimetresPerPixel * viewport;
    projection(0, 0) = 1.0 / halfSize.x();
    projection(1, 1) = 1.0 / halfSize.y();
    projection(2, 2) = -2.0 / (nearest + farthest);
    projection(2, 3) = (nearest - farthest) / (nearest + farthest);
    return projection * view;
}

} // namespace fff::ui
