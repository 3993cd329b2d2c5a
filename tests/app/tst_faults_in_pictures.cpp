// The same as tst_faults of pictures: one of the model shows what is known and says what is not, of
// the steps there are none then.
#include <QGuiApplication>
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/app/fault_models.h"
#include "tests/app/fault_run.h"
#include "tests/test_program.h"

#include <QGuiApplication>
#include <QImage>

using namespace fff;
using namespace fff::test;

class TestFaultsInPictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void sayWhatIsMissing_data();
    void sayWhatIsMissing();
    void someHadSteps();

private:
    QTemporaryDir m_folder;
    int m_withSteps = 0;
};

void TestFaultsInPictures::initTestCase()
{
    for (const NamedDocument &model : faultModels())
        QVERIFY(io::writeDocument(
            m_folder.filePath(QString::fromStdString(model.name) + QStringLiteral(".fff")),
            model.document));
}

void TestFaultsInPictures::sayWhatIsMissing_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("verb");
    for (const NamedDocument &model : faultModels()) {
        const QString file =
            m_folder.filePath(QString::fromStdString(model.name) + QStringLiteral(".fff"));
        for (const char *verb : {"render", "steps"})
            QTest::addRow("%s of %s", verb, model.name.c_str())
                << file << QString::fromLatin1(verb);
    }
}

// Wrong: someone would look at a model that is not theirs, or build by steps that were never found.
void TestFaultsInPictures::sayWhatIsMissing()
{
    QFETCH(QString, file);
    QFETCH(QString, verb);
    const bool isPicture = verb == QStringLiteral("render");
    QStringList arguments{verb, file};
    if (isPicture)
        arguments += {QStringLiteral("--size"), QStringLiteral("200x150")};
    const QString output = isPicture ? QStringLiteral("out.png") : QStringLiteral("out.pdf");
    const VerbRun whole = runVerb(arguments, output, FaultPoint::Boolean, -1);
    if (!whole.hasWritten()) { // this one has no steps
        QVERIFY(!isPicture);
        return;
    }
    QCOMPARE(whole.status, int(cli::Done));
    m_withSteps += isPicture ? 0 : 1;
    for (std::size_t kind = 0; kind < kFaultPoints; ++kind) {
        const auto point = static_cast<FaultPoint>(kind);
        for (const int call : spread(whole.calls[kind], 4)) {
            const VerbRun run = runVerb(arguments, output, point, call);
            const QByteArray where = QByteArray(nameOf(point)) + ' ' + QByteArray::number(call) +
                                     " of " + QByteArray::number(whole.calls[kind]) + ": " +
                                     run.err;
            const QString said = run.saysBeside(whole);
            const bool isSaid = said.startsWith(file) && !said.contains(u'\n');
            if (run.status == cli::BadInput) {
                QVERIFY2(isSaid && !run.hasWritten(), where.constData());
            } else {
                QVERIFY2(run.status == cli::Done, where.constData());
                // Of a mark at most, which is drawn as it is; a PDF tells the time.
                const bool isSame = isPicture ? run.file == whole.file : true;
                QVERIFY2(isSame || isSaid || point == FaultPoint::Line, where.constData());
                QVERIFY2(isPicture ? !QImage::fromData(run.file).isNull() : run.hasWritten(),
                         where.constData());
            }
        }
    }
}

// Wrong: the test above would show nothing of steps.
void TestFaultsInPictures::someHadSteps()
{
    QVERIFY(m_withSteps > 0);
}

FFF_TEST_WITH(TestFaultsInPictures, fff::testing::runWithin<TestFaultsInPictures, QGuiApplication>)
#include "tst_faults_in_pictures.moc"
