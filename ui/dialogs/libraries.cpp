#include "ui/dialogs/libraries.h"

#include "ui/settings/log.h"
#include "ui/view/steps_page.h"

#include <QFile>
#include <QGuiApplication>
#include <QLocale>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QSysInfo>

namespace fff::ui {

namespace {

constexpr int kLogLines = 100;

const Library kLibraries[] = {
    {"FlatFitFab", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "This program"),
     "© The authors of FlatFitFab", "GNU General Public License, version 3 or later", "gpl-3.0",
     ""},
    {"Qt " QT_VERSION_STR, QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Windows, files and text"),
     "© The Qt Company Ltd and others", "GNU Lesser General Public License, version 3", "lgpl-3.0",
     "https://www.qt.io"},
    {"CGAL", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Exact geometry"), "© The CGAL Project",
     "GNU General and Lesser General Public License, version 3 or later", "gpl-3.0",
     "https://www.cgal.org"},
    {"Eigen", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Vectors and matrices"),
     "© Benoît Jacob, Gaël Guennebaud and others", "Mozilla Public License, version 2.0", "mpl-2.0",
     "https://eigen.tuxfamily.org"},
    {"Clipper", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Cutting and offsetting outlines"),
     "© Angus Johnson", "Boost Software License, version 1.0", "bsl-1.0",
     "https://sourceforge.net/projects/polyclipping"},
    {"pugixml", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Reading drawings"),
     "© Arseny Kapoulkine", "MIT licence", "mit", "https://pugixml.org"},
    {"zlib", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Unpacking drawings"),
     "© Jean-loup Gailly and Mark Adler", "zlib licence", "zlib", "https://zlib.net"},
    {"MiniZip", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Models with pictures and meshes"),
     "© Gilles Vollant, Mathias Svensson and others", "zlib licence", "zlib",
     "https://www.winimage.com/zLibDll/minizip.html"},
    {"Boost", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Parts that CGAL uses"),
     "© The authors of Boost", "Boost Software License, version 1.0", "bsl-1.0",
     "https://www.boost.org"},
#ifndef FFF_WITHOUT_GMP // as for Windows
    {"GMP", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Numbers without rounding"),
     "© Free Software Foundation, Inc.", "GNU Lesser General Public License, version 3", "lgpl-3.0",
     "https://gmplib.org"},
    {"MPFR", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Numbers with many digits"),
     "© Free Software Foundation, Inc.", "GNU Lesser General Public License, version 3", "lgpl-3.0",
     "https://www.mpfr.org"},
#endif
    {"expected", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "Results that may be errors"),
     "Sy Brand", "CC0: given to the public domain", "cc0-1.0",
     "https://github.com/TartanLlama/expected"},
    {"three.js", QT_TRANSLATE_NOOP("fff::ui::AboutDialog", "The model in web pages of the steps"),
     "© The authors of three.js", "MIT licence", "mit", "https://threejs.org"},
};

QString openGlReport()
{
    QOpenGLContext context;
    QOffscreenSurface surface;
    const QString platform = QGuiApplication::platformName();
    const bool canAsk = platform != QStringLiteral("offscreen") &&
                        platform != QStringLiteral("minimal") && context.create();
    if (!canAsk)
        return QStringLiteral("OpenGL: none");
    surface.setFormat(context.format());
    surface.create();
    if (!context.makeCurrent(&surface))
        return QStringLiteral("OpenGL: none");
    QOpenGLFunctions *gl = context.functions();
    const auto word = [gl](GLenum name) {
        return QString::fromLatin1(reinterpret_cast<const char *>(gl->glGetString(name)));
    };
    QString report = QStringLiteral("OpenGL: %1, %2").arg(word(GL_VERSION), word(GL_RENDERER));
    context.doneCurrent();
    return report;
}

} // namespace

std::span<const Library> libraries()
{
    const std::span<const Library> all = kLibraries;
    return StepsPage::hasModel() ? all : all.first(all.size() - 1);
}

QString licenceText(const Library &library)
{
    QFile file(QStringLiteral(":/licences/%1.txt").arg(QLatin1String(library.file)));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString versionReport()
{
    QStringList lines;
    lines += QStringLiteral("FlatFitFab " FFF_VERSION);
    lines += QStringLiteral("Qt %1 (built with %2), %3")
                 .arg(QLatin1String(qVersion()), QLatin1String(QT_VERSION_STR),
                      QGuiApplication::platformName());
    lines += openGlReport();
    lines += QStringLiteral("System: %1, %2, kernel %3")
                 .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(),
                      QSysInfo::kernelVersion());
    if (const QScreen *screen = QGuiApplication::primaryScreen()) {
        lines += QStringLiteral("Screen: %1 × %2 at %3 %")
                     .arg(screen->size().width())
                     .arg(screen->size().height())
                     .arg(qRound(100 * screen->devicePixelRatio()));
    }
    lines += QStringLiteral("Language: ") + QLocale().name();
    if (const QString log = endOfLog(kLogLines); !log.isEmpty())
        lines += QStringLiteral("Log:\n") + log;
    return lines.join(QLatin1Char('\n'));
}

} // namespace fff::ui
