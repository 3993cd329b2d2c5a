// What is offered to mend a model, carried out on broken ones.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/analysis/plan_checks.h"
#include "core/io/document_file.h"
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

/// Of what is said of certain sections: its kind and their ids.
std::string keyOf(const Finding &finding)
{
    std::string key = finding.kind->name;
    for (const auto *refs : {&finding.sections, &finding.others}) {
        key += ':';
        for (const SectionRef &ref : *refs)
            key += std::to_string(ref.drawn.value) + ' ';
    }
    return key;
}

/// Errors and warnings, by that.
std::map<std::string, std::pair<int, int>> seenOfEach(const std::vector<Finding> &all)
{
    std::map<std::string, std::pair<int, int>> seen;
    for (const Finding &finding : all) {
        const int weight = finding.kind->weight ? finding.kind->weight(finding) : 1;
        if (finding.severity == Severity::Error)
            seen[keyOf(finding)].first += weight;
        else if (finding.severity == Severity::Warning)
            seen[keyOf(finding)].second += weight;
    }
    return seen;
}

/// How often a link was offered, by what it is to mend.
using Offered = std::map<QString, int>;

/// Each link of the model, carried out and taken back.
void carryOutLinks(const Document &document, const QString &of, Offered &offered)
{
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
            const QString name =
                QStringLiteral("%1: %2").arg(of, findingText(finding, list.model()));
            ++offered[QString::fromLatin1(finding.kind->name)];
            const std::vector<Finding> after = foundIn(mend.edit->document);
            for (const Subject subject : kSubjects) {
                QVERIFY2(seenOf(after, subject).first <= seenOf(before, subject).first,
                         qPrintable(name));
                QVERIFY2(worst(after, subject).value_or(Severity::Good) <=
                             worst(before, subject).value_or(Severity::Good),
                         qPrintable(name));
            }
            // Of the very same sections: what was in two pieces is not in three.
            const auto was = seenOfEach(before);
            for (const auto &[key, is] : seenOfEach(after))
                if (const auto known = was.find(key); known != was.end())
                    QVERIFY2(is <= known->second,
                             qPrintable(name + u' ' + QString::fromStdString(key)));
            // It lessens what it stands under, where that is not a row for many.
            const std::string own = keyOf(finding);
            const auto left = seenOfEach(after);
            if (was.contains(own) && left.contains(own))
                QVERIFY2(left.at(own) < was.at(own), qPrintable(name));
            session.commit(QStringLiteral("Mend"), mend.edit->document);
            session.history()->undo();
            QVERIFY2(session.committed().document.isSame(document), qPrintable(name));
        }
    }
}

} // namespace

class TestMending : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noLinkMakesAnythingWorse_data();
    void noLinkMakesAnythingWorse();
    void aShelfAcrossRibs();
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
    Offered offered;
    for (int seed = first; seed < first + 10; ++seed)
        carryOutLinks(randomDrawing(static_cast<std::uint64_t>(seed)),
                      QStringLiteral("drawing %1").arg(seed), offered);
    QStringList counts;
    for (const auto &[kind, count] : offered)
        counts += QStringLiteral("%1 %2").arg(kind).arg(count);
    qInfo("links: %s", qPrintable(counts.join(QStringLiteral(", "))));
    QVERIFY(!offered.empty());
}

// Wrong: one section is mended by cutting the body that it is on into one piece more; or a link
// under a problem that it leaves as it is.
void TestMending::aShelfAcrossRibs()
{
    const auto loaded =
        io::readDocument(QStringLiteral(FFF_TEST_DATA "/drawings/shelf_across_ribs.fff"));
    QVERIFY(loaded);
    Offered offered;
    carryOutLinks(loaded->document, QStringLiteral("shelf"), offered);
    QVERIFY(!offered.empty());
}

FFF_TEST(TestMending)
#include "tst_mending.moc"
