// What a person wants of how parts lie: laws of its edits, what follows sections that are copied,
// baked and removed, files, and commands.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/tolerances.h"
#include "core/io/fff_format.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/model/sheet_edits.h"
#include "core/operations/baking.h"
#include "core/operations/evaluate.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using nest::Turning;

/// Of the part of that section.
PinnedPlace placeOn(const Document &document, std::size_t section, const Vec2 &offset,
                    int sheet = 0)
{
    return {document.sections[section]->ref(), 0, sheet, Vec2::UnitX(), offset};
}

/// Some parts pinned, some with a turning of their own.
Document wished(unsigned seed)
{
    Document document = combModel(8);
    std::mt19937 random(seed);
    for (int i = 0; i < 12; ++i) {
        const std::size_t section = random() % document.sections.size();
        const double angle = 0.37 * static_cast<double>(random() % 17);
        PinnedPlace place = placeOn(document, section,
                                    {0.1 * static_cast<double>(random() % 4000),
                                     0.1 * static_cast<double>(random() % 3000)},
                                    static_cast<int>(random() % 3));
        place.body = static_cast<int>(random() % 2);
        place.turn = {std::cos(angle), std::sin(angle)};
        document = *setPin(std::move(document), place);
        document =
            *setTurning(std::move(document), place.section, static_cast<Turning>(random() % 4));
    }
    return document;
}

bool isInOrder(const Document &document)
{
    const auto isOnce = [](const auto &all, auto key) {
        return std::adjacent_find(all.begin(), all.end(), [&](const auto &a, const auto &b) {
                   return !(key(a) < key(b));
               }) == all.end();
    };
    return isOnce(document.pins,
                  [](const PinnedPlace &pin) { return std::pair(pin.section, pin.body); }) &&
           isOnce(document.turnings, [](const SectionTurning &one) { return one.section; });
}

/// A desk with a comb.
struct SheetDesk : Desk
{
    SheetDesk() { session.reset(combModel(4)); }
    Result<void> runNow(const char *id, const CommandParameters &parameters)
    {
        return commands.run(id, parameters, time);
    }
    const Document &document() const { return session.committed().document; }
    std::string name(std::size_t section) const { return document().sections[section]->name; }
};

} // namespace

class TestSheetWishes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void editsKeepTheOrder();
    void nonsenseIsRefused_data();
    void nonsenseIsRefused();
    void whatIsGoneIsForgotten();
    void copiesKeepTheirTurningAndNoPlace();
    void copiesOfOperationsTurnAsTheirSource();
    void filesKeepThem();
    void brokenFilesAreTold_data();
    void brokenFilesAreTold();
    void commandsAreSteps();
    void wrongCommandsAreTold_data();
    void wrongCommandsAreTold();
};

void TestSheetWishes::editsKeepTheOrder()
{
    for (unsigned seed = 1; seed < 40; ++seed) {
        const Document document = wished(seed);
        QVERIFY2(isInOrder(document), qPrintable(QString::number(seed)));
        for (const PinnedPlace &pin : document.pins) {
            QVERIFY(*pinOf(document, pin.section, pin.body) == pin);
            QVERIFY(setPin(document, pin)->isSame(document));
        }
        for (const SectionTurning &one : document.turnings)
            QVERIFY(turningOf(document, *document.find(one.section.drawn)) == one.turning);
        Document bare = document;
        for (const SectionPointer &section : document.sections) {
            const SectionRef ref[] = {section->ref()};
            bare = *setTurning(withoutPins(std::move(bare), ref), ref[0], std::nullopt);
        }
        QVERIFY(bare == combModel(8));
    }
}

void TestSheetWishes::nonsenseIsRefused_data()
{
    QTest::addColumn<int>("sheet");
    QTest::addColumn<int>("body");
    QTest::addColumn<Vec2>("turn");
    QTest::addColumn<Vec2>("offset");
    QTest::addColumn<QString>("place");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Vec2 x(1, 0), at(20, 20);
    QTest::newRow("before the first offcut")
        << -kMostSpares - 1 << 0 << x << at << QStringLiteral("sheet");
    QTest::newRow("a sheet beyond all") << 10000 << 0 << x << at << QStringLiteral("sheet");
    QTest::newRow("no body") << 0 << -1 << x << at << QStringLiteral("body");
    QTest::newRow("larger") << 0 << 0 << Vec2(2, 0) << at << QStringLiteral("turn");
    QTest::newRow("no turn") << 0 << 0 << Vec2(0, 0) << at << QStringLiteral("turn");
    QTest::newRow("a turn that is no number")
        << 0 << 0 << Vec2(nan, 0) << at << QStringLiteral("turn");
    QTest::newRow("nowhere") << 0 << 0 << x << Vec2(20, nan) << QStringLiteral("offset");
    QTest::newRow("far off") << 0 << 0 << x << Vec2(1e300, 0) << QStringLiteral("offset");
}

