#include "core/model/lettering.h"

#include "core/base/utf8.h"
#include "core/model/letter_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace fff {

namespace {

constexpr double kCapital = 10.0;               // of the letters' grid
constexpr double kGap = 2.2;                    // between letters, on the grid
constexpr double kTallAccent = 3.0;             // on capitals accents stand so much higher
constexpr double kQuarter = 0.5522847498307936; // handle of a quarter of a unit circle

tl::unexpected<Error> noLetter(const std::string &shown)
{
    return failure(ErrorCode::BadValue, "text",
                   {shown, "letters that are used in Europe's Latin alphabets"});
}

/// Reads the strokes of a letter (letter_shapes.h) into chains of control points.
class StrokeReader
{
public:
    StrokeReader(std::string_view strokes, const Vec2 &offset,
                 std::vector<std::vector<Vec2>> &chains)
        : m_at(strokes), m_offset(offset), m_chains(chains)
    {
    }

    void read()
    {
        while (!m_at.empty()) {
            const char command = m_at.front();
            m_at.remove_prefix(1);
            if (command != ' ')
                step(command);
        }
    }

private:
    double number()
    {
        m_at.remove_prefix(std::min(m_at.find_first_not_of(' '), m_at.size()));
        double value = 0.0; // with a point in it, whatever the person's country writes
        const auto [end, error] = std::from_chars(m_at.data(), m_at.data() + m_at.size(), value);
        if (error == std::errc())
            m_at.remove_prefix(static_cast<std::size_t>(end - m_at.data()));
        return value;
    }
    Vec2 point()
    {
        const double x = number();
        return Vec2(x, number()) + m_offset;
    }
    void add(const Vec2 &a, const Vec2 &b, const Vec2 &c)
    {
        m_chains.back().insert(m_chains.back().end(), {a, b, c});
    }
    void step(char command)
    {
        const Vec2 next = point();
        if (command == 'm') {
            m_chains.push_back({next});
            return;
        }
        const Vec2 from = m_chains.back().back(), way = next - from;
        if (command == 'l') {
            const CubicBezier line = CubicBezier::line(from, next);
            add(line.p1, line.p2, next);
        } else if (command == 'h') {
            add(from + Vec2(kQuarter * way.x(), 0.0), next - Vec2(0.0, kQuarter * way.y()), next);
        } else if (command == 'v') {
            add(from + Vec2(0.0, kQuarter * way.y()), next - Vec2(kQuarter * way.x(), 0.0), next);
        } else {
            const Vec2 second = point();
            add(next, second, point());
        }
    }

    std::string_view m_at;
    Vec2 m_offset;
    std::vector<std::vector<Vec2>> &m_chains;
};

/// All words on the letters' grid, each line of text from its own 0.
class Writer
{
public:
    Result<void> write(const std::u32string &text)
    {
        for (const char32_t letter : text) {
            if (letter == U'\n') {
                endLine();
                continue;
            }
            if (const Result<void> done = add(letter); !done)
                return done;
        }
        endLine();
        return {};
    }
    std::vector<std::vector<Vec2>> take() { return std::move(m_chains); }

private:
    Result<void> add(char32_t letter)
    {
        const MadeLetter *made = madeLetter(letter);
        const LetterShape *shape = letterShape(made ? made->base : letter);
        if (!shape)
            return noLetter(encoded({&letter, 1}));
        const double left = m_isStarted ? m_width + kGap : 0.0;
        const Vec2 offset(left, -m_line * kLineSpacing * kCapital);
        StrokeReader(shape->strokes, offset, m_chains).read();
        if (made) {
            const LetterShape *accent = accentShape(made->accent);
            const bool isTall = made->base >= U'A' && made->base <= U'Z';
            const bool isBelow = made->accent == U'\u0327' || made->accent == U'\u0328';
            const Vec2 middle(0.5 * shape->width, isTall && !isBelow ? kTallAccent : 0.0);
            StrokeReader(accent->strokes, offset + middle, m_chains).read();
        }
        m_width = left + shape->width;
        m_isStarted = true;
        return {};
    }
    /// Its middle comes to 0.
    void endLine()
    {
        for (; m_centred < m_chains.size(); ++m_centred)
            for (Vec2 &p : m_chains[m_centred])
                p.x() -= 0.5 * m_width;
        m_width = 0.0;
        m_isStarted = false;
        m_line += 1.0;
    }

    std::vector<std::vector<Vec2>> m_chains;
    std::size_t m_centred = 0;
    double m_width = 0.0, m_line = 0.0;
    bool m_isStarted = false;
};

} // namespace

Result<std::vector<CurvePath>> letterPaths(const Lettering &lettering)
{
    if (!(std::isfinite(lettering.height) && lettering.height > 0.0))
        return failure(ErrorCode::BadValue, "height",
                       {std::to_string(lettering.height), "a height above 0"});
    Writer writer;
    if (const Result<void> done = writer.write(decoded(lettering.text)); !done)
        return tl::unexpected(done.error());
    std::vector<std::vector<Vec2>> chains = writer.take();
    Box2 box;
    for (const std::vector<Vec2> &chain : chains)
        for (const Vec2 &p : chain)
            box.extend(p);
    if (box.isEmpty())
        return failure(ErrorCode::BadValue, "text", {lettering.text, "letters"});
    const Vec2 middle = box.center();
    const Eigen::Matrix2d map =
        lettering.height / kCapital * Eigen::Rotation2Dd(lettering.turn).toRotationMatrix();
    std::vector<CurvePath> paths;
    for (std::vector<Vec2> &chain : chains) {
        const bool isClosed = chain.front() == chain.back();
        for (Vec2 &p : chain)
            p = lettering.at + map * (p - middle);
        if (isClosed)
            chain.back() = chain.front();
        Result<CurvePath> path = CurvePath::fromPoints(std::move(chain));
        if (!path)
            return tl::unexpected(path.error());
        paths.push_back(*std::move(path));
    }
    return paths;
}

Result<MarkPointer> letteredMark(const Lettering &lettering, Mark::Kind kind)
{
    Result<std::vector<CurvePath>> paths = letterPaths(lettering);
    if (!paths)
        return tl::unexpected(paths.error());
    return std::make_shared<const Mark>(Mark{kind, *std::move(paths), lettering});
}

} // namespace fff
