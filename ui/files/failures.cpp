#include "ui/files/failures.h"

#include "core/io/error_text.h"
#include "core/io/formats.h"
#include "core/io/listing.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace fff::ui {

namespace {

struct FailuresTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::Failures)
};

/// What it is called where it has no name of its own: a folder.
QString shownName(const QString &path)
{
    const QString name = QFileInfo(path).fileName();
    return name.isEmpty() ? QDir::toNativeSeparators(path) : name;
}

/// A name that nobody reads to its end takes no room that is the reason's.
QString shortened(const QString &name)
{
    constexpr qsizetype kMost = 60, kEnd = 20; // letters
    return name.size() <= kMost ? name : name.first(kMost - kEnd) + u'…' + name.last(kEnd);
}

/// "fish.txt:340" is in the file's name already; what remains is "line 340".
QString placeInFile(const QString &name, const Error &error)
{
    const QString place = QString::fromStdString(error.place);
    const QString in = place.section(u':', 1);
    if (in.isEmpty() || !place.startsWith(name))
        return {};
    bool isLine = false;
    const int line = in.toInt(&isLine);
    return isLine ? FailuresTexts::tr("line %1").arg(line) : in;
}

/// ".fff and FlatFab’s .txt"
QString modelFiles()
{
    QStringList files;
    for (const io::Format *format : io::formatsThat(&io::Format::readsModels)) {
        const QString suffix = u'.' + format->suffix(), program = QLatin1String(format->program);
        //: %1 is the end of a name, such as ".txt", %2 a program
        files += program.isEmpty() ? suffix : FailuresTexts::tr("%2’s %1").arg(suffix, program);
    }
    return io::enumerated(files, FailuresTexts::tr("%1 and %2"));
}

} // namespace

QString openFailure(const QString &path, const Error &error)
{
    if (path.trimmed().isEmpty())
        return FailuresTexts::tr("Nothing was opened: no file was named.");
    const QString name = shownName(path);
    if (error.code == ErrorCode::NotAModel)
        return FailuresTexts::tr("%1 is not a model. FlatFitFab opens %2.").arg(name, modelFiles());
    if (!QFileInfo::exists(path)) {
        return FailuresTexts::tr(
                   "%1 could not be opened: it is not in %2 any more. Nothing was changed.")
            .arg(name, QFileInfo(path).absolutePath());
    }
    QString what = io::errorSentence(error);
    if (error.code == ErrorCode::CannotOpen && !error.args.empty() && !error.args[0].empty())
        what = QCoreApplication::translate("Error", error.args[0].c_str());
    const QString where = placeInFile(name, error);
    return where.isEmpty()
               ? FailuresTexts::tr("%1 could not be opened: %2. Nothing was changed.")
                     .arg(name, what)
               //: %3 is a place in the file, such as "line 340"
               : FailuresTexts::tr("%1 could not be opened: %2 (%3). Nothing was changed.")
                     .arg(name, what, where);
}

QString saveFailure(const QString &path, const Error &error)
{
    const QString name = shortened(QFileInfo(path).fileName()),
                  folder = QFileInfo(path).absolutePath();
    const QString kept = QFileInfo::exists(path)
                             ? FailuresTexts::tr("The file on disk is still the old one.")
                             : FailuresTexts::tr("Nothing was written.");
    QString why;
    if (!QFileInfo::exists(folder))
        why = FailuresTexts::tr("the folder %1 does not exist").arg(folder);
    else if (error.code == ErrorCode::CannotWrite && !error.args.empty())
        why = QCoreApplication::translate("Error", error.args[0].c_str());
    else
        why = io::errorSentence(error);
    if (error.code == ErrorCode::ClosedSlit || error.code == ErrorCode::CannotOffset)
        //: %1 the reason, %2 a sentence
        return FailuresTexts::tr("Not exported: %1. %2").arg(why, kept);
    //: %1 a file's name, %2 the reason, %3 a sentence
    return FailuresTexts::tr("Could not save %1: %2. %3").arg(name, why, kept);
}

QString failureDetails(const QString &path, const Error &error)
{
    return QFileInfo(path).absoluteFilePath() + QLatin1Char('\n') + io::errorText(error);
}

} // namespace fff::ui
