#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/assembly.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// Two standing plates of 100 x 60 that cross in the middle.
Document cross()
{
    const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
    return withSection(withSection(newDocument(), plate, front()), plate, side());
}

JointOverride ofBoth(const Document &document)
{
    JointOverride wanted;
    wanted.a = document.sections[0]->id;
    wanted.b = document.sections[1]->id;
    if (wanted.b < wanted.a)
        std::swap(wanted.a, wanted.b);
    return wanted;
}

Document opening(Document document, const Vec2 &direction)
{
    JointOverride wanted = ofBoth(document);
    wanted.opens = direction;
    return *setJointOverride(std::move(document), wanted);
}

/// From the bottom to the mouth, up is positive. mm
double slitOf(const Assembly &assembly, std::size_t section)
{
    const Slit &slit = assembly.slits[section].front();
    return slit.mouth.y() - slit.inner.y();
}

bool isSame(const Assembly &a, const Assembly &b)
{
    if (a.joints.size() != b.joints.size() || a.slits.size() != b.slits.size())
        return false;
    for (std::size_t i = 0; i < a.joints.size(); ++i)
        if (a.joints[i].kind != b.joints[i].kind || a.joints[i].id != b.joints[i].id)
            return false;
    for (std::size_t i = 0; i < a.slits.size(); ++i)
        if (a.slits[i] != b.slits[i])
            return false;
    return true;
}

constexpr double kOvershoot = 0.05; // mm, of a mouth

} // namespace

class TestJointOverride : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aDirectionIsKept();
    void theOrderOfTheSectionsDoesNotMatter();
    void sharesAreTaken();
    void aKindIsTaken();
    void whatCannotBeHadIsDormant();
    void anEditWorksOutWhatEverythingDoes();
    void badOnesAreRefused();
    void theyGoWithTheirSections();
};

/// What would be wrong: a slit that a person turned turns back.
void TestJointOverride::aDirectionIsKept()
{
    const Document plain = cross();
    QVERIFY(slitOf(assemble(evaluate(plain)), 0) > 0.0);
    const Document turned = opening(plain, {0.0, -2.0});
    const Assembly assembly = assemble(evaluate(turned));
    QVERIFY(slitOf(assembly, 0) < 0.0);
    QVERIFY(slitOf(assembly, 1) > 0.0);
    // Moved, and turned with its section: the direction is the section's own.
    const Document moved = *moveSection(turned, turned.sections[0]->id, front(5));
    QVERIFY(slitOf(assemble(evaluate(moved)), 0) < 0.0);
    const Document headOver =
        *moveSection(turned, turned.sections[0]->id, {{0, 60, 0}, -Vec3::UnitX(), -Vec3::UnitY()});
    QVERIFY(slitOf(assemble(evaluate(headOver)), 0) < 0.0);
    QVERIFY(slitOf(assemble(evaluate(headOver)), 1) < 0.0);
    QVERIFY(isSame(assemble(evaluate(*setJointOverride(turned, ofBoth(turned)))),
                   assemble(evaluate(plain))));
}

/// What would be wrong: what is said of one section is done to the other.
void TestJointOverride::theOrderOfTheSectionsDoesNotMatter()
{
    Document document = opening(cross(), {0.0, -1.0});
    JointOverride wanted = ofBoth(document);
    wanted.opens = Vec2(0.0, -1.0);
    wanted.shares = {{{0.0, 30.0}, 0.25}};
    document = *setJointOverride(document, wanted);
    std::swap(document.sections[0], document.sections[1]);
    const Assembly assembly = assemble(evaluate(document));
    QVERIFY(std::abs(slitOf(assembly, 1) + 15.0 + kOvershoot) < 1e-9);
    QVERIFY(std::abs(slitOf(assembly, 0) - 45.0 - kOvershoot) < 1e-9);
}

/// What would be wrong: two slits that do not meet, or a share of the wrong one.
void TestJointOverride::sharesAreTaken()
{
    JointOverride wanted = ofBoth(cross());
    wanted.shares = {{{3.0, 20.0}, 0.3}};
    const Document document = *setJointOverride(cross(), wanted);
    const Assembly assembly = assemble(evaluate(document));
    QVERIFY(std::abs(slitOf(assembly, 0) - 18.0 - kOvershoot) < 1e-9);
    QVERIFY(std::abs(slitOf(assembly, 1) + 42.0 + kOvershoot) < 1e-9);
    const Joint &joint = assembly.joints.front();
    const Vec3 meet = joint.crossing->axis.at(joint.crossing->overlaps.front().meet);
    QVERIFY(std::abs(meet.y() - 42.0) < 1e-9);
}

