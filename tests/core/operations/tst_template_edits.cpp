// Templates in a document: added, changed, taken away, and what edits of the model do to them.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/blobs.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/operations/insertion.h"
#include "core/operations/scaled_model.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// A mesh by its bytes.
Document withMesh(Document document, const std::string &bytes, const std::string &name)
{
    const BlobPointer blob = io::makeBlob(bytes, "model/stl", name + ".stl");
    document = addBlob(std::move(document), blob);
    Template mesh;
    mesh.name = name;
    mesh.blob = blob->sha256;
    mesh.file = name + ".stl";
    mesh.frame.origin = {1, 20, 3};
    mesh.scale = 2.5;
    return addTemplate(std::move(document), mesh).value();
}

/// A picture by reference, on a section's plane or a standard one.
Document withPicture(Document document, const SectionRef &on)
{
    Template picture;
    picture.kind = TemplateKind::Picture;
    picture.name = "side view";
    picture.file = "/pictures/side view.jpg";
    picture.on = on;
    picture.frame = makeFrame({5, 7, 0}, {0.6, 0.8, 0}, {-0.8, 0.6, 0}).value();
    picture.scale = 0.25;
    picture.opacity = kPictureOpacity;
    return addTemplate(std::move(document), picture).value();
}

Template only(const Document &document, const std::string &name)
{
    for (const TemplatePointer &one : document.templates)
        if (one->name == name)
            return *one;
    qFatal("no template %s", name.c_str());
}

/// Where the file's point (10, 4, z) lies in the world.
Vec3 probe(const Document &document, const Template &one, double z)
{
    const Vec3 p = one.placement()({10, 4, z});
    if (one.on == SectionRef())
        return p;
    const Model model = evaluate(document);
    const Section *ground = model.find(one.on);
    return placementOf(ground->frame)(p);
}

} // namespace

class TestTemplateEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAndIdsAreTheirOwn();
    void bytesGoWithTheLast();
    void theirOrder();
    void whatIsRefused_data();
    void whatIsRefused();
    void aSectionThatGoesLeavesThemWhereTheyAre();
    void scalingTheModelScalesThem();
    void movingTheModelMovesThem();
    void bakingKeepsThem();
    void insertingBringsThem();
    void theyAreReadAgain();
    void filesThatAreWrong_data();
    void filesThatAreWrong();
};

void TestTemplateEdits::namesAndIdsAreTheirOwn()
{
    Document document = withMesh(newDocument(), "a", "Bunny");
    document = withMesh(document, "b", "Bunny");
    document = withMesh(document, "a", "Bunny");
    QCOMPARE(document.templates.size(), std::size_t(3));
    QCOMPARE(document.templates[1]->name, std::string("Bunny 2"));
    QCOMPARE(document.templates[2]->name, std::string("Bunny 3"));
    QVERIFY(document.templates[0]->id < document.templates[1]->id);
    QVERIFY(document.templates[2]->id.value < document.nextId);
    QCOMPARE(document.blobs.size(), std::size_t(2));
}

void TestTemplateEdits::bytesGoWithTheLast()
{
    Document document = withMesh(withMesh(newDocument(), "a", "A"), "a", "B");
    document = removeTemplate(document, document.templates[0]->id).value();
    QCOMPARE(document.blobs.size(), std::size_t(1));
    document = removeTemplate(document, document.templates[0]->id).value();
    QVERIFY(document.blobs.empty());
    QVERIFY(!removeTemplate(document, TemplateId{1}));
}

void TestTemplateEdits::theirOrder()
{
    Document document = newDocument();
    for (const char *name : {"A", "B", "C"})
        document = withMesh(document, name, name);
    const auto order = [&document] {
        std::string all;
        for (const TemplatePointer &one : document.templates)
            all += one->name;
        return all;
    };
    document = moveTemplate(document, only(document, "A").id, 3).value();
    QCOMPARE(order(), std::string("BCA"));
    document = moveTemplate(document, only(document, "A").id, 1).value();
    QCOMPARE(order(), std::string("BAC"));
    document = moveTemplate(document, only(document, "A").id, 1).value();
    QCOMPARE(order(), std::string("BAC"));
    document = moveTemplate(document, only(document, "B").id, 2).value();
    QCOMPARE(order(), std::string("ABC"));
    document = moveTemplate(document, only(document, "C").id, 0).value();
    QCOMPARE(order(), std::string("CAB"));
}

