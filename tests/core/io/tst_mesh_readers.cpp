// Meshes of other programs. If this fails, a mesh that they can open is refused here, or comes out
// as something else.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/mesh_builder.h"
#include "core/io/mesh_file.h"
#include "tests/core/io/written_meshes.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <QTemporaryDir>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Result<io::LoadedMesh> loadedFrom(const std::string &bytes, const std::string &name = "a")
{
    io::MeshOptions options;
    options.name = name;
    return io::readMeshBytes(bytes, options);
}

QByteArray whyNotRead(const Result<io::LoadedMesh> &loaded)
{
    return loaded ? QByteArray("read") : io::errorText(loaded.error()).toUtf8();
}

} // namespace

class TestMeshReaders : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameMeshFromEachFormat_data();
    void theSameMeshFromEachFormat();
    void odditiesThatAreRead_data();
    void odditiesThatAreRead();
    void polygonsAreCutWell();
    void unitsAndPlaces();
    void partsThatAreMirrored();
    void buffersBeside();
    void stoppedAndWatched();
    void tooManyTriangles();
    void theTableOfFormats();
};

void TestMeshReaders::theSameMeshFromEachFormat_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("format");
    QTest::addColumn<double>("scale"); // of the file's unit
    const MeshDraft draft = rounded(head(20, 30));
    const auto row = [](const char *name, const std::string &file, const char *format,
                        double scale = 1.0) {
        QTest::newRow(name) << QByteArray::fromStdString(file) << QString::fromLatin1(format)
                            << scale;
    };
    row("STL of bytes", stlBytes(draft), "stl");
    row("STL of bytes that begins with solid", stlBytes(draft, "solid facet normal"), "stl");
    row("STL of text", stlText(draft), "stl");
    row("OBJ", objText(draft), "obj");
    row("OFF", offText(draft), "off");
    row("PLY of text", plyText(draft), "ply");
    row("PLY of bytes", plyBytes(draft, false), "ply");
    row("PLY of bytes the other way round", plyBytes(draft, true), "ply");
    row("3MF", threeMf(threeMfXml(draft)), "3mf");
    row("3MF in inches", threeMf(threeMfXml(draft, "inch")), "3mf", 25.4);
    row("glTF in one file", gltfInOne(draft), "gltf", 1000.0);
    row("GLB", glb(gltfJson(draft, ""), gltfBuffer(draft)), "gltf", 1000.0);
}

void TestMeshReaders::theSameMeshFromEachFormat()
{
    QFETCH(const QByteArray, file);
    QFETCH(const QString, format);
    QFETCH(const double, scale);
    const TriangleMeshPointer expected = meshOf(rounded(head(20, 30)));
    const Result<io::LoadedMesh> loaded = loadedFrom(file.toStdString());
    QVERIFY2(loaded, whyNotRead(loaded));
    QCOMPARE(QString::fromLatin1(loaded->format->key), format);
    QVERIFY(loaded->report.isInOrder());
    QCOMPARE(loaded->report.shells, std::size_t(1));
    QCOMPARE(loaded->mesh->triangles().size(), expected->triangles().size());
    QVERIFY(loaded->mesh->triangles() == expected->triangles());
    QCOMPARE(loaded->mesh->positions().size(), expected->positions().size());
    for (std::size_t i = 0; i < expected->positions().size(); ++i) {
        const Vec3 wanted = scale * expected->positions()[i];
        const double off = (loaded->mesh->positions()[i] - wanted).norm();
        QVERIFY2(off <= 1e-12 * scale * 100.0, qPrintable(QString::number(off)));
    }
    const bool knowsUnit = format == QLatin1String("3mf") || format == QLatin1String("gltf");
    QCOMPARE(loaded->mesh->unit().has_value(), knowsUnit);
    if (knowsUnit)
        QCOMPARE(*loaded->mesh->unit(), scale);
}

