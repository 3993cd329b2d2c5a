// The order of assembly that `parts --json` gives, carried out by whoever has read nothing but the
// contract: every step moves its parts along a direction by a distance into their place, the
// earlier ones of its group being there; a step with "joins" moves one of two groups to the other.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/assembly/line_oracle.h"
#include "tests/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <map>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

QJsonValue at(const QJsonValue &object, const char *key)
{
    return object[QLatin1String(key)];
}

Vec3 vector(const QJsonValue &value)
{
    return {value[0].toDouble(), value[1].toDouble(), value[2].toDouble()};
}

Polygon ring(const QJsonValue &value)
{
    Polygon points;
    for (const QJsonValue &point : value.toArray())
        points.push_back(Vec2(point[0].toDouble(), point[1].toDouble()));
    return points;
}

std::set<int> numbers(const QJsonValue &value)
{
    std::set<int> found;
    for (const QJsonValue &number : value.toArray())
        found.insert(number.toInt());
    return found;
}

/// What is to be cut, by the numbers of the parts.
struct Table
{
    explicit Table(const QJsonArray &parts)
    {
        for (const QJsonValue &part : parts) {
            Region &region = regions[at(part, "number").toInt()];
            region.outer = ring(at(part, "outer"));
            for (const QJsonValue &hole : at(part, "holes").toArray())
                region.holes.push_back(ring(hole));
            const QJsonValue frame = at(part, "frame");
            plates.emplace(at(part, "number").toInt(),
                           CutPlate{&region,
                                    {vector(at(frame, "origin")), vector(at(frame, "x")),
                                     vector(at(frame, "y"))},
                                    0.5 * at(part, "thickness").toDouble(),
                                    bounds(region.outer)});
        }
    }

    std::map<int, Region> regions;
    std::map<int, CutPlate> plates;
};

/// Takes the parts out of their place against the way, and looks whether they run into the others.
QString collision(const Table &table, const std::set<int> &moved, const std::set<int> &there,
                  const Vec3 &way)
{
    constexpr int kPlaces = 50;
    for (int i = 0; i <= kPlaces; ++i)
        for (const int part : moved)
            for (const int other : there)
                if (areInEachOther(table.plates.at(other), table.plates.at(part),
                                   -way * (static_cast<double>(i) / kPlaces)))
                    return QStringLiteral("%1 runs into %2").arg(part).arg(other);
    return {};
}

/// Empty when the steps put all parts together.
QString fault(const QJsonObject &json)
{
    const Table table(json[QLatin1String("parts")].toArray());
    const QJsonArray steps = json[QLatin1String("assembly")].toArray();
    std::vector<std::set<int>> together; // after each step: the parts of its group
    std::map<int, int> lastOf;           // of each group that is still one of its own
    for (int i = 0; i < steps.size(); ++i) {
        const QString where = QStringLiteral("step %1: ").arg(i);
        const std::set<int> moved = numbers(at(steps[i], "parts"));
        const std::set<int> joins = numbers(at(steps[i], "joins"));
        const int group = at(steps[i], "group").toInt(-1);
        std::set<int> there;
        if (!joins.empty()) {
            if (joins.size() != 2 || *joins.begin() < 0 || *joins.rbegin() >= i)
                return where + QStringLiteral("joins no two earlier steps");
            for (const int joined : joins) {
                const auto last = std::find_if(lastOf.begin(), lastOf.end(),
                                               [&](const auto &g) { return g.second == joined; });
                if (last == lastOf.end())
                    return where + QStringLiteral("joins what is no group's last step");
                lastOf.erase(last);
            }
            const auto &first = together[static_cast<std::size_t>(*joins.begin())];
            const auto &second = together[static_cast<std::size_t>(*joins.rbegin())];
            if (moved != first && moved != second)
                return where + QStringLiteral("moves neither group");
            there = moved == first ? second : first;
        } else {
            if (moved.size() != 1)
                return where + QStringLiteral("moves several parts, and joins nothing");
            if (lastOf.contains(group))
                there = together[static_cast<std::size_t>(lastOf.at(group))];
        }
        const double distance = at(steps[i], "distance").toDouble();
        if (there.empty() && distance != 0.0)
            return where + QStringLiteral("what is begun with comes from nowhere");
        const QString runs =
            collision(table, moved, there, vector(at(steps[i], "direction")) * distance);
        if (!runs.isEmpty())
            return where + runs;
        there.insert(moved.begin(), moved.end());
        together.push_back(there);
        lastOf[group] = i;
    }
    if (lastOf.size() != 1 || together.back().size() != table.plates.size())
        return QStringLiteral("not all parts are together at the end");
    return {};
}

} // namespace

class tst_cli_assembly : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theOrderIsWhatItSays_data()
    {
        QTest::addColumn<Document>("document");
        QTest::addColumn<int>("joining"); // steps
        QTest::newRow("a comb") << combModel(4) << 0;
        QTest::newRow("an egg crate") << eggCrate(3, 3) << 0;
        QTest::newRow("shelves in two frames") << furnished() << 1;
        Document twice = furnished();
        for (const auto &section : furnished().sections) {
            Frame frame = section->frame;
            frame.origin.x() += 500.0;
            twice = withSection(std::move(twice), section->shape, frame);
        }
        QTest::newRow("two pieces of furniture") << twice << 3;
        QTest::newRow("a comb over ribs") << combOverRibs() << 0;
        QTest::newRow("a rib under a beam") << ribUnderABeam() << 0;
    }
    // Wrong: whoever follows the file's words moves parts through others, or looks for parts that
    // are not there yet.
    void theOrderIsWhatItSays()
    {
        QFETCH(Document, document);
        QFETCH(int, joining);
        const QString path = m_folder.filePath(QStringLiteral("model.fff"));
        QVERIFY(io::writeDocument(path, document));
        const Run made = run({QStringLiteral("parts"), path, QStringLiteral("--json")});
        QCOMPARE(made.status, 0);
        const QJsonObject json = QJsonDocument::fromJson(made.out).object();
        QCOMPARE(fault(json), QString());
        int joins = 0;
        for (const QJsonValue &step : json[QLatin1String("assembly")].toArray())
            joins += at(step, "joins").isArray();
        QCOMPARE(joins, joining);
        const Run text = run({QStringLiteral("parts"), path});
        QCOMPARE(text.out.count("as one, joining"), joining);
    }

private:
    QTemporaryDir m_folder;
};

FFF_TEST(tst_cli_assembly)
#include "tst_cli_assembly.moc"
