// Laws and counts over real models, read in place where they are; skipped with a message elsewhere.
#include "core/assembly/assembly.h"
#include "core/assembly/cut_section.h"
#include "core/base/tolerances.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/test_program.h"

#include <QDir>
#include <QTest>

#include <cmath>
#include <set>

using namespace fff;

namespace {

const QString kFolder = QStringLiteral(FFF_SHARED_MODELS);

/// The pairs that meet by other means than the product's: plain arithmetic on 40 chords a segment,
/// crossings of each contour with the other's plane in the world, paired by even-odd.
std::set<std::pair<int, int>> pairsByHand(const Model &model)
{
    struct Sampled
    {
        std::vector<std::vector<Vec3>> rings;
        Vec3 normal, origin;
    };
    std::vector<Sampled> sections;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        Sampled sampled{{}, section.frame.normal(), section.frame.origin};
        std::vector<Contour> contours{section.shape->contour()};
        contours.insert(contours.end(), section.shape->holes().begin(),
                        section.shape->holes().end());
        for (const Contour &contour : contours) {
            std::vector<Vec3> &ring = sampled.rings.emplace_back();
            for (int s = 0; s < contour.segmentCount(); ++s)
                for (int k = 0; k < 40; ++k)
                    ring.push_back(section.frame.toWorld(contour.segment(s).at(k / 40.0)));
        }
        sections.push_back(std::move(sampled));
    }
    const auto stretches = [](const Sampled &cut, const Sampled &by, const Vec3 &direction) {
        std::vector<double> at;
        for (const std::vector<Vec3> &ring : cut.rings)
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                const double a = by.normal.dot(ring[j] - by.origin),
                             b = by.normal.dot(ring[i] - by.origin);
                if ((a >= 0) != (b >= 0))
                    at.push_back(direction.dot(ring[j] + a / (a - b) * (ring[i] - ring[j])));
            }
        std::sort(at.begin(), at.end());
        return at;
    };
    std::set<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < sections.size(); ++i)
        for (std::size_t j = i + 1; j < sections.size(); ++j) {
            const Vec3 direction = sections[i].normal.cross(sections[j].normal);
            if (direction.norm() < std::sin(kMinJointAngle))
                continue;
            const auto a = stretches(sections[i], sections[j], direction.normalized());
            const auto b = stretches(sections[j], sections[i], direction.normalized());
            for (std::size_t k = 0; k + 1 < a.size(); k += 2)
                for (std::size_t l = 0; l + 1 < b.size(); l += 2)
                    if (std::min(a[k + 1], b[l + 1]) - std::max(a[k], b[l]) > kMinOverlap)
                        pairs.insert({static_cast<int>(i), static_cast<int>(j)});
        }
    return pairs;
}

} // namespace

class TestSharedModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void laws_data();
    void laws();
};

void TestSharedModels::initTestCase()
{
    if (!QDir(kFolder).exists())
        FFF_WITHOUT_SHARED();
}

void TestSharedModels::laws_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("joinedPairs"); // counted by others; −1: only by hand, above

    const QHash<QString, int> known = {
        {QStringLiteral("bridge.txt"), 220},  {QStringLiteral("dino.txt"), 44},
        {QStringLiteral("octopus.txt"), 133}, {QStringLiteral("fish.txt"), 41},
        {QStringLiteral("dragon1.txt"), 84},  {QStringLiteral("spider.txt"), 30}};
    for (const QString &file : QDir(kFolder).entryList({QStringLiteral("*.txt")}, QDir::Files))
        QTest::newRow(qPrintable(file)) << file << known.value(file, -1);
}

// Each of these wrong means parts that do not fit: a pair without slits, a slit that nothing can
// slide into, a part whose area is not what the slits leave.
void TestSharedModels::laws()
{
    QFETCH(QString, file);
    QFETCH(int, joinedPairs);
    const Result<io::LoadedDocument> loaded = io::readDocument(kFolder + u'/' + file);
    QVERIFY(loaded.has_value());
    const Model model = evaluate(loaded->document);
    CutCache cuts;
    const Assembly assembly = assemble(model);

    std::set<std::pair<int, int>> pairs;
    for (const Joint &joint : assembly.joints)
        pairs.insert({joint.a, joint.b});
    QVERIFY(pairs == pairsByHand(model));
    if (joinedPairs >= 0)
        QCOMPARE(static_cast<int>(pairs.size()), joinedPairs);

    for (const Joint &joint : assembly.joints) {
        if (joint.kind == JointKind::None || joint.kind == JointKind::Mortise)
            continue;
        for (std::size_t k = 0; k < joint.crossing->overlaps.size(); ++k) {
            const Vec3 meet = joint.crossing->axis.at(joint.crossing->overlaps[k].meet);
            for (const int index : {joint.a, joint.b}) {
                const auto &slits = assembly.slits[static_cast<std::size_t>(index)];
                const auto slit = std::find_if(slits.begin(), slits.end(), [&](const Slit &s) {
                    return s.joint == joint.id && s.overlap == static_cast<int>(k);
                });
                // Where an end lies on a hole, one slit takes the whole overlap. No model has that.
                QVERIFY(slit != slits.end());
                const Section &host = *model.section(static_cast<std::size_t>(index));
                QVERIFY((host.frame.toWorld(slit->inner) - meet).norm() < 1e-7);
                QCOMPARE(locate(slit->mouth, host.shape->region()), Side::Outside);
            }
        }
    }

    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const ShapePointer &shape = model.section(i)->shape;
        const CutSectionPointer cut = cutSection(shape, assembly.slits[i], cuts);
        double curved = 0.0;
        for (const CurvedRegion &part : cut->parts()) {
            QVERIFY(part.outer.signedArea() > 0.0);
            curved += part.outer.signedArea();
            for (const Contour &hole : part.holes)
                curved += hole.signedArea();
        }
        // What the slits take away, on much finer chords: there the curves' bulges cancel but for
        // those at the slits' mouths, so the chords need to be as fine as these ask for.
        if (assembly.slits[i].empty())
            continue;
        std::vector<Polygon> outlines;
        double widths = 0.0;
        for (const Slit &slit : assembly.slits[i]) {
            outlines.push_back(slit.outline());
            widths += slit.width;
        }
        const double fineChord = 0.5e-6 * shape->area() / widths;
        double taken = area(shape->flatten(fineChord));
        const auto parts = *subtract(shape->contour(), shape->holes(), outlines, fineChord);
        for (const CurvedRegion &part : parts)
            taken -= area(part.region);
        QVERIFY2(std::abs(shape->area() - curved - taken) <= 1e-6 * curved,
                 qPrintable(QStringLiteral("section %1: %2 against %3")
                                .arg(i)
                                .arg(curved, 0, 'g', 12)
                                .arg(shape->area() - taken, 0, 'g', 12)));
    }
}

FFF_TEST(TestSharedModels)
#include "tst_shared_models.moc"
