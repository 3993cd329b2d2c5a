#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/frontal_factors.h"
#include "tests/test_program.h"

#include <Eigen/Dense>
#include <limits>
#include <numeric>
#include <random>
#include <set>

using namespace fff;

namespace {

/// A system told as pieces, and the same as one matrix.
struct PiecedSystem
{
    std::vector<int> sizes;
    std::vector<std::vector<int>> blocks; // of the pieces
    std::vector<Eigen::MatrixXd> own, pieces;
    Eigen::MatrixXd whole;

    std::vector<int> unknownsOf(const std::vector<int> &some) const
    {
        std::vector<int> unknowns;
        for (const int block : some) {
            const int start = std::accumulate(sizes.begin(), sizes.begin() + block, 0);
            for (int i = 0; i < sizes[static_cast<std::size_t>(block)]; ++i)
                unknowns.push_back(start + i);
        }
        return unknowns;
    }
};

Eigen::MatrixXd positive(int size, std::mt19937 &random)
{
    std::normal_distribution<double> number;
    Eigen::MatrixXd root(size, size);
    for (double &value : root.reshaped())
        value = number(random);
    return root * root.transpose();
}

PiecedSystem systemOf(std::vector<int> sizes, std::vector<std::vector<int>> blocks,
                      std::mt19937 &random)
{
    PiecedSystem system{std::move(sizes), std::move(blocks), {}, {}, {}};
    const int count = std::accumulate(system.sizes.begin(), system.sizes.end(), 0);
    system.whole = Eigen::MatrixXd::Zero(count, count);
    const auto put = [&](const std::vector<int> &some) {
        const std::vector<int> unknowns = system.unknownsOf(some);
        Eigen::MatrixXd matrix = positive(static_cast<int>(unknowns.size()), random);
        system.whole(unknowns, unknowns) += matrix;
        return matrix;
    };
    for (int i = 0; i < static_cast<int>(system.sizes.size()); ++i)
        system.own.push_back(put({i}));
    for (const std::vector<int> &some : system.blocks) {
        Eigen::MatrixXd matrix = put(some);
        // Wrong: upper halves are read, which nobody fills.
        matrix.triangularView<Eigen::StrictlyUpper>().setConstant(1e6);
        system.pieces.push_back(matrix);
    }
    return system;
}

} // namespace

class TestFrontalFactors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void solvesAsOneMatrixDoes_data();
    void solvesAsOneMatrixDoes();
    void whatDidNotChangeStays_data() { solvesAsOneMatrixDoes_data(); }
    void whatDidNotChangeStays();
    void whatIsNotPositiveIsTold();
};

void TestFrontalFactors::solvesAsOneMatrixDoes_data()
{
    QTest::addColumn<std::vector<int>>("sizes");
    QTest::addColumn<std::vector<std::vector<int>>>("blocks");

    using Sizes = std::vector<int>;
    using Pieces = std::vector<std::vector<int>>;
    QTest::newRow("nothing") << Sizes{} << Pieces{};
    QTest::newRow("blocks that nothing couples") << Sizes{6, 3, 1} << Pieces{};
    QTest::newRow("an empty piece") << Sizes{2} << Pieces{{}};
    QTest::newRow("one piece of all, out of order") << Sizes{1, 6, 3} << Pieces{{2, 0, 1}};
    QTest::newRow("the same piece twice") << Sizes{6, 6} << Pieces{{0, 1}, {1, 0}};
    QTest::newRow("one piece within another") << Sizes{3, 6, 3} << Pieces{{0, 1, 2}, {2, 1}};
    QTest::newRow("a row") << Sizes(7, 6) << Pieces{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}};
    QTest::newRow("a ring") << Sizes(4, 6) << Pieces{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    QTest::newRow("a star") << Sizes(5, 3) << Pieces{{0, 1}, {0, 2}, {0, 3}, {0, 4}};
    QTest::newRow("two that are apart") << Sizes(4, 6) << Pieces{{0, 2}, {1, 3}};
    const int strips = 8;
    Pieces lattice(2 * strips);
    for (int i = 0; i < strips; ++i) {
        for (int j = 0; j < strips; ++j) {
            lattice[static_cast<std::size_t>(i)].push_back(strips * i + j);
            lattice[static_cast<std::size_t>(strips + j)].push_back(strips * i + j);
        }
    }
    QTest::newRow("a lattice") << Sizes(strips * strips, 6) << lattice;
    std::mt19937 random(7);
    for (int k = 0; k < 40; ++k) {
        const int count = 1 + static_cast<int>(random() % 40);
        Sizes sizes;
        for (int i = 0; i < count; ++i)
            sizes.push_back(1 + static_cast<int>(random() % 6));
        Pieces pieces;
        for (unsigned i = random() % 25; i > 0; --i) {
            std::set<int> some;
            for (unsigned j = 1 + random() % 6; j > 0; --j)
                some.insert(static_cast<int>(random() % static_cast<unsigned>(count)));
            pieces.emplace_back(some.begin(), some.end());
            std::shuffle(pieces.back().begin(), pieces.back().end(), random);
        }
        QTest::addRow("at random, seed 7, number %d", k) << sizes << pieces;
    }
}

