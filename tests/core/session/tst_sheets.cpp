// How parts lie on their sheets, as a stage: laws of it, what stays, and who asks for it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/analysed.h"
#include "core/analysis/asked_skin.h"
#include "core/analysis/nested.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/nesting/proof.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "core/session/sheet_nesting.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <stop_token>
#include <thread>

using namespace fff;
using namespace fff::test;

namespace {

AnalysisPointer analysisOf(const Document &document)
{
    return std::make_shared<const Analysis>(analysed(document));
}

Nested askedOf(const AnalysisPointer &analysis, const SheetsQuestion &question,
               const Nested *previous = nullptr, std::stop_token stop = {})
{
    const Snapshot snapshot(
        1, {{kAnalysed.name, std::make_shared<const Analysed>(Analysed{analysis, nullptr})},
            {kSheetsAsked.name, std::make_shared<const SheetsQuestion>(question)}});
    Progress progress;
    return *nested(snapshot, previous, progress, std::move(stop));
}

struct Lying
{
    int sheet = 0;
    Vec2 turn = Vec2::UnitX(), offset = Vec2::Zero();
    bool operator==(const Lying &) const = default;
};

/// By part.
std::map<int, Lying> lyingOn(const Nested &nested)
{
    std::map<int, Lying> all;
    for (std::size_t i = 0; i < nested.layout->sheets.size(); ++i)
        for (const Placement &one : nested.layout->sheets[i].placements)
            all[one.part] = {static_cast<int>(i), one.turn, one.offset};
    return all;
}

/// Of parts of one stock, none too large, by other means than it was found by.
bool isSound(const Nested &nested)
{
    const LayoutOptions &options = nested.question->nesting.layout;
    nest::Problem problem;
    problem.margin = options.margin;
    problem.spacing = options.spacing;
    const Vec2 size = nested.layout->sheets.front().size;
    problem.sheets = {{{{Vec2::Zero(), {size.x(), 0.0}, size, {0.0, size.y()}}, {}},
                       nest::SheetKind::kUnlimited}};
    nest::Solution solution;
    solution.sheets.assign(nested.layout->sheets.size(), 0);
    for (const auto &[part, lying] : lyingOn(nested)) {
        nest::Piece piece;
        piece.outline = nested.parts->parts[static_cast<std::size_t>(part)].outline.region;
        piece.turnsFreely = true;
        problem.pieces.push_back(piece);
        solution.places.push_back({part, lying.sheet, lying.turn, lying.offset});
    }
    return problem.pieces.size() == nested.parts->parts.size() && !nest::faultOf(problem, solution);
}

PinnedPlace pinnedAt(const Nested &nested, int part, int sheet, const Vec2 &offset,
                     const Vec2 &turn = Vec2::UnitX())
{
    const int section = nested.parts->parts[static_cast<std::size_t>(part)].section;
    return {nested.analysis->model.ref(static_cast<std::size_t>(section)), 0, sheet, turn, offset};
}

/// A place on the first sheet where nothing lies.
PinnedPlace freePlace(const Nested &nested, int part)
{
    const Vec2 size = nested.layout->sheets.front().size;
    return pinnedAt(nested, part, 0, size - Vec2(40.0, 60.0));
}

/// A comb of which one rib is higher.
Document withHighRib(Document document)
{
    const SectionId rib = document.sections[3]->id;
    return *setShape(std::move(document), rib, polygonShape(rectangle(-20, 10, 20, 70)));
}

} // namespace

class TestSheets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameSeedGivesTheSame();
    void nobodyAsksAndNothingIsThere();
    void pinnedPartsStay();
    void pinsThatCannotStay_data();
    void pinsThatCannotStay();
    void pinningMovesNoOther();
    void unpinnedPartsGoBack();
    void searchesLeavePinnedParts();
    void sectionsTurnAsTheyMay();
    void anEditLeavesTheRest();
    void aGoneSectionLeavesTheRest();
    void manyChangesLayAllAnew();
    void anotherKerfLosesNothing();
    void aNewOffcutIsLaidOn();
    void otherSheetsAreLaidAnew();
    void askedAnewForgetsWhatLay();
    void stoppedKeepsTheBest();
    void holesAreRoomWhereTheyMay();
    void isWorkedOutWhereItIsWanted();
    void anEditMakesItOlder();
    void stopEndsASearch();
    void anotherDocumentIsAskedAgain();
    void otherQuestionsGoOn();
};

