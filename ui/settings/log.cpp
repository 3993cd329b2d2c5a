#include "ui/settings/log.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QMutex>
#include <QStringList>

#include <algorithm>

namespace fff::ui {

namespace {

struct LogFile
{
    QMutex mutex;
    QString path;
    QtMessageHandler before = nullptr;
};

LogFile &theLog()
{
    static LogFile log;
    return log;
}

const char *wordOf(QtMsgType type)
{
    switch (type) {
    case QtDebugMsg:
        return "debug";
    case QtInfoMsg:
        return "info";
    case QtWarningMsg:
        return "warning";
    case QtCriticalMsg:
        return "error";
    case QtFatalMsg:
        return "fatal";
    }
    return ""; // not reached: every type is above
}

/// Opened for each line: several windows' programs write to the same one, and the last words before
/// a crash are on the disk.
void write(const QString &line)
{
    LogFile &log = theLog();
    const QMutexLocker lock(&log.mutex);
    QFile file(log.path);
    if (log.path.isEmpty() || !file.open(QIODevice::WriteOnly | QIODevice::Append))
        return;
    const QString time = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
    file.write(
        QStringLiteral("%1 %2 %3\n")
            .arg(time, QString::number(QCoreApplication::applicationPid()), line.simplified())
            .toUtf8());
}

void handle(QtMsgType type, const QMessageLogContext &context, const QString &text)
{
    write(QLatin1String(wordOf(type)) + QStringLiteral(": ") + text);
    if (theLog().before)
        theLog().before(type, context, text);
}

} // namespace

void keepLog(const QString &folder)
{
    LogFile &log = theLog();
    const QDir place(folder);
    {
        const QMutexLocker lock(&log.mutex);
        log.path = place.mkpath(QStringLiteral("."))
                       ? place.absoluteFilePath(QStringLiteral("log.txt"))
                       : QString();
        if (QFile(log.path).size() > kLongLog) {
            const QString before = place.absoluteFilePath(QStringLiteral("log-before.txt"));
            QFile::remove(before);
            QFile::rename(log.path, before);
        }
    }
    if (!log.before)
        log.before = qInstallMessageHandler(handle);
}

void noteInLog(const QString &line)
{
    write(line);
}

QString endOfLog(int lines)
{
    LogFile &log = theLog();
    const QMutexLocker lock(&log.mutex);
    QFile file(log.path);
    if (log.path.isEmpty() || !file.open(QIODevice::ReadOnly))
        return {};
    const QStringList all = QString::fromUtf8(file.readAll()).split(u'\n', Qt::SkipEmptyParts);
    return all.mid(std::max<qsizetype>(0, all.size() - lines)).join(u'\n');
}

} // namespace fff::ui
