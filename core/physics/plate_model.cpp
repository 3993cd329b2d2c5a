#include "core/physics/plate_model.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace fff {

namespace {

constexpr double kSingular = 1e-13; // of an unknown's own stiffness: below, something is loose
constexpr double kOnClamp = 1e-6;   // of the plate's size: a point that is on a clamp

using PlateMatrix = Eigen::SparseMatrix<double>;

/// What is left of the unknowns when some are held.
struct Freedom
{
    std::vector<int> number; // of each unknown among the free ones; −1: held
    int free = 0;

    explicit Freedom(std::size_t unknowns) : number(unknowns, 0) {}

    void hold(int unknown) { number[static_cast<std::size_t>(unknown)] = -1; }
    void count()
    {
        free = 0;
        for (int &n : number) {
            if (n >= 0)
                n = free++;
        }
    }
    Eigen::MatrixXd reduced(const Eigen::MatrixXd &all) const
    {
        Eigen::MatrixXd result(free, all.cols());
        for (std::size_t i = 0; i < number.size(); ++i) {
            if (number[i] >= 0)
                result.row(number[i]) = all.row(static_cast<Eigen::Index>(i));
        }
        return result;
    }
    Eigen::MatrixXd expanded(const Eigen::MatrixXd &some) const
    {
        Eigen::MatrixXd result =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(number.size()), some.cols());
        for (std::size_t i = 0; i < number.size(); ++i) {
            if (number[i] >= 0)
                result.row(static_cast<Eigen::Index>(i)) = some.row(number[i]);
        }
        return result;
    }
};

struct PlateSystem
{
    Freedom freedom;
    Eigen::SimplicialLDLT<PlateMatrix> factor;

    explicit PlateSystem(std::size_t unknowns) : freedom(unknowns) {}

    bool make(const std::vector<Eigen::Triplet<double>> &entries)
    {
        PlateMatrix matrix(freedom.free, freedom.free);
        matrix.setFromTriplets(entries.begin(), entries.end());
        factor.compute(matrix);
        if (factor.info() != Eigen::Success || freedom.free == 0)
            return false;
        const Eigen::VectorXd stiff = factor.permutationP() * Eigen::VectorXd(matrix.diagonal());
        return (factor.vectorD().array() > kSingular * stiff.array()).all();
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd &forces) const
    {
        return freedom.expanded(factor.solve(freedom.reduced(forces)));
    }
};

/// Adds an element's stiffness; `unknowns`: its rows among all of them. The lower half.
template <class Stiffness, class Unknowns>
void addElement(std::vector<Eigen::Triplet<double>> &entries, const Freedom &freedom,
                const Stiffness &stiffness, const Unknowns &unknowns)
{
    const int size = static_cast<int>(stiffness.rows());
    for (int i = 0; i < size; ++i) {
        const int row = freedom.number[static_cast<std::size_t>(unknowns(i))];
        for (int j = 0; row >= 0 && j < size; ++j) {
            const int column = freedom.number[static_cast<std::size_t>(unknowns(j))];
            if (column >= 0 && column <= row)
                entries.emplace_back(row, column, stiffness(i, j));
        }
    }
}

/// Three corners far apart and far from a line.
std::array<int, 3> farCorners(const PlateMesh &mesh)
{
    const auto farthest = [&](const auto &measure) {
        int best = 0;
        for (int i = 1; i < mesh.corners; ++i) {
            if (measure(mesh.points[static_cast<std::size_t>(i)]) >
                measure(mesh.points[static_cast<std::size_t>(best)]))
                best = i;
        }
        return best;
    };
    const Vec2 some = mesh.points.front();
    const int a = farthest([&](const Vec2 &p) { return (p - some).squaredNorm(); });
    const Vec2 atA = mesh.points[static_cast<std::size_t>(a)];
    const int b = farthest([&](const Vec2 &p) { return (p - atA).squaredNorm(); });
    const Vec2 along = mesh.points[static_cast<std::size_t>(b)] - atA;
    const int c = farthest([&](const Vec2 &p) { return std::abs(cross(along, p - atA)); });
    return {a, b, c};
}

