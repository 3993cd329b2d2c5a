// Values with names drive a model: what was typed for its numbers, and what becomes of that.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/operations/baking.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"
#include "tests/core/operations/driven_models.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

class TestDriven : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPlaceIsWrittenAsItIsRead();
    void numbersFollow();
    void asTypedByHand();
    void whoSetsANumberEndsItsExpression();
    void aPlainNumberEndsIt();
    void refusals();
    void allOrNothing();
    void thickness();
    void sectionsOnSections();
    void wordsFollow();
    void wordsStayWordsOnAStretchedSection();
    void allAreSetBeforeOneIsRefused();
    void twoThatDisagree();
    void renameIsEverywhere();
    void removalLeavesNumbers();
    void copiesBringTheirValues();
    void pastedHereTheyAreShared();
    void bakingKeepsTheModel();
    void dependents();
};

void TestDriven::everyPlaceIsWrittenAsItIsRead()
{
    Document document = shelf();
    Operation row = operation("array", {{"sections", {document.sections[1]->ref()}}});
    document = addOperation(std::move(document), std::move(row));
    const std::vector<DrivenPlace> places = drivablePlaces(document);
    QVERIFY(places.size() > 30);
    for (const DrivenPlace &place : places) {
        const auto number = drivenNumber(document, place);
        QVERIFY2(number, keyOf(place).c_str());
        QVERIFY2(at(document, keyOf(place)) == place, keyOf(place).c_str());
        // What it is can be written there, and changes nothing.
        const Result<Document> same = withDrivenNumber(document, place, number->worth);
        QVERIFY2(same, keyOf(place).c_str());
        const auto again = drivenNumber(*same, place);
        QVERIFY2(again && isSameWorth(again->worth, number->worth), keyOf(place).c_str());
    }
    DrivenPlace none = places.front();
    none.field = "none";
    QVERIFY(!drivenNumber(document, none));
    QVERIFY(!withDrivenNumber(document, none, {}));
}

void TestDriven::numbersFollow()
{
    Document document = withValue(withValue(shelf(), "w", "200 mm"), "n", "3", ValueKind::Count);
    const std::int64_t board = document.sections[0]->id.value;
    document = madeOf(document, stockKey(document, "thickness"), "w/50");
    document = madeOf(document, key("section", board, "width"), "w + 0 mm");
    document = madeOf(document, "figure/" + std::to_string(board) + "/1/diameter", "w/20");
    document = madeOf(document, key("load", document.loads[0].id.value, "mass"), "n * 100 g");
    QCOMPARE(document.bindings.size(), std::size_t(4));
    const Document larger = typed(typed(document, "w", "250 mm"), "n", "7");
    QCOMPARE(larger.stocks[0]->thickness, 5.0);
    QCOMPARE(larger.loads[0].mass, 0.7);
    QVERIFY(std::abs(numberAt(larger, key("section", board, "width")) - 250.0) < 1e-9);
    QCOMPARE(numberAt(larger, "figure/" + std::to_string(board) + "/1/diameter"), 12.5);
    // Agreement is a fixed point, to the very objects.
    QVERIFY(driven(larger).document.isSame(larger));
    QVERIFY(evaluate(larger).document.isSame(larger));
}

void TestDriven::asTypedByHand()
{
    Document document = withValue(shelf(), "w", "3 mm");
    const std::string place = stockKey(document, "thickness");
    const Document byName = typed(madeOf(document, place, "2*w"), "w", "4.2 mm");
    Stock stock = *document.stocks[0];
    stock.thickness = 8.4;
    const Document byHand = setStock(document, stock).value();
    QVERIFY(byName.stocks[0]->thickness == byHand.stocks[0]->thickness);
    QVERIFY(*byName.stocks[0] == *byHand.stocks[0]);
}

void TestDriven::whoSetsANumberEndsItsExpression()
{
    Document document = withValue(shelf(), "w", "3 mm");
    document = madeOf(document, stockKey(document, "thickness"), "2*w");
    Stock stock = *document.stocks[0];
    stock.thickness = 5.0;
    const Document byHand = evaluate(setStock(document, stock).value()).document;
    QVERIFY(byHand.bindings.empty());
    QCOMPARE(byHand.stocks[0]->thickness, 5.0);
    QCOMPARE(typed(byHand, "w", "1 mm").stocks[0]->thickness, 5.0);
    // Another number of the same stock ends nothing.
    stock = *document.stocks[0];
    stock.kerf = 0.3;
    QCOMPARE(evaluate(setStock(document, stock).value()).document.bindings.size(), std::size_t(1));
    // What has it is gone.
    const SectionId board = document.sections[0]->id;
    const Document sized = madeOf(document, key("section", board.value, "width"), "50*w");
    const SectionId ids[] = {board};
    QCOMPARE(evaluate(removeSections(sized, ids).value()).document.bindings.size(), std::size_t(1));
}

