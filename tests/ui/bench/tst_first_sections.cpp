// What is wrong with a model that is only begun is not said in red while it is drawn.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/standing.h"
#include "core/session/check_list.h"
#include "core/session/session.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/bench/check_words.h"
#include "ui/bench/first_sections.h"

#include <algorithm>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestFirstSections : public QObject
{
    Q_OBJECT

private:
    static Frame raised()
    {
        Frame frame = front();
        frame.origin.y() += 20.0;
        return frame;
    }
    /// Two that cross, above the ground.
    static Document raisedCross()
    {
        Frame across = side();
        across.origin.y() += 20.0;
        return withSection(withSection(newDocument(), plateOf(-50, 0, 50, 60), raised()),
                           plateOf(-50, 0, 50, 60), across);
    }
    static const Finding *find(const CheckList &list, const FindingKind &kind)
    {
        for (const Finding &finding : list.all())
            if (finding.is(kind))
                return &finding;
        return nullptr;
    }

private Q_SLOTS:
    void nothingTurnsRedUnderTheHand()
    {
        Session session;
        CheckList list{session};
        bool isDrawing = true;
        FirstSections first(session, list, [&isDrawing] { return isDrawing; });
        session.commit(QStringLiteral("Draw"), raisedCross());
        list.finish();
        first.leaveAlone();
        QCOMPARE(find(list, kNoContact)->severity, Severity::Unknown);
        isDrawing = false;
        first.leaveAlone();
        QCOMPARE(find(list, kNoContact)->severity, Severity::Error);
    }
    void greyWhileDrawn()
    {
        Session session;
        CheckList list{session};
        FirstSections first(session, list, [] { return false; });
        session.commit(QStringLiteral("Draw"), raisedCross());
        list.finish();
        const Finding *finding = find(list, kNoContact);
        QVERIFY(finding);
        QCOMPARE(finding->severity, Severity::Unknown);
        const CheckWords words = checkWords(*finding, list.model());
        QCOMPARE(words.title, QStringLiteral("Not on the ground yet"));
        QVERIFY(!words.text.contains(QStringLiteral("Not on the ground")));

        // Left alone, or on its way to the cutter, it is what it is.
        first.takeAsIs();
        finding = find(list, kNoContact);
        QCOMPARE(finding->severity, Severity::Error);
        QCOMPARE(checkWords(*finding, list.model()).title, QStringLiteral("Not on the ground"));

        // The next section begins anew.
        const Document three =
            withSection(session.committed().document, plateOf(-50, 0, 50, 60), side(200));
        session.commit(QStringLiteral("Draw"), three);
        list.finish();
        QCOMPARE(find(list, kNotConnected)->severity, Severity::Unknown);
    }

    void notWithMoreSections()
    {
        Session session;
        CheckList list{session};
        FirstSections first(session, list, [] { return false; });
        Document document = newDocument();
        for (int i = 0; i < 4; ++i)
            document = withSection(document, plateOf(-50, 0, 50, 60), side(100.0 * i));
        session.commit(QStringLiteral("Draw"), document);
        list.finish();
        QCOMPARE(find(list, kNotConnected)->severity, Severity::Error);
    }

    // Wrong: three seconds after the first stroke the new model is red, for want of the second.
    void oneSectionMayHang()
    {
        Session session;
        CheckList list{session};
        FirstSections first(session, list, [] { return false; });
        session.reset(withSection(newDocument(), plateOf(-50, 0, 50, 60), raised()));
        list.finish();
        first.takeAsIs();
        QCOMPARE(find(list, kNoContact)->severity, Severity::Unknown);
        QCOMPARE(checkWords(*find(list, kNoContact), list.model()).title,
                 QStringLiteral("Not on the ground yet"));
    }

    /// What was opened is as somebody left it.
    void notOfAFile()
    {
        Session session;
        CheckList list{session};
        FirstSections first(session, list, [] { return false; });
        session.reset(raisedCross());
        list.finish();
        QCOMPARE(find(list, kNoContact)->severity, Severity::Error);
    }
};

FFF_TEST(TestFirstSections)
#include "tst_first_sections.moc"
