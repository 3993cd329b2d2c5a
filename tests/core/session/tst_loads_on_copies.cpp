// Weights and pushes through all that can be done to a model: operations carry them along, and
// nothing that only takes a model down in another way changes what acts on it.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/polygon.h"
#include "core/io/document_file.h"
#include "core/model/load_edits.h"
#include "core/model/moving.h"
#include "core/model/operation_edits.h"
#include "core/model/placed_loads.h"
#include "core/operations/baking.h"
#include "core/operations/evaluate.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"
#include "tests/test_program.h"

#include <QDir>
#include <QTemporaryDir>

#include <algorithm>
#include <random>
#include <set>

using namespace fff;

// What would be wrong: a weight that is lost with an operation, is there twice after baking, or
// acts somewhere else on a copy than on what that is a copy of.

namespace {

Document sample(const QString &file)
{
    return io::readDocument(QStringLiteral(FFF_SAMPLES "/") + file).value().document;
}

/// A place on its material.
Vec2 somewhereOn(const Section &section, std::mt19937 &random)
{
    const Box2 &box = section.shape->bounds();
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 at =
            box.min + Vec2(share(random), share(random)).cwiseProduct(Vec2(box.max - box.min));
        if (locate(at, section.shape->region()) == Side::Inside)
            return at;
    }
    return section.shape->centroid();
}

/// A weight and a push on each drawn section, and one on every seventh that is made.
Document loaded(Document document, unsigned seed)
{
    std::mt19937 random(seed);
    document.loads.clear();
    const Model model = evaluate(document);
    const auto put = [&](const Section &section, LoadKind kind) {
        Load load;
        load.section = section.ref();
        load.position = somewhereOn(section, random);
        load.kind = kind;
        load.mass = 0.01 * static_cast<double>(1 + random() % 100);
        load.push = Vec3(1.0, 2.0, 3.0 + static_cast<double>(random() % 5));
        document = addLoad(std::move(document), load).value();
    };
    for (const SectionPointer &section : document.sections) {
        put(*section, LoadKind::Weight);
        put(*section, LoadKind::Push);
    }
    for (std::size_t i = model.drawnCount(); i < model.sectionCount(); i += 7)
        put(*model.section(i), LoadKind::Weight);
    return document;
}

/// What acts on the model, whatever it is told by: kilograms and newtons at places of the world, as
/// whole thousandths.
using Acting = std::multiset<std::vector<long>>;

Acting actingOn(const Model &model)
{
    Acting acting;
    for (const PlacedLoad &placed : placedLoads(model)) {
        const Load &load = model.document.loads[static_cast<std::size_t>(placed.load)];
        const Frame &frame = model.section(static_cast<std::size_t>(placed.section))->frame;
        const Vec3 at = frame.toWorld(placed.position);
        const Vec3 force = load.isPush()
                               ? Vec3(placed.push.x() * frame.x + placed.push.y() * frame.y +
                                      placed.push.z() * frame.normal())
                               : Vec3(load.mass, 0.0, 0.0);
        std::vector<long> row{load.isPush() ? 1 : 0};
        for (const double number : {at.x(), at.y(), at.z(), force.x(), force.y(), force.z()})
            row.push_back(std::lround(1e3 * number));
        acting.insert(row);
    }
    return acting;
}

/// The same but for the rounding of thousandths.
bool isNearly(const Acting &a, const Acting &b)
{
    std::vector<std::vector<long>> rest(b.begin(), b.end());
    for (const std::vector<long> &row : a) {
        const auto found = std::find_if(rest.begin(), rest.end(), [&](const auto &other) {
            return std::equal(row.begin(), row.end(), other.begin(),
                              [](long x, long y) { return std::abs(x - y) <= 1; });
        });
        if (found == rest.end())
            return false;
        rest.erase(found);
    }
    return rest.empty();
}

} // namespace

class TestLoadsOnCopies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase_data();
    void copiesAreWhereTheySay();
    void bakingKeepsWhatActs();
    void detachingKeepsWhatActs();
    void excerptsTakeTheirsAlong();
    void filesKeepThem();
    void aloneIsAlone();
    void theyComeBack();
    void mirroredPushesAreMirrored();
    void cleanupTestCase() { QVERIFY(m_looked > 50); }

private:
    int m_looked = 0; // copies by their control points
};

void TestLoadsOnCopies::initTestCase_data()
{
    QTest::addColumn<QString>("file");
    for (const QString &file :
         QDir(QStringLiteral(FFF_SAMPLES)).entryList({QStringLiteral("*.fff")}))
        QTest::newRow(qPrintable(file)) << file;
}

/// By the control points, which know nothing of the way that is kept: a copy with as many of them
/// has each where the way puts it.
void TestLoadsOnCopies::copiesAreWhereTheySay()
{
    QFETCH_GLOBAL(QString, file);
    const Model model = evaluate(sample(file));
    int looked = 0;
    for (std::size_t i = model.drawnCount(); i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        const Section *source = section.copyOf ? model.find(section.copyOf->section) : nullptr;
        if (!source ||
            source->shape->contour().points().size() != section.shape->contour().points().size())
            continue;
        const std::vector<Vec2> &from = source->shape->contour().points();
        const std::vector<Vec2> &to = section.shape->contour().points();
        for (std::size_t k = 0; k < from.size(); ++k)
            QVERIFY2(((*section.copyOf)(from[k]) - to[k]).norm() < 1e-6, section.name.c_str());
        ++looked;
    }
    m_looked += looked;
}