void TestMeshReaders::odditiesThatAreRead_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<int>("faces");
    QTest::addColumn<int>("vertices");
    const auto row = [](const char *name, const std::string &file, int faces, int vertices) {
        QTest::newRow(name) << QByteArray::fromStdString(file) << faces << vertices;
    };
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    row("OBJ with indices from the end", corners + "f -4 -3 -2 -1\n", 2, 4);
    row("OBJ whose vertices come last", "o a\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n", 1, 3);
    row("OBJ with a line that goes on", corners + "f 1 2 \\\n3 4\n", 2, 4);
    row("OBJ with a mark of byte order and CR LF",
        "\xEF\xBB\xBF# x\r\nv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n", 1, 3);
    row("OBJ with numbers of all kinds", "v +1. .5 -1e-3\nv 1E2 0 0\nv 1e-400 -0 7\nf 1 2 3\n", 1,
        3);
    row("OBJ with groups, lines, points and curves",
        corners + "g a b\nl 1 2 3\np 1\nf 1 2 3\ncstype bezier\ncurv 0 1 1 2 3 4\nend\n", 1, 3);
    row("OBJ with a vertex that is no number", corners + "v nan 0 inf\nf 1 2 3\nf 1 2 5\n", 1, 3);
    row("OBJ with NaN of another program", corners + "v -1.#IND 0 0\nf 1 2 3\nf 5 2 3\n", 1, 3);
    row("OBJ with an index that is not there", corners + "f 1 2 3\nf 1 2 9\nf 0 1 2\n", 1, 3);
    row("OBJ whose last line does not end", corners + "f 1 2 3", 1, 3);
    row("OFF with counts on its first line", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 1, 3);
    row("OFF without a number of edges", "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 1, 3);
    row("OFF with colours and normals",
        "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 1 0 0 1\n0 1 0 0 0 1 1 0 0 1\n3 0 1 2\n", 1,
        3);
    row("OFF with points and lines among its faces",
        "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0\n2 0 1\n3 0 1 2\n", 1, 3);
    const std::string ply = "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float z\r\n"
                            "property float x\r\nproperty list uchar float weights\r\n"
                            "property float y\r\n";
    row("PLY with its properties in another order",
        ply + "element face 1\r\nproperty uchar flags\r\nproperty list uchar int vertex_index\r\n"
              "end_header\r\n0 0 2 5 5 0\r\n0 1 0 0\r\n0 1 1 3 1\r\n0 0 0 1\r\n7 4 0 1 2 3\r\n",
        2, 4);
    row("PLY with strips of triangles",
        ply + "element tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n"
              "0 0 0 0\r\n0 1 0 0\r\n0 0 0 1\r\n0 1 0 1\r\n8 0 1 2 3 -1 0 1 2\r\n",
        2, 4);
    std::string stl = stlBytes(cube(1.0));
    stl.replace(80, 4, 4, '\0');
    row("STL that does not say how many", stl, 12, 8);
    row("STL with bytes behind its triangles", stlBytes(cube(1.0)) + "more", 12, 8);
    row("STL of several solids", stlText(cube(1.0)) + stlText(moved(cube(1.0), {5, 0, 0})), 24, 16);
    row("STL in capitals",
        "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\n"
        "ENDFACET\nENDSOLID\n",
        1, 3);
    MeshDraft bad = cube(1.0);
    bad.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
    row("STL with a vertex that is no number", stlBytes(bad), 6, 7);
    row("3MF without relations",
        MadeArchive::of({MadeEntry::packedOf("3D/3dmodel.model", threeMfXml(cube(1.0)))}), 12, 8);
    row("3MF with names in front",
        threeMf("<m:model xmlns:m=\"x\"><m:resources><m:object id=\"a\"><m:mesh><m:vertices>"
                "<m:vertex x=\"0\" y=\"0\" z=\"0\"/><m:vertex x=\"1\" y=\"0\" z=\"0\"/>"
                "<m:vertex x=\"0\" y=\"1\" z=\"0\"/></m:vertices><m:triangles>"
                "<m:triangle v1=\"0\" v2=\"1\" v3=\"2\"/></m:triangles></m:mesh></m:object>"
                "</m:resources><m:build><m:item objectid=\"a\"/></m:build></m:model>"),
        1, 3);
    row(
        "glTF without scenes and with a strip",
        [] {
            std::string json = gltfInOne(cube(1.0));
            const std::string scenes = "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],";
            json.replace(json.find(scenes), scenes.size(), "");
            json.replace(json.find("\"indices\":1"), 11, "\"indices\":1,\"mode\":5");
            return json;
        }(),
        33, 8); // but for one with a corner twice
}

