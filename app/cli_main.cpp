// flatfitfab-cli: all of the product without a window.

#include "app/cli/command_line.h"
#include "core/io/error_text.h"
#include "core/io/own_libraries.h"

#include <QByteArrayList>
#include <QGuiApplication>
#include <QLocale>
#include <QStandardPaths>

#include <algorithm>
#include <clocale>
#include <memory>
#ifdef Q_OS_WIN
#include <cstdio>
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#endif

namespace {

#ifdef Q_OS_WIN
/// What is printed is bytes, of files too, and text in UTF-8; a console has another code by itself,
/// which whoever uses it next finds again.
class Console
{
public:
    Console() : m_before(GetConsoleOutputCP())
    {
        SetConsoleOutputCP(CP_UTF8);
        _setmode(_fileno(stdout), _O_BINARY);
    }
    ~Console()
    {
        if (m_before != 0)
            SetConsoleOutputCP(m_before);
    }
    Console(const Console &) = delete;
    Console &operator=(const Console &) = delete;

private:
    UINT m_before;
};
#endif

QString helpText()
{
    const auto tr = [](const char *text) {
        return QCoreApplication::translate("CommandLine", text);
    };
    QString text = tr("FlatFitFab draws flat parts in 3D and writes what a laser cutter cuts.");
    text += QStringLiteral("\n\n") + tr("Usage:") + QLatin1Char('\n');
    for (const fff::cli::Verb &verb : fff::cli::verbs())
        text += QStringLiteral("  flatfitfab-cli %1\n      %2\n")
                    .arg(fff::cli::usageOf(verb), fff::cli::purposeOf(verb));
    text += QStringLiteral("  flatfitfab-cli --version | --help | VERB --help\n\n");
    text += tr("FILE is %1. Lengths are in mm, angles in degrees.").arg(fff::cli::modelFiles());
    return text + QLatin1Char('\n');
}

/// Where the window has them, too.
void addOwnLibraries()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                           QStringLiteral("/flatfitfab");
    for (const fff::Error &error : fff::io::addOwnLibraries(folder))
        fff::cli::printError(fff::io::errorText(error));
}

/// Of Qt, the first that can be reached.
QByteArray platforms()
{
#if defined(Q_OS_WIN)
    return "windows";
#elif defined(Q_OS_MACOS)
    return "cocoa";
#else
    // Libraries of displays that are not there say so themselves, whatever Qt is told.
    QByteArrayList found;
    if (qEnvironmentVariableIsSet("DISPLAY"))
        found.append("xcb");
    if (qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
        found.append("wayland");
    found.append("offscreen");
    return found.join(';');
#endif
}

/// Only pictures need a display. Where none can be reached Qt's offscreen platform is taken, whose
/// missing OpenGL the verb then speaks about, instead of an end without words.
std::unique_ptr<QCoreApplication> makeApplication(int &argc, char *argv[])
{
    const bool asksForHelp =
        std::any_of(argv + std::min(argc, 1), argv + argc, [](const char *text) {
            return qstrcmp(text, "--help") == 0 || qstrcmp(text, "-h") == 0;
        });
    const auto isVerb = [&](const char *name) { return argc >= 2 && qstrcmp(argv[1], name) == 0; };
    // Steps are among what a workshop gets.
    const bool isForWorkshop =
        isVerb("export") && std::any_of(argv + 2, argv + argc, [](const char *text) {
            const QByteArray word = QByteArray(text).toLower();
            return word.endsWith(".zip") || word == "zip" || word == "--format=zip";
        });
    const bool isPicture = isVerb("render") || isVerb("steps") || isForWorkshop;
    if (!isPicture || asksForHelp)
        return std::make_unique<QCoreApplication>(argc, argv);
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", platforms());
    // What Qt says about platforms that it tries is of no use to anyone here.
    const QtMessageHandler before =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext &, const QString &) {});
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    qInstallMessageHandler(before);
    return application;
}

} // namespace

int main(int argc, char *argv[])
{
#ifdef Q_OS_WIN
    const Console console;
#endif
    const std::unique_ptr<QCoreApplication> app = makeApplication(argc, argv);
    // Its sentences are English, so are the numbers in them and the reasons that the system gives.
    QLocale::setDefault(QLocale::c());
    std::setlocale(LC_NUMERIC, "C");
#ifdef LC_MESSAGES
    std::setlocale(LC_MESSAGES, "C");
#endif
    QCoreApplication::setApplicationName(QStringLiteral("flatfitfab-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(FFF_VERSION));
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    const QString first = arguments.value(0);
    if (first == QStringLiteral("--help") || first == QStringLiteral("-h"))
        return fff::cli::print(helpText().toStdString());
    if (first == QStringLiteral("--version"))
        return fff::cli::print("FlatFitFab " FFF_VERSION "\n");
    addOwnLibraries();
    for (const fff::cli::Verb &verb : fff::cli::verbs())
        if (first == QLatin1String(verb.name))
            return verb.run(arguments.mid(1));
    if (!first.isEmpty()) {
        fff::cli::printError(
            QCoreApplication::translate("CommandLine", "There is no \"%1\".").arg(first));
        fff::cli::printError({});
    }
    for (const QString &line : helpText().chopped(1).split(u'\n'))
        fff::cli::printError(line);
    return fff::cli::WrongUse;
}
