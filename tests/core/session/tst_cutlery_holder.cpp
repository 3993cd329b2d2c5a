// A cutlery holder drawn from nothing with the mouse and a few keys, as in the paper's first
// figure: two human shapes through each other whose arms hold spoons. The script that is replayed,
// tests/data/replays/cutlery_holder.json, is what this hand draws; FFF_RECORD=1 writes it anew,
// with the model that it makes beside it.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/plan_checks.h"
#include "core/io/fff_format.h"
#include "core/session/replay.h"
#include "tests/core/interaction/recorder.h"
#include "tests/test_program.h"

#include <QFile>
#include <QUndoStack>

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

const QString kScript = QStringLiteral(FFF_TEST_DATA "/replays/cutlery_holder.json");
const QString kHolder = QStringLiteral(FFF_TEST_DATA "/replays/cutlery_holder.fff");

/// The right half of a person with spread arms, mm beside and above the ground, from the top of the
/// head down to between the feet. The hands turn up, so that what hangs there stays.
const std::vector<Vec2> kHalf{{8, 183},  {12, 172}, {10, 160},  {5, 152},   {14, 147},  {40, 146},
                              {70, 142}, {92, 146}, {100, 158}, {105, 152}, {102, 138}, {88, 130},
                              {60, 132}, {28, 132}, {18, 122},  {17, 104},  {22, 90},   {30, 50},
                              {38, 12},  {50, 4},   {50, -6},   {26, -6},   {24, 8},    {14, 52},
                              {5, 80},   {0, 82}};

} // namespace

class TestCutleryHolder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theScriptIsWhatTheHandDraws();
    void theScriptMakesAHolder();
};

/// Draws it; the screen is asked only where things are.
static void drawHolder(Recorder &hand)
{
    const Vec2 foot = hand.front(0, 0), up = hand.front(0, 1) - foot;
    const Vec2 right = hand.front(1, 0) - foot;
    const auto at = [&](const Vec2 &p) { return Vec2(foot + p.x() * right + p.y() * up); };
    // The front one: all round, from the top of the head.
    std::vector<Vec2> body;
    for (const Vec2 &p : kHalf)
        body.push_back(at(p));
    for (auto it = kHalf.rbegin(); it != kHalf.rend(); ++it)
        body.push_back(at({-it->x(), it->y()}));
    const Vec2 top = at({0, 186});
    hand.moveBy(top);
    hand.pressAt(top);
    hand.stroke(body, top);
    hand.moveBy(top);
    hand.releaseAt(top);
    hand.pause(200.0);
    // A second one across it: up through the head, then its right half, mirrored at the slit.
    const Vec2 inside = hand.front(0, 104), out = hand.front(0, 196);
    hand.moveBy(inside);
    hand.pressAt(inside);
    hand.stroke({inside + 0.5 * (out - inside), out}, inside);
    hand.pause(1500.0);
    const Vec2 tip = hand.cursor;
    // As the view looks at the new plane now.
    const Section &front = *hand.sections().front();
    const Vec3 head = front.frame.toWorld(front.shape->bounds().center());
    const auto beside = [&](const Vec2 &p) {
        const Camera &camera = hand.interaction.camera();
        const double sign = camera.right().z() >= 0.0 ? 1.0 : -1.0;
        return hand.screen({head.x(), p.y(), head.z() + sign * p.x()});
    };
    std::vector<Vec2> half;
    for (const Vec2 &p : kHalf)
        half.push_back(beside(p));
    hand.stroke(half, tip);
    hand.pause(50.0);
    hand.releaseAt(hand.cursor);
    hand.pause(1500.0);
}

// Wrong: the script and what it is of would have drifted apart.
void TestCutleryHolder::theScriptIsWhatTheHandDraws()
{
    Recorder hand;
    drawHolder(hand);
    if (qEnvironmentVariableIsSet("FFF_RECORD")) {
        QFile file(kScript);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(hand.script());
    }
    QCOMPARE(hand.sections().size(), std::size_t(2));
    QCOMPARE(hand.steps(), 2);
}

// Wrong: with the mouse alone one would not get what the paper shows.
void TestCutleryHolder::theScriptMakesAHolder()
{
    QFile file(kScript);
    QVERIFY(file.open(QIODevice::ReadOnly));
    Session session;
    SessionHost host(session);
    Interaction interaction(host);
    host.attach(interaction);
    QVERIFY(replay(file.readAll(), session, interaction));
    const Document &document = session.committed().document;
    QCOMPARE(document.sections.size(), std::size_t(2));
    AnalysisCaches caches;
    const Analysis analysis = analyse(session.committed(), caches);
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(1));
    // Both stand on the ground, both are symmetric, and their arms reach out.
    for (const SectionPointer &section : document.sections) {
        const Box3 box = worldBounds(*section->shape, section->frame);
        QVERIFY(std::abs(box.min.y()) < 0.01);
        QVERIFY(box.max.y() > 150.0);
        const Vec2 size = section->shape->bounds().size();
        QVERIFY(size.minCoeff() > 150.0);
    }
    const double right =
        std::abs(document.sections[0]->frame.normal().dot(document.sections[1]->frame.normal()));
    QVERIFY(right < 1e-9);
    // A file of it says the same.
    const Result<io::LoadedDocument> read = io::readFff(*io::writeFff(document));
    QVERIFY(read && read->document == document);
    if (qEnvironmentVariableIsSet("FFF_RECORD")) {
        QFile made(kHolder);
        QVERIFY(made.open(QIODevice::WriteOnly));
        made.write(QByteArray::fromStdString(*io::writeFff(document)));
    }
    // And it is the holder that is kept, of which cutlery_holder.png is a picture.
    QFile kept(kHolder);
    QVERIFY(kept.open(QIODevice::ReadOnly));
    const Result<io::LoadedDocument> holder = io::readFff(kept.readAll().toStdString());
    QVERIFY(holder);
    QCOMPARE(holder->document.sections.size(), document.sections.size());
    for (std::size_t i = 0; i < document.sections.size(); ++i) {
        const Section &drawn = *document.sections[i], &before = *holder->document.sections[i];
        QCOMPARE(drawn.shape->controlPointCount(), before.shape->controlPointCount());
        const auto &points = drawn.shape->contour().points();
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec3 is = drawn.frame.toWorld(points[k]);
            const Vec3 was = before.frame.toWorld(before.shape->contour().points()[k]);
            QVERIFY((is - was).norm() < 1e-6);
        }
    }
}

FFF_TEST(TestCutleryHolder)
#include "tst_cutlery_holder.moc"
