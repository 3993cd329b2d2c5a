#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/document_file.h"
#include "core/io/fff_format.h"
#include "core/model/load_edits.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QDir>

using namespace fff;
using namespace fff::test;

namespace {

std::vector<SectionRef> allOf(const Model &model)
{
    std::vector<SectionRef> all;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        all.push_back(model.ref(i));
    return all;
}

/// What two models differ in besides ids; empty: in nothing. Of b the sections from `first` on.
std::string difference(const Model &a, const Model &b)
{
    if (a.sectionCount() != b.sectionCount())
        return "count of sections";
    const auto on = [](const Model &model, const Section &section) {
        return section.parent ? model.indexOf(section.parent->section) : -2;
    };
    for (std::size_t i = 0; i < a.sectionCount(); ++i) {
        const Section &p = *a.section(i), &q = *b.section(i);
        const auto say = [&p](const char *what) { return p.name + ": " + what; };
        if (p.name != q.name)
            return say("name");
        if (!(*p.shape == *q.shape))
            return say("shape");
        if (!(p.frame == q.frame))
            return say("frame");
        if (on(a, p) != on(b, q))
            return say("parent");
        if (p.parent && p.parent->slitTo != q.parent->slitTo)
            return say("slit");
        Stock same = a.stockOf(i);
        same.id = b.stockOf(i).id;
        if (!(same == b.stockOf(i)))
            return say("stock");
        // What is made of a template comes without it, as drawn.
        const Operation *by = a.document.find(p.made.operation);
        const bool isMade = !p.made.key.empty() && !(by && by->subject.isValid());
        if (isMade == q.made.key.empty())
            return say("made");
    }
    const Document &d = a.document, &e = b.document;
    if (d.loads.size() != e.loads.size())
        return "weights";
    for (std::size_t i = 0; i < d.loads.size(); ++i)
        if (a.indexOf(d.loads[i].section) != b.indexOf(e.loads[i].section) ||
            d.loads[i].mass != e.loads[i].mass || d.loads[i].name != e.loads[i].name ||
            d.loads[i].position != e.loads[i].position)
            return "weight";
    // Slices that are drawn sections say of their slits what followed before (tst_slice_sides).
    const bool hasSlices = std::any_of(d.operations.begin(), d.operations.end(),
                                       [](const auto &one) { return one->subject.isValid(); });
    if (!hasSlices && d.jointOverrides.size() != e.jointOverrides.size())
        return "joints";
    for (std::size_t i = 0; !hasSlices && i < d.jointOverrides.size(); ++i) {
        JointOverride same = *d.jointOverrides[i];
        const JointOverride &other = *e.jointOverrides[i];
        if (a.indexOf(same.a) != b.indexOf(other.a) || a.indexOf(same.b) != b.indexOf(other.b))
            return "joint";
        same.a = other.a;
        same.b = other.b;
        if (!(same == other))
            return "what is wanted of a joint";
    }
    std::vector<OperationPointer> were = d.operations;
    std::erase_if(were, [](const auto &one) { return one->subject.isValid(); });
    if (were.size() != e.operations.size())
        return "operations";
    for (std::size_t i = 0; i < were.size(); ++i)
        if (were[i]->kind != e.operations[i]->kind ||
            were[i]->exceptions.size() != e.operations[i]->exceptions.size() ||
            were[i]->name != e.operations[i]->name)
            return were[i]->name;
    return {};
}

/// Written and read as the clipboard does it.
Document throughText(const Document &document)
{
    return io::readFff(io::writeFff(document).value()).value().document;
}

Model pasted(const Document &copied, const Document &into)
{
    return evaluate(inserted(into, copied).document);
}

} // namespace

class TestExcerpt : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pastingWhatWasCopied_data();
    void pastingWhatWasCopied();
    void twiceIntoTheSame();
    void keysFollowTheirIds();
    void onlyPartOfAnOperation();
    void aSymmetryIsThatOfWhatCame();
    void stocksAreFoundAgain();
    void namesThatAreTaken();
    void whatIsGoneIsNotSpokenOf();
    void nothing();
};

void TestExcerpt::pastingWhatWasCopied_data()
{
    QTest::addColumn<QString>("path");
    int count = 0;
    for (const QString &folder : {QStringLiteral(FFF_SHARED_MODELS),
                                  QStringLiteral(FFF_TEST_DATA "/../../resources/samples")}) {
        const QDir dir(folder);
        for (const QString &name : dir.entryList({QStringLiteral("*.txt"), QStringLiteral("*.fff")},
                                                 QDir::Files, QDir::Name)) {
            QTest::newRow(qPrintable(name)) << dir.filePath(name);
            ++count;
        }
    }
    QVERIFY(count >= 17);
}

