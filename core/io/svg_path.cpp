// Path data of SVG.
#include "core/io/svg_values.h"

#include "core/geometry/bezier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fff::io {

namespace {

/// An eighth of a circle: off by 4e-6 of the radius.
constexpr double kLongestArc = std::numbers::pi / 4.0;

/// Bytes of what could not be read that are kept, more than any sentence quotes.
constexpr std::size_t kShownRest = 256;

class PathReader
{
public:
    explicit PathReader(std::string_view text) : m_numbers(text) {}

    SvgPathData read()
    {
        while (!m_numbers.isAtEnd()) {
            const std::string_view rest = m_numbers.rest();
            if (step())
                continue;
            m_data.isWhole = false;
            m_data.rest = rest.substr(0, kShownRest);
            break;
        }
        std::erase_if(m_data.subpaths,
                      [](const SvgSubpath &path) { return path.points.size() < 4; });
        return std::move(m_data);
    }

private:
    /// One command, or once more the last one.
    bool step()
    {
        if (const char letter = m_numbers.letter()) {
            m_command = letter;
        } else if (m_command == 'M') {
            m_command = 'L';
        } else if (m_command == 'm') {
            m_command = 'l';
        } else if (m_command == 'Z' || m_command == 'z') {
            return false; // takes no numbers
        }
        m_isRelative = m_command >= 'a';
        const char kind = m_isRelative ? static_cast<char>(m_command - 'a' + 'A') : m_command;
        if (m_data.subpaths.empty() && kind != 'M')
            return false;
        const bool isRead = draw(kind);
        if (kind != 'C' && kind != 'S')
            m_cubic.reset();
        if (kind != 'Q' && kind != 'T')
            m_quadratic.reset();
        return isRead;
    }

    bool draw(char kind)
    {
        switch (kind) {
        case 'M':
            return move();
        case 'L':
            return withPoints<1>([this](const auto &p) { line(p[0]); });
        case 'H':
        case 'V':
            return straight(kind == 'H' ? 0 : 1);
        case 'C':
            return withPoints<3>([this](const auto &p) { cubic(p[0], p[1], p[2]); });
        case 'S':
            return withPoints<2>([this](const auto &p) {
                cubic(m_cubic ? Vec2(2.0 * m_at - *m_cubic) : m_at, p[0], p[1]);
            });
        case 'Q':
            return withPoints<2>([this](const auto &p) { quadratic(p[0], p[1]); });
        case 'T':
            return withPoints<1>([this](const auto &p) {
                quadratic(m_quadratic ? Vec2(2.0 * m_at - *m_quadratic) : m_at, p[0]);
            });
        case 'A':
            return arc();
        case 'Z':
            return close();
        default:
            return false;
        }
    }

    std::optional<Vec2> point()
    {
        const std::optional<double> x = m_numbers.number(), y = m_numbers.number();
        if (!x || !y)
            return std::nullopt;
        return m_isRelative ? Vec2(m_at + Vec2(*x, *y)) : Vec2(*x, *y);
    }
    template <std::size_t count, class Draw>
    bool withPoints(Draw draw)
    {
        std::array<Vec2, count> points;
        for (Vec2 &each : points) {
            const std::optional<Vec2> p = point();
            if (!p)
                return false;
            each = *p;
        }
        resume();
        draw(points);
        return true;
    }
    /// What is drawn behind a Z begins where that led to.
    void resume()
    {
        if (m_data.subpaths.back().isClosed)
            m_data.subpaths.push_back({{m_at}});
    }
    void add(const Vec2 &a, const Vec2 &b, const Vec2 &to)
    {
        auto &points = m_data.subpaths.back().points;
        points.insert(points.end(), {a, b, to});
        m_at = to;
    }
    void line(const Vec2 &to)
    {
        if (to == m_at)
            return;
        const CubicBezier curve = CubicBezier::line(m_at, to);
        add(curve.p1, curve.p2, to);
    }
    void cubic(const Vec2 &a, const Vec2 &b, const Vec2 &to)
    {
        m_cubic = b;
        add(a, b, to);
    }
    void quadratic(const Vec2 &by, const Vec2 &to)
    {
        m_quadratic = by;
        add(m_at + 2.0 / 3.0 * (by - m_at), to + 2.0 / 3.0 * (by - to), to);
    }
    bool move()
    {
        const std::optional<Vec2> to = point();
        if (!to)
            return false;
        m_at = *to;
        m_data.subpaths.push_back({{m_at}});
        return true;
    }
    bool straight(int axis)
    {
        const std::optional<double> number = m_numbers.number();
        if (!number)
            return false;
        resume();
        Vec2 to = m_at;
        to[axis] = m_isRelative ? m_at[axis] + *number : *number;
        line(to);
        return true;
    }
    bool close()
    {
        SvgSubpath &path = m_data.subpaths.back();
        if (!path.isClosed) {
            line(Vec2(path.points.front())); // a copy: the points grow
            path.isClosed = true;
        }
        m_at = path.points.front();
        return true;
    }
    bool arc();

