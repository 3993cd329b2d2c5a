// What people type where a number belongs: how it is read, what it comes to, and what is refused.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/values/formula.h"
#include "core/values/number_text.h"
#include "core/values/typed.h"
#include "tests/core/values/random_formula.h"
#include "tests/core/values/said.h"
#include "tests/one_line.h"
#include "tests/test_program.h"

#include <cmath>
#include <map>
#include <set>

using namespace fff;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Worth plain(double number, bool isBare = false)
{
    return {Worth::Type::Number, {}, isBare, number};
}
Worth millimetres(double number)
{
    return {Worth::Type::Number, kLengthPowers, false, number};
}

/// gap = 12 mm, n = 5 (a count), lid = yes, style = "round", weite = 30°, Größe_1 = 7 mm
const std::map<std::string, Worth, std::less<>> &knownWorths()
{
    static const std::map<std::string, Worth, std::less<>> worths{
        {"gap", millimetres(12.0)},
        {"n", plain(5.0)},
        {"k", plain(4.0, true)},
        {"zero", plain(0.0)},
        {"lid", {Worth::Type::Truth, {}, false, 1.0}},
        {"style", {Worth::Type::Text, {}, false, 0.0, "round"}},
        {"weite", {Worth::Type::Number, kAnglePowers, false, radians(30.0)}},
        {"load", {Worth::Type::Number, kMassPowers, false, 2.0}},
        {"größe_1", millimetres(7.0)},
        {"長さ", millimetres(9.0)}};
    return worths;
}

const Worth *lookUp(std::string_view name)
{
    const auto found = knownWorths().find(name);
    return found == knownWorths().end() ? nullptr : &found->second;
}

Understood<Worth> worthOf(const QString &text, ValueKind kind, const Reading &reading = {})
{
    const Understood<Typed> typed = Typed::read(text.toStdString(), kind, reading);
    return typed ? typed->worth(lookUp) : tl::unexpected(typed.error());
}

} // namespace

class TestFormula : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsTyped_data();
    void whatIsTyped();
    void commasAreAsPeopleWriteThem();
    void bareNumbersHaveTheUnitThatIsSet();
    void switchesTextsAndChoices();
    void wrongOnesAreToldInOneSentence_data();
    void wrongOnesAreToldInOneSentence();
    void tooMuchIsRefused_data();
    void tooMuchIsRefused();
    void anythingIsReadOrRefused();
    void madeUpOnesComeToWhatTheyWereMadeOf();
    void whatIsWrittenIsReadAsTheSame();
    void exactTextsAreReadAsTheSame();
    void resultsAreWrittenForPeople();
};

