// Runs the command line as a person does.
#pragma once

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>

namespace fff::test {

struct Run
{
    int status = -1;
    QByteArray out, err;
};

/// variables: of the environment, set in this order; an empty one is taken out.
inline Run run(const QString &program, const QStringList &arguments,
               const QList<std::pair<const char *, const char *>> &variables,
               bool hasDisplay = true)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (!hasDisplay) {
        for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            environment.remove(QLatin1String(name));
    }
    for (const auto &[name, value] : variables) {
        environment.insert(QLatin1String(name), QLatin1String(value));
        if (*value == '\0')
            environment.remove(QLatin1String(name));
    }
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    Run result;
    if (process.waitForFinished(120000) && process.exitStatus() == QProcess::NormalExit)
        result.status = process.exitCode();
    result.out = process.readAllStandardOutput();
    result.err = process.readAllStandardError();
    return result;
}

inline Run run(const QStringList &arguments, bool hasDisplay = true)
{
    return run(QStringLiteral(FFF_CLI), arguments, {}, hasDisplay);
}

inline QJsonObject object(const QByteArray &json)
{
    return QJsonDocument::fromJson(json).object();
}

} // namespace fff::test
