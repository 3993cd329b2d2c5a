// Runs a verb of the command line within the test, so that one of its geometric calls can be made
// to fail, and tells what a person would have of it.
#pragma once

#include "app/cli/command_line.h"
#include "core/base/fault_point.h"

#include <QFile>
#include <QTemporaryDir>

#include <cstdio>
#include <unistd.h>

namespace fff::test {

/// Sends what is written to a stream of the process into a file while it lives.
class Redirected
{
public:
    Redirected(std::FILE *stream, const QString &file)
        : m_stream(stream), m_file(file), m_before(dup(fileno(stream)))
    {
        std::fflush(m_stream);
        std::FILE *opened = std::fopen(QFile::encodeName(file).constData(), "w");
        dup2(fileno(opened), fileno(m_stream));
        std::fclose(opened);
    }
    ~Redirected() { finish(); }
    QByteArray finish()
    {
        if (m_before >= 0) {
            std::fflush(m_stream);
            dup2(m_before, fileno(m_stream));
            close(m_before);
            m_before = -1;
        }
        QFile file(m_file);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private:
    std::FILE *m_stream;
    QString m_file;
    int m_before;
};

/// What stood in the file to be written before: it has to stay where nothing is written.
inline const QByteArray kOldFile = "what was there before";

struct VerbRun
{
    int status = -1;
    QByteArray out, err, file;
    std::array<int, kFaultPoints> calls{};

    bool operator==(const VerbRun &other) const
    {
        return status == other.status && out == other.out && err == other.err && file == other.file;
    }
    bool hasWritten() const { return file != kOldFile; }
    /// What it says on standard error that the other one does not.
    QString saysBeside(const VerbRun &other) const
    {
        const QByteArrayList known = other.err.split('\n');
        QStringList lines;
        for (const QByteArray &line : err.split('\n'))
            if (!line.isEmpty() && !known.contains(line))
                lines += QString::fromUtf8(line);
        return lines.join(u'\n');
    }
};

/// A verb with the arguments behind it; output: of "-o", or empty. The call of this kind and number
/// fails; none below 0.
inline VerbRun runVerb(QStringList arguments, const QString &output, FaultPoint point, int call)
{
    const QTemporaryDir folder;
    const QString verb = arguments.takeFirst(), written = folder.filePath(output);
    if (!output.isEmpty()) {
        QFile file(written);
        if (!file.open(QIODevice::WriteOnly) || file.write(kOldFile) < 0)
            return {};
        arguments += {QStringLiteral("-o"), written};
    }
    VerbRun run;
    Redirected out(stdout, folder.filePath(QStringLiteral("out")));
    Redirected err(stderr, folder.filePath(QStringLiteral("err")));
    {
        const FaultWatch watch(point, call);
        run.status = cli::verbNamed(verb.toLatin1().constData()).run(arguments);
        for (std::size_t i = 0; i < kFaultPoints; ++i)
            run.calls[i] = watch.calls(static_cast<FaultPoint>(i));
    }
    run.out = out.finish();
    run.err = err.finish();
    if (!output.isEmpty()) {
        QFile file(written);
        if (file.open(QIODevice::ReadOnly))
            run.file = file.readAll();
    }
    return run;
}

/// So many numbers of calls, spread over all of them, the first and the last among them.
inline std::vector<int> spread(int count, int most)
{
    std::vector<int> calls;
    for (int i = 0; i < std::min(count, most); ++i)
        calls.push_back(count <= most ? i
                                      : static_cast<int>(std::lround(static_cast<double>(i) *
                                                                     (count - 1) / (most - 1))));
    return calls;
}

inline const char *nameOf(FaultPoint point)
{
    static constexpr const char *kNames[] = {"boolean", "curves", "triangles", "line", "contour"};
    return kNames[static_cast<std::size_t>(point)];
}

} // namespace fff::test
