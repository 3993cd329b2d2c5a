// The reference cases of mechanics as models that a person has drawn: joints, slits, feet and
// weights are found by the product; what a solver in three dimensions says of them stays true.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/footing.h"
#include "core/analysis/strength.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/operations/evaluate.h"
#include "tests/core/physics/reference_case.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"
#include "tests/told.h"

#include <QDir>

#include <cmath>
#include <numeric>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

const QString kCases = QStringLiteral(FFF_SHARED "/mechanics/cases");

/// Z up to Y up, and the ground at 0.
class Placed
{
public:
    explicit Placed(const Structure &structure) : m_ground(groundOf(structure)) {}

    Vec3 direction(const Vec3 &v) const { return {v.x(), v.z(), -v.y()}; }
    Vec3 point(const Vec3 &p) const { return direction(p - Vec3(0, 0, m_ground)); }

private:
    static double groundOf(const Structure &structure)
    {
        return structure.feet.empty() ? 0.0 : structure.feet.front().point.z();
    }
    double m_ground;
};

Document documentOf(const ReferenceCase &given)
{
    const Placed placed(given.structure);
    Document document = newDocument();
    for (const ReferenceSection &section : given.sections) {
        Stock stock;
        stock.name = section.id;
        stock.thickness = section.thickness;
        stock.density = section.material.density;
        stock.modulus = section.material.modulus;
        stock.tensileStrength = section.material.tensileStrength;
        stock.clearance = 0.0;
        document = *addStock(std::move(document), stock);
        std::vector<Contour> holes;
        for (const Polygon &hole : section.holes)
            holes.push_back(polygonContour(hole));
        NewSection made;
        made.name = section.id;
        made.shape = Shape::make(polygonContour(section.outline), holes).value();
        made.frame = {placed.point(section.frame.origin), placed.direction(section.frame.x),
                      placed.direction(section.frame.y)};
        made.stock = document.currentStock;
        document = *addSection(std::move(document), made);
    }
    for (const MemberLoad &load : given.structure.loads) {
        Load weight;
        const Section &on = *document.sections[static_cast<std::size_t>(load.member)];
        weight.section = on.id;
        weight.position = on.frame.toLocal(placed.point(load.point));
        weight.mass = load.force.norm() / given.structure.gravity.norm();
        document = *addLoad(std::move(document), weight);
    }
    return document;
}

/// Models can say it: no section is clamped, and all that presses on it is a weight.
bool isModel(const ReferenceCase &given)
{
    if (!given.clamps.empty())
        return false;
    for (const MemberLoad &load : given.structure.loads)
        if (load.moment != Vec3::Zero() || std::hypot(load.force.x(), load.force.y()) > 0.0 ||
            load.force.z() >= 0.0)
            return false;
    return true;
}

/// Of each member along `up`, N.
std::vector<double> pressingOf(const std::vector<Foot> &feet, const std::vector<Vec3> &reactions,
                               std::size_t members, const Vec3 &up)
{
    std::vector<double> pressing(members, 0.0);
    for (std::size_t i = 0; i < reactions.size(); ++i)
        pressing[static_cast<std::size_t>(feet[i].member)] += reactions[i].dot(up);
    return pressing;
}

/// Glued and loose slits come to the same: what rigid sections have to find, too.
bool isSharedInOneWay(const ReferenceCase &given)
{
    const std::size_t members = given.sections.size();
    const auto pressing = [&](const std::vector<Vec3> &reactions) {
        return pressingOf(given.structure.feet, reactions, members, Vec3::UnitZ());
    };
    if (given.truth.reactions.empty())
        return false;
    if (given.contact.reactions.empty())
        return true;
    const std::vector<double> glued = pressing(given.truth.reactions),
                              loose = pressing(given.contact.reactions);
    for (std::size_t i = 0; i < members; ++i)
        if (std::abs(glued[i] - loose[i]) > 0.01 * (std::abs(glued[i]) + std::abs(loose[i])))
            return false;
    return true;
}

} // namespace

class TestCaseModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asDrawn_data();
    void asDrawn();
    void bendingSharesTheLoad();
};

void TestCaseModels::asDrawn_data()
{
    QTest::addColumn<QString>("path");
    for (const QFileInfo &file :
         QDir(kCases).entryInfoList({u"c*.json"_s}, QDir::Files, QDir::Name))
        QTest::newRow(qPrintable(file.completeBaseName())) << file.filePath();
    if (QDir(kCases).entryList({u"c*.json"_s}).isEmpty())
        QTest::newRow("no cases here") << QString();
}