void TestSheetWishes::nonsenseIsRefused()
{
    QFETCH(int, sheet);
    QFETCH(int, body);
    QFETCH(Vec2, turn);
    QFETCH(Vec2, offset);
    QFETCH(QString, place);
    const Document document = combModel(2);
    const auto next = setPin(document, {document.sections[0]->ref(), body, sheet, turn, offset});
    QVERIFY(!next);
    QCOMPARE(next.error().code, ErrorCode::BadValue);
    QCOMPARE(QString::fromStdString(next.error().place), place);
    const auto unknown = setPin(document, {SectionId{999}, 0, 0, Vec2::UnitX(), Vec2(20, 20)});
    QVERIFY(!unknown);
    QCOMPARE(unknown.error().code, ErrorCode::UnknownReference);
    QVERIFY(!setTurning(document, SectionId{999}, Turning::None));
}

// Wrong: a file that cannot be read again, as it speaks of sections that are gone.
void TestSheetWishes::whatIsGoneIsForgotten()
{
    for (unsigned seed = 1; seed < 20; ++seed) {
        Document document = wished(seed);
        const SectionId gone[] = {document.pins.front().section.drawn};
        document = *removeSections(std::move(document), gone);
        QVERIFY(std::none_of(document.pins.begin(), document.pins.end(),
                             [&](const auto &pin) { return pin.section.drawn == gone[0]; }));
        QVERIFY(std::none_of(document.turnings.begin(), document.turnings.end(),
                             [&](const auto &one) { return one.section.drawn == gone[0]; }));
        const auto text = io::writeFff(document);
        QVERIFY(io::readFff(*text)->document == document);
    }
}

// Wrong: a copy lies where what it was copied from lies.
void TestSheetWishes::copiesKeepTheirTurningAndNoPlace()
{
    Document document = combModel(3);
    const SectionRef rib = document.sections[2]->ref();
    const PinnedPlace place = placeOn(document, 2, {100, 100});
    document = *setPin(std::move(document), place);
    document = *setTurning(std::move(document), rib, Turning::Half);
    const Insertion copied = inserted(document, excerpt(evaluate(document), {rib}));
    QCOMPARE(copied.sections.size(), std::size_t(1));
    QCOMPARE(copied.document.pins, document.pins);
    const Section &copy = *copied.document.find(copied.sections.front().drawn);
    QVERIFY(turningOf(copied.document, copy) == Turning::Half);
    QVERIFY(isInOrder(copied.document));
}

// Also when they are drawn ones then, and each may have its own.
void TestSheetWishes::copiesOfOperationsTurnAsTheirSource()
{
    Section source;
    source.id = SectionId{7};
    Document document = combModel(1);
    const SectionRef rib = document.sections[1]->ref();
    document = *setTurning(std::move(document), rib, Turning::None);
    Section copy = *document.sections[1];
    copy.id = {};
    copy.made = SectionRef(OperationId{99}, "1");
    copy.copyOf = CopyOf{rib};
    QVERIFY(turningOf(document, copy) == Turning::None);
    Section again = copy;
    again.made = SectionRef(OperationId{100}, "1");
    again.copyOf = CopyOf{copy.made, std::make_shared<const CopyOf>(CopyOf{rib})};
    QVERIFY(turningOf(document, again) == Turning::None);
    document = *setTurning(std::move(document), copy.made, Turning::Quarter);
    QVERIFY(turningOf(document, copy) == Turning::Quarter);
    QVERIFY(turningOf(document, again) == Turning::Quarter);
    QVERIFY(isInOrder(document));
}

void TestSheetWishes::filesKeepThem()
{
    for (unsigned seed = 1; seed < 40; ++seed) {
        const Document document = wished(seed);
        const auto text = io::writeFff(document);
        const auto back = io::readFff(*text);
        QVERIFY(back && back->document == document);
    }
    // Nothing of it where there is none: older versions read such files as they are.
    const std::string plain = *io::writeFff(combModel(2));
    QVERIFY(plain.find("pins") == std::string::npos);
    QVERIFY(plain.find("turnings") == std::string::npos);
}

