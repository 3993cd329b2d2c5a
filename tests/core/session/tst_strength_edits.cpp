// What is known of whether a model holds after any edits is what follows from the model alone.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/holding.h"
#include "core/io/document_file.h"
#include "core/model/load_edits.h"
#include "core/model/moving.h"
#include "core/operations/evaluate.h"
#include "core/session/finding_text.h"
#include "tests/core/session/random_edits.h"
#include "tests/rounds.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

// What would be wrong: a factor, a cut or a bending body of a model that is not there any more.

namespace {

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max({std::abs(a), std::abs(b), 1e-3});
}

bool areNear(const std::optional<double> &a, const std::optional<double> &b)
{
    // A search for a mass ends within 1e-4 of it, from wherever it began.
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= 2e-4 * std::abs(*a));
}

/// Empty where they are the same.
QString difference(const Holding &a, const Holding &b)
{
    const Strength &x = a.strength, &y = b.strength;
    if (x.verdict != y.verdict)
        return QStringLiteral("verdict");
    if (!isNear(x.neckUse, y.neckUse) || !isNear(x.cornerUse, y.cornerUse))
        return QStringLiteral("use %1 %2, %3 %4")
            .arg(x.neckUse, 0, 'g', 17)
            .arg(y.neckUse, 0, 'g', 17)
            .arg(x.cornerUse, 0, 'g', 17)
            .arg(y.cornerUse, 0, 'g', 17);
    const Equilibrium &e = x.equilibrium(), &f = y.equilibrium();
    if (e.balance() != f.balance() || e.feet.size() != f.feet.size())
        return QStringLiteral("balance");
    for (std::size_t i = 0; i < e.feet.size(); ++i)
        if ((e.feet[i].force - f.feet[i].force).norm() > 1e-9 * (1.0 + e.feet[i].force.norm()))
            return QStringLiteral("foot %1").arg(i);
    if (!areNear(a.bearable.cracksFrom, b.bearable.cracksFrom) ||
        !areNear(a.bearable.breaksAt, b.bearable.breaksAt))
        return QStringLiteral("bearable");
    if (a.findings.size() != b.findings.size())
        return QStringLiteral("findings");
    for (std::size_t i = 0; i < a.findings.size(); ++i)
        if (a.findings[i].kind != b.findings[i].kind ||
            a.findings[i].sections != b.findings[i].sections)
            return QStringLiteral("finding %1").arg(i);
    return {};
}

/// One model after the other, as the stages see them.
class Following
{
public:
    explicit Following(bool isElastic) { m_rules.isElastic = isElastic; }

    /// Of the document as it follows from those before, and from scratch.
    QString look(const Document &document)
    {
        m_model = evaluate(document, m_model);
        const Holding next = holdingOf(analyseNext(m_model, m_analyses), m_rules, m_strengths);
        AnalysisCaches nothing;
        const Holding fresh = holdingOf(analyseNext(evaluate(document), nothing), m_rules,
                                        std::make_shared<StrengthCaches>());
        m_standing += fresh.strength.equilibrium().balance() == Balance::Stands ? 1 : 0;
        return difference(next, fresh);
    }
    int standing() const { return m_standing; }

private:
    StrengthRules m_rules;
    Model m_model = evaluate(newDocument());
    AnalysisCaches m_analyses;
    std::shared_ptr<StrengthCaches> m_strengths = std::make_shared<StrengthCaches>();
    int m_standing = 0;
};

/// Loads come, move, change and go.
Document withOtherLoads(Document document, RandomEdits &edits)
{
    const int sections = static_cast<int>(document.sections.size());
    const int kind = edits.below(6);
    if (sections == 0)
        return document;
    const Section &section = *document.sections[static_cast<std::size_t>(edits.below(sections))];
    if (document.loads.empty() || kind == 0) {
        Load load;
        load.section = section.ref();
        load.position = section.shape->centroid();
        load.spread = static_cast<Spread>(edits.below(3));
        if (edits.below(3) == 0) {
            load.kind = LoadKind::Push;
            load.push = Vec3(edits.below(3) - 1, edits.below(3) - 1, 0.5);
        }
        return *addLoad(std::move(document), load);
    }
    Load load =
        document
            .loads[static_cast<std::size_t>(edits.below(static_cast<int>(document.loads.size())))];
    if (kind == 1 || document.loads.size() > 4)
        return *removeLoad(std::move(document), load.id);
    if (kind == 2)
        load.mass = load.filled + 0.05 + 0.1 * edits.below(20);
    else if (kind == 3)
        load.position += Vec2(edits.below(7) - 3, edits.below(7) - 3);
    else
        load.width = 1.0 + edits.below(60);
    return *setLoad(std::move(document), load);
}

} // namespace

class TestStrengthEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void platesAtRandom();
    void samples_data();
    void samples();
};

void TestStrengthEdits::platesAtRandom()
{
    RandomEdits edits(23);
    Following following(false);
    Document document = newDocument();
    for (int i = 0; i < rounds(250); ++i) {
        document = edits.next(document);
        if (edits.below(2) == 0)
            document = withOtherLoads(std::move(document), edits);
        const QString what = following.look(document);
        QVERIFY2(what.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(i).arg(what)));
    }
}

void TestStrengthEdits::samples_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("isElastic");
    QTest::addColumn<int>("edits");
    QTest::newRow("glass") << "glass_four_legs.fff" << false << 450;
    QTest::newRow("cutlery") << "cutlery_man.fff" << false << 250;
    QTest::newRow("glass that bends") << "glass_three_legs.fff" << true << 50;
}

/// Sections that are shifted in their planes, other sheets, other loads.
void TestStrengthEdits::samples()
{
    QFETCH(QString, file);
    QFETCH(bool, isElastic);
    QFETCH(int, edits);
    Document document = io::readDocument(QStringLiteral(FFF_SAMPLES "/") + file).value().document;
    const Document first = document;
    RandomEdits random(7);
    Following following(isElastic);
    for (int i = 0; i < rounds(edits); ++i) {
        const int kind = random.below(8);
        const SectionId id = document
                                 .sections[static_cast<std::size_t>(
                                     random.below(static_cast<int>(document.sections.size())))]
                                 ->id;
        if (kind == 0) {
            document = first; // as by Undo
        } else if (kind == 1) {
            Stock stock = *document.stocks.front();
            stock.thickness = 2.0 + 0.5 * random.below(5);
            document = *setStock(std::move(document), stock);
        } else if (kind < 4) {
            const Frame &frame = document.find(id)->frame;
            const SectionMove move{id,
                                   Similarity::moved(0.2 * (random.below(5) - 2) * Vec3(frame.x))};
            if (auto moved = movedSections(document, std::span(&move, 1)))
                document = *std::move(moved);
        } else {
            document = withOtherLoads(std::move(document), random);
        }
        const QString what = following.look(document);
        QVERIFY2(what.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(i).arg(what)));
    }
    QVERIFY(following.standing() > rounds(edits) / 3);
}

FFF_TEST(TestStrengthEdits)
#include "tst_strength_edits.moc"
