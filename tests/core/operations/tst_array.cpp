#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/operations/baking.h"
#include "core/operations/moving_model.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// Fish bones, three times behind each other.
struct Shoal : FishBones
{
    OperationId array;
    Model model;

    explicit Shoal(std::map<std::string, ParameterValue> values = {})
    {
        array = test::add(document, operation("array", {{"sections", {spine, rib}}}, values));
        model = evaluate(document);
    }
};

} // namespace

class TestArray : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachAStepFurther();
    void whatIsOnACopyIsOnThat();
    void anEditOfACopyIsOneOfAll();
    void aStepOfNoLength();
    void bakedNothingChanges();
};

// Wrong: copies would stand elsewhere, or not share what is worked out of their shape.
void TestArray::eachAStepFurther()
{
    const Shoal shoal({{"count", 4.0}, {"x", 10.0}, {"y", -5.0}, {"z", 40.0}});
    QCOMPARE(shoal.model.sectionCount(), std::size_t(8));
    for (std::size_t i = 0; i < 6; ++i) {
        const Section &copy = *shoal.model.section(2 + i), &source = *shoal.model.section(i % 2);
        const double k = double(i / 2) + 1.0;
        QCOMPARE(copy.shape, source.shape);
        QVERIFY((copy.frame.origin - source.frame.origin - k * Vec3(10, -5, 40)).norm() < 1e-12);
    }
    QCOMPARE(shoal.model.section(2)->name, std::string("Spine 2"));
    QCOMPARE(shoal.model.section(7)->name, std::string("Rib 4"));
}

// Wrong: a copied rib would hang on the first spine.
void TestArray::whatIsOnACopyIsOnThat()
{
    const Shoal shoal;
    QCOMPARE(shoal.model.section(3)->parent->section, shoal.model.ref(2));
    QCOMPARE(shoal.model.section(3)->parent->slitTo, shoal.model.section(1)->parent->slitTo);
    // One that is copied alone stays on it, its slit goes along.
    FishBones bones;
    test::add(bones.document, operation("array", {{"sections", {bones.rib}}},
                                        {{"count", 2.0}, {"x", 30.0}, {"z", 0.0}}));
    const Model model = evaluate(bones.document);
    const Section &copy = *model.section(2);
    QCOMPARE(copy.parent->section, SectionRef(SectionId{2}));
    QVERIFY((copy.parent->slitTo - model.section(1)->parent->slitTo - Vec2(30, 0)).norm() < 1e-12);
}

// Wrong: moving one copy would be refused, or leave the others.
void TestArray::anEditOfACopyIsOneOfAll()
{
    const Shoal shoal;
    const RefMove move{shoal.model.ref(4), Similarity::moved(Vec3(0, 7, 0))};
    const Model after = evaluate(movedSections(shoal.model, {&move, 1}).value(), shoal.model);
    for (std::size_t i = 0; i < after.sectionCount(); i += 2)
        QVERIFY(
            (after.section(i)->frame.origin - shoal.model.section(i)->frame.origin - Vec3(0, 7, 0))
                .norm() < 1e-12);
}

// Wrong: all copies would lie in one place, unseen.
void TestArray::aStepOfNoLength()
{
    const Shoal shoal({{"z", 0.0}});
    QCOMPARE(shoal.model.sectionCount(), std::size_t(2));
    QCOMPARE(shoal.model.resultOf(shoal.array)->notices.front().kind,
             OperationNotice::Kind::NothingFits);
}

// Wrong: what is kept as drawn sections would not be what was seen.
void TestArray::bakedNothingChanges()
{
    const Shoal shoal;
    const Model after = evaluate(baked(shoal.model, shoal.array).value());
    QCOMPARE(after.sectionCount(), shoal.model.sectionCount());
    for (std::size_t i = 0; i < after.sectionCount(); ++i) {
        QCOMPARE(after.section(i)->frame, shoal.model.section(i)->frame);
        QCOMPARE(after.section(i)->name, shoal.model.section(i)->name);
    }
}

FFF_TEST(TestArray)
#include "tst_array.moc"