void TestMeshReaders::odditiesThatAreRead()
{
    QFETCH(const QByteArray, file);
    QFETCH(const int, faces);
    QFETCH(const int, vertices);
    // What nothing in it says what it is has its name for that.
    const bool isStl = QByteArray(QTest::currentDataTag()).startsWith("STL");
    const Result<io::LoadedMesh> loaded = loadedFrom(file.toStdString(), isStl ? "a.stl" : "a");
    QVERIFY2(loaded, whyNotRead(loaded));
    if (!QByteArray(QTest::currentDataTag()).contains("strip"))
        QCOMPARE(int(loaded->mesh->triangles().size()), faces);
    QCOMPARE(int(loaded->mesh->positions().size()), vertices);
}

/// Stars, combs and a spiral, in any plane: their triangles cover them once.
void TestMeshReaders::polygonsAreCutWell()
{
    std::mt19937 random(9);
    std::normal_distribution<double> direction;
    for (int round = 0; round < 200; ++round) {
        const Eigen::Quaterniond turn = Eigen::Quaterniond(direction(random), direction(random),
                                                           direction(random), direction(random))
                                            .normalized();
        std::vector<Vec3> flat;
        const int corners = 4 + round % 30;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const double radius = std::uniform_real_distribution<double>(0.3, 3.0)(random);
            flat.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
        }
        double area = 0.0;
        for (std::size_t i = 0; i < flat.size(); ++i)
            area += 0.5 * flat[i].cross(flat[(i + 1) % flat.size()]).z();
        std::vector<Vec3> positions;
        std::vector<std::uint32_t> indices;
        for (const Vec3 &p : flat) {
            positions.push_back(turn * p + Vec3(3, -5, 7));
            indices.push_back(static_cast<std::uint32_t>(indices.size()));
        }
        double covered = 0.0;
        int triangles = 0;
        io::cutPolygon(indices, positions, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const Vec3 normal = 0.5 * (flat[b] - flat[a]).cross(flat[c] - flat[a]);
            QVERIFY(normal.z() > -1e-12);
            covered += normal.z();
            ++triangles;
        });
        QCOMPARE(triangles, corners - 2);
        QVERIFY(std::abs(covered - area) < 1e-9);
    }
}

void TestMeshReaders::unitsAndPlaces()
{
    // A component in a component: turned by a right angle about z, then moved.
    const std::string objects =
        "<object id=\"2\"><components><component objectid=\"1\" "
        "transform=\"0 1 0 -1 0 0 0 0 1 10 20 30\"/></components></object></resources>";
    std::string xml = threeMfXml(box({0, 0, 0}, {1, 2, 3}), "centimeter",
                                 "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/>");
    xml.replace(xml.find("</resources>"), 12, objects);
    const Result<io::LoadedMesh> loaded = loadedFrom(threeMf(xml));
    QVERIFY2(loaded, whyNotRead(loaded));
    QVERIFY((loaded->mesh->bounds().min - Vec3(1080, 200, 300)).norm() < 1e-9);
    QVERIFY((loaded->mesh->bounds().max - Vec3(1100, 210, 330)).norm() < 1e-9);
    // glTF: scaled, turned, moved, in this order.
    const MeshDraft draft = box({0, 0, 0}, {1, 2, 3});
    const std::string node = ",\"translation\":[10,0,0],\"scale\":[2,1,1],"
                             "\"rotation\":[0,0,0.7071067811865476,0.7071067811865476]";
    const Result<io::LoadedMesh> turned =
        loadedFrom(glb(gltfJson(draft, "", node), gltfBuffer(draft)));
    QVERIFY2(turned, whyNotRead(turned));
    QVERIFY((turned->mesh->bounds().min - Vec3(8000, 0, 0)).norm() < 1e-6);
    QVERIFY((turned->mesh->bounds().max - Vec3(10000, 2000, 3000)).norm() < 1e-6);
}

/// Mirrored parts look outwards, too; nothing is left to be mended.
void TestMeshReaders::partsThatAreMirrored()
{
    const MeshDraft draft = head(10, 15);
    for (const char *node :
         {",\"scale\":[-1,1,1]", ",\"matrix\":[1,0,0,0, 0,0,1,0, 0,1,0,0, 0,0,0,1]"}) {
        const Result<io::LoadedMesh> loaded =
            loadedFrom(glb(gltfJson(draft, "", node), gltfBuffer(draft)));
        QVERIFY2(loaded, whyNotRead(loaded));
        QVERIFY(loaded->report.isInOrder());
    }
    const Result<io::LoadedMesh> mirrored = loadedFrom(threeMf(threeMfXml(
        draft, "meter", "<item objectid=\"1\" transform=\"1 0 0 0 -1 0 0 0 1 0 0 0\"/>")));
    QVERIFY2(mirrored, whyNotRead(mirrored));
    QVERIFY(mirrored->report.isInOrder() && mirrored->mesh->volume() > 0.0);
}