// Wrong: what is pasted would not be what was copied.
void TestExcerpt::pastingWhatWasCopied()
{
    QFETCH(QString, path);
    const auto loaded = io::readDocument(path);
    QVERIFY(loaded);
    const Model model = evaluate(loaded->document);
    const Document copied = throughText(excerpt(model, allOf(model)));
    QCOMPARE(difference(model, evaluate(copied)), std::string());
    QCOMPARE(difference(model, pasted(copied, newDocument())), std::string());
    // Beside others, far enough for none to be on another, it is the same, and they are as they
    // were.
    FishBones bones;
    bones.document = moveAll(bones.document, Vec3(5000, 0, 0));
    const Insertion beside = inserted(bones.document, copied);
    const Model both = evaluate(beside.document);
    QCOMPARE(both.sectionCount(), model.sectionCount() + bones.document.sections.size());
    QCOMPARE(beside.sections.size(), model.sectionCount());
    QCOMPARE(beside.document.sections[0], bones.document.sections[0]);
    QVERIFY(io::readFff(io::writeFff(beside.document).value())); // ids and references hold
}

// Wrong: the second copy would share ids with the first one.
void TestExcerpt::twiceIntoTheSame()
{
    FishBones bones;
    test::add(bones.document,
              operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    const Model model = evaluate(bones.document);
    const Document copied = excerpt(model, allOf(model));
    const Document once = inserted(model.document, copied).document;
    const Document twice = inserted(once, copied).document;
    const Model all = evaluate(throughText(twice));
    QCOMPARE(all.sectionCount(), 3 * model.sectionCount());
    QCOMPARE(twice.operations.size(), std::size_t(3));
}

// Wrong: exceptions and weights on copies of whole branches, whose keys have ids in them, would be
// of other sections.
void TestExcerpt::keysFollowTheirIds()
{
    FishBones bones;
    const SectionId fin = test::add(bones.document, "Fin", shapeOf(circle({0, 0}, 12.0)),
                                    {Vec3(60, 30, 0), Vec3::UnitX(), Vec3::UnitY()},
                                    Parent{bones.rib, {0, 30}, {0, 20}});
    const OperationId ribs = test::add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                                  {{"wholeBranch", true}, {"count", 4.0}}));
    Model model = evaluate(bones.document);
    const std::string suffix = std::to_string(fin.value);
    SectionRef hidden, weighed;
    for (const SectionPointer &made : model.resultOf(ribs)->sections)
        if (made->made.key.ends_with("/" + suffix)) {
            hidden = weighed;
            weighed = made->made;
        }
    QVERIFY(hidden.operation.isValid());
    Document document = setExceptionState(model.document, hidden, Exception::State::Hidden).value();
    Load weight;
    weight.section = weighed;
    weight.name = "Cup";
    document = addLoad(document, weight).value();
    test::add(document, "Hat", shapeOf(circle({0, 0}, 5.0)), frontFrame(),
              Parent{weighed, {0, 0}, {1, 1}});
    model = evaluate(document);
    const Document copied = throughText(excerpt(model, allOf(model)));
    QCOMPARE(difference(model, pasted(copied, newDocument())), std::string());
    Document busy = newDocument();
    for (int i = 0; i < 5; ++i) {
        test::add(busy, "Plate", shapeOf(circle({0, 0}, 5.0)), frontFrame());
        busy = removeSections(busy, std::vector{busy.sections.back()->id}).value();
    }
    const Model there = pasted(copied, busy);
    QCOMPARE(difference(model, there), std::string());
    const Section *host = there.find(there.document.loads.front().section);
    QVERIFY(host && host->name == model.nameOf(weighed));
}

// Wrong: two ribs out of eight would bring all eight.
void TestExcerpt::onlyPartOfAnOperation()
{
    FishBones bones;
    const OperationId ribs = test::add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    const Model model = evaluate(bones.document);
    const auto &made = model.resultOf(ribs)->sections;
    const std::vector<SectionRef> two{made[1]->made, made[3]->made};
    const Document copied = excerpt(model, two);
    QVERIFY(copied.operations.empty());
    QCOMPARE(copied.sections.size(), std::size_t(2));
    QCOMPARE(copied.sections[1]->frame, made[3]->frame);
    QCOMPARE(copied.sections[1]->name, made[3]->name);
    QVERIFY(!copied.sections[1]->parent); // which did not come along
    std::vector<SectionRef> withSpine = two;
    withSpine.push_back(bones.spine);
    const Document both = excerpt(model, withSpine);
    QCOMPARE(both.sections[1]->parent->section, SectionRef(bones.spine));
}