void TestDriven::aPlainNumberEndsIt()
{
    Document document = withValue(shelf(), "w", "3 mm");
    const std::string place = stockKey(document, "thickness");
    document = madeOf(document, place, "2*w");
    QVERIFY(bindingOf(document, at(document, place)));
    const Document plain = madeOf(document, place, "1/2 in");
    QVERIFY(madeOf(document, place, "4 mm").bindings.empty());
    QCOMPARE(madeOf(document, place, "4 mm").stocks[0]->thickness, 4.0);
    QCOMPARE(plain.stocks[0]->thickness, 12.7);
}

void TestDriven::refusals()
{
    Document document = withValue(shelf(), "gap", "3 mm");
    const std::string place = stockKey(document, "thickness");
    for (const char *text : {"gap*gap", "nothing", "gap +", "gap/0", "-gap", "sin(30 °)*1 kg"}) {
        const auto refused = bound(document, at(document, place), text);
        QVERIFY2(!refused, text);
        QVERIFY2(refused.error().text.source, text);
    }
    DrivenPlace none;
    none.id = 99;
    none.field = "thickness";
    QVERIFY(!bound(document, none, "gap"));
    // An edit of a value that would leave a number without one is named.
    const Document two = madeOf(document, place, "6 mm - gap");
    const Document wrong = typeValue(two, idOf(two, "gap"), "9 mm", {}).value();
    QVERIFY(newlyWrong(two, wrong));
    QVERIFY(!newlyWrong(two, two));
}

void TestDriven::allOrNothing()
{
    Document document = withValue(shelf(), "w", "3 mm");
    const std::int64_t board = document.sections[0]->id.value;
    document = madeOf(document, key("section", board, "width"), "100*(5 mm - w)");
    document = madeOf(document, stockKey(document, "thickness"), "w");
    const Document before = document;
    const Model model = evaluate(
        typeValue(document, idOf(document, "w"), "6 mm", {}).value()); // the width would be < 0
    QCOMPARE(model.evaluation.drivingErrors.size(), std::size_t(1));
    QCOMPARE(model.document.stocks[0]->thickness, before.stocks[0]->thickness);
    QVERIFY(model.document.sections == before.sections);
    QVERIFY(model.document.bindings == before.bindings);
    const Document again = typed(model.document, "w", "4 mm");
    QCOMPARE(again.stocks[0]->thickness, 4.0);
}

void TestDriven::thickness()
{
    Document document = withValue(shelf(), "w", "4 mm");
    const std::int64_t board = document.sections[0]->id.value;
    document = madeOf(document, "figure/" + std::to_string(board) + "/1/diameter", "3*t");
    document = madeOf(document, stockKey(document, "thickness"), "w");
    QCOMPARE(numberAt(document, "figure/" + std::to_string(board) + "/1/diameter"), 12.0);
    document = typed(document, "w", "5 mm");
    QCOMPARE(numberAt(document, "figure/" + std::to_string(board) + "/1/diameter"), 15.0);
    QVERIFY(!bound(document, at(document, stockKey(document, "thickness")), "2*t"));
}

void TestDriven::sectionsOnSections()
{
    Document document = withValue(shelf(), "x", "100 mm");
    const std::int64_t board = document.sections[0]->id.value, rib = document.sections[1]->id.value;
    document = madeOf(document, key("section", board, "x"), "x + 1 mm");
    document = madeOf(document, key("section", rib, "x"), "2*x");
    document = madeOf(document, key("section", rib, "angle"), "1.5*x/1 mm*0.4 °");
    QCOMPARE(document.bindings.size(), std::size_t(3));
    const Document moved = typed(document, "x", "120 mm");
    QVERIFY(std::abs(numberAt(moved, key("section", board, "x")) - 121.0) < 1e-6);
    QVERIFY(std::abs(numberAt(moved, key("section", rib, "x")) - 240.0) < 1e-6);
    QVERIFY(std::abs(numberAt(moved, key("section", rib, "angle")) -
                     72.0 / 180.0 * std::numbers::pi) < 1e-6);
    QCOMPARE(moved.bindings.size(), std::size_t(3));
    // What is on a section goes along as it is sized, about the slit.
    const Document wider = madeOf(moved, key("section", board, "width"), "300 mm");
    QVERIFY(std::abs(numberAt(wider, key("section", board, "width")) - 300.0) < 1e-6);
    QVERIFY(std::abs(numberAt(wider, key("section", board, "height")) - 40.0) < 1e-6);
    QCOMPARE(wider.bindings.size(), std::size_t(3));
}