void TestFormula::whatIsTyped_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<ValueKind>("kind");
    QTest::addColumn<double>("worth"); // mm, radians, kg
    const auto row = [](const char *text, ValueKind kind, double worth) {
        QTest::newRow(text) << QString::fromUtf8(text) << kind << worth;
    };
    using enum ValueKind;
    row("3", Length, 3.0);
    row("2.5cm", Length, 25.0);
    row("1 m", Length, 1000.0);
    row("2 FT", Length, 609.6);
    row("3\"", Length, 76.2);
    row("1/2 in", Length, 12.7);
    row("1/(2 in)*1 in*1 in", Length, 12.7);
    row("1 1/2 in", Length, 38.1);
    row("n/2 in", Length, 63.5);
    row("gap/(2 mm)", Number, 6.0);
    row("gap/2 mm", Number, 6.0);
    row("1in + 5", Length, 30.4);
    row("2*gap + 1 in", Length, 49.4);
    row("(10 + 2.5) cm", Length, 125.0);
    row("n*20 + gap", Length, 112.0);
    row("k", Length, 4.0);
    row("−gap + 20 · 2", Length, 28.0);
    row("GAP", Length, 12.0);
    row("2*Größe_1", Length, 14.0);
    row("GRÖSSE + 1", Length, kNone);
    row("長さ + 1", Length, 10.0);
    row("sqrt(gap*gap + 5 mm * 5 mm)", Length, 13.0);
    row("sqrt(gap^2 + (5 mm)^2)", Length, 13.0);
    row("gap^3/gap^2", Length, 12.0);
    row("= gap", Length, 12.0);
    row("min(gap, 1 cm, 40)", Length, 10.0);
    row("max(2; 5)", Number, 5.0);
    row("max(2, 5)", Number, 5.0);
    row("max(gap,5)", Length, 12.0);
    row("if(n > 4, 3 mm, 4 mm)", Length, 3.0);
    row("if(n = 5; 30; gap)", Length, 30.0);
    row("if(zero > 0, gap/zero, gap)", Length, 12.0);
    row("if(and(zero > 0, n/zero > 2), 1, 2)", Number, 2.0);
    row("if(or(lid, n/zero > 2), 1, 2)", Number, 1.0);
    row("if(not(lid), 1, 2)", Number, 2.0);
    row("if(style = 'round', 1, 2)", Number, 1.0);
    row("if(style <> “square”, 1, 2)", Number, 1.0);
    row("round(gap/5 mm)", Count, 2.0);
    row("round(13.2 mm; 5 mm)", Length, 15.0);
    row("round(13.2 mm, 5)", Length, 15.0);
    row("floor(0.3/0.1)", Count, 3.0);
    row("ceil(0.1*3*10)", Count, 3.0);
    row("round(-2.5)", Number, -3.0);
    row("floor(-0.5)", Number, -1.0);
    row("round(12.4 mm)", Length, 12.0);
    row("sin(30)", Ratio, 0.5);
    row("sin(weite)", Ratio, 0.5);
    row("cos(60°)", Ratio, 0.5);
    row("tan(45 deg)", Ratio, 1.0);
    row("atan(1)", Angle, radians(45.0));
    row("asin(0.5) + 15", Angle, radians(45.0));
    row("360/8", Angle, radians(45.0));
    row("90° - 15", Angle, radians(75.0));
    row("2 rad", Angle, 2.0);
    row("2*pi*gap", Length, 24.0 * std::numbers::pi);
    row("2^3^2", Number, 512.0);
    row("-2^2", Number, -4.0);
    row("2^-1", Number, 0.5);
    row("8 / 4 / 2", Number, 1.0);
    row("2 + 3 * 4 - 1", Number, 13.0);
    row("7 ÷ 2 × 2", Number, 7.0);
    row("50 %", Ratio, 0.5);
    row("gap * 110 %", Length, 13.2);
    row("100/50%", Number, 200.0);
    row("(100)/(50 %)", Number, 200.0);
    row("gap/200%", Length, 6.0);
    row("50%^2", Ratio, 0.25);
    row("250", Mass, 0.25);
    row("1.5 kg + 50 g", Mass, 1.55);
    row("load/4", Mass, 0.5);
    row("n", Count, 5.0);
    row("3*0.1*10", Count, 3.0);
    row("1,000 mm", Length, 1000.0);
    row("2,5 mm", Length, 2.5);
    row("max(2,5; 3)", Number, 3.0);
    row("max((2,5), 3)", Number, 3.0);
    row("len('abc')", Count, 3.0);
    row("2*len(style)", Number, 10.0);
    row("len('Größe 長さ')", Count, 8.0);
    row("len('ab\ncdef\ng')", Count, 4.0);
    row("len(if(lid, style, 'a'))*gap", Length, 60.0);
}

void TestFormula::whatIsTyped()
{
    QFETCH(QString, text);
    QFETCH(ValueKind, kind);
    QFETCH(double, worth);
    const Understood<Worth> found = worthOf(text, kind);
    if (std::isnan(worth)) {
        QVERIFY(!found);
        return;
    }
    QVERIFY2(found, found ? "" : test::said(found.error().message).c_str());
    QVERIFY2(std::abs(found->number - worth) < 1e-9, qPrintable(QString::number(found->number)));
}