    SvgNumbers m_numbers;
    SvgPathData m_data;
    Vec2 m_at = Vec2::Zero();
    std::optional<Vec2> m_cubic, m_quadratic; // the last handle, of a command of that kind
    char m_command = 0;
    bool m_isRelative = false;
};

/// By its end points, SVG 1.1, appendix F.6.
bool PathReader::arc()
{
    const std::optional<double> rx = m_numbers.number(), ry = m_numbers.number(),
                                degrees = m_numbers.number();
    const std::optional<bool> isLarge = m_numbers.flag(), isPositive = m_numbers.flag();
    const std::optional<Vec2> to = point();
    if (!rx || !ry || !degrees || !isLarge || !isPositive || !to)
        return false;
    resume();
    Vec2 radii(std::abs(*rx), std::abs(*ry));
    if (*to == m_at)
        return true;
    if (!(radii.minCoeff() > 0.0)) {
        line(*to);
        return true;
    }
    const double turn = *degrees * std::numbers::pi / 180.0;
    const Eigen::Rotation2Dd back(-turn);
    const Vec2 half = back * Vec2(0.5 * (m_at - *to));
    const double reach = half.cwiseQuotient(radii).squaredNorm();
    if (reach > 1.0)
        radii *= std::sqrt(reach);
    const Vec2 unit = half.cwiseQuotient(radii); // on the unit circle, seen from its middle
    const double length2 = std::min(unit.squaredNorm(), 1.0);
    double away = length2 > 0.0 ? std::sqrt(std::max(0.0, 1.0 / length2 - 1.0)) : 0.0;
    if (*isLarge == *isPositive)
        away = -away;
    const Vec2 middle(away * unit.y(), -away * unit.x());
    const Vec2 start = unit - middle, stop = -unit - middle;
    const double from = std::atan2(start.y(), start.x());
    double sweep = std::atan2(stop.y(), stop.x()) - from;
    if (*isPositive && sweep < 0.0)
        sweep += 2.0 * std::numbers::pi;
    else if (!*isPositive && sweep > 0.0)
        sweep -= 2.0 * std::numbers::pi;
    const Vec2 centre =
        0.5 * (m_at + *to) + Eigen::Rotation2Dd(turn) * Vec2(middle.cwiseProduct(radii));
    auto &points = m_data.subpaths.back().points;
    appendArc(centre, radii, turn, from, sweep, points);
    m_at = points.back() = *to;
    return true;
}

} // namespace

void appendArc(const Vec2 &centre, const Vec2 &radii, double turn, double from, double sweep,
               std::vector<Vec2> &points)
{
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kLongestArc - 1e-9)));
    const double step = sweep / count, handle = 4.0 / 3.0 * std::tan(0.25 * step);
    const Eigen::Matrix2d map =
        Eigen::Rotation2Dd(turn).toRotationMatrix() * radii.asDiagonal().toDenseMatrix();
    const auto at = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
    for (int i = 0; i < count; ++i) {
        const Vec2 a = at(from + i * step), b = at(from + (i + 1) * step);
        const Vec2 behind = a + handle * Vec2(-a.y(), a.x()),
                   before = b - handle * Vec2(-b.y(), b.x());
        for (const Vec2 &p : {behind, before, b})
            points.push_back(centre + map * p);
    }
}

SvgPathData svgPath(std::string_view text)
{
    return PathReader(text).read();
}

} // namespace fff::io