void TestSheets::theSameSeedGivesTheSame()
{
    const AnalysisPointer analysis = analysisOf(combModel(12));
    const Nested one = askedOf(analysis, {}), other = askedOf(analysis, {});
    QVERIFY(lyingOn(one) == lyingOn(other));
    QCOMPARE(lyingOn(one).size(), std::size_t(13));
    QVERIFY(isSound(one));
    QVERIFY(one.filled > 0.3 && one.filled <= 1.0);
    QVERIFY(one.cutLength > 13 * 80.0);
    QCOMPARE(one.cutting->sheetCount(), static_cast<int>(one.layout->sheets.size()));
}

void TestSheets::nobodyAsksAndNothingIsThere()
{
    const Snapshot snapshot(1, {{kAnalysed.name, std::make_shared<const Analysed>(
                                                     Analysed{analysisOf(combModel(2)), nullptr})},
                                {kSheetsAsked.name, nullptr}});
    Progress progress;
    QVERIFY(!nested(snapshot, nullptr, progress, {})->layout);
    const Nested empty = askedOf(analysisOf(newDocument()), {});
    QVERIFY(empty.why);
    QCOMPARE(empty.why->code, ErrorCode::NothingToExport);
    QVERIFY(!empty.cutting);
}

// To the last bit, at any angle, also on a later sheet; and the others keep off them.
void TestSheets::pinnedPartsStay()
{
    Document document = combModel(12);
    const Nested free = askedOf(analysisOf(document), {});
    const double angle = radians(31.0);
    document.pins = {pinnedAt(free, 3, 0, {300.125, 200.0}, {std::cos(angle), std::sin(angle)}),
                     pinnedAt(free, 5, 1, {100.0, 100.0})};
    const AnalysisPointer analysis = analysisOf(document);
    for (const Nested *previous : {static_cast<const Nested *>(nullptr), &free}) {
        const Nested pinned = askedOf(analysis, {}, previous);
        const auto lying = lyingOn(pinned);
        QVERIFY(pinned.loosened.empty());
        QVERIFY((lying.at(3) == Lying{0, document.pins[0].turn, {300.125, 200.0}}));
        QVERIFY((lying.at(5) == Lying{1, Vec2::UnitX(), {100.0, 100.0}}));
        QCOMPARE(lying.size(), free.parts->parts.size());
        QVERIFY(isSound(pinned));
    }
}

void TestSheets::pinsThatCannotStay_data()
{
    QTest::addColumn<int>("sheet");
    QTest::addColumn<Vec2>("turn");
    QTest::addColumn<Vec2>("offset");
    QTest::newRow("on another one") << 0 << Vec2(1, 0) << Vec2(101, 101);
    QTest::newRow("nearer than the spacing") << 0 << Vec2(1, 0) << Vec2(141.5, 100);
    QTest::newRow("in the margin") << 0 << Vec2(1, 0) << Vec2(24.5, 200);
    QTest::newRow("off the sheet") << 0 << Vec2(1, 0) << Vec2(1000, 200);
    QTest::newRow("far off") << 0 << Vec2(1, 0) << Vec2(1e300, 200);
    QTest::newRow("nowhere") << 0 << Vec2(1, 0) << Vec2(std::nan(""), 200);
    QTest::newRow("before the first sheet") << -1 << Vec2(1, 0) << Vec2(300, 200);
    QTest::newRow("on a sheet that nobody needs") << 1000000 << Vec2(1, 0) << Vec2(300, 200);
    QTest::newRow("larger than it is") << 0 << Vec2(2, 0) << Vec2(300, 200);
    QTest::newRow("without a turn") << 0 << Vec2(0, 0) << Vec2(300, 200);
}