void TestFormula::commasAreAsPeopleWriteThem()
{
    Reading german;
    german.commas = Commas::Decimals;
    QCOMPARE(worthOf(QStringLiteral("1,000"), ValueKind::Length, german)->number, 1.0);
    QCOMPARE(worthOf(QStringLiteral("1.234,5"), ValueKind::Length, german)->number, 1234.5);
    QCOMPARE(worthOf(QStringLiteral("1,234.5"), ValueKind::Length)->number, 1234.5);
    QCOMPARE(worthOf(QStringLiteral("max(2,5; 1,5)"), ValueKind::Length, german)->number, 2.5);
    // Wrong: an eighth was a hundred and twenty-five.
    for (const auto &[text, is] : {std::pair{"0,125", 0.125},
                                   {"00,125", 0.125},
                                   {"1,234,567", 1234567.0},
                                   {"1.234.567", 1234567.0},
                                   {"12,345", 12345.0},
                                   {"1234,567", 1234.567},
                                   {"1,25", 1.25}})
        QCOMPARE(worthOf(QString::fromLatin1(text), ValueKind::Length)->number, is);
    for (const char *text : {"12,34.5", "1,2.3,4", "1.2.3", "0,125.5", "1234,567.8"})
        QVERIFY2(!worthOf(QString::fromLatin1(text), ValueKind::Length), text);
}

// Wrong: what was typed in inches is another size to whoever has set millimetres.
void TestFormula::bareNumbersHaveTheUnitThatIsSet()
{
    Reading inches;
    inches.lengthUnit = 25.4;
    QCOMPARE(worthOf(QStringLiteral("2"), ValueKind::Length, inches)->number, 50.8);
    QCOMPARE(worthOf(QStringLiteral("1 mm + 1"), ValueKind::Length, inches)->number, 26.4);
    QCOMPARE(worthOf(QStringLiteral("round(3 cm)"), ValueKind::Length, inches)->number, 25.4);
    QCOMPARE(worthOf(QStringLiteral("max(gap; 1)"), ValueKind::Length, inches)->number, 25.4);
}

void TestFormula::switchesTextsAndChoices()
{
    QCOMPARE(worthOf(QStringLiteral("Yes"), ValueKind::Switch)->number, 1.0);
    QCOMPARE(worthOf(QStringLiteral("no"), ValueKind::Switch)->number, 0.0);
    QCOMPARE(worthOf(QStringLiteral("gap > 1 cm"), ValueKind::Switch)->number, 1.0);
    const auto textOf = [](const char *typed, ValueKind kind) {
        const Understood<Worth> worth = worthOf(QString::fromUtf8(typed), kind);
        return worth ? worth->text : "refused: " + test::said(worth.error().message);
    };
    QCOMPARE(textOf("two words", ValueKind::Choice), std::string("two words"));
    QCOMPARE(textOf("= if(lid, 'a', 'b')", ValueKind::Choice), std::string("a"));
    QCOMPARE(textOf("{gap} wide", ValueKind::Text), std::string("12 mm wide"));
    QCOMPARE(textOf("{{{n}}}: {2*gap/1 mm}", ValueKind::Text), std::string("{5}: 24"));
    QCOMPARE(textOf("no places } here", ValueKind::Text), std::string("no places } here"));
    QCOMPARE(textOf("=gap", ValueKind::Text), std::string("12 mm"));
    QCOMPARE(textOf("{style}, {weite}, {load}, {lid}", ValueKind::Text),
             std::string("round, 30°, 2 kg, yes"));
}

