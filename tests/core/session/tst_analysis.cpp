#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/session/check_text.h"
#include "tests/bench/counted_memory.h"
#include "tests/core/session/random_edits.h"

using namespace fff;
using namespace fff::test;

namespace {

/// What differs between two analyses of one model, in words; nothing when every field is the same.
QString difference(const Analysis &a, const Analysis &b)
{
    if (!a.model.document.isSame(b.model.document))
        return QStringLiteral("the model");
    if (a.assembly.joints.size() != b.assembly.joints.size())
        return QStringLiteral("the number of joints");
    for (std::size_t i = 0; i < a.assembly.joints.size(); ++i) {
        const Joint &x = a.assembly.joints[i], &y = b.assembly.joints[i];
        if (x.id != y.id || x.a != y.a || x.b != y.b || x.kind != y.kind)
            return QStringLiteral("joint %1").arg(i + 1);
        const Crossing &c = *x.crossing, &d = *y.crossing;
        if (c.axis.point != d.axis.point || c.axis.direction != d.axis.direction ||
            c.angle != d.angle || c.overlaps.size() != d.overlaps.size())
            return QStringLiteral("the crossing of joint %1").arg(i + 1);
        for (std::size_t k = 0; k < c.overlaps.size(); ++k) {
            const Overlap &o = c.overlaps[k], &p = d.overlaps[k];
            const auto isSame = [](const AxisEnd &e, const AxisEnd &f) {
                return e.at == f.at && e.ring == f.ring && e.edge == f.edge;
            };
            if (o.from != p.from || o.to != p.to || o.meet != p.meet ||
                !isSame(o.a.from, p.a.from) || !isSame(o.a.to, p.a.to) ||
                !isSame(o.b.from, p.b.from) || !isSame(o.b.to, p.b.to))
                return QStringLiteral("overlap %1 of joint %2").arg(k).arg(i + 1);
        }
    }
    int number = 0;
    for (const Joint &joint : a.assembly.joints) {
        if (joint.id != ++number || &joint != &a.assembly.joints[joint.id - 1] ||
            &joint != a.assembly.joints.find(joint.a, joint.b))
            return QStringLiteral("the order of joint %1").arg(number);
    }
    if (!(a.assembly.slits == b.assembly.slits))
        return QStringLiteral("the slits");
    for (std::size_t i = 0; i < a.model.sectionCount(); ++i) {
        if (a.assembly.boxes[i].min != b.assembly.boxes[i].min ||
            a.assembly.boxes[i].max != b.assembly.boxes[i].max)
            return QStringLiteral("box %1").arg(i);
        const auto &p = a.cuts[i]->parts(), &q = b.cuts[i]->parts();
        if (p.size() != q.size())
            return QStringLiteral("the number of parts of section %1").arg(i);
        for (std::size_t k = 0; k < p.size(); ++k) {
            if (!(p[k].outer == q[k].outer) || !(p[k].holes == q[k].holes) ||
                p[k].region.outer != q[k].region.outer || p[k].region.holes != q[k].region.holes)
                return QStringLiteral("part %1 of section %2").arg(k).arg(i);
        }
    }
    return a.cuts.size() == b.cuts.size() ? QString() : QStringLiteral("the number of cuts");
}

/// What verdicts say, as text that differs when they do.
QString said(const std::vector<Check> &checks, const Model &model)
{
    QString text;
    for (const Check &check : checks)
        text += QString::number(static_cast<int>(check.severity)) + checkText(check, model) +
                QStringLiteral("%1 %2 %3 %4\n")
                    .arg(check.margin)
                    .arg(check.share)
                    .arg(check.at.value_or(Vec3::Zero()).sum())
                    .arg(check.mass.centre.sum());
    return text;
}

} // namespace

class TestAnalysis : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void incrementalEqualsFromScratch_data();
    void incrementalEqualsFromScratch();
    void whatAnEditDoesNotTouchIsShared();
    void aStepCostsSixteenBytesASection_data();
    void aStepCostsSixteenBytesASection();
};

void TestAnalysis::incrementalEqualsFromScratch_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u})
        QTest::addRow("seed %u", seed) << seed;
}

