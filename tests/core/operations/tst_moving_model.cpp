#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/operations/moving_model.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

Similarity turned(double angle, const Vec3 &axis, const Vec3 &about)
{
    return Similarity::turned(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(),
                              about);
}

/// Fish bones with ribs all along, and a fin that is drawn across one of those.
struct FinnedBones : FishBones
{
    OperationId ribs;
    SectionRef third;
    SectionId fin;
    Model model;

    FinnedBones()
    {
        ribs = test::add(document, operation("linear", {{"section", {rib}}, {"along", {spine}}},
                                             {{"count", 5.0}}));
        model = evaluate(document);
        third = SectionRef(ribs, model.resultOf(ribs)->sections[2]->made.key);
        const Section &host = *model.find(third);
        const Frame frame{host.frame.toWorld({0, 40}), host.frame.y, host.frame.normal()};
        fin = test::add(document, "Fin", shapeOf(circle({0, 0}, 25.0)), frame,
                        Parent{third, {0, 40}, {0, 10}});
        model = evaluate(document);
    }
    /// Where the fin stands, seen from the section that it was drawn on.
    static Frame seenFrom(const Frame &host, const Frame &frame)
    {
        return {Vec3(host.x.dot(frame.origin - host.origin), host.y.dot(frame.origin - host.origin),
                     host.height(frame.origin)),
                Vec3(host.x.dot(frame.x), host.y.dot(frame.x), host.normal().dot(frame.x)),
                Vec3(host.x.dot(frame.y), host.y.dot(frame.y), host.normal().dot(frame.y))};
    }
};

bool isSame(const Frame &a, const Frame &b, double tolerance = 1e-9)
{
    return (a.origin - b.origin).norm() <= tolerance && (a.x - b.x).norm() <= tolerance &&
           (a.y - b.y).norm() <= tolerance;
}

} // namespace

class TestMovingModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsOnAReplicaGoesWithIt();
    void whatIsOnAReplicaStaysWhenAsked();
    void stretchingCarriesReplicasToo();
    void anImageTakesItsSourceAlong();
    void aSectionAndItsImageMoveOnce();
    void replicasAreNotMoved();
};

// Wrong: a fin on the third rib would stay in the air where the rib was.
void TestMovingModel::whatIsOnAReplicaGoesWithIt()
{
    const FinnedBones bones;
    const Similarity there =
        turned(0.7, {1, 2, 3}, {50, 60, 70}) * Similarity::moved(Vec3(10, 20, 30));
    const RefMove move{bones.spine, there};
    const Model after = evaluate(movedSections(bones.model, {&move, 1}).value(), bones.model);
    const Section &fin = *after.find(bones.fin);
    QVERIFY(isSame(fin.frame, placed(bones.model.find(bones.fin)->frame, there), 1e-6));
    QVERIFY(isSame(FinnedBones::seenFrom(after.find(bones.third)->frame, fin.frame),
                   FinnedBones::seenFrom(bones.model.find(bones.third)->frame,
                                         bones.model.find(bones.fin)->frame)));
    QCOMPARE(fin.parent, bones.model.find(bones.fin)->parent);
    // Of the rib that is repeated as well: all of them move with it.
    const RefMove along{bones.rib, Similarity::moved(Vec3(0, -3, 0))};
    const Model lower = evaluate(movedSections(bones.model, {&along, 1}).value(), bones.model);
    QVERIFY(
        isSame(FinnedBones::seenFrom(lower.find(bones.third)->frame, lower.find(bones.fin)->frame),
               FinnedBones::seenFrom(bones.model.find(bones.third)->frame,
                                     bones.model.find(bones.fin)->frame)));
}

// Wrong: "What is on it goes along" could not be switched off.
void TestMovingModel::whatIsOnAReplicaStaysWhenAsked()
{
    const FinnedBones bones;
    const RefMove move{bones.spine, Similarity::moved(Vec3(10, 20, 30))};
    const Document after = movedSections(bones.model, {&move, 1}, false).value();
    QVERIFY(isSame(after.find(bones.fin)->frame, bones.model.find(bones.fin)->frame));
    QVERIFY(isSame(after.find(bones.rib)->frame, bones.model.find(bones.rib)->frame));
}

// Wrong: the same when the spine is made longer.
void TestMovingModel::stretchingCarriesReplicasToo()
{
    const FinnedBones bones;
    Eigen::Matrix2d longer;
    longer << 1.5, 0.0, 0.0, 1.0;
    const Model after = evaluate(
        stretchedSection(bones.model, bones.spine, longer, Vec2::Zero()).value(), bones.model);
    QVERIFY(
        isSame(FinnedBones::seenFrom(after.find(bones.third)->frame, after.find(bones.fin)->frame),
               FinnedBones::seenFrom(bones.model.find(bones.third)->frame,
                                     bones.model.find(bones.fin)->frame)));
}

// Wrong: dragging the mirrored half would move the drawn one to the wrong side.
void TestMovingModel::anImageTakesItsSourceAlong()
{
    Document document = newDocument();
    const SectionId plate =
        test::add(document, "Plate", shapeOf(circle({0, 0}, 20.0)), sideFrame({60, 50, 0}));
    test::add(document, operation("mirror", {}, {{"plane", std::string("x")}}));
    const Model model = evaluate(document);
    QCOMPARE(model.sectionCount(), std::size_t(2));
    const SectionRef image = model.ref(1);
    const Similarity there =
        Similarity::moved(Vec3(-10, 5, 20)) * turned(0.5, {0, 1, 0}, {-60, 50, 0});
    const Frame wanted = placed(model.find(image)->frame, there);
    const RefMove move{image, there};
    const Model after = evaluate(movedSections(model, {&move, 1}).value(), model);
    QVERIFY((after.find(image)->frame.origin - wanted.origin).norm() <= 1e-9);
    QVERIFY((after.find(image)->frame.normal().cross(wanted.normal())).norm() <= 1e-9);
    QVERIFY((after.find(plate)->frame.origin - Vec3(70, 55, 20)).norm() <= 1e-9);
}

// Wrong: with both selected the pair would go twice as far.
void TestMovingModel::aSectionAndItsImageMoveOnce()
{
    Document document = newDocument();
    const SectionId plate =
        test::add(document, "Plate", shapeOf(circle({0, 0}, 20.0)), sideFrame({60, 50, 0}));
    test::add(document, operation("mirror", {}, {{"plane", std::string("x")}}));
    const Model model = evaluate(document);
    const Similarity up = Similarity::moved(Vec3(0, 10, 0));
    const RefMove moves[] = {{plate, up}, {model.ref(1), up}};
    const Document after = movedSections(model, moves).value();
    QVERIFY((after.find(plate)->frame.origin - Vec3(60, 60, 0)).norm() <= 1e-12);
}

// Wrong: a rib would be moved to where its operation takes it back from at once.
void TestMovingModel::replicasAreNotMoved()
{
    const FinnedBones bones;
    const RefMove move{bones.third, Similarity::moved(Vec3(0, 10, 0))};
    const Result<Document> after = movedSections(bones.model, {&move, 1});
    QCOMPARE(after.error().code, ErrorCode::UnknownReference);
    QVERIFY(!after.error().place.empty());
}

FFF_TEST(TestMovingModel)
#include "tst_moving_model.moc"