bool isOnClamp(const Vec2 &point, const std::vector<PlateClamp> &clamps, double size)
{
    return std::any_of(clamps.begin(), clamps.end(), [&](const PlateClamp &clamp) {
        const Vec2 along = clamp.to - clamp.from;
        const double at =
            std::clamp((point - clamp.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (point - clamp.from - at * along).norm() < kOnClamp * size;
    });
}

void holdSupports(const PlateMesh &mesh, Freedom &membrane, Freedom &bending)
{
    const auto [a, b, c] = farCorners(mesh);
    const Vec2 along =
        mesh.points[static_cast<std::size_t>(b)] - mesh.points[static_cast<std::size_t>(a)];
    membrane.hold(2 * a);
    membrane.hold(2 * a + 1);
    membrane.hold(std::abs(along.x()) > std::abs(along.y()) ? 2 * b + 1 : 2 * b);
    for (const int corner : {a, b, c})
        bending.hold(3 * corner);
}

void holdClamps(const PlateMesh &mesh, const std::vector<PlateClamp> &clamps, Freedom &membrane,
                Freedom &bending)
{
    Box2 box;
    for (const Vec2 &p : mesh.points)
        box.extend(p);
    for (int i = 0; i < static_cast<int>(mesh.points.size()); ++i) {
        if (!isOnClamp(mesh.points[static_cast<std::size_t>(i)], clamps, box.size().maxCoeff()))
            continue;
        membrane.hold(2 * i);
        membrane.hold(2 * i + 1);
        for (int k = 0; k < 3 && i < mesh.corners; ++k)
            bending.hold(3 * i + k);
    }
}

} // namespace

struct PlateModel::Factors
{
    PlateSystem membrane, bending;

    explicit Factors(const PlateMesh &mesh)
        : membrane(2 * mesh.points.size()), bending(3 * static_cast<std::size_t>(mesh.corners))
    {
    }
};

Result<PlateModel> PlateModel::make(PlateMesh mesh, const PlateMaterial &material,
                                    const std::vector<PlateClamp> &clamps, const LongWork &work)
{
    if (!(material.thickness > 0.0) || !(material.modulus > 0.0) ||
        !(std::abs(material.poisson) < 1.0) || mesh.triangles.empty())
        return failure(ErrorCode::NotWorkedOut);
    PlateModel model(std::move(mesh), material);
    const auto factors = std::make_shared<Factors>(model.m_mesh);
    if (clamps.empty())
        holdSupports(model.m_mesh, factors->membrane.freedom, factors->bending.freedom);
    else
        holdClamps(model.m_mesh, clamps, factors->membrane.freedom, factors->bending.freedom);
    factors->membrane.freedom.count();
    factors->bending.freedom.count();

    const PlaneElasticity elasticity = planeStress(material.modulus, material.poisson);
    std::vector<Eigen::Triplet<double>> membrane, bending;
    membrane.reserve(78 * model.m_mesh.triangles.size());
    bending.reserve(45 * model.m_mesh.triangles.size());
    for (std::size_t i = 0; i < model.m_mesh.triangles.size(); ++i) {
        if (i % 256 == 0 && work.isStopped())
            return failure(ErrorCode::Cancelled);
        const PlateCorners corners = cornersOf(model.m_mesh, i);
        const auto &points = model.m_mesh.triangles[i];
        addElement(membrane, factors->membrane.freedom,
                   membraneStiffness(corners, elasticity, material.thickness),
                   [&](int k) { return 2 * points[static_cast<std::size_t>(k / 2)] + k % 2; });
        addElement(bending, factors->bending.freedom,
                   bendingStiffness(corners, elasticity, material.thickness),
                   [&](int k) { return 3 * points[static_cast<std::size_t>(k / 3)] + k % 3; });
    }
    if (!factors->membrane.make(membrane))
        return failure(ErrorCode::NotWorkedOut);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    if (!factors->bending.make(bending))
        return failure(ErrorCode::NotWorkedOut);
    model.m_factors = factors;
    return model;
}

PlateField PlateModel::noField() const
{
    return {Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(m_mesh.points.size())),
            Eigen::VectorXd::Zero(3 * m_mesh.corners)};
}

void PlateModel::addForce(PlateField &field, const PlateLocator::Place &place,
                          const Vec3 &force) const
{
    const auto &points = m_mesh.triangles[place.triangle];
    const Eigen::Matrix<double, 6, 1> shape = quadraticShape(place.at);
    for (int i = 0; i < 6; ++i)
        field.membrane.segment<2>(2 * points[static_cast<std::size_t>(i)]) +=
            shape[i] * force.head<2>();
    for (int i = 0; i < 3; ++i)
        field.bending[3 * points[static_cast<std::size_t>(i)]] += place.at[i] * force.z();
}

void PlateModel::addWeight(PlateField &field, const Vec3 &gravity) const
{
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
        const PlateCorners corners = cornersOf(m_mesh, i);
        const double area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
        const Vec3 third = gravity * (area * m_material.thickness * m_material.density / 3.0);
        const auto &points = m_mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            // The quadratic shapes of corners have no integral, those of middles a third.
            field.membrane.segment<2>(2 * points[3 + k]) += third.head<2>();
            field.bending[3 * points[k]] += third.z();
        }
    }
}

Eigen::MatrixXd PlateModel::solveMembrane(const Eigen::MatrixXd &forces) const
{
    return m_factors->membrane.solve(forces);
}

Eigen::MatrixXd PlateModel::solveBending(const Eigen::MatrixXd &forces) const
{
    return m_factors->bending.solve(forces);
}

PlateField PlateModel::solve(const PlateField &forces) const
{
    return {solveMembrane(forces.membrane), solveBending(forces.bending)};
}

Vec3 PlateModel::displacement(const PlateField &displacements,
                              const PlateLocator::Place &place) const
{
    Vec3 result = Vec3::Zero();
    const auto &points = m_mesh.triangles[place.triangle];
    const Eigen::Matrix<double, 6, 1> shape = quadraticShape(place.at);
    for (int i = 0; i < 6; ++i)
        result.head<2>() +=
            shape[i] * displacements.membrane.segment<2>(2 * points[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 3; ++i)
        result.z() += place.at[i] * displacements.bending[3 * points[static_cast<std::size_t>(i)]];
    return result;
}

} // namespace fff
