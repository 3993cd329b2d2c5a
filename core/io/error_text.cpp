#include "core/io/error_text.h"

#include "core/io/formats.h"
#include "core/io/listing.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

namespace fff::io {

namespace {

struct ErrorTexts
{
    Q_DECLARE_TR_FUNCTIONS(Error)
};

using Args = std::vector<std::string>;

/// As it stands in a file.
QString verbatim(const Args &args, std::size_t index)
{
    return QString::fromStdString(args[index]);
}

/// A phrase of ours, in the user's language where it is known.
QString phrase(const Args &args, std::size_t index)
{
    return QCoreApplication::translate("Error", args[index].c_str());
}

/// For what was found and what was expected, both of which may be unknown.
QString foundExpected(const Args &args)
{
    if (args.size() < 2)
        return ErrorTexts::tr("this value is not allowed here");
    if (args[0].empty())
        return ErrorTexts::tr("found nothing, expected %1").arg(phrase(args, 1));
    return ErrorTexts::tr("found \"%1\", expected %2").arg(verbatim(args, 0), phrase(args, 1));
}

QString withReason(const QString &sentence, const Args &args)
{
    if (args.empty() || args[0].empty())
        return sentence;
    //: %1 is a sentence such as "could not be opened", %2 the system's reason
    return ErrorTexts::tr("%1: %2").arg(sentence, phrase(args, 0));
}

QString badCount(const Args &args)
{
    if (args.size() < 2)
        return ErrorTexts::tr("this count is not possible");
    if (args.size() < 3)
        return ErrorTexts::tr("found a count of %1, expected at most %2")
            .arg(verbatim(args, 0), verbatim(args, 1));
    //: %3 is what was counted, such as "bytes"
    return ErrorTexts::tr("found %1 %3, expected at most %2 %3")
        .arg(verbatim(args, 0), verbatim(args, 1), phrase(args, 2));
}

QString placed(const std::string &place, const QString &sentence)
{
    if (place.empty())
        return sentence;
    return QString::fromStdString(place) + QStringLiteral(": ") + sentence;
}

QString newerVersion(const Args &args)
{
    if (args.size() < 2)
        return ErrorTexts::tr("made by a newer FlatFitFab");
    return ErrorTexts::tr("made by a newer FlatFitFab: found format %1, expected at most %2")
        .arg(verbatim(args, 0), verbatim(args, 1));
}

QString badContour(const Args &args)
{
    if (args.size() < 2)
        return ErrorTexts::tr("these control points do not form a closed contour");
    return ErrorTexts::tr(
               "these control points do not form a closed contour: found %1, expected %2")
        .arg(verbatim(args, 0), phrase(args, 1));
}

/// As the language writes it.
QString millimetres(const Args &args, std::size_t index)
{
    return QLocale().toString(verbatim(args, index).toDouble(), 'f', 2);
}

QString cannotOffset(const Args &args)
{
    if (args.size() < 2)
        return ErrorTexts::tr("no path can follow this outline at half the kerf all the way round");
    return ErrorTexts::tr(
               "no path can follow %1 at half the kerf of %2 mm all the way round; smooth the "
               "finest details of its contour, or give its stock another kerf")
        .arg(verbatim(args, 0), millimetres(args, 1));
}

QString closedSlit(const Args &args)
{
    if (args.size() < 3)
        return ErrorTexts::tr("the kerf closes a slit");
    return ErrorTexts::tr("%1 has a slit %2 mm wide, which a kerf of %3 mm would close")
        .arg(verbatim(args, 0), millimetres(args, 1), millimetres(args, 2));
}

/// "a .fff file or a .txt file of FlatFab"
QString modelFiles()
{
    QStringList files;
    for (const Format *format : formatsThat(&Format::readsModels)) {
        const QString suffix = u'.' + format->suffix(), program = QLatin1String(format->program);
        //: %1 is the end of a name, such as ".txt", %2 a program
        files += program.isEmpty() ? ErrorTexts::tr("a %1 file").arg(suffix)
                                   : ErrorTexts::tr("a %1 file of %2").arg(suffix, program);
    }
    return enumerated(files, ErrorTexts::tr("%1 or %2"));
}

QString ofSection(const Args &args, const QString &withName, const QString &without)
{
    return args.empty() || args[0].empty() ? without : withName.arg(verbatim(args, 0));
}

} // namespace

QString errorSentence(const Error &error)
{
    const Args &args = error.args;
    const bool hasArg = !args.empty() && !args[0].empty();
    switch (error.code) {
    case ErrorCode::CannotOpen:
        return withReason(ErrorTexts::tr("could not be opened"), args);
    case ErrorCode::CannotWrite:
        return withReason(ErrorTexts::tr("could not be written"), args);
    case ErrorCode::NotAModel:
        return ErrorTexts::tr("not a model, expected %1").arg(modelFiles());
    case ErrorCode::NewerVersion:
        return newerVersion(args);
    case ErrorCode::Truncated:
        return hasArg ? ErrorTexts::tr("the file ends here, expected %1").arg(phrase(args, 0))
                      : ErrorTexts::tr("the file ends too early");
    case ErrorCode::BadSyntax:
    case ErrorCode::BadValue:
        return foundExpected(args);
    case ErrorCode::NonFinite:
        return hasArg
                   ? ErrorTexts::tr("found \"%1\", expected a finite number").arg(verbatim(args, 0))
                   : ErrorTexts::tr("a number is not finite");
    case ErrorCode::BadCount:
        return badCount(args);
    case ErrorCode::DegenerateFrame:
        return ErrorTexts::tr(
            "these axes do not form a frame, expected two of length 1 at a right angle");
    case ErrorCode::EmptyContour:
        return hasArg ? ErrorTexts::tr("the outline is open: its ends are %1 mm apart")
                            .arg(millimetres(args, 0))
                      : ErrorTexts::tr("this contour encloses no area");
    case ErrorCode::BadContour:
        return badContour(args);
    case ErrorCode::UnknownReference:
        return hasArg ? ErrorTexts::tr("there is nothing with the number %1").arg(verbatim(args, 0))
                      : ErrorTexts::tr("this refers to something that does not exist");
    case ErrorCode::DuplicateId:
        return hasArg ? ErrorTexts::tr("the number %1 is used twice, expected one of its own")
                            .arg(verbatim(args, 0))
                      : ErrorTexts::tr("this number is used twice, expected one of its own");
    case ErrorCode::NearlyParallel:
        return ErrorTexts::tr("these two sections are nearly parallel and cannot be joined");
    case ErrorCode::SelfCrossing:
        return ErrorTexts::tr("this contour crosses itself");
    case ErrorCode::BoundariesMeet:
        return ErrorTexts::tr("a hole would touch the edge or another hole");
    case ErrorCode::TooFewPoints:
        return ErrorTexts::tr("too few points would be left to enclose anything");
    case ErrorCode::CannotOffset:
        return cannotOffset(args);
    case ErrorCode::ClosedSlit:
        return closedSlit(args);
    case ErrorCode::NothingToExport:
        return hasArg ? ErrorTexts::tr(
                            "slits leave nothing of any section, so there is nothing to cut")
                      : ErrorTexts::tr("there is no section yet, so there is nothing to cut");
    case ErrorCode::NoSkin:
        return hasArg ? ErrorTexts::tr("none of the places between its contours can be covered "
                                       "(%1), so there is no skin")
                            .arg(verbatim(args, 0))
                      : ErrorTexts::tr(
                            "no contours cross each other at their edges, so there is no skin");
    case ErrorCode::UnknownCommand:
        return hasArg ? ErrorTexts::tr("there is no command \"%1\"").arg(verbatim(args, 0))
                      : ErrorTexts::tr("there is no such command");
    case ErrorCode::BadEvent:
        return args.size() >= 2 ? foundExpected(args)
                                : ErrorTexts::tr("this event makes no sense here");
    case ErrorCode::Unsupported:
        return hasArg
                   ? ErrorTexts::tr("\"%1\" is not supported by this version").arg(phrase(args, 0))
                   : ErrorTexts::tr("this is not supported by this version");
    case ErrorCode::NotWorkedOut:
        return ErrorTexts::tr("this could not be worked out");
    case ErrorCode::NotCutOut:
        return ofSection(
            args,
            ErrorTexts::tr("\"%1\" could not be cut out: what its slits leave of it could "
                           "not be worked out"),
            ErrorTexts::tr("a section could not be cut out"));
    case ErrorCode::NotSolid:
        return ofSection(args, ErrorTexts::tr("the solid of \"%1\" could not be worked out"),
                         ErrorTexts::tr("a solid could not be worked out"));
    case ErrorCode::MarksNotCut:
        return ofSection(args,
                         ErrorTexts::tr("the marks on \"%1\" could not be trimmed at its edge"),
                         ErrorTexts::tr("the marks on a section could not be trimmed at its edge"));
    case ErrorCode::OperationFailed:
        return ofSection(
            args, ErrorTexts::tr("the sections of the operation \"%1\" could not be worked out"),
            ErrorTexts::tr("the sections of an operation could not be worked out"));
    case ErrorCode::StageFailed:
        return hasArg ? ErrorTexts::tr("something went wrong inside FlatFitFab (%1)")
                            .arg(verbatim(args, 0))
                      : ErrorTexts::tr("something went wrong inside FlatFitFab");
    case ErrorCode::Cancelled:
        return ErrorTexts::tr("it was stopped");
    case ErrorCode::BadArchive:
        return hasArg ? phrase(args, 0) : ErrorTexts::tr("the contents of this file are damaged");
    }
    return {}; // not reached: every code is above
}

QString warningSentence(const Warning &warning)
{
    const Args &args = warning.args;
    switch (warning.code) {
    case WarningCode::SkewFrame:
        return ofSection(args, ErrorTexts::tr("%1 was slightly skewed and has been straightened"),
                         ErrorTexts::tr("a section was slightly skewed and has been straightened"));
    case WarningCode::SelfCrossingContour:
        return ofSection(
            args, ErrorTexts::tr("the contour of %1 crosses itself; its largest loop was kept"),
            ErrorTexts::tr("a contour crosses itself; its largest loop was kept"));
    case WarningCode::HoleOutside:
        return ofSection(args,
                         ErrorTexts::tr("a hole of %1 reaches beyond its contour and was left out"),
                         ErrorTexts::tr("a hole reaches beyond its contour and was left out"));
    case WarningCode::DegenerateHole:
        return ofSection(args, ErrorTexts::tr("a hole of %1 has no area and was left out"),
                         ErrorTexts::tr("a hole has no area and was left out"));
    case WarningCode::MergedHoles:
        return ofSection(args, ErrorTexts::tr("holes of %1 overlap and were merged into one"),
                         ErrorTexts::tr("holes overlap and were merged into one"));
    case WarningCode::NotchedContour:
        return ofSection(
            args, ErrorTexts::tr("a hole of %1 reaches beyond its contour and was cut out of it"),
            ErrorTexts::tr("a hole reaches beyond its contour and was cut out of it"));
    case WarningCode::TrailingLines:
        return args.empty() ? ErrorTexts::tr("lines after the last section were ignored")
                            : ErrorTexts::tr("text after the last section was ignored, lines: %1")
                                  .arg(verbatim(args, 0));
    case WarningCode::MissingBlob:
        return args.size() < 2
                   ? ofSection(args, ErrorTexts::tr("%1 could not be read and was left out"),
                               ErrorTexts::tr("a picture or a mesh was left out"))
                   //: %2 is a reason such as "its data is missing"
                   : ErrorTexts::tr("%1 was left out: %2").arg(verbatim(args, 0), phrase(args, 1));
    case WarningCode::MissingTemplate:
        return ofSection(args,
                         ErrorTexts::tr("what %1 shows could not be read; its place was kept"),
                         ErrorTexts::tr("a template could not be read; its place was kept"));
    case WarningCode::LostBinding:
        //: %1 is an expression
        return ErrorTexts::tr("what was to follow “%1” is a plain number now")
            .arg(args.empty() ? QStringLiteral("?") : verbatim(args, 0));
    }
    return {}; // not reached: every code is above
}

QString errorText(const Error &error)
{
    return placed(error.place, errorSentence(error));
}

QString warningText(const Warning &warning)
{
    return placed(warning.place, warningSentence(warning));
}

} // namespace fff::io
