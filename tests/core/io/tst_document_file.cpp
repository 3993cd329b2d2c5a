// Files on disk. If this fails, a file is taken for what it is not, or a failed save destroys work.
// First: moc cannot read <numbers> before another header of the standard library.
#include <QtTest/QtTest>

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "tests/core/io/io_samples.h"
#include "tests/test_program.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>

#include <thread>

#ifdef Q_OS_UNIX
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
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
    void aPipeIsReadToItsEnd();
    void aPipeThatNobodyWritesIntoIsGivenUp();
    void aPipeThatNobodyReadsIsGivenUp();
    void aFileNeedsAName();
    void hugeFileIsAnError();
    void documentComesBack();
    void placesUseTheGivenName();
    void optionsReachTheReader();
    void writingReplacesTheWholeFile();
    void writingNeedsAPlace_data();
    void writingNeedsAPlace();
    void fullDiskKeepsTheOldFile();
    void unreadableDocumentIsNotWritten();
    void aFullDiskSaysSo_data();
    void aFullDiskSaysSo();
    void readOnlySaysSo_data();
    void readOnlySaysSo();
    void anUnreadableFileSaysSo();
    void permissionsStay();
    void devicesStayDevices();
    void theLastVersionIsKept_data();
    void theLastVersionIsKept();
    void aFailedSaveKeepsTheBackup();
    void linksStayLinks_data();
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

// Wrong: what another program makes could not be handed over without a file.
void TestDocumentFile::aPipeIsReadToItsEnd()
{
#ifdef Q_OS_UNIX
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    const std::string bytes(300'000, 'x'); // more than a pipe holds
    std::thread writer([&] {
        QFile file(path);
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    });
    const Result<std::string> read = io::readFile(path);
    writer.join();
    QVERIFY2(read, read ? "" : qPrintable(io::errorText(read.error())));
    QVERIFY(*read == bytes);
#endif
}

// Wrong: the program would hang until it is killed.
void TestDocumentFile::aPipeThatNobodyWritesIntoIsGivenUp()
{
#ifdef Q_OS_UNIX
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    const Result<std::string> read = io::readFile(path, "pipe");
    QVERIFY(!read);
    QCOMPARE(io::errorText(read.error()),
             QStringLiteral("pipe: could not be opened: nothing is writing to this pipe"));
#endif
}

// Wrong: an export into it would hang until it is killed.
void TestDocumentFile::aPipeThatNobodyReadsIsGivenUp()
{
#ifdef Q_OS_UNIX
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    const Result<void> written = io::writeFile(path, "x");
    QVERIFY(!written);
    QCOMPARE(io::errorSentence(written.error()),
             QStringLiteral("could not be written: nothing is reading from this pipe"));
#endif
}

// Wrong: an empty variable in a script would end in words about engines of the file system.
void TestDocumentFile::aFileNeedsAName()
{
    const Result<std::string> read = io::readFile({});
    QVERIFY(!read);
    QCOMPARE(io::errorText(read.error()),
             QStringLiteral("could not be opened: a file needs a name"));
    const Result<void> written = io::writeFile({}, "x");
    QVERIFY(!written);
    QCOMPARE(io::errorText(written.error()),
             QStringLiteral("could not be written: a file needs a name"));
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
    options.values["unit-mm"] = 10.0;
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

#ifdef Q_OS_UNIX
namespace {

/// Somebody without rights, while it lives: for root no permission is missing.
class Nobody
{
public:
    Nobody() : m_isRoot(getuid() == 0)
    {
        constexpr uid_t nobody = 65534;
        if (m_isRoot)
            m_works = setresuid(nobody, nobody, 0) == 0;
    }
    ~Nobody()
    {
        if (m_isRoot && m_works && setresuid(0, 0, 0) != 0)
            qFatal("no way back to root");
    }
    bool works() const { return m_works; }

private:
    bool m_isRoot;
    bool m_works = true;
};

/// What a save that fails must leave: the old file, and nothing beside it.
void verifyKept(const QString &file, const Result<void> &written, const QString &reason)
{
    QVERIFY(!written);
    QVERIFY2(written.error().code == ErrorCode::CannotWrite,
             qPrintable(io::errorText(written.error())));
    QCOMPARE(io::errorSentence(written.error()), QStringLiteral("could not be written: ") + reason);
    QCOMPARE(test::unclear(written.error()), QString());
    QCOMPARE(bytesOf(file), std::string("old"));
}

} // namespace

void TestDocumentFile::aFullDiskSaysSo_data()
{
    QTest::addColumn<int>("size");
    QTest::newRow("a file larger than the disk") << 1'000'000;
    QTest::newRow("a file that just does not fit") << 70'000;
}

/// On a disk of 64 KiB in a name space of its own, where that is allowed. The program is this one.
void TestDocumentFile::aFullDiskSaysSo()
{
    QFETCH(int, size);
    const QString disk = path(QStringLiteral("disk"));
    QVERIFY(QDir().mkpath(disk));
    const QString commands = QStringLiteral("mount -t tmpfs -o size=64k none '%1' || exit 77\n"
                                            "printf old >'%1/a.fff'\n"
                                            "'%2' tst_document_file --write '%1/a.fff' %3\n"
                                            "cat '%1/a.fff'; ls '%1'")
                                 .arg(disk, QCoreApplication::applicationFilePath())
                                 .arg(size);
    QProcess process;
    process.start(QStringLiteral("unshare"),
                  {QStringLiteral("--mount"), QStringLiteral("--map-root-user"),
                   QStringLiteral("sh"), QStringLiteral("-c"), commands});
    if (!process.waitForStarted() || !process.waitForFinished() || process.exitCode() != 0)
        QSKIP("no disk can be mounted here");
    QCOMPARE(process.readAllStandardOutput(),
             QByteArray("could not be written: the disk is full\nolda.fff\n"));
}

void TestDocumentFile::readOnlySaysSo_data()
{
    QTest::addColumn<int>("fileMode");
    QTest::addColumn<int>("folderMode");
    QTest::addColumn<QString>("reason");
    QTest::newRow("a file") << 0444 << 0777 << QStringLiteral("this file is read-only");
    QTest::newRow("a folder") << 0666 << 0555 << QStringLiteral("this folder is read-only");
    QTest::newRow("both") << 0444 << 0555 << QStringLiteral("this file is read-only");
}

void TestDocumentFile::readOnlySaysSo()
{
    QFETCH(int, fileMode);
    QFETCH(int, folderMode);
    QFETCH(QString, reason);
    chmod(QFile::encodeName(m_folder.path()).constData(), 0755);
    const QString folder = path(QStringLiteral("locked %1 %2").arg(fileMode).arg(folderMode));
    QVERIFY(QDir().mkpath(folder));
    const QString file = put(folder.section(u'/', -1) + QStringLiteral("/a.fff"), "old");
    chmod(QFile::encodeName(file).constData(), static_cast<mode_t>(fileMode));
    chmod(QFile::encodeName(folder).constData(), static_cast<mode_t>(folderMode));
    {
        const Nobody nobody;
        if (!nobody.works())
            QSKIP("root cannot become somebody else here");
        io::WriteOptions options;
        options.keepsBackup = true;
        verifyKept(file, io::writeFile(file, "new", options), reason);
        verifyKept(file, io::writeDocument(file, twoSections()), reason);
    }
    chmod(QFile::encodeName(folder).constData(), 0755);
    QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden),
             QStringList(QStringLiteral("a.fff")));
}