void TestFormula::wrongOnesAreToldInOneSentence_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<ValueKind>("kind");
    QTest::addColumn<QString>("place"); // what is quoted of the text
    const auto row = [](const char *text, ValueKind kind, const char *place) {
        QTest::addRow("%s as kind %d", text, static_cast<int>(kind))
            << QString::fromUtf8(text) << kind << QString::fromUtf8(place);
    };
    using enum ValueKind;
    // What cannot be read.
    row("", Length, "");
    row("   ", Length, "   ");
    row("=", Length, "=");
    row("3 +", Length, "+");
    row("* 3", Length, "*");
    row("3 * / 4", Length, "*");
    row("3 4", Length, "4");
    row("3 gap", Length, "gap");
    row("gap 3", Length, "3");
    row("gap n", Length, "n");
    row("gap mm", Length, "mm");
    row("(3)(4)", Length, "(");
    row("3 mm cm", Length, "cm");
    row("(3", Length, "(3");
    row("2*(3 + (4", Length, "(4");
    row("3 + 4)", Length, ")");
    row(")", Length, ")");
    row("()", Length, ")");
    row("3 # 4", Length, "#");
    row("§", Length, "§");
    row("3.4.5", Length, "3.4.5");
    row("1,2,3", Length, "1,2,3");
    row("3 .. 4", Length, ".");
    row("3, 4", Length, ",");
    row("3; 4", Length, ";");
    row("max(2,5)", Length, "2,5");
    row("if(lid,2,5)", Length, "2,5");
    row("max(2,5, 3)", Length, "2,5");
    row("max(2,gap; 3)", Length, ",");
    row("3 mm^2", Length, "3 mm^");
    row("1 < 2 < 3", Switch, "<");
    row("'open", Text, nullptr);
    row("= 'open", Text, "'open");
    row("3 “open", Length, "“open");
    row("3 'text'", Length, "'text'");
    row("mm", Length, "mm");
    row("3*cm", Length, "cm");
    row("cm(3)", Length, "cm");
    row("%", Length, "%");
    row("°", Angle, "°");
    row("median(1; 2)", Length, "median");
    row("長(1)", Length, "長");
    row("sqrt()", Length, "sqrt()");
    row("sqrt(1; 2)", Length, "sqrt(1; 2)");
    row("min(gap)", Length, "min(gap)");
    row("round(1; 2; 3)", Length, "round(1; 2; 3)");
    row("if(lid; 1)", Length, "if(lid; 1)");
    row("if(lid; 1; 2; 3)", Length, "if(lid; 1; 2; 3)");
    row("max(gap;)", Length, ";");
    row("max(;gap)", Length, ";");
    row("max(gap", Length, "(gap");
    row("gap ! 3", Length, "!");
    row("3 & 4", Length, "&");
    row("a.b", Length, ".");
    row("gap = ", Switch, "=");
    row("== 3", Length, "==");
    row("2^", Length, "^");
    row("^2", Length, "^");
    row("1 1/0 in", Length, "0");
    row("{gap", Text, "{gap");
    row("a {} b", Text, "");
    row("a {3 +} b", Text, "+");
    row("a {what} b", Text, "what");
    row("\x01", Length, "\x01");
    // What does not go together.
    row("gap*gap", Length, "gap*gap");
    row("gap*gap*gap", Length, "gap*gap*gap");
    row("1/gap", Length, "1/gap");
    row("gap/gap", Length, "gap/gap");
    row("gap", Angle, "gap");
    row("gap", Mass, "gap");
    row("gap", Count, "gap");
    row("gap", Ratio, "gap");
    row("gap", Number, "gap");
    row("gap", Switch, "gap");
    row("= gap", Choice, "= gap");
    row("n", Length, "n");
    row("50 %", Length, "50 %");
    row("n + gap", Length, "n + gap");
    row("gap + 10 %", Length, "gap + 10 %");
    row("gap + weite", Length, "gap + weite");
    row("gap + 2 kg", Length, "gap + 2 kg");
    row("gap*gap + 5", Length, "gap*gap + 5");
    row("lid + 1", Length, "lid");
    row("2*style", Length, "style");
    row("-style", Length, "style");
    row("style < 3", Switch, "style");
    row("style = 3", Switch, "style = 3");
    row("lid", Length, "lid");
    row("'abc'", Length, "'abc'");
    row("if(gap, 1, 2)", Length, "gap");
    row("if(lid, gap, weite)", Length, "gap, weite");
    row("if(lid, gap, 'a')", Length, "gap, 'a'");
    row("min(gap, n)", Length, "gap, n");
    row("and(lid, gap)", Switch, "gap");
    row("sin(gap)", Ratio, "gap");
    row("asin(gap)", Angle, "gap");
    row("sqrt(gap)", Length, "gap");
    row("len(gap)", Count, "gap");
    row("len(lid)", Count, "lid");
    row("len(style)", Length, "len(style)");
    row("gap^n", Length, "gap^n");
    row("gap^0.5", Length, "gap^0.5");
    row("gap^10", Length, "gap^10");
    row("(gap^9)^9", Length, "(gap^9)^9");
    row("2^gap", Length, "gap");
    row("(gap) mm", Length, "(gap) mm");
    row("(3 mm) cm", Length, "(3 mm) cm");
    row("round(gap; weite)", Length, "gap; weite");
    row("unknown", Length, "unknown");
    row("2*Unknown + gap", Length, "Unknown");
    row("3*t", Length, "t");
    // What has no value.
    row("1/0", Length, "0");
    row("gap/(2 - 2)", Length, "(2 - 2)");
    row("gap/zero", Length, "zero");
    row("sqrt(-4)", Length, "-4");
    row("tan(90)", Ratio, "90");
    row("acos(2)", Angle, "2");
    row("(-8)^(1/3)", Number, "(-8)^(1/3)");
    row("0^-1", Number, "0^-1");
    row("10^400", Number, "10^400");
    row("10^200*10^200", Number, "10^200*10^200");
    row("round(gap; zero*gap)", Length, "zero*gap");
    row("floor(3; -1)", Number, "-1");
    row("n/2", Count, "n/2");
    row("2.5", Count, "2.5");
    row("10^20", Count, "10^20");
}

