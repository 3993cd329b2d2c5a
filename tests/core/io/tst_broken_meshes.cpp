// Files that are no meshes any more, by name. If this fails, one of them stops the program, is read
// as something that it is not, or is refused without saying where and what was expected.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/error_text.h"
#include "core/io/mesh_file.h"
#include "tests/core/io/written_meshes.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/one_line.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

std::string brokenWith(std::string text, const std::string &what, const std::string &instead)
{
    const std::size_t at = text.find(what);
    if (at == std::string::npos)
        qFatal("nothing to break: %s", what.c_str());
    return text.replace(at, what.size(), instead);
}

Result<io::LoadedMesh> brokenRead(const std::string &name, const std::string &bytes)
{
    io::MeshOptions options;
    options.name = name;
    return io::readMeshBytes(bytes, options);
}

} // namespace

class TestBrokenMeshes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saidClearly_data();
    void saidClearly();
    void tooLargeIsNotRead_data();
    void tooLargeIsNotRead();
    void anyPrefixAndAnyByte_data();
    void anyPrefixAndAnyByte();
};

void TestBrokenMeshes::saidClearly_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("sentence"); // the start of it, with the place
    const auto row = [](const char *what, const char *name, const std::string &file,
                        const char *sentence) {
        QTest::newRow(what) << QByteArray::fromStdString(file) << QString::fromLatin1(name)
                            << QString::fromUtf8(sentence);
    };
    const MeshDraft draft = cube(10.0);
    const std::string stl = stlBytes(draft), text = stlText(draft), obj = objText(draft),
                      off = offText(draft), ply = plyText(draft), plyRaw = plyBytes(draft, false);
    row("nothing", "a.stl", "", "a.stl:1: the file ends here, expected a mesh");
    row("a letter", "letter.txt", "Dear all,\nthis is no mesh.\n",
        "letter.txt:1: found \"Dear all,\", expected a mesh");
    row("a picture", "a.png", "\x89PNG\r\n\x1a\n", "a.png:1: found");
    // STL
    row("STL cut off in its head", "a.stl", stl.substr(0, 50),
        "a.stl:byte 50: the file ends here, expected the number of triangles");
    row("STL cut off in a triangle", "a.stl", stl.substr(0, 300),
        "a.stl:byte 300: the file ends here, expected as many triangles");
    row("STL that claims more than there are", "a.stl",
        std::string(stl).replace(80, 4, bytesOf(std::uint32_t(4'000'000))),
        "a.stl:byte 684: the file ends here");
    row("STL that claims too many", "a.stl",
        std::string(stl).replace(80, 4, bytesOf(std::uint32_t(4'000'000'000))),
        "a.stl: found 4000000000 triangles, expected at most 10000000 triangles");
    row("STL without a triangle", "a.stl", stl.substr(0, 80) + bytesOf(std::uint32_t(0)),
        "a.stl: found nothing, expected a mesh with at least one triangle");
    row("STL text without a triangle", "a.stl", "solid\nendsolid\n",
        "a.stl: found nothing, expected a mesh");
    row("STL text with a word for a number", "a.stl", brokenWith(text, "vertex -5", "vertex five"),
        "a.stl:4: found \"five\", expected a number");
    row("STL text with a decimal comma", "a.stl", brokenWith(text, "vertex -5", "vertex -5,5"),
        "a.stl:4: found \"-5,5\", expected a number");
    row("STL text with two corners", "a.stl",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n",
        "a.stl:6: found \"2\", expected three corners of a triangle");
    row("STL text that ends early", "a.stl", text.substr(0, 250), "a.stl:");
    row("STL text with a stray word", "a.stl", brokenWith(text, "endfacet", "endfoo"),
        "a.stl:8: found \"endfoo\", expected endfacet");
    row("STL text with a number too few", "a.stl",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n",
        "a.stl:4: found nothing, expected a number");
    // OBJ
    row("OBJ without a face", "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\n",
        "a.obj: found nothing, expected a mesh with at least one triangle");
    row("OBJ of another world", "a.obj", "v 0 0 0\nv 1e302 0 0\nv 0 -8e301 0\nf 1 2 3\n",
        "a.obj: found \"1e+302\", expected coordinates up to 1e12");
    row("OBJ with a number too few", "a.obj", "v 0 0 0\nv 1 0\nv 1 1 0\nf 1 2 3\n",
        "a.obj:2: found nothing, expected a number");
    row("OBJ with a word for a number", "a.obj", "v 0 0 0\nv 1 x 0\n",
        "a.obj:2: found \"x\", expected a number");
    row("OBJ with a word for an index", "a.obj", "v 0 0 0\nf 1 2 x/1\n",
        "a.obj:2: found \"x\", expected a whole number");
    row("OBJ with a face of two corners", "a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n",
        "a.obj:3: found \"2\", expected at least three corners");
    row("OBJ whose faces name nothing", "a.obj", "v 0 0 0\nf 7 8 9\nf 0 0 0\nf -9 -8 -7\n",
        "a.obj: found nothing, expected a mesh");
    row("OBJ that is bytes", "a.obj", std::string("\0\1\2\3\4\5", 6), "a.obj: found nothing");
    row("OBJ with a fraction for an index", "a.obj", "v 0 0 0\nf 1.5 2 3\n",
        "a.obj:2: found \"1.5\", expected a whole number");
    // OFF
    row("OFF without counts", "a.off", "OFF\n", "a.off:2: the file ends here, expected the number");
    row("OFF with a negative count", "a.off", brokenWith(off, "8 12 0", "-8 12 0"),
        "a.off:3: found \"-8\", expected a count");
    row("OFF that claims too much", "a.off", brokenWith(off, "8 12 0", "8000000000 12 0"),
        "a.off:3: found 8000000000 vertices, expected at most");
    row("OFF that claims more than the file holds", "a.off",
        brokenWith(off, "8 12 0", "8 4000000 0"),
        "a.off:3: found 4000000 triangles, expected at most");
    row("OFF that ends early", "a.off", off.substr(0, off.size() - 40), "a.off:");
    row("OFF with a fourth coordinate", "a.off", brokenWith(off, "OFF", "4OFF"),
        "a.off:1: \"4OFF\" is not supported");
    row("OFF of bytes", "a.off", "OFF BINARY\n\0\0\0\1",
        "a.off:1: \"OFF BINARY\" is not supported");
    row("OFF with a word among its vertices", "a.off", brokenWith(off, "\n-5 -5 -5", "\n-5 why -5"),
        "a.off:4: found \"why\", expected a number");
    row("OFF with a face that has too few corners", "a.off",
        brokenWith(off, "3 0 2 3 ", "9 0 2 3 "),
        "a.off:12: found nothing, expected a whole number");
    // PLY
    row("PLY without an end of its head", "a.ply", ply.substr(0, 60),
        "a.ply:4: the file ends here, expected end_header");
    row("PLY with a head that stops", "a.ply", "ply\nformat ascii 1.0\n",
        "a.ply:3: the file ends here, expected end_header");
    row("PLY of an unknown format", "a.ply", brokenWith(ply, "ascii", "morse"),
        "a.ply:2: found \"morse\", expected ascii or binary");
    row("PLY of an unknown type", "a.ply", brokenWith(ply, "double x", "quad x"),
        "a.ply:5: found \"quad\", expected a type such as float or int");
    row("PLY without z", "a.ply", brokenWith(ply, "double z", "double w"),
        "a.ply: found \"element vertex\", expected x, y and z");
    row("PLY whose faces have no corners", "a.ply", brokenWith(ply, "vertex_indices", "edges"),
        "a.ply: found \"element face\", expected vertex_indices");
    row("PLY that ends early", "a.ply", ply.substr(0, ply.size() - 30), "a.ply:");
    row("PLY of bytes that ends early", "a.ply", plyRaw.substr(0, plyRaw.size() - 30),
        "a.ply:byte");
    row("PLY that claims too many", "a.ply",
        brokenWith(ply, "element face 12", "element face 60000000"),
        "a.ply: found 60000000 triangles, expected at most 10000000 triangles");
    row("PLY with vertices that are not there", "a.ply",
        brokenWith(plyRaw, "element vertex 8", "element vertex 9999999"),
        "a.ply:byte 244: found 9999999 vertices");
    row("PLY with an element of a name that is no text", "a.ply",
        brokenWith(plyRaw, "element face 12",
                   "element f\x7f"
                   "ace 9999999"),
        "a.ply:byte 444: found 9999999 f ace, expected at most 40 f ace");
    row("PLY with a word among its numbers", "a.ply", brokenWith(ply, "3 0 2 3", "3 0 two 3"),
        "a.ply:21: found \"two\", expected a number");
    row("PLY with a list of −1", "a.ply", brokenWith(ply, "3 0 2 3", "-1 0 2 3"),
        "a.ply:21: found \"-1\", expected the length of a list");
    // 3MF
    const std::string xml = threeMfXml(draft);
    row("3MF that is damaged", "a.3mf", threeMf(xml).substr(0, 200), "a.3mf: ");
    row("3MF without a model", "a.3mf",
        MadeArchive::of({MadeEntry::packedOf("readme.txt", "nothing")}),
        "a.3mf: there is no 3D model in this file");
    row("3MF that is no XML", "a.3mf", threeMf(brokenWith(xml, "</vertices>", "</vertex>")),
        "a.3mf:3D/a.model:12: found");
    row("3MF with another root", "a.3mf", threeMf("<book/>"),
        "a.3mf:3D/a.model:1: found \"book\", expected a 3D model");
    row("3MF of an unknown unit", "a.3mf", threeMf(threeMfXml(draft, "cubit")),
        "a.3mf:3D/a.model:2: found \"cubit\", expected a unit such as millimeter");
    row("3MF that builds what is not there", "a.3mf",
        threeMf(threeMfXml(draft, "inch", "<item objectid=\"7\"/>")),
        "a.3mf:3D/a.model:26: there is nothing with the number 7");
    row("3MF that builds nothing", "a.3mf", threeMf(threeMfXml(draft, "inch", "")),
        "a.3mf: found nothing, expected a mesh");
    row("3MF with a word for a number", "a.3mf", threeMf(brokenWith(xml, "x=\"-5\"", "x=\"no\"")),
        "a.3mf:3D/a.model:4: found \"no\", expected a number");
    row("3MF with a short transform", "a.3mf",
        threeMf(threeMfXml(draft, "inch", "<item objectid=\"1\" transform=\"1 0 0\"/>")),
        "a.3mf:3D/a.model:26: found \"1 0 0\", expected twelve numbers");
    row("3MF of an object in itself", "a.3mf",
        threeMf(
            brokenWith(xml, "<object id=\"1\" type=\"model\">",
                       "<object id=\"1\"><components><component objectid=\"1\"/></components>")),
        "a.3mf:3D/a.model:3: found \"1\", expected an object that does not contain itself");
    // Wrong: each names the one before four times, and the reader is not seen again.
    std::string laughs;
    for (int level = 2; level <= 30; ++level) {
        laughs += "<object id=\"" + std::to_string(level) + "\"><components>";
        for (int i = 0; i < 4; ++i)
            laughs += "<component objectid=\"" + std::to_string(level - 1) + "\"/>";
        laughs += "</components></object>";
    }
    row("3MF of objects in objects without end", "a.3mf",
        threeMf(brokenWith(threeMfXml(draft, "inch", "<item objectid=\"30\"/>"),
                           "<object id=\"1\" type=\"model\">",
                           laughs + "<object id=\"1\" type=\"model\">")),
        "a.3mf:3D/a.model:3: found 20001 placed objects, expected at most 20000");
    // glTF
    const std::string json = gltfInOne(draft);
    row("glTF that is no JSON", "a.gltf", "{\"asset\":", "a.gltf:1: the file ends here");
    row("glTF of version 1", "a.gltf", brokenWith(json, "\"2.0\"", "\"1.0\""),
        "a.gltf:$.asset.version: found \"1.0\", expected version 2 of glTF");
    row("glTF without meshes", "a.gltf", "{\"asset\":{\"version\":\"2.0\"}}",
        "a.gltf: found nothing, expected a mesh");
    row("glTF with a compression", "a.gltf",
        brokenWith(json, "\"scene\":0", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"),
        "a.gltf:$.extensionsRequired[0]: \"KHR_draco_mesh_compression\" is not supported");
    row("glTF with a node in itself", "a.gltf", brokenWith(json, "\"mesh\":0", "\"children\":[0]"),
        "a.gltf:$.nodes[0]: found \"0\", expected a node that is not within itself");
    row("glTF with a short buffer", "a.gltf",
        brokenWith(json, "\"byteLength\":96", "\"byteLength\":9999"),
        "a.gltf:$.bufferViews[0].byteLength: found \"9999\", expected a length");
    row("glTF whose accessor is too long", "a.gltf",
        brokenWith(json, "\"count\":8", "\"count\":800"),
        "a.gltf:$.accessors[0].count: found \"800\", expected as many values");
    row("glTF with an accessor that is not there", "a.gltf",
        brokenWith(json, "\"POSITION\":0", "\"POSITION\":9"),
        "a.gltf:$.accessors: there is nothing with the number 9");
    row("glTF with a buffer that is gone", "a.gltf", gltfJson(draft, "gone.bin"),
        "a.gltf:$.buffers[0]: found");
    row("GLB of another version", "a.glb",
        brokenWith(glb(gltfJson(draft, ""), gltfBuffer(draft)), bytesOf(std::uint32_t(2)),
                   bytesOf(std::uint32_t(7))),
        "a.glb:byte 4: found \"7\", expected version 2 of GLB");
    row("GLB cut off", "a.glb", glb(gltfJson(draft, ""), gltfBuffer(draft)).substr(0, 100),
        "a.glb:byte 12: the file ends here, expected a chunk of a GLB file");
    row("GLB that is a head only", "a.glb", "glTF", "a.glb:byte 4: found nothing");
}

void TestBrokenMeshes::saidClearly()
{
    QFETCH(const QByteArray, file);
    QFETCH(const QString, name);
    QFETCH(const QString, sentence);
    const Result<io::LoadedMesh> loaded = brokenRead(name.toStdString(), file.toStdString());
    QVERIFY(!loaded);
    const QString text = io::errorText(loaded.error());
    QVERIFY2(text.startsWith(sentence), qPrintable(text));
    QVERIFY2(isOneLine(text), qPrintable(text));
    QVERIFY(text.size() > name.size() + 10);
}

void TestBrokenMeshes::tooLargeIsNotRead_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("head");
    QTest::addColumn<qint64>("size");
    QTest::addColumn<QString>("sentence");
    constexpr std::uint32_t kFiftyMillion = 50'000'000;
    QTest::newRow("STL of 50 million triangles")
        << QStringLiteral("a.stl")
        << QByteArray::fromStdString(std::string(80, ' ') + bytesOf(kFiftyMillion))
        << qint64(84) + qint64(50) * kFiftyMillion
        << QStringLiteral("a.stl: found 50000000 triangles, expected at most 10000000 triangles");
    QTest::newRow("PLY of 50 million triangles")
        << QStringLiteral("a.ply")
        << QByteArray("ply\nformat binary_little_endian 1.0\nelement vertex 25000000\n"
                      "property float x\nproperty float y\nproperty float z\n"
                      "element face 50000000\nproperty list uchar int vertex_indices\n"
                      "end_header\n")
        << qint64(950'000'200)
        << QStringLiteral("a.ply: found 50000000 triangles, expected at most 10000000 triangles");
    QTest::newRow("OBJ of 50 million triangles")
        << QStringLiteral("a.obj") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        << qint64(2'000'000'000) << QStringLiteral("a.obj: found 2000000000 bytes, expected at");
}

// Wrong: a scan that is larger than the machine swaps it to death before anything is said.
void TestBrokenMeshes::tooLargeIsNotRead()
{
    QFETCH(const QString, name);
    QFETCH(const QByteArray, head);
    QFETCH(const qint64, size);
    QFETCH(const QString, sentence);
    QTemporaryDir folder;
    const QString path = folder.filePath(name);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(head);
    if (!file.resize(size)) // with a hole, which takes no room
        QSKIP("no room for such a file, nor for a hole in it");
    file.close();
    io::MeshOptions options;
    options.name = name.toStdString();
    // Nothing behind the head is read of what is refused: no progress is told.
    int asked = 0;
    options.work.progress = [&asked](double) { ++asked; };
    const Result<io::LoadedMesh> loaded = io::readMesh(path, options);
    QVERIFY(!loaded);
    const QString text = io::errorText(loaded.error());
    QVERIFY2(text.startsWith(sentence), qPrintable(text));
    QCOMPARE(asked, 0);
}

void TestBrokenMeshes::anyPrefixAndAnyByte_data()
{
    QTest::addColumn<QByteArray>("file");
    const MeshDraft draft = rounded(cube(10.0));
    QTest::newRow("STL") << QByteArray::fromStdString(stlBytes(draft));
    QTest::newRow("STL text") << QByteArray::fromStdString(stlText(draft));
    QTest::newRow("OBJ") << QByteArray::fromStdString(objText(draft));
    QTest::newRow("OFF") << QByteArray::fromStdString(offText(draft));
    QTest::newRow("PLY text") << QByteArray::fromStdString(plyText(draft));
    QTest::newRow("PLY") << QByteArray::fromStdString(plyBytes(draft, true));
    QTest::newRow("3MF") << QByteArray::fromStdString(threeMf(threeMfXml(draft)));
    QTest::newRow("glTF") << QByteArray::fromStdString(gltfInOne(draft));
    QTest::newRow("GLB") << QByteArray::fromStdString(glb(gltfJson(draft, ""), gltfBuffer(draft)));
}

/// Read or refused with a place and words; never anything else.
void TestBrokenMeshes::anyPrefixAndAnyByte()
{
    QFETCH(const QByteArray, file);
    const std::string whole = file.toStdString();
    const auto look = [](const std::string &bytes) {
        const Result<io::LoadedMesh> loaded = brokenRead("a", bytes);
        if (loaded)
            return loaded->mesh->positions().size() >= 3;
        return loaded.error().place.starts_with("a") &&
               !io::errorSentence(loaded.error()).isEmpty() &&
               isOneLine(io::errorText(loaded.error()));
    };
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 300)
        QVERIFY(look(whole.substr(0, length)));
    std::mt19937 random(77);
    for (int round = 0; round < 600; ++round) {
        std::string changed = whole;
        for (int i = 0; i < 1 + round % 4; ++i)
            changed[random() % changed.size()] = static_cast<char>(random());
        QVERIFY(look(changed));
    }
}

FFF_TEST(TestBrokenMeshes)
#include "tst_broken_meshes.moc"
