#include <QTest> // first: moc stumbles over some standard headers

#include "core/assembly/assembly.h"
#include "core/io/document_file.h"
#include "core/io/obj_writer.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <set>

using namespace fff;
using namespace fff::test;

namespace {

struct Traits : OpenMesh::DefaultTraits
{
    using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

struct Cut
{
    Model model;
    std::vector<CutSectionPointer> cuts;
    Bodies bodies;
};

Cut cutOf(Model model)
{
    CutCache cache;
    const Assembly assembly = assemble(model);
    Cut cut{std::move(model), {}, {}};
    for (std::size_t i = 0; i < cut.model.sectionCount(); ++i)
        cut.cuts.push_back(cutSection(cut.model.section(i)->shape, assembly.slits[i], cache));
    cut.bodies = bodiesOf(cut.model, cut.cuts);
    return cut;
}

/// A connected piece of the mesh: where its first vertex stands tells which part it is.
struct Piece
{
    int vertices = 0, edges = 0, faces = 0;
    double volume = 0.0;
    OpenMesh::Vec3d base; // volumes are counted from here: far from the origin digits get lost

    int euler() const { return vertices - edges + faces; }
};

std::vector<Piece> piecesOf(const Mesh &mesh)
{
    std::vector<int> pieceOf(mesh.n_vertices(), -1);
    std::vector<Piece> pieces;
    for (const auto start : mesh.vertices()) {
        if (pieceOf[static_cast<std::size_t>(start.idx())] >= 0)
            continue;
        const int index = static_cast<int>(pieces.size());
        pieces.emplace_back();
        pieces.back().base = mesh.point(start);
        std::vector<OpenMesh::VertexHandle> open{start};
        pieceOf[static_cast<std::size_t>(start.idx())] = index;
        while (!open.empty()) {
            const auto v = open.back();
            open.pop_back();
            ++pieces.back().vertices;
            for (const auto next : mesh.vv_range(v)) {
                int &piece = pieceOf[static_cast<std::size_t>(next.idx())];
                if (piece < 0) {
                    piece = index;
                    open.push_back(next);
                }
            }
        }
    }
    const auto piece = [&](OpenMesh::VertexHandle v) -> Piece & {
        return pieces[static_cast<std::size_t>(pieceOf[static_cast<std::size_t>(v.idx())])];
    };
    for (const auto edge : mesh.edges())
        ++piece(edge.v0()).edges;
    for (const auto face : mesh.faces()) {
        std::vector<OpenMesh::Vec3d> points;
        OpenMesh::VertexHandle first;
        for (const auto v : mesh.fv_range(face)) {
            first = v;
            points.push_back(mesh.point(v));
        }
        Piece &owner = piece(first);
        ++owner.faces;
        for (OpenMesh::Vec3d &point : points)
            point -= owner.base;
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            owner.volume += points[0].dot(points[i].cross(points[i + 1])) / 6.0;
    }
    return pieces;
}

/// Empty when the file is closed slabs, one a part, of the volume that is cut.
QString whatIsWrong(const Cut &cut, bool touches = false)
{
    const std::string obj = *io::writeObj(cut.model, cut.bodies);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("model.obj"));
    if (!io::writeFile(path, obj))
        return QStringLiteral("cannot be written");
    Mesh mesh;
    if (!OpenMesh::IO::read_mesh(mesh, path.toStdString()))
        return QStringLiteral("OpenMesh cannot read it");
    const QString text = QString::fromStdString(obj);
    if (static_cast<qsizetype>(mesh.n_vertices()) != text.count(QStringLiteral("\nv ")))
        return QStringLiteral("OpenMesh had to double vertices to make edges of two faces");
    if (static_cast<qsizetype>(mesh.n_faces()) != text.count(QStringLiteral("\nf ")))
        return QStringLiteral("OpenMesh left out faces");
    for (const auto edge : mesh.edges())
        if (edge.is_boundary())
            return QStringLiteral("an edge with one face");
    // OpenMesh's reader knows floats only: the true places are in the file.
    static const QRegularExpression kVertex(QStringLiteral("\nv (\\S+) (\\S+) (\\S+)"));
    auto match = kVertex.globalMatch(text);
    for (const auto v : mesh.vertices()) {
        const auto numbers = match.next();
        mesh.set_point(v, {numbers.captured(1).toDouble(), numbers.captured(2).toDouble(),
                           numbers.captured(3).toDouble()});
    }
    const std::vector<Piece> pieces = piecesOf(mesh);
    std::size_t next = 0;
    for (std::size_t i = 0; i < cut.cuts.size(); ++i) {
        for (const CurvedRegion &part : cut.cuts[i]->parts()) {
            if (next == pieces.size())
                return QStringLiteral("fewer solids than parts");
            const Piece &piece = pieces[next++];
            const double volume = area(part.region) * cut.model.stockOf(i).thickness;
            if (std::abs(piece.volume - volume) > 1e-6 * volume)
                return QStringLiteral("volume %1 instead of %2").arg(piece.volume).arg(volume);
            if (!touches && piece.euler() != 2 - 2 * static_cast<int>(part.region.holes.size()))
                return QStringLiteral("Euler characteristic %1").arg(piece.euler());
        }
    }
    return next == pieces.size() ? QString() : QStringLiteral("more solids than parts");
}

Model single(const Contour &contour, const std::vector<Contour> &holes = {},
             const Frame &frame = turned(0.4))
{
    return evaluate(withSection(newDocument(), *Shape::make(contour, holes), frame));
}

} // namespace

class TestObjWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyShapeIsClosed_data();
    void everyShapeIsClosed();
    void slitsAreCut_data();
    void slitsAreCut();
    void touchingHolesStayManifold_data();
    void touchingHolesStayManifold();
    void sharedModels_data();
    void sharedModels();
    void facesLookOutwards();
    void verticesAreThereOnce();
    void namesAreSafeAndUnique();
    void sameBytesForSameInput();
    void emptyModel();
};

void TestObjWriter::everyShapeIsClosed_data()
{
    QTest::addColumn<int>("index");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        QTest::newRow(shapes[i].name) << static_cast<int>(i);
}

// A slab with a gap cannot be printed, measured or cut by any other program.
void TestObjWriter::everyShapeIsClosed()
{
    QFETCH(int, index);
    const NamedContour shape = simpleContours()[static_cast<std::size_t>(index)];
    const bool touches = QByteArray(shape.name).contains("touch") ||
                         QByteArray(shape.name).contains("ring cut open");
    QCOMPARE(whatIsWrong(cutOf(single(shape.contour)), touches), QString());
}

void TestObjWriter::slitsAreCut_data()
{
    QTest::addColumn<double>("length"); // of the second plate, from the middle
    QTest::addColumn<double>("angle");
    QTest::newRow("crossed plates") << 50.0 << 1.5707963267948966;
    QTest::newRow("crossed at 40 degrees") << 50.0 << 0.7;
    QTest::newRow("crossed at 12 degrees, slits wide") << 90.0 << 0.21;
    QTest::newRow("a plate just longer than the slit is wide") << 2.0 << 1.5707963267948966;
}

void TestObjWriter::slitsAreCut()
{
    QFETCH(double, length);
    QFETCH(double, angle);
    const Cut cut =
        cutOf(twoSections(polygonShape(rectangle(-60, 0, 60, 50), {rectangle(-50, 10, -30, 30)}),
                          front(), polygonShape(rectangle(-length, 0, length, 50)), turned(angle)));
    QCOMPARE(whatIsWrong(cut), QString());
    QVERIFY(cut.cuts[0]->area() < 6000.0 - 400.0 - 50.0);
}

void TestObjWriter::touchingHolesStayManifold_data()
{
    QTest::addColumn<Polygon>("first");
    QTest::addColumn<Polygon>("second");
    QTest::newRow("holes that touch at a corner")
        << rectangle(10, 10, 20, 20) << rectangle(20, 20, 30, 30);
    QTest::newRow("a hole whose corner touches the edge")
        << Polygon{{0, 20}, {10, 10}, {10, 30}} << rectangle(25, 25, 30, 30);
    QTest::newRow("holes that share an edge")
        << rectangle(10, 10, 20, 20) << rectangle(20, 10, 30, 20);
    QTest::newRow("holes that touch at three corners")
        << Polygon{{10, 10}, {30, 10}, {20, 15}, {30, 20}, {10, 20}, {15, 15}}
        << Polygon{{20, 15}, {30, 10}, {35, 15}, {30, 20}};
}

