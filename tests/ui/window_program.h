// The program that a test of windows with a view runs in, set up as ours is: OpenGL as the view
// needs it, our style, English.
#pragma once

#include <QTest>

#include "ui/base/field_style.h"
#include "ui/base/translations.h"

#include <QApplication>
#include <QLocale>
#include <QSurfaceFormat>

namespace fff::ui {

template <class Test>
int runInWindowProgram(int argc, char *argv[])
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace fff::ui
