#include "core/io/flatfab_text.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace fff::io {

namespace {

// Counts above these are of no file that FlatFab could have written.
constexpr std::int64_t kMaxSections = 100'000;
constexpr std::int64_t kMaxCurves = 10'000;
constexpr std::int64_t kMaxSketchPoints = 10'000'000;
constexpr std::int64_t kMaxControlPoints = 1'000'000;
/// Two segments, and the first point again.
constexpr std::int64_t kMinControlPoints = 7;

// The fewest bytes that a record takes, by which a claimed count is doubted.
constexpr std::size_t kMinPointBytes = 4;    // "0 0\n"
constexpr std::size_t kMinCurveBytes = 58;   // two count lines and seven points
constexpr std::size_t kMinSectionBytes = 90; // four axes and a curve

/// Words of one line, at most one more than any record has.
struct Line
{
    int number = 0;
    std::string_view text = {};
    std::array<std::string_view, 5> words = {};
    std::size_t count = 0;
};

class FlatfabParser
{
public:
    FlatfabParser(std::string_view bytes, Problems &problems) : m_rest(bytes), m_problems(problems)
    {
    }

    std::vector<FlatfabSection> parse();

private:
    bool nextLine(Line &line);
    Line expectLine(const char *expected);
    void fail(ErrorCode code, int line, std::vector<std::string> args = {});
    double number(std::string_view word, int line);
    std::int64_t count(const Line &line, const char *keyword, const char *expected,
                       std::int64_t most);
    Vec3 axis(const char *keyword, const char *expected, int *lineNumber = nullptr);
    Vec2 point();
    FlatfabCurve curve(const Line &first);
    FlatfabSection section();
    void trailingLines();
    std::size_t reservable(std::int64_t claimed, std::size_t bytesEach) const;

    std::string_view m_rest;
    Problems &m_problems;
    int m_line = 0; // the last one read
};

void FlatfabParser::fail(ErrorCode code, int line, std::vector<std::string> args)
{
    m_problems.fail(code, std::to_string(line), std::move(args));
}

/// The next line that is not blank. One pass over its bytes: it is where reading spends its time.
bool FlatfabParser::nextLine(Line &line)
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!m_rest.empty()) {
        const char *at = m_rest.data();
        const char *const end = at + m_rest.size();
        line.number = ++m_line;
        line.count = 0;
        while (at != end && *at != '\n') {
            if (isBlank(*at)) {
                ++at;
                continue;
            }
            const char *const word = at;
            while (at != end && *at != '\n' && !isBlank(*at))
                ++at;
            if (line.count < line.words.size())
                line.words[line.count++] = {word, static_cast<std::size_t>(at - word)};
        }
        const auto length = static_cast<std::size_t>(at - m_rest.data());
        line.text = m_rest.substr(0, length);
        m_rest.remove_prefix(std::min(length + 1, m_rest.size()));
        if (line.count > 0)
            return true;
    }
    return false;
}

Line FlatfabParser::expectLine(const char *expected)
{
    Line line;
    if (!nextLine(line)) {
        line = Line{.number = std::max(m_line, 1)};
        fail(ErrorCode::Truncated, line.number, {expected});
    }
    return line;
}

double FlatfabParser::number(std::string_view word, int line)
{
    const std::string_view whole = word;
    if (word.size() > 1 && word.front() == '+' && word[1] != '-')
        word.remove_prefix(1);
    double value = 0.0;
    const char *end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) {
        fail(ErrorCode::BadValue, line, {quoted(whole), QT_TRANSLATE_NOOP("Error", "a number")});
        return 0.0;
    }
    // Out of range is also what is too small for a double, and that is nothing to complain about.
    const bool isTiny =
        word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    if (error == std::errc::result_out_of_range && isTiny)
        return 0.0;
    if (error == std::errc::result_out_of_range || !std::isfinite(value)) {
        fail(ErrorCode::NonFinite, line, {quoted(whole)});
        return 0.0;
    }
    return value;
}

std::int64_t FlatfabParser::count(const Line &line, const char *keyword, const char *expected,
                                  std::int64_t most)
{
    if (m_problems.failed())
        return 0;
    if (line.count != 2 || line.words[0] != keyword) {
        fail(ErrorCode::BadSyntax, line.number, {quoted(line.text), expected});
        return 0;
    }
    const std::string_view word = line.words[1];
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool isNumber = stop == word.data() + word.size() && error != std::errc::invalid_argument;
    const bool isOutOfRange = error == std::errc::result_out_of_range;
    if (isNumber && word.front() != '-' && (isOutOfRange || value > most)) {
        fail(ErrorCode::BadCount, line.number, {quoted(word), std::to_string(most)});
        return 0;
    }
    if (!isNumber || isOutOfRange || value < 0) {
        fail(ErrorCode::BadValue, line.number,
             {quoted(word), QT_TRANSLATE_NOOP("Error", "a count")});
        return 0;
    }
    return value;
}

