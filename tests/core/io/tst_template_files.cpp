// Pictures and drawings as templates: read, refused in plain words, saved and opened again.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/blobs.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "core/io/picture_file.h"
#include "core/io/picture_header.h"
#include "core/io/template_file.h"
#include "core/model/edits.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_curves.h"
#include "tests/test_program.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QImageReader>
#include <QLoggingCategory>
#include <QTemporaryDir>
#include <QtEndian>

#include <random>
#include <zlib.h>

using namespace fff;

namespace {

/// Red, but for a green pixel at the upper left and a blue one at the lower right.
QImage threeColours(int width, int height, QImage::Format format = QImage::Format_ARGB32)
{
    QImage image(width, height, QImage::Format_ARGB32);
    image.fill(Qt::red);
    image.setPixelColor(0, 0, Qt::green);
    image.setPixelColor(width - 1, height - 1, Qt::blue);
    return image.convertToFormat(format);
}

std::string encoded(const QImage &image, const char *format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, format, 100))
        qFatal("no %s", format);
    return bytes.toStdString();
}

std::string dataFile(const char *name)
{
    return io::readFile(QStringLiteral(FFF_TEST_DATA "/pictures/") + QLatin1String(name)).value();
}

QColor pixel(const TemplatePicture &picture, int x, int y)
{
    const std::uint8_t *p = picture.rgba.data() + 4 * (y * picture.width + x);
    return QColor(p[0], p[1], p[2], p[3]);
}

/// The head of a PNG that says so, rightly summed up, and an end.
std::string pngOfSize(quint32 width, quint32 height)
{
    const auto chunk = [](const char *kind, QByteArray content) {
        QByteArray bytes(4, '\0');
        qToBigEndian(quint32(content.size()), bytes.data());
        const QByteArray summed = kind + content;
        QByteArray sum(4, '\0');
        qToBigEndian(quint32(crc32(0, reinterpret_cast<const Bytef *>(summed.constData()),
                                   uInt(summed.size()))),
                     sum.data());
        return bytes + summed + sum;
    };
    QByteArray head(13, '\0');
    qToBigEndian(width, head.data());
    qToBigEndian(height, head.data() + 4);
    head[8] = 8;
    head[9] = 2;
    QByteArray packed = qCompress(QByteArray(100, '\0')).mid(4);
    return (QByteArray("\x89PNG\r\n\x1a\n", 8) + chunk("IHDR", head) + chunk("IDAT", packed) +
            chunk("IEND", {}))
        .toStdString();
}

/// A JPEG with the part in which cameras say how they were held.
std::string heldLike(const std::string &jpeg, char orientation)
{
    std::string exif("\xff\xe1\x00\x22"
                     "Exif\0\0"
                     "MM\0*\0\0\0\x08"
                     "\0\x01"
                     "\x01\x12\0\x03\0\0\0\x01\0",
                     29);
    exif += orientation;
    exif += std::string(6, '\0');
    return jpeg.substr(0, 2) + exif + jpeg.substr(2);
}

QString why(const std::string &bytes)
{
    const auto loaded = io::readTemplateBytes(bytes, "a.png", {});
    return loaded ? QString() : io::errorText(loaded.error());
}

// No raw string: moc would find no class behind it.
constexpr const char *kSquares =
    "<svg xmlns='http://www.w3.org/2000/svg' width='60mm' height='40mm' viewBox='0 0 60 40'>"
    "<path d='M0 0h60v40h-60z M10 10v20h20v-20z'/>"
    "<path fill='none' stroke='black' d='M40 10l10 10'/></svg>";

} // namespace

class TestTemplateFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // Qt's readers tell the log of each damage, too.
    void initTestCase()
    {
        QLoggingCategory::setFilterRules(QStringLiteral("qt.gui.imageio*=false"));
    }
    void pixelsAreWhatWasDrawn_data();
    void pixelsAreWhatWasDrawn();
    void whatIsTransparentStaysSo();
    void camerasAreHeldInManyWays();
    void inksBecomeColours();
    void webpWhereThePlatformReadsIt();
    void scansKnowTheirSize();
    void howTheyComeIn();
    void drawingsAreLinesInTrueSize();
    void drawingsThatAreNasty_data();
    void drawingsThatAreNasty();
    void picturesThatAreNasty_data();
    void picturesThatAreNasty();
    void anyDamageIsAnErrorOrAPicture();
    void aPictureThatMovesIsSaidToDoSo();
    void theyAreSavedAndOpenedAgain();
    void oneFileIsReadOnce();
    void whatIsMissingKeepsItsPlace();
    void meshesAreMeshesStill();
};