void TestJointOverride::aKindIsTaken()
{
    JointOverride wanted = ofBoth(cross());
    wanted.kind = JointKind::None;
    const Assembly apart = assemble(evaluate(*setJointOverride(cross(), wanted)));
    QCOMPARE(apart.joints.front().kind, JointKind::None);
    QVERIFY(apart.slits[0].empty() && apart.slits[1].empty());

    // A tongue in the upper half of a wall: two slits by itself, a slot when that is wanted.
    const ShapePointer wall = polygonShape(rectangle(-50, 0, 50, 60));
    const ShapePointer tongue = polygonShape(rectangle(-10, 20, 10, 40));
    const Document document =
        withSection(withSection(newDocument(), wall, front()), tongue, side());
    wanted = ofBoth(document);
    wanted.kind = JointKind::Mortise;
    const Assembly mortise = assemble(evaluate(*setJointOverride(document, wanted)));
    QCOMPARE(mortise.joints.front().kind, JointKind::Mortise);
    QCOMPARE(mortise.slits[0].size(), 1U);
    QVERIFY(!mortise.slits[0].front().isOpen && mortise.slits[1].empty());
}

/// What would be wrong: a wish from before that breaks the model of now.
void TestJointOverride::whatCannotBeHadIsDormant()
{
    // A wall whose slit cannot open downwards, into its window.
    const ShapePointer wall = polygonShape(rectangle(-50, 0, 50, 60), {rectangle(-10, 10, 10, 30)});
    const ShapePointer plate = polygonShape(rectangle(-30, 20, 30, 80));
    const Document document = withSection(withSection(newDocument(), wall, front()), plate, side());
    QVERIFY(
        isSame(assemble(evaluate(opening(document, {0.0, -1.0}))), assemble(evaluate(document))));
    // No mortise where both reach beyond the other.
    JointOverride wanted = ofBoth(cross());
    wanted.kind = JointKind::Mortise;
    QVERIFY(isSame(assemble(evaluate(*setJointOverride(cross(), wanted))),
                   assemble(evaluate(cross()))));
    // A share of an overlap that is elsewhere by now.
    wanted = ofBoth(cross());
    wanted.shares = {{{0.0, 300.0}, 0.2}};
    QVERIFY(isSame(assemble(evaluate(*setJointOverride(cross(), wanted))),
                   assemble(evaluate(cross()))));
    // Sections that do not meet, until they do.
    const Document apart =
        opening(*moveSection(cross(), cross().sections[1]->id, side(200)), {0.0, -1.0});
    QVERIFY(assemble(evaluate(apart)).joints.empty());
    const Document again = *moveSection(apart, apart.sections[1]->id, side());
    QVERIFY(slitOf(assemble(evaluate(again)), 0) < 0.0);
}

/// What would be wrong: an override that shows only after the next edit.
void TestJointOverride::anEditWorksOutWhatEverythingDoes()
{
    const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
    Document document = cross();
    for (int i = 0; i < 12; ++i)
        document = withSection(std::move(document), plate, side(4.0 + 3.5 * i));
    const Model before = evaluate(document);
    const Assembly assembly = assemble(before);
    const Model turned = evaluate(opening(document, {0.0, -1.0}));
    const Assembly next = assemble(turned, before, assembly);
    QVERIFY(isSame(next, assemble(turned)));
    QVERIFY(!isSame(next, assembly));
    QVERIFY(isSame(assemble(before, turned, next), assembly));
}

void TestJointOverride::badOnesAreRefused()
{
    const Document document = cross();
    JointOverride wanted = ofBoth(document);
    wanted.shares = {{{0.0, 0.0}, 1.0}};
    QCOMPARE(setJointOverride(document, wanted).error().code, ErrorCode::BadValue);
    wanted.shares.clear();
    wanted.opens = Vec2::Zero();
    QCOMPARE(setJointOverride(document, wanted).error().code, ErrorCode::BadValue);
    wanted.opens = Vec2::UnitY();
    std::swap(wanted.a, wanted.b);
    QCOMPARE(setJointOverride(document, wanted).error().code, ErrorCode::BadValue);
    wanted.b = SectionId{999};
    QCOMPARE(setJointOverride(document, wanted).error().code, ErrorCode::UnknownReference);
    QVERIFY(setJointOverride(document, ofBoth(document))->isSame(document)); // nothing wanted
    const Document turned = opening(document, {0.0, -1.0});
    QVERIFY(opening(turned, {0.0, -1.0}).isSame(turned));
}

void TestJointOverride::theyGoWithTheirSections()
{
    const Document document = opening(cross(), {0.0, -1.0});
    const Document without = *removeSections(document, std::vector{document.sections[1]->id});
    QVERIFY(without.jointOverrides.empty());
}

FFF_TEST(TestJointOverride)
#include "tst_joint_override.moc"