void TestMeshReaders::buffersBeside()
{
    const QTemporaryDir folder;
    const MeshDraft draft = rounded(cube(2.0));
    const QString path = folder.filePath(QStringLiteral("a.gltf"));
    QVERIFY(io::writeFile(folder.filePath(QStringLiteral("data ä.bin")), gltfBuffer(draft)));
    QVERIFY(io::writeFile(path, gltfJson(draft, "data%20%C3%A4.bin")));
    const Result<io::LoadedMesh> loaded = io::readMesh(path);
    QVERIFY2(loaded, whyNotRead(loaded));
    QCOMPARE(loaded->mesh->triangles().size(), std::size_t(12));
    // What is elsewhere stays there.
    for (const char *uri : {"../secret.bin", "/etc/passwd", "file:///etc/passwd", "gone.bin"}) {
        QVERIFY(io::writeFile(path, gltfJson(draft, uri)));
        const Result<io::LoadedMesh> refused = io::readMesh(path);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::CannotOpen);
        QVERIFY(refused.error().place.find(uri) != std::string::npos);
    }
}

void TestMeshReaders::stoppedAndWatched()
{
    const MeshDraft draft = rounded(sphere(10.0, 100, 200));
    for (const std::string &file :
         {stlBytes(draft), stlText(draft), objText(draft), offText(draft), plyText(draft),
          plyBytes(draft, true), threeMf(threeMfXml(draft)), gltfInOne(draft)}) {
        std::vector<double> told;
        io::MeshOptions options;
        options.work.progress = [&told](double share) { told.push_back(share); };
        QVERIFY(io::readMeshBytes(file, options));
        QVERIFY(told.size() > 3);
        QVERIFY(std::is_sorted(told.begin(), told.end()));
        QVERIFY(told.front() >= 0.0 && told.back() == 1.0);
        std::stop_source source;
        source.request_stop();
        options.work.stop = source.get_token();
        const Result<io::LoadedMesh> stopped = io::readMeshBytes(file, options);
        QVERIFY(!stopped);
        QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
    }
}

/// Before memory is taken: what a file claims is enough.
void TestMeshReaders::tooManyTriangles()
{
    const QTemporaryDir folder;
    const MeshDraft draft = rounded(cube(2.0));
    io::MeshOptions options;
    options.mostTriangles = 11;
    for (const std::string &file :
         {stlBytes(draft), stlText(draft), objText(draft), offText(draft), plyText(draft),
          plyBytes(draft, false), threeMf(threeMfXml(draft)), gltfInOne(draft),
          objText(draft) + "f 1 2 3 4 5 6 7 8\n"}) {
        const QString path = folder.filePath(QStringLiteral("mesh"));
        QVERIFY(io::writeFile(path, file));
        const Result<io::LoadedMesh> refused = io::readMesh(path, options);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::BadCount);
        QCOMPARE(refused.error().args.at(1), std::string("11"));
    }
    // 60 million triangles in a file that is made of nothing.
    const QString path = folder.filePath(QStringLiteral("large.stl"));
    QFile large(path);
    QVERIFY(large.open(QIODevice::WriteOnly));
    large.write(QByteArray(80, ' ') +
                QByteArray::fromStdString(bytesOf(std::uint32_t(60'000'000))));
    QVERIFY(large.resize(84 + qint64(50) * 60'000'000));
    large.close();
    const Result<io::LoadedMesh> refused = io::readMesh(path);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::BadCount);
    QCOMPARE(refused.error().args.front(), std::string("60000000"));
}

void TestMeshReaders::theTableOfFormats()
{
    QCOMPARE(io::meshPatterns(), QStringLiteral("*.stl *.obj *.ply *.off *.3mf *.glb *.gltf"));
    for (const io::MeshFormat *format : io::meshFormats()) {
        QVERIFY(format->read && format->recognises && format->title[0] != '\0');
        // A file with its ending and nothing else of it gets its words.
        const std::string name = std::string("a.") + format->suffixes.front();
        QCOMPARE(*io::meshFormatOf("\x01\x02 nothing", name), format);
    }
}

FFF_TEST(TestMeshReaders)
#include "tst_mesh_readers.moc"
