// Runs the real program: the steps of the assembly as a PDF, as a web page and as pictures.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;

namespace {

int pageCount(const QByteArray &pdf)
{
    const QRegularExpression page(QStringLiteral("/Type\\s*/Page\\b(?!s)"));
    int count = 0;
    for (auto it = page.globalMatch(QString::fromLatin1(pdf)); it.hasNext(); it.next())
        ++count;
    return count;
}

QByteArray bytesOf(const QString &file)
{
    QFile input(file);
    return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
}

} // namespace

class tst_cli_steps : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    QStringList outputs() const
    {
        return QDir(m_folder.path()).entryList({QStringLiteral("out*")}, QDir::Files, QDir::Name);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto write = [this](const char *name, const Document &document) {
            QVERIFY(io::writeDocument(path(name), document));
        };
        write("comb.fff", combModel(4));
        write("arm.fff", underAnArm(40));
        write("furnished.fff", furnished());
        write("locked.fff", triangle());
        write("empty.fff", newDocument());
    }

    void cleanup()
    {
        for (const QString &file : outputs())
            QFile::remove(m_folder.filePath(file));
    }

    void paperHasAllSteps_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<int>("pages"); // a title, then three steps on each
        QTest::newRow("five parts") << QStringLiteral("comb.fff") << 3;
        QTest::newRow("round a corner") << QStringLiteral("arm.fff") << 2;
        QTest::newRow("two that come as one") << QStringLiteral("furnished.fff") << 3;
    }
    /// A page that is missing leaves a person with parts in the hand.
    void paperHasAllSteps()
    {
        QFETCH(QString, model);
        QFETCH(int, pages);
        const Run made = run({QStringLiteral("steps"), m_folder.filePath(model),
                              QStringLiteral("-o"), path("out.pdf")});
        QCOMPARE(made.status, 0);
        QVERIFY2(made.err.isEmpty(), made.err);
        const QByteArray pdf = bytesOf(path("out.pdf"));
        QVERIFY(pdf.startsWith("%PDF-"));
        QVERIFY(pdf.trimmed().endsWith("%%EOF"));
        QCOMPARE(pageCount(pdf), pages);
    }

    /// For another program.
    void paperGoesToStandardOutput()
    {
        const Run made =
            run({QStringLiteral("steps"), path("comb.fff"), QStringLiteral("-o"),
                 QStringLiteral("-"), QStringLiteral("--paper"), QStringLiteral("letter")});
        QCOMPARE(made.status, 0);
        QVERIFY(made.out.startsWith("%PDF-"));
        QVERIFY(made.out.contains("/MediaBox [0 0 612"));
        QVERIFY(outputs().isEmpty());
    }

    /// Each picture shows another step, or they explain nothing.
    void picturesAreOneAStep()
    {
        const Run made = run({QStringLiteral("steps"), path("comb.fff"), QStringLiteral("-o"),
                              path("out.png"), QStringLiteral("--size"), QStringLiteral("320x200"),
                              QStringLiteral("--view"), QStringLiteral("iso2")});
        QVERIFY2(made.status == 0 && made.err.isEmpty(), made.err);
        const QStringList files = outputs();
        QCOMPARE(files.join(u' '),
                 QStringLiteral("out-01.png out-02.png out-03.png out-04.png out-05.png"));
        QImage before;
        for (const QString &file : files) {
            const QImage image(m_folder.filePath(file));
            QCOMPARE(image.size(), QSize(320, 200));
            QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
            QVERIFY(image != before);
            before = image;
        }
    }

    /// Wrong: there is no model in the page, or no picture where a browser cannot show that; or it
    /// is too large to be sent to a phone; or changed although nothing did.
    void thePageHasModelAndPictures()
    {
        const auto page = [this] {
            const Run made =
                run({QStringLiteral("steps"), QStringLiteral(FFF_SAMPLES "/bridge.fff"),
                     QStringLiteral("-o"), path("out.html")});
            return made.status == 0 && made.err.isEmpty() ? bytesOf(path("out.html"))
                                                          : QByteArray();
        };
        const QByteArray bytes = page();
        QVERIFY(bytes.startsWith("<!DOCTYPE html>"));
        QVERIFY(bytes.endsWith("</html>\n"));
        QVERIFY(bytes.contains("<title>bridge</title>"));
        QCOMPARE(bytes.count("<img "), 28);
        QCOMPARE(bytes.count("<tr>"), 29);
        QVERIFY2(bytes.size() < 2'000'000, QByteArray::number(bytes.size()));
        QVERIFY(bytes == page());
    }

    /// Pictures are for browsers without WebGL; the model itself needs no display here.
    void aPageNeedsNoDisplay()
    {
        const Run made =
            run({QStringLiteral("steps"), path("comb.fff"), QStringLiteral("-o"), path("out.html")},
                false);
        const QByteArray bytes = bytesOf(path("out.html"));
        if (made.status == 4 && outputs().isEmpty())
            QSKIP("built without three.js: there are only pictures");
        QVERIFY2(made.status == 0 && made.err.isEmpty(), made.err);
        QCOMPARE(bytes.count("<img "), 0);
        QVERIFY(bytes.contains("There are no pictures"));
    }

    void whatCannotBeAssembledHasNoSteps_data()
    {
        QTest::addColumn<QString>("output");
        QTest::newRow("on paper") << QStringLiteral("out.pdf");
        QTest::newRow("as a page") << QStringLiteral("out.html");
        QTest::newRow("as pictures") << QStringLiteral("out.png");
    }
    /// Steps of a model that cannot be put together would be a lie.
    void whatCannotBeAssembledHasNoSteps()
    {
        QFETCH(QString, output);
        const Run made = run({QStringLiteral("steps"), path("locked.fff"), QStringLiteral("-o"),
                              m_folder.filePath(output)});
        QCOMPARE(made.status, 3);
        QCOMPARE(made.err.count('\n'), 1);
        QVERIFY2(made.err.contains("cannot be assembled"), made.err);
        QVERIFY(outputs().isEmpty());
    }

    void wrongUseIsSaid_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        const auto row = [](const char *name, const char *arguments, int status) {
            QTest::newRow(name) << QString::fromLatin1(arguments).split(u' ', Qt::SkipEmptyParts)
                                << status;
        };
        row("no output", "comb.fff", 1);
        row("a kind that is none", "comb.fff -o out.svg", 1);
        row("pixels of paper", "comb.fff -o out.pdf --size 100x100", 1);
        row("paper of pixels", "comb.fff -o out.png --paper a4", 1);
        row("pixels of a page", "comb.fff -o out.html --size 100x100", 1);
        row("paper of a page", "comb.fff -o out.html --paper a4", 1);
        row("paper that no printer holds", "comb.fff -o out.pdf --paper a11", 1);
        row("a view from nowhere", "comb.fff -o out.pdf --view above", 1);
        row("no section", "empty.fff -o out.pdf", 2);
        row("no model", "none.fff -o out.pdf", 2);
        row("no folder", "comb.fff -o nowhere/out.pdf", 4);
        row("no folder for a page", "comb.fff -o nowhere/out.html", 4);
        row("no folder for pictures", "comb.fff -o nowhere/out.png", 4);
    }
    void wrongUseIsSaid()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        for (QString &argument : arguments) {
            if (argument.contains(u'.') && !argument.startsWith(u'-'))
                argument = m_folder.filePath(argument);
        }
        const Run made = run(QStringList(QStringLiteral("steps")) + arguments);
        QCOMPARE(made.status, status);
        QVERIFY(!made.err.isEmpty());
        QVERIFY(outputs().isEmpty());
    }

    /// Pictures come from the renderer, and without a display there is none.
    void withoutADisplayItSaysSo()
    {
        const Run made =
            run({QStringLiteral("steps"), path("comb.fff"), QStringLiteral("-o"), path("out.pdf")},
                false);
        QCOMPARE(made.status, 4);
        QCOMPARE(made.err.count('\n'), 1);
        QVERIFY(made.err.contains("display"));
        QVERIFY(outputs().isEmpty());
    }
};

FFF_TEST(tst_cli_steps)
#include "tst_cli_steps.moc"
