// The pictures of the help and of the README show the program as it is: each is made anew as
// resources/help/pictures.txt has it, and compared.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/app/cli_run.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <cmath>

using namespace fff::test;

namespace {

const QDir &helpFolder()
{
    static const QDir folder(QStringLiteral(FFF_RESOURCES "/help"));
    return folder;
}

/// Those that there are pages in, beside English.
QStringList languages()
{
    return helpFolder().entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

QStringList englishPages()
{
    return helpFolder().entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name);
}

QString textOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Mean difference of two pictures' colours, 0 … 255: another driver draws edges a little
/// otherwise.
double differenceOf(const QImage &a, const QImage &b)
{
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            sum += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                   std::abs(p.blue() - q.blue());
        }
    return sum / (3.0 * a.width() * a.height());
}

constexpr double kStale = 1.5; // of 255

} // namespace

class tst_help_pictures : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isAsItWasDrawn_data()
    {
        QTest::addColumn<QStringList>("words");
        const QString recipes = textOf(helpFolder().filePath(QStringLiteral("pictures.txt")));
        for (const QString &line : recipes.split(u'\n', Qt::SkipEmptyParts))
            if (!line.startsWith(u'#'))
                QTest::newRow(qPrintable(line.section(u' ', 0, 0)))
                    << line.simplified().split(u' ');
    }
    /// To make them anew: packaging/pictures.
    void isAsItWasDrawn()
    {
        QFETCH(QStringList, words);
        const QString name = words.takeFirst();
        QTemporaryDir folder;
        words[1].prepend(QStringLiteral(FFF_RESOURCES "/../"));
        words += {QStringLiteral("-o"), folder.filePath(name)};
        const Run done = run(words);
        QVERIFY2(done.status == 0, done.err.constData());
        const QStringList made = QDir(folder.path()).entryList(QDir::Files);
        QVERIFY(!made.isEmpty());
        for (const QString &file : made) {
            const QString is = QDir(folder.path()).filePath(file);
            const QString was = helpFolder().filePath(file);
            QVERIFY2(QFile::exists(was), qPrintable(was));
            if (!file.endsWith(QStringLiteral(".png"))) {
                QCOMPARE(textOf(is), textOf(was));
                continue;
            }
            const QImage now(is), then(was);
            QCOMPARE(now.size(), then.size());
            const double difference = differenceOf(now, then);
            QVERIFY2(difference <= kStale,
                     qPrintable(QStringLiteral("%1 is stale, by %2").arg(file).arg(difference)));
        }
    }

    /// Pages name pictures and pages that are there, and the README none that are not.
    void linksLeadSomewhere_data()
    {
        QTest::addColumn<QString>("page");
        QStringList pages{QStringLiteral("/../README.md")};
        for (const QString &page : englishPages()) {
            pages += QStringLiteral("/help/") + page;
            for (const QString &language : languages())
                pages += QStringLiteral("/help/%1/%2").arg(language, page);
        }
        for (const QString &page : pages)
            QTest::newRow(qPrintable(page)) << QStringLiteral(FFF_RESOURCES) + page;
    }
    void linksLeadSomewhere()
    {
        QFETCH(QString, page);
        const QString text = textOf(page);
        QVERIFY(!text.isEmpty());
        const QRegularExpression link(
            QStringLiteral("\\]\\(([^)#:]+)\\)|src=\"([^\":]+)\"")); // not of the web
        for (auto it = link.globalMatch(text); it.hasNext();) {
            const QRegularExpressionMatch match = it.next();
            const QString target = match.captured(1) + match.captured(2);
            QVERIFY2(QFileInfo(page).dir().exists(target), qPrintable(target));
        }
    }

    /// A page that was changed in one language alone tells others what is no longer so: each has
    /// the same headings, entries, pictures and keys as the English one, in the same order.
    void pagesSayTheSame_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("page");
        for (const QString &language : languages())
            for (const QString &page : englishPages())
                QTest::newRow(qPrintable(language + u' ' + page)) << language << page;
    }
    void pagesSayTheSame()
    {
        QFETCH(QString, language);
        QFETCH(QString, page);
        const auto skeleton = [](const QString &path) {
            static const QRegularExpression mark(
                QStringLiteral("^(#+) |^(-) |\\(([^)#:*]+)\\)|\\*\\*([A-Z]|F\\d+)\\*\\*"),
                QRegularExpression::MultilineOption);
            QStringList marks;
            const QString text = textOf(path);
            for (auto it = mark.globalMatch(text); it.hasNext();) {
                const QRegularExpressionMatch found = it.next();
                const QString link = found.captured(3).section(u'/', -1);
                if (found.captured(3).isEmpty() || link.contains(u'.')) // else words in parentheses
                    marks += found.captured(1) + found.captured(2) + link + found.captured(4);
            }
            return marks;
        };
        const QStringList english = skeleton(helpFolder().filePath(page));
        QVERIFY(english.size() > 8);
        QCOMPARE(skeleton(helpFolder().filePath(language + u'/' + page)), english);
    }
};

FFF_TEST(tst_help_pictures)
#include "tst_help_pictures.moc"