void TestLoadsOnCopies::bakingKeepsWhatActs()
{
    QFETCH_GLOBAL(QString, file);
    Model model = evaluate(loaded(sample(file), 1));
    for (int round = 0; round < 20 && !model.document.operations.empty(); ++round) {
        const Acting before = actingOn(model);
        const auto next = baked(model, model.document.operations.front()->id);
        QVERIFY(next);
        const std::size_t sections = model.sectionCount();
        model = evaluate(*next);
        QCOMPARE(model.sectionCount(), sections);
        QVERIFY(isNearly(actingOn(model), before));
    }
    QVERIFY(model.document.operations.empty());
}

void TestLoadsOnCopies::detachingKeepsWhatActs()
{
    QFETCH_GLOBAL(QString, file);
    const Model model = evaluate(loaded(sample(file), 2));
    if (model.drawnCount() == model.sectionCount())
        return;
    // What nothing else is made of: else that would change, too.
    const SectionRef last = model.ref(model.sectionCount() - 1);
    const auto next = detached(model, last);
    QVERIFY(next);
    const Model after = evaluate(*next);
    if (after.sectionCount() == model.sectionCount()) // a symmetry of all goes on with it
        QVERIFY(isNearly(actingOn(after), actingOn(model)));
}

/// All of it, copied into an empty document, once as it is and once each section as a drawn one.
void TestLoadsOnCopies::excerptsTakeTheirsAlong()
{
    QFETCH_GLOBAL(QString, file);
    const Model model = evaluate(loaded(sample(file), 3));
    std::vector<SectionRef> all;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        all.push_back(model.ref(i));
    const Insertion whole = inserted(newDocument(), excerpt(model, all));
    QVERIFY(isNearly(actingOn(evaluate(whole.document)), actingOn(model)));
    if (model.drawnCount() == model.sectionCount())
        return;
    const SectionRef one = model.ref(model.drawnCount());
    const Model alone = evaluate(excerpt(model, {one}));
    const Acting found = actingOn(alone);
    Acting wanted;
    for (const PlacedLoad &placed : placedLoads(model))
        if (model.ref(static_cast<std::size_t>(placed.section)) == one)
            wanted.insert({});
    QVERIFY(found.size() >= wanted.size()); // more where what it is made of came along
}

void TestLoadsOnCopies::filesKeepThem()
{
    QFETCH_GLOBAL(QString, file);
    Document document = loaded(sample(file), 4);
    for (std::size_t i = 0; i < document.loads.size(); ++i) {
        Load &load = document.loads[i];
        load.spread = static_cast<Spread>(i % (load.isPush() ? 3 : 4));
        load.width = 5.0 + static_cast<double>(i);
        load.isRepeated = i % 3 != 0;
        if (load.spread == Spread::Point || load.spread == Spread::Hanging)
            load.width = Load().width; // that is not kept where nothing is spread
        if (load.isPush()) {
            load.mass = Load().mass;
        } else {
            load.push.setZero();
            load.height = static_cast<double>(i % 4);
            load.filled = 0.5 * load.mass;
            load.preset = i % 2 ? "glass" : "";
        }
    }
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("loads.fff"));
    QVERIFY(io::writeDocument(path, document));
    const auto back = io::readDocument(path);
    QVERIFY(back);
    QVERIFY(back->document.loads == document.loads);
}

void TestLoadsOnCopies::aloneIsAlone()
{
    QFETCH_GLOBAL(QString, file);
    Document document = loaded(sample(file), 5);
    for (Load &load : document.loads)
        load.isRepeated = false;
    const Model model = evaluate(document);
    for (const PlacedLoad &placed : placedLoads(model))
        QVERIFY(!placed.isCopy);
}

/// Operations that are switched off, and on again.
void TestLoadsOnCopies::theyComeBack()
{
    QFETCH_GLOBAL(QString, file);
    const Document document = loaded(sample(file), 6);
    const Acting before = actingOn(evaluate(document));
    Document off = document;
    for (const OperationPointer &operation : document.operations) {
        Operation next = *operation;
        next.isOn = false;
        off = setOperation(std::move(off), next).value();
    }
    const Model without = evaluate(off);
    for (const PlacedLoad &placed : placedLoads(without))
        QVERIFY(!placed.isCopy);
    for (const OperationPointer &operation : document.operations)
        off = setOperation(std::move(off), *operation).value();
    QVERIFY(actingOn(evaluate(off)) == before);
}

/// All drawn sections across the plane x = 0, once without and once with the operations' copies.
void TestLoadsOnCopies::mirroredPushesAreMirrored()
{
    QFETCH_GLOBAL(QString, file);
    Document document = loaded(sample(file), 7);
    document.operations.clear();
    std::erase_if(document.loads, [](const Load &load) { return !load.section.drawn.isValid(); });
    std::vector<SectionMove> moves;
    const Eigen::Matrix3d across = Vec3(-1.0, 1.0, 1.0).asDiagonal();
    for (const SectionPointer &section : document.sections)
        moves.push_back({section->id, Similarity::turned(across, Vec3::Zero())});
    const auto moved = movedSections(document, moves);
    QVERIFY(moved);
    Acting wanted;
    for (std::vector<long> row : actingOn(evaluate(document))) {
        row[1] = -row[1];
        if (row[0] == 1)
            row[4] = -row[4];
        wanted.insert(row);
    }
    QVERIFY(isNearly(actingOn(evaluate(*moved)), wanted));
}

FFF_TEST(TestLoadsOnCopies)
#include "tst_loads_on_copies.moc"