void TestDriven::wordsFollow()
{
    Document document = withValue(shelf(), "n", "3", ValueKind::Count);
    const std::string place =
        "lettering/" + std::to_string(document.sections[0]->id.value) + "/0/text";
    document = madeOf(document, place, "{n} of {n + 1}");
    QCOMPARE(document.sections[0]->marks[0]->lettering->text, std::string("3 of 4"));
    document = typed(document, "n", "8");
    QCOMPARE(document.sections[0]->marks[0]->lettering->text, std::string("8 of 9"));
    document = removeValue(document, idOf(document, "n")).document;
    document = evaluate(document).document;
    QVERIFY(document.bindings.empty());
    QCOMPARE(document.sections[0]->marks[0]->lettering->text, std::string("8 of 9"));
}

// Wrong: words that a stretched section turns into mere lines, which follow nothing any more.
void TestDriven::wordsStayWordsOnAStretchedSection()
{
    Document document = withValue(shelf(), "n", "3", ValueKind::Count);
    const std::int64_t board = document.sections[0]->id.value;
    document = madeOf(document, "lettering/" + std::to_string(board) + "/0/text", "{n} of 9");
    document = madeOf(document, key("section", board, "width"), "100 mm * n");
    const std::optional<Lettering> wide = document.sections[0]->marks[0]->lettering;
    QVERIFY(wide);
    QCOMPARE(wide->height, 8.0);
    // As far from the middle of the board, in shares of its width, as before.
    QVERIFY((wide->at - Vec2(175, 20)).norm() < 1e-9);
    document = typed(document, "n", "2");
    const std::optional<Lettering> narrow = document.sections[0]->marks[0]->lettering;
    QVERIFY(narrow);
    QCOMPARE(narrow->text, std::string("2 of 9"));
    QVERIFY((narrow->at - Vec2(150, 20)).norm() < 1e-9);
}

// Wrong: a disc and its hole that both become larger, or smaller: whichever went first had no room,
// and values that are fine could not be reached from others that are.
void TestDriven::allAreSetBeforeOneIsRefused()
{
    Document document = newDocument();
    Figure disc = newFigure(*figureKind("circle")), hole = disc;
    disc.numbers = {100.0};
    hole.numbers = {80.0};
    const SectionId ring =
        add(document, "Ring", shapeOf(contourOf(disc).value(), {contourOf(hole).value()}),
            frontFrame());
    document = addFigure(std::move(document), ring, disc).value();
    document = addFigure(std::move(document), ring, hole).value();
    document = withValue(std::move(document), "d", "80 mm");
    const std::string figure = "figure/" + std::to_string(ring.value);
    document = madeOf(document, figure + "/0/diameter", "d + 20 mm");
    document = madeOf(document, figure + "/1/diameter", "d");
    QCOMPARE(document.bindings.size(), std::size_t(2));
    for (const char *size : {"200 mm", "30 mm", "400 mm", "80 mm"}) {
        document = typed(document, "d", size);
        QVERIFY2(driven(document).errors.empty(), size);
        QCOMPARE(numberAt(document, figure + "/0/diameter"),
                 numberAt(document, figure + "/1/diameter") + 20.0);
    }
    const Document before = document;
    QVERIFY(!driven(typeValue(document, idOf(document, "d"), "0 mm", {}).value()).errors.empty());
}

void TestDriven::twoThatDisagree()
{
    Document document = withValue(shelf(), "w", "3 mm");
    Figure round = newFigure(*figureKind("circle"));
    round.numbers = {50.0};
    const SectionId id = add(document, "Disc", shapeOf(contourOf(round).value()), frontFrame());
    document = addFigure(std::move(document), id, round).value();
    document = madeOf(document, key("section", id.value, "width"), "20*w");
    const std::string diameter = "figure/" + std::to_string(id.value) + "/0/diameter";
    if (placeOfKey(document, diameter)) // else the circle is an ellipse by now
        QVERIFY(!bound(document, at(document, diameter), "30*w"));
    QVERIFY(evaluate(document).evaluation.drivingErrors.empty());
}

