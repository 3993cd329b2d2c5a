// The window: flatfitfab [--copy] [--play SCRIPT] [FILE…]
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/own_libraries.h"
#include "ui/base/field_style.h"
#include "ui/base/focus_frame.h"
#include "ui/base/translations.h"
#include "ui/settings/log.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"
#include "ui/window/script_player.h"
#include "ui/window/windows.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QSysInfo>
#include <QTextStream>

#include <algorithm>
#include <clocale>

namespace {

const QString kCopy = QStringLiteral("copy"), kPlay = QStringLiteral("play"),
              kSafe = QStringLiteral("safe-mode");

void complain(const fff::Error &error)
{
    QTextStream(stderr) << fff::io::errorText(error) << Qt::endl;
}

/// A script that cannot be played says so on standard error; the window stays.
void playScript(fff::ui::MainWindow &window, const QString &path)
{
    const fff::Result<std::string> bytes = fff::io::readFile(path);
    const auto script = bytes ? fff::ReplayScript::read(QByteArray::fromStdString(*bytes))
                              : fff::Result<fff::ReplayScript>(tl::unexpected(bytes.error()));
    auto *view = window.findChild<QWidget *>(QStringLiteral("viewport"));
    if (!script)
        complain(script.error());
    if (!script || !view)
        return;
    auto *player = new fff::ui::ScriptPlayer(window.bench(), *view, *script, &window);
    QObject::connect(player, &fff::ui::ScriptPlayer::failed, player, complain);
    player->start();
}

void nameProgram()
{
    QCoreApplication::setApplicationName(QStringLiteral("flatfitfab"));
    QCoreApplication::setApplicationVersion(QStringLiteral(FFF_VERSION));
}

/// The options, which --help lists.
void describe(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        QCoreApplication::translate("main", "Draws flat parts in 3D and cuts them."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        QCoreApplication::translate(
            "main",
            "Models to open, each in a window; drawings, meshes and pictures to add to a new one."),
        QStringLiteral("[FILE…]"));
    parser.addOption({kCopy, QCoreApplication::translate(
                                 "main", "Opens FILE as a copy: saving asks for a name.")});
    parser.addOption({kPlay,
                      QCoreApplication::translate("main", "Plays a script of presses and moves."),
                      QCoreApplication::translate("main", "SCRIPT")});
    parser.addOption({kSafe, QCoreApplication::translate(
                                 "main", "Starts without what was set, and keeps no settings.")});
}

/// Whether it is only asked what there is, which needs no display.
bool asksForHelp(int argc, char *argv[])
{
    return std::any_of(argv + std::min(argc, 1), argv + argc, [](const char *text) {
        const QLatin1String word(text);
        return word == QLatin1String("--help") || word == QLatin1String("-h") ||
               word == QLatin1String("--help-all") || word == QLatin1String("--version") ||
               word == QLatin1String("-v");
    });
}

/// Prints the answer and ends the program.
[[noreturn]] void help(int argc, char *argv[])
{
    QCoreApplication application(argc, argv);
    nameProgram();
    fff::ui::installTranslations(application);
    QCommandLineParser parser;
    describe(parser);
    if (parser.parse(QCoreApplication::arguments()) && parser.isSet(QStringLiteral("version")))
        parser.showVersion();
    parser.showHelp();
}

} // namespace

int main(int argc, char *argv[])
{
    if (asksForHelp(argc, argv))
        help(argc, argv);
    // Before the application: contexts share this format.
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    // The view is drawn into buffers of its own. With samples, depth and stencil the window would
    // have four times as many pixels to put together, which costs software rendering most.
    format.setDepthBufferSize(0);
    format.setStencilBufferSize(0);
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(
        Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);

    QApplication application(argc, argv);
    // Every sample of a stroke counts; the viewport gathers them itself. After the application's
    // constructor: X11's platform plugin switches it on there.
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication::setStyle(new fff::ui::FieldStyle);
    new fff::ui::FocusFrame(application);
    nameProgram();
    // Wayland's windows have the icon of this entry (packaging/linux).
    QGuiApplication::setDesktopFileName(QStringLiteral("org.flatfitfab.FlatFitFab"));
    QApplication::setApplicationDisplayName(QString()); // the window's title names the program

    // Before the first words: the language is a setting.
    if (QCoreApplication::arguments().contains(QStringLiteral("--") + kSafe))
        fff::ui::Settings::startSafely();
    fff::ui::keepLog(fff::ui::Settings::dataFolder());
    fff::ui::noteInLog(QStringLiteral("started: FlatFitFab " FFF_VERSION ", Qt %1, %2, %3")
                           .arg(QLatin1String(qVersion()), QGuiApplication::platformName(),
                                QSysInfo::prettyProductName()));
    fff::ui::installTranslations(application);
    std::setlocale(LC_NUMERIC, "C"); // Qt's numbers follow QLocale; what is C's reads files

    QCommandLineParser parser;
    describe(parser);
    parser.process(application);

    for (const fff::Error &error : fff::io::addOwnLibraries(fff::ui::Settings::dataFolder())) {
        complain(error);
        fff::ui::noteInLog(fff::io::errorText(error));
    }
    fff::ui::MainWindow *window = fff::ui::openWindow();
    const QStringList files = parser.positionalArguments();
    if (!files.isEmpty())
        window->take(files, parser.isSet(kCopy));
    else if (fff::ui::settings().showsStartPage())
        window->showStartPage();
    window->offerRecovered();
    if (parser.isSet(kPlay))
        playScript(*window, parser.value(kPlay));
    return QApplication::exec();
}
