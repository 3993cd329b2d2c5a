#include <QTest> // first: moc stumbles over some standard headers

#include "core/session/check_list.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/base/field_style.h"
#include "ui/bench/first_sections.h"
#include "ui/bench/workbench.h"
#include "ui/docks/check_entries.h"
#include "ui/docks/check_row.h"
#include "ui/settings/settings.h"
#include "ui/window/badge.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCursor>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHoverEvent>
#include <QLineEdit>
#include <QTemporaryDir>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

/// What a link would make is seen while the cursor is on it, and nothing has been done.
class TestTryingOut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void itIsSeenAsLongAsTheCursorIsThere();
    void badgesShowWhatWouldBe();
    void wordsOfBadgesFoldFromWhatIsGood();
    void anotherModelEndsIt();
    void aClickDoesIt();
    void aClickTooEarlyIsNotLost();
    void aRestingCursorTriesNothing();
    void whatIsWrongComesFirstAndRemarksLast();
    void aLinkToANumberSelectsIt();

private:
    Session &session() { return m_window->bench().session(); }
    Workbench &bench() { return m_window->bench(); }
    /// Two plates that do not hold each other: one runs along the other's edge.
    static Document loose()
    {
        return withSection(withSection(newDocument(), plateOf(-50, 0, 50, 60), front()),
                           plateOf(-40, 0, 40, 60), side(49.5));
    }
    QAbstractButton *link() const
    {
        const auto *row = m_window->findChild<CheckRow *>(QStringLiteral("checkRow0"));
        return row ? row->findChild<QAbstractButton *>(QStringLiteral("checkLink0")) : nullptr;
    }
    void finish()
    {
        session().scheduler().finish();
        QCoreApplication::processEvents();
    }
    void hover(bool isOver)
    {
        const QPointF at(3, 3);
        QEnterEvent enter(at, at, at);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(link(), isOver ? static_cast<QEvent *>(&enter) : &leave);
    }
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestTryingOut::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    qputenv("XDG_DATA_HOME", QFile::encodeName(m_folder->path()));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1280, 800);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    session().commit(QStringLiteral("Draw"), loose());
    m_window->findChild<FirstSections *>()->takeAsIs();
    finish();
    QTRY_VERIFY(link());
}

void TestTryingOut::cleanup()
{
    m_window.reset();
}

void TestTryingOut::itIsSeenAsLongAsTheCursorIsThere()
{
    const Document before = session().committed().document;
    QVERIFY(!bench().tried());
    hover(true);
    QVERIFY(bench().tried());
    QVERIFY(&bench().shownModel() == &bench().tried()->model);
    QVERIFY(bench().differsInTrial(session().committed().ref(1)));
    hover(false);
    QVERIFY(!bench().tried());
    QVERIFY(&bench().shownModel() == &session().model());
    QVERIFY(session().committed().document.isSame(before));
    QCOMPARE(session().history()->count(), 1);
}

// Wrong: beside the picture of what would be stands the red badge of what is.
void TestTryingOut::badgesShowWhatWouldBe()
{
    const auto verdicts = [this] {
        std::vector<std::pair<Severity, QString>> all;
        for (const Badge *badge : m_window->findChildren<Badge *>())
            if (!badge->isHidden())
                all.emplace_back(badge->severity(), badge->accessibleName());
        return all;
    };
    const auto before = verdicts();
    const auto isByWeight = [this] { // from the left
        QCoreApplication::processEvents();
        std::vector<const Badge *> row;
        for (const Badge *badge : m_window->findChildren<Badge *>())
            if (!badge->isHidden())
                row.push_back(badge);
        std::sort(row.begin(), row.end(),
                  [](const Badge *a, const Badge *b) { return a->x() < b->x(); });
        return std::is_sorted(row.begin(), row.end(), [](const Badge *a, const Badge *b) {
            return a->severity() > b->severity();
        });
    };
    QTRY_VERIFY(isByWeight());
    hover(true);
    const auto tried = verdicts();
    QTRY_VERIFY(isByWeight()); // with what is wrong then before what is not known
    hover(false);
    QVERIFY(verdicts() == before);
    const auto errorsIn = [](const auto &all) {
        return std::count_if(all.begin(), all.end(),
                             [](const auto &one) { return one.first == Severity::Error; });
    };
    QVERIFY(errorsIn(tried) < errorsIn(before));
    link()->click();
    finish();
    QTRY_VERIFY(verdicts() == tried); // and that is what comes
}

// Wrong: in a narrow view "Sections overlap" loses its words, and "Connected" keeps them.
void TestTryingOut::wordsOfBadgesFoldFromWhatIsGood()
{
    bool wasFolded = false, wasMixed = false;
    for (int width = 1600; width >= 1024; width -= 16) {
        m_window->resize(width, 700);
        QCoreApplication::processEvents();
        int goodWithWords = 0, badWithout = 0, all = 0, without = 0;
        for (const Badge *badge : m_window->findChildren<Badge *>()) {
            if (badge->isHidden())
                continue;
            const bool isFolded = badge->width() <= badge->widthWhen(true);
            ++all;
            without += isFolded ? 1 : 0;
            goodWithWords += badge->severity() == Severity::Good && !isFolded ? 1 : 0;
            badWithout += badge->severity() == Severity::Error && isFolded ? 1 : 0;
        }
        QVERIFY(badWithout == 0 || goodWithWords == 0);
        wasFolded = wasFolded || without > 0;
        wasMixed = wasMixed || (without > 0 && without < all);
    }
    QVERIFY(wasFolded && wasMixed);
}

