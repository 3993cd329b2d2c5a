// The row of links below a check by itself: no window, no checks.
#include <QTest> // first: moc stumbles over some standard headers

#include <QApplication>

#include "tests/test_program.h"
#include "tests/ui/tip.h"
#include "ui/properties/link_row.h"

#include <QAbstractButton>
#include <QVBoxLayout>

using namespace fff::test;
using namespace fff::ui;

class TestLinkRow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aLinkHasRoomForItsWords_data();
    void aLinkHasRoomForItsWords();
    void aLongLinkBreaksIntoLines();
    void whatFitsIntoALineStaysInIt();
    void linksBreakIntoLines();
};

namespace {

/// A row in a panel as wide as that; links are made while it is hidden, as those of checks are.
struct Panel
{
    explicit Panel(int width)
    {
        row = new LinkRow(&panel);
        auto *layout = new QVBoxLayout(&panel);
        layout->addWidget(row);
        layout->addStretch(1);
        row->hide();
        panel.resize(width, 200);
        panel.show();
    }
    QAbstractButton *link(int index) const
    {
        return row->findChild<QAbstractButton *>(QStringLiteral("checkLink%1").arg(index));
    }
    QWidget panel;
    LinkRow *row = nullptr;
};

} // namespace

void TestLinkRow::aLinkHasRoomForItsWords_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    QTest::newRow("a larger font of the style sheet")
        << QStringLiteral("QWidget { font-size: 19px; letter-spacing: 0px; }") << QString();
    QTest::newRow("a larger font later")
        << QString() << QStringLiteral("QWidget { font-size: 23px; }");
    QTest::newRow("fractions of a pixel")
        << QStringLiteral("QWidget { font-size: 13px; letter-spacing: 0.3px; }") << QString();
}

// Wrong: "Trim Se…ion 120", with plenty of room beside it.
void TestLinkRow::aLinkHasRoomForItsWords()
{
    QFETCH(QString, before);
    QFETCH(QString, after);
    Panel panel(600);
    panel.panel.setStyleSheet(before);
    panel.row->setTexts({QStringLiteral("Trim Section 120"), QStringLiteral("Trim Section 22")});
    panel.row->show();
    QTRY_VERIFY(panel.link(1)->isVisible());
    if (!after.isEmpty())
        panel.panel.setStyleSheet(after);
    for (int i = 0; i < 2; ++i) {
        const QAbstractButton *link = panel.link(i);
        const auto needed = [link] {
            return QFontMetricsF(link->font()).horizontalAdvance(link->text());
        };
        QTRY_VERIFY2(link->width() >= needed(), qPrintable(link->text()));
        QCOMPARE(tipOf(*panel.link(i)), QString());
    }
    QTRY_VERIFY(panel.link(1)->x() > panel.link(0)->geometry().right());
    QVERIFY(panel.row->height() >= panel.link(0)->height());

    // The same row for another check, with a longer text.
    panel.row->setTexts({QStringLiteral("Trim the very long tail spike of the dragon")});
    QTRY_VERIFY(panel.link(0)->width() >=
                QFontMetricsF(panel.link(0)->font()).horizontalAdvance(panel.link(0)->text()));
    QVERIFY(!panel.link(1)->isVisible());
}

// Wrong: words that run out of the panel, or that cannot be read anywhere.
void TestLinkRow::aLongLinkBreaksIntoLines()
{
    Panel panel(140);
    panel.row->setTexts({QStringLiteral("Trim the very long tail spike of the dragon")});
    panel.row->show();
    QTRY_VERIFY(panel.link(0)->width() <= panel.row->width());
    const int line = panel.link(0)->sizeHint().height();
    QTRY_VERIFY(panel.link(0)->height() > line);
    QTRY_VERIFY(panel.row->height() >= panel.link(0)->height());
    QCOMPARE(tipOf(*panel.link(0)), QString());
    panel.panel.resize(900, 200);
    QTRY_COMPARE(panel.link(0)->height(), line);

    // What has no place to break is cut short and said by the tip.
    const QString word = QStringLiteral("Donaudampfschifffahrtsgesellschaftskapitän");
    panel.panel.resize(140, 200);
    panel.row->setTexts({word});
    QTRY_VERIFY(panel.link(0)->width() <= panel.row->width());
    QCOMPARE(tipOf(*panel.link(0)), word);
    // Another one in its place, as wide.
    const QString other = QStringLiteral("Bundesausbildungsförderungsgesetzgeberinnen");
    panel.row->setTexts({other});
    QCOMPARE(tipOf(*panel.link(0)), other);
    panel.panel.resize(900, 200);
    QTRY_COMPARE(panel.link(0)->width(), panel.link(0)->sizeHint().width());
    QCOMPARE(tipOf(*panel.link(0)), QString());
}

// Wrong: "Delete" and below it, out of sight, "it", because of a fraction of a pixel.
void TestLinkRow::whatFitsIntoALineStaysInIt()
{
    Panel panel(900);
    panel.row->show();
    for (const char *text : {"Delete it", "Move it to Body", "Drop it to the ground", "Trim Fin 2",
                             "Mit Body verbinden", "Stretch Front legs to the ground"}) {
        for (int pixels = 9; pixels < 24; ++pixels) {
            panel.panel.setStyleSheet(QStringLiteral("QWidget { font-size: %1px; }").arg(pixels));
            panel.row->setTexts({QLatin1String(text)});
            const QSize size = panel.link(0)->sizeHint();
            QCOMPARE(panel.link(0)->heightForWidth(size.width()), size.height());
            QVERIFY(panel.link(0)->heightForWidth(size.width() - 1) > size.height());
        }
    }
}

// Wrong: two links upon each other, or a row too low for its lines.
void TestLinkRow::linksBreakIntoLines()
{
    Panel panel(200);
    panel.row->setTexts({QStringLiteral("Move it to Body"),
                         QStringLiteral("Stretch the front legs"), QStringLiteral("Delete it")});
    panel.row->show();
    QTRY_VERIFY(panel.link(1)->y() >= panel.link(0)->geometry().bottom());
    QTRY_VERIFY(panel.row->height() > panel.link(2)->geometry().bottom());
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < i; ++k)
            QVERIFY(!panel.link(i)->geometry().intersects(panel.link(k)->geometry()));
}

FFF_TEST_WITH(TestLinkRow, fff::testing::runWithin<TestLinkRow, QApplication>)
#include "tst_link_row.moc"