void TestDocumentFile::anUnreadableFileSaysSo()
{
    chmod(QFile::encodeName(m_folder.path()).constData(), 0755);
    const QString file = put(QStringLiteral("secret.fff"), "old");
    chmod(QFile::encodeName(file).constData(), 0000);
    const Nobody nobody;
    if (!nobody.works())
        QSKIP("root cannot become somebody else here");
    const auto loaded = io::readDocument(file);
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, ErrorCode::CannotOpen);
    QCOMPARE(test::unclear(loaded.error()), QString());
}

void TestDocumentFile::permissionsStay()
{
    const QString file = put(QStringLiteral("shared.fff"), "old");
    for (const mode_t mode : {0600u, 0640u, 0664u, 0755u}) {
        chmod(QFile::encodeName(file).constData(), mode);
        QVERIFY(io::writeFile(file, "new"));
        struct stat info = {};
        QCOMPARE(stat(QFile::encodeName(file).constData(), &info), 0);
        QCOMPARE(static_cast<int>(info.st_mode & 0777u), static_cast<int>(mode));
    }
}

void TestDocumentFile::devicesStayDevices()
{
    const QString pipe = path(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    // Open for both, so that the writer need not wait for a reader.
    const int reader = open(QFile::encodeName(pipe).constData(), O_RDWR | O_NONBLOCK);
    QVERIFY(reader >= 0);
    QVERIFY(io::writeFile(pipe, "through"));
    char buffer[16] = {};
    QCOMPARE(read(reader, buffer, sizeof buffer), ssize_t(7));
    close(reader);
    QCOMPARE(QByteArray(buffer), QByteArray("through"));
    QVERIFY2(!QFileInfo(pipe).isFile(), "a file would have taken its place");

    const QString full = QStringLiteral("/dev/full");
    if (!QFile::exists(full))
        QSKIP("no such device here");
    const auto written = io::writeFile(full, "x");
    QVERIFY(!written);
    QCOMPARE(io::errorSentence(written.error()),
             QStringLiteral("could not be written: the disk is full"));
    QVERIFY(!QFileInfo(full).isFile());
}

void TestDocumentFile::theLastVersionIsKept_data()
{
    QTest::addColumn<bool>("keeps");
    QTest::newRow("kept when asked for") << true;
    QTest::newRow("not kept otherwise") << false;
}

void TestDocumentFile::theLastVersionIsKept()
{
    QFETCH(bool, keeps);
    const QString file = path(keeps ? QStringLiteral("kept.fff") : QStringLiteral("single.fff"));
    QFile::remove(file); // other tests have files of these names, too
    const QString backup = io::backupPath(file);
    QCOMPARE(backup, file + QLatin1Char('~'));
    io::WriteOptions options;
    options.keepsBackup = keeps;
    QVERIFY(io::writeFile(file, "1", options));
    QVERIFY2(!QFile::exists(backup), "there was nothing before");
    QVERIFY(io::writeFile(file, "2", options));
    QVERIFY(io::writeFile(file, "3", options));
    QCOMPARE(bytesOf(file), std::string("3"));
    QCOMPARE(bytesOf(backup), std::string(keeps ? "2" : ""));
    QCOMPARE(QFile::exists(backup), keeps);
    const QString name = QFileInfo(file).fileName();
    QCOMPARE(QDir(m_folder.path()).entryList({name + u'*'}).size(), keeps ? 2 : 1);
}

void TestDocumentFile::aFailedSaveKeepsTheBackup()
{
    const QString file = put(QStringLiteral("b.fff"), "old");
    const QString backup = put(QStringLiteral("b.fff~"), "older");
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit oldLimit{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &oldLimit), 0);
    rlimit limit = oldLimit;
    limit.rlim_cur = 4096;
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &limit), 0);
    io::WriteOptions options;
    options.keepsBackup = true;
    const auto written = io::writeFile(file, std::string(100'000, 'n'), options);
    setrlimit(RLIMIT_FSIZE, &oldLimit);
    std::signal(SIGXFSZ, oldHandler);
    QVERIFY(!written);
    QCOMPARE(bytesOf(file), std::string("old"));
    QCOMPARE(bytesOf(backup), std::string("older"));
}

void TestDocumentFile::linksStayLinks_data()
{
    QTest::addColumn<bool>("exists");
    QTest::addColumn<int>("links");
    QTest::newRow("to a file") << true << 1;
    QTest::newRow("to a link to a file") << true << 2;
    QTest::newRow("to a file that is not there yet") << false << 1;
    QTest::newRow("to a link to a file that is not there yet") << false << 2;
}

void TestDocumentFile::linksStayLinks()
{
    QFETCH(bool, exists);
    QFETCH(int, links);
    const QString number = QString::number(10 * links + (exists ? 1 : 0));
    const QString target = path(QStringLiteral("target") + number);
    if (exists)
        put(QFileInfo(target).fileName(), "old");
    QString last = target;
    for (int i = 0; i < links; ++i) {
        const QString link = path(QStringLiteral("link%1-%2").arg(number).arg(i));
        // By its name only, as it is seen from the link's folder.
        QCOMPARE(symlink(QFile::encodeName(QFileInfo(last).fileName()).constData(),
                         QFile::encodeName(link).constData()),
                 0);
        last = link;
    }
    io::WriteOptions options;
    options.keepsBackup = true;
    QVERIFY(io::writeFile(last, "new", options));
    for (int i = 0; i < links; ++i)
        QVERIFY(QFileInfo(path(QStringLiteral("link%1-%2").arg(number).arg(i))).isSymLink());
    QVERIFY(!QFileInfo(target).isSymLink());
    QCOMPARE(bytesOf(target), std::string("new"));
    QCOMPARE(bytesOf(io::backupPath(target)), std::string(exists ? "old" : ""));
}
#endif

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

/// "--write FILE SIZE" writes so many bytes and says how it went: for aFullDiskSaysSo.
FFF_TEST_WITH(TestDocumentFile, [](int argc, char *argv[]) {
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QStringLiteral("--write")) {
        const auto written =
            io::writeFile(arguments.value(2), std::string(arguments.value(3).toULongLong(), 'n'));
        std::puts(written ? "written" : qPrintable(io::errorSentence(written.error())));
        return 0;
    }
    TestDocumentFile test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_document_file.moc"