// It is laid with the rest and told; who was pinned before it stays.
void TestSheets::pinsThatCannotStay()
{
    QFETCH(int, sheet);
    QFETCH(Vec2, turn);
    QFETCH(Vec2, offset);
    Document document = combModel(6);
    const Nested free = askedOf(analysisOf(document), {});
    document.pins = {pinnedAt(free, 2, 0, {100, 100}), pinnedAt(free, 4, sheet, offset, turn)};
    const Nested pinned = askedOf(analysisOf(document), {});
    QCOMPARE(pinned.loosened, std::vector<int>{4});
    QVERIFY((lyingOn(pinned).at(2) == Lying{0, Vec2::UnitX(), {100, 100}}));
    QVERIFY(isSound(pinned));
}

// Wrong: who drags one part sees all the others jump.
void TestSheets::pinningMovesNoOther()
{
    Document document = combModel(12);
    const Nested before = askedOf(analysisOf(document), {});
    document.pins = {freePlace(before, 4)};
    const Nested pinned = askedOf(analysisOf(document), {}, &before);
    auto was = lyingOn(before), is = lyingOn(pinned);
    QCOMPARE(is.at(4).offset, document.pins[0].offset);
    was.erase(4);
    is.erase(4);
    QVERIFY(was == is);
    QVERIFY(pinned.loosened.empty());
    QVERIFY(isSound(pinned));
}

// So that undo brings a part back, after however many moves.
void TestSheets::unpinnedPartsGoBack()
{
    Document document = combModel(12);
    const Nested before = askedOf(analysisOf(document), {});
    document.pins = {freePlace(before, 4)};
    const Nested pinned = askedOf(analysisOf(document), {}, &before);
    document.pins[0].offset -= Vec2(3.0, 2.0);
    const Nested moved = askedOf(analysisOf(document), {}, &pinned);
    QCOMPARE(lyingOn(moved).at(4).offset, document.pins[0].offset);
    document.pins.clear();
    const Nested back = askedOf(analysisOf(document), {}, &moved);
    QVERIFY(lyingOn(back) == lyingOn(before));
    QVERIFY(back.layBefore.empty());
}

void TestSheets::searchesLeavePinnedParts()
{
    Document document = combModel(12);
    const Nested before = askedOf(analysisOf(document), {});
    document.pins = {freePlace(before, 4)};
    const AnalysisPointer analysis = analysisOf(document);
    const Nested quick = askedOf(analysis, {}, &before);
    SheetsQuestion anew;
    anew.times = 1;
    const Nested again = askedOf(analysis, anew, &quick);
    QCOMPARE(lyingOn(again).at(4).offset, document.pins[0].offset);
    QVERIFY(isSound(again));
}

// Also where they lie already, and in another way than all others.
void TestSheets::sectionsTurnAsTheyMay()
{
    Document document = combModel(12);
    SheetsQuestion question;
    question.nesting.turning = nest::Turning::Free;
    const Nested before = askedOf(analysisOf(document), question);
    for (const SectionPointer &section : document.sections)
        document.turnings.push_back({section->ref(), nest::Turning::None});
    for (const Nested *previous : {static_cast<const Nested *>(nullptr), &before}) {
        const Nested locked = askedOf(analysisOf(document), question, previous);
        for (const auto &[part, lying] : lyingOn(locked))
            QCOMPARE(lying.turn, Vec2(Vec2::UnitX()));
        QVERIFY(isSound(locked));
    }
}

void TestSheets::anEditLeavesTheRest()
{
    const Document document = combModel(25);
    const Nested before = askedOf(analysisOf(document), {});
    const Nested after = askedOf(analysisOf(withHighRib(document)), {}, &before);
    auto was = lyingOn(before), is = lyingOn(after);
    QCOMPARE(was.size(), is.size());
    was.erase(3);
    is.erase(3);
    QVERIFY(was == is);
    QVERIFY(isSound(after));
    QVERIFY(after.loosened.empty());
    QVERIFY(after.layout->sheets.size() <= before.layout->sheets.size());
}

void TestSheets::aGoneSectionLeavesTheRest()
{
    const Document document = combModel(25);
    const Nested before = askedOf(analysisOf(document), {});
    const SectionId last[] = {document.sections.back()->id};
    const Nested after = askedOf(analysisOf(*removeSections(document, last)), {}, &before);
    auto was = lyingOn(before);
    was.erase(25);
    was.erase(0); // has one slit less
    auto is = lyingOn(after);
    is.erase(0);
    QVERIFY(was == is);
    QVERIFY(isSound(after));
}