void TestTemplateFiles::pixelsAreWhatWasDrawn_data()
{
    QTest::addColumn<int>("format");
    QTest::newRow("PNG with opacity") << int(QImage::Format_ARGB32);
    QTest::newRow("PNG without") << int(QImage::Format_RGB888);
    QTest::newRow("PNG with a palette") << int(QImage::Format_Indexed8);
    QTest::newRow("PNG with 16 bits a colour") << int(QImage::Format_RGBA64);
}

void TestTemplateFiles::pixelsAreWhatWasDrawn()
{
    QFETCH(const int, format);
    const auto loaded =
        io::readPicture(encoded(threeColours(7, 5, QImage::Format(format)), "png"), "a.png");
    QVERIFY(loaded);
    const TemplatePicture &picture = *loaded->picture;
    QCOMPARE(picture.width, 7);
    QCOMPARE(picture.height, 5);
    QCOMPARE(picture.rgba.size(), std::size_t(4 * 35));
    QCOMPARE(pixel(picture, 0, 0), QColor(Qt::green));
    QCOMPARE(pixel(picture, 6, 4), QColor(Qt::blue));
    QCOMPARE(pixel(picture, 3, 2), QColor(Qt::red));
    QVERIFY(picture.isOpaque);
    QCOMPARE(std::string(loaded->mediaType), std::string("image/png"));
}

void TestTemplateFiles::whatIsTransparentStaysSo()
{
    QImage image = threeColours(4, 4);
    image.setPixelColor(1, 1, QColor(255, 0, 0, 100));
    const auto loaded = io::readPicture(encoded(image, "png"), "a.png");
    QVERIFY(loaded && !loaded->picture->isOpaque);
    QCOMPARE(pixel(*loaded->picture, 1, 1), QColor(255, 0, 0, 100));
}

// Wrong: a photograph of a standing person lay on its side.
void TestTemplateFiles::camerasAreHeldInManyWays()
{
    QImage image(40, 20, QImage::Format_RGB888);
    image.fill(Qt::white);
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            image.setPixelColor(x, y, Qt::black); // at the upper left of what is stored
    const std::string jpeg = encoded(image, "jpg");
    for (const auto &[orientation, width, x, y] :
         {std::tuple('\1', 40, 2, 2), std::tuple('\3', 40, 37, 17), std::tuple('\6', 20, 17, 2),
          std::tuple('\10', 20, 2, 37)}) {
        const auto loaded = io::readPicture(heldLike(jpeg, orientation), "a.jpg");
        QVERIFY(loaded);
        QCOMPARE(loaded->picture->width, width);
        QVERIFY(pixel(*loaded->picture, x, y).lightness() < 40);
    }
}

void TestTemplateFiles::inksBecomeColours()
{
    const auto loaded = io::readPicture(dataFile("cmyk.jpg"), "cmyk.jpg");
    QVERIFY(loaded);
    QVERIFY(pixel(*loaded->picture, 8, 8).lightness() < 60);
    QVERIFY(pixel(*loaded->picture, 20, 3).lightness() > 200);
}

void TestTemplateFiles::webpWhereThePlatformReadsIt()
{
    const auto loaded = io::readPicture(dataFile("still.webp"), "still.webp");
    if (QImageReader::supportedImageFormats().contains("webp")) {
        QVERIFY(loaded);
        QCOMPARE(loaded->picture->width, 3);
    } else {
        QCOMPARE(io::errorText(loaded.error()),
                 QStringLiteral("still.webp: \"WebP\" is not supported by this version"));
    }
}