// Wrong: a field that refuses and does not say what, or points to another place.
void TestFormula::wrongOnesAreToldInOneSentence()
{
    QFETCH(QString, text);
    QFETCH(ValueKind, kind);
    QFETCH(QString, place);
    const Understood<Worth> found = worthOf(text, kind);
    if (place.isNull()) { // a text is as it is
        QVERIFY(found);
        return;
    }
    QVERIFY2(!found, "it is understood");
    const std::string bytes = text.toStdString();
    const TextRange at = found.error().place;
    QVERIFY(at.begin <= at.end && at.end <= bytes.size());
    QCOMPARE(QString::fromStdString(bytes.substr(at.begin, at.end - at.begin)), place);
    const QString sentence = QString::fromStdString(test::said(found.error().message));
    QVERIFY2(test::isOneLine(sentence), qPrintable(sentence));
    QVERIFY2(sentence.endsWith(u'.') && sentence.count(QStringLiteral(". ")) == 0,
             qPrintable(sentence));
    QVERIFY2(!sentence.contains(u'%') || text.contains(u'%'), qPrintable(sentence));
}

void TestFormula::tooMuchIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    constexpr int kMany = 1'000'000;
    QTest::newRow("open parentheses") << QByteArray(kMany, '(');
    QTest::newRow("signs") << QByteArray(kMany, '-') + "1";
    QTest::newRow("digits") << QByteArray(kMany, '9');
    QTest::newRow("a name") << QByteArray(kMany, 'a');
    QTest::newRow("a sum") << QByteArray("1+").repeated(kMany / 2) + "1";
    QTest::newRow("calls") << QByteArray("abs(").repeated(kMany / 4);
    QTest::newRow("a deep one that is not long")
        << QByteArray(101, '(') + "1" + QByteArray(101, ')');
    QTest::newRow("a hundred and one signs") << QByteArray(101, '-') + "1";
    QTest::newRow("powers") << QByteArray("2^").repeated(101) + "1";
    QTest::newRow("calls that are not many")
        << QByteArray("abs(").repeated(101) + "1" + QByteArray(101, ')');
    QTest::newRow("many nodes") << QByteArray("1+").repeated(501) + "1";
}

