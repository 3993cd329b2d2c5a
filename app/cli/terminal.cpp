#include "app/cli/terminal.h"

#include "app/cli/command_line.h"

#include <QCoreApplication>
#include <QTextStream>

#include <cstdio>

namespace fff::cli {

namespace {

constexpr char16_t kPictures = 0x2400, kPictureOfDelete = 0x2421; // "Control Pictures" of Unicode
constexpr char16_t kSpace = 0x20, kDelete = 0x7F;

bool isControl(QChar c)
{
    return c.category() == QChar::Other_Control || c.category() == QChar::Separator_Line ||
           c.category() == QChar::Separator_Paragraph;
}

QChar pictureOf(QChar control)
{
    if (control.unicode() < kSpace)
        return QChar(static_cast<char16_t>(kPictures + control.unicode()));
    return control.unicode() == kDelete ? QChar(kPictureOfDelete)
                                        : QChar(QChar::ReplacementCharacter);
}

} // namespace

QString asLine(const QString &text)
{
    QString line = text;
    for (QChar &c : line)
        if (isControl(c))
            c = pictureOf(c);
    return line;
}

void printError(const QString &line)
{
    QTextStream(stderr) << asLine(line) << Qt::endl;
}

int printLines(const QStringList &lines)
{
    QString text;
    for (const QString &line : lines)
        text += asLine(line) + u'\n';
    return print(text.toStdString());
}

int print(const std::string &bytes)
{
    const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() &&
                           std::fflush(stdout) == 0;
    if (isWritten)
        return Done;
    printError(QCoreApplication::translate("CommandLine", "Standard output could not be written."));
    return CannotWrite;
}

} // namespace fff::cli