// What a scanner says is the size of the thing; what every program says is none.
void TestTemplateFiles::scansKnowTheirSize()
{
    QImage image = threeColours(300, 150);
    image.setDotsPerMeterX(11811); // 300 an inch
    image.setDotsPerMeterY(11811);
    const auto scan = io::readTemplateBytes(encoded(image, "png"), "scan", {});
    QVERIFY(scan);
    QVERIFY((flatSize(scan->made) - Vec2(25.4, 12.7)).norm() < 0.01);
    image.setDotsPerMeterX(2835); // 72
    image.setDotsPerMeterY(2835);
    const auto screen = io::readTemplateBytes(encoded(image, "png"), "screen", {});
    QCOMPARE(flatSize(screen->made), Vec2(254.0, 127.0));
    const auto wanted = io::readTemplateBytes(encoded(image, "png"), "wanted", {.size = 90.0});
    QVERIFY((flatSize(wanted->made) - Vec2(90.0, 45.0)).norm() < 1e-9);
}

void TestTemplateFiles::howTheyComeIn()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("side view.png"));
    QVERIFY(threeColours(20, 10).save(path));
    const auto loaded = io::readTemplateFile(path, {});
    QVERIFY(loaded);
    const Template &made = loaded->made;
    QCOMPARE(made.kind, TemplateKind::Picture);
    QCOMPARE(made.name, std::string("side view"));
    QCOMPARE(made.opacity, kPictureOpacity);
    QCOMPARE(made.blob, loaded->blob->sha256);
    QCOMPARE(loaded->blob->mediaType, std::string("image/png"));
    QCOMPARE(made.frame, (Frame{{0.0, 63.5, 0.0}, Vec3::UnitX(), Vec3::UnitY()}));
    const auto referred = io::readTemplateFile(path, {.isByReference = true});
    QVERIFY(referred && !referred->blob && referred->made.blob.empty());
    QCOMPARE(referred->made.file, path.toStdString());
}

void TestTemplateFiles::drawingsAreLinesInTrueSize()
{
    const auto loaded = io::readTemplateBytes(kSquares, "squares", {});
    QVERIFY(loaded);
    QCOMPARE(loaded->made.kind, TemplateKind::Curves);
    QVERIFY((flatSize(loaded->made) - Vec2(60, 40)).norm() < 1e-6);
    const TemplateCurves &curves = *loaded->made.curves;
    QCOMPARE(curves.outlines.size(), std::size_t(1));
    QCOMPARE(curves.outlines[0].holes.size(), std::size_t(1));
    QCOMPARE(curves.open.size(), std::size_t(1));
    QVERIFY(
        (flatSize(io::readTemplateBytes(kSquares, "a", {.size = 30}).value().made) - Vec2(30, 20))
            .norm() < 1e-6);
}

void TestTemplateFiles::drawingsThatAreNasty_data()
{
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QString>("expected"); // of the error; empty: what is read is `width` wide
    QTest::addColumn<double>("width");
    QTest::addColumn<int>("messages");
    const auto row = [](const char *name, const QByteArray &body, const char *expected,
                        double width = 0.0, int messages = 0) {
        QTest::newRow(name) << body << QString::fromUtf8(expected) << width << messages;
    };
    const QByteArray open = R"(<svg xmlns="http://www.w3.org/2000/svg" )"
                            R"(xmlns:xlink="http://www.w3.org/1999/xlink" )";
    row("transforms in transforms",
        open + R"x(width="100mm" height="100mm" viewBox="0 0 100 100"><g transform="scale(2)">
<g transform="rotate(90)"><rect transform="translate(3 4)" width="10" height="30"/></g></g></svg>)x",
        "", 60.0);
    row("no viewBox", open + R"(width="50mm" height="50mm"><circle cx="48" cy="48" r="48"/></svg>)",
        "", 25.4);
    row("no size and no viewBox", open + R"(><rect width="96" height="48"/></svg>)", "", 25.4);
    row("pictures and texts beside lines",
        open +
            R"(width="9mm" height="9mm" viewBox="0 0 9 9"><image xlink:href="http://example.org/a.png" )"
            R"(width="9" height="9"/><text>Wing</text><rect width="9" height="5"/></svg>)",
        "", 9.0, 2);
    row("what is used is in another file",
        open +
            R"(><use xlink:href="http://example.org/a.svg#b"/><use xlink:href="/etc/passwd#x"/></svg>)",
        "a.svg: found nothing, expected lines, shapes or paths");
    row("an entity of another file",
        R"(<!DOCTYPE svg [<!ENTITY e SYSTEM "file:///etc/passwd">]>)" + open +
            R"(><desc>&e;</desc></svg>)",
        "a.svg: found nothing, expected lines, shapes or paths");
    row("it uses itself",
        open + R"(><g id="a"><rect width="4" height="4"/><use xlink:href="#a"/></g></svg>)",
        "a.svg:1: ");
    QByteArray copies = open + R"(><rect id="c0" width="4" height="4"/>)";
    for (int i = 1; i < 40; ++i)
        copies +=
            "<g id='c" + QByteArray::number(i) + "'>" +
            QByteArray("<use xlink:href='#c" + QByteArray::number(i - 1) + "'/>").repeated(4) +
            "</g>";
    row("copies of copies of copies", copies + "</svg>", "a.svg:1: found ");
    row("cut off", open + R"(><rect width="4" hei)", "a.svg:1: ");
    row("only a picture", open + R"(><image xlink:href="a.png"/></svg>)",
        "a.svg: found nothing, expected lines; a picture must be traced first");
    row("no drawing", "<html><body/></html>", "a.svg:1: ");
    row("a path of nonsense", open + R"(><path d="M0 0 L five 5"/></svg>)", "a.svg:1: found ");
}