// Wrong: an expression in a file takes the stack, and the program with it.
void TestFormula::tooMuchIsRefused()
{
    QFETCH(QByteArray, text);
    for (const ValueKind kind : {ValueKind::Length, ValueKind::Switch}) {
        const Understood<Typed> typed = Typed::read(text.toStdString(), kind);
        QVERIFY(!typed);
        const std::string sentence = test::said(typed.error().message);
        QVERIFY2(sentence.size() < 300, sentence.c_str());
    }
    QVERIFY(Typed::read(std::string(100, '(') + "1" + std::string(100, ')'), ValueKind::Length));
    QVERIFY(Typed::read("1" + std::string(60, '+') + "1", ValueKind::Length));
}

// Wrong: something that nobody thought of breaks it.
void TestFormula::anythingIsReadOrRefused()
{
    static const std::vector<std::string> pieces{
        "gap",  "n",     "(",   ")",    "+", "-",  "*",  "/",  "^",     "<",  "=",        ",",
        ";",    "1",     "2.5", "3,",   " ", "mm", "in", "\"", "'",     "°",  "%",        "if(",
        "max(", "sqrt(", "é",   "\xff", "{", "}",  "“",  "”",  "1 1/2", "kg", "\xe2\x82", "lid"};
    std::mt19937 random(29);
    std::uniform_int_distribution<std::size_t> piece(0, pieces.size() - 1), count(1, 12);
    int understood = 0;
    for (int i = 0; i < 30'000; ++i) {
        std::string text;
        for (std::size_t left = count(random); left > 0; --left)
            text += pieces[piece(random)];
        const Understood<Formula> formula = Formula::read(text);
        if (!formula) {
            QVERIFY(!test::said(formula.error().message).empty());
            QVERIFY(formula.error().place.begin <= formula.error().place.end &&
                    formula.error().place.end <= text.size());
            continue;
        }
        ++understood;
        const Understood<Formula> again = Formula::read(writtenFormula(*formula));
        QVERIFY2(again && again->means(*formula), text.c_str());
        const Understood<Worth> worth = formula->worth(lookUp);
        if (worth && worth->type == Worth::Type::Number)
            QVERIFY2(std::isfinite(worth->number), text.c_str());
    }
    QVERIFY2(understood > 500, "nothing of it was an expression, so nothing was tested");
}

// Wrong: a sum of many is another one than the person meant.
void TestFormula::madeUpOnesComeToWhatTheyWereMadeOf()
{
    const test::MadeNames names{{"gap", {12.0, 1}}, {"n", {5.0, 0}}, {"größe_1", {7.0, 1}}};
    int valued = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
        test::RandomFormula random(seed, names);
        const auto made = random.make(1 + static_cast<int>(seed % 5), static_cast<int>(seed % 3));
        if (made.text.size() > kLongestExpression)
            continue;
        const Understood<Formula> formula = Formula::read(made.text);
        if (!formula && formula.error().message.text.source ==
                            std::string_view("At “%1” the expression has more than %2 numbers, "
                                             "names and signs."))
            continue;
        QVERIFY2(formula, made.text.c_str());
        const Understood<Worth> worth = formula->worth(lookUp);
        if (!std::isfinite(made.worth.number)) {
            QVERIFY2(!worth, made.text.c_str());
            continue;
        }
        // Where rounding decides, as of a difference that is nothing but that, both may be right.
        const double scale = std::max(1.0, std::abs(made.worth.number));
        if (!worth)
            continue;
        ++valued;
        QCOMPARE(worth->powers.length, made.worth.power);
        QVERIFY2(std::abs(worth->number - made.worth.number) < 1e-7 * scale, made.text.c_str());
        const std::string written = writtenFormula(*formula);
        if (written.size() > kLongestExpression)
            continue;
        const Understood<Formula> again = Formula::read(written);
        QVERIFY2(again && again->means(*formula), made.text.c_str());
        QCOMPARE(again->worth(lookUp)->number, worth->number);
    }
    QVERIFY2(valued > 2000, qPrintable(QString::number(valued)));
}