void TestDriven::renameIsEverywhere()
{
    Document document = withValue(withValue(shelf(), "w", "3 mm"), "two", "2*w");
    const std::string place = stockKey(document, "thickness");
    document = madeOf(document, place, "two + W");
    const Document renamed = renameValue(document, idOf(document, "w"), "breadth").value();
    QCOMPARE(bindingOf(renamed, at(renamed, place))->typed, std::string("two + breadth"));
    QCOMPARE(renamed.values.list[1]->value.typed, std::string("2*breadth"));
    QVERIFY(evaluate(renamed).document.stocks == document.stocks);
    QVERIFY(!renameValue(document, idOf(document, "w"), "two"));
    const Document back = renameValue(renamed, idOf(renamed, "breadth"), "w").value();
    QCOMPARE(bindingOf(back, at(back, place))->typed, std::string("two + w"));
    QVERIFY(back.values == document.values);
}

void TestDriven::removalLeavesNumbers()
{
    Document document = withValue(withValue(shelf(), "w", "3 mm"), "two", "2*w");
    document = madeOf(document, stockKey(document, "thickness"), "w + 1 mm");
    document = madeOf(document, stockKey(document, "kerf"), "two/60");
    const RemovedValue removed = removeValue(document, idOf(document, "w"));
    QCOMPARE(removed.users, 2);
    const Document after = evaluate(removed.document).document;
    QVERIFY(after.stocks == document.stocks);
    QCOMPARE(after.bindings.size(), std::size_t(1));
    QCOMPARE(after.values.list.size(), std::size_t(1));
    QVERIFY(evaluate(after).evaluation.drivingErrors.empty());
}

void TestDriven::copiesBringTheirValues()
{
    Document document = withValue(withValue(shelf(), "w", "200 mm"), "unused", "1 mm");
    document = withValue(document, "base", "100 mm");
    document = typed(document, "w", "2*base");
    const SectionRef board = document.sections[0]->ref();
    document = madeOf(document, key("section", board.drawn.value, "width"), "w + 1 mm");
    const Document copy = excerpt(evaluate(document), {board});
    QCOMPARE(copy.bindings.size(), std::size_t(1));
    QCOMPARE(copy.values.list.size(), std::size_t(2)); // without what is not used

    Document other = withValue(newDocument(), "w", "7 mm");
    const Insertion inserted = fff::inserted(other, copy);
    QCOMPARE(inserted.document.values.list.size(), std::size_t(3));
    QCOMPARE(inserted.document.bindings.size(), std::size_t(1));
    const Binding &binding = inserted.document.bindings[0]->binding;
    QVERIFY(binding.typed != "w + 1 mm"); // w is another one there
    QCOMPARE(binding.place.id, inserted.document.sections.back()->id.value);
    const Document larger = typed(inserted.document, "base", "110 mm");
    QVERIFY(std::abs(numberAt(larger, key("section", binding.place.id, "width")) - 221.0) < 1e-6);
}

void TestDriven::pastedHereTheyAreShared()
{
    Document document = withValue(shelf(), "w", "200 mm");
    const SectionRef board = document.sections[0]->ref();
    document = madeOf(document, key("section", board.drawn.value, "width"), "w + 1 mm");
    const Insertion twice = inserted(document, excerpt(evaluate(document), {board}));
    QCOMPARE(twice.document.values.list.size(), std::size_t(1));
    QCOMPARE(twice.document.bindings.size(), std::size_t(2));
    const Document larger = typed(twice.document, "w", "300 mm");
    for (const SectionId id : {board.drawn, larger.sections.back()->id})
        QVERIFY(std::abs(numberAt(larger, key("section", id.value, "width")) - 301.0) < 1e-6);
}

void TestDriven::bakingKeepsTheModel()
{
    Document document = withValue(shelf(), "n", "4", ValueKind::Count);
    Operation array = operation("array", {{"sections", {document.sections[1]->ref()}}});
    document = addOperation(std::move(document), std::move(array));
    const OperationId id = document.operations[0]->id;
    document = madeOf(document, key("operation", id.value, "count"), "n + 1");
    const Model before = evaluate(document);
    QCOMPARE(before.document.bindings.size(), std::size_t(1));
    const Model after = evaluate(baked(before, id).value());
    QCOMPARE(after.sectionCount(), before.sectionCount());
    QVERIFY(after.document.bindings.empty());
    QVERIFY(after.evaluation.drivingErrors.empty());
}

void TestDriven::dependents()
{
    Document document = withValue(withValue(shelf(), "w", "3 mm"), "two", "2*w");
    document = madeOf(document, stockKey(document, "thickness"), "two + 0 mm");
    document = madeOf(document, stockKey(document, "kerf"), "0.1 mm + 0 mm");
    const EvaluatedValues values = EvaluatedValues::of(document.values);
    QCOMPARE(boundTo(document, values, idOf(document, "w")).size(), std::size_t(1));
    QCOMPARE(boundTo(document, values, idOf(document, "two")).size(), std::size_t(1));
}

FFF_TEST(TestDriven)
#include "tst_driven.moc"
