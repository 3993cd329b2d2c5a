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

void TestOffcutFile::whatIsNone_data()
{
    QTest::addColumn<QByteArray>("shapes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("an open line") << QByteArray("<path d='M0 0 H100 V100'/>");
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