Vec3 FlatfabParser::axis(const char *keyword, const char *expected, int *lineNumber)
{
    if (m_problems.failed())
        return Vec3::Zero();
    const Line line = expectLine(expected);
    if (lineNumber)
        *lineNumber = line.number;
    if (m_problems.failed())
        return Vec3::Zero();
    if (line.count != 4 || line.words[0] != keyword) {
        fail(ErrorCode::BadSyntax, line.number, {quoted(line.text), expected});
        return Vec3::Zero();
    }
    return {number(line.words[1], line.number), number(line.words[2], line.number),
            number(line.words[3], line.number)};
}

Vec2 FlatfabParser::point()
{
    constexpr const char *expected = QT_TRANSLATE_NOOP("Error", "a point of two numbers");
    const Line line = expectLine(expected);
    if (m_problems.failed())
        return Vec2::Zero();
    if (line.count != 2) {
        fail(ErrorCode::BadSyntax, line.number, {quoted(line.text), expected});
        return Vec2::Zero();
    }
    return {number(line.words[0], line.number), number(line.words[1], line.number)};
}

std::size_t FlatfabParser::reservable(std::int64_t claimed, std::size_t bytesEach) const
{
    return std::min(static_cast<std::size_t>(claimed), m_rest.size() / bytesEach);
}

/// first: the line that should be "SketchPoints".
FlatfabCurve FlatfabParser::curve(const Line &first)
{
    FlatfabCurve curve;
    const std::int64_t samples = count(first, "SketchPoints", "SketchPoints n", kMaxSketchPoints);
    // What the hand drew before the curve was fitted: read for its errors only.
    for (std::int64_t i = 0; i < samples && !m_problems.failed(); ++i)
        point();
    if (m_problems.failed())
        return curve;

    const Line line = expectLine("BezierPoints n");
    curve.line = line.number;
    const std::int64_t points = count(line, "BezierPoints", "BezierPoints n", kMaxControlPoints);
    if (!m_problems.failed() && (points < kMinControlPoints || points % 3 != 1))
        fail(ErrorCode::BadContour, line.number,
             {std::to_string(points),
              QT_TRANSLATE_NOOP(
                  "Error", "three control points per segment and the first again, at least 7")});
    if (m_problems.failed())
        return curve;
    curve.points.reserve(reservable(points, kMinPointBytes));
    for (std::int64_t i = 0; i < points && !m_problems.failed(); ++i)
        curve.points.push_back(point());
    return curve;
}

FlatfabSection FlatfabParser::section()
{
    FlatfabSection section;
    section.p = axis("P", "P x y z", &section.line);
    section.t = axis("T", "T x y z");
    section.n = axis("N", "N x y z");
    section.b = axis("B", "B x y z");
    if (m_problems.failed())
        return section;

    // Files from before there were holes go on with the only curve.
    Line line = expectLine("BoundaryCurves n");
    std::int64_t curves = 1;
    if (!m_problems.failed() && line.words[0] != "SketchPoints") {
        curves = count(line, "BoundaryCurves", "BoundaryCurves n", kMaxCurves);
        if (!m_problems.failed() && curves == 0)
            fail(ErrorCode::BadValue, line.number,
                 {"0", QT_TRANSLATE_NOOP("Error", "at least 1 curve")});
        if (!m_problems.failed())
            line = expectLine("SketchPoints n");
    }
    section.curves.reserve(m_problems.failed() ? 0 : reservable(curves, kMinCurveBytes));
    for (std::int64_t i = 0; i < curves && !m_problems.failed(); ++i) {
        if (i > 0)
            line = expectLine("SketchPoints n");
        section.curves.push_back(curve(line));
    }
    return section;
}

void FlatfabParser::trailingLines()
{
    Line line;
    int first = 0;
    int lines = 0;
    while (nextLine(line)) {
        first = first == 0 ? line.number : first;
        ++lines;
    }
    if (lines > 0)
        m_problems.warn(WarningCode::TrailingLines, std::to_string(first), {std::to_string(lines)});
}

std::vector<FlatfabSection> FlatfabParser::parse()
{
    const Line first = expectLine("HeaderParameters 1");
    if (m_problems.failed())
        return {};
    if (first.words[0] != "HeaderParameters") {
        m_problems.fail(ErrorCode::NotAModel, {});
        return {};
    }
    // FlatFab does not look at its value either.
    count(first, "HeaderParameters", "HeaderParameters 1", kMaxSections);
    const Line header = expectLine("FlatFab n");
    const bool isOld = header.words[0] == "PlaneSketch";
    const std::int64_t claimed =
        count(header, isOld ? "PlaneSketch" : "FlatFab", "FlatFab n", kMaxSections);

    std::vector<FlatfabSection> sections;
    sections.reserve(reservable(claimed, kMinSectionBytes));
    for (std::int64_t i = 0; i < claimed && !m_problems.failed(); ++i)
        sections.push_back(section());
    if (!m_problems.failed())
        trailingLines();
    return sections;
}

} // namespace

std::vector<FlatfabSection> parseFlatfab(std::string_view bytes, Problems &problems)
{
    return FlatfabParser(withoutByteOrderMark(bytes), problems).parse();
}

} // namespace fff::io
