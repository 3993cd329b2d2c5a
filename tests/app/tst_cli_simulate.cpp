// `simulate`, as scripts read it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

const QString kStand = QStringLiteral(FFF_SAMPLES "/glass_three_legs.fff");

QJsonObject simulated(const QStringList &options = {})
{
    return QJsonDocument::fromJson(
               run(QStringList{u"simulate"_s, kStand, u"--json"_s} + options).out)
        .object();
}

} // namespace

class TestCliSimulate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsForcesAndStresses();
    void weightsOfOneRun();
    void pushesAreNoMass();
    void doesNotPraiseWhatIsLoose();
    void platesThatLieFlat();
    void wrongWeights_data();
    void wrongWeights();
};

// Wrong: a script adds up the numbers and they do not.
void TestCliSimulate::tellsForcesAndStresses()
{
    const QJsonObject told = simulated();
    QCOMPARE(told[u"equilibrium"].toString(), u"stable"_s);
    QCOMPARE(told[u"verdict"].toString(), u"barelyHolds"_s);
    double carried = 0.0;
    for (const QJsonValue &reaction : told[u"reactions"].toArray())
        carried += reaction[u"force"][1].toDouble();
    const double weight = told[u"totalWeight"].toDouble();
    QVERIFY(weight > 0.0 && std::abs(carried - weight) < 1e-9 * weight);
    QVERIFY(told[u"residual"].toDouble() < 1e-9);
    QVERIFY(!told[u"joints"].toArray().isEmpty());
    double worst = 0.0;
    for (const QJsonValue &section : told[u"sections"].toArray()) {
        QVERIFY(section[u"maxStress"].toDouble() <= section[u"maxStressFactored"].toDouble());
        worst = std::max(worst, section[u"utilisation"].toDouble());
    }
    QVERIFY(worst > 0.0);
    QCOMPARE(told[u"maxUtilisation"].toDouble(), worst);
    QVERIFY(told[u"cracksFrom"].toDouble() < told[u"breaksAt"].toDouble());
    QVERIFY(told[u"milliseconds"][u"equilibrium"].isDouble());
    QVERIFY(told[u"milliseconds"][u"stress"].isDouble());
    const Run asText = run({u"simulate"_s, kStand});
    QCOMPARE(asText.status, 0);
    QVERIFY(asText.out.contains("Barely holds"));
}

// Wrong: the weight is not there, or stays in the file.
void TestCliSimulate::weightsOfOneRun()
{
    const double before = simulated()[u"totalWeight"].toDouble();
    const double with = simulated({u"--weight"_s, u"Shelf=100g"_s, u"--weight"_s,
                                   u"Shelf@5,5=1kg"_s})[u"totalWeight"]
                            .toDouble();
    QVERIFY(std::abs(with - before - 1.1 * 9.81) < 1e-9);
    QCOMPARE(simulated()[u"totalWeight"].toDouble(), before);
}

// Wrong: "Stands. Holds." of plates that nothing joins, and "stable" of them.
void TestCliSimulate::doesNotPraiseWhatIsLoose()
{
    const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
    Document document = twoSections(plate, front(), plate, side()).document;
    Frame one = front(), other = side();
    one.origin.x() = other.origin.x() = 300.0;
    document = withSection(withSection(std::move(document), plate, one), plate, other);
    const QTemporaryDir folder;
    const QString file = folder.filePath(u"loose.fff"_s);
    QVERIFY(io::writeDocument(file, document));
    const Run asText = run({u"simulate"_s, file});
    QVERIFY2(asText.out.contains("Would stand if it held together.") &&
                 asText.out.contains("Would hold if it held together."),
             asText.out.constData());
    const QJsonObject told =
        QJsonDocument::fromJson(run({u"simulate"_s, file, u"--json"_s}).out).object();
    QCOMPARE(told[u"verdict"].toString(), u"unstable"_s);
    QVERIFY(told[u"warnings"].toArray().contains(u"Would stand if it held together."_s));
    const Run info = run({u"info"_s, file});
    QVERIFY2(info.out.contains("Would stand if it held together."), info.out.constData());
}

