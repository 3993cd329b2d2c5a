// Models with pictures and meshes on disk. If this fails, one of them is lost, or a file that was
// made to do harm does some.
// First: moc cannot read <numbers> before another header of the standard library.
#include <QtTest/QtTest>

#include "core/io/archive.h"
#include "core/io/document_file.h"
#include "core/io/fff_file.h"
#include "core/io/fff_format.h"
#include "tests/core/io/io_samples.h"
#include "tests/core/io/made_archive.h"
#include "tests/test_program.h"

#include <QtCore/QTemporaryDir>

#include <random>

using namespace fff;
using fff::test::MadeArchive;
using fff::test::MadeEntry;
using fff::test::twoSections;

namespace {

const std::string kDocument = "document.json";

/// Of any size, and so that nothing makes it smaller.
std::string noise(std::size_t size, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::string bytes(size, '\0');
    for (char &byte : bytes)
        byte = static_cast<char>(random() & 0xFFu);
    return bytes;
}

std::string nameOf(const std::string &bytes)
{
    return "blobs/" + io::sha256Of(bytes);
}

std::string textWith(const std::vector<std::string> &blobs)
{
    Document document = twoSections();
    for (const std::string &bytes : blobs)
        document = addBlob(std::move(document), io::makeBlob(bytes));
    return io::writeFff(document).value();
}

MadeEntry documentWith(const std::vector<std::string> &blobs)
{
    return MadeEntry::packedOf(kDocument, textWith(blobs));
}

MadeEntry blob(const std::string &bytes)
{
    return MadeEntry::stored(nameOf(bytes), bytes);
}

MadeEntry named(std::string name)
{
    return MadeEntry::stored(std::move(name), "bytes");
}

template <class Change>
MadeEntry changed(MadeEntry entry, Change change)
{
    change(entry);
    return entry;
}

void addColumns()
{
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<ErrorCode>("code");
    QTest::addColumn<std::string>("place"); // behind "a.fff"
}

void row(const char *name, const std::string &bytes, ErrorCode code, const std::string &place = {})
{
    QTest::newRow(name) << bytes << code << place;
}

Document withBlobs()
{
    Document document = addBlob(twoSections(), io::makeBlob("solid ship", "model/stl", "ship.stl"));
    document = addBlob(std::move(document), io::makeBlob(noise(70'000), "image/png", "fish.png"));
    return addBlob(std::move(document), io::makeBlob(""));
}

} // namespace

class TestFffFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theHashIsThatOfTheStandard();
    void blobsAreKeptOnceAndInOrder();
    void blobsComeBack();
    void withoutBlobsItIsText();
    void theSameBytesEveryTime();
    void whatIsInThere();
    void whatCannotBeMadeSmallIsStored();
    void zerosCanBeReadAgain();
    void tooMuchIsNotWritten();
    void textAloneIsNotHalfRead();
    void aFileOnDisk();
    void madeArchivesAreRead();
    void packedAgainByOthers_data();
    void packedAgainByOthers();
    void hostile_data();
    void hostile();
    void tooMuch_data();
    void tooMuch();
    void cutOffAnywhere();
    void anyByteChanged();
};

void TestFffFile::theHashIsThatOfTheStandard()
{
    // FIPS 180-2, appendix B.1
    QCOMPARE(io::sha256Of("abc"),
             std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
    QVERIFY(io::isSha256(io::sha256Of("")));
    QVERIFY(!io::isSha256(std::string(64, 'A')));
    QVERIFY(!io::isSha256(std::string(63, 'a')));
}

void TestFffFile::blobsAreKeptOnceAndInOrder()
{
    Document document = withBlobs();
    QCOMPARE(document.blobs.size(), 3u);
    QVERIFY(std::is_sorted(document.blobs.begin(), document.blobs.end(),
                           [](const auto &a, const auto &b) { return a->sha256 < b->sha256; }));
    const Document again = addBlob(document, io::makeBlob("solid ship", "", "another name"));
    QVERIFY2(again.isSame(document), "its bytes are there");
    QVERIFY(!document.isSame(twoSections()));
    QVERIFY(!(document == twoSections()));
    const Blob *ship = document.findBlob(io::sha256Of("solid ship"));
    QVERIFY(ship && ship->name == "ship.stl");
    QVERIFY(!document.findBlob(io::sha256Of("no ship")));
}

void TestFffFile::blobsComeBack()
{
    const Document document = withBlobs();
    const auto loaded = io::readFffFile(io::writeFffFile(document).value(), "a.fff");
    QVERIFY2(loaded, loaded ? "" : qPrintable(io::errorText(loaded.error())));
    QVERIFY(loaded->warnings.empty());
    QVERIFY(loaded->document == document);
    for (const BlobPointer &blob : document.blobs)
        QVERIFY(*loaded->document.findBlob(blob->sha256)->bytes == *blob->bytes);
}

void TestFffFile::withoutBlobsItIsText()
{
    const std::string text = io::writeFff(twoSections()).value();
    QCOMPARE(io::writeFffFile(twoSections()).value(), text);
    QVERIFY2(text.find("blobs") == std::string::npos, "nothing was added to it");
    QVERIFY(io::readFffFile(text, "a.fff").value().document == twoSections());
}

void TestFffFile::theSameBytesEveryTime()
{
    const std::string bytes = io::writeFffFile(withBlobs()).value();
    QCOMPARE(io::writeFffFile(withBlobs()).value(), bytes);
    const Document again = io::readFffFile(bytes, "a.fff").value().document;
    QVERIFY(io::writeFffFile(again).value() == bytes);
    // The date is the first that ZIP knows.
    QCOMPARE(bytes.substr(0, 14), std::string("PK\3\4\x14\0\0\0\x08\0\0\0\x21\0", 14));
}

void TestFffFile::whatIsInThere()
{
    const auto entries = io::unpacked(io::writeFffFile(withBlobs()).value(), "a.fff").value();
    std::vector<std::string> listing;
    for (const io::ArchiveEntry &entry : entries)
        listing.push_back(entry.name + " " + std::to_string(entry.bytes.size()));
    const std::string text = io::writeFff(withBlobs()).value();
    std::vector<std::string> expected = {
        "document.json " + std::to_string(text.size()),
        "blobs/" + io::sha256Of(noise(70'000)) + " 70000",
        "blobs/739c73c920f34e4e765641415d403d61658defbf786874657ee4976eaa8f00c2 10", // solid ship
        "blobs/e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855 0",  // nothing
    };
    std::sort(expected.begin() + 1, expected.end()); // the document first, then by hash
    QCOMPARE(listing, expected);
    QCOMPARE(entries.front().bytes, text);
    QVERIFY(text.find("\"mediaType\": \"model/stl\", \"name\": \"ship.stl\"") != std::string::npos);
}

void TestFffFile::whatCannotBeMadeSmallIsStored()
{
    const std::string bytes = io::writeFffFile(withBlobs()).value();
    QVERIFY2(bytes.find(noise(70'000)) != std::string::npos, "its very bytes are in the file");
    QVERIFY2(bytes.find("\"FlatFitFab\"") == std::string::npos, "text is packed");
}

// Wrong: what was written could be refused as an archive that was made to do harm.
void TestFffFile::zerosCanBeReadAgain()
{
    const Document document = addBlob(newDocument(), io::makeBlob(std::string(5'000'000, '\0')));
    const std::string bytes = io::writeFffFile(document).value();
    QVERIFY(io::readFffFile(bytes, "a.fff").value().document == document);
}

void TestFffFile::tooMuchIsNotWritten()
{
    Document document = newDocument();
    for (std::size_t i = 0; i < io::kMostEntries; ++i)
        document.blobs.push_back(io::makeBlob(std::to_string(i)));
    std::sort(document.blobs.begin(), document.blobs.end(),
              [](const auto &a, const auto &b) { return a->sha256 < b->sha256; });
    const auto many = io::writeFffFile(document);
    QVERIFY(!many);
    QCOMPARE(many.error().code, ErrorCode::BadCount);

    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.fff"));
    QVERIFY(!io::writeDocument(path, document));
    QVERIFY(!QFile::exists(path));
}

// Wrong: a text that was taken out of its archive would not open at all.
// Wrong: who saves what was read without its pictures has lost them.
void TestFffFile::textAloneIsNotHalfRead()
{
    const auto refused = io::readFffFile(textWith({"bytes"}), "a.fff");
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::BadArchive);
    QCOMPARE(refused.error().place, "a.fff:" + nameOf("bytes"));
    // Of what a crash left, all that can be had is more than nothing.
    const io::BlobSource none = [](const std::string &) {
        return failure(ErrorCode::BadArchive, {}, {"its data is missing"});
    };
    const auto loaded = io::readFffFile(textWith({"bytes"}), "a.fff", none);
    QVERIFY(loaded);
    QVERIFY(loaded->document == twoSections());
    QCOMPARE(loaded->warnings.size(), 1u);
    QCOMPARE(loaded->warnings.front().code, WarningCode::MissingBlob);
    QVERIFY(
        io::warningText(loaded->warnings.front()).startsWith(QStringLiteral("a.fff:$.blobs[0]: ")));
}

void TestFffFile::aFileOnDisk()
{
    QTemporaryDir folder;
    for (const char *name : {"a.fff", "a.txt", "a.zip"}) {
        const QString path = folder.filePath(QLatin1String(name));
        QVERIFY(io::writeDocument(path, withBlobs()));
        QVERIFY2(io::readDocument(path).value().document == withBlobs(), name);
    }
}

// The archives below are refused for what is wrong with them, and for nothing else.
void TestFffFile::madeArchivesAreRead()
{
    const std::string bytes = noise(1000);
    const auto loaded =
        io::readFffFile(MadeArchive::of({blob(bytes), documentWith({bytes, "text text text text"}),
                                         MadeEntry::packedOf(nameOf("text text text text"),
                                                             "text text text text")}),
                        "a.fff");
    QVERIFY2(loaded, loaded ? "" : qPrintable(io::errorText(loaded.error())));
    QCOMPARE(loaded->document.blobs.size(), 2u);
    const std::string many = MadeArchive::of({documentWith({})}, 1);
    QVERIFY(io::readFffFile(many, "a.fff"));
}

void TestFffFile::packedAgainByOthers_data()
{
    QTest::addColumn<std::string>("bytes");
    const std::string picture = noise(3000);
    const std::vector<MadeEntry> entries{documentWith({picture}), blob(picture)};
    const auto row = [](const char *name, const std::string &bytes) {
        QTest::newRow(name) << bytes;
    };
    const auto commented = [&](const std::string &comment) {
        return MadeArchive::of(entries, std::nullopt, comment);
    };
    row("with the folder of the blobs",
        MadeArchive::of({MadeEntry::stored("blobs/", ""), entries[0], entries[1]}));
    row("with a comment", commented("packed on a rainy day"));
    row("with a comment like the end", commented("PK\5\6"));
    row("with a comment that has a whole end",
        commented("see PK\5\6" + std::string(18, '\0') + " there"));
    row("with a comment that is an archive", commented(MadeArchive::of({named("x")})));
    row("with the longest comment", commented("PK\5\6" + std::string(0xFFFF - 4, '\6')));
    row("with a blob that looks like the end", [] {
        const std::string end = "PK\5\6" + std::string(18, '\0');
        return MadeArchive::of({documentWith({end}), blob(end)}, std::nullopt, "a comment");
    }());
}

// Wrong: a file that was only unpacked and packed again does not open.
void TestFffFile::packedAgainByOthers()
{
    QFETCH(std::string, bytes);
    const auto loaded = io::readFffFile(bytes, "a.fff");
    QVERIFY2(loaded, loaded ? "" : qPrintable(io::errorText(loaded.error())));
    QCOMPARE(loaded->document.blobs.size(), 1u);
    QVERIFY(loaded->document.sections.size() == 2);
}

void TestFffFile::hostile_data()
{
    addColumns();
    using enum ErrorCode;
    const std::string picture = noise(3000), hash = io::sha256Of(picture);
    const auto with = [&](const MadeEntry &entry) {
        return MadeArchive::of({documentWith({}), entry});
    };

    row("another ZIP", MadeArchive::of({named("word/document.xml"), named("[Content_Types].xml")}),
        NotAModel);
    row("an empty ZIP", MadeArchive::of({}), BadArchive);
    row("two letters", "PK", NotAModel);
    row("a head alone", std::string("PK\3\4", 4), BadArchive);

    row("out of the folder", with(named("../x")), BadArchive, ":../x");
    row("out of the folder of blobs", with(named("blobs/../x")), BadArchive, ":blobs/../x");
    row("an absolute path", with(named("/document.json")), BadArchive, ":/document.json");
    row("a path of Windows", with(named("C:\\x")), BadArchive, ":C:\\x");
    row("a backslash", with(named("blobs\\" + hash)), BadArchive,
        ":blobs\\" + hash.substr(0, 34) + "…");
    row("a zero byte", with(named(std::string("document.json\0x", 15))), BadArchive,
        ":document.json x");
    row("a zero byte behind a blob's name", with(named("blobs/" + hash + '\0')), BadArchive,
        ":blobs/" + hash.substr(0, 34) + "…");
    row("a folder that has bytes", with(named("blobs/")), BadArchive, ":blobs/");
    row("a folder alone", MadeArchive::of({MadeEntry::stored("blobs/", "")}), BadArchive,
        ":document.json");
    row("another folder", with(MadeEntry::stored("pictures/", "")), BadArchive, ":pictures/");
    row("a file in a deeper folder", with(named("blobs/x/" + hash)), BadArchive,
        ":blobs/x/" + hash.substr(0, 32) + "…");
    row("capital digits", with(named("blobs/" + std::string(64, 'A'))), BadArchive,
        ":blobs/" + std::string(34, 'A') + "…");
    row("a file of another kind", with(named("readme.txt")), BadArchive, ":readme.txt");
    row("no name", with(named("")), BadArchive, ":\"\"");
    row("bytes behind it", with(blob(picture)) + "more", BadArchive);
    row("much behind it", MadeArchive::of({documentWith({})}) + noise(70'000), BadArchive);
    row("two archives", MadeArchive::of({documentWith({})}) + MadeArchive::of({documentWith({})}),
        BadArchive);
    row("words behind the document", MadeArchive::of({MadeEntry::stored(kDocument, "{}word")}),
        BadSyntax, ":document.json:1");
    row("an endless name", with(named(std::string(60'000, 'x'))), BadArchive,
        ":" + std::string(40, 'x') + "…");

    row("two documents", MadeArchive::of({documentWith({}), documentWith({})}), BadArchive,
        ":document.json");
    row("a blob twice", MadeArchive::of({documentWith({picture}), blob(picture), blob(picture)}),
        BadArchive, ":blobs/" + hash.substr(0, 34) + "…");
    row("no document", MadeArchive::of({blob(picture)}), BadArchive, ":document.json");
    row("a missing blob", MadeArchive::of({documentWith({picture})}), BadArchive, ":blobs/" + hash);
    row("a blob too many", with(blob(picture)), BadArchive, ":blobs/" + hash);
    row("bytes of another blob",
        MadeArchive::of(
            {documentWith({picture}), MadeEntry::stored("blobs/" + hash, noise(3000, 2))}),
        BadArchive, ":blobs/" + hash);
    row("a document that is none", MadeArchive::of({MadeEntry::stored(kDocument, "{a}")}),
        BadSyntax, ":document.json:1");
    row("a document of something else", MadeArchive::of({MadeEntry::stored(kDocument, "{}")}),
        NotAModel, ":document.json");
    row("a packed document in a packed document",
        MadeArchive::of({MadeEntry::stored(kDocument, MadeArchive::of({documentWith({})}))}),
        BadSyntax, ":document.json:1");

    row("encrypted",
        MadeArchive::of({changed(documentWith({}), [](MadeEntry &entry) { entry.flags = 1; })}),
        BadArchive, ":document.json");
    row("encrypted, as it says itself",
        MadeArchive::of({changed(documentWith({}), [](MadeEntry &entry) { entry.ownFlags = 1; })}),
        BadArchive, ":document.json");
    row("called otherwise, as it says itself",
        MadeArchive::of(
            {changed(documentWith({}), [](MadeEntry &entry) { entry.ownName = "document.exe_"; })}),
        BadArchive, ":document.json");
    row(
        "an end in the comment that is as good",
        [] {
            // Two lists, one in the comment: which of them is it?
            const std::string first = MadeArchive::of({documentWith({})});
            std::string end = first.substr(first.size() - 22);
            const std::size_t place = first.size();
            for (std::size_t i = 0; i < 4; ++i) {
                end[12 + i] = '\0';
                end[16 + i] = static_cast<char>(place >> (8 * i) & 0xFF);
            }
            return MadeArchive::of({documentWith({})}, std::nullopt, end);
        }(),
        BadArchive);
    row("packed in an unknown way",
        MadeArchive::of({changed(documentWith({}), [](MadeEntry &entry) { entry.method = 12; })}),
        BadArchive, ":document.json");
    row("a wrong check sum",
        MadeArchive::of({changed(documentWith({}), [](MadeEntry &entry) { entry.crc ^= 1; })}),
        BadArchive, ":document.json");
    row("nothing that could be unpacked",
        MadeArchive::of(
            {changed(documentWith({}),
                     [](MadeEntry &entry) { entry.packed = noise(entry.packed.size()); })}),
        BadArchive, ":document.json");
    row("less than it says",
        MadeArchive::of({changed(documentWith({}), [](MadeEntry &entry) { entry.size += 1; })}),
        BadArchive, ":document.json");
    row("more than it says",
        MadeArchive::of({changed(documentWith({}), [](MadeEntry &entry) { entry.size = 10; })}),
        BadArchive, ":document.json");
    row("packed in more bytes than the file has",
        MadeArchive::of(
            {changed(documentWith({}), [](MadeEntry &entry) { entry.packedSize = 1u << 30; })}),
        BadArchive, ":document.json");
}

void TestFffFile::tooMuch_data()
{
    addColumns();
    using enum ErrorCode;
    const std::string zeros(std::size_t(20) << 20, '\0');
    row("twenty megabytes in twenty kilobytes",
        MadeArchive::of({documentWith({zeros}), MadeEntry::packedOf(nameOf(zeros), zeros)}),
        BadArchive, ":" + nameOf(zeros).substr(0, 40) + "…");
    row("said to be small",
        MadeArchive::of({documentWith({zeros}), changed(MadeEntry::packedOf(nameOf(zeros), zeros),
                                                        [](MadeEntry &entry) { entry.size = 9; })}),
        BadArchive, ":" + nameOf(zeros).substr(0, 40) + "…");
    row("said to be huge",
        MadeArchive::of({changed(documentWith({}),
                                 [](MadeEntry &entry) { entry.size = io::kMostEntryBytes + 1; })}),
        BadCount, ":document.json");
    row("said to be huge in 64 bits",
        MadeArchive::of({changed(documentWith({}),
                                 [](MadeEntry &entry) { entry.size = std::uint64_t(1) << 62; })}),
        BadArchive, ":document.json");
    row("said to be packed huge in 64 bits",
        MadeArchive::of({changed(documentWith({}),
                                 [](MadeEntry &entry) { entry.packedSize = ~std::uint64_t(0); })}),
        BadArchive, ":document.json");

    const std::string picture = noise(3000);
    std::vector<MadeEntry> large{documentWith({})}, same{documentWith({}), blob(picture)};
    for (int i = 0; i < 4; ++i) {
        large.push_back(blob(std::to_string(i)));
        large.back().size = io::kMostEntryBytes;
        same.push_back(changed(blob(picture), [i](MadeEntry &entry) {
            entry.name = nameOf(std::to_string(i));
            entry.sameAs = 1;
        }));
    }
    row("too much in all", MadeArchive::of(large), BadCount);
    row("the same bytes for several", MadeArchive::of(same), BadArchive);

    row("said to have many entries", MadeArchive::of({documentWith({})}, 65'535), BadCount);
    row("said to have many entries in 64 bits",
        MadeArchive::of({documentWith({})}, ~std::uint64_t(0)), BadCount);
    row("an entry fewer than said", MadeArchive::of({documentWith({})}, 2), BadArchive);
}

void TestFffFile::hostile()
{
    QFETCH(std::string, bytes);
    QFETCH(ErrorCode, code);
    QFETCH(std::string, place);
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("a.fff")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(bytes));
    file.close();
    io::ReadOptions options;
    options.name = "a.fff";
    const auto loaded = io::readDocument(file.fileName(), options);
    QVERIFY(!loaded);
    const QString text = io::errorText(loaded.error());
    QVERIFY2(loaded.error().code == code, qPrintable(text));
    QCOMPARE(QString::fromStdString(loaded.error().place), QString::fromStdString("a.fff" + place));
    QVERIFY2(test::unclear(loaded.error()).isEmpty(), qPrintable(test::unclear(loaded.error())));
}

void TestFffFile::tooMuch()
{
    hostile();
}

void TestFffFile::cutOffAnywhere()
{
    const std::string bytes = MadeArchive::of({documentWith({"bytes"}), blob("bytes")});
    for (std::size_t length = 4; length < bytes.size(); ++length) {
        const auto loaded = io::readFffFile(std::string_view(bytes).substr(0, length), "a.fff");
        QVERIFY2(!loaded, qPrintable(QString::number(length)));
        QVERIFY(test::unclear(loaded.error()).isEmpty());
    }
}

// What a changed byte says may be of no account, a time say; else it is an error, never another
// model.
void TestFffFile::anyByteChanged()
{
    const std::string bytes = MadeArchive::of({documentWith({"bytes"}), blob("bytes")});
    const Document document = io::readFffFile(bytes, "a.fff").value().document;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (const int change : {0x01, 0x80, 0xFF}) {
            std::string other = bytes;
            other[i] = static_cast<char>(other[i] ^ change);
            const auto loaded = io::readFffFile(other, "a.fff");
            if (loaded)
                QVERIFY2(loaded->document == document, qPrintable(QString::number(i)));
            else
                QVERIFY2(test::unclear(loaded.error()).isEmpty(),
                         qPrintable(test::unclear(loaded.error())));
        }
    }
}

FFF_TEST(TestFffFile)
#include "tst_fff_file.moc"
