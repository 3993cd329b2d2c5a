// The window: flatfitfab [--copy] [--play SCRIPT] [FILE…]
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "ui/field_style.h"
#include "ui/focus_frame.h"
#include "ui/main_window.h"
#include "ui/script_player.h"
#include "ui/settings/settings.h"
#include "ui/translations.h"
#include "ui/windows.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QTextStream>

namespace {

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

} // namespace

int main(int argc, char *argv[])
{
    // Before the application: contexts share this format.
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8); // QPainter clips with it
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(
        Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);

    QApplication application(argc, argv);
    // Every sample of a stroke counts; the viewport gathers them itself. After the application's
    // constructor: X11's platform plugin switches it on there.
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication::setStyle(new fff::ui::FieldStyle);
    new fff::ui::FocusFrame(application);
    QApplication::setApplicationName(QStringLiteral("flatfitfab"));
    QApplication::setApplicationDisplayName(QString()); // the window's title names the program
    QApplication::setApplicationVersion(QStringLiteral(FFF_VERSION));

    fff::ui::installTranslations(application);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QApplication::translate("main", "Draws flat parts in 3D and cuts them."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        QApplication::translate("main", "The models to open, each in a window."),
        QStringLiteral("[FILE…]"));
    const QCommandLineOption copy(
        QStringLiteral("copy"),
        QApplication::translate("main", "Opens FILE as a copy: saving asks for a name."));
    parser.addOption(copy);
    const QCommandLineOption play(
        QStringLiteral("play"),
        QApplication::translate("main", "Plays a script of presses and moves."),
        QApplication::translate("main", "SCRIPT"));
    parser.addOption(play);
    parser.process(application);

    fff::ui::MainWindow *window = fff::ui::openWindow();
    const QStringList files = parser.positionalArguments();
    if (!files.isEmpty())
        fff::ui::openFiles(*window, files, parser.isSet(copy));
    else if (fff::ui::settings().showsStartPage())
        window->showStartPage();
    window->offerRecovered();
    if (parser.isSet(play))
        playScript(*window, parser.value(play));
    return QApplication::exec();
}
