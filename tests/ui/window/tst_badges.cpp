// The verdicts over the view, in a window without its view: in which order they stand, and what a
// click on one shows.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/standing.h"
#include "core/session/check_list.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/bench/check_words.h"
#include "ui/docks/check_entries.h"
#include "ui/docks/check_row.h"
#include "ui/window/badge.h"

#include <QLabel>
#include <QLocale>
#include <QScrollArea>

#include <algorithm>
#include <memory>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

/// Two crosses that both stand by themselves, 200 mm apart; the right one is the larger.
Document crossesApart()
{
    Document document = newDocument();
    for (const double right : {0.0, 200.0}) {
        Frame one = front(), other = side();
        one.origin.x() = other.origin.x() = right;
        const double half = right > 0.0 ? 80.0 : 50.0;
        const ShapePointer plate = polygonShape(rectangle(-half, 0, half, 60));
        document = withSection(std::move(document), plate, one);
        document = withSection(std::move(document), plate, other);
    }
    return document;
}

Document cross()
{
    return twoSections(polygonShape(rectangle(-50, 0, 50, 60)), front(),
                       polygonShape(rectangle(-50, 0, 50, 60)), side())
        .document;
}

const Finding *findingOf(const CheckList &list, const FindingKind &kind)
{
    const auto found = std::find_if(list.all().begin(), list.all().end(),
                                    [&](const Finding &finding) { return finding.is(kind); });
    return found == list.all().end() ? nullptr : &*found;
}

} // namespace

class TestBadges : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup()
    {
        closeEverything();
        m_window = nullptr;
    }

    void theyStandByWeight();
    void theyStandAsTheRowsDo();
    void aDoubtedVerdictShowsItsDoubt();
    void headingsAreShort();
    void rowsAreThereWithTheBadges();

private:
    void show(const Document &document);
    Workbench &bench() { return m_window->bench(); }
    const CheckList &checks() { return *m_window->findChild<CheckList *>(); }
    /// From the left.
    std::vector<const Badge *> row();

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestBadges::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = openWindow();
}

void TestBadges::show(const Document &document)
{
    bench().session().reset(document);
    m_window->findChild<CheckList *>()->finish();
    QTRY_VERIFY(!row().empty());
}

std::vector<const Badge *> TestBadges::row()
{
    std::vector<const Badge *> seen;
    for (const Badge *badge : m_window->findChildren<Badge *>())
        if (badge->isVisible())
            seen.push_back(badge);
    std::sort(seen.begin(), seen.end(),
              [](const Badge *a, const Badge *b) { return a->x() < b->x(); });
    return seen;
}

// Wrong: a bare question mark comes first, and what is wrong is looked for behind it.
void TestBadges::theyStandByWeight()
{
    for (const Document &document : {crossesApart(), eggCrate(2, 2), roundabout(eggCrate(2, 2), 0),
                                     moveAll(crossesApart(), {0, 5, 0})}) {
        show(document);
        const auto isByWeight = [this] {
            const std::vector<const Badge *> seen = row();
            return std::is_sorted(seen.begin(), seen.end(), [](const Badge *a, const Badge *b) {
                return a->severity() > b->severity();
            });
        };
        QTRY_VERIFY(isByWeight());
    }
    show(crossesApart());
    QTRY_VERIFY(row().front()->severity() == Severity::Error);
    const std::vector<const Badge *> seen = row();
    QVERIFY(std::any_of(seen.begin(), seen.end(),
                        [](const Badge *badge) { return badge->severity() == Severity::Unknown; }));
}

// Wrong: what is second among the badges is first among the rows.
void TestBadges::theyStandAsTheRowsDo()
{
    for (const Document &document :
         {crossesApart(), eggCrate(2, 2), roundabout(eggCrate(2, 2), 0),
          moveAll(crossesApart(), {0, 5, 0}), moveAll(eggCrate(2, 2), {0, 5, 0})}) {
        show(document);
        std::vector<QString> rows, badges;
        std::vector<Subject> known;
        for (const CheckEntry &entry : checkEntries(checks(), {})) {
            const Finding &finding = entry.finding();
            if (finding.severity == Severity::Note ||
                std::find(known.begin(), known.end(), finding.subject()) != known.end())
                continue;
            known.push_back(finding.subject());
            rows.push_back(verdictText(finding));
        }
        for (const Badge *badge : row())
            badges.push_back(badge->accessibleName());
        QCOMPARE(badges.size(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            QVERIFY2(badges[i].contains(rows[i]), qPrintable(badges[i] + u'/' + rows[i]));
    }
}

// Wrong: everything that would stand is selected, as if it were all of it that is in doubt.
void TestBadges::aDoubtedVerdictShowsItsDoubt()
{
    show(crossesApart());
    const Finding *wouldStand = findingOf(checks(), kWouldStand);
    const Finding *loose = findingOf(checks(), kNotConnected);
    QVERIFY(wouldStand && loose && wouldStand->sections != loose->sections);
    const std::vector<SectionRef> inDoubt = loose->sections;
    auto *badge = m_window->findChild<Badge *>(QStringLiteral("badge0"));
    QVERIFY(badge->isVisible() && badge->severity() == Severity::Unknown);
    QTest::mouseClick(badge, Qt::LeftButton);
    QCOMPARE(bench().interaction().selection(), inDoubt);
    const auto rows = m_window->findChildren<CheckRow *>();
    const auto chosen = std::find_if(rows.begin(), rows.end(),
                                     [](const CheckRow *row) { return row->isChecked(); });
    QVERIFY(chosen != rows.end()); // which says what it hangs on
    QVERIFY(
        (*chosen)->accessibleName().contains(QStringLiteral("Would stand if it held together")));
}

// Wrong: a heading of three lines that are all names.
void TestBadges::headingsAreShort()
{
    show(crossesApart());
    bool isThere = false;
    for (const CheckRow *row : m_window->findChildren<CheckRow *>()) {
        const QString title = row->findChild<QLabel *>(QStringLiteral("checkTitle"))->text();
        if (!title.contains(QStringLiteral("Would stand")))
            continue;
        isThere = true;
        QCOMPARE(title, QStringLiteral("Would stand if it held together"));
        const QString text = row->findChild<QLabel *>(QStringLiteral("checkText"))->text();
        QVERIFY2(text.startsWith(QStringLiteral("Section 1 and Section 2: It would tip")) ||
                     text.startsWith(QStringLiteral("Section 3 and Section 4: It would tip")) ||
                     text.startsWith(QStringLiteral("Sections ")),
                 qPrintable(text));
    }
    QVERIFY(isThere);
}

// Wrong: badges speak already while the rows still lie over each other, until the view is drawn.
void TestBadges::rowsAreThereWithTheBadges()
{
    QTest::qWait(20); // the dock is where it will be
    const auto *area = m_window->findChild<QScrollArea *>(QStringLiteral("checksArea"));
    for (const Document &document : {eggCrate(2, 2), crossesApart(), cross()}) {
        bench().session().reset(document);
        m_window->findChild<CheckList *>()->finish(); // and nothing else has its turn
        int below = 0;
        for (const CheckRow *row : m_window->findChildren<CheckRow *>()) {
            if (row->isHidden())
                continue;
            QCOMPARE(row->y(), below);
            QCOMPARE(row->width(), area->viewport()->width());
            below += row->height();
        }
        QVERIFY(below > 0);
    }
}

FFF_TEST_WITH(TestBadges, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    TestBadges test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_badges.moc"
