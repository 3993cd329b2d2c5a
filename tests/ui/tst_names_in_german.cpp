// What is drawn and opened in a German window has German names; what was stored keeps its own.
#include <QApplication>
#include <QTest>

#include "core/io/document_file.h"
#include "core/io/material_library.h"
#include "tests/test_program.h"
#include "ui/base/naming.h"
#include "ui/bench/workbench.h"
#include "ui/properties/stock_choice.h"
#include "ui/settings/settings.h"
#include "ui/view/view_style.h"

#include <QTemporaryDir>
#include <QTranslator>

#include <algorithm>

using namespace fff;
using namespace fff::ui;

namespace {

/// The window speaks it for as long as this lives.
class Language
{
public:
    explicit Language(const char *code)
    {
        m_isLoaded = m_translator.load(QStringLiteral(":/i18n/flatfitfab_") + QLatin1String(code));
        QCoreApplication::installTranslator(&m_translator);
    }
    ~Language() { QCoreApplication::removeTranslator(&m_translator); }
    bool isLoaded() const { return m_isLoaded; }

private:
    QTranslator m_translator;
    bool m_isLoaded = false;
};

/// A square, drawn in one stroke beside all others.
void drawSquare(Workbench &bench)
{
    bench.run(QStringLiteral("view.front"));
    double time = 5000.0;
    const auto send = [&](PointerEvent::Type type, double x, double y, Button button) {
        PointerEvent event;
        event.type = type;
        event.position = {x, y};
        event.button = button;
        event.time = time += 8.0;
        bench.handle(event);
    };
    send(PointerEvent::Type::Press, 300, 200, Button::Left);
    const double corners[][2] = {{300, 200}, {500, 200}, {500, 400}, {300, 400}, {300, 210}};
    for (int i = 0; i < 4; ++i) {
        for (int k = 1; k <= 10; ++k)
            send(PointerEvent::Type::Move,
                 corners[i][0] + (corners[i + 1][0] - corners[i][0]) * k / 10.0,
                 corners[i][1] + (corners[i + 1][1] - corners[i][1]) * k / 10.0, Button::None);
    }
    send(PointerEvent::Type::Release, 300, 210, Button::Left);
}

} // namespace

class TestNamesInGerman : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        Settings::setFile(m_folder.filePath(QStringLiteral("settings.ini")));
    }

    /// A German window would draw "Section 1", or English and German would count apart.
    void namesAreOfTheWindowsLanguage()
    {
        QCOMPARE(naming().section, std::string("Section %1"));
        const Language german("de");
        QVERIFY(german.isLoaded());
        const Naming names = naming();
        QCOMPARE(names.section, std::string("Scheibe %1"));
        QVERIFY(std::count(names.others.begin(), names.others.end(), "Section %1") > 0);
        QVERIFY(std::count(names.others.begin(), names.others.end(), names.section) == 0);
    }

    /// The name that is stored and the history would speak two languages.
    void aStrokeIsNamedInGerman()
    {
        const Language german("de");
        Workbench bench;
        bench.setViewport({900, 700});
        drawSquare(bench);
        const Session &session = bench.session();
        QCOMPARE(session.committed().sectionCount(), std::size_t(1));
        QCOMPARE(session.committed().section(0)->name, std::string("Scheibe 1"));
        QVERIFY2(session.history()->undoText().contains(QStringLiteral("Scheibe 1")),
                 qPrintable(session.history()->undoText()));
        QVERIFY(!session.history()->undoText().contains(QStringLiteral("Draw")));
    }

    /// A stored name is the person's: opening the file in another language must not change it.
    void storedNamesStay()
    {
        Document drawn;
        {
            Workbench english;
            english.setViewport({900, 700});
            drawSquare(english);
            drawn = english.session().committed().document;
        }
        const QString path = m_folder.filePath(QStringLiteral("drawn.fff"));
        QVERIFY(io::writeDocument(path, drawn));
        const Language german("de");
        io::ReadOptions options;
        options.naming = naming();
        const auto read = io::readDocument(path, options);
        QVERIFY(read);
        QCOMPARE(read->document.sections.front()->name, std::string("Section 1"));
    }

    void presetsAreReadInGerman_data()
    {
        QTest::addColumn<QString>("stored");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char *says, const char *stored, const char *shown) {
            QTest::newRow(says) << QString::fromUtf8(stored) << QString::fromUtf8(shown);
        };
        row("a preset", "Birch plywood", "Birkensperrholz");
        row("the second one of it", "Birch plywood 2", "Birkensperrholz 2");
        row("a preset with a number in its name", "Birch plywood 4 mm", "Birkensperrholz 4 mm");
        row("one that ends with a number", "Aluminium 6061", "Aluminium 6061");
        row("a person's own name", "Birch from Riga", "Birch from Riga");
        row("a person's own name with a number", "Riga 3", "Riga 3");
        row("a number alone", " 3", " 3");
    }

    /// A list would mix languages, or a person's own words would be changed.
    void presetsAreReadInGerman()
    {
        QFETCH(QString, stored);
        QFETCH(QString, shown);
        const Language german("de");
        Stock stock;
        stock.name = stored.toStdString();
        QCOMPARE(stockName(stock), shown);
    }

    /// Plywood that is called by its German name would be drawn as grey card.
    void germanNamesLookLikeTheirMaterial()
    {
        const Language german("de");
        for (const Material &material : io::materialLibrary()) {
            Stock named = material.stocks.front();
            named.name = stockName(named).toStdString();
            QVERIFY2(stockLook(named).face == stockLook(material.stocks.front()).face,
                     named.name.c_str());
        }
    }

private:
    QTemporaryDir m_folder;
};

FFF_TEST_WITH(TestNamesInGerman, fff::testing::runWithin<TestNamesInGerman, QApplication>)
#include "tst_names_in_german.moc"
