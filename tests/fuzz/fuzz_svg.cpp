// Any bytes as a drawing of another program. If this stops, a file from the net takes the window
// down, or what comes of one is no outline.
#include "core/geometry/outlines.h"
#include "core/io/svg_reader.h"
#include "tests/fuzz/properties.h"

using namespace fff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    const Result<io::SvgDrawing> drawing = io::readSvg(bytes, "input.svg");
    if (!drawing) {
        fuzz::requireClear(drawing.error());
        return 0;
    }
    std::vector<CurvePath> lines;
    for (const io::SvgDrawing::Line &line : drawing->lines) {
        fuzz::require(line.path.segmentCount() > 0, "a line has a segment");
        for (const Vec2 &p : line.path.points())
            fuzz::require(p.allFinite(), "places are numbers");
        lines.push_back(line.path);
    }
    // What takes longest is quadratic: large drawings are the tests' matter.
    constexpr std::size_t kMostLines = 60;
    if (lines.size() > kMostLines)
        return 0;
    const Result<std::vector<Outline>> outlines = outlinesOf(joined(std::move(lines), kDrawnGap));
    fuzz::require(outlines.has_value(), "outlines are found");
    for (const Outline &outline : *outlines) {
        fuzz::require(outline.outer.signedArea() > 0.0, "outlines run counter-clockwise");
        for (const Contour &hole : outline.holes)
            fuzz::require(hole.signedArea() < 0.0, "holes run clockwise");
    }
    return 0;
}