void TestTemplateEdits::whatIsRefused_data()
{
    QTest::addColumn<Template>("changed");
    QTest::addColumn<QString>("place");
    const FishBones bones;
    const Template sound = only(withMesh(bones.document, "a", "A"), "A");
    const auto row = [&sound](const char *name, const char *place, auto change) {
        Template next = sound;
        change(next);
        QTest::newRow(name) << next << QString::fromLatin1(place);
    };
    row("no bytes of it", "blob", [](Template &t) { t.blob = std::string(64, 'f'); });
    row("neither bytes nor a file", "file", [](Template &t) { t.blob = t.file = {}; });
    row("no size", "scale", [](Template &t) { t.scale = 0.0; });
    row("a size that is none", "scale", [](Template &t) { t.scale = std::nan(""); });
    row("brighter than opaque", "opacity", [](Template &t) { t.opacity = 1.01; });
    row("a skew frame", "frame", [](Template &t) { t.frame.y = {0.1, 1, 0}; });
    row("out of this world", "frame", [](Template &t) { t.frame.origin.x() = 1e7; });
    row("a mesh on a section", "on", [&bones](Template &t) { t.on = bones.rib; });
    row("a picture on none that is there", "999", [](Template &t) {
        t.kind = TemplateKind::Picture;
        t.on = SectionId{999};
    });
    row("pulled by none that is there", "999", [](Template &t) {
        t.magnets = {{SectionId{999}, 5.0}};
    });
    row("pulled from no distance", "radius", [&bones](Template &t) {
        t.magnets = {{bones.rib, 0.0}};
    });
    row("a picture that is pulled", "magnets", [&bones](Template &t) {
        t.kind = TemplateKind::Picture;
        t.magnets = {{bones.rib, 5.0}};
    });
}

void TestTemplateEdits::whatIsRefused()
{
    QFETCH(Template, changed);
    QFETCH(QString, place);
    const FishBones bones;
    const Document document = withMesh(bones.document, "a", "A");
    const auto next = setTemplate(document, changed);
    QVERIFY(!next);
    QCOMPARE(QString::fromStdString(next.error().place), place);
}

// Wrong: what was drawn after would be gone with a section that was drawn on it.
void TestTemplateEdits::aSectionThatGoesLeavesThemWhereTheyAre()
{
    FishBones bones;
    Document document = withMesh(withPicture(bones.document, bones.rib), "a", "A");
    Template mesh = only(document, "A");
    mesh.magnets = {{bones.rib, 5.0}, {bones.spine, 6.0}};
    document = setTemplate(document, mesh).value();
    QCOMPARE(only(document, "A").magnets.front().section,
             std::min<SectionRef>(bones.rib, bones.spine));
    const Vec3 before = probe(document, only(document, "side view"), 0.0);
    const Document after = removeSections(document, std::vector{bones.rib}).value();
    QCOMPARE(only(after, "side view").on, SectionRef());
    QVERIFY((probe(after, only(after, "side view"), 0.0) - before).norm() < 1e-9);
    QCOMPARE(only(after, "A").magnets.size(), std::size_t(1));
    QCOMPARE(only(after, "A").magnets[0].section, SectionRef(bones.spine));
}

void TestTemplateEdits::scalingTheModelScalesThem()
{
    FishBones bones;
    Document document = withMesh(withPicture(bones.document, bones.rib), "a", "A");
    Template mesh = only(document, "A");
    mesh.magnets = {{bones.rib, 5.0}};
    document = setTemplate(document, mesh).value();
    const Document larger = scaledModel(document, 1.5).value();
    for (const char *name : {"A", "side view"}) {
        const Vec3 before = probe(document, only(document, name), 0.0);
        const Vec3 after = probe(larger, only(larger, name), 0.0);
        QVERIFY2((after - 1.5 * before).norm() < 1e-9, name);
    }
    QCOMPARE(only(larger, "A").magnets[0].radius, 7.5);
}

void TestTemplateEdits::movingTheModelMovesThem()
{
    const FishBones bones;
    const Document document = withMesh(withPicture(bones.document, bones.rib), "a", "A");
    const Document moved = moveAll(document, {1, 2, 3});
    for (const char *name : {"A", "side view"}) {
        const Vec3 before = probe(document, only(document, name), 2.0);
        const Vec3 after = probe(moved, only(moved, name), 2.0);
        QVERIFY2((after - before - Vec3(1, 2, 3)).norm() < 1e-9, name);
    }
}

