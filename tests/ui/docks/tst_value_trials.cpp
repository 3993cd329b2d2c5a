// *Try all* in the Values dock as a person uses it, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/docks/values_hand.h"
#include "ui/base/translations.h"
#include "ui/docks/value_trial_rows.h"
#include "ui/properties/link_row.h"

#include <QAbstractButton>
#include <QUndoStack>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

/// A board as long as its value, from 80 to so many mm.
Document board(double most)
{
    Document document = newDocument();
    const SectionId a =
        add(document, "Board", shapeOf(polygonContour(rectangleAt(-50, 0, 100, 60))), frontFrame());
    add(document, "Rib", shapeOf(polygonContour(rectangleAt(-40, 0, 80, 60))), sideFrame({0, 0, 0}),
        Parent{a, {0, 30}, {0, 60}, false});
    document = withValue(std::move(document), "width", "100 mm");
    document = madeOf(document, key("section", a.value, "width"), "width");
    Value width = *document.values.find(std::string_view("width"));
    width.isShown = true;
    width.range = {80.0, most, {}};
    return changeValue(std::move(document), std::move(width)).value();
}

} // namespace

class TestValueTrialRows : public QObject, private ValuesHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { begin(); }
    void cleanup() { end(); }

    void itIsOfferedWhereThereIsSomethingToTry();
    void allHold();
    void placesAreGoneToAndComeBack();
    void narrowingIsOneStep();
    void anEditDropsIt();
    void itCanBeStopped();

private:
    ValueTrialRows &rows() { return *m_window->findChild<ValueTrialRows *>(); }
    LinkRow &links() { return *rows().findChild<LinkRow *>(QStringLiteral("valueTrialLinks")); }
    QString said()
    {
        auto *label = rows().findChild<QLabel *>(QStringLiteral("valueTrialSaid"));
        return label->isVisible() ? label->text() : QString();
    }
    QList<LinkRow *> places()
    {
        QList<LinkRow *> seen;
        for (LinkRow *row : rows().findChildren<LinkRow *>(QStringLiteral("valueTrialPlace")))
            if (row->isVisible())
                seen += row;
        return seen;
    }
    void press(LinkRow &row, int index)
    {
        QTest::mouseClick(row.findChildren<QAbstractButton *>()[index], Qt::LeftButton);
    }
    void tryAll()
    {
        press(links(), 0);
        QTRY_VERIFY_WITH_TIMEOUT(links().texts().constFirst() == QStringLiteral("Try again"),
                                 60'000);
    }
    int steps() { return bench().session().history()->count(); }
};

void TestValueTrialRows::itIsOfferedWhereThereIsSomethingToTry()
{
    open(adjustable()); // it has a range, and is shown to nobody
    QVERIFY(!rows().isVisible());
    bench().session().reset(board(200.0));
    QVERIFY(rows().isVisible());
    QCOMPARE(links().texts(), QStringList{QStringLiteral("Try all ranges")});
    dock().setAdjustsOnly(true);
    QVERIFY(!rows().isVisible());
}

void TestValueTrialRows::allHold()
{
    open(board(200.0));
    tryAll();
    QVERIFY2(said().startsWith(QStringLiteral("All ")), qPrintable(said()));
    QVERIFY(places().isEmpty());
    QCOMPARE(links().texts().size(), 1);
    QCOMPARE(steps(), 0);
}

void TestValueTrialRows::placesAreGoneToAndComeBack()
{
    open(board(3000.0));
    tryAll();
    QVERIFY2(said().contains(QStringLiteral(" fail: ")), qPrintable(said()));
    QVERIFY(!places().isEmpty());
    const QString text = places().constFirst()->texts().constFirst();
    QVERIFY2(text.startsWith(QStringLiteral("width ")), qPrintable(text));
    const QString before = said();
    press(*places().constFirst(), 0);
    QCOMPARE(steps(), 1);
    QVERIFY(worth("width") > 200.0);
    QCOMPARE(said(), before); // the other places can be looked at, too
    press(*places().constLast(), 0);
    QCOMPARE(steps(), 2);
    bench().session().history()->undo();
    bench().session().history()->undo();
    QCOMPARE(worth("width"), 100.0);
    QCOMPARE(said(), before);
}

void TestValueTrialRows::narrowingIsOneStep()
{
    open(board(3000.0));
    tryAll();
    QCOMPARE(links().texts().size(), 2);
    activate();
    links().findChildren<QAbstractButton *>()[1]->setFocus();
    press(links(), 1);
    QCOMPARE(steps(), 1);
    // Wrong: the cursor was in the name of a value, without a word of what had been done.
    QVERIFY(links().isAncestorOf(m_window->focusWidget()));
    QVERIFY2(said().contains(QStringLiteral("width")), qPrintable(said()));
    const Value *width = document().values.find(std::string_view("width"));
    QVERIFY(*width->range.most < 3000.0);
    QCOMPARE(*width->range.least, 80.0);
    QVERIFY(places().isEmpty()); // of other ranges nothing is known
    QCOMPARE(links().texts(), QStringList{QStringLiteral("Try all ranges")});
    bench().session().history()->undo();
    QCOMPARE(said(), QString());
    QCOMPARE(*document().values.find(std::string_view("width"))->range.most, 3000.0);
}

void TestValueTrialRows::anEditDropsIt()
{
    open(board(200.0));
    tryAll();
    type(in<NumberEdit>("width"), QStringLiteral("120"));
    QCOMPARE(said(), QString());
    press(links(), 0); // while it runs
    QCOMPARE(links().texts(), QStringList{QStringLiteral("Stop")});
    bench().session().history()->undo();
    QCOMPARE(links().texts(), QStringList{QStringLiteral("Try all ranges")});
    QTest::qWait(200);
    QCOMPARE(said(), QString());
}

void TestValueTrialRows::itCanBeStopped()
{
    open(board(200.0));
    press(links(), 0);
    QVERIFY(said().contains(u'%'));
    press(links(), 0);
    QCOMPARE(said(), QString());
    QCOMPARE(links().texts(), QStringList{QStringLiteral("Try all ranges")});
}

FFF_TEST_WITH(TestValueTrialRows, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestValueTrialRows test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_value_trials.moc"