void TestFormula::whatIsWrittenIsReadAsTheSame()
{
    const auto isSame = [](const char *text, const char *written) {
        const Understood<Formula> formula = Formula::read(text);
        QVERIFY2(formula, text);
        QCOMPARE(writtenFormula(*formula), std::string(written));
        QVERIFY(Formula::read(written)->means(*formula));
    };
    isSame("2*( gap+1 )", "2*(gap + 1)");
    isSame("1/(2 in)", "1/(2 in)");
    isSame("1/2 in", "1/2 in");
    isSame("1/-(2 in)", "1/(-2 in)");
    isSame("-(a*b)", "-(a*b)");
    isSame("-a*b", "-a*b");
    isSame("(-a)^2", "(-a)^2");
    isSame("a^(-2)", "a^-2");
    isSame("(a^b)^c", "(a^b)^c");
    isSame("a-(b-c)", "a - (b - c)");
    isSame("(a) mm", "(a) mm");
    isSame("(1+2)mm", "(1 + 2) mm");
    isSame("1 1/2\"", "1.5 \"");
    isSame("if(a<b,max(a, b),'it''s \"so\"')", "if(a < b; max(a; b); \"it's \"\"so\"\"\")");
    isSame("(a < b) = c", "(a < b) = c");
    QVERIFY(!Formula::read("1/2 in")->means(*Formula::read("1/(2 in)")));
}

// Wrong: a value that is removed moves what was made of it by a hair.
void TestFormula::exactTextsAreReadAsTheSame()
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> digits(-1.0, 1.0), exponent(-6.0, 6.0);
    using enum ValueKind;
    for (int i = 0; i < 5000; ++i) {
        const double number = digits(random) * std::pow(10.0, exponent(random));
        for (const auto &[kind, powers] :
             {std::pair(Length, kLengthPowers), std::pair(Angle, kAnglePowers),
              std::pair(Mass, kMassPowers), std::pair(Number, Powers())}) {
            const Worth worth{Worth::Type::Number, powers, kind == Number, number};
            const std::string text = exactText(worth, kind);
            const Understood<Typed> typed = Typed::read(text, kind);
            QVERIFY2(typed && typed->isConstant(), text.c_str());
            QVERIFY2(*typed->worth({}) == worth, text.c_str());
        }
    }
    for (const char *words : {"{a} }b{", "=gap", "{{", "plain"}) {
        const Worth worth{Worth::Type::Text, {}, false, 0.0, words};
        const std::string text = exactText(worth, Text);
        QVERIFY2(*Typed::read(text, Text)->worth({}) == worth, text.c_str());
    }
}

void TestFormula::resultsAreWrittenForPeople()
{
    QCOMPARE(shownText(millimetres(49.4)), std::string("49.4 mm"));
    QCOMPARE(shownText(millimetres(1.0 / 3.0)), std::string("0.33 mm"));
    QCOMPARE(shownText(millimetres(-0.001)), std::string("0 mm"));
    QCOMPARE(shownText(millimetres(127.0), {25.4, "in", 3, ','}), std::string("5 in"));
    QCOMPARE(shownText(millimetres(12.7), {25.4, "in", 3, ','}), std::string("0,5 in"));
    QCOMPARE(shownText(plain(7.0)), std::string("7"));
    QCOMPARE(shownText({Worth::Type::Number, kMassPowers, false, 0.25}), std::string("250 g"));
    QCOMPARE(shownText({Worth::Type::Number, kAnglePowers, false, radians(22.5)}),
             std::string("22.5°"));
}

FFF_TEST(TestFormula)
#include "tst_formula.moc"