void TestTemplateFiles::drawingsThatAreNasty()
{
    QFETCH(const QByteArray, body);
    QFETCH(const QString, expected);
    QFETCH(const double, width);
    QFETCH(const int, messages);
    const auto loaded = io::readTemplateBytes(body.toStdString(), "a.svg", {});
    if (!expected.isEmpty()) {
        QVERIFY(!loaded);
        const QString text = io::errorText(loaded.error());
        QVERIFY2(text.startsWith(expected), qPrintable(text));
        QVERIFY2(text.size() > expected.size() || text == expected, qPrintable(text));
        return;
    }
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QVERIFY2(std::abs(flatSize(loaded->made).x() - width) < 0.01,
             qPrintable(QString::number(flatSize(loaded->made).x())));
    QCOMPARE(int(loaded->messages.size()), messages);
}

void TestTemplateFiles::picturesThatAreNasty_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const std::string &bytes, const char *expected) {
        QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString::fromUtf8(expected);
    };
    const std::string png = encoded(threeColours(60, 50), "png");
    const std::string jpeg = encoded(threeColours(60, 50, QImage::Format_RGB888), "jpg");
    row("a PNG's first bytes", png.substr(0, 8),
        "a.png:byte 8: the file ends here, expected the rest of the picture");
    row("a PNG without its end", png.substr(0, png.size() - 20), "a.png:byte ");
    row("half a PNG", png.substr(0, png.size() / 2), "a.png:byte ");
    row("half a JPEG", jpeg.substr(0, jpeg.size() / 2), "a.png:byte ");
    row("a JPEG without its end", jpeg.substr(0, jpeg.size() - 2), "a.png:byte ");
    row("a JPEG's first bytes", jpeg.substr(0, 3), "a.png:byte 3: ");
    row("no pixels", pngOfSize(0, 0),
        "a.png: found \"0 × 0\", expected a picture with at least one pixel");
    row("no rows", pngOfSize(5, 0), "a.png: found \"5 × 0\"");
    row("too many pixels", pngOfSize(100'000, 100'000),
        "a.png: found 10000000000 pixels, expected at most 64000000 pixels");
    row("as many as fit into a number", pngOfSize(0x7FFFFFFF, 0x7FFFFFFF),
        "a.png: found 4611686014132420609 pixels");
    row("more than a number with a sign can be", pngOfSize(0xFFFFFFFF, 0xFFFFFFFF),
        "a.png: found 18446744065119617025 pixels");
    row("fewer rows than it says", pngOfSize(6000, 6000), "a.png: the picture is damaged");
    row("GIF", dataFile("moving.gif"),
        "a.png: found \"GIF\", expected a picture as PNG, JPEG or WebP");
    row("TIFF", std::string("II*\0\x08\0\0\0", 8), "a.png: found \"TIFF\"");
    row("WebP that is cut off", dataFile("still.webp").substr(0, 40), "a.png:byte 40: ");
    row("a mesh", "solid a\nendsolid a\n",
        "a.png: found \"solid a endsolid a \", expected a picture or a drawing");
    row("nothing", "", "a.png: found nothing, expected a picture or a drawing");
}

void TestTemplateFiles::picturesThatAreNasty()
{
    QFETCH(const QByteArray, bytes);
    QFETCH(const QString, expected);
    const QString text = why(bytes.toStdString());
    QVERIFY2(text.startsWith(expected), qPrintable(text));
}