void TestFrontalFactors::solvesAsOneMatrixDoes()
{
    QFETCH(const std::vector<int>, sizes);
    QFETCH(const std::vector<std::vector<int>>, blocks);
    std::mt19937 random(11);
    FrontalFactors factors(sizes, blocks);
    for (int time = 0; time < 2; ++time) { // wrong the second time: something of the first is left
        const PiecedSystem system = systemOf(sizes, blocks, random);
        QVERIFY(factors.factorise(system.own, system.pieces));
        const Eigen::VectorXd expected = Eigen::VectorXd::Random(system.whole.rows());
        const Eigen::VectorXd right = system.whole * expected;
        const Eigen::VectorXd rest = system.whole * factors.solved(right) - right;
        QVERIFY(rest.norm() <= 1e-10 * (1.0 + right.norm()));
    }
}

// Wrong: a front keeps what one that it sums up no longer passes on; or nothing is kept after a
// system that has no factors.
void TestFrontalFactors::whatDidNotChangeStays()
{
    QFETCH(const std::vector<int>, sizes);
    QFETCH(const std::vector<std::vector<int>>, blocks);
    std::mt19937 random(13);
    PiecedSystem system = systemOf(sizes, blocks, random);
    const Eigen::VectorXd right = Eigen::VectorXd::Random(system.whole.rows());
    FrontalFactors kept(sizes, blocks);
    for (int time = 0; time < 8; ++time) {
        QVERIFY(kept.refactorise(system.own, system.pieces));
        FrontalFactors anew(sizes, blocks);
        QVERIFY(anew.factorise(system.own, system.pieces));
        QVERIFY(kept.solved(right) == anew.solved(right)); // to the last bit
        if (sizes.empty())
            continue;
        const std::size_t changed = random() % sizes.size();
        if (time == 4) {
            std::vector<Eigen::MatrixXd> lost = system.own;
            for (Eigen::MatrixXd &matrix : lost)
                matrix.setConstant(std::numeric_limits<double>::quiet_NaN());
            QVERIFY(!kept.refactorise(lost, system.pieces));
        }
        system.own[changed] += positive(sizes[changed], random);
    }
}

void TestFrontalFactors::whatIsNotPositiveIsTold()
{
    std::mt19937 random(3);
    PiecedSystem system = systemOf({3, 6, 3}, {{0, 1}, {1, 2}}, random);
    FrontalFactors factors(system.sizes, system.blocks);
    const Eigen::MatrixXd sound = system.own[1];
    system.own[1](0, 0) = -1e9;
    // Wrong: roots of negative numbers go on as if they were numbers.
    QVERIFY(!factors.factorise(system.own, system.pieces));
    system.own[1](0, 0) = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!factors.factorise(system.own, system.pieces));
    system.own[1] = sound;
    QVERIFY(factors.factorise(system.own, system.pieces));
}

FFF_TEST(TestFrontalFactors)

#include "tst_frontal_factors.moc"
