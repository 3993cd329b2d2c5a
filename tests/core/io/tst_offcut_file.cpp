// What is left of a sheet, from a drawing. If this fails, parts are laid where nothing is left.
#include "core/io/error_text.h"
#include "core/io/offcut_file.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace fff;
using namespace Qt::Literals::StringLiterals;

class TestOffcutFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLargestOutlineWithItsHoles();
    void singleEdgesAreOneLine();
    void asItIsFilled_data();
    void asItIsFilled();
    void theOutlineIsOpen();
    void whatTheFileDoesNotSay();
    void whatIsNone_data();
    void whatIsNone();

private:
    QString drawing(const QByteArray &shapes)
    {
        const QString path = m_folder.filePath(u"rest.svg"_s);
        QFile file(path);
        if (file.open(QIODevice::WriteOnly))
            file.write("<svg xmlns='http://www.w3.org/2000/svg' width='400mm' height='300mm' "
                       "viewBox='0 0 400 300'>" +
                       shapes + "</svg>");
        return path;
    }

    QTemporaryDir m_folder;
};

/// Wherever it stands on its page it begins at 0, 0; y is up.
void TestOffcutFile::theLargestOutlineWithItsHoles()
{
    const auto spare = io::readOffcut(
        drawing("<rect x='300' y='10' width='20' height='20'/>"
                "<path d='M50 250 H250 V150 H150 V50 H50 Z'/><circle cx='100' cy='200' r='20'/>"),
        3);
    QVERIFY(spare);
    QCOMPARE(spare->count, 3);
    QVERIFY(spare->shape->bounds().min.norm() < 1e-9);
    QVERIFY((spare->size() - Vec2(200, 200)).norm() < 1e-9);
    QCOMPARE(spare->shape->holes().size(), std::size_t(1));
    const double area = 200.0 * 100.0 + 100.0 * 100.0 - M_PI * 20.0 * 20.0;
    QVERIFY(std::abs(spare->shape->area() - area) < 1.0); // circles are four curves
    // The bay is at the upper right.
    QCOMPARE(spare->shape->boundaries().locate({150, 150}), Side::Outside);
    QCOMPARE(spare->shape->boundaries().locate({50, 150}), Side::Inside);
    QCOMPARE(spare->shape->boundaries().locate({50, 50}), Side::Outside); // the hole
    QVERIFY(isUsable(*spare) && !rectangleOf(*spare));
}

void TestOffcutFile::singleEdgesAreOneLine()
{
    const auto spare =
        io::readOffcut(drawing("<g stroke='black'><path d='M10 10 H310'/><path d='M310 10 V210'/>"
                               "<path d='M310.02 210 H10'/><path d='M10 210 V10'/></g>"));
    QVERIFY(spare);
    QVERIFY((spare->size() - Vec2(300, 200)).cwiseAbs().maxCoeff() < 0.05);
}

/// (500 x 350 less a corner) is 137500 mm².
void TestOffcutFile::asItIsFilled_data()
{
    QTest::addColumn<QByteArray>("shapes");
    QTest::addColumn<double>("area"); // mm²
    QTest::addColumn<QStringList>("remarks");
    const QByteArray outline = "M0 0 L500 0 L500 200 L300 350 L0 350 Z ";
    const double all = 500.0 * 350.0 - 0.5 * 200.0 * 150.0;
    const auto row = [](const char *name, const QByteArray &path, double area,
                        const QStringList &remarks = {}) {
        QTest::newRow(name) << QByteArray("<path fill='none' stroke='red' d='" + path + "'/>")
                            << area << remarks;
    };
    row("a hole over the edge", outline + "M250 20 L620 20 L620 150 L250 150 Z",
        all - 250.0 * 130.0);
    row("holes over each other", outline + "M100 80 h120 v120 h-120 Z M160 80 h120 v120 h-120 Z",
        all - 180.0 * 120.0);
    row("a hole that is open", outline + "M100 80 L220 80 L220 200 L100 200", all - 120.0 * 120.0,
        {u"rest.svg: lines in the offcut are open; what they would enclose if they were closed is "
         "left free."_s});
    row("a line that only ends in it", outline + "M100 80 L220 80", all);
    row("drawn twice, from another corner and the other way round",
        outline + "M300 350 L500 200 L500 0 L0 0 L0 350 Z M100 80 h120 v120 h-120 Z",
        all - 120.0 * 120.0);
    row("cut in two", "M0 0 H500 V350 H0 Z M300 -10 H310 V360 H300 Z", 300.0 * 350.0,
        {u"rest.svg: lines cut the offcut into pieces; the largest is taken, 300.0 × 350.0 mm."_s});
    // It crosses itself at 350, 245.
    row("a line that crosses itself",
        "M0 0 L500 0 L500 200 L0 350 L500 350 Z M100 30 h50 v30 h-50 Z", 76250.0 - 50.0 * 30.0,
        {u"rest.svg: the outline crosses itself; the largest piece of it is taken, 500.0 × 245.0 "
         "mm."_s});
    row("a hole drawn round twice", outline + "M100 50 h100 v100 h-100 v-100 h100 v100 h-100 Z",
        all - 100.0 * 100.0);
}

/// What is read is what the drawing shows when it is filled, and no material is guessed.
void TestOffcutFile::asItIsFilled()
{
    QFETCH(QByteArray, shapes);
    QFETCH(double, area);
    QFETCH(QStringList, remarks);
    QStringList said;
    const auto spare = io::readOffcut(drawing(shapes), 1, &said);
    QVERIFY(spare && isUsable(*spare));
    QVERIFY2(std::abs(spare->shape->area() - area) < 0.1,
             qPrintable(QString::number(spare->shape->area())));
    QCOMPARE(said, remarks);
}

/// A hole of it was taken for the sheet.
void TestOffcutFile::theOutlineIsOpen()
{
    const auto spare = io::readOffcut(
        drawing("<path fill='none' stroke='red' d='M0 0 L500 0 L500 200 L300 350 L0 350 M100 80 "
                "L220 80 L220 200 L100 200 Z'/>"));
    QVERIFY(!spare);
    QVERIFY(io::errorText(spare.error())
                .endsWith(u"rest.svg: the outline is open: its ends are 350.00 mm apart"_s));
}

void TestOffcutFile::whatTheFileDoesNotSay()
{
    const QString path = m_folder.filePath(u"px.svg"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 350'>"
               "<rect width='500' height='350'/></svg>");
    file.close();
    QStringList said;
    const auto spare = io::readOffcut(path, 1, &said);
    QVERIFY(spare);
    QCOMPARE(said, QStringList{u"px.svg does not say how large it is in mm or inches; the offcut "
                               "is taken as 132.3 × 92.6 mm."_s});
}

void TestOffcutFile::whatIsNone_data()
{
    QTest::addColumn<QByteArray>("shapes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("an open line") << QByteArray("<path d='M0 0 H100 V100'/>");
    QTest::newRow("holes that touch in a point")
        << QByteArray("<path d='M0 0 H300 V300 H0 Z M100 50 L200 150 L200 50 L100 150 Z'/>");
    QTest::newRow("no area") << QByteArray("<path d='M0 0 H100 H50 Z'/>");
}

void TestOffcutFile::whatIsNone()
{
    QFETCH(QByteArray, shapes);
    const auto spare = io::readOffcut(drawing(shapes));
    QVERIFY(!spare);
    QVERIFY(io::errorText(spare.error()).contains(u"rest.svg"_s));
}

FFF_TEST(TestOffcutFile)
#include "tst_offcut_file.moc"