// Wrong: right mechanics of a structure that is not the one that was drawn.
void TestCaseModels::asDrawn()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        FFF_WITHOUT_SHARED();
    QString error;
    const auto given = readReferenceCase(path, &error);
    QVERIFY2(given, qPrintable(error));
    if (!isModel(*given))
        return; // what is clamped nobody can draw
    AnalysisCaches analysisCaches;
    const Analysis analysis = analyse(evaluate(documentOf(*given)), analysisCaches);
    StrengthCaches caches;
    const Strength strength = strengthOf(analysis, {}, caches);
    const Structure &structure = strength.made.structure;
    QCOMPARE(structure.members.size(), given->sections.size());
    QCOMPARE(structure.links.size(), given->structure.links.size());
    std::vector<int> all(strength.bodies.size());
    std::iota(all.begin(), all.end(), 0);
    const Equilibrium &equilibrium = strength.equilibrium();
    if (given->truth.balance == Balance::LineSupport)
        // A file has the edge as a line; a sheet stands on it as wide as it is thick.
        QVERIFY(equilibrium.components.front().body.margin <= 0.5 * structure.thickness);
    else if (given->truth.balance)
        QCOMPARE(equilibrium.balance(), *given->truth.balance);
    if (equilibrium.components.size() == 1)
        QCOMPARE(equilibrium.balance() == Balance::Stands,
                 stabilityOf(analysis, all).standing == Standing::Stands);
    if (given->truth.mass) {
        double mass = 0.0;
        for (const Member &member : structure.members)
            mass += member.mass;
        QVERIFY(std::abs(mass - *given->truth.mass) < 5e-3 * mass);
    }
    if (equilibrium.balance() != Balance::Stands || !isSharedInOneWay(*given))
        return;
    const std::vector<double> truth = pressingOf(given->structure.feet, given->truth.reactions,
                                                 given->sections.size(), Vec3::UnitZ());
    std::vector<Vec3> reactions;
    for (const FootForce &foot : equilibrium.feet)
        reactions.push_back(foot.force);
    const std::vector<double> ours =
        pressingOf(structure.feet, reactions, truth.size(), Vec3::UnitY());
    const double sum = std::accumulate(truth.begin(), truth.end(), 0.0);
    for (std::size_t i = 0; i < truth.size(); ++i)
        QVERIFY2(std::abs(ours[i] - truth[i]) < 2e-3 * sum,
                 qPrintable(u"%1 N, of %2"_s.arg(ours[i]).arg(truth[i])));
    // The worst of a section is no less than what a solver finds at a place of it.
    for (const ReferenceCut &cut : given->truth.cuts) {
        const BodyStrength &body = strength.bodies[static_cast<std::size_t>(cut.section)];
        QVERIFY(body.isWorkedOut && body.neck);
        if (const auto linear = cut.fem.find("sigma_lin"); linear != cut.fem.end())
            QVERIFY2(body.neck->stress.neck >= 0.95 * linear->second, cut.name.c_str());
    }
}

// Wrong: of a stand that is redundant the stiffer feet bear what rigid sections would have them
// bear (10.4 and 1.2 N), not what finite elements with real contacts find.
void TestCaseModels::bendingSharesTheLoad()
{
    const auto given =
        readReferenceCase(kCases + u"/c10_crossed_stand_indeterminate.json"_s, nullptr);
    if (!given)
        FFF_WITHOUT_SHARED();
    AnalysisCaches analysisCaches;
    const Analysis analysis = analyse(evaluate(documentOf(*given)), analysisCaches);
    StrengthCaches caches;
    StrengthRules rules;
    rules.isElastic = true;
    const Strength strength = strengthOf(analysis, rules, caches);
    QVERIFY(strength.isElastic);
    QVERIFY(strength.stiff.empty());
    std::vector<Vec3> reactions;
    for (const FootForce &foot : strength.equilibrium().feet)
        reactions.push_back(foot.force);
    const std::vector<double> ours =
        pressingOf(strength.made.structure.feet, reactions, 2, Vec3::UnitY());
    const std::vector<double> truth =
        pressingOf(given->structure.feet, given->contact.reactions, 2, Vec3::UnitZ());
    QVERIFY2(std::abs(ours[0] - truth[0]) < 0.5,
             qPrintable(u"%1 N, of %2"_s.arg(ours[0]).arg(truth[0])));
    QVERIFY2(std::abs(ours[1] - truth[1]) < 0.5,
             qPrintable(u"%1 N, of %2"_s.arg(ours[1]).arg(truth[1])));
    for (const ReferenceCut &cut : given->truth.cuts)
        if (const auto linear = cut.fem.find("sigma_lin"); linear != cut.fem.end())
            QVERIFY2(strength.bodies[static_cast<std::size_t>(cut.section)].neck->stress.neck >=
                         0.95 * linear->second,
                     cut.name.c_str());
}

FFF_TEST(TestCaseModels)
#include "tst_case_models.moc"
