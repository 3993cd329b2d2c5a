#include <QTest>

#include "core/base/units.h"
#include "core/interaction/hover_words.h"
#include "core/interaction/interaction.h"
#include "core/interaction/problem_marks.h"
#include "core/interaction/view_cube.h"
#include "core/operations/evaluate.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

const Vec2 kViewport(1000, 700);

ProblemMark mark(int number, const Vec3 &at, std::vector<SectionRef> sections = {})
{
    return {number, at, std::move(sections)};
}

/// Remembers which problem was chosen; its model is one plate.
class Host : public InteractionHost
{
public:
    Host()
        : m_model(evaluate(
              withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 80)), front())))
    {
    }
    const Model &model() const override { return m_model; }
    void preview(Document) override { ++previews; }
    void cancelPreview() override {}
    void commit(const Step &, Document) override { ++commits; }
    void chooseProblem(int number, int place) override
    {
        chosen.push_back(number);
        places.push_back(place);
    }

    std::vector<int> chosen, places;
    int previews = 0, commits = 0;

private:
    Model m_model;
};

void send(Interaction &interaction, PointerEvent::Type type, const Vec2 &at,
          Button button = Button::None)
{
    PointerEvent event;
    event.type = type;
    event.position = at;
    event.button = button;
    event.time = 1000.0;
    interaction.handle(event);
}

} // namespace

class TestProblemMarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Twenty numbers on one spot: none can be read.
    void whatIsNearIsOneMark()
    {
        std::vector<ProblemMark> marks;
        for (int i = 1; i <= 20; ++i)
            marks.push_back(mark(i, {0.3 * i, 0, 0}));
        const std::vector<PlacedMark> placed = placeMarks(marks, Camera(), kViewport, {});
        std::size_t stoodFor = 0;
        for (const PlacedMark &one : placed)
            stoodFor += one.marks.size();
        QCOMPARE(stoodFor, marks.size()); // none is lost
        QVERIFY(placed.size() <= 2);      // they lie on 6 mm
        for (std::size_t i = 0; i < placed.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY((placed[i].centre - placed[k].centre).norm() >= 2.0 * kDotsRadius);
    }

    /// The number of a blocked joint lies on the arrows that say which way it is blocked.
    void aNumberKeepsOffItsArrows()
    {
        const std::vector<ProblemMark> marks{mark(1, Vec3::Zero())};
        const PlacedMark placed = placeMarks(marks, Camera(), kViewport, {}).front();
        // 19 px to either side, with bars of 14 px across, whichever way; lines are 3 px wide.
        for (int turn = 0; turn < 36; ++turn) {
            const Vec2 along = Eigen::Rotation2Dd(radians(10.0 * turn)) * Vec2::UnitX();
            for (const double side : {-7.0, 0.0, 7.0}) {
                const Vec2 ink = placed.anchor + 19.0 * along + side * Vec2(-along.y(), along.x());
                QVERIFY((placed.centre - ink).norm() > kMarkRadius + 1.5);
            }
        }
        QVERIFY((placed.centre - placed.anchor).norm() < 40.0); // and is beside its place still
    }

    /// A view full of numbers says less than one with a few.
    void aFewHaveNumbersTheRestAreDots()
    {
        std::vector<ProblemMark> marks;
        for (int i = 0; i < 12; ++i)
            marks.push_back(mark(i + 1, {-110.0 + 20.0 * i, 0, 0}));
        for (int i = 0; i < 4; ++i) { // warnings, of one row
            ProblemMark warning = mark(13, {-60.0 + 40.0 * i, 40, 0});
            warning.isError = false;
            warning.place = i;
            marks.push_back(warning);
        }
        const auto numbers = [&] {
            std::vector<int> of;
            for (const PlacedMark &one : placeMarks(marks, Camera(), kViewport, {}))
                if (!one.isDot)
                    of.push_back(one.number);
            return of;
        };
        QCOMPARE(placeMarks(marks, Camera(), kViewport, {}).size(), marks.size());
        QCOMPARE(numbers(), (std::vector{1, 2, 3, 4, 5})); // the worst, which come first
        marks[14].isChosen = true;
        QCOMPARE(numbers(), (std::vector{13, 1, 2, 3, 4})); // a warning, since it is looked at
        // A row has its number once.
        for (ProblemMark &one : marks)
            one.number = 7;
        QCOMPARE(numbers(), std::vector{7});
    }

    /// One that lies under others could never be chosen.
    void clicksStepThroughWhatIsOne()
    {
        std::vector<ProblemMark> marks;
        for (int i = 0; i < 3; ++i)
            marks.push_back(mark(i + 1, {0.5 * i, 0, 0}));
        std::vector<int> chosen;
        for (int click = 0; click < 4; ++click) {
            const std::vector<PlacedMark> placed = placeMarks(marks, Camera(), kViewport, {});
            QCOMPARE(placed.size(), std::size_t(1));
            const std::size_t next = chosenBy(placed.front(), marks);
            for (std::size_t i = 0; i < marks.size(); ++i)
                marks[i].isChosen = i == next;
            chosen.push_back(marks[next].number);
        }
        QCOMPARE(chosen, (std::vector{1, 2, 3, 1}));
    }

    void marksStayInTheView_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("the upper left corner") << 1.0 << 1.0;
        QTest::newRow("the lower edge") << 500.0 << 699.0;
        QTest::newRow("the right edge") << 999.0 << 400.0;
        QTest::newRow("behind the view cube") << 950.0 << 50.0;
    }

    /// Half a number at the edge, or one under the cube, can be neither read nor clicked.
    void marksStayInTheView()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        const Camera camera;
        const std::vector marks{mark(1, camera.pointAt({x, y}, kViewport))};
        const std::vector<PlacedMark> placed = placeMarks(marks, camera, kViewport, {});
        QCOMPARE(placed.size(), std::size_t(1));
        const Vec2 c = placed[0].centre;
        QVERIFY(c.x() >= kMarkRadius && c.x() <= kViewport.x() - kMarkRadius);
        QVERIFY(c.y() >= kMarkRadius && c.y() <= kViewport.y() - kMarkRadius);
        QVERIFY(!cubePartAt(c, camera.orientation, kViewport));
    }

    /// A number in the air would point at nothing.
    void whatIsNotSeenHasNoMark()
    {
        const SectionRef a(SectionId{1}), b(SectionId{2});
        const std::vector marks{mark(1, {0, 0, 0}, {a}), mark(2, {20, 0, 0}, {a, b}),
                                mark(3, {1e5, 0, 0}), mark(4, {-20, 0, 0})};
        ViewState view;
        view.hidden = {a};
        const std::vector<PlacedMark> placed = placeMarks(marks, Camera(), kViewport, view);
        QCOMPARE(placed.size(), std::size_t(2)); // not the hidden one, not the one far outside
        QCOMPARE(placed[0].number, 2);
        QCOMPARE(placed[1].number, 4);
    }

    /// What stands behind the eye would be seen mirrored before it.
    void behindTheEyeIsNothing()
    {
        Camera camera;
        camera.projection = Projection::Perspective;
        const Vec3 behind = camera.eye(kViewport) + 10.0 * camera.backward();
        QVERIFY(placeMarks(std::vector{mark(1, behind)}, camera, kViewport, {}).empty());
    }

    /// A click on a number would draw, select what is behind it, or do nothing.
    void aClickChoosesTheProblem()
    {
        Host host;
        Interaction interaction(host);
        interaction.setViewport(kViewport);
        interaction.setMarks({mark(3, {0, 40, 0})});
        const Vec2 at =
            placeMarks(interaction.marks(), interaction.camera(), kViewport, {})[0].centre;
        send(interaction, PointerEvent::Type::Move, at);
        QCOMPARE(interaction.hovered().problem, 3);
        QCOMPARE(interaction.hovered().section, -1);
        QCOMPARE(interaction.hint().words.text, hints::kChooseProblem);
        send(interaction, PointerEvent::Type::Press, at, Button::Left);
        send(interaction, PointerEvent::Type::Release, at, Button::Left);
        QCOMPARE(host.chosen, std::vector{3});
        QVERIFY(interaction.selection().empty());

        send(interaction, PointerEvent::Type::Move, at + Vec2(0, 60));
        QCOMPARE(interaction.hovered().problem, 0);
        QVERIFY(interaction.hovered().section >= 0);
    }

    /// Dots all over a section would let nobody draw on it.
    void aDragFromADotDraws()
    {
        Host host;
        Interaction interaction(host);
        interaction.setViewport(kViewport);
        ProblemMark warning = mark(1, {0, 40, 0});
        warning.isError = false;
        warning.place = 3;
        interaction.setMarks({warning});
        const std::vector<PlacedMark> placed =
            placeMarks(interaction.marks(), interaction.camera(), kViewport, {});
        QVERIFY(placed[0].isDot);
        const Vec2 at = placed[0].centre;
        send(interaction, PointerEvent::Type::Move, at);
        QCOMPARE(interaction.hovered().problem, 1);
        QCOMPARE(interaction.hovered().problemPlace, 3);
        send(interaction, PointerEvent::Type::Press, at, Button::Left);
        send(interaction, PointerEvent::Type::Release, at, Button::Left);
        QCOMPARE(host.chosen, std::vector{1});
        QCOMPARE(host.places, std::vector{3});
        QVERIFY(!interaction.isHandBusy());
        send(interaction, PointerEvent::Type::Press, at, Button::Left);
        send(interaction, PointerEvent::Type::Move, at + Vec2(30, 0));
        QVERIFY(interaction.overlay().find<sign::Slit>());
        QVERIFY(interaction.isHandBusy()); // so that it is not seen meanwhile
        interaction.escape(1000.0);
        QVERIFY(!interaction.isHandBusy());
    }

    /// A stroke that begins on a number would draw on what lies behind it.
    void aDragFromAMarkTurnsTheView()
    {
        Host host;
        Interaction interaction(host);
        interaction.setViewport(kViewport);
        interaction.setMarks({mark(1, {0, 40, 0})});
        const Camera before = interaction.camera();
        const Vec2 at = placeMarks(interaction.marks(), before, kViewport, {})[0].centre;
        send(interaction, PointerEvent::Type::Press, at, Button::Left);
        send(interaction, PointerEvent::Type::Move, at + Vec2(80, 0));
        send(interaction, PointerEvent::Type::Release, at + Vec2(80, 0), Button::Left);
        QVERIFY(host.chosen.empty());
        QCOMPARE(host.previews + host.commits, 0);
        QVERIFY(interaction.camera().orientation.angularDistance(before.orientation) > 0.1);
    }
};

FFF_TEST(TestProblemMarks)
#include "tests/told.h"
#include "tst_problem_marks.moc"