// Wrong: a picture on a rib of a row would be nowhere once the row has been baked.
void TestTemplateEdits::bakingKeepsThem()
{
    FishBones bones;
    const OperationId row = add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    Document document = withMesh(withPicture(bones.document, {row, "3"}), "a", "A");
    Template mesh = only(document, "A");
    mesh.magnets = {{{row, "3"}, 4.0}};
    document = setTemplate(document, mesh).value();
    const Vec3 before = probe(document, only(document, "side view"), 0.0);
    const Document after = baked(evaluate(document), row).value();
    QVERIFY(only(after, "side view").on.drawn.isValid());
    QCOMPARE(only(after, "A").magnets[0].section, only(after, "side view").on);
    QVERIFY((probe(after, only(after, "side view"), 0.0) - before).norm() < 1e-9);
}

void TestTemplateEdits::insertingBringsThem()
{
    FishBones bones;
    Document other = withMesh(withPicture(bones.document, bones.rib), "a", "A");
    Template mesh = only(other, "A");
    mesh.magnets = {{bones.spine, 4.0}};
    other = setTemplate(other, mesh).value();
    const Document twice = inserted(inserted(newDocument(), other).document, other).document;
    QCOMPARE(twice.templates.size(), std::size_t(4));
    QCOMPARE(twice.blobs.size(), std::size_t(1));
    for (const char *name : {"A", "A 2", "side view", "side view 2"}) {
        const std::string of(name, std::string(name).find(" 2") == std::string::npos
                                       ? std::string(name).size()
                                       : std::string(name).size() - 2);
        const Vec3 before = probe(other, only(other, of), 0.0);
        QVERIFY2((probe(twice, only(twice, name), 0.0) - before).norm() < 1e-9, name);
    }
    const SectionRef spine = only(twice, "A 2").magnets[0].section;
    QVERIFY(twice.find(spine.drawn));
    QVERIFY(spine != only(twice, "A").magnets[0].section);
}

void TestTemplateEdits::theyAreReadAgain()
{
    FishBones bones;
    const OperationId row = add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    Document document = withMesh(withPicture(bones.document, {row, "3"}), "bytes", "A");
    Template mesh = only(document, "A");
    mesh.magnets = {{bones.rib, 0.1 + 0.2}, {{row, "9"}, 4.0}};
    mesh.isFlipped = mesh.isHidden = mesh.isLocked = true;
    mesh.opacity = 1.0 / 3.0;
    document = setTemplate(document, mesh).value();
    const std::string text = io::writeFff(document).value();
    const auto bytes = std::make_shared<const std::string>("bytes");
    const auto again = io::readFff(
        text, {}, [&bytes](const std::string &) -> Result<io::BlobBytes> { return bytes; });
    QVERIFY2(again, qPrintable(again ? QString() : io::errorText(again.error())));
    QVERIFY(again->document == document);
    QCOMPARE(io::writeFff(again->document).value(), text);
    // Without its bytes it keeps its place, and all edits but one that asks for them.
    const auto without = io::readFff(text);
    QVERIFY(without);
    QCOMPARE(without->warnings.size(), std::size_t(1));
    QVERIFY(only(without->document, "A") == mesh);
    mesh.name = "found again";
    QVERIFY(setTemplate(without->document, mesh));
}

void TestTemplateEdits::filesThatAreWrong_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("place");
    const auto row = [](const char *from, const char *to, const char *place) {
        QTest::newRow(to) << QString::fromLatin1(from) << QString::fromLatin1(to)
                          << QStringLiteral("$.templates[0].") + QLatin1String(place);
    };
    row("\"picture\"", "\"film\"", "kind");
    row("\"picture\"", "\"mesh\"", "on");
    row("\"scale\": 0.25", "\"scale\": 0", "scale");
    row("\"scale\": 0.25", "\"scale\": -3", "scale");
    row("\"opacity\": 0.6", "\"opacity\": 6", "opacity");
    row("\"opacity\": 0.6", "\"opacity\": 0.6, \"hidden\": 1", "hidden");
    row("\"file\"", "\"blob\"", "blob");
    row("\"opacity\": 0.6", "\"opacity\": 0.6, \"magnets\": []", "magnets");
}

void TestTemplateEdits::filesThatAreWrong()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, place);
    FishBones bones;
    QString text =
        QString::fromStdString(io::writeFff(withPicture(bones.document, bones.rib)).value());
    QVERIFY(text.contains(from));
    const auto read = io::readFff(text.replace(from, to).toStdString());
    QVERIFY(!read);
    QCOMPARE(QString::fromStdString(read.error().place), place);
}

FFF_TEST(TestTemplateEdits)
#include "tst_template_edits.moc"
