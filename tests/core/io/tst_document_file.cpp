// Files on disk. If this fails, a file is taken for what it is not, or a failed save destroys work.
// First: moc cannot read <numbers> before another header of the standard library.
#include <QtTest/QtTest>

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "tests/core/io/io_samples.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#ifdef Q_OS_UNIX
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

using namespace fff;
using fff::test::flatfabSquares;
using fff::test::twoSections;

class TestDocumentFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void contentDecidesTheFormat_data();
    void contentDecidesTheFormat();
    void notReadable_data();
    void notReadable();
    void endlessFileIsAnError();
    void hugeFileIsAnError();
    void documentComesBack();
    void placesUseTheGivenName();
    void optionsReachTheReader();
    void writingReplacesTheWholeFile();
    void writingNeedsAPlace_data();
    void writingNeedsAPlace();
    void fullDiskKeepsTheOldFile();
    void unreadableDocumentIsNotWritten();
    void linksStayLinks();
    void dashIsStandardOutput();
    void fullStandardOutputIsAnError();

private:
    QString put(const QString &name, const std::string &bytes) const;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

namespace {

std::string bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

} // namespace

QString TestDocumentFile::put(const QString &name, const std::string &bytes) const
{
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(bytes.data(), static_cast<qint64>(bytes.size())) < 0)
        qFatal("no place for test files");
    return file.fileName();
}

void TestDocumentFile::contentDecidesTheFormat_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<int>("sections");
    const std::string fff = io::writeFff(twoSections()).value();
    const std::string mark = "\xEF\xBB\xBF";
    QTest::newRow("fff") << QStringLiteral("a.fff") << fff << 2;
    QTest::newRow("fff called txt") << QStringLiteral("a.txt") << fff << 2;
    QTest::newRow("fff with a byte-order mark") << QStringLiteral("a.fff") << mark + fff << 2;
    QTest::newRow("fff with CR LF")
        << QStringLiteral("a.fff") << test::replaced(fff, "\n", "\r\n") << 2;
    QTest::newRow("fff after blank lines") << QStringLiteral("a.fff") << "\n\n" + fff << 2;
    QTest::newRow("FlatFab") << QStringLiteral("a.txt") << flatfabSquares(3) << 3;
    QTest::newRow("FlatFab called fff") << QStringLiteral("a.fff") << flatfabSquares(3) << 3;
    QTest::newRow("FlatFab without a suffix")
        << QStringLiteral("Fisch ä") << flatfabSquares(1) << 1;
    QTest::newRow("FlatFab with a byte-order mark")
        << QStringLiteral("a.txt") << mark + flatfabSquares(1) << 1;
}

void TestDocumentFile::contentDecidesTheFormat()
{
    QFETCH(QString, name);
    QFETCH(std::string, bytes);
    QFETCH(int, sections);
    const auto loaded = io::readDocument(put(name, bytes));
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QCOMPARE(static_cast<int>(loaded->document.sections.size()), sections);
}

void TestDocumentFile::notReadable_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<ErrorCode>("code");
    QTest::addColumn<QString>("place");
    const auto row = [this](const char *name, const QString &file, ErrorCode code,
                            const char *suffix = "") {
        QTest::newRow(name) << file << code << file + QLatin1String(suffix);
    };
    using enum ErrorCode;
    row("nothing there", path(QStringLiteral("none.fff")), CannotOpen);
    row("no path", QString(), CannotOpen);
    row("folder", m_folder.path(), CannotOpen);
    row("empty file", put(QStringLiteral("empty.fff"), ""), Truncated, ":1");
    row("only a byte-order mark", put(QStringLiteral("mark.fff"), "\xEF\xBB\xBF"), Truncated, ":1");
    row("blanks", put(QStringLiteral("blanks.txt"), " \n\n"), Truncated, ":1");
    row("picture", put(QStringLiteral("a.png"), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
        NotAModel);
    row("zeros", put(QStringLiteral("zeros.fff"), std::string(4096, '\0')), NotAModel);
    row("binary after a brace", put(QStringLiteral("b.fff"), std::string("{\0\1\2", 4)), NotAModel);
    row("letter", put(QStringLiteral("letter.txt"), "Dear Sir or Madam,\n"), NotAModel);
    row("UTF-16", put(QStringLiteral("wide.fff"), std::string("\xFF\xFE{\0\"\0", 6)), NotAModel);
    row("other JSON", put(QStringLiteral("c.json"), "{\"a\": 1}"), NotAModel);
    row("broken JSON", put(QStringLiteral("d.fff"), "{\n\n\"a\" 1}"), BadSyntax, ":3");
    row("broken FlatFab", put(QStringLiteral("e.txt"), "HeaderParameters 1\nFlatFab nan\n"),
        BadValue, ":2");
}