void TestSheets::manyChangesLayAllAnew()
{
    const Nested before = askedOf(analysisOf(combModel(8)), {});
    const AnalysisPointer analysis = analysisOf(eggCrate(4, 4));
    QVERIFY(lyingOn(askedOf(analysis, {}, &before)) == lyingOn(askedOf(analysis, {})));
}

// Wrong: all parts are a little larger, and the layout that a search has found is lost.
void TestSheets::anotherKerfLosesNothing()
{
    Document document = combModel(8);
    Nested before = askedOf(analysisOf(document), {});
    QCOMPARE(before.layout->sheets.size(), std::size_t(1));
    // As no quick layout has it, which takes no less of the sheet.
    const Vec2 by(70.0, 0.0);
    Layout shifted = *before.layout;
    for (Placement &one : shifted.sheets.front().placements)
        one.offset += by;
    before.layout = std::make_shared<const Layout>(shifted);
    QVERIFY(isSound(before));
    Stock stock = *document.find(document.currentStock);
    stock.kerf += 0.1;
    stock.clearance += 0.05;
    document = *setStock(std::move(document), stock);
    const Nested after = askedOf(analysisOf(document), {}, &before);
    QVERIFY(isSound(after));
    QCOMPARE(after.layout->sheets.size(), std::size_t(1));
    const Nested anew = askedOf(analysisOf(document), {});
    const LayoutOptions layout;
    QVERIFY(!(takenArea(*anew.layout, anew.parts->parts, layout) <
              takenArea(*after.layout, after.parts->parts, layout)));
}

// Wrong: what lay on whole sheets stays there, and the offcut is not used up.
void TestSheets::aNewOffcutIsLaidOn()
{
    Document document = combModel(8);
    const Nested before = askedOf(analysisOf(document), {});
    Stock stock = *document.find(document.currentStock);
    stock.spares = {*rectangularSheet({260.0, 150.0})};
    document = *setStock(std::move(document), stock);
    const Nested after = askedOf(analysisOf(document), {}, &before);
    QCOMPARE(after.layout->sheets.front().index, -1);
}

// Wrong: parts stay on as many sheets when these are larger now.
void TestSheets::otherSheetsAreLaidAnew()
{
    Document document = eggCrate(6, 6);
    Stock stock = *document.find(document.currentStock);
    stock.sheet = {160, 160};
    document = *setStock(std::move(document), stock);
    const Nested before = askedOf(analysisOf(document), {});
    stock.sheet = {600, 400};
    const Nested after = askedOf(analysisOf(*setStock(document, stock)), {}, &before);
    QVERIFY(before.layout->sheets.size() > 1);
    QCOMPARE(after.layout->sheets.size(), std::size_t(1));
    QVERIFY(isSound(after));
}

void TestSheets::askedAnewForgetsWhatLay()
{
    const Document document = combModel(25);
    const Nested before = askedOf(analysisOf(document), {});
    const AnalysisPointer edited = analysisOf(withHighRib(document));
    SheetsQuestion anew;
    anew.times = 1;
    QVERIFY(lyingOn(askedOf(edited, anew, &before)) == lyingOn(askedOf(edited, {})));
}

// Of a search that is stopped before it begins, what lay before is the best; and what is found is
// never worse.
void TestSheets::stoppedKeepsTheBest()
{
    const AnalysisPointer analysis = analysisOf(eggCrate(6, 6));
    const Nested quick = askedOf(analysis, {});
    SheetsQuestion best;
    best.level = NestLevel::Best;
    std::stop_source source;
    source.request_stop();
    const Nested stopped = askedOf(analysis, best, &quick, source.get_token());
    QVERIFY(stopped.isStopped);
    QVERIFY(lyingOn(stopped) == lyingOn(quick));
    std::stop_source later;
    std::jthread stopper([&later] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        later.request_stop();
    });
    const Nested found = askedOf(analysis, best, &quick, later.get_token());
    QVERIFY(found.filled >= quick.filled);
    QVERIFY(isSound(found));
}