void TestTemplateFiles::anyDamageIsAnErrorOrAPicture()
{
    std::mt19937 random(27);
    const QImage image = threeColours(40, 30, QImage::Format_RGB888);
    for (const std::string &whole : {encoded(image, "png"), encoded(image, "jpg"),
                                     dataFile("cmyk.jpg"), dataFile("still.webp")})
        for (int i = 0; i < 60; ++i) {
            std::string bytes = whole;
            for (int k = 0; k < 3; ++k)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            if (i % 4 == 0)
                bytes.resize(random() % bytes.size());
            const auto loaded = io::readPicture(bytes, "a");
            if (loaded)
                QCOMPARE(std::int64_t(loaded->picture->rgba.size()), 4 * loaded->picture->pixels());
            else
                QVERIFY(!io::errorText(loaded.error()).isEmpty());
        }
}

void TestTemplateFiles::aPictureThatMovesIsSaidToDoSo()
{
    std::string png = encoded(threeColours(4, 3), "png");
    const std::string control("\0\0\0\x08"
                              "acTL"
                              "\0\0\0\x02\0\0\0\0"
                              "\xf3\x8d\x93\x70",
                              20);
    png.insert(33, control); // behind the head
    const auto loaded = io::readTemplateBytes(png, "moving", {});
    QVERIFY(loaded);
    QCOMPARE(loaded->messages.size(), std::size_t(1));
    QCOMPARE(loaded->made.picture->width, 4);
}

void TestTemplateFiles::theyAreSavedAndOpenedAgain()
{
    QTemporaryDir folder;
    Document document = newDocument();
    const auto picture = io::readTemplateBytes(encoded(threeColours(9, 4), "png"), "picture", {});
    document = picture->addedTo(document).value();
    document = io::readTemplateBytes(kSquares, "squares", {})->addedTo(document).value();
    const QString path = folder.filePath(QStringLiteral("a.fff"));
    QVERIFY(io::writeDocument(path, document));
    const auto again = io::readDocument(path);
    QVERIFY(again && again->warnings.empty());
    QCOMPARE(again->document, document);
    QCOMPARE(again->document.templates[0]->picture->rgba, picture->made.picture->rgba);
    QCOMPARE(again->document.templates[1]->curves->lines, document.templates[1]->curves->lines);
}

void TestTemplateFiles::oneFileIsReadOnce()
{
    QTemporaryDir folder;
    const auto picture = io::readTemplateBytes(encoded(threeColours(9, 4), "png"), "picture", {});
    const Document document = picture->addedTo(picture->addedTo(newDocument()).value()).value();
    QCOMPARE(document.blobs.size(), std::size_t(1));
    const QString path = folder.filePath(QStringLiteral("a.fff"));
    QVERIFY(io::writeDocument(path, document));
    const auto again = io::readDocument(path);
    QCOMPARE(again->document.templates[0]->picture, again->document.templates[1]->picture);
}

void TestTemplateFiles::whatIsMissingKeepsItsPlace()
{
    // It says that it is a picture; its bytes are none.
    Document document = newDocument();
    const BlobPointer blob = io::makeBlob("Dear all", "image/png", "letter.png");
    document = addBlob(std::move(document), blob);
    io::LoadedTemplate letter;
    letter.blob = blob;
    letter.made.kind = TemplateKind::Picture;
    letter.made.name = "letter";
    letter.made.blob = blob->sha256;
    document = letter.addedTo(document).value();
    std::vector<Warning> warnings;
    const Document read = io::withTemplateContents(document, warnings);
    QCOMPARE(read, document);
    QVERIFY(!read.templates[0]->isRead());
    QCOMPARE(warnings.size(), std::size_t(1));
    QCOMPARE(io::warningSentence(warnings[0]),
             QStringLiteral("what letter shows could not be read; its place was kept"));
}

void TestTemplateFiles::meshesAreMeshesStill()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("a.png"))); // whatever it is called
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    file.close();
    const auto loaded = io::readTemplateFile(file.fileName(), {});
    QVERIFY(loaded);
    QCOMPARE(loaded->made.kind, TemplateKind::Mesh);
    QVERIFY(loaded->made.mesh && loaded->made.isRead());
}

FFF_TEST(TestTemplateFiles)
#include "tst_template_files.moc"
