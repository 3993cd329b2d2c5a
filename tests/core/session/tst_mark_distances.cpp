// Numbers on the parts of real models. If this fails, "1" beside "2" is read as twelve, and
// somebody looks for a part that does not exist.
#include <QTest>

#include "core/analysis/analysis.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/core/fabrication/mark_distances.h"
#include "tests/test_program.h"

#include <QDir>

using namespace fff;
using namespace fff::test;

class TestMarkDistances : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersAreReadOneByOne_data();
    void numbersAreReadOneByOne();
};

void TestMarkDistances::numbersAreReadOneByOne_data()
{
    QTest::addColumn<QString>("path");
    for (const char *folder : {FFF_TEST_DATA "/../../resources/samples", FFF_SHARED_MODELS}) {
        const QDir dir(QString::fromUtf8(folder));
        for (const QFileInfo &file :
             dir.entryInfoList({QStringLiteral("*.fff"), QStringLiteral("*.txt")}, QDir::Files))
            QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    }
}

void TestMarkDistances::numbersAreReadOneByOne()
{
    QFETCH(QString, path);
    Result<io::LoadedDocument> read = io::readDocument(path);
    if (!read)
        FFF_WITHOUT_SHARED();
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(std::move(read->document)), caches);
    std::size_t joints = 0, leftOut = 0, unmarked = 0;
    double heights = 0.0;
    const std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    for (const Part &part : parts) {
        const Engraving engraving =
            engrave(part, analysis.model.section(static_cast<std::size_t>(part.section))->marks);
        const QString wrong = misread(engraving, part);
        QVERIFY2(wrong.isEmpty(),
                 qPrintable(QStringLiteral("part %1: %2").arg(part.number).arg(wrong)));
        QCOMPARE(engraving.boxes.size() + engraving.jointsLeftOut.size(),
                 part.joints.size() + (engraving.hasNumber ? 1 : 0));
        joints += part.joints.size();
        leftOut += engraving.jointsLeftOut.size();
        unmarked += engraving.hasNumber ? 0 : 1;
        if (engraving.hasNumber)
            heights += marksOf(engraving).back().height;
    }
    qInfo("%zu parts, %zu without a number, on average %.1f mm; %zu joints' numbers, %zu left out",
          parts.size(), unmarked,
          heights / static_cast<double>(std::max<std::size_t>(1, parts.size() - unmarked)), joints,
          leftOut);
}

FFF_TEST(TestMarkDistances)
#include "tst_mark_distances.moc"
