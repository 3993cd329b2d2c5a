// Every geometric call that can fail is made to fail once while the verbs run: either it is of no
// account and the output is what it would have been, or nothing is written and the person is told
// what could not be done, and of what.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/app/fault_models.h"
#include "tests/app/fault_run.h"
#include "tests/test_program.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace fff;
using namespace fff::test;

namespace {

/// Of each kind of call in each run.
constexpr int kMostFaults = 6;

/// All that a sentence may be about: the sections and the operations.
QStringList namesIn(const QString &file)
{
    QStringList names;
    const Result<io::LoadedDocument> loaded = io::readDocument(file);
    if (!loaded)
        return names;
    const Model model = evaluate(loaded->document);
    for (const SectionPointer &section : model.sections())
        names += QString::fromStdString(section->name);
    for (const OperationPointer &operation : model.document.operations)
        names += QString::fromStdString(operation->name);
    return names;
}

bool mentions(const QString &text, const QStringList &names)
{
    return std::any_of(names.begin(), names.end(),
                       [&](const QString &name) { return text.contains(name); });
}

/// One line with a name in it, or with the place in the file where reading it stopped.
bool isSentence(const QString &said, const QString &file, const QStringList &names)
{
    // Also of the file that is written, which is read again before it takes the old one's place.
    const bool isPlaced = said.contains(QStringLiteral(".fff:$."));
    return !said.contains(u'\n') &&
           (isPlaced || (said.startsWith(file) && mentions(said.mid(file.size()), names)));
}

/// What check and info may say of a model in which something could not be worked out.
bool isInAnswer(const QString &verb, const VerbRun &run, const QStringList &names)
{
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    if (verb == QStringLiteral("info"))
        return json[QStringLiteral("assemblable")] == QStringLiteral("unknown");
    for (const QJsonValue &problem : json[QStringLiteral("problems")].toArray()) {
        const QString code = problem[QStringLiteral("code")].toString();
        const bool isNamed = mentions(problem[QStringLiteral("text")].toString(), names);
        if (code == QStringLiteral("notCutOut") || code == QStringLiteral("notMade"))
            return isNamed && run.status == cli::ProblemsFound;
        if (code == QStringLiteral("orderUnknown"))
            return isNamed;
    }
    return false;
}

} // namespace

class TestFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void neverAWrongFile_data();
    void neverAWrongFile();
    void allKindsWereMadeToFail();

private:
    QTemporaryDir m_folder;
    std::array<int, kFaultPoints> m_made{}, m_told{};
};

void TestFaults::initTestCase()
{
    QCoreApplication::setApplicationName(QStringLiteral("flatfitfab-cli"));
    for (const NamedDocument &model : faultModels())
        QVERIFY(io::writeDocument(
            m_folder.filePath(QString::fromStdString(model.name) + QStringLiteral(".fff")),
            model.document));
}

void TestFaults::neverAWrongFile_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("output");
    QStringList files;
    for (const NamedDocument &model : faultModels())
        files += m_folder.filePath(QString::fromStdString(model.name) + QStringLiteral(".fff"));
    for (const char *sample : {"fish", "gears", "glass_four_legs"})
        files += QStringLiteral(FFF_SAMPLES "/%1.fff").arg(QLatin1String(sample));
    const QString json = QStringLiteral("--json");
    for (const QString &file : files) {
        const auto row = [&](const char *verb, const QStringList &options, const char *output) {
            const QString name = QStringLiteral("%1 of %2 %3%4")
                                     .arg(QLatin1String(verb), QFileInfo(file).completeBaseName(),
                                          QLatin1String(output), options.join(u' '));
            QTest::newRow(qPrintable(name))
                << file << (QStringList{QLatin1String(verb), file} + options)
                << QString::fromLatin1(output);
        };
        row("export", {}, "out.svg");
        row("export", {}, "out.obj");
        row("export", {}, "out.fff");
        row("parts", {json}, "");
        row("parts", {json, QStringLiteral("--tolerance"), QStringLiteral("0.05")}, "");
        row("info", {json}, "");
        row("check", {json}, "");
    }
}

// Wrong: a cutting file would lack a part, or a slit, and say nothing of it.
void TestFaults::neverAWrongFile()
{
    QFETCH(QString, file);
    QFETCH(QStringList, arguments);
    QFETCH(QString, output);
    const QStringList names = namesIn(file);
    const VerbRun whole = runVerb(arguments, output, FaultPoint::Boolean, -1);
    QVERIFY(whole.status == cli::Done || whole.status == cli::ProblemsFound);
    QCOMPARE(whole.hasWritten(), true);
    for (std::size_t kind = 0; kind < kFaultPoints; ++kind) {
        const auto point = static_cast<FaultPoint>(kind);
        for (const int call : spread(whole.calls[kind], kMostFaults)) {
            const VerbRun run = runVerb(arguments, output, point, call);
            const QString said = run.saysBeside(whole);
            const QByteArray where = QByteArray(nameOf(point)) + ' ' + QByteArray::number(call) +
                                     " of " + QByteArray::number(whole.calls[kind]) + ": " +
                                     run.err + run.out.left(300);
            ++m_made[kind];
            if (run == whole)
                continue;
            ++m_told[kind];
            const bool hasSentence = isSentence(said, file, names);
            const bool isRefused = run.status == cli::BadInput && hasSentence &&
                                   run.out.isEmpty() && (output.isEmpty() || !run.hasWritten());
            const bool isAnswered = output.isEmpty() && isInAnswer(arguments.first(), run, names) &&
                                    (arguments.first() != QStringLiteral("info") || hasSentence);
            // The file does not hang on it: what could not be known of the model is said beside it.
            const bool isWarned = !output.isEmpty() && run.status == whole.status &&
                                  run.out == whole.out && run.file == whole.file &&
                                  mentions(said, names);
            QVERIFY2(isRefused || isAnswered || isWarned, where.constData());
        }
    }
}

// Wrong: the test above would show nothing of a kind of call.
void TestFaults::allKindsWereMadeToFail()
{
    for (std::size_t kind = 0; kind < kFaultPoints; ++kind) {
        const char *name = nameOf(static_cast<FaultPoint>(kind));
        qInfo("%s: %d made to fail, %d of them told", name, m_made[kind], m_told[kind]);
        QVERIFY2(m_made[kind] > 0 && m_told[kind] > 0, name);
    }
}

FFF_TEST(TestFaults)
#include "tst_faults.moc"
