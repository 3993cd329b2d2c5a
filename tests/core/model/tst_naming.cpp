#include <QTest>

#include "core/model/edits.h"
#include "core/model/naming.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

const Naming kGerman{"Scheibe %1", {"Section %1"}};

Document withNames(const std::vector<std::string> &names)
{
    Document document = newDocument();
    for (const std::string &name : names) {
        NewSection section;
        section.name = name;
        section.shape = Shape::make(circle({0, 0}, 20.0)).value();
        document = addSection(document, section).value();
    }
    return document;
}

} // namespace

class TestNaming : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersGoOnPastBothLanguages_data()
    {
        QTest::addColumn<QList<QByteArray>>("names");
        QTest::addColumn<QByteArray>("free");
        const auto row = [](const char *says, const QList<QByteArray> &names, const char *free) {
            QTest::newRow(says) << names << QByteArray(free);
        };
        row("the first one", {}, "Scheibe 1");
        row("on from one's own", {"Scheibe 1", "Scheibe 2"}, "Scheibe 3");
        row("on from another language's", {"Section 1", "Section 2"}, "Scheibe 3");
        row("a number that is ahead is passed over", {"Section 3", "Body"}, "Scheibe 4");
        row("so is one's own", {"Scheibe 3", "Body"}, "Scheibe 4");
        row("both are", {"Section 4", "Scheibe 5", "Body"}, "Scheibe 6");
        row("names of a person's own leave numbers alone", {"Rib 2"}, "Scheibe 2");
        row("a name that only begins alike", {"Scheibe 22"}, "Scheibe 2");
    }

    /// Two sections with one number, which nobody can tell apart once one says it aloud.
    void numbersGoOnPastBothLanguages()
    {
        QFETCH(QList<QByteArray>, names);
        QFETCH(QByteArray, free);
        std::vector<std::string> given;
        for (const QByteArray &name : names)
            given.push_back(name.toStdString());
        QCOMPARE(QByteArray::fromStdString(freeSectionName(withNames(given), kGerman)), free);
    }

    /// The number would be lost, or a language whose word stands behind it could not be written.
    void theNumberStandsWhereThePatternHasIt()
    {
        QCOMPARE(numberedName("%1. Platte", 3), std::string("3. Platte"));
        QCOMPARE(numberedName("Scheibe", 3), std::string("Scheibe 3"));
    }

    /// Two of one name; a number where one has the word to itself; "a%1b" taken for a pattern.
    void sectionsOfOneThingHaveItsName()
    {
        const Document document = withNames({"Fish", "Fish 2"});
        using Names = std::vector<std::string>;
        QCOMPARE(namesAfter(document, "Owl", 1), Names({"Owl"}));
        QCOMPARE(namesAfter(document, "Owl", 2), Names({"Owl 1", "Owl 2"}));
        QCOMPARE(namesAfter(document, "Fish", 1), Names({"Fish 1"}));
        QCOMPARE(namesAfter(document, "Fish", 3), Names({"Fish 1", "Fish 3", "Fish 4"}));
        QCOMPARE(namesAfter(document, "a%1b", 2), Names({"a%1b 1", "a%1b 2"}));
        QCOMPARE(namesAfter(document, "", 3), Names());
    }
};

FFF_TEST(TestNaming)
#include "tst_naming.moc"