void TestSheetWishes::brokenFilesAreTold_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("place");
    const auto row = [](const char *name, const char *from, const char *to, const char *place) {
        QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QString::fromLatin1(place);
    };
    row("a sheet before the first", "\"sheet\": 1", "\"sheet\": -1", "a.fff:$.pins[0].sheet");
    row("half a sheet", "\"sheet\": 1", "\"sheet\": 0.5", "a.fff:$.pins[0].sheet");
    row("too many sheets", "\"sheet\": 1", "\"sheet\": 10000", "a.fff:$.pins[0].sheet");
    row("a body before the first", "\"body\": 1", "\"body\": -1", "a.fff:$.pins[0].body");
    row("a turn that is none", "\"turn\": [0, 1]", "\"turn\": [1, 1]", "a.fff:$.pins[0].turn");
    row("nowhere", "\"at\": [30, 40]", "\"at\": [30]", "a.fff:$.pins[0].at");
    row("a section that is not there", "{\"section\": 3, \"sheet\"", "{\"section\": 33, \"sheet\"",
        "a.fff:$.pins[1].section");
    row("the same part twice", "{\"section\": 3, \"sheet\"",
        "{\"section\": 2, \"body\": 1, \"sheet\"", "a.fff:$.pins[1]");
    row("an unknown turning", "\"half\"", "\"third\"", "a.fff:$.turnings[0].turning");
    row("a turning of nobody", "{\"section\": 2, \"turning\"", "{\"section\": 44, \"turning\"",
        "a.fff:$.turnings[0].section");
}

void TestSheetWishes::brokenFilesAreTold()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, place);
    Document document = combModel(3);
    const SectionRef first = document.sections[0]->ref();
    const PinnedPlace second = placeOn(document, 1, {50, 60});
    document = *setPin(std::move(document), {first, 1, 1, Vec2::UnitY(), Vec2(30, 40)});
    document = *setPin(std::move(document), second);
    document = *setTurning(std::move(document), first, Turning::Half);
    QByteArray text = QByteArray::fromStdString(*io::writeFff(document));
    QVERIFY2(text.count(from) == 1, text.constData());
    text.replace(from, to);
    const auto back = io::readFff(text.toStdString(), "a.fff");
    QVERIFY(!back);
    QCOMPARE(QString::fromStdString(back.error().place), place);
}

void TestSheetWishes::commandsAreSteps()
{
    SheetDesk desk;
    const Document before = desk.document();
    const QUndoStack &history = *desk.session.history();
    QVERIFY(desk.runNow(
        "sheets.place",
        {{"section", desk.name(1)}, {"x", "100"}, {"y", "80.5"}, {"turn", "270"}, {"sheet", "2"}}));
    const PinnedPlace first{desk.document().sections[1]->ref(), 0, 1, -Vec2::UnitY(),
                            Vec2(100, 80.5)};
    QCOMPARE(desk.document().pins, std::vector<PinnedPlace>{first});
    QVERIFY(desk.runNow("sheets.place", {{"section", desk.name(1)}, {"y", "90"}}));
    QCOMPARE(desk.document().pins.front().offset, Vec2(100, 90));
    QCOMPARE(desk.document().pins.front().turn, Vec2(-Vec2::UnitY()));
    QVERIFY(desk.runNow("sheets.turning", {{"section", desk.name(2)}, {"turning", "none"}}));
    QCOMPARE(desk.document().turnings.size(), std::size_t(1));
    QCOMPARE(history.count(), 3);
    QVERIFY(desk.runNow("sheets.turning", {{"section", desk.name(2)}, {"turning", "all"}}));
    QVERIFY(desk.document().turnings.empty());
    QVERIFY(desk.runNow("sheets.unpinAll", {}));
    QVERIFY(desk.document() == before);
    QVERIFY(!desk.commands.isEnabled("sheets.unpinAll"));
    for (int i = 0; i < 2; ++i)
        desk.session.history()->undo();
    QCOMPARE(desk.document().pins.size(), std::size_t(1));
    QVERIFY(desk.runNow("sheets.unpin", {{"section", desk.name(1)}}));
    QVERIFY(desk.document().pins.empty());
}

void TestSheetWishes::wrongCommandsAreTold_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("place");
    const auto row = [](const char *name, const char *id, const char *key, const char *value,
                        const char *place) {
        QTest::newRow(name) << QString::fromLatin1(id) << QString::fromLatin1(key)
                            << QString::fromLatin1(value) << QString::fromLatin1(place);
    };
    row("nobody", "sheets.place", "section", "Nobody", "section");
    row("no place", "sheets.place", "x", "12", "y");
    row("a place that is no number", "sheets.place", "x", "left", "x");
    row("sheet 0", "sheets.place", "sheet", "0", "sheet");
    row("half a sheet", "sheets.place", "sheet", "1.5", "sheet");
    row("body 0", "sheets.place", "body", "0", "body");
    row("no turning", "sheets.turning", "turning", "third", "turning");
    row("nothing said of the turning", "sheets.turning", "x", "", "turning");
}

void TestSheetWishes::wrongCommandsAreTold()
{
    QFETCH(QString, id);
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(QString, place);
    SheetDesk desk;
    CommandParameters parameters{{"section", desk.name(1)}};
    parameters[key.toStdString()] = value.toStdString();
    const auto ran = desk.runNow(qPrintable(id), parameters);
    QVERIFY(!ran);
    QCOMPARE(QString::fromStdString(ran.error().place), place);
    QCOMPARE(desk.session.history()->count(), 0);
}

FFF_TEST(TestSheetWishes)
#include "tst_sheet_wishes.moc"
