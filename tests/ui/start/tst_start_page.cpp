// The first page: what it says of files that were opened before, and how much of it is seen at
// once.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/cards/card_grid.h"
#include "ui/cards/model_card.h"
#include "ui/start/start_page.h"

#include <QDateTime>
#include <QFile>

#include <algorithm>
#include <memory>
#include <set>

using namespace fff;
using namespace fff::ui;

class TestStartPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup()
    {
        m_page.reset();
        closeEverything();
    }

    void whenAFileWasOpenedIsSaid();
    void ofAnOldListNothingIsSaid();
    void theUsualWindowHasSixColumns();
    void cardsFillTheWidth();

private:
    void open()
    {
        m_page = std::make_unique<StartPage>();
        m_page->resize(1440, 800);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    }
    QString file(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QString said(int card) const
    {
        return m_page->findChildren<ModelCard *>(QStringLiteral("recentCard"))
            .at(card)
            ->accessibleName();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<StartPage> m_page;
};

void TestStartPage::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(file("settings.ini"));
    for (const char *name : {"a.fff", "b.fff"})
        QVERIFY(io::writeDocument(file(name), squareDocument()));
}

// Wrong: what was copied onto the disk years ago and opened yesterday is "3 March".
void TestStartPage::whenAFileWasOpenedIsSaid()
{
    const QDateTime now = QDateTime::currentDateTime(); // the page reads the clock, too
    settings().addRecentFile(file("b.fff"), now.addDays(-3));
    settings().addRecentFile(file("a.fff"), now.addDays(-2));
    open();
    QTRY_VERIFY2(said(0).contains(QStringLiteral("2 day")), qPrintable(said(0)));
    QTRY_VERIFY2(said(1).contains(QStringLiteral("3 day")), qPrintable(said(1)));
    settings().addRecentFile(file("b.fff"), now);
    QTRY_VERIFY2(said(0).startsWith(QStringLiteral("b")) &&
                     said(0).contains(QStringLiteral("just now")),
                 qPrintable(said(0)));
    const Settings again(file("settings.ini"));
    QCOMPARE(again.recentTime(file("a.fff")).date(), now.addDays(-2).date());
    QVERIFY(!again.recentTime(file("gone.fff")).isValid());
}

// A list that was written before there were times in it.
void TestStartPage::ofAnOldListNothingIsSaid()
{
    settings().addRecentFile(file("a.fff"), QDateTime());
    QVERIFY(!settings().recentTime(file("a.fff")).isValid());
    open();
    QTRY_VERIFY2(said(0).contains(QStringLiteral("1 section")), qPrintable(said(0)));
    QVERIFY2(!said(0).contains(QStringLiteral("ago")) &&
                 !said(0).contains(QStringLiteral("just now")),
             qPrintable(said(0)));
}

// Wrong: the bar that scrolls the samples takes a column of them.
void TestStartPage::theUsualWindowHasSixColumns()
{
    settings().addRecentFile(file("a.fff"));
    open();
    const auto *samples = m_page->findChild<CardGrid *>(QStringLiteral("startSamples"));
    const auto columns = [samples] {
        std::set<int> at;
        for (const auto *card : samples->findChildren<ModelCard *>())
            at.insert(card->x());
        return at.size();
    };
    QTRY_COMPARE(columns(), std::size_t(6));
    const auto *recent = m_page->findChild<CardGrid *>(QStringLiteral("startRecent"));
    QTRY_COMPARE(recent->height(), ModelCard::kHeight); // one row
}

// Wrong: a strip as wide as a card stays empty beside the samples.
void TestStartPage::cardsFillTheWidth()
{
    settings().addRecentFile(file("a.fff"));
    open();
    for (const int width : {1024, 1280, 1440, 1920}) {
        m_page->resize(width, 640);
        QTest::qWait(20);
        const auto *grid = m_page->findChild<CardGrid *>(QStringLiteral("startSamples"));
        int right = 0;
        for (const auto *card : grid->findChildren<ModelCard *>()) {
            right = std::max(right, card->geometry().right() + 1);
            QVERIFY(card->width() >= ModelCard::kWidth && card->width() <= 240);
        }
        QVERIFY2(
            right <= grid->width() && right > grid->width() - 16,
            qPrintable(QStringLiteral("%1: %2 of %3").arg(width).arg(right).arg(grid->width())));
    }
}

FFF_TEST_WITH(TestStartPage, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    TestStartPage test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_start_page.moc"
