// What the product says that joints hold, and what it says is loose, before the judge.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/document_file.h"
#include "tests/core/analysed.h"
#include "tests/core/session/held_pairs.h"
#include "tests/core/session/random_drawings.h"
#include "tests/test_program.h"

#include <QDir>

using namespace fff;
using namespace fff::test;

namespace {

/// What came of the verdicts on some models.
struct Verdicts
{
    int held = 0, loose = 0, inEachOther = 0;
    QByteArrayList notHeld; // called held, but free beyond their ways
    QByteArrayList caught;  // called loose, but held by all others together
};

void judgeVerdicts(const QByteArray &model, const Analysis &analysis, Verdicts &verdicts)
{
    const Bodies &bodies = analysis.bodies;
    const std::vector<JudgedPiece> pieces = judgedPieces(bodies);
    std::vector<HeldPair> pairs;
    for (const Joint &joint : analysis.assembly.joints)
        for (const Grip &grip : analysis.grips.of(joint).held) {
            pairs.push_back(pairOf(analysis, joint, bodies.firstOf(joint.b) + grip.b,
                                   bodies.firstOf(joint.a) + grip.a));
            pairs.back().name += " | held over " + QByteArray::number(grip.inA, 'f', 2) + " and " +
                                 QByteArray::number(grip.inB, 'f', 2) + " mm";
        }
    for (const JudgedPair &pair : judged(pieces, pairs)) {
        ++verdicts.held;
        if (!pair.isHeld())
            verdicts.notHeld += model + " | " + toText(pair);
    }
    const auto groups = heldGroups(analysis);
    for (std::size_t g = 1; g < groups.size(); ++g) {
        if (groups[g].size() != 1)
            continue;
        ++verdicts.loose;
        const int body = groups[g].front();
        const Freedom freedom = judgedAmongAll(pieces, body);
        if (freedom.getsAway())
            continue;
        // Where it is in another one, which is a fault of its own, nobody can tell.
        if (freedom.inEachOther >= kFreeDepth)
            ++verdicts.inEachOther;
        else
            verdicts.caught +=
                model + " | piece " + QByteArray::number(bodies.at(body).key().piece) + " of " +
                QByteArray::fromStdString(analysis.model.nameOf(bodies.at(body).key().section));
    }
}

void filesIn(const QString &folder, const QString &kind)
{
    QTest::addColumn<QString>("path");
    for (const QFileInfo &file :
         QDir(folder).entryInfoList({QStringLiteral("*.") + kind}, QDir::Files, QDir::Name))
        QTest::newRow(qPrintable(file.fileName())) << file.filePath();
}

} // namespace

class TestGrips : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void realModels_data();
    void realModels();
    void samples_data() { filesIn(QStringLiteral(FFF_SAMPLES), QStringLiteral("fff")); }
    void samples();
    void drawings();

private:
    void judgeFile(const QString &path);
    void say(const Verdicts &verdicts);
};

void TestGrips::say(const Verdicts &verdicts)
{
    for (const QByteArray &line : verdicts.notHeld)
        qInfo("not held | %s", line.constData());
    for (const QByteArray &line : verdicts.caught)
        qInfo("caught | %s", line.constData());
    qInfo("%d held, of these %lld not; %d loose, of these %lld caught, and %d in another one",
          verdicts.held, static_cast<long long>(verdicts.notHeld.size()), verdicts.loose,
          static_cast<long long>(verdicts.caught.size()), verdicts.inEachOther);
}

void TestGrips::judgeFile(const QString &path)
{
    const auto loaded = io::readDocument(path);
    QVERIFY(loaded);
    Verdicts verdicts;
    judgeVerdicts(QTest::currentDataTag(), analysed(loaded->document), verdicts);
    say(verdicts);
    QVERIFY(verdicts.notHeld.empty());
    QVERIFY(verdicts.caught.empty());
}

void TestGrips::realModels_data()
{
    filesIn(QStringLiteral(FFF_SHARED_MODELS), QStringLiteral("txt"));
    if (QDir(QStringLiteral(FFF_SHARED_MODELS)).entryList({QStringLiteral("*.txt")}).isEmpty())
        QTest::newRow("no models here") << QString();
}

// Wrong: green over what comes apart, or red over what holds.
void TestGrips::realModels()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        FFF_WITHOUT_SHARED();
    judgeFile(path);
}

void TestGrips::samples()
{
    QFETCH(QString, path);
    judgeFile(path);
}

void TestGrips::drawings()
{
    Verdicts verdicts;
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        judgeVerdicts("drawing " + QByteArray::number(seed), analysed(randomDrawing(seed)),
                      verdicts);
    say(verdicts);
    // Known: pieces between walls so short, or so far apart, that one slanting shift or one turn
    // leads out of them.
    QVERIFY(verdicts.notHeld.size() <= 5);
    QVERIFY(verdicts.held > 700 && verdicts.loose > 300);
    QVERIFY(verdicts.caught.empty());
}

FFF_TEST(TestGrips)
#include "tst_grips.moc"
