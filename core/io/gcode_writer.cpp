#include "core/io/gcode_writer.h"

#include "core/fabrication/cutting_order.h"
#include "core/geometry/arc_fit.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fff::io {

namespace {

constexpr double kGCodeGrid = 1e-4;    // mm
constexpr double kLargestArc = 2000.0; // mm, radius
// What arcs may be off their curves, and what is left of that for edges in place of flat ones, and
// for the grid; mm.
constexpr double kOffCurve = 0.85 * kArcError, kOffArc = 0.1 * kArcError;
constexpr double kSecondsOfMinute = 60.0;

Vec2 onGrid(const Vec2 &p)
{
    return ((p / kGCodeGrid).array().round() * kGCodeGrid).matrix();
}

class GCodeText
{
public:
    explicit GCodeText(const Machine &machine) : m_machine(machine) {}

    void line(std::string_view text) { out.append(text).append(1, '\n'); }
    /// No control character gets in, and none that is not ASCII.
    void comment(const std::string &text)
    {
        out += "; ";
        for (const char c : text)
            out += c >= ' ' && c <= '~' ? c : '_';
        out += '\n';
    }

    void follow(const ToolLine &tool)
    {
        const ArcPath path = arcsAlong(tool.curves, tool.isClosed, kOffCurve);
        if (path.steps.empty())
            return;
        const Machine::Process &process = m_machine.of(tool.purpose);
        m_at = onGrid(path.start);
        out += "G0";
        coordinates(m_at);
        out += '\n' + m_machine.gcode.on + " S";
        number(process.power * m_machine.gcode.mostPower, 1);
        out += '\n';
        m_feed = process.speed * kSecondsOfMinute;
        m_saysFeed = true;
        for (const ArcStep &step : path.steps)
            add(step);
        line(m_machine.gcode.off);
    }

    std::string out;

private:
    void number(double value, int decimals)
    {
        std::array<char, 64> text{};
        auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
        if (decimals > 0) {
            while (end[-1] == '0')
                --end;
            if (end[-1] == '.')
                --end;
        }
        const std::string_view digits(text.data(), static_cast<std::size_t>(end - text.data()));
        out += digits == "-0" ? "0" : digits;
    }
    void word(char letter, double value)
    {
        out += ' ';
        out += letter;
        number(value, 4);
    }
    void coordinates(const Vec2 &p)
    {
        word('X', p.x());
        word('Y', p.y());
    }
    void endMove()
    {
        if (m_saysFeed) {
            out += " F";
            number(m_feed, 1);
        }
        m_saysFeed = false;
        out += '\n';
    }
    void edge(const Vec2 &end)
    {
        if (end == m_at)
            return;
        out += "G1";
        coordinates(end);
        endMove();
        m_at = end;
    }
    /// What is an arc on the grid, too.
    void add(const ArcStep &step)
    {
        const Vec2 end = onGrid(step.end);
        if (step.bulge == 0.0 || end == m_at)
            return edge(end);
        const Arc arc = arcOf(m_at, {end, step.bulge});
        if (arc.radius > kLargestArc)
            return flat(arc, end);
        out += step.bulge > 0.0 ? "G3" : "G2";
        coordinates(end);
        word('I', arc.center.x() - m_at.x());
        word('J', arc.center.y() - m_at.y());
        endMove();
        m_at = end;
    }
    /// Edges within kOffArc.
    void flat(const Arc &arc, const Vec2 &end)
    {
        const double most = std::sqrt(8.0 * arc.radius * kOffArc);
        const int count =
            std::max(1, static_cast<int>(std::ceil(arc.radius * std::abs(arc.sweep) / most)));
        for (int i = 1; i < count; ++i)
            edge(onGrid(arc.at(static_cast<double>(i) / count)));
        edge(end);
    }

    const Machine &m_machine;
    Vec2 m_at = Vec2::Zero(); // on the grid
    double m_feed = 0.0;      // mm/min
    bool m_saysFeed = false;
};

std::string shortNumber(double value)
{
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), std::round(value * 1000.0) / 1000.0);
    return {text.data(), end.ptr};
}

void describe(const CuttingDrawing &drawing, const CuttingSheet &sheet, GCodeText &out)
{
    out.comment("Sheet " + std::to_string(sheet.number) + ", " + shortNumber(sheet.size.x()) +
                " x " + shortNumber(sheet.size.y()) + " mm, lower left corner at X0 Y0");
    for (const Stock &stock : drawing.stocks)
        if (stock.id == sheet.stock)
            out.comment(stock.name.substr(0, 60) + ", " + shortNumber(stock.thickness) + " mm");
}

} // namespace

std::string writeGCode(const CuttingDrawing &drawing)
{
    const Machine &machine = machineOf(drawing);
    GCodeText text(machine);
    text.comment(std::string("FlatFitFab " FFF_VERSION ", millimetres, kerf ") +
                 (drawing.isKerfApplied ? "already applied" : "not applied"));
    text.comment("For " + machine.name + ". Try speeds and powers on a piece of waste first.");
    for (const std::string &line : machine.gcode.head)
        text.line(line);
    Vec2 at = Vec2::Zero();
    for (const CuttingSheet &sheet : drawing.sheets) {
        if (&sheet != &drawing.sheets.front())
            for (const std::string &line : machine.gcode.sheet)
                text.line(line);
        describe(drawing, sheet, text);
        for (const ToolLine &line : inCuttingOrder(sheet, at)) {
            if (line.purpose == Purpose::OuterCut)
                text.comment("Part " + std::to_string(sheet.parts[line.part].number()));
            text.follow(line);
            at = line.end();
        }
    }
    for (const std::string &line : machine.gcode.foot)
        text.line(line);
    return std::move(text.out);
}

const Format &gcodeFormat()
{
    static const Format format = {.key = "gcode",
                                  .suffixes = {"gcode"},
                                  .title = QT_TRANSLATE_NOOP("Format", "G-code for GRBL lasers"),
                                  .titleOfSheets =
                                      QT_TRANSLATE_NOOP("Format", "G-code, one for each sheet"),
                                  .help = QT_TRANSLATE_NOOP("CommandLine", "G-code for lasers"),
                                  .writeCutting = [](const CuttingDrawing &drawing,
                                                     const FormatValues &) -> Result<std::string> {
                                      return writeGCode(drawing);
                                  }};
    return format;
}

} // namespace fff::io