void TestSheets::holesAreRoomWhereTheyMay()
{
    const ShapePointer frame = *Shape::make(polygonContour(rectangleAt(0, 0, 190, 190)),
                                            {polygonContour(rectangleAt(20, 20, 150, 150))});
    Document document = withSection(newDocument(), frame, front());
    document =
        withSection(std::move(document), polygonShape(rectangle(0, 0, 100, 100)), front(500));
    Stock stock = *document.find(document.currentStock);
    stock.sheet = {200, 200};
    document = *setStock(std::move(document), stock);
    const AnalysisPointer analysis = analysisOf(document);
    SheetsQuestion question;
    question.nesting.layout.margin = 2.0;
    const Nested in = askedOf(analysis, question);
    QCOMPARE(in.layout->sheets.size(), std::size_t(1));
    question.nesting.fillsHoles = false;
    QCOMPARE(askedOf(analysis, question, &in).layout->sheets.size(), std::size_t(2));
}

void TestSheets::isWorkedOutWhereItIsWanted()
{
    Session session;
    SheetNesting nesting(session);
    session.reset(combModel(4));
    session.scheduler().finish();
    QVERIFY(!nesting.result());
    nesting.setWanted(this, true);
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.isCurrent());
    QVERIFY(nesting.layoutOf(session.analysisPointer(), nesting.options()));
    NestOptions other = nesting.options();
    other.layout.spacing = 7.0;
    QVERIFY(!nesting.layoutOf(session.analysisPointer(), other));
    nesting.setOptions(other);
    QVERIFY(!nesting.isCurrent());
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.isCurrent());
    nesting.setWanted(this, false);
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.result()); // what was there stays
    QVERIFY(!session.scheduler().result(kNested)->layout);
}

void TestSheets::anEditMakesItOlder()
{
    Session session;
    SheetNesting nesting(session);
    session.reset(combModel(4));
    nesting.setWanted(this, true);
    session.scheduler().finish(kNested.name);
    session.commit(QStringLiteral("Higher"), withHighRib(session.committed().document));
    QVERIFY(!nesting.isCurrent());
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.isCurrent());
    session.history()->undo();
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.isCurrent());
}

void TestSheets::stopEndsASearch()
{
    Session session;
    SheetNesting nesting(session);
    session.reset(eggCrate(5, 5));
    nesting.setWanted(this, true);
    session.scheduler().finish(kNested.name);
    const double before = nesting.result()->filled;
    nesting.nest(NestLevel::Best);
    QVERIFY(nesting.isSearching());
    QCOMPARE(nesting.level(), NestLevel::Best);
    nesting.stop();
    QVERIFY(!nesting.isSearching());
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.isCurrent());
    QVERIFY(nesting.result()->filled >= before);
    session.commit(QStringLiteral("Higher"), withHighRib(session.committed().document));
    QCOMPARE(nesting.level(), NestLevel::Quick);
}

void TestSheets::anotherDocumentIsAskedAgain()
{
    Session session;
    SheetNesting nesting(session);
    session.reset(combModel(4));
    nesting.setWanted(this, true);
    session.scheduler().finish(kNested.name);
    nesting.nest(NestLevel::Best);
    session.reset(combModel(5));
    QVERIFY(!nesting.isSearching());
    session.scheduler().finish(kNested.name);
    QVERIFY(nesting.isCurrent());
    QCOMPARE(nesting.result()->parts->parts.size(), std::size_t(6));
}

// Wrong: each round of a search works out the skin anew.
void TestSheets::otherQuestionsGoOn()
{
    Session session;
    SheetNesting nesting(session);
    session.reset(combModel(4));
    Questions questions;
    questions.skin = true;
    session.scheduler().want(kSkin.name);
    session.scheduler().ask(questions);
    session.scheduler().finish();
    const auto skin = session.scheduler().result(kSkin);
    QVERIFY(skin);
    nesting.setWanted(this, true);
    session.scheduler().finish();
    QVERIFY(nesting.isCurrent());
    QVERIFY(session.scheduler().questions().skin);
    QCOMPARE(session.scheduler().result(kSkin), skin);
}

FFF_TEST(TestSheets)
#include "tst_sheets.moc"