// Wrong: a mirrored chair that is pasted into a room would mirror the room.
void TestExcerpt::aSymmetryIsThatOfWhatCame()
{
    Document document = newDocument();
    test::add(document, "Plate", shapeOf(circle({0, 0}, 20.0)), sideFrame({60, 50, 0}));
    test::add(document, operation("mirror", {}, {{"plane", std::string("x")}}));
    const Model chair = evaluate(document);
    QCOMPARE(chair.sectionCount(), std::size_t(2));
    Document room = newDocument();
    test::add(room, "Wall", shapeOf(circle({0, 0}, 20.0)), sideFrame({300, 50, 0}));
    const Model both = pasted(excerpt(chair, allOf(chair)), room);
    QCOMPARE(both.sectionCount(), std::size_t(3));
    const Model inside = evaluate(inserted(room, selfContained(chair)).document);
    QCOMPARE(inside.sectionCount(), std::size_t(3));
    QCOMPARE(difference(chair, evaluate(selfContained(chair))), std::string());
}

// Wrong: every paste would add another "Birch plywood" to the list.
void TestExcerpt::stocksAreFoundAgain()
{
    const FishBones bones;
    const Model model = evaluate(bones.document);
    const Document copied = excerpt(model, {bones.rib});
    QCOMPARE(inserted(bones.document, copied).document.stocks.size(), std::size_t(1));
    Document thick = newDocument();
    Stock stock = *thick.stocks.front();
    stock.thickness = 12.0;
    thick = setStock(thick, stock).value();
    test::add(thick, "Block", shapeOf(circle({0, 0}, 20.0)), frontFrame());
    const Document both = inserted(thick, copied).document;
    QCOMPARE(both.stocks.size(), std::size_t(2));
    QCOMPARE(both.stockOf(*both.sections.back()).thickness, 3.0);
    QCOMPARE(both.find(both.currentStock)->thickness, 12.0);
    // An empty document takes the stock of what comes.
    const Document first =
        inserted(newDocument(), excerpt(evaluate(thick), {thick.sections[0]->id})).document;
    QCOMPARE(first.find(first.currentStock)->thickness, 12.0);
}

// Wrong: scripts and sentences could not tell the copy from what was copied.
void TestExcerpt::namesThatAreTaken()
{
    const FishBones bones;
    const Document copied = excerpt(evaluate(bones.document), {bones.spine, bones.rib});
    Document twice = inserted(bones.document, copied).document;
    QCOMPARE(twice.sections[2]->name, std::string("Spine 2"));
    twice = inserted(twice, copied).document;
    QCOMPARE(twice.sections[4]->name, std::string("Spine 3"));
    QCOMPARE(twice.sections[5]->name, std::string("Rib 3"));
}

// Wrong: a copied weight or joint would refer to a section that is not there.
void TestExcerpt::whatIsGoneIsNotSpokenOf()
{
    FishBones bones;
    Load weight;
    weight.section = bones.spine;
    bones.document = addLoad(bones.document, weight).value();
    JointOverride joint;
    joint.a = bones.spine;
    joint.b = bones.rib;
    joint.kind = JointKind::Mortise;
    bones.document = setJointOverride(bones.document, joint).value();
    const Model model = evaluate(bones.document);
    const Document rib = excerpt(model, {bones.rib});
    QVERIFY(rib.loads.empty() && rib.jointOverrides.empty());
    QVERIFY(!rib.sections.front()->parent);
    QVERIFY(io::readFff(io::writeFff(rib).value()));
    const Document both = excerpt(model, {bones.rib, bones.spine});
    QCOMPARE(both.loads.size(), std::size_t(1));
    QCOMPARE(both.jointOverrides.size(), std::size_t(1));
}

// Wrong: an empty selection would be no document.
void TestExcerpt::nothing()
{
    const FishBones bones;
    const Document none = excerpt(evaluate(bones.document), {});
    QVERIFY(none.sections.empty());
    QVERIFY(io::readFff(io::writeFff(none).value()));
    QCOMPARE(inserted(bones.document, none).document.sections, bones.document.sections);
}

FFF_TEST(TestExcerpt)
#include "tst_excerpt.moc"