void TestDocumentFile::notReadable()
{
    QFETCH(QString, file);
    QFETCH(ErrorCode, code);
    QFETCH(QString, place);
    const auto loaded = io::readDocument(file);
    QVERIFY(!loaded);
    QVERIFY2(loaded.error().code == code, qPrintable(io::errorText(loaded.error())));
    QCOMPARE(QString::fromStdString(loaded.error().place), place);
}

void TestDocumentFile::endlessFileIsAnError()
{
    const QString zero = QStringLiteral("/dev/zero");
    if (!QFile::exists(zero))
        QSKIP("no such device here");
    const auto loaded = io::readDocument(zero);
    QVERIFY(!loaded);
    QVERIFY2(loaded.error().code == ErrorCode::BadCount, qPrintable(io::errorText(loaded.error())));
}

void TestDocumentFile::hugeFileIsAnError()
{
    QFile huge(path(QStringLiteral("huge.fff")));
    QVERIFY(huge.open(QIODevice::WriteOnly));
    if (!huge.resize(io::kMaxFileSize + 1)) // sparse where the file system can
        QSKIP("no room for a huge file");
    const auto loaded = io::readDocument(huge.fileName());
    QVERIFY(!loaded);
    QVERIFY(loaded.error().code == ErrorCode::BadCount);
    huge.remove();
}

void TestDocumentFile::documentComesBack()
{
    const QString file = path(QStringLiteral("Fisch – 魚.fff"));
    QVERIFY(io::writeDocument(file, twoSections()));
    const auto loaded = io::readDocument(file);
    QVERIFY(loaded && loaded->document == twoSections());
    QVERIFY(loaded->warnings.empty());
}

void TestDocumentFile::placesUseTheGivenName()
{
    const QString file = put(QStringLiteral("bad.txt"), "HeaderParameters 1\n");
    io::ReadOptions options;
    options.name = "bad.txt";
    const auto loaded = io::readDocument(file, options);
    QVERIFY(!loaded);
    QCOMPARE(io::errorText(loaded.error()),
             QStringLiteral("bad.txt:1: the file ends here, expected FlatFab n"));
}

void TestDocumentFile::optionsReachTheReader()
{
    const QString file = put(QStringLiteral("unit.txt"), flatfabSquares(1));
    io::ReadOptions options;
    options.flatfab.unitMm = 10.0;
    const auto loaded = io::readDocument(file, options);
    QVERIFY(loaded);
    QCOMPARE(loaded->document.sections.front()->frame.origin, Vec3(0, 30, 0));
}

void TestDocumentFile::writingReplacesTheWholeFile()
{
    const QString file = put(QStringLiteral("long.svg"), std::string(100000, 'x'));
    QVERIFY(io::writeFile(file, "short"));
    QCOMPARE(bytesOf(file), std::string("short"));
    QVERIFY(io::writeFile(file, ""));
    QCOMPARE(bytesOf(file), std::string());
}

void TestDocumentFile::writingNeedsAPlace_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("no such folder") << path(QStringLiteral("none/a.fff"));
    QTest::newRow("a folder") << m_folder.path();
    QTest::newRow("a file as a folder") << put(QStringLiteral("plain"), "x") + QStringLiteral("/a");
    QTest::newRow("no name") << QString();
}