// Wrong: of a square on the table it is not known whether it holds: every line across it goes
// through a foot that is wider.
void TestCliSimulate::platesThatLieFlat()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(u"flat.fff"_s);
    for (const Vec2 &size : {Vec2(60, 60), Vec2(100, 100), Vec2(59, 60), Vec2(60, 400)}) {
        Document document = newDocument();
        const Frame flat{
            {0, 0.5 * document.stocks.front()->thickness, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
        document = withSection(std::move(document), plateOf(0, 0, size.x(), size.y()), flat);
        QVERIFY(io::writeDocument(file, document));
        const Run told = run({u"simulate"_s, file});
        QVERIFY2(told.out.contains("Stands.\nHolds."), told.out.constData());
    }
    // Of thin card, with a neck between two lobes that nothing lifts.
    Document card = newDocument();
    Stock thin = *card.stocks.front();
    thin.thickness = 0.3;
    card = setStock(std::move(card), thin).value();
    const ShapePointer lobes = polygonShape({{-200, -100},
                                             {-100, -100},
                                             {-100, -2},
                                             {100, -2},
                                             {100, -100},
                                             {200, -100},
                                             {200, 100},
                                             {100, 100},
                                             {100, 2},
                                             {-100, 2},
                                             {-100, 100},
                                             {-200, 100}});
    const Frame lying{{0, 0.15, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
    QVERIFY(io::writeDocument(file, withSection(std::move(card), lobes, lying)));
    const Run told = run({u"simulate"_s, file});
    QVERIFY2(told.out.contains("Stands.\nHolds."), told.out.constData());
}

// Wrong: "from 5.1 kg in all" of what nobody weighs.
void TestCliSimulate::pushesAreNoMass()
{
    QFile file(kStand);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonObject model = QJsonDocument::fromJson(file.readAll()).object();
    QJsonObject push = model[u"weights"][0].toObject();
    for (const char *gone : {"mass", "preset", "filled", "height", "name"})
        push.remove(QLatin1String(gone));
    push[u"id"_s] = 1000;
    push[u"force"_s] = QJsonArray{0.0, 0.0, -5.0};
    model[u"pushes"_s] = QJsonArray{push};
    model[u"nextId"_s] = 1001;
    QTemporaryDir folder;
    const auto said = [&](const QJsonObject &of) {
        QFile written(folder.filePath(u"m.fff"_s));
        return written.open(QIODevice::WriteOnly) &&
                       written.write(QJsonDocument(of).toJson()) > 0 && written.flush()
                   ? run({u"simulate"_s, written.fileName()}).out
                   : QByteArray();
    };
    QVERIFY(run({u"simulate"_s, kStand}).out.contains(" g in all."));
    QVERIFY(said(model).contains(" times the load."));
    model.remove(u"weights"_s);
    const QByteArray pushed = said(model);
    QVERIFY(pushed.contains(" N in all.") && !pushed.contains("g in all"));
}

void TestCliSimulate::wrongWeights_data()
{
    QTest::addColumn<QString>("weight");
    QTest::newRow("no mass") << u"Shelf"_s;
    QTest::newRow("no unit") << u"Shelf=3"_s;
    QTest::newRow("no unit in a part") << u"Shelf=1kg+3"_s;
    QTest::newRow("a comma, of thousands or decimals") << u"Shelf=1,000g"_s;
    QTest::newRow("not finite") << u"Shelf=1kg/0"_s;
    QTest::newRow("nothing") << u"Shelf=0g"_s;
    QTest::newRow("less than nothing") << u"Shelf=-1kg"_s;
    QTest::newRow("more than all") << u"Shelf=1000001kg"_s;
    QTest::newRow("no number") << u"Shelf=e5kg"_s;
    QTest::newRow("nobody") << u"Nobody=3g"_s;
    QTest::newRow("a place that is none") << u"Shelf@a,b=3g"_s;
    QTest::newRow("nowhere") << u"Shelf@1e300,0=3g"_s;
}

// Wrong: it goes on with something else, or does not say with what it cannot.
void TestCliSimulate::wrongWeights()
{
    QFETCH(QString, weight);
    const Run told = run({u"simulate"_s, kStand, u"--weight"_s, weight});
    QCOMPARE(told.status, 1);
    QVERIFY(told.out.isEmpty());
    QVERIFY(told.err.contains(weight.toUtf8()));
}

FFF_TEST(TestCliSimulate)
#include "tst_cli_simulate.moc"
