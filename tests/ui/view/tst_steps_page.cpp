// The page of the steps: what is in it, and that nothing in a document can harm who opens it.
#include <QGuiApplication>
#include <QTest>

#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "ui/view/steps_page.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

#include <set>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

AssemblyStepsPointer stepsOf(Document document)
{
    AnalysisCaches caches;
    const AnalysisPointer analysis = analyseNext(evaluate(std::move(document)), caches);
    return assemblySteps(analysis, planOf(*analysis, {}));
}

Document named(Document document, const std::string &name)
{
    Section section = *document.sections.front();
    section.name = name;
    document.sections.front() = std::make_shared<const Section>(std::move(section));
    return document;
}

/// Without pictures, as on a display that makes none, whatever there is here.
QByteArray pageOf(const AssemblyStepsPointer &steps, const QString &title)
{
    StepsPage::Options options;
    options.title = title;
    StepPictures pictures(steps, Camera());
    return StepsPage(pictures, options, Camera()).take();
}

QByteArray between(const QByteArray &page, const QByteArray &from, const QByteArray &to)
{
    const qsizetype begin = page.indexOf(from) + from.size();
    return page.mid(begin, page.indexOf(to, begin) - begin);
}

QJsonObject dataOf(const QByteArray &page)
{
    return QJsonDocument::fromJson(
               between(page, "<script type=\"application/json\" id=\"data\">", "</script>"))
        .object();
}

qsizetype numbersIn(const QJsonValue &base64, qsizetype size)
{
    return QByteArray::fromBase64(base64.toString().toLatin1()).size() / size;
}

} // namespace

class TestStepsPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        if (!StepsPage::hasModel())
            QSKIP("built without three.js");
    }

    /// Wrong: a step or a part is lost between the plan and the page.
    void everyPartAndStepIsInIt()
    {
        const AssemblyStepsPointer steps = stepsOf(combModel(4));
        const QJsonObject data = dataOf(pageOf(steps, QStringLiteral("Comb")));
        const QJsonArray parts = data[QStringLiteral("parts")].toArray();
        QCOMPARE(parts.size(), 5);
        std::set<int> moved;
        const QJsonArray all = data[QStringLiteral("steps")].toArray();
        QCOMPARE(all.size(), steps->playback.stepCount());
        for (int i = 0; i < all.size(); ++i) {
            const QJsonObject step = all[i].toObject();
            QCOMPARE(step[QStringLiteral("title")].toString(), stepTitle(*steps, i));
            QCOMPARE(std::size_t(step[QStringLiteral("way")].toArray().size()),
                     steps->playback.way(i).size());
            for (const QJsonValue &part : step[QStringLiteral("parts")].toArray())
                moved.insert(part.toInt());
        }
        QCOMPARE(moved.size(), std::size_t(5));
        for (int i = 0; i < parts.size(); ++i)
            QCOMPARE(parts[i].toObject()[QStringLiteral("number")].toInt(), i + 1);
    }

    /// Wrong: a part is nothing to see, or what is equal is written again and again.
    void shapesHaveTrianglesAndAreShared()
    {
        const QJsonObject data = dataOf(pageOf(stepsOf(combModel(4)), QStringLiteral("Comb")));
        const QJsonArray shapes = data[QStringLiteral("shapes")].toArray();
        QCOMPARE(shapes.size(), 2); // the spine, and four equal ribs
        for (const QJsonValue &value : shapes) {
            const QJsonObject shape = value.toObject();
            const qsizetype corners = numbersIn(shape[QStringLiteral("triangles")], 2);
            QVERIFY(corners > 0 && corners % 3 == 0);
            QVERIFY(numbersIn(shape[QStringLiteral("points")], 4) >= 8); // with its slits
            QCOMPARE(shape[QStringLiteral("unit")].toDouble(), 0.01);
        }
    }

    /// Wrong: what was exported twice looks changed to whoever keeps it under version control.
    void theSameInputGivesTheSameBytes()
    {
        const auto page = [] { return pageOf(stepsOf(eggCrate(2, 3)), QStringLiteral("Crate")); };
        QCOMPARE(page(), page());
    }

    /// Wrong: whoever opens a model of somebody else runs that one's code.
    void whatTheDocumentSaysIsText()
    {
        const QString evil =
            QStringLiteral("</script><script>alert(1)</script><!-- & \"{{data}}\"");
        const AssemblyStepsPointer steps = stepsOf(named(combModel(2), evil.toStdString()));
        const QByteArray page = pageOf(steps, evil);
        const QByteArray plain = pageOf(stepsOf(combModel(2)), QStringLiteral("Comb"));
        for (const char *tag : {"<script", "</script", "<!--", "alert(1)</script>"}) {
            const bool isOurs = QByteArray(tag) != "alert(1)</script>";
            QCOMPARE(page.count(tag), isOurs ? plain.count(tag) : 0);
        }
        QCOMPARE(between(page, "<title>", "</title>"), evil.toHtmlEscaped().toUtf8());
        // And is still there, letter by letter.
        const QJsonObject first = dataOf(page)[QStringLiteral("steps")].toArray()[0].toObject();
        QVERIFY(first[QStringLiteral("text")].toString().contains(evil));
    }

    /// Wrong: it does not open without a network, or fetches something from somebody.
    void nothingIsFetched()
    {
        const QByteArray page = pageOf(stepsOf(combModel(2)), QStringLiteral("Comb"));
        QVERIFY(page.contains("default-src 'none'"));
        for (const char *from : {"<link", "<iframe", "src=\"http", "src=\"//", "@import", "eval("})
            QCOMPARE(page.count(from), 0);
        QVERIFY(page.contains("Permission is hereby granted")); // as three.js asks for
    }

    /// Wrong: where no picture can be made there is no page at all, or one that keeps quiet.
    void withoutPicturesItSaysSo()
    {
        const AssemblyStepsPointer steps = stepsOf(combModel(3));
        const QByteArray page = pageOf(steps, QStringLiteral("Comb"));
        QCOMPARE(page.count("<img"), 0);
        QVERIFY(page.contains("There are no pictures"));
        QCOMPARE(page.count("<li>"), steps->playback.stepCount());
        QCOMPARE(between(page, "<tbody>", "</tbody>").count("<tr>"), 4);
    }

    /// Wrong: parts larger than 16 bits of hundredths of a millimetre are cut off.
    void largePartsKeepTheirSize()
    {
        Document document =
            withSection(newDocument(), polygonShape(rectangle(0, 0, 1400, 300)), front());
        document = withSection(std::move(document), polygonShape(rectangle(-200, 100, 200, 500)),
                               side(700));
        const QJsonObject data = dataOf(pageOf(stepsOf(document), QStringLiteral("Large")));
        const QJsonObject shape = data[QStringLiteral("shapes")].toArray()[0].toObject();
        const QByteArray bytes =
            QByteArray::fromBase64(shape[QStringLiteral("points")].toString().toLatin1());
        int least = 0, most = 0;
        for (qsizetype i = 0; i + 4 <= bytes.size(); i += 4) {
            const int x = qFromLittleEndian<qint16>(bytes.constData() + i);
            least = std::min(least, x);
            most = std::max(most, x);
        }
        const double unit = shape[QStringLiteral("unit")].toDouble();
        QVERIFY(std::abs((most - least) * unit - 1400.0) < 0.1);
    }
};

FFF_TEST_WITH(TestStepsPage, fff::testing::runWithin<TestStepsPage, QGuiApplication>)
#include "tst_steps_page.moc"