void TestDocumentFile::writingNeedsAPlace()
{
    QFETCH(QString, file);
    const auto written = io::writeDocument(file, twoSections());
    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::CannotWrite);
    QCOMPARE(QString::fromStdString(written.error().place), file);
    QVERIFY(!written.error().args.at(0).empty());
}

void TestDocumentFile::fullDiskKeepsTheOldFile()
{
#ifdef Q_OS_UNIX
    const QString file = put(QStringLiteral("kept.fff"), "old");
    // A limit on the size of files stands for a disk that is full.
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit oldLimit{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &oldLimit), 0);
    rlimit limit = oldLimit;
    limit.rlim_cur = 4096;
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const auto written = io::writeFile(file, std::string(1000000, 'n'));
    const auto late = io::writeFile(file, std::string(5000, 'n')); // fails when it is flushed
    setrlimit(RLIMIT_FSIZE, &oldLimit);
    std::signal(SIGXFSZ, oldHandler);
    QVERIFY(!written && written.error().code == ErrorCode::CannotWrite);
    QVERIFY(!late && late.error().code == ErrorCode::CannotWrite);
    QCOMPARE(bytesOf(file), std::string("old"));
    QVERIFY(QDir(m_folder.path()).entryList({QStringLiteral("kept.fff*")}).size() == 1);
#else
    QSKIP("no limit on the size of files here");
#endif
}

void TestDocumentFile::unreadableDocumentIsNotWritten()
{
    const QString file = path(QStringLiteral("far.fff"));
    QVERIFY(io::writeDocument(file, twoSections()));
    Document document = twoSections();
    Frame far;
    far.origin = {2e6, 0, 0};
    document = moveSection(document, document.sections.front()->id, far).value();
    const auto written = io::writeDocument(file, document);
    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::BadValue);
    QVERIFY(io::readDocument(file).value().document == twoSections());
}

void TestDocumentFile::linksStayLinks()
{
#ifdef Q_OS_UNIX
    const QString target = put(QStringLiteral("target.fff"), "old");
    const QString link = path(QStringLiteral("link.fff"));
    QVERIFY(QFile::link(target, link));
    QVERIFY(io::writeFile(link, "new"));
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(bytesOf(target), std::string("new"));
#else
    QSKIP("symbolic links only");
#endif
}

#ifdef Q_OS_UNIX
namespace {

/// Writes to "-" while standard output goes to the file.
Result<void> writtenToOutput(const QString &file, const std::string &bytes)
{
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    const int other = open(file.toUtf8().constData(), O_WRONLY | O_CREAT, 0600);
    dup2(other, STDOUT_FILENO);
    const auto written = io::writeFile(QStringLiteral("-"), bytes);
    dup2(kept, STDOUT_FILENO);
    close(other);
    close(kept);
    return written;
}

} // namespace
#endif

void TestDocumentFile::dashIsStandardOutput()
{
#ifdef Q_OS_UNIX
    const QString file = path(QStringLiteral("output"));
    const std::string bytes = io::writeFff(twoSections()).value();
    QVERIFY(writtenToOutput(file, bytes));
    QCOMPARE(bytesOf(file), bytes);
    QVERIFY(!QFile::exists(QStringLiteral("-")));
#else
    QSKIP("no file descriptors here");
#endif
}

void TestDocumentFile::fullStandardOutputIsAnError()
{
#ifdef Q_OS_UNIX
    const QString full = QStringLiteral("/dev/full");
    if (!QFile::exists(full))
        QSKIP("no such device here");
    for (const std::size_t size : {10u, 100000u}) {
        const auto written = writtenToOutput(full, std::string(size, 'x'));
        QVERIFY(!written);
        QVERIFY(written.error().code == ErrorCode::CannotWrite);
    }
#else
    QSKIP("no file descriptors here");
#endif
}

QTEST_APPLESS_MAIN(TestDocumentFile)
#include "tst_document_file.moc"