// Four walls in one edge: neither printers nor solid modellers take that.
void TestObjWriter::touchingHolesStayManifold()
{
    QFETCH(Polygon, first);
    QFETCH(Polygon, second);
    QCOMPARE(whatIsWrong(cutOf(single(polygonContour(rectangleAt(0, 0, 40, 40)),
                                      {polygonContour(first), polygonContour(second)})),
                         true),
             QString());
}

void TestObjWriter::sharedModels_data()
{
    QTest::addColumn<QString>("path");
    const QDir folder(QStringLiteral(FFF_SHARED_MODELS));
    for (const QString &file : folder.entryList({QStringLiteral("*.txt")}, QDir::Files, QDir::Name))
        QTest::newRow(qPrintable(file)) << folder.filePath(file);
    if (folder.isEmpty())
        QTest::newRow("none") << QString();
}

void TestObjWriter::sharedModels()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        FFF_WITHOUT_SHARED();
    Result<io::LoadedDocument> read = io::readDocument(path);
    QVERIFY(read);
    QCOMPARE(whatIsWrong(cutOf(evaluate(std::move(read->document)))), QString());
}

// Seen from inside out a solid has a negative volume, whichever way its frame is turned.
void TestObjWriter::facesLookOutwards()
{
    for (const Frame &frame : {front(), side(), Frame{{1, 2, 3}, Vec3::UnitY(), Vec3::UnitX()},
                               Frame{{0, 9, 0}, Vec3::UnitZ(), Vec3::UnitX()}})
        QCOMPARE(whatIsWrong(cutOf(single(polygonContour(rectangleAt(0, 0, 40, 20)), {}, frame))),
                 QString());
}

void TestObjWriter::verticesAreThereOnce()
{
    const Cut cut = cutOf(twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                      polygonShape(rectangle(-50, 0, 50, 50)), side()));
    std::set<QByteArray> seen;
    for (const QByteArray &line :
         QByteArray::fromStdString(*io::writeObj(cut.model, cut.bodies)).split('\n')) {
        if (line.startsWith("o "))
            seen.clear();
        if (line.startsWith("v "))
            QVERIFY2(seen.insert(line).second, line.constData());
    }
    QCOMPARE(seen.size(), 16U); // two faces of a plate with one slit
}

void TestObjWriter::namesAreSafeAndUnique()
{
    Document document = newDocument();
    const ShapePointer shape = polygonShape(rectangle(0, 0, 10, 10));
    for (int i = 0; i < 4; ++i)
        document = withSection(document, shape, front(20.0 * i));
    const std::vector<std::string> names{"Rippe 3", "Rippe_3", "Flügel\n#2", ""};
    for (std::size_t i = 0; i < names.size(); ++i) {
        Section section = *document.sections[i];
        section.name = names[i];
        document.sections[i] = std::make_shared<const Section>(section);
    }
    const Cut cut = cutOf(evaluate(document));
    QList<QByteArray> groups;
    for (const QByteArray &line :
         QByteArray::fromStdString(*io::writeObj(cut.model, cut.bodies)).split('\n'))
        if (line.startsWith("g "))
            groups += line.mid(2);
    QCOMPARE(groups, (QList<QByteArray>{"Rippe_3", "Rippe_3_2", "Flügel__2", "section"}));
}

void TestObjWriter::sameBytesForSameInput()
{
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-50, 0, 50, 50)), side());
    const Cut a = cutOf(model), b = cutOf(model);
    QVERIFY(io::writeObj(a.model, a.bodies) == io::writeObj(b.model, b.bodies));
}

void TestObjWriter::emptyModel()
{
    const Cut cut = cutOf(evaluate(newDocument()));
    QVERIFY(io::writeObj(cut.model, cut.bodies)->starts_with("# FlatFitFab"));
}

FFF_TEST(TestObjWriter)
#include "tst_obj_writer.moc"
