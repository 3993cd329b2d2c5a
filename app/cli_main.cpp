// flatfitfab-cli: all of the product without a window.

#include "app/cli/command_line.h"

#include <QCoreApplication>
#include <QTextStream>

namespace {

QString helpText()
{
    const auto tr = [](const char *text) {
        return QCoreApplication::translate("CommandLine", text);
    };
    QString text = tr("FlatFitFab draws flat parts in 3D and writes what a laser cutter cuts.");
    text += QStringLiteral("\n\n") + tr("Usage:") + QLatin1Char('\n');
    for (const fff::cli::Verb &verb : fff::cli::verbs())
        text += QStringLiteral("  flatfitfab-cli %1 %2\n      %3\n")
                    .arg(QLatin1String(verb.name), QLatin1String(verb.usage), tr(verb.purpose));
    text += QStringLiteral("  flatfitfab-cli --version | --help | VERB --help\n\n");
    text += tr("FILE is a .fff file or a FlatFab .txt file. Lengths are in mm, angles in degrees.");
    return text + QLatin1Char('\n');
}

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("flatfitfab-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(FFF_VERSION));
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    const QString first = arguments.value(0);
    if (first == QStringLiteral("--help") || first == QStringLiteral("-h"))
        return fff::cli::print(helpText().toStdString());
    if (first == QStringLiteral("--version"))
        return fff::cli::print("FlatFitFab " FFF_VERSION "\n");
    for (const fff::cli::Verb &verb : fff::cli::verbs())
        if (first == QLatin1String(verb.name))
            return verb.run(arguments.mid(1));
    QTextStream err(stderr);
    if (!first.isEmpty())
        err << QCoreApplication::translate("CommandLine", "There is no \"%1\".").arg(first)
            << "\n\n";
    err << helpText();
    return fff::cli::WrongUse;
}
