// What is offered to mend a model, carried out on broken ones.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/analysis/plan_checks.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/session.h"
#include "tests/core/analysed.h"
#include "tests/core/session/random_drawings.h"
#include "tests/test_program.h"

#include <algorithm>
#include <map>

using namespace fff;
using namespace fff::test;

namespace {

/// From scratch, without what tries edits.
std::vector<Finding> foundIn(const Document &document)
{
    const Analysis analysis = analysed(document);
    std::vector<Finding> all = checks(analysis);
    for (Finding &finding : planChecks(analysis, planOf(analysis)))
        all.push_back(std::move(finding));
    return all;
}

constexpr Subject kSubjects[] = {Subject::Connection, Subject::Stability, Subject::Assembly,
                                 Subject::Size, Subject::Joints};

/// How many of what a person would see in red, and how many in amber.
std::pair<int, int> seenOf(const std::vector<Finding> &all, Subject subject)
{
    const auto count = [&](Severity severity) {
        int sum = 0; // of loose pieces each by itself
        for (const Finding &finding : all)
            if (finding.subject() == subject && finding.severity == severity)
                sum += finding.kind->weight ? finding.kind->weight(finding) : 1;
        return sum;
    };
    return {count(Severity::Error), count(Severity::Warning)};
}

} // namespace

class TestMending : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noLinkMakesAnythingWorse_data();
    void noLinkMakesAnythingWorse();
};

void TestMending::noLinkMakesAnythingWorse_data()
{
    QTest::addColumn<int>("first");
    for (int first = 0; first < 100; first += 10)
        QTest::addRow("drawings %d to %d", first, first + 9) << first;
}

// Wrong: a link that mends one thing and breaks another, or that undo does not take back.
void TestMending::noLinkMakesAnythingWorse()
{
    QFETCH(int, first);
    int links = 0;
    std::map<QString, int> kinds;
    for (int seed = first; seed < first + 10; ++seed) {
        const Document document = randomDrawing(static_cast<std::uint64_t>(seed));
        const std::vector<Finding> before = foundIn(document);
        Session session;
        CheckRules patient;
        patient.planningTime = std::chrono::minutes(10); // else it depends on the clock
        session.scheduler().setRules(patient);
        CheckList list(session);
        session.commit(QStringLiteral("Draw"), document);
        list.finish();
        const std::vector<Finding> all = list.all();
        for (const Finding &finding : all) {
            const std::vector<Mend> mends = list.mendsOf(finding);
            for (const Mend &mend : mends) {
                if (!mend.isEdit())
                    continue;
                ++links;
                const QString name = QStringLiteral("drawing %1: %2")
                                         .arg(seed)
                                         .arg(findingText(finding, list.model()));
                ++kinds[QString::fromLatin1(finding.kind->name)];
                const std::vector<Finding> after = foundIn(mend.edit->document);
                for (const Subject subject : kSubjects) {
                    QVERIFY2(seenOf(after, subject).first <= seenOf(before, subject).first,
                             qPrintable(name));
                    QVERIFY2(worst(after, subject).value_or(Severity::Good) <=
                                 worst(before, subject).value_or(Severity::Good),
                             qPrintable(name));
                }
                session.commit(QStringLiteral("Mend"), mend.edit->document);
                session.history()->undo();
                QVERIFY2(session.committed().document.isSame(document), qPrintable(name));
            }
        }
    }
    QStringList counts;
    for (const auto &[kind, count] : kinds)
        counts += QStringLiteral("%1 %2").arg(kind).arg(count);
    qInfo("%d links: %s", links, qPrintable(counts.join(QStringLiteral(", "))));
    QVERIFY(links > 0);
}

FFF_TEST(TestMending)
#include "tst_mending.moc"