// Wrong: after some sequence of edits, jumps through the history and changes of stock, the window
// would show and cut other slits than a fresh start with the same document.
void TestAnalysis::incrementalEqualsFromScratch()
{
    QFETCH(unsigned, seed);
    RandomEdits edits(seed);
    AnalysisCaches caches;
    CheckCaches verdicts;
    std::vector<Document> history{newDocument()};
    std::size_t joints = 0;
    for (int step = 0; step < 120; ++step) {
        // Now and then back, as undo does, or to anywhere.
        if (edits.below(8) == 0)
            history.push_back(
                history[static_cast<std::size_t>(edits.below(static_cast<int>(history.size())))]);
        else
            history.push_back(edits.next(history.back()));
        const Model model = evaluate(history.back());
        const AnalysisPointer kept = analyseNext(model, caches);
        AnalysisCaches none;
        const AnalysisPointer fresh = analyseNext(model, none);
        const QString wrong = difference(*kept, *fresh);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("step %1: %2").arg(step).arg(wrong)));
        QCOMPARE(said(checks(*kept, verdicts), model), said(checks(*fresh), model));
        joints += kept->assembly.joints.size();
    }
    QVERIFY(joints > 120); // or nothing was tested
}

// Wrong: an edit would cost by the size of the model, and everything would be drawn anew.
void TestAnalysis::whatAnEditDoesNotTouchIsShared()
{
    Document document = newDocument();
    const ShapePointer strip = polygonShape(rectangle(0, 0, 200, 40));
    for (int i = 0; i < 8; ++i)
        document = withSection(std::move(document), strip, front(-20.0 * (i + 1)));
    document = withSection(std::move(document), polygonShape(rectangle(5, 0, 50, 40)), side(50));
    AnalysisCaches caches;
    const AnalysisPointer before = analyseNext(evaluate(document), caches);
    const SectionId id = document.sections.back()->id;
    const AnalysisPointer after =
        analyseNext(evaluate(*moveSection(document, id, side(51))), caches);
    QCOMPARE(before->assembly.joints.size(), std::size_t(2));
    // The moved section itself is cut where it was.
    for (std::size_t i = 0; i < 9; ++i) {
        QCOMPARE(before->cuts[i] != after->cuts[i], i < 2);
        QCOMPARE(before->assembly.slits.pointer(i) != after->assembly.slits.pointer(i), i < 2);
    }
    const AnalysisPointer undone = analyseNext(evaluate(document), caches);
    QVERIFY(undone->cuts == before->cuts);
}

void TestAnalysis::aStepCostsSixteenBytesASection_data()
{
    QTest::addColumn<int>("sections");
    QTest::addColumn<QString>("edit");
    for (int sections : {10, 1000}) {
        for (const char *edit : {"move", "add", "remove", "shape", "stock"})
            QTest::addRow("%s one of %d", edit, sections) << sections << QString::fromLatin1(edit);
    }
}

// Wrong: a day's undo steps would fill the memory, as steps that copy what they do not change do.
void TestAnalysis::aStepCostsSixteenBytesASection()
{
    QFETCH(int, sections);
    QFETCH(QString, edit);
    Document document = newDocument();
    const ShapePointer strip = polygonShape(rectangle(0, 0, 200, 40));
    for (int i = 0; i < sections; ++i)
        document = withSection(std::move(document), strip, front(-20.0 * i));
    const auto model = std::make_shared<const Model>(evaluate(document));
    const ShapePointer other = polygonShape(rectangle(0, 0, 100, 40));
    const SectionId id = document.sections[4]->id;
    const auto edited = [&]() -> Document {
        if (edit == QStringLiteral("move"))
            return *moveSection(model->document, id, side());
        if (edit == QStringLiteral("add"))
            return withSection(model->document, other, side());
        if (edit == QStringLiteral("remove"))
            return *removeSections(model->document, std::vector{id});
        if (edit == QStringLiteral("shape"))
            return *setShape(model->document, id, other);
        Stock stock = *model->document.stocks.front();
        stock.thickness = 4.0;
        return *setStock(model->document, stock);
    };
    // What the history keeps of the step is the model after it.
    const std::int64_t before = bench::liveBytes();
    const auto after = std::make_shared<const Model>(evaluate(edited()));
    const std::int64_t counted = bench::liveBytes() - before;
    const auto lists = static_cast<std::int64_t>(sizeof(std::shared_ptr<void>) *
                                                 (static_cast<std::size_t>(sections) + 1 + 1));
    // The changed object with its text, and the model that holds the lists.
    const auto changed = static_cast<std::int64_t>(std::max(sizeof(Section), sizeof(Stock)) +
                                                   sizeof(Model) + 2 * 16 + 64);
    QVERIFY2(counted <= lists + changed, qPrintable(QString::number(counted)));
    QVERIFY2(counted >= 16 * sections - 16, qPrintable(QString::number(counted)));
    int kept = 0;
    for (const SectionPointer &s : after->document.sections)
        kept += std::count(model->document.sections.begin(), model->document.sections.end(), s);
    QVERIFY(kept >= sections - 1);
}

QTEST_APPLESS_MAIN(TestAnalysis)
#include "tst_analysis.moc"