// Wrong: the view goes on showing what some edit would have made of a model that is gone.
void TestTryingOut::anotherModelEndsIt()
{
    hover(true);
    QVERIFY(bench().tried());
    session().commit(QStringLiteral("Draw"), withPlate(loose(), 90.0));
    finish();
    QTRY_VERIFY(!bench().tried());
}

void TestTryingOut::aClickDoesIt()
{
    hover(true);
    const Document tried = bench().tried()->model.document;
    link()->click();
    QVERIFY(session().committed().document.isSame(tried));
    QVERIFY(!bench().tried());
    session().history()->undo();
    QVERIFY(!session().committed().document.isSame(tried));
}

// Wrong: the window waits for what is judged, or a click on what is being judged does nothing.
void TestTryingOut::aClickTooEarlyIsNotLost()
{
    // The same model but for a name: the same link, whose effect is not worked out yet.
    Document renamed = session().committed().document;
    Section section = *renamed.sections.front();
    section.name = "Body";
    renamed.sections.front() = std::make_shared<const Section>(section);
    session().commit(QStringLiteral("Rename"), renamed);
    QVERIFY(link());
    link()->click();
    QCOMPARE(session().history()->count(), 2); // not done yet
    QTRY_COMPARE(session().history()->count(), 3);
    QCOMPARE(session().committed().document.sections.front()->name, std::string("Body"));
}

// Wrong: after a click another link comes to be under the cursor, and what that would make is shown
// in place of what was done.
void TestTryingOut::aRestingCursorTriesNothing()
{
    const QPoint at(3, 3);
    QCursor::setPos(link()->mapToGlobal(at));
    QTest::mousePress(link(), Qt::LeftButton, {}, at);
    QTest::mouseRelease(link(), Qt::LeftButton, {}, QPoint(-90, -90)); // not a click
    hover(false);
    hover(true);
    QVERIFY(!bench().tried());
    QHoverEvent moved(QEvent::HoverMove, QPointF(5, 3), QPointF(5, 3), QPointF(3, 3));
    QCoreApplication::sendEvent(link(), &moved);
    QVERIFY(bench().tried());
    hover(false);
    QVERIFY(!bench().tried());
}

// Wrong: on a good model two question marks are read before "Stands".
void TestTryingOut::whatIsWrongComesFirstAndRemarksLast()
{
    const auto *list = m_window->findChild<CheckList *>();
    std::vector<Severity> severities;
    for (const CheckEntry &entry : checkEntries(*list, {}))
        severities.push_back(entry.finding().severity);
    const auto firstOf = [&](Severity severity) {
        return std::find(severities.begin(), severities.end(), severity) - severities.begin();
    };
    const auto count = std::ssize(severities);
    QVERIFY(firstOf(Severity::Error) < firstOf(Severity::Good));
    QVERIFY(firstOf(Severity::Good) < firstOf(Severity::Note) && firstOf(Severity::Note) < count);
    QVERIFY(std::all_of(severities.begin() + firstOf(Severity::Note), severities.end(),
                        [](Severity severity) { return severity == Severity::Note; }));
}

// Wrong: "Set the clearance" opens a window at its top, and the clearance is below its lower edge.
void TestTryingOut::aLinkToANumberSelectsIt()
{
    Document document = withSection(withSection(newDocument(), plateOf(-50, 0, 50, 60), front()),
                                    plateOf(-50, 0, 50, 60), side());
    Stock stock = *document.stocks.front();
    stock.clearance = 0.9;
    session().reset(*setStock(document, stock));
    finish();
    const auto wanted = [this]() -> QAbstractButton * {
        for (auto *button : m_window->findChildren<QAbstractButton *>())
            if (button->text() == QStringLiteral("Set the clearance") && button->isVisible())
                return button;
        return nullptr;
    };
    QTRY_VERIFY(wanted());
    wanted()->click();
    auto *editor = m_window->findChild<QDialog *>(QStringLiteral("stockEditor"));
    QVERIFY(editor && editor->isVisible());
    auto *field = editor->findChild<QDoubleSpinBox *>(QStringLiteral("stockClearance"));
    QVERIFY(field);
    QCOMPARE(editor->focusWidget(), static_cast<QWidget *>(field));
    QVERIFY(field->findChild<QLineEdit *>()->hasSelectedText());
    QTRY_COMPARE(field->visibleRegion().boundingRect(), field->rect());
    editor->close();
}

FFF_TEST_WITH(TestTryingOut, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestTryingOut test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_trying_out.moc"
